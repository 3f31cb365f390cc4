/* command_spectrum.c: `smoothcert spectrum SCHEME --valence K`: every block's eigenvalues, and what dominates. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "choices.h"
#include "command_scheme.h"
#include "escalate.h"
#include "spectrum_list.h"

#include "../bigfloat/interval.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_VALENCE 100000

static const char help[] =
    "Usage: smoothcert spectrum SCHEME --valence K [OPTION]...\n"
    "Prints proved enclosures of all eigenvalues of the subdivision matrix at valence K, by blocks:\n"
    "block m acts on nets that rotation by one sector multiplies by exp(2 pi i m / K); block K - m is\n"
    "the conjugate of block m.\n"
    "\n"
    "  --valence K         3 to 100000\n"
    "  --set NAME=VALUE    another value for a parameter of the scheme (may be repeated)\n"
    "  --precision BITS    balls of this precision (64 to 8192); default: hardware intervals\n"
    "  --digits N          decimals to print (default 15)\n"
    "  --json              one JSON object\n"
    "  --help              this text\n";

typedef struct {
    scheme_options scheme;
    long valence;
    long precision;
    long digits;
    bool json;
} options;

/* What the list says about dominance.  Indices into the list, -1: none. */
typedef struct {
    long one;       /* the eigenvalue 1 of block 0 */
    long dominant;  /* the largest other one, if certainly larger than all the rest */
    long runner_up; /* the one that may be largest of the rest */
    double rest_upper; /* every other eigenvalue is at most this large */
} summary;

static int read_options(options *o, int argc, char **argv)
{
    enum { OPTION_VALENCE = 256, OPTION_SET, OPTION_PRECISION, OPTION_DIGITS, OPTION_JSON, OPTION_HELP };
    static const struct option known[] = {
        {"valence", required_argument, NULL, OPTION_VALENCE}, {"set", required_argument, NULL, OPTION_SET},
        {"precision", required_argument, NULL, OPTION_PRECISION}, {"digits", required_argument, NULL, OPTION_DIGITS},
        {"json", no_argument, NULL, OPTION_JSON}, {"help", no_argument, NULL, OPTION_HELP}, {NULL, 0, NULL, 0},
    };
    int option, result;
    memset(o, 0, sizeof *o);
    o->digits = 15;
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        switch (option) {
        case OPTION_VALENCE:
            if (!read_long_option(&o->valence, optarg, CHOICES_MIN_VALENCE, MAX_VALENCE))
                return complain(EXIT_USAGE, "--valence: expected one valence from %d to %d, found '%s'", CHOICES_MIN_VALENCE, MAX_VALENCE, optarg);
            break;
        case OPTION_SET:
            if (!scheme_options_set(&o->scheme, optarg))
                return complain(EXIT_USAGE, "--set: at most %d settings", SCHEME_OPTIONS_MAX);
            break;
        case OPTION_PRECISION:
            if (!read_long_option(&o->precision, optarg, LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION))
                return complain(EXIT_USAGE, "--precision: expected a number of bits from %d to %d, found '%s'", LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION, optarg);
            break;
        case OPTION_DIGITS:
            if (!read_long_option(&o->digits, optarg, 1, 2400))
                return complain(EXIT_USAGE, "--digits: expected a number from 1 to 2400, found '%s'", optarg);
            break;
        case OPTION_JSON:
            o->json = true;
            break;
        case OPTION_HELP:
            fputs(help, stdout);
            return finish_output(0);
        default:
            return complain(EXIT_USAGE, "spectrum: unknown option or missing value at '%s'; see 'smoothcert spectrum --help'", argv[optind - 1]);
        }
    }
    result = scheme_options_name(&o->scheme, "spectrum", argc, argv, optind);
    if (result >= 0)
        return result;
    if (!o->valence)
        return complain(EXIT_USAGE, "spectrum: no valence given, such as --valence 7");
    return -1;
}

/* ---- who dominates ---- */

static bool is_conjugate_pair(const spectrum_entry *x, const spectrum_entry *y)
{
    return x->m == y->m && !x->real && !y->real && x->count == 1 && y->count == 1
           && fabs(x->modulus_lower - y->modulus_lower) <= x->modulus_upper - x->modulus_lower + y->modulus_upper - y->modulus_lower;
}

static summary summarise(const spectrum_list *l)
{
    summary s = {-1, -1, -1, 0};
    long best = -1;
    for (size_t i = 0; i < l->count; i++) {
        const spectrum_entry *e = &l->entry[i];
        if (s.one < 0 && e->m == 0 && e->real && e->modulus_lower <= 1 && e->modulus_upper >= 1)
            s.one = (long)i;
        else if (best < 0 || e->modulus_upper > l->entry[best].modulus_upper)
            best = (long)i;
    }
    for (size_t i = 0; i < l->count; i++) {
        if ((long)i == s.one || (long)i == best || (best >= 0 && is_conjugate_pair(&l->entry[best], &l->entry[i])))
            continue;
        if (s.runner_up < 0 || l->entry[i].modulus_upper > l->entry[s.runner_up].modulus_upper)
            s.runner_up = (long)i;
    }
    s.rest_upper = s.runner_up >= 0 ? l->entry[s.runner_up].modulus_upper : 0;
    if (best >= 0 && l->entry[best].count == 1 && l->entry[best].re && l->entry[best].modulus_lower > s.rest_upper)
        s.dominant = best;
    return s;
}

/* ---- output ---- */

static void print_entry(const spectrum_entry *e)
{
    if (!e->re)
        printf("  %d eigenvalues of modulus at most %.6g (no enclosures at this precision)\n", e->count, e->modulus_upper * (1 + 1e-5));
    else if (e->im)
        printf("  %s  + i (%s)", e->re, e->im);
    else
        printf("  %s", e->re);
    if (e->re && e->count > 1)
        printf("   (%d eigenvalues with multiplicity, that near)", e->count);
    if (e->re)
        printf("\n");
}

/* mu / L^2 decides how curvature behaves ([Z] Corollary 3.12; verify/certificate.md does not speak of it). */
static const char *meaning_of(double ratio_lower, double ratio_upper)
{
    if (ratio_lower > 1)
        return "curvature diverges";
    if (ratio_upper < 1)
        return "curvature tends to zero";
    return "curvature is bounded if this is exactly 1 without Jordan blocks";
}

static void print_summary(const spectrum_list *l, const summary *s)
{
    const spectrum_entry *d, *r;
    if (s->dominant < 0) {
        printf("no eigenvalue but 1 is certainly larger than all others\n");
        return;
    }
    d = &l->entry[s->dominant];
    printf("dominant: L = %s", d->re);
    if (d->im)
        printf(" + i (%s), modulus > %.9g", d->im, d->modulus_lower - 1e-9);
    printf(" in block %ld, simple\n", d->m);
    if (s->runner_up < 0)
        return;
    r = &l->entry[s->runner_up];
    double low = r->modulus_lower / (d->modulus_upper * d->modulus_upper) * (1 - 1e-15), high = r->modulus_upper / (d->modulus_lower * d->modulus_lower) * (1 + 1e-15);
    printf("runner-up: mu < %.9g in block %ld; mu / L = %.6g\n", r->modulus_upper + 1e-9, r->m, r->modulus_upper / d->modulus_lower);
    printf("mu / L^2 = %.6g: %s\n", high, meaning_of(low, high));
}

static void print_text(const options *o, const scheme *s, const spectrum_list *l, const summary *sum)
{
    printf("%s at valence %ld, %s%s\n", s->name, o->valence, o->precision ? "balls" : "double intervals", s->mirror_symmetric ? "" : ", complex blocks");
    for (size_t i = 0; i < l->count; i++) {
        if (i == 0 || l->entry[i].m != l->entry[i - 1].m)
            printf("block %ld\n", l->entry[i].m);
        print_entry(&l->entry[i]);
    }
    print_summary(l, sum);
}

static void print_json(const options *o, const scheme *s, const spectrum_list *l, const summary *sum)
{
    printf("{\"scheme\":\"%s\",\"valence\":%ld,\"precision\":%ld,\"eigenvalues\":[", s->name, o->valence, o->precision ? o->precision : 53);
    for (size_t i = 0; i < l->count; i++) {
        const spectrum_entry *e = &l->entry[i];
        printf("%s{\"block\":%ld,\"count\":%d", i ? "," : "", e->m, e->count);
        if (e->re)
            printf(",\"real\":\"%s\"", e->re);
        if (e->im)
            printf(",\"imaginary\":\"%s\"", e->im);
        printf(",\"modulus_lower\":%.17g,\"modulus_upper\":%.17g}", e->modulus_lower, e->modulus_upper);
    }
    printf("],\"dominant\":");
    if (sum->dominant >= 0)
        printf("%ld", sum->dominant);
    else
        printf("null");
    printf("}\n");
}

/* ---- the command ---- */

static int list_spectrum(const options *o, const scheme *s)
{
    spectrum_list l;
    summary sum;
    diagnostic d;
    status result;
    bool balls = o->precision != 0 || !interval_self_test();
    spectrum_list_init(&l);
    result = balls ? spectrum_list_make_ball(&l, s, o->valence, (int)o->digits, o->precision ? o->precision : LIMITS_MIN_PRECISION, &d)
                   : spectrum_list_make_interval(&l, s, o->valence, (int)o->digits, 53, &d);
    if (result == STATUS_OK) {
        sum = summarise(&l);
        (o->json ? print_json : print_text)(o, s, &l, &sum);
    }
    spectrum_list_clear(&l);
    if (result == STATUS_BAD_INPUT)
        return complain_of_scheme(o->scheme.name, &d);
    return result == STATUS_OK ? 0 : complain(EXIT_NO_MEMORY, "no memory");
}

int command_spectrum(int argc, char **argv)
{
    options o;
    scheme s;
    int result = read_options(&o, argc, argv);
    if (result >= 0)
        return result;
    scheme_init(&s);
    result = scheme_options_load(&s, &o.scheme);
    if (result < 0)
        result = list_spectrum(&o, &s);
    scheme_clear(&s);
    return finish_output(result);
}
