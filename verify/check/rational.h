#ifndef CHECK_RATIONAL_H
#define CHECK_RATIONAL_H

/* Rationals
 * =========
 *
 * Exact rational numbers num/den.  Always den > 0 and gcd(num, den) = 1, so
 * equal numbers have equal parts.  A number with more than 16,384 bits above or
 * below is an error (lib/scheme.md): cannot check.
 */

#include "integer.h"

enum { RATIONAL_BITS = 16384 };

typedef struct {
    integer num, den;
} rational;

/* num / den in lowest terms, den != 0. */
rational rational_reduce(integer num, integer den);
rational rational_from(int64_t num, int64_t den);

rational rational_negate(rational a);
rational rational_add(rational a, rational b);
rational rational_sub(rational a, rational b);
rational rational_mul(rational a, rational b);
rational rational_divide(rational a, rational b);  /* b != 0 */
rational rational_floor(rational a);

int rational_compare(rational a, rational b);

/* Whether a = num/den exactly (den > 0). */
bool rational_equals(rational a, int64_t num, int64_t den);

bool rational_is_whole(rational a);

#endif
