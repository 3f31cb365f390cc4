/* number_affine.h: affine numbers as a number system of their own.

   With NUMBER_AFFINE defined besides NUMBER_INTERVAL, NUMBER_BALL or NUMBER_GRID, number.h ends with this file, and `number`
   is an affine one of the numbers that it would be otherwise (bigfloat/affine.h): what a source computes for one valence it
   computes, compiled so, for many.  base_number is the type of centre and slope, BASE_NAME(f) the name of a function of
   theirs, base_op an operation.

   A constant has slope 0, and what is indeterminate is so in both parts.  These work part by part: hull, max, midpoint,
   radius_upper, add_error.  So `midpoint` and `radius_upper` split an affine number into a thin one and pairs of radii, which
   `max` collects and `add_error` adds again; a radius is no quantity that depends on t.  Answers to questions, and bounds, are
   those of the range. */
#ifndef BIGFLOAT_NUMBER_AFFINE_H
#define BIGFLOAT_NUMBER_AFFINE_H

#include "affine.h"

typedef number base_number;

#define BASE_NAME(f) NUMBER_PASTE(f, NUMBER_BASE_TYPE)

static inline void affine_zero(affine *z)
{
    number_zero(&z->centre);
    number_zero(&z->slope);
}
static inline void affine_one(affine *z)
{
    number_one(&z->centre);
    number_zero(&z->slope);
}
static inline void affine_indeterminate(affine *z)
{
    number_indeterminate(&z->centre);
    number_indeterminate(&z->slope);
}
static inline void affine_set_si(affine *z, long v, long prec)
{
    number_set_si(&z->centre, v, prec);
    number_zero(&z->slope);
}
static inline void affine_set_rational(affine *z, const rational *q, long prec)
{
    number_set_rational(&z->centre, q, prec);
    number_zero(&z->slope);
}
static inline void affine_cos_pi(affine *z, const rational *r, long prec)
{
    number_cos_pi(&z->centre, r, prec);
    number_zero(&z->slope);
}
static inline void affine_sin_pi(affine *z, const rational *r, long prec)
{
    number_sin_pi(&z->centre, r, prec);
    number_zero(&z->slope);
}

/* z += c x (-= if `negative`), c a constant, as most factors are. */
static inline void affine_add_multiple_(affine *z, const affine *c, const affine *x, bool negative, long prec)
{
    if (number_is_zero(&x->slope) != TRUTH_TRUE)
        (negative ? number_submul : number_addmul)(&z->slope, &c->centre, &x->slope, prec);
    (negative ? number_submul : number_addmul)(&z->centre, &c->centre, &x->centre, prec);
}

static inline void affine_accumulate_(affine *z, const affine *x, const affine *y, bool negative, long prec)
{
    affine product;
    if (number_is_zero(&x->slope) == TRUTH_TRUE) {
        affine_add_multiple_(z, x, y, negative, prec);
        return;
    }
    if (number_is_zero(&y->slope) == TRUTH_TRUE) {
        affine_add_multiple_(z, y, x, negative, prec);
        return;
    }
    affine_init(&product);
    affine_mul(&product, x, y, prec);
    (negative ? affine_sub : affine_add)(z, z, &product, prec);
    affine_clear(&product);
}

static inline void affine_addmul(affine *z, const affine *x, const affine *y, long prec) { affine_accumulate_(z, x, y, false, prec); }
static inline void affine_submul(affine *z, const affine *x, const affine *y, long prec) { affine_accumulate_(z, x, y, true, prec); }
static inline void affine_sqr(affine *z, const affine *x, long prec) { affine_mul(z, x, x, prec); }
static inline void affine_mul_si(affine *z, const affine *x, long v, long prec)
{
    number_mul_si(&z->centre, &x->centre, v, prec);
    number_mul_si(&z->slope, &x->slope, v, prec);
}
static inline void affine_mul_2exp(affine *z, const affine *x, long e, long prec)
{
    number_mul_2exp(&z->centre, &x->centre, e, prec);
    number_mul_2exp(&z->slope, &x->slope, e, prec);
}

/* ---- part by part ---- */

static inline void affine_hull(affine *z, const affine *x, const affine *y, long prec)
{
    number_hull(&z->centre, &x->centre, &y->centre, prec);
    number_hull(&z->slope, &x->slope, &y->slope, prec);
}
static inline void affine_max(affine *z, const affine *x, const affine *y, long prec)
{
    number_max(&z->centre, &x->centre, &y->centre, prec);
    number_max(&z->slope, &x->slope, &y->slope, prec);
}
static inline void affine_midpoint(affine *z, const affine *x, long prec)
{
    number_midpoint(&z->centre, &x->centre, prec);
    number_midpoint(&z->slope, &x->slope, prec);
}
static inline void affine_radius_upper(affine *z, const affine *x, long prec)
{
    number_radius_upper(&z->centre, &x->centre, prec);
    number_radius_upper(&z->slope, &x->slope, prec);
}
static inline void affine_add_error(affine *z, const affine *x, const affine *r, long prec)
{
    number_add_error(&z->centre, &x->centre, &r->centre, prec);
    number_add_error(&z->slope, &x->slope, &r->slope, prec);
}

/* ---- the rest ---- */

static inline truth affine_is_negative(const affine *x)
{
    affine minus;
    truth t;
    affine_init(&minus);
    affine_neg(&minus, x);
    t = affine_is_positive(&minus);
    affine_clear(&minus);
    return t;
}
static inline double affine_mid_approx(const affine *x) { return number_mid_approx(&x->centre); }
/* Of the range. */
static inline char *affine_get_decimal(const affine *x, int digits)
{
    number range;
    char *text;
    number_init(&range);
    affine_range(&range, x, 64 + 4L * digits);
    text = number_get_decimal(&range, digits);
    number_clear(&range);
    return text;
}

#define base_array_new NUMBER_OP(array_new)
#define base_array_free NUMBER_OP(array_free)
#define base_init NUMBER_OP(init)
#define base_clear NUMBER_OP(clear)
#define base_set NUMBER_OP(set)
#define base_set_rational NUMBER_OP(set_rational)
#define base_midpoint NUMBER_OP(midpoint)
#define base_radius_upper NUMBER_OP(radius_upper)
#define base_hull NUMBER_OP(hull)
#define base_cos_pi NUMBER_OP(cos_pi)
#define base_swap NUMBER_OP(swap)
#define base_lower NUMBER_OP(lower)
#define base_upper NUMBER_OP(upper)
#define base_inv NUMBER_OP(inv)
#define base_set_double NUMBER_OP(set_double)
#define base_set_integer_2exp NUMBER_OP(set_integer_2exp)
#define base_lower_grid NUMBER_OP(lower_grid)
#define base_is_finite NUMBER_OP(is_finite)
#define base_lacks_memory NUMBER_OP(lacks_memory)

/* What has no meaning here is no name here. */
#undef NUMBER_TYPE
#undef number_array_new
#undef number_array_free
#undef number_init
#undef number_clear
#undef number_set
#undef number_swap
#undef number_zero
#undef number_one
#undef number_indeterminate
#undef number_set_si
#undef number_set_rational
#undef number_neg
#undef number_add
#undef number_sub
#undef number_mul
#undef number_div
#undef number_addmul
#undef number_submul
#undef number_sqr
#undef number_mul_2exp
#undef number_mul_si
#undef number_hull
#undef number_max
#undef number_midpoint
#undef number_radius_upper
#undef number_add_error
#undef number_is_positive
#undef number_is_negative
#undef number_is_zero
#undef number_is_finite
#undef number_lacks_memory
#undef number_mid_approx
#undef number_lower_bound
#undef number_upper_bound
#undef number_cos_pi
#undef number_sin_pi
#undef number_get_decimal
#undef number_set_double
#undef number_set_integer_2exp
#undef number_set_ball
#undef number_get_ball
#undef number_abs
#undef number_div_si
#undef number_inv
#undef number_sqrt
#undef number_min
#undef number_intersection
#undef number_lower
#undef number_upper
#undef number_magnitude_upper
#undef number_less
#undef number_contains_zero
#undef number_contains
#undef number_contains_interior
#undef number_contains_rational
#undef number_is_thin
#undef number_mid_grid
#undef number_lower_grid
#undef number_upper_grid
#undef number_pi
#define NUMBER_TYPE NUMBER_AFFINE_TYPE
#define number affine
#define number_array_new affine_array_new
#define number_array_free affine_array_free
#define number_init affine_init
#define number_clear affine_clear
#define number_set affine_set
#define number_swap affine_swap
#define number_zero affine_zero
#define number_one affine_one
#define number_indeterminate affine_indeterminate
#define number_set_si affine_set_si
#define number_set_rational affine_set_rational
#define number_neg affine_neg
#define number_add affine_add
#define number_sub affine_sub
#define number_mul affine_mul
#define number_div affine_div
#define number_addmul affine_addmul
#define number_submul affine_submul
#define number_sqr affine_sqr
#define number_mul_2exp affine_mul_2exp
#define number_mul_si affine_mul_si
#define number_hull affine_hull
#define number_max affine_max
#define number_midpoint affine_midpoint
#define number_radius_upper affine_radius_upper
#define number_add_error affine_add_error
#define number_is_positive affine_is_positive
#define number_is_negative affine_is_negative
#define number_is_zero affine_is_zero
#define number_is_finite affine_is_finite
#define number_lacks_memory affine_lacks_memory
#define number_mid_approx affine_mid_approx
#define number_lower_bound affine_lower_bound
#define number_upper_bound affine_upper_bound
#define number_cos_pi affine_cos_pi
#define number_sin_pi affine_sin_pi
#define number_get_decimal affine_get_decimal

#endif
