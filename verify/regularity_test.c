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
    const ring *g = &a->problem->geometry;
    charnet_windows first, second;
    adaptive_report report;
    outcome o;
    block_status s, t;
    a->findings->test = "regularity";
    s = charnet_windows_make(&first, &a->net, g, RING_FIRST, g->elements, g->element_count, a->prec);
    t = charnet_windows_make(&second, &a->net, g, RING_SECOND, g->elements, g->element_count, a->prec);
    if (s == BLOCK_OK && t == BLOCK_OK) {
        adaptive_task task = {g, g->elements, g->element_count, 2, {RING_FIRST, RING_SECOND}, {&first, &second},
                              {&a->mask[RING_FIRST], &a->mask[RING_SECOND]}, jacobian_is_positive, NULL, a->replay, a->max_level};
        o = adaptive_run(&report, &a->choices->regularity, &task, a->prec);
        a->findings->jacobian = report.margin;
        a->findings->elements += report.examined;
        a->findings->level = report.level > a->findings->level ? report.level : a->findings->level;
    } else {
        o = s == BLOCK_OPPOSITE || t == BLOCK_OPPOSITE ? OUTCOME_FALSE : OUTCOME_NO_MEMORY;
    }
    if (o == OUTCOME_UNDEFINED)
        findings_explain(a->findings, o, "the sign of the Jacobian is still open on some element after %d subdivisions", a->max_level);
    else if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the Jacobian is not positive everywhere on the ring: the characteristic map seems to fold");
    charnet_windows_free(&first);
    charnet_windows_free(&second);
    return o;
}
