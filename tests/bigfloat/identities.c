/* identities.c: relations between functions at 10,000 bits, where any wrong digit anywhere shows.

   Both sides of an identity enclose the same number, so their difference contains 0; and it is narrow, or the test
   would say nothing. */
#include <stdlib.h>
#include <string.h>

#include "bigfloat/ball.h"
#include "random.h"

#define BITS 10000
#define LOSS 40 /* bits that a few operations may lose */

static ball x, y, z, s, c, t, u;

static void each(void (*f)(ball *))
{
    ball *all[] = {&x, &y, &z, &s, &c, &t, &u};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        f(all[i]);
}

/* Does a - b contain 0, in a radius below 2^(size - BITS + LOSS)?  a and b are about 2^size. */
static void expect_equal(const char *name, const ball *a, const ball *b, long size)
{
    static ball difference, radius, limit;
    ball_sub(&difference, a, b, BITS);
    CHECK(ball_is_finite(a) && ball_is_finite(b), "%s: indeterminate", name);
    CHECK(ball_contains_zero(&difference), "%s: different", name);
    ball_radius_upper(&radius, &difference, 64);
    ball_set_si(&limit, 1, 64);
    ball_mul_2exp(&limit, &limit, size - BITS + LOSS, 64);
    CHECK(ball_less(&radius, &limit) == TRUTH_TRUE, "%s: too wide to tell", name);
    ball_clear(&difference), ball_clear(&radius), ball_clear(&limit);
}

/* Full mantissa, |b| about 2^size; exact, or with an error of one unit. */
static void draw(ball *b, long size, bool exact)
{
    uint64_t limb[BITS / 64 + 1];
    const size_t n = sizeof limb / sizeof *limb;
    integer m;
    integer_init(&m);
    random_limbs(limb, n);
    limb[n - 1] |= (uint64_t)1 << 63;
    MUST(integer_set_limbs(&m, limb, n, random_bool()));
    ball_set_parts(b, &m, !exact, size - (long)integer_bits(&m));
    integer_clear(&m);
}

static void test_ring(void)
{
    test_begin("identities-ring");
    for (test_cases(20); test_next();) {
        bool exact = random_bool();
        draw(&x, 0, exact), draw(&y, 0, exact);
        ball_add(&s, &x, &y, BITS), ball_sub(&c, &x, &y, BITS), ball_mul(&z, &s, &c, BITS);
        ball_sqr(&t, &x, BITS), ball_sqr(&u, &y, BITS), ball_sub(&u, &t, &u, BITS);
        expect_equal("(x + y)(x - y) = x^2 - y^2", &z, &u, 2);
        ball_div(&z, &x, &y, BITS), ball_mul(&z, &z, &y, BITS);
        expect_equal("x / y y = x", &z, &x, 3);
        ball_inv(&z, &y, BITS), ball_mul(&z, &z, &y, BITS), ball_one(&u);
        expect_equal("1 / y y = 1", &z, &u, 2);
        ball_pow_ui(&z, &s, 3, BITS); /* (x + y)^3 = x^3 + 3 x y (x + y) + y^3 */
        ball_pow_ui(&u, &x, 3, BITS), ball_mul(&t, &x, &y, BITS), ball_mul(&t, &t, &s, BITS);
        ball_mul_si(&t, &t, 3, BITS), ball_add(&u, &u, &t, BITS), ball_pow_ui(&t, &y, 3, BITS), ball_add(&u, &u, &t, BITS);
        expect_equal("(x + y)^3", &z, &u, 4);
        ball_pow_si(&z, &x, -2, BITS), ball_sqr(&u, &x, BITS), ball_inv(&u, &u, BITS);
        expect_equal("x^-2", &z, &u, 6);
        ball pair[2], swapped[2];
        ball_init(&pair[0]), ball_init(&pair[1]), ball_init(&swapped[0]), ball_init(&swapped[1]);
        ball_set(&pair[0], &x), ball_set(&pair[1], &y);
        ball_set(&swapped[0], &y), ball_neg(&swapped[1], &x);
        ball_dot(&z, pair, swapped, 2, BITS), ball_zero(&u);
        expect_equal("(x, y) . (y, -x) = 0", &z, &u, 1);
        ball_dot(&z, pair, pair, 2, BITS);
        ball_sqr(&t, &x, BITS), ball_sqr(&u, &y, BITS), ball_add(&u, &t, &u, BITS);
        expect_equal("(x, y) . (x, y) = x^2 + y^2", &z, &u, 1);
        for (int i = 0; i < 2; i++)
            ball_clear(&pair[i]), ball_clear(&swapped[i]);
    }
    test_end();
}

static void test_root(void)
{
    test_begin("identities-sqrt");
    for (test_cases(20); test_next();) {
        draw(&x, random_range(0, 1), random_bool());
        ball_abs(&x, &x);
        ball_sqrt(&z, &x, BITS), ball_sqr(&z, &z, BITS);
        expect_equal("sqrt(x)^2 = x", &z, &x, 2);
        draw(&y, 0, true), ball_abs(&y, &y);
        ball_mul(&t, &x, &y, BITS), ball_sqrt(&t, &t, BITS);
        ball_sqrt(&s, &x, BITS), ball_sqrt(&c, &y, BITS), ball_mul(&u, &s, &c, BITS);
        expect_equal("sqrt(x y) = sqrt(x) sqrt(y)", &t, &u, 1);
    }
    test_end();
}

static void test_trigonometry(void)
{
    test_begin("identities-sin-cos");
    for (test_cases(6); test_next();) {
        draw(&x, random_range(-3, 5), random_bool());
        ball_sin_cos(&s, &c, &x, BITS);
        ball_sqr(&t, &s, BITS), ball_sqr(&u, &c, BITS), ball_add(&z, &t, &u, BITS), ball_one(&u);
        expect_equal("sin^2 + cos^2 = 1", &z, &u, 8);
        ball_mul_si(&y, &x, 2, BITS), ball_sin(&t, &y, BITS), ball_mul(&u, &s, &c, BITS), ball_mul_2exp(&u, &u, 1, BITS);
        expect_equal("sin 2 x = 2 sin x cos x", &t, &u, 8);
        draw(&y, 1, true), ball_add(&t, &x, &y, BITS), ball_cos(&z, &t, BITS);
        ball_cos(&t, &y, BITS), ball_mul(&c, &c, &t, BITS), ball_sin(&t, &y, BITS), ball_mul(&s, &s, &t, BITS);
        ball_sub(&u, &c, &s, BITS);
        expect_equal("cos(x + y)", &z, &u, 8);
    }
    test_end();
}

/* T_n(cos t) = cos n t for t = pi p / q, and T_q(cos(2 pi p / q)) = 1. */
static void test_chebyshev(void)
{
    rational r;
    rational_init(&r);
    test_begin("identities-chebyshev");
    for (test_cases(6); test_next();) {
        long q = random_range(3, 30), p = random_range(1, q), n = random_range(2, 30);
        MUST(rational_set_si(&r, p, q));
        ball_cos_pi(&x, &r, BITS);
        ball_one(&s), ball_set(&c, &x); /* T_0, T_1 */
        for (long k = 2; k <= n; k++) {
            ball_mul(&t, &x, &c, BITS), ball_mul_2exp(&t, &t, 1, BITS), ball_sub(&t, &t, &s, BITS);
            ball_swap(&s, &c), ball_swap(&c, &t);
        }
        MUST(rational_set_si(&r, n * p, q));
        ball_cos_pi(&u, &r, BITS);
        static ball difference;
        ball_sub(&difference, &c, &u, BITS);
        CHECK(ball_contains_zero(&difference), "T_%ld(cos(pi %ld/%ld))", n, p, q);
        CHECK(ball_accuracy_bits_approx(&c) > BITS - 200 || ball_contains_zero(&u), "T_%ld: too wide to tell", n);
        ball_clear(&difference);
    }
    rational_clear(&r);
    test_end();
}

/* pi = 16 atan(1/5) - 4 atan(1/239) = 48 atan(1/18) + 32 atan(1/57) - 20 atan(1/239) = 4 atan 1, and half the angle
   of (0, 1). */
static void arc(ball *z_, long times, long of)
{
    ball_set_si(&y, 1, BITS), ball_div_si(&y, &y, of, BITS + 64);
    ball_atan(&y, &y, BITS + 64), ball_mul_si(&y, &y, times, BITS + 64);
    ball_add(z_, z_, &y, BITS);
}

static void test_pi(void)
{
    test_begin("identities-pi");
    ball_pi(&x, BITS);
    ball_zero(&z), arc(&z, 16, 5), arc(&z, -4, 239);
    expect_equal("Machin", &x, &z, 4);
    ball_zero(&z), arc(&z, 48, 18), arc(&z, 32, 57), arc(&z, -20, 239);
    expect_equal("Gauss", &x, &z, 4);
    ball_zero(&z), arc(&z, 4, 1);
    expect_equal("4 atan 1", &x, &z, 4);
    ball_one(&t), ball_zero(&u), ball_atan2(&z, &t, &u, BITS), ball_mul_2exp(&z, &z, 1, BITS);
    expect_equal("2 atan2(1, 0)", &x, &z, 4);
    ball_neg(&t, &t), ball_atan2(&z, &u, &t, BITS);
    expect_equal("atan2(0, -1)", &x, &z, 4);
    ball_sin(&z, &x, BITS), ball_zero(&u);
    expect_equal("sin pi", &z, &u, 4);
    ball_cos(&z, &x, BITS), ball_one(&u), ball_neg(&u, &u);
    expect_equal("cos pi", &z, &u, 4);
    test_end();
}

static void test_atan(void)
{
    test_begin("identities-atan");
    for (test_cases(4); test_next();) {
        draw(&x, random_range(-2, 1), random_bool());
        ball_atan(&y, &x, BITS), ball_sin_cos(&s, &c, &y, BITS), ball_div(&z, &s, &c, BITS);
        expect_equal("tan(atan x) = x", &z, &x, 8);
        ball_inv(&t, &x, BITS), ball_atan(&t, &t, BITS), ball_add(&t, &t, &y, BITS), ball_abs(&t, &t);
        ball_pi(&u, BITS), ball_mul_2exp(&u, &u, -1, BITS);
        expect_equal("atan x + atan(1/x) = pi/2", &t, &u, 8);
    }
    test_end();
}

/* 2 cos(pi/3) = 1, 2 cos(pi/4)^2 = 1, 2 cos(pi/5) = golden ratio, 4 cos(pi/6)^2 = 3, and 4 sin(pi/10) = sqrt 5 - 1. */
static void test_angles(void)
{
    rational r;
    rational_init(&r);
    test_begin("identities-angles");
    ball_set_si(&t, 5, BITS), ball_sqrt(&t, &t, BITS), ball_one(&u);
    ball_add(&x, &t, &u, BITS), ball_mul_2exp(&x, &x, -1, BITS); /* golden ratio */
    MUST(rational_set_si(&r, 1, 3)), ball_cos_pi(&z, &r, BITS), ball_mul_2exp(&z, &z, 1, BITS);
    CHECK(ball_is_thin(&z), "cos(pi/3) is exact");
    expect_equal("cos(pi/3)", &z, &u, 0);
    ball_pi(&y, BITS), ball_div_si(&y, &y, 3, BITS), ball_cos(&z, &y, BITS), ball_mul_2exp(&z, &z, 1, BITS);
    expect_equal("cos of a third of pi", &z, &u, 0);
    MUST(rational_set_si(&r, 1, 4)), ball_cos_pi(&z, &r, BITS), ball_sqr(&z, &z, BITS), ball_mul_2exp(&z, &z, 1, BITS);
    expect_equal("cos(pi/4)", &z, &u, 0);
    MUST(rational_set_si(&r, 1, 5)), ball_cos_pi(&z, &r, BITS), ball_mul_2exp(&z, &z, 1, BITS);
    expect_equal("cos(pi/5)", &z, &x, 0);
    MUST(rational_set_si(&r, 1, 6)), ball_cos_pi(&z, &r, BITS), ball_sqr(&z, &z, BITS), ball_mul_2exp(&z, &z, 2, BITS);
    ball_set_si(&y, 3, BITS);
    expect_equal("cos(pi/6)", &z, &y, 2);
    MUST(rational_set_si(&r, 1, 10)), ball_sin_pi(&z, &r, BITS), ball_mul_2exp(&z, &z, 2, BITS);
    ball_sub(&y, &t, &u, BITS);
    expect_equal("sin(pi/10)", &z, &y, 2);
    rational_clear(&r);
    test_end();
}

static void test_text(void)
{
    test_begin("identities-text");
    for (test_cases(10); test_next();) {
        draw(&x, random_range(-3000, 3000), random_bool());
        char *text = ball_get_hex(&x);
        CHECK(ball_set_hex(&y, text, strlen(text)) == RATIONAL_TEXT_OK && ball_identical(&x, &y), "exact form");
        free(text);
        text = ball_get_str(&x);
        CHECK(ball_set_str(&y, text, strlen(text), 4 * BITS) == RATIONAL_TEXT_OK && ball_contains(&y, &x), "shortest decimal");
        free(text);
        text = ball_get_decimal(&x, 3000);
        CHECK(ball_set_str(&y, text, strlen(text), 4 * BITS) == RATIONAL_TEXT_OK && ball_contains(&y, &x), "3000 digits");
        CHECK(ball_accuracy_bits_approx(&y) > 9900, "3000 digits are worth %ld bits", ball_accuracy_bits_approx(&y));
        free(text);
    }
    test_end();
}

int main(void)
{
    each(ball_init);
    test_ring();
    test_root();
    test_trigonometry();
    test_chebyshev();
    test_pi();
    test_atan();
    test_angles();
    test_text();
    each(ball_clear);
    return test_status();
}
