#ifndef CHECK_LAURENT_H
#define CHECK_LAURENT_H

/* Laurent values: certificate-valences.md, section 4, "Limit", and section 6, "Growing". */

#include "affine.h"
#include "scheme.h"

enum { LAURENT_DEGREE = 64 };

/* The sum of c[i + LAURENT_DEGREE] k^i, |i| <= LAURENT_DEGREE. */
struct laurent {
    rational c[2 * LAURENT_DEGREE + 1];
};

/* The Laurent values of the weights of a rule for the centre, one for each source; false if one
 * has none. */
bool laurent_weights(struct laurent *out, const struct rule *rule, const struct environment *e);

/* In units of `unit`: the coefficients of (k/unit)^i. */
void laurent_rescale(struct laurent *a, int64_t unit);

/* The coefficient of k^i. */
rational laurent_at(const struct laurent *a, int i);

/* 1/kappa in the place of k; false if that has a negative exponent of kappa. */
bool laurent_in_kappa(struct affine *out, const struct laurent *a, struct affine kappa, int g);

#endif
