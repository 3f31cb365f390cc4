/* regularity_test.c: the Jacobian of the characteristic map on the ring (verify/certificate.md, section 8). */
#include "tests.h"

void adaptive_jacobian(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    (void)data;
    number_addmul(z, x[0], y[1], prec);
    number_submul(z, y[0], x[1], prec);
}

outcome test_regularity(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = {.nets = 2, .which = {RING_FIRST, RING_SECOND}, .quantity = adaptive_jacobian};
    outcome o = analysis_subdivide(a, &task, &a->choices->regularity, g->elements, g->element_count);
    a->findings->jacobian = findings_last(a->findings)->bound;
    if (o == OUTCOME_UNDEFINED)
        findings_explain(a->findings, o, "the sign of the Jacobian is still open on some element after %d subdivisions", a->plan->max_level);
    else if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the Jacobian is not positive everywhere on the ring: the characteristic map seems to fold");
    return o;
}
