/* block_slope.c: a block of jets, taken apart.  Compiled for jets of each number system. */
#include "block_slope.h"

#include <string.h>

#define block_slope BASE_NAME(block_slope)

static block_status take_apart(block_slope *z, const block *b)
{
    size_t size = (size_t)b->n * (size_t)b->n;
    z->n = b->n;
    z->entry = base_array_new(size);
    z->slope = base_array_new(size);
    if (!z->entry || !z->slope)
        return BLOCK_NO_MEMORY;
    for (size_t i = 0; i < size; i++) {
        base_set(&z->entry[i], &b->entry[i].value);
        base_set(&z->slope[i], &b->entry[i].slope);
    }
    return BLOCK_OK;
}

block_status BASE_NAME(block_slope_make)(block_slope *z, const scheme *s, long k, frequencies m, const base_number *u, long prec, diagnostic *d)
{
    scheme_numbers numbers;
    block b;
    jet variable;
    block_status result = BLOCK_NO_MEMORY;
    status made = scheme_numbers_make(&numbers, s, k, prec, d);
    memset(z, 0, sizeof *z);
    if (made == STATUS_OK) {
        jet_init(&variable);
        jet_variable(&variable, u);
        result = block_make_at(&b, &numbers, m, &variable, d);
        if (result == BLOCK_OK)
            result = take_apart(z, &b);
        block_free(&b);
        jet_clear(&variable);
    } else if (made == STATUS_BAD_INPUT) {
        result = BLOCK_BAD_INPUT;
    }
    scheme_numbers_free(&numbers);
    return result;
}

void BASE_NAME(block_slope_free)(block_slope *z)
{
    size_t size = (size_t)z->n * (size_t)z->n;
    base_array_free(z->entry, size);
    base_array_free(z->slope, size);
    memset(z, 0, sizeof *z);
}
