/* exact_block.h: a block of the subdivision matrix over a field of cosines (verify/exact.md, section 3). */
#ifndef LIB_EXACT_BLOCK_H
#define LIB_EXACT_BLOCK_H

#include "field_matrix.h"
#include "scheme.h"

typedef enum { EXACT_BLOCK_OK, EXACT_BLOCK_NONE, EXACT_BLOCK_NO_MEMORY } exact_block_status;

/* z = the block of frequency m, 0 <= m <= k/2, in the real form; for m = 0 without the eigenvalue 1 of the vector of ones.
   m >= 1: the scheme must be mirror-symmetric.  EXACT_BLOCK_NONE: an entry has no exact value in this field, or the block
   more than EXACT_BLOCK_MAX_ORDER rows, or the field has failed.  In any case field_matrix_clear. */
enum { EXACT_BLOCK_MAX_ORDER = 64 };
exact_block_status exact_block_make(field_matrix *z, number_field *f, const scheme *s, long k, long m);

#endif
