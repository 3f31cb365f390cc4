/* eigenpair_test.c: the eigenvalue L of one block (verify/certificate.md, sections 6 and 10).  Compiled once per number
   system.

   For a proof of C1 it is the dominant one of block 1; for a refutation, that of the block that dominates, block 0
   being deflated by the vector of ones. */
#include "tests.h"

#include "../lib/eigenpair.h"
#include "../lib/spectrum.h"

#include <stdlib.h>

/* scale = the least number of the system that is at least 1/x. */
static void invert_upwards(number *scale, const number *x, long prec)
{
    number_inv(scale, x, prec);
    number_upper(scale, scale, prec);
}

/* Is the interval of L, or of -L, or of |L|^2, on the side of 1 that the claim needs? */
static bool is_on_its_side(const analysis *a, const number *x)
{
    bool good;
    number one;
    number_init(&one);
    number_one(&one);
    if (a->choices->claim == CLAIM_NOT_C0)
        good = number_less(&one, x) == TRUTH_TRUE;
    else
        good = number_is_positive(x) == TRUTH_TRUE && number_less(x, &one) == TRUTH_TRUE;
    number_clear(&one);
    return good;
}

static outcome explain_side(analysis *a, const char *of_what)
{
    if (a->choices->claim == CLAIM_NOT_C0)
        return findings_explain(a->findings, OUTCOME_FAIL, "%s of block %ld could not be shown to lie beyond 1", of_what, a->choices->frequency);
    return findings_explain(a->findings, OUTCOME_FAIL, "%s of block %ld could not be shown to lie between 0 and 1", of_what, a->choices->frequency);
}

/* A real L, which may not be negative for C1 and folds.  Sets the scale. */
static outcome bound_real(analysis *a)
{
    claim_kind claim = a->choices->claim;
    number modulus, lower;
    outcome o = OUTCOME_TRUE;
    number_init(&modulus);
    number_init(&lower);
    number_set(&modulus, &a->box[a->order]);
    if ((claim == CLAIM_FREQUENCY || claim == CLAIM_NOT_C0 || claim == CLAIM_WINDING || claim == CLAIM_REAL) && number_is_negative(&modulus) == TRUTH_TRUE)
        number_neg(&modulus, &modulus);
    if (!is_on_its_side(a, &modulus))
        o = explain_side(a, "the dominant eigenvalue");
    number_lower(&lower, &modulus, a->prec);
    invert_upwards(&a->scale, &lower, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(&modulus);
    a->findings->eigenvalue_upper = number_upper_bound(&modulus);
    number_clear(&modulus);
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

/* 0 < ell < |L|, and |L|^2 on its side of 1.  Sets the scale. */
static outcome bound_complex(analysis *a)
{
    const number *re = &a->box[a->order], *im = re + 1;
    choices *c = a->choices;
    number square, modulus, rest;
    outcome o = OUTCOME_TRUE;
    number_init(&square);
    number_init(&modulus);
    number_init(&rest);
    number_mul(&square, re, re, a->prec);
    number_addmul(&square, im, im, a->prec);
    if (!a->replay && !choose_modulus(&c->modulus, &square, c->grid, a->prec))
        o = number_lacks_memory(&square) ? OUTCOME_NO_MEMORY : explain_side(a, "the modulus of the dominant eigenvalue");
    if (o == OUTCOME_TRUE) {
        number_set_integer_2exp(&modulus, &c->modulus, -c->grid, a->prec);
        number_mul(&rest, &modulus, &modulus, a->prec);
        number_sub(&rest, &square, &rest, a->prec);
        if (integer_sign(&c->modulus) <= 0 || number_is_positive(&rest) != TRUTH_TRUE || !is_on_its_side(a, &square))
            o = explain_side(a, "the modulus of the dominant eigenvalue");
    }
    invert_upwards(&a->scale, &modulus, a->prec);
    number_sqrt(&square, &square, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(&modulus);
    a->findings->eigenvalue_upper = number_upper_bound(&square);
    number_clear(&square);
    number_clear(&modulus);
    number_clear(&rest);
    return o;
}

/* Block 0 without the eigenvalue 1 of the vector of ones, order x order. */
static number *deflate_plain(int *order, const block *plain, long prec)
{
    int n = *order = plain->n - 1;
    number *z = number_array_new((size_t)n * (size_t)n);
    if (z)
        matrix_deflate(z, plain->entry, NULL, plain->n, 0, prec);
    return z;
}

/* (A, 0; 0, A), so that a real vector (x, y) stands for x + i y: block 0 or k/2, which is real, as a matrix of the complex
   form. */
static number *double_matrix(const number *a, int n)
{
    number *z = number_array_new(4 * (size_t)n * (size_t)n);
    for (int i = 0; z && i < n * n; i++) {
        number_set(&z[i / n * 2 * n + i % n], &a[i]);
        number_set(&z[(i / n + n) * 2 * n + i % n + n], &a[i]);
    }
    return z;
}

/* a->matrix: the block as a real matrix, as the choices say. */
static outcome make_matrix(analysis *a)
{
    long m = a->choices->frequency;
    number *real = NULL;
    outcome o = analysis_make_block(&a->dominant, a, m, m);
    if (o != OUTCOME_TRUE)
        return o;
    a->order = a->dominant.n;
    if (m == 0)
        real = deflate_plain(&a->order, &a->dominant, a->prec);
    if (!a->choices->pair) {
        a->matrix = m == 0 ? real : block_real_matrix(&a->order, &a->dominant);
        return a->matrix ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
    }
    if (m > 0 || real)
        a->matrix = double_matrix(m == 0 ? real : a->dominant.entry, a->order);
    if (real)
        number_array_free(real, (size_t)a->order * (size_t)a->order);
    a->order *= 2;
    return a->matrix ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

outcome test_eigenpair(analysis *a)
{
    choices *c = a->choices;
    bool symmetric = a->plan->problem->scheme->mirror_symmetric;
    bool complex_form = c->pair || (c->frequency > 0 && (a->replay ? c->eigenpair.complex_form : !symmetric));
    truth found = TRUTH_TRUE;
    outcome o;
    if (c->frequency > 0 && !complex_form && !symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "the real form, but the scheme is not evidently mirror-symmetric");
    c->eigenpair.complex_form = a->numbers.complex_form = complex_form;
    o = make_matrix(a);
    if (o != OUTCOME_TRUE)
        return o;
    a->box = number_array_new(eigenpair_box_size(a->order, complex_form));
    if (!a->box)
        return OUTCOME_NO_MEMORY;
    if (!a->replay)
        found = eigenpair_choose(&c->eigenpair, a->matrix, a->order, complex_form, c->grid, a->prec);
    else if (c->eigenpair.n != a->order)
        return findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector has not %d components", a->order);
    if (found == TRUTH_TRUE)
        found = eigenpair_prove(a->box, &c->eigenpair, a->matrix, a->prec);
    if (found != TRUTH_TRUE)
        return found == TRUTH_FALSE ? OUTCOME_NO_MEMORY
                                    : findings_explain(a->findings, OUTCOME_FAIL, "no box round an approximate dominant eigenpair of block %ld could be proved", c->frequency);
    o = complex_form ? bound_complex(a) : bound_real(a);
    findings_last(a->findings)->bound = a->findings->eigenvalue_lower;
    return o;
}
