/* t-affine.c: affine numbers against exact functions of t, and blocks of many valences against single ones. */
#include "lib/block_affine.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 128, FINE = 320 };

/* ---- arithmetic ---- */

/* A function of t: its values at three points, exactly, and what the arithmetic makes of it. */
enum { POINTS = 3 };
typedef struct {
    rational value[POINTS];
    affine z;
} function;

static void function_init(function *f)
{
    for (int i = 0; i < POINTS; i++)
        rational_init(&f->value[i]);
    affine_init(&f->z);
}

static void function_clear(function *f)
{
    for (int i = 0; i < POINTS; i++)
        rational_clear(&f->value[i]);
    affine_clear(&f->z);
}

static void random_small(rational *q)
{
    MUST(rational_set_si(q, random_range(-40, 40), random_range(1, 17)));
}

/* c + d t, c and d somewhere in intervals. */
static void random_line(function *f, const rational *t)
{
    rational c, d, other;
    number bound;
    rational_init(&c), rational_init(&d), rational_init(&other);
    number_init(&bound);
    random_small(&c);
    if (random_below(4))
        random_small(&d);
    for (int i = 0; i < POINTS; i++)
        MUST(rational_mul(&f->value[i], &d, &t[i]) && rational_add(&f->value[i], &f->value[i], &c));
    number_set_rational(&f->z.centre, &c, PRECISION);
    number_set_rational(&f->z.slope, &d, PRECISION);
    for (int part = 0; part < 2; part++) {
        number *z = part ? &f->z.slope : &f->z.centre;
        if (random_below(3))
            continue;
        MUST(rational_set_si(&other, random_range(-3, 3), 1000) && rational_add(&other, &other, part ? &d : &c));
        number_set_rational(&bound, &other, PRECISION);
        number_hull(z, z, &bound, PRECISION);
    }
    rational_clear(&c), rational_clear(&d), rational_clear(&other);
    number_clear(&bound);
}

/* f = f op g, if that is defined. */
static void combine(function *f, const function *g, char op)
{
    static const char names[] = "+-*/n";
    void (*const two[])(affine *, const affine *, const affine *, long) = {affine_add, affine_sub, affine_mul, affine_div};
    bool (*const exact[])(rational *, const rational *, const rational *) = {rational_add, rational_sub, rational_mul, rational_div};
    int which = (int)(strchr(names, op) - names);
    number range;
    bool defined;
    number_init(&range);
    affine_range(&range, &g->z, PRECISION);
    defined = op != '/' || !number_contains_zero(&range);
    number_clear(&range);
    if (!defined)
        return;
    for (int i = 0; i < POINTS; i++)
        MUST(op == 'n' ? rational_neg(&f->value[i], &f->value[i]) : exact[which](&f->value[i], &f->value[i], &g->value[i]));
    if (op == 'n')
        affine_neg(&f->z, &f->z);
    else if (random_bool())
        two[which](&f->z, &f->z, &g->z, PRECISION);
    else {
        affine product;
        affine_init(&product);
        two[which](&product, &f->z, &g->z, PRECISION);
        affine_swap(&product, &f->z);
        affine_clear(&product);
    }
}

/* Is c + d t there, and c + d (s - t) of the differences? */
static void check_function(const function *f, const rational *t)
{
    number x, run;
    rational q;
    double largest = -INFINITY, least = INFINITY;
    number_init(&x), number_init(&run);
    rational_init(&q);
    for (int i = 0; i < POINTS; i++) {
        number_set_rational(&run, &t[i], FINE);
        number_mul(&x, &f->z.slope, &run, FINE);
        number_add(&x, &x, &f->z.centre, FINE);
        CHECK(number_contains_rational(&x, &f->value[i]), "the value at point %d is not enclosed", i);
        affine_range(&x, &f->z, PRECISION);
        CHECK(number_contains_rational(&x, &f->value[i]), "the value at point %d is not in the range", i);
        largest = fmax(largest, rational_get_double_approx(&f->value[i]));
        least = fmin(least, rational_get_double_approx(&f->value[i]));
        for (int j = 0; j < i; j++) {
            MUST(rational_sub(&q, &t[i], &t[j]));
            number_set_rational(&run, &q, FINE);
            number_mul(&x, &f->z.slope, &run, FINE);
            MUST(rational_sub(&q, &f->value[i], &f->value[j]));
            CHECK(number_contains_rational(&x, &q), "the slope from point %d to point %d is not enclosed", i, j);
        }
    }
    CHECK(affine_is_positive(&f->z) != TRUTH_TRUE || least > 0, "something negative is positive");
    CHECK(affine_lower_bound(&f->z) <= least + fabs(least) * 1e-14 && affine_upper_bound(&f->z) >= largest - fabs(largest) * 1e-14, "bounds");
    number_clear(&x), number_clear(&run);
    rational_clear(&q);
}

static void test_arithmetic(void)
{
    test_begin("affine-arithmetic");
    for (test_cases(3000); test_next();) {
        rational t[POINTS];
        function f, g;
        for (int i = 0; i < POINTS; i++) {
            rational_init(&t[i]);
            MUST(rational_set_si(&t[i], i == 0 ? 0 : random_range(-64, 64), 64)); /* f(0) is in the centre */
        }
        function_init(&f), function_init(&g);
        random_line(&f, t);
        for (int step = 0; step < 6 && affine_is_finite(&f.z); step++) {
            random_line(&g, t);
            if (random_below(4) == 0)
                combine(&g, &g, '*');
            combine(&f, random_below(6) ? &g : &f, "+-*/n"[random_below(5)]);
            check_function(&f, t);
        }
        function_clear(&f), function_clear(&g);
        for (int i = 0; i < POINTS; i++)
            rational_clear(&t[i]);
    }
    test_end();
}

/* Narrow slopes are found: the slope of t^2 - t + 5 on 1/2 + t/1000 is near 0. */
static void test_sharp(void)
{
    affine t, f, one;
    test_begin("affine-arithmetic-sharp");
    affine_init(&t), affine_init(&f), affine_init(&one);
    number_set_double(&t.centre, 0.5, PRECISION);
    number_set_double(&t.slope, 0x1p-10, PRECISION);
    number_one(&one.centre);
    affine_sub(&f, &t, &one, PRECISION);
    affine_mul(&f, &f, &t, PRECISION);
    CHECK(is_near(&f.centre, -0.25, 1e-9) && is_near(&f.slope, 0, 0x1.01p-19), "t (t - 1)");
    affine_div(&f, &t, &t, PRECISION);
    CHECK(is_near(&f.centre, 1, 1e-9) && is_near(&f.slope, 0, 0x1p-15), "t / t");
    CHECK(affine_is_positive(&f) == TRUTH_TRUE && affine_is_zero(&f) != TRUTH_TRUE, "questions");
    number_set_double(&t.slope, 0.5, PRECISION);
    CHECK(affine_is_positive(&t) != TRUTH_TRUE, "0 is positive");
    number_neg(&t.slope, &t.slope);
    CHECK(affine_is_positive(&t) != TRUTH_TRUE, "0 is positive, backwards");
    affine_div(&f, &one, &t, PRECISION);
    CHECK(!affine_is_finite(&f), "a quotient by 0");
    affine_clear(&t), affine_clear(&f), affine_clear(&one);
    test_end();
}

/* ---- arcs ---- */

static void test_arcs(void)
{
    test_begin("arcs");
    CHECK(arc_units_below(1, 3) == 0x555555555555 && arc_units_above(1, 3) == 0x555555555556, "1/3");
    CHECK(arc_units_below(1, 4) == 1LL << 46 && arc_units_above(1, 4) == 1LL << 46, "1/4");
    CHECK(arc_units_below(2, 3) == ARC_HALF && arc_units_above(5, 9) == ARC_HALF && arc_units_below(1, 2) == ARC_HALF, "at most 1/2");
    CHECK(arc_units_below(1, VALENCES_UNBOUNDED) == 0 && arc_units_above(FREQUENCIES_UNBOUNDED, 7) == ARC_HALF, "without bound");
    for (test_cases(2000); test_next();) {
        long k = random_range(3, 1000000000), m = random_range(0, k / 2);
        int64_t below = arc_units_below(m, k), above = arc_units_above(m, k);
        rational q, exact;
        rational_init(&q), rational_init(&exact);
        MUST(rational_set_si(&exact, m, k) && rational_set_si(&q, below, 1LL << ARC_BITS));
        CHECK(rational_cmp(&q, &exact) <= 0 && above - below <= 1, "floor of %ld/%ld", m, k);
        MUST(rational_set_si(&q, above, 1LL << ARC_BITS));
        CHECK(rational_cmp(&q, &exact) >= 0 && (above > below || rational_cmp(&q, &exact) == 0), "ceiling of %ld/%ld", m, k);
        rational_clear(&q), rational_clear(&exact);
    }
    test_end();
}

/* ---- blocks ---- */

/* x = u at m/k, and t with C + D t = u. */
static void find_t(number *t, const arc *r, long m, long k)
{
    /* C and D as affine_cosine has them */
    number low, high;
    affine u;
    rational q;
    number_init(&low), number_init(&high);
    affine_init(&u);
    rational_init(&q);
    number_cos_pi(&low, &r->high, PRECISION);
    number_cos_pi(&high, &r->low, PRECISION);
    affine_between(&u, &low, &high, PRECISION);
    MUST(rational_set_si(&q, m, k));
    number_cos_pi(t, &q, FINE);
    number_sub(t, t, &u.centre, FINE);
    number_div(t, t, &u.slope, FINE);
    number_clear(&low), number_clear(&high);
    affine_clear(&u);
    rational_clear(&q);
}

static bool meets(const number *x, const number *y)
{
    return number_less(x, y) != TRUTH_TRUE && number_less(y, x) != TRUTH_TRUE;
}

static void check_single(const scheme *s, const affine_matrix *matrix, const arc *r, long m, long k)
{
    scheme_numbers numbers;
    block one;
    diagnostic d;
    number t, x;
    number_init(&t), number_init(&x);
    find_t(&t, r, m, k);
    CHECK(scheme_numbers_make(&numbers, s, k, FINE, &d) == STATUS_OK && block_make(&one, &numbers, m, true, &d) == BLOCK_OK && one.n == matrix->n, "%s: block %ld of %ld", s->name, m, k);
    for (int i = 0; i < one.n * one.n; i++) {
        number_mul(&x, &t, &matrix->entry[i].slope, FINE);
        number_add(&x, &x, &matrix->entry[i].centre, FINE);
        CHECK(meets(&x, &one.entry[i]), "%s: entry %d of block %ld of %ld is not enclosed", s->name, i, m, k);
    }
    block_free(&one);
    scheme_numbers_free(&numbers);
    number_clear(&t), number_clear(&x);
}

/* Frequencies m of valences k, some blocks of them. */
static void check_blocks(const char *name, valence_range k, frequencies m, double narrow)
{
    scheme s;
    affine_matrix matrix;
    diagnostic d = {0, 0, ""};
    arc r;
    int64_t low = arc_units_below(m.first, k.last), high = arc_units_above(m.last, k.first);
    arc_init(&r);
    read_scheme(&s, catalogue_text(name));
    MUST(arc_set_units(&r, low, high));
    CHECK(affine_matrix_make(&matrix, &s, k, m, &r, PRECISION, &d) == BLOCK_OK, "%s: %s", name, d.text);
    for (int c = 0; c < 8 && matrix.n; c++) {
        long a = random_range(k.first, k.last == VALENCES_UNBOUNDED ? 10 * k.first : k.last), b = random_range(m.first, m.last == FREQUENCIES_UNBOUNDED ? a / 2 : m.last);
        if (b <= a / 2)
            check_single(&s, &matrix, &r, b, a);
    }
    for (int i = 0; i < matrix.n * matrix.n; i++) {
        double width = number_upper_bound(&matrix.entry[i].centre) - number_lower_bound(&matrix.entry[i].centre);
        double slope = number_upper_bound(&matrix.entry[i].slope) - number_lower_bound(&matrix.entry[i].slope);
        CHECK(width <= 1e-6 && slope <= narrow, "%s: entry %d is %.3g wide, its slope %.3g", name, i, width, slope);
    }
    affine_matrix_free(&matrix);
    arc_clear(&r);
    scheme_clear(&s);
}

static void test_blocks(void)
{
    static const char *const name[] = {"loop", "butterfly", "catmull-clark", "kobbelt", "midpoint", "wave"};
    const frequencies one = {1, 1}, all = {2, FREQUENCIES_UNBOUNDED};
    test_begin("blocks-of-many-valences");
    for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
        check_blocks(name[i], (valence_range){7, 8}, one, 0.05);
        check_blocks(name[i], (valence_range){20, VALENCES_UNBOUNDED}, one, 0.01);
        check_blocks(name[i], (valence_range){100, 1000}, one, 0.001);
        check_blocks(name[i], (valence_range){9, 20}, (frequencies){2, 3}, 3);
        check_blocks(name[i], (valence_range){9, VALENCES_UNBOUNDED}, all, 10);
    }
    check_blocks("modified-butterfly", (valence_range){7, VALENCES_UNBOUNDED}, one, 0.1);
    check_blocks("modified-butterfly", (valence_range){7, VALENCES_UNBOUNDED}, (frequencies){3, FREQUENCIES_UNBOUNDED}, 10);
    check_blocks("doo-sabin", (valence_range){7, VALENCES_UNBOUNDED}, (frequencies){2, 4}, 10);
    test_end();
}

/* A valence at which rules change, and one where the complex is the plane, are part of no range that hides it. */
static void test_refused(void)
{
    scheme s;
    affine_matrix matrix;
    diagnostic d = {0, 0, ""};
    arc r;
    test_begin("blocks-of-many-valences-refused");
    arc_init(&r);
    read_scheme(&s, catalogue_text("modified-butterfly"));
    MUST(arc_set_valences(&r, (valence_range){5, 7}));
    CHECK(affine_matrix_make(&matrix, &s, (valence_range){5, 7}, one_frequency(1), &r, PRECISION, &d) == BLOCK_BAD_INPUT && d.line > 0, "a rule that holds at 5 and 7, not at 6");
    affine_matrix_free(&matrix);
    scheme_clear(&s);
    read_scheme(&s, catalogue_text("butterfly"));
    MUST(arc_set_valences(&r, (valence_range){5, 7}));
    CHECK(affine_matrix_make(&matrix, &s, (valence_range){5, 7}, one_frequency(1), &r, PRECISION, &d) == BLOCK_OK, "nothing opposite is asked for");
    affine_matrix_free(&matrix);
    scheme_clear(&s);
    arc_clear(&r);
    test_end();
}

static void tests(void)
{
    test_arithmetic();
    test_sharp();
    test_arcs();
    test_blocks();
    test_refused();
}

MAIN(tests);
