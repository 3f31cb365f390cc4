/* uniform_injectivity_test.c: the winding number of the outer curve by its length on the unit square ([Z] 5.7,
   ComputeProj and TestInjective, on one sector: verify/uniform.md, 7).  Compiled once per number system.

   The sides of the square are x = 1, y = 1, x = -1, y = -1, in this order; counter-clockwise lengths are positive. */
#include "uniform.h"

#include <math.h>

enum { RIGHT = 1, TOP = 2, LEFT = 4, BOTTOM = 8 };

/* A value projected on the square from 0, and the sides on which it may be. */
typedef struct {
    number x, y;
    int sides;
} projection;

static void projection_init(projection *z)
{
    number_init(&z->x);
    number_init(&z->y);
    z->sides = 0;
}

static void projection_clear(projection *z)
{
    number_clear(&z->x);
    number_clear(&z->y);
}

/* May x be 1, or -1? */
static bool may_be(const number *x, long value, long prec)
{
    bool may;
    number t;
    number_init(&t);
    number_set_si(&t, value, prec);
    number_sub(&t, x, &t, prec);
    may = number_contains_zero(&t);
    number_clear(&t);
    return may;
}

static void project(projection *z, const number *x, const number *y, long prec)
{
    number s, t;
    number_init(&s);
    number_init(&t);
    number_abs(&s, x);
    number_abs(&t, y);
    number_max(&s, &s, &t, prec);
    number_div(&z->x, x, &s, prec);
    number_div(&z->y, y, &s, prec);
    number_clear(&s);
    number_clear(&t);
    z->sides = (may_be(&z->x, 1, prec) ? RIGHT : 0) | (may_be(&z->y, 1, prec) ? TOP : 0) | (may_be(&z->x, -1, prec) ? LEFT : 0)
               | (may_be(&z->y, -1, prec) ? BOTTOM : 0);
}

/* On these sides (one, or two that meet) the place, counted counter-clockwise from anywhere, is s_x x + s_y y: the factors are
   0, 1, -1.  false: other sides. */
static bool find_place(int *s_x, int *s_y, int sides)
{
    switch (sides) {
    case RIGHT: *s_x = 0, *s_y = 1; return true;
    case TOP: *s_x = -1, *s_y = 0; return true;
    case LEFT: *s_x = 0, *s_y = -1; return true;
    case BOTTOM: *s_x = 1, *s_y = 0; return true;
    case RIGHT | TOP: *s_x = -1, *s_y = 1; return true;
    case TOP | LEFT: *s_x = -1, *s_y = -1; return true;
    case LEFT | BOTTOM: *s_x = 1, *s_y = -1; return true;
    case BOTTOM | RIGHT: *s_x = 1, *s_y = 1; return true;
    default: return false;
    }
}

static void add_signed(number *z, int sign, const number *x, long prec)
{
    if (sign > 0)
        number_add(z, z, x, prec);
    else if (sign < 0)
        number_sub(z, z, x, prec);
}

/* length += the way from p to q.  OUTCOME_FAIL: the sides of a point are not known well enough; OUTCOME_UNDEFINED: those
   of the segment. */
static outcome add_way(number *length, const projection *p, const projection *q, long prec)
{
    int s_x, s_y;
    if (!find_place(&s_x, &s_y, p->sides) || !find_place(&s_x, &s_y, q->sides))
        return OUTCOME_FAIL;
    if (!find_place(&s_x, &s_y, p->sides | q->sides))
        return OUTCOME_UNDEFINED;
    add_signed(length, s_x, &q->x, prec);
    add_signed(length, -s_x, &p->x, prec);
    add_signed(length, s_y, &q->y, prec);
    add_signed(length, -s_y, &p->y, prec);
    return OUTCOME_TRUE;
}

/* The length of the polygon of one sector, from (R,0) to (0,R).  The limit's curve turns as it does if no segment comes within
   `error` of 0: else OUTCOME_UNDEFINED. */
static outcome find_length(number *length, const uniform_net *z, int outer, long prec)
{
    outcome o = OUTCOME_TRUE;
    projection p, q;
    projection_init(&p);
    projection_init(&q);
    for (int b = 0; o == OUTCOME_TRUE && b <= outer; b++) {
        int ends[2] = {uniform_net_index(z, outer - b, b), b > 0 ? uniform_net_index(z, outer - b + 1, b - 1) : 0};
        projection next = q;
        q = p;
        p = next;
        project(&p, &z->value[0][ends[0]], &z->value[1][ends[0]], prec);
        if (b > 0)
            o = uniform_avoids_zero(z, ends, 2, prec) ? add_way(length, &q, &p, prec) : OUTCOME_UNDEFINED;
    }
    projection_clear(&p);
    projection_clear(&q);
    return o;
}

/* Winding 1: 0 < length < 8. */
static outcome judge(analysis *a, const number *length)
{
    outcome o;
    number eight;
    number_init(&eight);
    number_set_si(&eight, 8, a->prec);
    findings_last(a->findings)->bound = number_lower_bound(length);
    if (number_lacks_memory(length))
        o = OUTCOME_NO_MEMORY;
    else if (number_is_positive(length) == TRUTH_TRUE && number_less(length, &eight) == TRUTH_TRUE)
        o = OUTCOME_TRUE;
    else if (number_is_negative(length) == TRUTH_TRUE || number_less(&eight, length) == TRUTH_TRUE)
        o = findings_explain(a->findings, OUTCOME_FALSE, "the outer curve does not wind once round 0: on the unit square one sector of it has the length %.3g",
                             number_mid_approx(length));
    else
        o = findings_explain(a->findings, OUTCOME_FAIL, "the length of the outer curve on the unit square is not known well enough");
    number_clear(&eight);
    return o;
}

outcome test_uniform_injectivity(analysis *a)
{
    const uniform_net *z = &a->uniform[RING_VALUES];
    outcome o;
    number length;
    number_init(&length);
    findings_last(a->findings)->error = uniform_largest_error(a, RING_VALUES, RING_VALUES);
    o = find_length(&length, z, 2 * a->plan->problem->geometry.radius << z->level, a->prec);
    if (o == OUTCOME_TRUE)
        o = judge(a, &length);
    else if (o == OUTCOME_FAIL)
        findings_explain(a->findings, o, "a point of the outer curve may lie on three sides of the unit square, as seen from 0");
    else
        findings_explain(a->findings, o, "some segment of the outer curve may reach 0, or lie on three sides of the unit square, as seen from 0");
    number_clear(&length);
    return o;
}
