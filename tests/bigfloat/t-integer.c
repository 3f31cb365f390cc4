/* t-integer.c: ring laws, division, shifts, roots, common divisors and text of integers. */
#include <stdlib.h>
#include <string.h>

#include "bigfloat/integer.h"
#include "random.h"

#define EQUAL(x, y) CHECK(integer_cmp(&(x), &(y)) == 0, "%s != %s", #x, #y)

static integer a, b, c, d, e, f;

static void setup(void)
{
    integer_init(&a), integer_init(&b), integer_init(&c), integer_init(&d), integer_init(&e), integer_init(&f);
}

static void teardown(void)
{
    integer_clear(&a), integer_clear(&b), integer_clear(&c), integer_clear(&d), integer_clear(&e), integer_clear(&f);
}

static size_t some_limbs(void) { return random_below(20) ? random_below(20) ? 6 : 70 : 300; }

typedef bool (*binary)(integer *, const integer *, const integer *);

/* op(z, x, y) with every aliasing gives the same. */
static void check_aliasing(const char *name, binary op)
{
    MUST(op(&c, &a, &b));
    MUST(integer_set(&d, &a));
    MUST(op(&d, &d, &b));
    CHECK(integer_cmp(&c, &d) == 0, "%s(x, x, y)", name);
    MUST(integer_set(&d, &b));
    MUST(op(&d, &a, &d));
    CHECK(integer_cmp(&c, &d) == 0, "%s(y, x, y)", name);
    MUST(op(&c, &a, &a));
    MUST(integer_set(&d, &a));
    MUST(op(&d, &d, &d));
    CHECK(integer_cmp(&c, &d) == 0, "%s(x, x, x)", name);
    MUST(integer_set(&e, &a));
    MUST(op(&d, &a, &e));
    CHECK(integer_cmp(&c, &d) == 0, "%s(z, x, x)", name);
}

static void test_ring(void)
{
    test_begin("integer-ring");
    for (test_cases(4000); test_next();) {
        setup();
        size_t n = some_limbs();
        random_integer(&a, n), random_integer(&b, n), random_integer(&e, n);
        MUST(integer_add(&c, &a, &b));
        MUST(integer_sub(&d, &c, &b));
        EQUAL(d, a);
        MUST(integer_sub(&d, &a, &c));
        MUST(integer_neg(&d, &d));
        EQUAL(d, b);
        /* (a + b) e = a e + b e */
        MUST(integer_mul(&c, &c, &e));
        MUST(integer_mul(&d, &a, &e));
        MUST(integer_mul(&f, &b, &e));
        MUST(integer_add(&d, &d, &f));
        EQUAL(c, d);
        /* (a + b)^2 - (a - b)^2 = 4 a b */
        MUST(integer_add(&c, &a, &b));
        MUST(integer_sqr(&c, &c));
        MUST(integer_sub(&d, &a, &b));
        MUST(integer_sqr(&d, &d));
        MUST(integer_sub(&c, &c, &d));
        MUST(integer_mul(&d, &a, &b));
        MUST(integer_mul_2exp(&d, &d, 2));
        EQUAL(c, d);
        MUST(integer_addmul(&e, &a, &b));
        MUST(integer_submul(&e, &a, &b));
        MUST(integer_addmul(&e, &e, &b));
        MUST(integer_submul(&e, &a, &e));
        check_aliasing("add", integer_add);
        check_aliasing("sub", integer_sub);
        check_aliasing("mul", integer_mul);
        check_aliasing("gcd", integer_gcd);
        teardown();
    }
    test_end();
}

static void test_products(void)
{
    test_begin("integer-products"); /* Karatsuba against schoolbook, all pairs of lengths about the thresholds */
    for (test_cases(150); test_next();) {
        setup();
        random_integer(&a, random_bool() ? 120 : 400), random_integer(&b, random_bool() ? 120 : 400);
        MUST(integer_mul(&c, &a, &b));
        integer_zero(&d);
        for (int i = 0; i < integer_length(&b); i++) {
            MUST(integer_mul_2exp(&d, &d, 64));
            integer_set_ui(&f, integer_limbs(&b)[integer_length(&b) - 1 - i]);
            MUST(integer_mul(&f, &f, &a));
            MUST(integer_add(&d, &d, &f));
        }
        if (integer_sign(&b) < 0)
            MUST(integer_neg(&d, &d));
        EQUAL(c, d);
        teardown();
    }
    test_end();
}

static void test_division(void)
{
    test_begin("integer-division");
    for (test_cases(4000); test_next();) {
        setup();
        size_t n = some_limbs();
        random_integer(&a, n), random_nonzero_integer(&b, random_bool() ? n : 3);
        MUST(integer_fdiv_qr(&c, &d, &a, &b));
        MUST(integer_mul(&e, &c, &b));
        MUST(integer_add(&e, &e, &d));
        EQUAL(e, a);
        CHECK(integer_cmp_abs(&d, &b) < 0 && (integer_is_zero(&d) || integer_sign(&d) == integer_sign(&b)), "remainder");
        MUST(integer_cdiv_q(&e, &a, &b));
        MUST(integer_sub(&e, &e, &c));
        CHECK(integer_cmp_si(&e, !integer_is_zero(&d)) == 0, "ceiling");
        MUST(integer_mul(&e, &a, &b));
        MUST(integer_divexact(&e, &e, &b));
        EQUAL(e, a);
        check_aliasing("fdiv_q", integer_is_zero(&a) ? integer_add : integer_fdiv_q);
        check_aliasing("cdiv_q", integer_is_zero(&a) ? integer_add : integer_cdiv_q);
        MUST(integer_set(&e, &a)), MUST(integer_set(&f, &b));
        MUST(integer_fdiv_qr(&c, &d, &a, &b));
        MUST(integer_fdiv_qr(&e, &f, &e, &f));
        EQUAL(c, e);
        EQUAL(d, f);
        teardown();
    }
    test_end();
}

/* Long quotients, built so that their digits are extreme: (q b + r) / b. */
static void test_long_division(void)
{
    test_begin("integer-long-division");
    for (test_cases(300); test_next();) {
        setup();
        random_integer(&a, 300), random_nonzero_integer(&b, random_bool() ? 300 : 120), random_integer(&c, 200);
        MUST(integer_abs(&a, &a));
        MUST(integer_abs(&b, &b));
        if (random_bool()) { /* all ones: quotients that must be corrected */
            integer_set_si(&a, 1);
            MUST(integer_mul_2exp(&a, &a, 64 * random_below(200)));
            MUST(integer_add_si(&a, &a, random_range(-1, 0)));
        }
        MUST(integer_fdiv_qr(NULL, &c, &c, &b)); /* 0 <= c < b */
        MUST(integer_mul(&d, &a, &b));
        MUST(integer_add(&d, &d, &c));
        MUST(integer_fdiv_qr(&e, &f, &d, &b));
        EQUAL(e, a);
        EQUAL(f, c);
        MUST(integer_fdiv_qr(NULL, &f, &d, &b));
        EQUAL(f, c);
        MUST(integer_fdiv_q(&e, &d, &b));
        EQUAL(e, a);
        teardown();
    }
    test_end();
}

static void test_shifts(void)
{
    test_begin("integer-shifts");
    for (test_cases(4000); test_next();) {
        setup();
        random_integer(&a, some_limbs());
        unsigned long n = random_below(300);
        integer_set_si(&b, 2);
        MUST(integer_pow(&b, &b, n));
        MUST(integer_mul_2exp(&c, &a, n));
        MUST(integer_mul(&d, &a, &b));
        EQUAL(c, d);
        MUST(integer_fdiv_2exp(&c, &a, n));
        MUST(integer_fdiv_q(&d, &a, &b));
        EQUAL(c, d);
        MUST(integer_cdiv_2exp(&c, &a, n));
        MUST(integer_cdiv_q(&d, &a, &b));
        EQUAL(c, d);
        MUST(integer_set(&c, &a)), MUST(integer_cdiv_2exp(&c, &c, n));
        EQUAL(c, d);
        MUST(integer_set(&c, &a)), MUST(integer_mul_2exp(&c, &c, n)), MUST(integer_fdiv_2exp(&c, &c, n));
        EQUAL(c, a);
        if (!integer_is_zero(&a)) {
            size_t z = integer_trailing_zeros(&a), bits = integer_bits(&a);
            MUST(integer_fdiv_2exp(&c, &a, z));
            CHECK(integer_is_odd(&c), "trailing zeros");
            MUST(integer_abs(&c, &a)), MUST(integer_fdiv_2exp(&c, &c, bits - 1));
            CHECK(integer_is_one(&c), "bits");
        }
        teardown();
    }
    test_end();
}

static void test_words(void)
{
    test_begin("integer-words");
    for (test_cases(4000); test_next();) {
        setup();
        int64_t v = (int64_t)random_corner();
        if (random_below(20) == 0)
            v = INT64_MIN;
        integer_set_si(&a, v);
        CHECK(integer_fits_si(&a) && integer_get_si(&a) == v && integer_cmp_si(&a, v) == 0, "get_si");
        CHECK(integer_sign(&a) == (v > 0) - (v < 0), "sign");
        random_integer(&b, 3);
        MUST(integer_mul_si(&c, &b, v)), MUST(integer_mul(&d, &b, &a));
        EQUAL(c, d);
        MUST(integer_add_si(&c, &b, v)), MUST(integer_add(&d, &b, &a));
        EQUAL(c, d);
        if (integer_fits_si(&b)) {
            integer_set_si(&c, integer_get_si(&b));
            EQUAL(b, c);
        }
        integer_set_ui(&c, (uint64_t)1 << 63);
        CHECK(!integer_fits_si(&c), "2^63 fits");
        teardown();
    }
    test_end();
}

static void test_gcd(void)
{
    test_begin("integer-gcd");
    for (test_cases(1500); test_next();) {
        setup();
        random_integer(&a, 8), random_integer(&b, 8), random_nonzero_integer(&c, 5);
        MUST(integer_gcd(&d, &a, &b));
        MUST(integer_mul(&e, &a, &c)), MUST(integer_mul(&f, &b, &c));
        MUST(integer_gcd(&e, &e, &f));
        MUST(integer_mul(&d, &d, &c)), MUST(integer_abs(&d, &d));
        EQUAL(d, e);
        if (!integer_is_zero(&e)) { /* a c / g and b c / g are prime to each other, by Euclid */
            MUST(integer_mul(&a, &a, &c)), MUST(integer_mul(&b, &b, &c));
            MUST(integer_fdiv_qr(&a, &f, &a, &e));
            CHECK(integer_is_zero(&f), "divides");
            MUST(integer_fdiv_qr(&b, &f, &b, &e));
            CHECK(integer_is_zero(&f), "divides");
            while (!integer_is_zero(&b)) {
                MUST(integer_fdiv_qr(NULL, &f, &a, &b));
                integer_swap(&a, &b), integer_swap(&b, &f);
            }
            MUST(integer_abs(&a, &a));
            CHECK(integer_is_one(&a), "not the greatest");
        }
        teardown();
    }
    test_end();
}

static void test_sqrt(void)
{
    test_begin("integer-sqrt");
    for (test_cases(3000); test_next();) {
        setup();
        random_integer(&a, some_limbs()), MUST(integer_abs(&a, &a));
        if (random_bool()) {
            MUST(integer_sqr(&a, &a));
            MUST(integer_add_si(&a, &a, random_range(-1, 1)));
            if (integer_sign(&a) < 0)
                integer_zero(&a);
        }
        MUST(integer_sqrt_rem(&b, &c, &a));
        MUST(integer_sqr(&d, &b)), MUST(integer_add(&d, &d, &c));
        EQUAL(d, a);
        MUST(integer_mul_2exp(&e, &b, 1));
        CHECK(integer_sign(&c) >= 0 && integer_cmp(&c, &e) <= 0, "remainder");
        MUST(integer_sqrt(&a, &a));
        EQUAL(a, b);
        teardown();
    }
    test_end();
}

static void test_text(void)
{
    test_begin("integer-text");
    for (test_cases(1000); test_next();) {
        setup();
        random_integer(&a, some_limbs());
        for (int base = 10; base <= 16; base += 6) {
            char *text = integer_get_str(&a, base);
            CHECK(text, "no memory");
            CHECK(text[0] != '0' || text[1] == 0, "leading zero: %s", text);
            CHECK(integer_set_str(&b, text, strlen(text), base) == INTEGER_TEXT_OK, "%s", text);
            EQUAL(a, b);
            free(text);
        }
        teardown();
    }
    setup();
    CHECK(integer_set_str(&a, "-007", 4, 10) == INTEGER_TEXT_OK && integer_cmp_si(&a, -7) == 0, "-007");
    CHECK(integer_set_str(&a, "fF", 2, 16) == INTEGER_TEXT_OK && integer_cmp_si(&a, 255) == 0, "fF");
    CHECK(integer_set_str(&a, "-0", 2, 10) == INTEGER_TEXT_OK && integer_is_zero(&a), "-0");
    static const char *bad[] = {"", "-", "1 ", "+1", "1a", "--1", "0x1", "1.0"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK(integer_set_str(&a, bad[i], strlen(bad[i]), 10) == INTEGER_TEXT_MALFORMED, "accepted '%s'", bad[i]);
    teardown();
    test_end();
}

int main(void)
{
    test_ring();
    test_products();
    test_division();
    test_long_division();
    test_shifts();
    test_words();
    test_gcd();
    test_sqrt();
    test_text();
    return test_status();
}
