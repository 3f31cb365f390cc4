/* components.h: which unknowns of a matrix depend on each other.

   Draw an arrow from i to j wherever entry (i,j) is not exactly 0.  Two indices share a *component* if each can be reached
   from the other.  With its components put in order of reachability, the matrix is block triangular with one block to a
   component (the Frobenius normal form), so its characteristic polynomial is the product of theirs. */
#ifndef LIB_COMPONENTS_H
#define LIB_COMPONENTS_H

#include "../bigfloat/integer.h"

/* component[i] = the least index in the component of i; arrow is n x n, row by row.  false: no memory. */
BIGFLOAT_MUST_USE bool components_find(int *component, const bool *arrow, int n);

#endif
