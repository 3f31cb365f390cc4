/* eigenpair_slope.h: how an eigenvalue and its eigenvector change with a parameter.  Compiled once per number system. */
#ifndef LIB_EIGENPAIR_SLOPE_H
#define LIB_EIGENPAIR_SLOPE_H

#include "eigenpair.h"

#define eigenpair_slope NUMBER_NAME(eigenpair_slope)

/* Let b(u) be a differentiable family of n x n matrices, all of them in the enclosure b, their derivatives in b_slope, and
   let eigenpair_prove(box, choice, b) have answered TRUTH_TRUE.  Then b(u) has one pair (x(u), L(u)) in the box, both
   differentiable; slope receives enclosures of x'(u) (the pivot's is 0) and then L'(u) for all u: n + 1 numbers.
   TRUTH_UNKNOWN: none was found.  TRUTH_FALSE: no memory.

   Proof.  The equations F(z, u) = b(u) x - L x = 0, z = (x without x_pivot, L), have a derivative G by z that is
   non-singular in the box, so z(u) is differentiable and G z' + b'(u) x = 0.  With the preconditioner Y and E = 1 - Y G
   hence z' = s + E z', s = -Y b' x.  If |E| <= q < 1 in the row sum norm, |z'| <= |s| / (1 - q) in the maximum norm;
   putting an enclosure of z' into the right-hand side gives another one. */
truth eigenpair_slope(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, long prec);

#endif
