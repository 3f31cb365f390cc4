/* power.h: the coefficients of powers of a subdivision operator, in machine words, exactly or with a proved error.

   For a mask s the power N is s^N(z) = s(z) s(z^2) ... s(z^(2^(N-1))), the mask of N steps at once.  A `mask_power` holds
   it on its box, which begins at (0,0): s is multiplied by a monomial first, which moves the coefficients of s^N and
   permutes their classes modulo 2^N, no more.  Coefficients are integers over total_denominator, which for exact powers is
   denominator^N.  Around the box lie zeros, as many as the box of s is wide and high.

   Row x of S^N holds the coefficients s^N(x - 2^N y), y in Z^2.  A *rounded* power is for masks with long coefficients:
   those of s are rounded down to multiples of 2^-POWER_MASK_BITS and those of the powers towards 0 to multiples of
   2^-POWER_ENTRY_BITS, and each row differs from the true one by at most `error` in the sum of |numerator|, which stays
   0 as long as nothing had to be rounded.

   No sum that is ever formed exceeds POWER_MAX_SUM in absolute value: the row sums of |numerator of s^N| are at most (that
   of s)^N.  Whoever needs more, or more than POWER_MAX_ENTRIES coefficients, or more than POWER_MAX_WORK
   multiplications for one product, is told so. */
#ifndef LIB_POWER_H
#define LIB_POWER_H

#include "laurent.h"

#define POWER_MAX_SUM ((int64_t)1 << 62)
#define POWER_MAX_ENTRIES ((int64_t)1 << 23)
#define POWER_MAX_WORK 2e8
#define POWER_MASK_BITS 18
#define POWER_ENTRY_BITS 30

typedef struct {
    long a, b;
    int64_t coefficient;
    bool rounded;
} power_term;

typedef struct {
    int exponent;              /* N */
    long na, nb;               /* the box is 0 <= a < na, 0 <= b < nb */
    long margin_a, margin_b;   /* of zeros on every side */
    long stride;               /* nb + 2 margin_b */
    int64_t *entry;
    int64_t row_sum;           /* a bound of every row's sum of |numerator| */
    int64_t error;             /* a bound of every row's error; 0 if exact */
    bool rounded;
    power_term *term;          /* of s, where it is not 0, in order of a then b */
    int terms;
    int64_t term_row_sum;      /* the row sum of s itself */
    int rounded_terms;         /* the most terms in one class modulo 2 that were rounded */
    integer denominator;       /* of s, exact powers only */
    integer total_denominator;
} mask_power;

typedef enum { POWER_OK, POWER_TOO_LARGE, POWER_NO_MEMORY } power_status;

void power_init(mask_power *z);
void power_clear(mask_power *z);

/* z = s^0 = 1.  On any status power_clear. */
power_status power_start(mask_power *z, const laurent *s, bool rounded);
/* From s^N to s^(N+1).  POWER_TOO_LARGE: z is s^N as before; POWER_NO_MEMORY: z can only be cleared. */
power_status power_raise(mask_power *z);

/* The coefficient at (a,b), which lies in the box or its margin. */
static inline const int64_t *power_at(const mask_power *z, long a, long b)
{
    return z->entry + (a + z->margin_a) * z->stride + (b + z->margin_b);
}

/* norm = |S^N|: the largest sum of |coefficient| over a class modulo 2^N ([Z] 4.29).  (Of a rounded power a bound.) */
BIGFLOAT_MUST_USE bool power_norm(rational *norm, const mask_power *z);

/* sum = the largest sum of |p * (row x) - q * (row x + d)|, numerators, over all x; of a rounded power a bound of it
   for the true rows.  d must lie within the margins (|d.a| <= margin_a ...), 2 (|p| + |q|) row_sum must not exceed
   POWER_MAX_SUM, nor error row_sum.  false: no memory. */
BIGFLOAT_MUST_USE bool power_largest_difference(int64_t *sum, const mask_power *z, lattice d, int64_t p, int64_t q);

#endif
