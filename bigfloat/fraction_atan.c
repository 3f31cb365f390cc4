/* fraction_atan.c: the arc tangent of a number in [0, 1] in fixed point.

   Let a be an approximation, found by the same function with a quarter of the limbs, at last with one word.  Then
   atan x = a + atan d with d = (x cos a - sin a) / (cos a + x sin a), whatever a is; as d is tiny, very few terms of
   its series are needed.  A small x is its own d, with a = 0.  The bounds: errors-trig.md, "Arc tangents". */
#include "fraction.h"

static limb_t high_word(limb_t a, limb_t b)
{
    limb_t high;
    limb_mul(&high, a, b);
    return high;
}

/* atan(x 2^-64) 2^64, within 3: with j = floor(16 x), atan x = atan(j / 16) + atan t, t = (x - j/16) / (1 + x j/16) <
   1/16.  The tests compare the table of floor(atan(j / 16) 2^64) with what is computed with it at higher precision. */
static limb_t atan_word(limb_t x)
{
    static const limb_t table[16] = {
        0x0000000000000000, 0x0ffaaddb967ef4e3, 0x1fd5ba9aac2f6dc6, 0x2f72f6979cb6044d,
        0x3eb6ebf25901bac5, 0x4d89dcdc1faf2f34, 0x5bd86507937bc239, 0x6993bb0f308ff2db,
        0x76b19c1586ed3da2, 0x832bf4a6d9867e2a, 0x8f005d5ef7f59f9b, 0x9a2f80e671bdda20,
        0xa4bc7d1934f70924, 0xaeac4c38b4d8c080, 0xb8053e2bc2319e73, 0xc0ce85b8ac526640,
    };
    limb_t j = x >> 60, rest = x << 4 >> 4, r;
    limb_t t = limb_div(&r, rest >> 1, rest << 63, ((limb_t)1 << 63) + high_word(x, j << 59));
    limb_t u = high_word(t, t), sum = 0;
    for (limb_t k = 15; k >= 3; k -= 2) /* t (1 - u (1/3 - u (1/5 - ...))): what is left out is below 2^-72 */
        sum = ~(limb_t)0 / k - high_word(u, sum);
    return table[j] + t - high_word(t, high_word(u, sum));
}

/* sum = atan d = d - d^3 / 3 + d^5 / 5 ..., |d| < 1/2, n limbs; the error is below the answer.  p has 4 n limbs. */
static limb_t tail_series(limb_t *sum, const limb_t *d, size_t n, limb_t *p, bool *ok)
{
    limb_t *power = p + 2 * n, *w = power + n, err = 1; /* ROUNDING: what is left out */
    limb_copy(sum, d, n);
    limb_copy(power, d, n);
    *ok = fraction_square(w, d, n, p);
    size_t L = limb_normal(d, n), M = limb_normal(w, n);
    for (limb_t k = 3; *ok; k += 2) {
        /* power = floor(power w): zero limbs above stay out of it */
        *ok = M == 0 || L == 0
              || (L >= M ? limb_multiply(p, power, L, w, M) : limb_multiply(p, w, M, power, L));
        if (L + M <= n || M == 0 || L == 0)
            break;
        L = L + M - n;
        limb_copy(power, p + n, L);
        L = limb_normal(power, L);
        limb_divrem_1(p, power, L, k);
        if (k % 4 == 3)
            limb_sub_any(sum, sum, n, p, L);
        else
            limb_add_any(sum, sum, n, p, L);
        err += 2; /* ROUNDING: the power, 3/2 / k; the quotient, 1 */
    }
    return err;
}

/* d = |num| / den, num = x c - s, den = c + x s; in ulp, n limbs each but den n + 1.  v has 5 n + 3 limbs. */
static bool difference(limb_t *d, bool *negative, const limb_t *x, const limb_t *s, const limb_t *c, size_t n,
                       limb_t *v)
{
    limb_t *num = v, *den = num + 2 * n, *p = den + n + 1;
    bool ok = fraction_mul(num + n, x, c, n, p) && fraction_mul(den, x, s, n, p);
    *negative = limb_compare(num + n, s, n) < 0;
    if (*negative)
        limb_sub_n(num + n, s, num + n, n);
    else
        limb_sub_n(num + n, num + n, s, n);
    den[n] = limb_add_n(den, den, c, n);
    limb_zero(num, n);
    limb_zero(d, n);
    size_t L = limb_normal(num + n, n);
    if (ok && L && den[n])
        ok = limb_divide(d, NULL, num, n + L, den, n + 1);
    else if (ok && L) /* den below 1 by roundings only: 1 */
        limb_copy(d, num + n, L);
    return ok;
}

/* The arc tangent by way of a, which has n limbs. */
static bool correct(draft *to, const limb_t *a, const limb_t *x, size_t n)
{
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 10 * n + 7);
    bool ok = w != NULL, negative;
    if (ok) {
        draft s = {w, false, 0, 0}, c = {w + n + 1, false, 0, 0};
        limb_t *y = c.w + n + 1, *d = y + n + 1, *v = d + n;
        limb_copy(y, a, n);
        y[n] = 0;
        angle angle_a = {y, n, 0};
        ok = fraction_sin_cos(&s, &c, &angle_a);
        if (c.w[n]) { /* the cosine is 1, as n limbs do not hold it: take 1 - ulp */
            for (size_t i = 0; i < n; i++)
                c.w[i] = ~(limb_t)0;
            c.err++; /* ROUNDING (hidden by the series): the ulp taken off */
        }
        ok = ok && difference(d, &negative, x, s.w, c.w, n, v);
        if (ok) {
            limb_t series = tail_series(y, d, n, v, &ok);
            limb_copy(to->w, a, n);
            to->w[n] = 0;
            if (negative)
                limb_sub_n(to->w, to->w, y, n);
            else
                limb_add_n(to->w, to->w, y, n);
            to->k = s.k > c.k ? s.k : c.k;
            /* ROUNDING: sine and cosine; the products, 2, the quotient, 1, and tiny ones, 1; the series */
            to->err = ball_error_at(to->k, s.err, s.k) + ball_error_at(to->k, c.err, c.k)
                      + ball_error_at(to->k, 4 + series, 0);
        }
    }
    ball_scratch_free(&space);
    return ok;
}

static bool small_atan(draft *to, const limb_t *x, size_t n)
{
    ball_scratch space;
    limb_t *p = ball_scratch_new(&space, 4 * n);
    bool ok = p != NULL;
    if (ok) {
        to->w[n] = 0;
        to->err = tail_series(to->w, x, n, p, &ok);
        to->k = 0;
    }
    ball_scratch_free(&space);
    return ok;
}

static bool atan_limbs(draft *to, const limb_t *x, size_t n)
{
    to->negative = false;
    size_t zeros = 64 * n - limb_bit_length(x, n);
    if (n == 1) {
        to->w[0] = atan_word(x[0]);
        to->w[1] = 0;
        to->err = 3; /* ROUNDING: see atan_word */
        to->k = 0;
        return true;
    }
    if (zeros >= 6 * n)
        return small_atan(to, x, n);
    size_t m = (n + 3) / 4;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, n + m + 1);
    draft a = {w ? w + n : NULL, false, 0, 0};
    bool ok = w && atan_limbs(&a, x + n - m, m);
    if (ok) {
        limb_zero(w, n);
        limb_copy(w + n - m, a.w, m);
        ok = correct(to, w, x, n);
    }
    ball_scratch_free(&space);
    return ok;
}

bool fraction_atan(draft *a, const angle *x)
{
    size_t n = x->n;
    bool ok;
    if (x->w[n]) { /* atan 1 = pi / 4 */
        ok = fraction_pi(a->w, n);
        limb_shift_right(a->w, a->w, n + 1, 2);
        a->negative = false;
        a->err = 2; /* ROUNDING: pi / 4, 1/2; the floor, 1 */
        a->k = 0;
    } else
        ok = atan_limbs(a, x->w, n);
    a->err += x->wrong; /* ROUNDING: atan' <= 1 */
    return ok;
}
