/* exact_choice.c: life of the choices of verify/exact.md. */
#include "exact_choice.h"

#include <stdlib.h>
#include <string.h>

void exact_choice_init(exact_choice *z)
{
    memset(z, 0, sizeof *z);
    integer_init(&z->eigenvalue);
    integer_init(&z->radius);
}

void exact_choice_clear(exact_choice *z)
{
    for (int i = 0; z->coefficient && i < z->degree * z->field_degree; i++)
        rational_clear(&z->coefficient[i]);
    free(z->coefficient);
    integer_clear(&z->eigenvalue);
    integer_clear(&z->radius);
    exact_choice_init(z);
}

bool exact_choice_make_factor(exact_choice *z, int degree, int field_degree)
{
    size_t size = (size_t)degree * (size_t)field_degree;
    z->degree = degree;
    z->field_degree = field_degree;
    z->coefficient = malloc((size ? size : 1) * sizeof *z->coefficient);
    for (size_t i = 0; z->coefficient && i < size; i++)
        rational_init(&z->coefficient[i]);
    return z->coefficient != NULL;
}

bool exact_choice_set(exact_choice *z, const exact_choice *x)
{
    bool ok;
    exact_choice_clear(z);
    z->n = x->n;
    z->low = x->low;
    z->high = x->high;
    z->others = x->others;
    z->count = x->count;
    memcpy(z->line, x->line, sizeof z->line);
    ok = integer_set(&z->eigenvalue, &x->eigenvalue) && integer_set(&z->radius, &x->radius) && exact_choice_make_factor(z, x->degree, x->field_degree);
    for (int i = 0; ok && i < x->degree * x->field_degree; i++)
        ok = rational_set(&z->coefficient[i], &x->coefficient[i]);
    return ok;
}
