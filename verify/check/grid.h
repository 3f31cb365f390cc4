#ifndef CHECK_GRID_H
#define CHECK_GRID_H

/* Grid intervals
 * ==============
 *
 * Section 2 of certificate.md.  An interval is a pair of integers lo <= hi and
 * denotes [lo 2^-g, hi 2^-g]; g is the same throughout a check and is the last
 * argument of whatever depends on it.  Every operation yields an interval that
 * contains the exact results for all points of its operands, with exactly the
 * endpoints that the specification asks for.
 */

#include "rational.h"

typedef struct {
    integer lo, hi;
} interval;

/* Releases scratch memory down to the mark, all but what these consist of. */
void interval_keep(struct mark mark, interval *values, size_t count);

/* [a, a] and [lo, hi], in units of 2^-g. */
interval interval_thin(integer a);
interval interval_of(integer lo, integer hi);

/* The integer a, thin. */
interval grid_from(int64_t a, int g);

/* The least interval that contains num/den (den > 0), or q. */
interval grid_from_fraction(integer num, integer den, int g);
interval grid_from_rational(rational q, int g);

interval interval_add(interval x, interval y);
interval interval_sub(interval x, interval y);
interval interval_minus(interval x);
interval grid_mul(interval x, interval y, int g);
interval grid_div(interval x, interval y, int g);  /* 0 not in y */
interval grid_root(interval x, int g);             /* lo >= 0 */

interval interval_hull(interval x, interval y);
interval interval_min(interval x, interval y);
interval interval_max(interval x, interval y);
interval interval_abs(interval x);
integer interval_magnitude(interval x);            /* max |x| */
integer interval_mid(interval x);
integer interval_rad(interval x);                  /* hi - mid */

bool interval_contains_zero(interval x);
bool interval_is_zero(interval x);                 /* [0, 0] */
bool interval_is_positive(interval x);             /* lo > 0 */

/* pi, cos(pi q), sin(pi q)
 * ------------------------
 *
 * For rational q, the least grid interval that contains the number. */

/* cos(pi q), if it is a rational number; else false.  (By Niven's theorem the rational ones
 * are 0, 1/2, -1/2, 1, -1.) */
bool rational_cos_pi(rational *out, rational q);

interval grid_pi(int g);
interval grid_cos_pi(rational q, int g);
interval grid_sin_pi(rational q, int g);

#endif
