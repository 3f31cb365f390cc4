#ifndef CHECK_DECIDE_H
#define CHECK_DECIDE_H

/* The decisions: section 8 of certificate.md. */

#include "characteristic.h"

/* The Jacobian is positive on the closed ring; else rejects. */
void decide_regularity(const struct characteristic *c,
                       const struct certificate *certificate);

/* The outer curve of one sector lies in the open half-plane; else rejects. */
void decide_boundary(const struct characteristic *c,
                     const struct certificate *certificate);

/* The outer curve of one sector is proved not to meet 0; else rejects. */
void decide_outer_curve(const struct characteristic *c,
                        const struct certificate *certificate);

/* The same, and it winds another number of times than once; else rejects. */
void decide_winding(const struct characteristic *c, const struct certificate *certificate);

/* The witnesses of `not-c0` and `fold`. */
void decide_not_zero(const struct characteristic *c, const struct certificate *certificate);
void decide_fold(const struct characteristic *c, const struct certificate *certificate);

/* The witness of `real`: a place where the derivatives of two functions, each a part of c's or of
 * d's, are not parallel. */
void decide_independent(const struct characteristic *c, const struct characteristic *d,
                        const struct certificate *certificate);

#endif
