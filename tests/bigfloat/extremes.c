/* extremes.c: the ends of all ranges: the whole line, exponents that no ball has, grids that do not exist, infinite
   doubles, malformed text. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bigfloat/ball.h"
#include "bigfloat/grid.h"
#include "bigfloat/interval.h"
#include "random.h"

/* ---- the whole line, in every system ---- */

/* w is the whole line, x = 2, and prec is 60. */
#define WHOLE_LINE(X)                                                                                             \
    static INTERVAL_NOINLINE void whole_line_##X##_cases(void)                                                    \
    {                                                                                                             \
        X w, x, y, z;                                                                                             \
        X##_init(&w), X##_init(&x), X##_init(&y), X##_init(&z);                                                   \
        X##_indeterminate(&w);                                                                                    \
        X##_set_si(&x, 2, 60);                                                                                    \
        X##_set_si(&y, -3, 60);                                                                                   \
        struct {                                                                                                  \
            const char *name;                                                                                     \
            void (*op)(X *, const X *, const X *, long);                                                          \
        } const binary[] = {{"add", X##_add}, {"sub", X##_sub}, {"mul", X##_mul}, {"div", X##_div},               \
                            {"hull", X##_hull}, {"add_error", X##_add_error}};                                    \
        for (size_t i = 0; i < sizeof binary / sizeof *binary; i++) {                                             \
            binary[i].op(&z, &w, &x, 60);                                                                         \
            CHECK(!X##_is_finite(&z) && !X##_lacks_memory(&z), "%s(whole line, 2)", binary[i].name);              \
            binary[i].op(&z, &x, &w, 60);                                                                         \
            CHECK(!X##_is_finite(&z) && !X##_lacks_memory(&z), "%s(2, whole line)", binary[i].name);              \
        }                                                                                                         \
        struct {                                                                                                  \
            const char *name;                                                                                     \
            void (*op)(X *, const X *, long);                                                                     \
        } const unary[] = {{"sqr", X##_sqr}, {"inv", X##_inv}, {"sqrt", X##_sqrt}, {"lower", X##_lower},          \
                           {"upper", X##_upper}, {"midpoint", X##_midpoint},                                      \
                           {"radius_upper", X##_radius_upper}, {"magnitude_upper", X##_magnitude_upper}};         \
        for (size_t i = 0; i < sizeof unary / sizeof *unary; i++) {                                               \
            unary[i].op(&z, &w, 60);                                                                              \
            CHECK(!X##_is_finite(&z) && !X##_lacks_memory(&z), "%s(whole line)", unary[i].name);                  \
        }                                                                                                         \
        X##_neg(&z, &w); CHECK(!X##_is_finite(&z), "neg");                                                        \
        X##_abs(&z, &w); CHECK(!X##_is_finite(&z), "abs");                                                        \
        X##_set(&z, &w); CHECK(!X##_is_finite(&z), "set");                                                        \
        X##_mul_si(&z, &w, 7, 60); CHECK(!X##_is_finite(&z), "mul_si");                                           \
        X##_div_si(&z, &w, 7, 60); CHECK(!X##_is_finite(&z), "div_si");                                           \
        X##_div_si(&z, &x, 0, 60); CHECK(!X##_is_finite(&z), "div_si by 0");                                      \
        X##_mul_2exp(&z, &w, 5, 60); CHECK(!X##_is_finite(&z), "mul_2exp");                                       \
        X##_set(&z, &x), X##_addmul(&z, &w, &y, 60); CHECK(!X##_is_finite(&z), "addmul");                         \
        X##_set(&z, &x), X##_submul(&z, &y, &w, 60); CHECK(!X##_is_finite(&z), "submul");                         \
        X##_min(&z, &w, &y, 60); CHECK(X##_contains(&z, &y), "min");                                              \
        X##_max(&z, &x, &w, 60); CHECK(X##_contains(&z, &x), "max");                                              \
        X##_intersection(&z, &w, &x, 60); CHECK(X##_contains(&x, &z) && X##_contains(&z, &x), "intersection");    \
        X##_intersection(&z, &x, &w, 60); CHECK(X##_contains(&x, &z) && X##_contains(&z, &x), "intersection");    \
        X##_intersection(&z, &w, &w, 60); CHECK(!X##_is_finite(&z), "intersection of whole lines");               \
        X##_intersection(&z, &x, &y, 60); CHECK(!X##_lacks_memory(&z), "empty intersection");                     \
        CHECK(X##_is_positive(&w) == TRUTH_UNKNOWN && X##_is_negative(&w) == TRUTH_UNKNOWN                        \
                  && X##_is_zero(&w) == TRUTH_UNKNOWN && X##_contains_zero(&w) && !X##_is_thin(&w),               \
              "signs of the whole line");                                                                         \
        CHECK(X##_less(&w, &x) == TRUTH_UNKNOWN && X##_less(&x, &w) == TRUTH_UNKNOWN, "less");                    \
        CHECK(X##_contains(&w, &x) && !X##_contains(&x, &w) && X##_contains(&w, &w), "contains");                 \
        CHECK(X##_contains_interior(&w, &x) && !X##_contains_interior(&x, &w), "contains_interior");              \
        CHECK(X##_lower_bound(&w) == -HUGE_VAL && X##_upper_bound(&w) == HUGE_VAL, "bounds");                     \
        CHECK(X##_mid_approx(&w) == 0 && X##_mid_approx(&x) == 2 && X##_mid_approx(&y) == -3, "mid_approx");      \
        X##_sub(&z, &x, &x, 60); CHECK(X##_is_zero(&z) == TRUTH_TRUE, "2 - 2");                                   \
        X##_sqr(&z, &y, 60), X##_add_error(&z, &z, &y, 60);                                                       \
        CHECK(X##_lower_bound(&z) == 6 && X##_upper_bound(&z) == 12, "9 +- 3");                                   \
        X##_clear(&w), X##_clear(&x), X##_clear(&y), X##_clear(&z);                                               \
    }                                                                                                             \
    static void whole_line_##X(void)                                                                              \
    {                                                                                                             \
        test_begin("extremes-whole-line-" #X);                                                                    \
        interval_mode mode = interval_enter();                                                                    \
        whole_line_##X##_cases();                                                                                 \
        interval_leave(mode);                                                                                     \
        test_end();                                                                                               \
    }                                                                                                             \
    static void outside_##X(void)                                                                                 \
    {                                                                                                             \
        X w, x;                                                                                                   \
        rational q;                                                                                               \
        integer m;                                                                                                \
        X##_init(&w), X##_init(&x), rational_init(&q), integer_init(&m);                                          \
        test_begin("extremes-conversions-" #X);                                                                   \
        X##_indeterminate(&w);                                                                                    \
        CHECK(X##_contains_rational(&w, &q), "contains_rational");                                                \
        CHECK(!X##_mid_grid(&m, &w, 0) && !X##_lower_grid(&m, &w, 0) && !X##_upper_grid(&m, &w, 0), "grids");     \
        char *text = X##_get_decimal(&w, 5);                                                                      \
        CHECK(text && strcmp(text, "indeterminate") == 0, "get_decimal");                                         \
        free(text);                                                                                               \
        X##_set_double(&x, 0.375, 60);                                                                            \
        text = X##_get_decimal(&x, 3);                                                                            \
        CHECK(text && strcmp(text, "0.375") == 0, "get_decimal: %s", text);                                       \
        free(text);                                                                                               \
        X##_set_double(&x, HUGE_VAL, 60); CHECK(!X##_is_finite(&x), "set_double(infinity)");                      \
        X##_set_double(&x, -HUGE_VAL, 60); CHECK(!X##_is_finite(&x), "set_double(-infinity)");                    \
        X##_set_double(&x, NAN, 60); CHECK(!X##_is_finite(&x), "set_double(NaN)");                                \
        X##_zero(&x); CHECK(X##_is_zero(&x) == TRUTH_TRUE, "zero");                                               \
        X##_one(&x);                                                                                              \
        MUST(X##_mid_grid(&m, &x, 3)); CHECK(integer_cmp_si(&m, 8) == 0, "one");                                  \
        X##_pi(&x, 60);                                                                                           \
        MUST(X##_lower_grid(&m, &x, 10)); CHECK(integer_cmp_si(&m, 3216) == 0, "pi");                             \
        MUST(X##_upper_grid(&m, &x, 10)); CHECK(integer_cmp_si(&m, 3217) == 0, "pi");                             \
        for (long p = -7; p <= 7; p++) { /* sin(pi p / 6) = cos(pi (p - 3) / 6) */                                \
            MUST(rational_set_si(&q, p, 6)), X##_sin_pi(&x, &q, 60);                                              \
            MUST(rational_set_si(&q, p - 3, 6)), X##_cos_pi(&w, &q, 60);                                          \
            CHECK(X##_contains(&x, &w) && X##_contains(&w, &x), "sin(pi %ld/6)", p);                              \
        }                                                                                                         \
        test_end();                                                                                               \
        X##_clear(&w), X##_clear(&x), rational_clear(&q), integer_clear(&m);                                      \
    }
WHOLE_LINE(ball)
WHOLE_LINE(grid)
WHOLE_LINE(interval)

/* ---- balls: exponents ---- */

static void power(ball *z, int64_t e, uint64_t err)
{
    integer one;
    integer_init(&one);
    integer_set_si(&one, 1);
    ball_set_parts(z, &one, err, e);
    integer_clear(&one);
}

static void expect_tiny(const char *name, const ball *z)
{
    ball limit, t;
    ball_init(&limit), ball_init(&t);
    power(&limit, -BALL_MAX_EXPONENT + 200, 0);
    ball_magnitude_upper(&t, z, 64);
    CHECK(ball_is_finite(z) && ball_contains_zero(z) && !ball_is_thin(z), "%s: not around 0", name);
    CHECK(ball_less(&t, &limit) == TRUTH_TRUE, "%s: not near 0", name);
    ball_clear(&limit), ball_clear(&t);
}

static void test_exponents(void)
{
    ball x, y, z;
    integer m;
    ball_init(&x), ball_init(&y), ball_init(&z), integer_init(&m);
    test_begin("extremes-exponents");
    for (uint64_t err = 0; err < 2; err++) {
        power(&x, BALL_MAX_EXPONENT, err / 2), power(&y, -BALL_MAX_EXPONENT, err);
        CHECK(ball_is_finite(&x) && ball_is_finite(&y), "the ends of the range");
        ball_mul(&z, &x, &x, 64); CHECK(!ball_is_finite(&z) && !ball_lacks_memory(&z), "large times large");
        ball_mul_2exp(&z, &x, 1, 64); CHECK(!ball_is_finite(&z), "twice the largest");
        ball_mul_2exp(&z, &x, LONG_MAX, 64); CHECK(!ball_is_finite(&z), "mul_2exp by the largest");
        ball_mul_2exp(&z, &x, LONG_MIN, 64), expect_tiny("mul_2exp by the least", &z);
        ball_mul(&z, &y, &y, 64), expect_tiny("small times small", &z);
        ball_sqr(&z, &y, 64), expect_tiny("square of a small one", &z);
        ball_mul_2exp(&z, &y, -1, 64), expect_tiny("half the least", &z);
        ball_div(&z, &y, &x, 64), expect_tiny("small by large", &z);
        ball_pow_ui(&z, &x, 5, 64); CHECK(!ball_is_finite(&z), "large^5");
        ball_add(&z, &x, &y, 64);
        CHECK(ball_contains(&z, &x) && ball_accuracy_bits_approx(&z) >= 62, "large plus small");
        ball_sub(&z, &y, &x, 64), ball_add(&z, &z, &x, 64); CHECK(ball_contains_zero(&z), "small minus large plus large");
        ball_lower(&z, &y, 64); CHECK(ball_less(&y, &z) != TRUTH_TRUE && ball_is_thin(&z), "lower of a small one");
        ball_upper(&z, &y, 64); CHECK(ball_less(&z, &y) != TRUTH_TRUE && ball_is_thin(&z), "upper of a small one");
        CHECK(ball_lower_bound(&x) == DBL_MAX && ball_upper_bound(&x) == HUGE_VAL, "a large one as doubles");
        CHECK(ball_upper_bound(&y) == 0x1p-1074 && ball_lower_bound(&y) == 0, "a small one as doubles");
        MUST(ball_lower_grid(&m, &y, 100)); CHECK(integer_is_zero(&m), "floor of a small one");
        MUST(ball_upper_grid(&m, &y, 100)); CHECK(integer_is_one(&m), "ceiling of a small one");
        CHECK(!ball_lower_grid(&m, &x, 0), "a large one as an integer");
        char *text = ball_get_decimal(&x, 10); /* too long a decimal: the exact form */
        CHECK(text && ball_set_hex(&z, text, strlen(text)) == RATIONAL_TEXT_OK && ball_identical(&z, &x), "text of a large one");
        free(text);
        text = ball_get_str(&y);
        CHECK(text && ball_set_hex(&z, text, strlen(text)) == RATIONAL_TEXT_OK && ball_identical(&z, &y), "text of a small one");
        free(text);
    }
    /* the limbs of the fast paths: full mantissas */
    for (int n = 1; n <= 5; n++) {
        integer_set_si(&m, 1);
        MUST(integer_mul_2exp(&m, &m, 64 * (unsigned long)n)), MUST(integer_add_si(&m, &m, -1));
        ball_set_parts(&x, &m, 1, BALL_MAX_EXPONENT - 5), ball_mul(&z, &x, &x, 64 * n);
        CHECK(!ball_is_finite(&z), "large times large, %d limbs", n);
        ball_set_parts(&y, &m, 1, -BALL_MAX_EXPONENT + 5), ball_mul(&z, &y, &y, 64 * n);
        expect_tiny("small times small, full limbs", &z);
        ball_set_parts(&x, &m, 1, BALL_MAX_EXPONENT), ball_add(&z, &x, &x, 64 * n);
        CHECK(!ball_is_finite(&z), "large plus large, %d limbs", n);
        ball_neg(&y, &x), ball_add(&z, &x, &y, 64 * n);
        CHECK(ball_contains_zero(&z), "large minus large, %d limbs", n);
        ball_dot(&z, &x, &x, 1, 64 * n); CHECK(!ball_is_finite(&z), "dot of large ones, %d limbs", n);
    }
    ball_set_si(&x, 1, 2), ball_set_si(&y, 3, 2), ball_div(&z, &x, &y, 1); /* below the least precision */
    ball_mul_si(&z, &z, 3, 64);
    CHECK(ball_contains(&z, &x), "one bit");
    CHECK(ball_accuracy_bits_approx(&x) == LONG_MAX, "accuracy of 1");
    ball_indeterminate(&x); CHECK(ball_accuracy_bits_approx(&x) == LONG_MIN, "accuracy of the whole line");
    CHECK(ball_overlaps(&x, &y) && ball_overlaps(&y, &x), "overlaps");
    ball_clear(&x), ball_clear(&y), ball_clear(&z), integer_clear(&m);
    test_end();
}

/* ---- functions of everything ---- */

static bool is_within(const ball *x, double low, double high)
{
    return ball_is_finite(x) && ball_lower_bound(x) >= low && ball_upper_bound(x) <= high;
}

static void test_functions(void)
{
    ball x, y, s, c;
    ball_init(&x), ball_init(&y), ball_init(&s), ball_init(&c);
    test_begin("extremes-functions");
    ball_indeterminate(&x);
    ball_sin_cos(&s, &c, &x, 64); CHECK(is_within(&s, -1, 1) && is_within(&c, -1, 1), "sine of the whole line");
    CHECK(ball_lower_bound(&s) == -1 && ball_upper_bound(&s) == 1 && ball_lower_bound(&c) == -1, "less than [-1, 1]");
    ball_atan(&s, &x, 64); CHECK(is_within(&s, -2, 2), "atan of the whole line");
    CHECK(ball_lower_bound(&s) <= -1.5708 && ball_upper_bound(&s) >= 1.5708, "less than (-pi/2, pi/2)");
    ball_one(&y), ball_atan2(&s, &x, &y, 64); CHECK(!ball_is_finite(&s) || is_within(&s, -4, 4), "atan2 of the whole line");
    ball_atan2(&s, &y, &x, 64); CHECK(!ball_is_finite(&s) || is_within(&s, -4, 4), "atan2 of the whole line");
    ball_zero(&x), ball_atan2(&s, &x, &x, 64); CHECK(!ball_is_finite(&s), "atan2(0, 0)");
    ball_sin_cos(&s, &c, &x, 64);
    CHECK(ball_is_zero(&s) == TRUTH_TRUE && ball_is_thin(&c) && is_within(&c, 1, 1), "sine and cosine of 0");
    ball_atan(&s, &x, 64); CHECK(ball_is_zero(&s) == TRUTH_TRUE, "atan 0");
    power(&x, (int64_t)1 << 39, 0), ball_sin_cos(&s, &c, &x, 64);
    CHECK(is_within(&s, -1, 1) && is_within(&c, -1, 1), "sine of a large number");
    ball_atan(&s, &x, 64); CHECK(is_within(&s, 1.5707, 1.5708), "atan of a large number");
    power(&x, -((int64_t)1 << 39), 0), ball_sin_cos(&s, &c, &x, 64);
    CHECK(ball_contains(&s, &x) && ball_accuracy_bits_approx(&s) > 60 && is_within(&c, 0.9999, 1.0001), "sine of a small number");
    ball_atan(&s, &x, 64); CHECK(ball_overlaps(&s, &x) && ball_accuracy_bits_approx(&s) > 60, "atan of a small number");
    power(&x, 0, 100), ball_sin_cos(&s, &c, &x, 64);
    CHECK(ball_is_finite(&s) && ball_lower_bound(&s) <= -1 && ball_upper_bound(&s) >= 1, "sine of [-99, 101]");
    ball_set_si(&x, -4, 64), ball_sqrt(&s, &x, 64); CHECK(!ball_is_finite(&s), "sqrt(-4)");
    ball_zero(&x), ball_sqrt(&s, &x, 64); CHECK(ball_is_zero(&s) == TRUTH_TRUE, "sqrt(0)");
    power(&x, 0, 1), ball_sqrt(&s, &x, 64); CHECK(ball_contains_zero(&s) && ball_upper_bound(&s) >= 1.4142, "sqrt of [0, 2]");
    ball_zero(&x), ball_pow_si(&s, &x, 0, 64); CHECK(is_within(&s, 1, 1), "0^0");
    ball_pow_si(&s, &x, -1, 64); CHECK(!ball_is_finite(&s), "0^-1");
    ball_dot(&s, &x, &y, 0, 64); CHECK(ball_is_zero(&s) == TRUTH_TRUE, "empty dot product");
    ball_indeterminate(&x), ball_dot(&s, &x, &y, 1, 64); CHECK(!ball_is_finite(&s), "dot with the whole line");
    ball_clear(&x), ball_clear(&y), ball_clear(&s), ball_clear(&c);
    test_end();
}

/* ---- grids that do not exist, numbers out of reach ---- */

static void test_grids(void)
{
    grid x, z;
    integer m, n;
    rational q;
    ball b;
    const long beyond = GRID_MAX_EXPONENT + 1;
    grid_init(&x), grid_init(&z), integer_init(&m), integer_init(&n), rational_init(&q), ball_init(&b);
    test_begin("extremes-grids");
    grid_one(&x), integer_set_si(&m, 1);
    MUST(rational_set_si(&q, 1, 3));
    for (int sign = -1; sign <= 1; sign += 2) {
        long g = sign * beyond;
        grid_set_si(&z, 1, g); CHECK(!grid_is_finite(&z), "set_si");
        grid_set_rational(&z, &q, g); CHECK(!grid_is_finite(&z), "set_rational");
        grid_set_double(&z, 1, g); CHECK(!grid_is_finite(&z), "set_double");
        grid_set_integer_2exp(&z, &m, 0, g); CHECK(!grid_is_finite(&z), "set_integer_2exp");
        grid_set_endpoints(&z, &m, &m, g); CHECK(!grid_is_finite(&z), "set_endpoints");
        ball_one(&b), grid_set_ball(&z, &b, g); CHECK(!grid_is_finite(&z), "set_ball");
        grid_set_round(&z, &x, g); CHECK(!grid_is_finite(&z), "set_round");
        grid_add(&z, &x, &x, g); CHECK(!grid_is_finite(&z), "add");
        grid_mul(&z, &x, &x, g); CHECK(!grid_is_finite(&z), "mul");
        grid_mul_si(&z, &x, 2, g); CHECK(!grid_is_finite(&z), "mul_si");
        grid_inv(&z, &x, g); CHECK(!grid_is_finite(&z), "inv");
        grid_pi(&z, g); CHECK(!grid_is_finite(&z), "pi");
        grid_cos_pi(&z, &q, g); CHECK(!grid_is_finite(&z), "cos_pi");
        MUST(rational_set_si(&q, 1, 7)), grid_sin_pi(&z, &q, g); CHECK(!grid_is_finite(&z), "sin_pi");
    }
    integer_set_si(&n, 0);
    grid_set_endpoints(&z, &m, &n, 5); CHECK(!grid_is_finite(&z), "endpoints in the wrong order");
    grid_set_integer_2exp(&z, &m, LONG_MAX, 0); CHECK(!grid_is_finite(&z), "2^LONG_MAX");
    grid_set_integer_2exp(&z, &n, LONG_MAX, 0); CHECK(grid_is_zero(&z) == TRUTH_TRUE, "0 2^LONG_MAX");
    grid_set_integer_2exp(&z, &m, LONG_MIN + 1, 0);
    CHECK(grid_lower_bound(&z) == 0 && grid_upper_bound(&z) == 1, "2^-LONG_MAX");
    grid_mul_2exp(&z, &x, LONG_MAX, 0); CHECK(!grid_is_finite(&z), "1 2^LONG_MAX");
    grid_mul_2exp(&z, &x, -LONG_MAX, 0);
    CHECK(grid_lower_bound(&z) == 0 && grid_upper_bound(&z) == 1, "1 2^-LONG_MAX");
    grid_neg(&z, &x), grid_mul_2exp(&z, &z, -LONG_MAX, 4);
    CHECK(grid_lower_bound(&z) == -0.0625 && grid_upper_bound(&z) == 0, "-1 2^-LONG_MAX");
    grid_zero(&z), grid_mul_2exp(&z, &z, LONG_MAX, 3); CHECK(grid_is_zero(&z) == TRUTH_TRUE, "0 2^LONG_MAX");
    grid_pi(&z, -3); CHECK(grid_lower_bound(&z) == 0 && grid_upper_bound(&z) == 8, "pi in eighths upside down");
    MUST(rational_set_si(&q, 1, 6)), grid_sin_pi(&z, &q, 1);
    CHECK(grid_lower_bound(&z) == 0.5 && grid_upper_bound(&z) == 0.5, "sin(pi/6)");
    grid_sin_pi(&z, &q, 0); CHECK(grid_lower_bound(&z) == 0 && grid_upper_bound(&z) == 1, "sin(pi/6) in integers");
    grid_indeterminate(&x), ball_set_grid(&b, &x, 64); CHECK(!ball_is_finite(&b) && !ball_lacks_memory(&b), "ball_set_grid");
    CHECK(!grid_get_endpoints(&m, &n, &x, 3), "get_endpoints");
    grid_set_ball(&z, &b, 3); CHECK(!grid_is_finite(&z) && grid_identical(&x, &z), "the whole line there and back");
    grid_clear(&x), grid_clear(&z), integer_clear(&m), integer_clear(&n), rational_clear(&q), ball_clear(&b);
    test_end();
}

/* ---- intervals of doubles that are none ---- */

static void test_intervals(void)
{
    static const double bad[][2] = {{1, 0}, {NAN, 1}, {1, NAN}, {NAN, NAN}, {HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    interval x;
    test_begin("extremes-intervals");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        interval_set_doubles(&x, bad[i][0], bad[i][1]);
        CHECK(!interval_is_finite(&x) && interval_contains_zero(&x), "[%g, %g]", bad[i][0], bad[i][1]);
    }
    interval_set_si(&x, LONG_MAX, 0);
    CHECK(interval_lower_bound(&x) < 0x1p63 && interval_upper_bound(&x) == 0x1p63, "LONG_MAX");
    interval_set_si(&x, LONG_MIN, 0);
    CHECK(interval_lower_bound(&x) == -0x1p63 && interval_upper_bound(&x) == -0x1p63, "LONG_MIN");
    interval_pi(&x, 0);
    CHECK(interval_lower_bound(&x) == 0x1.921fb54442d18p1 && interval_upper_bound(&x) == 0x1.921fb54442d19p1, "pi");
    test_end();
}

/* ---- text ---- */

static void test_ball_text(void)
{
    static const char *const bad_str[] = {"", " ", "1 +/-", "1 +/- ", "1 +/- x", "x +/- 1", "1+/-1", "1 +/- 1 ", "Indeterminate",
                                          "1e", "--1", "1 +/- 1 +/- 1", "inf", "nan", "1/2"};
    static const char *const bad_hex[] = {"", "0x1", "0x1 0x2", "0x1 0x2 ", "0x1 0x2 3 ", "0x1 0x2 3 4", "0x1  0x2 3", " 0x1 0x2 3",
                                          "1 0x2 3", "0x1 2 3", "0x1 0x2 0x3", "0x1 -0x2 3", "0x 0x2 3", "0x-1 0x2 3", "-0x-1 0x2 3",
                                          "0x1 0x40000000 3", "0x1 0x2 99999999999999", "0x1 0x2 99999999999999999999999", "0xg 0x2 3",
                                          "0x1 0x2 x", "indeterminat", "indeterminate "};
    ball x, z;
    ball_init(&x), ball_init(&z);
    test_begin("extremes-text-of-balls");
    for (size_t i = 0; i < sizeof bad_str / sizeof *bad_str; i++)
        CHECK(ball_set_str(&z, bad_str[i], strlen(bad_str[i]), 64) == RATIONAL_TEXT_MALFORMED, "set_str takes '%s'", bad_str[i]);
    for (size_t i = 0; i < sizeof bad_hex / sizeof *bad_hex; i++)
        CHECK(ball_set_hex(&z, bad_hex[i], strlen(bad_hex[i])) == RATIONAL_TEXT_MALFORMED, "set_hex takes '%s'", bad_hex[i]);
    CHECK(ball_set_str(&z, "1e100001", 8, 64) == RATIONAL_TEXT_EXPONENT_TOO_LARGE, "1e100001");
    CHECK(ball_set_str(&z, "1 +/- 1e-100001", 15, 64) == RATIONAL_TEXT_EXPONENT_TOO_LARGE, "1 +/- 1e-100001");
    CHECK(ball_set_str(&z, "indeterminate", 13, 64) == RATIONAL_TEXT_OK && !ball_is_finite(&z), "indeterminate");
    ball_zero(&z);
    CHECK(ball_set_hex(&z, "indeterminate", 13) == RATIONAL_TEXT_OK && !ball_is_finite(&z), "indeterminate, exact form");
    char *text = ball_get_str(&z), *exact = ball_get_hex(&z);
    CHECK(strcmp(text, "indeterminate") == 0 && strcmp(exact, "indeterminate") == 0, "writing the whole line");
    free(text), free(exact);
    ball_zero(&z), text = ball_get_str(&z), exact = ball_get_decimal(&z, 0);
    CHECK(strcmp(text, "0") == 0 && strcmp(exact, "0") == 0, "writing 0");
    free(text), free(exact);
    CHECK(ball_set_hex(&z, "0x3fffffff 0x3fffffff -1099511627776", 37 - 1) == RATIONAL_TEXT_OK, "the least exponent");
    power(&x, 0, 0), ball_div_si(&x, &x, -3, 64);
    for (int digits = -1; digits <= 25; digits++) {
        text = ball_get_decimal(&x, digits);
        CHECK(ball_set_str(&z, text, strlen(text), 128) == RATIONAL_TEXT_OK && ball_contains(&z, &x), "-1/3 in %d digits: '%s'", digits, text);
        free(text);
    }
    ball_clear(&x), ball_clear(&z);
    test_end();
}

static void test_rational_text(void)
{
    static const char *const bad[] = {"", "-", "+", ".", "-.", "e5", ".e5", "1e", "1e+", "1e-", "1e5x", "1e5.0", "1.2.3", " 1", "1 ", "+-1",
                                      "--1", "1-", "0x1", "1,5", "inf", "nan", "1e 5", "\0011"};
    static const char *const bad_fraction[] = {"1/0", "1/-2", "/2", "1/", "1/2/3", "1.5/2", "1/2.0", "1e5/2", "1 / 2", "x/2", "1/x", "/"};
    static const struct {
        const char *text;
        long p, q;
    } good[] = {{"+1", 1, 1},      {"1.", 1, 1},         {".5", 1, 2},         {"-.25", -1, 4}, {"-0", 0, 1},     {"007", 7, 1},
                {"1E2", 100, 1},   {"1e+2", 100, 1},     {"25e-2", 1, 4},      {"0e99999", 0, 1}, {"-12.50", -25, 2}, {"00.10", 1, 10}},
      good_fraction[] = {{"3/4", 3, 4}, {"-6/4", -3, 2}, {"0/5", 0, 1}, {"10/1", 10, 1}, {"0.75", 3, 4}, {"-7", -7, 1}};
    rational x;
    rational_init(&x);
    test_begin("extremes-text-of-rationals");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK(rational_set_decimal(&x, bad[i], strlen(bad[i])) == RATIONAL_TEXT_MALFORMED, "set_decimal takes '%s'", bad[i]);
        CHECK(rational_set_str(&x, bad[i], strlen(bad[i])) == RATIONAL_TEXT_MALFORMED, "set_str takes '%s'", bad[i]);
    }
    for (size_t i = 0; i < sizeof bad_fraction / sizeof *bad_fraction; i++) {
        CHECK(rational_set_str(&x, bad_fraction[i], strlen(bad_fraction[i])) == RATIONAL_TEXT_MALFORMED, "set_str takes '%s'", bad_fraction[i]);
        CHECK(rational_set_decimal(&x, bad_fraction[i], strlen(bad_fraction[i])) == RATIONAL_TEXT_MALFORMED, "set_decimal takes '%s'",
              bad_fraction[i]);
    }
    CHECK(rational_set_decimal(&x, "1\0002", 3) == RATIONAL_TEXT_MALFORMED, "a zero byte");
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        CHECK(rational_set_decimal(&x, good[i].text, strlen(good[i].text)) == RATIONAL_TEXT_OK && rational_cmp_si(&x, good[i].p, good[i].q) == 0,
              "set_decimal('%s')", good[i].text);
    for (size_t i = 0; i < sizeof good_fraction / sizeof *good_fraction; i++)
        CHECK(rational_set_str(&x, good_fraction[i].text, strlen(good_fraction[i].text)) == RATIONAL_TEXT_OK
                  && rational_cmp_si(&x, good_fraction[i].p, good_fraction[i].q) == 0,
              "set_str('%s')", good_fraction[i].text);
    static const char *const large[] = {"1e100001", "1e-100001", "1e99999999999999999999999999", "-1.5E-18446744073709551617"};
    for (size_t i = 0; i < sizeof large / sizeof *large; i++)
        CHECK(rational_set_decimal(&x, large[i], strlen(large[i])) == RATIONAL_TEXT_EXPONENT_TOO_LARGE, "set_decimal takes '%s'", large[i]);
    CHECK(rational_set_decimal(&x, "1e-100000", 9) == RATIONAL_TEXT_OK, "1e-100000");
    rational_clear(&x);
    test_end();
}

int main(void)
{
    whole_line_ball(), outside_ball();
    whole_line_grid(), outside_grid();
    whole_line_interval(), outside_interval();
    test_exponents();
    test_functions();
    test_grids();
    test_intervals();
    test_ball_text();
    test_rational_text();
    return test_status();
}
