/* uniform_isolation_test.c: no triangle of one level comes within `error` of 0 ([Z] 5.6, TestIsolZero, on whole triangles
   instead of vertices: verify/uniform.md, 6).  Compiled once per number system.

   It is never false: a box that contains 0 says nothing. */
#include "uniform.h"

/* Does one coordinate of the hull, and of everything within `error` of it, have one sign? */
bool uniform_avoids_zero(const uniform_net *z, const int *corner, int corners, long prec)
{
    bool avoids = false;
    number hull;
    number_init(&hull);
    for (int c = 0; c < 2 && !avoids; c++) {
        number_set(&hull, &z->value[c][corner[0]]);
        for (int i = 1; i < corners; i++)
            number_hull(&hull, &hull, &z->value[c][corner[i]], prec);
        number_add_error(&hull, &hull, &z->error[c], prec);
        avoids = number_is_positive(&hull) == TRUTH_TRUE || number_is_negative(&hull) == TRUTH_TRUE;
    }
    number_clear(&hull);
    return avoids;
}

static bool up_avoids_zero(const uniform_net *z, int a, int b, long prec)
{
    int corner[3] = {uniform_net_index(z, a, b), uniform_net_index(z, a + 1, b), uniform_net_index(z, a, b + 1)};
    return uniform_avoids_zero(z, corner, 3, prec);
}

static bool down_avoids_zero(const uniform_net *z, int a, int b, long prec)
{
    int corner[3] = {uniform_net_index(z, a + 1, b + 1), uniform_net_index(z, a, b + 1), uniform_net_index(z, a + 1, b)};
    return uniform_avoids_zero(z, corner, 3, prec);
}

outcome test_uniform_isolation(analysis *a)
{
    const uniform_net *z = &a->uniform[RING_VALUES];
    int inner = a->plan->problem->geometry.radius << z->level, outer = 2 * inner;
    bool isolated = true;
    findings_last(a->findings)->error = uniform_largest_error(a, RING_VALUES, RING_VALUES);
    for (int p = 0; p < outer && isolated; p++) {
        for (int q = p < inner ? inner - p : 0; p + q < outer && isolated; q++)
            isolated = up_avoids_zero(z, p, q, a->prec);
        for (int q = p < inner - 1 ? inner - 1 - p : 0; p + q < outer - 1 && isolated; q++)
            isolated = down_avoids_zero(z, p, q, a->prec);
    }
    return isolated ? OUTCOME_TRUE : findings_explain(a->findings, OUTCOME_UNDEFINED, "some triangle may contain 0");
}
