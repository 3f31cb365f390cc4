/* graded_net.h: plain nets whose values are powers of kappa = unit/k times what stays bounded as k grows, and the steps of a scheme
   applied to them (verify/certificate-valences.md, section 6, "Growing without bound").  Compiled for affine numbers of each system.

   Where nothing but the weights of the centre depends on k, and these are finite sums of powers of k, each step keeps such values. */
#ifndef LIB_GRADED_NET_H
#define LIB_GRADED_NET_H

#include "centre_weights.h"
#include "graded_choice.h"
#include "subdivision.h"

#define graded_net NUMBER_NAME(graded_net)
#define graded_net_make NUMBER_NAME(graded_net_make)
#define graded_net_free NUMBER_NAME(graded_net_free)
#define graded_scale NUMBER_NAME(graded_scale)
#define graded_subdivide NUMBER_NAME(graded_subdivide)

/* The value at i is kappa^grade[i] value[i], or 0 where the grade is GRADED_ABSENT: that of the centre at GRADED_CENTRE, of a point of the sector on the rings 1..rings
   at graded_index. */
typedef struct {
    mesh_kind mesh;
    int rings;
    int *grade;
    number *value;
} graded_net;

enum { GRADED_CENTRE = 0 };

static inline int graded_index(const graded_net *z, int a, int b) { return 1 + (a - 1) * (z->rings + 1) + b; }
static inline int graded_size(int rings) { return 1 + sector_size(rings); }

bool graded_net_make(graded_net *z, mesh_kind mesh, int rings); /* all absent; false: no memory; on either graded_net_free */
void graded_net_free(graded_net *z);

/* z *= kappa^power, power >= 0 */
void graded_scale(number *z, const number *kappa, int power, long prec);

/* new_net is made here by all steps; weights[i] are those of the centre's rule in step i, in k/unit, where it has one.  On any status graded_net_free. */
subdivide_status graded_subdivide(graded_net *new_net, const graded_net *old_net, const subdivision *s, const centre_weights *weights, const number *kappa);

#endif
