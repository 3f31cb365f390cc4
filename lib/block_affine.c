/* block_affine.c: u over an arc, and the block there.  Compiled for affine numbers of each system. */
#include "block_affine.h"

#include <string.h>

#define affine_matrix BASE_NAME(affine_matrix)

bool affine_cosine(affine *u, const arc *r, long prec)
{
    base_number low, high;
    base_init(&low);
    base_init(&high);
    base_cos_pi(&low, &r->high, prec);
    base_cos_pi(&high, &r->low, prec);
    base_hull(&low, &low, &high, prec);
    affine_spread(u, &low, prec);
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

void BASE_NAME(affine_matrix_free)(affine_matrix *z)
{
    affine_array_free(z->entry, (size_t)z->n * (size_t)z->n);
    memset(z, 0, sizeof *z);
}
