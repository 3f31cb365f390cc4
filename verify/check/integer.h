#ifndef CHECK_INTEGER_H
#define CHECK_INTEGER_H

/* Integers
 * ========
 *
 * An integer is a sign and a magnitude of `length` limbs, 32 bits each, least
 * first.  Always: the top limb is not 0; length = 0 iff sign = 0.  Limbs
 * beyond the length are never read, so short numbers are quick.
 *
 * The capacity is fixed.  It holds the product of two grid numbers of
 * 8192 + 64 bits (certificate.md, section 1) and a little more.  A result that
 * would not fit ends the program with "cannot check": no result is ever wrong.
 *
 * Outputs come first and may be the same objects as inputs.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { INTEGER_LIMBS = 544 };                      /* 17,408 bits */

typedef struct {
    int sign;                                      /* -1, 0 or 1 */
    int length;
    uint32_t limb[INTEGER_LIMBS];
} integer;

/* Values in and out
 * ----------------- */

void integer_set(integer *out, const integer *a);  /* copies `length` limbs */
void integer_set_small(integer *out, int64_t a);

/* The token text[0..size) in canonical hexadecimal: `-` in front if negative,
 * lower case, no leading zero, never `-0`.  False for any other token. */
bool integer_read_hex(integer *out, const char *text, size_t size);

/* -1, 0, 1: sign of a - b. */
int integer_compare(const integer *a, const integer *b);

/* Bits of the magnitude: 2^(bits-1) <= |a| < 2^bits; 0 for 0. */
long integer_bits(const integer *a);

/* a, if it lies in [-bound, bound]; else false. */
bool integer_get_small(int64_t *out, const integer *a, int64_t bound);

/* Exact arithmetic
 * ---------------- */

void integer_negate(integer *out, const integer *a);
void integer_absolute(integer *out, const integer *a);
void integer_add(integer *out, const integer *a, const integer *b);
void integer_sub(integer *out, const integer *a, const integer *b);
void integer_mul(integer *out, const integer *a, const integer *b);
void integer_shift_left(integer *out, const integer *a, long bits);

/* The greatest common divisor, >= 0. */
void integer_gcd(integer *out, const integer *a, const integer *b);

/* Division
 * --------
 *
 * floor: greatest integer <= a/b, ceil: least integer >= a/b; b is not 0. */

void integer_divide_floor(integer *out, const integer *a, const integer *b);
void integer_divide_ceil(integer *out, const integer *a, const integer *b);
void integer_shift_floor(integer *out, const integer *a, long bits);
void integer_shift_ceil(integer *out, const integer *a, long bits);

#endif
