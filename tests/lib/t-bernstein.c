/* t-bernstein.c: polynomials of windows, exactly: they sum to 1, they are what subdivision refines them to, and they are where
   plain subdivision leads. */
#include "lib/bernstein.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/regular.h"

static const element_type types[2][3] = {{ELEMENT_UP, ELEMENT_DOWN, ELEMENT_EDGE}, {ELEMENT_SQUARE, ELEMENT_ALONG_FIRST, ELEMENT_ALONG_SECOND}};

typedef struct {
    mesh_kind mesh;
    const laurent *mask;
    element_stencil stencil;
    bernstein b;
    bool found;
} setting;

static void make_setting(setting *z, mesh_kind mesh, const laurent *mask)
{
    z->mesh = mesh;
    z->mask = mask;
    element_stencil_init(&z->stencil);
    bernstein_init(&z->b);
    MUST(element_stencil_make(&z->stencil, mesh, mask));
    MUST(bernstein_make(&z->b, &z->found, mesh, mask, &z->stencil));
}

static void free_setting(setting *z)
{
    bernstein_clear(&z->b);
    element_stencil_clear(&z->stencil);
}

/* Of some call before the last 8. */
static const rational *bernstein_at(const bernstein *b, element_type type, int row, int column)
{
    static rational entry[8];
    static int next;
    rational *z = &entry[++next % 8];
    MUST(bernstein_get(z, b, type, row, column));
    return z;
}

static element_type type_of(const setting *z, int i) { return types[z->mesh != MESH_TRIANGLE][i]; }

/* ---- shape, sums, signs ---- */

static void check_sums(const setting *z)
{
    rational sum;
    rational_init(&sum);
    for (int i = 0; i < 3; i++) {
        element_type type = type_of(z, i);
        int n = z->b.degree[0], m = z->b.degree[1], expected = i == 0 ? (z->mesh == MESH_TRIANGLE ? (n + 1) * (n + 2) / 2 : (n + 1) * (m + 1)) : 0;
        CHECK(i > 0 || z->b.rows[type] == expected, "%d coefficients, not %d", z->b.rows[type], expected);
        CHECK(z->b.rows[type] == 0 || z->b.columns[type] == z->stencil.window[type].count, "%d columns", z->b.columns[type]);
        for (int row = 0; row < z->b.rows[type]; row++) {
            MUST(rational_set_si(&sum, 0, 1));
            for (int y = 0; y < z->b.columns[type]; y++) {
                CHECK(rational_sign(bernstein_at(&z->b, type, row, y)) >= 0, "a negative coefficient");
                MUST(rational_add(&sum, &sum, bernstein_at(&z->b, type, row, y)));
            }
            CHECK(rational_cmp_si(&sum, 1, 1) == 0, "coefficient %d of type %d: the sum over the window is %g", row, (int)type, rational_get_double_approx(&sum));
        }
    }
    rational_clear(&sum);
}

/* ---- evaluation ---- */

static long binomial(int n, int k)
{
    long c = 1;
    for (int i = 1; i <= k; i++)
        c = c * (n - k + i) / i;
    return c;
}

/* z = x^n; 0^0 = 1. */
static void power(rational *z, const rational *x, int n)
{
    MUST(rational_set_si(z, 1, 1));
    for (; n > 0; n--)
        MUST(rational_mul(z, z, x));
}

/* z = the value at (u,v), in the coordinates of the element at (0,0), of the polynomial of a window's values. */
static void evaluate(rational *z, const setting *s, element_type type, const rational *value, const rational *u, const rational *v)
{
    rational weight[3], part, c, one;
    int n = s->b.degree[0], m = s->b.degree[1], row = 0;
    for (int i = 0; i < 3; i++)
        rational_init(&weight[i]);
    rational_init(&part), rational_init(&c), rational_init(&one);
    MUST(rational_set_si(&one, 1, 1));
    MUST(rational_set_si(z, 0, 1));
    if (s->mesh == MESH_TRIANGLE) {
        /* UP: u = weight of v1, v = weight of v2.  DOWN: v1 = (0,1): 1 - u, v2 = (1,0): 1 - v. */
        MUST(type == ELEMENT_UP ? rational_set(&weight[1], u) : rational_sub(&weight[1], &one, u));
        MUST(type == ELEMENT_UP ? rational_set(&weight[2], v) : rational_sub(&weight[2], &one, v));
        MUST(rational_sub(&weight[0], &one, &weight[1]));
        MUST(rational_sub(&weight[0], &weight[0], &weight[2]));
    }
    for (int l = 0; l <= m; l++)
        for (int j = 0; j <= (s->mesh == MESH_TRIANGLE ? n - l : n); j++, row++) {
            MUST(rational_set_si(&c, 0, 1));
            for (int y = 0; y < s->b.columns[type]; y++) {
                MUST(rational_mul(&part, bernstein_at(&s->b, type, row, y), &value[y]));
                MUST(rational_add(&c, &c, &part));
            }
            if (s->mesh == MESH_TRIANGLE) {
                MUST(rational_set_si(&part, binomial(n, l) * binomial(n - l, j), 1));
                MUST(rational_mul(&c, &c, &part));
                for (int i = 0; i < 3; i++) {
                    power(&part, &weight[i], i == 0 ? n - j - l : i == 1 ? j : l);
                    MUST(rational_mul(&c, &c, &part));
                }
            } else {
                MUST(rational_set_si(&part, binomial(n, j) * binomial(m, l), 1));
                MUST(rational_mul(&c, &c, &part));
                for (int i = 0; i < 2; i++) {
                    const rational *x = i ? v : u;
                    power(&part, x, i ? l : j);
                    MUST(rational_mul(&c, &c, &part));
                    MUST(rational_sub(&part, &one, x));
                    MUST(rational_set(&weight[0], &part));
                    power(&part, &weight[0], i ? m - l : n - j);
                    MUST(rational_mul(&c, &c, &part));
                }
            }
            MUST(rational_add(z, z, &c));
        }
    for (int i = 0; i < 3; i++)
        rational_clear(&weight[i]);
    rational_clear(&part), rational_clear(&c), rational_clear(&one);
}

static rational *random_values(int count)
{
    rational *a = malloc((size_t)count * sizeof *a);
    for (int i = 0; i < count; i++) {
        rational_init(&a[i]);
        MUST(rational_set_si(&a[i], random_range(-50, 50), 1));
    }
    return a;
}

static void free_values(rational *a, int count)
{
    for (int i = 0; i < count; i++)
        rational_clear(&a[i]);
    free(a);
}

static rational *refine(const setting *s, element_type type, int child, const rational *value)
{
    const element_refinement *r = &s->stencil.child[type][child];
    rational *a = random_values(r->count), part;
    rational_init(&part);
    for (int i = 0; i < r->count; i++) {
        MUST(rational_set_si(&a[i], 0, 1));
        for (int e = r->row[i]; e < r->row[i + 1]; e++) {
            MUST(laurent_get(&part, s->mask, r->term[e].a, r->term[e].b));
            MUST(rational_mul(&part, &part, &value[r->source[e]]));
            MUST(rational_add(&a[i], &a[i], &part));
        }
    }
    rational_clear(&part);
    return a;
}

/* The refinement equation: the polynomial of each child of the refined values is that of the values.  With partition of
   unity it has one continuous solution. */
static void check_refinement(const setting *s)
{
    rational u, v, x, y, t;
    rational_init(&u), rational_init(&v), rational_init(&x), rational_init(&y), rational_init(&t);
    for (int i = 0; i < (s->mesh == MESH_TRIANGLE ? 2 : 1); i++) {
        element_type type = type_of(s, i);
        int count = s->stencil.window[type].count;
        rational *value = random_values(count);
        for (int c = 0; c < element_children(type); c++) {
            element_child child = element_get_child(type, c);
            rational *fine = refine(s, type, c, value);
            for (int point = 0; point < 3; point++) { /* any points: two polynomials are compared */
                MUST(rational_set_si(&u, random_range(-5, 9), 7));
                MUST(rational_set_si(&v, random_range(-5, 9), 11));
                evaluate(&x, s, child.type, fine, &u, &v);
                MUST(rational_set_si(&t, child.shift.a, 1) && rational_add(&u, &u, &t) && rational_mul_2exp(&u, &u, -1));
                MUST(rational_set_si(&t, child.shift.b, 1) && rational_add(&v, &v, &t) && rational_mul_2exp(&v, &v, -1));
                evaluate(&y, s, type, value, &u, &v);
                CHECK(rational_equal(&x, &y), "child %d of type %d: %g, not %g", c, (int)type, rational_get_double_approx(&x), rational_get_double_approx(&y));
            }
            free_values(fine, s->stencil.window[child.type].count);
        }
        free_values(value, count);
    }
    rational_clear(&u), rational_clear(&v), rational_clear(&x), rational_clear(&y), rational_clear(&t);
}

/* The coefficients of a segment are those of the polynomial next to it: the corner values agree, and so do all others, for
   they are in the same places of a side. */
static void check_segments(const setting *s)
{
    for (int i = 1; i < 3; i++) {
        element_type segment = type_of(s, i);
        if (s->mesh == MESH_TRIANGLE && segment == ELEMENT_DOWN)
            continue;
        int n = s->b.degree[segment == ELEMENT_ALONG_SECOND], p = s->b.degree[0];
        element_type whole = type_of(s, 0);
        const element_window *w = &s->stencil.window[segment], *from = &s->stencil.window[whole];
        CHECK(s->b.rows[segment] == n + 1, "%d coefficients on segment %d", s->b.rows[segment], (int)segment);
        for (int t = 0; t <= n && !test_failed(); t++) {
            int row = segment == ELEMENT_EDGE ? t * (n + 1) - t * (t - 1) / 2 + n - t : segment == ELEMENT_ALONG_FIRST ? t : t * (p + 1);
            for (int y = 0; y < from->count; y++) {
                int at = 0;
                while (at < w->count && (w->point[at].a != from->point[y].a || w->point[at].b != from->point[y].b))
                    at++;
                CHECK(at < w->count ? rational_equal(bernstein_at(&s->b, segment, t, at), bernstein_at(&s->b, whole, row, y)) : rational_is_zero(bernstein_at(&s->b, whole, row, y)), "coefficient %d of segment %d", t, (int)segment);
            }
        }
    }
}

/* ---- plain subdivision ---- */

enum { LEVELS = 7, HALF = 900, SIDE = 2 * HALF + 1 };
static double old_values[SIDE][SIDE], new_values[SIDE][SIDE];

/* The delta at y = (0,0) after many steps, against its polynomial on the element at (a,b): UP or SQUARE. */
static void check_limit(const setting *s)
{
    rational u, v, z;
    double tolerance = 0.05, worst = 0;
    const element_window *w = &s->stencil.window[type_of(s, 0)];
    int terms = 0, term_a[400], term_b[400];
    double term[400];
    rational_init(&u), rational_init(&v), rational_init(&z);
    for (long a = s->mask->a0; a < s->mask->a0 + s->mask->na; a++)
        for (long b = s->mask->b0; b < s->mask->b0 + s->mask->nb; b++)
            if (!laurent_is_zero_at(s->mask, a, b)) {
                MUST(laurent_get(&z, s->mask, a, b));
                term_a[terms] = (int)a, term_b[terms] = (int)b, term[terms++] = rational_get_double_approx(&z);
            }
    memset(old_values, 0, sizeof old_values);
    old_values[HALF][HALF] = 1;
    for (int n = 0; n < LEVELS; n++) {
        memset(new_values, 0, sizeof new_values);
        for (int a = -HALF / 2 + 8; a <= HALF / 2 - 8; a++)
            for (int b = -HALF / 2 + 8; b <= HALF / 2 - 8; b++)
                for (int i = 0; old_values[a + HALF][b + HALF] != 0 && i < terms; i++)
                    new_values[2 * a + term_a[i] + HALF][2 * b + term_b[i] + HALF] += term[i] * old_values[a + HALF][b + HALF];
        memcpy(old_values, new_values, sizeof old_values);
    }
    for (int y = 0; y < w->count; y++) {
        rational *value = random_values(w->count);
        for (int i = 0; i < w->count; i++)
            MUST(rational_set_si(&value[i], i == y, 1));
        for (int c = 1; c < 4; c++)
            for (int d = 1; d < 4 - (s->mesh == MESH_TRIANGLE ? c : 0); d++) {
                int p = (4 * -w->point[y].a + c) * (1 << (LEVELS - 2)), q = (4 * -w->point[y].b + d) * (1 << (LEVELS - 2));
                MUST(rational_set_si(&u, c, 4) && rational_set_si(&v, d, 4));
                evaluate(&z, s, type_of(s, 0), value, &u, &v);
                worst = fmax(worst, fabs(rational_get_double_approx(&z) - old_values[p + HALF][q + HALF]));
            }
        free_values(value, w->count);
    }
    CHECK(worst < tolerance, "a limit differs by %g", worst); /* by about the slope times 2^-LEVELS times the reach */
    rational_clear(&u), rational_clear(&v), rational_clear(&z);
}

/* ---- schemes ---- */

/* "name" or "midpoint N"; net -1: values, 0, 1: derivatives.  Degrees as the text books have them. */
static void check_scheme(const char *name, int net, int degree0, int degree1)
{
    char word[40] = "", parameter[40];
    const char *parameters[] = {parameter};
    int number = 0;
    scheme_settings settings = {parameters, 0};
    diagnostic d = {0, 0, ""};
    scheme scheme_read_in;
    regular_masks masks;
    setting s;
    sscanf(name, "%39s %d", word, &number);
    snprintf(parameter, sizeof parameter, "degree=%d", number);
    settings.count = number > 0;
    const char *text = catalogue_text(word);
    scheme_init(&scheme_read_in);
    regular_init(&masks);
    CHECK(scheme_read(&scheme_read_in, text, strlen(text), &settings, &d) == STATUS_OK, "%s: %s", name, d.text);
    MUST(regular_derive(&masks, &scheme_read_in.mask, scheme_read_in.mesh));
    make_setting(&s, scheme_read_in.mesh, net < 0 ? &scheme_read_in.mask : &masks.derivative[net]);
    CHECK(s.found == (degree0 >= 0), "%s: %sa box spline", name, s.found ? "" : "not ");
    if (s.found && !test_failed()) {
        CHECK(s.b.degree[0] == degree0 && s.b.degree[1] == degree1, "%s: degrees %d and %d", name, s.b.degree[0], s.b.degree[1]);
        check_sums(&s);
        check_refinement(&s);
        check_segments(&s);
        check_limit(&s);
    }
    free_setting(&s);
    regular_clear(&masks);
    scheme_clear(&scheme_read_in);
}

static void test_schemes(void)
{
    test_begin("bernstein-loop");
    check_scheme("loop", -1, 4, 4);
    check_scheme("loop", 0, 3, 3);
    check_scheme("loop", 1, 3, 3);
    test_end();
    test_begin("bernstein-catmull-clark");
    check_scheme("catmull-clark", -1, 3, 3);
    check_scheme("catmull-clark", 0, 2, 3);
    check_scheme("catmull-clark", 1, 3, 2);
    test_end();
    test_begin("bernstein-doo-sabin");
    check_scheme("doo-sabin", -1, 2, 2);
    check_scheme("doo-sabin", 0, 1, 2);
    check_scheme("doo-sabin", 1, 2, 1);
    test_end();
    test_begin("bernstein-midpoint");
    check_scheme("midpoint 4", -1, 4, 4);
    check_scheme("midpoint 4", 0, 3, 4);
    check_scheme("midpoint 5", 1, 5, 4);
    test_end();
    test_begin("bernstein-none");
    check_scheme("butterfly", -1, -1, -1);
    check_scheme("kobbelt", -1, -1, -1);
    check_scheme("kobbelt", 0, -1, -1);
    check_scheme("wave", -1, -1, -1);
    check_scheme("midpoint 17", -1, -1, -1); /* its degree is too large */
    test_end();
}

/* ---- known coefficients ---- */

static bool is_quotient(const rational *x, long p, long q) { return rational_cmp_si(x, p, q) == 0; }

static void test_known(void)
{
    scheme z;
    setting s;
    test_begin("bernstein-known");
    /* Loop's vertex: 1/2 of itself, 1/12 of each neighbour (the quartic's corner) */
    read_scheme(&z, catalogue_text("loop"));
    make_setting(&s, MESH_TRIANGLE, &z.mask);
    for (int y = 0; y < s.b.columns[ELEMENT_UP]; y++) {
        lattice p = s.stencil.window[ELEMENT_UP].point[y];
        int d = lattice_distance(p.a, p.b);
        CHECK(is_quotient(bernstein_at(&s.b, ELEMENT_UP, 0, y), d == 0 ? 1 : d == 1, d == 0 ? 2 : 12), "Loop's corner at (%d,%d)", p.a, p.b);
    }
    free_setting(&s);
    scheme_clear(&z);
    /* Catmull-Clark: (1, 4, 1)/6 in both directions at the corner, (4, 2)/6 next to it */
    read_scheme(&z, catalogue_text("catmull-clark"));
    make_setting(&s, MESH_QUAD, &z.mask);
    for (int y = 0; y < s.b.columns[ELEMENT_SQUARE]; y++) {
        static const long corner[4] = {1, 4, 1, 0}, next[4] = {0, 4, 2, 0};
        lattice p = s.stencil.window[ELEMENT_SQUARE].point[y];
        CHECK(is_quotient(bernstein_at(&s.b, ELEMENT_SQUARE, 0, y), corner[p.a + 1] * corner[p.b + 1], 36), "Catmull-Clark's corner at (%d,%d)", p.a, p.b);
        CHECK(is_quotient(bernstein_at(&s.b, ELEMENT_SQUARE, 1, y), next[p.a + 1] * corner[p.b + 1], 36), "Catmull-Clark's second at (%d,%d)", p.a, p.b);
    }
    free_setting(&s);
    scheme_clear(&z);
    test_end();
}

/* ---- the recursions of verify/certificate.md, section 7 ---- */

enum { MOST = BERNSTEIN_MAX_DEGREE + 1, MOST_COEFFICIENTS = (MOST + 1) * (MOST + 2) / 2 };
typedef struct {
    rational c[MOST_COEFFICIENTS]; /* of w0^(n-i-j) w1^i w2^j, by the shape's index */
} polynomial;

static polynomial *new_polynomial(void)
{
    polynomial *p = malloc(sizeof *p);
    MUST(p != NULL);
    for (int i = 0; i < MOST_COEFFICIENTS; i++)
        rational_init(&p->c[i]);
    return p;
}

static void free_polynomial(polynomial *p)
{
    for (int i = 0; i < MOST_COEFFICIENTS; i++)
        rational_clear(&p->c[i]);
    free(p);
}

/* z += (l[0] w0 + l[1] w1 + l[2] w2) x / divisor, x of degree n. */
static void add_multiple(polynomial *z, const polynomial *x, int n, const int l[3], int divisor)
{
    bernstein_shape from = {true, {n, n}}, to = {true, {n + 1, n + 1}};
    rational part;
    rational_init(&part);
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n - j; i++)
            for (int v = 0; v < 3; v++) {
                rational *sum = &z->c[bernstein_shape_index(to, i + (v == 1), j + (v == 2))];
                MUST(rational_set_si(&part, l[v], divisor) && rational_mul(&part, &part, &x->c[bernstein_shape_index(from, i, j)]) && rational_add(sum, sum, &part));
            }
    rational_clear(&part);
}

static int spanning(const int m[3]) { return (m[0] > 0) + (m[1] > 0) + (m[2] > 0) >= 2; }

/* P(m; T) for T = UP(a,b) or DOWN(a,b), by itself, without remembering anything. */
static polynomial *recursion(const int m[3], element_type type, int a, int b)
{
    static const lattice e[3] = {{1, 0}, {0, 1}, {1, -1}};
    int n = m[0] + m[1] + m[2] - 2, l[3][3];
    polynomial *z = new_polynomial(), *p;
    if (a < 0 || a >= m[0] + m[2] || b < -m[2] || b >= m[1])
        return z; /* outside the support */
    if (n == 0) {
        bool up = type == ELEMENT_UP, one = false;
        if (m[2] == 0)
            one = m[0] == 1 && a == 0 && b == 0;
        else if (m[1] == 0)
            one = m[0] == 1 && (up ? a == 1 : a == 0) && b == -1;
        else
            one = m[0] == 0 && m[1] == 1 && a == 0 && (up ? b == 0 : b == -1);
        MUST(rational_set_si(&z->c[0], one, 1));
        return z;
    }
    for (int v = 0; v < 3; v++) {
        lattice w = element_get_vertex(type, v);
        int x = a + w.a, y = b + w.b;
        l[0][v] = m[1] == 0 ? x + y : m[0] > 0 ? x : 0;
        l[1][v] = m[1] == 0 ? 0 : m[0] > 0 ? y : x + y;
        l[2][v] = m[1] == 0 ? -y : m[0] > 0 ? 0 : x;
    }
    for (int i = 0; i < 3; i++) {
        int fewer[3] = {m[0] - (i == 0), m[1] - (i == 1), m[2] - (i == 2)}, rest[3];
        if (m[i] == 0 || !spanning(fewer)) /* what does not span is 0 */
            continue;
        for (int v = 0; v < 3; v++)
            rest[v] = m[i] - l[i][v];
        p = recursion(fewer, type, a, b);
        add_multiple(z, p, n - 1, l[i], n);
        free_polynomial(p);
        p = recursion(fewer, type, a - e[i].a, b - e[i].b);
        add_multiple(z, p, n - 1, rest, n);
        free_polynomial(p);
    }
    return z;
}

/* b(n,l) in s and t: as polynomials in w0 and w1. */
static polynomial *spline_recursion(int n, int l)
{
    polynomial *z = new_polynomial(), *p;
    int here[3] = {l, l + 1, 0}, back[3] = {n + 1 - l, n - l, 0};
    if (n == 0)
        MUST(rational_set_si(&z->c[0], l == 0, 1));
    if (n == 0 || l < 0 || l > n)
        return z;
    p = spline_recursion(n - 1, l);
    add_multiple(z, p, n - 1, here, n);
    free_polynomial(p);
    p = spline_recursion(n - 1, l - 1);
    add_multiple(z, p, n - 1, back, n);
    free_polynomial(p);
    return z;
}

/* times and shift are those of the mask. */
static void check_recursion(const setting *s, const int times[3], lattice shift)
{
    rational part;
    rational_init(&part);
    for (int t = 0; t < (s->mesh == MESH_TRIANGLE ? 2 : 1); t++) {
        element_type type = type_of(s, t);
        bernstein_shape shape = bernstein_get_shape(&s->b, type);
        for (int y = 0; y < s->b.columns[type]; y++) {
            lattice at = s->stencil.window[type].point[y];
            polynomial *p = NULL, *q = NULL;
            at = (lattice){-at.a - shift.a, -at.b - shift.b};
            if (s->mesh == MESH_TRIANGLE) {
                p = recursion(times, type, at.a, at.b);
            } else {
                p = spline_recursion(times[0] - 1, at.a);
                q = spline_recursion(times[1] - 1, at.b);
            }
            for (int j = 0; j <= shape.degree[1]; j++)
                for (int i = 0; i <= bernstein_shape_last(shape, j); i++) {
                    int row = bernstein_shape_index(shape, i, j);
                    MUST(rational_set_si(&part, bernstein_shape_multiplicity(shape, i, j), 1));
                    MUST(rational_mul(&part, &part, bernstein_at(&s->b, type, row, y)));
                    if (q)
                        MUST(rational_mul(&p->c[MOST_COEFFICIENTS - 1], &p->c[i], &q->c[j]));
                    CHECK(rational_equal(&part, q ? &p->c[MOST_COEFFICIENTS - 1] : &p->c[row]), "%d, %d, %d: coefficient (%d,%d) of label (%d,%d)", times[0],
                          times[1], times[2], i, j, at.a, at.b);
                }
            free_polynomial(p);
            if (q)
                free_polynomial(q);
        }
    }
    rational_clear(&part);
}

/* ---- any box spline ---- */

static void test_random(void)
{
    test_begin("bernstein-box-splines");
    for (test_cases(40); test_next();) {
        static const lattice direction[3] = {{1, 0}, {0, 1}, {1, -1}};
        laurent mask, factor;
        lattice point[2] = {{0, 0}, {0, 0}}, shift;
        rational weight[2];
        setting s;
        mesh_kind mesh = (mesh_kind)random_below(3);
        int times[3], total = 0;
        bool spoilt = random_below(5) == 0;
        laurent_init(&mask), laurent_init(&factor);
        for (int i = 0; i < 2; i++)
            rational_init(&weight[i]);
        do
            for (int d = 0; d < 3; d++)
                times[d] = mesh == MESH_TRIANGLE || d < 2 ? (int)random_range(0, 3) : 0;
        while ((times[0] > 0) + (times[1] > 0) + (times[2] > 0) < 2);
        point[0] = shift = (lattice){(int)random_range(-3, 3), (int)random_range(-3, 3)};
        MUST(rational_set_si(&weight[0], spoilt && random_bool() ? 5 : 4, 1));
        spoilt = spoilt && rational_cmp_si(&weight[0], 5, 1) == 0;
        MUST(laurent_set_terms(&mask, point, weight, 1));
        for (int d = 0; d < 3; d++)
            for (int i = 0; i < times[d]; i++, total++) {
                point[0] = (lattice){0, 0}, point[1] = direction[d];
                MUST(rational_set_si(&weight[0], 1, 2) && rational_set_si(&weight[1], 1, 2));
                MUST(laurent_set_terms(&factor, point, weight, 2));
                MUST(laurent_mul(&mask, &mask, &factor));
            }
        make_setting(&s, mesh, &mask);
        CHECK(s.found == !spoilt, "%d, %d, %d: %s", times[0], times[1], times[2], s.found ? "found" : "not found");
        if (s.found && !test_failed()) {
            bool continuous = mesh == MESH_TRIANGLE ? (times[0] > 0) + (times[1] > 0) + (times[2] > 0) == 3 || (times[0] != 1 && times[1] != 1 && times[2] != 1) : times[0] > 1 && times[1] > 1;
            CHECK(mesh == MESH_TRIANGLE ? s.b.degree[0] == total - 2 : s.b.degree[0] == times[0] - 1 && s.b.degree[1] == times[1] - 1, "degrees");
            check_sums(&s);
            check_refinement(&s);
            if (total <= 6 || s.mesh != MESH_TRIANGLE)
                check_recursion(&s, times, shift);
            if (continuous)
                check_segments(&s);
            else
                CHECK(s.b.rows[type_of(&s, 2)] == 0 || s.b.rows[type_of(&s, 1)] == 0, "limits jump on some segment");
        }
        free_setting(&s);
        for (int i = 0; i < 2; i++)
            rational_clear(&weight[i]);
        laurent_clear(&mask), laurent_clear(&factor);
    }
    test_end();
}

int main(void)
{
    test_known();
    test_schemes();
    test_random();
    return test_status();
}
