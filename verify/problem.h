/* problem.h: what is the same for all valences and all number systems: the scheme and its regular part, exactly. */
#ifndef VERIFY_PROBLEM_H
#define VERIFY_PROBLEM_H

#include "../lib/ring.h"

typedef struct {
    const scheme *scheme;
    regular_masks regular;
    int contraction[3]; /* N of the three norms (lib/regular.h), all > 0 if C1 on the regular complex is proved */
    rational norm[3];
    ring geometry;
    const char *obstacle; /* NULL, or why no valence can be decided: a sentence */
} problem;

void problem_init(problem *z);
void problem_clear(problem *z);
/* Analyses the regular part of the scheme, which the caller keeps. */
BIGFLOAT_MUST_USE bool problem_make(problem *z, const scheme *s);

#endif
