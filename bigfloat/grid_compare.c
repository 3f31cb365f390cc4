/* grid_compare.c: questions about grids, and conversions out of them. */
#include <math.h>

#include "ball_internal.h"
#include "grid.h"
#include "grid_internal.h"

static dyadic endpoint(const grid *x, bool upper)
{
    const integer *m = upper ? &x->upper : &x->lower;
    dyadic d = {integer_limbs(m), (size_t)integer_length(m), m->size < 0, -(int64_t)x->exponent};
    return d;
}

static int compare(const grid *x, bool x_upper, const grid *y, bool y_upper)
{
    if (x->exponent == y->exponent)
        return integer_cmp(x_upper ? &x->upper : &x->lower, y_upper ? &y->upper : &y->lower);
    dyadic a = endpoint(x, x_upper), b = endpoint(y, y_upper);
    return ball_dyadic_compare(&a, &b);
}

truth grid_is_positive(const grid *x)
{
    if (x->state != GRID_FINITE)
        return TRUTH_UNKNOWN;
    return x->lower.size > 0 ? TRUTH_TRUE : x->upper.size <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

truth grid_is_negative(const grid *x)
{
    if (x->state != GRID_FINITE)
        return TRUTH_UNKNOWN;
    return x->upper.size < 0 ? TRUTH_TRUE : x->lower.size >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

bool grid_contains_zero(const grid *x)
{
    return x->state != GRID_FINITE || (x->lower.size <= 0 && x->upper.size >= 0);
}

truth grid_is_zero(const grid *x)
{
    if (!grid_contains_zero(x))
        return TRUTH_FALSE;
    return x->state == GRID_FINITE && x->lower.size == 0 && x->upper.size == 0 ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

truth grid_less(const grid *x, const grid *y)
{
    if (x->state != GRID_FINITE || y->state != GRID_FINITE)
        return TRUTH_UNKNOWN;
    if (compare(x, true, y, false) < 0)
        return TRUTH_TRUE;
    return compare(x, false, y, true) >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

bool grid_contains(const grid *x, const grid *y)
{
    if (x->state != GRID_FINITE)
        return true;
    return y->state == GRID_FINITE && compare(x, false, y, false) <= 0 && compare(y, true, x, true) <= 0;
}

bool grid_contains_interior(const grid *x, const grid *y)
{
    if (x->state != GRID_FINITE)
        return true;
    return y->state == GRID_FINITE && compare(x, false, y, false) < 0 && compare(y, true, x, true) < 0;
}

bool grid_is_thin(const grid *x) { return x->state == GRID_FINITE && integer_cmp(&x->lower, &x->upper) == 0; }

bool grid_identical(const grid *x, const grid *y)
{
    if (x->state != GRID_FINITE || y->state != GRID_FINITE)
        return x->state != GRID_FINITE && y->state != GRID_FINITE;
    return x->exponent == y->exponent && integer_cmp(&x->lower, &y->lower) == 0 && integer_cmp(&x->upper, &y->upper) == 0;
}

/* ---- conversions: through exact balls ---- */

static void endpoint_ball(ball *z, const grid *x, bool upper)
{
    ball_init(z);
    if (x->state != GRID_FINITE)
        ball_indeterminate(z);
    else
        ball_set_integer_2exp(z, upper ? &x->upper : &x->lower, -(long)x->exponent, LONG_MAX);
}

bool grid_contains_rational(const grid *x, const rational *q)
{
    if (x->state != GRID_FINITE)
        return true;
    rational a, b;
    rational_init(&a);
    rational_init(&b);
    bool inside = rational_set_integer_2exp(&a, &x->lower, -(long)x->exponent)
                  && rational_set_integer_2exp(&b, &x->upper, -(long)x->exponent) && rational_cmp(&a, q) <= 0
                  && rational_cmp(q, &b) <= 0;
    rational_clear(&a);
    rational_clear(&b);
    return inside;
}

double grid_lower_bound(const grid *x)
{
    ball t;
    endpoint_ball(&t, x, false);
    double v = ball_lower_bound(&t);
    ball_clear(&t);
    return v;
}

double grid_upper_bound(const grid *x)
{
    ball t;
    endpoint_ball(&t, x, true);
    double v = ball_upper_bound(&t);
    ball_clear(&t);
    return v;
}

double grid_mid_approx(const grid *x)
{
    double a = grid_lower_bound(x), b = grid_upper_bound(x);
    return x->state == GRID_FINITE ? 0.5 * a + 0.5 * b : 0;
}

bool grid_lower_grid(integer *m, const grid *x, long g)
{
    ball t;
    endpoint_ball(&t, x, false);
    bool ok = ball_lower_grid(m, &t, g);
    ball_clear(&t);
    return ok;
}

bool grid_upper_grid(integer *m, const grid *x, long g)
{
    ball t;
    endpoint_ball(&t, x, true);
    bool ok = ball_upper_grid(m, &t, g);
    ball_clear(&t);
    return ok;
}

/* The middle (lower + upper) / 2 in units of 2^-(h+1) is lower + upper. */
bool grid_mid_grid(integer *m, const grid *x, long g)
{
    if (x->state != GRID_FINITE)
        return false;
    grid sum;
    grid_init(&sum);
    ball t;
    ball_init(&t);
    bool ok = integer_add(&sum.lower, &x->lower, &x->upper);
    if (ok) {
        ball_set_integer_2exp(&t, &sum.lower, -(long)x->exponent - 1, LONG_MAX);
        ok = ball_mid_grid(m, &t, g);
    }
    ball_clear(&t);
    grid_clear(&sum);
    return ok;
}
