#ifndef CHECK_VALENCES_H
#define CHECK_VALENCES_H

/* The spectrum at several valences: section 4 of certificate-valences.md. */

#include "spectrum.h"

/* Block 1, over all valences of v. */
void valences_prepare_block(struct block *out, const struct valence *v);

/* Proves the eigenpair of block 1 with 0 < L < 1, and that all other eigenvalues but 1 are
 * smaller than L in modulus; else rejects. */
struct eigenpair valences_prove_spectrum(const struct block *block,
                                         const struct certificate *certificate);

#endif
