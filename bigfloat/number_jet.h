/* number_jet.h: jets as a number system of their own.

   With NUMBER_JET defined besides NUMBER_INTERVAL, NUMBER_BALL or NUMBER_GRID, number.h ends with this file, and `number`
   is a jet of the numbers that it would be otherwise (bigfloat/jet.h): a source that only adds and multiplies computes
   derivatives when it is compiled so.  base_number is the type of value and slope, BASE_NAME(f) the name of a function
   of theirs.  Every constant has slope 0, what is indeterminate is so in both parts, and hulls are taken part by part. */
#ifndef BIGFLOAT_NUMBER_JET_H
#define BIGFLOAT_NUMBER_JET_H

#include "jet.h"

typedef number base_number;

static inline base_number *base_array_new(size_t n) { return number_array_new(n); }
static inline void base_array_free(base_number *a, size_t n) { number_array_free(a, n); }
static inline void base_set(base_number *z, const base_number *x) { number_set(z, x); }
static inline void base_indeterminate(base_number *z) { number_indeterminate(z); }

NUMBER_ARRAY_FUNCTIONS(jet);

static inline void jet_zero(jet *z)
{
    number_zero(&z->value);
    number_zero(&z->slope);
}
static inline void jet_one(jet *z)
{
    number_one(&z->value);
    number_zero(&z->slope);
}
static inline void jet_indeterminate(jet *z)
{
    number_indeterminate(&z->value);
    number_indeterminate(&z->slope);
}
static inline void jet_set_si(jet *z, long v, long prec)
{
    number_set_si(&z->value, v, prec);
    number_zero(&z->slope);
}
static inline void jet_set_rational(jet *z, const rational *q, long prec)
{
    number_set_rational(&z->value, q, prec);
    number_zero(&z->slope);
}
static inline void jet_cos_pi(jet *z, const rational *r, long prec)
{
    number_cos_pi(&z->value, r, prec);
    number_zero(&z->slope);
}
static inline void jet_sin_pi(jet *z, const rational *r, long prec)
{
    number_sin_pi(&z->value, r, prec);
    number_zero(&z->slope);
}
static inline void jet_hull(jet *z, const jet *x, const jet *y, long prec)
{
    number_hull(&z->value, &x->value, &y->value, prec);
    number_hull(&z->slope, &x->slope, &y->slope, prec);
}
/* z + x y; most factors here are constants. */
static inline void jet_addmul(jet *z, const jet *x, const jet *y, long prec)
{
    number_addmul(&z->slope, &x->slope, &y->value, prec);
    number_addmul(&z->slope, &x->value, &y->slope, prec);
    number_addmul(&z->value, &x->value, &y->value, prec);
}
static inline bool jet_lacks_memory(const jet *x)
{
    return number_lacks_memory(&x->value) || number_lacks_memory(&x->slope);
}
/* 0 everywhere, with its slope? */
static inline truth jet_is_zero(const jet *x)
{
    return number_is_zero(&x->value) == TRUTH_TRUE ? number_is_zero(&x->slope) : TRUTH_UNKNOWN;
}

#define BASE_NAME(f) NUMBER_PASTE(f, NUMBER_BASE_TYPE)

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
#undef number_addmul
#undef number_hull
#undef number_is_zero
#undef number_lacks_memory
#undef number_cos_pi
#undef number_sin_pi
#define NUMBER_TYPE NUMBER_JET_TYPE
#define number jet
#define number_array_new jet_array_new
#define number_array_free jet_array_free
#define number_init jet_init
#define number_clear jet_clear
#define number_set jet_set
#define number_swap jet_swap
#define number_zero jet_zero
#define number_one jet_one
#define number_indeterminate jet_indeterminate
#define number_set_si jet_set_si
#define number_set_rational jet_set_rational
#define number_neg jet_neg
#define number_add jet_add
#define number_sub jet_sub
#define number_mul jet_mul
#define number_addmul jet_addmul
#define number_hull jet_hull
#define number_is_zero jet_is_zero
#define number_lacks_memory jet_lacks_memory
#define number_cos_pi jet_cos_pi
#define number_sin_pi jet_sin_pi

#endif
