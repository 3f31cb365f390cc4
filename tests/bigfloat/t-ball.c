/* t-ball.c: every operation on balls contains the exact result for exact points of the operands. */
#include "bigfloat/ball_internal.h"

#include "random.h"

typedef void (*ball_op)(ball *, const ball *, const ball *, long);
typedef bool (*rational_op)(rational *, const rational *, const rational *);

static size_t limbs(void) { return random_below(8) ? 5 : 20; }

/* z := op(x, y) contains the exact result; every aliasing gives the same ball. */
static void check_binary(const char *name, ball_op op, rational_op exact, bool divides)
{
    ball x, y, z, t;
    rational p, q, r;
    ball_init(&x), ball_init(&y), ball_init(&z), ball_init(&t);
    rational_init(&p), rational_init(&q), rational_init(&r);
    random_ball(&x, limbs());
    random_ball(&y, limbs());
    if (random_below(6) == 0) {
        ball_neg(&y, &x);
        ball_set_round(&y, &y, 64);
    }
    random_point_ball(&p, &x);
    random_point_ball(&q, &y);
    long prec = random_precision(400);
    op(&z, &x, &y, prec);
    CHECK(!ball_lacks_memory(&z), "memory");
    CHECK(!ball_is_finite(&z) || z.error >> BALL_ERROR_BITS == 0, "error too long");
    if (divides && rational_is_zero(&q))
        CHECK(!ball_is_finite(&z), "%s by 0 is finite", name);
    else {
        MUST(exact(&r, &p, &q));
        char *tx = ball_get_hex(&x), *ty = ball_get_hex(&y), *tz = ball_get_hex(&z);
        CHECK(ball_contains_rational(&z, &r), "%s: x = %s, y = %s, prec = %ld: z = %s", name, tx, ty, prec, tz);
        free(tx), free(ty), free(tz);
    }
    ball_set(&t, &x), op(&t, &t, &y, prec);
    CHECK(ball_identical(&t, &z), "%s(x, x, y)", name);
    ball_set(&t, &y), op(&t, &x, &t, prec);
    CHECK(ball_identical(&t, &z), "%s(y, x, y)", name);
    op(&z, &x, &x, prec);
    ball_set(&t, &x), op(&t, &t, &t, prec);
    CHECK(ball_identical(&t, &z), "%s(x, x, x)", name);
    ball_set(&y, &x), op(&t, &x, &y, prec);
    CHECK(ball_identical(&t, &z), "%s(z, x, copy of x)", name);
    ball_clear(&x), ball_clear(&y), ball_clear(&z), ball_clear(&t);
    rational_clear(&p), rational_clear(&q), rational_clear(&r);
}

#define BINARY(op, divides)                                             \
    static void test_##op(void)                                         \
    {                                                                   \
        test_begin("ball-" #op);                                        \
        for (test_cases(8000); test_next();)                            \
            check_binary(#op, ball_##op, rational_##op, divides);       \
        test_end();                                                     \
    }
BINARY(add, false)
BINARY(sub, false)
BINARY(mul, false)
BINARY(div, true)

static bool rational_min(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? x : y);
}
static bool rational_max(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? y : x);
}
static bool either(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, random_bool() ? x : y);
}
static bool plus_or_minus(rational *z, const rational *x, const rational *y)
{
    return random_bool() ? rational_add(z, x, y) : rational_sub(z, x, y);
}
#define rational_hull either
#define rational_add_error plus_or_minus
BINARY(min, false)
BINARY(max, false)
BINARY(hull, false)
BINARY(add_error, false)

static void test_addmul(void)
{
    test_begin("ball-addmul");
    for (test_cases(4000); test_next();) {
        ball x, y, z, w, t;
        rational p, q, r, s;
        ball_init(&x), ball_init(&y), ball_init(&z), ball_init(&w), ball_init(&t);
        rational_init(&p), rational_init(&q), rational_init(&r), rational_init(&s);
        random_ball(&x, limbs()), random_ball(&y, limbs()), random_ball(&w, limbs());
        random_point_ball(&p, &x), random_point_ball(&q, &y), random_point_ball(&r, &w);
        long prec = random_precision(400);
        MUST(rational_mul(&p, &p, &q));
        MUST(rational_add(&s, &r, &p));
        ball_fma(&z, &x, &y, &w, prec);
        CHECK(ball_contains_rational(&z, &s), "fma");
        ball_set(&t, &w), ball_addmul(&t, &x, &y, prec);
        CHECK(ball_contains_rational(&t, &s), "addmul");
        ball_set(&t, &w), ball_fma(&t, &x, &y, &t, prec);
        CHECK(ball_identical(&t, &z), "fma(w, x, y, w)");
        ball_set(&t, &x), ball_fma(&t, &t, &y, &w, prec);
        CHECK(ball_identical(&t, &z), "fma(x, x, y, w)");
        MUST(rational_sub(&s, &r, &p));
        ball_set(&t, &w), ball_submul(&t, &x, &y, prec);
        CHECK(ball_contains_rational(&t, &s), "submul");
        ball_set(&t, &x), ball_addmul(&t, &t, &t, prec);
        ball_clear(&x), ball_clear(&y), ball_clear(&z), ball_clear(&w), ball_clear(&t);
        rational_clear(&p), rational_clear(&q), rational_clear(&r), rational_clear(&s);
    }
    test_end();
}

/* sqrt: z contains the root iff z^2 allows the radicand: compare squares. */
static void test_sqrt(void)
{
    test_begin("ball-sqrt");
    for (test_cases(4000); test_next();) {
        ball x, z, t;
        rational p, q, r;
        ball_init(&x), ball_init(&z), ball_init(&t);
        rational_init(&p), rational_init(&q), rational_init(&r);
        random_ball(&t, limbs());
        random_point_ball(&p, &t);
        MUST(rational_abs(&p, &p));
        ball_sqr(&x, &t, random_precision(600)); /* contains p^2 */
        long prec = random_precision(400);
        ball_sqrt(&z, &x, prec);
        CHECK(ball_contains_rational(&z, &p), "root of a square");
        ball_set(&t, &x), ball_sqrt(&t, &t, prec);
        CHECK(ball_identical(&t, &z), "sqrt(x, x)");
        ball_set_si(&x, 49, prec), ball_mul_2exp(&x, &x, random_range(-20, 20) * 2, prec), ball_sqrt(&z, &x, prec);
        CHECK(ball_is_thin(&z), "exact root");
        ball_set_si(&x, -1, prec), ball_sqrt(&z, &x, prec);
        CHECK(!ball_is_finite(&z), "root of -1");
        ball_clear(&x), ball_clear(&z), ball_clear(&t);
        rational_clear(&p), rational_clear(&q), rational_clear(&r);
    }
    test_end();
}

static void test_unary(void)
{
    test_begin("ball-unary");
    for (test_cases(5000); test_next();) {
        ball x, z;
        rational p, q;
        ball_init(&x), ball_init(&z);
        rational_init(&p), rational_init(&q);
        random_ball(&x, limbs());
        random_point_ball(&p, &x);
        long prec = random_precision(400), e = random_range(-300, 300), v = (long)random_corner();
        ball_neg(&z, &x), MUST(rational_neg(&q, &p));
        CHECK(ball_contains_rational(&z, &q), "neg");
        ball_abs(&z, &x), MUST(rational_abs(&q, &p));
        CHECK(ball_contains_rational(&z, &q) && ball_is_negative(&z) == TRUTH_FALSE, "abs");
        ball_sqr(&z, &x, prec), MUST(rational_mul(&q, &p, &p));
        CHECK(ball_contains_rational(&z, &q), "sqr");
        ball_mul_2exp(&z, &x, e, prec), MUST(rational_mul_2exp(&q, &p, e));
        CHECK(ball_contains_rational(&z, &q), "mul_2exp");
        ball_mul_si(&z, &x, v, prec), MUST(rational_set_si(&q, v, 1)), MUST(rational_mul(&q, &q, &p));
        CHECK(ball_contains_rational(&z, &q), "mul_si");
        ball_div_si(&z, &x, v, prec);
        if (v != 0) {
            MUST(rational_set_si(&q, v, 1)), MUST(rational_div(&q, &p, &q));
            CHECK(ball_contains_rational(&z, &q), "div_si");
        } else
            CHECK(!ball_is_finite(&z), "div by 0");
        ball_inv(&z, &x, prec);
        if (!rational_is_zero(&p)) {
            MUST(rational_inv(&q, &p));
            CHECK(ball_contains_rational(&z, &q), "inv");
        }
        ball_set_round(&z, &x, prec);
        CHECK(ball_contains(&z, &x), "set_round");
        long n = random_range(-4, 6);
        ball_pow_si(&z, &x, n, prec);
        if (!rational_is_zero(&p) || n >= 0) {
            MUST(rational_pow(&q, &p, n));
            CHECK(ball_contains_rational(&z, &q), "pow_si %ld", n);
        }
        ball_set_rational(&z, &p, prec);
        CHECK(ball_contains_rational(&z, &p), "set_rational");
        ball_clear(&x), ball_clear(&z);
        rational_clear(&p), rational_clear(&q);
    }
    test_end();
}

static void test_sets(void)
{
    test_begin("ball-sets");
    for (test_cases(5000); test_next();) {
        ball x, z, m, r, t;
        rational p, q;
        ball_init(&x), ball_init(&z), ball_init(&m), ball_init(&r), ball_init(&t);
        rational_init(&p), rational_init(&q);
        random_ball(&x, limbs());
        random_point_ball(&p, &x);
        ball_set_rational(&t, &p, 1000);
        long prec = random_precision(400);
        ball_lower(&z, &x, prec);
        CHECK(ball_is_thin(&z) && ball_less(&t, &z) != TRUTH_TRUE, "lower");
        ball_lower(&z, &x, 5000);
        CHECK(ball_contains(&x, &z), "lower, exact");
        ball_upper(&z, &x, prec);
        CHECK(ball_is_thin(&z) && ball_less(&z, &t) != TRUTH_TRUE, "upper");
        ball_upper(&z, &x, 5000);
        CHECK(ball_contains(&x, &z), "upper, exact");
        ball_midpoint(&m, &x, prec), ball_radius_upper(&r, &x, prec);
        CHECK(ball_is_thin(&m) && ball_is_thin(&r), "thin");
        ball_sub(&z, &t, &m, 6000), ball_abs(&z, &z);
        CHECK(ball_less(&r, &z) != TRUTH_TRUE, "radius");
        ball_magnitude_upper(&z, &x, prec), ball_abs(&t, &t);
        CHECK(ball_is_thin(&z) && ball_less(&z, &t) != TRUTH_TRUE, "magnitude");
        double a = ball_lower_bound(&x), b = ball_upper_bound(&x);
        interval ends;
        interval_set_doubles(&ends, a, b);
        CHECK(interval_contains_rational(&ends, &p), "double bounds");
        /* the bounds are the least: the next doubles inside are not bounds, if x is not thin they are tight */
        integer lo, hi;
        integer_init(&lo), integer_init(&hi);
        long g = random_range(-300, 300);
        MUST(ball_lower_grid(&lo, &x, g)), MUST(ball_upper_grid(&hi, &x, g));
        MUST(rational_set_integer_2exp(&q, &lo, -g));
        CHECK(rational_cmp(&q, &p) <= 0, "lower_grid");
        MUST(rational_set_integer_2exp(&q, &hi, -g));
        CHECK(rational_cmp(&q, &p) >= 0, "upper_grid");
        integer_clear(&lo), integer_clear(&hi);
        ball_clear(&x), ball_clear(&z), ball_clear(&m), ball_clear(&r), ball_clear(&t);
        rational_clear(&p), rational_clear(&q);
    }
    test_end();
}

/* The questions, against endpoints as rationals. */
static void endpoints(rational *a, rational *b, const ball *x)
{
    ball t;
    ball_init(&t);
    integer m;
    int64_t e;
    integer_init(&m);
    ball_lower(&t, x, 20000), MUST(ball_get_parts(&m, NULL, &e, &t)), MUST(rational_set_integer_2exp(a, &m, (long)e));
    ball_upper(&t, x, 20000), MUST(ball_get_parts(&m, NULL, &e, &t)), MUST(rational_set_integer_2exp(b, &m, (long)e));
    integer_clear(&m);
    ball_clear(&t);
}

static void test_questions(void)
{
    test_begin("ball-questions");
    for (test_cases(20000); test_next();) {
        ball x, y;
        rational a, b, c, d;
        ball_init(&x), ball_init(&y);
        rational_init(&a), rational_init(&b), rational_init(&c), rational_init(&d);
        random_ball(&x, 3), random_ball(&y, 3);
        if (random_bool()) {
            ball_set(&y, &x);
            y.error = random_bool() ? x.error / 2 : random_below(1000);
            if (random_bool())
                y.exponent += random_range(-1, 1);
        }
        if (y.size == 0 && y.error == 0)
            y.exponent = 0;
        if (random_below(3) == 0) { /* neighbours: y is x moved by about the errors */
            integer m;
            integer_init(&m);
            random_integer(&m, 1);
            MUST(integer_mul_2exp(&m, &m, random_below(30)));
            MUST(integer_add_si(&m, &m, (long)random_below((uint64_t)1 << 29)));
            ball_set_parts(&x, &m, random_below((uint64_t)1 << random_range(1, BALL_ERROR_BITS)), 0);
            /* moved by up to twice the error, with an error that just touches, or any other */
            long moved = random_range(-2, 2) * (long)(x.error / 2 + 1) + random_range(-2, 2), touching;
            touching = (moved < 0 ? -moved : moved) - (long)x.error + random_range(-1, 1);
            MUST(integer_add_si(&m, &m, moved));
            ball_set_parts(&y, &m, touching >= 0 && random_bool() ? (uint64_t)touching : random_below((uint64_t)1 << random_range(1, BALL_ERROR_BITS)), 0);
            integer_clear(&m);
        }
        endpoints(&a, &b, &x), endpoints(&c, &d, &y);
        CHECK(ball_less(&x, &y) == (rational_cmp(&b, &c) < 0 ? TRUTH_TRUE : rational_cmp(&a, &d) >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "less");
        CHECK(ball_contains(&x, &y) == (rational_cmp(&a, &c) <= 0 && rational_cmp(&d, &b) <= 0), "contains");
        CHECK(ball_contains_interior(&x, &y) == (rational_cmp(&a, &c) < 0 && rational_cmp(&d, &b) < 0), "interior");
        CHECK(ball_overlaps(&x, &y) == (rational_cmp(&a, &d) <= 0 && rational_cmp(&c, &b) <= 0), "overlaps");
        int s = rational_sign(&a), t = rational_sign(&b);
        CHECK(ball_is_positive(&x) == (s > 0 ? TRUTH_TRUE : t <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "positive");
        CHECK(ball_is_negative(&x) == (t < 0 ? TRUTH_TRUE : s >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "negative");
        CHECK(ball_contains_zero(&x) == (s <= 0 && t >= 0), "contains_zero");
        CHECK(ball_is_zero(&x) == (s == 0 && t == 0 ? TRUTH_TRUE : s > 0 || t < 0 ? TRUTH_FALSE : TRUTH_UNKNOWN), "zero");
        ball_clear(&x), ball_clear(&y);
        rational_clear(&a), rational_clear(&b), rational_clear(&c), rational_clear(&d);
    }
    test_end();
}

static void test_dot(void)
{
    test_begin("ball-dot");
    for (test_cases(3000); test_next();) {
        ball x[20], z, t;
        rational p, q, sum;
        ball_init(&z), ball_init(&t);
        rational_init(&p), rational_init(&q), rational_init(&sum);
        size_t n = (size_t)random_below(11), m = random_below(10) ? 4 : random_below(4) ? 12 : 50;
        long spread = random_bool() ? 0 : 300;
        bool exact = random_below(4) == 0;
        for (size_t i = 0; i < 20; i++) {
            ball_init(&x[i]);
            if (i >= 2 * n)
                continue;
            random_ball(&x[i], m);
            if (exact)
                ball_midpoint(&x[i], &x[i], 10000);
            ball_mul_2exp(&x[i], &x[i], random_range(-spread, spread), 10000);
        }
        if (n > 2 && random_bool()) { /* cancellation */
            ball_set(&x[2], &x[0]);
            ball_neg(&x[3], &x[1]);
        }
        for (size_t i = 0; i < n; i++) {
            random_point_ball(&p, &x[2 * i]);
            random_point_ball(&q, &x[2 * i + 1]);
            MUST(rational_mul(&p, &p, &q));
            MUST(rational_add(&sum, &sum, &p));
        }
        long prec = random_precision(400);
        ball_dot_strided(&z, x, 2, x + 1, 2, n, prec);
        CHECK(!n || ball_is_finite(&z), "finite");
        CHECK(ball_contains_rational(&z, &sum), "dot of %zu terms", n);
        if (exact && m < 50) {
            CHECK(ball_is_thin(&z) || z.error <= n + 1, "error of an exact dot product: %llu", (unsigned long long)z.error);
            ball_dot_strided(&t, x, 2, x + 1, 2, n, 4600);
            ball_set_round(&t, &t, prec);
            CHECK(!ball_is_thin(&t) || ball_accuracy_bits_approx(&z) >= prec - 2 || ball_contains_zero(&z) || n > 2, "poor");
        }
        ball_set(&t, &x[1]);
        ball_dot_strided(&x[0], x, 2, x + 1, 2, n, prec);
        CHECK(ball_identical(&x[0], &z), "alias");
        for (size_t i = 0; i < 20; i++)
            ball_clear(&x[i]);
        ball_clear(&z), ball_clear(&t);
        rational_clear(&p), rational_clear(&q), rational_clear(&sum);
    }
    test_end();
}

/* Two mantissas of n full limbs at precision 64 n: sums that carry, errors at their limit, exact operands. */
static void test_full_lengths(void)
{
    test_begin("ball-full-lengths");
    for (test_cases(20000); test_next();) {
        size_t n = (size_t)random_range(1, 10);
        uint64_t limb[10];
        ball x[2], z;
        rational p, q;
        ball_init(&z);
        rational_init(&p), rational_init(&q);
        bool sign = random_bool();
        for (int i = 0; i < 2; i++) {
            integer m;
            integer_init(&m);
            ball_init(&x[i]);
            random_limbs(limb, n);
            limb[n - 1] |= random_below(4) ? (uint64_t)1 << 63 : 1;
            MUST(integer_set_limbs(&m, limb, n, random_below(4) ? sign : !sign));
            ball_set_parts(&x[i], &m, random_below(3) ? random_below(4) : ((uint64_t)1 << BALL_ERROR_BITS) - 1 - random_below(4),
                           random_below(3) ? 0 : random_below(4) ? random_range(-66, 66) : random_range(-330, 330));
            integer_clear(&m);
        }
        random_point_ball(&p, &x[0]), random_point_ball(&q, &x[1]);
        long prec = 64 * (long)n;
        MUST(rational_mul(&q, &q, &p));
        ball_mul(&z, &x[0], &x[1], prec);
        CHECK(ball_contains_rational(&z, &q), "mul");
        if (!rational_is_zero(&p)) {
            MUST(rational_div(&q, &q, &p));
            MUST(rational_add(&q, &q, &p));
            ball_add(&z, &x[0], &x[1], prec);
            CHECK(ball_contains_rational(&z, &q), "add");
            MUST(rational_sub(&q, &q, &p));
            MUST(rational_sub(&q, &p, &q));
            ball_sub(&z, &x[0], &x[1], prec);
            CHECK(ball_contains_rational(&z, &q), "sub");
        }
        ball_clear(&x[0]), ball_clear(&x[1]), ball_clear(&z);
        rational_clear(&p), rational_clear(&q);
    }
    test_end();
}

/* The exact sum with n limbs: rounded once, and exact if it fits. */
static void check_exact(const ball *z, const rational *sum, size_t n)
{
    const integer *m = &sum->numerator;
    size_t zeros = m->size ? limb_trailing_zeros(integer_limbs(m), (size_t)integer_length(m)) : 0;
    bool fits = integer_bits(m) - zeros <= 64 * n;
    CHECK(fits ? z->error == 0 : z->error == 1 && ball_mantissa_bits(z) == 64 * n,
          "exact terms of %zu limbs: rounded more than once", n);
}

/* Dot products of terms that all have n limbs, most of them full, at precision 64 n. */
static void test_dot_full_lengths(void)
{
    test_begin("ball-dot-full-lengths");
    for (test_cases(10000); test_next();) {
        size_t n = (size_t)(random_below(5) ? random_range(1, 5) : random_bool() ? 8 : random_range(6, 33)), N = (size_t)random_range(1, 4);
        uint64_t limb[33];
        ball x[8], z;
        bool exact = random_below(3) == 0;
        rational p, q, sum;
        ball_init(&z);
        rational_init(&p), rational_init(&q), rational_init(&sum);
        bool short_errors = random_bool();
        long spread = random_below(4) ? 66 : 64 * (long)n + 130;
        for (size_t i = 0; i < 2 * N; i++) {
            integer m;
            integer_init(&m);
            ball_init(&x[i]);
            random_limbs(limb, n);
            limb[n - 1] |= (uint64_t)1 << (random_below(4) ? 63 : random_below(4) ? random_range(46, 62) : 0);
            MUST(integer_set_limbs(&m, limb, n, random_below(4) == 0));
            ball_set_parts(&x[i], &m, exact ? 0 : short_errors ? random_below(3) : random_word() >> (64 - BALL_ERROR_BITS),
                           random_below(3) ? 0 : random_range(-spread, spread));
            integer_clear(&m);
        }
        for (size_t i = 0; i < N; i++) {
            random_point_ball(&p, &x[i]), random_point_ball(&q, &x[N + i]);
            MUST(rational_mul(&p, &p, &q));
            MUST(rational_add(&sum, &sum, &p));
        }
        ball_dot(&z, x, x + N, N, 64 * (long)n);
        CHECK(ball_contains_rational(&z, &sum), "%zu terms of %zu limbs", N, n);
        if (exact)
            check_exact(&z, &sum, n);
        for (size_t i = 0; i < 2 * N; i++)
            ball_clear(&x[i]);
        ball_clear(&z);
        rational_clear(&p), rational_clear(&q), rational_clear(&sum);
    }
    test_end();
}

/* Exact terms whose sum fits give it exactly, however many zero bits their mantissas carry. */
static void test_dot_exact(void)
{
    test_begin("ball-dot-exact");
    for (test_cases(3000); test_next();) {
        size_t N = (size_t)random_range(1, 16);
        long shift = random_range(0, 44), sum = 0;
        ball x[32], z;
        ball_init(&z);
        for (size_t i = 0; i < N; i++) {
            long a = random_range(-(1L << 19), 1L << 19), b = random_range(-(1L << 19), 1L << 19);
            for (int j = 0; j < 2; j++) {
                integer m;
                integer_init(&m);
                ball_init(&x[i + 16 * (size_t)j]);
                integer_set_si(&m, j ? b : a);
                MUST(integer_mul_2exp(&m, &m, (unsigned long)shift));
                ball_set_parts(&x[i + 16 * (size_t)j], &m, 0, -shift);
                integer_clear(&m);
            }
            sum += a * b;
        }
        rational exact;
        rational_init(&exact);
        MUST(rational_set_si(&exact, sum, 1));
        ball_dot(&z, x, x + 16, N, 64);
        CHECK(ball_is_thin(&z) && ball_contains_rational(&z, &exact), "%zu exact terms, shift %ld", N, shift);
        rational_clear(&exact);
        for (size_t i = 0; i < N; i++)
            ball_clear(&x[i]), ball_clear(&x[i + 16]);
        ball_clear(&z);
    }
    test_end();
}

/* (h + 1) (h - 1) - h h = -1: all digits of the accumulator cancel; alone, and with an inexact term far below. */
static void test_dot_cancellation(void)
{
    test_begin("ball-dot-cancellation");
    for (test_cases(500); test_next();) {
        size_t n = (size_t)random_range(1, 9);
        uint64_t limb[9];
        integer h, one;
        ball x[3], y[3], z;
        rational sum, p, q;
        integer_init(&h), integer_init(&one);
        integer_set_si(&one, 1);
        rational_init(&sum), rational_init(&p), rational_init(&q);
        for (int i = 0; i < 3; i++)
            ball_init(&x[i]), ball_init(&y[i]);
        ball_init(&z);
        random_limbs(limb, n);
        limb[n - 1] |= (uint64_t)1 << 63;
        limb[0] = (limb[0] | 2) & ~(uint64_t)8;
        MUST(integer_set_limbs(&h, limb, n, false));
        ball_set_parts(&x[1], &h, 0, 0);
        ball_neg(&y[1], &x[1]);
        MUST(integer_add(&h, &h, &one));
        ball_set_parts(&x[0], &h, 0, 0);
        MUST(integer_add_si(&h, &h, -2));
        ball_set_parts(&y[0], &h, 0, 0);
        ball_set_parts(&x[2], &h, 1, -1000), ball_set_parts(&y[2], &h, 0, -1000);
        random_point_ball(&p, &x[2]), random_point_ball(&q, &y[2]);
        MUST(rational_mul(&p, &p, &q));
        MUST(rational_set_si(&sum, -1, 1));
        ball_dot(&z, x, y, 2, 64 * (long)n);
        CHECK(ball_contains_rational(&z, &sum), "exact, %zu limbs", n);
        MUST(rational_add(&sum, &sum, &p));
        ball_dot(&z, x, y, 3, 64 * (long)n);
        CHECK(ball_contains_rational(&z, &sum), "%zu limbs", n);
        for (int i = 0; i < 3; i++)
            ball_clear(&x[i]), ball_clear(&y[i]);
        ball_clear(&z);
        integer_clear(&h), integer_clear(&one);
        rational_clear(&sum), rational_clear(&p), rational_clear(&q);
    }
    test_end();
}

/* z = +-m 2^e +- err 2^e */
static void set_word(ball *z, long m, uint64_t err, int64_t e)
{
    integer t;
    integer_init(&t);
    integer_set_si(&t, m);
    ball_set_parts(z, &t, err, e);
    integer_clear(&t);
}

/* Terms that fall below the accumulator's unit, all in one direction, after all that was large has cancelled. */
static void test_dot_lost(void)
{
    test_begin("ball-dot-lost");
    for (test_cases(1000); test_next();) {
        enum { N = 12 };
        ball x[N], y[N], z;
        rational p, q, sum;
        ball_init(&z);
        rational_init(&p), rational_init(&q), rational_init(&sum);
        int64_t e = random_range(-80, -40); /* the unit is in this range */
        for (size_t i = 0; i < N; i++) {
            ball_init(&x[i]), ball_init(&y[i]);
            set_word(&x[i], i == 1 ? -1 : 1, 0, 0), set_word(&y[i], (1 << 20) - 1, 0, e - 20);
            if (i < 2) { /* +- (2^64 + 1) */
                set_word(&y[i], 1, 0, 64);
                ball_add(&y[i], &y[i], &x[0], 128);
            }
        }
        set_word(&x[N - 1], 0, 1, 0), set_word(&y[N - 1], 1, 0, e); /* only an error */
        for (size_t i = 0; i < N; i++) {
            random_point_ball(&p, &x[i]), random_point_ball(&q, &y[i]);
            MUST(rational_mul(&p, &p, &q));
            MUST(rational_add(&sum, &sum, &p));
        }
        ball_dot(&z, x, y, N, 64);
        CHECK(ball_contains_rational(&z, &sum), "unit 2^%ld", (long)e);
        for (size_t i = 0; i < N; i++)
            ball_clear(&x[i]), ball_clear(&y[i]);
        ball_clear(&z);
        rational_clear(&p), rational_clear(&q), rational_clear(&sum);
    }
    test_end();
}

/* (B^n - 1)^2 - (B^n - 2) B^n = 1: in the first product the limbs left out are as great as can be, in the second they are
   0; and an inexact term far below. */
static void test_dot_left_out(void)
{
    test_begin("ball-dot-left-out");
    for (size_t n = 1; n <= 64; n++) {
        uint64_t limb[64];
        integer m;
        ball x[3], y[3], z;
        rational sum;
        integer_init(&m);
        rational_init(&sum);
        ball_init(&z);
        for (int i = 0; i < 3; i++)
            ball_init(&x[i]), ball_init(&y[i]);
        for (size_t i = 0; i < n; i++)
            limb[i] = ~(uint64_t)0;
        MUST(integer_set_limbs(&m, limb, n, false));
        ball_set_parts(&x[0], &m, 0, 0), ball_set_parts(&y[0], &m, 0, 0);
        ball_set_parts(&x[2], &m, 1, -20000), ball_set_parts(&y[2], &m, 0, 0);
        MUST(integer_add_si(&m, &m, -1));
        ball_set_parts(&x[1], &m, 0, 0);
        for (size_t i = 0; i < n; i++)
            limb[i] = i + 1 == n ? (uint64_t)1 << 63 : 0;
        MUST(integer_set_limbs(&m, limb, n, true));
        ball_set_parts(&y[1], &m, 0, 1);
        ball_dot(&z, x, y, 3, 64 * (long)n);
        MUST(rational_set_si(&sum, 1, 1));
        CHECK(ball_contains_rational(&z, &sum), "%zu limbs", n); /* less than 2^-11000 is missing */
        integer_clear(&m);
        rational_clear(&sum);
        for (int i = 0; i < 3; i++)
            ball_clear(&x[i]), ball_clear(&y[i]);
        ball_clear(&z);
    }
    test_end();
}

int main(void)
{
    test_full_lengths();
    test_dot_full_lengths();
    test_dot_exact();
    test_dot_cancellation();
    test_dot_lost();
    test_dot_left_out();
    test_dot();
    test_add();
    test_sub();
    test_mul();
    test_div();
    test_min();
    test_max();
    test_hull();
    test_add_error();
    test_addmul();
    test_sqrt();
    test_unary();
    test_sets();
    test_questions();
    return test_status();
}
