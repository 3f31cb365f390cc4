/* bernstein.c: box splines, one direction after the other, by integration.

   Let N_X be the box spline of the directions X: its mask is 4 times the product over d in X of (1 + z^d)/2, and the limit
   of the delta at y for that mask times z^s is N_X(u - y - s).  Then

       N_X(u) = integral over t from 0 to 1 of N_(X - d)(u - t d),

   so the derivative of N_X along d is N_(X - d)(u) - N_(X - d)(u - d), and along lines in direction d N_X is continuous and begins with
   0.  In Bernstein form: a polynomial of degree n on a triangle with the vertices P, Q, R, Q - P = d, whose
   derivative along d has the coefficients g, satisfies b(p, q+1, r) = b(p+1, q, r) + g(p, q, r)/n, and its coefficients b(p, 0, r)
   on the edge PR, where lines enter, are those of the triangle before.  The first two directions make the indicator
   of a parallelogram, which is two triangles.  Squares are the same in each direction by itself. */
#include "bernstein.h"

#include <stdlib.h>
#include <string.h>

void bernstein_init(bernstein *z)
{
    memset(z, 0, sizeof *z);
}

static rational *new_rationals(size_t count)
{
    rational *a = malloc((count ? count : 1) * sizeof *a);
    for (size_t i = 0; a && i < count; i++)
        rational_init(&a[i]);
    return a;
}

static void free_rationals(rational *a, size_t count)
{
    for (size_t i = 0; a && i < count; i++)
        rational_clear(&a[i]);
    free(a);
}

bool bernstein_get(rational *z, const bernstein *b, element_type type, int row, int column)
{
    int p = b->degree[0], q = b->degree[1], across = b->labels[type][1];
    if (b->entry[type])
        return rational_set(z, &b->entry[type][row * b->columns[type] + column]);
    int rows = type == ELEMENT_ALONG_SECOND ? 1 : p + 1; /* for each j */
    return rational_mul(z, &b->spline[0][(p - column / across) * (p + 1) + row % rows], &b->spline[1][(q - column % across) * (q + 1) + row / rows]);
}

void bernstein_clear(bernstein *z)
{
    for (int t = 0; t < ELEMENT_TYPES; t++)
        free_rationals(z->entry[t], (size_t)z->rows[t] * (size_t)z->columns[t]);
    for (int d = 0; d < 2; d++)
        free_rationals(z->spline[d], (size_t)(z->degree[d] + 1) * (size_t)(z->degree[d] + 1));
    bernstein_init(z);
}

/* ---- shapes ---- */

bernstein_shape bernstein_get_shape(const bernstein *b, element_type type)
{
    bernstein_shape s = {!element_is_segment(type) && element_is_of(type, MESH_TRIANGLE), {b->degree[0], b->degree[1]}};
    if (element_is_segment(type))
        s.degree[type == ELEMENT_ALONG_SECOND ? 0 : 1] = 0;
    return s;
}

bernstein_shape bernstein_shape_product(bernstein_shape x, bernstein_shape y)
{
    x.degree[0] += y.degree[0];
    x.degree[1] += y.degree[1];
    return x;
}

int bernstein_shape_size(bernstein_shape s)
{
    return s.triangle ? (s.degree[0] + 1) * (s.degree[0] + 2) / 2 : (s.degree[0] + 1) * (s.degree[1] + 1);
}

static int64_t binomial(int n, int k)
{
    int64_t c = 1;
    for (int i = 1; i <= k; i++)
        c = c * (n - k + i) / i;
    return c;
}

int64_t bernstein_shape_multiplicity(bernstein_shape s, int i, int j)
{
    return s.triangle ? binomial(s.degree[0], j) * binomial(s.degree[0] - j, i) : binomial(s.degree[0], i) * binomial(s.degree[1], j);
}

/* ---- factors of the mask ---- */

enum { DIRECTIONS = 3 };
static const lattice direction[DIRECTIONS] = {{1, 0}, {0, 1}, {1, -1}};

/* mask = 4 z^shift times the product of ((1 + z^d)/2)^times[d]. */
typedef struct {
    int times[DIRECTIONS];
    lattice shift;
} factors;

/* Divides rest by 1 + z^-d as often as that leaves no remainder. */
static bool divide_out(int *times, laurent *rest, lattice d)
{
    laurent quotient;
    bool exact = true, ok = true;
    laurent_init(&quotient);
    for (*times = 0; ok && exact && *times <= BERNSTEIN_MAX_DEGREE + 2;) {
        ok = laurent_divide_binomial(&quotient, &exact, rest, d);
        if (ok && exact) {
            laurent_swap(rest, &quotient);
            ++*times;
        }
    }
    laurent_clear(&quotient);
    return ok;
}

/* Is rest one power, with the weight 4 / 2^halves? */
static bool is_monomial(lattice *power, bool *is, const laurent *rest, int halves)
{
    int count = 0;
    bool ok = true;
    rational weight;
    rational_init(&weight);
    *is = false;
    for (long a = rest->a0; a < rest->a0 + rest->na; a++)
        for (long b = rest->b0; b < rest->b0 + rest->nb; b++)
            if (!laurent_is_zero_at(rest, a, b)) {
                *power = (lattice){(int)a, (int)b};
                count++;
            }
    if (count == 1) {
        ok = laurent_get(&weight, rest, power->a, power->b) && rational_mul_2exp(&weight, &weight, halves - 2);
        *is = ok && rational_cmp_si(&weight, 1, 1) == 0;
    }
    rational_clear(&weight);
    return ok;
}

/* *found: the mask is a product of such factors, with directions that span the plane. */
static bool factorise(factors *z, bool *found, mesh_kind mesh, const laurent *mask)
{
    int halves = 0, different = 0;
    laurent rest;
    bool ok;
    laurent_init(&rest);
    memset(z, 0, sizeof *z);
    ok = laurent_set(&rest, mask);
    for (int d = 0; ok && d < (mesh == MESH_TRIANGLE ? 3 : 2); d++) {
        ok = divide_out(&z->times[d], &rest, direction[d]);
        halves += z->times[d];
        different += z->times[d] > 0;
    }
    ok = ok && is_monomial(&z->shift, found, &rest, halves);
    for (int d = 0; d < DIRECTIONS; d++) { /* 1 + z^-d = z^-d (1 + z^d) */
        z->shift.a -= z->times[d] * direction[d].a;
        z->shift.b -= z->times[d] * direction[d].b;
    }
    *found = ok && *found && different >= 2;
    laurent_clear(&rest);
    return ok;
}

/* ---- squares ---- */

/* The B-spline of degree n on [0, n+1]: piece l, on [l, l+1], has the coefficients c[l (n+1)] to c[l (n+1) + n].  On failure
   *c = NULL. */
static bool make_spline(rational **c, int n)
{
    rational *old = new_rationals(1), *next = NULL, part, g;
    size_t count = 1;
    bool ok = old && rational_set_si(&old[0], 1, 1);
    rational_init(&part);
    rational_init(&g);
    for (int p = 1; ok && p <= n; p++) {
        ok = rational_set_si(&part, 1, p);
        next = new_rationals((size_t)(p + 1) * (size_t)(p + 1));
        ok = ok && next;
        for (int l = 0; ok && l <= p; l++) {
            rational *b = &next[l * (p + 1)];
            if (l > 0)
                ok = rational_set(&b[0], &b[-1]);
            for (int j = 0; ok && j < p; j++) {
                ok = l == p || rational_set(&g, &old[l * p + j]);
                if (ok && l == p)
                    ok = rational_set_si(&g, 0, 1);
                ok = ok && (l == 0 || rational_sub(&g, &g, &old[(l - 1) * p + j])) && rational_mul(&g, &g, &part) && rational_add(&b[j + 1], &b[j], &g);
            }
        }
        free_rationals(old, count);
        old = next;
        count = (size_t)(p + 1) * (size_t)(p + 1);
    }
    rational_clear(&part);
    rational_clear(&g);
    if (!ok) {
        free_rationals(old, count);
        old = NULL;
    }
    *c = old;
    return ok;
}

/* All of the square's polynomial, or one of its sides.  The B-spline of the degree n has n + 1 pieces, which are those of the
   labels n, n - 1 ... in this order; at a knot the piece 0 vanishes, and limits jump if n = 0. */
static void fill_square(bernstein *z, element_type type)
{
    int across = type == ELEMENT_ALONG_FIRST ? 1 : type == ELEMENT_ALONG_SECOND ? 0 : -1;
    if (across >= 0 && z->degree[across] == 0)
        return;
    z->rows[type] = z->columns[type] = 1;
    for (int d = 0; d < 2; d++) {
        z->labels[type][d] = z->degree[d] + (d != across);
        z->columns[type] *= z->labels[type][d];
        z->rows[type] *= d == across ? 1 : z->degree[d] + 1;
    }
}

static bool make_squares(bernstein *z)
{
    for (int d = 0; d < 2; d++)
        if (!make_spline(&z->spline[d], z->degree[d]))
            return false;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        if (element_is_of((element_type)t, MESH_QUAD))
            fill_square(z, (element_type)t);
    return true;
}

/* ---- triangles ---- */

/* A box spline: its polynomials on UP(a,b) and DOWN(a,b), 0 <= a < na, b0 <= b < b0 + nb, and 0 elsewhere. */
typedef struct {
    int na, b0, nb;
    int degree, size; /* size coefficients for each triangle */
    rational *c;
} pieces;

/* An index of a polynomial of degree n on a triangle, by the indices of v1 and v2. */
static int index_of(int n, int j, int l)
{
    return l * (n + 1) - l * (l - 1) / 2 + j;
}

static size_t pieces_count(const pieces *z)
{
    return (size_t)(2 * z->na * z->nb * z->size);
}

static bool pieces_make(pieces *z, const factors *f, int degree)
{
    z->na = f->times[0] + f->times[2];
    z->b0 = -f->times[2];
    z->nb = f->times[1] + f->times[2];
    z->degree = degree;
    z->size = (degree + 1) * (degree + 2) / 2;
    z->c = new_rationals(pieces_count(z));
    return z->c != NULL;
}

/* The coefficients on a triangle; NULL: all are 0. */
static rational *piece_at(const pieces *z, element_type type, int a, int b)
{
    if (a < 0 || a >= z->na || b < z->b0 || b >= z->b0 + z->nb)
        return NULL;
    return &z->c[((a * z->nb + b - z->b0) * 2 + (type == ELEMENT_DOWN)) * z->size];
}

/* How lines in a direction d run through a triangle: in at the edge PR, along PQ.  The triangle before is of the other type
   and has the vertices R - d, R, P. */
typedef struct {
    int p, q, r;    /* which vertices they are */
    lattice before; /* where the triangle before lies; its Q is our R, and its R our P */
} passage;

static const passage passages[2][DIRECTIONS] = {
    [ELEMENT_UP] = {{0, 1, 2, {-1, 0}}, {0, 2, 1, {0, -1}}, {2, 1, 0, {-1, 0}}},
    [ELEMENT_DOWN] = {{1, 0, 2, {0, 0}}, {2, 0, 1, {0, 0}}, {1, 2, 0, {0, 1}}},
};

/* The coefficient with the indices p, q, r of P, Q, R. */
static int index_by(const passage *s, int n, int p, int q, int r)
{
    int k[3];
    k[s->p] = p;
    k[s->q] = q;
    k[s->r] = r;
    return index_of(n, k[1], k[2]);
}

/* g = the coefficient of the derivative along d, from the spline without d. */
static bool derivative_at(rational *g, const pieces *old, element_type type, int a, int b, int d, int index)
{
    const rational *here = piece_at(old, type, a, b), *back = piece_at(old, type, a - direction[d].a, b - direction[d].b);
    bool ok = here ? rational_set(g, &here[index]) : rational_set_si(g, 0, 1);
    return ok && (!back || rational_sub(g, g, &back[index]));
}

static bool integrate_piece(pieces *z, const pieces *old, element_type type, int a, int b, int d)
{
    element_type other = type == ELEMENT_UP ? ELEMENT_DOWN : ELEMENT_UP;
    const passage *s = &passages[type][d], *s_before = &passages[other][d];
    rational *c = piece_at(z, type, a, b), part, g;
    const rational *before = piece_at(z, other, a + s->before.a, b + s->before.b);
    int n = z->degree;
    bool ok;
    rational_init(&part);
    rational_init(&g);
    ok = rational_set_si(&part, 1, n);
    for (int r = 0; ok && before && r <= n; r++)
        ok = rational_set(&c[index_by(s, n, n - r, 0, r)], &before[index_by(s_before, n, 0, r, n - r)]);
    for (int q = 1; q <= n; q++)
        for (int r = 0; ok && r <= n - q; r++) {
            int p = n - q - r;
            ok = derivative_at(&g, old, type, a, b, d, index_by(s, n - 1, p, q - 1, r)) && rational_mul(&g, &g, &part)
                 && rational_add(&c[index_by(s, n, p, q, r)], &c[index_by(s, n, p + 1, q - 1, r)], &g);
        }
    rational_clear(&part);
    rational_clear(&g);
    return ok;
}

/* z = the spline with one direction more.  Triangles before come first: by growing b for e2, by growing a for the others, and
   UP before DOWN. */
static bool integrate(pieces *z, const pieces *old, int d)
{
    bool ok = true;
    int outer = d == 1 ? z->nb : z->na, inner = d == 1 ? z->na : z->nb;
    for (int i = 0; i < outer; i++)
        for (int type = ELEMENT_UP; type <= ELEMENT_DOWN; type++)
            for (int j = 0; ok && j < inner; j++)
                ok = integrate_piece(z, old, (element_type)type, d == 1 ? j : i, z->b0 + (d == 1 ? i : j), d);
    return ok;
}

/* The indicator of the parallelogram of the first two directions that f has; `left` are the others. */
static bool begin(pieces *z, factors *left, const factors *f)
{
    bool e1 = f->times[0] > 0, e2 = f->times[1] > 0;
    lattice up = {e1 && !e2, e1 && !e2 ? -1 : 0}, down = {0, e1 && e2 ? 0 : -1};
    *left = *f;
    if (e1)
        left->times[0]--;
    if (e2)
        left->times[1]--;
    if (!e1 || !e2)
        left->times[2]--;
    return pieces_make(z, f, 0) && rational_set_si(piece_at(z, ELEMENT_UP, up.a, up.b), 1, 1) && rational_set_si(piece_at(z, ELEMENT_DOWN, down.a, down.b), 1, 1);
}

static bool make_box_spline(pieces *z, const factors *f)
{
    factors left;
    bool ok = begin(z, &left, f);
    for (int d = 0; d < DIRECTIONS; d++)
        for (; ok && left.times[d] > 0; left.times[d]--) {
            pieces next;
            ok = pieces_make(&next, f, z->degree + 1) && integrate(&next, z, d);
            free_rationals(z->c, pieces_count(z));
            *z = next;
        }
    return ok;
}

/* Is the spline continuous: do its directions still span the plane when any one is taken away? */
static bool is_continuous(const factors *f)
{
    int different = (f->times[0] > 0) + (f->times[1] > 0) + (f->times[2] > 0);
    return different == 3 || (f->times[0] != 1 && f->times[1] != 1 && f->times[2] != 1);
}

/* EDGE is the side of UP where the index of v0 is 0. */
static bool fill_triangle(bernstein *z, element_type type, const factors *f, const element_window *w, const pieces *spline)
{
    int n = spline->degree;
    bool ok, edge = type == ELEMENT_EDGE;
    z->rows[type] = edge ? n + 1 : spline->size;
    z->columns[type] = w->count;
    z->entry[type] = new_rationals((size_t)z->rows[type] * (size_t)w->count);
    ok = z->entry[type] != NULL;
    for (int y = 0; y < w->count; y++) {
        const rational *c = piece_at(spline, edge ? ELEMENT_UP : type, -w->point[y].a - f->shift.a, -w->point[y].b - f->shift.b);
        for (int row = 0; ok && c && row < z->rows[type]; row++)
            ok = rational_set(&z->entry[type][row * w->count + y], &c[edge ? index_of(n, n - row, row) : row]);
    }
    return ok;
}

static bool make_triangles(bernstein *z, const factors *f, const element_stencil *stencil)
{
    pieces spline;
    bool ok = make_box_spline(&spline, f);
    for (int t = ELEMENT_UP; ok && t <= ELEMENT_EDGE; t++)
        if (t != ELEMENT_EDGE || is_continuous(f))
            ok = fill_triangle(z, (element_type)t, f, &stencil->window[t], &spline);
    free_rationals(spline.c, pieces_count(&spline));
    return ok;
}

bool bernstein_make(bernstein *z, bool *found, mesh_kind mesh, const laurent *mask, const element_stencil *stencil)
{
    factors f;
    if (!factorise(&f, found, mesh, mask))
        return false;
    if (!*found)
        return true;
    for (int d = 0; d < 2; d++) {
        z->degree[d] = mesh == MESH_TRIANGLE ? f.times[0] + f.times[1] + f.times[2] - 2 : f.times[d] - 1;
        *found = *found && z->degree[d] <= BERNSTEIN_MAX_DEGREE;
    }
    if (!*found) {
        z->degree[0] = z->degree[1] = 0;
        return true;
    }
    return mesh == MESH_TRIANGLE ? make_triangles(z, &f, stencil) : make_squares(z);
}
