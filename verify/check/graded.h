#ifndef CHECK_GRADED_H
#define CHECK_GRADED_H

/* An eigenvalue of block 0 that grows with k: certificate-valences.md, section 6, "Growing without
 * bound". */

#include "mask.h"
#include "sector.h"
#include "certificate.h"

/* Block 0, but for the rules of the centre, whose weights need no values on the grid; rejects
 * schemes that are not made for it. */
void graded_prepare_block(struct block *out, const struct valence *v);

/* Proves |l| > 1 and that its function is not 0, at each valence; returns what contains
 * |l| (q/k)^d; else rejects.  q: q_0, q_1, q_2. */
interval graded_prove(const struct block *block, const struct mask q[3],
                      const struct certificate *certificate);

#endif
