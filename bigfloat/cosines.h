/* cosines.h: numbers of a real cyclotomic field, exactly, as a number system (number.h).

   A `cosines` denotes the number q_0 + q_1 cos(pi/n) + q_2 cos(2 pi/n) + ..., q_i rational, or nothing that is known (it is
   indeterminate).  n is the last argument of every operation, where other systems have the precision, and the same for
   all numbers that meet.  Sums and products of known numbers are known; what would leave the field, and what is no
   polynomial (quotients by what is not a rational, roots, comparisons, hulls), is indeterminate.

   One number has several such sums, so only 0 with no term is certainly 0; lib/number_field.h has unique forms. */
#ifndef BIGFLOAT_COSINES_H
#define BIGFLOAT_COSINES_H

#include "number_array.h"
#include "rational.h"
#include "truth.h"

typedef enum { COSINES_KNOWN, COSINES_UNKNOWN, COSINES_NO_MEMORY } cosines_state;

typedef struct {
    cosines_state state;
    long count;     /* of the terms; those at most n/2 are enough */
    rational *term; /* term[i] cos(i pi/n) */
} cosines;

static inline void cosines_init(cosines *z)
{
    z->state = COSINES_KNOWN;
    z->count = 0;
    z->term = NULL;
}
void cosines_clear(cosines *z);
NUMBER_ARRAY_FUNCTIONS(cosines);

void cosines_set(cosines *z, const cosines *x);
static inline void cosines_swap(cosines *x, cosines *y)
{
    cosines t = *x;
    *x = *y;
    *y = t;
}
void cosines_zero(cosines *z);
void cosines_one(cosines *z);
void cosines_indeterminate(cosines *z);
void cosines_set_si(cosines *z, long v, long n);
void cosines_set_rational(cosines *z, const rational *q, long n);
/* Known where n r is whole. */
void cosines_cos_pi(cosines *z, const rational *r, long n);
void cosines_sin_pi(cosines *z, const rational *r, long n);
static inline void cosines_pi(cosines *z, long n)
{
    (void)n;
    cosines_indeterminate(z);
}

void cosines_neg(cosines *z, const cosines *x);
void cosines_add(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_sub(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_mul(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_addmul(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_div(cosines *z, const cosines *x, const cosines *y, long n);

/* Never known. */
void cosines_hull(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_abs(cosines *z, const cosines *x);
void cosines_min(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_max(cosines *z, const cosines *x, const cosines *y, long n);
void cosines_sqrt(cosines *z, const cosines *x, long n);

static inline truth cosines_is_zero(const cosines *x) { return x->state == COSINES_KNOWN && x->count == 0 ? TRUTH_TRUE : TRUTH_UNKNOWN; }
truth cosines_is_negative(const cosines *x);
truth cosines_less(const cosines *x, const cosines *y);
static inline bool cosines_lacks_memory(const cosines *x) { return x->state == COSINES_NO_MEMORY; }

#endif
