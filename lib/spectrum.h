/* spectrum.h: bounds for all eigenvalues of a matrix, or for all but a known one (verify/certificate.md, section 6).
   Compiled once per number system. */
#ifndef LIB_SPECTRUM_H
#define LIB_SPECTRUM_H

#include "../bigfloat/number.h"

#define matrix_deflate NUMBER_NAME(matrix_deflate)
#define matrix_deflate_complex NUMBER_NAME(matrix_deflate_complex)
#define matrix_deflate_pair NUMBER_NAME(matrix_deflate_pair)
#define spectral_contraction NUMBER_NAME(spectral_contraction)
#define spectral_contraction_sharp NUMBER_NAME(spectral_contraction_sharp)

/* z, (n-1) x (n-1), = b without the eigenvalue of the eigenvector x, x_pivot = 1: b_ij - x_i b_pivot,j, row and
   column `pivot` removed.  Exactly the other eigenvalues remain.  x = NULL is the vector of ones.  z is not b. */
void matrix_deflate(number *z, const number *b, const number *x, int n, int pivot, long prec);

/* The same for the complex matrix that b = (R, -I; I, R), n x n, stands for (lib/eigenpair.h), and its eigenvector x, n
   numbers, x_pivot = 1, pivot < n/2: z, (n-2) x (n-2), is the real matrix of the complex one without that eigenvalue.
   Its eigenvalues are the other ones, and their conjugates. */
void matrix_deflate_complex(number *z, const number *b, const number *x, int n, int pivot, long prec);

/* For b = (A, 0; 0, A), n x n, A real, and the eigenvector x = a + i b of an eigenvalue of A that is not real, n numbers, real parts
   first, x_pivot = 1, pivot, second < n/2: z, (n/2-2) x (n/2-2), is A without that eigenvalue and its conjugate, rows and
   columns `pivot` and `second` removed.  The imaginary part of x_second must not be 0. */
void matrix_deflate_pair(number *z, const number *b, const number *x, int n, int pivot, int second, long prec);

/* (lib/stop.h: an answer that does not contract may have been given for want of time.) */
typedef struct {
    truth contracts; /* TRUTH_FALSE: no memory */
    int power;
    bool diverges;   /* a hint: some entry has certainly grown so much that more precision will hardly help */
    double radius;   /* whether it contracts or not, every eigenvalue of b is at most radius/scale in modulus */
} spectral_answer;

/* Let C = scale b, n x n, scale thin.  Squares C up to `limit` times, until the largest row sum of magnitudes is
   below 1 (at least `least` times).  contracts = TRUTH_TRUE proves that every eigenvalue of b, for all matrices in
   the enclosure, is smaller than 1/scale in modulus, by C^(2^power). */
spectral_answer spectral_contraction(const number *b, const number *scale, int n, int least, int limit, long prec);

/* The same, with `least` = 0; if it contracts with few squarings, some more are done for a better radius. */
spectral_answer spectral_contraction_sharp(const number *b, const number *scale, int n, int limit, long prec);

#endif
