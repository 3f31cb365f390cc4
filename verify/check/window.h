#ifndef CHECK_WINDOW_H
#define CHECK_WINDOW_H

/* Refutations by a window of frequencies: section 6 of certificate-valences.md. */

#include "mask.h"
#include "valences.h"

/* Proves that at each valence of v some frequency of the window dominates, and that those
 * that may do not wind once; returns what contains the largest modulus; else rejects.  q:
 * q_0, q_1, q_2. */
interval window_prove(const struct valence *v, const struct mask q[3],
                      const struct certificate *certificate);

#endif
