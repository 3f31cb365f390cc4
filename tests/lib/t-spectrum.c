/* t-spectrum.c: deflation keeps exactly the other eigenvalues; bounds of spectral radii are never too small. */
#include "lib/spectrum.h"

#include <math.h>
#include <stdlib.h>

#include "region.h"
#include "matrix.h"

#if defined(NUMBER_INTERVAL)
static const long precisions[] = {53};
#elif defined(NUMBER_BALL)
static const long precisions[] = {64, 128, 300};
#else
static const long precisions[] = {64, 128, 300};
#endif
enum { PRECISIONS = sizeof precisions / sizeof *precisions, LIMIT = 40 };

static long random_prec(void)
{
    return precisions[random_below(PRECISIONS)];
}

/* Do the traces of the powers of b, n x n, contain those of d / denominator without the first eigenvalues? */
static void check_traces(const number *b, const known_matrix *m, int without, long prec)
{
    int n = m->n - without;
    size_t size = (size_t)(n * n);
    number *now = number_array_new(size), *next = number_array_new(size);
    number trace;
    rational q;
    rational_init(&q);
    number_init(&trace);
    for (int i = 0; i < n * n; i++)
        number_set(&now[i], &b[i]);
    for (int p = 1; p <= n; p++) { /* they determine the characteristic polynomial */
        number_zero(&trace);
        for (int i = 0; i < n; i++)
            number_add(&trace, &trace, &now[i * n + i], prec);
        trace_of_power(&q, m, without, p);
        double about = rational_get_double_approx(&q);
        CHECK(number_contains_rational(&trace, &q), "n = %d: the trace of power %d is not %.12g, but %.12g", m->n, p, about, number_mid_approx(&trace));
        CHECK(number_upper_bound(&trace) - number_lower_bound(&trace) < 1e-6 * pow(1000, p), "the trace is wide");
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                number_zero(&next[i * n + j]);
                for (int l = 0; l < n; l++)
                    number_addmul(&next[i * n + j], &now[i * n + l], &b[l * n + j], prec);
            }
        for (int i = 0; i < n * n; i++)
            number_swap(&now[i], &next[i]);
    }
    number_array_free(now, size), number_array_free(next, size);
    number_clear(&trace);
    rational_clear(&q);
}

static void check_deflation(bool ones)
{
    known_matrix m = {.n = (int)random_range(1, MATRIX_MAX)};
    long prec = random_prec();
    int n = m.n, pivot;
    rational q;
    rational_init(&q);
    m.d[0][0] = random_range(-9, 9);
    random_blocks(&m, 1, 9);
    random_denominator(&m);
    transform(&m, 2 * n, ones ? 1 : 0);
    if (ones)
        make_ones(&m);
    do
        pivot = (int)random_below((uint64_t)n);
    while (m.p[pivot][0] == 0);
    number *b = matrix_numbers(&m, prec), *x = number_array_new((size_t)n), *rest = number_array_new((size_t)((n - 1) * (n - 1)));
    for (int i = 0; i < n; i++) {
        MUST(rational_set_si(&q, m.p[i][0], m.p[pivot][0]));
        number_set_rational(&x[i], &q, prec);
        CHECK(!ones || m.p[i][0] == 1, "the test itself");
    }
    matrix_deflate(rest, b, ones ? NULL : x, n, pivot, prec);
    check_traces(rest, &m, 1, prec);
    number_array_free(b, (size_t)(n * n)), number_array_free(x, (size_t)n), number_array_free(rest, (size_t)((n - 1) * (n - 1)));
    rational_clear(&q);
}

/* x = P (e_0 - i e_1) / its component `pivot`: the eigenvector of (d_00 + i d_10) / denominator. */
static void make_eigenvector(number *x, const known_matrix *m, int pivot, long prec)
{
    long c = m->p[pivot][0], d = m->p[pivot][1];
    rational q;
    rational_init(&q);
    for (int i = 0; i < m->n; i++) {
        long a = m->p[i][0], b = m->p[i][1];
        MUST(rational_set_si(&q, a * c + b * d, c * c + d * d));
        number_set_rational(&x[i], &q, prec);
        MUST(rational_set_si(&q, a * d - b * c, c * c + d * d));
        number_set_rational(&x[i + m->n], &q, prec);
    }
    rational_clear(&q);
}

static void check_pair_deflation(void)
{
    known_matrix m = {.n = (int)random_range(2, MATRIX_MAX)};
    long prec = random_prec();
    int n = m.n, pivot, second;
    m.d[0][0] = m.d[1][1] = random_range(-6, 6);
    m.d[1][0] = random_range(1, 6) * (random_bool() ? 1 : -1);
    m.d[0][1] = -m.d[1][0];
    random_blocks(&m, 2, 9);
    random_denominator(&m);
    transform(&m, 2 * n, 0);
    do {
        pivot = (int)random_below((uint64_t)n);
        second = (int)random_below((uint64_t)n);
    } while (m.p[second][0] * m.p[pivot][1] == m.p[second][1] * m.p[pivot][0]);
    number *a = matrix_numbers(&m, prec), *b = number_array_new((size_t)(4 * n * n)), *x = number_array_new((size_t)(2 * n));
    number *rest = number_array_new((size_t)((n - 2) * (n - 2)));
    for (int i = 0; i < n * n; i++) {
        number_set(&b[i / n * 2 * n + i % n], &a[i]);
        number_set(&b[(i / n + n) * 2 * n + i % n + n], &a[i]);
    }
    make_eigenvector(x, &m, pivot, prec);
    matrix_deflate_pair(rest, b, x, 2 * n, pivot, second, prec);
    check_traces(rest, &m, 2, prec);
    number_array_free(a, (size_t)(n * n)), number_array_free(b, (size_t)(4 * n * n)), number_array_free(x, (size_t)(2 * n));
    number_array_free(rest, (size_t)((n - 2) * (n - 2)));
}

static void test_deflation(void)
{
    test_begin("spectrum-deflate-pair");
    for (test_cases(300); test_next();)
        check_pair_deflation();
    test_end();
    test_begin("spectrum-deflate");
    for (test_cases(300); test_next();)
        check_deflation(false);
    test_end();
    test_begin("spectrum-deflate-ones");
    for (test_cases(300); test_next();)
        check_deflation(true);
    test_end();
}

/* ---- contraction ---- */

static spectral_answer contraction(const known_matrix *m, const rational *scale, int least, int limit, long prec)
{
    number *b = matrix_numbers(m, prec);
    number s;
    number_init(&s);
    number_set_rational(&s, scale, prec);
    CHECK(number_is_thin(&s), "the scale is a number of all systems");
    spectral_answer answer = spectral_contraction(b, &s, m->n, least, limit, prec);
    CHECK(answer.contracts != TRUTH_FALSE, "no memory");
    CHECK(answer.power <= limit && (answer.contracts != TRUTH_TRUE || answer.power >= least), "power %d of %d..%d", answer.power, least, limit);
    number_array_free(b, (size_t)(m->n * m->n));
    number_clear(&s);
    return answer;
}

/* (scale * spectral radius)^2, exactly. */
static void square_of_radius(rational *z, const known_matrix *m, const rational *scale)
{
    rational q;
    rational_init(&q);
    MUST(rational_set_si(&q, m->denominator, 1));
    MUST(rational_div(z, scale, &q));
    MUST(rational_mul(z, z, z));
    MUST(rational_set_si(&q, m->square, 1));
    MUST(rational_mul(z, z, &q));
    rational_clear(&q);
}

static void test_contraction(void)
{
    int proved = 0, refused = 0, close = 0;
    test_begin("spectrum-contraction");
    for (test_cases(400); test_next();) {
        known_matrix m;
        long prec = random_prec();
        rational scale, square;
        rational_init(&scale), rational_init(&square);
        random_general_matrix(&m, (int)random_range(1, MATRIX_MAX));
        /* scale close to 1 / radius, from both sides */
        double radius = sqrt((double)m.square) / (double)m.denominator, factor = 1 + (random_bool() ? 0x1p-3 : 0x1p-16) * (double)random_range(-7, 7);
        if (m.square == 0)
            radius = 1;
        MUST(rational_set_si(&scale, (int64_t)(0x1p20 * factor / radius), 1L << 20));
        square_of_radius(&square, &m, &scale);
        double about = sqrt(rational_get_double_approx(&square));
        spectral_answer answer = contraction(&m, &scale, 0, LIMIT, prec);
        if (answer.contracts == TRUTH_TRUE) {
            CHECK(rational_cmp_si(&square, 1, 1) < 0, "n = %d: %.17g < 1 is proved by power %d", m.n, about, answer.power);
            CHECK(!answer.diverges, "it contracts and diverges");
            proved++;
            close += about > 0.999;
        } else
            refused++;
        if (prec >= 300)
            CHECK(about >= 0.99 || answer.contracts == TRUTH_TRUE, "n = %d: %.5g < 1 is not proved with %ld bits (power %d)", m.n, about, prec, answer.power);
        if (answer.contracts == TRUTH_TRUE && answer.power < LIMIT) {
            /* the least power is the least: asked for more, it uses more; held to less, it does not know */
            spectral_answer more = contraction(&m, &scale, answer.power + 1, answer.power + 1, prec);
            CHECK(more.contracts != TRUTH_TRUE || more.power == answer.power + 1, "power %d instead of %d", more.power, answer.power + 1);
            if (answer.power)
                CHECK(contraction(&m, &scale, 0, answer.power - 1, prec).contracts == TRUTH_UNKNOWN, "a smaller power is good enough, too");
        }
        rational_clear(&scale), rational_clear(&square);
    }
    CHECK(proved + refused < 100 || (proved > 40 && close > 0 && refused > 40), "%d proved, %d of them close to 1, %d not", proved, close, refused);
    test_end();
}

/* Exactly 1 is not less than 1, and Jordan blocks at 1 grow. */
static void test_exactly_one(void)
{
    test_begin("spectrum-exactly-1");
    for (test_cases(200); test_next();) {
        known_matrix m = {.n = (int)random_range(1, MATRIX_MAX), .denominator = 1};
        rational scale;
        long modulus = 1L << random_below(4);
        rational_init(&scale);
        random_blocks(&m, 1, modulus);
        m.d[0][0] = random_bool() ? modulus : -modulus;
        if (m.n > 1 && random_bool() && m.d[1][1] == m.d[0][0])
            m.d[0][1] = 1;
        transform(&m, (int)random_below(12), 0);
        MUST(rational_set_si(&scale, 1, modulus));
        CHECK(contraction(&m, &scale, 0, LIMIT, random_prec()).contracts == TRUTH_UNKNOWN, "1 < 1");
        rational_clear(&scale);
    }
    test_end();
}

static void test_special(void)
{
    known_matrix m = {.n = 0, .denominator = 1};
    rational scale;
    spectral_answer answer;
    test_begin("spectrum-special");
    rational_init(&scale);
    MUST(rational_set_si(&scale, 1, 1));
    answer = contraction(&m, &scale, 0, 5, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 0, "an empty matrix");
    answer = contraction(&m, &scale, 3, 5, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 3, "an empty matrix, at least 3 times");
    m.n = 4; /* nilpotent, with large entries */
    for (int i = 0; i < 3; i++)
        m.b[i][i + 1] = 1000000;
    answer = contraction(&m, &scale, 0, 5, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 2, "a nilpotent matrix: power %d", answer.power);
    m = (known_matrix){.n = 2, .denominator = 1};
    m.b[0][0] = m.b[1][1] = 3;
    answer = contraction(&m, &scale, 0, LIMIT, 64);
    CHECK(answer.contracts == TRUTH_UNKNOWN && answer.diverges, "3 I does not diverge");
    /* a half: the norm of power 0 is below 1, that of the least power counts */
    m.b[0][0] = m.b[1][1] = 1, m.denominator = 2;
    answer = contraction(&m, &scale, 0, 7, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 0, "I / 2");
    answer = contraction(&m, &scale, 4, 7, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 4, "I / 2, at least 4 times");
    /* a row sum of 1 is not below 1; one step more makes it so */
    m.b[0][0] = m.b[1][1] = 0, m.b[0][1] = 2, m.b[1][0] = 1;
    answer = contraction(&m, &scale, 0, 7, 64);
    CHECK(answer.contracts == TRUTH_TRUE && answer.power == 1, "a row sum of 1: power %d", answer.power);
    rational_clear(&scale);
    test_end();
}

/* Every matrix of an enclosure counts, also its extreme ones. */
static void test_enclosure(void)
{
    test_begin("spectrum-enclosure");
    for (test_cases(50); test_next();) {
        long prec = random_prec();
        int n = (int)random_range(1, 4);
        number *b = number_array_new((size_t)(n * n));
        number one, error, scale;
        double middle = 0.5 + 0.25 * (double)random_below(2), spread = ldexp(1 - middle, random_bool() ? 0 : -1);
        number_init(&one), number_init(&error), number_init(&scale);
        number_one(&scale);
        for (int i = 0; i < n; i++) {
            number_set_double(&b[i * n + i], random_bool() ? middle : -middle, prec);
            number_set_double(&error, spread, prec);
            number_add_error(&b[i * n + i], &b[i * n + i], &error, prec); /* up to modulus 1, or not */
        }
        truth t = spectral_contraction(b, &scale, n, 0, LIMIT, prec).contracts;
        CHECK(t == (middle + spread < 1 ? TRUTH_TRUE : TRUTH_UNKNOWN), "moduli up to %g: %d", middle + spread, (int)t);
        number_array_free(b, (size_t)(n * n));
        number_clear(&one), number_clear(&error), number_clear(&scale);
    }
    test_end();
}

static void tests(void)
{
    test_deflation();
    test_contraction();
    test_exactly_one();
    test_special();
    test_enclosure();
}
MAIN(tests);
