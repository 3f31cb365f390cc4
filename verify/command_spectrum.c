/* command_spectrum.c: `smoothcert spectrum SCHEME --valence K`: every block's eigenvalues, and what dominates. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "choices.h"
#include "command_scheme.h"
#include "consistency.h"
#include "escalate.h"
#include "spectrum_list.h"

#include "../bigfloat/interval.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_VALENCE 1000000000000000
/* All blocks are listed up to the first valence, and on demand up to the second. */
#define ALL_BLOCKS 100
#define MAX_ALL_BLOCKS 100000

static const char help[] =
    "Usage: smoothcert spectrum SCHEME --valence K [OPTION]...\n"
    "Prints proved enclosures of all eigenvalues of the subdivision matrix at valence K, by blocks:\n"
    "block m acts on nets that rotation by one sector multiplies by exp(2 pi i m / K); block K - m is\n"
    "the conjugate of block m.  At large valences the others are proved to be smaller in ranges of\n"
    "blocks, which costs about the same at any valence.\n"
    "\n"
    "  --valence K         3 to 10^15, in digits\n"
    "  --blocks all        list every block (up to valence 100000); default up to valence 100\n"
    "  --set NAME=VALUE    another value for a parameter of the scheme (may be repeated)\n"
    "  --precision BITS    balls of this precision (64 to 8192); default: hardware intervals, and balls\n"
    "                      of 64, 128, 256, 512 bits until one eigenvalue is proved dominant\n"
    "  --digits N          decimals to print (default 15)\n"
    "  --json              one JSON object\n"
    "  --help              this text\n";

typedef struct {
    scheme_options scheme;
    long valence;
    long precision;
    long digits;
    bool json;
    bool all_blocks;
} options;

/* What the list says about dominance.  Indices into the list, -1: none. */
typedef struct {
    long one;       /* the eigenvalue 1 of block 0 */
    long dominant;  /* the largest other one, if certainly larger than all the rest */
    long runner_up; /* the one that may be largest of the rest */
    double rest_upper; /* every other eigenvalue is at most this large */
} summary;

typedef struct {
    spectrum_list list;
    summary summary;
    long precision; /* 0: double intervals */
} found;

static int read_options(options *o, int argc, char **argv)
{
    enum { OPTION_VALENCE = 256, OPTION_BLOCKS, OPTION_SET, OPTION_PRECISION, OPTION_DIGITS, OPTION_JSON, OPTION_HELP };
    static const struct option known[] = {
        {"valence", required_argument, NULL, OPTION_VALENCE}, {"blocks", required_argument, NULL, OPTION_BLOCKS}, {"set", required_argument, NULL, OPTION_SET},
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
                return complain(EXIT_USAGE, "--valence: expected one valence from %d to %ld, found '%s'", CHOICES_MIN_VALENCE, MAX_VALENCE, optarg);
            break;
        case OPTION_BLOCKS:
            if (strcmp(optarg, "all"))
                return complain(EXIT_USAGE, "--blocks: expected 'all', found '%s'", optarg);
            o->all_blocks = true;
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
    if (o->all_blocks && o->valence > MAX_ALL_BLOCKS)
        return complain(EXIT_USAGE, "--blocks all: up to valence %d only", MAX_ALL_BLOCKS);
    return -1;
}

/* ---- who dominates ---- */

/* Where all blocks but one and block 0 are proved to be smaller, only the entries of these two matter. */
static bool may_dominate(const spectrum_list *l, const spectrum_entry *e)
{
    return l->top < 0 || e->m == l->top || e->m == 0;
}

static summary summarise(const spectrum_list *l)
{
    summary s = {spectrum_find_one(l), -1, -1, 0};
    long best = -1;
    double rival = 0;
    for (size_t i = 0; i < l->count; i++)
        if ((long)i != s.one && may_dominate(l, &l->entry[i]) && (best < 0 || l->entry[i].modulus_upper > l->entry[best].modulus_upper))
            best = (long)i;
    for (size_t i = 0; i < l->count; i++) {
        const spectrum_entry *e = &l->entry[i];
        if ((long)i == s.one || (long)i == best || (best >= 0 && spectrum_is_conjugate_pair(l, (size_t)best, i)))
            continue;
        if (s.runner_up < 0 || e->modulus_upper > l->entry[s.runner_up].modulus_upper)
            s.runner_up = (long)i;
        if (may_dominate(l, e))
            rival = fmax(rival, e->modulus_upper);
    }
    s.rest_upper = s.runner_up >= 0 ? l->entry[s.runner_up].modulus_upper : 0;
    if (l->top >= 0)
        s.rest_upper = fmax(s.rest_upper, l->rest_upper);
    if (best >= 0 && l->entry[best].count == 1 && l->entry[best].re && l->entry[best].modulus_lower > rival && (l->top < 0 || (l->ordered && l->entry[best].m == l->top)))
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
    if (e->re && e->count > 1 && e->real)
        printf("   (%d times)", e->count);
    else if (e->re && e->count > 1)
        printf("   (%d eigenvalues with multiplicity, that near)", e->count);
    if (e->re)
        printf("\n");
}

/* More than %.9g changes x by. */
static double rounding_of(double x)
{
    return x < 1 ? 1e-9 : 1e-8 * x;
}

/* mu / L^2 decides how curvature behaves ([Z] Corollary 3.12; verify/certificate.md does not speak of it). */
static const char *meaning_of(double ratio_lower, double ratio_upper)
{
    if (ratio_lower > 1)
        return "curvature diverges, unless mu's eigenfunction is 0";
    if (ratio_upper < 1)
        return "curvature tends to zero";
    if (ratio_lower < 1 - 1e-2 || ratio_upper > 1 + 1e-2)
        return "how curvature behaves is not decided";
    return "curvature is bounded if this is exactly 1 without Jordan blocks";
}

/* Nothing dominates, as far as is known. */
static void print_doubt(const spectrum_list *l)
{
    printf("no eigenvalue but 1 is certainly larger than all others\n");
    if (l->top >= 0)
        printf("the largest may be in block %ld", l->top);
    if (l->top >= 0 && !l->ordered)
        printf(", or in one of the blocks %ld to %ld", l->open.first, l->open.last);
    if (l->top >= 0)
        printf("\n");
}

static void print_summary(const spectrum_list *l, const summary *s)
{
    const spectrum_entry *d, *r;
    double low, high;
    if (s->dominant < 0) {
        print_doubt(l);
        return;
    }
    d = &l->entry[s->dominant];
    printf("dominant: L = %s", d->re);
    if (d->im)
        printf(" + i (%s), modulus > %.9g", d->im, d->modulus_lower - rounding_of(d->modulus_lower));
    printf(" in block %ld, simple\n", d->m);
    if (s->runner_up < 0)
        return;
    r = &l->entry[s->runner_up];
    low = r->modulus_lower / (d->modulus_upper * d->modulus_upper) * (1 - 1e-15);
    high = s->rest_upper / (d->modulus_lower * d->modulus_lower) * (1 + 1e-15);
    printf("runner-up: mu < %.9g", s->rest_upper + rounding_of(s->rest_upper));
    if (s->rest_upper <= r->modulus_upper * (1 + 0x1p-20))
        printf(" in block %ld", r->m);
    printf("; mu / L = %.6g\n", fmin(1, s->rest_upper / d->modulus_lower));
    printf("mu / L^2 = %.6g", high);
    if (d->m == 1 && d->modulus_upper < 1) /* else there is no tangent plane */
        printf(": %s", meaning_of(low, high));
    printf("\n");
}

static void print_range(const spectrum_range *r)
{
    if (r->m.first == r->m.last)
        printf("block %ld\n", r->m.first);
    else
        printf("blocks %ld to %ld\n", r->m.first, r->m.last);
    if (isfinite(r->upper))
        printf("  all eigenvalues of modulus at most %.9g\n", r->upper < 1 ? ceil(r->upper * 1e9) / 1e9 : r->upper + rounding_of(r->upper));
    else
        printf("  nothing proved\n");
}

static void print_text(const scheme *s, long valence, const found *f, const consistency *other)
{
    const spectrum_list *l = &f->list;
    size_t range = 0;
    printf("%s at valence %ld, ", s->name, valence);
    if (f->precision)
        printf("balls of %ld bits", f->precision);
    else
        printf("double intervals");
    printf("%s\n", s->mirror_symmetric ? "" : ", complex blocks");
    for (size_t i = 0; i < l->count; i++) {
        if (i == 0 || l->entry[i].m != l->entry[i - 1].m) {
            while (range < l->ranges && l->range[range].m.first < l->entry[i].m)
                print_range(&l->range[range++]);
            printf("block %ld\n", l->entry[i].m);
        }
        print_entry(&l->entry[i]);
    }
    while (range < l->ranges)
        print_range(&l->range[range++]);
    print_summary(l, &f->summary);
    if (other)
        consistency_print(other);
}

/* other: NULL if nothing else is known. */
static void print_json(const scheme *s, long valence, const found *f, const consistency *other)
{
    const spectrum_list *l = &f->list;
    printf("{\"scheme\":\"%s\",\"valence\":%ld,\"precision\":%ld,\"eigenvalues\":[", s->name, valence, f->precision ? f->precision : 53);
    for (size_t i = 0; i < l->count; i++) {
        const spectrum_entry *e = &l->entry[i];
        printf("%s{\"block\":%ld,\"count\":%d", i ? "," : "", e->m, e->count);
        if (e->re)
            printf(",\"real\":\"%s\"", e->re);
        if (e->im)
            printf(",\"imaginary\":\"%s\"", e->im);
        printf(",\"modulus_lower\":%.17g,\"modulus_upper\":%.17g}", e->modulus_lower, e->modulus_upper);
    }
    printf("],\"ranges\":[");
    for (size_t i = 0; i < l->ranges; i++) {
        printf("%s{\"first\":%ld,\"last\":%ld,\"modulus_upper\":", i ? "," : "", l->range[i].m.first, l->range[i].m.last);
        printf(isfinite(l->range[i].upper) ? "%.17g}" : "null}", l->range[i].upper);
    }
    printf("],\"dominant\":");
    if (f->summary.dominant >= 0)
        printf("%ld,\"rest_upper\":%.17g", f->summary.dominant, f->summary.rest_upper);
    else
        printf("null");
    if (f->summary.dominant < 0 && l->top >= 0 && !l->ordered)
        printf(",\"open\":{\"first\":%ld,\"last\":%ld}", l->open.first, l->open.last);
    if (other)
        consistency_print_json(other);
    printf("}\n");
}

/* ---- the command ---- */

/* Weights that are given for each sector know nothing of ranges. */
static bool has_sector_weights(const scheme *s)
{
    for (int i = 0; i < s->step_count; i++)
        for (int j = 0; j < s->steps[i].rule_count; j++)
            for (int l = 0; l < s->steps[i].rules[j].count; l++)
                if (s->steps[i].rules[j].sources[l].kind == SOURCE_SECTORS)
                    return true;
    return false;
}

static status find(found *f, const options *o, const scheme *s, bool all, long precision, diagnostic *d)
{
    int digits = (int)o->digits;
    status result;
    spectrum_list_init(&f->list);
    f->precision = precision;
    if (all)
        result = precision ? spectrum_list_make_ball(&f->list, s, o->valence, digits, precision, d) : spectrum_list_make_interval(&f->list, s, o->valence, digits, 53, d);
    else
        result = precision ? spectrum_survey_ball(&f->list, s, o->valence, digits, precision, true, d) : spectrum_survey_interval(&f->list, s, o->valence, digits, 53, true, d);
    f->summary = summarise(&f->list);
    return result;
}

static void replace(found *x, found *y)
{
    found t = *x;
    *x = *y;
    *y = t;
}

static bool may_use_doubles(void)
{
    if (!interval_self_test())
        return complain(0, "this machine or compiler does not round doubles as told: only balls are used") != 0;
    return true;
}

/* With the precision wanted, or with more and more until something dominates.  If nothing does, the first list says
   as much as the last one where it has all blocks; else the last one leaves the fewest open. */
static status find_best(found *f, const options *o, const scheme *s, diagnostic *d)
{
    static const long balls[] = {64, 128, 256, 512};
    bool all = o->all_blocks || o->valence <= ALL_BLOCKS || (o->valence <= MAX_ALL_BLOCKS && has_sector_weights(s));
    bool hardware = !o->precision && may_use_doubles();
    status result = find(f, o, s, all, o->precision ? o->precision : hardware ? 0 : balls[0], d);
    for (size_t i = hardware ? 0 : 1; !o->precision && (!all || o->valence <= ALL_BLOCKS) && result == STATUS_OK && f->summary.dominant < 0 && !f->list.exhausted && i < sizeof balls / sizeof *balls; i++) {
        found other;
        result = find(&other, o, s, all, balls[i], d);
        if (result != STATUS_OK || !all || other.summary.dominant >= 0)
            replace(f, &other);
        spectrum_list_clear(&other.list);
    }
    return result;
}

static int list_spectrum(const options *o, const scheme *s)
{
    found f;
    diagnostic d;
    consistency other;
    bool compares = o->valence <= CONSISTENCY_MAX_VALENCE, broken = false;
    status result = find_best(&f, o, s, &d);
    if (result == STATUS_OK && compares) {
        status compared = consistency_make(&other, s, o->valence, &f.list, f.summary.dominant, !may_use_doubles());
        compares = compared == STATUS_OK;
        broken = compares && consistency_is_broken(&other);
        result = compared == STATUS_NO_MEMORY ? compared : STATUS_OK;
    }
    if (result == STATUS_OK)
        (o->json ? print_json : print_text)(s, o->valence, &f, compares ? &other : NULL);
    spectrum_list_clear(&f.list);
    if (broken)
        return complain(EXIT_FAULT, "spectrum: two proved statements about %s at valence %ld contradict each other; please report this", s->name, o->valence);
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
