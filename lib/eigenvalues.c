/* eigenvalues.c: a basis from doubles, improved if the precision asks for it; then Gershgorin. */
#include "eigenvalues.h"

#include "schur_approx.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Eigenvalues closer than this, relative to the largest entry, share a group. */
#define GROUP_DISTANCE 0x1p-13

typedef struct {
    int n;
    long prec;
    const number *re, *im; /* the matrix; im may be NULL */
    complex_matrix v, w;   /* thin: the basis, and about its inverse */
    complex_matrix m;      /* w b v, then v^-1 b v */
    complex_matrix t;      /* scratch */
    int *group;
    double *scale;         /* powers of two */
} workspace;

static bool workspace_make(workspace *s, const number *b, const number *imaginary, int n, long prec)
{
    memset(s, 0, sizeof *s);
    s->n = n;
    s->prec = prec;
    s->re = b;
    s->im = imaginary;
    s->group = malloc(((size_t)n + 1) * sizeof *s->group);
    s->scale = malloc(((size_t)n + 1) * sizeof *s->scale);
    return complex_matrix_make(&s->v, n) && complex_matrix_make(&s->w, n) && complex_matrix_make(&s->m, n) && complex_matrix_make(&s->t, n) && s->group && s->scale;
}

static void workspace_free(workspace *s)
{
    complex_matrix_free(&s->v);
    complex_matrix_free(&s->w);
    complex_matrix_free(&s->m);
    complex_matrix_free(&s->t);
    free(s->group);
    free(s->scale);
}

static void load(complex_matrix *z, const double complex *a, long prec)
{
    for (int i = 0; i < z->n * z->n; i++) {
        number_set_double(&z->re[i], creal(a[i]), prec);
        number_set_double(&z->im[i], cimag(a[i]), prec);
    }
}

#define GUARD 32

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

/* The basis of a real matrix is a suggestion that costs less where it is real, too. */
static void make_real(double complex *v, double complex *w, int n)
{
    for (int j = 0; j < n; j++) {
        double complex phase;
        if (!is_nearly_real(&phase, v + j, n))
            continue;
        for (int i = 0; i < n; i++) {
            v[i * n + j] = creal(v[i * n + j] / phase);
            w[j * n + i] *= phase;
        }
    }
    for (int j = 0; j < n; j++) {
        double largest = 0;
        bool small = true;
        for (int i = 0; i < n; i++)
            largest = fmax(largest, cabs(w[j * n + i]));
        for (int i = 0; i < n; i++)
            small = small && fabs(cimag(w[j * n + i])) <= NEGLIGIBLE * largest;
        for (int i = 0; small && i < n; i++)
            w[j * n + i] = creal(w[j * n + i]);
    }
}

/* v and w from doubles.  TRUTH_FALSE: no memory. */
static truth start(workspace *s)
{
    size_t square = (size_t)s->n * (size_t)s->n;
    double complex *a = malloc((3 * square + 1) * sizeof *a);
    double largest = 0;
    truth found = TRUTH_FALSE;
    if (a) {
        for (size_t i = 0; i < square; i++) {
            a[i] = number_mid_approx(&s->re[i]) + (s->im ? number_mid_approx(&s->im[i]) : 0) * I;
            largest = fmax(largest, cabs(a[i]));
        }
        found = block_diagonalise_approx(a + square, a + 2 * square, s->group, a, s->n, GROUP_DISTANCE * largest) ? TRUTH_TRUE : TRUTH_UNKNOWN;
        if (found == TRUTH_TRUE && !s->im)
            make_real(a + square, a + 2 * square, s->n);
        if (found == TRUTH_TRUE) {
            load(&s->v, a + square, s->prec);
            load(&s->w, a + 2 * square, s->prec);
        }
    }
    free(a);
    return found;
}

/* m = w b v. */
static void transform(workspace *s)
{
    complex_matrix b = {s->n, (number *)s->re, (number *)s->im};
    number *zero = NULL;
    if (!s->im) {
        zero = number_array_new((size_t)s->n * (size_t)s->n);
        b.im = zero;
        if (!zero) {
            number_indeterminate(&s->m.re[0]);
            return;
        }
    }
    complex_matrix_multiply(&s->t, &b, &s->v, s->prec);
    complex_matrix_multiply(&s->m, &s->w, &s->t, s->prec);
    if (zero)
        number_array_free(zero, (size_t)s->n * (size_t)s->n);
}

/* t = 1 - w v. */
static void defect(workspace *s)
{
    number one;
    number_init(&one);
    number_one(&one);
    complex_matrix_multiply(&s->t, &s->w, &s->v, s->prec);
    for (int i = 0; i < s->n * s->n; i++) {
        number_neg(&s->t.re[i], &s->t.re[i]);
        number_neg(&s->t.im[i], &s->t.im[i]);
        if (i % (s->n + 1) == 0)
            number_add(&s->t.re[i], &s->t.re[i], &one, s->prec);
    }
    number_clear(&one);
}

/* z += x y, thin, by way of scratch. */
static void add_product(complex_matrix *z, const complex_matrix *x, const complex_matrix *y, complex_matrix *scratch, long prec)
{
    complex_matrix_multiply(scratch, x, y, prec);
    for (int i = 0; i < z->n * z->n; i++) {
        number_add(&z->re[i], &z->re[i], &scratch->re[i], prec);
        number_add(&z->im[i], &z->im[i], &scratch->im[i], prec);
    }
    complex_matrix_thin(z, prec);
}

/* (re, im) = (a, b) / (c, d). */
static void divide(number *re, number *im, const number *a, const number *b, const number *c, const number *d, long prec)
{
    number p, q, r;
    number_init(&p);
    number_init(&q);
    number_init(&r);
    number_sqr(&r, c, prec);
    number_addmul(&r, d, d, prec);
    number_mul(&p, a, c, prec);
    number_addmul(&p, b, d, prec);
    number_mul(&q, b, c, prec);
    number_submul(&q, a, d, prec);
    number_div(re, &p, &r, prec);
    number_div(im, &q, &r, prec);
    number_clear(&p);
    number_clear(&q);
    number_clear(&r);
}

/* w made the inverse of v as well as the precision allows, by Newton's method. */
static void improve_inverse(workspace *s)
{
    for (int step = 0; step < 2; step++) {
        defect(s);
        complex_matrix_thin(&s->t, s->prec);
        add_product(&s->w, &s->t, &s->w, &s->m, s->prec);
    }
}

/* One step towards a basis in which eigenvalues of different groups do not meet: v (1 + z) with
   z_ij = m_ij / (m_jj - m_ii), twice as many digits each time.  m must be v^-1 b v better than what is corrected, so w
   comes first. */
static void improve(workspace *s)
{
    int n = s->n;
    number c, d;
    number_init(&c);
    number_init(&d);
    improve_inverse(s);
    transform(s);
    complex_matrix_thin(&s->m, s->prec);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            number *re = &s->t.re[i * n + j], *im = &s->t.im[i * n + j];
            number_zero(re);
            number_zero(im);
            if (s->group[i] == s->group[j])
                continue;
            number_sub(&c, &s->m.re[j * n + j], &s->m.re[i * n + i], s->prec);
            number_sub(&d, &s->m.im[j * n + j], &s->m.im[i * n + i], s->prec);
            divide(re, im, &s->m.re[i * n + j], &s->m.im[i * n + j], &c, &d, s->prec);
        }
    complex_matrix_thin(&s->t, s->prec);
    add_product(&s->v, &s->v, &s->t, &s->m, s->prec);
    number_clear(&c);
    number_clear(&d);
}

/* With e = |1 - w v| < 1 in the row sum norm, v is invertible and v^-1 b v = (w v)^-1 (w b v); (w v)^-1 differs from 1 by
   at most f = e / (1 - e), so each entry of m in column j by at most f times that column's largest.  false: e is
   not certainly small. */
static bool account_for_defect(workspace *s)
{
    int n = s->n;
    bool ok;
    number e, sum, one, f, largest;
    number_init(&e);
    number_init(&sum);
    number_init(&one);
    number_init(&f);
    number_init(&largest);
    number_one(&one);
    transform(s);
    defect(s);
    for (int i = 0; i < n; i++) {
        number_zero(&sum);
        for (int j = 0; j < n; j++) {
            complex_magnitude_upper(&largest, &s->t.re[i * n + j], &s->t.im[i * n + j], s->prec);
            number_add(&sum, &sum, &largest, s->prec);
        }
        number_max(&e, &e, &sum, s->prec);
    }
    number_sub(&f, &one, &e, s->prec);
    ok = number_is_positive(&f) == TRUTH_TRUE;
    number_div(&f, &e, &f, s->prec);
    for (int j = 0; ok && j < n; j++) {
        number_zero(&largest);
        for (int i = 0; i < n; i++) {
            complex_magnitude_upper(&sum, &s->m.re[i * n + j], &s->m.im[i * n + j], s->prec);
            number_max(&largest, &largest, &sum, s->prec);
        }
        number_mul(&largest, &largest, &f, s->prec);
        for (int i = 0; i < n; i++) {
            number_add_error(&s->m.re[i * n + j], &s->m.re[i * n + j], &largest, s->prec);
            number_add_error(&s->m.im[i * n + j], &s->m.im[i * n + j], &largest, s->prec);
        }
    }
    number_clear(&e);
    number_clear(&sum);
    number_clear(&one);
    number_clear(&f);
    number_clear(&largest);
    return ok;
}

static double size_of(const workspace *s, int i, int j)
{
    double re = fmax(fabs(number_lower_bound(&s->m.re[i * s->n + j])), fabs(number_upper_bound(&s->m.re[i * s->n + j])));
    double im = fmax(fabs(number_lower_bound(&s->m.im[i * s->n + j])), fabs(number_upper_bound(&s->m.im[i * s->n + j])));
    return re + im;
}

/* Within a group of g eigenvalues the entries above the diagonal are of size t, all others of size h: position p of the
   group is scaled by d^p with d = (h / t)^(1/g), which makes both about t d. */
static void choose_scale(workspace *s)
{
    int n = s->n;
    for (int i = 0; i < n; i++)
        s->scale[i] = 1;
    for (int leader = 0; leader < n; leader++) {
        double above = 0, other = 0x1p-900, step;
        int members = 0;
        if (s->group[leader] != leader)
            continue;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                if (i != j && (s->group[i] == leader || s->group[j] == leader)) {
                    if (s->group[i] == s->group[j] && i < j)
                        above = fmax(above, size_of(s, i, j));
                    else
                        other = fmax(other, size_of(s, i, j));
                }
        for (int i = 0; i < n; i++)
            members += s->group[i] == leader;
        if (members == 1 || above <= other || !isfinite(above + other))
            continue;
        step = ldexp(1, ilogb(fmax(pow(other / above, 1.0 / members), exp2(-900.0 / members)))); /* so that no power of it underflows */
        double scale = 1;
        for (int i = 0; i < n; i++)
            if (s->group[i] == leader) {
                s->scale[i] = scale;
                scale *= step;
            }
    }
}

/* One disc per row of the scaled matrix: round the midpoint of m_ii. */
static void make_discs(eigenvalues *z, workspace *s)
{
    int n = s->n;
    number size, factor;
    number_init(&size);
    number_init(&factor);
    for (int i = 0; i < n; i++) {
        eigenvalue_disc *d = &z->disc[i];
        number_radius_upper(&d->radius, &s->m.re[i * n + i], s->prec);
        number_radius_upper(&size, &s->m.im[i * n + i], s->prec);
        number_add(&d->radius, &d->radius, &size, s->prec);
        number_midpoint(&d->re, &s->m.re[i * n + i], s->prec);
        number_midpoint(&d->im, &s->m.im[i * n + i], s->prec);
        for (int j = 0; j < n; j++) {
            if (j == i)
                continue;
            complex_magnitude_upper(&size, &s->m.re[i * n + j], &s->m.im[i * n + j], s->prec);
            number_set_double(&factor, s->scale[j] / s->scale[i], s->prec); /* a power of two: exact */
            number_addmul(&d->radius, &size, &factor, s->prec);
        }
        number_upper(&d->radius, &d->radius, s->prec);
        d->count = 1;
    }
    z->count = n;
    number_clear(&size);
    number_clear(&factor);
}

/* distance >= |difference of the centres|, thin. */
static void centre_distance_upper(number *distance, const eigenvalue_disc *x, const eigenvalue_disc *y, long prec)
{
    number re, im;
    number_init(&re);
    number_init(&im);
    number_sub(&re, &x->re, &y->re, prec);
    number_sub(&im, &x->im, &y->im, prec);
    complex_magnitude_upper(distance, &re, &im, prec);
    number_clear(&re);
    number_clear(&im);
}

/* Certainly disjoint?  They are if the centres differ by more than both radii in one coordinate. */
static bool are_disjoint(const eigenvalue_disc *x, const eigenvalue_disc *y, long prec)
{
    bool disjoint = false;
    number both, difference;
    number_init(&both);
    number_init(&difference);
    number_add(&both, &x->radius, &y->radius, prec);
    for (int part = 0; part < 2; part++) {
        number_sub(&difference, part ? &x->im : &x->re, part ? &y->im : &y->re, prec);
        number_abs(&difference, &difference);
        disjoint = disjoint || number_less(&both, &difference) == TRUTH_TRUE;
    }
    number_clear(&both);
    number_clear(&difference);
    return disjoint;
}

/* x becomes a disc round its old centre that contains both. */
static void merge(eigenvalue_disc *x, const eigenvalue_disc *y, long prec)
{
    number reach;
    number_init(&reach);
    centre_distance_upper(&reach, x, y, prec);
    number_add(&reach, &reach, &y->radius, prec);
    number_max(&x->radius, &x->radius, &reach, prec);
    number_upper(&x->radius, &x->radius, prec);
    x->count += y->count;
    number_clear(&reach);
}

static void swap_discs(eigenvalue_disc *x, eigenvalue_disc *y)
{
    eigenvalue_disc t = *x;
    *x = *y;
    *y = t;
}

/* Until all are disjoint: two discs that may meet become one with the sum of the counts.  (The union of discs that are
   disjoint from the others keeps its count when it is covered by a larger disc that is so, too.) */
static void merge_discs(eigenvalues *z, long prec)
{
    for (int changed = 1; changed;) {
        changed = 0;
        for (int i = 0; i < z->count; i++)
            for (int j = i + 1; j < z->count; j++)
                if (!are_disjoint(&z->disc[i], &z->disc[j], prec)) {
                    merge(&z->disc[i], &z->disc[j], prec);
                    swap_discs(&z->disc[j], &z->disc[z->count - 1]);
                    z->count--;
                    j--;
                    changed = 1;
                }
    }
}

/* The eigenvalues of a real matrix lie symmetrically.  A disc that may meet the real axis is moved onto it, and widened:
   if it still holds one eigenvalue when all discs are disjoint again, that one is real. */
static bool move_to_axis(eigenvalues *z, long prec)
{
    bool moved = false;
    number size;
    number_init(&size);
    for (int i = 0; i < z->count; i++) {
        eigenvalue_disc *d = &z->disc[i];
        number_abs(&size, &d->im);
        if (number_is_zero(&d->im) == TRUTH_TRUE || number_less(&d->radius, &size) == TRUTH_TRUE)
            continue;
        number_add(&d->radius, &d->radius, &size, prec);
        number_upper(&d->radius, &d->radius, prec);
        number_zero(&d->im);
        moved = true;
    }
    number_clear(&size);
    return moved;
}

static int by_falling_modulus(const void *x, const void *y)
{
    double a = ((const eigenvalue_disc *)x)->modulus, b = ((const eigenvalue_disc *)y)->modulus;
    return (a < b) - (a > b);
}

static truth finish(eigenvalues *z, workspace *s)
{
    make_discs(z, s);
    for (int i = 0; i < z->count; i++)
        if (!number_is_finite(&z->disc[i].radius))
            return number_lacks_memory(&z->disc[i].radius) ? TRUTH_FALSE : TRUTH_UNKNOWN;
    do
        merge_discs(z, s->prec);
    while (!s->im && move_to_axis(z, s->prec));
    for (int i = 0; i < z->count; i++)
        z->disc[i].real = !s->im && z->disc[i].count == 1 && number_is_zero(&z->disc[i].im) == TRUTH_TRUE;
    for (int i = 0; i < z->count; i++)
        z->disc[i].modulus = hypot(number_mid_approx(&z->disc[i].re), number_mid_approx(&z->disc[i].im));
    qsort(z->disc, (size_t)z->count, sizeof *z->disc, by_falling_modulus);
    return TRUTH_TRUE;
}

truth eigenvalues_enclose(eigenvalues *z, const number *b, const number *imaginary, int n, long prec)
{
    workspace s;
    truth found = TRUTH_FALSE;
    bool made = workspace_make(&s, b, imaginary, n, prec);
    z->size = n;
    z->count = 0;
    z->disc = malloc(((size_t)n + 1) * sizeof *z->disc);
    for (int i = 0; z->disc && i < n; i++) {
        number_init(&z->disc[i].re);
        number_init(&z->disc[i].im);
        number_init(&z->disc[i].radius);
    }
    if (made && z->disc)
        found = start(&s);
    if (found == TRUTH_TRUE) {
        for (long good = 45; good < prec; good *= 2) { /* as many digits as the step can make right, and some */
            s.prec = 2 * good + GUARD < prec ? 2 * good + GUARD : prec;
            improve(&s);
        }
        s.prec = prec;
        if (prec > 53)
            improve_inverse(&s);
        found = account_for_defect(&s) ? TRUTH_TRUE : TRUTH_UNKNOWN;
    }
    if (found == TRUTH_TRUE) {
        choose_scale(&s);
        found = finish(z, &s);
    }
    workspace_free(&s);
    return found;
}

void eigenvalues_free(eigenvalues *z)
{
    for (int i = 0; z->disc && i < z->size; i++) {
        number_clear(&z->disc[i].re);
        number_clear(&z->disc[i].im);
        number_clear(&z->disc[i].radius);
    }
    free(z->disc);
    z->disc = NULL;
}
