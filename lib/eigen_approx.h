/* eigen_approx.h: linear algebra in plain doubles, to find what is then proved.

   Nothing here is rigorous and nothing needs to be: a poor answer makes a proof fail, never a false one.
   TRUTH_TRUE: found; TRUTH_UNKNOWN: not found; TRUTH_FALSE: no memory. */
#ifndef LIB_EIGEN_APPROX_H
#define LIB_EIGEN_APPROX_H

#include "../bigfloat/truth.h"

/* The eigenvalue of largest modulus of the n x n matrix b (row by row), if it is real and simple, and its
   eigenvector x, scaled so that its largest component, number *pivot, is 1. */
truth eigen_dominant_approx(double *eigenvalue, double *x, int *pivot, const double *b, int n);

/* The same for the complex matrix of order n/2 that the n x n matrix b = (R, -I; I, R) stands for: an eigenvalue that alone
   has the largest modulus, and its eigenvector (real parts, then imaginary ones), whose component *pivot is 1.  If I = 0 its
   conjugate may have it, too, and *im >= 0. */
truth eigen_dominant_complex_approx(double *re, double *im, double *x, int *pivot, const double *b, int n);

/* About the largest modulus of an eigenvalue of b (0 for n = 0).  NAN: no memory. */
double spectral_radius_approx(const double *b, int n);

/* inverse = the inverse of the n x n matrix a.  TRUTH_UNKNOWN: singular to
   working precision. */
truth matrix_inverse_approx(double *inverse, const double *a, int n);

#endif
