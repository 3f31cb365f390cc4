/* laurent.h: Laurent polynomials in two variables with rational coefficients, exactly.

   A `laurent` denotes the sum over the lattice points (a,b) of its box, a0 <= a < a0 + na, b0 <= b < b0 + nb, of
   coefficient(a,b) / denominator * z1^a z2^b.  The coefficients are integers over one common denominator, which
   is positive and need not be the least.  The box may be larger than the support; na = nb = 0 is the zero
   polynomial.  Masks of subdivision schemes are such polynomials (the "symbol").

   A function that may allocate returns false when there is no memory. */
#ifndef LIB_LAURENT_H
#define LIB_LAURENT_H

#include "../bigfloat/rational.h"
#include "lattice.h"

typedef struct {
    long a0, b0;
    long na, nb;
    integer *coefficient; /* na * nb of them, b fastest */
    integer denominator;
} laurent;

void laurent_init(laurent *z); /* z = 0; never allocates */
void laurent_clear(laurent *z);
void laurent_swap(laurent *x, laurent *y);
BIGFLOAT_MUST_USE bool laurent_set(laurent *z, const laurent *x);

/* z = the zero polynomial on the box given, denominator 1: coefficients can then be set one by one. */
BIGFLOAT_MUST_USE bool laurent_set_box(laurent *z, long a0, long b0, long na, long nb);

/* z = sum of weight[i] z^point[i], points distinct; the box is the points' own. */
BIGFLOAT_MUST_USE bool laurent_set_terms(laurent *z, const lattice *point, const rational *weight, size_t count);

/* The integer coefficient (over the denominator) at (a,b), NULL outside the box: 0. */
const integer *laurent_at(const laurent *x, long a, long b);
bool laurent_is_zero_at(const laurent *x, long a, long b);
/* q = the coefficient at (a,b). */
BIGFLOAT_MUST_USE bool laurent_get(rational *q, const laurent *x, long a, long b);

BIGFLOAT_MUST_USE bool laurent_sub(laurent *z, const laurent *x, const laurent *y);
/* Fast if x has many zeros. */
BIGFLOAT_MUST_USE bool laurent_mul(laurent *z, const laurent *x, const laurent *y);
BIGFLOAT_MUST_USE bool laurent_mul_si(laurent *z, const laurent *x, long v);
/* z(z1,z2) = x(z1^n,z2^n), n >= 1. */
BIGFLOAT_MUST_USE bool laurent_stretch(laurent *z, const laurent *x, long n);

/* Divides x by 1 + z^-d, d not 0.  *exact tells whether there is no remainder; if there is one, z is
   unspecified. */
BIGFLOAT_MUST_USE bool laurent_divide_binomial(laurent *z, bool *exact, const laurent *x, lattice d);

/* norm = the largest, over the classes of lattice points modulo n, of the sum of |coefficient| over the class:
   for the n-th power of dilation 2 the maximum norm of the subdivision operator ([Z] 4.29). */
BIGFLOAT_MUST_USE bool laurent_class_norm(rational *norm, const laurent *x, long n);
/* sum = the sum of the coefficients at points congruent to (a,b) modulo n. */
BIGFLOAT_MUST_USE bool laurent_class_sum(rational *sum, const laurent *x, long a, long b, long n);

bool laurent_is_nonnegative(const laurent *x);

/* The least and greatest a, b and a + b over the points with a coefficient that is not 0: f = 0, 1, 2. */
typedef struct {
    long low[3], high[3];
} laurent_extent;
laurent_extent laurent_get_extent(const laurent *x); /* x not 0 */

#endif
