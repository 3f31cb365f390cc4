/* grid_mul.c: products on the grid: exact endpoint products, then one floor and one ceiling. */
#include "grid.h"
#include "grid_internal.h"

/* m in units of 2^-2g goes to units of 2^-g, floor or ceiling. */
static bool rescale(integer *z, const integer *m, long g, bool up)
{
    if (g < 0)
        return integer_mul_2exp(z, m, (unsigned long)-g);
    return up ? integer_cdiv_2exp(z, m, (unsigned long)g) : integer_fdiv_2exp(z, m, (unsigned long)g);
}

/* *low and *high: the least and the greatest of the products of x's endpoints by y's. */
static bool product_range(integer *low, integer *high, const grid *x, const grid *y)
{
    integer t;
    integer_init(&t);
    bool ok = integer_mul(low, &x->lower, &y->lower) && integer_set(high, low);
    const integer *p[3] = {&x->lower, &x->upper, &x->upper}, *q[3] = {&y->upper, &y->lower, &y->upper};
    for (int i = 0; ok && i < 3; i++) {
        ok = integer_mul(&t, p[i], q[i]);
        if (ok && integer_cmp(&t, low) < 0)
            ok = integer_set(low, &t);
        else if (ok && integer_cmp(&t, high) > 0)
            ok = integer_set(high, &t);
    }
    integer_clear(&t);
    return ok;
}

static void mul_any(grid *z, const grid *x, const grid *y, long g)
{
    integer low, high;
    integer_init(&low);
    integer_init(&high);
    bool ok = product_range(&low, &high, x, y) && rescale(&z->lower, &low, g, false) && rescale(&z->upper, &high, g, true);
    integer_clear(&low);
    integer_clear(&high);
    grid_finish(z, g, ok);
}

void grid_mul(grid *z, const grid *x, const grid *y, long prec)
{
    if (grid_ready(x, prec) && grid_ready(y, prec) && grid_exponent_ok(prec))
        mul_any(z, x, y, prec);
    else
        grid_on_grid(z, x, y, prec, mul_any);
}

void grid_sqr(grid *z, const grid *x, long prec)
{
    grid t;
    grid_init(&t);
    grid_abs(&t, x);
    grid_mul(z, &t, &t, prec);
    grid_clear(&t);
}

void grid_addmul(grid *z, const grid *x, const grid *y, long prec)
{
    grid t;
    grid_init(&t);
    grid_mul(&t, x, y, prec);
    grid_add(z, z, &t, prec);
    grid_clear(&t);
}

void grid_submul(grid *z, const grid *x, const grid *y, long prec)
{
    grid t;
    grid_init(&t);
    grid_mul(&t, x, y, prec);
    grid_sub(z, z, &t, prec);
    grid_clear(&t);
}

void grid_mul_si(grid *z, const grid *x, long v, long prec)
{
    if (!grid_move(z, x, prec))
        return;
    if (v < 0)
        integer_swap(&z->lower, &z->upper);
    grid_finish(z, prec, integer_mul_si(&z->lower, &z->lower, v) && integer_mul_si(&z->upper, &z->upper, v));
}

/* Moving x, whose endpoints count units of 2^-h, as if they counted units of 2^-(h - e). */
void grid_mul_2exp(grid *z, const grid *x, long e, long prec)
{
    if (e > 2 * GRID_MAX_EXPONENT || e < -2 * GRID_MAX_EXPONENT) {
        long half = e > 0 ? 2 * GRID_MAX_EXPONENT : -2 * GRID_MAX_EXPONENT;
        /* beyond: 0 stays 0; small numbers become [-1, 0], [0, 1], [-1, 1] units; large ones the whole line */
        if (e > 0 && grid_is_finite(x) && grid_is_zero(x) != TRUTH_TRUE) {
            grid_indeterminate(z);
            return;
        }
        e = half;
    }
    grid_set(z, x);
    if (grid_is_finite(z)) {
        z->exponent = (int32_t)(z->exponent - e);
        (void)grid_move(z, z, prec);
    }
}
