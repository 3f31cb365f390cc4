/* zero_free_test.c: an eigenfunction has no zero on the outer curve, which rotation maps to itself (verify/certificate.md,
   section 10, "frequency").  Compiled once per number system. */
#include "tests.h"

#include <math.h>

/* One coordinate has a sign. */
static outcome avoids_zero(double *margin, const adaptive_box *box, const void *data, long prec)
{
    outcome o = OUTCOME_UNDEFINED;
    (void)data;
    (void)prec;
    *margin = -INFINITY;
    for (int i = 0; i < 2 && o == OUTCOME_UNDEFINED; i++) {
        const number *x = i ? &box[0].y : &box[0].x;
        if (number_lacks_memory(x))
            o = OUTCOME_NO_MEMORY;
        else if (number_is_positive(x) == TRUTH_TRUE || number_is_negative(x) == TRUTH_TRUE) {
            *margin = fmax(number_lower_bound(x), -number_upper_bound(x));
            o = OUTCOME_TRUE;
        }
    }
    return o;
}

outcome test_zero_free(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task task = {.nets = 1, .which = {RING_VALUES}, .decide = avoids_zero};
    outcome o = analysis_subdivide(a, &task, &a->choices->boundary, g->boundary, g->boundary_count);
    if (o == OUTCOME_UNDEFINED || o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the eigenfunction of block %ld could not be shown to have no zero on the outer curve", a->choices->frequency);
    return o;
}
