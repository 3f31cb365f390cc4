/* ball_dot.c: sums of products, rounded once.

   The products are added in one fixed-point accumulator: limbs in two's complement, in units of 2^t.  With T >= the top
   of every product and N terms, the sum is below N 2^T, so that an accumulator of 64 L bits with
   t = T + bits(N) + 1 - 64 L cannot overflow.  L is one limb more than the precision (fewer if all terms are short).
   Each product loses less than one unit when it is brought to the scale t; its error word is brought to a common scale
   2^K rounding up.  A special ball, or a spread of exponents that makes terms negligible, costs nothing in accuracy:
   the sum is correct to about 2^(T + bits(N) - prec - 64), like that of exact terms rounded once. */
#include "ball.h"
#include "ball_fixed.h"
#include "ball_internal.h"

#define DOT_LIMBS 72 /* longer mantissas go one by one */

typedef struct {
    limb_t acc[DOT_LIMBS + 2];
    size_t L;
    int64_t t;       /* accumulator unit */
    limb_t lost;     /* units of 2^t lost, a count */
    limb_t error;    /* in units of 2^K */
    int64_t K;
} accumulator;

/* acc += w 2^(e - t) or -=, w of n limbs; e may be below t. */
static inline void add_shifted(accumulator *s, const limb_t *w, size_t n, int64_t e, bool subtract)
{
    limb_t moved[2 * DOT_LIMBS + 2];
    int64_t d = e - s->t; /* move by d bits */
    size_t at = 0;
    if (d < 0) {
        size_t whole = (size_t)-d / 64;
        s->lost++; /* ROUNDING: less than one unit, if anything */
        if (whole >= n)
            return;
        n -= whole;
        limb_shift_right(moved, w + whole, n, (unsigned)(-d % 64));
    } else {
        at = (size_t)d / 64;
        moved[n] = limb_shift_left(moved, w, n, (unsigned)(d % 64));
        n++;
    }
    n = limb_normal(moved, n);
    limb_t *a = s->acc + at;
    size_t rest = s->L - at - n; /* the product fits below the top: at + n <= L */
    if (subtract)
        limb_sub_1(a + n, a + n, rest, limb_sub_n(a, a, moved, n));
    else
        limb_add_1(a + n, a + n, rest, limb_add_n(a, a, moved, n));
}

/* err 2^k, the error of x y in units of 2^(e_x + e_y). */
static inline limb_t term_error(int64_t *k, const ball *x, const ball *y)
{
    limb_t u, v;
    int64_t i, j;
    ball_mantissa_word(&u, &i, x);
    ball_magnitude_word(&v, &j, y);
    return ball_error_sum(k, u * y->error, y->error ? i : 0, v * x->error, x->error ? j : 0);
}

static inline int64_t product_top(const ball *x, const ball *y)
{
    return x->exponent + y->exponent + (int64_t)(ball_mantissa_bits(x) + ball_mantissa_bits(y));
}

/* The range of the terms: the highest top, the lowest exponent, the highest top of an error; false if some operand is
   special or too long. */
typedef struct {
    int64_t top, bottom, error_top;
    bool any, any_error;
} range;

static bool find_range(range *r, const ball *x, long xs, const ball *y, long ys, size_t n)
{
    r->top = r->error_top = INT64_MIN / 4;
    r->bottom = INT64_MAX / 4;
    r->any = r->any_error = false;
    for (size_t i = 0; i < n; i++, x += xs, y += ys) {
        if (ball_is_special(x) || ball_is_special(y) || ball_length(x) + ball_length(y) > DOT_LIMBS)
            return false;
        int64_t e = x->exponent + y->exponent;
        if (x->size && y->size) {
            int64_t top = product_top(x, y);
            r->any = true;
            r->top = top > r->top ? top : r->top;
            r->bottom = e < r->bottom ? e : r->bottom;
        }
        if (x->error | y->error) {
            int64_t k;
            limb_t err = term_error(&k, x, y);
            int64_t top = e + k + limb_bits(err);
            if (err)
                r->any_error = true;
            r->error_top = err && top > r->error_top ? top : r->error_top;
        }
    }
    return true;
}

/* Errors of up to 2^error_top each, n of them, in units of 2^K: the sum of the words stays below 2^62. */
static void add_error(accumulator *s, const ball *x, const ball *y)
{
    int64_t k;
    limb_t err = term_error(&k, x, y);
    int64_t d = s->K - (x->exponent + y->exponent + k);
    if (err)
        s->error += d <= 0 ? err << -d : (d < 64 ? err >> d : 0) + 1; /* ROUNDING: ceiling, or one more */
}

static void add_terms(accumulator *s, const ball *x, long xs, const ball *y, long ys, size_t n)
{
    limb_t w[DOT_LIMBS];
    for (size_t i = 0; i < n; i++, x += xs, y += ys) {
        size_t a = ball_length(x), b = ball_length(y);
        if (x->error | y->error)
            add_error(s, x, y);
        if (a == 0 || b == 0)
            continue;
        if (a >= b)
            limb_multiply_basecase(w, ball_limbs(x), a, ball_limbs(y), b);
        else
            limb_multiply_basecase(w, ball_limbs(y), b, ball_limbs(x), a);
        add_shifted(s, w, a + b, x->exponent + y->exponent, (x->size ^ y->size) < 0);
    }
}

/* The accumulator, lost units and errors as a ball. */
static void finish(ball *z, accumulator *s, long prec)
{
    bool negative = s->acc[s->L - 1] >> 63;
    if (negative) {
        for (size_t i = 0; i < s->L; i++)
            s->acc[i] = ~s->acc[i];
        limb_add_1(s->acc, s->acc, s->L, 1);
    }
    int64_t k;
    limb_t err = ball_error_sum(&k, s->lost, 0, s->error, s->error && s->K > s->t ? s->K - s->t : 0);
    ball_store(z, s->acc, s->L, negative, err, k, s->t, prec);
}

static void dot_one_by_one(ball *z, const ball *x, long xs, const ball *y, long ys, size_t n, long prec)
{
    ball t, sum;
    ball_init(&t);
    ball_init(&sum);
    for (size_t i = 0; i < n; i++, x += xs, y += ys) {
        ball_mul(&t, x, y, BALL_MAX_PRECISION);
        ball_add(&sum, &sum, &t, prec + 64);
    }
    ball_set_round(z, &sum, prec);
    ball_clear(&sum);
    ball_clear(&t);
}

/* ---- all mantissas of one length of at most 4 limbs, some error: the common case ----

   As above with L = n + 1.  The two parts of a term's error, u err_y at the scale i and v err_x at j (as in
   fixed_product_error), are words below 2^62; with K >= all scales + bits(N) + 1 their sum stays below 2^63. */

static inline bool has_length(const ball *x, int n) { return x->size == n || x->size == -n; }
static inline bool is_exact_zero_term(const ball *x, const ball *y)
{
    return (!ball_is_special(x) && !ball_is_special(y)) && (ball_is_exact_zero(x) || ball_is_exact_zero(y));
}

/* The highest top of a product and the highest scale of an error, relative to nothing; false: not this case. */
FIXED_INLINE bool fixed_range(int64_t *top, int64_t *scale, const ball *x, long xs, const ball *y, long ys, size_t N, const int n)
{
    int64_t highest = INT64_MIN, highest_scale = INT64_MIN;
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!has_length(x, n) || !has_length(y, n))) {
            if (!is_exact_zero_term(x, y))
                return false;
            continue;
        }
        int ca = limb_clz(ball_limbs(x)[n - 1]), cb = limb_clz(ball_limbs(y)[n - 1]);
        if (n == 1 && FIXED_UNLIKELY(ca > 30 || cb > 30))
            return false;
        int64_t e = x->exponent + y->exponent, t = e - ca - cb;
        highest = t > highest ? t : highest;
        t = y->error ? e - ca : INT64_MIN;
        highest_scale = t > highest_scale ? t : highest_scale;
        t = x->error ? e - cb : INT64_MIN;
        highest_scale = t > highest_scale ? t : highest_scale;
    }
    *top = highest + 128 * n;
    *scale = highest_scale + 64 * n - 31;
    return highest_scale != INT64_MIN;
}

/* ceil(word 2^-d) or one more, for word < 2^63, d >= 0; d may be negative where word is 0 */
FIXED_INLINE limb_t scaled_down(limb_t word, int64_t d)
{
    return ((uint64_t)d < 63 ? word >> d : 0) + 1; /* ROUNDING: ceiling */
}

/* acc += +-w 2^-d, d >= 0, w of 2 n limbs; bits below the unit are cut off. */
FIXED_INLINE void fixed_accumulate(limb_t *acc, const limb_t *w, uint64_t d, bool subtract, const int n)
{
    limb_t mask = 0 - (limb_t)subtract, carry = subtract;
    unsigned r = (unsigned)d % 64;
    const limb_t *from = w + d / 64;
#define S(i) acc[i] = limb_add(acc[i], (from[i] >> r | (from[i + 1] << 1) << (63 - r)) ^ mask, &carry);
    FIXED_EACH(n, S);
    S(n)
#undef S
}

FIXED_INLINE bool fixed_dot(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec, const int n)
{
    int64_t top, K;
    if (!fixed_range(&top, &K, x, xs, y, ys, N, n))
        return false;
    limb_t acc[5] = {0, 0, 0, 0, 0}, w[14], error = 0;
    for (int i = 0; i < 14; i++)
        w[i] = 0;
    int guard = limb_bits(N) + 1;
    int64_t t = top + guard - 64 * (n + 1);
    K += guard;
    K = K < t ? t : K;
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!has_length(x, n) || !has_length(y, n)))
            continue;
        const limb_t *a = ball_limbs(x), *b = ball_limbs(y);
        int64_t e = x->exponent + y->exponent, to = K - e - 64 * n + 31;
        if ((a[n - 1] & b[n - 1]) >> 63) /* both full: one scale */
            /* ROUNDING: |m| + err_x and |n|, as in fixed_product_error */
            error += scaled_down(((a[n - 1] >> 33) + 2) * y->error + ((b[n - 1] >> 33) + 1) * x->error, to);
        else {
            unsigned ca = (unsigned)limb_clz(a[n - 1]), cb = (unsigned)limb_clz(b[n - 1]);
            limb_t u = (fixed_leading(a, n, ca) >> 33) + 2, v = (fixed_leading(b, n, cb) >> 33) + 1;
            if (n == 1)
                u += x->error >> (64 - 31 - ca);
            error += scaled_down(u * y->error, to + ca) + scaled_down(v * x->error, to + cb);
        }
        int64_t d = t - e;
        if (FIXED_UNLIKELY(d < 0 || d >= 128 * n)) {
            if (d < 0)
                return false;
            continue; /* below the unit */
        }
        fixed_multiply(w, a, b, n);
        fixed_accumulate(acc, w, (uint64_t)d, (x->size ^ y->size) < 0, n);
    }
    limb_t mask = 0 - (acc[n] >> 63), carry = mask & 1;
    for (int i = 0; i <= n; i++)
        acc[i] = limb_add(acc[i] ^ mask, 0, &carry);
    int64_t k;
    error = ball_error_sum(&k, N, 0, error, K - t); /* ROUNDING (hidden by the ceilings of the errors): N terms,
                                                           less than one unit each */
    ball_store(z, acc, (size_t)n + 1, mask != 0, error, k, t, prec);
    return true;
}

FIXED_INLINE bool dot_any_length(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec)
{
    int64_t room = ball_room_bits(prec);
    int n = fixed_length(x, y, room);
    if (n == 0 || room != 64 * n)
        return false;
    switch (n) {
    case 1: return fixed_dot(z, x, xs, y, ys, N, prec, 1);
    case 2: return fixed_dot(z, x, xs, y, ys, N, prec, 2);
    case 3: return fixed_dot(z, x, xs, y, ys, N, prec, 3);
    default: return fixed_dot(z, x, xs, y, ys, N, prec, 4);
    }
}

#if LIMB_HAVE_ADX
FIXED_BMI2 static bool dot_short_bmi2(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec)
{
    return dot_any_length(z, x, xs, y, ys, N, prec);
}
#endif

static bool dot_short(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec)
{
    return dot_any_length(z, x, xs, y, ys, N, prec);
}

void ball_dot_strided(ball *z, const ball *x, long xs, const ball *y, long ys, size_t n, long prec)
{
    range r;
    accumulator s;
    if (n && n >> 30 == 0 && FIXED_BEST(dot_short)(z, x, xs, y, ys, n, prec))
        return;
    int64_t room = ball_room_bits(prec);
    if (n == 0 || n >> 30 || room > 64 * (DOT_LIMBS - 2) || !find_range(&r, x, xs, y, ys, n)
        || !(r.any || r.any_error)) {
        dot_one_by_one(z, x, xs, y, ys, n, prec);
        return;
    }
    int guard = limb_bits(n) + 1;
    if (!r.any)
        r.top = r.bottom = r.error_top; /* only errors around 0 */
    if (r.any_error && r.error_top - BALL_ERROR_BITS < r.bottom)
        r.bottom = r.error_top - BALL_ERROR_BITS; /* units fine enough for the errors */
    int64_t span = r.top - r.bottom + guard, length = span < room + 64 ? span : room + 64;
    s.L = (size_t)(length + 63) / 64;
    s.L += s.L == 0;
    s.t = r.top + guard - 64 * (int64_t)s.L;
    if (span <= 64 * (int64_t)s.L) /* every term ends at or above the unit: exact */
        s.t = s.t > r.bottom ? r.bottom : s.t;
    s.lost = s.error = 0;
    s.K = r.error_top - 61 + limb_bits(n);
    if (!r.any_error || s.K < s.t)
        s.K = s.t;
    limb_zero(s.acc, s.L);
    add_terms(&s, x, xs, y, ys, n);
    finish(z, &s, prec);
}

void ball_dot(ball *z, const ball *x, const ball *y, size_t n, long prec)
{
    ball_dot_strided(z, x, 1, y, 1, n, prec);
}
