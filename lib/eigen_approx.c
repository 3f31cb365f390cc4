/* eigen_approx.c: power iteration, sharpened by inverse iteration. */
#include "eigen_approx.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define POWER_STEPS 400
#define INVERSE_STEPS 4
#define SQUARINGS 40

static int largest(const double *x, int n)
{
    int best = 0;
    for (int i = 1; i < n; i++)
        if (fabs(x[i]) > fabs(x[best]))
            best = i;
    return best;
}

static void multiply(double *y, const double *b, const double *x, int n)
{
    for (int i = 0; i < n; i++) {
        y[i] = 0;
        for (int j = 0; j < n; j++)
            y[i] += b[i * n + j] * x[j];
    }
}

/* Scales x so that its largest component is 1; false if it is 0 or not finite. */
static bool normalise(double *x, int n)
{
    double scale = x[largest(x, n)];
    if (scale == 0 || !isfinite(scale))
        return false;
    for (int i = 0; i < n; i++)
        x[i] /= scale;
    return true;
}

/* Gauss-Jordan with row pivoting on [a | inverse]; a is destroyed. */
static bool invert(double *inverse, double *a, int n)
{
    for (int i = 0; i < n * n; i++)
        inverse[i] = i % (n + 1) == 0;
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c + 1; i < n; i++)
            if (fabs(a[i * n + c]) > fabs(a[p * n + c]))
                p = i;
        if (a[p * n + c] == 0 || !isfinite(a[p * n + c]))
            return false;
        for (int j = 0; j < n; j++) {
            double t = a[c * n + j], s = inverse[c * n + j];
            a[c * n + j] = a[p * n + j];
            a[p * n + j] = t;
            inverse[c * n + j] = inverse[p * n + j];
            inverse[p * n + j] = s;
        }
        double scale = 1 / a[c * n + c];
        for (int j = 0; j < n; j++) {
            a[c * n + j] *= scale;
            inverse[c * n + j] *= scale;
        }
        for (int i = 0; i < n; i++) {
            double factor = a[i * n + c];
            for (int j = 0; i != c && j < n; j++) {
                a[i * n + j] -= factor * a[c * n + j];
                inverse[i * n + j] -= factor * inverse[c * n + j];
            }
        }
    }
    return true;
}

truth matrix_inverse_approx(double *inverse, const double *a, int n)
{
    size_t size = (size_t)n * (size_t)n * sizeof *a;
    double *work = malloc(size);
    bool ok;
    if (!work)
        return TRUTH_FALSE;
    memcpy(work, a, size);
    ok = invert(inverse, work, n);
    free(work);
    return ok ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

/* One step of inverse iteration with a shift close to the eigenvalue: x and the eigenvalue improve. */
static bool sharpen(double *eigenvalue, double *x, double *y, double *shifted, double *inverse, const double *b, int n)
{
    int p;
    memcpy(shifted, b, (size_t)n * (size_t)n * sizeof *b);
    for (int i = 0; i < n; i++)
        shifted[i * n + i] -= *eigenvalue * (1 + 1e-12) + 1e-300;
    if (!invert(inverse, shifted, n))
        return false;
    multiply(y, inverse, x, n);
    if (!normalise(y, n))
        return false;
    memcpy(x, y, (size_t)n * sizeof *x);
    multiply(y, b, x, n);
    p = largest(x, n);
    *eigenvalue = y[p] / x[p];
    return true;
}

truth eigen_dominant_approx(double *eigenvalue, double *x, int *pivot, const double *b, int n)
{
    size_t square = (size_t)n * (size_t)n;
    double *work = malloc((2 * square + (size_t)n) * sizeof *work);
    double *y = work;
    bool ok = true;
    if (!work)
        return TRUTH_FALSE;
    for (int i = 0; ok && i < n; i++)
        x[i] = 1 + 0.37 * i / n; /* a vector in no special position */
    for (int step = 0; ok && step < POWER_STEPS; step++) {
        multiply(y, b, x, n);
        *eigenvalue = y[largest(x, n)] / x[largest(x, n)];
        ok = normalise(y, n);
        memcpy(x, y, (size_t)n * sizeof *x);
    }
    for (int step = 0; ok && step < INVERSE_STEPS; step++)
        if (!sharpen(eigenvalue, x, y, work + n, work + n + square, b, n))
            break; /* the shift hit the eigenvalue: it is good already */
    if (ok)
        *pivot = largest(x, n);
    free(work);
    return ok && isfinite(*eigenvalue) ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

/* c^(2^40), scaled to norm 1 after every squaring: what was divided out is the spectral radius. */
double spectral_radius_approx(const double *b, int n)
{
    size_t size = (size_t)n * (size_t)n;
    double *c = malloc((2 * size + 1) * sizeof *c), *d = c + size;
    double logarithm = 0, share = 1;
    if (!c)
        return NAN;
    memcpy(c, b, size * sizeof *c);
    for (int step = 0; step < SQUARINGS; step++) {
        double norm = 0;
        for (size_t i = 0; i < size; i++)
            norm = fmax(norm, fabs(c[i]));
        if (norm == 0 || !isfinite(norm)) {
            free(c); /* a late 0 is a Jordan block that cancelled to the last digit: what was divided out stands */
            return norm == 0 && step > 10 ? exp(logarithm) : norm;
        }
        logarithm += share * log(norm);
        share /= 2;
        for (size_t i = 0; i < size; i++)
            c[i] /= norm;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                d[i * n + j] = 0;
                for (int l = 0; l < n; l++)
                    d[i * n + j] += c[i * n + l] * c[l * n + j];
            }
        memcpy(c, d, size * sizeof *c);
    }
    free(c);
    return exp(logarithm);
}
