#ifndef CHECK_STABILITY_H
#define CHECK_STABILITY_H

/* The constants K: section 4 of certificate.md, "Stability". */

#include "mask.h"

/* Whether K <= T/1024 is verified with the power N: lib/stability.md, section 3,
 * "Verification".  T > 1024, 1 <= N <= 9.  The scheme of the mask converges. */
bool stability_holds(const struct mask *mask, int n, int64_t t);

#endif
