/* block_matrix.h: what is left of a block beside the eigenvalue 1 of constant nets.  Compiled once per number system. */
#ifndef VERIFY_BLOCK_MATRIX_H
#define VERIFY_BLOCK_MATRIX_H

#include "../lib/block.h"

#define block_matrix_make NUMBER_NAME(block_matrix_make)

/* The real matrix of block m, 0 <= m <= k/2: in the real form if the scheme is mirror-symmetric, else in the complex one
   (then *complex_form, lib/eigenpair.h); for m = 0 without the eigenvalue 1.  size x size numbers, which the caller frees.
   NULL: *result says why. */
number *block_matrix_make(int *size, bool *complex_form, status *result, scheme_numbers *numbers, long m, diagnostic *d);

#endif
