/* escalate.c: search, write, read back, replay; if anything is missing, more precision. */
#include "escalate.h"

#include "certificate.h"
#include "refute.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A box of valences that needs so many elements beside those of the ring is better cut in two: its trees are deep where wide numbers are
   hardly decided. */
#define RANGE_MAX_ELEMENTS 2000

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

const attempt *decision_obstacle(const decision *z)
{
    return &z->findings.attempts[z->obstacle];
}

/* What a certificate that proves its claim says. */
static void take_over(decision *z, const choices *c)
{
    z->verdict = c->claim == CLAIM_C1 ? VERDICT_PROVED : VERDICT_REFUTED;
    z->claim = c->claim;
    z->frequency = c->frequency;
    z->plainly_regular = c->plainly_regular;
}

/* Is the certificate as text a proof, by its specification? */
static outcome replay(decision *z, const analysis_plan *p, const buffer *certificate)
{
    analysis_plan plan = {.problem = p->problem, .deadline = p->deadline, .system = "grid"};
    choices c;
    long line = 0;
    outcome o;
    choices_init(&c);
    if (certificate->failed || !certificate_read(&c, &line, p->problem->scheme, certificate->bytes, certificate->length))
        o = OUTCOME_NO_MEMORY;
    else if (line || c.k.first != z->k.first || c.k.last != z->k.last) {
        findings_begin(&z->findings, "certificate", "grid", c.grid);
        o = findings_explain(&z->findings, OUTCOME_FALSE, "the certificate does not read back (line %ld): this is a fault of the program", line);
        findings_last(&z->findings)->outcome = o;
    } else
        o = analysis_replay(&z->findings, &c, &plan);
    if (o == OUTCOME_TRUE)
        take_over(z, &c);
    choices_clear(&c);
    return o;
}

/* Writes the certificate of choices that were found, and follows it. */
static outcome certify(decision *z, const choices *c, const analysis_plan *plan)
{
    outcome o;
    certificate_write(&z->certificate, plan->problem->scheme, c);
    o = replay(z, plan, &z->certificate);
    if (o == OUTCOME_TRUE)
        return o;
    buffer_clear(&z->certificate);
    return o == OUTCOME_FALSE || o == OUTCOME_UNDEFINED ? OUTCOME_FAIL : o;
}

static outcome try_to_prove(decision *z, choices *c, analysis_plan *plan, long precision)
{
    outcome o = analysis_search(&z->findings, c, plan, precision);
    if (o == OUTCOME_TRUE) {
        o = certify(z, c, plan);
        if (o != OUTCOME_TRUE) {
            for (int i = 0; i < TESTS; i++) /* everything inexact anew, with more precision */
                plan->found[i] = plan->found[i] && i == TEST_REGULAR_COMPLEX;
            z->findings.level = 0;
            z->findings.elements = 0;
        }
    }
    z->obstacle = z->findings.attempt_count ? z->findings.attempt_count - 1 : 0;
    return o;
}

/* The figures are those of the refutation if it succeeds, and else remain.  s: of one valence; r: of several. */
static outcome try_to_refute(decision *z, suspicion *s, range_reason r, const analysis_plan *plan, long precision)
{
    findings before = z->findings;
    choices c;
    outcome o;
    choices_init(&c);
    z->findings.eigenvalue = NULL;
    o = s ? refute(&z->findings, &c, s, plan, z->k.first, precision) : refute_range(&z->findings, &c, plan, z->k, r, precision);
    if (o == OUTCOME_TRUE) {
        if (s)
            refute_describe(z->reason, sizeof z->reason, &c, &z->findings, s);
        else
            refute_range_describe(z->reason, sizeof z->reason, &c, &z->findings);
        o = certify(z, &c, plan);
    }
    if (o == OUTCOME_TRUE) {
        free(before.eigenvalue);
    } else {
        free(z->findings.eigenvalue);
        memcpy(before.attempts, z->findings.attempts, sizeof before.attempts);
        before.attempt_count = z->findings.attempt_count;
        z->findings = before;
    }
    choices_clear(&c);
    return o;
}

/* One rung of the ladder: precision 0 is hardware intervals. */
static void set_rung(decision *z, analysis_plan *plan, const limits *l, long precision)
{
    bool hardware = precision == 0;
    z->system = plan->system = hardware ? "interval" : "ball";
    z->precision = hardware ? 53 : precision;
    plan->max_level = l->max_level ? l->max_level : 12 + (int)(precision / 64);
    if (plan->max_level > TREE_MAX_DEPTH)
        plan->max_level = TREE_MAX_DEPTH;
}

/* OUTCOME_TRUE: there is a verdict. */
static outcome try_precision(decision *z, choices *c, analysis_plan *plan, suspicion *s, const limits *l, long precision)
{
    outcome o, refuted;
    set_rung(z, plan, l, precision);
    o = try_to_prove(z, c, plan, precision);
    if (o == OUTCOME_TRUE || o == OUTCOME_STOPPED || o == OUTCOME_NO_MEMORY || o == OUTCOME_BAD_INPUT || !plan->found[TEST_REGULAR_COMPLEX])
        return o;
    s->folds = plan->found[TEST_SPECTRUM] && !plan->found[TEST_REGULARITY];
    s->winds = plan->found[TEST_SPECTRUM] ? !plan->found[TEST_INJECTIVITY] : !plan->found[TEST_EIGENPAIR]; /* L < 0 is none for C1 */
    refuted = try_to_refute(z, s, range_reason_after(CLAIM_C1, 0), plan, precision);
    return refuted == OUTCOME_FAIL ? o : refuted;
}

/* Has the uniform method run out of levels, where more precision does not help? */
static bool is_uniform_open(const analysis_plan *plan)
{
    return plan->uniform && plan->found[TEST_SPECTRUM] && !plan->found[TEST_UNIFORM];
}

/* What looks like the opposite at so many precisions in a row, and is not refuted, will hardly be decided by more. */
enum { MOST_CONTRARY = 4 };

static outcome climb(decision *z, choices *c, analysis_plan *plan, suspicion *s, const limits *l)
{
    long precision = l->precision ? l->precision : l->no_intervals ? LIMITS_MIN_PRECISION : 0;
    int contrary = 0;
    for (;;) {
        outcome o = try_precision(z, c, plan, s, l, precision);
        contrary = o == OUTCOME_FALSE ? contrary + 1 : 0;
        if (o == OUTCOME_UNDEFINED && is_uniform_open(plan))
            return o;
        if ((o != OUTCOME_UNDEFINED && o != OUTCOME_FAIL && o != OUTCOME_FALSE) || contrary == MOST_CONTRARY || l->precision || plan->problem->obstacle || !plan->found[TEST_REGULAR_COMPLEX])
            return o;
        if (deadline_passed(plan->deadline))
            return OUTCOME_STOPPED;
        precision = precision ? 2 * precision : LIMITS_MIN_PRECISION;
        if (precision > l->max_precision)
            return o;
    }
}

static outcome escalate(decision *z, choices *c, analysis_plan *plan, const limits *l)
{
    suspicion s = {.made = false};
    outcome o = climb(z, c, plan, &s, l);
    if ((o == OUTCOME_FAIL || o == OUTCOME_FALSE) && !plan->found[TEST_SPECTRUM])
        refute_note_gap(&z->findings.attempts[z->obstacle], &s, plan, z->k.first, strcmp(z->system, "ball") ? 0 : z->precision);
    return o;
}

/* OUTCOME_NO_MEMORY is not told from "no": then it is proved anew. */
bool decide_by_certificate(decision *z, const problem *p, valence_range k, const buffer *certificate, const limits *l)
{
    double start = deadline_now();
    analysis_plan plan = {.problem = p, .deadline = &l->deadline};
    stop_sign before;
    bool proved;
    z->k = k;
    if (l->precision || l->uniform || !certificate || !certificate->length)
        return false;
    before = stop_watch(deadline_sign(&l->deadline));
    proved = replay(z, &plan, certificate) == OUTCOME_TRUE;
    stop_watch(before);
    if (!proved) {
        findings_clear(&z->findings);
        return false;
    }
    buffer_append(&z->certificate, certificate->bytes, certificate->length);
    z->kept_before = true;
    z->outcome = OUTCOME_TRUE;
    z->seconds = deadline_now() - start;
    return true;
}

void decide_valence(decision *z, const problem *p, long valence, const buffer *earlier, const limits *l)
{
    double start = deadline_now();
    analysis_plan plan = {.problem = p, .deadline = &l->deadline, .uniform = l->uniform};
    stop_sign before;
    choices c;
    if (decide_by_certificate(z, p, one_valence(valence), earlier, l))
        return;
    before = stop_watch(deadline_sign(&l->deadline));
    choices_init(&c);
    c.k = z->k;
    z->outcome = escalate(z, &c, &plan, l);
    choices_clear(&c);
    stop_watch(before);
    z->seconds = deadline_now() - start;
}

void decide_range(decision *z, const problem *p, valence_range k, range_reason r, const limits *l)
{
    double start = deadline_now();
    analysis_plan plan = {.problem = p, .deadline = &l->deadline, .max_elements = p->geometry.element_count + RANGE_MAX_ELEMENTS, .uniform = l->uniform};
    long precision = l->precision ? l->precision : l->no_intervals ? LIMITS_MIN_PRECISION : 0;
    stop_sign before;
    choices c;
    choices_init(&c);
    c.k = z->k = k;
    set_rung(z, &plan, l, precision);
    before = stop_watch(deadline_sign(&l->deadline));
    z->outcome = range_reason_is_one(r) ? try_to_refute(z, NULL, r, &plan, precision) : try_to_prove(z, &c, &plan, precision);
    z->obstacle = z->findings.attempt_count ? z->findings.attempt_count - 1 : 0;
    choices_clear(&c);
    stop_watch(before);
    z->seconds = deadline_now() - start;
}
