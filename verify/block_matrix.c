/* block_matrix.c: a block as a real matrix, block 0 deflated by the vector of ones. */
#include "block_matrix.h"

#include "../lib/spectrum.h"

number *block_matrix_make(int *size, bool *complex_form, status *result, scheme_numbers *numbers, long m, diagnostic *d)
{
    block b;
    number *matrix = NULL;
    block_status made = block_make(&b, numbers, m, numbers->scheme->mirror_symmetric, d);
    *result = made == BLOCK_OK || made == BLOCK_NO_MEMORY ? STATUS_NO_MEMORY : STATUS_BAD_INPUT;
    if (made == BLOCK_OK && m > 0) {
        matrix = block_real_matrix(size, &b);
    } else if (made == BLOCK_OK) {
        *size = b.n - 1;
        matrix = number_array_new((size_t)*size * (size_t)*size);
        if (matrix)
            matrix_deflate(matrix, b.entry, NULL, b.n, 0, numbers->prec);
    }
    *complex_form = m > 0 && b.imaginary;
    block_free(&b);
    if (matrix)
        *result = STATUS_OK;
    return matrix;
}
