/* uniform_regularity_test.c: the sign of the Jacobian on every triangle of one level ([Z] 5.5, TestRegular; with the
   derivatives of one triangle paired: verify/uniform.md, 5).  Compiled once per number system. */
#include "uniform.h"

#include <math.h>

/* What the triangles looked at so far say. */
typedef struct {
    bool some_positive, some_negative, some_open;
    double least; /* a lower bound of the Jacobian */
} signs;

/* J = x1 y2 - y1 x2 for all derivatives within `error` of those of the edges (a1,b1) and (a2,b2). */
static void jacobian(number *j, number box[4], const uniform_net *first, int at, const uniform_net *second, int at_second, long prec)
{
    for (int c = 0; c < 2; c++) {
        number_add_error(&box[c], &first->value[c][at], &first->error[c], prec);
        number_add_error(&box[2 + c], &second->value[c][at_second], &second->error[c], prec);
    }
    number_mul(j, &box[0], &box[3], prec);
    number_submul(j, &box[1], &box[2], prec);
}

static void note_sign(signs *z, const number *j)
{
    z->least = fmin(z->least, number_lower_bound(j));
    if (number_is_positive(j) == TRUTH_TRUE)
        z->some_positive = true;
    else if (number_is_negative(j) == TRUTH_TRUE)
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
    number j, box[4];
    number_init(&j);
    for (int i = 0; i < 4; i++)
        number_init(&box[i]);
    for (int p = 0; p < outer && !number_lacks_memory(&j); p++) {
        for (int q = p < inner ? inner - p : 0; p + q < outer; q++) {
            jacobian(&j, box, first, uniform_net_index(first, p, q), second, uniform_net_index(second, p, q), a->prec);
            note_sign(z, &j);
        }
        for (int q = p < inner - 1 ? inner - 1 - p : 0; p + q < outer - 1; q++) {
            jacobian(&j, box, first, uniform_net_index(first, p, q + 1), second, uniform_net_index(second, p + 1, q), a->prec);
            note_sign(z, &j);
        }
    }
    if (number_lacks_memory(&j))
        o = OUTCOME_NO_MEMORY;
    number_clear(&j);
    for (int i = 0; i < 4; i++)
        number_clear(&box[i]);
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
