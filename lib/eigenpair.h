/* eigenpair.h: one simple real eigenvalue of a block and its eigenvector, found in doubles and proved by a Krawczyk
   step (verify/certificate.md, section 6).  Compiled once per number system. */
#ifndef LIB_EIGENPAIR_H
#define LIB_EIGENPAIR_H

#include "../bigfloat/number.h"
#include "eigenpair_choice.h"

#define eigenpair_choose NUMBER_NAME(eigenpair_choose)
#define eigenpair_prove NUMBER_NAME(eigenpair_prove)

/* Looks for the dominant eigenpair of the n x n matrix b and for a box round it that eigenpair_prove accepts,
   both on the grid 2^-g.
   TRUTH_UNKNOWN: not found.  TRUTH_FALSE: no memory. */
truth eigenpair_choose(eigenpair_choice *z, const number *b, int n, long g, long prec);

/* TRUTH_TRUE proves, for every matrix in the enclosure b: the box holds exactly one pair (x, eigenvalue) with
   b x = eigenvalue x and x_pivot = 1, and the eigenvalue is algebraically simple.  box receives enclosures of the
   n components of x (the pivot's is 1) and then of the eigenvalue: n + 1 numbers.  TRUTH_UNKNOWN: not proved,
   and box is no enclosure of anything.  TRUTH_FALSE: no memory. */
truth eigenpair_prove(number *box, const eigenpair_choice *choice, const number *b, long prec);

#endif
