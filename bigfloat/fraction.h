/* fraction.h: numbers in [0, 1) as n limbs, lowest first, in units ulp = 2^(-64 n); and pi, the sine, the cosine and
   the arc tangent in such fixed point.

   A *draft* has n + 1 limbs, the highest one being its integer part, and is known up to err 2^k ulp: ball_store makes
   a ball of it.  Every bound is derived in errors-trig.md, section by section as the files are named there.
   A function that answers bool answers false only for want of memory. */
#ifndef BIGFLOAT_FRACTION_H
#define BIGFLOAT_FRACTION_H

#include "ball_internal.h"
#include "rational.h"

/* z = a b - d and z = a^2 - d with 0 <= d < 2 ulp (product), 0 <= d < 1 ulp (square).  z may be a or b; p has
   2 n limbs of space. */
bool fraction_mul(limb_t *z, const limb_t *a, const limb_t *b, size_t n, limb_t *p);
bool fraction_square(limb_t *z, const limb_t *a, size_t n, limb_t *p);

/* z = floor(a / 2^s), any s. */
void fraction_shift_right(limb_t *z, const limb_t *a, size_t n, size_t s);

/* floor(pi 2^(64 n)), or one less: n + 1 limbs; n < 2^20. */
bool fraction_pi(limb_t *p, size_t n);
bool fraction_pi_series(limb_t *p, size_t n); /* the same without the table */

typedef struct {
    limb_t *w; /* n + 1 limbs, the magnitude */
    bool negative;
    limb_t err;
    int64_t k;
} draft;

/* An angle X 2^(-64 n), wrong by at most `wrong` <= 2^20 ulp. */
typedef struct {
    limb_t *w;
    size_t n;
    limb_t wrong;
} angle;

/* Leading zero bits, at most 64 n. */
static inline size_t angle_zeros(const angle *x) { return 64 * x->n - limb_bit_length(x->w, x->n); }

/* x = |m| 2^e, e the exponent of `of` and m its mantissa, not 0, |x| < 2^top, is q pi/2 + y or q pi/2 - y (*minus) with
   y about pi/4 at most; *turn = q modulo 4.  x.w has n + 1 limbs. */
bool fraction_angle_reduce(angle *x, unsigned *turn, bool *minus, const ball *of);
/* x = |m| 2^e, and 1 / (|m| 2^e), below 2; m != 0. */
void fraction_angle_set(angle *x, const ball *of);
bool fraction_angle_set_inverse(angle *x, const ball *of);
/* x becomes pi/2 - x; x < pi/2 */
bool fraction_angle_complement(angle *x);
/* pi t for a rational 0 <= t < 1 */
bool fraction_angle_of_turns(angle *x, const rational *t);

/* Below 2^-fraction_halvings(n) an angle is small: sine and cosine have their own series. */
size_t fraction_halvings(size_t n);

/* cos y (first = 1) or sin(y) / y (first = 2), as n + 1 limbs with an error of at most *err ulp, from z = floor(y^2);
   0 <= y < 2^-fraction_halvings(n), which is below 2^-6.  The sum is that of (-1)^k z^k / (d_1 ... d_k), with
   d_k = (2 k - 1) 2 k or 2 k (2 k + 1). */
bool fraction_series(limb_t *sum, limb_t *err, const limb_t *z, size_t n, limb_t first);

/* w = cos x, 0 <= x < 1.58. */
bool fraction_cos(draft *c, const angle *x);
/* w = sin x, 0 <= x < 0.8 and small as defined above. */
bool fraction_sin_small(draft *s, const angle *x);
/* both, x < 0.8 */
bool fraction_sin_cos(draft *s, draft *c, const angle *x);

/* w = atan x, 0 <= x <= 1. */
bool fraction_atan(draft *a, const angle *x);

/* z = +- sin(pi t) or cos(pi t), 0 < t <= 1/4 (ball_trig.c) */
void ball_trig_of_turns(ball *z, const rational *t, bool of_sine, bool negative, long prec);

#endif
