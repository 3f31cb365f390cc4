/* prove_keep.c: what is decided is made durable; only then is it told. */
#include "prove_run.h"

#include "command.h"
#include "prove_output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void prove_discard(void *answer)
{
    prove_answer *a = answer;
    if (!a)
        return;
    free(a->certificate);
    decision_clear(&a->decision);
    free(a);
}

void prove_raise_result(prove_run *r, int exit_status)
{
    bool worse = r->result == EXIT_PROVED || exit_status > EXIT_UNDECIDED || (exit_status == EXIT_REFUTED && r->result == EXIT_UNDECIDED);
    if (worse)
        r->result = exit_status;
}

/* What is wrong with the scheme at many valences alike is told once. */
static void tell_error(prove_run *r, const char *reason)
{
    if (strcmp(reason, r->error) != 0)
        complain(0, "%s:%s", r->options.scheme.name, reason);
    snprintf(r->error, sizeof r->error, "%s", reason);
    prove_raise_result(r, EXIT_BAD_INPUT);
}

static bool report(prove_run *r, const prove_answer *a)
{
    const decision *d = &a->decision;
    if (!is_one_valence(d->k) && valence_range_equal(d->k, r->told))
        return true; /* several valences of the list, one certificate */
    r->told = d->k;
    if (a->earlier == EARLIER_DAMAGED)
        complain(0, "%s: the certificate for valence %ld is not the one that was finished; it is made anew", r->archive.path, d->k.first);
    if (d->verdict == VERDICT_UNDECIDED && deadline_interrupted()) {
        prove_raise_result(r, EXIT_INTERRUPTED);
        return false;
    }
    if (d->outcome == OUTCOME_NO_MEMORY) {
        prove_raise_result(r, complain(EXIT_NO_MEMORY, "no memory at valence %ld; what was finished before is kept", d->k.first));
        return false;
    }
    if (d->outcome == OUTCOME_BAD_INPUT) {
        tell_error(r, decision_obstacle(d)->reason);
        return true;
    }
    (r->options.json ? prove_print_json : prove_print_line)(r->scheme.name, d, a->certificate);
    if (d->verdict != VERDICT_PROVED)
        prove_raise_result(r, d->verdict == VERDICT_REFUTED ? EXIT_REFUTED : EXIT_UNDECIDED);
    if (fflush(stdout) != 0) {
        prove_raise_result(r, EXIT_IO); /* finish_output complains */
        return false;
    }
    return true;
}

static bool is_worth_keeping(const prove_answer *a)
{
    const decision *d = &a->decision;
    return d->verdict != VERDICT_UNDECIDED || (d->outcome != OUTCOME_NO_MEMORY && d->outcome != OUTCOME_BAD_INPUT && !deadline_interrupted());
}

_Static_assert((int)KEEPER_GROUP_MAX <= (int)ARCHIVE_GROUP_MAX, "a group of the keeper is one of the archive");

/* Two certificates of one valence would do no harm, but smoothcert-check wants each valence once. */
static bool fits(prove_run *r, const decision *d)
{
    const archive_index_entry *e = NULL;
    char name[ARCHIVE_NAME_MAX], k[VALENCE_RANGE_TEXT];
    if (d->verdict == VERDICT_UNDECIDED)
        return true;
    do
        e = archive_index_next(&r->earlier, d->k, e);
    while (e && valence_range_equal(e->valences, d->k));
    if (!e)
        return true;
    archive_name(name, e->valences, ARCHIVE_CERTIFICATE);
    valence_range_print(k, d->k);
    if (d->kept_before)
        prove_raise_result(r, complain(EXIT_USAGE, "%s: %s and the certificate of %s speak of a valence twice, which smoothcert-check does not want; "
                                                   "move one of them away", r->archive.path, name, k));
    else
        prove_raise_result(r, complain(EXIT_USAGE, "%s: this run, with its method and precision, cannot use %s, and a certificate of %s beside it would speak of a "
                                                   "valence twice; name another directory with --out", r->archive.path, name, k));
    return false;
}

/* What is damaged and shares a valence with what is kept now would never be mended: the boxes are others this time.  It is
   moved only when its successor is durable. */
static bool set_damaged_aside(prove_run *r, valence_range kept)
{
    for (archive_index_entry *e; r->archive.path && (e = archive_index_damaged(&r->earlier, kept));) {
        char name[ARCHIVE_NAME_MAX], aside[ARCHIVE_ASIDE_MAX], k[VALENCE_RANGE_TEXT];
        archive_name(name, e->valences, ARCHIVE_CERTIFICATE);
        valence_range_print(k, e->valences);
        if (archive_set_aside(&r->archive, aside, e->valences) != ARCHIVE_OK) {
            prove_raise_result(r, complain(EXIT_IO, "%s: the damaged %s could not be moved aside: %s", r->archive.path, name, strerror(errno)));
            return false;
        }
        complain(0, journal_find(&r->archive.finished, name) ? "%s: the certificate for valences %s is not the one that was finished; it is now %s"
                                                             : "%s: what was there as the certificate for valences %s is none; it is now %s",
                 r->archive.path, k, aside);
        e->damaged = false;
        r->earlier.damaged--;
    }
    return true;
}

static bool set_all_damaged_aside(prove_run *r, prove_answer *const *answers, int count)
{
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = !answers[i] || !is_worth_keeping(answers[i]) || set_damaged_aside(r, answers[i]->decision.k);
    return ok;
}

/* Makes the answers durable; only then are they told. */
static bool keep_all(prove_run *r, prove_answer *const *answers, int count)
{
    archive_status kept = ARCHIVE_OK;
    long from = 0;
    for (int i = 0; kept == ARCHIVE_OK && i < count; i++) {
        if (!answers[i] || !is_worth_keeping(answers[i]))
            continue;
        if (!fits(r, &answers[i]->decision))
            return false;
        from = from ? from : answers[i]->decision.k.first;
        kept = archive_keep(&r->archive, &answers[i]->certificate, &answers[i]->decision, answers[i]->earlier);
    }
    if (kept == ARCHIVE_OK)
        kept = archive_commit(&r->archive);
    if (kept == ARCHIVE_OK)
        return set_all_damaged_aside(r, answers, count);
    prove_raise_result(r, complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: valence %ld and what follows could not be kept: %s", r->archive.path, from, strerror(errno)));
    return false;
}

static bool report_next(prove_run *r, const prove_answer *a)
{
    bool go_on = a != NULL && report(r, a);
    if (!a)
        prove_raise_result(r, complain(EXIT_NO_MEMORY, "no memory"));
    r->reported++;
    if (go_on && r->in_ranges && !classification_add(&r->classification, &a->decision)) {
        prove_raise_result(r, complain(EXIT_NO_MEMORY, "no memory"));
        go_on = false;
    }
    if (go_on && deadline_interrupted() && r->reported < r->list.count) {
        prove_raise_result(r, EXIT_INTERRUPTED);
        go_on = false;
    }
    return go_on;
}

bool prove_keep(void *const *results, int count, void *data)
{
    prove_run *r = data;
    prove_answer *const *answers = (prove_answer *const *)results;
    bool go_on;
    progress_clear(&r->progress);
    go_on = keep_all(r, answers, count);
    for (int i = 0; i < count; i++) {
        go_on = go_on && report_next(r, answers[i]);
        prove_discard(answers[i]);
    }
    progress_show(&r->progress, r->reported);
    return go_on;
}
