/* regular.h: the regular part, exactly: difference masks and their norms (MATH of contraction: verify/certificate.md,
   section 4).

   Directions are numbered 0, 1, 2 for e1 = (1,0), e2 = (0,1), e3 = (1,-1); pairs 0, 1, 2 for (e1,e2), (e1,e3),
   (e2,e3). */
#ifndef LIB_REGULAR_H
#define LIB_REGULAR_H

#include "laurent.h"

extern const lattice regular_direction[3];

typedef struct {
    laurent derivative[2]; /* 2 a_d for e1, e2: refines the divided differences in direction d */
    laurent second[3];     /* 2 a_dd' for the three pairs */
    bool divisible;        /* false: a division left a remainder, and the criterion is silent */
} regular_masks;

void regular_init(regular_masks *z);
void regular_clear(regular_masks *z);
BIGFLOAT_MUST_USE bool regular_derive(regular_masks *z, const laurent *mask);

/* The largest power that regular_contraction tries: 2^6 classes in each direction. */
#define REGULAR_MAX_POWER 6
/* And it stops where a product would take more multiplications than this. */
#define REGULAR_MAX_WORK 3e7

/* norm = |S^N| for the scheme with mask s, 1 <= power <= REGULAR_MAX_POWER. */
BIGFLOAT_MUST_USE bool regular_norm(rational *norm, const laurent *s, int power);

/* For each pair the least N with |S^N| < 1 and that norm; power[i] = 0 when there is none up to the limit.
   All three non-zero prove that the scheme is C1 on the regular complex. */
BIGFLOAT_MUST_USE bool regular_contraction(int power[3], rational norm[3], const regular_masks *masks);

#endif
