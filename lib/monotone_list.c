/* monotone_list.c: life of chains. */
#include "monotone_list.h"

#include "growing.h"

#include <stdlib.h>
#include <string.h>

void monotone_list_init(monotone_list *z)
{
    memset(z, 0, sizeof *z);
}

void monotone_list_clear(monotone_list *z)
{
    for (size_t i = 0; i < z->count; i++)
        eigenpair_choice_clear(&z->box[i].eigenpair);
    free(z->box);
    monotone_list_init(z);
}

monotone_box *monotone_list_add(monotone_list *z)
{
    monotone_box *p = growing_room(z->box, z->count, &z->capacity, sizeof *p);
    if (!p)
        return NULL;
    z->box = p;
    memset(&z->box[z->count], 0, sizeof *z->box);
    eigenpair_choice_init(&z->box[z->count].eigenpair);
    return &z->box[z->count++];
}

bool monotone_list_is_chain(const monotone_list *z, long start, bool forward)
{
    for (size_t i = 0; i < z->count; i++) {
        frequencies m = z->box[i].m;
        if (m.first >= m.last || (forward ? m.first : m.last) != start)
            return false;
        start = forward ? m.last : m.first;
    }
    return true;
}
