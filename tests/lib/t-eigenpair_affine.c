/* t-eigenpair_affine.c: eigenpairs of many valences against those of single ones. */
#include "lib/block_affine.h"
#include "lib/eigenpair.h"
#include "lib/eigenpair_affine.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { GRID = 64, PRECISION = 128, FINE = 256 };

static bool meets(const number *x, const number *y)
{
    return number_less(x, y) != TRUTH_TRUE && number_less(y, x) != TRUTH_TRUE;
}

/* The pair of one matrix. */
typedef struct {
    scheme s;
    affine_matrix matrix;
    eigenpair_choice choice;
    affine *box;
    arc r;
    truth found;
} pair;

static void make_pair(pair *z, const char *name, valence_range k, frequencies m, int64_t low, int64_t high)
{
    diagnostic d = {0, 0, ""};
    read_scheme(&z->s, catalogue_text(name));
    eigenpair_choice_init(&z->choice);
    arc_init(&z->r);
    MUST(arc_set_units(&z->r, low, high));
    CHECK(affine_matrix_make(&z->matrix, &z->s, k, m, &z->r, PRECISION, &d) == BLOCK_OK, "%s: %s", name, d.text);
    z->box = affine_array_new((size_t)z->matrix.n + 1);
    z->found = eigenpair_affine_choose(&z->choice, z->matrix.entry, z->matrix.n, GRID, PRECISION);
    if (z->found == TRUTH_TRUE) {
        CHECK(integer_cmp(&z->choice.radius, &z->choice.range) <= 0, "%s: the radius is larger than the range", name);
        z->found = eigenpair_affine_prove(z->box, &z->choice, z->matrix.entry, z->matrix.n, PRECISION);
        CHECK(z->found == TRUTH_TRUE, "%s: what was chosen is no proof", name);
    }
}

static void free_pair(pair *z)
{
    affine_array_free(z->box, (size_t)z->matrix.n + 1);
    affine_matrix_free(&z->matrix);
    eigenpair_choice_clear(&z->choice);
    arc_clear(&z->r);
    scheme_clear(&z->s);
}

/* t with C + D t = cos(pi m / k), C and D as affine_cosine has them. */
static void find_t(number *t, const arc *r, long m, long k)
{
    number hull, other;
    rational q;
    number_init(&hull), number_init(&other);
    rational_init(&q);
    number_cos_pi(&hull, &r->high, PRECISION);
    number_cos_pi(&other, &r->low, PRECISION);
    number_hull(&hull, &hull, &other, PRECISION);
    MUST(rational_set_si(&q, m, k));
    number_cos_pi(t, &q, FINE);
    number_midpoint(&other, &hull, PRECISION);
    number_sub(t, t, &other, FINE);
    number_radius_upper(&other, &hull, PRECISION);
    number_div(t, t, &other, FINE);
    number_clear(&hull), number_clear(&other);
    rational_clear(&q);
}

/* The pair of block m of valence k, scaled to the pivot. */
static number *single_pair(const pair *z, long m, long k)
{
    scheme_numbers numbers;
    block b;
    diagnostic d;
    eigenpair_choice c;
    int n = z->matrix.n;
    number scale;
    number *box = number_array_new((size_t)n + 1);
    number_init(&scale);
    eigenpair_choice_init(&c);
    CHECK(scheme_numbers_make(&numbers, &z->s, k, FINE, &d) == STATUS_OK && block_make(&b, &numbers, m, true, &d) == BLOCK_OK, "%s: block %ld of %ld", z->s.name, m, k);
    CHECK(eigenpair_choose(&c, b.entry, n, false, FINE, FINE) == TRUTH_TRUE && eigenpair_prove(box, &c, b.entry, FINE) == TRUTH_TRUE, "%s: pair %ld of %ld", z->s.name, m, k);
    number_set(&scale, &box[z->choice.pivot]);
    for (int j = 0; j < n; j++)
        number_div(&box[j], &box[j], &scale, FINE);
    eigenpair_choice_clear(&c);
    block_free(&b);
    scheme_numbers_free(&numbers);
    number_clear(&scale);
    return box;
}

static void check_single(const pair *z, long m, long k)
{
    number *box = single_pair(z, m, k);
    number t, x;
    number_init(&t), number_init(&x);
    find_t(&t, &z->r, m, k);
    for (int j = 0; j <= z->matrix.n; j++) {
        number_mul(&x, &t, &z->box[j].slope, FINE);
        number_add(&x, &x, &z->box[j].centre, FINE);
        CHECK(meets(&x, &box[j]), "%s: component %d of block %ld of %ld", z->s.name, j, m, k);
    }
    number_array_free(box, (size_t)z->matrix.n + 1);
    number_clear(&t), number_clear(&x);
}

static double width(const number *x)
{
    return number_upper_bound(x) - number_lower_bound(x);
}

/* Frequency m at valences first..last. */
static void check_frequency(const char *name, long m, long first, long last)
{
    const valence_range k = {first, last};
    pair z;
    make_pair(&z, name, k, one_frequency(m), arc_units_below(m, last), arc_units_above(m, first));
    CHECK(z.found == TRUTH_TRUE, "%s, %ld to %ld: no pair", name, first, last);
    for (int i = 0; i < 5 && z.found == TRUTH_TRUE && !test_failed(); i++)
        check_single(&z, m, i == 0 ? first : last == VALENCES_UNBOUNDED ? first + random_range(0, 100000) : i == 1 ? last : random_range(first, last));
    for (int j = 0; z.found == TRUTH_TRUE && j <= z.matrix.n; j++) {
        double most = fmax(fabs(number_upper_bound(&z.box[j].slope)), fabs(number_lower_bound(&z.box[j].slope)));
        CHECK(width(&z.box[j].centre) < 1e-7, "%s, %ld to %ld: component %d is %.3g wide", name, first, last, j, width(&z.box[j].centre));
        CHECK(width(&z.box[j].slope) < 0.5 * most + 1e-12 || most < 0.02, "%s, %ld to %ld: slope %d is %.3g wide, at most %.3g", name, first, last, j, width(&z.box[j].slope), most);
    }
    free_pair(&z);
}

static void check_range(const char *name, long first, long last)
{
    check_frequency(name, 1, first, last);
}

static void test_ranges(void)
{
    test_begin("eigenpairs-of-many-valences");
    check_range("loop", 20, VALENCES_UNBOUNDED);
    check_range("loop", 7, 8);
    check_range("loop", 1000000, 1000000000);
    check_range("catmull-clark", 20, VALENCES_UNBOUNDED);
    check_range("catmull-clark", 9, 10);
    check_frequency("butterfly", 10, 50, 51);
    check_frequency("butterfly", 30, 190, 191);
    check_range("kobbelt", 22, 24);
    check_range("kobbelt", 49, VALENCES_UNBOUNDED);
    check_range("modified-butterfly", 20, VALENCES_UNBOUNDED);
    check_range("midpoint", 12, 14);
    check_range("wave", 30, VALENCES_UNBOUNDED);
    test_end();
}

/* L of Loop's scheme is 1/8 + u^2/2 for u > 1/2: its slope by u is u. */
static void test_loop(void)
{
    pair z;
    test_begin("eigenpairs-of-many-valences-loop");
    for (int i = 0; i < 6; i++) {
        int64_t low = i * (1LL << 44), high = low + (1LL << 40);
        make_pair(&z, "loop", (valence_range){3, VALENCES_UNBOUNDED}, (frequencies){1, FREQUENCIES_UNBOUNDED}, low, high);
        CHECK(z.found == TRUTH_TRUE, "no pair from %d/16 on", i);
        if (z.found == TRUTH_TRUE) {
            double above = cos(3.14159265358979 * i / 16), below = cos(3.14159265358979 * (i / 16.0 + 1 / 256.0)), rise = (above - below) / 2;
            const affine *l = &z.box[z.matrix.n];
            CHECK(number_lower_bound(&l->slope) > 0, "the slope from %d/16 on", i);
            CHECK(number_lower_bound(&l->slope) <= rise * below * (1 + 1e-9) && number_upper_bound(&l->slope) >= rise * above * (1 - 1e-9), "the slope from %d/16 on is %.9g to %.9g, not %.9g to %.9g", i,
                  number_lower_bound(&l->slope), number_upper_bound(&l->slope), rise * below, rise * above);
            CHECK(number_upper_bound(&l->slope) < 1.5 * rise * above, "the slope from %d/16 on is %.3g instead of %.3g", i, number_upper_bound(&l->slope), rise * above);
        }
        free_pair(&z);
    }
    test_end();
}

/* A poor preconditioner, half of the inverse, proves less precisely, and still the truth. */
static void test_poor(void)
{
    pair z;
    test_begin("eigenpairs-of-many-valences-with-a-poor-preconditioner");
    make_pair(&z, "loop", (valence_range){20, 22}, one_frequency(1), arc_units_below(1, 22), arc_units_above(1, 20));
    for (int i = 0; i < z.matrix.n * z.matrix.n; i++)
        MUST(integer_fdiv_2exp(&z.choice.inverse[i], &z.choice.inverse[i], 1));
    MUST(integer_mul_2exp(&z.choice.range, &z.choice.range, 1) && integer_mul_2exp(&z.choice.radius, &z.choice.radius, 1));
    z.found = eigenpair_affine_prove(z.box, &z.choice, z.matrix.entry, z.matrix.n, PRECISION);
    CHECK(z.found == TRUTH_TRUE, "no pair");
    for (long k = 20; k <= 22 && z.found == TRUTH_TRUE; k++)
        check_single(&z, 1, k);
    free_pair(&z);
    test_end();
}

/* Choices that somebody else made. */
static void test_lies(void)
{
    pair z;
    affine *box;
    int n;
    integer saved;
    test_begin("eigenpairs-of-many-valences-with-a-lie");
    make_pair(&z, "catmull-clark", (valence_range){10, 12}, one_frequency(1), arc_units_below(1, 12), arc_units_above(1, 10));
    n = z.matrix.n;
    box = affine_array_new((size_t)n + 1);
    integer_init(&saved);
#define PROVES (eigenpair_affine_prove(box, &z.choice, z.matrix.entry, n, PRECISION) == TRUTH_TRUE)
    CHECK(PROVES, "no pair");
    MUST(integer_set(&saved, &z.choice.range));
    integer_set_si(&z.choice.range, 0);
    CHECK(!PROVES, "no range");
    MUST(integer_set(&z.choice.range, &z.choice.radius));
    CHECK(!PROVES, "a range as small as the radius");
    MUST(integer_mul_2exp(&z.choice.range, &saved, 12));
    CHECK(!PROVES, "a large range");
    MUST(integer_set(&z.choice.range, &saved));
    CHECK(PROVES, "mended");
    MUST(integer_mul_2exp(&z.choice.radius, &saved, 1));
    CHECK(!PROVES, "a radius beyond the range");
    integer_set_si(&z.choice.radius, 0);
    CHECK(!PROVES, "no radius");
    integer_clear(&saved);
    affine_array_free(box, (size_t)n + 1);
    free_pair(&z);
    /* u wider than the eigenvector can be followed */
    make_pair(&z, "catmull-clark", (valence_range){3, VALENCES_UNBOUNDED}, one_frequency(1), 0, arc_units_above(1, 3));
    CHECK(z.found != TRUTH_TRUE, "from 3 to infinity at once");
    free_pair(&z);
    test_end();
}

/* The other eigenvalues are left: the trace of the rest is that of the block without L. */
static void test_deflation(void)
{
    pair z;
    test_begin("eigenpairs-of-many-valences-deflated");
    make_pair(&z, "kobbelt", (valence_range){50, VALENCES_UNBOUNDED}, one_frequency(1), 0, arc_units_above(1, 50));
    if (z.found == TRUTH_TRUE) {
        int n = z.matrix.n;
        size_t size = (size_t)(n - 1) * (size_t)(n - 1);
        number *rest = number_array_new(size);
        number trace, part;
        number_init(&trace), number_init(&part);
        affine_deflate(rest, z.matrix.entry, z.box, n, z.choice.pivot, PRECISION);
        for (int i = 0; i < n - 1; i++)
            number_add(&trace, &trace, &rest[i * n], PRECISION);
        affine_range(&part, &z.box[n], PRECISION);
        number_add(&trace, &trace, &part, PRECISION);
        for (int i = 0; i < n; i++) {
            affine_range(&part, &z.matrix.entry[i * n + i], PRECISION);
            number_sub(&trace, &trace, &part, PRECISION);
        }
        CHECK(number_contains_zero(&trace) && width(&trace) < 0.2, "the trace differs by %.3g to %.3g", number_lower_bound(&trace), number_upper_bound(&trace));
        number_clear(&trace), number_clear(&part);
        number_array_free(rest, size);
    } else
        CHECK(false, "no pair");
    free_pair(&z);
    test_end();
}

static void tests(void)
{
    test_ranges();
    test_loop();
    test_poor();
    test_lies();
    test_deflation();
}

MAIN(tests);
