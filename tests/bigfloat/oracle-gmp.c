/* oracle-gmp.c: integers and rationals against GMP (which comes with MPFR), up to 100,000 bits. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#include "tests/harness.h"

#ifndef HAVE_MPFR
int main(void)
{
    test_begin("oracle-gmp");
    test_skip("built without MPFR");
    test_end();
    return test_status();
}
#else
#include <gmp.h>
#include <stdlib.h>
#include <string.h>

#include "bigfloat/integer.h"
#include "bigfloat/rational.h"
#include "random.h"

/* ---- operands ---- */

#define MOST_LIMBS 1600 /* 100,000 bits and a few */

static uint64_t limb[MOST_LIMBS];

/* Few limbs most of the time; some around the lengths where algorithms change; rarely all there are. */
static size_t random_length(void)
{
    switch (random_below(16)) {
    case 0: return (size_t)random_below(MOST_LIMBS - 37);
    case 1: case 2: return (size_t)random_below(200);
    case 3: case 4: case 5: return 20 + (size_t)random_below(60);
    case 6: case 7: case 8: return (size_t)random_below(24);
    default: return (size_t)random_below(5);
    }
}

/* Patterns at which carries run and estimates of quotients fail. */
static size_t random_pattern(void)
{
    size_t n = random_length();
    random_limbs(limb, n);
    if (n == 0)
        return 0;
    switch (random_below(10)) {
    case 0: /* 2^(64 n) - 1 */
        memset(limb, 0xff, n * sizeof *limb);
        break;
    case 1: /* 2^k + d */
        memset(limb, 0, n * sizeof *limb);
        limb[n - 1] = (uint64_t)1 << random_below(64);
        limb[0] += random_below(3);
        break;
    case 2: /* 2^k - d */
        memset(limb, 0xff, n * sizeof *limb);
        limb[n - 1] >>= random_below(64);
        limb[0] -= random_below(3);
        break;
    case 3: /* equal high limbs */
        for (size_t i = n / 2; i < n; i++)
            limb[i] = limb[n - 1];
        break;
    case 4: /* high half 10...0 */
        for (size_t i = n / 2; i < n; i++)
            limb[i] = 0;
        limb[n - 1] = (uint64_t)1 << 63;
        break;
    case 5: /* low zeros */
        memset(limb, 0, (size_t)random_below(n) * sizeof *limb);
        break;
    }
    return n;
}

static void give(mpz_t z, const integer *x)
{
    mpz_import(z, (size_t)integer_length(x), -1, sizeof(uint64_t), 0, 0, integer_limbs(x));
    if (integer_sign(x) < 0)
        mpz_neg(z, z);
}

static void draw(integer *x, mpz_t m)
{
    size_t n = random_pattern();
    MUST(integer_set_limbs(x, limb, n, random_bool()));
    give(m, x);
}

static bool equal(const integer *x, const mpz_t m)
{
    static mpz_t t;
    if (!t->_mp_d)
        mpz_init(t);
    give(t, x);
    return mpz_cmp(t, m) == 0 && integer_sign(x) == mpz_sgn(m);
}

static integer x, y, z, w;
static mpz_t a, b, c, d;

static void start(void)
{
    integer_init(&x), integer_init(&y), integer_init(&z), integer_init(&w);
    mpz_inits(a, b, c, d, NULL);
}

static void stop(void)
{
    integer_clear(&x), integer_clear(&y), integer_clear(&z), integer_clear(&w);
    mpz_clears(a, b, c, d, NULL);
}

static void same(const char *name, const integer *ours, const mpz_t theirs)
{
    CHECK(equal(ours, theirs), "%s of %zu and %zu bits", name, mpz_sizeinbase(a, 2), mpz_sizeinbase(b, 2));
}

/* ---- integers ---- */

static void check_ring(void)
{
    draw(&x, a), draw(&y, b);
    if (random_below(8) == 0) { /* neighbours */
        MUST(integer_add_si(&y, &x, random_range(-1, 1)));
        give(b, &y);
    }
    MUST(integer_add(&z, &x, &y)), mpz_add(c, a, b), same("add", &z, c);
    MUST(integer_sub(&z, &x, &y)), mpz_sub(c, a, b), same("sub", &z, c);
    MUST(integer_mul(&z, &x, &y)), mpz_mul(c, a, b), same("mul", &z, c);
    draw(&w, d);
    MUST(integer_set(&z, &w)), mpz_set(c, d);
    MUST(integer_addmul(&z, &x, &y)), mpz_addmul(c, a, b), same("addmul", &z, c);
    MUST(integer_submul(&z, &x, &x)), mpz_submul(c, a, a), same("submul", &z, c);
    MUST(integer_sqr(&z, &x)), mpz_mul(c, a, a), same("sqr", &z, c);
    MUST(integer_mul(&x, &x, &x)), same("mul(x, x, x)", &x, c);
    give(a, &x);
    int64_t v = (int64_t)random_corner();
    MUST(integer_add_si(&z, &y, v)), mpz_set_si(c, v), mpz_add(c, b, c), same("add_si", &z, c);
    MUST(integer_mul_si(&z, &y, v)), mpz_mul_si(c, b, v), same("mul_si", &z, c);
    MUST(integer_neg(&z, &y)), mpz_neg(c, b), same("neg", &z, c);
    MUST(integer_abs(&z, &y)), mpz_abs(c, b), same("abs", &z, c);
}

static void check_order(void)
{
    draw(&x, a), draw(&y, b);
    if (random_bool()) {
        MUST(integer_add_si(&y, &x, random_range(-1, 1)));
        if (random_below(4) == 0)
            MUST(integer_neg(&y, &y));
        give(b, &y);
    }
    int s = mpz_cmp(a, b), t = mpz_cmpabs(a, b);
    CHECK(integer_cmp(&x, &y) == (s > 0) - (s < 0), "cmp");
    CHECK(integer_cmp_abs(&x, &y) == (t > 0) - (t < 0), "cmp_abs");
    int64_t v = random_bool() || !mpz_fits_slong_p(a) ? (int64_t)random_corner() : mpz_get_si(a);
    s = mpz_cmp_si(a, v);
    CHECK(integer_cmp_si(&x, v) == (s > 0) - (s < 0), "cmp_si");
    CHECK(integer_bits(&x) == (mpz_sgn(a) ? mpz_sizeinbase(a, 2) : 0), "bits");
    CHECK(integer_trailing_zeros(&x) == (mpz_sgn(a) ? mpz_scan1(a, 0) : 0), "trailing_zeros");
    CHECK(integer_fits_si(&x) == (mpz_fits_slong_p(a) != 0), "fits_si");
    if (integer_fits_si(&x))
        CHECK(integer_get_si(&x) == mpz_get_si(a), "get_si");
    CHECK(integer_is_zero(&x) == (mpz_sgn(a) == 0) && integer_is_one(&x) == (mpz_cmp_si(a, 1) == 0)
              && integer_is_odd(&x) == (mpz_odd_p(a) != 0),
          "is_zero, is_one or is_odd");
    if (mpz_sizeinbase(a, 2) < 1000) {
        double ours = integer_get_double_approx(&x), theirs = mpz_get_d(a), error = ours - theirs;
        CHECK((error < 0 ? -error : error) <= 0x1p-50 * (theirs < 0 ? -theirs : theirs), "get_double_approx");
    }
}

static void check_shifts(void)
{
    draw(&x, a);
    mpz_set_si(b, 0);
    unsigned long n = (unsigned long)random_below(random_bool() ? 130 : mpz_sizeinbase(a, 2) + 70);
    MUST(integer_mul_2exp(&z, &x, n)), mpz_mul_2exp(c, a, n), same("mul_2exp", &z, c);
    MUST(integer_fdiv_2exp(&z, &x, n)), mpz_fdiv_q_2exp(c, a, n), same("fdiv_2exp", &z, c);
    MUST(integer_cdiv_2exp(&z, &x, n)), mpz_cdiv_q_2exp(c, a, n), same("cdiv_2exp", &z, c);
    MUST(integer_fdiv_2exp(&x, &x, n)), mpz_fdiv_q_2exp(c, a, n), same("fdiv_2exp(x, x)", &x, c);
}

/* Also a dividend next to a multiple of the divisor. */
static void check_division(void)
{
    draw(&x, a);
    do
        draw(&y, b);
    while (mpz_sgn(b) == 0);
    if (random_below(3) == 0 && mpz_sizeinbase(b, 2) < 20000) {
        draw(&z, c);
        MUST(integer_mul(&x, &z, &y));
        MUST(integer_add_si(&x, &x, random_range(-1, 1)));
        give(a, &x);
    }
    MUST(integer_fdiv_qr(&z, &w, &x, &y));
    mpz_fdiv_qr(c, d, a, b), same("fdiv_qr: quotient", &z, c), same("fdiv_qr: remainder", &w, d);
    MUST(integer_fdiv_q(&z, &x, &y)), same("fdiv_q", &z, c);
    MUST(integer_fdiv_qr(NULL, &z, &x, &y)), same("fdiv_qr without quotient", &z, d);
    MUST(integer_cdiv_q(&z, &x, &y)), mpz_cdiv_q(c, a, b), same("cdiv_q", &z, c);
    MUST(integer_set(&z, &x)), MUST(integer_cdiv_q(&z, &z, &y)), same("cdiv_q(x, x, y)", &z, c);
    MUST(integer_set(&z, &y)), MUST(integer_cdiv_q(&z, &x, &z)), same("cdiv_q(y, x, y)", &z, c);
    if (mpz_sizeinbase(a, 2) < 50000) {
        MUST(integer_mul(&z, &x, &y));
        MUST(integer_divexact(&z, &z, &y)), same("divexact", &z, a);
    }
}

static void check_roots(void)
{
    draw(&x, a);
    mpz_abs(a, a), mpz_set_si(b, 0);
    MUST(integer_abs(&x, &x));
    if (random_bool()) { /* next to a square */
        MUST(integer_sqr(&x, &x));
        if (!integer_is_zero(&x))
            MUST(integer_add_si(&x, &x, random_range(-1, 1)));
        give(a, &x);
    }
    MUST(integer_sqrt_rem(&z, &w, &x));
    mpz_sqrtrem(c, d, a), same("sqrt_rem: root", &z, c), same("sqrt_rem: rest", &w, d);
    MUST(integer_sqrt_rem(&z, NULL, &x)), same("sqrt_rem without rest", &z, c);
    MUST(integer_sqrt(&x, &x)), same("sqrt(x, x)", &x, c);
}

static void check_gcd(void)
{
    draw(&x, a), draw(&y, b), draw(&w, d);
    if (mpz_sizeinbase(a, 2) + mpz_sizeinbase(b, 2) + mpz_sizeinbase(d, 2) > 8000)
        return;
    if (random_bool()) {
        MUST(integer_mul(&x, &x, &w)), MUST(integer_mul(&y, &y, &w));
        give(a, &x), give(b, &y);
    }
    MUST(integer_gcd(&z, &x, &y)), mpz_gcd(c, a, b), same("gcd", &z, c);
    MUST(integer_gcd(&x, &x, &y)), same("gcd(x, x, y)", &x, c);
}

static void check_pow(void)
{
    draw(&x, a);
    if (mpz_sizeinbase(a, 2) > 600)
        return;
    unsigned long n = (unsigned long)random_below(20);
    mpz_set_si(b, (long)n);
    MUST(integer_pow(&z, &x, n)), mpz_pow_ui(c, a, n), same("pow", &z, c);
}

static void check_text(void)
{
    draw(&x, a), mpz_set_si(b, 0);
    int base = random_bool() ? 10 : 16;
    char *ours = integer_get_str(&x, base), *theirs = mpz_get_str(NULL, base, a);
    CHECK(ours && strcmp(ours, theirs) == 0, "get_str of %zu bits in base %d", mpz_sizeinbase(a, 2), base);
    if (base == 16 && random_bool())
        for (char *p = theirs; *p; p++)
            *p = *p >= 'a' ? (char)(*p - 'a' + 'A') : *p;
    CHECK(integer_set_str(&z, theirs, strlen(theirs), base) == INTEGER_TEXT_OK, "set_str");
    same("set_str", &z, a);
    free(ours);
    free(theirs);
}

static const struct {
    const char *name;
    void (*check)(void);
    long rounds;
} integer_tests[] = {
    {"oracle-gmp-ring", check_ring, 3000},   {"oracle-gmp-order", check_order, 4000},
    {"oracle-gmp-shifts", check_shifts, 4000}, {"oracle-gmp-division", check_division, 3000},
    {"oracle-gmp-roots", check_roots, 1500}, {"oracle-gmp-gcd", check_gcd, 1500},
    {"oracle-gmp-pow", check_pow, 1500},     {"oracle-gmp-text", check_text, 600},
};

/* ---- rationals ---- */

static rational p, q, r;
static mpq_t f, g, h;

/* The same fraction, in lowest terms on our side too. */
static void same_fraction(const char *name, const rational *u, const mpq_t v)
{
    CHECK(equal(&u->numerator, mpq_numref(v)) && equal(&u->denominator, mpq_denref(v)), "%s", name);
}

static void draw_rational(rational *u, mpq_t v)
{
    do {
        draw(&x, a), draw(&y, b);
        if (random_below(4) == 0)
            integer_set_si(&y, 1), mpz_set_si(b, 1);
    } while (mpz_sgn(b) == 0 || mpz_sizeinbase(a, 2) > 3000 || mpz_sizeinbase(b, 2) > 3000);
    MUST(rational_set_integers(u, &x, &y));
    mpz_set(mpq_numref(v), a), mpz_set(mpq_denref(v), b);
    mpq_canonicalize(v);
}


static void check_rational(void)
{
    draw_rational(&p, f), draw_rational(&q, g);
    same_fraction("set_integers", &p, f);
    if (random_below(8) == 0) /* equal denominators, nearly equal numbers */
        MUST(rational_set(&q, &p)), MUST(integer_add_si(&q.numerator, &q.numerator, 0)), mpq_set(g, f);
    MUST(rational_add(&r, &p, &q)), mpq_add(h, f, g), same_fraction("add", &r, h);
    MUST(rational_sub(&r, &p, &q)), mpq_sub(h, f, g), same_fraction("sub", &r, h);
    MUST(rational_mul(&r, &p, &q)), mpq_mul(h, f, g), same_fraction("mul", &r, h);
    if (mpq_sgn(g)) {
        MUST(rational_div(&r, &p, &q)), mpq_div(h, f, g), same_fraction("div", &r, h);
        MUST(rational_inv(&r, &q)), mpq_inv(h, g), same_fraction("inv", &r, h);
    }
    MUST(rational_neg(&r, &p)), mpq_neg(h, f), same_fraction("neg", &r, h);
    MUST(rational_abs(&r, &p)), mpq_abs(h, f), same_fraction("abs", &r, h);
    int s = mpq_cmp(f, g);
    CHECK(rational_cmp(&p, &q) == (s > 0) - (s < 0) && rational_equal(&p, &q) == (s == 0), "cmp");
    int64_t u = random_range(-100, 100), v = random_range(1, 50);
    s = mpq_cmp_si(f, u, (unsigned long)v);
    CHECK(rational_cmp_si(&p, u, v) == (s > 0) - (s < 0), "cmp_si");
    long e = random_range(-300, 300);
    MUST(rational_mul_2exp(&r, &p, e));
    if (e >= 0)
        mpq_mul_2exp(h, f, (unsigned long)e);
    else
        mpq_div_2exp(h, f, (unsigned long)-e);
    same_fraction("mul_2exp", &r, h);
    MUST(rational_floor(&z, &p)), mpz_fdiv_q(c, mpq_numref(f), mpq_denref(f)), same("floor", &z, c);
    MUST(rational_ceil(&z, &p)), mpz_cdiv_q(c, mpq_numref(f), mpq_denref(f)), same("ceil", &z, c);
    CHECK(rational_is_integer(&p) == (mpz_cmp_si(mpq_denref(f), 1) == 0), "is_integer");
    char *ours = rational_get_str(&p), *theirs = mpq_get_str(NULL, 10, f);
    CHECK(strcmp(ours, theirs) == 0, "get_str");
    CHECK(rational_set_str(&r, theirs, strlen(theirs)) == RATIONAL_TEXT_OK && rational_equal(&r, &p), "set_str");
    free(ours);
    free(theirs);
}

static void check_pow_and_doubles(void)
{
    draw_rational(&p, f);
    long n = random_range(-6, 6);
    if (mpz_sizeinbase(mpq_numref(f), 2) < 500 && (n >= 0 || mpq_sgn(f))) {
        MUST(rational_pow(&r, &p, n));
        mpz_pow_ui(mpq_numref(h), mpq_numref(f), (unsigned long)labs(n));
        mpz_pow_ui(mpq_denref(h), mpq_denref(f), (unsigned long)labs(n));
        if (n < 0)
            mpq_inv(h, h);
        same_fraction("pow", &r, h);
    }
    double v = random_double();
    MUST(rational_set_double(&r, v)), mpq_set_d(h, v), same_fraction("set_double", &r, h);
}

int main(void)
{
    start();
    for (size_t i = 0; i < sizeof integer_tests / sizeof *integer_tests; i++) {
        test_begin(integer_tests[i].name);
        for (test_cases(integer_tests[i].rounds); test_next();)
            integer_tests[i].check();
        test_end();
    }
    rational_init(&p), rational_init(&q), rational_init(&r);
    mpq_inits(f, g, h, NULL);
    test_begin("oracle-gmp-rational");
    for (test_cases(2000); test_next();)
        check_rational();
    test_end();
    test_begin("oracle-gmp-rational-pow");
    for (test_cases(2000); test_next();)
        check_pow_and_doubles();
    test_end();
    rational_clear(&p), rational_clear(&q), rational_clear(&r);
    mpq_clears(f, g, h, NULL);
    stop();
    return test_status();
}
#endif
