/* escalate.c: search, write, read back, replay; if anything is missing, more precision. */
#include "escalate.h"

#include "certificate.h"

#include <math.h>
#include <string.h>

void decision_init(decision *z)
{
    memset(z, 0, sizeof *z);
    z->verdict = VERDICT_UNDECIDED;
    findings_init(&z->findings);
    buffer_init(&z->certificate);
}

void decision_clear(decision *z)
{
    findings_clear(&z->findings);
    buffer_clear(&z->certificate);
    decision_init(z);
}

static void note_attempt(decision *z, const char *system, long precision, int max_level, outcome o, const findings *f)
{
    attempt *a;
    z->no_memory = z->no_memory || o == OUTCOME_NO_MEMORY;
    z->bad_input = z->bad_input || o == OUTCOME_BAD_INPUT;
    if (z->attempt_count == MAX_ATTEMPTS)
        return;
    a = &z->attempts[z->attempt_count++];
    *a = (attempt){system, precision, max_level, o, f->test, f->level, f->elements, f->jacobian, ""};
    memcpy(a->reason, f->reason, sizeof a->reason);
}

/* Is the certificate as text a proof, by its specification? */
static outcome replay(decision *z, const problem *p, const buffer *certificate)
{
    choices c;
    findings f;
    long line = 0;
    outcome o;
    choices_init(&c);
    findings_init(&f);
    f.test = "certificate";
    if (certificate->failed || !certificate_read(&c, &line, p->scheme, certificate->bytes, certificate->length))
        o = OUTCOME_NO_MEMORY;
    else if (line || c.valence != z->valence)
        o = findings_explain(&f, OUTCOME_FALSE, "the certificate does not read back (line %ld): this is a fault of the program", line);
    else
        o = analysis_replay_grid(&f, &c, p, c.grid);
    note_attempt(z, "grid", c.grid, 0, o, &f);
    choices_clear(&c);
    findings_clear(&f);
    return o;
}

/* One rung of the ladder: precision 0 is hardware intervals. */
static outcome try_precision(decision *z, const problem *p, const limits *l, long precision)
{
    bool hardware = precision == 0;
    long g = hardware ? CHOICES_MIN_GRID : precision;
    int max_level = l->max_level ? l->max_level : 12 + (int)(precision / 64);
    choices c;
    findings f;
    outcome o = OUTCOME_NO_MEMORY;
    choices_init(&c);
    findings_init(&f);
    if (max_level > TREE_MAX_DEPTH)
        max_level = TREE_MAX_DEPTH;
    if (choices_make(&c, z->valence, g))
        o = hardware ? analysis_search_interval(&f, &c, p, max_level, 53) : analysis_search_ball(&f, &c, p, max_level, precision);
    z->system = hardware ? "interval" : "ball";
    z->precision = hardware ? 53 : precision;
    note_attempt(z, z->system, z->precision, max_level, o, &f);
    findings_clear(&z->findings);
    z->findings = f;
    if (o == OUTCOME_TRUE) {
        certificate_write(&z->certificate, p->scheme, &c);
        o = replay(z, p, &z->certificate);
        if (o != OUTCOME_TRUE) {
            buffer_clear(&z->certificate);
            findings_explain(&z->findings, o, "found at this precision, but the certificate does not prove it on its grid");
            o = o == OUTCOME_NO_MEMORY ? o : OUTCOME_FAIL;
        }
    }
    choices_clear(&c);
    return o;
}

void decide_valence(decision *z, const problem *p, long valence, const limits *l)
{
    long precision = l->precision ? l->precision : l->no_intervals ? LIMITS_MIN_PRECISION : 0;
    z->valence = valence;
    if (p->obstacle) {
        z->findings.test = "regular complex";
        findings_explain(&z->findings, OUTCOME_UNDEFINED, "%s", p->obstacle);
        note_attempt(z, "exact", 0, 0, OUTCOME_UNDEFINED, &z->findings);
        return;
    }
    for (;;) {
        outcome o = try_precision(z, p, l, precision);
        if (o == OUTCOME_TRUE)
            z->verdict = VERDICT_PROVED;
        if (o == OUTCOME_TRUE || o == OUTCOME_FALSE || z->no_memory || z->bad_input || l->precision)
            return;
        precision = precision ? 2 * precision : LIMITS_MIN_PRECISION;
        if (precision > l->max_precision)
            return;
    }
}
