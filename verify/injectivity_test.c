/* injectivity_test.c: the outer curve avoids 0 and winds once round it (verify/certificate.md, section 8).

   One sector's piece of the curve in an open half-plane does both: see "Why this is condition 4 and 5" there. */
#include "tests.h"

#include <math.h>

#define NORMAL_SCALE 0x1p20

/* data: the normal, two longs.  z += normal * F: positive in the half-plane. */
static void height(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    const long *normal = data;
    number p;
    number_init(&p);
    number_mul_si(&p, x[0], normal[0], prec);
    number_add(z, z, &p, prec);
    number_mul_si(&p, y[0], normal[1], prec);
    number_add(z, z, &p, prec);
    number_clear(&p);
}

/* The bisector of the directions of the two ends of the curve, V(2r,0) and t V(2r,0). */
static bool choose_normal(long normal[2], const sector_net *net, int at, long prec)
{
    double x, y, p, q, length;
    number s, t;
    number_init(&s);
    number_init(&t);
    sector_value(&s, &t, net, at, 0, prec);
    x = number_mid_approx(&s);
    y = number_mid_approx(&t);
    if (net->twist)
        twist_apply(&s, &t, net->twist, 1, prec);
    p = number_mid_approx(&s);
    q = number_mid_approx(&t);
    number_clear(&s);
    number_clear(&t);
    length = hypot(x, y);
    x /= length;
    y /= length;
    length = hypot(p, q);
    p = x + p / length;
    q = y + q / length;
    length = hypot(p, q);
    if (!(length > 0x1p-20))
        return false;
    normal[0] = (long)(NORMAL_SCALE * p / length);
    normal[1] = (long)(NORMAL_SCALE * q / length);
    return true;
}

outcome test_injectivity(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = {.nets = 1, .which = {RING_VALUES}, .quantity = height, .data = a->choices->normal};
    outcome o = analysis_make_net(a);
    if (o == OUTCOME_TRUE && !a->replay && !choose_normal(a->choices->normal, &a->net, 2 * g->radius, a->prec))
        o = findings_explain(a->findings, OUTCOME_FAIL, "the ends of one sector of the outer curve could not be told from 0");
    if (o == OUTCOME_TRUE)
        o = analysis_subdivide(a, &task, &a->choices->boundary, g->boundary, g->boundary_count);
    if (o == OUTCOME_UNDEFINED || o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "one sector of the outer curve could not be shown to lie in a half-plane seen from 0");
    return o;
}
