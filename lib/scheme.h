/* scheme.h: a subdivision scheme as its file says it, exact and ready to use (lib/scheme.md).

   A `scheme` denotes the stationary subdivision rules on all meshes: the regular mask and the rule at an
   extraordinary vertex as formulas in the valence.  What always holds after scheme_read: the mask is affine
   invariant, invariant under rotation by a sixth of a turn and under reflection, all exactly. */
#ifndef LIB_SCHEME_H
#define LIB_SCHEME_H

#include "formula.h"
#include "laurent.h"
#include "text.h"

#define SCHEME_NAME_MAX 64
/* The largest |point| that a mask may have. */
#define SCHEME_MAX_REACH 8

typedef struct {
    char name[SCHEME_NAME_MAX + 1];
    source_text source;
    laurent mask;          /* p'(x) = sum mask(x - 2y) p(y) */
    int reach;             /* h: the largest |point| of the mask */
    /* The rule at the extraordinary vertex: total weights, one of them NULL = the rest to 1. */
    formula *centre_weight;
    formula *ring_weight;
} scheme;

void scheme_init(scheme *z);
void scheme_clear(scheme *z);

/* Reads the `length` bytes of a scheme file. */
status scheme_read(scheme *z, const char *bytes, size_t length, diagnostic *d);

#endif
