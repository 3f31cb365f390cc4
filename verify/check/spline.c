/* Limits that are polynomials on elements: section 7 of certificate.md, "Coefficients". */

#include "spline.h"

enum { MAX_QUAD = 16, MAX_TRIANGLE = 17, SIDE = MAX_TRIANGLE + 1 };

static const struct label direction[3] = { { 1, 0 }, { 0, 1 }, { 1, -1 } };

/* degree! P(m; T) for all T in the support of m, once they have been asked for. */
struct piece {
    bool known;
    integer *polynomial;
};

struct pieces {
    struct piece *of[SIDE][SIDE][SIDE];
};

/* Divides by 1 + z^-e_i = z^-e_i (1 + z^e_i) as often as that goes. */
bool spline_find(struct spline *out, const struct mask *mask, enum mesh mesh)
{
    struct mask rest = *mask, quotient;
    struct points left;
    int total = 0;

    out->c = (struct label) { 0, 0 };
    for (int i = 0; i < 3; i++) {
        struct label e = direction[i];

        out->m[i] = 0;
        while ((mesh == TRIANGLE || i < 2) && out->m[i] <= MAX_TRIANGLE &&
               mask_divide(&quotient, &rest, e.a, e.b)) {
            rest = quotient;
            out->m[i]++;
            out->c.a -= e.a;
            out->c.b -= e.b;
        }
        total += out->m[i];
    }
    left = mask_points(&rest);
    if (left.count != 1 || integer_compare(integer_shift_left(left.point->weight, total),
                                           integer_shift_left(rest.denominator, 2)) != 0)
        return false;
    out->c.a += left.point->a;
    out->c.b += left.point->b;
    out->pieces = mesh == TRIANGLE ? allocate(1, sizeof *out->pieces) : NULL;
    return mesh == TRIANGLE ? total <= MAX_TRIANGLE
                            : out->m[0] <= MAX_QUAD && out->m[1] <= MAX_QUAD;
}

struct spline spline_derivative(const struct spline *s, int i)
{
    struct spline out = *s;

    out.m[i]--;
    out.c.a += direction[i].a;
    out.c.b += direction[i].b;
    return out;
}

/* Polynomials of degree n are stored as n! times their coefficients, which is whole:
 * each recursion divides by the degree, and nothing else is divided by. */
static integer factorial(int n)
{
    return n < 2 ? integer_from(1) : integer_mul(integer_from(n), factorial(n - 1));
}

static void add_times(integer *sum, integer a, int factor)
{
    *sum = integer_add(*sum, integer_mul(a, integer_from(factor)));
}

/* Quads
 * ----- */

/* out[i] += (coefficient of s^(n-i) t^i in) (p s + q t) f, f of degree n - 1. */
static void add_linear(integer *out, const integer *f, int n, int p, int q)
{
    for (int i = 0; i < n; i++) {
        add_times(&out[i], f[i], p);
        add_times(&out[i + 1], f[i], q);
    }
}

/* degree! b(degree,l) for l = 0..degree: degree + 1 coefficients each. */
static integer *spline_pieces(int degree)
{
    integer *old = NULL;

    for (int n = 0; n <= degree; n++) {
        integer *new = allocate((size_t)(n + 1) * (size_t)(n + 1), sizeof new[0]);

        if (n == 0)
            new[0] = integer_from(1);
        for (int l = 0; n > 0 && l <= n; l++) {
            integer *out = &new[l * (n + 1)];

            if (l < n)
                add_linear(out, &old[l * n], n, l, l + 1);
            if (l > 0)
                add_linear(out, &old[(l - 1) * n], n, n + 1 - l, n - l);
        }
        old = new;
    }
    return old;
}

/* For y = low, low + 1 ... the coefficients of b(m - 1, -y - c). */
static interval *along_axis(int m, int c, int low, int side, int g)
{
    integer *piece = spline_pieces(m - 1), scale = factorial(m - 1);
    interval *out = allocate((size_t)side * (size_t)m, sizeof out[0]);

    for (int y = 0; y < side; y++) {
        int l = -(y + low) - c;

        for (int i = 0; l >= 0 && l < m && i < m; i++)
            out[y * m + i] = grid_from_fraction(piece[l * m + i], scale, g);
    }
    return out;
}

/* Triangles
 * ---------
 *
 * A polynomial of degree D in w0, w1, w2 is a square of D + 1 rows; NULL: 0. */

/* out += (p0 w0 + p1 w1 + p2 w2) f, f of degree n - 1 */
static void add_product(integer *out, const integer *f, int n, const int p[3])
{
    for (int i = 0; f != NULL && i < n; i++) {
        for (int j = 0; i + j < n; j++) {
            add_times(&out[i * (n + 1) + j], f[i * n + j], p[0]);
            add_times(&out[(i + 1) * (n + 1) + j], f[i * n + j], p[1]);
            add_times(&out[i * (n + 1) + j + 1], f[i * n + j], p[2]);
        }
    }
}

/* L_i at the point (a,b) */
static int linear_value(const int m[3], int i, int a, int b)
{
    if (m[0] > 0 && m[1] > 0)
        return i == 0 ? a : i == 1 ? b : 0;
    if (m[1] == 0)
        return i == 0 ? a + b : i == 1 ? 0 : -b;
    return i == 0 ? 0 : i == 1 ? a + b : a;
}

/* P for two directions is 1 or 0. */
static bool is_one(const int m[3], struct element t)
{
    bool up = t.kind == ELEMENT_U;

    if (m[0] == 1 && m[1] == 1)
        return t.a == 0 && t.b == 0;
    if (m[0] == 1 && m[2] == 1)
        return up ? t.a == 1 && t.b == -1 : t.a == 0 && t.b == -1;
    if (m[1] == 1 && m[2] == 1)
        return t.a == 0 && t.b == (up ? 0 : -1);
    return false;
}

static const integer *piece_at(struct pieces *p, const int m[3], struct element t);

static integer *make_piece(struct pieces *p, const int m[3], struct element t)
{
    int degree = m[0] + m[1] + m[2] - 2;
    size_t count = (size_t)(degree + 1) * (size_t)(degree + 1);
    integer *out = allocate(count, sizeof out[0]);

    if (degree == 0 && is_one(m, t))
        out[0] = integer_from(1);
    for (int i = 0; degree > 0 && i < 3; i++) {
        int less[3] = { m[0], m[1], m[2] }, l[3], rest[3];
        struct element moved = { t.kind, t.a - direction[i].a, t.b - direction[i].b };

        if (m[i] == 0)
            continue;
        less[i]--;
        for (int w = 0; w < 3; w++) {
            struct label v = element_form[t.kind].vertex[w];

            l[w] = linear_value(m, i, t.a + v.a, t.b + v.b);
            rest[w] = m[i] - l[w];
        }
        add_product(out, piece_at(p, less, t), degree, l);
        add_product(out, piece_at(p, less, moved), degree, rest);
    }
    return out;
}

/* T lies outside of the support, 0 <= a <= m1 + m3, -m3 <= b <= m2: NULL. */
static const integer *piece_at(struct pieces *p, const int m[3], struct element t)
{
    int side_a = m[0] + m[2], side_b = m[1] + m[2], b = t.b + m[2];
    struct piece **table = &p->of[m[0]][m[1]][m[2]], *here;

    if (t.a < 0 || t.a >= side_a || b < 0 || b >= side_b)
        return NULL;
    if (*table == NULL)
        *table = allocate(2 * (size_t)side_a * (size_t)side_b, sizeof **table);
    here = &(*table)[2 * (t.a * side_b + b) + (t.kind == ELEMENT_U ? 0 : 1)];
    if (!here->known)
        here->polynomial = make_piece(p, m, t);
    here->known = true;
    return here->polynomial;
}

static interval *triangle_polynomials(const struct spline *s, enum element_kind kind,
                                      const struct window *window, int degree, int g)
{
    int count = (degree + 1) * (degree + 1);
    interval *out = allocate((size_t)window->count * (size_t)count, sizeof out[0]);
    integer scale = factorial(degree);

    for (int n = 0; n < window->count; n++) {
        struct element t = { kind == ELEMENT_E ? ELEMENT_U : kind,
                             -window->label[n].a - s->c.a, -window->label[n].b - s->c.b };
        const integer *p = piece_at(s->pieces, s->m, t);

        for (int i = 0; p != NULL && i < count; i++)
            out[n * count + i] = grid_from_fraction(p[i], scale, g);
    }
    return out;
}

/* Bases
 * ----- */

bool basis_make(struct basis *out, const struct spline *s, enum element_kind kind,
                enum mesh mesh, const struct window *window, int g)
{
    int degree = s->m[0] + s->m[1] + s->m[2] - 2;

    *out = (struct basis) { .triangular = mesh == TRIANGLE };
    if (mesh == TRIANGLE) {
        if (degree < 0 || s->m[0] < 0 || s->m[1] < 0)
            return false;
        out->side_a = out->side_b = degree + 1;
        out->polynomial = triangle_polynomials(s, kind, window, degree, g);
        return true;
    }
    if (s->m[0] < 1 || s->m[1] < 1)
        return false;
    out->side_a = s->m[0];
    out->side_b = s->m[1];
    out->along_a = along_axis(s->m[0], s->c.a, window->low_a, window->side_a, g);
    out->along_b = along_axis(s->m[1], s->c.b, window->low_b, window->side_b, g);
    return true;
}

bool basis_has(const struct basis *b, enum element_kind kind, int i, int j)
{
    int degree = b->side_a - 1;

    if (i >= b->side_a || j >= b->side_b || (b->triangular && i + j > degree))
        return false;
    return kind == ELEMENT_E ? i + j == degree : kind == ELEMENT_G ? j == 0
         : kind == ELEMENT_H ? i == 0 : true;
}

static void add_multiple(struct pair *sum, interval weight, struct pair v, int g)
{
    affine_add_multiple(&sum->x, weight, &v.x, g);
    affine_add_multiple(&sum->y, weight, &v.y, g);
}

/* First along y1 for each y2, then along y2. */
static void quad_coefficients(struct pair *out, const struct basis *b,
                              const struct window *window, const struct pair *value, int g)
{
    struct pair *a = allocate((size_t)b->side_a * (size_t)window->side_b, sizeof a[0]);

    for (int i = 0; i < b->side_a; i++)
        for (int n = 0; n < window->count; n++)
            add_multiple(&a[i * window->side_b + window->label[n].b - window->low_b],
                         b->along_a[(window->label[n].a - window->low_a) * b->side_a + i],
                         value[n], g);
    for (int i = 0; i < b->side_a; i++)
        for (int j = 0; j < b->side_b; j++)
            for (int y = 0; y < window->side_b; y++)
                add_multiple(&out[i * b->side_b + j], b->along_b[y * b->side_b + j],
                             a[i * window->side_b + y], g);
}

struct pair *basis_coefficients(const struct basis *b, const struct window *window,
                                const struct pair *value, int g)
{
    int count = b->side_a * b->side_b;
    struct pair *out = allocate((size_t)count, sizeof out[0]);

    if (!b->triangular) {
        quad_coefficients(out, b, window, value, g);
        return out;
    }
    for (int n = 0; n < window->count; n++)
        for (int i = 0; i < count; i++)
            add_multiple(&out[i], b->polynomial[n * count + i], value[n], g);
    return out;
}
