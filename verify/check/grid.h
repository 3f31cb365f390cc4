#ifndef CHECK_GRID_H
#define CHECK_GRID_H

/* Grid intervals
 * ==============
 *
 * Section 2 of certificate.md.  An interval is a pair of integers lo <= hi and
 * denotes [lo 2^-g, hi 2^-g]; g is the same throughout a check and is the last
 * argument of whatever depends on it.  Every operation yields an interval that
 * contains the exact results for all points of its operands, with exactly the
 * endpoints that the specification asks for.  Outputs may be inputs.
 */

#include "rational.h"

typedef struct {
    integer lo, hi;
} interval;

void interval_set(interval *out, const interval *x);

/* [a, a] and [lo, hi], in units of 2^-g. */
void interval_set_thin(interval *out, const integer *a);
void interval_set_ends(interval *out, const integer *lo, const integer *hi);

/* The integer a, thin. */
void grid_set_small(interval *out, int64_t a, int g);

/* The least interval that contains num/den; den > 0. */
void grid_from_fraction(interval *out, const integer *num, const integer *den,
                        int g);
void grid_from_rational(interval *out, const rational *q, int g);

void interval_add(interval *out, const interval *x, const interval *y);
void interval_sub(interval *out, const interval *x, const interval *y);
void interval_minus(interval *out, const interval *x);
void grid_mul(interval *out, const interval *x, const interval *y, int g);
void grid_div(interval *out, const interval *x, const interval *y, int g);
                                                   /* 0 not in y */

void interval_hull(interval *out, const interval *x, const interval *y);
void interval_magnitude(integer *out, const interval *x);    /* max |x| */
void interval_mid(integer *out, const interval *x);
void interval_rad(integer *out, const interval *x);          /* hi - mid */

bool interval_contains_zero(const interval *x);
bool interval_is_positive(const interval *x);                /* lo > 0 */

#endif
