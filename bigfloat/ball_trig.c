/* ball_trig.c: sine and cosine of balls.

   The midpoint is q pi/2 +- y in fixed point (fraction_angle.c), with as many limbs as the precision, the roundings to
   come and the leading zeros of y ask for.  What is wanted of sin y and cos y is computed (fraction_cos.c); a sine
   alone is the cosine of pi/2 - y, which needs no square root.  The ball's error is added at the end. */
#include "ball.h"
#include "fraction.h"

/* ---- sine and cosine of a reduced angle ---- */

/* The number of limbs that gives prec bits to the cosine, and to the sine of an angle with so many leading zeros (which
   may be over-estimated by a few).  The roundings cost 4^r ulp, r <= halvings + 1, times a few for each term of the
   series. */
static size_t limbs_needed(int64_t prec, int64_t zeros, size_t n)
{
    int64_t halvings = (int64_t)fraction_halvings(n), bits = prec < 64 ? 64 : prec;
    return (size_t)(bits + zeros + (zeros < halvings + 8 ? 2 * halvings + 2 : 0) + limb_bits(n) + 8 + 63) / 64;
}

/* s = sin y and c = cos y, unless NULL. */
static bool sin_cos_angle(draft *s, draft *c, angle *y)
{
    if (s && c)
        return fraction_sin_cos(s, c, y);
    if (c)
        return fraction_cos(c, y);
    if (angle_zeros(y) >= fraction_halvings(y->n))
        return fraction_sin_small(s, y);
    return fraction_angle_complement(y) && fraction_cos(s, y);
}

static void store_draft(ball *z, const draft *d, size_t n, bool negative, long prec)
{
    ball_store(z, d->w, n + 1, d->negative != negative, d->err, d->k, -64 * (int64_t)n, prec);
}

/* Thin x, not 0, with n limbs; s or c may be NULL.  Negative: no memory.  Otherwise the number of limbs with which it
   is good: if that is more than n, nothing was computed. */
static int64_t try_sin_cos(ball *s, ball *c, const ball *x, size_t n, long prec)
{
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 3 * (n + 1));
    angle y = {w, n, 0};
    unsigned turn;
    bool minus, negative = x->size < 0;
    int64_t answer = -1;
    if (w && fraction_angle_reduce(&y, &turn, &minus, x)) {
        bool odd = turn & 1, lower = turn & 2, sine = odd ? c != NULL : s != NULL, cosine = odd ? s != NULL : c != NULL;
        answer = (int64_t)limbs_needed(prec, sine ? (int64_t)angle_zeros(&y) + 2 : 2, n);
        draft sin_y = {w + n + 1, false, 0, 0}, cos_y = {w + 2 * (n + 1), false, 0, 0};
        if (answer > (int64_t)n)
            ;
        else if (!sin_cos_angle(sine ? &sin_y : NULL, cosine ? &cos_y : NULL, &y))
            answer = -1;
        else {
            if (s) /* sin y', cos y', -sin y', -cos y', y' = +- y */
                store_draft(s, odd ? &cos_y : &sin_y, n, (lower != (!odd && minus)) != negative, prec);
            if (c) /* cos y', -sin y', -cos y', sin y' */
                store_draft(c, odd ? &sin_y : &cos_y, n, lower != (odd && !minus), prec);
        }
    }
    ball_scratch_free(&space);
    return answer;
}

/* ---- thin arguments; s or c may be NULL, and x may be one of them ---- */

/* 0 < |x| < 2^top, top < -prec: sin x = x +- |x|^3 / 6, cos x = 1 +- x^2 / 2. */
static void sin_cos_tiny(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = ball_top(x);
    ball t;
    ball_init(&t);
    if (s) {
        ball_set_error(&t, 1, 3 * top - 2); /* ROUNDING: 1/6 < 1/4 */
        ball_add(s, x, &t, prec);
    }
    if (c) {
        ball_set_error(&t, 1, 2 * top - 1);
        ball_one(c);
        ball_add(c, c, &t, prec);
    }
    ball_clear(&t);
}

/* [-1, 1] */
static void any_sine(ball *s, ball *c, bool memory)
{
    if (s)
        memory ? ball_set_error(s, 1, 0) : ball_no_memory(s);
    if (c)
        memory ? ball_set_error(c, 1, 0) : ball_no_memory(c);
}

static void sin_cos_thin(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = x->size ? ball_top(x) : 0;
    if (x->size == 0) {
        if (s)
            ball_zero(s);
        if (c)
            ball_one(c);
    } else if (top < -(int64_t)prec)
        sin_cos_tiny(s, c, x, prec);
    else if (top > BALL_MAX_PRECISION / 4)
        any_sine(s, c, true);
    else {
        int64_t zeros = s && top < 0 ? 2 - top : 2, next;
        size_t n = (size_t)(prec < 64 ? 64 : prec) / 64 + 1;
        n = limbs_needed(prec, zeros, n);
        while ((next = try_sin_cos(s, c, x, n, prec)) > (int64_t)n)
            n = (size_t)next;
        if (next < 0)
            any_sine(s, c, false);
    }
}

/* ---- balls ---- */

static void sin_cos(ball *s, ball *c, const ball *x, long prec)
{
    if (ball_is_special(x)) {
        any_sine(s, c, !ball_lacks_memory(x));
        return;
    }
    prec = prec < 2 ? 2 : prec > BALL_MAX_PRECISION ? BALL_MAX_PRECISION : prec;
    if (x->error == 0) {
        sin_cos_thin(s, c, x, prec);
        return;
    }
    ball t, r;
    ball_init(&t);
    ball_init(&r);
    r.error = x->error;
    r.exponent = x->exponent;
    int64_t top = ball_top(x);
    /* no more digits than the error leaves; the cosine of a small angle has an error 2^top times as large */
    int64_t useful = (int64_t)ball_mantissa_bits(x) + BALL_ERROR_BITS + 8 + (c && top < 0 ? -2 * top : 0);
    ball_midpoint(&t, x, BALL_MAX_PRECISION);
    if (ball_is_special(&t))
        any_sine(s, c, false);
    else
        sin_cos_thin(s, c, &t, t.size && useful < prec && ball_top(&t) <= 2 ? (long)useful : prec);
    if (s)
        ball_add_error(s, s, &r, prec); /* ROUNDING: |sin(t + u) - sin t| <= |u| */
    if (c) {
        if (top < 0)
            r.exponent += top;
        ball_add_error(c, c, &r, prec); /* ROUNDING: |cos(t + u) - cos t| <= |u|, and <= |u| 2^top as |sin y| <= |y| */
    }
    ball_clear(&t);
    ball_clear(&r);
}

void ball_sin_cos(ball *s, ball *c, const ball *x, long prec) { sin_cos(s, c, x, prec); }
void ball_sin(ball *z, const ball *x, long prec) { sin_cos(z, NULL, x, prec); }
void ball_cos(ball *z, const ball *x, long prec) { sin_cos(NULL, z, x, prec); }

/* ---- pi r ---- */

/* sin(pi t) or cos(pi t), 0 < t <= 1/4. */
void ball_trig_of_turns(ball *z, const rational *t, bool of_sine, bool negative, long prec)
{
    prec = prec < 2 ? 2 : prec > BALL_MAX_PRECISION ? BALL_MAX_PRECISION : prec;
    /* pi t >= t >= 2^-zeros */
    int64_t zeros = 2 + (of_sine ? (int64_t)(integer_bits(&t->denominator) - integer_bits(&t->numerator)) + 1 : 0);
    size_t n = limbs_needed(prec, zeros, (size_t)(prec < 64 ? 64 : prec) / 64 + 1);
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 2 * (n + 1));
    angle y = {w, n, 0};
    draft d = {w ? w + n + 1 : NULL, false, 0, 0};
    if (w && fraction_angle_of_turns(&y, t) && sin_cos_angle(of_sine ? &d : NULL, of_sine ? NULL : &d, &y))
        store_draft(z, &d, n, negative, prec);
    else
        ball_no_memory(z);
    ball_scratch_free(&space);
}
