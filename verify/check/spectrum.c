/* The spectrum: section 6 of certificate.md. */

#include "spectrum.h"

#include "answer.h"

#include <stdlib.h>

enum { INVERSE_BITS = 32, MAX_MAGNITUDE_BITS = 64 };

/* sum += x y */
static void add_product(interval *sum, const interval *x, const interval *y, int g)
{
    interval product;

    grid_mul(&product, x, y, g);
    interval_add(sum, sum, &product);
}

/* The eigenpair
 * ------------- */

/* What the Krawczyk step works on; unknowns are counted from 0. */
struct krawczyk {
    int g, n, pivot;
    const interval *b;                             /* n x n */
    interval *x_mid, *x_box;                       /* x~ and X; 1 at the pivot */
    interval l_mid, l_box;                         /* L~ and X_L */
    interval *f, *slope, *inverse;                 /* f; G and Y, n x n */
};

static void set_box(interval *mid, interval *box, const integer *centre,
                    const integer *radius)
{
    interval_set_thin(mid, centre);
    integer_sub(&box->lo, centre, radius);
    integer_add(&box->hi, centre, radius);
}

static void read_choices(struct krawczyk *s, const struct certificate *c)
{
    int n = s->n;

    s->pivot = c->pivot - 1;
    s->x_mid = allocate((size_t)n, sizeof s->x_mid[0]);
    s->x_box = allocate((size_t)n, sizeof s->x_box[0]);
    s->f = allocate((size_t)n, sizeof s->f[0]);
    s->slope = allocate((size_t)(n * n), sizeof s->slope[0]);
    s->inverse = allocate((size_t)(n * n), sizeof s->inverse[0]);

    set_box(&s->l_mid, &s->l_box, &c->eigenvalue, &c->radius);
    for (int i = 0, other = 0; i < n; i++) {
        if (i == s->pivot) {
            grid_set_small(&s->x_mid[i], 1, s->g);
            grid_set_small(&s->x_box[i], 1, s->g);
        } else {
            set_box(&s->x_mid[i], &s->x_box[i], &c->eigenvector[other++],
                    &c->radius);
        }
    }
    for (int i = 0; i < n * n; i++) {              /* exact, since g >= 64 */
        integer y;

        integer_shift_left(&y, &c->inverse[i], s->g - INVERSE_BITS);
        interval_set_thin(&s->inverse[i], &y);
    }
}

/* f = B x~ - L~ x~ */
static void compute_residual(struct krawczyk *s)
{
    for (int i = 0; i < s->n; i++) {
        interval sum, right;

        grid_set_small(&sum, 0, s->g);
        for (int j = 0; j < s->n; j++)
            add_product(&sum, &s->b[i * s->n + j], &s->x_mid[j], s->g);
        grid_mul(&right, &s->l_mid, &s->x_mid[i], s->g);
        interval_sub(&s->f[i], &sum, &right);
    }
}

/* G: columns for the unknowns other than the pivot, then one for L. */
static void compute_slope(struct krawczyk *s)
{
    int n = s->n;

    for (int i = 0; i < n; i++) {
        int l = 0;

        for (int j = 0; j < n; j++) {
            if (j == s->pivot)
                continue;
            if (i == j)
                interval_sub(&s->slope[i * n + l], &s->b[i * n + j], &s->l_box);
            else
                interval_set(&s->slope[i * n + l], &s->b[i * n + j]);
            l++;
        }
        interval_minus(&s->slope[i * n + n - 1], &s->x_box[i]);
    }
}

/* K_i = - sum_l Y_il f_l + sum_l (delta_il - sum_q Y_iq G_ql) [-rho, rho] */
static void compute_image(interval *out, const struct krawczyk *s, int i,
                          const interval *box)
{
    int n = s->n;
    interval sum, delta;

    grid_set_small(&sum, 0, s->g);
    for (int l = 0; l < n; l++)
        add_product(&sum, &s->inverse[i * n + l], &s->f[l], s->g);
    interval_minus(out, &sum);

    for (int l = 0; l < n; l++) {
        grid_set_small(&sum, 0, s->g);
        for (int q = 0; q < n; q++)
            add_product(&sum, &s->inverse[i * n + q], &s->slope[q * n + l], s->g);
        grid_set_small(&delta, i == l ? 1 : 0, s->g);
        interval_sub(&sum, &delta, &sum);
        add_product(out, &sum, box, s->g);
    }
}

void spectrum_prove_eigenpair(struct eigenpair *out, const struct block *block,
                              const interval *matrix,
                              const struct certificate *c)
{
    struct krawczyk *s = allocate(1, sizeof *s);
    interval box, image, one;

    s->g = block->g;
    s->n = block->n;
    s->b = matrix;
    if (c->radius.sign <= 0)
        rejected(c->file, c->line_of.radius, "radius: it is not positive");
    if (c->pivot < 1 || c->pivot > s->n)
        rejected(c->file, c->line_of.pivot,
                 "pivot: it is not the index of one of the %d unknowns", s->n);
    read_choices(s, c);
    compute_residual(s);
    compute_slope(s);

    integer_negate(&box.lo, &c->radius);
    integer_set(&box.hi, &c->radius);
    for (int i = 0; i < s->n; i++) {
        compute_image(&image, s, i, &box);
        if (integer_compare(&image.lo, &box.lo) <= 0 ||
            integer_compare(&image.hi, &box.hi) >= 0)
            rejected(c->file, c->line_of.radius,
                     "radius: the Krawczyk operator does not map the box into "
                     "its interior (component %d)", i + 1);
    }

    grid_set_small(&one, 1, s->g);
    if (s->l_box.lo.sign <= 0 || integer_compare(&s->l_box.hi, &one.lo) >= 0)
        rejected(c->file, c->line_of.eigenvalue,
                 "eigenvalue: its interval is not inside (0,1)");
    out->unknowns = s->x_box;
    interval_set(&out->eigenvalue, &s->l_box);
    free(s->x_mid);
    free(s->f);
    free(s->slope);
    free(s->inverse);
    free(s);
}

/* The rest
 * -------- */

/* B': what is left of the block beside its known eigenvalue, if it has one.
 * size: in n, out that of B'. */
static interval *deflate(int *size, const struct block *block,
                         const interval *b, const struct eigenpair *pair, int pivot)
{
    int m = block->twist.m, n = block->n, rows = 0;
    interval *out = allocate((size_t)(n * n), sizeof out[0]);
    interval product;

    if (m >= 2) {
        for (int i = 0; i < n * n; i++)
            interval_set(&out[i], &b[i]);
        return out;
    }
    *size = n - 1;
    for (int i = 0; i < n; i++) {
        int columns = 0;

        if (i == pivot)
            continue;
        for (int j = 0; j < n; j++) {
            if (j == pivot)
                continue;
            if (m == 0)                            /* X_i = 1 */
                interval_set(&product, &b[pivot * n + j]);
            else
                grid_mul(&product, &pair->unknowns[i], &b[pivot * n + j], block->g);
            interval_sub(&out[rows * *size + columns], &b[i * n + j], &product);
            columns++;
        }
        rows++;
    }
    return out;
}

/* s = ceil(1 / lo) in units of 2^-g: 2^g / (lo 2^-g). */
static void inverse_upper(interval *out, const interval *eigenvalue, int g)
{
    integer square, s;

    integer_set_small(&square, 1);
    integer_shift_left(&square, &square, 2L * g);
    integer_divide_ceil(&s, &square, &eigenvalue->lo);
    interval_set_thin(out, &s);
}

static bool has_large_entry(const interval *c, int size, int g)
{
    integer magnitude;

    for (int i = 0; i < size * size; i++) {
        interval_magnitude(&magnitude, &c[i]);
        if (integer_bits(&magnitude) > g + MAX_MAGNITUDE_BITS)
            return true;
    }
    return false;
}

static void multiply(interval *out, const interval *x, const interval *y, int size,
                     int g)
{
    for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
            interval *sum = &out[i * size + j];

            grid_set_small(sum, 0, g);
            for (int l = 0; l < size; l++)
                add_product(sum, &x[i * size + l], &y[l * size + j], g);
        }
    }
}

/* Is the sum of magnitudes of each row < 1? */
static bool has_small_rows(const interval *c, int size, int g)
{
    interval one;

    grid_set_small(&one, 1, g);
    for (int i = 0; i < size; i++) {
        integer sum, magnitude;

        integer_set_small(&sum, 0);
        for (int j = 0; j < size; j++) {
            interval_magnitude(&magnitude, &c[i * size + j]);
            integer_add(&sum, &sum, &magnitude);
        }
        if (integer_compare(&sum, &one.lo) >= 0)
            return false;
    }
    return true;
}

void spectrum_prove_rest(const struct block *block, const interval *matrix,
                         const struct eigenpair *pair,
                         const struct certificate *certificate)
{
    int g = block->g, size = block->n, m = block->twist.m;
    int pivot = m == 0 ? 0 : certificate->pivot - 1;
    int line = certificate->line_of.power;
    interval *c = deflate(&size, block, matrix, pair, pivot);
    interval *square = allocate((size_t)(size * size), sizeof square[0]);
    interval s;

    inverse_upper(&s, &pair->eigenvalue, g);
    for (int i = 0; i < size * size; i++)
        grid_mul(&c[i], &c[i], &s, g);
    for (int step = 0; ; step++) {
        if (has_large_entry(c, size, g))
            rejected(certificate->file, line,
                     "power: an entry of block %d reaches 2^64", m);
        if (step == certificate->power[m])
            break;
        multiply(square, c, c, size, g);

        interval *swap = c;

        c = square;
        square = swap;
    }
    if (!has_small_rows(c, size, g))
        rejected(certificate->file, line,
                 "power: the other eigenvalues of block %d are not proved to be "
                 "smaller than L", m);
    free(c);
    free(square);
}
