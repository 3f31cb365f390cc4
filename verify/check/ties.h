#ifndef CHECK_TIES_H
#define CHECK_TIES_H

/* Refutations by eigenvalues that are equal: exact.md. */

#include "spectrum.h"

/* Proves what the `exact` lines say of the largest eigenvalue beside 1 (or, modulus-one, of 1 or
 * -1), and that the eigenfunctions that count are as the reason needs; or rejects.  The
 * frequencies without such a line are left: of these all eigenvalues, but 1, must be smaller than
 * 1/s.  lambda: the box of the eigenvalue's modulus. */
struct tie {
    interval lambda, s;
    int64_t frequency;                             /* of the first line that counts */
};

struct tie tie_prove(const struct valence *v, const struct mask q[3],
                     const struct certificate *certificate);

#endif
