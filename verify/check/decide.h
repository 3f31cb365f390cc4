#ifndef CHECK_DECIDE_H
#define CHECK_DECIDE_H

/* The decisions: sections 8 and 10 of certificate.md. */

#include "characteristic.h"

/* Proves by the trees or witnesses of the certificate what its claim, or its reason, needs of
 * the function; else rejects. */
void decide_claim(const struct characteristic *c, const struct certificate *certificate);

/* The witness of `real`: a place where the derivatives of two functions, each a part of c's or of
 * d's, are not parallel. */
void decide_independent(const struct characteristic *c, const struct characteristic *d,
                        const struct certificate *certificate);

#endif
