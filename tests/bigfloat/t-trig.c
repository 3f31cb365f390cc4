/* t-trig.c: pi, sine and cosine: known digits, identities, agreement across precisions and systems. */
#include "bigfloat/ball.h"

#include <math.h>

#include "random.h"

/* floor(pi 2^256) = 4 * (0.C90FDAA2...): digits from the first words of SHA-free literature, RFC 3526. */
static const char pi_hex[] = "3243f6a8885a308d313198a2e03707344a4093822299f31d0082efa98ec4e6c89";

static void test_pi(void)
{
    test_begin("trig-pi");
    integer m, n;
    ball x, y;
    integer_init(&m), integer_init(&n);
    ball_init(&x), ball_init(&y);
    CHECK(integer_set_str(&m, pi_hex, sizeof pi_hex - 1, 16) == INTEGER_TEXT_OK, "digits");
    ball_pi(&x, 300);
    MUST(ball_lower_grid(&n, &x, 256));
    CHECK(integer_cmp(&m, &n) == 0, "pi to 256 bits, lower");
    MUST(ball_upper_grid(&n, &x, 256));
    MUST(integer_add_si(&n, &n, -1));
    CHECK(integer_cmp(&m, &n) == 0, "pi to 256 bits, upper");
    ball_pi(&y, 3000);
    for (long prec = 2; prec < 2900; prec += 1 + prec / 7) {
        ball_pi(&x, prec);
        CHECK(ball_contains(&x, &y), "pi at %ld bits", prec);
        CHECK(ball_accuracy_bits_approx(&x) >= prec - 2, "pi at %ld bits is poor", prec);
    }
    integer_clear(&m), integer_clear(&n);
    ball_clear(&x), ball_clear(&y);
    test_end();
}

/* The table of pi against Machin's series, which serves precisions beyond it. */
static void test_table(void)
{
    test_begin("trig-pi-table");
    ball x, y;
    ball_init(&x), ball_init(&y);
    ball_pi(&y, 4000);
    for (long prec = 64; prec < 2700; prec += 64) {
        ball_pi(&x, prec);
        CHECK(ball_contains(&x, &y), "pi at %ld bits", prec);
        CHECK(x.error <= 2, "pi at %ld bits: error %d", prec, (int)x.error);
    }
    ball_clear(&x), ball_clear(&y);
    test_end();
}

static void test_cos_pi(void)
{
    test_begin("trig-cos-pi");
    for (test_cases(1000); test_next();) {
        ball c, s, t, one;
        rational r, q;
        ball_init(&c), ball_init(&s), ball_init(&t), ball_init(&one);
        rational_init(&r), rational_init(&q);
        if (random_bool())
            MUST(rational_set_si(&r, random_range(-50, 50), random_range(1, 24)));
        else
            random_rational(&r, 2);
        long prec = random_precision(600);
        ball_cos_pi(&c, &r, prec), ball_sin_pi(&s, &r, prec);
        CHECK(ball_accuracy_bits_approx(&c) >= prec - 3 && ball_accuracy_bits_approx(&s) >= prec - 3, "accuracy");
        /* c^2 + s^2 = 1 */
        ball_sqr(&t, &c, prec), ball_addmul(&t, &s, &s, prec);
        ball_one(&one);
        CHECK(ball_contains(&t, &one), "c^2 + s^2");
        /* cos(2 a) = 1 - 2 s^2 */
        MUST(rational_mul_2exp(&q, &r, 1));
        ball_sqr(&t, &s, prec), ball_mul_2exp(&t, &t, 1, prec), ball_sub(&t, &one, &t, prec);
        ball_cos_pi(&s, &q, prec);
        CHECK(ball_overlaps(&s, &t), "doubling");
        /* against libm */
        double d = rational_get_double_approx(&r);
        if (fabs(d) < 100)
            CHECK(fabs(ball_mid_approx(&c) - cos(3.14159265358979323846 * d)) < 1e-12, "libm cos(pi %g)", d);
        /* higher precision is inside */
        ball_cos_pi(&t, &r, prec + 200);
        CHECK(ball_overlaps(&c, &t), "precisions differ");
        grid g, h;
        grid_init(&g), grid_init(&h);
        long e = random_range(-3, 200);
        grid_cos_pi(&g, &r, e);
        ball_cos_pi(&t, &r, 1000);
        grid_set_ball(&h, &t, e);
        CHECK(grid_identical(&g, &h), "grid");
        grid_clear(&g), grid_clear(&h);
        interval x;
        interval_cos_pi(&x, &r, 0);
        ball_set_interval(&c, &x, 64);
        CHECK(ball_overlaps(&c, &t) && x.upper <= nextafter(nextafter(-x.neg_lower, 2), 2), "interval");
        ball_clear(&c), ball_clear(&s), ball_clear(&t), ball_clear(&one);
        rational_clear(&r), rational_clear(&q);
    }
    test_end();
}

static void test_niven(void)
{
    test_begin("trig-niven");
    ball c;
    rational r, v;
    ball_init(&c);
    rational_init(&r), rational_init(&v);
    static const int twice_cos[12] = {2, 9, 1, 0, -1, 9, -2, 9, -1, 0, 1, 9}; /* of pi j / 6; 9: irrational */
    for (int j = -36; j <= 36; j++) {
        int k = ((j % 12) + 12) % 12, l = (((3 - j) % 12) + 12) % 12;
        MUST(rational_set_si(&r, j, 6));
        ball_cos_pi(&c, &r, 64);
        MUST(rational_set_si(&v, twice_cos[k], 2));
        CHECK(ball_is_thin(&c) == (twice_cos[k] != 9), "cos thin %d", j);
        CHECK(twice_cos[k] == 9 || ball_contains_rational(&c, &v), "cos %d", j);
        ball_sin_pi(&c, &r, 64);
        MUST(rational_set_si(&v, twice_cos[l], 2));
        CHECK(ball_is_thin(&c) == (twice_cos[l] != 9), "sin thin %d", j);
        CHECK(twice_cos[l] == 9 || ball_contains_rational(&c, &v), "sin %d", j);
    }
    ball_clear(&c);
    rational_clear(&r), rational_clear(&v);
    test_end();
}

/* sin and cos of a ball contain those of a point of it, computed much more precisely. */
static void test_sin_cos(void)
{
    test_begin("trig-sin-cos");
    for (test_cases(1000); test_next();) {
        ball x, y, s, c, u, v;
        rational p;
        ball_init(&x), ball_init(&y), ball_init(&s), ball_init(&c), ball_init(&u), ball_init(&v);
        rational_init(&p);
        random_ball(&x, 4);
        if (random_below(4))
            ball_mul_2exp(&x, &x, -ball_accuracy_bits_approx(&x) / 2 * 0 - (long)(x.exponent) - random_range(0, 260), 300);
        random_point_ball(&p, &x);
        ball_set_rational(&y, &p, 1500);
        long prec = random_precision(300);
        ball_sin_cos(&s, &c, &x, prec);
        ball_sin_cos(&u, &v, &y, 900);
        CHECK(ball_overlaps(&s, &u) && ball_overlaps(&c, &v), "sin cos");
        if (ball_is_thin(&x) && x.size)
            CHECK(ball_accuracy_bits_approx(&s) >= prec - 5, "accuracy of sin");
        ball_set(&u, &x), ball_sin(&u, &u, prec), ball_sin(&v, &x, prec);
        CHECK(ball_identical(&u, &v) && ball_overlaps(&u, &s), "alias");
        ball_set(&u, &x), ball_sin_cos(&v, &u, &u, prec);
        CHECK(ball_identical(&u, &c) && ball_identical(&v, &s), "alias of both");
        ball_clear(&x), ball_clear(&y), ball_clear(&s), ball_clear(&c), ball_clear(&u), ball_clear(&v);
        rational_clear(&p);
    }
    test_end();
}

/* Identities at high precision, and arguments next to multiples of pi/2. */
static void test_high_precision(void)
{
    test_begin("trig-high-precision");
    for (test_cases(60); test_next();) {
        ball x, s, c, t, one;
        rational q;
        ball_init(&x), ball_init(&s), ball_init(&c), ball_init(&t), ball_init(&one);
        rational_init(&q);
        long prec = random_below(4) ? random_range(64, 3000) : 10000;
        if (random_bool()) { /* near q pi / 2 */
            ball_pi(&x, random_bool() ? 100 : prec);
            ball_midpoint(&x, &x, prec);
            ball_mul_si(&x, &x, random_range(-1000, 1000), 20000);
            ball_mul_2exp(&x, &x, -1, 20000);
        } else {
            random_rational(&q, 2);
            ball_set_rational(&x, &q, prec);
            ball_midpoint(&x, &x, prec);
        }
        ball_sin_cos(&s, &c, &x, prec);
        CHECK(x.size == 0 || (ball_accuracy_bits_approx(&s) >= prec - 4 && ball_accuracy_bits_approx(&c) >= prec - 4), "accuracy %ld %ld at %ld",
              ball_accuracy_bits_approx(&s), ball_accuracy_bits_approx(&c), prec);
        ball_sqr(&t, &c, prec), ball_addmul(&t, &s, &s, prec);
        ball_one(&one);
        CHECK(ball_contains(&t, &one) && ball_accuracy_bits_approx(&t) >= prec - 8, "c^2 + s^2 at %ld bits", prec);
        /* sin 2x = 2 s c */
        ball_mul_2exp(&x, &x, 1, prec), ball_mul(&t, &s, &c, prec), ball_mul_2exp(&t, &t, 1, prec);
        ball_sin(&s, &x, prec);
        CHECK(ball_overlaps(&s, &t), "sin 2x at %ld bits", prec);
        ball_clear(&x), ball_clear(&s), ball_clear(&c), ball_clear(&t), ball_clear(&one);
        rational_clear(&q);
    }
    test_end();
}

int main(void)
{
    test_high_precision();
    test_pi();
    test_table();
    test_niven();
    test_cos_pi();
    test_sin_cos();
    return test_status();
}
