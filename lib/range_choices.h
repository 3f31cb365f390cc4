/* range_choices.h: the choices that bound all blocks of a range of valences (verify/certificate-valences.md, sections 4
   and 6).  Exact, the same for all number systems.

   q = m/k is counted in units of 2^-ARC_BITS. */
#ifndef LIB_RANGE_CHOICES_H
#define LIB_RANGE_CHOICES_H

#include "arc.h"
#include "eigenpair_choice.h"

#include <stddef.h>
#include <stdint.h>

/* From the q of the box before to this one: an eigenpair of all blocks there, and the power that bounds the rest of them. */
typedef struct {
    int64_t q;
    eigenpair_choice eigenpair;
    int power;
} rise_box;

typedef struct {
    rise_box *box;
    size_t count, capacity;
} rise_list;

void rise_list_init(rise_list *z);
void rise_list_clear(rise_list *z);
/* A new last box with nothing in its eigenpair.  NULL: no memory. */
rise_box *rise_list_add(rise_list *z);

/* Blocks of the frequencies m, from the q of the box before, if that is of the same frequencies, to this one. */
typedef struct {
    frequencies m;
    int64_t q;
    int power;
} span_box;

typedef struct {
    span_box *box;
    size_t count, capacity;
} span_list;

void span_list_init(span_list *z);
void span_list_clear(span_list *z);
BIGFLOAT_MUST_USE bool span_list_add(span_list *z, span_box b); /* false: no memory */

#endif
