/* block_affine.c: u over an arc, and the block there.  Compiled for affine numbers of each system. */
#include "block_affine.h"

#include "centre_weights.h"
#include "reciprocal.h"

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

/* The weights of a rule of the centre, the rest included, are these from now on. */
static status set_centre_weights(rule_numbers *z, const affine *kappa, valence_range k, long prec)
{
    centre_weights w;
    bool known, ok = centre_weights_make(&w, &known, z->rule, k);
    for (int i = 0; ok && i < w.count; i++) {
        if (known)
            reciprocal_laurent_value(&z->weight[i], &w.weight[i], kappa, prec);
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
    result = reciprocal_set_down_to_zero(&kappa, numbers->k, numbers->prec) ? STATUS_OK : STATUS_NO_MEMORY;
    for (int i = 0; i < numbers->scheme->step_count; i++)
        for (int j = 0; result == STATUS_OK && j < numbers->steps[i].rule_count; j++)
            if (numbers->steps[i].rules[j].rule->at_centre)
                result = set_centre_weights(&numbers->steps[i].rules[j], &kappa, numbers->k, numbers->prec);
    affine_clear(&kappa);
    return result;
}

affine *block_without_constants(const block *b, long prec)
{
    affine *z = affine_array_new((size_t)(b->n - 1) * (size_t)(b->n - 1)), *to = z;
    for (int i = 1; z && i < b->n; i++)
        for (int j = 1; j < b->n; j++)
            affine_sub(to++, &b->entry[i * b->n + j], &b->entry[j], prec);
    return z;
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
        if (result == BLOCK_OK) {
            z->n = b.n - 1;
            z->entry = block_without_constants(&b, prec);
            result = z->entry ? BLOCK_OK : BLOCK_NO_MEMORY;
        }
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
