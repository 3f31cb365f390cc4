/* zero_free_test.c: where an eigenfunction is not 0 (verify/certificate.md, section 10): on all of the outer curve, which
   rotation maps to itself, or somewhere on it.  Compiled once per number system. */
#include "tests.h"

static bool has_sign(const number *x)
{
    return number_is_positive(x) == TRUTH_TRUE || number_is_negative(x) == TRUTH_TRUE;
}

/* z += |x| if that has a sign, however small, else |y| if that has one, else something that contains 0: F is not 0 if
   the sum is positive.  (Squares would be rounded to 0 on the grid.) */
static void coordinate_with_sign(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    const number *coordinate = has_sign(x[0]) ? x[0] : y[0];
    (void)data;
    if (number_is_negative(coordinate) == TRUTH_TRUE)
        number_sub(z, z, coordinate, prec);
    else
        number_add(z, z, coordinate, prec);
    if (!has_sign(coordinate))
        number_add(z, z, x[0], prec);
}

static adaptive_task make_task(void)
{
    return (adaptive_task){.nets = 1, .which = {RING_VALUES}, .quantity = coordinate_with_sign, .boxes_only = true};
}

outcome test_zero_free(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = make_task();
    outcome o = analysis_subdivide(a, &task, &a->choices->boundary, g->boundary, g->boundary_count);
    if (o == OUTCOME_UNDEFINED || o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to have no zero on the outer curve", a->choices->frequency);
    return o;
}

outcome analysis_seek_nonzero(analysis *a, witness_choice *witness)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = make_task();
    outcome o = analysis_seek(a, &task, witness, g->boundary, g->boundary_count);
    if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to be other than 0 anywhere on the outer curve", a->choices->frequency);
    return o;
}

outcome test_nonzero(analysis *a)
{
    return analysis_seek_nonzero(a, &a->choices->witness[0]);
}
