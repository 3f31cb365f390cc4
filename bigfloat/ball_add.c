/* ball_add.c: sums and differences.

   The mantissas are aligned exactly at the lower exponent, added, and rounded once.  Only when the operands are
   so far apart that the smaller one (with its error) is below one unit in the last place of the result, it
   becomes one unit of error. */
#include "ball.h"
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

/* Let T be the larger top and e the lower exponent.  If T - e exceeds 64 (length x + length y) + room + 128, the
   operand with the lower exponent is below 2^(higher exponent - room - 64): errors.md, "Sums". */
static void add_signed(ball *z, const ball *x, const ball *y, bool flip, long prec)
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

void ball_add(ball *z, const ball *x, const ball *y, long prec) { add_signed(z, x, y, false, prec); }
void ball_sub(ball *z, const ball *x, const ball *y, long prec) { add_signed(z, x, y, true, prec); }

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
