/* field_matrix.h: square matrices over a number field (verify/exact.md, sections 4 and 7). */
#ifndef LIB_FIELD_MATRIX_H
#define LIB_FIELD_MATRIX_H

#include "field_polynomial.h"

/* Row by row; entry i n + j by field_at. */
typedef struct {
    number_field *field;
    int n;
    rational *entry;
} field_matrix;

void field_matrix_init(field_matrix *m, number_field *f, int n); /* 0 */
void field_matrix_clear(field_matrix *m);

/* The characteristic polynomial det(x - m). */
void field_matrix_characteristic(field_polynomial *z, const field_matrix *m);
/* v = p(m) v, v of n elements. */
void field_matrix_apply_polynomial(rational *v, const field_polynomial *p, const field_matrix *m);
bool field_vector_is_zero(const number_field *f, const rational *v, int n);

#endif
