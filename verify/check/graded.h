#ifndef CHECK_GRADED_H
#define CHECK_GRADED_H

/* Graded values
 * =============
 *
 * certificate-valences.md, section 6, "Growing without bound".  A graded value is absent, which
 * stands for 0, or it stands for kappa^e v, kappa = q/k.
 */

#include "laurent.h"
#include "sector.h"

struct graded_value {
    bool present;
    int e;
    struct affine v;
};

/* Masks have fewer points than this. */
enum { MAX_KAPPA = 4096, MAX_TERMS = MAX_SOURCES * (2 * LAURENT_DEGREE + 1) };

/* What a computation with them depends on. */
struct grading {
    int g, degree;                                 /* d, of the eigenvalue */
    struct affine kappa[MAX_KAPPA + 1];            /* its powers */
    int powers;                                    /* those that are known */
    int terms;                                     /* of the sum at hand */
    struct graded_value term[MAX_TERMS];
};

/* For nets of the block (0, of several valences), in units of q.  False if a weight of the centre
 * has no Laurent value. */
bool grading_prepare(struct block *block, int64_t q, int degree);

struct affine kappa_power(struct grading *s, int n);

/* The arithmetic of the nets of such a block. */
extern const struct arithmetic GRADED;

#endif
