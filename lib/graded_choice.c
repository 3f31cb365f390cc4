/* graded_choice.c: life of a graded_choice. */
#include "graded_choice.h"

#include <stdlib.h>

void graded_choice_init(graded_choice *z)
{
    *z = (graded_choice){1, 0, 0, NULL};
}

void graded_choice_clear(graded_choice *z)
{
    free(z->grade);
    graded_choice_init(z);
}

bool graded_choice_make(graded_choice *z, int n)
{
    graded_choice_clear(z);
    z->n = n;
    z->grade = calloc((size_t)n, sizeof *z->grade);
    return z->grade != NULL;
}

static bool is_degree(int d)
{
    return d >= 0 && d <= GRADED_MAX_DEGREE;
}

bool graded_choice_is_within_limits(const graded_choice *z)
{
    bool ok = is_degree(z->degree) && z->unit >= 1 && z->unit <= GRADED_MAX_UNIT;
    for (int i = 0; i < z->n; i++)
        ok = ok && is_degree(z->grade[i]);
    return ok;
}
