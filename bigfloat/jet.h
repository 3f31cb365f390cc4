/* jet.h: a value and its first derivative, over any number system.

   A `jet` denotes a set of pairs (f(t), f'(t)): it encloses the value of a differentiable function of one variable t
   and its derivative, for every t of the set from which it was computed.  jet_variable starts with t itself (value t,
   derivative 1), jet_constant with a number (derivative 0); the operations follow the rules of differentiation and
   enclose for every choice of numbers, like those of number.h.  Outputs may be inputs.

   This file belongs to generic sources: include number.h first, which says what `number` is.  The functions are static
   inline; with intervals they must run inside number_enter() .. number_leave(). */
#ifndef BIGFLOAT_JET_H
#define BIGFLOAT_JET_H

#include "number.h"

typedef struct {
    number value;
    number slope;
} jet;

static inline void jet_init(jet *z)
{
    number_init(&z->value);
    number_init(&z->slope);
}
static inline void jet_clear(jet *z)
{
    number_clear(&z->value);
    number_clear(&z->slope);
}
static inline void jet_set(jet *z, const jet *x)
{
    number_set(&z->value, &x->value);
    number_set(&z->slope, &x->slope);
}
static inline void jet_swap(jet *x, jet *y)
{
    number_swap(&x->value, &y->value);
    number_swap(&x->slope, &y->slope);
}
static inline void jet_constant(jet *z, const number *c)
{
    number_set(&z->value, c);
    number_zero(&z->slope);
}
static inline void jet_variable(jet *z, const number *t)
{
    number_set(&z->value, t);
    number_one(&z->slope);
}

static inline void jet_neg(jet *z, const jet *x)
{
    number_neg(&z->value, &x->value);
    number_neg(&z->slope, &x->slope);
}
static inline void jet_add(jet *z, const jet *x, const jet *y, long prec)
{
    number_add(&z->value, &x->value, &y->value, prec);
    number_add(&z->slope, &x->slope, &y->slope, prec);
}
static inline void jet_sub(jet *z, const jet *x, const jet *y, long prec)
{
    number_sub(&z->value, &x->value, &y->value, prec);
    number_sub(&z->slope, &x->slope, &y->slope, prec);
}
static inline void jet_mul_2exp(jet *z, const jet *x, long e, long prec)
{
    number_mul_2exp(&z->value, &x->value, e, prec);
    number_mul_2exp(&z->slope, &x->slope, e, prec);
}
/* c a number that does not depend on t */
static inline void jet_scale(jet *z, const jet *x, const number *c, long prec)
{
    number_mul(&z->value, &x->value, c, prec);
    number_mul(&z->slope, &x->slope, c, prec);
}

/* (x y)' = x' y + x y' */
static inline void jet_mul(jet *z, const jet *x, const jet *y, long prec)
{
    number slope;
    number_init(&slope);
    number_mul(&slope, &x->slope, &y->value, prec);
    number_addmul(&slope, &x->value, &y->slope, prec);
    number_mul(&z->value, &x->value, &y->value, prec);
    number_swap(&z->slope, &slope);
    number_clear(&slope);
}

/* (x^2)' = 2 x x' */
static inline void jet_sqr(jet *z, const jet *x, long prec)
{
    number_mul(&z->slope, &x->value, &x->slope, prec);
    number_mul_2exp(&z->slope, &z->slope, 1, prec);
    number_sqr(&z->value, &x->value, prec);
}

/* q = x / y, q' = (x' - q y') / y */
static inline void jet_div(jet *z, const jet *x, const jet *y, long prec)
{
    number q, slope;
    number_init(&q);
    number_init(&slope);
    number_div(&q, &x->value, &y->value, prec);
    number_mul(&slope, &q, &y->slope, prec);
    number_sub(&slope, &x->slope, &slope, prec);
    number_div(&z->slope, &slope, &y->value, prec);
    number_swap(&z->value, &q);
    number_clear(&q);
    number_clear(&slope);
}

/* s = sqrt x, s' = x' / (2 s) */
static inline void jet_sqrt(jet *z, const jet *x, long prec)
{
    number twice;
    number_init(&twice);
    number_sqrt(&z->value, &x->value, prec);
    number_mul_2exp(&twice, &z->value, 1, prec);
    number_div(&z->slope, &x->slope, &twice, prec);
    number_clear(&twice);
}

/* An enclosure of f over t, from f(c) at one point c of t and the slope over all of t: f(c) + f'(t) (t - c), met with
   the direct one (mean-value form). */
static inline void jet_mean_value(number *z, const jet *over_t, const number *at_c, const number *t, const number *c,
                                  long prec)
{
    number d;
    number_init(&d);
    number_sub(&d, t, c, prec);
    number_mul(&d, &d, &over_t->slope, prec);
    number_add(&d, &d, at_c, prec);
    number_intersection(z, &over_t->value, &d, prec);
    number_clear(&d);
}

#endif
