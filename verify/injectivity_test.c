/* injectivity_test.c: the outer curve avoids 0 and winds once round it (verify/certificate.md, section 8).

   One sector's piece of the curve in an open half-plane does both: see "Why this is condition 4 and 5" there. */
#include "tests.h"

#include <math.h>

#define NORMAL_SCALE 0x1p20

/* data: the normal, two longs.  Is normal * F > 0 on the box? */
static outcome lies_in_half_plane(double *margin, const adaptive_box *box, const void *data, long prec)
{
    const long *normal = data;
    outcome o;
    number s, p;
    number_init(&s);
    number_init(&p);
    number_mul_si(&s, &box[0].x, normal[0], prec);
    number_mul_si(&p, &box[0].y, normal[1], prec);
    number_add(&s, &s, &p, prec);
    o = adaptive_sign(margin, &s);
    number_clear(&s);
    number_clear(&p);
    return o;
}

/* The bisector of the directions in which the sector's two spokes are mapped. */
static void choose_normal(long normal[2], const sector_net *net, int at)
{
    double sign = number_mid_approx(&net->x[sector_index(net, at, 0)]) < 0 ? -1 : 1;
    double c = number_mid_approx(&net->twist->forth.xx), v = number_mid_approx(&net->twist->forth.yx), length = hypot(c, v);
    normal[0] = (long)(sign * NORMAL_SCALE * (1 + c / length));
    normal[1] = (long)(sign * NORMAL_SCALE * (v / length));
}

outcome test_injectivity(analysis *a)
{
    const ring *g = &a->problem->geometry;
    charnet_windows values;
    adaptive_report report;
    outcome o;
    block_status s;
    a->findings->test = "injectivity";
    if (!a->replay)
        choose_normal(a->choices->normal, &a->net, 2 * g->radius);
    s = charnet_windows_make(&values, &a->net, g, RING_VALUES, g->boundary, g->boundary_count, a->prec);
    if (s == BLOCK_OK) {
        adaptive_task task = {g, g->boundary, g->boundary_count, 1, {RING_VALUES, 0}, {&values, NULL}, {&a->mask[RING_VALUES], NULL},
                              lies_in_half_plane, a->choices->normal, a->replay, a->max_level};
        o = adaptive_run(&report, &a->choices->boundary, &task, a->prec);
        a->findings->elements += report.examined;
        a->findings->level = report.level > a->findings->level ? report.level : a->findings->level;
    } else {
        o = s == BLOCK_OPPOSITE ? OUTCOME_FALSE : OUTCOME_NO_MEMORY;
    }
    if (o == OUTCOME_UNDEFINED || o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "one sector of the outer curve could not be shown to lie in a half-plane seen from 0");
    charnet_windows_free(&values);
    return o;
}
