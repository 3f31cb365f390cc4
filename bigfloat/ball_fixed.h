/* ball_fixed.h: sums and products of balls whose mantissas both have n limbs, n = 1, 2, 3, 4 known to the compiler.

   Each function answers false, and leaves z alone, when the case is not a plain one: the general path then does
   the work.  Which path is taken depends on the operands and on prec only, so results are reproducible. */
#ifndef BIGFLOAT_BALL_FIXED_H
#define BIGFLOAT_BALL_FIXED_H

#include "ball_internal.h"
#include "limb_row.h"

#if defined(__GNUC__)
#define FIXED_INLINE static inline __attribute__((always_inline))
#define FIXED_UNLIKELY(c) __builtin_expect(!!(c), 0)
#define FIXED_NOINLINE __attribute__((noinline))
#else
#define FIXED_NOINLINE
#define FIXED_INLINE static inline
#define FIXED_UNLIKELY(c) (c)
#endif

/* On x86-64 the same source is compiled a second time for processors with BMI2 (three-operand shifts): name the two
   versions f and f_bmi2, and call FIXED_BEST(f)(...). */
#if LIMB_HAVE_ADX
#define FIXED_BMI2 __attribute__((target("bmi,bmi2")))
#define FIXED_BEST(f) (__builtin_cpu_supports("bmi2") ? f##_bmi2 : f)
#else
#define FIXED_BEST(f) f
#endif

/* S(i) for i = 0 .. n - 1, n <= 4, unrolled. */
#define FIXED_EACH(n, S)     \
    do {                     \
        S(0)                 \
        if ((n) > 1) {       \
            S(1)             \
        }                    \
        if ((n) > 2) {       \
            S(2)             \
        }                    \
        if ((n) > 3) {       \
            S(3)             \
        }                    \
    } while (0)

/* a >> s for 0 <= s <= 64 */
FIXED_INLINE limb_t fixed_right(limb_t a, unsigned s) { return s < 64 ? a >> s : 0; }

/* w[0..n] = a b (first) or w[0..n-1] + a b */
FIXED_INLINE void fixed_row(limb_t *w, const limb_t *a, limb_t b, const int n, bool first)
{
    limb_t carry = 0;
#define S(i) w[i] = limb_muladd(a[i], b, first ? 0 : w[i], &carry);
    FIXED_EACH(n, S);
#undef S
    w[n] = carry;
}

FIXED_INLINE void fixed_multiply(limb_t *w, const limb_t *a, const limb_t *b, const int n)
{
    fixed_row(w, a, b[0], n, true);
    if (n > 1)
        fixed_row(w + 1, a, b[1], n, false);
    if (n > 2)
        fixed_row(w + 2, a, b[2], n, false);
    if (n > 3)
        fixed_row(w + 3, a, b[3], n, false);
}

/* The leading 64 bits of a, c = clz(a[n - 1]). */
FIXED_INLINE limb_t fixed_leading(const limb_t *a, const int n, unsigned c)
{
    limb_t t = a[n - 1] << c;
    return n > 1 ? t | (a[n - 2] >> 1) >> (63 - c) : t;
}

FIXED_INLINE limb_t *fixed_target(ball *z) { return z->capacity ? z->at.heap : z->at.inline_limbs; }

/* Error of the product of two balls with at least 34 bits: *err 2^*k, *err < 2^63.
   |m| < ((leading >> 33) + 1) 2^K with K = bits - 31, and err_x <= (err_x >> K) + 1 such units. */
FIXED_INLINE void fixed_product_error(limb_t *err, int *k, const ball *x, const ball *y, const limb_t *a, const limb_t *b,
                                      unsigned ca, unsigned cb, const int n)
{
    if ((a[n - 1] & b[n - 1]) >> 63) { /* both full: one scale, beyond the length of an error word */
        *k = 64 * n - 31;
        *err = ((a[n - 1] >> 33) + 2) * y->error + ((b[n - 1] >> 33) + 1) * x->error; /* ROUNDING: |m| + err_x, |n| */
        return;
    }
    int i = 64 * n - (int)ca - 31, j = 64 * n - (int)cb - 31;
    limb_t u = (fixed_leading(a, n, ca) >> 33) + 2, v = (fixed_leading(b, n, cb) >> 33) + 1;
    if (n == 1)
        u += x->error >> i;
    u *= y->error;
    v *= x->error;
    if (y->error == 0)
        *k = j, *err = v;
    else if (x->error == 0)
        *k = i, *err = u;
    else {
        *k = i > j ? i : j;
        *err = (u >> (*k - i)) + (v >> (*k - j)) + 2; /* ROUNDING: two ceilings; |i - j| < 64 */
    }
}

FIXED_INLINE bool fixed_mul(ball *z, const ball *x, const ball *y, int room, const int n)
{
    const limb_t *a = ball_limbs(x), *b = ball_limbs(y);
    limb_t w[2 * 4 + 1], err = 0;
    unsigned ca = (unsigned)limb_clz(a[n - 1]), cb = (unsigned)limb_clz(b[n - 1]);
    if (n == 1 && FIXED_UNLIKELY(ca > 30 || cb > 30))
        return false;
    fixed_multiply(w, a, b, n);
    w[2 * n] = 0;
    if (FIXED_UNLIKELY(w[2 * n - 1] == 0))
        return false;
    int bits = 128 * n - limb_clz(w[2 * n - 1]), k = 0, s = bits > room ? bits - room : 0;
    bool inexact = (x->error | y->error) != 0;
    if (inexact) {
        fixed_product_error(&err, &k, x, y, a, b, ca, cb, n);
        int error_bits = limb_bits(err) + k;
        if (error_bits > (s ? s + BALL_ERROR_BITS - 1 : BALL_ERROR_BITS))
            s = error_bits - (BALL_ERROR_BITS - 1);
    }
    if (FIXED_UNLIKELY(bits - s > 64 * n || bits - s <= 64 * (n - 1)))
        return false;
    /* Hence 64 (n - 1) < s < 64 (n + 1). */
    limb_t lost = 1;
    if (!inexact) {
        lost = s >= 64 * n ? (w[n] << 1) << (63 - (s - 64 * n)) : w[n - 1] << (64 * n - s);
        if (s == 64 * n)
            lost = w[n - 1];
        else if (s > 64 * n)
            lost |= w[n - 1];
        lost |= n > 1 ? w[0] : 0;
        lost |= n > 2 ? w[1] : 0;
        lost |= n > 3 ? w[2] : 0;
    }
    limb_t *p = fixed_target(z);
    bool negative = (x->size ^ y->size) < 0;
    int64_t e = x->exponent + y->exponent + s;
    if (s <= 64 * n) {
        unsigned r = (unsigned)(s - 64 * (n - 1)); /* 1 .. 64 */
#define S(i) p[i] = (w[n - 1 + i] >> 1) >> (r - 1) | w[n + i] << (64 - r);
        FIXED_EACH(n, S);
#undef S
    } else {
        unsigned r = (unsigned)(s - 64 * n); /* 1 .. 63 */
#define S(i) p[i] = w[n + i] >> r | w[n + i + 1] << (64 - r);
        FIXED_EACH(n, S);
#undef S
    }
    if (err)
        err = s >= k ? fixed_right(err, s - k < 64 ? (unsigned)(s - k) : 64) + 1 : err << (k - s); /* ROUNDING: ceiling */
    z->error = err + (lost != 0); /* ROUNDING: less than one unit was cut off */
    z->size = negative ? -n : n;
    z->exponent = e;
    if (FIXED_UNLIKELY(e > BALL_MAX_EXPONENT || e < -BALL_MAX_EXPONENT))
        ball_settle_exponent(z);
    return true;
}

/* w = a 2^d - b or a 2^d + b, n + 1 limbs, 0 <= d < 63; the answer: has it become its opposite, as it was negative? */
FIXED_INLINE bool fixed_sum(limb_t *w, const limb_t *a, unsigned d, const limb_t *b, bool subtract, const int n)
{
    limb_t mask = 0 - (limb_t)subtract, carry = subtract;
#define S(i) w[i] = limb_add(a[i] << d | (i ? (a[i ? i - 1 : 0] >> 1) >> (63 - d) : 0), b[i] ^ mask, &carry);
    FIXED_EACH(n, S);
#undef S
    w[n] = ((a[n - 1] >> 1) >> (63 - d)) + mask + carry;
    if (!FIXED_UNLIKELY(w[n] >> 63))
        return false;
    carry = 1;
#define S(i) w[i] = limb_add(~w[i], 0, &carry);
    FIXED_EACH(n, S);
#undef S
    w[n] = ~w[n] + carry;
    return true;
}

/* The exact sum in n + 1 limbs, rounded as ball_store does it; for exponents that are not far apart. */
FIXED_INLINE bool fixed_add(ball *z, const ball *left, const ball *right, bool flip, int64_t room, const int n)
{
    bool swap = left->exponent < right->exponent;
    const ball *x = swap ? right : left, *y = swap ? left : right;
    uint64_t d = (uint64_t)(x->exponent - y->exponent);
    if (FIXED_UNLIKELY(d >= 63 || x->error >> (63 - d)))
        return false;
    limb_t w[4 + 1], err = (x->error << d) + y->error;
    bool negative = fixed_sum(w, ball_limbs(x), (unsigned)d, ball_limbs(y), ((x->size ^ y->size) < 0) != flip, n)
                    != ((x->size < 0) != (flip && swap));
    unsigned s = (unsigned)limb_bits(w[n]); /* < 64 */
    limb_t mask = ((limb_t)1 << s) - 1;
    /* ROUNDING: ceiling of the error, and the bits cut off */
    limb_t error = (err >> s) + ((err & mask) != 0) + ((w[0] & mask) != 0);
    if (FIXED_UNLIKELY(error >> (BALL_ERROR_BITS - 1) || (room > 64 * n && s && error < 256)))
        return false; /* more must go, or there is room for more limbs and the error has not yet eaten them */
    limb_t *p = fixed_target(z);
#define S(i) p[i] = w[i] >> s | (w[i + 1] << 1) << (63 - s);
    FIXED_EACH(n, S);
#undef S
    int size = n;
    int64_t e = y->exponent + (int64_t)s;
    if (FIXED_UNLIKELY(p[n - 1] == 0))
        while (size && p[size - 1] == 0)
            size--;
    z->error = error;
    z->size = negative ? -size : size;
    z->exponent = e;
    if (FIXED_UNLIKELY(size == 0 || e > BALL_MAX_EXPONENT || e < -BALL_MAX_EXPONENT))
        ball_settle_exponent(z);
    return true;
}

/* The limbs of x and y if they have the same number, at most 4 and at most room / 64; else 0. */
FIXED_INLINE int fixed_length(const ball *x, const ball *y, int64_t room)
{
    int m = x->size < 0 ? -x->size : x->size, n = y->size < 0 ? -y->size : y->size;
    return m == n && n <= 4 && room >= 64 * n ? n : 0;
}

#endif
