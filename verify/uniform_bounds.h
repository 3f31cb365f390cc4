/* uniform_bounds.h: what the uniform method knows of the regular scheme, exactly (verify/uniform.md, 2). */
#ifndef VERIFY_UNIFORM_BOUNDS_H
#define VERIFY_UNIFORM_BOUNDS_H

#include "problem.h"

typedef struct {
    rational constant[RING_NETS];      /* c of (4.26) to (4.28): the thesis's, or the least one where that is larger */
    norm_list contraction[RING_NETS];  /* norm[N]: gamma of N steps */
    lattice direction[RING_NETS][2];   /* D takes differences in these */
    laurent_extent extent[RING_NETS];  /* of the masks: how far windows reach */
    const char *obstacle;              /* NULL, or why the method cannot be used: a sentence */
} uniform_bounds;

void uniform_bounds_init(uniform_bounds *z);
void uniform_bounds_clear(uniform_bounds *z);
/* p must have been made; where it has an obstacle, z has it, too. */
BIGFLOAT_MUST_USE bool uniform_bounds_make(uniform_bounds *z, const problem *p);

#endif
