/* interval_batch.c: loops over arrays of intervals; four intervals at a time with AVX-512. */
#include "interval_batch.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(SMOOTHCERT_PORTABLE)
#define BATCH_AVX512 1
#include <immintrin.h>
#else
#define BATCH_AVX512 0
#endif

typedef void (*kernel)(interval *z, const interval *x, const interval *y, size_t n);

/* Runs a kernel, which is not inlined, in a region. */
static void run(kernel f, interval *z, const interval *x, const interval *y, size_t n)
{
    interval_mode mode = interval_enter();
    f(z, x, y, n);
    interval_leave(mode);
}

/* ---- one at a time ---- */

#define PLAIN(name, statement)                                                                                  \
    static INTERVAL_NOINLINE void name##_plain(interval *z, const interval *x, const interval *y, size_t n)     \
    {                                                                                                           \
        for (size_t i = 0; i < n; i++)                                                                          \
            statement;                                                                                          \
    }
PLAIN(add, interval_add(&z[i], &x[i], &y[i], 0))
PLAIN(sub, interval_sub(&z[i], &x[i], &y[i], 0))
PLAIN(mul, interval_mul(&z[i], &x[i], &y[i], 0))
PLAIN(addmul, interval_addmul(&z[i], &x[i], &y[i], 0))
PLAIN(scale, interval_mul(&z[i], &x[i], y, 0))
PLAIN(axpy, interval_addmul(&z[i], &x[i], y, 0))

/* Four partial sums, like the four places of a vector: sum j takes the terms j, j + 4, ... */
static void add_four(interval *z, interval sum[4])
{
    interval_add(&sum[0], &sum[0], &sum[2], 0);
    interval_add(&sum[1], &sum[1], &sum[3], 0);
    interval_add(z, &sum[0], &sum[1], 0);
}

static INTERVAL_NOINLINE void dot_plain(interval *z, const interval *x, const interval *y, size_t n)
{
    interval sum[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    for (size_t i = 0; i < n; i++)
        interval_addmul(&sum[i % 4], &x[i], &y[i], 0);
    add_four(z, sum);
}

/* The first `columns` of them. */
static INTERVAL_NOINLINE void columns_plain(interval *z, const interval *x, const interval *y, size_t n, size_t columns, bool negative)
{
    for (size_t l = 0; l < n; l++)
        for (size_t j = 0; j < columns; j++)
            if (negative)
                interval_submul(&z[j], &x[l], &y[l * n + j], 0);
            else
                interval_addmul(&z[j], &x[l], &y[l * n + j], 0);
}

static void row_plain(interval *z, const interval *x, const interval *y, size_t n, bool negative)
{
    columns_plain(z, x, y, n, n, negative);
}

#if BATCH_AVX512
/* ---- four at a time: a vector holds (a0 b0 a1 b1 a2 b2 a3 b3) with a = -inf, b = sup ---- */

#define AVX __attribute__((target("avx512f,avx512dq")))
#define UP (_MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)

AVX static inline __m512d load4(const interval *x) { return _mm512_loadu_pd(&x->neg_lower); }
AVX static inline void store4(interval *z, __m512d v) { _mm512_storeu_pd(&z->neg_lower, v); }
AVX static inline __m512d swapped(__m512d v) { return _mm512_permute_pd(v, 0x55); }

/* Is some endpoint, or the sum of the four of some product, infinite? */
AVX static inline bool unbounded(__m512d x, __m512d y)
{
    __m512d sum = _mm512_add_round_pd(x, y, UP);
    sum = _mm512_add_round_pd(sum, swapped(sum), UP);
    return _mm512_cmp_pd_mask(sum, _mm512_set1_pd(HUGE_VAL), _CMP_LT_OQ) != 0xff;
}

/* As interval_mul; all endpoints finite. */
AVX static inline __m512d product(__m512d ab, __m512d cd)
{
    const __m512d minus = _mm512_set1_pd(-0.0);
    __m512d ba = swapped(ab), cc = _mm512_movedup_pd(cd), dd = _mm512_permute_pd(cd, 0xff);
    __m512d p = _mm512_mul_round_pd(ab, dd, UP), q = _mm512_mul_round_pd(ba, cc, UP);
    __m512d r = _mm512_mul_round_pd(_mm512_xor_pd(ab, minus), cc, UP);
    __m512d s = _mm512_mul_round_pd(_mm512_xor_pd(ba, minus), dd, UP);
    return _mm512_max_pd(_mm512_max_pd(p, q), _mm512_max_pd(r, s));
}

AVX static INTERVAL_NOINLINE void add_avx(interval *z, const interval *x, const interval *y, size_t n)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4)
        store4(z + i, _mm512_add_round_pd(load4(x + i), load4(y + i), UP));
    add_plain(z + i, x + i, y + i, n - i);
}

AVX static INTERVAL_NOINLINE void sub_avx(interval *z, const interval *x, const interval *y, size_t n)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4)
        store4(z + i, _mm512_add_round_pd(load4(x + i), swapped(load4(y + i)), UP));
    sub_plain(z + i, x + i, y + i, n - i);
}

AVX static INTERVAL_NOINLINE void mul_avx(interval *z, const interval *x, const interval *y, size_t n)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        __m512d u = load4(x + i), v = load4(y + i);
        if (INTERVAL_UNLIKELY(unbounded(u, v)))
            mul_plain(z + i, x + i, y + i, 4);
        else
            store4(z + i, product(u, v));
    }
    mul_plain(z + i, x + i, y + i, n - i);
}

AVX static INTERVAL_NOINLINE void addmul_avx(interval *z, const interval *x, const interval *y, size_t n)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        __m512d u = load4(x + i), v = load4(y + i);
        if (INTERVAL_UNLIKELY(unbounded(u, v)))
            addmul_plain(z + i, x + i, y + i, 4);
        else
            store4(z + i, _mm512_add_round_pd(load4(z + i), product(u, v), UP));
    }
    addmul_plain(z + i, x + i, y + i, n - i);
}

AVX static inline __m512d four_times(const interval *c)
{
    return _mm512_set_pd(c->upper, c->neg_lower, c->upper, c->neg_lower, c->upper, c->neg_lower, c->upper, c->neg_lower);
}

AVX static INTERVAL_NOINLINE void scale_avx(interval *z, const interval *x, const interval *c, size_t n)
{
    size_t i = 0;
    __m512d v = four_times(c);
    for (; i + 4 <= n; i += 4) {
        __m512d u = load4(x + i);
        if (INTERVAL_UNLIKELY(unbounded(u, v)))
            scale_plain(z + i, x + i, c, 4);
        else
            store4(z + i, product(u, v));
    }
    scale_plain(z + i, x + i, c, n - i);
}

AVX static INTERVAL_NOINLINE void axpy_avx(interval *z, const interval *x, const interval *c, size_t n)
{
    size_t i = 0;
    __m512d v = four_times(c);
    for (; i + 4 <= n; i += 4) {
        __m512d u = load4(x + i);
        if (INTERVAL_UNLIKELY(unbounded(u, v)))
            axpy_plain(z + i, x + i, c, 4);
        else
            store4(z + i, _mm512_add_round_pd(load4(z + i), product(u, v), UP));
    }
    axpy_plain(z + i, x + i, c, n - i);
}

AVX static INTERVAL_NOINLINE void dot_avx(interval *z, const interval *x, const interval *y, size_t n)
{
    interval sum[4];
    __m512d s = _mm512_setzero_pd();
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        __m512d u = load4(x + i), v = load4(y + i);
        if (INTERVAL_UNLIKELY(unbounded(u, v))) {
            interval p[4];
            mul_plain(p, x + i, y + i, 4);
            s = _mm512_add_round_pd(s, load4(p), UP);
        } else
            s = _mm512_add_round_pd(s, product(u, v), UP);
    }
    store4(sum, s);
    for (; i < n; i++)
        interval_addmul(&sum[i % 4], &x[i], &y[i], 0);
    add_four(z, sum);
}

/* Endpoints up to here: no sum of four is infinite. */
#define TAME 0x1p1000

/* Columns 0 to 3 of a row, those that the mask has two bits for.  false: not done, some endpoint is too large. */
AVX static inline bool row4_avx(interval *z, const interval *x, const interval *y, size_t n, __mmask8 columns, bool negative)
{
    const __m512d minus = _mm512_set1_pd(-0.0);
    __m512d sum = _mm512_maskz_loadu_pd(columns, &z->neg_lower), largest = _mm512_setzero_pd();
    for (size_t l = 0; l < n; l++) {
        __m512d cd = _mm512_maskz_loadu_pd(columns, &y[l * n].neg_lower), cc = _mm512_movedup_pd(cd), dd = _mm512_permute_pd(cd, 0xff);
        __m512d ab = _mm512_broadcast_f64x2(_mm_loadu_pd(&x[l].neg_lower)), ba = swapped(ab);
        __m512d p = _mm512_mul_round_pd(ab, dd, UP), q = _mm512_mul_round_pd(ba, cc, UP);
        __m512d r = _mm512_mul_round_pd(_mm512_xor_pd(ab, minus), cc, UP);
        __m512d s = _mm512_mul_round_pd(_mm512_xor_pd(ba, minus), dd, UP);
        __m512d t = _mm512_max_pd(_mm512_max_pd(p, q), _mm512_max_pd(r, s));
        sum = _mm512_add_round_pd(sum, negative ? swapped(t) : t, UP);
        largest = _mm512_max_pd(largest, _mm512_max_pd(ab, cd));
    }
    if (_mm512_cmp_pd_mask(largest, _mm512_set1_pd(TAME), _CMP_LE_OQ) != 0xff)
        return false;
    _mm512_mask_storeu_pd(&z->neg_lower, columns, sum);
    return true;
}

AVX static INTERVAL_NOINLINE void row_avx(interval *z, const interval *x, const interval *y, size_t n, bool negative)
{
    for (size_t j = 0; j < n; j += 4) {
        size_t count = n - j < 4 ? n - j : 4;
        if (INTERVAL_UNLIKELY(!row4_avx(z + j, x, y + j, n, (__mmask8)((1u << 2 * count) - 1), negative)))
            columns_plain(z + j, x, y + j, n, count, negative);
    }
}

static bool has_avx512(void) { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"); }
#define BEST(f) (has_avx512() ? f##_avx : f##_plain)
#else
#define BEST(f) f##_plain
#endif

/* c is copied first: it may lie in z. */
void interval_batch_add(interval *z, const interval *x, const interval *y, size_t n) { run(BEST(add), z, x, y, n); }
void interval_batch_sub(interval *z, const interval *x, const interval *y, size_t n) { run(BEST(sub), z, x, y, n); }
void interval_batch_mul(interval *z, const interval *x, const interval *y, size_t n) { run(BEST(mul), z, x, y, n); }
void interval_batch_addmul(interval *z, const interval *x, const interval *y, size_t n) { run(BEST(addmul), z, x, y, n); }
void interval_batch_scale(interval *z, const interval *x, const interval *c, size_t n)
{
    interval copy = *c;
    run(BEST(scale), z, x, &copy, n);
}
void interval_batch_axpy(interval *z, const interval *x, const interval *c, size_t n)
{
    interval copy = *c;
    run(BEST(axpy), z, x, &copy, n);
}
void interval_batch_dot(interval *z, const interval *x, const interval *y, size_t n) { run(BEST(dot), z, x, y, n); }
void interval_batch_row(interval *z, const interval *x, const interval *y, size_t n, bool negative) { BEST(row)(z, x, y, n, negative); }
