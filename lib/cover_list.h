/* cover_list.h: ranges of frequencies that follow each other, each with a power: the choices that make the proof of a
   bound for many blocks (lib/cover.h).  Exact, the same for all number systems. */
#ifndef LIB_COVER_LIST_H
#define LIB_COVER_LIST_H

#include "exact_range.h"

#include <stddef.h>

/* The power of a range for which nothing is proved. */
#define COVER_OPEN -1

typedef struct {
    frequencies m;
    int power; /* of spectral_contraction, or COVER_OPEN */
} cover_box;

typedef struct {
    cover_box *box;
    size_t count, capacity;
} cover_list;

void cover_list_init(cover_list *z);
void cover_list_clear(cover_list *z);
BIGFLOAT_MUST_USE bool cover_list_add(cover_list *z, frequencies m, int power); /* false: no memory */

/* Do the boxes, in their order, hold every frequency of the range once, and no others? */
bool cover_list_partitions(const cover_list *z, frequencies m);

#endif
