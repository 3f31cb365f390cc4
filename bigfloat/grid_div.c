/* grid_div.c: quotients and roots on the grid. */
#include "grid.h"
#include "grid_internal.h"

/* q = floor or ceil(x 2^g / y) */
static bool quotient(integer *q, const integer *x, const integer *y, long g, bool up)
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    bool ok = integer_mul_2exp(&a, x, g > 0 ? (unsigned long)g : 0) && integer_mul_2exp(&b, y, g < 0 ? (unsigned long)-g : 0)
              && (up ? integer_cdiv_q(q, &a, &b) : integer_fdiv_q(q, &a, &b));
    integer_clear(&a);
    integer_clear(&b);
    return ok;
}

/* For y > 0 the least quotient is lower / (the upper y if lower >= 0, else the lower y), the greatest is
   upper / (the lower y if upper >= 0, else the upper y). */
static void div_positive(grid *z, const grid *x, const grid *y, long g)
{
    integer low, high;
    integer_init(&low);
    integer_init(&high);
    bool ok = quotient(&low, &x->lower, integer_sign(&x->lower) >= 0 ? &y->upper : &y->lower, g, false)
              && quotient(&high, &x->upper, integer_sign(&x->upper) >= 0 ? &y->lower : &y->upper, g, true);
    integer_swap(&z->lower, &low);
    integer_swap(&z->upper, &high);
    integer_clear(&low);
    integer_clear(&high);
    grid_finish(z, g, ok);
}

static void div_any(grid *z, const grid *x, const grid *y, long g)
{
    if (integer_sign(&y->lower) > 0)
        div_positive(z, x, y, g);
    else if (integer_sign(&y->upper) < 0) {
        grid s, t;
        grid_init(&s);
        grid_init(&t);
        grid_neg(&s, x);
        grid_neg(&t, y);
        if (grid_is_finite(&s) && grid_is_finite(&t))
            div_positive(z, &s, &t, g);
        else
            grid_no_memory(z);
        grid_clear(&s);
        grid_clear(&t);
    } else
        grid_indeterminate(z);
}

void grid_div(grid *z, const grid *x, const grid *y, long prec) { grid_on_grid(z, x, y, prec, div_any); }

void grid_inv(grid *z, const grid *x, long prec)
{
    grid one;
    grid_init(&one);
    grid_one(&one);
    /* On a grid too coarse for it, 1 itself would be rounded: divide on a finer one, exactly. */
    if (prec >= 0)
        grid_div(z, &one, x, prec);
    else {
        integer low, high;
        integer_init(&low);
        integer_init(&high);
        grid t;
        grid_init(&t);
        if (!grid_move(&t, x, prec))
            grid_indeterminate_like(z, &t, &t);
        else if (grid_contains_zero(&t))
            grid_indeterminate(z);
        else {
            /* 1 / (m 2^-g) in units of 2^-g is 2^(2 g) / m = 1 / (m 2^(-2 g)) */
            integer_set_si(&low, 1);
            integer_set_si(&high, 1);
            bool ok = quotient(&low, &low, &t.upper, 2 * prec, false) && quotient(&high, &high, &t.lower, 2 * prec, true);
            integer_swap(&z->lower, &low);
            integer_swap(&z->upper, &high);
            grid_finish(z, prec, ok);
        }
        grid_clear(&t);
        integer_clear(&low);
        integer_clear(&high);
    }
    grid_clear(&one);
}

void grid_div_si(grid *z, const grid *x, long v, long prec)
{
    if (v == 0) {
        grid_indeterminate_like(z, x, x);
        return;
    }
    if (!grid_move(z, x, prec))
        return;
    integer d;
    integer_init(&d);
    integer_set_si(&d, v);
    if (v < 0)
        integer_swap(&z->lower, &z->upper);
    grid_finish(z, prec, integer_fdiv_q(&z->lower, &z->lower, &d) && integer_cdiv_q(&z->upper, &z->upper, &d));
}

/* sqrt(m 2^-g) = sqrt(m 2^g) 2^-g; floor(sqrt(floor(t))) = floor(sqrt(t)), and likewise for ceilings. */
static bool root(integer *z, const integer *m, long g, bool up)
{
    integer t, r;
    integer_init(&t);
    integer_init(&r);
    bool ok = g >= 0 ? integer_mul_2exp(&t, m, (unsigned long)g)
              : up ? integer_cdiv_2exp(&t, m, (unsigned long)-g) : integer_fdiv_2exp(&t, m, (unsigned long)-g);
    ok = ok && integer_sqrt_rem(z, &r, &t) && (!up || integer_is_zero(&r) || integer_add_si(z, z, 1));
    integer_clear(&t);
    integer_clear(&r);
    return ok;
}

void grid_sqrt(grid *z, const grid *x, long prec)
{
    if (!grid_move(z, x, prec))
        return;
    if (integer_sign(&z->lower) < 0)
        grid_indeterminate(z);
    else
        grid_finish(z, prec, root(&z->lower, &z->lower, prec, false) && root(&z->upper, &z->upper, prec, true));
}
