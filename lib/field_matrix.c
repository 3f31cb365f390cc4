/* field_matrix.c: Faddeev and Leverrier's characteristic polynomial; polynomials of a matrix by Horner's rule. */
#include "field_matrix.h"

#include "stop.h"

void field_matrix_init(field_matrix *m, number_field *f, int n)
{
    m->field = f;
    m->n = n;
    m->entry = field_new(f, (size_t)n * (size_t)n);
}

void field_matrix_clear(field_matrix *m)
{
    field_free(m->field, m->entry, (size_t)m->n * (size_t)m->n);
    m->entry = NULL;
}

static rational *at(const field_matrix *m, int i, int j)
{
    return field_at(m->field, m->entry, (size_t)i * (size_t)m->n + (size_t)j);
}

/* z = m (x + c), z neither of them */
static void multiply_shifted(field_matrix *z, const field_matrix *m, field_matrix *x, const rational *c)
{
    number_field *f = m->field;
    int n = m->n;
    for (int i = 0; i < n; i++)
        field_add(f, at(x, i, i), at(x, i, i), c);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n && !f->failed; j++) {
            f->failed = stop_now();
            field_set_si(f, at(z, i, j), 0);
            for (int l = 0; l < n; l++)
                field_addmul(f, at(z, i, j), at(m, i, l), at(x, l, j));
        }
}

/* A_i = m (A_(i-1) + c_(i-1)), c_i = -trace(A_i) / i, beginning with A_0 = 0 and c_0 = 1. */
void field_matrix_characteristic(field_polynomial *z, const field_matrix *m)
{
    number_field *f = m->field;
    int n = m->n;
    field_matrix x, next;
    field_matrix_init(&x, f, n);
    field_matrix_init(&next, f, n);
    field_polynomial_make_room(z, n);
    if (!f->failed)
        field_set_si(f, field_polynomial_at(z, n), 1);
    for (int i = 1; !f->failed && i <= n; i++) {
        rational *c = field_polynomial_at(z, n - i);
        multiply_shifted(&next, m, &x, field_polynomial_at(z, n - i + 1));
        for (int l = 0; l < n; l++)
            field_sub(f, c, c, at(&next, l, l));
        field_div_si(f, c, c, i);
        rational *t = x.entry;
        x.entry = next.entry;
        next.entry = t;
    }
    field_matrix_clear(&x);
    field_matrix_clear(&next);
}

void field_matrix_apply_polynomial(rational *v, const field_polynomial *p, const field_matrix *m)
{
    number_field *f = m->field;
    size_t n = (size_t)m->n;
    rational *sum = field_new(f, n), *image = field_new(f, n);
    for (int i = p->degree; !f->failed && i >= 0; i--) {
        for (int row = 0; row < m->n; row++) {
            rational *entry = field_at(f, image, (size_t)row);
            field_mul(f, entry, field_polynomial_at(p, i), field_get(f, v, (size_t)row));
            for (int j = 0; j < m->n; j++)
                field_addmul(f, entry, at(m, row, j), field_get(f, sum, (size_t)j));
        }
        rational *t = sum;
        sum = image;
        image = t;
    }
    for (size_t i = 0; !f->failed && i < n; i++)
        field_set(f, field_at(f, v, i), field_get(f, sum, i));
    field_free(f, sum, n);
    field_free(f, image, n);
}

bool field_vector_is_zero(const number_field *f, const rational *v, int n)
{
    for (int i = 0; i < n; i++)
        if (!field_is_zero(f, field_get(f, v, (size_t)i)))
            return false;
    return true;
}
