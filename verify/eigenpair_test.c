/* eigenpair_test.c: the eigenvalue L of block 1 (verify/certificate.md, section 6).  Compiled once per number system. */
#include "tests.h"

#include "../lib/eigenpair.h"

#include <stdlib.h>

/* scale = the least number of the system that is at least 1/x. */
static void invert_upwards(number *scale, const number *x, long prec)
{
    number_inv(scale, x, prec);
    number_upper(scale, scale, prec);
}

/* 0 < L < 1, and the scale. */
static outcome bound_real(analysis *a)
{
    const number *eigenvalue = &a->box[a->order];
    number one, lower;
    outcome o = OUTCOME_TRUE;
    number_init(&one);
    number_init(&lower);
    number_one(&one);
    if (number_is_positive(eigenvalue) != TRUTH_TRUE || number_less(eigenvalue, &one) != TRUTH_TRUE)
        o = findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block 1 could not be shown to lie between 0 and 1");
    number_lower(&lower, eigenvalue, a->prec);
    invert_upwards(&a->scale, &lower, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(eigenvalue);
    a->findings->eigenvalue_upper = number_upper_bound(eigenvalue);
    number_clear(&one);
    number_clear(&lower);
    return o;
}

/* Less than the root of `square` by so much that rounding differently makes no difference, on the grid of
   certificates. */
static bool choose_modulus(integer *modulus, const number *square, long g, long prec)
{
    bool ok;
    number lower, slack;
    number_init(&lower);
    number_init(&slack);
    number_lower(&lower, square, prec);
    number_sqrt(&lower, &lower, prec);
    number_mul_2exp(&slack, &lower, 8 - prec, prec);
    number_sub(&lower, &lower, &slack, prec);
    ok = number_lower_grid(modulus, &lower, g);
    number_clear(&lower);
    number_clear(&slack);
    return ok;
}

/* 0 < ell < |L| < 1, and the scale. */
static outcome bound_complex(analysis *a)
{
    const number *re = &a->box[a->order], *im = re + 1;
    choices *c = a->choices;
    number square, modulus, one;
    outcome o = OUTCOME_TRUE;
    number_init(&square);
    number_init(&modulus);
    number_init(&one);
    number_one(&one);
    number_mul(&square, re, re, a->prec);
    number_addmul(&square, im, im, a->prec);
    if (!a->replay && !choose_modulus(&c->modulus, &square, c->grid, a->prec))
        o = number_lacks_memory(&square) ? OUTCOME_NO_MEMORY : findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block 1 is not bounded");
    if (o == OUTCOME_TRUE) {
        number t;
        number_init(&t);
        number_set_integer_2exp(&modulus, &c->modulus, -c->grid, a->prec);
        number_mul(&t, &modulus, &modulus, a->prec);
        number_sub(&t, &square, &t, a->prec);
        if (integer_sign(&c->modulus) <= 0 || number_is_positive(&t) != TRUTH_TRUE || number_less(&square, &one) != TRUTH_TRUE)
            o = findings_explain(a->findings, OUTCOME_FAIL, "the modulus of the dominant eigenvalue of block 1 could not be shown to lie between 0 and 1");
        number_clear(&t);
    }
    invert_upwards(&a->scale, &modulus, a->prec);
    number_sqrt(&square, &square, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(&modulus);
    a->findings->eigenvalue_upper = number_upper_bound(&square);
    number_clear(&square);
    number_clear(&modulus);
    number_clear(&one);
    return o;
}

outcome test_eigenpair(analysis *a)
{
    choices *c = a->choices;
    bool complex_form = a->replay ? c->eigenpair.complex_form : !a->plan->problem->scheme->mirror_symmetric;
    truth found = TRUTH_TRUE;
    outcome o;
    if (!complex_form && !a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "the real form, but the scheme is not evidently mirror-symmetric");
    c->eigenpair.complex_form = complex_form;
    o = analysis_make_block(&a->dominant, a, 1, 1);
    if (o != OUTCOME_TRUE)
        return o;
    a->matrix = block_real_matrix(&a->order, &a->dominant);
    a->box = number_array_new(eigenpair_box_size(a->order, complex_form));
    if (!a->box || !a->matrix)
        return OUTCOME_NO_MEMORY;
    if (!a->replay)
        found = eigenpair_choose(&c->eigenpair, a->matrix, a->order, complex_form, c->grid, a->prec);
    else if (c->eigenpair.n != a->order)
        return findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector has not %d components", a->order);
    if (found == TRUTH_TRUE)
        found = eigenpair_prove(a->box, &c->eigenpair, a->matrix, a->prec);
    if (found != TRUTH_TRUE)
        return found == TRUTH_FALSE ? OUTCOME_NO_MEMORY
                                    : findings_explain(a->findings, OUTCOME_FAIL, "no box round an approximate dominant eigenpair of block 1 could be proved");
    o = complex_form ? bound_complex(a) : bound_real(a);
    findings_last(a->findings)->bound = a->findings->eigenvalue_lower;
    return o;
}
