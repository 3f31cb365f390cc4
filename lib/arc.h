/* arc.h: angles pi r with low <= r <= high, 0 <= low <= high <= 1/2: what pi m / k may be (verify/certificate-valences.md). */
#ifndef LIB_ARC_H
#define LIB_ARC_H

#include "exact_range.h"

/* Arcs of certificates begin and end at multiples of pi 2^-ARC_BITS. */
#define ARC_BITS 48
#define ARC_HALF ((int64_t)1 << (ARC_BITS - 1))

typedef struct {
    rational low, high;
} arc;

void arc_init(arc *z); /* 0 */
void arc_clear(arc *z);

/* From low to high, in units of 2^-ARC_BITS; 0 <= low <= high <= ARC_HALF. */
BIGFLOAT_MUST_USE bool arc_set_units(arc *z, int64_t low, int64_t high);
/* From m/k2 to m/k1, for a frequency m, 2 m <= k1. */
BIGFLOAT_MUST_USE bool arc_set_frequency(arc *z, long m, valence_range k);
static inline bool arc_set_valences(arc *z, valence_range k) { return arc_set_frequency(z, 1, k); }

/* floor(m 2^ARC_BITS / k) and ceil(m 2^ARC_BITS / k), at most ARC_HALF: the ends of m/k.  m or k may be unbounded: 0 for an
   unbounded k, else ARC_HALF for an unbounded m. */
int64_t arc_units_below(long m, long k);
int64_t arc_units_above(long m, long k);

#endif
