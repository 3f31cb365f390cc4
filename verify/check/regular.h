#ifndef CHECK_REGULAR_H
#define CHECK_REGULAR_H

/* C1 on the regular complex: section 4 of certificate.md. */

#include "mask.h"

/* The masks that the section derives from the scheme's mask. */
struct derived_masks {
    struct mask first[2];                          /* a_1, a_2 */
    struct mask second[3];                         /* a_dd' */
    int name[3];                                   /* 10 d + d' */
};

/* False if a division leaves a remainder. */
bool regular_derive(struct derived_masks *out, const struct mask *mask, enum mesh mesh);

/* Whether the norm of s^N, s = 2 second, is < 1. */
bool regular_contracts(const struct mask *second, int n);

/* Whether K <= T/1024 is verified with the power N: lib/stability.md, section 3,
 * "Verification".  T > 1024, 1 <= N <= 9.  The scheme of the mask converges. */
bool stability_holds(const struct mask *mask, int n, int64_t t);

#endif
