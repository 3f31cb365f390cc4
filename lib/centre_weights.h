/* centre_weights.h: the weights of the centre as functions of k, where nothing else depends on it (verify/certificate-valences.md,
   sections 4, "Limit", and 6, "Growing without bound").  Exact. */
#ifndef LIB_CENTRE_WEIGHTS_H
#define LIB_CENTRE_WEIGHTS_H

#include "laurent_value.h"
#include "scheme.h"

/* The weights of a rule of the centre for all k of a range, source by source, the rest as what it is worth. */
typedef struct {
    int count;
    laurent_value weight[SCHEME_MAX_SOURCES];
} centre_weights;

/* *known false: some weight has no Laurent value.  false: no memory.  On either centre_weights_clear. */
BIGFLOAT_MUST_USE bool centre_weights_make(centre_weights *z, bool *known, const rule *r, valence_range k);
void centre_weights_clear(centre_weights *z);

/* Is there a centre, are all rules decided for the range, and of those that hold for other points: no weight depends on k
   or m, and no source is `all`, `spectrum` or `@ j`? */
status scheme_centre_alone_varies(bool *alone, const scheme *s, valence_range k, diagnostic *d);

#endif
