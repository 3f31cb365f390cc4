#ifndef CHECK_GRADED_NET_H
#define CHECK_GRADED_NET_H

/* Graded nets
 * ===========
 *
 * certificate-valences.md, section 6, "Growing without bound".  A graded value is absent, which
 * stands for 0, or it stands for kappa^e v, kappa = q/k.  Nets of such values are stored like
 * those of sector.h at frequency 0, the centre at (0,0).
 */

#include "laurent.h"
#include "sector.h"

struct graded_value {
    bool present;
    int e;
    struct affine v;
};

struct graded_net {
    enum mesh mesh;
    int rings;
    struct graded_value *value;
};

enum { MAX_KAPPA = 4096, MAX_TERMS = MAX_SOURCES * (2 * LAURENT_DEGREE + 1) };

/* What a computation on such nets depends on. */
struct grading {
    const struct block *block;
    int g;
    struct affine kappa[MAX_KAPPA + 1];            /* its powers */
    int powers;                                    /* those that are known */
    struct laurent *weight[MAX_STEPS];             /* of the centre's rule, in units of q; or NULL */
    int terms;                                     /* of the sum at hand */
    struct graded_value term[MAX_TERMS];
};

/* False if a weight of the centre has no Laurent value. */
bool grading_prepare(struct grading *out, const struct block *block, int64_t q);

struct affine kappa_power(struct grading *s, int n);

/* A net with nothing in it. */
struct graded_net graded_net_make(enum mesh mesh, int rings);

/* The place of a label of the plane that is not opposite. */
struct graded_value *graded_net_at(const struct graded_net *net, int a, int b);

/* The net after one subdivision, on the rings 1..rings. */
struct graded_net graded_net_subdivide(struct grading *s, const struct graded_net *old, int rings);

#endif
