/* t-batch.c: batch kernels give the same intervals as single operations, for all lengths and odd operands. */
#include "bigfloat/interval_batch.h"

#include "random.h"

#define MOST 37

static interval x[MOST], y[MOST], z[MOST], w[MOST], c, sum, sum4;

static bool same(const interval *a, const interval *b) { return a->neg_lower == b->neg_lower && a->upper == b->upper; }

static INTERVAL_NOINLINE void single(int op, size_t n)
{
    for (size_t i = 0; i < n; i++)
        switch (op) {
        case 0: interval_add(&w[i], &x[i], &y[i], 0); break;
        case 1: interval_sub(&w[i], &x[i], &y[i], 0); break;
        case 2: interval_mul(&w[i], &x[i], &y[i], 0); break;
        case 3: interval_addmul(&w[i], &x[i], &y[i], 0); break;
        case 4: interval_mul(&w[i], &x[i], &c, 0); break;
        default: interval_addmul(&w[i], &x[i], &c, 0); break;
        }
}

static void batch(int op, size_t n)
{
    switch (op) {
    case 0: interval_batch_add(z, x, y, n); break;
    case 1: interval_batch_sub(z, x, y, n); break;
    case 2: interval_batch_mul(z, x, y, n); break;
    case 3: interval_batch_addmul(z, x, y, n); break;
    case 4: interval_batch_scale(z, x, &c, n); break;
    default: interval_batch_axpy(z, x, &c, n); break;
    }
}

static void fill(size_t n)
{
    bool tame = random_bool();
    for (size_t i = 0; i < n; i++) {
        random_interval(&x[i]), random_interval(&y[i]), random_interval(&z[i]);
        if (tame) {
            interval_set_doubles(&x[i], (double)random_range(-100, 0), (double)random_range(0, 100) / 3);
            interval_set_doubles(&y[i], -1e-300 * (double)random_range(-3, 100), (double)random_range(4, 100));
        }
        w[i] = z[i];
    }
    random_interval(&c);
}

static void test_operations(void)
{
    test_begin("batch-operations");
    for (test_cases(5000); test_next();) {
        size_t n = (size_t)random_below(MOST + 1);
        int op = (int)random_below(6);
        fill(n);
        interval_mode mode = interval_enter();
        single(op, n);
        interval_leave(mode);
        batch(op, n);
        for (size_t i = 0; i < n; i++)
            CHECK(same(&z[i], &w[i]), "operation %d, %zu of %zu: [%a, %a] [%a, %a]", op, i, n, -z[i].neg_lower, z[i].upper,
                  -w[i].neg_lower, w[i].upper);
    }
    test_end();
}

static INTERVAL_NOINLINE void dot_by_hand(size_t n)
{
    interval_zero(&sum);
    for (size_t i = 0; i < n; i++)
        interval_addmul(&sum, &x[i], &y[i], 0);
}

/* The exact sum of midpoints' products is inside, and the mode is left alone. */
static void test_dot(void)
{
    test_begin("batch-dot");
    for (test_cases(2000); test_next();) {
        size_t n = (size_t)random_below(MOST + 1);
        rational p, q, s;
        rational_init(&p), rational_init(&q), rational_init(&s);
        fill(n);
        for (size_t i = 0; i < n; i++) {
            random_point_interval(&p, &x[i]), random_point_interval(&q, &y[i]);
            MUST(rational_mul(&p, &p, &q));
            MUST(rational_add(&s, &s, &p));
        }
        interval_batch_dot(&sum4, x, y, n);
        CHECK(interval_contains_rational(&sum4, &s), "dot of %zu", n);
        interval_mode mode = interval_enter();
        dot_by_hand(n);
        interval_leave(mode);
        CHECK(interval_contains_rational(&sum, &s), "dot by hand");
        volatile double one = 1, small = 0x1p-60;
        CHECK(one + small == 1, "rounding mode");
        rational_clear(&p), rational_clear(&q), rational_clear(&s);
    }
    test_end();
}

enum { MOST_SQUARE = 11 };
static interval matrix[MOST_SQUARE * MOST_SQUARE];

static INTERVAL_NOINLINE void row_by_hand(size_t n, bool negative)
{
    for (size_t l = 0; l < n; l++)
        for (size_t j = 0; j < n; j++)
            (negative ? interval_submul : interval_addmul)(&w[j], &x[l], &matrix[l * n + j], 0);
}

/* Of random matrices half are tame; one entry of some of these is not. */
static void fill_matrix(size_t n)
{
    bool tame = random_bool();
    fill(n);
    for (size_t i = 0; i < n * n; i++) {
        random_interval(&matrix[i]);
        if (tame)
            interval_set_doubles(&matrix[i], (double)random_range(-100, 5) / 3, (double)random_range(5, 100) / 7);
    }
    if (n > 0 && random_below(4) == 0)
        interval_set_doubles(&matrix[random_below(n * n)], -1, random_bool() ? HUGE_VAL : DBL_MAX);
    if (n > 0 && random_below(4) == 0)
        interval_set_doubles(&x[random_below(n)], random_bool() ? -HUGE_VAL : -DBL_MAX, 3);
}

static void test_row(void)
{
    test_begin("batch-row");
    for (test_cases(5000); test_next();) {
        size_t n = (size_t)random_below(MOST_SQUARE + 1);
        bool negative = random_bool();
        fill_matrix(n);
        interval_mode mode = interval_enter();
        row_by_hand(n, negative);
        interval_batch_row(z, x, matrix, n, negative);
        interval_leave(mode);
        for (size_t j = 0; j < n; j++)
            CHECK(same(&z[j], &w[j]), "column %zu of %zu: [%a, %a] [%a, %a]", j, n, -z[j].neg_lower, z[j].upper, -w[j].neg_lower, w[j].upper);
    }
    test_end();
}

int main(void)
{
    test_operations();
    test_row();
    test_dot();
    return test_status();
}
