/* t-element.c: children, windows and refinements of elements, against plain subdivision of the lattice; the ring. */
#include "lib/element.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/influence.h"
#include "lib/ring.h"

/* The box spline mask of the hat function's third power: reach 3, no negative weight. */
#define SMOOTH_TEXT SCHEME_TEXT("(0,0) 7/16\n(1,0) 39/128\n(1,1) 9/64\n(2,0) 3/32\n(1,2) 3/128\n(3,0) 1/128\n", "1/2")

enum { TYPES = 6 };
static const char *const type_name[TYPES] = {"UP", "DOWN", "EDGE", "SQUARE", "ALONG_FIRST", "ALONG_SECOND"};

/* The types of a mesh: first_type .. first_type + 2. */
static int first_type(mesh_kind mesh) { return mesh == MESH_TRIANGLE ? 0 : 3; }

/* The least and greatest a, b, and of triangles a + b, over the vertices of an element at (0,0), by the pictures in
   lib/ring.md. */
static const int low_of[TYPES][3] = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -9}, {0, 0, -9}, {0, 0, -9}};
static const int high_of[TYPES][3] = {{1, 1, 1}, {1, 1, 2}, {1, 1, 1}, {1, 1, 9}, {1, 0, 9}, {0, 1, 9}};

/* Is (a,b) / scale in the element at (0,0)?  Elements are what the functionals allow. */
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
    static const int expected_children[TYPES] = {4, 4, 2, 4, 2, 2}, expected_vertices[TYPES] = {3, 3, 2, 4, 2, 2};
    test_begin("element-children");
    for (int type = 0; type < TYPES; type++) {
        int children = element_children((element_type)type), vertices = element_vertices((element_type)type);
        CHECK(children == expected_children[type] && vertices == expected_vertices[type], "%s", type_name[type]);
        CHECK(element_is_segment((element_type)type) == (vertices == 2), "%s", type_name[type]);
        CHECK(element_is_of((element_type)type, MESH_TRIANGLE) == (type < 3) && element_is_of((element_type)type, MESH_QUAD) == (type >= 3)
                  && element_is_of((element_type)type, MESH_DUAL) == (type >= 3), "the mesh of %s", type_name[type]);
        for (int v = 0; v < vertices; v++) {
            lattice p = element_get_vertex((element_type)type, v);
            CHECK(is_in_element(type, p.a, p.b, 1, false), "vertex %d of %s", v, type_name[type]);
            for (int w = 0; w < v; w++) {
                lattice q = element_get_vertex((element_type)type, w);
                CHECK(p.a != q.a || p.b != q.b, "vertices %d and %d of %s are the same", v, w, type_name[type]);
            }
        }
        /* every point of the element is in a child, and only on borders in two: all points in 60ths */
        for (long a = -120; a <= 240; a++)
            for (long b = -120; b <= 240; b++) {
                int closed = 0, open = 0;
                for (int c = 0; c < children; c++) {
                    element_child child = element_get_child((element_type)type, c);
                    CHECK((int)child.type / 3 == type / 3 && element_is_segment(child.type) == element_is_segment((element_type)type), "kinds of children");
                    long x = 2 * a - 60 * child.shift.a, y = 2 * b - 60 * child.shift.b;
                    closed += is_in_element((int)child.type, x, y, 60, false);
                    open += is_in_element((int)child.type, x, y, 60, true);
                }
                CHECK((closed > 0) == is_in_element(type, a, b, 60, false), "%s: (%ld,%ld)/60 is in %d children", type_name[type], a, b, closed);
                CHECK(open <= 1, "%s: (%ld,%ld)/60 is inside %d children", type_name[type], a, b, open);
            }
    }
    /* certificates count on these orders */
    for (int c = 0; c < 4; c++) {
        element_child child = element_get_child(ELEMENT_SQUARE, c);
        CHECK(child.shift.a == c % 2 && child.shift.b == c / 2, "the order of the children of SQUARE");
    }
    for (int c = 0; c < 2; c++) {
        CHECK(element_get_child(ELEMENT_ALONG_FIRST, c).shift.a == c && element_get_child(ELEMENT_ALONG_SECOND, c).shift.b == c, "the order of the children of segments");
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

static void check_windows(mesh_kind mesh, const laurent *mask, bool sharp)
{
    element_stencil s;
    long middle[2] = {0, 0}, count = 0;
    for (int a = -4; a <= 4; a++)
        for (int b = -4; b <= 4; b++)
            if (!laurent_is_zero_at(mask, a, b))
                middle[0] += a, middle[1] += b, count++;
    spread_delta(mask);
    element_stencil_init(&s);
    MUST(element_stencil_make(&s, mesh, mask));
    for (int type = 0; type < TYPES; type++)
        CHECK((s.window[type].count > 0) == (type / 3 == first_type(mesh) / 3), "%s: the wrong mesh", type_name[type]);
    for (int type = first_type(mesh); type < first_type(mesh) + 3; type++) {
        int points = 0, last[2] = {-99, -99};
        for (int a = -6; a <= 6; a++)
            for (int b = -6; b <= 6; b++) {
                bool listed = in_window(&s.window[type], a, b), used = false;
                for (int level = 0; level <= LEVELS; level++)
                    used = used || reaches(type, a, b, level, middle, count);
                CHECK(listed || !used, "%s: the window lacks (%d,%d)", type_name[type], a, b);
                CHECK(!sharp || element_is_segment((element_type)type) || used || !listed, "%s: (%d,%d) is in the window for nothing", type_name[type], a, b);
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

static void check_windows_of(const char *name)
{
    scheme z;
    regular_masks masks;
    read_scheme(&z, catalogue_text(name));
    regular_init(&masks);
    MUST(regular_derive(&masks, &z.mask, z.mesh));
    check_windows(z.mesh, &z.mask, true);
    check_windows(z.mesh, &masks.derivative[0], true);
    check_windows(z.mesh, &masks.derivative[1], true);
    regular_clear(&masks);
    scheme_clear(&z);
}

static void test_windows(void)
{
    test_begin("element-windows-loop");
    check_windows_of("loop");
    test_end();
    test_begin("element-windows-quads");
    check_windows_of("catmull-clark");
    check_windows_of("doo-sabin");
    test_end();
    test_begin("element-windows");
    for (test_cases(60); test_next();) {
        laurent mask;
        laurent_init(&mask);
        random_mask(&mask, true);
        check_windows((mesh_kind)random_below(3), &mask, false);
        laurent_clear(&mask);
    }
    test_end();
}

/* Basis functions of dual schemes, computed at their true places, (a - 1/2) / 2^n for the label a of level n: the value
   of the delta at y is not 0 somewhere inside an element if and only if y is in its window.  `many` steps, so that one
   half step does not matter: the border of a support is thin. */
enum { MANY = 6, DUAL_HALF = 320, DUAL_SIDE = 2 * DUAL_HALF + 1 };

static void check_dual_support(const char *name)
{
    static bool old[DUAL_SIDE][DUAL_SIDE], new_values[DUAL_SIDE][DUAL_SIDE];
    scheme z;
    element_stencil s;
    read_scheme(&z, name);
    CHECK(z.mesh == MESH_DUAL && laurent_is_nonnegative(&z.mask), "the test itself");
    element_stencil_init(&s);
    MUST(element_stencil_make(&s, z.mesh, &z.mask));
    memset(old, 0, sizeof old);
    old[DUAL_HALF][DUAL_HALF] = true; /* non-negative weights: what is not 0 stays so */
    for (int n = 0; n < MANY; n++) {
        memset(new_values, 0, sizeof new_values);
        for (int a = -DUAL_HALF / 2; a <= DUAL_HALF / 2; a++)
            for (int b = -DUAL_HALF / 2; b <= DUAL_HALF / 2; b++)
                for (long i = z.mask.a0; old[a + DUAL_HALF][b + DUAL_HALF] && i < z.mask.a0 + z.mask.na; i++)
                    for (long j = z.mask.b0; j < z.mask.b0 + z.mask.nb; j++)
                        if (!laurent_is_zero_at(&z.mask, i, j)) {
                            CHECK(labs(2 * a + i) <= DUAL_HALF && labs(2 * b + j) <= DUAL_HALF, "the test's plane is too small");
                            new_values[2 * a + i + DUAL_HALF][2 * b + j + DUAL_HALF] = true;
                        }
        memcpy(old, new_values, sizeof old);
    }
    for (int ya = -8; ya <= 8; ya++)
        for (int yb = -8; yb <= 8; yb++) {
            bool inside = false;
            for (int a = -DUAL_HALF; a <= DUAL_HALF; a++)
                for (int b = -DUAL_HALF; b <= DUAL_HALF; b++) /* the label y 2^n + (a,b), in halves of 2^-n */
                    inside = inside || (old[a + DUAL_HALF][b + DUAL_HALF] && is_in_element(ELEMENT_SQUARE, 2 * (ya * (1 << MANY) + a) - 1, 2 * (yb * (1 << MANY) + b) - 1, 2 << MANY, true));
            CHECK(inside == in_window(&s.window[ELEMENT_SQUARE], ya, yb), "%s: the basis function of (%d,%d) is %szero on the square", z.name, ya, yb, inside ? "not " : "");
        }
    element_stencil_clear(&s);
    scheme_clear(&z);
}

static void test_dual_support(void)
{
    test_begin("element-windows-dual-support");
    check_dual_support(catalogue_text("doo-sabin"));
    check_dual_support("scheme even\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2\naverage\nend\n");
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
        mesh_kind mesh = (mesh_kind)random_below(3);
        laurent_init(&mask);
        random_mask(&mask, random_bool());
        element_stencil_init(&s);
        MUST(element_stencil_make(&s, mesh, &mask));
        for (int i = 0; i < PLANE_SIDE * PLANE_SIDE; i++)
            old[i / PLANE_SIDE][i % PLANE_SIDE] = (double)random_range(-1000, 1000);
        for (int type = first_type(mesh); type < first_type(mesh) + 3; type++)
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

/* ---- the ring, point by point as lib/ring.md has it ---- */

static int smallest(int x, int y) { return x < y ? x : y; }
static int greatest(int x, int y) { return x > y ? x : y; }

static bool in_window_by_definition(const laurent *mask, int type, int a, int b)
{
    int f[3] = {a, b, a + b};
    for (int i = 0; i < (type < 3 ? 3 : 2); i++) {
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

static int distance(mesh_kind mesh, int a, int b)
{
    return greatest(abs(a), greatest(abs(b), mesh == MESH_TRIANGLE ? abs(a + b) : 0));
}

static int distance_to_element(int type, int a, int b)
{
    static const int corner[TYPES][4][2] = {{{0, 0}, {1, 0}, {0, 1}, {0, 1}}, {{1, 1}, {0, 1}, {1, 0}, {1, 0}}, {{1, 0}, {0, 1}, {1, 0}, {1, 0}},
                                            {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 0}, {1, 0}, {1, 0}, {1, 0}}, {{0, 0}, {0, 1}, {0, 1}, {0, 1}}};
    int best = 99;
    for (int v = 0; v < 4; v++)
        best = smallest(best, distance(type < 3 ? MESH_TRIANGLE : MESH_QUAD, a - corner[type][v][0], b - corner[type][v][1]));
    return best;
}

/* The ring of any label of the plane: how far from the centre it is. */
static int ring_of(mesh_kind mesh, int a, int b)
{
    return mesh == MESH_DUAL ? greatest(greatest(a, 1 - a), greatest(b, 1 - b)) : distance(mesh, a, b);
}

static bool is_opposite(mesh_kind mesh, int a, int b)
{
    return mesh == MESH_DUAL ? a <= 0 && b <= 0 : a < 0 && b <= 0;
}

/* For which elements a net counts, and the second point of its differences. */
static bool counts(int net, int type) { return element_is_segment((element_type)type) == (net == RING_VALUES); }
static const int step[RING_NETS][2] = {{0, 0}, {1, 0}, {0, 1}};

/* Calls for all used points of an element; what is used is never opposite, and beyond ring F at level >= 1; nor are the
   points that the composed mask asks for there. */
static void check_used_points(const ring *z, mesh_kind mesh, element_type type, int a, int b, int level, int farthest)
{
    for (int net = 0; net < RING_NETS; net++)
        for (int i = 0; counts(net, (int)type) && i < z->stencil[net].window[type].count; i++)
            for (int second = 0; second < 2; second++) {
                lattice p = z->stencil[net].window[type].point[i];
                int x = a + p.a + second * step[net][0], y = b + p.b + second * step[net][1];
                CHECK(!is_opposite(mesh, x, y), "level %d: (%d,%d) is opposite", level, x, y);
                CHECK(level == 0 || ring_of(mesh, x, y) > farthest, "level %d: (%d,%d) is used", level, x, y);
                CHECK(level > 0 || ring_of(mesh, x, y) <= z->rings, "(%d,%d) is beyond ring %d", x, y, z->rings);
                for (int p2 = -30; level > 0 && p2 <= 30; p2++)
                    for (int q = -30; q <= 30; q++)
                        if (!laurent_is_zero_at(z->mask[RING_VALUES], x - 2 * p2, y - 2 * q))
                            CHECK(!is_opposite(mesh, p2, q), "level %d: the rule of (%d,%d) asks for (%d,%d)", level, x, y, p2, q);
            }
}

static int expected_order(element *list, mesh_kind mesh, int r)
{
    int n = 0;
    if (mesh == MESH_TRIANGLE) {
        for (int type = 0; type < 2; type++)
            for (int j = 0; j < 2 * r; j++)
                for (int b = 0; b <= j; b++)
                    if (type == 0 ? r <= j && j < 2 * r : r <= j + 1 && j + 2 <= 2 * r)
                        list[n++] = (element){(element_type)type, j - b, b};
    } else {
        for (int j = 0; j < 2 * r; j++)
            for (int b = 0; b < 2 * r; b++)
                for (int a = 2 * r; a >= 0; a--)
                    if (greatest(a, b) == j && r <= j && greatest(a, b) + 1 <= 2 * r)
                        list[n++] = (element){ELEMENT_SQUARE, a, b};
    }
    return n;
}

/* The outer curve of one sector as a polygon: consecutive segments share a vertex, from one spoke to the other. */
static void check_boundary(const ring *z, mesh_kind mesh)
{
    int r = z->radius, a = 2 * r, b = 0;
    CHECK(z->boundary_count == (mesh == MESH_TRIANGLE ? 2 * r : 4 * r), "%d segments", z->boundary_count);
    for (int i = 0; i < z->boundary_count && !test_failed(); i++) {
        lattice p = element_get_vertex(z->boundary[i].type, 0), q = element_get_vertex(z->boundary[i].type, 1);
        int p_a = z->boundary[i].a + p.a, p_b = z->boundary[i].b + p.b, q_a = z->boundary[i].a + q.a, q_b = z->boundary[i].b + q.b;
        CHECK(element_is_segment(z->boundary[i].type) && element_is_of(z->boundary[i].type, mesh), "segment %d", i);
        CHECK((p_a == a && p_b == b) || (q_a == a && q_b == b), "segment %d does not begin at (%d,%d)", i, a, b);
        if (p_a == a && p_b == b)
            a = q_a, b = q_b;
        else
            a = p_a, b = p_b;
        CHECK(a >= 0 && b >= 0 && (mesh == MESH_TRIANGLE ? a + b : greatest(a, b)) == 2 * r, "segment %d leads to (%d,%d)", i, a, b);
    }
    CHECK(a == 0 && b == 2 * r, "the curve ends at (%d,%d)", a, b);
}

static void check_ring(const char *text, bool nonnegative, int farthest, int expected_radius)
{
    scheme s;
    regular_masks masks;
    ring z;
    static element expected[1000];
    int omega = 0, h = 0, r = 1, n, f;
    read_scheme(&s, text);
    regular_init(&masks);
    ring_init(&z);
    MUST(regular_derive(&masks, &s.mask, s.mesh));
    CHECK(masks.divisible, "the test itself");
    MUST(influence_farthest(&f, &s));
    CHECK(f == farthest, "%s: rules matter up to ring %d, not %d", s.name, f, farthest);
    MUST(ring_make(&z, &s, &masks));
    CHECK(z.nonnegative == nonnegative, "nonnegative");
    const laurent *mask[RING_NETS] = {&s.mask, &masks.derivative[0], &masks.derivative[1]};
    for (int net = 0; net < RING_NETS; net++)
        for (int type = first_type(s.mesh); type < first_type(s.mesh) + 3; type++) {
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
            if (counts(net, type))
                omega = greatest(omega, most);
        }
    for (int a = -8; a <= 8; a++) /* a dual label i stands for i + 1/2 */
        for (int b = -8; b <= 8; b++)
            if (!laurent_is_zero_at(&s.mask, a, b))
                h = greatest(h, s.mesh == MESH_DUAL ? (distance(MESH_QUAD, 2 * a + 1, 2 * b + 1) + 1) / 2 : distance(s.mesh, a, b));
    while (s.mesh == MESH_TRIANGLE ? !(omega <= r && omega + h < 2 * (r + 1) && omega + f < 2 * r) : !(omega < r && omega + h < 2 * r && omega + f < 2 * r))
        r++;
    CHECK(z.radius == r && r == expected_radius && z.rings == 2 * r + omega, "%s: r = %d, rings = %d; expected %d and %d", s.name, z.radius, z.rings, r, 2 * r + omega);
    n = expected_order(expected, s.mesh, r);
    CHECK(n == z.element_count && n == 3 * r * r, "%d elements", z.element_count); /* their area: (2 r)^2 - r^2 */
    for (int i = 0; i < n && !test_failed(); i++)
        CHECK(z.elements[i].type == expected[i].type && z.elements[i].a == expected[i].a && z.elements[i].b == expected[i].b, "element %d", i);
    check_boundary(&z, s.mesh);
    for (int i = 0; i < n + z.boundary_count && !test_failed(); i++) {
        element e = i < n ? z.elements[i] : z.boundary[i - n];
        check_used_points(&z, s.mesh, e.type, e.a, e.b, 0, f);
        for (int c = 0; c < element_children(e.type); c++) {
            element_child child = element_get_child(e.type, c);
            int a = 2 * e.a + child.shift.a, b = 2 * e.b + child.shift.b;
            check_used_points(&z, s.mesh, child.type, a, b, 1, f);
            for (int d = 0; d < element_children(child.type); d++) {
                element_child grandchild = element_get_child(child.type, d);
                check_used_points(&z, s.mesh, grandchild.type, 2 * a + grandchild.shift.a, 2 * b + grandchild.shift.b, 2, f);
            }
        }
    }
    ring_clear(&z);
    regular_clear(&masks);
    scheme_clear(&s);
}

#define MIDPOINT_TEXT(rest) "scheme midpoint\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\n" rest "end\n"
#define SMOOTH "smooth 1/4, 1/2\n"

/* Loop's mask and a rule that says the same, far out. */
#define FAR_RULE_TEXT LOOP_TEXT "rule (3,2) when k = 9\n(1,1) 3/8\n(2,1) 3/8\n(1,2) 1/8\n(2,0) rest\nend\n"

/* Bicubic splines in one step: no rule matters beyond the centre. */
#define DIRECT_TEXT                                                                                                          \
    "scheme direct\nmesh quad\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 9/16\n(1,0) 3/8\n(1,1) 1/4\n(2,0) 3/32\n" \
    "(2,1) 1/16\n(2,2) 1/64\nend\nrule centre\ncentre 1/2\nall (1,0) rest\nend\n"

/* What special points of a step before do: a rule for (3,0) behind the first of two smoothings reaches ring 4. */
static void test_influence(void)
{
    scheme s;
    int f;
    test_begin("influence-through-steps");
    read_scheme(&s, MIDPOINT_TEXT(SMOOTH SMOOTH));
    CHECK(s.step_count == 3 && s.steps[1].rule_count == 1 && s.steps[1].rules[0].at_centre, "the test itself");
    s.steps[1].rules[0].at_centre = false;
    s.steps[1].rules[0].point = (lattice){3, 0};
    MUST(influence_farthest(&f, &s));
    CHECK(f == 4, "F = %d", f);
    s.steps[1].rules[0].point = (lattice){2, 7};
    MUST(influence_farthest(&f, &s));
    CHECK(f == 8, "F = %d", f);
    scheme_clear(&s);
    test_end();
}

static void test_ring(void)
{
    test_begin("ring-triangles");
    check_ring(catalogue_text("loop"), true, 0, 1);
    check_ring(SMOOTH_TEXT, true, 1, 2); /* its weight at (3,0) asks for what is opposite */
    check_ring(BUTTERFLY_TEXT, false, 0, 2);
    check_ring(catalogue_text("modified-loop"), true, 1, 2);
    check_ring(catalogue_text("modified-butterfly"), false, 1, 2);
    check_ring(FAR_RULE_TEXT, true, 5, 4);
    test_end();
    test_begin("ring-quads");
    check_ring(catalogue_text("catmull-clark"), true, 1, 2);
    check_ring(MIDPOINT_TEXT(SMOOTH SMOOTH), true, 3, 3);
    check_ring(MIDPOINT_TEXT(SMOOTH SMOOTH SMOOTH), true, 4, 4);
    check_ring(catalogue_text("kobbelt"), false, 3, 3);
    check_ring(DIRECT_TEXT, true, 0, 2);
    test_end();
    test_begin("ring-dual-quads");
    check_ring(catalogue_text("doo-sabin"), true, 1, 2);
    check_ring(MIDPOINT_TEXT("average\n"), true, 1, 2);
    check_ring(MIDPOINT_TEXT(SMOOTH "average\n"), true, 2, 3);
    check_ring(MIDPOINT_TEXT(SMOOTH SMOOTH "average\n"), true, 3, 4);
    test_end();
}

int main(void)
{
    test_children();
    test_windows();
    test_dual_support();
    test_refinement();
    test_influence();
    test_ring();
    return test_status();
}
