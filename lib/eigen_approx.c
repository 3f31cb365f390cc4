/* eigen_approx.c: power iteration, or the complex Schur form, sharpened by inverse iteration. */
#include "eigen_approx.h"

#include "schur_approx.h"
#include "stop.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define POWER_STEPS 400
#define INVERSE_STEPS 4
#define SQUARINGS 40
/* How well a vector that powers have reached is one of the eigenvalue's, compared with it: better than this if no other
   eigenvalue comes closer than by 7 %, and otherwise it may be anything. */
#define CONVERGED 0x1p-44

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
        if (stop_now())
            return false;
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

static double largest_entry(const double *c, size_t size)
{
    double norm = 0;
    for (size_t i = 0; i < size; i++)
        norm = fmax(norm, fabs(c[i]));
    return norm;
}

/* c = c c */
static void square(double *c, double *work, int n)
{
    memset(work, 0, (size_t)n * (size_t)n * sizeof *work);
    for (int i = 0; i < n; i++)
        for (int l = 0; l < n; l++) /* outside, so that sums need not wait for each other */
            for (int j = 0; j < n; j++)
                work[i * n + j] += c[i * n + l] * c[l * n + j];
    memcpy(c, work, (size_t)n * (size_t)n * sizeof *c);
}

/* Is b x about eigenvalue x? */
static bool has_converged(double eigenvalue, const double *x, double *y, const double *b, int n)
{
    double rest = 0;
    multiply(y, b, x, n);
    for (int i = 0; i < n; i++)
        rest = fmax(rest, fabs(y[i] - eigenvalue * x[i]));
    return rest <= CONVERGED * fabs(eigenvalue);
}

/* x = b^(2^40) x, for an eigenvalue that another one comes close to. */
static bool power_by_squaring(double *eigenvalue, double *x, double *y, double *c, double *work, const double *b, int n)
{
    size_t size = (size_t)n * (size_t)n;
    bool ok = true;
    memcpy(c, b, size * sizeof *c);
    for (int step = 0; ok && step < SQUARINGS && !stop_now(); step++) {
        double norm = largest_entry(c, size);
        ok = norm > 0 && isfinite(norm);
        for (size_t i = 0; ok && i < size; i++)
            c[i] /= norm;
        square(c, work, n);
    }
    multiply(y, c, x, n);
    ok = ok && normalise(y, n);
    memcpy(x, y, (size_t)n * sizeof *x);
    multiply(y, b, x, n);
    *eigenvalue = y[largest(x, n)] / x[largest(x, n)];
    return ok;
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
    size_t square_size = (size_t)n * (size_t)n;
    double *work = malloc((2 * square_size + (size_t)n) * sizeof *work);
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
    if (ok && !has_converged(*eigenvalue, x, y, b, n))
        ok = power_by_squaring(eigenvalue, x, y, work + n, work + n + square_size, b, n);
    for (int step = 0; ok && step < INVERSE_STEPS; step++)
        if (!sharpen(eigenvalue, x, y, work + n, work + n + square_size, b, n))
            break; /* the shift hit the eigenvalue: it is good already */
    if (ok)
        *pivot = largest(x, n);
    free(work);
    return ok && isfinite(*eigenvalue) ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

/* ---- complex matrices, embedded ---- */

/* Moduli that differ by less than this share are taken to be equal. */
#define TIED 0x1p-36
/* Eigenvalues closer together than this share of the largest entry stay in one triangle: all that is asked for are
   the diagonals of the triangles. */
#define CLOSE 0x1p-10

static bool list_eigenvalues(double complex *eigenvalue, double complex *work, int *cluster, const double *b, int h)
{
    double complex *a = work, *v = work + h * h, *w = work + 2 * h * h;
    double norm = 0;
    for (int i = 0; i < h * h; i++) {
        int at = i / h * 2 * h + i % h;
        a[i] = b[at] + I * b[at + 2 * h * h];
        norm = fmax(norm, cabs(a[i]));
    }
    if (!isfinite(norm) || !block_diagonalise_approx(v, w, cluster, a, h, norm * CLOSE))
        return false;
    for (int i = 0; i < h; i++)
        eigenvalue[i] = a[i * h + i];
    return true;
}

/* Eigenvalues of a pair are farther from the real axis than this share of them. */
#define NOT_REAL 0x1p-20

/* Is the matrix (A, 0; 0, A)? */
static bool is_doubled(const double *b, int h)
{
    for (int i = 0; i < h; i++)
        for (int j = 0; j < h; j++)
            if (b[i * 2 * h + j + h] != 0)
                return false;
    return true;
}

/* Are they conjugates of each other, and not real? */
static bool are_conjugate(double complex x, double complex y)
{
    double near = cabs(x) * NOT_REAL;
    return fabs(cimag(x)) > near && cabs(x - conj(y)) < near;
}

/* The eigenvalue that alone has the largest modulus; of a real matrix also one of a pair that has it, that with the positive
   imaginary part.  0: there is none. */
static double complex find_dominant(const double complex *eigenvalue, int h, bool real)
{
    int best = 0;
    for (int i = 1; i < h; i++)
        if (cabs(eigenvalue[i]) > cabs(eigenvalue[best]))
            best = i;
    for (int i = 0; i < h; i++) {
        bool tied = i != best && cabs(eigenvalue[i]) >= cabs(eigenvalue[best]) * (1 - TIED);
        if (tied && !(real && are_conjugate(eigenvalue[best], eigenvalue[i])))
            return 0;
    }
    return real && cimag(eigenvalue[best]) < 0 ? conj(eigenvalue[best]) : eigenvalue[best];
}

/* Scales x by a complex number so that its largest component is 1; false if it is 0 or not finite. */
static bool normalise_complex(int *pivot, double *x, int h)
{
    double complex scale;
    *pivot = 0;
    for (int i = 1; i < h; i++)
        if (hypot(x[i], x[i + h]) > hypot(x[*pivot], x[*pivot + h]))
            *pivot = i;
    scale = x[*pivot] + I * x[*pivot + h];
    if (scale == 0 || !isfinite(cabs(scale)))
        return false;
    for (int i = 0; i < h; i++) {
        double complex z = (x[i] + I * x[i + h]) / scale;
        x[i] = creal(z);
        x[i + h] = cimag(z);
    }
    return true;
}

/* One step of inverse iteration, as in sharpen. */
static bool sharpen_complex(double complex *eigenvalue, double *x, int *pivot, double *y, double *shifted, double *inverse, const double *b, int n)
{
    int h = n / 2;
    double complex shift = *eigenvalue * (1 + 1e-12) + 1e-300;
    memcpy(shifted, b, (size_t)n * (size_t)n * sizeof *b);
    for (int i = 0; i < h; i++) {
        shifted[i * n + i] -= creal(shift);
        shifted[(i + h) * n + i + h] -= creal(shift);
        shifted[i * n + i + h] += cimag(shift);
        shifted[(i + h) * n + i] -= cimag(shift);
    }
    if (!invert(inverse, shifted, n))
        return false;
    multiply(y, inverse, x, n);
    if (!normalise_complex(pivot, y, h))
        return false;
    memcpy(x, y, (size_t)n * sizeof *x);
    multiply(y, b, x, n);
    *eigenvalue = y[*pivot] + I * y[*pivot + h];
    return true;
}

truth eigen_dominant_complex_approx(double *re, double *im, double *x, int *pivot, const double *b, int n)
{
    int h = n / 2;
    size_t square = (size_t)n * (size_t)n;
    double *work = malloc((2 * square + (size_t)n) * sizeof *work);
    double complex *many = malloc(((size_t)h * (size_t)h * 3 + (size_t)h) * sizeof *many), eigenvalue = 0;
    int *cluster = malloc((size_t)h * sizeof *cluster);
    truth found = TRUTH_FALSE;
    if (work && many && cluster) {
        bool ok = list_eigenvalues(many, many + h, cluster, b, h);
        eigenvalue = ok ? find_dominant(many, h, is_doubled(b, h)) : 0;
        ok = eigenvalue != 0;
        for (int i = 0; i < n; i++)
            x[i] = 1 + 0.37 * i / n; /* a vector in no special position */
        for (int step = 0; ok && step < INVERSE_STEPS; step++)
            if (!sharpen_complex(&eigenvalue, x, pivot, work, work + n, work + n + square, b, n))
                ok = step > 0; /* the shift hit the eigenvalue: it is good already */
        found = ok && isfinite(cabs(eigenvalue)) ? TRUTH_TRUE : TRUTH_UNKNOWN;
    }
    *re = creal(eigenvalue);
    *im = cimag(eigenvalue);
    free(work);
    free(many);
    free(cluster);
    return found;
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
        double norm = largest_entry(c, size);
        if (norm == 0 || !isfinite(norm)) {
            free(c); /* a late 0 is a Jordan block that cancelled to the last digit: what was divided out stands */
            return norm == 0 && step > 10 ? exp(logarithm) : norm;
        }
        logarithm += share * log(norm);
        share /= 2;
        for (size_t i = 0; i < size; i++)
            c[i] /= norm;
        square(c, d, n);
    }
    free(c);
    return exp(logarithm);
}
