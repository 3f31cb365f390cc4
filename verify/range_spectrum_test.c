/* range_spectrum_test.c: the dominance of L for many valences (verify/certificate-valences.md, section 4).  Compiled
   for affine numbers. */
#include "tests.h"

#include "../lib/eigenpair_affine.h"
#include "range_spectrum.h"

outcome test_spectrum(analysis *a)
{
    int n = a->order - 1;
    size_t size = (size_t)n * (size_t)n;
    base_number *rest = base_array_new(size);
    outcome o = OUTCOME_NO_MEMORY;
    if (rest) {
        BASE_NAME(affine_deflate)(rest, a->dominant.entry, a->box, a->order, a->choices->eigenpair.pivot, a->prec);
        o = BASE_NAME(range_spectrum)(a->findings, a->choices, a->plan->problem->scheme, rest, n, &a->scale.centre, a->replay, a->prec);
        base_array_free(rest, size);
    }
    a->plan->scale_upper = number_upper_bound(&a->scale);
    return o;
}
