/* exact_block.c: the block by the sources that make it in enclosures, in exact numbers instead.  Compiled for these only. */
#include "exact_block.h"

#include "block.h"

/* Rows and columns from `skip` on; of block 0, minus those of the first unknown. */
static exact_block_status take_over(field_matrix *z, number_field *f, const block *b)
{
    int skip = b->m == 0, n = b->n - skip;
    exact_block_status result = EXACT_BLOCK_OK;
    number entry;
    if (n > EXACT_BLOCK_MAX_ORDER)
        return EXACT_BLOCK_NONE;
    number_init(&entry);
    field_matrix_init(z, f, n);
    for (int i = 0; !f->failed && i < n; i++)
        for (int j = 0; result == EXACT_BLOCK_OK && j < n; j++) {
            const number *first = &b->entry[(i + skip) * b->n + j + skip];
            if (skip)
                number_sub(&entry, first, &b->entry[j + skip], f->n);
            else
                number_set(&entry, first);
            if (entry.state != COSINES_KNOWN)
                result = number_lacks_memory(&entry) ? EXACT_BLOCK_NO_MEMORY : EXACT_BLOCK_NONE;
            else
                field_set_cosines(f, field_at(f, z->entry, (size_t)i * (size_t)n + (size_t)j), &entry);
        }
    number_clear(&entry);
    return f->failed ? EXACT_BLOCK_NONE : result;
}

exact_block_status exact_block_make(field_matrix *z, number_field *f, const scheme *s, long k, long m)
{
    scheme_numbers numbers;
    block b;
    diagnostic unused;
    exact_block_status result = EXACT_BLOCK_NONE;
    *z = (field_matrix){f, 0, NULL};
    if (m > 0 && !s->mirror_symmetric)
        return result;
    if (scheme_numbers_make(&numbers, s, k, f->n, &unused) == STATUS_OK) {
        block_status made = block_make(&b, &numbers, m, true, &unused);
        if (made == BLOCK_OK)
            result = take_over(z, f, &b);
        else if (made == BLOCK_NO_MEMORY)
            result = EXACT_BLOCK_NO_MEMORY;
        block_free(&b);
    }
    scheme_numbers_free(&numbers);
    return result;
}
