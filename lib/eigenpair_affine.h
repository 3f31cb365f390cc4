/* eigenpair_affine.h: the eigenpair of an affine matrix as affine numbers (verify/certificate-valences.md, section 3).
   Compiled once per number system; affine sources may include it, too. */
#ifndef LIB_EIGENPAIR_AFFINE_H
#define LIB_EIGENPAIR_AFFINE_H

#include "../bigfloat/number.h"
#include "../bigfloat/affine.h"
#include "eigenpair_choice.h"
#include "spectrum.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* Looks for a pair, its radius and its range, on the grid 2^-g, that eigenpair_affine_prove accepts: that of the centres whose
   eigenvalue has the largest modulus.  The answers are those of eigenpair_choose. */
truth BASE_NAME(eigenpair_affine_choose)(eigenpair_choice *z, const affine *b, int n, long g, long prec);

/* Let b, n x n, enclose matrices.  TRUTH_TRUE proves: each has exactly one pair (x, L) in the box of radius choice->range round the
   approximation, x_pivot = 1, and L is algebraically simple; box receives, n + 1 numbers, affine enclosures of the
   components of x and then of L.  If b is sloped (bigfloat/affine.h), so are they.
   TRUTH_UNKNOWN: not proved, and box is no enclosure of anything.  TRUTH_FALSE: no memory. */
truth BASE_NAME(eigenpair_affine_prove)(affine *box, const eigenpair_choice *choice, const affine *b, int n, long prec);

/* The ranges of what is left of b beside the eigenvalue of its eigenvector x, x_pivot = 1: (n-1) x (n-1), with exactly the other
   eigenvalues (lib/spectrum.h, matrix_deflate). */
void BASE_NAME(affine_deflate)(base_number *z, const affine *b, const affine *x, int n, int pivot, long prec);

/* The spectral_contraction of these. */
spectral_answer BASE_NAME(affine_contract_rest)(const affine *b, const affine *x, int n, int pivot, const base_number *scale, int least, int most, long prec);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define eigenpair_affine_choose NUMBER_NAME(eigenpair_affine_choose)
#define eigenpair_affine_prove NUMBER_NAME(eigenpair_affine_prove)
#define affine_deflate NUMBER_NAME(affine_deflate)
#define affine_contract_rest NUMBER_NAME(affine_contract_rest)
#endif

#endif
