/* t-fixed-trig.c: the fixed-point layer under pi, sine, cosine and arc tangent: each stated bound against the same
   function with more limbs; then the balls, from 2 to 10,000 bits, against identities and themselves. */
#include "bigfloat/fraction.h"

#include "random.h"

#define MOST 40 /* limbs */

/* |a - b| <= err 2^k ulp for drafts a with n limbs and b with N > n, whose own error is negligible? */
static bool agree(const draft *a, size_t n, const draft *b, size_t N)
{
    limb_t x[MOST + 8], bound[MOST + 8];
    limb_zero(x, N - n);
    limb_copy(x + N - n, a->w, n + 1);
    if (a->negative == b->negative) {
        if (limb_compare(x, b->w, N + 1) < 0)
            limb_sub_n(x, b->w, x, N + 1);
        else
            limb_sub_n(x, x, b->w, N + 1);
    } else
        limb_add_n(x, x, b->w, N + 1);
    limb_zero(bound, N + 1);
    size_t shift = 64 * (N - n) + (size_t)a->k;
    if (shift / 64 + 2 > N + 1)
        return true; /* nothing is claimed */
    bound[shift / 64] = a->err;
    bound[shift / 64 + 1] = limb_shift_left(bound + shift / 64, bound + shift / 64, 1, (unsigned)(shift % 64));
    return limb_compare(x, bound, N + 1) <= 0;
}

static size_t random_length(void) { return (size_t)(random_below(4) ? random_range(1, 6) : random_range(1, MOST - 4)); }

/* x < 2^-64 n of limit / 2^64, sometimes with leading zeros or corners; exactly representable */
static void random_angle(limb_t *w, size_t n, limb_t limit)
{
    if (random_bool())
        random_limbs(w, n);
    else
        for (size_t i = 0; i < n; i++)
            w[i] = random_word();
    w[n] = 0;
    w[n - 1] %= limit;
    if (random_below(4) == 0)
        fraction_shift_right(w, w, n, random_below(64 * n < 200 ? 64 * n : 200));
}

/* the same number with N limbs */
static void extend(limb_t *to, size_t N, const limb_t *w, size_t n)
{
    limb_zero(to, N - n);
    limb_copy(to + N - n, w, n + 1);
}

static void test_product(void)
{
    test_begin("fixed-product");
    for (test_cases(3000); test_next();) {
        limb_t a[64], b[64], z[64], p[128], full[128];
        size_t n = (size_t)random_range(1, 60);
        random_limbs(a, n), random_limbs(b, n);
        MUST(fraction_mul(z, a, b, n, p));
        MUST(limb_multiply(full, a, n, b, n));
        limb_t borrow = limb_sub_n(full + n, full + n, z, n);
        CHECK(borrow == 0 && full[n] <= 1 && limb_normal(full + n + 1, n - 1) == 0, "product of %d limbs", (int)n);
        MUST(fraction_square(z, a, n, p));
        MUST(limb_multiply(full, a, n, a, n));
        CHECK(limb_compare(z, full + n, n) == 0, "square of %d limbs", (int)n);
    }
    test_end();
}

/* s = atan(1/q) B^n; the error of each term is below 2. */
static void atan_inverse(limb_t *s, limb_t *p, limb_t *t, size_t n, limb_t q)
{
    limb_zero(p, n);
    p[n] = 1;
    limb_divrem_1(p, p, n + 1, q);
    limb_copy(s, p, n + 1);
    limb_t k = 0;
    for (size_t m = limb_normal(p, n + 1); m; k++) {
        limb_divrem_1(p, p, m, q * q);
        m = limb_normal(p, m);
        limb_divrem_1(t, p, m, 2 * k + 3);
        if (k % 2 == 0)
            limb_sub_any(s, s, n + 1, t, m);
        else
            limb_add_any(s, s, n + 1, t, m);
    }
}

/* floor(pi B^N), give or take what 64 bits hold, by Machin's formula: 16 atan(1/5) - 4 atan(1/239). */
static void machin(limb_t *sum, size_t N)
{
    static limb_t s[400], p[400], t[400];
    atan_inverse(s, p, t, N, 5);
    limb_mul_1(sum, s, N + 1, 16);
    atan_inverse(s, p, t, N, 239);
    limb_submul_1(sum, s, N + 1, 4);
}

static void test_pi_limbs(void)
{
    test_begin("fixed-pi");
    static limb_t p[400], q[400];
    const size_t N = 330;
    machin(q, N);
    for (size_t n = 1; n < N; n++) {
        MUST(fraction_pi(p, n));
        bool same = limb_compare(p, q + N - n, n + 1) == 0;
        if (!same && n > 172) {
            limb_add_1(p, p, n + 1, 1);
            same = limb_compare(p, q + N - n, n + 1) == 0;
        }
        CHECK(same, "pi to %d limbs", (int)n);
        if (n < 20 || n % 16 == 12) { /* 172, the table's last */
            MUST(fraction_pi_series(p, n));
            same = limb_compare(p, q + N - n, n + 1) == 0;
            limb_add_1(p, p, n + 1, 1);
            CHECK(same || limb_compare(p, q + N - n, n + 1) == 0, "series of pi to %d limbs", (int)n);
        }
    }
    test_end();
}

static void test_drafts(void)
{
    test_begin("fixed-sin-cos");
    for (test_cases(6000); test_next();) {
        limb_t x[MOST + 8], X[MOST + 8], s[MOST + 8], c[MOST + 8], S[MOST + 8], C[MOST + 8];
        size_t n = random_length(), N = n + 3;
        random_angle(x, n, 0xcc00000000000000); /* 0.797 */
        extend(X, N, x, n);
        angle y = {x, n, 0}, Y = {X, N, 0};
        draft sine = {s, false, 0, 0}, cosine = {c, false, 0, 0}, Sine = {S, false, 0, 0}, Cosine = {C, false, 0, 0};
        MUST(fraction_sin_cos(&Sine, &Cosine, &Y));
        MUST(fraction_sin_cos(&sine, &cosine, &y));
        CHECK(agree(&sine, n, &Sine, N) && agree(&cosine, n, &Cosine, N), "both, %d limbs", (int)n);
        MUST(fraction_cos(&cosine, &y));
        CHECK(agree(&cosine, n, &Cosine, N), "cosine, %d limbs", (int)n);
        if (angle_zeros(&y) >= fraction_halvings(n)) {
            MUST(fraction_sin_small(&sine, &y));
            CHECK(agree(&sine, n, &Sine, N), "small sine, %d limbs", (int)n);
        }
        MUST(fraction_angle_complement(&y)); /* now wrong */
        MUST(fraction_cos(&cosine, &y));
        CHECK(agree(&cosine, n, &Sine, N), "cosine of the complement, %d limbs", (int)n);
    }
    test_end();
}

static void test_atan_drafts(void)
{
    test_begin("fixed-atan");
    for (test_cases(6000); test_next();) {
        limb_t x[MOST + 8], X[MOST + 8], a[MOST + 8], A[MOST + 8];
        size_t n = random_length(), N = n + 3;
        random_angle(x, n, ~(limb_t)0);
        extend(X, N, x, n);
        angle y = {x, n, 0}, Y = {X, N, 0};
        draft t = {a, false, 0, 0}, T = {A, false, 0, 0};
        MUST(fraction_atan(&t, &y) && fraction_atan(&T, &Y));
        CHECK(agree(&t, n, &T, N), "atan, %d limbs", (int)n);
    }
    test_end();
}

/* Angles that are wrong by as much as they say. */
static void test_wrong_angles(void)
{
    test_begin("fixed-wrong-angles");
    for (test_cases(2000); test_next();) {
        limb_t x[MOST + 8], X[MOST + 8], a[MOST + 8], A[MOST + 8];
        size_t n = random_length(), N = n + 3;
        random_angle(x, n, 0xcc00000000000000 - 1);
        if (n > 1)
            fraction_shift_right(x, x, n, 64 * n / 2);
        extend(X, N, x, n);
        angle y = {x, n, 1000}, Y = {X, N, 0};
        limb_add_1(x, x, n, 1000);
        draft t = {a, false, 0, 0}, T = {A, false, 0, 0};
        MUST(fraction_atan(&t, &y) && fraction_atan(&T, &Y));
        CHECK(agree(&t, n, &T, N), "atan, %d limbs", (int)n);
        if (angle_zeros(&y) >= fraction_halvings(n)) {
            MUST(fraction_sin_small(&t, &y) && fraction_sin_small(&T, &Y));
            CHECK(agree(&t, n, &T, N), "small sine, %d limbs", (int)n);
        }
    }
    test_end();
}

/* The angle of n limbs is within y->wrong of the same one with N limbs. */
static bool angles_agree(const angle *y, const angle *Y)
{
    draft d = {y->w, false, y->wrong, 0}, D = {Y->w, false, Y->wrong, 0};
    return agree(&d, y->n, &D, Y->n);
}

static void test_other_angles(void)
{
    test_begin("fixed-other-angles");
    for (test_cases(2000); test_next();) {
        limb_t w[MOST + 8], W[MOST + 8];
        size_t n = random_length(), N = n + 3;
        angle y = {w, n, 0}, Y = {W, N, 0};
        random_angle(w, n, 0xcc00000000000000);
        extend(W, N, w, n);
        MUST(fraction_angle_complement(&y) && fraction_angle_complement(&Y));
        CHECK(angles_agree(&y, &Y), "complement, %d limbs", (int)n);
        rational r;
        rational_init(&r);
        if (random_bool()) {
            int64_t q = (int64_t)(random_word() >> random_range(1, 60)) + 4;
            MUST(rational_set_si(&r, (int64_t)random_below((uint64_t)q / 4), q));
        } else
            do {
                random_rational(&r, 3);
                MUST(rational_abs(&r, &r));
            } while (rational_cmp_si(&r, 1, 1) >= 0);
        MUST(fraction_angle_of_turns(&y, &r) && fraction_angle_of_turns(&Y, &r));
        CHECK(angles_agree(&y, &Y), "turns, %d limbs", (int)n);
        rational_clear(&r);
        ball x;
        ball_init(&x);
        random_ball(&x, 4);
        ball_midpoint(&x, &x, 1000);
        if (x.size) {
            ball_mul_2exp(&x, &x, (long)(random_range(1, 140) - ball_top(&x)), 1000);
            MUST(fraction_angle_set_inverse(&y, &x) && fraction_angle_set_inverse(&Y, &x));
            CHECK(angles_agree(&y, &Y), "inverse, %d limbs", (int)n);
        }
        ball_clear(&x);
        /* atan 1 */
        limb_t a[MOST + 8], A[MOST + 8];
        draft t = {a, false, 0, 0}, T = {A, false, 0, 0};
        limb_zero(w, n), limb_zero(W, N);
        w[n] = W[N] = 1;
        y.wrong = Y.wrong = 0;
        MUST(fraction_atan(&t, &y) && fraction_atan(&T, &Y));
        CHECK(agree(&t, n, &T, N), "atan 1, %d limbs", (int)n);
    }
    test_end();
}

/* x = q pi/2 +- y */
static void test_angles(void)
{
    test_begin("fixed-angles");
    for (test_cases(3000); test_next();) {
        limb_t w[MOST + 8], W[MOST + 8];
        size_t n = random_length(), N = n + 3;
        ball x;
        ball_init(&x);
        random_ball(&x, 4);
        ball_midpoint(&x, &x, 1000);
        if (x.size) {
            ball_mul_2exp(&x, &x, (long)(random_range(-70, 140) - ball_top(&x)), 1000);
            angle y = {w, n, 0}, Y = {W, N, 0};
            unsigned turn = 0, Turn = 0;
            bool minus = false, Minus = false;
            MUST(fraction_angle_reduce(&y, &turn, &minus, &x) && fraction_angle_reduce(&Y, &Turn, &Minus, &x));
            if (turn == Turn && minus == Minus) /* else next to pi/4 */
                CHECK(angles_agree(&y, &Y), "angle, %d limbs", (int)n);
            CHECK(w[n] == 0 && w[n - 1] < 0xcc00000000000000, "angle too large");
        }
        ball_clear(&x);
    }
    test_end();
}

/* ---- balls ---- */

static long precision(void)
{
    switch (random_below(40)) {
    case 0: return random_range(2, 10000);
    case 1: case 2: case 3: return random_range(2, 2000);
    default: return random_range(2, 300);
    }
}

/* Thin arguments of all kinds: tiny, huge, next to multiples of pi/2. */
static void argument(ball *x, long prec)
{
    if (random_below(3) == 0) {
        ball_pi(x, random_range(2, prec));
        ball_midpoint(x, x, prec);
        ball_mul_si(x, x, random_range(-1000, 1000), 20000);
        ball_mul_2exp(x, x, -1, 20000);
    } else {
        random_ball(x, 3);
        ball_midpoint(x, x, 1000);
        if (x->size)
        {
            long top = random_range(random_below(4) ? -5 : -400, random_below(4) ? 5 : 64);
            ball_mul_2exp(x, x, top - (long)ball_top(x), 1000);
        }
    }
}

static void test_balls(void)
{
    test_begin("fixed-balls");
    for (test_cases(2000); test_next();) {
        ball x, s, c, t, u, one;
        ball_init(&x), ball_init(&s), ball_init(&c), ball_init(&t), ball_init(&u), ball_init(&one);
        long prec = precision();
        argument(&x, prec);
        ball_one(&one);
        ball_sin(&s, &x, prec), ball_cos(&c, &x, prec);
        CHECK(!x.size || (ball_accuracy_bits_approx(&s) >= prec - 3 && ball_accuracy_bits_approx(&c) >= prec - 3),
              "accuracy at %ld bits", prec);
        ball_sqr(&t, &s, prec), ball_addmul(&t, &c, &c, prec);
        CHECK(ball_contains(&t, &one), "sin^2 + cos^2 at %ld bits", prec);
        ball_sin_cos(&t, &u, &x, prec + random_range(64, 300));
        CHECK(ball_overlaps(&s, &t) && ball_overlaps(&c, &u), "more precision at %ld bits", prec);
        ball_midpoint(&t, &t, BALL_MAX_PRECISION), ball_midpoint(&u, &u, BALL_MAX_PRECISION);
        CHECK(s.error == 0 || ball_contains(&s, &t), "sine at %ld bits", prec);
        CHECK(c.error == 0 || ball_contains(&c, &u), "cosine at %ld bits", prec);
        /* the arc tangent of the tangent */
        ball_atan(&t, &x, prec);
        CHECK(!x.size || ball_accuracy_bits_approx(&t) >= prec - 3, "accuracy of atan at %ld bits", prec);
        ball_atan(&u, &x, prec + 200);
        CHECK(ball_overlaps(&t, &u), "atan at %ld bits", prec);
        ball_midpoint(&u, &u, BALL_MAX_PRECISION);
        CHECK(t.error == 0 || ball_contains(&t, &u), "atan at %ld bits, midpoint", prec);
        /* tan(atan x) = x */
        ball_sin_cos(&s, &c, &t, prec);
        ball_mul(&c, &c, &x, prec);
        CHECK(ball_overlaps(&s, &c), "tan atan at %ld bits", prec);
        ball_clear(&x), ball_clear(&s), ball_clear(&c), ball_clear(&t), ball_clear(&u), ball_clear(&one);
    }
    test_end();
}

/* Wide balls contain the values at their points. */
static void test_wide(void)
{
    test_begin("fixed-wide");
    for (test_cases(1000); test_next();) {
        ball x, y, s, c, t, u;
        rational q;
        ball_init(&x), ball_init(&y), ball_init(&s), ball_init(&c), ball_init(&t), ball_init(&u);
        rational_init(&q);
        long prec = random_precision(300);
        random_ball(&x, 3);
        ball_mul_2exp(&x, &x, (long)(random_range(-10, 10) - ball_top(&x)) * (x.size != 0), 300);
        random_point_ball(&q, &x);
        ball_set_rational(&y, &q, 1000);
        ball_sin(&s, &x, prec), ball_sin(&t, &y, 900), ball_cos(&c, &x, prec), ball_cos(&u, &y, 900);
        CHECK(ball_overlaps(&s, &t) && ball_overlaps(&c, &u), "sine, cosine");
        ball_atan(&s, &x, prec), ball_atan(&t, &y, 900);
        CHECK(ball_overlaps(&s, &t), "atan");
        ball_clear(&x), ball_clear(&y), ball_clear(&s), ball_clear(&c), ball_clear(&t), ball_clear(&u);
        rational_clear(&q);
    }
    test_end();
}

/* cos(pi r) against the cosine of the ball pi r, for short and long r. */
static void test_turns(void)
{
    test_begin("fixed-turns");
    for (test_cases(1000); test_next();) {
        ball x, y, z;
        rational r;
        ball_init(&x), ball_init(&y), ball_init(&z);
        rational_init(&r);
        long prec = precision();
        if (random_bool())
            MUST(rational_set_si(&r, random_range(-50, 50), random_range(1, 50)));
        else
            random_rational(&r, (size_t)random_range(1, 5));
        ball_set_rational(&x, &r, prec + 400), ball_pi(&y, prec + 400), ball_mul(&x, &x, &y, prec + 400);
        ball_cos_pi(&y, &r, prec), ball_cos(&z, &x, prec + 100);
        CHECK(ball_overlaps(&y, &z), "cos pi r at %ld bits", prec);
        CHECK(ball_accuracy_bits_approx(&y) >= prec - 3, "accuracy of cos pi r at %ld bits", prec);
        ball_sin_pi(&y, &r, prec), ball_sin(&z, &x, prec + 100);
        CHECK(ball_overlaps(&y, &z), "sin pi r at %ld bits", prec);
        CHECK(ball_accuracy_bits_approx(&y) >= prec - 3, "accuracy of sin pi r at %ld bits", prec);
        ball_clear(&x), ball_clear(&y), ball_clear(&z);
        rational_clear(&r);
    }
    test_end();
}

int main(void)
{
    test_product();
    test_pi_limbs();
    test_drafts();
    test_atan_drafts();
    test_wrong_angles();
    test_other_angles();
    test_angles();
    test_balls();
    test_wide();
    test_turns();
    return test_status();
}
