/* window_choice.c: life of the choices of a window. */
#include "window_choice.h"

#include "../lib/growing.h"

#include <stdlib.h>
#include <string.h>

void window_choice_init(window_choice *z)
{
    memset(z, 0, sizeof *z);
    integer_init(&z->bound);
}

void window_choice_drop(window_choice *z)
{
    window_wave *last = &z->wave[--z->count];
    eigenpair_choice_clear(&last->eigenpair);
    tree_clear(&last->boundary);
}

void window_choice_clear(window_choice *z)
{
    while (z->count)
        window_choice_drop(z);
    free(z->wave);
    integer_clear(&z->bound);
    window_choice_init(z);
}

window_wave *window_choice_add(window_choice *z)
{
    window_wave *p = growing_room(z->wave, z->count, &z->capacity, sizeof *p);
    if (!p)
        return NULL;
    z->wave = p;
    p = &z->wave[z->count++];
    memset(p, 0, sizeof *p);
    eigenpair_choice_init(&p->eigenpair);
    tree_init(&p->boundary);
    return p;
}
