/* eigenpair_choice.c: life of an eigenpair_choice. */
#include "eigenpair_choice.h"

#include <stdlib.h>
#include <string.h>

void eigenpair_choice_init(eigenpair_choice *z)
{
    memset(z, 0, sizeof *z);
    integer_init(&z->radius);
    integer_init(&z->range);
}

static integer *new_integers(int count)
{
    integer *a = malloc((size_t)count * sizeof *a);
    for (int i = 0; a && i < count; i++)
        integer_init(&a[i]);
    return a;
}

static void free_integers(integer *a, int count)
{
    for (int i = 0; a && i < count; i++)
        integer_clear(&a[i]);
    free(a);
}

bool eigenpair_choice_make(eigenpair_choice *z, int n, long grid)
{
    eigenpair_choice_clear(z);
    z->approximation = new_integers(n);
    z->inverse = new_integers(n * n);
    z->n = n;
    z->grid = grid;
    return z->approximation && z->inverse;
}

void eigenpair_choice_clear(eigenpair_choice *z)
{
    free_integers(z->approximation, z->n);
    free_integers(z->inverse, z->n * z->n);
    integer_clear(&z->radius);
    integer_clear(&z->range);
    eigenpair_choice_init(z);
}

int eigenpair_choice_second_pivot(const eigenpair_choice *z)
{
    int others = z->n / 2 - 1, best = 0;
    const integer *imaginary = z->approximation + others;
    for (int i = 1; i < others; i++)
        if (integer_cmp_abs(&imaginary[i], &imaginary[best]) > 0)
            best = i;
    return others < 1 ? -1 : best < z->pivot ? best : best + 1;
}
