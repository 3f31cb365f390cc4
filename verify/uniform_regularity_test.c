/* uniform_regularity_test.c: the sign of the Jacobian on every triangle of one level ([Z] 5.5, TestRegular; with the
   derivatives of one triangle paired: verify/uniform.md, 5).  Compiled once per number system. */
#include "uniform.h"

#include <math.h>

/* What the triangles looked at so far say. */
typedef struct {
    bool some_positive, some_negative, some_open;
    double least; /* a lower bound of the Jacobian */
} signs;

/* An edge's derivative in one coordinate: a value, and its error. */
typedef struct {
    const number *value, *error;
} bounded;

/* The least and the greatest product of two numbers within the errors of x and y: at ends of both.  (One product of wide balls would
   be wider.) */
static void bound_product(number *least, number *greatest, bounded x, bounded y, long prec)
{
    number s, t;
    number_init(&s);
    number_init(&t);
    for (int corner = 0; corner < 4; corner++) {
        (corner & 1 ? number_sub : number_add)(&s, x.value, x.error, prec);
        (corner & 2 ? number_sub : number_add)(&t, y.value, y.error, prec);
        number_mul(&s, &s, &t, prec);
        if (corner == 0) {
            number_set(least, &s);
            number_set(greatest, &s);
        } else {
            number_min(least, least, &s, prec);
            number_max(greatest, greatest, &s, prec);
        }
    }
    number_clear(&s);
    number_clear(&t);
}

/* The least and the greatest J = x1 y2 - y1 x2 for all derivatives within the errors of those of two edges. */
static void jacobian(number j[2], const uniform_net *first, int at_first, const uniform_net *second, int at_second, long prec)
{
    bounded x1 = {&first->value[0][at_first], &first->error[0]}, y1 = {&first->value[1][at_first], &first->error[1]};
    bounded x2 = {&second->value[0][at_second], &second->error[0]}, y2 = {&second->value[1][at_second], &second->error[1]};
    number least, greatest;
    number_init(&least);
    number_init(&greatest);
    bound_product(&j[0], &j[1], x1, y2, prec);
    bound_product(&least, &greatest, y1, x2, prec);
    number_sub(&j[0], &j[0], &greatest, prec);
    number_sub(&j[1], &j[1], &least, prec);
    number_clear(&least);
    number_clear(&greatest);
}

static void note_sign(signs *z, const number j[2])
{
    z->least = fmin(z->least, number_lower_bound(&j[0]));
    if (number_is_positive(&j[0]) == TRUTH_TRUE)
        z->some_positive = true;
    else if (number_is_negative(&j[1]) == TRUTH_TRUE)
        z->some_negative = true;
    else
        z->some_open = true;
}

/* UP(a,b) has the edges of labels (a,b) in both directions, DOWN(a,b) those of (a,b+1) in direction 1 and (a+1,b) in
   direction 2. */
static outcome find_signs(signs *z, analysis *a)
{
    const uniform_net *first = &a->uniform[RING_FIRST], *second = &a->uniform[RING_SECOND];
    int inner = a->plan->problem->geometry.radius << first->level, outer = 2 * inner;
    outcome o = OUTCOME_TRUE;
    number j[2];
    number_init(&j[0]);
    number_init(&j[1]);
    for (int p = 0; p < outer && !number_lacks_memory(&j[0]); p++) {
        for (int q = p < inner ? inner - p : 0; p + q < outer; q++) {
            jacobian(j, first, uniform_net_index(first, p, q), second, uniform_net_index(second, p, q), a->prec);
            note_sign(z, j);
        }
        for (int q = p < inner - 1 ? inner - 1 - p : 0; p + q < outer - 1; q++) {
            jacobian(j, first, uniform_net_index(first, p, q + 1), second, uniform_net_index(second, p + 1, q), a->prec);
            note_sign(z, j);
        }
    }
    if (number_lacks_memory(&j[0]))
        o = OUTCOME_NO_MEMORY;
    number_clear(&j[0]);
    number_clear(&j[1]);
    return o;
}

outcome test_uniform_regularity(analysis *a)
{
    signs z = {false, false, false, INFINITY};
    attempt *log = findings_last(a->findings);
    outcome o = find_signs(&z, a);
    log->error = uniform_largest_error(a, RING_FIRST, RING_SECOND);
    log->bound = z.least;
    if (o != OUTCOME_TRUE)
        return o;
    if (!z.some_negative && !z.some_open)
        return OUTCOME_TRUE;
    if (z.some_negative && z.some_positive)
        return findings_explain(a->findings, OUTCOME_FALSE, "the Jacobian is positive somewhere and negative elsewhere: the characteristic map folds");
    if (z.some_negative && !z.some_open)
        return findings_explain(a->findings, OUTCOME_FALSE, "the Jacobian is negative throughout: the characteristic map turns the wrong way round");
    return findings_explain(a->findings, OUTCOME_UNDEFINED, "the sign of the Jacobian is open on some triangle");
}
