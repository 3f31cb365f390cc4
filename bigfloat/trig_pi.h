/* trig_pi.h: cos(pi r) and sin(pi r) for rational r, reduced exactly. */
#ifndef BIGFLOAT_TRIG_PI_H
#define BIGFLOAT_TRIG_PI_H

#include "rational.h"

/* cos(pi r) = (-1)^negative f(pi t) with 0 <= t <= 1/4 and f = cos or sin; or cos(pi r) = half / 2 exactly.
   By Niven's theorem the values 0, +-1/2, +-1 are the only rational ones: in all other cases the value is
   irrational. */
typedef struct {
    bool exact;
    int half; /* if exact: -2, -1, 0, 1 or 2 */
    bool sine;
    bool negative;
    rational t;
} trig_pi;

/* For sin(pi r) the same with `of_sine`.  The caller clears u->t.  False = no memory. */
BIGFLOAT_MUST_USE bool trig_pi_reduce(trig_pi *u, const rational *r, bool of_sine);

#endif
