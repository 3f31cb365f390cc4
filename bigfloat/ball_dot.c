/* ball_dot.c: sums of products, rounded once.

   The products are added in one fixed-point accumulator: limbs in two's complement, in units of 2^t.  With T >= the top
   of every product and N terms, the sum is below N 2^T, so that an accumulator of 64 L bits with
   t = T + bits(N) + 1 - 64 L cannot overflow.  L is one limb more than the precision (fewer if all terms are short).
   Each product loses less than one unit when it is brought to the scale t; its error word is brought to a common scale
   2^K rounding up.  A special ball, or a spread of exponents that makes terms negligible, costs nothing in accuracy:
   the sum is correct to about 2^(T + bits(N) - prec - 64), like that of exact terms rounded once. */
#include "ball.h"
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

/* The sum in the precision `between`. */
static void dot_one_by_one(ball *z, const ball *x, long xs, const ball *y, long ys, size_t n, long between, long prec)
{
    ball t, sum;
    ball_init(&t);
    ball_init(&sum);
    for (size_t i = 0; i < n; i++, x += xs, y += ys) {
        ball_mul(&t, x, y, BALL_MAX_PRECISION);
        ball_add(&sum, &sum, &t, between);
    }
    ball_set_round(z, &sum, prec);
    ball_clear(&sum);
    ball_clear(&t);
}

static bool all_exact(const ball *x, long xs, const ball *y, long ys, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (ball_is_special(x + (long)i * xs) || ball_is_special(y + (long)i * ys) || x[(long)i * xs].error || y[(long)i * ys].error)
            return false;
    return true;
}

void ball_dot_strided(ball *z, const ball *x, long xs, const ball *y, long ys, size_t n, long prec)
{
    range r;
    accumulator s;
    int64_t room = ball_room_bits(prec);
    if (ball_dot_even(z, x, xs, y, ys, n, prec))
        return;
    if (n == 0 || n >> 30 || room > 64 * (DOT_LIMBS - 2) || !find_range(&r, x, xs, y, ys, n)
        || !(r.any || r.any_error)) {
        dot_one_by_one(z, x, xs, y, ys, n, all_exact(x, xs, y, ys, n) ? BALL_MAX_PRECISION : prec + 64, prec);
        return;
    }
    int guard = limb_bits(n) + 1;
    if (!r.any)
        r.top = r.bottom = r.error_top; /* only errors around 0 */
    if (r.any_error && r.error_top - BALL_ERROR_BITS < r.bottom)
        r.bottom = r.error_top - BALL_ERROR_BITS; /* units fine enough for the errors */
    int64_t span = r.top - r.bottom + guard, length = span < room + 64 || !r.any_error ? span : room + 64;
    if (length > 64 * (DOT_LIMBS - 2)) { /* exact terms, too far apart for the accumulator */
        dot_one_by_one(z, x, xs, y, ys, n, BALL_MAX_PRECISION, prec);
        return;
    }
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
