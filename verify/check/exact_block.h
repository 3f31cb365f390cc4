#ifndef CHECK_EXACT_BLOCK_H
#define CHECK_EXACT_BLOCK_H

/* Exact blocks: section 3 of exact.md. */

#include "field.h"
#include "sector.h"

/* The exact matrix M of a block in the real form, or (m = 0) the plain one without the constant
 * net: size x size, row by row.  What has no exact value in the field: rejected, at that line of
 * the certificate. */
struct exact_matrix {
    int size;
    struct number *entry;
};

struct exact_matrix exact_block(const struct block *block, const struct field *k, int line);

#endif
