/* Affine numbers: section 2 of certificate-valences.md, operation by operation.  What is
 * multiplied by a d of 0 is 0, and is left out. */

#include "affine.h"

struct affine affine_from(interval c)
{
    return (struct affine) { c, { { 0 }, { 0 } } };
}

struct affine affine_from_whole(int64_t a, int g)
{
    return affine_from(grid_from(a, g));
}

interval affine_range(struct affine x)
{
    integer d;

    if (interval_is_zero(x.d))
        return x.c;
    d = interval_magnitude(x.d);
    return interval_of(integer_sub(x.c.lo, d), integer_add(x.c.hi, d));
}

struct affine affine_add(struct affine x, struct affine y)
{
    x.c = interval_add(x.c, y.c);
    if (interval_is_zero(x.d))
        x.d = y.d;
    else if (!interval_is_zero(y.d))
        x.d = interval_add(x.d, y.d);
    return x;
}

struct affine affine_minus(struct affine x)
{
    return (struct affine) { interval_minus(x.c), interval_minus(x.d) };
}

struct affine affine_sub(struct affine x, struct affine y)
{
    return affine_add(x, affine_minus(y));
}

/* c = c_x c_y, d = d_x R_y + R_x d_y */
struct affine affine_mul(struct affine x, struct affine y, int g)
{
    struct affine out = affine_from(grid_mul(x.c, y.c, g));

    if (!interval_is_zero(x.d))
        out.d = grid_mul(x.d, affine_range(y), g);
    if (!interval_is_zero(y.d))
        out.d = interval_add(out.d, grid_mul(affine_range(x), y.d, g));
    return out;
}

void affine_add_multiple(struct affine *sum, interval w, const struct affine *x, int g)
{
    sum->c = interval_add(sum->c, grid_mul(w, x->c, g));
    if (!interval_is_zero(x->d))
        sum->d = interval_add(sum->d, grid_mul(w, x->d, g));
}

/* c = c_x / c_y, d = (d_x - (R_x / R_y) d_y) / R_y */
struct affine affine_div(struct affine x, struct affine y, int g)
{
    struct affine out = affine_from(grid_div(x.c, y.c, g));
    interval range = affine_range(y), d = x.d;

    if (interval_is_zero(x.d) && interval_is_zero(y.d))
        return out;
    if (!interval_is_zero(y.d))
        d = interval_sub(d, grid_mul(grid_div(affine_range(x), range, g), y.d, g));
    out.d = grid_div(d, range, g);
    return out;
}

struct affine affine_hull(struct affine x, struct affine y)
{
    x.c = interval_hull(x.c, y.c);
    if (!interval_is_zero(x.d) || !interval_is_zero(y.d))
        x.d = interval_hull(x.d, y.d);
    return x;
}

bool affine_is_positive(struct affine x)
{
    return interval_is_positive(affine_range(x));
}

struct affine affine_cosine(rational first, rational last, int g)
{
    interval u = interval_hull(grid_cos_pi(last, g), grid_cos_pi(first, g));

    return (struct affine) { interval_thin(interval_mid(u)),
                             interval_thin(interval_rad(u)) };
}

void affine_keep(struct mark mark, struct affine *values, size_t count)
{
    interval_keep(mark, count > 0 ? &values[0].c : NULL, 2 * count);
}
