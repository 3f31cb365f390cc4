/* growing.h: room for one more in an array that grows. */
#ifndef LIB_GROWING_H
#define LIB_GROWING_H

#include <stdbool.h>
#include <stdlib.h>

/* items = an array with room for *capacity things of `size` bytes, or NULL, of which `count` are in use.  Returns the
   array, perhaps elsewhere, with room for one more; NULL: no memory, and it is as before. */
static inline void *growing_room(void *items, size_t count, size_t *capacity, size_t size)
{
    size_t larger = *capacity ? 2 * *capacity : 16;
    if (count < *capacity)
        return items;
    items = realloc(items, larger * size);
    if (items)
        *capacity = larger;
    return items;
}

#endif
