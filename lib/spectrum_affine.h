/* spectrum_affine.h: bounds for all eigenvalues of affine matrices, or for all but a known one (verify/certificate-valences.md, section
   4).  Compiled once per number system; affine sources may include it, too. */
#ifndef LIB_SPECTRUM_AFFINE_H
#define LIB_SPECTRUM_AFFINE_H

#include "../bigfloat/number.h"
#include "../bigfloat/affine.h"
#include "spectrum.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* spectral_contraction of the ranges of b, n x n. */
spectral_answer BASE_NAME(affine_contraction)(const affine *b, int n, const base_number *scale, int least, int limit, long prec);

/* Of the ranges of what is left of b beside the eigenvalue of its eigenvector x, x_pivot = 1 (NULL: the vector of ones): exactly the
   other eigenvalues (lib/spectrum.h, matrix_deflate). */
spectral_answer BASE_NAME(affine_rest_contraction)(const affine *b, const affine *x, int n, int pivot, const base_number *scale, int least, int limit, long prec);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define affine_contraction NUMBER_NAME(affine_contraction)
#define affine_rest_contraction NUMBER_NAME(affine_rest_contraction)
#endif

#endif
