/* spectrum_affine.c: deflation in affine numbers, contraction of ranges. */
#include "spectrum_affine.h"

#include <math.h>

spectral_answer affine_contraction(const affine *b, int n, const number *scale, int least, int limit, long prec)
{
    spectral_answer z = {TRUTH_FALSE, 0, false, INFINITY};
    size_t size = (size_t)n * (size_t)n;
    number *range = number_array_new(size);
    for (size_t i = 0; range && i < size; i++)
        affine_range(&range[i], &b[i], prec);
    if (range)
        z = spectral_contraction(range, scale, n, least, limit, prec);
    number_array_free(range, size);
    return z;
}

/* z, (n-1) x (n-1), = b_ij - x_i b_pivot,j. */
static void deflate(affine *z, const affine *b, const affine *x, int n, int pivot, long prec)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            if (i == pivot || j == pivot)
                continue;
            if (x)
                affine_mul(z, &x[i], &b[pivot * n + j], prec);
            else
                affine_set(z, &b[pivot * n + j]);
            affine_sub(z, &b[i * n + j], z, prec);
            z++;
        }
}

spectral_answer affine_rest_contraction(const affine *b, const affine *x, int n, int pivot, const number *scale, int least, int limit, long prec)
{
    spectral_answer z = {TRUTH_FALSE, 0, false, INFINITY};
    size_t size = (size_t)(n - 1) * (size_t)(n - 1);
    affine *rest = affine_array_new(size);
    if (rest) {
        deflate(rest, b, x, n, pivot, prec);
        z = affine_contraction(rest, n - 1, scale, least, limit, prec);
    }
    affine_array_free(rest, size);
    return z;
}
