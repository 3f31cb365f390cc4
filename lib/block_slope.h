/* block_slope.h: blocks in the real form together with their derivatives by u = cos(w/2).  Compiled once per number
   system (bigfloat/number.h), by way of jets. */
#ifndef LIB_BLOCK_SLOPE_H
#define LIB_BLOCK_SLOPE_H

#include "block.h"

#if !defined(NUMBER_JET)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* Let B(u) be the block as a function of u, with the weights that the rules have at the frequencies of the range.
   entry and slope enclose B(u) and B'(u), n x n each, for all u of the interval, which lies within [0, 1]. */
typedef struct {
    int n;
    base_number *entry, *slope;
} BASE_NAME(block_slope);

/* Only for mirror-symmetric schemes, first >= 1.  A weight that is not the same at all frequencies of the range makes
   the slopes indeterminate.  On any status block_slope_free. */
block_status BASE_NAME(block_slope_make)(BASE_NAME(block_slope) *z, const scheme *s, long k, frequencies m, const base_number *u, long prec, diagnostic *d);
void BASE_NAME(block_slope_free)(BASE_NAME(block_slope) *z);

#if !defined(NUMBER_JET)
#undef base_number
#undef BASE_NAME
#define block_slope NUMBER_NAME(block_slope)
#define block_slope_make NUMBER_NAME(block_slope_make)
#define block_slope_free NUMBER_NAME(block_slope_free)
#endif

#endif
