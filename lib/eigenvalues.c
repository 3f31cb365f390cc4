/* eigenvalues.c: Gershgorin's discs, component by component.  lib/eigenvalues.md has the proof. */
#include "eigenvalues.h"

#include "components.h"
#include "eigenbasis.h"

#include <math.h>
#include <stdlib.h>

/* One component of the matrix. */
typedef struct {
    int n;
    int *member;      /* its indices in the matrix */
    number *re, *im;  /* its entries; im may be NULL */
    complex_matrix m; /* similar to it */
    int *group;       /* in m: lib/eigenbasis.h */
    long *scale;      /* exponents of 2 */
} part;

static bool part_make(part *z, int n, bool is_complex)
{
    z->n = n;
    z->member = malloc((size_t)n * sizeof *z->member);
    z->re = number_array_new((size_t)n * (size_t)n);
    z->im = is_complex ? number_array_new((size_t)n * (size_t)n) : NULL;
    z->group = malloc((size_t)n * sizeof *z->group);
    z->scale = malloc((size_t)n * sizeof *z->scale);
    return complex_matrix_make(&z->m, n) && z->member && z->re && (!is_complex || z->im) && z->group && z->scale;
}

static void part_free(part *z)
{
    number_array_free(z->re, (size_t)z->n * (size_t)z->n);
    number_array_free(z->im, (size_t)z->n * (size_t)z->n);
    complex_matrix_free(&z->m);
    free(z->member);
    free(z->group);
    free(z->scale);
}

/* The entries of the component of `leader`. */
static void gather(part *z, const number *b, const number *imaginary, const int *component, int leader, int order)
{
    for (int i = 0, count = 0; i < order; i++)
        if (component[i] == leader)
            z->member[count++] = i;
    for (int i = 0; i < z->n * z->n; i++) {
        int from = z->member[i / z->n] * order + z->member[i % z->n];
        number_set(&z->re[i], &b[from]);
        if (imaginary)
            number_set(&z->im[i], &imaginary[from]);
    }
}

/* m and its groups: what is alone is its own eigenvalue. */
static truth diagonalise(part *z, long prec)
{
    if (z->n > 1)
        return eigenbasis_enclose(&z->m, z->group, z->re, z->im, z->n, prec);
    number_set(&z->m.re[0], &z->re[0]);
    if (z->im)
        number_set(&z->m.im[0], &z->im[0]);
    z->group[0] = 0;
    return TRUTH_TRUE;
}

static double size_of(const part *s, int i, int j)
{
    double re = fmax(fabs(number_lower_bound(&s->m.re[i * s->n + j])), fabs(number_upper_bound(&s->m.re[i * s->n + j])));
    double im = fmax(fabs(number_lower_bound(&s->m.im[i * s->n + j])), fabs(number_upper_bound(&s->m.im[i * s->n + j])));
    return re + im;
}

/* Within a group of g eigenvalues the entries above the diagonal are of size t, all others of size h: position p of the
   group is scaled by d^p with d = (h / t)^(1/g), which makes both about t d. */
static void choose_scale(part *s)
{
    int n = s->n;
    for (int i = 0; i < n; i++)
        s->scale[i] = 0;
    for (int leader = 0; leader < n; leader++) {
        double above = 0, other = 0x1p-900;
        long members = 0, step, exponent = 0;
        if (s->group[leader] != leader)
            continue;
        for (int i = 0; i < n; i++)
            members += s->group[i] == leader;
        for (int i = 0; members > 1 && i < n; i++)
            for (int j = 0; j < n; j++)
                if (i != j && (s->group[i] == leader || s->group[j] == leader)) {
                    if (s->group[i] == s->group[j] && i < j)
                        above = fmax(above, size_of(s, i, j));
                    else
                        other = fmax(other, size_of(s, i, j));
                }
        if (!(above > other) || !isfinite(above))
            continue;
        step = (long)floor((log2(other) - log2(above)) / (double)members);
        for (int i = 0; i < n; i++)
            if (s->group[i] == leader) {
                s->scale[i] = exponent;
                exponent += step;
            }
    }
}

/* *z = the disc of row i of the scaled matrix: round the midpoint of m_ii. */
static void make_disc(eigenvalue_disc *z, const part *s, int i, long prec)
{
    int n = s->n;
    number size;
    number_init(&size);
    number_radius_upper(&z->radius, &s->m.re[i * n + i], prec);
    number_radius_upper(&size, &s->m.im[i * n + i], prec);
    number_add(&z->radius, &z->radius, &size, prec);
    number_midpoint(&z->re, &s->m.re[i * n + i], prec);
    number_midpoint(&z->im, &s->m.im[i * n + i], prec);
    for (int j = 0; j < n; j++) {
        if (j == i)
            continue;
        complex_magnitude_upper(&size, &s->m.re[i * n + j], &s->m.im[i * n + j], prec);
        number_mul_2exp(&size, &size, s->scale[j] - s->scale[i], prec);
        number_add(&z->radius, &z->radius, &size, prec);
    }
    number_upper(&z->radius, &z->radius, prec);
    z->count = 1;
    number_clear(&size);
}

/* The discs of the component of `leader`, behind those that are there. */
static truth add_component(eigenvalues *z, const number *b, const number *imaginary, const int *component, int leader, long prec)
{
    part s;
    truth found = TRUTH_FALSE;
    int n = 0;
    for (int i = leader; i < z->size; i++)
        n += component[i] == leader;
    if (part_make(&s, n, imaginary != NULL)) {
        gather(&s, b, imaginary, component, leader, z->size);
        found = diagonalise(&s, prec);
    }
    if (found == TRUTH_TRUE) {
        choose_scale(&s);
        for (int i = 0; i < n; i++)
            make_disc(&z->disc[z->count++], &s, i, prec);
    }
    part_free(&s);
    return found;
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
    for (int side = 0; side < 2; side++) {
        number_sub(&difference, side ? &x->im : &x->re, side ? &y->im : &y->re, prec);
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

/* TRUTH_FALSE: no memory. */
static truth are_finite(const eigenvalues *z)
{
    for (int i = 0; i < z->count; i++)
        if (!number_is_finite(&z->disc[i].radius))
            return number_lacks_memory(&z->disc[i].radius) ? TRUTH_FALSE : TRUTH_UNKNOWN;
    return TRUTH_TRUE;
}

/* Disjoint discs, in order. */
static truth settle(eigenvalues *z, bool is_real, long prec)
{
    truth finite = are_finite(z);
    if (finite != TRUTH_TRUE)
        return finite;
    do
        merge_discs(z, prec);
    while (is_real && move_to_axis(z, prec));
    for (int i = 0; i < z->count; i++) {
        eigenvalue_disc *d = &z->disc[i];
        bool settles = d->count == 1 || number_is_zero(&d->radius) == TRUTH_TRUE;
        d->real = is_real && settles && number_is_zero(&d->im) == TRUTH_TRUE;
        d->modulus = hypot(number_mid_approx(&d->re), number_mid_approx(&d->im));
    }
    qsort(z->disc, (size_t)z->count, sizeof *z->disc, by_falling_modulus);
    return are_finite(z);
}

static bool make(eigenvalues *z, int n)
{
    z->size = n;
    z->count = 0;
    z->disc = malloc(((size_t)n + 1) * sizeof *z->disc);
    for (int i = 0; z->disc && i < n; i++) {
        number_init(&z->disc[i].re);
        number_init(&z->disc[i].im);
        number_init(&z->disc[i].radius);
    }
    return z->disc != NULL;
}

static bool find_components(int *component, const number *b, const number *imaginary, int n)
{
    bool *arrow = malloc((size_t)n * (size_t)n + 1);
    bool ok = arrow != NULL;
    for (int i = 0; ok && i < n * n; i++)
        arrow[i] = number_is_zero(&b[i]) != TRUTH_TRUE || (imaginary && number_is_zero(&imaginary[i]) != TRUTH_TRUE);
    ok = ok && components_find(component, arrow, n);
    free(arrow);
    return ok;
}

truth eigenvalues_enclose(eigenvalues *z, const number *b, const number *imaginary, int n, long prec)
{
    int *component = malloc(((size_t)n + 1) * sizeof *component);
    truth found = make(z, n) && component && find_components(component, b, imaginary, n) ? TRUTH_TRUE : TRUTH_FALSE;
    for (int i = 0; found == TRUTH_TRUE && i < n; i++)
        if (component[i] == i)
            found = add_component(z, b, imaginary, component, i, prec);
    free(component);
    return found == TRUTH_TRUE ? settle(z, imaginary == NULL, prec) : found;
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
