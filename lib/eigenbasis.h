/* eigenbasis.h: a matrix in a basis in which it is nearly diagonal (lib/eigenvalues.md).  Compiled once per number system.

   The basis v is one of approximate eigenvectors, of approximate Schur vectors within a *group* of eigenvalues that lie so
   close together that eigenvectors would be ill-conditioned: there v^-1 b v is nearly a small triangle. */
#ifndef LIB_EIGENBASIS_H
#define LIB_EIGENBASIS_H

#include "complex_matrix.h"

#define eigenbasis_enclose NUMBER_NAME(eigenbasis_enclose)

/* m contains v^-1 b v for some invertible v and every real n x n matrix b in re, or complex one in re + i im (im = NULL:
   real).  group[i] = the least index in the group of i.  m is made by the caller, n x n.
   TRUTH_UNKNOWN: no basis found at this precision, m means nothing; TRUTH_FALSE: no memory. */
truth eigenbasis_enclose(complex_matrix *m, int *group, const number *re, const number *im, int n, long prec);

#endif
