/* matrix_row.h: a row times a matrix, by what each number system does best.  For generic sources: include number.h
   first. */
#ifndef LIB_MATRIX_ROW_H
#define LIB_MATRIX_ROW_H

#include "../bigfloat/number.h"

#if defined(NUMBER_INTERVAL)
#include "../bigfloat/interval_batch.h"
#endif

/* z_j += x_0 y_0j + ... + x_(n-1) y_(n-1)j (minus, if `negative`), j < n; z is not x, and not in y.  On grids each
   product is rounded and the sum exact, so its order does not matter. */
static inline void matrix_add_row(number *z, const number *x, const number *y, int n, bool negative, long prec)
{
#if defined(NUMBER_BALL)
    number sum;
    number_init(&sum);
    for (int j = 0; j < n; j++) {
        ball_dot_strided(&sum, x, 1, y + j, n, (size_t)n, prec);
        (negative ? number_sub : number_add)(&z[j], &z[j], &sum, prec);
    }
    number_clear(&sum);
#elif defined(NUMBER_INTERVAL)
    (void)prec;
    interval_batch_row(z, x, y, (size_t)n, negative);
#else
    for (int l = 0; l < n; l++)
        for (int j = 0; j < n; j++)
            if (negative)
                number_submul(&z[j], &x[l], &y[l * n + j], prec);
            else
                number_addmul(&z[j], &x[l], &y[l * n + j], prec);
#endif
}

#endif
