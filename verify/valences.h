/* valences.h: lists of valences as users write them: 3..20,50. */
#ifndef VERIFY_VALENCES_H
#define VERIFY_VALENCES_H

#include "choices.h"

#include <stddef.h>

typedef struct {
    long valence[CHOICES_MAX_VALENCE]; /* increasing, each once */
    size_t count;
} valences;

/* Reads a list of valences between CHOICES_MIN_VALENCE and CHOICES_MAX_VALENCE.  NULL: well; else what is wrong (a
   sentence; static storage), and z is empty.  Allocates nothing. */
const char *valences_read(valences *z, const char *text);

#endif
