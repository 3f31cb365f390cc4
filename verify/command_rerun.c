/* command_rerun.c: is what a certificate states still so, and how much better can it be proved? */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "archive.h"
#include "archive_run.h"
#include "command_certificates.h"
#include "command_out.h"
#include "command_scheme.h"
#include "rerun_report.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

static const char help[] =
    "Usage: smoothcert rerun [OPTION]... CERTIFICATE|DIRECTORY...\n"
    "Follows each certificate's choices once more, then looks for others by a new search with balls, and says what\n"
    "holds and what became tighter.\n"
    "\n"
    "  --precision BITS      of the new search (64 to 8192); default, and least: the certificate's own\n"
    "  --time-limit SECONDS  for all of it\n"
    "  --out DIR             keep the new certificates in another directory (all of one scheme)\n"
    "  --json                one JSON object per certificate and line\n"
    "  --help                this text\n"
    "\n"
    "Exit status: 0 every scheme is C1 where its certificate says so, 1 something is refuted, else 2 something is\n"
    "undecided; 65 a certificate is damaged, or its choices do not prove what it states; 70 two proofs contradict\n"
    "each other: a fault of the program.\n";

typedef struct {
    buffer command;
    long precision;
    deadline deadline;
    const char *out;
    bool json;
    examine_subject subject;
    archive archive;
    int result;
} rerun_run;

static void raise_result(rerun_run *r, int exit_status)
{
    bool worse = r->result == EXIT_PROVED || exit_status > EXIT_UNDECIDED || (exit_status == EXIT_REFUTED && r->result == EXIT_UNDECIDED);
    if (worse && r->result <= EXIT_UNDECIDED)
        r->result = exit_status;
}

/* ---- one certificate ---- */

/* Why several valences are not C1: for the reason that the certificate has, if it can be read. */
static range_reason reason_of(const examination *x)
{
    if (x->claim.c1)
        return range_reason_after(CLAIM_C1, 0);
    return x->readable ? range_reason_after(x->choices.claim, x->choices.frequency) : range_reason_after(CLAIM_WINDOW, 2);
}

/* false: no memory.  A scheme that has no meaning at the valence is undecided. */
static bool search(decision *d, const rerun_run *r, const examination *x)
{
    limits l = {.precision = r->precision > x->claim.grid ? r->precision : x->claim.grid, .deadline = r->deadline};
    if (l.precision < LIMITS_MIN_PRECISION)
        l.precision = LIMITS_MIN_PRECISION;
    if (l.precision > LIMITS_MAX_PRECISION)
        l.precision = LIMITS_MAX_PRECISION;
    if (is_one_valence(x->claim.valences))
        decide_valence(d, &r->subject.problem, x->claim.valences.first, NULL, &l);
    else
        decide_range(d, &r->subject.problem, x->claim.valences, reason_of(x), &l);
    return d->outcome != OUTCOME_NO_MEMORY;
}

static int keep(rerun_run *r, const decision *d)
{
    char *certificate = NULL;
    buffer bytes;
    archive_earlier earlier;
    bool ok;
    buffer_init(&bytes);
    earlier = archive_read(&r->archive, &bytes, d->k);
    buffer_clear(&bytes);
    ok = archive_keep(&r->archive, &certificate, d, earlier) == ARCHIVE_OK && archive_commit(&r->archive) == ARCHIVE_OK;
    free(certificate);
    return ok ? 0 : complain_of_file(r->out);
}

static int report(rerun_run *r, const rerun *found)
{
    const examination *x = found->before;
    int result = 0;
    if (r->archive.path)
        result = keep(r, found->decision);
    if (result)
        return result;
    if (r->json) {
        buffer line;
        buffer_init(&line);
        rerun_print_json(&line, found);
        result = print_line(&line);
    } else {
        rerun_print_line(found);
    }
    if (result)
        return result;
    if (fflush(stdout) != 0)
        return EXIT_IO; /* finish_output complains */
    if (rerun_is_contradiction(found))
        return complain(EXIT_FAULT, "%s: its choices and those of a new search prove the opposite of each other: this is a fault of the program", found->file);
    if (x->followed != OUTCOME_TRUE && x->claim.version == STATEMENT_NEWEST_VERSION)
        raise_result(r, complain(EXIT_BAD_INPUT, "%s: this certificate does not prove what it states", found->file));
    switch (rerun_verdict(found)) {
    case VERDICT_PROVED:
        break;
    case VERDICT_REFUTED:
        raise_result(r, EXIT_REFUTED);
        break;
    default:
        raise_result(r, EXIT_UNDECIDED);
    }
    return 0;
}

/* x was examined. */
static int search_and_report(rerun_run *r, const char *file, const examination *x)
{
    examination y;
    decision d;
    rerun found = {.file = file, .scheme = r->subject.scheme.name, .before = x, .decision = &d, .after = &y};
    int result = 0;
    decision_init(&d);
    examination_init(&y);
    if (!search(&d, r, x))
        result = complain_of_memory();
    if (d.certificate.length)
        buffer_append(&y.bytes, d.certificate.bytes, d.certificate.length);
    if (result == 0 && d.certificate.length && (y.bytes.failed || !examine(&y, &r->subject, NULL)))
        result = complain_of_memory();
    if (result == 0)
        result = report(r, &found);
    decision_clear(&d);
    examination_clear(&y);
    return result;
}

/* All certificates of one run that keeps what it finds must be of one scheme. */
static int prepare_archive(rerun_run *r, const char *file, const examination *x)
{
    char *path;
    buffer kept;
    bool same;
    if (!r->out)
        return 0;
    if (!r->archive.path) {
        int opened = command_open_archive(&r->archive, r->out, &r->subject.scheme, &r->command);
        return opened < 0 ? 0 : opened;
    }
    path = durable_path(r->archive.path, ARCHIVE_SCHEME);
    buffer_init(&kept);
    same = path && buffer_read_file(&kept, path, ARCHIVE_MAX_BYTES) && statement_is_about(&x->claim, kept.bytes, kept.length);
    free(path);
    buffer_clear(&kept);
    return same ? 0 : complain(EXIT_BAD_INPUT, "%s is about another scheme than the certificates before it: --out takes those of one scheme", file);
}

static int rerun_certificate(const char *file, void *data)
{
    rerun_run *r = data;
    examination x;
    int result = 0;
    if (deadline_passed(&r->deadline)) {
        raise_result(r, EXIT_UNDECIDED);
        return 0;
    }
    examination_init(&x);
    if (!examine_read(&x, file))
        result = complain_of_file(file);
    else if (!examine(&x, &r->subject, NULL))
        result = complain_of_memory();
    else if (!r->subject.made || !x.claim.grid || !statement_is_about(&x.claim, r->subject.scheme.text, r->subject.scheme.text_length))
        raise_result(r, complain(EXIT_BAD_INPUT, "%s:%ld: %s", file, x.line, x.reason[0] ? x.reason : "expected 'grid' and a number"));
    else {
        result = prepare_archive(r, file, &x);
        if (result == 0)
            result = search_and_report(r, file, &x);
    }
    examination_clear(&x);
    return result;
}

/* ---- all of them ---- */

static int read_option(rerun_run *r, int option, const char *value)
{
    switch (option) {
    case 'p':
        if (read_long_option(&r->precision, value, LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION))
            return -1;
        return complain(EXIT_USAGE, "--precision: expected a number of bits from %d to %d, found '%s'", LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION, value);
    case 't':
        return read_seconds_option(&r->deadline, value) ? -1 : complain(EXIT_USAGE, "--time-limit: expected a number of seconds, found '%s'", value);
    case 'o':
        r->out = value;
        return -1;
    case 'J':
        r->json = true;
        return -1;
    default:
        fputs(help, stdout);
        return finish_output(0);
    }
}

static int read_options(rerun_run *r, int argc, char **argv)
{
    static const struct option known[] = {{"precision", required_argument, NULL, 'p'}, {"time-limit", required_argument, NULL, 't'}, {"out", required_argument, NULL, 'o'},
                                          {"json", no_argument, NULL, 'J'},            {"help", no_argument, NULL, 'h'},              {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int option; (option = getopt_long(argc, argv, "", known, NULL)) != -1;) {
        int result;
        if (option == '?')
            return complain(EXIT_USAGE, "rerun: unknown option or missing value at '%s'; see 'smoothcert rerun --help'", argv[optind - 1]);
        result = read_option(r, option, optarg);
        if (result >= 0)
            return result;
    }
    if (optind == argc)
        return complain(EXIT_USAGE, "rerun: no certificate given; see 'smoothcert rerun --help'");
    return -1;
}

int command_rerun(int argc, char **argv)
{
    rerun_run r = {.json = false};
    int result;
    buffer_init(&r.command);
    archive_describe_run(&r.command, argc, argv);
    result = read_options(&r, argc, argv);
    if (result >= 0) {
        buffer_clear(&r.command);
        return result;
    }
    result = 0;
    examine_subject_init(&r.subject);
    archive_init(&r.archive);
    for (int i = optind; result == 0 && i < argc; i++)
        result = for_each_certificate(argv[i], rerun_certificate, &r);
    if (result == 0)
        result = command_write_index(&r.archive);
    archive_clear(&r.archive);
    examine_subject_clear(&r.subject);
    buffer_clear(&r.command);
    return finish_output(result ? result : r.result);
}
