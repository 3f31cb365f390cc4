#ifndef CHECK_FORMULA_H
#define CHECK_FORMULA_H

/* Formulas
 * ========
 *
 * lib/scheme.md, "Value of a formula at a valence k".  A value is an exact
 * rational q, an angle q pi (q not 0), or an enclosure.
 */

#include "grid.h"
#include "text.h"

struct value {
    enum { RATIONAL, ANGLE, ENCLOSURE } kind;
    rational q;                                    /* RATIONAL, ANGLE */
    interval x;                                    /* ENCLOSURE */
};

/* Reads a formula and evaluates it on the grid g.  k = 0: k may not occur. */
void formula_evaluate(struct value *out, struct cursor *c, int k, int g);

/* The enclosure that a value is turned into. */
void value_enclose(interval *out, const struct value *v, int g);

#endif
