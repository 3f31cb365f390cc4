/* number_field.h: the real cyclotomic field K = Q(theta), theta = 2 cos(pi/n), exactly (verify/exact.md, section 2).

   An element is an array of f->degree rationals, the coefficients of 1, theta, theta^2 ...: a unique form.  Vectors,
   matrices and polynomials of elements are arrays of them, one after the other.

   Nothing here returns a failure: f->failed stays set once memory was missing, a rational had more than
   NUMBER_FIELD_MAX_BITS bits, or there was no time left (lib/stop.h); what was computed then means nothing. */
#ifndef LIB_NUMBER_FIELD_H
#define LIB_NUMBER_FIELD_H

#include "../bigfloat/cosines.h"

enum { NUMBER_FIELD_MAX_N = 4096, NUMBER_FIELD_MAX_DEGREE = 64, NUMBER_FIELD_MAX_BITS = 16384 };

typedef struct {
    long n;
    int degree;
    rational *minimal; /* of theta: monic, the `degree` coefficients below */
    rational *scratch;
    bool failed;
} number_field;

/* 2 <= n <= NUMBER_FIELD_MAX_N.  false: the degree is too high, or no memory.  In any case number_field_free. */
BIGFLOAT_MUST_USE bool number_field_make(number_field *f, long n);
void number_field_free(number_field *f);

/* `count` elements, all 0.  Never NULL unless f->failed is set. */
rational *field_new(number_field *f, size_t count);
void field_free(const number_field *f, rational *x, size_t count); /* x may be NULL */
static inline rational *field_at(const number_field *f, rational *x, size_t i) { return x + i * (size_t)f->degree; }
static inline const rational *field_get(const number_field *f, const rational *x, size_t i) { return x + i * (size_t)f->degree; }

/* z may be x or y in all of these. */
void field_set(number_field *f, rational *z, const rational *x);
void field_set_si(number_field *f, rational *z, long v);
void field_set_cosines(number_field *f, rational *z, const cosines *x); /* x known, of the same n */
void field_neg(number_field *f, rational *z, const rational *x);
void field_add(number_field *f, rational *z, const rational *x, const rational *y);
void field_sub(number_field *f, rational *z, const rational *x, const rational *y);
void field_mul(number_field *f, rational *z, const rational *x, const rational *y);
void field_addmul(number_field *f, rational *z, const rational *x, const rational *y);
void field_div_si(number_field *f, rational *z, const rational *x, long v);
void field_inverse(number_field *f, rational *z, const rational *x); /* x not 0 */
bool field_is_zero(const number_field *f, const rational *x);

#endif
