/* fold_test.c: the characteristic map keeps its orientation here and turns it over there (verify/certificate.md, section
   10).  Compiled once per number system. */
#include "tests.h"

void analysis_signed_jacobian(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    const long *sign = data;
    number j;
    number_init(&j);
    number_mul(&j, x[0], y[1], prec);
    number_submul(&j, y[0], x[1], prec);
    if (*sign > 0)
        number_add(z, z, &j, prec);
    else
        number_sub(z, z, &j, prec);
    number_clear(&j);
}

outcome test_fold(analysis *a)
{
    static const long signs[] = {1, -1};
    const ring *g = &a->plan->problem->geometry;
    outcome o = OUTCOME_TRUE;
    for (int i = 0; o == OUTCOME_TRUE && i < 2; i++) {
        adaptive_task task = {.nets = 2, .which = {RING_FIRST, RING_SECOND}, .quantity = analysis_signed_jacobian, .data = &signs[i], .boxes_only = true};
        o = analysis_seek(a, &task, &a->choices->witness[i], g->elements, g->element_count);
    }
    if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the Jacobian could not be shown to have both signs on the ring");
    return o;
}
