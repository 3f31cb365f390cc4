/* t-cover.c: bounds for the blocks of whole ranges of frequencies, against one block after the other. */
#include "lib/cover.h"
#include "lib/eigen_approx.h"
#include "lib/stop.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 128 };

static double radius_of_block(scheme_numbers *numbers, long m)
{
    block b;
    diagnostic d;
    double radius = NAN;
    CHECK(block_make(&b, numbers, m, numbers->scheme->mirror_symmetric, &d) == BLOCK_OK, "block %ld", m);
    int size;
    number *matrix = block_real_matrix(&size, &b);
    double *a = malloc((size_t)(size * size) * sizeof *a);
    for (int i = 0; i < size * size; i++)
        a[i] = number_mid_approx(&matrix[i]);
    radius = spectral_radius_approx(a, size);
    number_array_free(matrix, (size_t)(size * size));
    free(a);
    block_free(&b);
    return radius;
}

static void set_scale(number *scale, double bound)
{
    number_set_double(scale, bound, PRECISION);
    number_inv(scale, scale, PRECISION);
    number_upper(scale, scale, PRECISION);
}

static const cover_limits patient = {.tries = 100000, .power = 10000};

/* Numbers of one catalogue scheme at valence k. */
static void open_numbers(scheme *s, scheme_numbers *numbers, const char *name, long k)
{
    diagnostic d = {0, 0, ""};
    read_scheme(s, catalogue_text(name));
    CHECK(scheme_numbers_make(numbers, s, k, PRECISION, &d) == STATUS_OK, "%s: %s", name, d.text);
}

/* A little above the largest of the spectral radii the cover succeeds, a little below it does not, and says where. */
static void check_bound(const char *name, long k, long first)
{
    scheme s;
    scheme_numbers numbers;
    cover_list list;
    cover_answer found;
    diagnostic d;
    number scale;
    frequencies m = {first, k / 2};
    double largest = 0;
    long where = 0;
    number_init(&scale);
    open_numbers(&s, &numbers, name, k);
    for (long i = m.first; i <= m.last; i++) {
        double radius = radius_of_block(&numbers, i);
        if (radius > largest)
            largest = radius, where = i;
    }
    set_scale(&scale, largest * (1 + 1e-4));
    cover_list_init(&list);
    found = cover_search(&list, &numbers, &scale, m, &patient, &d);
    CHECK(found.status == BLOCK_OK && found.proved && cover_list_partitions(&list, m), "%s, k = %ld: nothing found, open %ld to %ld", name, k, found.open.first, found.open.last);
    CHECK(cover_verify(&list, &numbers, &scale, m, &d).proved, "%s, k = %ld: what was found is no proof", name, k);
    set_scale(&scale, largest * (1 - 1e-4));
    found = cover_verify(&list, &numbers, &scale, m, &d);
    CHECK(!found.proved && found.open.first <= where && where <= found.open.last, "%s, k = %ld: verified too small a number", name, k);
    cover_list_clear(&list);
    found = cover_search(&list, &numbers, &scale, m, &(cover_limits){.tries = 1000, .open = 50, .power = 10000}, &d);
    CHECK(!found.proved && found.open.first <= where && where <= found.open.last, "%s, k = %ld: proved too small a number", name, k);
    CHECK(cover_list_partitions(&list, m), "%s, k = %ld: something is in no box", name, k);
    for (size_t i = 0; i < list.count; i++)
        if (list.box[i].m.first <= where && where <= list.box[i].m.last)
            CHECK(list.box[i].power == COVER_OPEN, "%s, k = %ld: the box with %ld is not open", name, k, where);
    cover_list_clear(&list);
    number_clear(&scale);
    scheme_numbers_free(&numbers);
    scheme_clear(&s);
}

static void test_bounds(void)
{
    test_begin("cover-bounds");
    check_bound("loop", 50, 2);
    check_bound("butterfly", 31, 2);
    check_bound("butterfly", 30, 8);
    check_bound("modified-butterfly", 20, 2);
    check_bound("modified-loop", 21, 2);
    check_bound("catmull-clark", 40, 2);
    check_bound("doo-sabin", 16, 2);
    check_bound("loop-spiral", 24, 2);
    check_bound("loop-spiral", 9, 1);
    check_bound("wave", 17, 2);
    test_end();
}

/* Near w = 0 boxes grow geometrically: their number is like log k. */
static void check_count(const char *name, long k, double limit, long most)
{
    scheme s;
    scheme_numbers numbers;
    cover_list list;
    cover_answer found;
    diagnostic d;
    number scale;
    frequencies m = {2, k / 2};
    number_init(&scale);
    open_numbers(&s, &numbers, name, k);
    /* (L(w_1) + L(w_2)) / 2 by L = limit - curvature w^2 */
    double curvature = (limit - radius_of_block(&numbers, k / 1000)) / (k / 1000) / (k / 1000);
    set_scale(&scale, limit - 2.5 * curvature);
    cover_list_init(&list);
    found = cover_search(&list, &numbers, &scale, m, &patient, &d);
    CHECK(found.proved && found.tries <= most, "%s, k = %ld: proved %d, %zu boxes, %ld tries", name, k, found.proved, list.count, found.tries);
    CHECK(cover_verify(&list, &numbers, &scale, m, &d).proved, "%s, k = %ld: no proof", name, k);
    cover_list_clear(&list);
    number_clear(&scale);
    scheme_numbers_free(&numbers);
    scheme_clear(&s);
}

static void test_counts(void)
{
    test_begin("cover-few-boxes");
    check_count("loop", 10000, 0.625, 12);
    check_count("loop", 3000000, 0.625, 15);
    check_count("catmull-clark", 10000, 0.65450849718747371, 40);
    check_count("catmull-clark", 1000000, 0.65450849718747371, 65);
    test_end();
}

/* The time for a few blocks, then no time is left. */
static bool after_a_while(const void *data)
{
    return ++*(long *)data > 500;
}

static void test_stop(void)
{
    scheme s;
    scheme_numbers numbers;
    cover_list list;
    cover_limits limits = patient;
    cover_answer found;
    diagnostic d;
    number scale;
    long asked = 0;
    frequencies m = {2, 500};
    test_begin("cover-stops");
    number_init(&scale);
    open_numbers(&s, &numbers, "catmull-clark", 1000);
    set_scale(&scale, 0.654505);
    cover_list_init(&list);
    stop_watch((stop_sign){after_a_while, &asked});
    found = cover_search(&list, &numbers, &scale, m, &limits, &d);
    CHECK(found.stopped && !found.proved && found.status == BLOCK_OK && found.tries > 1 && found.tries < 9, "the search: %ld tries", found.tries);
    list.count = 0;
    stop_watch((stop_sign){NULL, NULL});
    CHECK(cover_search(&list, &numbers, &scale, m, &patient, &d).proved && list.count > 9, "without a limit");
    asked = 0;
    stop_watch((stop_sign){after_a_while, &asked});
    found = cover_verify(&list, &numbers, &scale, m, &d);
    stop_watch((stop_sign){NULL, NULL});
    CHECK(found.stopped && !found.proved && found.tries > 1 && found.tries < 9, "the proof: %ld tries", found.tries);
    cover_list_clear(&list);
    number_clear(&scale);
    scheme_numbers_free(&numbers);
    scheme_clear(&s);
    test_end();
}

static void test_lists(void)
{
    scheme s;
    scheme_numbers numbers;
    cover_list list;
    diagnostic d;
    number scale;
    frequencies m = {2, 500};
    test_begin("cover-lists-with-a-lie");
    number_init(&scale);
    open_numbers(&s, &numbers, "catmull-clark", 1000);
    set_scale(&scale, 0.654505);
    cover_list_init(&list);
    CHECK(cover_search(&list, &numbers, &scale, m, &patient, &d).proved && list.count > 3, "search");
    CHECK(cover_verify(&list, &numbers, &scale, m, &d).proved, "verify");
    CHECK(!cover_verify(&list, &numbers, &scale, (frequencies){1, 500}, &d).proved, "a frequency missing in front");
    CHECK(!cover_verify(&list, &numbers, &scale, (frequencies){2, 501}, &d).proved, "a frequency missing behind");
    CHECK(!cover_verify(&list, &numbers, &scale, (frequencies){2, 499}, &d).proved, "a frequency too many");
    list.box[1].power--;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "a power too low");
    list.box[1].power = COVER_OPEN;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "an open box");
    list.box[1].power = 40;
    CHECK(cover_verify(&list, &numbers, &scale, m, &d).proved, "a power that is high");
    list.box[1].m.last--;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "a gap");
    list.box[1].m.last += 2;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "an overlap");
    list.box[1].m.last--;
    list.box[0].m.last = 500;
    list.count = 1;
    list.box[0].power = 20;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "all in one box");
    list.count = 0;
    CHECK(!cover_verify(&list, &numbers, &scale, m, &d).proved, "no box");
    CHECK(cover_verify(&list, &numbers, &scale, (frequencies){2, 1}, &d).proved, "no frequency");
    cover_list_clear(&list);
    number_clear(&scale);
    scheme_numbers_free(&numbers);
    scheme_clear(&s);
    test_end();
}

static void tests(void)
{
    test_bounds();
    test_counts();
    test_lists();
    test_stop();
}

MAIN(tests);
