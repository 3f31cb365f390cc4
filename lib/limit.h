/* limit.h: block 0 falls behind block 1 as the valence grows, though it tends to what block 1 tends to
   (verify/certificate-valences.md, section 4, "Limit").  Compiled once per number system.

   Block 0 without the constant net is a function of kappa = 1/k, down to kappa = 0.  Of its eigenvalue mu it is proved that it is
   simple and positive, that its slope is below minus that of L, and that all others are smaller than L at any k; at kappa = 0 it is
   no larger than L at u = 1.  So mu < L at all valences. */
#ifndef LIB_LIMIT_H
#define LIB_LIMIT_H

#include "block_affine.h"
#include "range_choices.h"

#define limit_search NUMBER_NAME(limit_search)
#define limit_verify NUMBER_NAME(limit_verify)

/* Whose valences, and what is known of the eigenvalue L of block 1 there. */
typedef struct {
    const scheme *scheme;
    valence_range k;      /* unbounded */
    const number *scale;  /* thin, >= 1/L at all valences */
    const number *slope;  /* of L by t, where u(0, 1/k.first) = c + d t */
} limit_task;

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool applies;        /* the centre comes to rest (lib/resting_centre.h) */
    bool proved;
} limit_answer;

/* Finds choices, on the grid 2^-g, with which limit_verify proves that all eigenvalues of block 0 but that of the constant net are
   smaller than L in modulus, at each valence.  It is assumed that block 1 without L has only eigenvalues smaller than 1/scale for
   all u of the range, u = 1 included.  z->q has no meaning.  power: of spectral_contraction at most. */
limit_answer limit_search(rise_box *z, const limit_task *task, int power, long g, long prec, diagnostic *d);

limit_answer limit_verify(const rise_box *z, const limit_task *task, long prec, diagnostic *d);

#endif
