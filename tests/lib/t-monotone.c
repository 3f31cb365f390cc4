/* t-monotone.c: blocks as functions of u, their eigenvalues as such, and chains along which one falls. */
#include "lib/block_slope.h"
#include "lib/eigen_approx.h"
#include "lib/eigenpair_slope.h"
#include "lib/monotone.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 128 };

/* Can they be equal? */
static bool meets(const number *x, const number *y)
{
    return number_less(x, y) != TRUTH_TRUE && number_less(y, x) != TRUTH_TRUE;
}

static void hull_of_doubles(number *z, double low, double high)
{
    number other;
    number_init(&other);
    number_set_double(z, low, PRECISION);
    number_set_double(&other, high, PRECISION);
    number_hull(z, z, &other, PRECISION);
    number_clear(&other);
}

static bool make_slope(block_slope *z, const scheme *s, long k, frequencies m, double low, double high)
{
    diagnostic d = {0, 0, ""};
    number u;
    block_status answer;
    number_init(&u);
    hull_of_doubles(&u, low, high);
    answer = block_slope_make(z, s, k, m, &u, PRECISION, &d);
    CHECK(answer == BLOCK_OK, "%s: status %d: %s", s->name, (int)answer, d.text);
    number_clear(&u);
    return answer == BLOCK_OK;
}

/* y - x is in slope (b - a): the mean-value theorem. */
static bool has_slope(const number *x, const number *y, const number *slope, double a, double b)
{
    bool ok;
    number run, rise;
    number_init(&run), number_init(&rise);
    number_set_double(&run, b, PRECISION);
    number_set_double(&rise, a, PRECISION);
    number_sub(&run, &run, &rise, PRECISION);
    number_mul(&run, &run, slope, PRECISION);
    number_sub(&rise, y, x, PRECISION);
    ok = meets(&run, &rise);
    number_clear(&run), number_clear(&rise);
    return ok;
}

/* ---- blocks ---- */

static void check_block_slope(const scheme *s, long k, double a, double b)
{
    block_slope over, at_a, at_b;
    block plain;
    frequencies m = {k / 2, k / 2}; /* some frequency, for the weights */
    memset(&over, 0, sizeof over);
    memset(&at_a, 0, sizeof at_a);
    memset(&at_b, 0, sizeof at_b);
    if (make_slope(&over, s, k, m, a, b) && make_slope(&at_a, s, k, m, a, a) && make_slope(&at_b, s, k, m, b, b)) {
        scheme_numbers numbers;
        diagnostic d;
        number u;
        double most = 0;
        number_init(&u);
        hull_of_doubles(&u, a, b);
        CHECK(scheme_numbers_make(&numbers, s, k, PRECISION, &d) == STATUS_OK && block_make_at(&plain, &numbers, m, &u, &d) == BLOCK_OK && plain.n == over.n, "%s: block", s->name);
        for (int i = 0; i < over.n * over.n; i++) {
            CHECK(has_slope(&at_a.entry[i], &at_b.entry[i], &over.slope[i], a, b), "%s, u from %.3g to %.3g: slope of entry %d", s->name, a, b, i);
            CHECK(meets(&over.slope[i], &at_a.slope[i]) && meets(&over.slope[i], &at_b.slope[i]) && meets(&over.entry[i], &at_a.entry[i]), "%s: parts are not in the whole", s->name);
            CHECK(number_contains(&over.entry[i], &plain.entry[i]) || meets(&over.entry[i], &plain.entry[i]), "%s: entry %d differs", s->name, i);
            most = fmax(most, number_upper_bound(&over.slope[i]) - number_lower_bound(&over.slope[i]));
        }
        CHECK(most < 2000 * (b - a), "%s: slopes are %.3g wide", s->name, most);
        block_free(&plain);
        scheme_numbers_free(&numbers);
        number_clear(&u);
    }
    block_slope_free(&over);
    block_slope_free(&at_a);
    block_slope_free(&at_b);
}

static void test_block_slopes(void)
{
    test_begin("block-slopes");
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        scheme s;
        read_scheme(&s, e->text);
        if (s.mirror_symmetric)
            for (int i = 0; i <= 8; i++)
                check_block_slope(&s, 10, i / 9.0, (i + 1) / 9.0);
        scheme_clear(&s);
    }
    test_end();
}

/* Weights must not depend on the frequency. */
static void test_weights(void)
{
    static const struct {
        const char *name;
        frequencies m;
        bool constant;
    } known[] = {{"modified-butterfly", {3, 9}, true},  {"modified-butterfly", {2, 9}, false}, {"modified-butterfly", {1, 1}, true}, {"modified-loop", {3, 4}, false},
                 {"modified-loop", {3, 3}, true},       {"doo-sabin", {2, 9}, true},           {"doo-sabin", {1, 2}, false},         {"loop", {1, 9}, true}};
    test_begin("block-slopes-of-weights");
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        scheme s;
        block_slope b;
        bool finite = true;
        read_scheme(&s, catalogue_text(known[i].name));
        if (make_slope(&b, &s, 20, known[i].m, 0.25, 0.5))
            for (int j = 0; j < b.n * b.n; j++)
                finite = finite && number_is_finite(&b.slope[j]);
        CHECK(finite == known[i].constant, "%s, %ld to %ld", known[i].name, known[i].m.first, known[i].m.last);
        block_slope_free(&b);
        scheme_clear(&s);
    }
    test_end();
}

/* ---- eigenpairs ---- */

typedef struct {
    eigenpair_choice choice;
    number *box, *slope;
    int n;
} pair;

static bool make_pair(pair *z, const scheme *s, double a, double b)
{
    block_slope blocks;
    bool ok = false;
    memset(z, 0, sizeof *z);
    eigenpair_choice_init(&z->choice);
    if (make_slope(&blocks, s, 10, one_frequency(1), a, b)) {
        z->n = blocks.n;
        z->box = number_array_new((size_t)z->n + 1);
        z->slope = number_array_new((size_t)z->n + 1);
        ok = eigenpair_choose(&z->choice, blocks.entry, blocks.n, false, PRECISION, PRECISION) == TRUTH_TRUE && eigenpair_prove(z->box, &z->choice, blocks.entry, PRECISION) == TRUTH_TRUE
             && eigenpair_slope_sharp(z->slope, z->box, &z->choice, blocks.entry, blocks.slope, PRECISION) == TRUTH_TRUE;
        CHECK(ok, "%s, u from %.3g to %.3g: no pair", s->name, a, b);
    }
    block_slope_free(&blocks);
    return ok;
}

static void free_pair(pair *z)
{
    eigenpair_choice_clear(&z->choice);
    number_array_free(z->box, (size_t)z->n + 1);
    number_array_free(z->slope, (size_t)z->n + 1);
}

/* L of Loop's scheme is 1/8 + u^2/2, for all u. */
static void test_loop(void)
{
    scheme s;
    test_begin("eigenpair-slope-of-loop");
    read_scheme(&s, catalogue_text("loop"));
    for (int i = 0; i <= 10; i++) {
        double u = 0.5 + i / 20.0;
        pair p;
        number v;
        number_init(&v);
        number_set_double(&v, u, PRECISION);
        if (make_pair(&p, &s, u, u)) {
            CHECK(meets(&p.slope[p.n], &v) && is_near(&p.slope[p.n], u, 1e-10), "dL/du at %.3g is %.15g", u, number_mid_approx(&p.slope[p.n]));
            CHECK(is_near(&p.box[p.n], 0.125 + u * u / 2, 1e-10), "L at %.3g", u);
        }
        free_pair(&p);
        number_clear(&v);
    }
    scheme_clear(&s);
    test_end();
}

static void check_pair(const char *name, double a, double b)
{
    scheme s;
    pair over, at_a, at_b;
    read_scheme(&s, catalogue_text(name));
    bool ok = make_pair(&over, &s, a, b);
    ok = make_pair(&at_a, &s, a, a) && ok;
    ok = make_pair(&at_b, &s, b, b) && ok;
    if (ok) {
        CHECK(over.choice.pivot == at_a.choice.pivot && over.choice.pivot == at_b.choice.pivot, "%s: pivots", name);
        for (int j = 0; j <= over.n; j++) {
            CHECK(has_slope(&at_a.box[j], &at_b.box[j], &over.slope[j], a, b), "%s, u from %.3g to %.3g: slope of component %d", name, a, b, j);
            CHECK(meets(&over.slope[j], &at_a.slope[j]) && meets(&over.slope[j], &at_b.slope[j]), "%s: parts are not in the whole", name);
        }
        CHECK(number_is_zero(&over.slope[over.choice.pivot]) == TRUTH_TRUE, "%s: the pivot moves", name);
    }
    free_pair(&over);
    free_pair(&at_a);
    free_pair(&at_b);
    scheme_clear(&s);
}

static void test_pairs(void)
{
    test_begin("eigenpair-slopes");
    for (int i = 0; i < 6; i++) {
        double a = 0.6 + i / 16.0, b = a + 0x1p-12;
        check_pair("loop", a, b);
        check_pair("catmull-clark", a, b);
        check_pair("butterfly", 0.75 + i / 64.0, 0.75 + i / 64.0 + 0x1p-12);
        check_pair("wave", a, b);
        check_pair("modified-butterfly", a, b);
    }
    test_end();
}

/* ---- chains ---- */

typedef struct {
    scheme s;
    scheme_numbers numbers;
    monotone_list list;
    monotone_answer found;
    long start;
} chain;

static void find_chain(chain *c, const char *name, long k, long start, long goal, size_t most)
{
    diagnostic d = {0, 0, ""};
    read_scheme(&c->s, catalogue_text(name));
    CHECK(scheme_numbers_make(&c->numbers, &c->s, k, PRECISION, &d) == STATUS_OK, "%s: %s", name, d.text);
    monotone_list_init(&c->list);
    c->start = start;
    c->found = monotone_search(&c->list, &c->numbers, start, goal, most, 0, &d);
    CHECK(c->found.status == BLOCK_OK, "%s: status %d: %s", name, (int)c->found.status, d.text);
}

static void free_chain(chain *c)
{
    monotone_list_clear(&c->list);
    scheme_numbers_free(&c->numbers);
    scheme_clear(&c->s);
}

static bool verifies(const chain *c, bool forward)
{
    diagnostic d;
    return monotone_verify(&c->list, &c->numbers, c->start, forward, &d).proved;
}

/* Chains where the eigenvalues do fall; a third of the way it is easy. */
static void check_chain(const char *name, long k, long start, long goal, long reach)
{
    chain c;
    find_chain(&c, name, k, start, goal, 40);
    CHECK(c.found.proved && labs(c.found.end - start) >= reach, "%s, k = %ld: the chain from %ld ends at %ld", name, k, start, c.found.end);
    CHECK(verifies(&c, goal > start), "%s, k = %ld: what was found is no proof", name, k);
    CHECK(!verifies(&c, goal < start), "%s, k = %ld: backward is forward", name, k);
    free_chain(&c);
}

static void test_chains(void)
{
    test_begin("monotone-chains");
    check_chain("loop", 1000, 1, 500, 10);
    check_chain("loop", 1000000000000, 1, 500000000000, 20000000000);
    check_chain("catmull-clark", 1000000000, 1, 500000000, 10000000);
    check_chain("wave", 1000000, 1, 500000, 5000);
    check_chain("butterfly", 1000000, 200000, 300000, 5000);
    check_chain("butterfly", 1000000, 185000, 150000, 5000);
    test_end();
}

/* Chains where they rise, or weights change. */
static void check_no_chain(const char *name, long k, long start, long goal)
{
    chain c;
    find_chain(&c, name, k, start, goal, 40);
    CHECK(!c.found.proved && c.found.end == start && c.list.count == 0, "%s, k = %ld: a chain from %ld to %ld", name, k, start, c.found.end);
    free_chain(&c);
}

static void test_no_chains(void)
{
    test_begin("monotone-no-chains");
    check_no_chain("loop", 1000, 50, 1);
    check_no_chain("butterfly", 1000000, 150000, 185000);
    check_no_chain("butterfly", 1000000, 250000, 200000);
    check_no_chain("butterfly", 1000000, 192760, 150000); /* the largest is near 192,749 */
    check_no_chain("modified-loop", 1000000, 3, 100);
    check_no_chain("modified-butterfly", 1000000, 1, 100);
    test_end();
}

static void test_lies(void)
{
    chain c;
    test_begin("monotone-chains-with-a-lie");
    find_chain(&c, "catmull-clark", 1000000000, 1, 500000000, 3);
    CHECK(c.found.proved && c.list.count == 3 && verifies(&c, true), "the chain");
    monotone_box *b = &c.list.box[1];
    int power = b->power;
    c.start = 2;
    CHECK(!verifies(&c, true), "another start");
    c.start = 1;
    b->power = 0;
    CHECK(!verifies(&c, true), "a power too low");
    b->power = power;
    b->m.first++;
    CHECK(!verifies(&c, true), "a gap");
    b->m.first--;
    CHECK(verifies(&c, true), "mended");
    long last = b->m.last;
    eigenpair_choice_clear(&c.list.box[2].eigenpair);
    c.list.count = 2;
    b->m.last = 500000000;
    CHECK(!verifies(&c, true), "too wide a range");
    b->m.last = b->m.first;
    CHECK(!verifies(&c, true), "an empty range");
    b->m.last = last;
    integer_set_si(&b->eigenpair.approximation[b->eigenpair.n - 1], 1);
    CHECK(!verifies(&c, true), "another eigenvalue");
    free_chain(&c);
    test_end();
}

static void tests(void)
{
    test_block_slopes();
    test_weights();
    test_loop();
    test_pairs();
    test_chains();
    test_no_chains();
    test_lies();
}

MAIN(tests);
