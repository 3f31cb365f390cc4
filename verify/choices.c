/* choices.c: life of the choices. */
#include "choices.h"

#include <stdlib.h>
#include <string.h>

void choices_init(choices *z)
{
    memset(z, 0, sizeof *z);
    eigenpair_choice_init(&z->eigenpair);
    tree_init(&z->regularity);
    tree_init(&z->boundary);
}

bool choices_make(choices *z, long valence, long grid)
{
    choices_clear(z);
    z->valence = valence;
    z->grid = grid;
    z->power = calloc((size_t)(valence / 2 + 1), sizeof *z->power);
    return z->power != NULL;
}

void choices_clear(choices *z)
{
    eigenpair_choice_clear(&z->eigenpair);
    free(z->power);
    tree_clear(&z->regularity);
    tree_clear(&z->boundary);
    choices_init(z);
}
