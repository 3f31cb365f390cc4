/* range_spectrum.h: the dominance of L over all blocks of many valences (verify/certificate-valences.md, section 4).
   Compiled once per number system; affine sources may include it, too. */
#ifndef VERIFY_RANGE_SPECTRUM_H
#define VERIFY_RANGE_SPECTRUM_H

#include "../bigfloat/number.h"
#include "../bigfloat/affine.h"
#include "choices.h"
#include "findings.h"

#include "../lib/scheme.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* A pair of the block of the choices' frequency, proved by eigenpair_affine_prove: of block 0 without the constant net. */
typedef struct {
    const affine *matrix; /* order x order */
    const affine *box;    /* order + 1 */
    int order, pivot;
} BASE_NAME(range_pair);

/* scale thin, >= 1/L at all valences of c->k, L being the pair's, of block 1; its slope is by t, where u of c->k is c + d t.
   OUTCOME_TRUE: 1 is simple, and every eigenvalue of every block other than 1 and L is smaller than L in modulus, at each valence.
   Finds the blocks, rise and spans of c, or follows them; figures and the reason of another outcome go to f. */
outcome BASE_NAME(range_spectrum)(findings *f, choices *c, const scheme *s, const BASE_NAME(range_pair) *pair, const base_number *scale, bool replay, long prec);

/* The same of a pair of any one frequency (section 6, "At one frequency"): of blocks and spans only, and scale >= 1/|L|. */
outcome BASE_NAME(range_spectrum_of_frequency)(findings *f, choices *c, const scheme *s, const BASE_NAME(range_pair) *pair, const base_number *scale, bool replay, long prec);

/* Every eigenvalue other than 1 of every block outside the window of c (CLAIM_WINDOW) is smaller than 1/scale in modulus, at each valence; likewise. */
outcome BASE_NAME(range_window_spectrum)(findings *f, choices *c, const scheme *s, const base_number *scale, bool replay, long prec);

/* About the largest modulus of an eigenvalue of the blocks m >= 2 with m/k = q, in the units of lib/arc.h; NAN: not known. */
double BASE_NAME(range_radius_approx)(const scheme *s, valence_range k, int64_t q, long prec);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define range_pair NUMBER_NAME(range_pair)
#define range_spectrum NUMBER_NAME(range_spectrum)
#define range_spectrum_of_frequency NUMBER_NAME(range_spectrum_of_frequency)
#define range_window_spectrum NUMBER_NAME(range_window_spectrum)
#define range_radius_approx NUMBER_NAME(range_radius_approx)
#endif

#endif
