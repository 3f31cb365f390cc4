/* formula_range.h: formulas in enclosures over a range of frequencies.  Compiled once per number system
   (bigfloat/number.h). */
#ifndef LIB_FORMULA_RANGE_H
#define LIB_FORMULA_RANGE_H

#include "../bigfloat/number.h"
#include "exact_range.h"

/* z contains the value of f at every m of the range (with k and j of `at`).  For one m, and for formulas that do not
   depend on m, it is formula_value.  Otherwise a case that may apply counts with all the others that may, and what is
   not known, or is an error at some m, is the whole line: whether the scheme is at fault, single frequencies tell. */
status NUMBER_NAME(formula_range)(number *z, const formula *f, const formula_point *at, frequencies m, long prec, diagnostic *d);

#endif
