/* monotone_list.h: the choices that prove an eigenvalue monotone along a chain of ranges (lib/monotone.h).  Exact, the
   same for all number systems. */
#ifndef LIB_MONOTONE_LIST_H
#define LIB_MONOTONE_LIST_H

#include "eigenpair_choice.h"
#include "exact_range.h"

#include <stddef.h>

typedef struct {
    frequencies m;              /* first < last */
    eigenpair_choice eigenpair; /* for all blocks of the range */
    int power;                  /* of spectral_contraction, for the rest of them */
} monotone_box;

typedef struct {
    monotone_box *box;
    size_t count, capacity;
} monotone_list;

void monotone_list_init(monotone_list *z);
void monotone_list_clear(monotone_list *z);
/* A new last box with nothing in its eigenpair.  NULL: no memory. */
monotone_box *monotone_list_add(monotone_list *z);

/* Does each box begin (forward), or end, where the one before it ends (begins), the first one at `start`? */
bool monotone_list_is_chain(const monotone_list *z, long start, bool forward);

#endif
