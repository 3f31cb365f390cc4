/* Grid intervals: section 2 of certificate.md, operation by operation. */

#include "grid.h"

#include "answer.h"

void interval_keep(struct mark mark, interval *values, size_t count)
{
    integer_keep(mark, count > 0 ? &values[0].lo : NULL, 2 * count);
}

interval interval_of(integer lo, integer hi)
{
    interval out = { lo, hi };

    if (integer_compare(lo, hi) > 0)
        cannot_check("the checker's interval arithmetic is at fault");
    return out;
}

interval interval_thin(integer a)
{
    interval out = { a, a };

    return out;
}

interval grid_from(int64_t a, int g)
{
    return interval_thin(integer_shift_left(integer_from(a), g));
}

interval grid_from_fraction(integer num, integer den, int g)
{
    integer scaled = integer_shift_left(num, g);

    return interval_of(integer_divide_floor(scaled, den),
                       integer_divide_ceil(scaled, den));
}

interval grid_from_rational(rational q, int g)
{
    return grid_from_fraction(q.num, q.den, g);
}

interval interval_add(interval x, interval y)
{
    interval out = { integer_add(x.lo, y.lo), integer_add(x.hi, y.hi) };

    return out;
}

interval interval_sub(interval x, interval y)
{
    interval out = { integer_sub(x.lo, y.hi), integer_sub(x.hi, y.lo) };

    return out;
}

interval interval_minus(interval x)
{
    interval out = { integer_negate(x.hi), integer_negate(x.lo) };

    return out;
}

/* The product of intervals is spanned by the products of their endpoints; if one
 * of them has a sign, it is known which.  (x < 0: by minus x and minus y.) */
interval grid_mul(interval x, interval y, int g)
{
    integer least, greatest;

    if (x.hi.sign <= 0 && x.lo.sign < 0) {
        x = interval_minus(x);
        y = interval_minus(y);
    }
    if (x.lo.sign >= 0) {
        least = integer_mul(y.lo.sign >= 0 ? x.lo : x.hi, y.lo);
        greatest = integer_mul(y.hi.sign >= 0 ? x.hi : x.lo, y.hi);
    } else {
        least = integer_min(integer_mul(x.lo, y.hi), integer_mul(x.hi, y.lo));
        greatest = integer_max(integer_mul(x.lo, y.lo), integer_mul(x.hi, y.hi));
    }
    return interval_of(integer_shift_floor(least, g),
                       integer_shift_ceil(greatest, g));
}

/* Monotone in each variable, so the corners decide; and floor and ceiling are
 * monotone, so they may be taken before least and greatest. */
interval grid_div(interval x, interval y, int g)
{
    interval out = { integer_from(0), integer_from(0) };

    if (interval_contains_zero(y))
        cannot_check("the checker divides by zero");
    for (int i = 0; i < 4; i++) {
        integer scaled = integer_shift_left(i % 2 == 0 ? x.lo : x.hi, g);
        integer end = i < 2 ? y.lo : y.hi;
        integer floor = integer_divide_floor(scaled, end);
        integer ceiling = integer_divide_ceil(scaled, end);

        out.lo = i == 0 ? floor : integer_min(out.lo, floor);
        out.hi = i == 0 ? ceiling : integer_max(out.hi, ceiling);
    }
    return out;
}

/* sqrt(a 2^-g) = sqrt(a 2^g) 2^-g */
interval grid_root(interval x, int g)
{
    integer lower = integer_shift_left(x.lo, g), upper = integer_shift_left(x.hi, g);
    integer root = integer_root(upper);

    if (integer_compare(integer_mul(root, root), upper) < 0)
        root = integer_add(root, integer_from(1));
    return interval_of(integer_root(lower), root);
}

interval interval_hull(interval x, interval y)
{
    return interval_of(integer_min(x.lo, y.lo), integer_max(x.hi, y.hi));
}

interval interval_min(interval x, interval y)
{
    return interval_of(integer_min(x.lo, y.lo), integer_min(x.hi, y.hi));
}

interval interval_max(interval x, interval y)
{
    return interval_of(integer_max(x.lo, y.lo), integer_max(x.hi, y.hi));
}

interval interval_abs(interval x)
{
    if (x.lo.sign >= 0)
        return x;
    if (x.hi.sign <= 0)
        return interval_minus(x);
    return interval_of(integer_from(0), interval_magnitude(x));
}

integer interval_magnitude(interval x)
{
    return integer_max(integer_absolute(x.lo), integer_absolute(x.hi));
}

integer interval_mid(interval x)
{
    return integer_shift_floor(integer_add(x.lo, x.hi), 1);
}

integer interval_rad(interval x)
{
    return integer_sub(x.hi, interval_mid(x));
}

bool interval_contains_zero(interval x)
{
    return x.lo.sign <= 0 && x.hi.sign >= 0;
}

bool interval_is_zero(interval x)
{
    return x.lo.sign == 0 && x.hi.sign == 0;
}

bool interval_is_positive(interval x)
{
    return x.lo.sign > 0;
}
