/* regular.h: the regular part, exactly: difference masks and their norms (verify/certificate.md, section 4).

   Directions are numbered 0, 1, 2 for e1 = (1,0), e2 = (0,1), e3 = (1,-1).  a_d is the mask a divided by 1 + z^-d: it
   refines the differences p(x + d) - p(x); a_dd' is a_d divided by 1 + z^-d'.  The second differences that matter are
     on triangles  a_12, a_13, a_23
     on quads      a_11, a_12, a_22   (primal and dual)
   in this order. */
#ifndef LIB_REGULAR_H
#define LIB_REGULAR_H

#include "laurent.h"
#include "mesh.h"

extern const lattice regular_direction[3];

typedef struct {
    mesh_kind mesh;
    laurent derivative[2]; /* 2 a_d for e1, e2: refines the divided differences in direction d */
    laurent second[3];     /* 2 a_dd' for the three pairs */
    bool divisible;        /* false: a division left a remainder, and the criterion is silent */
    bool symmetric;        /* the mask is invariant under reflection: second[2] has the norms of second[1] on
                              triangles, of second[0] on quads */
} regular_masks;

void regular_init(regular_masks *z);
void regular_clear(regular_masks *z);
BIGFLOAT_MUST_USE bool regular_derive(regular_masks *z, const laurent *mask, mesh_kind mesh);

/* The two directions in which differences of the derivative 0 or 1 contract, and which of `second` refines them. */
typedef struct {
    int direction[2], second[2];
} regular_pair;
regular_pair regular_get_pair(mesh_kind mesh, int derivative);
/* Pair i = 0, 1, 2 as directions. */
regular_pair regular_get_directions(mesh_kind mesh, int i);

/* ---- norms ---- */

/* The largest power that is ever tried: 2^9 classes in each direction. */
#define REGULAR_MAX_POWER 9
/* Norms are taken in machine words (lib/power.h, which has limits of its own); where those are too short, up to this
   power, and as long as a product takes no more multiplications than this. */
#define REGULAR_MAX_LONG_POWER 6
#define REGULAR_MAX_WORK 3e7

/* norm[N] = |S^N|, 0 <= N <= count. */
typedef struct {
    int count;
    rational norm[REGULAR_MAX_POWER + 1];
} norm_list;

void norm_list_init(norm_list *z);
void norm_list_clear(norm_list *z);
/* The norms for the mask s up to N = most, or less where the limits do not allow more; if `contracting`, only up to the
   first that is smaller than 1. */
BIGFLOAT_MUST_USE bool norm_list_make(norm_list *z, const laurent *s, int most, bool contracting);
/* The first N with norm[N] < 1; 0: there is none. */
int norm_list_first_contraction(const norm_list *z);

/* norm = |S^N| for one N within the limits; false also where it is not. */
BIGFLOAT_MUST_USE bool regular_norm(rational *norm, const laurent *s, int power);

/* norm[q] bounds how differences grow in q steps, D(S^q p) <= norm[q] D(p): of values (derivative = -1) those along e1 and
   e2, the larger of |S_(a_1)^q| and |S_(a_2)^q|; of a derivative those along its regular_pair. */
BIGFLOAT_MUST_USE bool regular_contraction_list(norm_list *z, const regular_masks *masks, int derivative);

/* For each pair the least N with |S^N| < 1 and that norm; power[i] = 0 when there is none up to the limits.  All three
   non-zero prove that the scheme is C1 on the regular complex. */
BIGFLOAT_MUST_USE bool regular_contraction(int power[3], rational norm[3], const regular_masks *masks);

#endif
