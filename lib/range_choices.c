/* range_choices.c: life of the lists. */
#include "range_choices.h"

#include "growing.h"

#include <stdlib.h>

void rise_list_init(rise_list *z)
{
    *z = (rise_list){NULL, 0, 0};
}

void rise_list_clear(rise_list *z)
{
    for (size_t i = 0; i < z->count; i++)
        eigenpair_choice_clear(&z->box[i].eigenpair);
    free(z->box);
    rise_list_init(z);
}

rise_box *rise_list_add(rise_list *z)
{
    rise_box *p = growing_room(z->box, z->count, &z->capacity, sizeof *p);
    if (!p)
        return NULL;
    z->box = p;
    p = &z->box[z->count++];
    p->q = 0;
    p->power = 0;
    eigenpair_choice_init(&p->eigenpair);
    return p;
}

void span_list_init(span_list *z)
{
    *z = (span_list){NULL, 0, 0};
}

void span_list_clear(span_list *z)
{
    free(z->box);
    span_list_init(z);
}

bool span_list_add(span_list *z, span_box b)
{
    span_box *p = growing_room(z->box, z->count, &z->capacity, sizeof *p);
    if (!p)
        return false;
    z->box = p;
    z->box[z->count++] = b;
    return true;
}
