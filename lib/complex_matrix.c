/* complex_matrix.c: what eigenvalues.c needs of complex matrices. */
#include "complex_matrix.h"

#include "matrix_row.h"

bool complex_matrix_make(complex_matrix *z, int n)
{
    z->n = n;
    z->re = number_array_new((size_t)n * (size_t)n);
    z->im = number_array_new((size_t)n * (size_t)n);
    return z->re && z->im;
}

void complex_matrix_free(complex_matrix *z)
{
    if (z->re)
        number_array_free(z->re, (size_t)z->n * (size_t)z->n);
    if (z->im)
        number_array_free(z->im, (size_t)z->n * (size_t)z->n);
    z->re = z->im = NULL;
}

static bool is_zero(const number *x, int count)
{
    for (int i = 0; i < count; i++)
        if (number_is_zero(&x[i]) != TRUTH_TRUE)
            return false;
    return true;
}

/* Where imaginary parts are exactly 0, as often they are, there is nothing to multiply. */
void complex_matrix_multiply(complex_matrix *z, const complex_matrix *x, const complex_matrix *y, long prec)
{
    int n = z->n;
    bool y_real = is_zero(y->im, n * n);
    for (int i = 0; i < n * n; i++) {
        number_zero(&z->re[i]);
        number_zero(&z->im[i]);
    }
    for (int i = 0; i < n; i++) {
        const number *re = &x->re[i * n], *im = &x->im[i * n];
        bool row_real = is_zero(im, n);
        matrix_add_row(&z->re[i * n], re, y->re, n, false, prec);
        if (!y_real)
            matrix_add_row(&z->im[i * n], re, y->im, n, false, prec);
        if (!row_real)
            matrix_add_row(&z->im[i * n], im, y->re, n, false, prec);
        if (!row_real && !y_real)
            matrix_add_row(&z->re[i * n], im, y->im, n, true, prec);
    }
}

void complex_matrix_thin(complex_matrix *z, long prec)
{
    for (int i = 0; i < z->n * z->n; i++) {
        number_midpoint(&z->re[i], &z->re[i], prec);
        number_midpoint(&z->im[i], &z->im[i], prec);
    }
}

void complex_magnitude_upper(number *z, const number *re, const number *im, long prec)
{
    number t;
    number_init(&t);
    number_magnitude_upper(&t, im, prec);
    number_magnitude_upper(z, re, prec);
    number_add(z, z, &t, prec);
    number_upper(z, z, prec);
    number_clear(&t);
}
