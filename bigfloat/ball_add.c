/* ball_add.c: sums and differences.

   The mantissas are aligned exactly at the lower exponent, added, and rounded once.  Only when the operands are
   so far apart that the smaller one (with its error) is below one unit in the last place of the result, it
   becomes one unit of error. */
#include "ball.h"
#include "ball_fixed.h"
#include "ball_internal.h"

/* w = m 2^d, n limbs in all. */
static void place(limb_t *w, size_t n, const ball *x, int64_t d)
{
    size_t m = ball_length(x), whole = (size_t)d / 64;
    limb_zero(w, whole);
    w[whole + m] = limb_shift_left(w + whole, ball_limbs(x), m, (unsigned)(d % 64));
    limb_zero(w + whole + m + 1, n - whole - m - 1);
}

/* Adds y's mantissa (negated if its sign is not that of w), shifted left by d, to w; the sign of the sum goes
   to *negative. */
static void add_placed(limb_t *w, limb_t *t, size_t n, const ball *y, bool y_negative, int64_t d, bool *negative)
{
    place(t, n, y, d);
    if (y_negative == *negative)
        limb_add_n(w, w, t, n);
    else if (limb_compare(w, t, n) >= 0)
        limb_sub_n(w, w, t, n);
    else {
        limb_sub_n(w, t, w, n);
        *negative = y_negative;
    }
}

static void add_aligned(ball *z, const ball *x, const ball *y, bool y_negative, int64_t span, long prec)
{
    int64_t e = x->exponent < y->exponent ? x->exponent : y->exponent;
    int64_t dx = x->exponent - e, dy = y->exponent - e, k;
    size_t n = (size_t)span / 64 + 3;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 2 * n);
    if (w) {
        bool negative = x->size < 0;
        place(w, n, x, dx);
        add_placed(w, w + n, n, y, y_negative, dy, &negative);
        limb_t err = ball_error_sum(&k, x->error, x->error ? dx : 0, y->error, y->error ? dy : 0);
        ball_store(z, w, n, negative, err, k, e, prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

/* x plus or minus a number below 2^(x->exponent - room): one unit of error, after x, if it is exact, has been
   extended to its full length. */
static void add_negligible(ball *z, const ball *x, bool negative, long prec)
{
    int64_t bits = (int64_t)ball_mantissa_bits(x), room = ball_room_bits(prec);
    int64_t d = x->error == 0 && bits < room ? room - bits : 0;
    size_t n = ball_length(x) + (size_t)d / 64 + 1;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, n);
    if (w) {
        place(w, n, x, d);
        /* ROUNDING: the number lost is less than one unit of 2^(e - d) */
        ball_store(z, w, n, negative, x->error + 1, 0, x->exponent - d, prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

/* ---- two mantissas of one length n, the difference d of their exponents below 64 n: two passes ---- */

/* w = 2^64 a + v or - v, v = floor(b 2^(64 - d)), n + 2 limbs; the answer: has it become its opposite? */
FIXED_INLINE bool shift_and_add(limb_t *w, const limb_t *a, const limb_t *b, size_t d, bool subtract, size_t n)
{
    limb_t mask = 0 - (limb_t)subtract, carry = subtract;
    size_t whole = d / 64, i = 1;
    unsigned r = d % 64;
    limb_t low = b[whole];
    w[0] = limb_add(((whole ? b[whole - 1] : 0) >> r | (low << 1) << (63 - r)) ^ mask, 0, &carry);
#pragma GCC unroll 4
    for (; i < n - whole; i++) {
        limb_t high = b[whole + i];
        w[i] = limb_add(a[i - 1], (low >> r | (high << 1) << (63 - r)) ^ mask, &carry);
        low = high;
    }
    w[i] = limb_add(a[i - 1], low >> r ^ mask, &carry);
    for (i++; i <= n; i++)
        w[i] = limb_add(a[i - 1], mask, &carry);
    w[n + 1] = mask + carry;
    if (!FIXED_UNLIKELY(w[n + 1] >> 63))
        return false;
    for (i = 0; i <= n; i++)
        w[i] = ~w[i];
    w[n + 1] = limb_add_1(w, w, n + 1, 1);
    return true;
}

/* The sum in units of 2^-64 of x's, rounded once: errors.md, "Sums".  False, and z is as before: not a plain case. */
FIXED_INLINE bool add_even(ball *z, const ball *x, const ball *y, bool flip, int64_t room)
{
    size_t n = ball_length(x);
    if (n != ball_length(y) || n == 0 || n > BALL_STACK_LIMBS || room < 64 * (int64_t)n)
        return false;
    bool swap = x->exponent < y->exponent;
    if (swap) {
        const ball *t = x;
        x = y;
        y = t;
    }
    int64_t d = x->exponent - y->exponent;
    if (d >= 64 * (int64_t)n)
        return false;
    limb_t w[BALL_STACK_LIMBS + 2];
    bool lost = d > 64 && !limb_low_bits_zero(ball_limbs(y), n, (size_t)d - 64);
    bool negative = shift_and_add(w, ball_limbs(x), ball_limbs(y), (size_t)d, ((x->size ^ y->size) < 0) != flip, n)
                    != ((x->size < 0) != (flip && swap));
    /* s low bits go: those that have no room, and those below the units of y */
    int64_t s = w[n + 1] ? 65 : limb_bits(w[n]);
    if (s < 64 - d)
        s = 64 - d;
    if (s == 0 || (x->error && limb_bits(x->error) + 64 - s > BALL_ERROR_BITS))
        return false; /* digits cancelled, or the error must go, too */
    lost = lost || !limb_low_bits_zero(w, n + 2, (size_t)s);
    /* ROUNDING: ceilings of both errors; less than one unit was cut off */
    limb_t error = ball_error_at(s, x->error, 64) + ball_error_at(d + s - 64, y->error, 0) + lost;
    if (error >> (BALL_ERROR_BITS - 1) || (room > 64 * (int64_t)n && s > 64 - d && error < 256))
        return false; /* as in fixed_add */
    limb_t *p = ball_fresh(z, n);
    if (!p) {
        ball_no_memory(z);
        return true;
    }
    const limb_t *from = w + s / 64;
    unsigned r = (unsigned)(s % 64);
#pragma GCC unroll 4
    for (size_t i = 0; i < n; i++)
        p[i] = from[i] >> r | (from[i + 1] << 1) << (63 - r);
    int64_t e = x->exponent - 64 + s;
    int32_t size = (int32_t)limb_normal(p, n);
    z->size = negative ? -size : size;
    z->error = error;
    z->exponent = e;
    ball_settle_exponent(z);
    return true;
}

/* ---- all cases ---- */

/* Let T be the larger top and e the lower exponent.  If T - e exceeds 64 (length x + length y) + room + 128, the
   operand with the lower exponent is below 2^(higher exponent - room - 64): errors.md, "Sums". */
FIXED_INLINE void add_any(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    bool y_negative = (y->size < 0) != flip;
    if (ball_is_special(x) || ball_is_special(y)) {
        ball_indeterminate_like(z, x, y);
        return;
    }
    if (ball_is_exact_zero(y)) {
        ball_set_round(z, x, prec);
        return;
    }
    if (ball_is_exact_zero(x)) {
        ball_set_round(z, y, prec);
        if (flip)
            z->size = -z->size;
        return;
    }
    if (add_even(z, x, y, flip, ball_room_bits(prec)))
        return;
    int64_t tx = ball_top(x), ty = ball_top(y), top = tx > ty ? tx : ty;
    int64_t e = x->exponent < y->exponent ? x->exponent : y->exponent;
    int64_t limit = 64 * (int64_t)(ball_length(x) + ball_length(y)) + ball_room_bits(prec) + 128;
    if (top - e <= limit)
        add_aligned(z, x, y, y_negative, top - e, prec);
    else if (tx > ty)
        add_negligible(z, x, x->size < 0, prec);
    else
        add_negligible(z, y, y_negative, prec);
}

FIXED_NOINLINE static void add_general(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    add_any(z, x, y, flip, prec);
}

/* One function for each length, so that each has registers enough. */
#define ADD_FIXED(name, n, otherwise)                                                                    \
    FIXED_NOINLINE static void name(ball *z, const ball *x, const ball *y, bool flip, long prec)         \
    {                                                                                                    \
        if (FIXED_UNLIKELY(!fixed_add(z, x, y, flip, ball_room_bits(prec), n)))                          \
            otherwise(z, x, y, flip, prec);                                                              \
    }
ADD_FIXED(add_1, 1, add_general)
ADD_FIXED(add_2, 2, add_general)
ADD_FIXED(add_3, 3, add_general)
ADD_FIXED(add_4, 4, add_general)

#if LIMB_HAVE_ADX
FIXED_BMI2 FIXED_NOINLINE static void add_general_bmi2(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    add_any(z, x, y, flip, prec);
}
FIXED_BMI2 ADD_FIXED(add_1_bmi2, 1, add_general_bmi2)
FIXED_BMI2 ADD_FIXED(add_2_bmi2, 2, add_general_bmi2)
FIXED_BMI2 ADD_FIXED(add_3_bmi2, 3, add_general_bmi2)
FIXED_BMI2 ADD_FIXED(add_4_bmi2, 4, add_general_bmi2)
#endif

FIXED_INLINE void add(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    switch (fixed_length(x, y, ball_room_bits(prec))) {
    case 1: FIXED_BEST(add_1)(z, x, y, flip, prec); break;
    case 2: FIXED_BEST(add_2)(z, x, y, flip, prec); break;
    case 3: FIXED_BEST(add_3)(z, x, y, flip, prec); break;
    case 4: FIXED_BEST(add_4)(z, x, y, flip, prec); break;
    default: FIXED_BEST(add_general)(z, x, y, flip, prec);
    }
}

void ball_add(ball *z, const ball *x, const ball *y, long prec) { add(z, x, y, false, prec); }
void ball_sub(ball *z, const ball *x, const ball *y, long prec) { add(z, x, y, true, prec); }

void ball_add_error(ball *z, const ball *x, const ball *r, long prec)
{
    if (ball_is_special(r)) {
        ball_indeterminate_like(z, x, r);
        return;
    }
    limb_t w;
    int64_t k;
    ball_magnitude_word(&w, &k, r);
    ball t;
    ball_init(&t);
    ball_set_error(&t, w, r->exponent + k);
    ball_add(z, x, &t, prec);
}
