/* comparison.h: how far one step of a scheme can be from one step of a simple scheme, exactly (lib/stability.md, 5).

   The simple scheme B has non-negative weights and a known limit, which turns nets into functions L: piecewise
     linear on triangles, bilinear on primal quads, constant on dual quads (one value for each square);
   for the derivative in direction 1 (in direction 2 alike)
     constant on triangles; on quads constant in direction 1 and linear in direction 2; on dual quads linear in
     direction 1 and constant in direction 2.
   C is a number with |(S - B) p| <= C D(p), D(p) = the largest |p(x + u) - p(x)|, |p(x + v) - p(x)|, where u, v are
     e1, e2 for values and on quads; e2, e3 and e1, e3 for the first and second derivative on triangles. */
#ifndef LIB_COMPARISON_H
#define LIB_COMPARISON_H

#include "regular.h"

/* z = the mask of B for values. */
BIGFLOAT_MUST_USE bool comparison_values(laurent *z, mesh_kind mesh);
/* z = the mask of B for divided differences in direction 0 or 1. */
BIGFLOAT_MUST_USE bool comparison_derivative(laurent *z, mesh_kind mesh, int direction);

/* c = the least C for the masks s and b, which have the same sum in each class; u, v is a basis of the lattice. */
BIGFLOAT_MUST_USE bool comparison_constant(rational *c, const laurent *s, const laurent *b, lattice u, lattice v);

/* The constants of a scheme: C for values, C_1 and C_2 for its derivatives. */
typedef struct {
    rational values, derivative[2];
} comparison;

void comparison_init(comparison *z);
void comparison_clear(comparison *z);
/* masks must be divisible. */
BIGFLOAT_MUST_USE bool comparison_make(comparison *z, const laurent *mask, const regular_masks *masks);

#endif
