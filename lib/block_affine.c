/* block_affine.c: u over an arc, and the block there.  Compiled for affine numbers of each system. */
#include "block_affine.h"

#include "resting_centre.h"

#include <string.h>

#define affine_matrix BASE_NAME(affine_matrix)

bool affine_cosine(affine *u, const arc *r, long prec)
{
    base_number low, high;
    base_init(&low);
    base_init(&high);
    base_cos_pi(&low, &r->high, prec);
    base_cos_pi(&high, &r->low, prec);
    affine_between(u, &low, &high, prec);
    base_clear(&low);
    base_clear(&high);
    return !affine_lacks_memory(u);
}

block_status block_make_over(block *z, scheme_numbers *numbers, frequencies m, const arc *r, diagnostic *d)
{
    affine u;
    block_status result = BLOCK_NO_MEMORY;
    memset(z, 0, sizeof *z);
    affine_init(&u);
    if (affine_cosine(&u, r, numbers->prec))
        result = block_make_at(z, numbers, m, &u, d);
    affine_clear(&u);
    return result;
}

block_status BASE_NAME(affine_matrix_make)(affine_matrix *z, const scheme *s, valence_range k, frequencies m, const arc *r, long prec, diagnostic *d)
{
    scheme_numbers numbers;
    block b;
    block_status result = BLOCK_NO_MEMORY;
    status made = scheme_numbers_make_range(&numbers, s, k, prec, d);
    memset(z, 0, sizeof *z);
    if (made == STATUS_BAD_INPUT)
        result = BLOCK_BAD_INPUT;
    if (made == STATUS_OK) {
        result = block_make_over(&b, &numbers, m, r, d);
        if (result == BLOCK_OK) {
            z->n = b.n;
            z->entry = b.entry;
            b.entry = NULL;
        }
        block_free(&b);
    }
    scheme_numbers_free(&numbers);
    return result;
}

/* ---- a centre that comes to rest ---- */

/* kappa = 1/k = (1 + t)/(2 k1) */
static bool set_reciprocal(affine *kappa, valence_range k, long prec)
{
    rational half;
    bool ok;
    rational_init(&half);
    ok = rational_set_si(&half, 1, k.first) && rational_mul_2exp(&half, &half, -1);
    base_set_rational(&kappa->centre, &half, prec);
    base_set(&kappa->slope, &kappa->centre);
    rational_clear(&half);
    return ok;
}

/* z = w, a polynomial in kappa, by Horner's rule. */
static void evaluate(affine *z, const laurent_value *w, const affine *kappa, long prec)
{
    affine c;
    affine_init(&c);
    affine_set_rational(z, laurent_value_at(w, laurent_value_low(w)), prec);
    for (int i = laurent_value_low(w) + 1; i <= 0; i++) {
        affine_mul(z, z, kappa, prec);
        affine_set_rational(&c, laurent_value_at(w, i), prec);
        affine_add(z, z, &c, prec);
    }
    affine_clear(&c);
}

/* The weights of a rule of the centre, the rest included, are these from now on. */
static status set_centre_weights(rule_numbers *z, const affine *kappa, valence_range k, long prec)
{
    centre_weights w;
    bool known, ok = centre_weights_make(&w, &known, z->rule, k);
    for (int i = 0; ok && i < w.count; i++) {
        if (known)
            evaluate(&z->weight[i], &w.weight[i], kappa, prec);
        else
            affine_indeterminate(&z->weight[i]);
        z->known[i] = true;
    }
    centre_weights_clear(&w);
    return ok ? STATUS_OK : STATUS_NO_MEMORY;
}

static status set_all_centre_weights(scheme_numbers *numbers)
{
    affine kappa;
    status result;
    affine_init(&kappa);
    result = set_reciprocal(&kappa, numbers->k, numbers->prec) ? STATUS_OK : STATUS_NO_MEMORY;
    for (int i = 0; i < numbers->scheme->step_count; i++)
        for (int j = 0; result == STATUS_OK && j < numbers->steps[i].rule_count; j++)
            if (numbers->steps[i].rules[j].rule->at_centre)
                result = set_centre_weights(&numbers->steps[i].rules[j], &kappa, numbers->k, numbers->prec);
    affine_clear(&kappa);
    return result;
}

/* z = b without its constant net: the unknown 0 is the centre. */
static block_status take_rest(affine_matrix *z, const block *b, long prec)
{
    affine *to = z->entry = affine_array_new((size_t)(b->n - 1) * (size_t)(b->n - 1));
    if (!to)
        return BLOCK_NO_MEMORY;
    z->n = b->n - 1;
    for (int i = 1; i < b->n; i++)
        for (int j = 1; j < b->n; j++)
            affine_sub(to++, &b->entry[i * b->n + j], &b->entry[j], prec);
    return BLOCK_OK;
}

block_status BASE_NAME(affine_matrix_make_resting)(affine_matrix *z, const scheme *s, valence_range k, long prec, diagnostic *d)
{
    scheme_numbers numbers;
    block b;
    block_status result = BLOCK_NO_MEMORY;
    status made = scheme_numbers_make_range(&numbers, s, k, prec, d);
    memset(z, 0, sizeof *z);
    if (made == STATUS_OK)
        made = set_all_centre_weights(&numbers);
    if (made == STATUS_BAD_INPUT)
        result = BLOCK_BAD_INPUT;
    if (made == STATUS_OK) {
        result = block_make(&b, &numbers, 0, true, d);
        if (result == BLOCK_OK)
            result = take_rest(z, &b, prec);
        block_free(&b);
    }
    scheme_numbers_free(&numbers);
    return result;
}

void BASE_NAME(affine_matrix_free)(affine_matrix *z)
{
    affine_array_free(z->entry, (size_t)z->n * (size_t)z->n);
    memset(z, 0, sizeof *z);
}
