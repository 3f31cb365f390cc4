/* zero_free_test.c: where an eigenfunction is not 0 (verify/certificate.md, section 10): on all of the outer curve, which
   rotation maps to itself, or somewhere on it.  Compiled once per number system. */
#include "tests.h"

/* z += max(|x|, |y|), the coordinates of F: positive if and only if one of them has a sign, however small. */
static void greatest_coordinate(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    number p, q;
    (void)data;
    number_init(&p);
    number_init(&q);
    number_abs(&p, x[0]);
    number_abs(&q, y[0]);
    number_max(&p, &p, &q, prec);
    number_add(z, z, &p, prec);
    number_clear(&p);
    number_clear(&q);
}

static adaptive_task make_task(void)
{
    return (adaptive_task){.nets = 1, .which = {RING_VALUES}, .quantity = greatest_coordinate, .boxes_only = true};
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

outcome test_nonzero(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = make_task();
    outcome o = analysis_seek(a, &task, &a->choices->witness[0], g->boundary, g->boundary_count);
    if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to be other than 0 anywhere on the outer curve", a->choices->frequency);
    return o;
}
