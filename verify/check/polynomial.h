#ifndef CHECK_POLYNOMIAL_H
#define CHECK_POLYNOMIAL_H

/* Matrices and polynomials over a field of cosines: sections 3 and 4 of exact.md. */

#include "field.h"
#include "sector.h"

/* size x size, row by row. */
struct exact_matrix {
    int size;
    struct number *entry;
};

/* The matrix M of a block in the real form, or (m = 0) the plain one without the constant net.
 * What has no exact value in the field: rejected, at that line of the certificate. */
struct exact_matrix exact_block(const struct block *block, const struct field *k, int line);

/* coefficient[0] + coefficient[1] x + ... , coefficient[degree] = 1: monic, always. */
struct polynomial {
    int degree;
    struct number *coefficient;
};

/* 0 <= degree */
struct polynomial polynomial_make(int degree);

/* det(x - M) */
struct polynomial polynomial_characteristic(const struct exact_matrix *m, const struct field *k);

/* s^e g(s x), s = 1 or -1, e the degree of g. */
struct polynomial polynomial_turn(const struct polynomial *g, int sign);

/* a := a / b; false if there is a remainder. */
bool polynomial_divide(struct polynomial *a, const struct polynomial *b, const struct field *k);

/* v := p(M) v */
void polynomial_apply(struct number *v, const struct polynomial *p,
                      const struct exact_matrix *m, const struct field *k);

/* Enclosures of the coefficients but the leading one. */
interval *polynomial_enclose(const struct polynomial *p, const struct field *k, int g);

#endif
