/* command_prove.c: the main command: a scheme, valences, one line and one certificate for each. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "archive.h"
#include "archive_index.h"
#include "archive_run.h"
#include "classification.h"
#include "command_out.h"
#include "command_scheme.h"
#include "escalate.h"
#include "keeper.h"
#include "partition.h"
#include "progress.h"
#include "prove_output.h"
#include "valence_list.h"
#include "workers.h"

#include "../bigfloat/interval.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert prove SCHEME --valence LIST [OPTION]...\n"
    "Proves that the scheme (a name of the catalogue, or a file) is C1 at vertices of each valence, or\n"
    "that it is not.\n"
    "\n"
    "  --valence LIST        valences, such as 7 or 3..20,50 or 8..inf or all; up to 1,000 of them are\n"
    "                        examined one by one, more in ranges, as wide as can be decided at once\n"
    "  --each                one by one, however many they are (100,000 at most)\n"
    "  --set NAME=VALUE      another value for a parameter of the scheme (may be repeated)\n"
    "  --method METHOD       adaptive (default), or uniform: the reference for triangle meshes, which\n"
    "                        subdivides everywhere alike and bounds the error of the whole net; the\n"
    "                        certificate's trees are then sought no deeper\n"
    "  --precision BITS      only balls of this precision (64 to 8192); default: hardware\n"
    "                        intervals, then balls of 64, 128, 256 ... bits\n"
    "  --max-precision BITS  the highest precision to try (default 4096; 0: intervals only)\n"
    "  --max-level N         the deepest subdivision to try (default: grows with the precision)\n"
    "  --time-limit SECONDS  leave undecided what is not decided by then\n"
    "  --jobs N              work on N valences at a time (default 1)\n"
    "  --out DIR|none        where certificates and logs go (default smoothcert-NAME, with the\n"
    "                        settings behind it); what is proved there already is only checked\n"
    "                        again\n"
    "  --json                one JSON object per line, for each valence or range\n"
    "  --help                this text\n"
    "\n"
    "Behind ranges a line sums up, such as \"butterfly, in 7 boxes: C1: 4..7; not C1: 3 (jordan) ...\".\n"
    "Exit status: 0 everything was proved, 1 something was refuted, else 2 something stayed undecided.\n";

/* More valences than that are examined in ranges, unless --each is given, which goes farther. */
enum { MAX_EACH = 1000, MAX_EACH_FORCED = 100000 };

typedef struct {
    scheme_options scheme;
    const char *list;
    const char *out;
    limits limits;
    long jobs;
    bool uniform;
    bool each;
    bool json;
} options;

typedef struct {
    buffer command; /* for the archive: getopt_long changes the order of argv */
    options options;
    scheme scheme;
    problem problem;
    uniform_bounds uniform;
    valence_list list;
    archive archive;
    keeper keeper;
    progress progress;
    long reported;
    bool in_ranges;
    classification classification; /* of ranges */
    archive_index earlier;         /* what was there before, then */
    int result;
} prove_run;

/* ---- arguments ---- */

/* -1: go on; else the exit status. */
static int read_option(options *o, int option, const char *value)
{
    long level = 0;
    switch (option) {
    case 'v':
        o->list = value;
        return -1;
    case 's':
        return scheme_options_set(&o->scheme, value) ? -1 : complain(EXIT_USAGE, "--set: at most %d settings", SCHEME_OPTIONS_MAX);
    case 'M':
        o->uniform = !strcmp(value, "uniform");
        return o->uniform || !strcmp(value, "adaptive") ? -1 : complain(EXIT_USAGE, "--method: expected 'adaptive' or 'uniform', found '%s'", value);
    case 'p':
        if (read_long_option(&o->limits.precision, value, LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION))
            return -1;
        return complain(EXIT_USAGE, "--precision: expected a number of bits from %d to %d, found '%s'", LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION, value);
    case 'm':
        if (read_long_option(&o->limits.max_precision, value, 0, LIMITS_MAX_PRECISION))
            return -1;
        return complain(EXIT_USAGE, "--max-precision: expected a number of bits from 0 to %d, found '%s'", LIMITS_MAX_PRECISION, value);
    case 'l':
        if (!read_long_option(&level, value, 1, TREE_MAX_DEPTH))
            return complain(EXIT_USAGE, "--max-level: expected a number from 1 to %d, found '%s'", TREE_MAX_DEPTH, value);
        o->limits.max_level = (int)level;
        return -1;
    case 't':
        return read_seconds_option(&o->limits.deadline, value) ? -1 : complain(EXIT_USAGE, "--time-limit: expected a number of seconds, found '%s'", value);
    case 'j':
        return read_long_option(&o->jobs, value, 1, 256) ? -1 : complain(EXIT_USAGE, "--jobs: expected a number from 1 to 256, found '%s'", value);
    case 'o':
        o->out = value;
        return -1;
    case 'e':
        o->each = true;
        return -1;
    case 'J':
        o->json = true;
        return -1;
    default:
        fputs(help, stdout);
        return finish_output(0);
    }
}

static int read_options(options *o, int argc, char **argv)
{
    static const struct option known[] = {
        {"valence", required_argument, NULL, 'v'},   {"set", required_argument, NULL, 's'},       {"precision", required_argument, NULL, 'p'},
        {"max-precision", required_argument, NULL, 'm'}, {"max-level", required_argument, NULL, 'l'}, {"time-limit", required_argument, NULL, 't'},
        {"jobs", required_argument, NULL, 'j'},      {"out", required_argument, NULL, 'o'},       {"json", no_argument, NULL, 'J'},
        {"method", required_argument, NULL, 'M'},    {"each", no_argument, NULL, 'e'},               {"help", no_argument, NULL, 'h'},
        {NULL, 0, NULL, 0},
    };
    int option, result;
    memset(o, 0, sizeof *o);
    o->limits.max_precision = 4096;
    o->jobs = 1;
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        if (option == '?')
            return complain(EXIT_USAGE, "prove: unknown option or missing value at '%s'; see 'smoothcert prove --help'", argv[optind - 1]);
        result = read_option(o, option, optarg);
        if (result >= 0)
            return result;
    }
    result = scheme_options_name(&o->scheme, "prove", argc, argv, optind);
    if (result >= 0)
        return result;
    if (!o->list)
        return complain(EXIT_USAGE, "prove: no valences given, such as --valence 3..20");
    return -1;
}

/* ---- evidence ---- */

/* smoothcert-NAME, and the settings: another scheme needs another directory.  Characters that might not do in the name
   of a file become `_`; if two schemes come to have one name so, archive_open tells them apart. */
static void name_archive(char *name, size_t size, const prove_run *r)
{
    size_t length = (size_t)snprintf(name, size, "smoothcert-%s", r->scheme.name);
    for (int i = 0; i < r->options.scheme.count; i++) {
        const char *c = r->options.scheme.settings[i];
        if (length + 1 < size)
            name[length++] = ',';
        for (; *c && length + 1 < size; c++)
            if (*c != ' ')
                name[length++] = strchr("+-.=_", *c) || isalnum((unsigned char)*c) ? *c : '_';
        name[length] = '\0';
    }
}

static int open_archive(prove_run *r)
{
    char name[SCHEME_NAME_MAX + 128];
    const char *path = r->options.out;
    if (path && !strcmp(path, "none"))
        return -1;
    name_archive(name, sizeof name, r);
    return command_open_archive(&r->archive, path ? path : name, &r->scheme, &r->command);
}

/* ---- the answers ---- */

typedef struct {
    decision decision;
    archive_earlier earlier;
    char *certificate; /* where it is kept */
} answer;

static void discard(void *result)
{
    answer *a = result;
    if (!a)
        return;
    free(a->certificate);
    decision_clear(&a->decision);
    free(a);
}

/* The widest range that holds k for which an earlier run has left a certificate, which begins at k if it has to; k alone: none.
   (The index has longer ranges before shorter ones.) */
static valence_range find_range(const prove_run *r, buffer *certificate, archive_earlier *earlier, long k, bool from_k)
{
    for (size_t i = 0; i < r->earlier.count; i++) {
        const archive_index_entry *e = &r->earlier.entry[i];
        bool holds = from_k ? e->valences.first == k : e->valences.first <= k && k <= e->valences.last;
        if (!holds || e->verdict == VERDICT_UNDECIDED)
            continue;
        *earlier = archive_read(&r->archive, certificate, e->valences);
        if (*earlier != EARLIER_DAMAGED)
            return e->valences;
    }
    return one_valence(k);
}

/* By a certificate of many valences, so that two do not speak of one. */
static bool decide_within_range(prove_run *r, answer *a, long k)
{
    buffer certificate;
    archive_earlier earlier = EARLIER_NONE;
    bool decided;
    valence_range range;
    buffer_init(&certificate);
    range = find_range(r, &certificate, &earlier, k, false);
    decided = !is_one_valence(range) && decide_by_certificate(&a->decision, &r->problem, range, &certificate, &r->options.limits);
    buffer_clear(&certificate);
    if (decided)
        a->earlier = earlier;
    return decided;
}

static void *decide(long i, void *data)
{
    prove_run *r = data;
    long k = valence_list_get(&r->list, i);
    answer *a = calloc(1, sizeof *a);
    buffer earlier;
    if (!a)
        return NULL;
    decision_init(&a->decision);
    buffer_init(&earlier);
    a->earlier = archive_read(&r->archive, &earlier, one_valence(k));
    if (a->earlier != EARLIER_NONE || !decide_within_range(r, a, k))
        decide_valence(&a->decision, &r->problem, k, &earlier, &r->options.limits);
    buffer_clear(&earlier);
    return a;
}

static void raise_result(prove_run *r, int exit_status)
{
    bool worse = r->result == EXIT_PROVED || exit_status > EXIT_UNDECIDED || (exit_status == EXIT_REFUTED && r->result == EXIT_UNDECIDED);
    if (worse)
        r->result = exit_status;
}

static bool report(prove_run *r, const answer *a)
{
    const decision *d = &a->decision;
    if (a->earlier == EARLIER_DAMAGED)
        complain(0, "%s: the certificate for valence %ld is not the one that was finished; it is made anew", r->archive.path, d->k.first);
    if (d->verdict == VERDICT_UNDECIDED && deadline_interrupted()) {
        raise_result(r, EXIT_INTERRUPTED);
        return false;
    }
    if (d->outcome == OUTCOME_NO_MEMORY) {
        raise_result(r, complain(EXIT_NO_MEMORY, "no memory at valence %ld; what was finished before is kept", d->k.first));
        return false;
    }
    if (d->outcome == OUTCOME_BAD_INPUT) {
        raise_result(r, complain(EXIT_BAD_INPUT, "%s:%s", r->options.scheme.name, decision_obstacle(d)->reason));
        return true;
    }
    (r->options.json ? prove_print_json : prove_print_line)(r->scheme.name, d, a->certificate);
    if (d->verdict != VERDICT_PROVED)
        raise_result(r, d->verdict == VERDICT_REFUTED ? EXIT_REFUTED : EXIT_UNDECIDED);
    if (fflush(stdout) != 0) {
        raise_result(r, EXIT_IO); /* finish_output complains */
        return false;
    }
    return true;
}

/* ---- what is finished ---- */

static bool is_worth_keeping(const answer *a)
{
    const decision *d = &a->decision;
    return d->verdict != VERDICT_UNDECIDED || (d->outcome != OUTCOME_NO_MEMORY && d->outcome != OUTCOME_BAD_INPUT && !deadline_interrupted());
}

_Static_assert((int)KEEPER_GROUP_MAX <= (int)ARCHIVE_GROUP_MAX, "a group of the keeper is one of the archive");

/* Makes the answers durable; only then are they told. */
static bool keep_all(prove_run *r, answer *const *answers, int count)
{
    archive_status kept = ARCHIVE_OK;
    long from = 0;
    for (int i = 0; kept == ARCHIVE_OK && i < count; i++) {
        if (!answers[i] || !is_worth_keeping(answers[i]))
            continue;
        from = from ? from : answers[i]->decision.k.first;
        kept = archive_keep(&r->archive, &answers[i]->certificate, &answers[i]->decision, answers[i]->earlier);
    }
    if (kept == ARCHIVE_OK)
        kept = archive_commit(&r->archive);
    if (kept == ARCHIVE_OK)
        return true;
    raise_result(r, complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: valence %ld and what follows could not be kept: %s", r->archive.path, from, strerror(errno)));
    return false;
}

static bool report_next(prove_run *r, const answer *a)
{
    bool go_on = a != NULL && report(r, a);
    if (!a)
        raise_result(r, complain(EXIT_NO_MEMORY, "no memory"));
    r->reported++;
    if (go_on && r->in_ranges && !classification_add(&r->classification, &a->decision)) {
        raise_result(r, complain(EXIT_NO_MEMORY, "no memory"));
        go_on = false;
    }
    if (go_on && deadline_interrupted() && r->reported < r->list.count) {
        raise_result(r, EXIT_INTERRUPTED);
        go_on = false;
    }
    return go_on;
}

static bool keep_group(void *const *results, int count, void *data)
{
    prove_run *r = data;
    answer *const *answers = (answer *const *)results;
    bool go_on;
    progress_clear(&r->progress);
    go_on = keep_all(r, answers, count);
    for (int i = 0; i < count; i++) {
        go_on = go_on && report_next(r, answers[i]);
        discard(answers[i]);
    }
    progress_show(&r->progress, r->reported);
    return go_on;
}

static bool finish(long i, void *result, void *data)
{
    prove_run *r = data;
    (void)i;
    return keeper_put(&r->keeper, result);
}

static void interrupt(int signal)
{
    (void)signal;
    deadline_interrupt();
}

static void heed_interrupts(void)
{
    struct sigaction action = {.sa_handler = interrupt};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

/* ---- one by one, or in ranges ---- */

static bool decide_each(prove_run *r)
{
    workers w = {r->list.count, (int)r->options.jobs, decide, finish, discard, r};
    return workers_run(&w);
}

static bool take(decision *d, void *data)
{
    prove_run *r = data;
    answer *a = calloc(1, sizeof *a);
    buffer unused;
    if (a) {
        a->decision = *d;
        decision_init(d);
        buffer_init(&unused);
        a->earlier = archive_read(&r->archive, &unused, a->decision.k);
        buffer_clear(&unused);
    }
    return keeper_put(&r->keeper, a);
}

static valence_range find_earlier(buffer *certificate, long k, void *data)
{
    archive_earlier unused;
    return find_range(data, certificate, &unused, k, true);
}

static void summarise(const prove_run *r)
{
    buffer text;
    buffer_init(&text);
    if (r->options.json) {
        buffer_print(&text, "{\"scheme\":\"%s\",\"boxes\":%ld,", r->scheme.name, r->classification.boxes);
        classification_print_json(&text, &r->classification);
        buffer_print(&text, "}");
    } else {
        buffer_print(&text, "%s, in %ld %s: ", r->scheme.name, r->classification.boxes, r->classification.boxes == 1 ? "box" : "boxes");
        classification_print(&text, &r->classification);
        if (r->options.uniform)
            buffer_print(&text, "; uniform method: nets up to +/- %.2g wide, level %d at most", r->classification.uniform_width, r->classification.uniform_level);
    }
    if (!text.failed)
        puts(text.bytes);
    buffer_clear(&text);
}

static bool decide_ranges(prove_run *r)
{
    partition p = {&r->problem, &r->options.limits, find_earlier, take, r};
    bool more = true;
    for (int i = 0; more && i < r->list.ranges; i++)
        more = partition_run(&p, r->list.range[i]);
    return true;
}

static int decide_all(prove_run *r)
{
    bool ran;
    if (r->archive.path && !archive_index_make(&r->earlier, r->archive.path, &r->archive.finished))
        return complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: %s", r->archive.path, strerror(errno));
    progress_begin(&r->progress, r->list.count);
    keeper_start(&r->keeper);
    ran = (r->in_ranges ? decide_ranges : decide_each)(r);
    keeper_finish(&r->keeper);
    progress_clear(&r->progress);
    if (!ran)
        return complain(EXIT_NO_MEMORY, "no memory");
    if (r->classification.count)
        summarise(r);
    if (r->result <= EXIT_UNDECIDED || r->result == EXIT_INTERRUPTED || r->result == EXIT_BAD_INPUT) {
        int written = command_write_index(&r->archive);
        if (written)
            return written;
    }
    if (r->result == EXIT_INTERRUPTED)
        complain(0, r->archive.path ? "interrupted; what is finished is kept in %s, and the same command goes on" : "interrupted", r->archive.path);
    return r->result;
}

/* One by one, or in ranges?  These need the real form. */
static int prepare_ranges(prove_run *r)
{
    bool each = r->options.each || r->list.count <= MAX_EACH || (!r->scheme.mirror_symmetric && r->list.count <= MAX_EACH_FORCED);
    r->in_ranges = !each;
    if (each && r->list.count > MAX_EACH_FORCED)
        return complain(EXIT_USAGE, "--each examines at most %d valences in a run", MAX_EACH_FORCED);
    if (!each && !r->scheme.mirror_symmetric)
        return complain(EXIT_USAGE, "ranges of valences need a scheme that is evidently mirror-symmetric, which %s is not; name at most %d valences", r->scheme.name,
                        MAX_EACH_FORCED);
    return -1;
}

/* What the uniform method needs, where it is wanted. */
static int prepare_method(prove_run *r)
{
    if (!r->options.uniform)
        return -1;
    if (r->scheme.mesh != MESH_TRIANGLE)
        return complain(EXIT_USAGE, "--method uniform is for triangle meshes only, and %s is a scheme on a %s mesh", r->scheme.name, mesh_name(r->scheme.mesh));
    if (!uniform_bounds_make(&r->uniform, &r->problem))
        return complain(EXIT_NO_MEMORY, "no memory");
    if (r->uniform.obstacle && !r->problem.obstacle)
        return complain(EXIT_USAGE, "--method uniform cannot be used for %s: %s", r->scheme.name, r->uniform.obstacle);
    r->options.limits.uniform = &r->uniform;
    return -1;
}

static int prove(prove_run *r)
{
    const char *complaint;
    int result = scheme_options_load(&r->scheme, &r->options.scheme);
    if (result >= 0)
        return result;
    complaint = valence_list_read(&r->list, r->options.list);
    if (complaint)
        return complain(EXIT_USAGE, "--valence %s: %s", r->options.list, complaint);
    if (!interval_self_test()) {
        r->options.limits.no_intervals = true;
        complain(0, "this machine or compiler does not round doubles as told: only balls are used");
    }
    if (!problem_make(&r->problem, &r->scheme))
        return complain(EXIT_NO_MEMORY, "no memory");
    result = prepare_method(r);
    if (result >= 0)
        return result;
    result = prepare_ranges(r);
    if (result >= 0)
        return result;
    result = open_archive(r);
    return result >= 0 ? result : decide_all(r);
}

int command_prove(int argc, char **argv)
{
    prove_run r;
    int result;
    buffer_init(&r.command);
    archive_describe_run(&r.command, argc, argv);
    result = read_options(&r.options, argc, argv);
    if (result >= 0) {
        buffer_clear(&r.command);
        return result;
    }
    r.result = EXIT_PROVED;
    scheme_init(&r.scheme);
    problem_init(&r.problem);
    uniform_bounds_init(&r.uniform);
    r.list.count = 0;
    r.in_ranges = false;
    classification_init(&r.classification);
    archive_index_init(&r.earlier);
    r.reported = 0;
    r.keeper = (keeper){.keep = keep_group, .discard = discard, .data = &r};
    archive_init(&r.archive);
    heed_interrupts();
    result = prove(&r);
    archive_clear(&r.archive);
    archive_index_clear(&r.earlier);
    classification_clear(&r.classification);
    buffer_clear(&r.command);
    uniform_bounds_clear(&r.uniform);
    problem_clear(&r.problem);
    scheme_clear(&r.scheme);
    return finish_output(result);
}
