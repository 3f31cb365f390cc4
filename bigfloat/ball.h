/* ball.h: real numbers known up to an error, of any precision (BigFloat).

   A finite `ball` denotes the set of real numbers x with

       (m - err) 2^e  <=  x  <=  (m + err) 2^e,

   m a signed integer of any length (sign and magnitude, 64-bit limbs, lowest first), err one machine word
   that counts units of m's last place, e an exponent.  An *indeterminate* ball denotes the whole line.

   What always holds:
     |size| is the number of limbs of m, the sign of size is the sign of m, and the highest limb is not zero;
     err < 2^BALL_ERROR_BITS: when the error grows beyond, m and err are shifted right together, so that a
       mantissa never carries digits that the error has eaten;
     |e| <= BALL_MAX_EXPONENT, and a ball with m = err = 0 has e = 0.  A result whose exponent would be too
       large is indeterminate, one whose exponent would be too small is a ball around 0;
     an indeterminate ball has size 0 and e = BALL_INDETERMINATE; its err is 1 if memory was missing in the
       computation that led to it, else 0.
   Up to BALL_INLINE_LIMBS limbs live inside the value, without allocation.

   The operations are those of number.h; z becomes a ball that contains the result for every choice of
   numbers in the inputs.  `prec` >= 2 is the precision in bits: m keeps at most the next multiple of 64 bits,
   and a result that was cut carries one more unit of error.  A result that is exact and fits this length is
   exact.  Every result is a function of the inputs and prec only, the same on every machine. */
#ifndef BIGFLOAT_BALL_H
#define BIGFLOAT_BALL_H

#include <limits.h>

#include "number_array.h"
#include "number_common.h"

#define BALL_INLINE_LIMBS 4
#define BALL_ERROR_BITS 30
#define BALL_MAX_EXPONENT ((int64_t)1 << 40)
#define BALL_INDETERMINATE INT64_MAX
#define BALL_MAX_PRECISION ((long)1 << 24)

typedef struct {
    int64_t exponent;
    uint64_t error;
    int32_t size;
    uint32_t capacity; /* 0: limbs inline; else the number of limbs that heap can hold */
    union {
        uint64_t inline_limbs[BALL_INLINE_LIMBS];
        uint64_t *heap;
    } at;
} ball;

static inline void ball_init(ball *z) /* z = 0; never allocates */
{
    z->exponent = 0;
    z->error = 0;
    z->size = 0;
    z->capacity = 0;
}

static inline void ball_swap(ball *x, ball *y)
{
    ball t = *x;
    *x = *y;
    *y = t;
}

NUMBER_DECLARE(ball);
NUMBER_DECLARE_SLOW(ball);
NUMBER_ARRAY_FUNCTIONS(ball);

/* True bounds of the ball as doubles, possibly infinite; and a double near its midpoint.  The rounding mode
   of the machine has no influence on them. */
double ball_mid_approx(const ball *x);
double ball_lower_bound(const ball *x);
double ball_upper_bound(const ball *x);

/* ---- for balls only ---- */

void ball_set_round(ball *z, const ball *x, long prec);               /* x, cut to prec */
/* x y + w, rounded once.  (ball_addmul and ball_submul round the product first when that is quicker and the operands are
   inexact anyway; exact operands are always treated exactly.) */
void ball_fma(ball *z, const ball *x, const ball *y, const ball *w, long prec);
/* The sum of x[i] y[i] for i < n, rounded once. */
void ball_dot(ball *z, const ball *x, const ball *y, size_t n, long prec);
/* The same where neighbours lie `xstride` and `ystride` balls apart. */
void ball_dot_strided(ball *z, const ball *x, long xstride, const ball *y, long ystride, size_t n, long prec);
void ball_pow_ui(ball *z, const ball *x, unsigned long n, long prec); /* x^n, 0^0 = 1 */
void ball_pow_si(ball *z, const ball *x, long n, long prec);
/* The number of bits of the midpoint that the error leaves, about log2(|m| / err): LONG_MAX for an exact ball,
   <= 0 if the ball contains 0, LONG_MIN if indeterminate. */
long ball_accuracy_bits_approx(const ball *x);

void ball_cos(ball *z, const ball *x, long prec);
void ball_sin(ball *z, const ball *x, long prec);
void ball_sin_cos(ball *s, ball *c, const ball *x, long prec); /* s and c different objects */
void ball_atan(ball *z, const ball *x, long prec);
/* The angle of the point (x, y), in (-pi, pi]; if the set of points crosses the negative axis, continued across it:
   around pi, for points below the axis as well (their angle plus 2 pi).  Indeterminate if (0, 0) cannot be excluded. */
void ball_atan2(ball *z, const ball *y, const ball *x, long prec);

/* m, err and e as numbers; false = no memory or indeterminate.  The outputs may be NULL. */
BIGFLOAT_MUST_USE bool ball_get_parts(integer *m, uint64_t *err, int64_t *e, const ball *x);
/* z = (m +- err) 2^e, exactly, if err < 2^BALL_ERROR_BITS; else the least such ball around it. */
void ball_set_parts(ball *z, const integer *m, uint64_t err, int64_t e);
/* Same m, err and e? */
bool ball_identical(const ball *x, const ball *y);
/* Can x and y be equal? */
bool ball_overlaps(const ball *x, const ball *y);

/* ---- text: every string is malloc'ed, NULL = no memory ---- */

/* ball_get_decimal (declared above): "0.53088 +/- 3.1e-17", with `digits` digits or fewer if the error has eaten the rest: every
   number of x is within the printed error of the printed decimal.  An exact ball that `digits` digits show
   completely has no error printed.  "indeterminate" for the whole line. */
/* The shortest such decimal from which an error of at most twice the ball's own follows. */
char *ball_get_str(const ball *x);
/* Reads what the two functions above print, "indeterminate", or any decimal, as a ball that contains it:
   the decimal and its error are read exactly and enclosed with prec. */
rational_text_status ball_set_str(ball *z, const char *text, size_t length, long prec);

/* The exact form: mantissa, error and exponent, e.g. "-0x1f3 0x2 -17", or "indeterminate".  Reading it back gives an
   identical ball. */
char *ball_get_hex(const ball *x);
rational_text_status ball_set_hex(ball *z, const char *text, size_t length);

#endif
