/* ball_atan.c: the arc tangent.

   For thin x, 0 < x <= 1: first an approximation a of 64 bits, then atan x = a + atan(d) with
   d = (x cos a - sin a) / (cos a + x sin a), which is tiny and so has a short series.  Whatever a is, this holds; only
   the length of the series depends on its quality.  Above 1, atan x = pi/2 - atan(1/x). */
#include "ball.h"
#include "ball_internal.h"

/* z = atan x for |x| <= 1/2.  The series x - x^3/3 + x^5/5 ... alternates with decreasing terms: what is left out is at
   most the first term left out. */
static void series(ball *z, const ball *x, long prec)
{
    ball power, square, term, sum;
    ball_init(&power);
    ball_init(&square);
    ball_init(&term);
    ball_init(&sum);
    ball_sqr(&square, x, prec);
    ball_set_round(&power, x, prec);
    int64_t enough = ball_is_special(x) || ball_is_exact_zero(x) ? 0 : ball_top(x) - prec - 4;
    for (long k = 1;; k += 2) {
        ball_div_si(&term, &power, k, prec);
        if (ball_is_special(&term) || ball_is_exact_zero(&term) || ball_top(&term) < enough)
            break;
        if (k % 4 == 1)
            ball_add(&sum, &sum, &term, prec);
        else
            ball_sub(&sum, &sum, &term, prec);
        ball_mul(&power, &power, &square, prec);
    }
    ball_add_error(z, &sum, &term, prec);
    ball_clear(&power);
    ball_clear(&square);
    ball_clear(&term);
    ball_clear(&sum);
}

/* z = atan x, 0 < x <= 1, about 64 bits: atan x = 2 atan(x / (1 + sqrt(1 + x^2))), three times. */
static void short_atan(ball *z, const ball *x)
{
    const long prec = 128;
    ball t, u, one;
    ball_init(&t);
    ball_init(&u);
    ball_init(&one);
    ball_one(&one);
    ball_set_round(&t, x, prec);
    for (int i = 0; i < 3; i++) {
        ball_sqr(&u, &t, prec);
        ball_add(&u, &u, &one, prec);
        ball_sqrt(&u, &u, prec);
        ball_add(&u, &u, &one, prec);
        ball_div(&t, &t, &u, prec);
    }
    series(&t, &t, prec);
    ball_mul_2exp(z, &t, 3, prec);
    ball_clear(&t);
    ball_clear(&u);
    ball_clear(&one);
}

/* x thin, 0 < x <= 1 */
static void atan_unit(ball *z, const ball *x, long prec)
{
    if (ball_top(x) < -10) {
        series(z, x, prec + 8);
        return;
    }
    ball a, s, c, t, u;
    ball_init(&a);
    ball_init(&s);
    ball_init(&c);
    ball_init(&t);
    ball_init(&u);
    const long working = prec + 16;
    short_atan(&a, x);
    if (prec > 100) {
        ball_midpoint(&a, &a, 64);
        ball_sin_cos(&s, &c, &a, working);
        ball_mul(&t, x, &c, working);
        ball_sub(&t, &t, &s, working);
        ball_mul(&u, x, &s, working);
        ball_add(&u, &u, &c, working);
        ball_div(&t, &t, &u, working);
        series(&t, &t, working);
        ball_add(&a, &a, &t, working);
    }
    ball_swap(z, &a);
    ball_clear(&a);
    ball_clear(&s);
    ball_clear(&c);
    ball_clear(&t);
    ball_clear(&u);
}

/* x thin, not 0 */
static void atan_thin(ball *z, const ball *x, long prec)
{
    ball t, u;
    ball_init(&t);
    ball_init(&u);
    bool negative = x->size < 0;
    ball_abs(&t, x);
    if (ball_top(&t) <= 0) /* x < 1 */
        atan_unit(z, &t, prec);
    else {
        ball_inv(&t, &t, prec + 16); /* not thin: 1 / x +- e, and atan' <= 1 */
        ball_radius_upper(&u, &t, BALL_MAX_PRECISION);
        ball_midpoint(&t, &t, BALL_MAX_PRECISION);
        atan_unit(&t, &t, prec);
        ball_add_error(&t, &t, &u, prec + 16);
        ball_pi(&u, prec + 16);
        ball_mul_2exp(&u, &u, -1, prec + 16);
        ball_sub(z, &u, &t, prec + 16);
    }
    if (negative)
        ball_neg(z, z);
    ball_clear(&t);
    ball_clear(&u);
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
    ball t, e;
    ball_init(&t);
    ball_init(&e);
    ball_midpoint(&t, x, BALL_MAX_PRECISION);
    propagated_error(&e, x);
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
