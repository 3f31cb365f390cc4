/* command_prove.c: the main command: a scheme, valences, one line and one certificate for each. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "archive.h"
#include "escalate.h"
#include "command_scheme.h"
#include "valences.h"

#include "../bigfloat/interval.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert prove SCHEME --valence LIST [OPTION]...\n"
    "Proves that the scheme (a name of the catalogue, or a file) is C1 at vertices of each valence.\n"
    "\n"
    "  --valence LIST        valences, such as 7 or 3..20,50\n"
    "  --set NAME=VALUE      another value for a parameter of the scheme (may be repeated)\n"
    "  --precision BITS      only balls of this precision (64 to 8192); default: hardware\n"
    "                        intervals, then balls of 64, 128, 256 ... bits\n"
    "  --max-precision BITS  the highest precision to try (default 4096)\n"
    "  --max-level N         the deepest subdivision to try (default: grows with the precision)\n"
    "  --out DIR|none        where certificates and logs go (default smoothcert-NAME)\n"
    "  --help                this text\n";

typedef struct {
    scheme_options scheme;
    const char *list;
    const char *out;
    limits limits;
} options;

typedef struct {
    options options;
    scheme scheme;
    problem problem;
    valences valences;
    archive archive;
} prove_run;

/* ---- arguments ---- */

/* -1: go on; else the exit status. */
static int read_options(options *o, int argc, char **argv)
{
    enum { OPTION_VALENCE = 256, OPTION_SET, OPTION_PRECISION, OPTION_MAX_PRECISION, OPTION_MAX_LEVEL, OPTION_OUT, OPTION_HELP };
    static const struct option known[] = {
        {"valence", required_argument, NULL, OPTION_VALENCE},
        {"set", required_argument, NULL, OPTION_SET},
        {"precision", required_argument, NULL, OPTION_PRECISION},
        {"max-precision", required_argument, NULL, OPTION_MAX_PRECISION},
        {"max-level", required_argument, NULL, OPTION_MAX_LEVEL},
        {"out", required_argument, NULL, OPTION_OUT},
        {"help", no_argument, NULL, OPTION_HELP},
        {NULL, 0, NULL, 0},
    };
    long level = 0;
    int option, result;
    memset(o, 0, sizeof *o);
    o->limits = (limits){0, 4096, 0, false};
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        switch (option) {
        case OPTION_VALENCE:
            o->list = optarg;
            break;
        case OPTION_SET:
            if (!scheme_options_set(&o->scheme, optarg))
                return complain(EXIT_USAGE, "--set: at most %d settings", SCHEME_OPTIONS_MAX);
            break;
        case OPTION_PRECISION:
            if (!read_long_option(&o->limits.precision, optarg, LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION))
                return complain(EXIT_USAGE, "--precision: expected a number of bits from %d to %d, found '%s'", LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION, optarg);
            break;
        case OPTION_MAX_PRECISION:
            if (!read_long_option(&o->limits.max_precision, optarg, 0, LIMITS_MAX_PRECISION))
                return complain(EXIT_USAGE, "--max-precision: expected a number of bits from 0 to %d, found '%s'", LIMITS_MAX_PRECISION, optarg);
            break;
        case OPTION_MAX_LEVEL:
            if (!read_long_option(&level, optarg, 1, TREE_MAX_DEPTH))
                return complain(EXIT_USAGE, "--max-level: expected a number from 1 to %d, found '%s'", TREE_MAX_DEPTH, optarg);
            o->limits.max_level = (int)level;
            break;
        case OPTION_OUT:
            o->out = optarg;
            break;
        case OPTION_HELP:
            fputs(help, stdout);
            return finish_output(0);
        default:
            return complain(EXIT_USAGE, "prove: unknown option or missing value at '%s'; see 'smoothcert prove --help'", argv[optind - 1]);
        }
    }
    result = scheme_options_name(&o->scheme, "prove", argc, argv, optind);
    if (result >= 0)
        return result;
    if (!o->list)
        return complain(EXIT_USAGE, "prove: no valences given, such as --valence 3..20");
    return -1;
}

/* ---- evidence ---- */

static int open_archive(prove_run *r)
{
    char name[SCHEME_NAME_MAX + 32];
    const char *path = r->options.out;
    if (path && !strcmp(path, "none"))
        return -1;
    snprintf(name, sizeof name, "smoothcert-%s", r->scheme.name);
    if (!path)
        path = name;
    switch (archive_open(&r->archive, path, &r->scheme)) {
    case ARCHIVE_OK:
        return -1;
    case ARCHIVE_OTHER_SCHEME:
        return complain(EXIT_BAD_INPUT, "%s holds evidence for another scheme; name another directory with --out", path);
    default:
        return complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: %s", path, strerror(errno));
    }
}

/* ---- the answers ---- */

/* Bounds are printed so that the decimals still are bounds.  Printing moves a number by at most half a unit of the
   last digit, so it is moved by a little more than that before: for nine places behind the point 0.5e-9 (the
   excess is far above a rounding error of numbers below 1), for four significant digits of v at most v / 2000. */
static double round_up(double v)
{
    return v + 0.5e-9 * (1 + 1e-3);
}

static double round_down(double v)
{
    return v * (1 - 0.000501);
}

static void print_decision(const prove_run *r, const decision *d, const char *certificate)
{
    const findings *f = &d->findings;
    char others[32] = "L";
    if (f->runner_up < f->eigenvalue_lower)
        snprintf(others, sizeof others, "%.9f", round_up(f->runner_up));
    if (d->verdict == VERDICT_PROVED) {
        printf("proved: %s is C1 at valence %ld; L = %s, others < %s (block %ld), Jacobian > %.4g, level %d, %ld elements, ", r->scheme.name, d->valence,
               f->eigenvalue, others, f->runner_up_block, round_down(f->jacobian), f->level, f->elements);
    } else {
        printf("undecided: %s at valence %ld; %s: %s; last tried with ", r->scheme.name, d->valence, f->test, f->reason);
    }
    if (!d->system)
        printf("exact arithmetic");
    else if (!strcmp(d->system, "interval"))
        printf("double intervals");
    else
        printf("balls of %ld bits", d->precision);
    if (certificate)
        printf("; %s", certificate);
    printf("\n");
}

static int decide_all(prove_run *r)
{
    int result = EXIT_PROVED;
    for (size_t i = 0; i < r->valences.count; i++) {
        decision d;
        char *certificate = NULL;
        archive_status kept;
        decision_init(&d);
        decide_valence(&d, &r->problem, r->valences.valence[i], &r->options.limits);
        if (d.verdict != VERDICT_PROVED && d.no_memory) {
            decision_clear(&d);
            return complain(EXIT_NO_MEMORY, "no memory at valence %ld; what was finished before is kept", r->valences.valence[i]);
        }
        if (d.bad_input) {
            result = complain(EXIT_BAD_INPUT, "%s:%s", r->options.scheme.name, d.findings.reason);
            decision_clear(&d);
            continue;
        }
        kept = archive_keep(&r->archive, &certificate, &d);
        if (kept != ARCHIVE_OK) {
            int lost = complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: valence %ld could not be kept: %s", r->archive.path, d.valence, strerror(errno));
            free(certificate);
            decision_clear(&d);
            return lost;
        }
        print_decision(r, &d, certificate);
        if (d.verdict != VERDICT_PROVED && result == EXIT_PROVED)
            result = EXIT_UNDECIDED;
        free(certificate);
        decision_clear(&d);
        if (fflush(stdout) != 0)
            return EXIT_IO; /* finish_output complains */
    }
    return result;
}

static int prove(prove_run *r)
{
    const char *complaint;
    int result = scheme_options_load(&r->scheme, &r->options.scheme);
    if (result >= 0)
        return result;
    complaint = valences_read(&r->valences, r->options.list);
    if (complaint)
        return complain(EXIT_USAGE, "--valence %s: %s", r->options.list, complaint);
    if (!interval_self_test()) {
        r->options.limits.no_intervals = true;
        complain(0, "this machine or compiler does not round doubles as told: only balls are used");
    }
    if (!problem_make(&r->problem, &r->scheme))
        return complain(EXIT_NO_MEMORY, "no memory");
    result = open_archive(r);
    return result >= 0 ? result : decide_all(r);
}

int command_prove(int argc, char **argv)
{
    prove_run r;
    int result = read_options(&r.options, argc, argv);
    if (result >= 0)
        return result;
    scheme_init(&r.scheme);
    problem_init(&r.problem);
    r.valences.count = 0;
    archive_init(&r.archive);
    result = prove(&r);
    archive_clear(&r.archive);
    problem_clear(&r.problem);
    scheme_clear(&r.scheme);
    return finish_output(result);
}
