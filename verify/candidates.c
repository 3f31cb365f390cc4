/* candidates.c: spectral radii in doubles, of all blocks or, where there are many, of some and then of those near the
   largest. */
#include "candidates.h"

#include "block_matrix.h"

#include "../lib/eigen_approx.h"

#include <math.h>
#include <stdlib.h>

/* Blocks looked at in one pass over a range. */
#define PASS 1500
/* Smaller ones by more than this part of the largest are none: doubles of simple eigenvalues, and of multiple ones. */
#define NEARNESS 1e-6
#define VAGUE_NEARNESS 1e-2
/* Of the numbers from which the doubles are taken. */
#define PRECISION 64

#define find NUMBER_NAME(candidates_find_blocks)
status find(candidates *z, const scheme *s, long k, diagnostic *d);

/* NAN: no memory. */
static double radius_of(const number *matrix, int n)
{
    double *approximation = malloc(((size_t)n * (size_t)n + 1) * sizeof *approximation), radius = NAN;
    for (int i = 0; approximation && i < n * n; i++)
        approximation[i] = number_mid_approx(&matrix[i]);
    if (approximation)
        radius = spectral_radius_approx(approximation, n);
    free(approximation);
    return radius;
}

/* Of block m, without the eigenvalue 1 of the vector of ones. */
static status measure(double *radius, scheme_numbers *numbers, long m, diagnostic *d)
{
    int n;
    bool complex_form;
    status result;
    number *matrix = block_matrix_make(&n, &complex_form, &result, numbers, m, d);
    *radius = 0;
    if (matrix) {
        *radius = radius_of(matrix, n);
        number_array_free(matrix, (size_t)n * (size_t)n);
    }
    return result;
}

static void enter(candidates *z, long m, double radius)
{
    int at = z->count;
    for (int i = 0; i < z->count; i++)
        if (z->frequency[i] == m)
            return;
    while (at > 0 && z->radius[at - 1] < radius)
        at--;
    if (at == CANDIDATES_MAX)
        return;
    if (z->count < CANDIDATES_MAX)
        z->count++;
    for (int i = z->count - 1; i > at; i--) {
        z->radius[i] = z->radius[i - 1];
        z->frequency[i] = z->frequency[i - 1];
    }
    z->radius[at] = radius;
    z->frequency[at] = m;
}

/* Every `step`-th block of a range. */
static status pass(candidates *z, scheme_numbers *numbers, long first, long last, long step, diagnostic *d)
{
    status result = STATUS_OK;
    for (long m = first; result == STATUS_OK && m <= last; m += step) {
        double radius;
        result = measure(&radius, numbers, m, d);
        if (isnan(radius))
            result = STATUS_NO_MEMORY;
        if (result == STATUS_OK)
            enter(z, m, radius);
        if (result == STATUS_OK && m == 0)
            z->radius_of_zero = radius;
        if (result == STATUS_OK && m > 0 && 2 * m < numbers->k.first && radius > z->radius_of_pair) {
            z->pair = m;
            z->radius_of_pair = radius;
        }
        if (last - m < step && m != last)
            m = last - step; /* the last one, too */
    }
    return result;
}

status find(candidates *z, const scheme *s, long k, diagnostic *d)
{
    scheme_numbers numbers;
    long first = 0, last = k / 2, step;
    status result = scheme_numbers_make(&numbers, s, k, PRECISION, d);
    z->count = 0;
    z->radius_of_pair = z->radius_of_zero = 0;
    if (result == STATUS_OK)
        result = measure(&z->radius_of_one, &numbers, 1, d);
    if (result == STATUS_OK && isnan(z->radius_of_one))
        result = STATUS_NO_MEMORY;
    do {
        long best;
        step = (last - first) / PASS + 1;
        if (result == STATUS_OK)
            result = pass(z, &numbers, first, last, step, d);
        best = z->count ? z->frequency[0] : 0;
        first = best - step > 0 ? best - step : 0;
        last = best + step < k / 2 ? best + step : k / 2;
    } while (result == STATUS_OK && step > 1);
    while (z->count > 1 && !(z->radius[z->count - 1] >= z->radius[0] * (1 - VAGUE_NEARNESS)))
        z->count--;
    for (z->near = z->count; z->near > 1 && !(z->radius[z->near - 1] >= z->radius[0] * (1 - NEARNESS)); z->near--)
        ;
    z->near = z->near > CANDIDATES_MAX_NEAR ? CANDIDATES_MAX_NEAR : z->near;
    scheme_numbers_free(&numbers);
    return result;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
status NUMBER_NAME(candidates_find)(candidates *z, const scheme *s, long k, diagnostic *d)
{
    number_mode mode = number_enter();
    status result = find(z, s, k, d);
    number_leave(mode);
    return result;
}
