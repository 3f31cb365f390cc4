/* formula_value.h: formulas and weights in enclosures.  Compiled once per number system (bigfloat/number.h). */
#ifndef LIB_FORMULA_VALUE_H
#define LIB_FORMULA_VALUE_H

#include "../bigfloat/number.h"
#include "scheme.h"

/* z encloses the value of f at valence k; evaluated as lib/scheme.md says, exactly as far as it is exact. */
status NUMBER_NAME(formula_value)(number *z, const formula *f, long k, long prec, diagnostic *d);

/* The total weights of the rule at the extraordinary vertex at valence k: centre + ring = 1. */
status NUMBER_NAME(scheme_weights)(number *centre, number *ring, const scheme *s, long k, long prec, diagnostic *d);

#endif
