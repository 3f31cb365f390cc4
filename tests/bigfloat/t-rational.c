/* t-rational.c: field laws, order, powers and text of fractions. */
#include "bigfloat/rational.h"

#include <stdlib.h>
#include <string.h>

#include "random.h"

#define EQUAL(x, y) CHECK(rational_equal(&(x), &(y)) && is_normal(&(x)), "%s != %s", #x, #y)

static bool is_normal(const rational *x)
{
    integer g;
    integer_init(&g);
    bool ok = integer_gcd(&g, &x->numerator, &x->denominator) && integer_is_one(&g) && integer_sign(&x->denominator) > 0;
    integer_clear(&g);
    return ok;
}

static rational a, b, c, d, e;

static void setup(void)
{
    rational_init(&a), rational_init(&b), rational_init(&c), rational_init(&d), rational_init(&e);
}
static void teardown(void)
{
    rational_clear(&a), rational_clear(&b), rational_clear(&c), rational_clear(&d), rational_clear(&e);
}

static void test_field(void)
{
    test_begin("rational-field");
    for (test_cases(3000); test_next();) {
        setup();
        random_rational(&a, 3), random_rational(&b, 3), random_rational(&c, 2);
        /* (a + b) c = a c + b c */
        MUST(rational_add(&d, &a, &b));
        MUST(rational_mul(&d, &d, &c));
        MUST(rational_mul(&e, &a, &c));
        MUST(rational_mul(&a, &b, &c)); /* a = b c */
        MUST(rational_add(&e, &e, &a));
        EQUAL(d, e);
        MUST(rational_sub(&d, &d, &d));
        CHECK(rational_is_zero(&d), "x - x");
        if (!rational_is_zero(&c)) {
            MUST(rational_div(&d, &a, &c));
            EQUAL(d, b);
            MUST(rational_inv(&d, &c));
            MUST(rational_inv(&d, &d));
            EQUAL(d, c);
            MUST(rational_div(&d, &c, &c));
            CHECK(rational_cmp_si(&d, 1, 1) == 0, "x / x");
            long n = random_range(-5, 5);
            MUST(rational_pow(&d, &c, n));
            MUST(rational_pow(&e, &c, 5 - n));
            MUST(rational_mul(&d, &d, &e));
            MUST(rational_pow(&e, &c, 5));
            EQUAL(d, e);
        }
        long k = random_range(-100, 100);
        MUST(rational_mul_2exp(&d, &b, k));
        CHECK(is_normal(&d), "mul_2exp");
        MUST(rational_mul_2exp(&d, &d, -k));
        EQUAL(d, b);
        MUST(rational_neg(&d, &b));
        MUST(rational_abs(&e, &d));
        CHECK(rational_sign(&e) >= 0 && (rational_equal(&e, &b) || rational_equal(&e, &d)), "abs");
        teardown();
    }
    test_end();
}

static void test_order(void)
{
    test_begin("rational-order");
    for (test_cases(4000); test_next();) {
        setup();
        integer f;
        integer_init(&f);
        random_rational(&a, 4), random_rational(&b, 4);
        if (random_bool()) { /* neighbours */
            MUST(rational_set_si(&c, random_range(-1, 1), 1000000007));
            MUST(rational_add(&b, &a, &c));
        }
        MUST(rational_sub(&c, &a, &b));
        CHECK(rational_cmp(&a, &b) == rational_sign(&c), "cmp");
        CHECK(rational_cmp(&a, &a) == 0, "cmp with itself");
        long p = random_range(-20, 20), q = random_range(1, 20);
        MUST(rational_set_si(&c, p, q));
        CHECK(rational_cmp_si(&a, p, q) == rational_cmp(&a, &c), "cmp_si");
        MUST(rational_floor(&f, &a));
        MUST(rational_set_integer_2exp(&c, &f, 0));
        CHECK(rational_cmp(&c, &a) <= 0, "floor");
        MUST(integer_add_si(&f, &f, 1));
        MUST(rational_set_integer_2exp(&c, &f, 0));
        CHECK(rational_cmp(&c, &a) > 0, "floor");
        MUST(rational_ceil(&f, &a));
        MUST(rational_set_integer_2exp(&c, &f, 0));
        CHECK(rational_cmp(&c, &a) >= 0 && (rational_cmp(&c, &a) == 0) == rational_is_integer(&a), "ceil");
        double v = random_double();
        MUST(rational_set_double(&c, v));
        CHECK(rational_get_double_approx(&c) == v, "double %a", v);
        integer_clear(&f);
        teardown();
    }
    test_end();
}

static bool reads(const char *text, long p, long q)
{
    return rational_set_str(&a, text, strlen(text)) == RATIONAL_TEXT_OK && is_normal(&a) && rational_cmp_si(&a, p, q) == 0;
}

static void test_text(void)
{
    test_begin("rational-text");
    setup();
    CHECK(reads("12.5e-3", 1, 80), "12.5e-3");
    CHECK(reads("-.25", -1, 4) && reads("+3.", 3, 1) && reads("1E2", 100, 1) && reads("1e+2", 100, 1) && reads("-6/4", -3, 2), "forms");
    CHECK(reads("0.000", 0, 1) && reads("-0", 0, 1), "zero");
    static const char *bad[] = {"", ".", "-", "+-1", "1e", "1e+", "1.2.3", "e5", "1 ", " 1", "1/0", "1/-2", "1/", "/2", "0x1", "1e5x", "1.-2"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK(rational_set_str(&a, bad[i], strlen(bad[i])) == RATIONAL_TEXT_MALFORMED, "accepted '%s'", bad[i]);
    CHECK(rational_set_decimal(&a, "1e100001", 8) == RATIONAL_TEXT_EXPONENT_TOO_LARGE, "1e100001");
    CHECK(rational_set_decimal(&a, "1e-99999999999999999999", 23) == RATIONAL_TEXT_EXPONENT_TOO_LARGE, "1e-999...");
    CHECK(rational_set_decimal(&a, "1e1x0001", 8) == RATIONAL_TEXT_MALFORMED, "1e1x0001");
    teardown();
    for (test_cases(1000); test_next();) {
        setup();
        random_rational(&b, 4);
        char *text = rational_get_str(&b);
        CHECK(text && rational_set_str(&a, text, strlen(text)) == RATIONAL_TEXT_OK, "%s", text);
        EQUAL(a, b);
        free(text);
        teardown();
    }
    test_end();
}

int main(void)
{
    test_field();
    test_order();
    test_text();
    return test_status();
}
