/* schur_approx.h: approximate block diagonalisation of complex matrices in plain doubles.

   Nothing here is rigorous and nothing needs to be: it suggests a basis in which eigenvalues.c then encloses them. */
#ifndef LIB_SCHUR_APPROX_H
#define LIB_SCHUR_APPROX_H

#include <complex.h>
#include <stdbool.h>

/* Finds v, n x n, such that v^-1 a v is about upper triangular, with entries off the diagonal only between eigenvalues
   that lie closer together than `distance`; and w, about v^-1.  cluster[i] numbers the groups of close eigenvalues
   from 0, each a run of neighbours on the diagonal... in no special order.  a is destroyed and holds that triangle.
   false: no convergence, or no memory. */
bool block_diagonalise_approx(double complex *v, double complex *w, int *cluster, double complex *a, int n, double distance);

#endif
