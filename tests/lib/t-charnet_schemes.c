/* t-charnet_schemes.c: characteristic nets of all kinds of schemes, in real and complex form: S V = L V, what is known of
   L and V, both forms against each other, and the windows of the ring against plain subdivision in doubles. */
#include "lib/charnet.h"

#include <complex.h>
#undef I
#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/eigenpair.h"
#include "region.h"

#define PI 3.14159265358979323846

#if defined(NUMBER_INTERVAL)
enum { PRECISION = 53, GRID = 64 };
#else
enum { PRECISION = 96, GRID = 96 };
#endif

typedef double _Complex cplx;

static cplx make(double re, double im) { return re + im * _Complex_I; }

typedef struct {
    const char *name;
    long k;
    bool real;
    scheme scheme;
    regular_masks regular;
    ring ring;
    scheme_numbers numbers;
    block block;
    eigenpair_choice choice;
    number *box;
    size_t box_size;
    sector_net net;
} setting;

/* The block as one real matrix: (R, -I; I, R), or R itself. */
static number *real_matrix(const block *b)
{
    int n = b->n, order = b->imaginary ? 2 * n : n;
    number *z = number_array_new((size_t)(order * order));
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++) {
            int at = i % n * n + j % n;
            if (i / n == j / n)
                number_set(&z[i * order + j], &b->entry[at]);
            else if (i / n)
                number_set(&z[i * order + j], &b->imaginary[at]);
            else
                number_neg(&z[i * order + j], &b->imaginary[at]);
        }
    return z;
}

/* name is of the catalogue, or "midpoint N". */
static bool make_setting(setting *z, const char *name, long k, bool real)
{
    diagnostic d = {0, 0, ""};
    char word[40] = "", parameter[40];
    const char *parameters[] = {parameter};
    int degree = 0;
    scheme_settings settings = {parameters, 0};
    memset(z, 0, sizeof *z);
    sscanf(name, "%39s %d", word, &degree);
    snprintf(parameter, sizeof parameter, "degree=%d", degree);
    settings.count = degree > 0;
    z->name = name;
    z->k = k;
    scheme_init(&z->scheme);
    regular_init(&z->regular);
    ring_init(&z->ring);
    eigenpair_choice_init(&z->choice);
    const char *text = catalogue_text(word);
    CHECK(scheme_read(&z->scheme, text, strlen(text), &settings, &d) == STATUS_OK, "%s: %s", name, d.text);
    z->real = real && z->scheme.mirror_symmetric;
    MUST(regular_derive(&z->regular, &z->scheme.mask, z->scheme.mesh));
    MUST(ring_make(&z->ring, &z->scheme, &z->regular));
    CHECK(scheme_numbers_make(&z->numbers, &z->scheme, k, PRECISION, &d) == STATUS_OK, "%s: %s", name, d.text);
    CHECK(block_make(&z->block, &z->numbers, 1, z->real, &d) == BLOCK_OK, "%s, k = %ld: %s", name, k, d.text);
    CHECK(z->real == !z->block.imaginary, "the form");
    if (test_failed())
        return false;
    int order = z->real ? z->block.n : 2 * z->block.n;
    number *m = real_matrix(&z->block);
    z->box_size = eigenpair_box_size(order, !z->real);
    z->box = number_array_new(z->box_size);
    CHECK(eigenpair_choose(&z->choice, m, order, !z->real, GRID, PRECISION) == TRUTH_TRUE, "%s, k = %ld: no eigenpair found", name, k);
    CHECK(test_failed() || eigenpair_prove(z->box, &z->choice, m, PRECISION) == TRUTH_TRUE, "%s, k = %ld: no eigenpair proved", name, k);
    number_array_free(m, (size_t)(order * order));
    CHECK(test_failed() || charnet_make(&z->net, &z->block, z->box, z->block.imaginary != NULL, &z->numbers, z->ring.rings) == BLOCK_OK, "%s: no net at k = %ld", name, k);
    CHECK(test_failed() || z->net.rings >= z->ring.rings, "%s: %d rings", name, z->net.rings);
    return !test_failed();
}

static void free_setting(setting *z)
{
    sector_net_free(&z->net);
    if (z->box)
        number_array_free(z->box, z->box_size);
    eigenpair_choice_clear(&z->choice);
    block_free(&z->block);
    scheme_numbers_free(&z->numbers);
    ring_clear(&z->ring);
    regular_clear(&z->regular);
    scheme_clear(&z->scheme);
}

static cplx eigenvalue_of(const setting *z)
{
    const number *l = &z->box[z->choice.n];
    return make(number_mid_approx(l), z->real ? 0 : number_mid_approx(l + 1));
}

/* About the complex value at a label of the plane. */
static cplx value_at(const setting *z, int a, int b)
{
    number x, y;
    cplx v;
    number_init(&x), number_init(&y);
    CHECK(sector_value(&x, &y, &z->net, a, b, PRECISION) == SECTOR_OK, "%s: (%d,%d)", z->name, a, b);
    v = make(number_mid_approx(&x), number_mid_approx(&y) * (z->real ? sin(PI / (double)z->k) : 1));
    number_clear(&x), number_clear(&y);
    return v;
}

static bool is_close(cplx x, cplx y, double tolerance) { return cabs(x - y) <= tolerance; }

/* What all nets are compared with: 1 at the first point of the spoke, or of a dual mesh at (1,1). */
static cplx unit_of(const setting *z) { return value_at(z, 1, z->scheme.mesh == MESH_DUAL); }

/* ---- S V = L V ---- */

static void check_eigenvector(const setting *z)
{
    int rings = z->block.rings;
    sector_net image;
    number p, q;
    const number *re = &z->box[z->choice.n], *im = re + 1;
    double width = 0;
    while (scheme_rings_needed(&z->scheme, rings + 1) <= z->net.rings)
        rings++;
    CHECK(rings > z->net.rings, "%s: S V is not known on ring %d", z->name, rings + 1);
    CHECK(scheme_subdivide(&image, &z->net, &z->numbers, z->net.rings) == SUBDIVIDE_OK, "%s: S V", z->name);
    number_init(&p), number_init(&q);
    for (int a = 1; a <= z->net.rings && !test_failed(); a++)
        for (int b = z->scheme.mesh == MESH_DUAL; b <= z->net.rings; b++) {
            int at = sector_index(&z->net, a, b);
            const number *x = &z->net.x[at], *y = &z->net.y[at];
            if (mesh_ring(z->scheme.mesh, a, b) > z->net.rings)
                continue;
            number_set(&p, &image.x[sector_index(&image, a, b)]);
            number_set(&q, &image.y[sector_index(&image, a, b)]);
            number_submul(&p, re, x, PRECISION);
            number_submul(&q, re, y, PRECISION);
            if (!z->real) {
                number_addmul(&p, im, y, PRECISION);
                number_submul(&q, im, x, PRECISION);
            }
            CHECK(number_contains_zero(&p) && number_contains_zero(&q), "%s, k = %ld: S V is not L V at (%d,%d)", z->name, z->k, a, b);
            width = fmax(width, fmax(number_upper_bound(&p) - number_lower_bound(&p), number_upper_bound(&q) - number_lower_bound(&q)));
        }
    CHECK(width < 1e-6, "%s, k = %ld: L V is %.3g wide", z->name, z->k, width);
    sector_net_free(&image);
    number_clear(&p), number_clear(&q);
}

/* L at some valences, from tests/lib/catalogue-golden.txt, made without lib/; of midpoint 9 from another
   independent computation. */
typedef struct {
    const char *name;
    long k[4];
    double re[4], im;
} golden;
static const golden known[] = {
    {"doo-sabin", {3, 5, 8, 20}, {0.5, 0.5, 0.5, 0.5}, 0},
    {"modified-butterfly", {3, 5, 7, 12}, {0.5, 0.5, 0.5, 0.5}, 0},
    {"modified-loop", {3, 4, 5, 9}, {0.5, 0.5, 0.5, 0.5}, 0},
    {"loop-spiral", {3, 5, 7, 12}, {0.5, 0.5, 0.5, 0.5}, 0.2},
    {"catmull-clark", {3, 5, 8, 20}, {0.410097050801, 0.549988354518, 0.611116526695, 0.647331902642}, 0},
    {"loop", {3, 5, 8, 20}, {0.25, 0.452254248594, 0.551776695297, 0.612764129073}, 0},
    {"butterfly", {4, 5, 6, 7}, {0.469041522099, 0.506675611394, 0.5, 0.481910701413}, 0},
    {"kobbelt", {3, 5, 8, 20}, {0.426330909085, 0.537943859700, 0.582134301804, 0.607353776935}, 0},
    {"midpoint 2", {3, 5, 8}, {0.375, 0.577254248594, 0.676776695297}, 0},
    {"midpoint 3", {3, 5, 8}, {0.410097050801, 0.549988354518, 0.611116526695}, 0},
    {"midpoint 4", {3, 5, 8}, {0.396595278201, 0.568235351709, 0.663925808285}, 0},
    {"midpoint 5", {3, 5, 8}, {0.401653792073, 0.560247416517, 0.639814515675}, 0},
    {"midpoint 6", {3, 5}, {0}, 0},
    {"midpoint 7", {3, 5}, {0}, 0},
    {"midpoint 8", {3, 5}, {0}, 0},
    {"midpoint 9", {3, 5}, {0.398519240063, 0.566587645442}, 0},
};
enum { KNOWN = sizeof known / sizeof *known };

static void check_known(const golden *g, bool real)
{
    for (int i = 0; i < 4 && g->k[i] && !test_failed(); i++) {
        setting z;
        if (make_setting(&z, g->name, g->k[i], real)) {
            cplx l = eigenvalue_of(&z);
            CHECK(g->re[i] == 0 || is_close(l, make(g->re[i], g->im), 1e-9), "%s, k = %ld: L = %.12f + i %.12f", g->name, g->k[i], creal(l), cimag(l));
            CHECK(z.real || g->im != 0 || number_contains_zero(&z.box[z.choice.n + 1]), "%s, k = %ld: L is not real", g->name, g->k[i]);
            check_eigenvector(&z);
        }
        free_setting(&z);
    }
}

static void test_eigenvectors(void)
{
    test_begin("charnet-schemes-real-form");
    for (int i = 0; i < KNOWN && !test_failed(); i++)
        check_known(&known[i], true);
    test_end();
    test_begin("charnet-schemes-complex-form");
    for (int i = 0; i < KNOWN && !test_failed(); i++)
        check_known(&known[i], false);
    test_end();
}

/* Both forms give the same net but for a factor. */
static void test_forms(void)
{
    static const char *const names[] = {"loop", "catmull-clark", "doo-sabin", "midpoint 4", "midpoint 5"};
    test_begin("charnet-schemes-forms-agree");
    for (int i = 0; i < 5 && !test_failed(); i++)
        for (long k = 3; k <= 7 && !test_failed(); k++) {
            setting r, c;
            bool made = make_setting(&r, names[i], k, true);
            made = make_setting(&c, names[i], k, false) && made;
            if (made) {
                cplx factor = unit_of(&r) / unit_of(&c);
                CHECK(r.real && !c.real, "the test itself");
                for (int a = 1; a <= r.ring.rings; a++)
                    for (int b = r.scheme.mesh == MESH_DUAL; b <= r.ring.rings; b++)
                        if (mesh_ring(r.scheme.mesh, a, b) <= r.ring.rings)
                            CHECK(is_close(value_at(&r, a, b), factor * value_at(&c, a, b), 1e-8), "%s, k = %ld: the forms differ at (%d,%d)", names[i], k, a, b);
            }
            free_setting(&r), free_setting(&c);
        }
    test_end();
}

/* ---- the regular valence: the plane itself ---- */

static void thin_box(number *box, const charnet_windows *w, int at, int count, bool second)
{
    const number *value = (second ? w->y : w->x) + at * w->stride;
    number_set(box, &value[0]);
    for (int i = 1; i < count; i++)
        number_hull(box, box, &value[i], PRECISION);
    number_add_error(box, box, &w->radius[second], PRECISION);
}

static bool box_holds(const number *x, const number *y, cplx v)
{
    return creal(v) > number_lower_bound(x) - 1e-9 && creal(v) < number_upper_bound(x) + 1e-9 && cimag(v) > number_lower_bound(y) - 1e-9
           && cimag(v) < number_upper_bound(y) + 1e-9;
}

/* At the regular valence V is the place of its point times a number, so that differences are constant; the limit is
   the parameter itself: the value boxes of the outer curve contain its places. */
static void check_regular(const char *name, bool real)
{
    setting z;
    charnet_windows w;
    number x, y;
    long k = strstr(name, "loop") || strstr(name, "butterfly") ? 6 : 4;
    number_init(&x), number_init(&y);
    if (make_setting(&z, name, k, real)) {
        bool dual = z.scheme.mesh == MESH_DUAL;
        cplx t = make(cos(2 * PI / (double)k), sin(2 * PI / (double)k)), half = dual ? (1 + t) / 2 : 0, unit = unit_of(&z) / (dual ? half : 1);
        double scale = z.real ? sin(PI / (double)k) : 1;
        CHECK(is_close(eigenvalue_of(&z), 0.5, 1e-9), "%s: L is not 1/2", name);
        for (int a = 1; a <= z.ring.rings; a++)
            for (int b = dual; b <= z.ring.rings; b++)
                if (mesh_ring(z.scheme.mesh, a, b) <= z.ring.rings)
                    CHECK(is_close(value_at(&z, a, b), unit * (a + b * t - half), 1e-8), "%s: (%d,%d) is not where it should be", name, a, b);
        for (int which = RING_VALUES; which <= RING_SECOND && !test_failed(); which++) {
            const element *list = which == RING_VALUES ? z.ring.boundary : z.ring.elements;
            int count = which == RING_VALUES ? z.ring.boundary_count : z.ring.element_count;
            CHECK(charnet_windows_make(&w, &z.net, &z.ring, which, list, count, PRECISION) == BLOCK_OK, "%s: windows", name);
            for (int i = 0; i < count && !test_failed(); i++) {
                int points = w.window[list[i].type];
                thin_box(&x, &w, i, points, false);
                thin_box(&y, &w, i, points, true);
                if (which == RING_VALUES) {
                    for (int v = 0; v < 2; v++) {
                        lattice p = element_get_vertex(list[i].type, v);
                        cplx place = unit * (list[i].a + p.a + (list[i].b + p.b) * t);
                        CHECK(box_holds(&x, &y, make(creal(place), cimag(place) / scale)), "%s: segment %d does not contain its end %d", name, i, v);
                    }
                } else {
                    cplx d = unit * (which == RING_FIRST ? 1 : t);
                    CHECK(box_holds(&x, &y, make(creal(d), cimag(d) / scale)), "%s: difference %d of element %d", name, which, i);
                    CHECK(number_upper_bound(&x) - number_lower_bound(&x) < 1e-8 && number_upper_bound(&y) - number_lower_bound(&y) < 1e-8, "%s: difference %d of element %d is not constant", name, which, i);
                }
            }
            charnet_windows_free(&w);
        }
    }
    free_setting(&z);
    number_clear(&x), number_clear(&y);
}

static void test_regular_valence(void)
{
    static const char *const names[] = {"loop", "modified-loop", "modified-butterfly", "catmull-clark", "doo-sabin", "kobbelt",
                                        "midpoint 2", "midpoint 3", "midpoint 4", "midpoint 5", "midpoint 6", "midpoint 7"};
    test_begin("charnet-schemes-regular-valence");
    for (int i = 0; i < 12 && !test_failed(); i++) {
        check_regular(names[i], true);
        if (i < 10 && !test_failed())
            check_regular(names[i], false);
    }
    test_end();
}

/* ---- plain subdivision ---- */

/* A net of pairs on a square of labels of the plane, from low to low + side - 1 both ways; NAN: not known. */
typedef struct {
    int low, side;
    double *x, *y;
} plane;

static void plane_make(plane *z, int low, int high)
{
    z->low = low;
    z->side = high - low + 1;
    z->x = malloc((size_t)z->side * (size_t)z->side * sizeof(double));
    z->y = malloc((size_t)z->side * (size_t)z->side * sizeof(double));
    for (int i = 0; i < z->side * z->side; i++)
        z->x[i] = z->y[i] = NAN;
}

static void plane_free(plane *z)
{
    free(z->x);
    free(z->y);
}

static int plane_index(const plane *z, int a, int b)
{
    bool inside = a >= z->low && b >= z->low && a < z->low + z->side && b < z->low + z->side;
    return inside ? (a - z->low) * z->side + b - z->low : -1;
}

static void plane_from_net(plane *z, const setting *s)
{
    int rings = s->ring.rings;
    number x, y;
    number_init(&x), number_init(&y);
    plane_make(z, -rings, rings);
    for (int a = -rings; a <= rings; a++)
        for (int b = -rings; b <= rings; b++)
            if (sector_value(&x, &y, &s->net, a, b, PRECISION) == SECTOR_OK) {
                z->x[plane_index(z, a, b)] = number_mid_approx(&x);
                z->y[plane_index(z, a, b)] = number_mid_approx(&y);
            }
    number_clear(&x), number_clear(&y);
}

/* The mask's weights in doubles. */
typedef struct {
    int count, a[400], b[400];
    double w[400];
} weights;

static void weights_of(weights *z, const laurent *mask)
{
    rational q;
    rational_init(&q);
    z->count = 0;
    for (long a = mask->a0; a < mask->a0 + mask->na; a++)
        for (long b = mask->b0; b < mask->b0 + mask->nb; b++)
            if (!laurent_is_zero_at(mask, a, b)) {
                MUST(laurent_get(&q, mask, a, b));
                z->a[z->count] = (int)a, z->b[z->count] = (int)b;
                z->w[z->count++] = rational_get_double_approx(&q);
            }
    rational_clear(&q);
}

static void plane_subdivide(plane *z, const weights *m, int low, int high)
{
    plane next;
    plane_make(&next, low, high);
    for (int a = low; a <= high; a++)
        for (int b = low; b <= high; b++) {
            double x = 0, y = 0;
            for (int i = 0; i < m->count; i++) {
                int at;
                if ((a - m->a[i]) % 2 || (b - m->b[i]) % 2)
                    continue;
                at = plane_index(z, (a - m->a[i]) / 2, (b - m->b[i]) / 2);
                x += at < 0 ? NAN : m->w[i] * z->x[at];
                y += at < 0 ? NAN : m->w[i] * z->y[at];
            }
            next.x[plane_index(&next, a, b)] = x;
            next.y[plane_index(&next, a, b)] = y;
        }
    plane_free(z);
    *z = next;
}

typedef struct {
    const setting *s;
    const plane *fine;
    int which, levels;
    double low[2], high[2]; /* the box of the element */
    double closest;
} descent;

/* All values of the last level that the windows below this element name lie in the box. */
static void descend(descent *d, element_type type, int a, int b, int level)
{
    const element_window *w = &d->s->ring.stencil[d->which].window[type];
    double scale = d->which == RING_VALUES ? 1 : ldexp(1, d->levels);
    if (level < d->levels) {
        for (int c = 0; c < element_children(type); c++) {
            element_child child = element_get_child(type, c);
            descend(d, child.type, 2 * a + child.shift.a, 2 * b + child.shift.b, level + 1);
        }
        return;
    }
    for (int i = 0; i < w->count && !test_failed(); i++) {
        int p = a + w->point[i].a, q = b + w->point[i].b, at = plane_index(d->fine, p, q);
        double v[2];
        CHECK(at >= 0, "(%d,%d) is off the plane", p, q);
        if (test_failed())
            return;
        v[0] = d->fine->x[at], v[1] = d->fine->y[at];
        if (d->which != RING_VALUES) {
            at = plane_index(d->fine, p + (d->which == RING_FIRST), q + (d->which == RING_SECOND));
            v[0] = scale * (d->fine->x[at] - v[0]), v[1] = scale * (d->fine->y[at] - v[1]);
        }
        for (int c = 0; c < 2; c++) {
            double inside = fmin(v[c] - d->low[c], d->high[c] - v[c]);
            CHECK(inside > -1e-8, "%s, k = %ld, net %d: the value at (%d,%d) of level %d is %.3g outside", d->s->name, d->s->k, d->which, p, q, d->levels, -inside);
            d->closest = fmin(d->closest, inside / (d->high[c] - d->low[c] + 1e-9));
        }
    }
}

static void check_boxes(const setting *z, int levels)
{
    plane fine;
    weights m;
    number x, y;
    int omega = z->ring.rings - 2 * z->ring.radius;
    double closest = INFINITY;
    number_init(&x), number_init(&y);
    weights_of(&m, &z->scheme.mask);
    plane_from_net(&fine, z);
    for (int level = 1; level <= levels; level++)
        plane_subdivide(&fine, &m, -omega - 1, (2 * z->ring.radius << level) + omega + 1);
    for (int which = RING_VALUES; which <= RING_SECOND && !test_failed(); which++) {
        charnet_windows w;
        const element *list = which == RING_VALUES ? z->ring.boundary : z->ring.elements;
        int count = which == RING_VALUES ? z->ring.boundary_count : z->ring.element_count;
        CHECK(charnet_windows_make(&w, &z->net, &z->ring, which, list, count, PRECISION) == BLOCK_OK, "%s: windows", z->name);
        for (int i = 0; i < count && !test_failed(); i++) {
            descent d = {z, &fine, which, levels, {0, 0}, {0, 0}, INFINITY};
            thin_box(&x, &w, i, w.window[list[i].type], false);
            thin_box(&y, &w, i, w.window[list[i].type], true);
            d.low[0] = number_lower_bound(&x), d.high[0] = number_upper_bound(&x);
            d.low[1] = number_lower_bound(&y), d.high[1] = number_upper_bound(&y);
            descend(&d, list[i].type, list[i].a, list[i].b, 0);
            closest = fmin(closest, d.closest);
        }
        charnet_windows_free(&w);
    }
    CHECK(closest < 0.3, "%s: the boxes are much larger than they need be (%.3g)", z->name, closest);
    plane_free(&fine);
    number_clear(&x), number_clear(&y);
}

static void test_windows(void)
{
    static const struct {
        const char *name;
        bool real;
        int levels;
    } list[] = {{"loop", true, 5}, {"modified-loop", true, 5}, {"loop-spiral", false, 5}, {"catmull-clark", true, 5}, {"catmull-clark", false, 4}, {"doo-sabin", true, 5},
                {"doo-sabin", false, 4}, {"midpoint 2", true, 5}, {"midpoint 4", true, 4}, {"midpoint 5", true, 4}, {"midpoint 6", true, 3}, {"midpoint 7", true, 3}};
    static const long valences[] = {3, 5, 8};
    test_begin("charnet-schemes-windows");
    for (int i = 0; i < 12 && !test_failed(); i++)
        for (int j = 0; j < (i < 8 ? 3 : 2) && !test_failed(); j++) {
            setting z;
            if (make_setting(&z, list[i].name, valences[j], list[i].real)) {
                CHECK(z.ring.nonnegative, "the test itself");
                check_boxes(&z, list[i].levels);
            }
            free_setting(&z);
        }
    test_end();
}

static void tests(void)
{
    test_eigenvectors();
    test_forms();
    test_regular_valence();
    test_windows();
}
MAIN(tests);
