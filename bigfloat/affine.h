/* affine.h: quantities that depend on a parameter t in [-1, 1], over any number system
   (verify/certificate-valences.md, section 2).

   An `affine` is a pair of numbers (centre, slope), sets C and D of reals.  It *encloses* a quantity f that may depend on t, and
   on other things besides, if f = c + d t for some c in C and d in D, for each t.  Where f is a function of t alone the pair is *sloped* if
   f(0) is in C and f(s) - f(t) in D (s - t) for all s and t; the arithmetic keeps both properties.  (Hulls and what widens
   keep the first.)  The *range* of the pair, C + D [-1, 1], contains all values of f.

   This file belongs to generic sources: include number.h first, which says what `number` is.  The functions are static
   inline; with intervals they must run inside number_enter() .. number_leave().  Outputs may be inputs. */
#ifndef BIGFLOAT_AFFINE_H
#define BIGFLOAT_AFFINE_H

#include "number.h"
#include "number_array.h"

#include <math.h>

typedef struct {
    number centre;
    number slope;
} affine;

static inline void affine_init(affine *z)
{
    number_init(&z->centre);
    number_init(&z->slope);
}
static inline void affine_clear(affine *z)
{
    number_clear(&z->centre);
    number_clear(&z->slope);
}
static inline void affine_set(affine *z, const affine *x)
{
    number_set(&z->centre, &x->centre);
    number_set(&z->slope, &x->slope);
}
static inline void affine_swap(affine *x, affine *y)
{
    number_swap(&x->centre, &y->centre);
    number_swap(&x->slope, &y->slope);
}

NUMBER_ARRAY_FUNCTIONS(affine);

/* (c, 0): a quantity within c, whatever t is. */
static inline void affine_constant(affine *z, const number *c)
{
    number_set(&z->centre, c);
    number_zero(&z->slope);
}

/* All numbers from those of `low` to those of `high`, at some t: the middle of the outermost ends, and how far these are from it,
   thin both.  (Not by way of their hull: the middle of a wide ball has few digits.) */
static inline void affine_between(affine *z, const number *low, const number *high, long prec)
{
    number first, last, middle;
    number_init(&first);
    number_init(&last);
    number_init(&middle);
    number_lower(&first, low, prec);
    number_upper(&last, high, prec);
    number_add(&middle, &first, &last, prec);
    number_mul_2exp(&middle, &middle, -1, prec);
    number_midpoint(&middle, &middle, prec);
    number_sub(&first, &middle, &first, prec);
    number_sub(&last, &last, &middle, prec);
    number_max(&last, &first, &last, prec);
    number_upper(&z->slope, &last, prec);
    number_swap(&z->centre, &middle);
    number_clear(&first);
    number_clear(&last);
    number_clear(&middle);
}

static inline void affine_range(number *z, const affine *x, long prec)
{
    number_add_error(z, &x->centre, &x->slope, prec);
}

/* ---- arithmetic ---- */

static inline void affine_neg(affine *z, const affine *x)
{
    number_neg(&z->centre, &x->centre);
    number_neg(&z->slope, &x->slope);
}
static inline void affine_add(affine *z, const affine *x, const affine *y, long prec)
{
    number_add(&z->centre, &x->centre, &y->centre, prec);
    number_add(&z->slope, &x->slope, &y->slope, prec);
}
static inline void affine_sub(affine *z, const affine *x, const affine *y, long prec)
{
    number_sub(&z->centre, &x->centre, &y->centre, prec);
    number_sub(&z->slope, &x->slope, &y->slope, prec);
}

/* z += (slope of x) (range of y); most numbers are constants, and their range is the centre. */
static inline void affine_add_part_(number *z, const affine *x, const affine *y, long prec)
{
    number range;
    if (number_is_zero(&x->slope) == TRUTH_TRUE)
        return;
    if (number_is_zero(&y->slope) == TRUTH_TRUE) {
        number_addmul(z, &x->slope, &y->centre, prec);
        return;
    }
    number_init(&range);
    affine_range(&range, y, prec);
    number_addmul(z, &x->slope, &range, prec);
    number_clear(&range);
}

/* x y = c_x c_y + (d_x y + c_x d_y) t */
static inline void affine_mul(affine *z, const affine *x, const affine *y, long prec)
{
    number slope;
    number_init(&slope);
    affine_add_part_(&slope, x, y, prec);
    affine_add_part_(&slope, y, x, prec);
    number_mul(&z->centre, &x->centre, &y->centre, prec);
    number_swap(&z->slope, &slope);
    number_clear(&slope);
}

/* x / y = q + ((d_x - q d_y) / y) t, q = c_x / c_y */
static inline void affine_div(affine *z, const affine *x, const affine *y, long prec)
{
    number range, slope;
    number_init(&range);
    number_init(&slope);
    affine_range(&range, y, prec);
    affine_range(&slope, x, prec);
    number_div(&slope, &slope, &range, prec);
    number_mul(&slope, &slope, &y->slope, prec);
    number_sub(&slope, &x->slope, &slope, prec);
    number_div(&slope, &slope, &range, prec);
    number_div(&z->centre, &x->centre, &y->centre, prec);
    number_swap(&z->slope, &slope);
    number_clear(&range);
    number_clear(&slope);
}

/* ---- questions, about all t ---- */

/* centre > |slope| */
static inline truth affine_is_positive(const affine *x)
{
    number minus;
    truth t;
    number_init(&minus);
    number_neg(&minus, &x->slope);
    t = number_less(&x->slope, &x->centre) == TRUTH_TRUE && number_less(&minus, &x->centre) == TRUTH_TRUE ? TRUTH_TRUE : TRUTH_UNKNOWN;
    number_clear(&minus);
    return t;
}

/* TRUTH_TRUE: both parts are 0. */
static inline truth affine_is_zero(const affine *x)
{
    return number_is_zero(&x->centre) == TRUTH_TRUE && number_is_zero(&x->slope) == TRUTH_TRUE ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

static inline bool affine_is_finite(const affine *x)
{
    return number_is_finite(&x->centre) && number_is_finite(&x->slope);
}

static inline bool affine_lacks_memory(const affine *x)
{
    return number_lacks_memory(&x->centre) || number_lacks_memory(&x->slope);
}

/* ---- doubles ---- */

static inline double affine_size_of_slope_(const affine *x)
{
    return fmax(number_upper_bound(&x->slope), -number_lower_bound(&x->slope));
}

/* True bounds of the range: a step further than what rounding, in whatever mode, may have lost. */
static inline double affine_lower_bound(const affine *x)
{
    return nextafter(number_lower_bound(&x->centre) - affine_size_of_slope_(x), -INFINITY);
}
static inline double affine_upper_bound(const affine *x)
{
    return nextafter(number_upper_bound(&x->centre) + affine_size_of_slope_(x), INFINITY);
}

#endif
