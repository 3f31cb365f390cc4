#ifndef CHECK_LAURENT_H
#define CHECK_LAURENT_H

/* Laurent values: certificate-valences.md, section 4, "Limit". */

#include "value.h"

enum { LAURENT_DEGREE = 64 };

/* The sum of c[i + LAURENT_DEGREE] k^i, |i| <= LAURENT_DEGREE. */
struct laurent {
    rational c[2 * LAURENT_DEGREE + 1];
};

/* The Laurent value of a formula; false if it has none. */
bool laurent_evaluate(struct laurent *out, const struct node *formula,
                      const struct environment *e);

struct laurent laurent_constant(rational q);
void laurent_subtract(struct laurent *a, const struct laurent *b);

/* The coefficient of k^i. */
rational laurent_at(const struct laurent *a, int i);

#endif
