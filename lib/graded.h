/* graded.h: block 0 scaled by powers of kappa = unit/k, where weights of the centre grow with k, and the net of its eigenvector
   (verify/certificate-valences.md, section 6, "Growing without bound").  Compiled for affine numbers of each system.

   M_ij = kappa^(d + e_j - e_i) B_ij stays bounded as k grows, if the degree d and the grades e are well chosen; if x, L is a pair of
   M, the kappa^e_i x_i are an eigenvector of B, and L kappa^-d is its eigenvalue. */
#ifndef LIB_GRADED_H
#define LIB_GRADED_H

#include "block.h"
#include "graded_choice.h"
#include "graded_net.h"
#include "ring.h"

#define graded_block NUMBER_NAME(graded_block)
#define graded_block_make NUMBER_NAME(graded_block_make)
#define graded_block_free NUMBER_NAME(graded_block_free)
#define graded_block_scale NUMBER_NAME(graded_block_scale)
#define graded_choose NUMBER_NAME(graded_choose)
#define graded_matrix NUMBER_NAME(graded_matrix)
#define graded_sector_net NUMBER_NAME(graded_sector_net)

/* B_ij = kappa^order[i n + j] entry[i n + j], or 0 where the order is GRADED_ABSENT. */
typedef struct {
    const block *plain;            /* block 0, kept by the caller; its entries are computed without weights of the centre, and have no meaning */
    const scheme_numbers *numbers; /* kept by the caller */
    centre_weights weights[SCHEME_MAX_STEPS]; /* of the centre's rule in each step, if it has one; in k/unit */
    number kappa;                  /* once there is a unit, and these: */
    int *order;
    number *entry;
} graded_block;

static inline int graded_place(const graded_net *net, const unknown *p)
{
    return p->kind == UNKNOWN_CENTRE ? GRADED_CENTRE : graded_index(net, p->a, p->b);
}

/* Makes the plain block, too; the scheme must be graded (lib/graded_scheme.h).  Sets the weights of the centre in `numbers`, to 0.  On any
   status graded_block_free, and block_free of the plain one. */
block_status graded_block_make(graded_block *z, block *plain, scheme_numbers *numbers, diagnostic *d);
void graded_block_free(graded_block *z);

/* A unit that makes the scaled eigenvalue about 1, and a degree and grades with which graded_matrix has no negative powers; they may be
   beyond the limits of certificates.  Once, before there is a unit. */
block_status graded_choose(graded_choice *z, graded_block *b);

/* Once, behind that. */
block_status graded_block_scale(graded_block *z, long unit);

/* *m = M, a new matrix of order b->plain->n.  TRUTH_UNKNOWN: some power is negative, or the choice is of another order; TRUTH_FALSE: no memory. */
truth graded_matrix(number **m, const graded_block *b, const graded_choice *c);

/* net = the eigenvector of M, `box` (n components, then L), extended to the rings that r needs: as far as the windows of r's boundary
   reach the values of the eigenvector of B, times one power of kappa.  On any status sector_net_free. */
block_status graded_sector_net(sector_net *net, const graded_block *b, const graded_choice *c, const number *box, const ring *r);

#endif
