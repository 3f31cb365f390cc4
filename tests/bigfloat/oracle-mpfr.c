/* oracle-mpfr.c: functions of balls, and decimals, against MPFR at a higher precision.

   MPFR's value, rounded down and up with MORE more bits than ours, must lie in the ball; and where the operand is
   exact the ball's radius is at most 2^SLACK units of the precision asked for: relative to the value for roots, pi,
   arcs, decimals and for the sine of a small angle, absolute for other sines and cosines. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#include "tests/harness.h"

#ifndef HAVE_MPFR
int main(void)
{
    test_begin("oracle-mpfr");
    test_skip("built without MPFR");
    test_end();
    return test_status();
}
#else
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"

#define MORE 200
#define SLACK 3

/* Mostly short, up to `most` bits. */
static long random_bits(long most)
{
    long bits = most;
    for (uint64_t k = random_below(6); k > 0; k--)
        bits = bits / 4 > 2 ? bits / 4 : 2;
    return random_bool() ? bits : random_range(2, bits);
}

/* z = m 2^e exactly, with a precision that allows it. */
static void give_exactly(mpfr_t z, const integer *m, long e)
{
    char *text = integer_get_str(m, 16);
    mpfr_set_prec(z, (mpfr_prec_t)integer_bits(m) + 2);
    CHECK(text && mpfr_set_str(z, text, 16, MPFR_RNDN) == 0, "conversion");
    mpfr_mul_2si(z, z, e, MPFR_RNDN);
    free(text);
}

/* The ends of a finite ball; radius = err 2^e. */
static void ends(mpfr_t low, mpfr_t high, mpfr_t radius, const ball *x)
{
    integer m;
    uint64_t err;
    int64_t e;
    integer_init(&m);
    MUST(ball_get_parts(&m, &err, &e, x));
    MUST(integer_add_si(&m, &m, -(int64_t)err));
    give_exactly(low, &m, (long)e);
    MUST(integer_add_si(&m, &m, 2 * (int64_t)err));
    give_exactly(high, &m, (long)e);
    mpfr_set_ui_2exp(radius, (unsigned long)err, (long)e, MPFR_RNDN);
    integer_clear(&m);
}

static mpfr_t low, high, radius, down, up, point, point2, bound;

static void start(void)
{
    mpfr_inits2(128, low, high, radius, down, up, point, point2, bound, (mpfr_ptr)0);
}

static void stop(void)
{
    mpfr_clears(low, high, radius, down, up, point, point2, bound, (mpfr_ptr)0);
    mpfr_free_cache();
}

/* Is [down, up] in z? */
static bool holds(const ball *z)
{
    if (!ball_is_finite(z))
        return true;
    ends(low, high, radius, z);
    return mpfr_lessequal_p(low, down) && mpfr_lessequal_p(up, high);
}

/* After holds(z): radius <= 2^(SLACK - prec) |down|, or with 1 in place of |down|? */
static bool is_tight(const ball *z, long prec, bool relative)
{
    if (!ball_is_finite(z))
        return false;
    mpfr_set_ui(bound, 1, MPFR_RNDN);
    if (relative)
        mpfr_abs(bound, down, MPFR_RNDU);
    mpfr_mul_2si(bound, bound, SLACK - prec, MPFR_RNDU);
    return mpfr_lessequal_p(radius, bound);
}

static void verdict(const char *name, const ball *x, const ball *z, long prec, bool exact, bool relative)
{
    char *t = ball_get_hex(x);
    CHECK(ball_is_finite(z) || !exact, "%s(%s) at %ld bits is indeterminate", name, t, prec);
    CHECK(holds(z), "%s(%s) at %ld bits does not contain the value", name, t, prec);
    CHECK(!exact || is_tight(z, prec, relative), "%s(%s) at %ld bits is too wide", name, t, prec);
    free(t);
}

/* ---- functions of one ball ---- */

typedef int (*mpfr_function)(mpfr_t, const mpfr_t, mpfr_rnd_t);
typedef void (*ball_function)(ball *, const ball *, long);

static void evaluate(mpfr_function f, const mpfr_t x, long prec)
{
    mpfr_set_prec(down, prec + MORE);
    mpfr_set_prec(up, prec + MORE);
    f(down, x, MPFR_RNDD);
    f(up, x, MPFR_RNDU);
}

/* |x| about 2^top, with an error or without; e is x's exponent. */
static void random_operand(ball *x, integer *m, uint64_t *err, long *e, long top, bool positive, bool thin)
{
    do
        random_nonzero_integer(m, random_below(10) ? 4 : 160);
    while (!thin && integer_bits(m) < 40);
    if (positive)
        MUST(integer_abs(m, m));
    *err = thin ? 0 : random_below(4) ? random_below(100) : random_below((uint64_t)1 << BALL_ERROR_BITS);
    *e = top - (long)integer_bits(m);
    ball_set_parts(x, m, *err, *e);
}

static void compare_one(const char *name, ball_function f, mpfr_function g, long lowest, long highest, long most,
                        bool positive, bool relative)
{
    ball x, z;
    integer m;
    uint64_t err;
    long e, prec = random_bits(most), top = random_range(lowest, highest);
    bool thin = random_below(4) != 0;
    ball_init(&x), ball_init(&z), integer_init(&m);
    random_operand(&x, &m, &err, &e, top, positive, thin);
    f(&z, &x, prec);
    if (!thin) /* some number of the ball */
        MUST(integer_add_si(&m, &m, random_range(-(long)err, (long)err)));
    give_exactly(point, &m, e);
    evaluate(g, point, prec);
    verdict(name, &x, &z, prec, thin, relative || mpfr_get_exp(down) < -1);
    ball_clear(&x), ball_clear(&z), integer_clear(&m);
}

static void compare(const char *name, ball_function f, mpfr_function g, long lowest, long highest, long most, bool positive,
                    bool relative, long rounds)
{
    test_begin(name);
    for (test_cases(rounds); test_next();)
        compare_one(name, f, g, lowest, highest, most, positive, relative);
    test_end();
}

static void only_sine(ball *z, const ball *x, long prec)
{
    ball c;
    ball_init(&c);
    ball_sin_cos(z, &c, x, prec);
    ball_clear(&c);
}

static void only_cosine(ball *z, const ball *x, long prec)
{
    ball s;
    ball_init(&s);
    ball_sin_cos(&s, z, x, prec);
    ball_clear(&s);
}

static void test_atan2(void)
{
    test_begin("oracle-mpfr-atan2");
    for (test_cases(1000); test_next();) {
        ball x, y, z;
        integer m, n;
        uint64_t err;
        long e, f, prec = random_bits(1500);
        ball_init(&x), ball_init(&y), ball_init(&z), integer_init(&m), integer_init(&n);
        random_operand(&x, &m, &err, &e, random_range(-60, 60), false, true);
        random_operand(&y, &n, &err, &f, random_range(-60, 60), false, true);
        ball_atan2(&z, &y, &x, prec);
        give_exactly(point, &m, e), give_exactly(point2, &n, f);
        mpfr_set_prec(down, prec + MORE), mpfr_set_prec(up, prec + MORE);
        mpfr_atan2(down, point2, point, MPFR_RNDD);
        mpfr_atan2(up, point2, point, MPFR_RNDU);
        verdict("atan2", &x, &z, prec, true, false);
        ball_clear(&x), ball_clear(&y), ball_clear(&z), integer_clear(&m), integer_clear(&n);
    }
    test_end();
}

/* ---- pi and its multiples ---- */

static void test_pi(void)
{
    ball z;
    ball_init(&z);
    test_begin("oracle-mpfr-pi");
    for (long prec = 2; prec <= 10000; prec += prec < 600 ? 1 : prec / 7) {
        mpfr_set_prec(down, prec + MORE), mpfr_set_prec(up, prec + MORE);
        mpfr_const_pi(down, MPFR_RNDD);
        mpfr_const_pi(up, MPFR_RNDU);
        ball_pi(&z, prec);
        verdict("pi", &z, &z, prec, true, true);
    }
    ball_clear(&z);
    test_end();
}

/* Of pi p / q, whose bounds cost some of the MORE bits: the derivative is at most 1. */
static void multiple_of_pi(mpfr_function f, long p, long q, long prec)
{
    mpfr_set_prec(point, prec + MORE + 80);
    mpfr_const_pi(point, MPFR_RNDN);
    mpfr_mul_si(point, point, p, MPFR_RNDN);
    mpfr_div_si(point, point, q, MPFR_RNDN);
    evaluate(f, point, prec);
    mpfr_set_prec(bound, 64);
    mpfr_set_ui_2exp(bound, 1, -prec - MORE / 2, MPFR_RNDN);
    mpfr_sub(down, down, bound, MPFR_RNDD);
    mpfr_add(up, up, bound, MPFR_RNDU);
}

static void compare_multiple(const char *name, void (*f)(ball *, const rational *, long), mpfr_function g)
{
    test_begin(name);
    for (test_cases(1500); test_next();) {
        ball z;
        rational r;
        integer twelve;
        ball_init(&z), rational_init(&r), integer_init(&twelve);
        long prec = random_bits(4000), q = random_bool() ? random_range(1, 70) : random_range(1, 1000000);
        long p = random_range(-5 * q, 5 * q);
        MUST(rational_set_si(&r, p, q));
        f(&z, &r, prec);
        multiple_of_pi(g, p, q, prec);
        if (ball_is_thin(&z)) { /* 0, +-1/2 or +-1 */
            MUST(ball_mid_grid(&twelve, &z, 1));
            CHECK(integer_cmp_si(&twelve, 2) <= 0 && integer_cmp_si(&twelve, -2) >= 0, "%s(%ld/%ld) is thin", name, p, q);
            ends(low, high, radius, &z);
            CHECK(mpfr_lessequal_p(down, low) && mpfr_lessequal_p(low, up), "%s(%ld/%ld) is wrong", name, p, q);
        } else {
            CHECK(holds(&z), "%s(%ld/%ld) at %ld bits does not contain the value", name, p, q, prec);
            CHECK(is_tight(&z, prec, false), "%s(%ld/%ld) at %ld bits is too wide", name, p, q, prec);
        }
        ball_clear(&z), rational_clear(&r), integer_clear(&twelve);
    }
    test_end();
}

/* ---- decimals ---- */

static void random_decimal(char *text, long digits, long exponent)
{
    char *to = text;
    if (random_bool())
        *to++ = '-';
    long before = random_range(0, digits);
    for (long i = 0; i < digits; i++) {
        if (i == before)
            *to++ = '.';
        *to++ = (char)('0' + (random_below(3) ? random_below(10) : 9 * random_below(2)));
    }
    if (random_bool())
        to += sprintf(to, "%c%ld", random_bool() ? 'e' : 'E', exponent);
    *to = 0;
}

/* [down, up] = the decimal */
static void read_decimal(const char *text, long prec)
{
    mpfr_set_prec(down, prec), mpfr_set_prec(up, prec);
    CHECK(mpfr_set_str(down, text, 10, MPFR_RNDD) == 0 && mpfr_set_str(up, text, 10, MPFR_RNDU) == 0, "'%s' for MPFR", text);
}

static void test_reading(void)
{
    static char text[4000];
    test_begin("oracle-mpfr-reading");
    for (test_cases(2000); test_next();) {
        ball z;
        ball_init(&z);
        long prec = random_bits(8000);
        random_decimal(text, random_range(1, random_below(5) ? 40 : 3000), random_range(-400, 400));
        CHECK(ball_set_str(&z, text, strlen(text), prec) == RATIONAL_TEXT_OK, "'%s' is refused", text);
        read_decimal(text, prec + 12000);
        CHECK(holds(&z), "'%s' at %ld bits", text, prec);
        CHECK(is_tight(&z, prec, true), "'%s' at %ld bits is too wide", text, prec);
        ball_clear(&z);
    }
    test_end();
}

#define READ_BITS 14000 /* decimals are read so precisely; the operands have at most 10,300 bits */

/* "decimal" or "decimal +/- decimal" contains x, and its error is at most 2.5 times that of x and a unit of the last
   digit asked for. */
static void check_printed(const char *text, const ball *x, int digits)
{
    const char *sign = strstr(text, " +/- ");
    size_t n = sign ? (size_t)(sign - text) : strlen(text);
    char *middle = malloc(n + 1);
    mpfr_t e;
    memcpy(middle, text, n);
    middle[n] = 0;
    read_decimal(middle, READ_BITS);
    ends(low, high, radius, x);
    mpfr_init2(e, READ_BITS);
    mpfr_set_ui(e, 0, MPFR_RNDN);
    if (sign)
        CHECK(mpfr_set_str(e, sign + 5, 10, MPFR_RNDU) == 0, "error in '%s'", text);
    mpfr_sub(down, down, e, MPFR_RNDD);
    mpfr_add(up, up, e, MPFR_RNDU);
    CHECK(mpfr_lessequal_p(down, low), "'%s' has not the lower end", text);
    CHECK(mpfr_greaterequal_p(up, high), "'%s' has not the upper end", text);
    if (sign) { /* e <= 2.5 radius + 10^(1 - digits) |x| */
        mpfr_abs(bound, low, MPFR_RNDU);
        mpfr_set_ui(point, 10, MPFR_RNDN);
        mpfr_pow_si(point, point, 1 - digits, MPFR_RNDU);
        mpfr_mul(bound, bound, point, MPFR_RNDU);
        mpfr_mul_d(radius, radius, 2.5, MPFR_RNDU);
        mpfr_add(bound, bound, radius, MPFR_RNDU);
        CHECK(mpfr_lessequal_p(e, bound), "'%s' has too large an error", text);
    }
    mpfr_clear(e);
    free(middle);
}

static void test_printing(void)
{
    test_begin("oracle-mpfr-printing");
    for (test_cases(2000); test_next();) {
        ball x, z;
        integer m;
        uint64_t err;
        long e;
        ball_init(&x), ball_init(&z), integer_init(&m);
        random_operand(&x, &m, &err, &e, random_range(-300, 300), false, random_bool());
        int digits = (int)random_range(1, random_below(5) ? 30 : 800);
        char *text = ball_get_decimal(&x, digits);
        check_printed(text, &x, digits);
        CHECK(ball_set_str(&z, text, strlen(text), 12000) == RATIONAL_TEXT_OK && ball_contains(&z, &x), "reading '%s'", text);
        free(text);
        text = ball_get_str(&x);
        CHECK(ball_set_str(&z, text, strlen(text), 12000) == RATIONAL_TEXT_OK && ball_contains(&z, &x), "reading '%s'", text);
        if (!ball_is_thin(&x))
            check_printed(text, &x, 10000);
        free(text);
        ball_clear(&x), ball_clear(&z), integer_clear(&m);
    }
    test_end();
}

int main(void)
{
    start();
    test_pi();
    compare("oracle-mpfr-sqrt", ball_sqrt, mpfr_sqrt, -300, 300, 10000, true, true, 2000);
    compare("oracle-mpfr-sqr", ball_sqr, mpfr_sqr, -300, 300, 10000, false, true, 2000);
    compare("oracle-mpfr-sin", ball_sin, mpfr_sin, -80, 6, 3000, false, false, 2000);
    compare("oracle-mpfr-cos", ball_cos, mpfr_cos, -80, 6, 3000, false, false, 2000);
    compare("oracle-mpfr-sin-cos-sine", only_sine, mpfr_sin, -80, 6, 3000, false, false, 500);
    compare("oracle-mpfr-sin-cos-cosine", only_cosine, mpfr_cos, -80, 6, 3000, false, false, 500);
    compare("oracle-mpfr-sin-tiny", ball_sin, mpfr_sin, -2000, -80, 1000, false, false, 500);
    compare("oracle-mpfr-sin-large", ball_sin, mpfr_sin, 6, 300, 1500, false, false, 500);
    compare("oracle-mpfr-cos-large", ball_cos, mpfr_cos, 6, 300, 1500, false, false, 500);
    compare("oracle-mpfr-sin-10000", ball_sin, mpfr_sin, -10, 4, 10000, false, false, 30);
    compare("oracle-mpfr-cos-10000", ball_cos, mpfr_cos, -10, 4, 10000, false, false, 30);
    compare("oracle-mpfr-atan", ball_atan, mpfr_atan, -80, 80, 3000, false, true, 1500);
    compare("oracle-mpfr-atan-10000", ball_atan, mpfr_atan, -10, 10, 10000, false, true, 20);
    test_atan2();
    compare_multiple("oracle-mpfr-cos-pi", ball_cos_pi, mpfr_cos);
    compare_multiple("oracle-mpfr-sin-pi", ball_sin_pi, mpfr_sin);
    test_reading();
    test_printing();
    stop();
    return test_status();
}
#endif
