/* field_polynomial.h: polynomials in one variable over a number field. */
#ifndef LIB_FIELD_POLYNOMIAL_H
#define LIB_FIELD_POLYNOMIAL_H

#include "number_field.h"

/* degree + 1 elements, from the constant one on; the leading one is not 0.  Degree -1: the polynomial 0.  All of them
   belong to one field; results mean nothing once it has failed. */
typedef struct {
    number_field *field;
    int degree;
    int capacity;
    rational *c;
} field_polynomial;

void field_polynomial_init(field_polynomial *p, number_field *f); /* 0 */
void field_polynomial_clear(field_polynomial *p);
void field_polynomial_swap(field_polynomial *p, field_polynomial *q);
void field_polynomial_set(field_polynomial *z, const field_polynomial *p);
/* 0 with room up to this degree, which it pretends to have until field_polynomial_trim. */
void field_polynomial_make_room(field_polynomial *z, int degree);
void field_polynomial_trim(field_polynomial *z);
static inline rational *field_polynomial_at(const field_polynomial *p, int i) { return field_at(p->field, p->c, (size_t)i); }

/* z, none of the others, = p q */
void field_polynomial_mul(field_polynomial *z, const field_polynomial *p, const field_polynomial *q);
/* p = quotient d + rest, d monic, the rest of lower degree.  quotient (NULL: not wanted) and rest are other objects. */
void field_polynomial_divide(field_polynomial *quotient, field_polynomial *rest, const field_polynomial *p, const field_polynomial *d);
void field_polynomial_make_monic(field_polynomial *z); /* z not 0 */
/* The monic greatest common divisor of p and q, not both 0. */
void field_polynomial_gcd(field_polynomial *z, const field_polynomial *p, const field_polynomial *q);
void field_polynomial_derivative(field_polynomial *z, const field_polynomial *p);
/* z = sign^degree p(sign x): the roots times sign, which is 1 or -1. */
void field_polynomial_reflect(field_polynomial *z, const field_polynomial *p, int sign);

#endif
