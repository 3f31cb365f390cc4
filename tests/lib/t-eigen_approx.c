/* t-eigen_approx.c: the approximations are good where the problem is. */
#include "lib/eigen_approx.h"

#include <math.h>

#include "matrix.h"

static void get_doubles(double *z, const known_matrix *m)
{
    for (int i = 0; i < m->n; i++)
        for (int j = 0; j < m->n; j++)
            z[i * m->n + j] = (double)m->b[i][j] / (double)m->denominator;
}

static void test_dominant(void)
{
    test_begin("approx-dominant");
    for (test_cases(300); test_next();) {
        known_matrix m;
        double b[MATRIX_MAX * MATRIX_MAX], x[MATRIX_MAX], eigenvalue = 0;
        int pivot = -1;
        random_real_matrix(&m, (int)random_range(1, MATRIX_MAX));
        get_doubles(b, &m);
        CHECK(eigen_dominant_approx(&eigenvalue, x, &pivot, b, m.n) == TRUTH_TRUE, "not found");
        CHECK(fabs(eigenvalue * (double)m.denominator - (double)m.d[0][0]) < 1e-6, "%g, not %ld", eigenvalue * (double)m.denominator, m.d[0][0]);
        CHECK(pivot >= 0 && pivot < m.n && x[pivot] == 1, "pivot");
        for (int i = 0; i < m.n && !test_failed(); i++)
            CHECK(fabs(x[i]) <= 1 && fabs(x[i] - (double)m.p[i][0] / (double)m.p[pivot][0]) < 1e-6, "component %d", i);
    }
    test_end();
}

/* P (1, 0; 0, 1 - e) P^-1, P = (3, 1; 1, 1): powers take 1/e steps. */
static void test_close(void)
{
    test_begin("approx-dominant-close");
    for (double e = 0.125; e > 1e-11; e /= 16) {
        double b[4] = {(3 - (1 - e)) / 2, (-3 + 3 * (1 - e)) / 2, e / 2, (3 * (1 - e) - 1) / 2}, x[2], eigenvalue = 0;
        int pivot = -1;
        CHECK(eigen_dominant_approx(&eigenvalue, x, &pivot, b, 2) == TRUTH_TRUE && fabs(eigenvalue - 1) < 1e-14, "%g: %.17g", e, eigenvalue);
        CHECK(pivot == 0 && fabs(x[1] - 1 / 3.) < 1e-15 / e, "%g: component %g", e, x[1]);
    }
    test_end();
}

static void test_radius(void)
{
    test_begin("approx-spectral-radius");
    CHECK(spectral_radius_approx((double[]){0}, 0) == 0, "n = 0");
    CHECK(spectral_radius_approx((double[]){0, 1, 0, 0}, 2) < 1e-3, "nilpotent");
    for (test_cases(300); test_next();) {
        known_matrix m;
        double b[MATRIX_MAX * MATRIX_MAX];
        random_general_matrix(&m, (int)random_range(1, MATRIX_MAX));
        get_doubles(b, &m);
        double radius = spectral_radius_approx(b, m.n) * (double)m.denominator, expected = sqrt((double)m.square);
        if (m.square) /* a Jordan block of size 6 costs five digits of six */
            CHECK(fabs(radius / expected - 1) < 0.25, "%.10g, not %.10g", radius, expected);
    }
    test_end();
}

/* The powers of a Jordan block look more and more like those of a nilpotent matrix. */
static void test_defective(void)
{
    test_begin("approx-spectral-radius-defective");
    double radius = spectral_radius_approx((double[]){-0.006, 0.004, -0.001, -0.002}, 2);
    CHECK(fabs(radius - 0.004) < 1e-5, "%g, not 0.004", radius);
    test_end();
}

static void test_inverse(void)
{
    test_begin("approx-inverse");
    for (test_cases(300); test_next();) {
        int n = (int)random_range(1, 12);
        double a[144], z[144];
        for (int i = 0; i < n * n; i++)
            a[i] = (double)random_range(-1000, 1000) / 1000;
        if (matrix_inverse_approx(z, a, n) != TRUTH_TRUE)
            continue;
        double size = 0, error = 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                double sum = 0;
                for (int l = 0; l < n; l++)
                    sum += a[i * n + l] * z[l * n + j];
                size = fmax(size, fabs(z[i * n + j]));
                error = fmax(error, fabs(sum - (i == j)));
            }
        CHECK(error < 1e-10 * (1 + size), "n = %d: the product with the inverse is off by %g", n, error);
    }
    CHECK(matrix_inverse_approx((double[4]){0}, (double[]){1, 2, 2, 4}, 2) != TRUTH_TRUE, "a singular matrix");
    CHECK(matrix_inverse_approx((double[1]){0}, (double[]){0}, 1) != TRUTH_TRUE, "0");
    test_end();
}

int main(void)
{
    test_dominant();
    test_close();
    test_radius();
    test_defective();
    test_inverse();
    return test_status();
}
