/* t-charnet.c: the net of the characteristic map is an eigenvector; its windows and local bounds contain the limit.

   What is contained comes from subdivision in doubles on sector nets of complex numbers, with Loop's rules written
   by hand, as far as the sixth level. */
#include "lib/charnet.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/eigenpair.h"
#include "region.h"

#define PI 3.14159265358979323846

#if defined(NUMBER_INTERVAL)
enum { PRECISION = 53, GRID = 64 };
#else
enum { PRECISION = 64, GRID = 64 };
#endif

/* All that leads to a characteristic net. */
typedef struct {
    int k;
    scheme scheme;
    regular_masks regular;
    ring ring;
    scheme_numbers numbers;
    block block;
    eigenpair_choice choice;
    number *box;
    sector_net net;
} setting;

static bool make_setting(setting *z, const char *text, int k, int more_rings)
{
    diagnostic d = {0, 0, ""};
    memset(z, 0, sizeof *z);
    z->k = k;
    read_scheme(&z->scheme, text);
    regular_init(&z->regular);
    ring_init(&z->ring);
    eigenpair_choice_init(&z->choice);
    MUST(regular_derive(&z->regular, &z->scheme.mask, MESH_TRIANGLE));
    MUST(ring_make(&z->ring, &z->scheme, &z->regular));
    CHECK(scheme_numbers_make(&z->numbers, &z->scheme, k, PRECISION, &d) == STATUS_OK, "weights: %s", d.text);
    CHECK(block_make(&z->block, &z->numbers, 1, true, &d) == BLOCK_OK, "block: %s", d.text);
    z->box = number_array_new((size_t)z->block.n + 1);
    CHECK(eigenpair_choose(&z->choice, z->block.entry, z->block.n, false, GRID, PRECISION) == TRUTH_TRUE
              && eigenpair_prove(z->box, &z->choice, z->block.entry, PRECISION) == TRUTH_TRUE, "no eigenpair at k = %d", k);
    CHECK(charnet_make(&z->net, &z->block, z->box, false, &z->numbers, z->ring.rings + more_rings) == BLOCK_OK, "no net at k = %d", k);
    return !test_failed();
}

static void free_setting(setting *z)
{
    sector_net_free(&z->net);
    number_array_free(z->box, (size_t)z->block.n + 1);
    eigenpair_choice_clear(&z->choice);
    block_free(&z->block);
    scheme_numbers_free(&z->numbers);
    ring_clear(&z->ring);
    regular_clear(&z->regular);
    scheme_clear(&z->scheme);
}

/* ---- S V = L V ---- */

static void check_eigenvector(const setting *z)
{
    number x, y, t;
    const number *eigenvalue = &z->box[z->block.n];
    number_init(&x), number_init(&y), number_init(&t);
    for (int j = 1; j <= z->net.rings; j++)
        for (int b = 0; b < j && (j + z->scheme.steps[0].reach) / 2 <= z->net.rings; b++) {
            int at = sector_index(&z->net, j - b, b);
            CHECK(sector_masked_value(&x, &y, &z->net, &z->numbers.steps[0].mask, 2, j - b, b, PRECISION) == SECTOR_OK, "(%d,%d)", j - b, b);
            number_submul(&x, eigenvalue, &z->net.x[at], PRECISION);
            number_submul(&y, eigenvalue, &z->net.y[at], PRECISION);
            CHECK(number_contains_zero(&x) && number_contains_zero(&y), "k = %d: S V is not L V at (%d,%d)", z->k, j - b, b);
            CHECK(fabs(number_upper_bound(&x)) < 1e-7 && fabs(number_lower_bound(&y)) < 1e-7, "k = %d: wide at (%d,%d)", z->k, j - b, b);
        }
    number_clear(&x), number_clear(&y), number_clear(&t);
}

static void test_eigenvector(void)
{
    static const int valences[] = {3, 4, 5, 7, 8, 12, 20};
    test_begin("charnet-eigenvector-loop");
    for (int i = 0; i < 7 && !test_failed(); i++) {
        setting z;
        if (make_setting(&z, catalogue_text("loop"), valences[i], 6)) {
            double l = 0.375 + cos(2 * PI / valences[i]) / 4;
            CHECK(z.net.rings == z.ring.rings + 6, "%d rings", z.net.rings);
            CHECK(is_near(&z.box[z.block.n], l, 1e-9), "L at k = %d", valences[i]);
            check_eigenvector(&z);
        }
        free_setting(&z);
    }
    test_end();
    test_begin("charnet-eigenvector-butterfly");
    for (int k = 4; k <= 7 && !test_failed(); k++) {
        setting z;
        if (make_setting(&z, BUTTERFLY_TEXT, k, 6)) {
            if (k == 7)
                CHECK(is_near(&z.box[z.block.n], 0.48191070, 2e-8), "L at k = 7");
            check_eigenvector(&z);
        }
        free_setting(&z);
    }
    test_end();
}

/* At k = 6 the net is the plane itself, up to a linear map: V = a + b e^(i pi/3). */
static void test_regular_valence(void)
{
    setting z;
    test_begin("charnet-valence-6");
    if (make_setting(&z, catalogue_text("loop"), 6, 3)) {
        double unit = number_mid_approx(&z.net.x[sector_index(&z.net, 1, 0)]);
        CHECK(is_near(&z.box[z.block.n], 0.5, 1e-9), "L is not 1/2");
        for (int j = 1; j <= z.net.rings; j++)
            for (int b = 0; b < j; b++) {
                int at = sector_index(&z.net, j - b, b);
                double re = j - b + b * 0.5, im = b * sqrt(0.75);
                CHECK(is_near(&z.net.x[at], unit * re, 1e-7) && is_near(&z.net.y[at], unit * im / 0.5, 1e-7), "(%d,%d)", j - b, b);
            }
    }
    free_setting(&z);
    test_end();
}

/* ---- windows ---- */

static void check_window(const setting *z, int which)
{
    charnet_windows w;
    const element *list = which == RING_VALUES ? z->ring.boundary : z->ring.elements;
    int count = which == RING_VALUES ? z->ring.boundary_count : z->ring.element_count;
    number p[2], q[2], thin[2];
    for (int c = 0; c < 2; c++)
        number_init(&p[c]), number_init(&q[c]), number_init(&thin[c]);
    CHECK(charnet_windows_make(&w, &z->net, &z->ring, which, list, count, PRECISION) == BLOCK_OK, "k = %d, net %d", z->k, which);
    CHECK(w.count == count && number_upper_bound(&w.radius[0]) < 1e-8 && number_upper_bound(&w.radius[1]) < 1e-8, "k = %d, net %d: the radius is large", z->k, which);
    for (int i = 0; i < count && !test_failed(); i++)
        for (int j = 0; j < w.window[list[i].type]; j++) {
            lattice y = z->ring.stencil[which].window[list[i].type].point[j];
            int a = list[i].a + y.a, b = list[i].b + y.b;
            CHECK(sector_value(&p[0], &p[1], &z->net, a, b, PRECISION) == SECTOR_OK, "(%d,%d)", a, b);
            if (which != RING_VALUES) {
                CHECK(sector_value(&q[0], &q[1], &z->net, a + (which == RING_FIRST), b + (which == RING_SECOND), PRECISION) == SECTOR_OK, "(%d,%d)", a, b);
                for (int c = 0; c < 2; c++)
                    number_sub(&p[c], &q[c], &p[c], PRECISION);
            }
            number_set(&thin[0], &w.x[i * w.stride + j]);
            number_set(&thin[1], &w.y[i * w.stride + j]);
            for (int c = 0; c < 2; c++) {
                CHECK(number_is_thin(&thin[c]), "a value that is not thin");
                number_add_error(&thin[c], &thin[c], &w.radius[c], PRECISION);
                CHECK(number_contains(&thin[c], &p[c]), "k = %d, net %d, element %d, point %d: further away than the radius", z->k, which, i, j);
            }
        }
    charnet_windows_free(&w);
    for (int c = 0; c < 2; c++)
        number_clear(&p[c]), number_clear(&q[c]), number_clear(&thin[c]);
}

static void test_windows(void)
{
    static const int valences[] = {3, 5, 8, 20};
    test_begin("charnet-windows");
    for (int i = 0; i < 4 && !test_failed(); i++) {
        setting z;
        if (make_setting(&z, catalogue_text("loop"), valences[i], 0))
            for (int which = 0; which < RING_NETS; which++)
                check_window(&z, which);
        free_setting(&z);
    }
    test_end();
}

/* ---- the limit ---- */

typedef struct {
    double re, im;
} complex_value;

typedef struct {
    int k, rings;
    complex_value *at; /* (a,b), a >= 1, b >= 0, a + b <= rings, in rows of equal a + b */
} complex_net;

static complex_value get(const complex_net *z, int a, int b)
{
    complex_value v = {0, 0};
    int turns = 0;
    double w = 2 * PI / z->k;
    if (a == 0 && b == 0)
        return v;
    while (a < 1 || b < 0) {
        int old = a;
        CHECK(!(a < 0 && b <= 0), "(%d,%d) is opposite", a, b);
        if (test_failed())
            return v;
        if (b >= 1)
            a = old + b, b = -old, turns++;
        else
            a = -b, b = old + b, turns--;
    }
    CHECK(a + b <= z->rings, "ring %d of %d", a + b, z->rings);
    if (test_failed())
        return v;
    v = z->at[(a + b) * (a + b - 1) / 2 + b];
    if (turns) {
        complex_value t = {cos(w * turns), sin(w * turns)};
        v = (complex_value){v.re * t.re - v.im * t.im, v.re * t.im + v.im * t.re};
    }
    return v;
}

static void add(complex_value *z, double weight, complex_value v)
{
    z->re += weight * v.re;
    z->im += weight * v.im;
}

static const int neighbour[6][2] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};

/* Loop's rules away from the centre: a vertex and its six neighbours; an edge, its ends, and the two points that see
   both of them. */
static complex_value loop_value(const complex_net *z, int a, int b)
{
    complex_value v = {0, 0};
    if (a % 2 == 0 && b % 2 == 0) {
        add(&v, 5.0 / 8, get(z, a / 2, b / 2));
        for (int i = 0; i < 6; i++)
            add(&v, 1.0 / 16, get(z, a / 2 + neighbour[i][0], b / 2 + neighbour[i][1]));
    } else {
        /* the edge from (p,q) goes in the direction d, where (a,b) = 2 (p,q) + d; left and right of it are the
           directions next to d */
        int d = b % 2 == 0 ? 0 : a % 2 == 0 ? 1 : 2;
        int p = (a - neighbour[d][0]) / 2, q = (b - neighbour[d][1]) / 2;
        add(&v, 3.0 / 8, get(z, p, q));
        add(&v, 3.0 / 8, get(z, p + neighbour[d][0], q + neighbour[d][1]));
        add(&v, 1.0 / 8, get(z, p + neighbour[d + 1][0], q + neighbour[d + 1][1]));
        add(&v, 1.0 / 8, get(z, p + neighbour[(d + 5) % 6][0], q + neighbour[(d + 5) % 6][1]));
    }
    return v;
}

/* Rings up to 2 n - 1 of the next net follow from n of this one. */
static void refine_net(complex_net *z)
{
    int rings = 2 * z->rings - 1;
    complex_value *next = malloc((size_t)(rings * (rings + 1) / 2) * sizeof *next);
    for (int j = 1; j <= rings; j++)
        for (int b = 0; b < j; b++)
            next[j * (j - 1) / 2 + b] = loop_value(z, j - b, b);
    free(z->at);
    z->at = next;
    z->rings = rings;
}

static void box_of(number *box, const number *value, int count, const number *radius)
{
    number_set(box, &value[0]);
    for (int i = 1; i < count; i++)
        number_hull(box, box, &value[i], PRECISION);
    number_add_error(box, box, radius, PRECISION);
}

/* The smallest distance from v to the outside of the box, with the sign of being inside. */
static double depth(const number *box, double v)
{
    return fmin(v - number_lower_bound(box), number_upper_bound(box) - v);
}

static bool is_in_element(element_type type, int a, int b, int scale)
{
    if (type == ELEMENT_UP)
        return a >= 0 && b >= 0 && a + b <= scale;
    if (type == ELEMENT_DOWN)
        return a <= scale && b <= scale && a + b >= scale;
    return a >= 0 && b >= 0 && a + b == scale;
}

/* What the boxes of an element must contain: differences along edges inside it, and the limits at its points. */
static void check_boxes(const setting *z, const complex_net *fine, int level, int which)
{
    charnet_windows w;
    const element *list = which == RING_VALUES ? z->ring.boundary : z->ring.elements;
    int count = which == RING_VALUES ? z->ring.boundary_count : z->ring.element_count, scale = 1 << level;
    int e1 = which == RING_FIRST, e2 = which == RING_SECOND;
    double half = sin(PI / z->k), deepest = 0;
    number x, y;
    number_init(&x), number_init(&y);
    CHECK(charnet_windows_make(&w, &z->net, &z->ring, which, list, count, PRECISION) == BLOCK_OK, "windows");
    for (int i = 0; i < count && !test_failed(); i++) {
        box_of(&x, &w.x[i * w.stride], w.window[list[i].type], &w.radius[0]);
        box_of(&y, &w.y[i * w.stride], w.window[list[i].type], &w.radius[1]);
        for (int a = 0; a <= scale; a++)
            for (int b = 0; b <= scale; b++) {
                if (!is_in_element(list[i].type, a, b, scale))
                    continue;
                int p = scale * list[i].a + a, q = scale * list[i].b + b;
                complex_value limit = {0, 0}, difference = {0, 0};
                if (which == RING_VALUES) {
                    add(&limit, 1.0 / 2, get(fine, p, q));
                    for (int n = 0; n < 6; n++)
                        add(&limit, 1.0 / 12, get(fine, p + neighbour[n][0], q + neighbour[n][1]));
                } else
                    for (int n = 0; n < 6; n++) /* the derivative: cosines of the angles to e1 or e2, over 3 */
                        add(&limit, scale * cos(PI * (n - e2) / 3) / 3, get(fine, p + neighbour[n][0], q + neighbour[n][1]));
                CHECK(depth(&x, limit.re) > -1e-9 && depth(&y, limit.im / half) > -1e-9, "k = %d, net %d, element %d at (%d,%d)/%d: the limit is %.3g, %.3g outside", z->k, which, i, a, b,
                      scale, -depth(&x, limit.re), -depth(&y, limit.im / half));
                deepest = fmax(deepest, fmin(depth(&x, limit.re), depth(&y, limit.im / half)));
                if (which == RING_VALUES || !is_in_element(list[i].type, a + e1, b + e2, scale))
                    continue;
                add(&difference, scale, get(fine, p + e1, q + e2));
                add(&difference, -scale, get(fine, p, q));
                CHECK(depth(&x, difference.re) > -1e-9 && depth(&y, difference.im / half) > -1e-9, "k = %d, net %d, element %d at (%d,%d)/%d: the difference is %.3g, %.3g outside", z->k, which, i, a,
                      b, scale, -depth(&x, difference.re), -depth(&y, difference.im / half));
            }
        CHECK(number_upper_bound(&x) - number_lower_bound(&x) < 4, "a box is wide");
    }
    CHECK(test_failed() || deepest > 0.001, "all limits are on the border of their boxes");
    charnet_windows_free(&w);
    number_clear(&x), number_clear(&y);
}

static void check_limits(int k, int levels)
{
    setting z;
    complex_net net = {k, 0, NULL};
    if (make_setting(&z, catalogue_text("loop"), k, 1)) {
        net.rings = z.net.rings;
        net.at = malloc((size_t)(net.rings * (net.rings + 1) / 2) * sizeof *net.at);
        for (int j = 1; j <= net.rings; j++)
            for (int b = 0; b < j; b++) {
                int i = sector_index(&z.net, j - b, b);
                net.at[j * (j - 1) / 2 + b] = (complex_value){number_mid_approx(&z.net.x[i]), sin(PI / k) * number_mid_approx(&z.net.y[i])};
            }
        for (int level = 0; level <= levels && !test_failed(); level++) {
            if (level)
                refine_net(&net);
            if (level == 0 || level == 3 || level == levels)
                for (int which = level ? 0 : 1; which < RING_NETS; which++)
                    check_boxes(&z, &net, level, which);
        }
    }
    free(net.at);
    free_setting(&z);
}

static void test_limits(void)
{
    static const int valences[] = {3, 5, 8, 20};
    test_begin("charnet-limits-in-boxes");
    for (int i = 0; i < 4 && !test_failed(); i++)
        check_limits(valences[i], 6);
    test_end();
}

static void tests(void)
{
    test_eigenvector();
    test_regular_valence();
    test_windows();
    test_limits();
}
MAIN(tests);
