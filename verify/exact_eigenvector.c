/* exact_eigenvector.c: the eigenvector at the end of a longest Jordan chain (verify/exact.md, section 7).  Compiled once per
   number system. */
#include "exact_test.h"

#include "../lib/eigenpair.h"

/* z = the enclosure of the vector w = g(sign M)^(size-1) h(M) e_column. */
static outcome enclose_start(number *z, analysis *a, int line, int column)
{
    struct exact_state *e = a->exact;
    const exact_line *l = &a->choices->exact.line[line];
    const field_matrix *m = &e->matrix[line];
    number_field *f = &e->field;
    field_polynomial factor;
    rational *w = field_new(f, (size_t)m->n);
    field_polynomial_init(&factor, f);
    field_polynomial_reflect(&factor, &e->factor, l->sign);
    if (w && !f->failed) {
        field_set_si(f, field_at(f, w, (size_t)column), 1);
        field_matrix_apply_polynomial(w, &e->rest[line], m);
        for (int i = 1; i < l->size; i++)
            field_matrix_apply_polynomial(w, &factor, m);
        for (int i = 0; i < m->n; i++)
            exact_enclose(&z[i], field_get(f, w, (size_t)i), f, a->prec);
    }
    field_polynomial_clear(&factor);
    field_free(f, w, (size_t)m->n);
    return f->failed ? OUTCOME_NO_MEMORY : OUTCOME_TRUE;
}

/* y = r(M) w by Horner's rule, r with the roots of the quotient times the sign: coefficient i gets sign^(degree - i). */
static void apply_quotient(number *y, const number *w, const number *matrix, int n, const analysis *a, int sign)
{
    const struct exact_state *e = a->exact;
    int degree = e->factor.degree - 1;
    number *image = number_array_new((size_t)n), c;
    number_init(&c);
    for (int i = 0; i < n; i++)
        number_set(&y[i], &w[i]);
    for (int l = degree - 1; image && l >= 0; l--) {
        number_set(&c, &e->quotient[l]);
        if (sign < 0 && (degree - l) % 2)
            number_neg(&c, &c);
        for (int i = 0; i < n; i++) {
            number_mul(&image[i], &c, &w[i], a->prec);
            for (int j = 0; j < n; j++)
                number_addmul(&image[i], &matrix[i * n + j], &y[j], a->prec);
        }
        for (int i = 0; i < n; i++)
            number_swap(&y[i], &image[i]);
    }
    for (int i = 0; !image && i < n; i++)
        number_indeterminate(&y[i]);
    if (image)
        number_array_free(image, (size_t)n);
    number_clear(&c);
}

static bool is_certainly_not_zero(const number *y, int n)
{
    for (int i = 0; i < n; i++)
        if (number_is_positive(&y[i]) == TRUTH_TRUE || number_is_negative(&y[i]) == TRUTH_TRUE)
            return true;
    return false;
}

/* y = the eigenvector, by the column of the choices, or, in a search, by the first that leads to one. */
static outcome find_eigenvector(number *y, number *w, const number *matrix, analysis *a, int line)
{
    exact_line *l = &a->choices->exact.line[line];
    int n = a->order;
    outcome o = OUTCOME_TRUE;
    if (l->column > n)
        return findings_explain(a->findings, OUTCOME_FALSE, "block %ld has only %d unknowns", l->frequency, n);
    for (int column = a->replay ? l->column - 1 : 0; o == OUTCOME_TRUE && column < n; column++) {
        o = enclose_start(w, a, line, column);
        if (o != OUTCOME_TRUE)
            break;
        apply_quotient(y, w, matrix, n, a, l->sign);
        l->column = column + 1;
        if (a->replay || is_certainly_not_zero(y, n))
            return OUTCOME_TRUE;
    }
    return o == OUTCOME_TRUE ? findings_explain(a->findings, OUTCOME_FAIL, "no eigenvector of block %ld could be told from 0", l->frequency) : o;
}

/* May M y = l y?  Anything else is a fault of ours. */
static bool may_be_eigenvector(const number *matrix, const number *y, int n, const number *l, long prec)
{
    bool may = true;
    number rest;
    number_init(&rest);
    for (int i = 0; may && i < n; i++) {
        number_mul(&rest, l, &y[i], prec);
        number_neg(&rest, &rest);
        for (int j = 0; j < n; j++)
            number_addmul(&rest, &matrix[i * n + j], &y[j], prec);
        may = number_contains_zero(&rest);
    }
    number_clear(&rest);
    return may;
}

/* a->box = y, then sign times lambda. */
static outcome make_box(analysis *a, int line)
{
    struct exact_state *e = a->exact;
    const field_matrix *m = &e->matrix[line];
    size_t n = (size_t)m->n;
    number *w = number_array_new(n), *matrix = number_array_new(n * n);
    outcome o = OUTCOME_NO_MEMORY;
    a->order = m->n;
    a->box = number_array_new(eigenpair_box_size(a->order, false));
    if (w && matrix && a->box) {
        for (size_t i = 0; i < n * n; i++)
            exact_enclose(&matrix[i], field_get(&e->field, m->entry, i), &e->field, a->prec);
        o = find_eigenvector(a->box, w, matrix, a, line);
        number_set(&a->box[n], &e->eigenvalue);
        if (a->choices->exact.line[line].sign < 0)
            number_neg(&a->box[n], &a->box[n]);
        if (o == OUTCOME_TRUE && !may_be_eigenvector(matrix, a->box, a->order, &a->box[n], a->prec))
            o = findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector of block %ld is none: this is a fault of the program", a->choices->exact.line[line].frequency);
    }
    if (w)
        number_array_free(w, n);
    if (matrix)
        number_array_free(matrix, n * n);
    return o;
}

outcome exact_use_line(analysis *a, int line)
{
    long m = a->choices->exact.line[line].frequency;
    outcome o;
    sector_net_free(&a->net);
    a->net_made = false;
    block_free(&a->dominant);
    if (a->box)
        number_array_free(a->box, eigenpair_box_size(a->order, false));
    a->box = NULL;
    a->choices->frequency = m;
    a->choices->eigenpair.complex_form = false;
    o = analysis_make_block(&a->dominant, a, m, m);
    return o == OUTCOME_TRUE ? make_box(a, line) : o;
}
