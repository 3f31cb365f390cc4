/* schur_approx.c: Hessenberg form, shifted QR with Givens rotations, and elimination between distant eigenvalues. */
#include "schur_approx.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_STEPS_PER_EIGENVALUE 60

#define AT(m, i, j) (m)[(i) * n + (j)]

static void set_identity(double complex *m, int n)
{
    for (int i = 0; i < n * n; i++)
        m[i] = i % (n + 1) == 0;
}

/* Rows p, q of a become c p + s q and -conj(s) p + c q (c real). */
static void rotate_rows(double complex *a, int n, int p, int q, double c, double complex s)
{
    for (int j = 0; j < n; j++) {
        double complex x = AT(a, p, j), y = AT(a, q, j);
        AT(a, p, j) = c * x + s * y;
        AT(a, q, j) = -conj(s) * x + c * y;
    }
}

/* The inverse rotation on columns p, q. */
static void rotate_columns(double complex *a, int n, int p, int q, double c, double complex s)
{
    for (int i = 0; i < n; i++) {
        double complex x = AT(a, i, p), y = AT(a, i, q);
        AT(a, i, p) = c * x + conj(s) * y;
        AT(a, i, q) = -s * x + c * y;
    }
}

/* The rotation that takes (x, y) to (r, 0). */
static void choose_rotation(double *c, double complex *s, double complex x, double complex y)
{
    double r = hypot(cabs(x), cabs(y));
    if (r == 0 || y == 0) {
        *c = 1;
        *s = 0;
    } else if (x == 0) {
        *c = 0;
        *s = conj(y) / cabs(y);
    } else {
        *c = cabs(x) / r;
        *s = x / cabs(x) * conj(y) / r;
    }
}

static void to_hessenberg(double complex *a, double complex *v, int n)
{
    for (int j = 0; j < n - 2; j++)
        for (int i = n - 1; i > j + 1; i--) {
            double c;
            double complex s;
            choose_rotation(&c, &s, AT(a, i - 1, j), AT(a, i, j));
            rotate_rows(a, n, i - 1, i, c, s);
            rotate_columns(a, n, i - 1, i, c, s);
            rotate_columns(v, n, i - 1, i, c, s);
            AT(a, i, j) = 0;
        }
}

/* The eigenvalue of the lower right 2 x 2 block at q that is nearer to its last entry. */
static double complex wilkinson_shift(const double complex *a, int n, int q)
{
    double complex p = AT(a, q - 1, q - 1), r = AT(a, q, q), b = AT(a, q - 1, q) * AT(a, q, q - 1);
    double complex half = (p - r) / 2, root = csqrt(half * half + b);
    double complex one = r + half + root, two = r + half - root;
    return cabs(one - r) < cabs(two - r) ? one : two;
}

/* One step of QR on the rows and columns l..q, the shift subtracted and added again: all rotations of the rows first,
   then those of the columns.  c and t have room for n rotations. */
static void qr_step(double complex *a, double complex *v, int n, int l, int q, double complex shift, double *c, double complex *t)
{
    for (int i = l; i <= q; i++)
        AT(a, i, i) -= shift;
    for (int i = l; i < q; i++) {
        choose_rotation(&c[i], &t[i], AT(a, i, i), AT(a, i + 1, i));
        rotate_rows(a, n, i, i + 1, c[i], t[i]);
        AT(a, i + 1, i) = 0;
    }
    for (int i = l; i < q; i++) {
        rotate_columns(a, n, i, i + 1, c[i], t[i]);
        rotate_columns(v, n, i, i + 1, c[i], t[i]);
    }
    for (int i = l; i <= q; i++)
        AT(a, i, i) += shift;
}

static bool to_triangle(double complex *a, double complex *v, int n, double *c, double complex *t)
{
    double negligible = 0;
    for (int i = 0; i < n * n; i++)
        negligible = fmax(negligible, cabs(a[i]) * 0x1p-52);
    for (int q = n - 1, steps = 0; q > 0;) {
        int l = q;
        while (l > 0 && cabs(AT(a, l, l - 1)) > negligible)
            l--;
        if (l > 0)
            AT(a, l, l - 1) = 0;
        if (l == q) {
            q--;
            steps = 0;
            continue;
        }
        if (++steps > MAX_STEPS_PER_EIGENVALUE)
            return false;
        qr_step(a, v, n, l, q, steps % 11 == 10 ? AT(a, q, q) + cabs(AT(a, q, q - 1)) : wilkinson_shift(a, n, q), c, t);
    }
    for (int i = 1; i < n; i++)
        for (int j = 0; j < i; j++)
            AT(a, i, j) = 0;
    return true;
}

/* Numbers the classes of diagonal entries that are linked by steps shorter than `distance`. */
static void find_clusters(int *cluster, const double complex *a, int n, double distance)
{
    for (int i = 0; i < n; i++)
        cluster[i] = i;
    for (int changed = 1; changed;) {
        changed = 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < i; j++)
                if (cluster[i] != cluster[j] && cabs(AT(a, i, i) - AT(a, j, j)) <= distance) {
                    int low = cluster[i] < cluster[j] ? cluster[i] : cluster[j];
                    cluster[i] = cluster[j] = low;
                    changed = 1;
                }
    }
}

/* a -> (I - x E_ij) a (I + x E_ij), v -> v (I + x E_ij), w -> (I - x E_ij) w, with the x that makes a_ij = 0; from the
   bottom of each column upwards, so that no zero is lost. */
static void eliminate(double complex *a, double complex *v, double complex *w, const int *cluster, int n)
{
    for (int j = 1; j < n; j++)
        for (int i = j - 1; i >= 0; i--) {
            double complex x;
            if (cluster[i] == cluster[j])
                continue;
            x = AT(a, i, j) / (AT(a, j, j) - AT(a, i, i));
            for (int l = 0; l <= i; l++)
                AT(a, l, j) += x * AT(a, l, i);
            for (int l = j; l < n; l++)
                AT(a, i, l) -= x * AT(a, j, l);
            AT(a, i, j) = 0;
            for (int l = 0; l < n; l++) {
                AT(v, l, j) += x * AT(v, l, i);
                AT(w, i, l) -= x * AT(w, j, l);
            }
        }
}

bool block_diagonalise_approx(double complex *v, double complex *w, int *cluster, double complex *a, int n, double distance)
{
    double *c = malloc((size_t)n * sizeof *c);
    double complex *t = malloc((size_t)n * sizeof *t);
    bool ok = c && t;
    set_identity(v, n);
    if (ok) {
        to_hessenberg(a, v, n);
        ok = to_triangle(a, v, n, c, t);
    }
    free(c);
    free(t);
    if (!ok)
        return false;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            AT(w, i, j) = conj(AT(v, j, i));
    find_clusters(cluster, a, n, distance);
    eliminate(a, v, w, cluster, n);
    for (int i = 0; i < n * n; i++)
        if (!isfinite(creal(v[i])) || !isfinite(cimag(v[i])) || !isfinite(creal(w[i])) || !isfinite(cimag(w[i])))
            return false;
    return true;
}
