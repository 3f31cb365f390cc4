/* t-grid.c: grid operations give exactly the least grid interval, computed here from rational endpoints. */
#include "bigfloat/grid.h"

#include "random.h"

static rational lo[2], hi[2]; /* endpoints of the operands */

static void get(int i, const grid *x)
{
    MUST(rational_set_integer_2exp(&lo[i], &x->lower, -(long)x->exponent));
    MUST(rational_set_integer_2exp(&hi[i], &x->upper, -(long)x->exponent));
}

/* Is z the least interval of the grid g around [a, b]? */
static bool is_least(const grid *z, const rational *a, const rational *b, long g)
{
    if (!grid_is_finite(z) || z->exponent != g)
        return false;
    rational t;
    integer m;
    rational_init(&t);
    integer_init(&m);
    MUST(rational_mul_2exp(&t, a, g));
    MUST(rational_floor(&m, &t));
    bool same = integer_cmp(&m, &z->lower) == 0;
    MUST(rational_mul_2exp(&t, b, g));
    MUST(rational_ceil(&m, &t));
    same = same && integer_cmp(&m, &z->upper) == 0;
    rational_clear(&t);
    integer_clear(&m);
    return same;
}

typedef bool (*rational_op)(rational *, const rational *, const rational *);
typedef void (*grid_op)(grid *, const grid *, const grid *, long);

/* The least grid interval around the four op(endpoint, endpoint). */
static void check_corners(const char *name, grid_op op, rational_op exact, bool divides)
{
    grid x, y, z, t;
    grid_init(&x), grid_init(&y), grid_init(&z), grid_init(&t);
    for (int i = 0; i < 2; i++)
        rational_init(&lo[i]), rational_init(&hi[i]);
    rational a, b, r;
    rational_init(&a), rational_init(&b), rational_init(&r);
    long g = random_below(4) ? random_range(30, 130) : random_range(-70, 200);
    size_t n = random_below(4) ? 1 + random_below(2) : 5;
    bool elsewhere = random_below(8) == 0;
    random_grid(&x, n, elsewhere ? g + random_range(-50, 50) : g), random_grid(&y, n, g);
    op(&z, &x, &y, g);
    if (elsewhere)
        grid_set_round(&x, &x, g);
    get(0, &x), get(1, &y);
    if (divides && grid_contains_zero(&y))
        CHECK(!grid_is_finite(&z), "%s by 0", name);
    else {
        for (int i = 0; i < 4; i++) {
            MUST(exact(&r, i & 1 ? &lo[0] : &hi[0], i & 2 ? &lo[1] : &hi[1]));
            if (i == 0 || rational_cmp(&r, &a) < 0)
                MUST(rational_set(&a, &r));
            if (i == 0 || rational_cmp(&r, &b) > 0)
                MUST(rational_set(&b, &r));
        }
        CHECK(is_least(&z, &a, &b, g), "%s on grid %ld", name, g);
    }
    grid_set(&t, &x), op(&t, &t, &y, g);
    CHECK(grid_identical(&t, &z), "%s(x, x, y)", name);
    grid_set(&t, &y), op(&t, &x, &t, g);
    CHECK(grid_identical(&t, &z), "%s(y, x, y)", name);
    op(&z, &x, &x, g), grid_set(&t, &x), op(&t, &t, &t, g);
    CHECK(grid_identical(&t, &z), "%s(x, x, x)", name);
    grid_clear(&x), grid_clear(&y), grid_clear(&z), grid_clear(&t);
    for (int i = 0; i < 2; i++)
        rational_clear(&lo[i]), rational_clear(&hi[i]);
    rational_clear(&a), rational_clear(&b), rational_clear(&r);
}

static bool rational_min(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? x : y);
}
static bool rational_max(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? y : x);
}

#define BINARY(op, divides)                                           \
    static void test_##op(void)                                       \
    {                                                                 \
        test_begin("grid-" #op);                                      \
        for (test_cases(10000); test_next();)                         \
            check_corners(#op, grid_##op, rational_##op, divides);    \
        test_end();                                                   \
    }
BINARY(add, false)
BINARY(sub, false)
BINARY(mul, false)
BINARY(div, true)
BINARY(min, false)
BINARY(max, false)

static void test_unary(void)
{
    test_begin("grid-unary");
    for (test_cases(5000); test_next();) {
        grid x, y, z, w;
        grid_init(&x), grid_init(&y), grid_init(&z), grid_init(&w);
        for (int i = 0; i < 2; i++)
            rational_init(&lo[i]), rational_init(&hi[i]);
        rational a, b;
        rational_init(&a), rational_init(&b);
        long g = random_range(-70, 200), v = (long)random_corner(), e = random_range(-200, 200);
        random_grid(&x, 3, g), random_grid(&y, 3, g);
        get(0, &x), get(1, &y);
        grid_neg(&z, &x);
        MUST(rational_neg(&a, &hi[0]));
        MUST(rational_neg(&b, &lo[0]));
        CHECK(is_least(&z, &a, &b, g), "neg");
        grid_mul_2exp(&z, &x, e, g);
        MUST(rational_mul_2exp(&a, &lo[0], e));
        MUST(rational_mul_2exp(&b, &hi[0], e));
        CHECK(is_least(&z, &a, &b, g), "mul_2exp");
        MUST(rational_set_si(&a, v, 1));
        MUST(rational_set(&b, &a));
        MUST(rational_mul(&a, &a, v < 0 ? &hi[0] : &lo[0]));
        MUST(rational_mul(&b, &b, v < 0 ? &lo[0] : &hi[0]));
        grid_mul_si(&z, &x, v, g);
        CHECK(is_least(&z, &a, &b, g), "mul_si");
        grid_div_si(&z, &x, v, g);
        if (v) {
            MUST(rational_set_si(&a, v, 1));
            MUST(rational_div(&b, v < 0 ? &lo[0] : &hi[0], &a));
            MUST(rational_div(&a, v < 0 ? &hi[0] : &lo[0], &a));
            CHECK(is_least(&z, &a, &b, g), "div_si");
        } else
            CHECK(!grid_is_finite(&z), "div by 0");
        grid_inv(&z, &x, g);
        if (!grid_contains_zero(&x)) {
            MUST(rational_inv(&a, &hi[0]));
            MUST(rational_inv(&b, &lo[0]));
            CHECK(is_least(&z, &a, &b, g), "inv");
        }
        grid_mul(&w, &x, &y, g), grid_add(&w, &w, &x, g);
        grid_set(&z, &x), grid_addmul(&z, &z, &y, g);
        CHECK(grid_identical(&z, &w), "addmul");
        grid_mul(&w, &x, &y, g), grid_sub(&w, &x, &w, g);
        grid_set(&z, &x), grid_submul(&z, &z, &y, g);
        CHECK(grid_identical(&z, &w), "submul");
        grid_abs(&z, &x);
        MUST(rational_abs(&a, &lo[0]));
        MUST(rational_abs(&b, &hi[0]));
        if (rational_cmp(&a, &b) > 0)
            rational_swap(&a, &b);
        grid_magnitude_upper(&w, &x, g);
        CHECK(is_least(&w, &b, &b, g), "magnitude");
        if (grid_contains_zero(&x))
            MUST(rational_set_si(&a, 0, 1));
        CHECK(is_least(&z, &a, &b, g), "abs");
        grid_sqr(&w, &z, g);
        MUST(rational_mul(&a, &a, &a));
        MUST(rational_mul(&b, &b, &b));
        CHECK(is_least(&w, &a, &b, g), "sqr");
        grid_sqr(&y, &x, g);
        CHECK(grid_identical(&w, &y), "sqr of negative");
        grid_midpoint(&z, &x, g), grid_radius_upper(&w, &x, g);
        grid_add_error(&z, &z, &w, g);
        CHECK(grid_contains(&z, &x), "midpoint and radius");
        grid_lower(&z, &x, g), grid_upper(&w, &x, g);
        CHECK(is_least(&z, &lo[0], &lo[0], g) && is_least(&w, &hi[0], &hi[0], g), "endpoints");
        grid_hull(&z, &z, &w, g);
        CHECK(grid_identical(&z, &x), "hull");
        double u = grid_lower_bound(&x), t = grid_upper_bound(&x);
        MUST(rational_set_double(&a, u));
        MUST(rational_set_double(&b, t));
        CHECK(rational_cmp(&a, &lo[0]) <= 0 && rational_cmp(&b, &hi[0]) >= 0, "double bounds");
        random_point_grid(&a, &x);
        CHECK(grid_contains_rational(&x, &a), "contains_rational");
        grid_set_rational(&z, &a, g);
        CHECK(is_least(&z, &a, &a, g) && grid_contains(&x, &z), "set_rational");
        random_rational(&a, 3);
        grid_set_rational(&z, &a, g);
        CHECK(is_least(&z, &a, &a, g), "set_rational");
        ball bb;
        ball_init(&bb);
        ball_set_grid(&bb, &x, 100);
        random_point_grid(&a, &x);
        CHECK(ball_contains_rational(&bb, &a), "ball_set_grid");
        ball_clear(&bb);
        for (int i = 0; i < 2; i++)
            rational_clear(&lo[i]), rational_clear(&hi[i]);
        rational_clear(&a), rational_clear(&b);
        grid_clear(&x), grid_clear(&y), grid_clear(&z), grid_clear(&w);
    }
    test_end();
}

/* floor(sqrt) and ceil(sqrt): their squares bracket. */
static void test_sqrt(void)
{
    test_begin("grid-sqrt");
    for (test_cases(5000); test_next();) {
        grid x, z;
        grid_init(&x), grid_init(&z);
        rational a, b;
        rational_init(&a), rational_init(&b);
        integer m;
        integer_init(&m);
        long g = random_range(-70, 200);
        random_grid(&x, 3, g);
        if (random_bool())
            grid_abs(&x, &x);
        grid_sqrt(&z, &x, g);
        if (integer_sign(&x.lower) < 0)
            CHECK(!grid_is_finite(&z), "negative");
        else {
            for (int up = 0; up < 2; up++) {
                MUST(rational_set_integer_2exp(&a, up ? &x.upper : &x.lower, -g));
                MUST(rational_set_integer_2exp(&b, up ? &z.upper : &z.lower, -g));
                MUST(rational_mul(&b, &b, &b));
                CHECK(up ? rational_cmp(&b, &a) >= 0 : rational_cmp(&b, &a) <= 0, "not outward");
                MUST(integer_add_si(&m, up ? &z.upper : &z.lower, up ? -1 : 1));
                MUST(rational_set_integer_2exp(&b, &m, -g));
                MUST(rational_mul(&b, &b, &b));
                CHECK((up ? rational_cmp(&b, &a) < 0 : rational_cmp(&b, &a) > 0) || integer_sign(&m) < 0, "not least");
            }
        }
        rational_clear(&a), rational_clear(&b);
        integer_clear(&m);
        grid_clear(&x), grid_clear(&z);
    }
    test_end();
}

static void test_questions(void)
{
    test_begin("grid-questions");
    for (test_cases(5000); test_next();) {
        grid x, y;
        grid_init(&x), grid_init(&y);
        for (int i = 0; i < 2; i++)
            rational_init(&lo[i]), rational_init(&hi[i]);
        long g = random_range(0, 80);
        random_grid(&x, 2, g), random_grid(&y, 2, random_bool() ? g : g + random_range(-3, 3));
        if (random_bool()) {
            grid_set(&y, &x);
            MUST(integer_add_si(&y.lower, &y.lower, random_range(-1, 1)));
            MUST(integer_add_si(&y.upper, &y.upper, random_range(0, 2)));
            if (integer_cmp(&y.lower, &y.upper) > 0)
                grid_set(&y, &x);
        }
        get(0, &x), get(1, &y);
        CHECK(grid_less(&x, &y) == (rational_cmp(&hi[0], &lo[1]) < 0 ? TRUTH_TRUE : rational_cmp(&lo[0], &hi[1]) >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "less");
        CHECK(grid_contains(&x, &y) == (rational_cmp(&lo[0], &lo[1]) <= 0 && rational_cmp(&hi[1], &hi[0]) <= 0), "contains");
        CHECK(grid_contains_interior(&x, &y) == (rational_cmp(&lo[0], &lo[1]) < 0 && rational_cmp(&hi[1], &hi[0]) < 0), "interior");
        int s = rational_sign(&lo[0]), t = rational_sign(&hi[0]);
        CHECK(grid_is_positive(&x) == (s > 0 ? TRUTH_TRUE : t <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "positive");
        CHECK(grid_is_negative(&x) == (t < 0 ? TRUTH_TRUE : s >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "negative");
        CHECK(grid_contains_zero(&x) == (s <= 0 && t >= 0), "contains_zero");
        CHECK(grid_is_zero(&x) == (s == 0 && t == 0 ? TRUTH_TRUE : s > 0 || t < 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "zero");
        CHECK(grid_is_thin(&x) == (rational_cmp(&lo[0], &hi[0]) == 0), "thin");
        for (int i = 0; i < 2; i++)
            rational_clear(&lo[i]), rational_clear(&hi[i]);
        grid_clear(&x), grid_clear(&y);
    }
    test_end();
}

int main(void)
{
    test_add();
    test_sub();
    test_mul();
    test_div();
    test_min();
    test_max();
    test_unary();
    test_sqrt();
    test_questions();
    return test_status();
}
