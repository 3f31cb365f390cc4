/* zero_free_test.c: where an eigenfunction is not 0 (verify/certificate.md, section 10): on all of the outer curve, which
   rotation maps to itself, or somewhere on it.  Compiled once per number system. */
#include "tests.h"

static bool has_sign(const number *x)
{
    return number_is_positive(x) == TRUTH_TRUE || number_is_negative(x) == TRUTH_TRUE;
}

/* The first of the half-planes x > 0, y > 0, x < 0, y < 0 that certainly holds (x, y), as a digit from 0; one does. */
static const char *direction_of(const number *x, const number *y)
{
    if (number_is_positive(x) == TRUTH_TRUE)
        return "0";
    if (number_is_positive(y) == TRUTH_TRUE)
        return "1";
    return number_is_negative(x) == TRUTH_TRUE ? "2" : "3";
}

/* z = |x| if that has a sign, however small, else |y| if that has one, else something that contains 0: F is not 0 if it is
   positive.  (Squares would be rounded to 0 on the grid.)  data: a buffer that takes the direction, or NULL. */
static void coordinate_with_sign(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    buffer *directions = (buffer *)(uintptr_t)data;
    const number *coordinate = has_sign(x[0]) ? x[0] : y[0];
    if (number_is_negative(coordinate) == TRUTH_TRUE)
        number_neg(z, coordinate);
    else
        number_set(z, coordinate);
    if (!has_sign(coordinate))
        number_add(z, z, x[0], prec);
    else if (directions)
        buffer_append(directions, direction_of(x[0], y[0]), 1);
}

static adaptive_task make_task(const buffer *directions)
{
    return (adaptive_task){.nets = 1, .which = {RING_VALUES}, .quantity = coordinate_with_sign, .data = directions, .boxes_only = true};
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
