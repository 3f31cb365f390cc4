/* complex_ball.h: rectangles in the complex plane.

   A `complex_ball` denotes the set of complex numbers a + b i with a in the ball `re` and b in the ball `im`; it is
   indeterminate in a direction whose ball is.  Operations enclose the result for every choice of numbers in the
   operands; outputs may be inputs; prec is the precision of the balls. */
#ifndef BIGFLOAT_COMPLEX_BALL_H
#define BIGFLOAT_COMPLEX_BALL_H

#include "ball.h"

typedef struct {
    ball re;
    ball im;
} complex_ball;

static inline void complex_ball_init(complex_ball *z) /* z = 0; never allocates */
{
    ball_init(&z->re);
    ball_init(&z->im);
}
static inline void complex_ball_swap(complex_ball *x, complex_ball *y)
{
    complex_ball t = *x;
    *x = *y;
    *y = t;
}

void complex_ball_clear(complex_ball *z);
void complex_ball_set(complex_ball *z, const complex_ball *x);
void complex_ball_set_balls(complex_ball *z, const ball *re, const ball *im);
void complex_ball_zero(complex_ball *z);
void complex_ball_one(complex_ball *z);
void complex_ball_indeterminate(complex_ball *z);

void complex_ball_neg(complex_ball *z, const complex_ball *x);
void complex_ball_conj(complex_ball *z, const complex_ball *x);
void complex_ball_add(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_sub(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_mul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_mul_ball(complex_ball *z, const complex_ball *x, const ball *y, long prec);
void complex_ball_addmul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_submul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_sqr(complex_ball *z, const complex_ball *x, long prec);
void complex_ball_inv(complex_ball *z, const complex_ball *x, long prec); /* indeterminate if 0 is inside */
void complex_ball_div(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec);
void complex_ball_mul_2exp(complex_ball *z, const complex_ball *x, long e, long prec);
void complex_ball_pow_ui(complex_ball *z, const complex_ball *x, unsigned long n, long prec); /* 0^0 = 1 */
/* The root with nonnegative real part; indeterminate if x meets the closed negative real axis, 0 included,
   unless x is exactly 0. */
void complex_ball_sqrt(complex_ball *z, const complex_ball *x, long prec);

void complex_ball_abs(ball *r, const complex_ball *x, long prec);
void complex_ball_norm(ball *r, const complex_ball *x, long prec); /* |x|^2 */
/* exp(2 pi i r); exact parts where they are rational. */
void complex_ball_root_of_unity(complex_ball *z, const rational *r, long prec);

bool complex_ball_contains_zero(const complex_ball *x);
bool complex_ball_contains(const complex_ball *x, const complex_ball *y);
bool complex_ball_overlaps(const complex_ball *x, const complex_ball *y);
bool complex_ball_is_finite(const complex_ball *x);
bool complex_ball_lacks_memory(const complex_ball *x);

#endif
