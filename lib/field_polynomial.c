/* field_polynomial.c: long division and Euclid's algorithm. */
#include "field_polynomial.h"

void field_polynomial_init(field_polynomial *p, number_field *f)
{
    *p = (field_polynomial){f, -1, 0, NULL};
}

void field_polynomial_clear(field_polynomial *p)
{
    field_free(p->field, p->c, (size_t)p->capacity);
    field_polynomial_init(p, p->field);
}

void field_polynomial_swap(field_polynomial *p, field_polynomial *q)
{
    field_polynomial t = *p;
    *p = *q;
    *q = t;
}

void field_polynomial_make_room(field_polynomial *z, int degree)
{
    number_field *f = z->field;
    field_polynomial_clear(z);
    if (degree < 0)
        return;
    z->c = field_new(f, (size_t)degree + 1);
    if (z->c) {
        z->degree = degree;
        z->capacity = degree + 1;
    }
}

void field_polynomial_trim(field_polynomial *z)
{
    while (z->degree >= 0 && field_is_zero(z->field, field_polynomial_at(z, z->degree)))
        z->degree--;
}

void field_polynomial_set(field_polynomial *z, const field_polynomial *p)
{
    if (z == p)
        return;
    field_polynomial_make_room(z, p->degree);
    for (int i = 0; i <= z->degree; i++)
        field_set(z->field, field_polynomial_at(z, i), field_polynomial_at(p, i));
}

void field_polynomial_mul(field_polynomial *z, const field_polynomial *p, const field_polynomial *q)
{
    field_polynomial_make_room(z, p->degree < 0 || q->degree < 0 ? -1 : p->degree + q->degree);
    for (int i = 0; z->degree >= 0 && i <= p->degree; i++)
        for (int j = 0; j <= q->degree; j++)
            field_addmul(z->field, field_polynomial_at(z, i + j), field_polynomial_at(p, i), field_polynomial_at(q, j));
}

void field_polynomial_divide(field_polynomial *quotient, field_polynomial *rest, const field_polynomial *p, const field_polynomial *d)
{
    number_field *f = p->field;
    rational *factor = field_new(f, 1);
    field_polynomial_set(rest, p);
    if (quotient)
        field_polynomial_make_room(quotient, p->degree - d->degree);
    for (int i = p->degree - d->degree; !f->failed && i >= 0; i--) {
        const rational *lead = field_polynomial_at(rest, i + d->degree);
        if (quotient)
            field_set(f, field_polynomial_at(quotient, i), lead);
        field_neg(f, factor, lead);
        for (int j = 0; j <= d->degree; j++)
            field_addmul(f, field_polynomial_at(rest, i + j), factor, field_polynomial_at(d, j));
    }
    field_polynomial_trim(rest);
    field_free(f, factor, 1);
}

void field_polynomial_make_monic(field_polynomial *z)
{
    number_field *f = z->field;
    rational *inverse = field_new(f, 1);
    if (!f->failed) {
        field_inverse(f, inverse, field_polynomial_at(z, z->degree));
        for (int i = 0; i <= z->degree; i++)
            field_mul(f, field_polynomial_at(z, i), field_polynomial_at(z, i), inverse);
    }
    field_free(f, inverse, 1);
}

void field_polynomial_gcd(field_polynomial *z, const field_polynomial *p, const field_polynomial *q)
{
    number_field *f = p->field;
    field_polynomial x, y, rest;
    field_polynomial_init(&x, f);
    field_polynomial_init(&y, f);
    field_polynomial_init(&rest, f);
    field_polynomial_set(&x, p);
    field_polynomial_set(&y, q);
    while (!f->failed && y.degree >= 0) {
        field_polynomial_make_monic(&y);
        field_polynomial_divide(NULL, &rest, &x, &y);
        field_polynomial_swap(&x, &y);
        field_polynomial_swap(&y, &rest);
    }
    if (!f->failed)
        field_polynomial_make_monic(&x);
    field_polynomial_swap(z, &x);
    field_polynomial_clear(&x);
    field_polynomial_clear(&y);
    field_polynomial_clear(&rest);
}

void field_polynomial_derivative(field_polynomial *z, const field_polynomial *p)
{
    number_field *f = p->field;
    rational *factor = field_new(f, 1);
    field_polynomial_make_room(z, p->degree - 1);
    for (int i = 0; !f->failed && i <= z->degree; i++) {
        field_set_si(f, factor, i + 1);
        field_mul(f, field_polynomial_at(z, i), factor, field_polynomial_at(p, i + 1));
    }
    field_free(f, factor, 1);
}

void field_polynomial_reflect(field_polynomial *z, const field_polynomial *p, int sign)
{
    field_polynomial_set(z, p);
    for (int i = p->degree - 1; sign < 0 && i >= 0; i -= 2)
        field_neg(z->field, field_polynomial_at(z, i), field_polynomial_at(z, i));
}
