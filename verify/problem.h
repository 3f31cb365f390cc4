/* problem.h: what is the same for all valences and all number systems: the scheme and its regular part, exactly. */
#ifndef VERIFY_PROBLEM_H
#define VERIFY_PROBLEM_H

#include "../lib/bernstein.h"
#include "../lib/ring.h"
#include "choices.h"

typedef struct {
    const scheme *scheme;
    regular_masks regular;
    int contraction[3]; /* N of the three norms (lib/regular.h), all > 0 if C1 on the regular complex is proved */
    rational norm[3];
    stability_choice stability[RING_NETS]; /* K of values and both derivatives */
    ring geometry;
    bool polynomial;              /* the mask is of a box spline: limits are polynomials on elements, */
    bernstein bernstein[RING_NETS]; /* these */
    const char *obstacle;         /* NULL, or why no valence can be decided: a sentence */
    const char *special_obstacle; /* NULL, or why only plainly regular valences can */
} problem;

void problem_init(problem *z);
void problem_clear(problem *z);
/* Analyses the regular part of the scheme, which the caller keeps. */
BIGFLOAT_MUST_USE bool problem_make(problem *z, const scheme *s);

/* *plainly: k is the regular valence and no rule holds there: the regular part is all there is to prove. */
status problem_is_plainly_regular(bool *plainly, const problem *z, long k, diagnostic *d);

#endif
