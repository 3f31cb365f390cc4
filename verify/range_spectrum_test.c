/* range_spectrum_test.c: the dominance of L for many valences (verify/certificate-valences.md, sections 4 and 6).  Compiled
   for affine numbers. */
#include "tests.h"

#include "range_spectrum.h"

outcome test_spectrum(analysis *a)
{
    const BASE_NAME(range_pair) pair = {analysis_matrix(a), a->box, a->order, a->choices->eigenpair.pivot};
    outcome o = (a->choices->claim == CLAIM_C1 ? BASE_NAME(range_spectrum) : BASE_NAME(range_spectrum_of_frequency))(
        a->findings, a->choices, a->plan->problem->scheme, &pair, &a->scale.centre, a->replay, a->prec);
    a->plan->scale_upper = number_upper_bound(&a->scale);
    return o;
}
