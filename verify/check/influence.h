#ifndef CHECK_INFLUENCE_H
#define CHECK_INFLUENCE_H

/* Influence: lib/ring.md. */

#include "scheme.h"

/* F: the farthest ring on which a new value may not follow the scheme's mask, at
 * whatever valence beyond the regular one. */
int scheme_influence(const struct scheme *scheme);

#endif
