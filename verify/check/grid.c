/* Grid intervals: section 2 of certificate.md, operation by operation. */

#include "grid.h"

#include "answer.h"

void interval_set_ends(interval *out, const integer *lo, const integer *hi)
{
    if (integer_compare(lo, hi) > 0)
        cannot_check("the checker's interval arithmetic is at fault");
    integer_set(&out->lo, lo);
    integer_set(&out->hi, hi);
}

void interval_set(interval *out, const interval *x)
{
    integer_set(&out->lo, &x->lo);
    integer_set(&out->hi, &x->hi);
}

void interval_set_thin(interval *out, const integer *a)
{
    integer_set(&out->lo, a);
    integer_set(&out->hi, a);
}

void grid_set_small(interval *out, int64_t a, int g)
{
    integer_set_small(&out->lo, a);
    integer_shift_left(&out->lo, &out->lo, g);
    integer_set(&out->hi, &out->lo);
}

void grid_from_fraction(interval *out, const integer *num, const integer *den,
                        int g)
{
    integer scaled, lo, hi;

    integer_shift_left(&scaled, num, g);
    integer_divide_floor(&lo, &scaled, den);
    integer_divide_ceil(&hi, &scaled, den);
    interval_set_ends(out, &lo, &hi);
}

void grid_from_rational(interval *out, const rational *q, int g)
{
    grid_from_fraction(out, &q->num, &q->den, g);
}

void interval_add(interval *out, const interval *x, const interval *y)
{
    integer_add(&out->lo, &x->lo, &y->lo);
    integer_add(&out->hi, &x->hi, &y->hi);
}

void interval_sub(interval *out, const interval *x, const interval *y)
{
    integer lo;

    integer_sub(&lo, &x->lo, &y->hi);
    integer_sub(&out->hi, &x->hi, &y->lo);
    integer_set(&out->lo, &lo);
}

void interval_minus(interval *out, const interval *x)
{
    integer lo;

    integer_negate(&lo, &x->hi);
    integer_negate(&out->hi, &x->lo);
    integer_set(&out->lo, &lo);
}

/* least and greatest: those of them and of a. */
static void include(integer *least, integer *greatest, const integer *a)
{
    if (integer_compare(a, least) < 0)
        integer_set(least, a);
    if (integer_compare(a, greatest) > 0)
        integer_set(greatest, a);
}

/* A bilinear function on a box has its extremes at the corners. */
void grid_mul(interval *out, const interval *x, const interval *y, int g)
{
    bool x_thin = integer_compare(&x->lo, &x->hi) == 0;
    bool y_thin = integer_compare(&y->lo, &y->hi) == 0;
    integer least, greatest, product;

    integer_mul(&least, &x->lo, &y->lo);
    integer_set(&greatest, &least);
    if (!x_thin) {
        integer_mul(&product, &x->hi, &y->lo);
        include(&least, &greatest, &product);
    }
    if (!y_thin) {
        integer_mul(&product, &x->lo, &y->hi);
        include(&least, &greatest, &product);
    }
    if (!x_thin && !y_thin) {
        integer_mul(&product, &x->hi, &y->hi);
        include(&least, &greatest, &product);
    }
    integer_shift_floor(&out->lo, &least, g);
    integer_shift_ceil(&out->hi, &greatest, g);
}

/* Monotone in each variable, so again the corners decide; and floor and
 * ceiling are monotone, so they may be taken before least and greatest. */
void grid_div(interval *out, const interval *x, const interval *y, int g)
{
    integer lo, hi, scaled, quotient;
    const integer *x_end[2] = { &x->lo, &x->hi };
    const integer *y_end[2] = { &y->lo, &y->hi };

    if (interval_contains_zero(y))
        cannot_check("the checker divides by zero");
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            integer_shift_left(&scaled, x_end[i], g);
            integer_divide_floor(&quotient, &scaled, y_end[j]);
            if ((i == 0 && j == 0) || integer_compare(&quotient, &lo) < 0)
                integer_set(&lo, &quotient);
            integer_divide_ceil(&quotient, &scaled, y_end[j]);
            if ((i == 0 && j == 0) || integer_compare(&quotient, &hi) > 0)
                integer_set(&hi, &quotient);
        }
    }
    interval_set_ends(out, &lo, &hi);
}

void interval_hull(interval *out, const interval *x, const interval *y)
{
    integer_set(&out->lo,
                integer_compare(&x->lo, &y->lo) <= 0 ? &x->lo : &y->lo);
    integer_set(&out->hi,
                integer_compare(&x->hi, &y->hi) >= 0 ? &x->hi : &y->hi);
}

void interval_magnitude(integer *out, const interval *x)
{
    integer lo, hi;

    integer_absolute(&lo, &x->lo);
    integer_absolute(&hi, &x->hi);
    integer_set(out, integer_compare(&lo, &hi) > 0 ? &lo : &hi);
}

void interval_mid(integer *out, const interval *x)
{
    integer sum;

    integer_add(&sum, &x->lo, &x->hi);
    integer_shift_floor(out, &sum, 1);
}

void interval_rad(integer *out, const interval *x)
{
    integer mid;

    interval_mid(&mid, x);
    integer_sub(out, &x->hi, &mid);
}

bool interval_contains_zero(const interval *x)
{
    return x->lo.sign <= 0 && x->hi.sign >= 0;
}

bool interval_is_positive(const interval *x)
{
    return x->lo.sign > 0;
}
