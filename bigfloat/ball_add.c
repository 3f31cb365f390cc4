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

/* ---- two long mantissas of one length: one pass, as fixed_add ---- */

/* p = a 2^up +- floor(b 2^-down), n limbs, the answer is the carry (1: no borrow, if subtract); down < 64 n. */
static limb_t shift_and_add(limb_t *p, const limb_t *a, unsigned up, const limb_t *b, size_t down, bool subtract, size_t n)
{
    limb_t mask = 0 - (limb_t)subtract, carry = subtract, below = 0;
    size_t whole = down / 64, i = 0;
    unsigned r = down % 64;
    for (; i + whole + 1 < n; i++) {
        limb_t u = a[i] << up | (below >> 1) >> (63 - up), v = b[i + whole] >> r | (b[i + whole + 1] << 1) << (63 - r);
        below = a[i];
        p[i] = limb_add(u, v ^ mask, &carry);
    }
    for (; i < n; i++) {
        limb_t u = a[i] << up | (below >> 1) >> (63 - up), v = i + whole < n ? b[i + whole] >> r : 0;
        below = a[i];
        p[i] = limb_add(u, v ^ mask, &carry);
    }
    return carry;
}

static bool add_long(ball *z, const ball *x, const ball *y, bool flip, int64_t room)
{
    size_t n = ball_length(x);
    if (n != ball_length(y) || room != 64 * (int64_t)n || n > BALL_STACK_LIMBS)
        return false;
    bool x_negative = x->size < 0, y_negative = (y->size < 0) != flip;
    if (x->exponent < y->exponent) {
        const ball *t = x;
        x = y;
        y = t;
        bool negative = x_negative;
        x_negative = y_negative;
        y_negative = negative;
    }
    int64_t d = x->exponent - y->exponent;
    if (d >= room)
        return false;
    int up = limb_clz(ball_limbs(x)[n - 1]), free_bits = BALL_ERROR_BITS - 1 - limb_bits(x->error);
    up = up > d ? (int)d : up;
    if (x->error && up > free_bits)
        up = free_bits > 0 ? free_bits : 0;
    size_t down = (size_t)(d - up);
    limb_t p[BALL_STACK_LIMBS], lost = down ? !limb_low_bits_zero(ball_limbs(y), n, down) : 0;
    bool subtract = x_negative != y_negative;
    limb_t carry = shift_and_add(p, ball_limbs(x), (unsigned)up, ball_limbs(y), down, subtract, n);
    if (subtract && carry == 0) { /* y was greater */
        for (size_t i = 0; i < n; i++)
            p[i] = ~p[i];
        limb_add_1(p, p, n, 1);
        x_negative = y_negative;
    }
    if (subtract)
        carry = 0;
    if (lost && !carry && p[n - 1] >> (x->error | y->error ? 61 : 63) == 0)
        return false; /* as in fixed_add */
    limb_t err = (x->error << up) + ball_error_at((int64_t)down, y->error, 0) + lost; /* ROUNDING: as in fixed_add */
    int s = err >> BALL_ERROR_BITS ? limb_bits(err) - (BALL_ERROR_BITS - 1) : (int)carry;
    if (s) {
        limb_t mask = ((limb_t)1 << s) - 1;
        err = (err >> s) + ((err & mask) != 0) + ((p[0] & mask) != 0); /* ROUNDING: ceiling, and the bits cut off */
        limb_shift_right(p, p, n, (unsigned)s);
        p[n - 1] |= carry << (64 - s);
    }
    int64_t e = x->exponent - up + s;
    size_t size = limb_normal(p, n);
    limb_t *to = ball_fresh(z, size);
    if (!to) {
        ball_no_memory(z);
        return true;
    }
    limb_copy(to, p, size);
    z->size = x_negative ? -(int32_t)size : (int32_t)size;
    z->error = err;
    z->exponent = e;
    ball_settle_exponent(z);
    return true;
}

/* Let T be the larger top and e the lower exponent.  If T - e exceeds 64 (length x + length y) + room + 128, the
   operand with the lower exponent is below 2^(higher exponent - room - 64): errors.md, "Sums". */
FIXED_NOINLINE static void add_signed(ball *z, const ball *x, const ball *y, bool flip, long prec)
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
    if (ball_length(x) > BALL_INLINE_LIMBS && add_long(z, x, y, flip, ball_room_bits(prec)))
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

FIXED_INLINE void add_any(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    int64_t room = ball_room_bits(prec);
    bool done = false;
    switch (fixed_length(x, y, room)) {
    case 1: done = fixed_add(z, x, y, flip, (int)room, 1); break;
    case 2: done = fixed_add(z, x, y, flip, (int)room, 2); break;
    case 3: done = fixed_add(z, x, y, flip, (int)room, 3); break;
    case 4: done = fixed_add(z, x, y, flip, (int)room, 4); break;
    default: break;
    }
    if (FIXED_UNLIKELY(!done))
        add_signed(z, x, y, flip, prec);
}

#if LIMB_HAVE_ADX
FIXED_BMI2 static void add_bmi2(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    add_any(z, x, y, flip, prec);
}
#endif

static void add(ball *z, const ball *x, const ball *y, bool flip, long prec) { add_any(z, x, y, flip, prec); }

void ball_add(ball *z, const ball *x, const ball *y, long prec) { FIXED_BEST(add)(z, x, y, false, prec); }
void ball_sub(ball *z, const ball *x, const ball *y, long prec) { FIXED_BEST(add)(z, x, y, true, prec); }

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
