/* regular_refutation.h: proofs, in exact arithmetic, that a mask's limits are not C1 (lib/regular_refutation.md).

   The values of a limit at the points 2^-N x, x fixed, follow a linear recurrence.  If limits are C1, nothing in it may
   fall more slowly than 2^-N or as slowly, but a constant and 2^-N itself, in those nets that turn as linear functions do. */
#ifndef LIB_REGULAR_REFUTATION_H
#define LIB_REGULAR_REFUTATION_H

#include "laurent.h"
#include "mesh.h"

/* Moduli are multiples of 1/1024. */
#define REFUTATION_UNIT 1024

typedef struct {
    bool refuted;    /* the mask is not C1 on the regular complex.  false: nothing is known */
    int frequency;   /* of nets with an eigenvalue that C1 does not admit */
    lattice point;   /* its eigenfunction (or a generalised one) is not 0 at one of this point's images under rotation; (0,0):
                        nets of that eigenvalue, 1, do not converge to a continuous function */
    int64_t modulus; /* the eigenvalue's modulus is at least modulus / REFUTATION_UNIT, which is at least 1/2 */
} regular_refutation;

/* The mask sums to 1 on each class and is invariant under rotation by one sector.  What would take too long is left out. */
BIGFLOAT_MUST_USE bool regular_refute(regular_refutation *z, const laurent *mask, mesh_kind mesh);

#endif
