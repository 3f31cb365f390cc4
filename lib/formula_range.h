/* formula_range.h: formulas in enclosures over ranges of valences and frequencies.  Compiled once per number system
   (bigfloat/number.h). */
#ifndef LIB_FORMULA_RANGE_H
#define LIB_FORMULA_RANGE_H

#include "../bigfloat/number.h"
#include "exact_range.h"

/* z contains the value of f everywhere in the region.  At one valence and one frequency, and for formulas that do not depend
   on what varies, it is formula_value.  Otherwise a case that may apply counts with all the others that may, and what is
   not known, or is an error somewhere, is the whole line: whether the scheme is at fault, single valences and frequencies
   tell. */
#if !defined(NUMBER_JET) && !defined(NUMBER_AFFINE)
status NUMBER_NAME(formula_range)(number *z, const formula *f, const formula_region *at, long prec, diagnostic *d);
#else
status BASE_NAME(formula_range)(base_number *z, const formula *f, const formula_region *at, long prec, diagnostic *d);
#endif

#if defined(NUMBER_JET)
/* As a jet it is a constant of slope 0; if it may not be the same everywhere, it has no slope, and is indeterminate. */
static inline status NUMBER_NAME(formula_range)(jet *z, const formula *f, const formula_region *at, long prec, diagnostic *d)
{
    bool constant;
    jet_zero(z);
    if (!formula_is_constant(&constant, f, at))
        return STATUS_NO_MEMORY;
    if (!constant)
        base_indeterminate(&z->slope);
    return BASE_NAME(formula_range)(&z->value, f, at, prec, d);
}
#elif defined(NUMBER_AFFINE)
/* As an affine number its slope is 0; if it is the same everywhere, it is sloped (bigfloat/affine.h). */
static inline status NUMBER_NAME(formula_range)(affine *z, const formula *f, const formula_region *at, long prec, diagnostic *d)
{
    affine_zero(z);
    return BASE_NAME(formula_range)(&z->centre, f, at, prec, d);
}
#endif

#endif
