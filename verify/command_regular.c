/* command_regular.c: the regular part of a scheme, exactly: norms, constants, bounds. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "command_scheme.h"

#include "../lib/decomposition.h"
#include "../lib/regular_refutation.h"
#include "../lib/stability.h"

#include <getopt.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert regular SCHEME [OPTION]...\n"
    "Analyses the scheme (a name of the catalogue, or a file) where the mesh is regular, exactly:\n"
    "norms of the powers of its difference schemes up to the first that prove C1, the distance\n"
    "of one step from a simple scheme, and bounds of the limit by the data.\n"
    "\n"
    "  --set NAME=VALUE  another value for a parameter of the scheme (may be repeated)\n"
    "  --max-power N     the highest power to try (1 to 9; default 9)\n"
    "  --all             all powers up to that one, also behind the first that prove C1\n"
    "  --json            the answer for machines\n"
    "  --help            this text\n"
    "\n"
    "a_d is the mask divided by 1 + z^-d for the directions e1 = (1,0), e2 = (0,1), e3 = (1,-1),\n"
    "and S_a^N is N steps with the mask a. The scheme is C1 on the regular complex if a power of\n"
    "each of S_2a12, S_2a13, S_2a23 (on quads S_2a11, S_2a12, S_2a22) has a norm below 1; the last\n"
    "is left out where the mask is equal to its mirror image. It is not C1, on the other hand, if\n"
    "values at 2^-N x fall more slowly than those of C1 functions can, which is decided exactly from\n"
    "the eigenvalues that they follow. If neither holds it is undecided.\n"
    "C, C1, C2: one step of the scheme (of its derivatives 1, 2) differs from a step of linear or\n"
    "constant interpolation by at most C times the largest difference of neighbours.\n"
    "On triangles these constants follow as in Zorin's thesis, too, by decomposing the mask: as they\n"
    "are printed there, and as its argument proves them. (Printed ones that are not below the least\n"
    "are bounds.)\n"
    "K, K1, K2: the limit (its derivatives) is at most K times as large as the data.\n";

typedef struct {
    scheme_options scheme;
    long max_power;
    bool all, json;
} options;

enum { MAX_COLUMNS = 5 };

/* The powers of one operator. */
typedef struct {
    const char *name;    /* S_name */
    bool halved;         /* the mask is 2 a_d, and S_(a_d) is asked for */
    bool must_contract;
    norm_list norms;
} column;

typedef struct {
    options options;
    scheme scheme;
    regular_masks masks;
    column columns[MAX_COLUMNS];
    int column_count;
    int power;             /* rows of the table */
    bool proved;
    regular_refutation refutation; /* unless proved */
    comparison comparison;
    decomposition thesis; /* on triangles */
    stability stability[3]; /* of values and both derivatives */
} regular_run;

/* -1: go on; else the exit status. */
static int read_options(options *o, int argc, char **argv)
{
    enum { OPTION_SET = 256, OPTION_MAX_POWER, OPTION_ALL, OPTION_JSON, OPTION_HELP };
    static const struct option known[] = {
        {"set", required_argument, NULL, OPTION_SET},
        {"max-power", required_argument, NULL, OPTION_MAX_POWER},
        {"all", no_argument, NULL, OPTION_ALL},
        {"json", no_argument, NULL, OPTION_JSON},
        {"help", no_argument, NULL, OPTION_HELP},
        {NULL, 0, NULL, 0},
    };
    int option;
    memset(o, 0, sizeof *o);
    o->max_power = REGULAR_MAX_POWER;
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        switch (option) {
        case OPTION_SET:
            if (!scheme_options_set(&o->scheme, optarg))
                return complain(EXIT_USAGE, "--set: at most %d settings", SCHEME_OPTIONS_MAX);
            break;
        case OPTION_MAX_POWER:
            if (!read_long_option(&o->max_power, optarg, 1, REGULAR_MAX_POWER))
                return complain(EXIT_USAGE, "--max-power: expected a number from 1 to %d, found '%s'", REGULAR_MAX_POWER, optarg);
            break;
        case OPTION_ALL:
            o->all = true;
            break;
        case OPTION_JSON:
            o->json = true;
            break;
        case OPTION_HELP:
            fputs(help, stdout);
            return finish_output(0);
        default:
            return complain(EXIT_USAGE, "regular: unknown option or missing value at '%s'; see 'smoothcert regular --help'", argv[optind - 1]);
        }
    }
    return scheme_options_name(&o->scheme, "regular", argc, argv, optind);
}

/* ---- the analysis ---- */

/* false: no memory. */
static bool add_column(regular_run *r, const char *name, const laurent *mask, bool halved)
{
    column *c = &r->columns[r->column_count++];
    c->name = name;
    c->halved = halved;
    c->must_contract = !halved;
    if (!norm_list_make(&c->norms, mask, (int)r->options.max_power, c->must_contract && !r->options.all))
        return false;
    for (int n = 1; halved && n <= c->norms.count; n++)
        if (!rational_mul_2exp(&c->norms.norm[n], &c->norms.norm[n], -n))
            return false;
    return true;
}

/* Up to the power that proves C1, or as far as the limits allow. */
static int highest_power(regular_run *r)
{
    int first = 0, most = 0;
    r->proved = true;
    for (int i = 0; i < r->column_count; i++) {
        const column *c = &r->columns[i];
        int n = norm_list_first_contraction(&c->norms);
        most = c->norms.count > most ? c->norms.count : most;
        if (!c->must_contract)
            continue;
        r->proved = r->proved && n > 0;
        first = n > first ? n : first;
    }
    return r->proved && !r->options.all ? first : most;
}

/* The norms that must contract come first, for they say how many of the others are wanted; then all are completed. */
static bool find_norms(regular_run *r)
{
    static const char *const names[2][3] = {{"2a12", "2a13", "2a23"}, {"2a11", "2a12", "2a22"}};
    static const char *const halves[2] = {"a1", "a2"};
    const char *const *name = names[r->masks.mesh != MESH_TRIANGLE];
    int seconds = r->masks.symmetric ? 2 : 3, firsts = r->masks.symmetric ? 1 : 2;
    for (int i = 0; i < seconds; i++)
        if (!add_column(r, name[i], &r->masks.second[i], false))
            return false;
    r->power = highest_power(r);
    for (int i = 0; i < seconds; i++)
        if (r->columns[i].norms.count < r->power && !norm_list_make(&r->columns[i].norms, &r->masks.second[i], r->power, false))
            return false;
    r->options.max_power = r->power;
    for (int i = 0; i < firsts; i++)
        if (!add_column(r, halves[i], &r->masks.derivative[i], true))
            return false;
    return true;
}

static bool find_constants(regular_run *r)
{
    return comparison_make(&r->comparison, &r->scheme.mask, &r->masks)
           && (r->masks.mesh != MESH_TRIANGLE || decomposition_make(&r->thesis, &r->scheme.mask, &r->masks));
}

static bool find_bounds(regular_run *r)
{
    for (int i = 0; r->proved && i < 3; i++)
        if (i == 2 && r->masks.symmetric)
            r->stability[2] = r->stability[1];
        else if (!stability_find(&r->stability[i], &r->scheme.mask, &r->masks, &r->comparison, i - 1))
            return false;
    return true;
}

static bool analyse(regular_run *r)
{
    if (!regular_derive(&r->masks, &r->scheme.mask, r->scheme.mesh))
        return false;
    if (r->masks.divisible && !(find_norms(r) && find_constants(r) && find_bounds(r)))
        return false;
    return r->proved || regular_refute(&r->refutation, &r->scheme.mask, r->scheme.mesh);
}

/* ---- text ---- */

/* Longer fractions would spread the table over more than a screen: there the decimals stand alone. */
enum { MAX_FRACTION = 22, CELL = MAX_FRACTION + 14 };

/* v near x as text; never a whole number unless it is x. */
static void write_decimal(char *text, size_t size, const rational *x)
{
    double v = rational_get_double_approx(x);
    snprintf(text, size, "%.6g", v);
    if (!strpbrk(text, ".e"))
        snprintf(text, size, "%.15g", v);
}

/* false: no memory. */
static bool write_cell(char text[CELL], const rational *x)
{
    char decimal[32];
    char *fraction = rational_get_str(x);
    if (!fraction)
        return false;
    write_decimal(decimal, sizeof decimal, x);
    if (rational_is_integer(x))
        snprintf(text, CELL, "%.*s", MAX_FRACTION, fraction);
    else if (strlen(fraction) > MAX_FRACTION)
        snprintf(text, CELL, "%.12s...", decimal);
    else
        snprintf(text, CELL, "%s = %.10s", fraction, decimal);
    free(fraction);
    return true;
}

static const column *shown_column(const regular_run *r, int i)
{
    int seconds = r->masks.symmetric ? 2 : 3, firsts = r->column_count - seconds;
    return &r->columns[i < firsts ? seconds + i : i - firsts];
}

static bool print_row(const regular_run *r, int n, const int *width)
{
    printf("%2d", n);
    for (int i = 0; i < r->column_count; i++) {
        const column *c = shown_column(r, i);
        char text[CELL] = "";
        if (n <= c->norms.count && !write_cell(text, &c->norms.norm[n]))
            return false;
        printf(i + 1 < r->column_count ? "   %-*s" : "   %.*s", i + 1 < r->column_count ? width[i] : CELL, text);
    }
    printf("\n");
    return true;
}

static bool print_table(const regular_run *r)
{
    int width[MAX_COLUMNS];
    char text[CELL];
    for (int i = 0; i < r->column_count; i++) {
        const column *c = shown_column(r, i);
        width[i] = (int)strlen(c->name) + 6;
        for (int n = 1; n <= r->power && n <= c->norms.count; n++) {
            if (!write_cell(text, &c->norms.norm[n]))
                return false;
            width[i] = (int)strlen(text) > width[i] ? (int)strlen(text) : width[i];
        }
    }
    printf(" N");
    for (int i = 0; i < r->column_count; i++) {
        const column *c = shown_column(r, i);
        printf("   |S_%s^N|", c->name);
        printf("%*s", i + 1 < r->column_count ? width[i] - (int)strlen(c->name) - 6 : 0, "");
    }
    printf("\n");
    for (int n = 1; n <= r->power; n++)
        if (!print_row(r, n, width))
            return false;
    return true;
}

static const char *mesh_in_words(mesh_kind mesh)
{
    static const char *const names[] = {"triangles", "quads", "quads, dual"};
    return names[mesh];
}

static long count_points(const laurent *mask)
{
    long count = 0;
    for (long i = 0; i < mask->na * mask->nb; i++)
        count += !integer_is_zero(&mask->coefficient[i]);
    return count;
}

static void print_refutation(const regular_refutation *z)
{
    if (z->point.a == 0) {
        printf("no; a net that is not constant round a vertex does not change there,\n"
               "so that subdivision does not converge\n");
        return;
    }
    printf("no; besides those of constant and linear functions there is an\n"
           "eigenvalue of modulus >= %.17g (frequency %d), and its eigenfunction is not 0\n",
           (double)z->modulus / REFUTATION_UNIT, z->frequency);
}

static void print_verdict(const regular_run *r)
{
    printf("\nC1 on the regular complex: ");
    if (r->refutation.refuted) {
        print_refutation(&r->refutation);
        return;
    }
    if (!r->proved) {
        printf("undecided; no power up to %d has norms below 1\n", r->power);
        return;
    }
    printf("proved by");
    for (int i = 0; i < r->column_count; i++)
        if (r->columns[i].must_contract)
            printf("%s |S_%s^%d| < 1", i ? "," : "", r->columns[i].name, norm_list_first_contraction(&r->columns[i].norms));
    printf("\n");
}

/* A bound as a fraction in lowest terms. */
static void write_bound(char text[CELL], const stability *k)
{
    int64_t numerator = k->bound, denominator = STABILITY_UNIT;
    while (numerator % 2 == 0 && denominator > 1) {
        numerator /= 2;
        denominator /= 2;
    }
    snprintf(text, CELL, denominator > 1 ? "%" PRId64 "/%" PRId64 : "%" PRId64, numerator, denominator);
}

static void print_stability(const stability *k, const char *name, const char *mask)
{
    char bound[CELL];
    write_bound(bound, k);
    switch (k->kind) {
    case STABILITY_NONE:
        printf("no bound of %s", name);
        break;
    case STABILITY_CONVEX:
        printf("%s = 1: no weight is negative", name);
        break;
    default: /* four decimals, rounded up */
        printf("%s <= %s < %.4f by %s S%s^%d", name, bound, (double)(k->bound * 10000 / STABILITY_UNIT + 1) / 10000,
               k->kind == STABILITY_SERIES ? "a series from" : "windows of", mask, k->power);
    }
    printf("\n");
}

/* What is said once for both derivatives where they are mirror images. */
static bool print_bounds(const regular_run *r)
{
    static const char *const what[4] = {"values", "derivative 1", "derivative 2", "derivatives"}, *const masks[3] = {"", "_2a1", "_2a2"};
    static const char *const distance[4] = {"C", "C1", "C2", "C1 = C2"}, *const bound[4] = {"K", "K1", "K2", "K1, K2"};
    const rational *c[3] = {&r->comparison.values, &r->comparison.derivative[0], &r->comparison.derivative[1]};
    printf("\n");
    for (int i = 0; i < (r->masks.symmetric ? 2 : 3); i++) {
        int name = i == 1 && r->masks.symmetric ? 3 : i;
        char text[CELL];
        if (!write_cell(text, c[i]))
            return false;
        printf("%-13s %s = %-*s", what[name], distance[name], 24 - (int)strlen(distance[name]), text);
        printf("  ");
        print_stability(&r->stability[i], bound[name], masks[i]);
    }
    return true;
}

/* "C = 3/4 = 0.75, C1 = C2 = 5/4 = 1.25" */
static bool print_constants(const comparison *c, bool symmetric)
{
    char text[3][CELL];
    if (!write_cell(text[0], &c->values) || !write_cell(text[1], &c->derivative[0]) || !write_cell(text[2], &c->derivative[1]))
        return false;
    if (symmetric)
        printf("C = %s, C1 = C2 = %s\n", text[0], text[1]);
    else
        printf("C = %s, C1 = %s, C2 = %s\n", text[0], text[1], text[2]);
    return true;
}

static bool is_at_least(const comparison *x, const comparison *y)
{
    return rational_cmp(&x->values, &y->values) >= 0 && rational_cmp(&x->derivative[0], &y->derivative[0]) >= 0
           && rational_cmp(&x->derivative[1], &y->derivative[1]) >= 0;
}

static bool print_thesis(const regular_run *r)
{
    if (r->masks.mesh != MESH_TRIANGLE || !r->thesis.identity)
        return true;
    printf("\nThe least constants are above. By decompositions (Zorin's thesis, 4.22 to 4.27):\n");
    printf("as printed    ");
    if (!print_constants(&r->thesis.printed, r->masks.symmetric))
        return false;
    if (!is_at_least(&r->thesis.printed, &r->comparison))
        printf("              (below the least: these are no bounds)\n");
    printf("as proved     ");
    return print_constants(&r->thesis.proved, r->masks.symmetric);
}

static bool print_text(const regular_run *r)
{
    printf("%s: %s, %ld mask points%s\n\n", r->scheme.name, mesh_in_words(r->scheme.mesh), count_points(&r->scheme.mask),
           r->masks.symmetric ? ", equal to its mirror image" : ", not equal to its mirror image");
    if (!r->masks.divisible && r->refutation.refuted) {
        printf("The mask is not divisible by 1 + z^-d in the directions needed, and there are no norms.\n");
        print_verdict(r);
        return true;
    }
    if (!r->masks.divisible) {
        printf("C1 on the regular complex: undecided; the mask is not divisible by 1 + z^-d in the directions\n"
               "needed, and the criterion by norms is silent\n");
        return true;
    }
    if (!print_table(r))
        return false;
    print_verdict(r);
    return print_bounds(r) && print_thesis(r);
}

/* ---- JSON ---- */

static bool print_json_rational(const char *key, const rational *x, const char *behind)
{
    char *text = rational_get_str(x);
    if (text)
        printf("\"%s\": \"%s\"%s", key, text, behind);
    free(text);
    return text != NULL;
}

static bool print_json_norms(const regular_run *r)
{
    printf("  \"norms\": [");
    for (int n = 1; n <= r->power; n++) {
        printf("%s\n    {\"power\": %d", n > 1 ? "," : "", n);
        for (int i = 0; i < r->column_count; i++) {
            const column *c = shown_column(r, i);
            if (n > c->norms.count)
                continue;
            printf(", ");
            if (!print_json_rational(c->name, &c->norms.norm[n], ""))
                return false;
        }
        printf("}");
    }
    printf("\n  ],\n");
    return true;
}

static bool print_json_constants(const char *key, const comparison *c)
{
    printf("  \"%s\": {", key);
    return print_json_rational("C", &c->values, ", ") && print_json_rational("C1", &c->derivative[0], ", ")
           && print_json_rational("C2", &c->derivative[1], "},\n");
}

static bool print_json_thesis(const regular_run *r)
{
    if (r->masks.mesh != MESH_TRIANGLE || !r->thesis.identity)
        return true;
    if (!print_json_constants("comparison_thesis", &r->thesis.printed) || !print_json_constants("comparison_decomposition", &r->thesis.proved))
        return false;
    printf("  \"comparison_thesis_is_bound\": %s,\n", is_at_least(&r->thesis.printed, &r->comparison) ? "true" : "false");
    return true;
}

static void print_json_stability(const char *key, const stability *k, const char *behind)
{
    static const char *const kinds[] = {"none", "convex", "window", "series"};
    char bound[CELL];
    write_bound(bound, k);
    printf("    \"%s\": {\"method\": \"%s\"", key, kinds[k->kind]);
    if (k->kind != STABILITY_NONE && k->kind != STABILITY_CONVEX)
        printf(", \"power\": %d", k->power);
    if (k->kind != STABILITY_NONE)
        printf(", \"bound\": \"%s\"", bound);
    printf("}%s\n", behind);
}

/* Scheme names are letters, digits and '-', so nothing needs an escape. */
static bool print_json(const regular_run *r)
{
    printf("{\n  \"scheme\": \"%s\",\n  \"mesh\": \"%s\",\n  \"mirror_symmetric_mask\": %s,\n  \"divisible\": %s,\n", r->scheme.name,
           mesh_name(r->scheme.mesh), r->masks.symmetric ? "true" : "false", r->masks.divisible ? "true" : "false");
    if (r->masks.divisible) {
        if (!print_json_norms(r))
            return false;
        if (!print_json_constants("comparison", &r->comparison) || !print_json_thesis(r))
            return false;
        printf("  \"stability\": {\n");
        print_json_stability("K", &r->stability[0], ",");
        print_json_stability("K1", &r->stability[1], ",");
        print_json_stability("K2", &r->stability[2], "");
        printf("  },\n");
    }
    if (r->refutation.refuted)
        printf("  \"refutation\": {\"modulus_at_least\": %.17g, \"frequency\": %d, \"seen_at\": [%d, %d]},\n",
               (double)r->refutation.modulus / REFUTATION_UNIT, r->refutation.frequency, r->refutation.point.a, r->refutation.point.b);
    printf("  \"c1_on_regular_complex\": \"%s\"\n}\n", r->proved ? "proved" : r->refutation.refuted ? "refuted" : "undecided");
    return true;
}

/* ---- the command ---- */

static void regular_run_init(regular_run *r)
{
    scheme_init(&r->scheme);
    regular_init(&r->masks);
    for (int i = 0; i < MAX_COLUMNS; i++)
        norm_list_init(&r->columns[i].norms);
    r->column_count = r->power = 0;
    r->proved = false;
    r->refutation.refuted = false;
    comparison_init(&r->comparison);
    decomposition_init(&r->thesis);
    for (int i = 0; i < 3; i++)
        r->stability[i] = (stability){STABILITY_NONE, 0, 0};
}

static void regular_run_clear(regular_run *r)
{
    scheme_clear(&r->scheme);
    regular_clear(&r->masks);
    for (int i = 0; i < MAX_COLUMNS; i++)
        norm_list_clear(&r->columns[i].norms);
    comparison_clear(&r->comparison);
    decomposition_clear(&r->thesis);
}

static int run(regular_run *r)
{
    int result = scheme_options_load(&r->scheme, &r->options.scheme);
    if (result >= 0)
        return result;
    if (!analyse(r) || !(r->options.json ? print_json(r) : print_text(r)))
        return complain(EXIT_NO_MEMORY, "no memory");
    return 0;
}

int command_regular(int argc, char **argv)
{
    regular_run r;
    int result = read_options(&r.options, argc, argv);
    if (result >= 0)
        return result;
    regular_run_init(&r);
    result = run(&r);
    regular_run_clear(&r);
    return finish_output(result);
}
