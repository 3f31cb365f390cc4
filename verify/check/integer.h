#ifndef CHECK_INTEGER_H
#define CHECK_INTEGER_H

/* Integers
 * ========
 *
 * An integer is a sign and a magnitude of `length` limbs, 32 bits each, least
 * first.  Always: the top limb is not 0; length = 0 iff sign = 0.  Integers are
 * values: functions take and return them, and nothing changes one.
 *
 * The limbs of short integers, at most those of an int64_t, are in the structure, so
 * that it fits two registers; those of longer ones are in scratch memory (scratch.h):
 * what is to survive a release goes through integer_keep().  In front of them stands a
 * number that only they have: if it is another one, they have been released, and the
 * program ends with "cannot check".
 *
 * The capacity is fixed: it holds products of two rational parts of 16,384 bits
 * (lib/scheme.md) and a little more.  A result that would not fit ends the
 * program with "cannot check": no result is ever wrong.
 */

#include "scratch.h"

#include <stdbool.h>
#include <stdint.h>

enum { INTEGER_LIMBS = 1056, SHORT_LIMBS = 2 };    /* 33,792 bits */

typedef struct {
    int16_t sign;                                  /* -1, 0 or 1 */
    int16_t length;
    uint32_t serial;                               /* of limbs there: there[-1] */
    union {
        uint32_t here[SHORT_LIMBS];                /* length <= SHORT_LIMBS */
        const uint32_t *there;
    } limb;
} integer;

/* Releases scratch memory down to the mark, all but the limbs of these. */
void integer_keep(struct mark mark, integer *values, size_t count);

/* Lets the limbs of a live in home[0 .. INTEGER_LIMBS], for good. */
void integer_store(integer *a, uint32_t *home);

/* Counts work; beyond a limit "cannot check", so that every run ends. */
void integer_count_work(int rows, int columns);

/* Values in and out
 * ----------------- */

integer integer_from(int64_t a);

/* The token text[0..size) in canonical hexadecimal: `-` in front if negative,
 * lower case, no leading zero, never `-0`.  False for any other token. */
bool integer_read_hex(integer *out, const char *text, size_t size);

/* -1, 0, 1: sign of a - b. */
int integer_compare(integer a, integer b);

/* Bits of the magnitude: 2^(bits-1) <= |a| < 2^bits; 0 for 0. */
long integer_bits(integer a);

/* a, if it lies in [-bound, bound]; else false. */
bool integer_get_small(int64_t *out, integer a, int64_t bound);

/* Exact arithmetic
 * ---------------- */

integer integer_negate(integer a);
integer integer_absolute(integer a);
integer integer_add(integer a, integer b);
integer integer_sub(integer a, integer b);
integer integer_mul(integer a, integer b);
integer integer_shift_left(integer a, long bits);
integer integer_min(integer a, integer b);
integer integer_max(integer a, integer b);

/* The greatest common divisor, >= 0. */
integer integer_gcd(integer a, integer b);

/* Division
 * --------
 *
 * floor: greatest integer <= a/b, ceil: least integer >= a/b; b is not 0.  root:
 * the greatest integer <= the square root of a >= 0. */

integer integer_divide_floor(integer a, integer b);
integer integer_divide_ceil(integer a, integer b);
integer integer_shift_floor(integer a, long bits);
integer integer_shift_ceil(integer a, long bits);
integer integer_root(integer a);

#endif
