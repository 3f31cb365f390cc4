/* eigenbasis.c: a basis from doubles, improved if the precision asks for it.  lib/eigenvalues.md has the proof. */
#include "eigenbasis.h"

#include "matrix_row.h"
#include "schur_approx.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Eigenvalues closer than this, relative to the largest entry, share a group. */
#define GROUP_DISTANCE 0x1p-13

/* b v = v d + r with d block diagonal, one block to a group, so v^-1 b v = d + v^-1 r.  Doubles give v, about v^-1 and d.
   As r becomes smaller, corrections of v and d are found in doubles, too, 45 bits or so each time: all that is
   multiplied with many digits is b by doubles.  v and b v are the sums of what the corrections say, in enclosures,
   so that no rounding need be undone. */
typedef struct {
    int n;
    long prec;
    const number *re, *im; /* the matrix; im may be NULL */
    number *zero;          /* stands for its imaginary part then */
    complex_matrix v;      /* the basis */
    complex_matrix y;      /* b v */
    complex_matrix d;      /* thin */
    complex_matrix m;      /* the caller's: r, in the end v^-1 b v */
    complex_matrix t;      /* scratch */
    double complex *start; /* of the basis */
    double complex *w;     /* about the inverse of v */
    double complex *diagonal, *work; /* d; scratch, two matrices */
    int *group;            /* the caller's */
    int *next;             /* the next index in the group, n: there is none */
    bool *real;            /* the columns of v that are real */
} workspace;

static bool workspace_make(workspace *s, complex_matrix *m, int *group, const number *re, const number *im, int n, long prec)
{
    size_t square = (size_t)n * (size_t)n;
    memset(s, 0, sizeof *s);
    s->n = n;
    s->prec = prec;
    s->re = re;
    s->im = im;
    s->m = *m;
    s->group = group;
    s->zero = number_array_new(im ? 0 : square);
    s->start = malloc(5 * square * sizeof *s->start);
    s->next = malloc((size_t)n * sizeof *s->next);
    s->real = calloc((size_t)n, sizeof *s->real);
    if (s->start) {
        s->w = s->start + square;
        s->diagonal = s->w + square;
        s->work = s->diagonal + square;
    }
    return complex_matrix_make(&s->v, n) && complex_matrix_make(&s->y, n) && complex_matrix_make(&s->d, n) && complex_matrix_make(&s->t, n)
        && s->zero && s->start && s->next && s->real;
}

static void workspace_free(workspace *s)
{
    complex_matrix_free(&s->v);
    complex_matrix_free(&s->y);
    complex_matrix_free(&s->d);
    complex_matrix_free(&s->t);
    number_array_free(s->zero, s->im ? 0 : (size_t)s->n * (size_t)s->n);
    free(s->start);
    free(s->next);
    free(s->real);
}

/* z = a 2^e. */
static void load(complex_matrix *z, const double complex *a, long e, long prec)
{
    for (int i = 0; i < z->n * z->n; i++) {
        number_set_double(&z->re[i], creal(a[i]), prec);
        number_set_double(&z->im[i], cimag(a[i]), prec);
        if (e) {
            number_mul_2exp(&z->re[i], &z->re[i], e, prec);
            number_mul_2exp(&z->im[i], &z->im[i], e, prec);
        }
    }
}

#define GUARD 32

/* Enough for bounds. */
#define BOUND_BITS 64

/* For numbers of which so many leading bits matter.  On grids bits are counted from 1, not from the first. */
static long precision_for(const workspace *s, long bits)
{
#if defined(NUMBER_GRID)
    (void)bits;
    return s->prec;
#else
    return bits < s->prec ? bits : s->prec;
#endif
}

/* r this far above 2^-prec is left as it is: all of r that its enclosures let one see. */
#define ENOUGH 12

/* An entry of a column or row that is smaller than this, relative to the largest one, may as well be 0. */
#define NEGLIGIBLE 1e-9

/* Is the column real but for a common factor?  phase = that factor. */
static bool is_nearly_real(double complex *phase, const double complex *column, int n)
{
    double complex largest = 0;
    for (int i = 0; i < n; i++)
        if (cabs(column[i * n]) > cabs(largest))
            largest = column[i * n];
    *phase = largest / cabs(largest);
    for (int i = 0; i < n; i++)
        if (!(fabs(cimag(column[i * n] / *phase)) <= NEGLIGIBLE * cabs(largest)))
            return false;
    return true;
}

/* Which columns are real but for a factor, in groups of such columns only: they are exactly those that a real matrix maps
   to real combinations of each other. */
static void find_real(workspace *s, double complex *phase)
{
    int n = s->n;
    for (int j = 0; j < n; j++)
        s->real[j] = is_nearly_real(&phase[j], s->start + j, n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if (!s->real[i] && s->group[i] == s->group[j])
                s->real[j] = false;
}

/* The basis of a real matrix is a suggestion that costs less where it is real, too. */
static void make_real(workspace *s)
{
    int n = s->n;
    double complex *phase = s->work;
    find_real(s, phase);
    for (int j = 0; j < n; j++) {
        double largest = 0;
        bool small = true;
        if (!s->real[j])
            continue;
        for (int i = 0; i < n; i++) {
            s->start[i * n + j] = creal(s->start[i * n + j] / phase[j]);
            s->diagonal[i * n + j] /= phase[j];
            s->w[j * n + i] *= phase[j];
            s->diagonal[j * n + i] *= phase[j];
        }
        for (int i = 0; i < n; i++)
            largest = fmax(largest, cabs(s->w[j * n + i]));
        for (int i = 0; i < n; i++)
            small = small && fabs(cimag(s->w[j * n + i])) <= NEGLIGIBLE * largest;
        for (int i = 0; small && i < n; i++)
            s->w[j * n + i] = creal(s->w[j * n + i]);
    }
    for (int i = 0; i < n * n; i++)
        if (s->real[i / n] && s->real[i % n])
            s->diagonal[i] = creal(s->diagonal[i]);
}

static void link_groups(workspace *s)
{
    for (int i = 0; i < s->n; i++) {
        s->next[i] = i + 1;
        while (s->next[i] < s->n && s->group[s->next[i]] != s->group[i])
            s->next[i]++;
    }
}

/* v, w, d and b v from doubles.  TRUTH_UNKNOWN: it does not work. */
static truth start(workspace *s)
{
    int n = s->n;
    complex_matrix b = {n, (number *)s->re, s->im ? (number *)s->im : s->zero};
    double largest = 0;
    for (int i = 0; i < n * n; i++) {
        s->diagonal[i] = number_mid_approx(&s->re[i]) + (s->im ? number_mid_approx(&s->im[i]) : 0) * I;
        largest = fmax(largest, cabs(s->diagonal[i]));
    }
    if (!block_diagonalise_approx(s->start, s->w, s->group, s->diagonal, n, GROUP_DISTANCE * largest))
        return TRUTH_UNKNOWN;
    for (int i = 0; i < n * n; i++)
        if (s->group[i / n] != s->group[i % n])
            s->diagonal[i] = 0;
    link_groups(s);
    if (!s->im)
        make_real(s);
    load(&s->v, s->start, 0, s->prec);
    load(&s->d, s->diagonal, 0, s->prec);
    complex_matrix_multiply(&s->y, &b, &s->v, s->prec);
    return TRUTH_TRUE;
}

/* (re, im) -= (a, b) (c, d). */
static void subtract_product(number *re, number *im, const number *a, const number *b, const number *c, const number *d, long prec)
{
    bool first_real = number_is_zero(b) == TRUTH_TRUE, second_real = number_is_zero(d) == TRUTH_TRUE;
    number_submul(re, a, c, prec);
    if (!first_real)
        number_submul(im, b, c, prec);
    if (!second_real)
        number_submul(im, a, d, prec);
    if (!first_real && !second_real)
        number_addmul(re, b, d, prec);
}

/* m = b v - v d. */
static void find_residual(workspace *s)
{
    int n = s->n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int at = i * n + j;
            number_set(&s->m.re[at], &s->y.re[at]);
            number_set(&s->m.im[at], &s->y.im[at]);
            for (int l = s->group[j]; l < n; l = s->next[l])
                subtract_product(&s->m.re[at], &s->m.im[at], &s->v.re[i * n + l], &s->v.im[i * n + l], &s->d.re[l * n + j], &s->d.im[l * n + j], s->prec);
        }
}

static void multiply_approx(double complex *z, const double complex *x, const double complex *y, int n)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double re = 0, im = 0;
            for (int l = 0; l < n; l++) {
                double complex p = x[i * n + l], q = y[l * n + j];
                re += creal(p) * creal(q) - cimag(p) * cimag(q);
                im += creal(p) * cimag(q) + cimag(p) * creal(q);
            }
            z[i * n + j] = re + im * I;
        }
}

/* c becomes z with d z - z d = -c outside the groups, in which it stays as it is.  d is nearly a triangle in each group,
   so what an entry needs lies below it and to its left, and what is left of d there hardly matters. */
static void solve_approx(double complex *c, const double complex *d, const int *group, int n)
{
    for (int i = n - 1; i >= 0; i--)
        for (int j = 0; j < n; j++) {
            if (group[i] == group[j])
                continue;
            for (int l = i + 1; l < n; l++)
                if (group[l] == group[i])
                    c[i * n + j] += d[i * n + l] * c[l * n + j];
            for (int l = 0; l < j; l++)
                if (group[l] == group[j])
                    c[i * n + j] -= c[i * n + l] * d[l * n + j];
            c[i * n + j] /= d[j * n + j] - d[i * n + i];
        }
}

/* z += x. */
static void add_matrix(complex_matrix *z, const complex_matrix *x, long prec)
{
    for (int i = 0; i < z->n * z->n; i++) {
        number_add(&z->re[i], &z->re[i], &x->re[i], prec);
        number_add(&z->im[i], &z->im[i], &x->im[i], prec);
    }
}

/* c = about 2^shift v^-1 r. */
static void correction_approx(double complex *c, double complex *scratch, const workspace *s, long shift)
{
    number part;
    number_init(&part);
    for (int i = 0; i < s->n * s->n; i++) {
        double re;
        number_mul_2exp(&part, &s->m.re[i], shift, s->prec);
        re = number_mid_approx(&part);
        number_mul_2exp(&part, &s->m.im[i], shift, s->prec);
        scratch[i] = re + number_mid_approx(&part) * I;
    }
    number_clear(&part);
    multiply_approx(c, s->w, scratch, s->n);
}

/* d += the part of c 2^-good within the groups, which becomes 0 in c. */
static void improve_diagonal(workspace *s, double complex *c, double complex *scratch, long good)
{
    int n = s->n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            bool same = s->group[i] == s->group[j];
            scratch[i * n + j] = !same ? 0 : s->real[i] && s->real[j] ? creal(c[i * n + j]) : c[i * n + j];
            if (same)
                c[i * n + j] = 0;
        }
    load(&s->t, scratch, -good, s->prec);
    add_matrix(&s->d, &s->t, s->prec);
    complex_matrix_thin(&s->d, s->prec);
}

/* With c = about v^-1 r 2^good, which is destroyed: d + the part of c within the groups, and v + v z with d z - z d = -c
   otherwise, leave only what is quadratic in c, or lost in doubles. */
static void improve(workspace *s, double complex *c, double complex *scratch, long good)
{
    int n = s->n;
    complex_matrix b = {n, (number *)s->re, s->im ? (number *)s->im : s->zero};
    solve_approx(c, s->diagonal, s->group, n);
    improve_diagonal(s, c, scratch, good);
    multiply_approx(scratch, s->start, c, n);
    for (int i = 0; i < n * n; i++)
        if (s->real[i % n])
            scratch[i] = creal(scratch[i]);
    load(&s->t, scratch, -good, s->prec);
    add_matrix(&s->v, &s->t, s->prec);
    complex_matrix_multiply(&s->m, &b, &s->t, precision_for(s, s->prec - good + GUARD));
    add_matrix(&s->y, &s->m, s->prec);
}

/* Until r is no larger than rounding, or hardly becomes smaller. */
#define LEAST_GAIN 4

static void improve_all(workspace *s)
{
    long good = 0, next = 0;
    double complex *c = s->work, *scratch = s->work + s->n * s->n;
    double norm = 0;
    for (int i = 0; i < s->n * s->n; i++)
        norm = fmax(norm, cabs(s->diagonal[i]));
    for (;;) {
        double size = 0;
        find_residual(s);
        correction_approx(c, scratch, s, good);
        for (int i = 0; i < s->n * s->n; i++)
            size = fmax(size, cabs(c[i]));
        if (!(size > 0) || !isfinite(size) || !(norm > 0))
            return;
        next = good - ilogb(size / norm);
        if (next < good + LEAST_GAIN || next > s->prec - ENOUGH) {
            improve_diagonal(s, c, scratch, good); /* which costs nothing, and puts discs where they belong */
            return;
        }
        improve(s, c, scratch, good);
        good = next;
    }
}

/* *f >= the row sum norm of (w v)^-1 - 1: with e = |1 - w v| < 1 it is at most e / (1 - e).  false: e is not certainly
   small. */
static bool bound_defect(number *f, workspace *s)
{
    int n = s->n;
    long prec = precision_for(s, BOUND_BITS);
    bool ok;
    number e, sum, one, size;
    number_init(&e);
    number_init(&sum);
    number_init(&one);
    number_init(&size);
    number_one(&one);
    load(&s->t, s->w, 0, prec);
    complex_matrix_multiply(&s->y, &s->t, &s->v, prec);
    for (int i = 0; i < n; i++) {
        number_zero(&sum);
        for (int j = 0; j < n; j++) {
            number *re = &s->y.re[i * n + j];
            if (i == j)
                number_sub(re, re, &one, prec);
            complex_magnitude_upper(&size, re, &s->y.im[i * n + j], prec);
            number_add(&sum, &sum, &size, prec);
        }
        number_max(&e, &e, &sum, prec);
    }
    number_sub(f, &one, &e, prec);
    ok = number_is_positive(f) == TRUTH_TRUE;
    number_div(f, &e, f, prec);
    number_clear(&e);
    number_clear(&sum);
    number_clear(&one);
    number_clear(&size);
    return ok;
}

/* m = d + v^-1 r.  As v is invertible if w v is, v^-1 r = (w v)^-1 (w r), and each entry of it differs from that of w r by
   at most f times the largest of the column; no entry of w r is larger than that of |w| |r|.  false: no bound. */
static bool add_remainder(workspace *s)
{
    int n = s->n;
    long prec = precision_for(s, BOUND_BITS);
    bool ok;
    number f, largest;
    number *size = s->t.im, *bound = s->y.re; /* |r|; |w| |r| */
    number_init(&f);
    number_init(&largest);
    find_residual(s);
    ok = bound_defect(&f, s);
    for (int i = 0; ok && i < n * n; i++) {
        complex_magnitude_upper(&s->t.re[i], &s->t.re[i], &s->t.im[i], prec);
        complex_magnitude_upper(&size[i], &s->m.re[i], &s->m.im[i], prec);
        number_zero(&bound[i]);
    }
    for (int i = 0; ok && i < n; i++)
        matrix_add_row(&bound[i * n], &s->t.re[i * n], size, n, false, prec);
    for (int j = 0; ok && j < n; j++) {
        number_zero(&largest);
        for (int i = 0; i < n; i++)
            number_max(&largest, &largest, &bound[i * n + j], prec);
        number_mul(&largest, &largest, &f, prec);
        for (int i = 0; i < n; i++) {
            number_add(&bound[i * n + j], &bound[i * n + j], &largest, prec);
            number_add_error(&s->m.re[i * n + j], &s->d.re[i * n + j], &bound[i * n + j], s->prec);
            number_add_error(&s->m.im[i * n + j], &s->d.im[i * n + j], &bound[i * n + j], s->prec);
        }
    }
    number_clear(&f);
    number_clear(&largest);
    return ok;
}

truth eigenbasis_enclose(complex_matrix *m, int *group, const number *re, const number *im, int n, long prec)
{
    workspace s;
    truth found = TRUTH_FALSE;
    if (workspace_make(&s, m, group, re, im, n, prec))
        found = start(&s);
    if (found == TRUTH_TRUE) {
        improve_all(&s);
        found = add_remainder(&s) ? TRUTH_TRUE : TRUTH_UNKNOWN;
    }
    workspace_free(&s);
    return found;
}
