/* t-element.c: children, windows and refinements of elements, against plain subdivision of the lattice; the ring. */
#include "lib/element.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/ring.h"

/* The box spline mask of the hat function's third power: reach 3, no negative weight. */
#define SMOOTH_TEXT SCHEME_TEXT("(0,0) 7/16\n(1,0) 39/128\n(1,1) 9/64\n(2,0) 3/32\n(1,2) 3/128\n(3,0) 1/128\n", "1/2")

static const char *const type_name[] = {"UP", "DOWN", "EDGE"};

/* The least and greatest f over the vertices of an element at (0,0), by lib/scheme.md's picture of it. */
static const int low_of[3][3] = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}, high_of[3][3] = {{1, 1, 1}, {1, 1, 2}, {1, 1, 1}};

/* Is (a,b) / scale in the element at (0,0)?  Triangles and segments are what the three functionals allow. */
static bool is_in_element(int type, long a, long b, long scale, bool inside)
{
    long f[3] = {a, b, a + b};
    for (int i = 0; i < 3; i++)
        if (f[i] < low_of[type][i] * scale || f[i] > high_of[type][i] * scale)
            return false;
        else if (inside && low_of[type][i] < high_of[type][i] && (f[i] == low_of[type][i] * scale || f[i] == high_of[type][i] * scale))
            return false;
    return true;
}

static void test_children(void)
{
    test_begin("element-children");
    for (int type = 0; type < 3; type++) {
        int children = element_children((element_type)type), vertices = element_vertices((element_type)type);
        CHECK(children == (type < 2 ? 4 : 2) && vertices == (type < 2 ? 3 : 2), "%s", type_name[type]);
        for (int v = 0; v < vertices; v++) {
            lattice p = element_get_vertex((element_type)type, v);
            CHECK(is_in_element(type, p.a, p.b, 1, false), "vertex %d of %s", v, type_name[type]);
        }
        /* every point of the element is in a child, and only on borders in two: all points in 60ths */
        for (long a = -120; a <= 240; a++)
            for (long b = -120; b <= 240; b++) {
                int closed = 0, open = 0;
                for (int c = 0; c < children; c++) {
                    element_child child = element_get_child((element_type)type, c);
                    CHECK((child.type == ELEMENT_EDGE) == (type == ELEMENT_EDGE), "kinds of children");
                    long x = 2 * a - 60 * child.shift.a, y = 2 * b - 60 * child.shift.b;
                    closed += is_in_element((int)child.type, x, y, 60, false);
                    open += is_in_element((int)child.type, x, y, 60, true);
                }
                CHECK((closed > 0) == is_in_element(type, a, b, 60, false), "%s: (%ld,%ld)/60 is in %d children", type_name[type], a, b, closed);
                CHECK(open <= 1, "%s: (%ld,%ld)/60 is inside %d children", type_name[type], a, b, open);
            }
    }
    test_end();
}

/* ---- windows ---- */

/* Some points with small weights; not all on one line. */
static void random_mask(laurent *z, bool positive)
{
    enum { MOST = 12 };
    lattice point[MOST];
    rational weight[MOST];
    size_t count = 3 + (size_t)random_below(MOST - 2), n = 0;
    for (size_t i = 0; i < count; i++) {
        lattice p = i == 0 ? (lattice){1, 0} : i == 1 ? (lattice){0, 2} : i == 2 ? (lattice){-1, -1} : (lattice){(int)random_range(-3, 3), (int)random_range(-3, 3)};
        bool known = false;
        for (size_t j = 0; j < n; j++)
            known = known || (point[j].a == p.a && point[j].b == p.b);
        if (known)
            continue;
        point[n] = p;
        rational_init(&weight[n]);
        MUST(rational_set_si(&weight[n], positive ? 1 : random_range(-8, 8), 4));
        n++;
    }
    MUST(laurent_set_terms(z, point, weight, n));
    for (size_t i = 0; i < n; i++)
        rational_clear(&weight[i]);
}

enum { LEVELS = 3, NETS_HALF = 64, NETS_SIDE = 2 * NETS_HALF + 1 };
static bool support[LEVELS + 1][NETS_SIDE][NETS_SIDE]; /* where the delta at 0 has got to */

static void spread_delta(const laurent *mask)
{
    memset(support, 0, sizeof support);
    support[0][NETS_HALF][NETS_HALF] = true;
    for (int n = 0; n < LEVELS; n++)
        for (int a = -NETS_HALF; a <= NETS_HALF; a++)
            for (int b = -NETS_HALF; b <= NETS_HALF; b++)
                for (int i = -4; support[n][a + NETS_HALF][b + NETS_HALF] && i <= 4; i++)
                    for (int j = -4; j <= 4; j++)
                        if (!laurent_is_zero_at(mask, i, j))
                            support[n + 1][2 * a + i + NETS_HALF][2 * b + j + NETS_HALF] = true;
}

static bool in_window(const element_window *w, int a, int b)
{
    for (int i = 0; i < w->count; i++)
        if (w->point[i].a == a && w->point[i].b == b)
            return true;
    return false;
}

/* After `level` steps a delta at y has values at x; there its share of the limit lives on x + hull of the mask, and c,
   the middle of the mask's points, is inside that hull.  If (x + c) / 2^level is on an element, y is in its window. */
static bool reaches(int type, int a, int b, int level, const long c[2], long count)
{
    long scale = (1L << level) * count;
    for (int p = -NETS_HALF; p <= NETS_HALF; p++)
        for (int q = -NETS_HALF; q <= NETS_HALF; q++)
            if (support[level][p + NETS_HALF][q + NETS_HALF]
                && is_in_element(type, ((long)a * (1L << level) + p) * count + c[0], ((long)b * (1L << level) + q) * count + c[1], scale, false))
                return true;
    return false;
}

static void check_windows(const laurent *mask, bool sharp)
{
    element_stencil s;
    long middle[2] = {0, 0}, count = 0;
    for (int a = -4; a <= 4; a++)
        for (int b = -4; b <= 4; b++)
            if (!laurent_is_zero_at(mask, a, b))
                middle[0] += a, middle[1] += b, count++;
    spread_delta(mask);
    element_stencil_init(&s);
    MUST(element_stencil_make(&s, mask));
    for (int type = 0; type < 3; type++) {
        int points = 0, last[2] = {-99, -99};
        for (int a = -6; a <= 6; a++)
            for (int b = -6; b <= 6; b++) {
                bool listed = in_window(&s.window[type], a, b), used = false;
                for (int level = 0; level <= LEVELS; level++)
                    used = used || reaches(type, a, b, level, middle, count);
                CHECK(listed || !used, "%s: the window lacks (%d,%d)", type_name[type], a, b);
                CHECK(!sharp || type == ELEMENT_EDGE || used || !listed, "%s: (%d,%d) is in the window for nothing", type_name[type], a, b);
                points += listed;
            }
        CHECK(points == s.window[type].count, "%s: %d points are far away or there twice", type_name[type], s.window[type].count - points);
        for (int i = 0; i < s.window[type].count; i++) {
            lattice p = s.window[type].point[i];
            CHECK(p.a > last[0] || (p.a == last[0] && p.b > last[1]), "the order of the window");
            last[0] = p.a, last[1] = p.b;
        }
    }
    element_stencil_clear(&s);
}

static void test_windows(void)
{
    scheme loop;
    regular_masks masks;
    test_begin("element-windows-loop");
    read_scheme(&loop, catalogue_text("loop"));
    regular_init(&masks);
    MUST(regular_derive(&masks, &loop.mask, MESH_TRIANGLE));
    check_windows(&loop.mask, true);
    check_windows(&masks.derivative[0], true);
    check_windows(&masks.derivative[1], true);
    regular_clear(&masks);
    scheme_clear(&loop);
    test_end();
    test_begin("element-windows");
    for (test_cases(60); test_next();) {
        laurent mask;
        laurent_init(&mask);
        random_mask(&mask, true);
        check_windows(&mask, false);
        laurent_clear(&mask);
    }
    test_end();
}

/* ---- refinement ---- */

enum { PLANE_HALF = 24, PLANE_SIDE = 2 * PLANE_HALF + 1 };
typedef double plane[PLANE_SIDE][PLANE_SIDE];

static double weight_at(const laurent *mask, int a, int b)
{
    double w;
    rational q;
    rational_init(&q);
    MUST(laurent_get(&q, mask, a, b));
    w = rational_get_double_approx(&q);
    rational_clear(&q);
    return w;
}

/* One step on the plain lattice: the new value at (a,b). */
static double subdivided(const laurent *mask, plane old, int a, int b)
{
    double sum = 0;
    for (int p = -PLANE_HALF; p <= PLANE_HALF; p++)
        for (int q = -PLANE_HALF; q <= PLANE_HALF; q++)
            if (!laurent_is_zero_at(mask, a - 2 * p, b - 2 * q))
                sum += weight_at(mask, a - 2 * p, b - 2 * q) * old[p + PLANE_HALF][q + PLANE_HALF];
    return sum;
}

static void test_refinement(void)
{
    static plane old;
    test_begin("element-refinement");
    for (test_cases(25); test_next();) {
        laurent mask;
        element_stencil s;
        int a = (int)random_range(-3, 3), b = (int)random_range(-3, 3);
        laurent_init(&mask);
        random_mask(&mask, random_bool());
        element_stencil_init(&s);
        MUST(element_stencil_make(&s, &mask));
        for (int i = 0; i < PLANE_SIDE * PLANE_SIDE; i++)
            old[i / PLANE_SIDE][i % PLANE_SIDE] = (double)random_range(-1000, 1000);
        for (int type = 0; type < 3; type++)
            for (int c = 0; c < element_children((element_type)type); c++) {
                element_child child = element_get_child((element_type)type, c);
                const element_refinement *r = &s.child[type][c];
                const element_window *from = &s.window[type], *to = &s.window[child.type];
                CHECK(r->count == to->count && r->row[0] == 0, "shape");
                for (int i = 0; i < r->count && !test_failed(); i++) {
                    double sum = 0, expected = subdivided(&mask, old, 2 * a + child.shift.a + to->point[i].a, 2 * b + child.shift.b + to->point[i].b);
                    for (int e = r->row[i]; e < r->row[i + 1]; e++) {
                        CHECK(r->source[e] >= 0 && r->source[e] < from->count && !laurent_is_zero_at(&mask, r->term[e].a, r->term[e].b), "entry");
                        lattice p = from->point[r->source[e]];
                        sum += weight_at(&mask, r->term[e].a, r->term[e].b) * old[a + p.a + PLANE_HALF][b + p.b + PLANE_HALF];
                    }
                    CHECK(fabs(sum - expected) < 1e-6, "child %d of %s, point %d: %g, not %g", c, type_name[type], i, sum, expected);
                }
            }
        element_stencil_clear(&s);
        laurent_clear(&mask);
    }
    test_end();
}

/* ---- the ring, point by point as verify/certificate.md has it ---- */

static int smallest(int x, int y) { return x < y ? x : y; }
static int greatest(int x, int y) { return x > y ? x : y; }

static bool in_window_by_definition(const laurent *mask, int type, int a, int b)
{
    int f[3] = {a, b, a + b};
    for (int i = 0; i < 3; i++) {
        int low = 99, high = -99;
        for (int p = -8; p <= 8; p++)
            for (int q = -8; q <= 8; q++)
                if (!laurent_is_zero_at(mask, p, q)) {
                    int g[3] = {p, q, p + q};
                    low = smallest(low, g[i]), high = greatest(high, g[i]);
                }
        if (!(high_of[type][i] - f[i] > low && low_of[type][i] - f[i] < high))
            return false;
    }
    return true;
}

static int distance(int a, int b)
{
    return greatest(abs(a), greatest(abs(b), abs(a + b)));
}

static int distance_to_element(int type, int a, int b)
{
    static const int corner[3][3][2] = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {0, 1}, {1, 0}}, {{1, 0}, {0, 1}, {1, 0}}};
    int best = 99;
    for (int v = 0; v < 3; v++)
        best = smallest(best, distance(a - corner[type][v][0], b - corner[type][v][1]));
    return best;
}

/* For which elements a net counts, and the second point of its differences. */
static const bool counts[RING_NETS][3] = {{false, false, true}, {true, true, false}, {true, true, false}};
static const int step[RING_NETS][2] = {{0, 0}, {1, 0}, {0, 1}};

/* Calls for all used points of an element; what is used is never opposite, and not the centre at level >= 1. */
static void check_used_points(const ring *z, element_type type, int a, int b, int level, int reach)
{
    for (int net = 0; net < RING_NETS; net++)
        for (int i = 0; counts[net][type] && i < z->stencil[net].window[type].count; i++)
            for (int second = 0; second < 2; second++) {
                lattice p = z->stencil[net].window[type].point[i];
                int x = a + p.a + second * step[net][0], y = b + p.b + second * step[net][1];
                CHECK(!(x < 0 && y <= 0), "level %d: (%d,%d) is opposite", level, x, y);
                CHECK(level == 0 || x || y, "level %d: the centre is used", level);
                CHECK(level > 0 || distance(x, y) <= z->rings, "(%d,%d) is beyond ring %d", x, y, z->rings);
                CHECK(level > 0 || y >= 0 || -y <= z->rings, "ring");
                for (int p2 = -30; level > 0 && p2 <= 30; p2++)
                    for (int q = -30; q <= 30; q++)
                        if (distance(x - 2 * p2, y - 2 * q) <= reach && !laurent_is_zero_at(z->mask[RING_VALUES], x - 2 * p2, y - 2 * q))
                            CHECK(!(p2 < 0 && q <= 0), "level %d: the rule of (%d,%d) asks for (%d,%d)", level, x, y, p2, q);
            }
}

static void check_ring(const char *text, bool nonnegative, int expected_radius)
{
    scheme s;
    regular_masks masks;
    ring z;
    int omega = 0, r = 1;
    read_scheme(&s, text);
    regular_init(&masks);
    ring_init(&z);
    MUST(regular_derive(&masks, &s.mask, MESH_TRIANGLE));
    CHECK(masks.divisible, "the test itself");
    MUST(ring_make(&z, &s, &masks));
    CHECK(z.nonnegative == nonnegative, "nonnegative");
    const laurent *mask[RING_NETS] = {&s.mask, &masks.derivative[0], &masks.derivative[1]};
    for (int net = 0; net < RING_NETS; net++)
        for (int type = 0; type < 3; type++) {
            int points = 0, most = 0;
            for (int a = -12; a <= 12; a++)
                for (int b = -12; b <= 12; b++) {
                    bool listed = in_window_by_definition(mask[net], type, a, b);
                    CHECK(listed == in_window(&z.stencil[net].window[type], a, b), "net %d, %s: (%d,%d)", net, type_name[type], a, b);
                    points += listed;
                    if (listed)
                        most = greatest(most, greatest(distance_to_element(type, a, b), distance_to_element(type, a + step[net][0], b + step[net][1])));
                }
            CHECK(points == z.stencil[net].window[type].count, "net %d, %s: %d points", net, type_name[type], points);
            CHECK(element_stencil_reach(&z.stencil[net], (element_type)type, (lattice){step[net][0], step[net][1]}) == most, "reach of net %d, %s", net, type_name[type]);
            if (counts[net][type])
                omega = greatest(omega, most);
        }
    while (!(omega <= r && omega + s.steps[0].reach < 2 * (r + 1) && omega < 2 * r))
        r++;
    CHECK(z.radius == r && r == expected_radius && z.rings == 2 * r + omega, "r = %d, rings = %d; expected %d and %d", z.radius, z.rings, r, 2 * r + omega);
    int n = 0;
    for (int type = 0; type < 2; type++)
        for (int j = 0; j < 2 * r; j++)
            for (int b = 0; b <= j; b++)
                if (type == 0 ? r <= j && j < 2 * r : r <= j + 1 && j + 2 <= 2 * r) {
                    CHECK(n < z.element_count && (int)z.elements[n].type == type && z.elements[n].a == j - b && z.elements[n].b == b, "element %d", n);
                    n++;
                }
    CHECK(n == z.element_count && n == 3 * r * r, "%d elements", z.element_count); /* their area: (2 r)^2 - r^2 */
    CHECK(z.boundary_count == 2 * r, "%d edges", z.boundary_count);
    for (int b = 0; b < z.boundary_count; b++)
        CHECK(z.boundary[b].type == ELEMENT_EDGE && z.boundary[b].b == b && z.boundary[b].a == 2 * r - 1 - b, "edge %d", b);
    for (int i = 0; i < n + 2 * r && !test_failed(); i++) {
        element e = i < n ? z.elements[i] : z.boundary[i - n];
        check_used_points(&z, e.type, e.a, e.b, 0, s.steps[0].reach);
        for (int c = 0; c < element_children(e.type); c++) {
            element_child child = element_get_child(e.type, c);
            int a = 2 * e.a + child.shift.a, b = 2 * e.b + child.shift.b;
            check_used_points(&z, child.type, a, b, 1, s.steps[0].reach);
            for (int d = 0; d < element_children(child.type); d++) {
                element_child grandchild = element_get_child(child.type, d);
                check_used_points(&z, grandchild.type, 2 * a + grandchild.shift.a, 2 * b + grandchild.shift.b, 2, s.steps[0].reach);
            }
        }
    }
    ring_clear(&z);
    regular_clear(&masks);
    scheme_clear(&s);
}

static void test_ring(void)
{
    test_begin("ring");
    check_ring(catalogue_text("loop"), true, 1);
    check_ring(SMOOTH_TEXT, true, 2);
    check_ring(BUTTERFLY_TEXT, false, 2);
    test_end();
}

int main(void)
{
    test_children();
    test_windows();
    test_refinement();
    test_ring();
    return test_status();
}
