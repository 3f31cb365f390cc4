/* t-ring.c: what lib/ring.md proves, tried on nets of random values: beyond ring F every new value is the composed
   mask's in the chart of its sector, and on the ring of elements, level after level, every used point's is in the chart
   of the ring's sector.  The nets are subdivided by the scheme's own steps and rules. */
#include "lib/ring.h"

#include <math.h>

#include "common.h"
#include "lib/influence.h"
#include "lib/subdivision.h"
#include "region.h"

#if defined(NUMBER_INTERVAL)
enum { PRECISION = 53 };
#else
enum { PRECISION = 96 };
#endif

enum { LEVELS = 2 };

typedef struct {
    scheme scheme;
    regular_masks regular;
    ring ring;
    scheme_numbers numbers;
    mask_numbers mask;
    twist twist;
    int farthest;
    sector_net net[LEVELS + 1]; /* random values, and what the scheme makes of them */
} setting;

static void fill(sector_net *net)
{
    for (int a = 1; a <= net->rings; a++)
        for (int b = net->mesh == MESH_DUAL; b <= net->rings; b++)
            if (mesh_ring(net->mesh, a, b) <= net->rings) {
                number_set_double(&net->x[sector_index(net, a, b)], random_unit(), PRECISION);
                number_set_double(&net->y[sector_index(net, a, b)], random_unit(), PRECISION);
            }
}

static void make_setting(setting *z, const char *text, const char *parameter, long k, long m)
{
    diagnostic d = {0, 0, ""};
    scheme_settings settings = {&parameter, parameter != NULL};
    int rings[LEVELS + 1];
    memset(z, 0, sizeof *z);
    scheme_init(&z->scheme);
    CHECK(scheme_read(&z->scheme, text, strlen(text), &settings, &d) == STATUS_OK, "%s", d.text);
    regular_init(&z->regular);
    ring_init(&z->ring);
    twist_init(&z->twist);
    MUST(regular_derive(&z->regular, &z->scheme.mask, z->scheme.mesh));
    MUST(ring_make(&z->ring, &z->scheme, &z->regular));
    MUST(influence_farthest(&z->farthest, &z->scheme));
    MUST(mask_numbers_make(&z->mask, &z->scheme.mask, PRECISION));
    MUST(twist_set_complex(&z->twist, m, k, PRECISION));
    CHECK(scheme_numbers_make(&z->numbers, &z->scheme, k, PRECISION, &d) == STATUS_OK, "%s", d.text);
    CHECK(scheme_numbers_set_frequency(&z->numbers, m, &z->twist, &d) == STATUS_OK, "%s", d.text);
    for (int level = LEVELS; level >= 0; level--) { /* level n of the ring lies within 2^n (2r) and its windows */
        int used = ((2 * z->ring.radius) << level) + z->ring.rings - 2 * z->ring.radius;
        rings[level] = used;
        if (level < LEVELS) {
            int needed = scheme_rings_needed(&z->scheme, rings[level + 1]);
            rings[level] = needed > used ? needed : used;
        }
    }
    MUST(sector_net_make(&z->net[0], z->scheme.mesh, k == mesh_regular_valence(z->scheme.mesh), rings[0], &z->twist));
    fill(&z->net[0]);
    for (int level = 1; level <= LEVELS; level++)
        CHECK(scheme_subdivide(&z->net[level], &z->net[level - 1], &z->numbers, rings[level]) == SUBDIVIDE_OK, "k = %ld: level %d", k, level);
}

static void free_setting(setting *z)
{
    for (int level = 0; level <= LEVELS; level++)
        sector_net_free(&z->net[level]);
    scheme_numbers_free(&z->numbers);
    mask_numbers_free(&z->mask);
    twist_clear(&z->twist);
    ring_clear(&z->ring);
    regular_clear(&z->regular);
    scheme_clear(&z->scheme);
}

/* Is the value at (a,b) of level n the mask's sum in the chart of the net's own sector? */
static bool follows_mask(const setting *z, int level, int a, int b)
{
    number x, y, p, q;
    bool same;
    number_init(&x), number_init(&y), number_init(&p), number_init(&q);
    same = sector_value(&x, &y, &z->net[level], a, b, PRECISION) == SECTOR_OK
           && sector_masked_value(&p, &q, &z->net[level - 1], &z->mask, 2, a, b, PRECISION) == SECTOR_OK;
    number_sub(&x, &x, &p, PRECISION);
    number_sub(&y, &y, &q, PRECISION);
    same = same && fabs(number_mid_approx(&x)) < 1e-9 && fabs(number_mid_approx(&y)) < 1e-9;
    CHECK(!same || (number_contains_zero(&x) && number_contains_zero(&y)), "level %d, (%d,%d): enclosures of the same number are apart", level, a, b);
    number_clear(&x), number_clear(&y), number_clear(&p), number_clear(&q);
    return same;
}

/* How many points of a ring of the sector do not follow the mask. */
static int irregular_points(const setting *z, int j)
{
    int count = 0;
    for (int a = 1; a <= j; a++)
        for (int b = z->scheme.mesh == MESH_DUAL; b <= j; b++)
            count += mesh_ring(z->scheme.mesh, a, b) == j && !follows_mask(z, 1, a, b);
    return count;
}

static void check_point(const setting *z, int level, int a, int b)
{
    CHECK(follows_mask(z, level, a, b), "%s, k = %ld, level %d: the used point (%d,%d) does not follow the mask", z->scheme.name, z->numbers.k.first, level, a, b);
}

static void check_element(const setting *z, element_type type, int a, int b, int level)
{
    bool segment = element_is_segment(type);
    for (int net = segment ? RING_VALUES : RING_FIRST; level > 0 && net <= (segment ? RING_VALUES : RING_SECOND); net++)
        for (int i = 0; i < z->ring.stencil[net].window[type].count; i++) {
            lattice p = z->ring.stencil[net].window[type].point[i];
            check_point(z, level, a + p.a, b + p.b);
            if (!segment)
                check_point(z, level, a + p.a + (net == RING_FIRST), b + p.b + (net == RING_SECOND));
        }
    for (int c = 0; level < LEVELS && c < element_children(type) && !test_failed(); c++) {
        element_child child = element_get_child(type, c);
        check_element(z, child.type, 2 * a + child.shift.a, 2 * b + child.shift.b, level + 1);
    }
}

/* sharp: some point on ring F does not follow the mask, at this valence. */
static void check(const char *text, const char *parameter, long k, bool sharp)
{
    static setting z;
    make_setting(&z, text, parameter, k, random_range(1, (k - 1) / 2));
    for (int j = z.farthest + 1; j <= z.net[1].rings && !test_failed(); j++)
        CHECK(irregular_points(&z, j) == 0, "%s, k = %ld: %d points of ring %d, beyond F = %d", z.scheme.name, k, irregular_points(&z, j), j, z.farthest);
    CHECK(test_failed() || !sharp || z.farthest == 0 || irregular_points(&z, z.farthest) > 0, "%s, k = %ld: all is regular on ring F = %d", z.scheme.name, k, z.farthest);
    for (int i = 0; i < z.ring.element_count && !test_failed(); i++)
        check_element(&z, z.ring.elements[i].type, z.ring.elements[i].a, z.ring.elements[i].b, 0);
    for (int i = 0; i < z.ring.boundary_count && !test_failed(); i++)
        check_element(&z, z.ring.boundary[i].type, z.ring.boundary[i].a, z.ring.boundary[i].b, 0);
    free_setting(&z);
}

/* A rule in the third ring that takes what it likes. */
#define LOOP_MASK "mask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
#define FAR_TEXT \
    "scheme far\nmesh triangle\ndilation 2\nvertices interior\n" LOOP_MASK "rule centre\ncentre 3/8 + (3/8 + cos(2*pi/k)/4)^2\nall (1,0) rest\nend\n" \
    "rule (2,1)\n(1,0) 1/2\n(1,1) rest\nend\n"

static void test_schemes(void)
{
    static const long valences[] = {3, 5, 7, 12};
    test_begin("ring-is-regular-triangles");
    for (int i = 0; i < 4 && !test_failed(); i++) {
        check(catalogue_text("loop"), NULL, valences[i], true);
        check(catalogue_text("butterfly"), NULL, valences[i] == 3 ? 4 : valences[i], true);
        check(catalogue_text("modified-loop"), NULL, valences[i], valences[i] > 3);
        check(catalogue_text("modified-butterfly"), NULL, valences[i], true);
        check(catalogue_text("loop-spiral"), NULL, valences[i], true);
        check(FAR_TEXT, NULL, valences[i], true);
    }
    test_end();
    test_begin("ring-is-regular-quads");
    for (int i = 0; i < 4 && !test_failed(); i++) {
        check(catalogue_text("catmull-clark"), NULL, valences[i], false);
        check(catalogue_text("midpoint"), "degree=5", valences[i], true);
        check(catalogue_text("midpoint"), "degree=7", valences[i], true);
        check(catalogue_text("kobbelt"), NULL, valences[i], true);
    }
    test_end();
    test_begin("ring-is-regular-dual-quads");
    for (int i = 0; i < 4 && !test_failed(); i++) {
        check(catalogue_text("doo-sabin"), NULL, valences[i], true);
        check(catalogue_text("midpoint"), "degree=2", valences[i], true);
        check(catalogue_text("midpoint"), "degree=4", valences[i], true);
        check(catalogue_text("midpoint"), "degree=6", valences[i], true);
    }
    test_end();
}

static void tests(void)
{
    test_schemes();
}
MAIN(tests);
