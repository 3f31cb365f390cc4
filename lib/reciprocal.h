/* reciprocal.h: kappa, a multiple of 1/k, as an affine number, its powers, and Laurent values in it (verify/certificate-valences.md,
   sections 4 and 6).  Compiled for affine numbers of each system. */
#ifndef LIB_RECIPROCAL_H
#define LIB_RECIPROCAL_H

#include "../bigfloat/number.h"
#include "laurent_value.h"

#define reciprocal_set NUMBER_NAME(reciprocal_set)
#define reciprocal_set_down_to_zero NUMBER_NAME(reciprocal_set_down_to_zero)
#define reciprocal_powers NUMBER_NAME(reciprocal_powers)
#define reciprocal_laurent_value NUMBER_NAME(reciprocal_laurent_value)

/* unit/k = c + d t for each k of the range and some t, unit >= 1: from unit/last, or 0, to unit/first.  false: no memory. */
bool reciprocal_set(affine *kappa, long unit, valence_range k, long prec);
/* 1/k, of a range without an end: 0 at t = -1, exactly, and 1/first at t = 1. */
bool reciprocal_set_down_to_zero(affine *kappa, valence_range k, long prec);

/* A new array: kappa^0 .. kappa^(count-1), each the one before times kappa; NULL: no memory. */
affine *reciprocal_powers(const affine *kappa, int count, long prec);

/* z = w at k = 1/kappa, by Horner's rule; w has no exponents > 0. */
void reciprocal_laurent_value(affine *z, const laurent_value *w, const affine *kappa, long prec);

#endif
