/* number_common.h: the declarations that all number systems share, as one list.

   NUMBER_DECLARE(X) declares the operations of the system X (a type name and a prefix) that are ordinary
   functions.  number.h says what each of them means. */
#ifndef BIGFLOAT_NUMBER_COMMON_H
#define BIGFLOAT_NUMBER_COMMON_H

#include "integer.h"
#include "rational.h"
#include "truth.h"

#define NUMBER_DECLARE(X)                                                                        \
    void X##_clear(X *z);                                                                        \
    void X##_set(X *z, const X *x);                                                              \
    void X##_zero(X *z);                                                                         \
    void X##_one(X *z);                                                                          \
    void X##_indeterminate(X *z);                                                                \
    void X##_set_si(X *z, long v, long prec);                                                    \
    void X##_neg(X *z, const X *x);                                                              \
    void X##_abs(X *z, const X *x);                                                              \
    void X##_add(X *z, const X *x, const X *y, long prec);                                       \
    void X##_sub(X *z, const X *x, const X *y, long prec);                                       \
    void X##_mul(X *z, const X *x, const X *y, long prec);                                       \
    void X##_div(X *z, const X *x, const X *y, long prec);                                       \
    void X##_addmul(X *z, const X *x, const X *y, long prec);                                    \
    void X##_submul(X *z, const X *x, const X *y, long prec);                                    \
    void X##_sqr(X *z, const X *x, long prec);                                                   \
    void X##_mul_2exp(X *z, const X *x, long e, long prec);                                      \
    void X##_mul_si(X *z, const X *x, long v, long prec);                                        \
    void X##_div_si(X *z, const X *x, long v, long prec);                                        \
    void X##_inv(X *z, const X *x, long prec);                                                   \
    void X##_sqrt(X *z, const X *x, long prec);                                                  \
    void X##_hull(X *z, const X *x, const X *y, long prec);                                      \
    void X##_min(X *z, const X *x, const X *y, long prec);                                       \
    void X##_max(X *z, const X *x, const X *y, long prec);                                       \
    void X##_intersection(X *z, const X *x, const X *y, long prec);                              \
    void X##_lower(X *z, const X *x, long prec);                                                 \
    void X##_upper(X *z, const X *x, long prec);                                                 \
    void X##_midpoint(X *z, const X *x, long prec);                                              \
    void X##_radius_upper(X *z, const X *x, long prec);                                          \
    void X##_magnitude_upper(X *z, const X *x, long prec);                                       \
    void X##_add_error(X *z, const X *x, const X *r, long prec);                                 \
    truth X##_is_positive(const X *x);                                                           \
    truth X##_is_negative(const X *x);                                                           \
    truth X##_is_zero(const X *x);                                                               \
    truth X##_less(const X *x, const X *y);                                                      \
    bool X##_contains_zero(const X *x);                                                          \
    bool X##_contains(const X *x, const X *y);                                                   \
    bool X##_contains_interior(const X *x, const X *y);                                          \
    bool X##_is_finite(const X *x);                                                              \
    bool X##_is_thin(const X *x);                                                                \
    bool X##_lacks_memory(const X *x)

/* The ones that no system has as an inline function, because they are never hot. */
#define NUMBER_DECLARE_SLOW(X)                                                                   \
    void X##_set_integer_2exp(X *z, const integer *m, long e, long prec);                        \
    void X##_set_rational(X *z, const rational *q, long prec);                                   \
    void X##_set_double(X *z, double v, long prec);                                              \
    bool X##_contains_rational(const X *x, const rational *q);                                   \
    BIGFLOAT_MUST_USE bool X##_mid_grid(integer *m, const X *x, long g);                         \
    BIGFLOAT_MUST_USE bool X##_lower_grid(integer *m, const X *x, long g);                       \
    BIGFLOAT_MUST_USE bool X##_upper_grid(integer *m, const X *x, long g);                       \
    void X##_pi(X *z, long prec);                                                                \
    void X##_cos_pi(X *z, const rational *r, long prec);                                         \
    void X##_sin_pi(X *z, const rational *r, long prec);                                         \
    char *X##_get_decimal(const X *x, int digits)

#endif
