/* cover_list.c: life of covers. */
#include "cover_list.h"

#include "growing.h"

#include <stdlib.h>
#include <string.h>

void cover_list_init(cover_list *z)
{
    memset(z, 0, sizeof *z);
}

void cover_list_clear(cover_list *z)
{
    free(z->box);
    cover_list_init(z);
}

bool cover_list_add(cover_list *z, frequencies m, int power)
{
    cover_box *p = growing_room(z->box, z->count, &z->capacity, sizeof *p);
    if (!p)
        return false;
    z->box = p;
    z->box[z->count++] = (cover_box){m, power};
    return true;
}

bool cover_list_partitions(const cover_list *z, frequencies m)
{
    for (size_t i = 0; i < z->count; i++) {
        frequencies here = z->box[i].m;
        if (here.first != (i ? z->box[i - 1].m.last + 1 : m.first) || here.last < here.first || here.last > m.last)
            return false;
    }
    return z->count ? z->box[z->count - 1].m.last == m.last : m.first > m.last;
}
