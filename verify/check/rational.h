#ifndef CHECK_RATIONAL_H
#define CHECK_RATIONAL_H

/* Rationals
 * =========
 *
 * Exact rational numbers num/den.  Always den > 0 and gcd(num, den) = 1, so
 * equal numbers have equal parts.  A number with more than 16,384 bits above or
 * below is an error (lib/scheme.md): cannot check.  Outputs may be inputs.
 */

#include "integer.h"

enum { RATIONAL_BITS = 16384 };

typedef struct {
    integer num, den;
} rational;

void rational_set(rational *out, const rational *a);
void rational_set_small(rational *out, int64_t num, int64_t den);   /* den != 0 */
void rational_negate(rational *out, const rational *a);
void rational_add(rational *out, const rational *a, const rational *b);
void rational_sub(rational *out, const rational *a, const rational *b);
void rational_mul(rational *out, const rational *a, const rational *b);
void rational_divide(rational *out, const rational *a, const rational *b);
                                                   /* b != 0 */
int rational_compare(const rational *a, const rational *b);

/* Whether a = num/den exactly (den > 0). */
bool rational_equals(const rational *a, int64_t num, int64_t den);

/* num / den in lowest terms, den != 0. */
void rational_reduce(rational *out, const integer *num, const integer *den);

#endif
