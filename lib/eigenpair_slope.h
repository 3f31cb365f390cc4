/* eigenpair_slope.h: how an eigenvalue and its eigenvector change with a parameter.  Compiled once per number system. */
#ifndef LIB_EIGENPAIR_SLOPE_H
#define LIB_EIGENPAIR_SLOPE_H

#include "eigenpair.h"

#define eigenpair_slope NUMBER_NAME(eigenpair_slope)
#define eigenpair_slope_sharp NUMBER_NAME(eigenpair_slope_sharp)

/* Let b(u) be a family of n x n matrices, all of them in the enclosure b, and b(u) - b(v) in b_slope (u - v) for all u and v
   (as when b_slope encloses the derivatives), and let eigenpair_prove(box, choice, b) have answered TRUTH_TRUE.  Then b(u)
   has one pair (x(u), L(u)) in the box; slope receives, for n + 1 numbers (the pivot's is 0), enclosures of
   (x(u) - x(v)) / (u - v) and then of (L(u) - L(v)) / (u - v), and so of derivatives.
   TRUTH_UNKNOWN: none was found.  TRUTH_FALSE: no memory.

   Proof.  Let s and l be these quotients, d that of the matrices, in b_slope.  b(u) x(u) = L(u) x(u) and the same at v give

       (b(u) - L(u)) s - l x(v) = -d x(v),        s_pivot = 0,

   n equations for s and l with a matrix in G, the derivative of the equations on the box, and a right-hand side in -b_slope x.  With
   the preconditioner Y and E = 1 - Y G hence z = (s, l) = -Y d x + E z, and if |E| <= e < 1 in the row sum norm, |z| <= w = |Y d x| / (1 - e) in
   the maximum norm; then z_i lies in (-Y d x)_i +- w (the sum of |E_ij| over j).  (verify/certificate-valences.md, section 3.) */
truth eigenpair_slope(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, long prec);

/* The same, then improved by z = -Y d x + E z: where one component is much smaller than others.  (Certificates have it without.) */
truth eigenpair_slope_sharp(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, long prec);

#endif
