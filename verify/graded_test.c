/* graded_test.c: an eigenvalue of block 0 that grows without bound with the valence (verify/certificate-valences.md, section
   6).  Compiled for affine numbers. */
#include "tests.h"

#include "../lib/graded.h"
#include "../lib/graded_scheme.h"
#include "../lib/reciprocal.h"

#include <math.h>

static outcome check_scheme(analysis *a)
{
    diagnostic d;
    bool is, varies;
    status s = scheme_centre_is_graded(&is, &varies, a->plan->problem->scheme, a->choices->k, &d);
    if (s != STATUS_OK)
        return analysis_from_block(a, s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY, &d);
    return is ? OUTCOME_TRUE : findings_explain(a->findings, OUTCOME_FALSE, "the weights of the centre are not the only ones that depend on k, or are no finite sums of powers of k");
}

/* a->matrix: by a choice that is made or followed. */
static outcome make_matrix(analysis *a, graded_block *b)
{
    graded_choice *c = &a->choices->graded;
    block_status s = a->replay ? BLOCK_OK : graded_choose(c, b);
    truth t;
    if (s == BLOCK_OK)
        s = graded_block_scale(b, c->unit);
    if (s != BLOCK_OK)
        return analysis_from_block(a, s, NULL);
    t = graded_matrix(&a->matrix, b, c);
    a->order = a->dominant.n;
    if (t == TRUTH_UNKNOWN)
        return findings_explain(a->findings, OUTCOME_FALSE, "these grades leave powers of k that grow, or are beyond the limits of certificates");
    return t == TRUTH_TRUE ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

/* |L| (k/unit)^d lies between these at all valences: figures for people. */
static void note_bounds(analysis *a, const number *modulus)
{
    valence_range k = a->choices->k;
    int d = a->choices->graded.degree;
    double unit = (double)a->choices->graded.unit;
    a->findings->eigenvalue_lower = number_lower_bound(modulus) * pow((double)k.first / unit, d) * (1 - 0x1p-40);
    a->findings->eigenvalue_upper = k.last == VALENCES_UNBOUNDED && d > 0 ? INFINITY : number_upper_bound(modulus) * pow((double)k.last / unit, d) * (1 + 0x1p-40);
    findings_last(a->findings)->bound = a->findings->eigenvalue_lower;
}

/* |L| > kappa^d, and L is not 0. */
static outcome bound(analysis *a, const number *kappa)
{
    int d = a->choices->graded.degree;
    number *powers = reciprocal_powers(kappa, d + 1, a->prec), modulus, excess;
    outcome o = powers ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
    number_init(&modulus);
    number_init(&excess);
    if (o == OUTCOME_TRUE) {
        number_set(&modulus, &a->box[a->order]);
        if (number_is_negative(&modulus) == TRUTH_TRUE)
            number_neg(&modulus, &modulus);
        number_sub(&excess, &modulus, &powers[d], a->prec);
        if (number_lacks_memory(&excess))
            o = OUTCOME_NO_MEMORY;
        else if (number_is_positive(&modulus) != TRUTH_TRUE || number_is_positive(&excess) != TRUTH_TRUE)
            o = findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block 0 could not be shown to lie beyond 1");
        note_bounds(a, &modulus);
        number_array_free(powers, (size_t)d + 1);
    }
    number_clear(&modulus);
    number_clear(&excess);
    return o;
}

static outcome prove(analysis *a, graded_block *b)
{
    outcome o = make_matrix(a, b);
    if (o == OUTCOME_TRUE)
        o = analysis_prove_pair(a, &a->choices->eigenpair, "block 0, scaled,");
    if (o == OUTCOME_TRUE)
        o = bound(a, &b->kappa);
    if (o == OUTCOME_TRUE) {
        o = analysis_from_block(a, graded_sector_net(&a->net, b, &a->choices->graded, a->box, &a->plan->problem->geometry), NULL);
        a->net_made = o == OUTCOME_TRUE;
    }
    return o;
}

outcome test_graded(analysis *a)
{
    graded_block b;
    diagnostic d;
    outcome o;
    if (!a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need a scheme that is evidently mirror-symmetric");
    o = check_scheme(a);
    if (o != OUTCOME_TRUE)
        return o;
    o = analysis_from_block(a, graded_block_make(&b, &a->dominant, &a->numbers, &d), &d);
    if (o == OUTCOME_TRUE)
        o = prove(a, &b);
    graded_block_free(&b);
    return o;
}
