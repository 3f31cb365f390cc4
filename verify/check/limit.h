#ifndef CHECK_LIMIT_H
#define CHECK_LIMIT_H

/* Block 0 where it tends to block 1: certificate-valences.md, section 4, "Limit". */

#include "spectrum.h"

/* Proves that all eigenvalues of block 0 but 1 are smaller than L, that of the pair, at each
 * valence; else rejects. */
void limit_prove(const struct valence *v, const struct eigenpair *pair,
                 const struct certificate *certificate);

#endif
