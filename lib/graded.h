/* graded.h: block 0 scaled by powers of kappa = unit/k, where weights of the centre grow with k, and the net of its eigenvector
   (verify/certificate-valences.md, section 6, "Growing without bound").  Compiled for affine numbers of each system.

   M_ij = kappa^(d + e_j - e_i) B_ij stays bounded as k grows, if the degree d and the grades e are well chosen; if x, L is a pair of
   M, the kappa^e_i x_i are an eigenvector of B, and L kappa^-d is its eigenvalue. */
#ifndef LIB_GRADED_H
#define LIB_GRADED_H

#include "block.h"
#include "graded_choice.h"
#include "laurent_value.h"
#include "ring.h"

#define graded_block NUMBER_NAME(graded_block)
#define graded_block_make NUMBER_NAME(graded_block_make)
#define graded_block_free NUMBER_NAME(graded_block_free)
#define graded_block_set_unit NUMBER_NAME(graded_block_set_unit)
#define graded_choose NUMBER_NAME(graded_choose)
#define graded_matrix NUMBER_NAME(graded_matrix)
#define graded_net_make NUMBER_NAME(graded_net_make)

typedef struct {
    const block *plain;     /* block 0, kept by the caller; its first row, that of the centre, has no meaning */
    laurent_value *centre;  /* what each unknown contributes to the new centre, a Laurent polynomial in k/unit (before there is one: in k) */
    number kappa;           /* once there is a unit */
} graded_block;

/* Makes both the plain block and z; the scheme must be graded (lib/graded_scheme.h).  Sets the weights of the centre in `numbers`, to 0.  On any
   status graded_block_free, and block_free of the plain one. */
block_status graded_block_make(graded_block *z, block *plain, scheme_numbers *numbers, diagnostic *d);
void graded_block_free(graded_block *z);

/* A unit that makes the scaled eigenvalue about 1, and a degree and grades with which graded_matrix has no negative powers; they may be
   beyond the limits of certificates.  false: no memory. */
bool graded_choose(graded_choice *z, const graded_block *b);

/* Once, behind that.  false: no memory. */
bool graded_block_set_unit(graded_block *z, long unit, long prec);

/* *m = M, a new matrix of order b->plain->n.  TRUTH_UNKNOWN: some power is negative, or the choice is of another order; TRUTH_FALSE: no memory. */
truth graded_matrix(number **m, const graded_block *b, const graded_choice *c, long prec);

/* net = the eigenvector of M, `box` (n components, then L), extended to the rings that r needs: as far as the windows of r's boundary
   reach the values of the eigenvector of B, times one power of kappa.  On any status sector_net_free. */
block_status graded_net_make(sector_net *net, const graded_block *b, const graded_choice *c, const number *box, const scheme_numbers *numbers, const ring *r);

#endif
