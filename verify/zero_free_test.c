/* zero_free_test.c: where an eigenfunction is not 0 (verify/certificate.md, section 10): on all of the outer curve, which
   rotation maps to itself, or somewhere on it.  Compiled once per number system. */
#include "tests.h"

/* The first of the half-planes x > 0, y > 0, x < 0, y < 0, numbered from 0, that certainly holds (x, y); -1: none does. */
static int direction_of(const number *x, const number *y)
{
    if (number_is_positive(x) == TRUTH_TRUE)
        return 0;
    if (number_is_positive(y) == TRUTH_TRUE)
        return 1;
    if (number_is_negative(x) == TRUTH_TRUE)
        return 2;
    return number_is_negative(y) == TRUTH_TRUE ? 3 : -1;
}

/* z = the distance from the line that bounds that half-plane, of which no rounding makes 0, or something that contains 0: F is
   not 0 if it is positive.  data: a buffer that takes the direction, or NULL. */
static void distance(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    buffer *directions = (buffer *)(uintptr_t)data;
    int d = direction_of(x[0], y[0]);
    const number *coordinate = d % 2 ? y[0] : x[0];
    (void)prec;
    if (d > 1)
        number_neg(z, coordinate);
    else
        number_set(z, d < 0 ? x[0] : coordinate);
    if (directions && d >= 0)
        buffer_append(directions, &"0123"[d], 1);
}

static adaptive_task make_task(const buffer *directions)
{
    return (adaptive_task){.nets = 1, .which = {RING_VALUES}, .quantity = distance, .data = directions, .boxes_only = true};
}

outcome analysis_follow_curve(analysis *a, buffer *directions)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = make_task(directions);
    outcome o = analysis_subdivide(a, &task, &a->choices->boundary, g->boundary, g->boundary_count);
    if (o == OUTCOME_UNDEFINED || o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to have no zero on the outer curve", a->choices->frequency);
    return o;
}

outcome test_zero_free(analysis *a)
{
    return analysis_follow_curve(a, NULL);
}

outcome analysis_seek_nonzero(analysis *a, witness_choice *witness)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = make_task(NULL);
    outcome o = analysis_seek(a, &task, witness, g->boundary, g->boundary_count);
    if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to be other than 0 anywhere on the outer curve", a->choices->frequency);
    return o;
}

outcome test_nonzero(analysis *a)
{
    return analysis_seek_nonzero(a, &a->choices->witness[0]);
}
