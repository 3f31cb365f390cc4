/* range_spectrum.h: the dominance of L over all blocks of many valences (verify/certificate-valences.md, section 4).
   Compiled once per number system; affine sources may include it, too. */
#ifndef VERIFY_RANGE_SPECTRUM_H
#define VERIFY_RANGE_SPECTRUM_H

#include "../bigfloat/number.h"
#include "choices.h"
#include "findings.h"

#include "../lib/scheme.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* rest, n x n: what is left of block 1 beside L; scale thin, >= 1/L at all valences of c->k.  OUTCOME_TRUE: 1 is simple, and every eigenvalue of every block
   other than 1 and L is smaller than L in modulus, at each valence.  Finds the blocks, rise and spans of c, or follows
   them; figures and the reason of another outcome go to f. */
outcome BASE_NAME(range_spectrum)(findings *f, choices *c, const scheme *s, const base_number *rest, int n, const base_number *scale, bool replay, long prec);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define range_spectrum NUMBER_NAME(range_spectrum)
#endif

#endif
