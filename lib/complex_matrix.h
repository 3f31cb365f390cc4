/* complex_matrix.h: square matrices of complex enclosures (rectangles), row by row.  Compiled once per number system. */
#ifndef LIB_COMPLEX_MATRIX_H
#define LIB_COMPLEX_MATRIX_H

#include "../bigfloat/number.h"

#define complex_matrix_make NUMBER_NAME(complex_matrix_make)
#define complex_matrix_free NUMBER_NAME(complex_matrix_free)
#define complex_matrix_multiply NUMBER_NAME(complex_matrix_multiply)
#define complex_matrix_thin NUMBER_NAME(complex_matrix_thin)
#define complex_magnitude_upper NUMBER_NAME(complex_magnitude_upper)

typedef struct {
    int n;
    number *re, *im; /* n * n each */
} complex_matrix;

bool complex_matrix_make(complex_matrix *z, int n); /* 0; false: no memory */
void complex_matrix_free(complex_matrix *z);
/* z = x y; z is neither of them. */
void complex_matrix_multiply(complex_matrix *z, const complex_matrix *x, const complex_matrix *y, long prec);
/* Replaces every entry by its midpoint. */
void complex_matrix_thin(complex_matrix *z, long prec);
/* z >= |re + i im|, thin: the sum of the parts' magnitudes. */
void complex_magnitude_upper(number *z, const number *re, const number *im, long prec);

#endif
