/* analysis.c: the tests one after the other.  Compiled once per number system. */
#include "tests.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of L on a line for people; `spectrum` prints as many as one asks for. */
#define MOST_DIGITS 40

#define run_analysis NUMBER_NAME(run_analysis)
outcome run_analysis(findings *f, choices *c, const problem *p, bool replay, int max_level, long prec);

/* The frequency was last set to that of the last block: it has to be 1 again. */
outcome test_characteristic_net(analysis *a)
{
    const problem *p = a->problem;
    diagnostic d;
    a->findings->test = "characteristic net";
    if (scheme_numbers_set_frequency(&a->numbers, 1, &a->dominant.twist, &d) != STATUS_OK)
        return OUTCOME_NO_MEMORY;
    switch (charnet_make(&a->net, &a->dominant, a->box, &a->numbers, p->geometry.rings)) {
    case BLOCK_OK:
        return OUTCOME_TRUE;
    case BLOCK_NO_MEMORY:
        return OUTCOME_NO_MEMORY;
    default:
        return findings_explain(a->findings, OUTCOME_FALSE, "a rule reaches behind the extraordinary vertex, where its sheet is ambiguous");
    }
}

/* What the scheme's formulas are worth at this valence. */
static outcome evaluate_scheme(analysis *a)
{
    diagnostic d;
    switch (scheme_numbers_make(&a->numbers, a->problem->scheme, a->choices->valence, a->prec, &d)) {
    case STATUS_OK:
        return OUTCOME_TRUE;
    case STATUS_BAD_INPUT:
        a->findings->test = "scheme";
        return findings_explain(a->findings, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d.line, d.column, d.text);
    default:
        return OUTCOME_NO_MEMORY;
    }
}

static outcome run_tests(analysis *a)
{
    static outcome (*const tests[])(analysis *) = {test_spectrum, test_characteristic_net, test_regularity, test_injectivity};
    outcome o = OUTCOME_TRUE;
    for (int i = 0; i < 3; i++) /* the regular part is exact: problem.c has tested it for all valences */
        if (!a->replay)
            a->choices->contraction[i] = a->problem->contraction[i];
        else if (a->choices->contraction[i] != a->problem->contraction[i])
            return findings_explain(a->findings, OUTCOME_FALSE, "the powers of the regular part are not the least ones");
    for (int i = 0; i < RING_NETS; i++)
        if (!mask_numbers_make(&a->mask[i], a->problem->geometry.mask[i], a->prec))
            return OUTCOME_NO_MEMORY;
    o = evaluate_scheme(a);
    for (size_t i = 0; o == OUTCOME_TRUE && i < sizeof tests / sizeof *tests; i++)
        o = tests[i](a);
    return o;
}

outcome run_analysis(findings *f, choices *c, const problem *p, bool replay, int max_level, long prec)
{
    analysis a;
    outcome o;
    memset(&a, 0, sizeof a);
    a.problem = p;
    a.choices = c;
    a.findings = f;
    a.replay = replay;
    a.max_level = max_level;
    a.prec = prec;
    o = run_tests(&a);
    if (o == OUTCOME_TRUE) {
        f->eigenvalue = number_get_decimal(&a.box[a.dominant.n], prec < 128 ? 16 : MOST_DIGITS);
        if (!f->eigenvalue)
            o = OUTCOME_NO_MEMORY;
    }
    for (int i = 0; i < RING_NETS; i++)
        if (a.mask[i].mask)
            mask_numbers_free(&a.mask[i]);
    if (a.box)
        number_array_free(a.box, (size_t)a.dominant.n + 1);
    sector_net_free(&a.net);
    scheme_numbers_free(&a.numbers);
    block_free(&a.dominant);
    return o;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
static outcome in_region(findings *f, choices *c, const problem *p, bool replay, int max_level, long prec)
{
    number_mode mode = number_enter();
    outcome o = run_analysis(f, c, p, replay, max_level, prec);
    number_leave(mode);
    return o;
}

outcome NUMBER_NAME(analysis_search)(findings *f, choices *c, const problem *p, int max_level, long prec)
{
    return in_region(f, c, p, false, max_level, prec);
}

outcome NUMBER_NAME(analysis_replay)(findings *f, choices *c, const problem *p, long prec)
{
    return in_region(f, c, p, true, TREE_MAX_DEPTH, prec);
}
