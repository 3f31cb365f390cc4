/* valences.h: lists of valences as users write them: 3..20,50. */
#ifndef VERIFY_VALENCES_H
#define VERIFY_VALENCES_H

#include "../lib/exact_range.h"
#include "choices.h"

#include <stddef.h>

/* A list is examined one by one, up to so many of them. */
#define VALENCES_MAX 100000
#define VALENCES_MAX_RANGES 1000

typedef struct {
    valence_range range[VALENCES_MAX_RANGES]; /* increasing, with gaps between them */
    int ranges;
    long count;
} valences;

/* Reads a list of valences between CHOICES_MIN_VALENCE and CHOICES_MAX_VALENCE.  NULL: well; else what is wrong (a
   sentence; static storage), and z is empty.  Allocates nothing. */
const char *valences_read(valences *z, const char *text);

/* The valence number i, 0 <= i < count. */
long valences_get(const valences *z, long i);

#endif
