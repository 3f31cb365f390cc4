/* stability.h: how much larger than its data a limit can be, exactly (proofs: lib/stability.md).

   For a convergent scheme that reproduces constants, with the basis functions phi(y - i),

       K = sup over y of the sum over i of |phi(y - i)|

   is the norm of the map from data to limits.  This file finds rational upper bounds of K, all of them proved. */
#ifndef LIB_STABILITY_H
#define LIB_STABILITY_H

#include "comparison.h"

/* Bounds are multiples of 1/1024, so that they are exact in binary. */
#define STABILITY_UNIT 1024
#define STABILITY_MAX_BOUND ((int64_t)1 << 40)
/* How many pairs of coefficients one pass over S^N may look at. */
#define STABILITY_MAX_WORK 8e7

typedef enum {
    STABILITY_NONE,   /* no bound was found */
    STABILITY_CONVEX, /* no weight is negative: K = 1 (lib/stability.md, 2) */
    STABILITY_WINDOW, /* rows of S^N in one window are close (3) */
    STABILITY_SERIES  /* |S^N| and what further steps can add (4) */
} stability_kind;

typedef struct {
    stability_kind kind;
    int64_t bound; /* K <= bound / STABILITY_UNIT */
    int power;     /* N */
} stability;

/* The best bound that the limits allow, for the mask itself (derivative = -1) or the derivative scheme 2 a_1 or 2 a_2
   (derivative = 0, 1).  masks are the mask's own, and the scheme must be proved C1 on the regular complex
   (regular_contraction); c are its comparison constants. */
BIGFLOAT_MUST_USE bool stability_find(stability *z, const laurent *mask, const regular_masks *masks, const comparison *c, int derivative);

/* Do the windows of S^N prove K <= bound / STABILITY_UNIT for the mask s?  It is what STABILITY_WINDOW claims: a
   certificate can hold N and the bound, and whoever checks it does this.  Where the work would exceed the limits the
   answer is false. */
BIGFLOAT_MUST_USE bool stability_verify_window(bool *proved, const laurent *s, int exponent, int64_t bound);

#endif
