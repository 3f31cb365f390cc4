/* complex_matrix.c: what eigenvalues.c needs of complex matrices. */
#include "complex_matrix.h"

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

void complex_matrix_multiply(complex_matrix *z, const complex_matrix *x, const complex_matrix *y, long prec)
{
    int n = z->n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            number *re = &z->re[i * n + j], *im = &z->im[i * n + j];
            number_zero(re);
            number_zero(im);
            for (int l = 0; l < n; l++) {
                number_addmul(re, &x->re[i * n + l], &y->re[l * n + j], prec);
                number_submul(re, &x->im[i * n + l], &y->im[l * n + j], prec);
                number_addmul(im, &x->re[i * n + l], &y->im[l * n + j], prec);
                number_addmul(im, &x->im[i * n + l], &y->re[l * n + j], prec);
            }
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
