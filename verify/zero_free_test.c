/* zero_free_test.c: where an eigenfunction is not 0 (verify/certificate.md, section 10): on all of the outer curve, which
   rotation maps to itself, or somewhere on it.  Compiled once per number system. */
#include "tests.h"

/* z += |F|^2, in the coordinates (x, y): positive if one of them has a sign. */
static void square_of_modulus(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    number p;
    (void)data;
    number_init(&p);
    number_sqr(&p, x[0], prec);
    number_add(z, z, &p, prec);
    number_sqr(&p, y[0], prec);
    number_add(z, z, &p, prec);
    number_clear(&p);
}

static adaptive_task make_task(void)
{
    return (adaptive_task){.nets = 1, .which = {RING_VALUES}, .quantity = square_of_modulus, .boxes_only = true};
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
