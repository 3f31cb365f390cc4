/* eigenpair.c: the equations, the Krawczyk operator, and the search for a box that it maps into itself.

   The unknowns are the components of x other than the pivot's, in order, then the eigenvalue.  The equations
   are F_i = (b x)_i - eigenvalue x_i = 0, i = 0..n-1.  In complex form (lib/eigenpair.h) both components of the pivot
   are fixed, the eigenvalue is alpha, beta, and F = b x - alpha x - beta J x. */
#include "eigenpair.h"

#include "eigen_approx.h"
#include "matrix_row.h"
#include "stop.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* Work space of one proof or search. */
typedef struct {
    int n, pivot;
    bool complex_form;
    const number *b;
    number *approximation; /* like a box: x with its 1, then the eigenvalue, thin where the number system can */
    number *residual;      /* n */
    number *derivative;    /* n x n */
    number *inverse;       /* n x n */
    number *row;           /* n, scratch */
    number *image;         /* n: Krawczyk operator minus the approximation */
} workspace;

static bool workspace_make(workspace *w, const number *b, int n, bool complex_form, int pivot)
{
    size_t square = (size_t)n * (size_t)n;
    w->n = n;
    w->pivot = pivot;
    w->complex_form = complex_form;
    w->b = b;
    w->approximation = number_array_new(eigenpair_box_size(n, complex_form));
    w->residual = number_array_new((size_t)n);
    w->derivative = number_array_new(square);
    w->inverse = number_array_new(square);
    w->row = number_array_new((size_t)n);
    w->image = number_array_new((size_t)n);
    return w->approximation && w->residual && w->derivative && w->inverse && w->row && w->image;
}

static void free_numbers(number *a, size_t count)
{
    if (a)
        number_array_free(a, count);
}

static void workspace_free(workspace *w)
{
    size_t n = (size_t)w->n;
    free_numbers(w->approximation, eigenpair_box_size(w->n, w->complex_form));
    free_numbers(w->residual, n);
    free_numbers(w->derivative, n * n);
    free_numbers(w->inverse, n * n);
    free_numbers(w->row, n);
    free_numbers(w->image, n);
}

/* Where the unknown number l is in a box. */
static int component(const workspace *w, int l)
{
    if (!w->complex_form)
        return l == w->n - 1 ? w->n : l < w->pivot ? l : l + 1;
    if (l >= w->n - 2)
        return l + 2;
    l += l >= w->pivot;
    return l + (l >= w->pivot + w->n / 2);
}

/* Is component j of x fixed, to 1 or (the imaginary part) to 0? */
static bool is_fixed(const workspace *w, int j)
{
    return j == w->pivot || (w->complex_form && j == w->pivot + w->n / 2);
}

static void fix(number *x, const workspace *w)
{
    number_one(&x[w->pivot]);
    if (w->complex_form)
        number_zero(&x[w->pivot + w->n / 2]);
}

/* (J x)_i = x_j, or -x_j if *minus; returns j. */
static int turned(bool *minus, const workspace *w, int i)
{
    *minus = i < w->n / 2;
    return *minus ? i + w->n / 2 : i - w->n / 2;
}

/* residual = F(x, eigenvalue). */
static void evaluate(workspace *w, const number *x, long prec)
{
    for (int i = 0; i < w->n; i++) {
        number *f = &w->residual[i];
        number_zero(f);
        for (int j = 0; j < w->n; j++)
            number_addmul(f, &w->b[i * w->n + j], &x[j], prec);
        number_submul(f, &x[w->n], &x[i], prec);
        if (w->complex_form) {
            bool minus;
            int j = turned(&minus, w, i);
            if (minus)
                number_addmul(f, &x[w->n + 1], &x[j], prec);
            else
                number_submul(f, &x[w->n + 1], &x[j], prec);
        }
    }
}

/* g = minus (J x)_i. */
static void differentiate_by_imaginary(number *g, const workspace *w, const number *x, int i)
{
    bool minus;
    int j = turned(&minus, w, i);
    if (minus)
        number_set(g, &x[j]);
    else
        number_neg(g, &x[j]);
}

/* g = minus beta J_ij, for a g that is b_ij or b_ii - alpha. */
static void subtract_turn(number *g, const workspace *w, const number *x, int i, int j, long prec)
{
    bool minus;
    if (turned(&minus, w, i) != j)
        return;
    if (minus)
        number_add(g, g, &x[w->n + 1], prec);
    else
        number_sub(g, g, &x[w->n + 1], prec);
}

/* derivative = F' at (for all points of) x, eigenvalue. */
static void differentiate(workspace *w, const number *x, long prec)
{
    for (int i = 0; i < w->n; i++)
        for (int l = 0; l < w->n; l++) {
            int j = component(w, l);
            number *g = &w->derivative[i * w->n + l];
            if (j == w->n) {
                number_neg(g, &x[i]);
            } else if (j == w->n + 1) {
                differentiate_by_imaginary(g, w, x, i);
            } else {
                number_set(g, &w->b[i * w->n + j]);
                if (i == j)
                    number_sub(g, g, &x[w->n], prec);
                if (w->complex_form)
                    subtract_turn(g, w, x, i, j, prec);
            }
        }
}

/* image = -Y F(approximation). */
static void newton(workspace *w, long prec)
{
    for (int i = 0; i < w->n; i++) {
        number_zero(&w->image[i]);
        for (int l = 0; l < w->n; l++)
            number_submul(&w->image[i], &w->inverse[i * w->n + l], &w->residual[l], prec);
    }
}

/* image = -Y F(approximation) + (I - Y F') [-radius, radius]; indeterminate if there is no time for it. */
static void krawczyk(workspace *w, const number *radius, long prec)
{
    number spread;
    number_init(&spread);
    number_add_error(&spread, &spread, radius, prec);
    newton(w, prec);
    for (int i = 0; i < w->n; i++) {
        for (int l = 0; l < w->n; l++)
            number_set_si(&w->row[l], i == l, prec);
        matrix_add_row(w->row, &w->inverse[i * w->n], w->derivative, w->n, true, prec);
        for (int l = 0; l < w->n; l++)
            number_addmul(&w->image[i], &w->row[l], &spread, prec);
        if (stop_now()) {
            number_indeterminate(&w->image[w->n - 1]);
            break;
        }
    }
    number_clear(&spread);
}

static void load(workspace *w, const eigenpair_choice *c, long prec)
{
    for (int l = 0; l < w->n; l++)
        number_set_integer_2exp(&w->approximation[component(w, l)], &c->approximation[l], -c->grid, prec);
    fix(w->approximation, w);
    for (int i = 0; i < w->n * w->n; i++)
        number_set_integer_2exp(&w->inverse[i], &c->inverse[i], -EIGENPAIR_INVERSE_BITS, prec);
}

/* box = approximation +- radius, but for what is fixed. */
static void make_box(number *box, const workspace *w, const number *radius, long prec)
{
    for (int j = 0; j < (int)eigenpair_box_size(w->n, w->complex_form); j++) {
        if (is_fixed(w, j))
            number_set(&box[j], &w->approximation[j]);
        else
            number_add_error(&box[j], &w->approximation[j], radius, prec);
    }
}

/* Is every component of the image strictly inside (-radius, radius)? */
static truth is_inside(const workspace *w, const number *radius)
{
    truth inside = TRUTH_TRUE;
    number minus;
    number_init(&minus);
    number_neg(&minus, radius);
    for (int i = 0; i < w->n && inside != TRUTH_FALSE; i++) {
        if (number_less(&w->image[i], radius) != TRUTH_TRUE || number_less(&minus, &w->image[i]) != TRUTH_TRUE)
            inside = TRUTH_UNKNOWN;
        if (number_lacks_memory(&w->image[i]))
            inside = TRUTH_FALSE;
    }
    number_clear(&minus);
    return inside;
}

/* Proves it for a box of `size` units round what is loaded. */
static truth prove_loaded(number *box, workspace *w, const eigenpair_choice *choice, const integer *size, long prec)
{
    number radius;
    truth proved;
    number_init(&radius);
    number_set_integer_2exp(&radius, size, -choice->grid, prec);
    make_box(box, w, &radius, prec);
    evaluate(w, w->approximation, prec);
    differentiate(w, box, prec);
    krawczyk(w, &radius, prec);
    proved = is_inside(w, &radius);
    number_clear(&radius);
    return proved;
}

static truth prove(number *box, const eigenpair_choice *choice, const integer *size, const number *b, long prec)
{
    workspace w;
    truth proved = TRUTH_FALSE;
    if (choice->complex_form && (choice->n % 2 || choice->pivot >= choice->n / 2))
        return TRUTH_UNKNOWN; /* a choice that somebody else made */
    if (workspace_make(&w, b, choice->n, choice->complex_form, choice->pivot)) {
        load(&w, choice, prec);
        proved = prove_loaded(box, &w, choice, size, prec);
    }
    workspace_free(&w);
    return proved;
}

truth eigenpair_prove(number *box, const eigenpair_choice *choice, const number *b, long prec)
{
    return prove(box, choice, &choice->radius, b, prec);
}

truth eigenpair_prove_range(number *box, const eigenpair_choice *choice, const number *b, long prec)
{
    return prove(box, choice, &choice->range, b, prec);
}

/* ---- the search ---- */

/* approximation = the eigenpair that doubles find; inverse = roughly the inverse of F' there, on its grid.
   TRUTH_UNKNOWN: they find none.  TRUTH_FALSE: no memory. */
static truth start(workspace *w, double *work, eigenpair_choice *choice, long prec)
{
    int n = w->n;
    size_t square = (size_t)n * (size_t)n;
    double *b = work, *inverse = work + square, *x = work + 2 * square, eigenvalue, imaginary = 0;
    truth found;
    for (int i = 0; i < n * n; i++)
        b[i] = number_mid_approx(&w->b[i]);
    found = w->complex_form ? eigen_dominant_complex_approx(&eigenvalue, &imaginary, x, &w->pivot, b, n) : eigen_dominant_approx(&eigenvalue, x, &w->pivot, b, n);
    if (found != TRUTH_TRUE)
        return found;
    choice->pivot = w->pivot;
    for (int j = 0; j < n; j++)
        number_set_double(&w->approximation[j], x[j], prec);
    fix(w->approximation, w);
    number_set_double(&w->approximation[n], eigenvalue, prec);
    if (w->complex_form)
        number_set_double(&w->approximation[n + 1], imaginary, prec);
    differentiate(w, w->approximation, prec);
    for (int i = 0; i < n * n; i++)
        b[i] = number_mid_approx(&w->derivative[i]);
    found = matrix_inverse_approx(inverse, b, n);
    if (found != TRUTH_TRUE)
        return found;
    for (int i = 0; i < n * n; i++) {
        number_set_double(&w->inverse[i], inverse[i], prec);
        if (!(fabs(inverse[i]) < 0x1p60))
            return TRUTH_UNKNOWN;
        if (!number_mid_grid(&choice->inverse[i], &w->inverse[i], EIGENPAIR_INVERSE_BITS))
            return TRUTH_FALSE;
        number_set_integer_2exp(&w->inverse[i], &choice->inverse[i], -EIGENPAIR_INVERSE_BITS, prec);
    }
    return TRUTH_TRUE;
}

/* The least n with |x| <= 2^(n - unit) for all numbers of x, at least 0; a large number if there is none. */
static long bits_above(const number *x, long unit, long prec)
{
    long bits = LONG_MAX;
    number size;
    integer m;
    number_init(&size);
    integer_init(&m);
    number_magnitude_upper(&size, x, prec);
    if (number_upper_grid(&m, &size, unit))
        bits = (long)integer_bits(&m);
    number_clear(&size);
    integer_clear(&m);
    return bits;
}

static long largest_bits(const workspace *w, long unit, long prec)
{
    long most = 0;
    for (int l = 0; l < w->n; l++) {
        long bits = bits_above(&w->image[l], unit, prec);
        most = bits > most ? bits : most;
    }
    return most;
}

/* approximation -= Y F(approximation), about 30 bits better each time; returns the size of the step in bits above
   2^-unit. */
static long improve(workspace *w, long unit, long prec)
{
    long size;
    evaluate(w, w->approximation, prec);
    newton(w, prec);
    size = largest_bits(w, unit, prec);
    for (int l = 0; l < w->n; l++) {
        number *z = &w->approximation[component(w, l)];
        number_add(z, z, &w->image[l], prec);
        number_midpoint(z, z, prec);
    }
    return size;
}

/* Takes the approximation over as integers; the radius starts at the size of -Y F there and grows until the proof
   succeeds, then once more, so that rounding differently costs nothing. */
static truth settle(workspace *w, eigenpair_choice *choice, long prec)
{
    number *box = number_array_new(eigenpair_box_size(w->n, w->complex_form));
    long bits = 0;
    truth proved = box ? TRUTH_UNKNOWN : TRUTH_FALSE;
    for (int l = 0; proved == TRUTH_UNKNOWN && l < w->n; l++)
        if (!number_mid_grid(&choice->approximation[l], &w->approximation[component(w, l)], choice->grid))
            proved = TRUTH_FALSE;
    if (proved == TRUTH_UNKNOWN) {
        load(w, choice, prec);
        evaluate(w, w->approximation, prec);
        newton(w, prec);
        bits = largest_bits(w, choice->grid, prec) + 1;
    }
    for (bits = bits < 3 ? 3 : bits; proved == TRUTH_UNKNOWN && bits < choice->grid; bits += 2) {
        integer_set_si(&choice->radius, 1);
        if (!integer_mul_2exp(&choice->radius, &choice->radius, (unsigned long)bits))
            proved = TRUTH_FALSE;
        else
            proved = eigenpair_prove(box, choice, w->b, prec);
        if (proved == TRUTH_TRUE && !integer_mul_2exp(&choice->radius, &choice->radius, 2))
            proved = TRUTH_FALSE;
    }
    free_numbers(box, eigenpair_box_size(w->n, w->complex_form));
    return proved;
}

/* TRUTH_UNKNOWN: of some nothing is known.  TRUTH_FALSE: for want of memory. */
static truth all_are_finite(const number *b, size_t size)
{
    truth t = TRUTH_TRUE;
    for (size_t i = 0; i < size && t != TRUTH_FALSE; i++)
        if (!number_is_finite(&b[i]))
            t = number_lacks_memory(&b[i]) ? TRUTH_FALSE : TRUTH_UNKNOWN;
    return t;
}

truth eigenpair_choose(eigenpair_choice *z, const number *b, int n, bool complex_form, long g, long prec)
{
    workspace w;
    size_t square = (size_t)n * (size_t)n;
    double *work = malloc((2 * square + (size_t)n) * sizeof *work);
    truth found = TRUTH_FALSE;
    bool made = workspace_make(&w, b, n, complex_form, 0);
    if (made && work && eigenpair_choice_make(z, n, g)) {
        z->complex_form = complex_form;
        found = all_are_finite(b, square);
        if (found == TRUTH_TRUE)
            found = start(&w, work, z, prec);
        if (found == TRUTH_TRUE) {
            long unit = g + 64, step = unit, last;
            do {
                last = step;
                step = improve(&w, unit, prec);
            } while (step < last);
            found = settle(&w, z, prec);
        }
    }
    workspace_free(&w);
    free(work);
    return found;
}

/* ---- the search for a range ---- */

/* At least the largest magnitude in the image, in units of 2^-unit.  false: no memory, or there is none. */
static bool image_size(integer *size, const workspace *w, long unit, long prec)
{
    number one, largest;
    bool ok;
    number_init(&one);
    number_init(&largest);
    for (int l = 0; l < w->n; l++) {
        number_magnitude_upper(&one, &w->image[l], prec);
        number_max(&largest, &largest, &one, prec);
    }
    ok = number_upper_grid(size, &largest, unit);
    number_clear(&one);
    number_clear(&largest);
    return ok;
}

/* x = 17/16 x, rounded upward. */
static bool enlarge(integer *x)
{
    integer part;
    bool ok;
    integer_init(&part);
    ok = integer_cdiv_2exp(&part, x, 4) && integer_add(x, x, &part);
    integer_clear(&part);
    return ok;
}

/* The image of a box that is too small says how large it has to be at least. */
static truth grow(integer *size, workspace *w, const eigenpair_choice *z, number *box, long prec)
{
    truth proved = TRUTH_UNKNOWN;
    while (proved == TRUTH_UNKNOWN && (long)integer_bits(size) < z->grid) {
        if (!enlarge(size))
            return TRUTH_FALSE;
        proved = prove_loaded(box, w, z, size, prec);
        if (proved == TRUTH_UNKNOWN && !image_size(size, w, z->grid, prec))
            return number_lacks_memory(&w->image[0]) ? TRUTH_FALSE : TRUTH_UNKNOWN;
    }
    return proved;
}

/* size, the radius or the range of z, grows. */
static truth choose_size(integer *size, eigenpair_choice *z, const number *b, long prec)
{
    workspace w;
    number *box = number_array_new(eigenpair_box_size(z->n, z->complex_form));
    truth found = TRUTH_FALSE;
    if (workspace_make(&w, b, z->n, z->complex_form, z->pivot) && box) {
        load(&w, z, prec);
        found = all_are_finite(b, (size_t)z->n * (size_t)z->n);
        if (found == TRUTH_TRUE)
            found = grow(size, &w, z, box, prec);
    }
    workspace_free(&w);
    free_numbers(box, eigenpair_box_size(z->n, z->complex_form));
    return found;
}

truth eigenpair_choose_radius(eigenpair_choice *z, const number *b, long prec)
{
    integer_set_si(&z->radius, 1);
    return choose_size(&z->radius, z, b, prec);
}

truth eigenpair_choose_range(eigenpair_choice *z, const number *b, long prec)
{
    return integer_set(&z->range, &z->radius) ? choose_size(&z->range, z, b, prec) : TRUTH_FALSE;
}

void eigenpair_modulus(number *z, const number *box, int n, bool complex_form, long prec)
{
    number square;
    if (!complex_form) {
        number_abs(z, &box[n]);
        return;
    }
    number_init(&square);
    number_sqr(&square, &box[n + 1], prec);
    number_sqr(z, &box[n], prec);
    number_add(z, z, &square, prec);
    number_sqrt(z, z, prec);
    number_clear(&square);
}
