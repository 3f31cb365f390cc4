/* exact_value.h: the values of formulas that are known exactly.

   An exact value is a rational q or an angle q pi with q not 0 (lib/scheme.md, "Value of a formula").  What is
   neither is left to enclosures: the operations here then answer EXACT_NONE. */
#ifndef LIB_EXACT_VALUE_H
#define LIB_EXACT_VALUE_H

#include "../bigfloat/rational.h"

/* A rational with more bits than this in numerator or denominator is refused. */
#define EXACT_MAX_BITS 16384

typedef enum {
    EXACT_OK,
    EXACT_NONE,             /* the result is neither a rational nor an angle */
    EXACT_DIVISION_BY_ZERO,
    EXACT_TOO_LARGE,
    EXACT_UNDEFINED,        /* cos or sin of something that is not a rational multiple of pi */
    EXACT_NEGATIVE,         /* the square root of a negative number */
    EXACT_NOT_WHOLE,        /* an exponent or an operand of mod that is not a whole number (or mod by 0) */
    EXACT_UNDECIDED,        /* a comparison that no enclosure has decided */
    EXACT_NO_CASE,          /* no condition of cases(...) holds */
    EXACT_NO_MEMORY
} exact_status;

typedef struct {
    bool is_angle;
    rational q;
} exact_value;

void exact_init(exact_value *z);
void exact_clear(exact_value *z);

/* In all of these z may be x or y. */

/* op is one of + - * /. */
exact_status exact_binary(exact_value *z, const exact_value *x, char op, const exact_value *y);
exact_status exact_negate(exact_value *z, const exact_value *x);
exact_status exact_power(exact_value *z, const exact_value *x, long n);
/* x - y floor(x / y) for whole numbers. */
exact_status exact_modulo(exact_value *z, const exact_value *x, const exact_value *y);
/* The root if it is rational, else EXACT_NONE. */
exact_status exact_sqrt(exact_value *z, const exact_value *x);
/* The sign of x - y; EXACT_NONE for a rational with an angle. */
exact_status exact_compare(int *sign, const exact_value *x, const exact_value *y);

/* function is 'c' or 's'.  EXACT_NONE: *z is the angle (q pi, or q = 0 as a rational) and its cosine or sine is
   not rational. */
exact_status exact_cos_sin(exact_value *z, const exact_value *x, char function);

#endif
