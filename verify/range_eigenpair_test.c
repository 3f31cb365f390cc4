/* range_eigenpair_test.c: the eigenvalue L of one block for many valences (verify/certificate-valences.md, sections 3, 4
   and 6).  Compiled for affine numbers.

   For a proof of C1 it is that of block 1; for a refutation, that of the block of one frequency, block 0 being without the
   constant net. */
#include "tests.h"

#include "../lib/block_affine.h"
#include "../lib/eigenpair_affine.h"

#include <stdio.h>

/* a->dominant: the block over cos(pi m/k) of all valences. */
static outcome make_block(analysis *a, long m)
{
    arc r;
    diagnostic d;
    outcome o = OUTCOME_NO_MEMORY;
    arc_init(&r);
    if (arc_set_frequency(&r, m, a->choices->k))
        o = analysis_from_block(a, block_make_over(&a->dominant, &a->numbers, one_frequency(m), &r, &d), &d);
    arc_clear(&r);
    a->order = a->dominant.n;
    return o;
}

/* Of m = 0, for all valences, a->matrix being what is left of it. */
static outcome make_plain_block(analysis *a)
{
    diagnostic d;
    outcome o = analysis_from_block(a, block_make(&a->dominant, &a->numbers, 0, true, &d), &d);
    if (o != OUTCOME_TRUE)
        return o;
    a->order = a->dominant.n - 1;
    a->matrix = block_without_constants(&a->dominant, a->prec);
    return a->matrix ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

outcome analysis_prove_pair(analysis *a, eigenpair_choice *e, const char *of_what)
{
    const number *matrix = analysis_matrix(a);
    int n = a->order;
    truth found = TRUTH_TRUE;
    a->box = number_array_new((size_t)n + 1);
    if (!a->box)
        return OUTCOME_NO_MEMORY;
    if (!a->replay)
        found = BASE_NAME(eigenpair_affine_choose)(e, matrix, n, a->choices->grid, a->prec);
    else if (e->n != n)
        return findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector has not %d components", n);
    if (found == TRUTH_TRUE)
        found = BASE_NAME(eigenpair_affine_prove)(a->box, e, matrix, n, a->prec);
    if (found == TRUTH_TRUE)
        return OUTCOME_TRUE;
    return found == TRUTH_FALSE ? OUTCOME_NO_MEMORY : findings_explain(a->findings, OUTCOME_FAIL, "no box round an approximate dominant eigenpair of %s could be proved", of_what);
}

/* 0 < modulus < 1, or 1 < modulus where that is claimed. */
static bool is_on_its_side(const analysis *a, const number *modulus)
{
    number rest;
    bool good;
    number_init(&rest);
    number_one(&rest);
    number_sub(&rest, modulus, &rest, a->prec);
    if (a->choices->claim == CLAIM_NOT_C0)
        good = number_is_positive(&rest) == TRUTH_TRUE;
    else
        good = number_is_positive(modulus) == TRUTH_TRUE && number_is_negative(&rest) == TRUTH_TRUE;
    number_clear(&rest);
    return good;
}

/* ceil(1/lo), lo the lower end of the modulus' range. */
static void set_scale(analysis *a, const number *modulus)
{
    base_number lower;
    base_init(&lower);
    affine_range(&lower, modulus, a->prec);
    base_lower(&lower, &lower, a->prec);
    base_inv(&lower, &lower, a->prec);
    base_upper(&a->scale.centre, &lower, a->prec);
    base_clear(&lower);
}

/* |L| is on its side of 1; L may be negative only where a frequency or growth is claimed.  Sets the scale. */
static outcome bound(analysis *a)
{
    claim_kind claim = a->choices->claim;
    number modulus;
    outcome o = OUTCOME_TRUE;
    number_init(&modulus);
    number_set(&modulus, &a->box[a->order]);
    if ((claim == CLAIM_FREQUENCY || claim == CLAIM_NOT_C0) && number_is_negative(&modulus) == TRUTH_TRUE)
        number_neg(&modulus, &modulus);
    if (!is_on_its_side(a, &modulus))
        o = findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block %ld could not be shown to lie %s", a->choices->frequency,
                             claim == CLAIM_NOT_C0 ? "beyond 1" : "between 0 and 1");
    set_scale(a, &modulus);
    a->findings->eigenvalue_lower = number_lower_bound(&modulus);
    a->findings->eigenvalue_upper = number_upper_bound(&modulus);
    findings_last(a->findings)->bound = a->findings->eigenvalue_lower;
    number_clear(&modulus);
    return o;
}

outcome test_eigenpair(analysis *a)
{
    long m = a->choices->frequency;
    char words[64];
    outcome o;
    if (a->choices->eigenpair.complex_form)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need the real form");
    if (!a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need a scheme that is evidently mirror-symmetric");
    if (m > 0 && 2 * m >= a->choices->k.first)
        return findings_explain(a->findings, OUTCOME_FALSE, "not all of these valences have a block %ld with a partner", m);
    o = m > 0 ? make_block(a, m) : make_plain_block(a);
    if (o != OUTCOME_TRUE)
        return o;
    snprintf(words, sizeof words, "block %ld", m);
    o = analysis_prove_pair(a, &a->choices->eigenpair, words);
    return o == OUTCOME_TRUE ? bound(a) : o;
}
