/* ball_trig.c: sine and cosine.

   The argument is brought to |t| <= about 1, halved r times, summed by Taylor's series in ball arithmetic, and doubled
   r times by sin 2t = 2 sin t cos t, cos 2t = 1 - 2 sin^2 t.  All rounding errors are carried by the balls; only
   the series' tail is added by hand. */
#include "ball.h"
#include "ball_internal.h"

/* s = sin t, c = cos t for |t| <= 1/4.  After the terms t^j / j! for j < J the rest is at most
   |t|^J / J! (Lagrange: all derivatives are at most 1 in absolute value). */
static void taylor(ball *s, ball *c, const ball *t, long prec)
{
    ball term, sum[2];
    ball_init(&term);
    ball_init(&sum[0]);
    ball_init(&sum[1]);
    ball_one(&term);
    long j = 0;
    for (;;) {
        if (j % 4 < 2)
            ball_add(&sum[j % 2], &sum[j % 2], &term, prec);
        else
            ball_sub(&sum[j % 2], &sum[j % 2], &term, prec);
        j++;
        ball_mul(&term, &term, t, prec);
        ball_div_si(&term, &term, j, prec);
        if (ball_is_special(&term) || ball_is_exact_zero(&term) || ball_top(&term) < -prec)
            break;
    }
    ball_add_error(c, &sum[0], &term, prec);
    ball_add_error(s, &sum[1], &term, prec);
    ball_clear(&term);
    ball_clear(&sum[0]);
    ball_clear(&sum[1]);
}

/* s, c = sin t, cos t for |t| <= 4; t is destroyed. */
static void sin_cos_reduced(ball *s, ball *c, ball *t, long prec)
{
    long halvings = 4 + prec / 64;
    if (halvings > 40)
        halvings = 40;
    if (!ball_is_exact_zero(t) && !ball_is_special(t)) {
        int64_t top = ball_top(t);
        halvings = top < -halvings ? 0 : halvings + (top > 0 ? top : 0);
    }
    long working = prec + 2 * halvings + 20;
    ball_mul_2exp(t, t, -halvings, working);
    taylor(s, c, t, working);
    for (long i = 0; i < halvings; i++) {
        ball_mul(c, c, s, working);
        ball_sqr(t, s, working);
        ball_mul_2exp(s, c, 1, working);
        ball_mul_2exp(t, t, 1, working);
        ball_one(c);
        ball_sub(c, c, t, working);
    }
    ball_set_round(s, s, prec);
    ball_set_round(c, c, prec);
}

/* s, c = [-1, 1] */
static void any_sine(ball *s, ball *c)
{
    ball_set_error(s, 1, 0);
    ball_set_error(c, 1, 0);
}

/* x = q pi/2 + t with q an integer near 2 x / pi; sine and cosine of x follow from those of t by q mod 4. */
static void sin_cos_large(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = ball_top(x);
    if (top > BALL_MAX_PRECISION / 4 || (x->error && x->exponent + limb_bits(x->error) > 4)) {
        any_sine(s, c);
        return;
    }
    ball quarter, t, u;
    integer q;
    ball_init(&quarter);
    ball_init(&t);
    ball_init(&u);
    integer_init(&q);
    long working = prec + (long)(top > 0 ? top : 0) + 20;
    ball_pi(&quarter, working);
    ball_mul_2exp(&quarter, &quarter, -1, working);
    ball_div(&t, x, &quarter, working);
    if (ball_mid_grid(&q, &t, 0)) {
        ball_set_integer_2exp(&u, &q, 0, BALL_MAX_PRECISION);
        ball_mul(&u, &u, &quarter, working);
        ball_sub(&t, x, &u, working);
        sin_cos_reduced(s, c, &t, prec);
        unsigned turn = q.size == 0 ? 0 : (unsigned)(integer_limbs(&q)[0] & 3);
        if (q.size < 0)
            turn = (4 - turn) & 3;
        if (turn & 1) { /* sin(t + pi/2) = cos t, cos(t + pi/2) = -sin t */
            ball_swap(s, c);
            ball_neg(c, c);
        }
        if (turn & 2) {
            ball_neg(s, s);
            ball_neg(c, c);
        }
    } else {
        ball_no_memory(s);
        ball_no_memory(c);
    }
    ball_clear(&quarter);
    ball_clear(&t);
    ball_clear(&u);
    integer_clear(&q);
}

void ball_sin_cos(ball *s, ball *c, const ball *x, long prec)
{
    ball t;
    ball_init(&t);
    ball_set(&t, x);
    if (ball_is_special(&t)) {
        if (t.error) {
            ball_no_memory(s);
            ball_no_memory(c);
        } else
            any_sine(s, c);
    } else if (ball_is_exact_zero(&t) || ball_top(&t) <= 1)
        sin_cos_reduced(s, c, &t, prec);
    else
        sin_cos_large(s, c, &t, prec);
    ball_clear(&t);
}

void ball_sin(ball *z, const ball *x, long prec)
{
    ball c;
    ball_init(&c);
    ball_sin_cos(z, &c, x, prec);
    ball_clear(&c);
}

void ball_cos(ball *z, const ball *x, long prec)
{
    ball s;
    ball_init(&s);
    ball_sin_cos(&s, z, x, prec);
    ball_clear(&s);
}
