/* candidates.h: which blocks seem to hold the largest eigenvalues other than 1: where to look for a refutation.  Nothing
   here is proved.  Compiled once per number system. */
#ifndef VERIFY_CANDIDATES_H
#define VERIFY_CANDIDATES_H

#include "../lib/scheme.h"

enum { CANDIDATES_MAX = 64, CANDIDATES_MAX_NEAR = 4 };

typedef struct {
    int count;                      /* blocks whose largest modulus may be the largest of all, were it not for Jordan blocks */
    int near;                       /* the first of them: about as large as the first, and no more than CANDIDATES_MAX_NEAR */
    long frequency[CANDIDATES_MAX]; /* by falling modulus */
    double radius[CANDIDATES_MAX];
    long pair;                      /* the block between 0 and k/2 with the largest modulus, */
    double radius_of_pair;          /* this one; 0: there is none */
    double radius_of_one;           /* the largest modulus in block 1, */
    double radius_of_zero;          /*   and in block 0 without its 1 */
} candidates;

/* STATUS_BAD_INPUT: a formula has no value somewhere. */
status candidates_find_interval(candidates *z, const scheme *s, long k, diagnostic *d);
status candidates_find_ball(candidates *z, const scheme *s, long k, diagnostic *d);
status candidates_find_grid(candidates *z, const scheme *s, long k, diagnostic *d);

#endif
