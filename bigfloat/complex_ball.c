/* complex_ball.c: rectangular complex arithmetic, from balls. */
#include "complex_ball.h"

#include "ball_internal.h"

void complex_ball_clear(complex_ball *z)
{
    ball_clear(&z->re);
    ball_clear(&z->im);
}

void complex_ball_set(complex_ball *z, const complex_ball *x)
{
    ball_set(&z->re, &x->re);
    ball_set(&z->im, &x->im);
}

void complex_ball_set_balls(complex_ball *z, const ball *re, const ball *im)
{
    complex_ball t;
    complex_ball_init(&t);
    ball_set(&t.re, re);
    ball_set(&t.im, im);
    complex_ball_swap(z, &t);
    complex_ball_clear(&t);
}

void complex_ball_zero(complex_ball *z)
{
    ball_zero(&z->re);
    ball_zero(&z->im);
}

void complex_ball_one(complex_ball *z)
{
    ball_one(&z->re);
    ball_zero(&z->im);
}

void complex_ball_indeterminate(complex_ball *z)
{
    ball_indeterminate(&z->re);
    ball_indeterminate(&z->im);
}

void complex_ball_neg(complex_ball *z, const complex_ball *x)
{
    ball_neg(&z->re, &x->re);
    ball_neg(&z->im, &x->im);
}

void complex_ball_conj(complex_ball *z, const complex_ball *x)
{
    ball_set(&z->re, &x->re);
    ball_neg(&z->im, &x->im);
}

void complex_ball_add(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    ball_add(&z->re, &x->re, &y->re, prec);
    ball_add(&z->im, &x->im, &y->im, prec);
}

void complex_ball_sub(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    ball_sub(&z->re, &x->re, &y->re, prec);
    ball_sub(&z->im, &x->im, &y->im, prec);
}

void complex_ball_mul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    complex_ball_init(&t);
    ball_mul(&t.re, &x->re, &y->re, prec);
    ball_submul(&t.re, &x->im, &y->im, prec);
    ball_mul(&t.im, &x->re, &y->im, prec);
    ball_addmul(&t.im, &x->im, &y->re, prec);
    complex_ball_swap(z, &t);
    complex_ball_clear(&t);
}

void complex_ball_mul_ball(complex_ball *z, const complex_ball *x, const ball *y, long prec)
{
    ball t;
    ball_init(&t);
    ball_set(&t, y); /* y may be a part of z */
    ball_mul(&z->re, &x->re, &t, prec);
    ball_mul(&z->im, &x->im, &t, prec);
    ball_clear(&t);
}

void complex_ball_addmul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    complex_ball_init(&t);
    complex_ball_mul(&t, x, y, prec);
    complex_ball_add(z, z, &t, prec);
    complex_ball_clear(&t);
}

void complex_ball_submul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    complex_ball_init(&t);
    complex_ball_mul(&t, x, y, prec);
    complex_ball_sub(z, z, &t, prec);
    complex_ball_clear(&t);
}

/* Re = a^2 - b^2 by squares, which are never negative; Im = 2 a b. */
void complex_ball_sqr(complex_ball *z, const complex_ball *x, long prec)
{
    ball a, b;
    ball_init(&a);
    ball_init(&b);
    ball_sqr(&a, &x->re, prec);
    ball_sqr(&b, &x->im, prec);
    ball_sub(&a, &a, &b, prec);
    ball_mul(&b, &x->re, &x->im, prec);
    ball_mul_2exp(&z->im, &b, 1, prec);
    ball_swap(&z->re, &a);
    ball_clear(&a);
    ball_clear(&b);
}

void complex_ball_norm(ball *r, const complex_ball *x, long prec)
{
    ball t;
    ball_init(&t);
    ball_sqr(&t, &x->im, prec);
    ball_sqr(r, &x->re, prec);
    ball_add(r, r, &t, prec);
    ball_clear(&t);
}

/* If the sum of squares may be 0, or dips below by its rounding, |x| is in [0, sqrt(upper)]. */
void complex_ball_abs(ball *r, const complex_ball *x, long prec)
{
    ball t;
    ball_init(&t);
    complex_ball_norm(&t, x, prec + 8);
    if (ball_contains_zero(&t) && ball_is_finite(&t) && !ball_is_exact_zero(&t)) {
        limb_t w;
        int64_t k;
        ball_upper(&t, &t, prec + 8);
        ball_sqrt(&t, &t, prec);
        ball_magnitude_word(&w, &k, &t);
        if (ball_is_finite(&t))
            ball_set_from_zero(r, w, t.exponent + k);
        else
            ball_set(r, &t);
    } else
        ball_sqrt(r, &t, prec);
    ball_clear(&t);
}

void complex_ball_inv(complex_ball *z, const complex_ball *x, long prec)
{
    complex_ball t;
    ball norm;
    complex_ball_init(&t);
    ball_init(&norm);
    complex_ball_norm(&norm, x, prec);
    ball_div(&t.re, &x->re, &norm, prec);
    ball_div(&t.im, &x->im, &norm, prec);
    ball_neg(&t.im, &t.im);
    complex_ball_swap(z, &t);
    complex_ball_clear(&t);
    ball_clear(&norm);
}

/* x conj(y) / |y|^2 */
void complex_ball_div(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    ball norm;
    complex_ball_init(&t);
    ball_init(&norm);
    complex_ball_norm(&norm, y, prec);
    complex_ball_conj(&t, y);
    complex_ball_mul(&t, x, &t, prec);
    ball_div(&z->re, &t.re, &norm, prec);
    ball_div(&z->im, &t.im, &norm, prec);
    complex_ball_clear(&t);
    ball_clear(&norm);
}

void complex_ball_mul_2exp(complex_ball *z, const complex_ball *x, long e, long prec)
{
    ball_mul_2exp(&z->re, &x->re, e, prec);
    ball_mul_2exp(&z->im, &x->im, e, prec);
}

void complex_ball_pow_ui(complex_ball *z, const complex_ball *x, unsigned long n, long prec)
{
    complex_ball base, power;
    complex_ball_init(&base);
    complex_ball_init(&power);
    complex_ball_set(&base, x);
    complex_ball_one(&power);
    for (unsigned long bit = n ? 1UL << (limb_bits(n) - 1) : 0; bit; bit /= 2) {
        complex_ball_sqr(&power, &power, prec);
        if (n & bit)
            complex_ball_mul(&power, &power, &base, prec);
    }
    complex_ball_swap(z, &power);
    complex_ball_clear(&base);
    complex_ball_clear(&power);
}

/* For a >= 0: u = sqrt((|x| + a) / 2), root = u + i b / (2 u).  For a < 0, b of one sign: v = sqrt((|x| - a) / 2),
   root = |b| / (2 v) + i v sign(b).  Each adds numbers of one sign. */
void complex_ball_sqrt(complex_ball *z, const complex_ball *x, long prec)
{
    bool right = ball_is_positive(&x->re) == TRUTH_TRUE, above = ball_is_positive(&x->im) == TRUTH_TRUE;
    bool below = ball_is_negative(&x->im) == TRUTH_TRUE;
    if (ball_is_zero(&x->re) == TRUTH_TRUE && ball_is_zero(&x->im) == TRUTH_TRUE) {
        complex_ball_zero(z);
        return;
    }
    if (!right && !above && !below) {
        ball_indeterminate_like(&z->re, &x->re, &x->im);
        ball_set(&z->im, &z->re);
        return;
    }
    const long working = prec + 8;
    ball u, t;
    ball_init(&u);
    ball_init(&t);
    complex_ball_abs(&u, x, working);
    if (right)
        ball_add(&u, &u, &x->re, working);
    else
        ball_sub(&u, &u, &x->re, working);
    ball_mul_2exp(&u, &u, -1, working);
    ball_sqrt(&u, &u, working);
    ball_mul_2exp(&t, &u, 1, working);
    ball_div(&t, &x->im, &t, working);
    if (!right && below) {
        ball_neg(&t, &t);
        ball_neg(&u, &u);
    }
    ball_set_round(&z->re, right ? &u : &t, prec);
    ball_set_round(&z->im, right ? &t : &u, prec);
    ball_clear(&u);
    ball_clear(&t);
}

void complex_ball_root_of_unity(complex_ball *z, const rational *r, long prec)
{
    rational twice;
    rational_init(&twice);
    if (rational_mul_2exp(&twice, r, 1)) {
        ball_cos_pi(&z->re, &twice, prec);
        ball_sin_pi(&z->im, &twice, prec);
    } else {
        ball_no_memory(&z->re);
        ball_no_memory(&z->im);
    }
    rational_clear(&twice);
}

bool complex_ball_contains_zero(const complex_ball *x)
{
    return ball_contains_zero(&x->re) && ball_contains_zero(&x->im);
}
bool complex_ball_contains(const complex_ball *x, const complex_ball *y)
{
    return ball_contains(&x->re, &y->re) && ball_contains(&x->im, &y->im);
}
bool complex_ball_overlaps(const complex_ball *x, const complex_ball *y)
{
    return ball_overlaps(&x->re, &y->re) && ball_overlaps(&x->im, &y->im);
}
bool complex_ball_is_finite(const complex_ball *x) { return ball_is_finite(&x->re) && ball_is_finite(&x->im); }
bool complex_ball_lacks_memory(const complex_ball *x) { return ball_lacks_memory(&x->re) || ball_lacks_memory(&x->im); }
