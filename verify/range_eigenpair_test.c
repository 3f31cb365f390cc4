/* range_eigenpair_test.c: the eigenvalue L of block 1 for many valences (verify/certificate-valences.md, sections 3
   and 4).  Compiled for affine numbers. */
#include "tests.h"

#include "../lib/block_affine.h"
#include "../lib/eigenpair_affine.h"

/* a->dominant: block 1 over cos(pi/k) of all valences. */
static outcome make_block(analysis *a)
{
    arc r;
    diagnostic d;
    outcome o = OUTCOME_NO_MEMORY;
    arc_init(&r);
    if (arc_set_valences(&r, a->choices->k))
        o = analysis_from_block(a, block_make_over(&a->dominant, &a->numbers, one_frequency(1), &r, &d), &d);
    arc_clear(&r);
    return o;
}

outcome analysis_prove_pair(analysis *a, eigenpair_choice *e, const char *of_what)
{
    int n = a->dominant.n;
    truth found = TRUTH_TRUE;
    a->order = n;
    a->box = number_array_new((size_t)n + 1);
    if (!a->box)
        return OUTCOME_NO_MEMORY;
    if (!a->replay)
        found = BASE_NAME(eigenpair_affine_choose)(e, a->dominant.entry, n, a->choices->grid, a->prec);
    else if (e->n != n)
        return findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector has not %d components", n);
    if (found == TRUTH_TRUE)
        found = BASE_NAME(eigenpair_affine_prove)(a->box, e, a->dominant.entry, n, a->prec);
    if (found == TRUTH_TRUE)
        return OUTCOME_TRUE;
    return found == TRUTH_FALSE ? OUTCOME_NO_MEMORY : findings_explain(a->findings, OUTCOME_FAIL, "no box round an approximate dominant eigenpair of %s could be proved", of_what);
}

/* 0 < L < 1, and the scale, ceil(1/lo), lo the lower end of L's range. */
static outcome bound(analysis *a)
{
    const number *eigenvalue = &a->box[a->order];
    base_number lower;
    number rest;
    outcome o = OUTCOME_TRUE;
    base_init(&lower);
    number_init(&rest);
    number_one(&rest);
    number_sub(&rest, &rest, eigenvalue, a->prec);
    if (number_is_positive(eigenvalue) != TRUTH_TRUE || number_is_positive(&rest) != TRUTH_TRUE)
        o = findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block 1 could not be shown to lie between 0 and 1");
    affine_range(&lower, eigenvalue, a->prec);
    base_lower(&lower, &lower, a->prec);
    base_inv(&lower, &lower, a->prec);
    base_upper(&a->scale.centre, &lower, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(eigenvalue);
    a->findings->eigenvalue_upper = number_upper_bound(eigenvalue);
    findings_last(a->findings)->bound = a->findings->eigenvalue_lower;
    base_clear(&lower);
    number_clear(&rest);
    return o;
}

outcome test_eigenpair(analysis *a)
{
    outcome o;
    if (a->choices->eigenpair.complex_form)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need the real form");
    if (!a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need a scheme that is evidently mirror-symmetric");
    o = make_block(a);
    if (o != OUTCOME_TRUE)
        return o;
    o = analysis_prove_pair(a, &a->choices->eigenpair, "block 1");
    return o == OUTCOME_TRUE ? bound(a) : o;
}
