/* valence_range.h: what one piece of evidence speaks of: one valence, or all of a range that may have no end. */
#ifndef VERIFY_VALENCE_RANGE_H
#define VERIFY_VALENCE_RANGE_H

#include "../lib/exact_range.h"

#include <stdbool.h>

/* Room for any of them as text. */
enum { VALENCE_RANGE_TEXT = 48 };

static inline bool valence_range_equal(valence_range a, valence_range b) { return a.first == b.first && a.last == b.last; }
static inline bool valence_range_overlap(valence_range a, valence_range b) { return a.first <= b.last && b.first <= a.last; }
static inline bool valence_range_contains(valence_range a, valence_range b) { return a.first <= b.first && b.last <= a.last; }

/* By first, then by last: < 0, 0, > 0. */
int valence_range_compare(valence_range a, valence_range b);

/* "7", "8..20" or "21..inf". */
void valence_range_print(char text[VALENCE_RANGE_TEXT], valence_range r);

/* Reads such a text, in its one canonical form.  Returns what follows it, or NULL: there is none. */
const char *valence_range_read(valence_range *r, const char *text);

#endif
