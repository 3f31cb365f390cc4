/* regularity_test.c: the Jacobian of the characteristic map on the ring (verify/certificate.md, section 8). */
#include "tests.h"

/* J = x1 y2 - y1 x2 for all derivatives (x1, y1), (x2, y2) in the two boxes. */
static outcome jacobian_is_positive(double *margin, const adaptive_box *box, const void *data, long prec)
{
    outcome o;
    number j;
    (void)data;
    number_init(&j);
    number_mul(&j, &box[0].x, &box[1].y, prec);
    number_submul(&j, &box[0].y, &box[1].x, prec);
    o = adaptive_sign(margin, &j);
    number_clear(&j);
    return o;
}

outcome test_regularity(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = {.nets = 2, .which = {RING_FIRST, RING_SECOND}, .decide = jacobian_is_positive};
    outcome o = analysis_subdivide(a, &task, &a->choices->regularity, g->elements, g->element_count);
    a->findings->jacobian = findings_last(a->findings)->bound;
    if (o == OUTCOME_UNDEFINED)
        findings_explain(a->findings, o, "the sign of the Jacobian is still open on some element after %d subdivisions", a->plan->max_level);
    else if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the Jacobian is not positive everywhere on the ring: the characteristic map seems to fold");
    return o;
}
