/* valence_list.h: lists of valences as users write them: 3..20,50,100..inf. */
#ifndef VERIFY_VALENCE_LIST_H
#define VERIFY_VALENCE_LIST_H

#include "choices.h"

#include <stddef.h>

#define VALENCE_LIST_MAX 1000 /* parts */

typedef struct {
    valence_range range[VALENCE_LIST_MAX]; /* increasing, with gaps between them; only the last one may be unbounded */
    int ranges;
    long count;                       /* of valences; LONG_MAX: infinitely many */
} valence_list;

/* Reads a list of valences from CHOICES_MIN_VALENCE to CHOICES_MAX_VALENCE; `inf` ends a range that has no end, and `all` is
   3..inf.  NULL: well; else what is wrong (a sentence; static storage), and z is empty.  Allocates nothing. */
const char *valence_list_read(valence_list *z, const char *text);

/* The valence number i, 0 <= i < count. */
long valence_list_get(const valence_list *z, long i);

#endif
