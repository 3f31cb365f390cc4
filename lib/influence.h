/* influence.h: how far from the extraordinary place a new value can be anything else than the composed mask says.

   Exact and combinatorial, for all valences together: whatever holds a rule, under any condition, counts (lib/ring.md, 3). */
#ifndef LIB_INFLUENCE_H
#define LIB_INFLUENCE_H

#include "scheme.h"

/* *ring = F: on every ring beyond F, at every valence, a new value (after all steps of one subdivision) is the sum of
   mask(x - 2y) times the old value at y in the chart of its own sector, no y is opposite, and no rule took part.
   false: no memory. */
BIGFLOAT_MUST_USE bool influence_farthest(int *ring, const scheme *s);

#endif
