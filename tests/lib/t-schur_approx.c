/* t-schur_approx.c: the quality of the approximate block diagonalisation, over random matrices. */
#include "lib/schur_approx.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"

enum { MOST = 14 };
typedef double complex matrix[MOST * MOST];

static void multiply(double complex *z, const double complex *x, const double complex *y, int n)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            z[i * n + j] = 0;
            for (int l = 0; l < n; l++)
                z[i * n + j] += x[i * n + l] * y[l * n + j];
        }
}

/* The largest row sum of magnitudes. */
static double norm(const double complex *x, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++)
            sum += cabs(x[i * n + j]);
        most = fmax(most, sum);
    }
    return most;
}

/* Are i and j linked by steps shorter than `distance` between diagonal entries? */
static bool are_linked(const double complex *a, int n, int i, int j, double distance)
{
    bool reached[MOST] = {false};
    reached[i] = true;
    for (int round = 0; round < n; round++)
        for (int p = 0; p < n; p++)
            for (int q = 0; q < n; q++)
                reached[q] = reached[q] || (reached[p] && cabs(a[p * n + p] - a[q * n + q]) < distance);
    return reached[j];
}

static void check_matrix(const double complex *original, int n, double distance)
{
    matrix a, v, w, t, u;
    int cluster[MOST];
    memcpy(a, original, (size_t)(n * n) * sizeof *a);
    CHECK(block_diagonalise_approx(v, w, cluster, a, n, distance), "no answer");
    if (test_failed())
        return;
    double size = norm(original, n), condition = norm(v, n) * norm(w, n);
    /* w v = 1, and w original v = a up to rounding errors */
    multiply(t, w, v, n);
    for (int i = 0; i < n; i++)
        t[i * n + i] -= 1;
    CHECK(norm(t, n) < 1e-13 * condition, "w is not the inverse of v: %.3g, condition %.3g", norm(t, n), condition);
    multiply(t, original, v, n);
    multiply(u, w, t, n);
    for (int i = 0; i < n * n; i++)
        u[i] -= a[i];
    CHECK(norm(u, n) <= 1e-13 * condition * size, "w a v is not the triangle: %.3g, condition %.3g, size %.3g", norm(u, n), condition, size);
    /* a triangle; above the diagonal only between close eigenvalues */
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            CHECK(i <= j || a[i * n + j] == 0, "below the diagonal");
            CHECK(cluster[i] >= 0 && cluster[i] < n, "cluster %d", cluster[i]);
            if (i < j && cluster[i] != cluster[j])
                CHECK(cabs(a[i * n + j]) <= 1e-14 * condition * size, "%.3g between clusters", cabs(a[i * n + j]));
            CHECK((cluster[i] == cluster[j]) == are_linked(a, n, i, j, distance), "clusters of %d and %d", i, j);
        }
}

static void test_random(void)
{
    test_begin("schur-random");
    for (test_cases(400); test_next();) {
        int n = (int)random_range(1, MOST);
        bool real = random_bool(), sparse = random_bool();
        matrix a;
        for (int i = 0; i < n * n; i++)
            a[i] = sparse && random_below(3) ? 0 : random_unit() + (real ? 0 : random_unit() * I);
        check_matrix(a, n, 0x1p-13 * (1 + norm(a, n)));
        for (int i = 0; i < n * n; i++)
            a[i] *= 0x1p200;
        check_matrix(a, n, 0x1p-13 * (1 + norm(a, n)));
    }
    test_end();
}

/* Triangles mixed by elementary steps: the eigenvalues are known; those of Jordan blocks of size s to 1/s of the digits. */
static void test_known(void)
{
    test_begin("schur-known-eigenvalues");
    for (test_cases(400); test_next();) {
        int n = (int)random_range(1, MOST), steps = (int)random_below((uint64_t)n + 1), largest = (int)random_range(1, 4), used = 1;
        matrix a = {0}, b, v, w;
        int cluster[MOST];
        double complex value[MOST];
        for (int i = 0; i < n; i += used) {
            double complex x = random_range(-9, 9) + random_range(-9, 9) * I;
            used = (int)random_range(1, largest);
            for (int j = i; j < n && j < i + used; j++) {
                a[j * n + j] = value[j] = x;
                if (j + 1 < n && j + 1 < i + used)
                    a[j * n + j + 1] = 1;
            }
        }
        for (; steps > 0 && n > 1; steps--) {
            int to = (int)random_below((uint64_t)n), from = (int)random_below((uint64_t)n);
            for (int j = 0; to != from && j < n; j++)
                a[to * n + j] += a[from * n + j];
            for (int i = 0; to != from && i < n; i++)
                a[i * n + from] -= a[i * n + to];
        }
        memcpy(b, a, sizeof b);
        check_matrix(a, n, 0.05);
        CHECK(block_diagonalise_approx(v, w, cluster, b, n, 0.05), "no answer");
        for (int i = 0; i < n && !test_failed(); i++) {
            int near = 0, members = 0;
            for (int j = 0; j < n; j++) {
                near += cabs(b[j * n + j] - value[i]) < 0.02;
                members += value[j] == value[i];
            }
            CHECK(near == members, "%d of %d eigenvalues near %g + %g i", near, members, creal(value[i]), cimag(value[i]));
        }
    }
    test_end();
}

static void test_corners(void)
{
    static const double complex rotation[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0}; /* the shift alone makes no progress on it */
    matrix a = {0};
    test_begin("schur-corners");
    check_matrix(rotation, 3, 0.01);
    for (int n = 1; n <= MOST; n++) {
        memset(a, 0, sizeof a);
        check_matrix(a, n, 0.01);
        for (int i = 0; i < n; i++)
            a[i * n + (i + 1) % n] = 1; /* a cycle */
        check_matrix(a, n, 0.01);
        for (int i = 0; i < n * n; i++)
            a[i] = 1;
        check_matrix(a, n, 0.01);
    }
    a[0] = NAN;
    CHECK(!block_diagonalise_approx((matrix){0}, (matrix){0}, (int[MOST]){0}, a, 3, 0.01), "not a number");
    test_end();
}

int main(void)
{
    test_random();
    test_known();
    test_corners();
    return test_status();
}
