/* t-interval.c: hardware intervals contain exact results; the rounding mode comes back; odd operands. */
#include "bigfloat/interval.h"

#include <fenv.h>
#include <stdlib.h>

#include "random.h"

typedef bool (*rational_op)(rational *, const rational *, const rational *);
typedef struct {
    interval x, y, z, same_x, same_y, squared, same;
} operands;

/* One operation with every aliasing, inside a region that holds nothing else. */
#define RUN(op)                                                              \
    static INTERVAL_NOINLINE void compute_##op(operands *o)                  \
    {                                                                        \
        interval_##op(&o->z, &o->x, &o->y, 0);                               \
        o->same_x = o->x, interval_##op(&o->same_x, &o->same_x, &o->y, 0);   \
        o->same_y = o->y, interval_##op(&o->same_y, &o->x, &o->same_y, 0);   \
        interval_##op(&o->squared, &o->x, &o->x, 0);                         \
        o->same = o->x, interval_##op(&o->same, &o->same, &o->same, 0);      \
    }                                                                        \
    static void run_##op(operands *o)                                        \
    {                                                                        \
        interval_mode mode = interval_enter();                               \
        compute_##op(o);                                                     \
        interval_leave(mode);                                                \
    }
RUN(add)
RUN(sub)
RUN(mul)
RUN(div)
RUN(min)
RUN(max)
RUN(hull)
RUN(add_error)

static bool valid(const interval *x)
{
    return x->neg_lower > -HUGE_VAL && x->upper > -HUGE_VAL && -x->neg_lower <= x->upper;
}

static bool identical(const interval *x, const interval *y)
{
    return x->neg_lower == y->neg_lower && x->upper == y->upper;
}

static void check_binary(const char *name, void (*run)(operands *), rational_op exact, bool divides)
{
    operands o;
    rational p, q, r;
    rational_init(&p), rational_init(&q), rational_init(&r);
    random_interval(&o.x), random_interval(&o.y);
    if (random_below(6) == 0)
        interval_neg(&o.y, &o.x);
    random_point_interval(&p, &o.x), random_point_interval(&q, &o.y);
    run(&o);
    CHECK(valid(&o.z) && valid(&o.squared), "%s: not an interval", name);
    if (divides && rational_is_zero(&q))
        CHECK(!interval_is_finite(&o.z), "%s by 0", name);
    else {
        MUST(exact(&r, &p, &q));
        CHECK(interval_contains_rational(&o.z, &r), "%s: [%a, %a] [%a, %a] -> [%a, %a]", name, -o.x.neg_lower, o.x.upper,
              -o.y.neg_lower, o.y.upper, -o.z.neg_lower, o.z.upper);
    }
    CHECK(identical(&o.z, &o.same_x) && identical(&o.z, &o.same_y) && identical(&o.squared, &o.same), "%s: aliasing", name);
    rational_clear(&p), rational_clear(&q), rational_clear(&r);
}

static bool rational_min(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? x : y);
}
static bool rational_max(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? y : x);
}
static bool rational_hull(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, random_bool() ? x : y);
}
static bool rational_add_error(rational *z, const rational *x, const rational *y)
{
    return random_bool() ? rational_add(z, x, y) : rational_sub(z, x, y);
}

#define BINARY(op, divides)                                             \
    static void test_##op(void)                                         \
    {                                                                   \
        test_begin("interval-" #op);                                    \
        for (test_cases(10000); test_next();)                           \
            check_binary(#op, run_##op, rational_##op, divides);        \
        test_end();                                                     \
    }
BINARY(add, false)
BINARY(sub, false)
BINARY(mul, false)
BINARY(div, true)
BINARY(min, false)
BINARY(max, false)
BINARY(hull, false)
BINARY(add_error, false)

/* ---- one operand ---- */

typedef struct {
    interval x, neg, abs, sqr, inv, sqrt_sqr, shifted, times, over, lower, upper, middle, radius, magnitude;
    long e, v;
} unary;

static INTERVAL_NOINLINE void compute_unary(unary *u)
{
    const interval *x = &u->x;
    interval_neg(&u->neg, x);
    interval_abs(&u->abs, x);
    interval_sqr(&u->sqr, x, 0);
    interval_inv(&u->inv, x, 0);
    interval_sqrt(&u->sqrt_sqr, &u->sqr, 0);
    interval_mul_2exp(&u->shifted, x, u->e, 0);
    interval_mul_si(&u->times, x, u->v, 0);
    interval_div_si(&u->over, x, u->v, 0);
    interval_lower(&u->lower, x, 0);
    interval_upper(&u->upper, x, 0);
    interval_midpoint(&u->middle, x, 0);
    interval_radius_upper(&u->radius, x, 0);
    interval_magnitude_upper(&u->magnitude, x, 0);
}

static void run_unary(unary *u)
{
    interval_mode mode = interval_enter();
    compute_unary(u);
    interval_leave(mode);
}

static void test_unary(void)
{
    test_begin("interval-unary");
    for (test_cases(10000); test_next();) {
        unary u;
        rational p, q, m;
        rational_init(&p), rational_init(&q), rational_init(&m);
        random_interval(&u.x);
        u.e = random_bool() ? random_range(-100, 100) : random_range(-3000, 3000);
        u.v = (long)random_corner();
        random_point_interval(&p, &u.x);
        run_unary(&u);
#define HOLDS(z, name) CHECK(valid(&u.z) && interval_contains_rational(&u.z, &q), name " [%a, %a]", -u.x.neg_lower, u.x.upper)
        MUST(rational_neg(&q, &p));
        HOLDS(neg, "neg");
        MUST(rational_abs(&q, &p));
        HOLDS(abs, "abs");
        HOLDS(sqrt_sqr, "sqrt of square");
        CHECK(interval_is_negative(&u.abs) == TRUTH_FALSE, "abs < 0");
        if (interval_is_finite(&u.magnitude))
            CHECK(-u.magnitude.neg_lower == fmax(u.x.upper, u.x.neg_lower), "magnitude");
        MUST(rational_mul(&q, &p, &p));
        HOLDS(sqr, "sqr");
        MUST(rational_mul_2exp(&q, &p, u.e));
        HOLDS(shifted, "mul_2exp");
        MUST(rational_set_si(&q, u.v, 1));
        MUST(rational_mul(&q, &q, &p));
        HOLDS(times, "mul_si");
        if (u.v) {
            MUST(rational_set_si(&q, u.v, 1));
            MUST(rational_div(&q, &p, &q));
            HOLDS(over, "div_si");
        }
        if (!rational_is_zero(&p)) {
            MUST(rational_inv(&q, &p));
            HOLDS(inv, "inv");
        }
        if (interval_is_finite(&u.x)) {
            CHECK(u.lower.upper == -u.x.neg_lower && u.upper.upper == u.x.upper, "endpoints");
            CHECK(interval_is_thin(&u.lower) && interval_is_thin(&u.upper), "thin");
        }
        if (interval_is_finite(&u.middle) && interval_is_finite(&u.radius)) {
            MUST(rational_set_double(&m, u.middle.upper));
            MUST(rational_sub(&m, &m, &p));
            MUST(rational_abs(&m, &m));
            MUST(rational_set_double(&q, u.radius.upper));
            CHECK(rational_cmp(&m, &q) <= 0, "radius");
            if (interval_is_thin(&u.x))
                CHECK(u.middle.upper == u.x.upper && u.radius.upper == 0, "thin middle");
        }
        rational_clear(&p), rational_clear(&q), rational_clear(&m);
    }
    test_end();
}

static void test_conversions(void)
{
    test_begin("interval-conversions");
    for (test_cases(3000); test_next();) {
        rational q, r;
        ball b;
        interval x;
        integer m;
        rational_init(&q), rational_init(&r);
        ball_init(&b);
        integer_init(&m);
        random_rational(&q, 4);
        interval_set_rational(&x, &q, 0);
        CHECK(interval_contains_rational(&x, &q), "set_rational");
        CHECK(nextafter(-x.neg_lower, HUGE_VAL) >= x.upper, "set_rational is not the least");
        random_ball(&b, 4);
        random_point_ball(&q, &b);
        interval_set_ball(&x, &b, 0);
        CHECK(interval_contains_rational(&x, &q), "set_ball");
        random_interval(&x);
        random_point_interval(&q, &x);
        ball_set_interval(&b, &x, 64);
        CHECK(ball_contains_rational(&b, &q), "ball_set_interval");
        long v = (long)random_corner(), g = random_range(-100, 100);
        interval_set_si(&x, v, 0);
        MUST(rational_set_si(&q, v, 1));
        CHECK(interval_contains_rational(&x, &q), "set_si");
        random_interval(&x);
        if (interval_is_finite(&x)) {
            random_point_interval(&q, &x);
            MUST(interval_lower_grid(&m, &x, g));
            MUST(rational_set_integer_2exp(&r, &m, -g));
            CHECK(rational_cmp(&r, &q) <= 0, "lower_grid");
            MUST(interval_upper_grid(&m, &x, g));
            MUST(rational_set_integer_2exp(&r, &m, -g));
            CHECK(rational_cmp(&r, &q) >= 0, "upper_grid");
        }
        rational_clear(&q), rational_clear(&r);
        ball_clear(&b);
        integer_clear(&m);
    }
    test_end();
}

static void test_region(void)
{
    test_begin("interval-region");
    CHECK(interval_self_test(), "self test");
    volatile double one = 1, small = 0x1p-60;
    const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (int i = 0; i < 4; i++) {
        fesetround(modes[i]);
        volatile double before = one + small, before_minus = -one - small;
        CHECK(interval_self_test(), "self test in mode %d", i);
        interval_mode mode = interval_enter();
        volatile double inside = one + small;
        interval_mode inner = interval_enter();
        interval_leave(inner);
        volatile double still = one + small;
        interval_leave(mode);
        volatile double after = one + small, after_minus = -one - small;
        fesetround(FE_TONEAREST);
        CHECK(inside == 1 + DBL_EPSILON && still == 1 + DBL_EPSILON, "not upward in a region (mode %d)", i);
        CHECK(after == before && after_minus == before_minus, "mode %d is not restored", i);
    }
    test_end();
}

int main(void)
{
    test_region();
    test_add();
    test_sub();
    test_mul();
    test_div();
    test_min();
    test_max();
    test_hull();
    test_add_error();
    test_unary();
    test_conversions();
    return test_status();
}
