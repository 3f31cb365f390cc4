/* ball_atan.c: the arc tangent of balls.

   That of the midpoint in fixed point (fraction_atan.c), above 1 as pi/2 - atan(1/x); then the ball's error. */
#include "ball.h"
#include "fraction.h"

/* 0 < |x| < 2^top, top < -prec: atan x = x +- |x|^3 / 3 */
static void atan_tiny(ball *z, const ball *x, long prec)
{
    ball t;
    ball_init(&t);
    ball_set_error(&t, 1, 3 * ball_top(x) - 1); /* ROUNDING: 1/3 < 1/2 */
    ball_add(z, x, &t, prec);
    ball_clear(&t);
}

/* |x| >= 2^(top - 1), top > prec + 2: pi/2 - 1/|x| < atan |x| < pi/2 */
static void atan_huge(ball *z, bool negative, int64_t top, long prec)
{
    ball t;
    ball_init(&t);
    ball_set_error(&t, 1, 1 - top); /* ROUNDING: atan(1/x) < 1/x */
    ball_pi(z, prec);
    ball_mul_2exp(z, z, -1, prec);
    ball_add(z, z, &t, prec);
    if (negative)
        ball_neg(z, z);
    ball_clear(&t);
}

/* x thin, not 0; z may be x */
static void atan_thin(ball *z, const ball *x, long prec)
{
    int64_t top = ball_top(x);
    bool negative = x->size < 0, inverse = top > 0, ok;
    if (top < -(int64_t)prec) {
        atan_tiny(z, x, prec);
        return;
    }
    if (top > prec + 2) {
        atan_huge(z, negative, top, prec);
        return;
    }
    int64_t bits = prec < 64 ? 64 : prec, zeros = top < 0 ? -top : 0;
    size_t n = (size_t)(bits + zeros) / 64 + 1;
    n = (size_t)(bits + zeros + 2 * (int64_t)fraction_halvings(n) + limb_bits(n) + 10 + 63) / 64;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 2 * (n + 1));
    angle y = {w, n, 0};
    draft a = {w ? w + n + 1 : NULL, false, 0, 0};
    ok = w && (inverse ? fraction_angle_set_inverse(&y, x) : (fraction_angle_set(&y, x), true)) && fraction_atan(&a, &y);
    if (ok && inverse) {
        angle b = {a.w, n, 0};
        ok = fraction_angle_complement(&b);
        a.err += b.wrong;
    }
    if (ok)
        ball_store(z, a.w, n + 1, negative, a.err, a.k, -64 * (int64_t)n, prec);
    else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

/* e >= |atan t - atan m| for every t of x = m +- r: r / (1 + l^2), where l <= |t|. */
static void propagated_error(ball *e, const ball *x)
{
    ball l, one;
    ball_init(&l);
    ball_init(&one);
    ball_one(&one);
    ball_abs(&l, x);
    ball_lower(&l, &l, 64);
    ball_sqr(&l, &l, 64);
    ball_add(&l, &l, &one, 64);
    ball_radius_upper(e, x, BALL_MAX_PRECISION);
    ball_div(e, e, &l, 64);
    ball_clear(&l);
    ball_clear(&one);
}

void ball_atan(ball *z, const ball *x, long prec)
{
    if (ball_is_special(x)) { /* [-2, 2] */
        bool memory = ball_lacks_memory(x);
        ball_set_error(z, 2, 0);
        if (memory)
            ball_no_memory(z);
        return;
    }
    prec = prec < 2 ? 2 : prec > BALL_MAX_PRECISION ? BALL_MAX_PRECISION : prec;
    if (x->error == 0 && x->size) {
        atan_thin(z, x, prec);
        return;
    }
    ball t, e;
    ball_init(&t);
    ball_init(&e);
    ball_midpoint(&t, x, BALL_MAX_PRECISION);
    propagated_error(&e, x);
    /* no more digits than the error leaves */
    long useful = (long)ball_mantissa_bits(x) + BALL_ERROR_BITS + 8;
    if (t.size && useful < prec && ball_top(&t) <= 2)
        prec = useful;
    if (!ball_is_special(&t) && !ball_is_exact_zero(&t))
        atan_thin(&t, &t, prec);
    ball_add_error(&t, &t, &e, prec);
    ball_set_round(z, &t, prec);
    ball_clear(&t);
    ball_clear(&e);
}

/* With x > 0: atan(y / x).  With y > 0: pi/2 - atan(x / y); with y < 0: -pi/2 - atan(x / y).  With x < 0 and y around 0:
   pi + atan(y / x), which passes pi where y is negative; with y = 0 exactly it is pi. */
void ball_atan2(ball *z, const ball *y, const ball *x, long prec)
{
    ball t, half_pi;
    ball_init(&t);
    ball_init(&half_pi);
    const long working = prec + 8;
    ball_pi(&half_pi, working);
    ball_mul_2exp(&half_pi, &half_pi, -1, working);
    truth right = ball_is_positive(x), above = ball_is_positive(y), below = ball_is_negative(y);
    if (right == TRUTH_TRUE) {
        ball_div(&t, y, x, working);
        ball_atan(&t, &t, working);
    } else if (above == TRUTH_TRUE || below == TRUTH_TRUE) {
        ball_div(&t, x, y, working);
        ball_atan(&t, &t, working);
        if (below == TRUTH_TRUE)
            ball_neg(&half_pi, &half_pi);
        ball_sub(&t, &half_pi, &t, working);
    } else if (ball_is_negative(x) == TRUTH_TRUE) {
        ball_div(&t, y, x, working);
        ball_atan(&t, &t, working);
        ball_mul_2exp(&half_pi, &half_pi, 1, working);
        ball_add(&t, &t, &half_pi, working);
    } else
        ball_indeterminate_like(&t, x, y);
    ball_set_round(z, &t, prec);
    ball_clear(&t);
    ball_clear(&half_pi);
}
