/* interval_batch.h: the operations of interval.h on arrays.

   z[i] = x[i] op y[i] for i < n: the same doubles that interval_op gives inside a region, on every machine (the sign
   of a zero endpoint excepted).  The functions set and restore the rounding mode themselves and may be called anywhere,
   also inside a region.  z may be the same array as x or y, but must not overlap them partly.  On processors with
   AVX-512 the instructions carry their rounding themselves; which way is taken is decided at run time. */
#ifndef BIGFLOAT_INTERVAL_BATCH_H
#define BIGFLOAT_INTERVAL_BATCH_H

#include "interval.h"

void interval_batch_add(interval *z, const interval *x, const interval *y, size_t n);
void interval_batch_sub(interval *z, const interval *x, const interval *y, size_t n);
void interval_batch_mul(interval *z, const interval *x, const interval *y, size_t n);
void interval_batch_addmul(interval *z, const interval *x, const interval *y, size_t n); /* z[i] += x[i] y[i] */
void interval_batch_scale(interval *z, const interval *x, const interval *c, size_t n);  /* x[i] c */
void interval_batch_axpy(interval *z, const interval *x, const interval *c, size_t n);   /* z[i] += x[i] c */
/* *z = the sum of x[i] y[i].  The order of summation is fixed, but not from left to right. */
void interval_batch_dot(interval *z, const interval *x, const interval *y, size_t n);

/* z[j] += the sum of x[l] y[l n + j] over l < n (-= if negative), j < n, one l after the other: a row times an n x n matrix.
   In a region only.  z must not overlap x or y. */
void interval_batch_row(interval *z, const interval *x, const interval *y, size_t n, bool negative);

#endif
