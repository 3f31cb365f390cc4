/* decomposition.h: the comparison constants of the thesis, exactly (lib/stability.md, 6).

   It takes b for B of lib/comparison.h, writes a - b = b (p_1 (1/z_1 - 1) + p_2 (1/z_2 - 1)) and bounds
   |(S_a - S_b) p| by C D(p).  This finds p_1 and p_2 by division with remainder, symmetrised, and checks the identity.
   For triangles only: the thesis has nothing else. */
#ifndef LIB_DECOMPOSITION_H
#define LIB_DECOMPOSITION_H

#include "comparison.h"

typedef struct {
    comparison printed; /* |S_(b p_1)| + |S_(b p_2)|, as the thesis defines C.  It is a bound where it is not below the
                           least constant (comparison_make), which nothing but comparing tells */
    comparison proved;  /* |S_(b_1 p_1)| + |S_(b_2 p_2)|, b_i = b / (1 + 1/z_i): always a bound */
    bool identity;      /* a - b is what the decompositions say, in all three cases: else nothing is known */
} decomposition;

void decomposition_init(decomposition *z);
void decomposition_clear(decomposition *z);
/* masks must be divisible, and those of a mesh of triangles. */
BIGFLOAT_MUST_USE bool decomposition_make(decomposition *z, const laurent *mask, const regular_masks *masks);

#endif
