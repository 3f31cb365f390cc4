/* ball_internal.h: what the sources of balls share.

   A result is first formed in a *draft*: limbs in scratch space, an error err 2^k in units of the draft's last
   place, an exponent.  ball_store rounds the draft into a ball. */
#ifndef BIGFLOAT_BALL_INTERNAL_H
#define BIGFLOAT_BALL_INTERNAL_H

#include <stdlib.h>

#include "ball.h"
#include "integer_internal.h"
#include "limb.h"

static inline const limb_t *ball_limbs(const ball *x) { return x->capacity ? x->at.heap : x->at.inline_limbs; }
static inline size_t ball_length(const ball *x) { return (size_t)(x->size < 0 ? -x->size : x->size); }
static inline bool ball_is_special(const ball *x) { return x->exponent == BALL_INDETERMINATE; }
static inline bool ball_is_exact_zero(const ball *x) { return x->size == 0 && x->error == 0; }
static inline size_t ball_mantissa_bits(const ball *x)
{
    size_t n = ball_length(x);
    return n ? 64 * n - (size_t)limb_clz(ball_limbs(x)[n - 1]) : 0;
}

/* The mantissa's greatest length in bits at precision prec. */
static inline int64_t ball_room_bits(long prec)
{
    if (prec < 2)
        return 64;
    return prec > BALL_MAX_PRECISION ? BALL_MAX_PRECISION : (prec + 63) / 64 * 64;
}

/* The whole line; the second one remembers the missing memory. */
void ball_no_memory(ball *z);
void ball_indeterminate_like(ball *z, const ball *x, const ball *y); /* lacks memory if x or y does */

/* Room for n limbs, old value lost; NULL = no memory. */
limb_t *ball_fresh(ball *z, size_t n);

/* z = (+-w +- err 2^k) 2^e, rounded to prec; k >= 0.  w has n limbs (high zeros allowed), is destroyed, and is
   not part of z. */
void ball_store(ball *z, limb_t *w, size_t n, bool negative, limb_t err, int64_t k, int64_t e, long prec);

/* Mantissa and error are in place: bring the exponent into its range. */
void ball_settle_exponent(ball *z);

/* |x| < 2^top for every number x of the ball: bits of (|m| + err), plus e.  Only for finite balls that are
   not exactly 0. */
int64_t ball_top(const ball *x);

/* |m| + err <= *w 2^*k with *w < 2^31 + 2; w = |m| + err and k = 0 if |m| < 2^30. */
void ball_magnitude_word(limb_t *w, int64_t *k, const ball *x);

/* |m| <= *w 2^*k in the same way, without the error. */
void ball_mantissa_word(limb_t *w, int64_t *k, const ball *x);

/* ceil(a 2^i / 2^k); when k < i the result must fit. */
static inline limb_t ball_error_at(int64_t k, limb_t a, int64_t i)
{
    if (k <= i)
        return a << (i - k);
    int64_t d = k - i;
    return d < 64 ? (a >> d) + ((a & (((limb_t)1 << d) - 1)) != 0) : a != 0; /* ROUNDING: ceiling */
}

/* a 2^i + b 2^j <= result 2^*k, a, b < 2^63, i, j >= 0.  *k is low enough that the greater of the two keeps 40 bits,
   and so high that both stay below 2^63. */
static inline limb_t ball_error_sum(int64_t *k, limb_t a, int64_t i, limb_t b, int64_t j)
{
    int64_t ta = a ? i + limb_bits(a) : 0, tb = b ? j + limb_bits(b) : 0, t = (ta > tb ? ta : tb) - 40;
    *k = t > 0 ? t : 0;
    return ball_error_at(*k, a, i) + ball_error_at(*k, b, j);
}

/* Scratch limbs: on the stack while they are few. */
#define BALL_STACK_LIMBS 80
typedef struct {
    limb_t stack[BALL_STACK_LIMBS];
    limb_t *heap;
} ball_scratch;

static inline limb_t *ball_scratch_new(ball_scratch *s, size_t n)
{
    s->heap = NULL;
    if (n <= BALL_STACK_LIMBS)
        return s->stack;
    return s->heap = malloc(n * sizeof(limb_t));
}
static inline void ball_scratch_free(ball_scratch *s) { free(s->heap); }

/* ball_dot_strided where it is simple: false, and z is as before, if it is not (ball_dot_even.c). */
bool ball_dot_even(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec);

/* ---- thin numbers: +- w 2^e, compared exactly ---- */

typedef struct {
    const limb_t *w;
    size_t n;
    bool negative;
    int64_t e;
} dyadic;

/* -1, 0, 1: the order of two dyadic numbers; high zero limbs are not allowed in w. */
int ball_dyadic_compare(const dyadic *x, const dyadic *y);
/* The endpoint m - err (upper = false) or m + err, in w, which has room for ball_length(x) + 1 limbs. */
void ball_endpoint(dyadic *d, limb_t *w, const ball *x, bool upper);

/* z = the least ball (up to rounding) that contains [lower, upper]; both thin; lower <= upper. */
void ball_set_thin_bounds(ball *z, const ball *lower, const ball *upper, long prec);

/* z contains [0, t 2^e], and no negative number. */
void ball_set_from_zero(ball *z, limb_t t, int64_t e);

/* z = 0 +- w 2^k, w < 2^63. */
void ball_set_error(ball *z, limb_t w, int64_t k);

#endif
