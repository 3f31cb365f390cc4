/* formula_value.h: formulas and weights in enclosures.  Compiled once per number system (bigfloat/number.h). */
#ifndef LIB_FORMULA_VALUE_H
#define LIB_FORMULA_VALUE_H

#include "../bigfloat/number.h"
#include "formula.h"

/* z encloses the value of f at the point; evaluated as lib/scheme.md says, exactly as far as it is exact.
   What enclosures leave open (a divisor that may be 0, a root that may be of something negative, a comparison that
   cannot be decided) gives the whole line; bad input is what is wrong at every precision. */
status NUMBER_NAME(formula_value)(number *z, const formula *f, const formula_point *at, long prec, diagnostic *d);

#endif
