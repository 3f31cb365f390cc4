/* t-charnet_affine.c: characteristic nets of many valences contain those of single ones, and their windows split into thin
   parts and radii component by component.  The whole test computes with affine numbers; at a single valence their slopes are 0. */
#define NUMBER_AFFINE

#include "lib/block_affine.h"
#include "lib/charnet.h"
#include "lib/eigenpair_affine.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 128, GRID = 64 };

#define base(operation) NUMBER_OP(operation)

typedef struct {
    scheme scheme;
    regular_masks regular;
    ring ring;
    scheme_numbers numbers;
    block block;
    eigenpair_choice choice;
    number *box;
    sector_net net;
} setting;

static bool make_setting(setting *z, const char *name, valence_range k)
{
    diagnostic d = {0, 0, ""};
    arc r;
    memset(z, 0, sizeof *z);
    read_scheme(&z->scheme, catalogue_text(name));
    regular_init(&z->regular);
    ring_init(&z->ring);
    arc_init(&r);
    MUST(arc_set_valences(&r, k) && regular_derive(&z->regular, &z->scheme.mask, z->scheme.mesh) && ring_make(&z->ring, &z->scheme, &z->regular));
    CHECK(scheme_numbers_make_range(&z->numbers, &z->scheme, k, PRECISION, &d) == STATUS_OK, "%s: %s", name, d.text);
    CHECK((is_one_valence(k) ? block_make(&z->block, &z->numbers, 1, true, &d) : block_make_over(&z->block, &z->numbers, one_frequency(1), &r, &d)) == BLOCK_OK, "%s: %s", name, d.text);
    z->box = number_array_new((size_t)z->block.n + 1);
    eigenpair_choice_init(&z->choice);
    CHECK(BASE_NAME(eigenpair_affine_choose)(&z->choice, z->block.entry, z->block.n, GRID, PRECISION) == TRUTH_TRUE
              && BASE_NAME(eigenpair_affine_prove)(z->box, &z->choice, z->block.entry, z->block.n, PRECISION) == TRUTH_TRUE,
          "%s, %ld to %ld: no pair", name, k.first, k.last);
    CHECK(charnet_make(&z->net, &z->block, z->box, false, &z->numbers, z->ring.rings) == BLOCK_OK, "%s, %ld to %ld: no net", name, k.first, k.last);
    arc_clear(&r);
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

/* t with C + D t = u of the single valence. */
static void find_t(base_number *t, const setting *many, const setting *one)
{
    base(sub)(t, &one->block.twist.u.centre, &many->block.twist.u.centre, PRECISION);
    base(div)(t, t, &many->block.twist.u.slope, PRECISION);
}

/* Is x, of one valence, scaled, in C + D t? */
static bool is_enclosed(const number *many, const number *one, const number *scale, const base_number *t)
{
    base_number x, y;
    bool ok;
    base(init)(&x);
    base(init)(&y);
    base(mul)(&x, t, &many->slope, PRECISION);
    base(add)(&x, &x, &many->centre, PRECISION);
    base(div)(&y, &one->centre, &scale->centre, PRECISION);
    ok = base(less)(&x, &y) != TRUTH_TRUE && base(less)(&y, &x) != TRUTH_TRUE;
    base(clear)(&x);
    base(clear)(&y);
    return ok;
}

static void check_net(const setting *many, const setting *one, long k)
{
    const char *name = many->scheme.name;
    const number *scale = &one->box[many->choice.pivot];
    base_number t;
    base(init)(&t);
    find_t(&t, many, one);
    for (int a = 1; a <= many->net.rings; a++)
        for (int b = 0; b <= many->net.rings; b++) {
            int at = sector_index(&many->net, a, b), there = sector_index(&one->net, a, b);
            if (!mesh_in_sector(many->net.mesh, a, b) || mesh_ring(many->net.mesh, a, b) > many->ring.rings)
                continue;
            CHECK(is_enclosed(&many->net.x[at], &one->net.x[there], scale, &t) && is_enclosed(&many->net.y[at], &one->net.y[there], scale, &t), "%s, k = %ld: the value at (%d,%d)", name, k, a, b);
            CHECK(number_upper_bound(&many->net.x[at]) - number_lower_bound(&many->net.x[at]) < 2, "%s: the value at (%d,%d) is wide", name, a, b);
        }
    base(clear)(&t);
}

/* The difference is at most the radius, in each component. */
static bool is_within(const number *value, const number *thin, const number *radius)
{
    number wide;
    bool ok;
    number_init(&wide);
    number_add_error(&wide, thin, radius, PRECISION);
    ok = base(contains)(&wide.centre, &value->centre) && base(contains)(&wide.slope, &value->slope) && base(is_thin)(&thin->centre) && base(is_thin)(&thin->slope);
    number_clear(&wide);
    return ok;
}

static void check_windows(const setting *z)
{
    const element_stencil *stencil = &z->ring.stencil[RING_VALUES];
    charnet_windows w;
    number x, y;
    number_init(&x);
    number_init(&y);
    CHECK(charnet_windows_make(&w, &z->net, &z->ring, RING_VALUES, z->ring.boundary, z->ring.boundary_count, PRECISION) == BLOCK_OK, "%s: windows", z->scheme.name);
    for (int i = 0; i < w.count && !test_failed(); i++)
        for (int j = 0; j < w.window[z->ring.boundary[i].type]; j++) {
            lattice p = stencil->window[z->ring.boundary[i].type].point[j];
            CHECK(sector_value(&x, &y, &z->net, z->ring.boundary[i].a + p.a, z->ring.boundary[i].b + p.b, PRECISION) == SECTOR_OK, "%s: a point of a window", z->scheme.name);
            CHECK(is_within(&x, &w.x[i * w.stride + j], &w.radius[0]) && is_within(&y, &w.y[i * w.stride + j], &w.radius[1]), "%s, element %d, point %d", z->scheme.name, i, j);
        }
    CHECK(base(upper_bound)(&w.radius[0].centre) < 1e-6, "%s: the radius of the centres is %.3g", z->scheme.name, base(upper_bound)(&w.radius[0].centre));
    charnet_windows_free(&w);
    number_clear(&x);
    number_clear(&y);
}

static void check(const char *name, long first, long last)
{
    setting many, one;
    if (make_setting(&many, name, (valence_range){first, last})) {
        for (int i = 0; i < 4 && !test_failed(); i++) {
            long k = i == 0 ? first : last == VALENCES_UNBOUNDED ? first + random_range(1, 10000) : i == 1 ? last : random_range(first, last);
            if (make_setting(&one, name, one_valence(k)))
                check_net(&many, &one, k);
            free_setting(&one);
        }
        check_windows(&many);
    }
    free_setting(&many);
}

static void test_nets(void)
{
    test_begin("characteristic-nets-of-many-valences");
    check("loop", 30, VALENCES_UNBOUNDED);
    check("loop", 9, 10);
    check("catmull-clark", 30, VALENCES_UNBOUNDED);
    check("catmull-clark", 12, 13);
    check("modified-butterfly", 40, VALENCES_UNBOUNDED);
    check("midpoint", 20, 30);
    check("doo-sabin", 30, VALENCES_UNBOUNDED);
    check("kobbelt", 100, VALENCES_UNBOUNDED);
    test_end();
}

static void tests(void)
{
    test_nets();
}

MAIN(tests);
