#ifndef CHECK_AFFINE_H
#define CHECK_AFFINE_H

/* Affine numbers
 * ==============
 *
 * Section 2 of certificate-valences.md.  An affine number (c, d) encloses what depends on
 * the valence k, or on t in [-1, 1]: for each k it is a number of c plus a number of d
 * times t_k.  Where there is one valence only, d = 0, and c is all there is: every
 * operation then is that of certificate.md on c, and costs as much.
 */

#include "grid.h"

struct affine {
    interval c, d;
};

/* (c, 0); the integer a. */
struct affine affine_from(interval c);
struct affine affine_from_whole(int64_t a, int g);

/* All numbers that it may stand for. */
interval affine_range(struct affine x);

struct affine affine_add(struct affine x, struct affine y);
struct affine affine_sub(struct affine x, struct affine y);
struct affine affine_minus(struct affine x);
struct affine affine_mul(struct affine x, struct affine y, int g);
struct affine affine_div(struct affine x, struct affine y, int g);  /* 0 not in y */
struct affine affine_hull(struct affine x, struct affine y);

/* sum := sum + w x */
void affine_add_multiple(struct affine *sum, interval w, const struct affine *x, int g);

bool affine_is_positive(struct affine x);          /* its range is */

/* u(first, last): cos(pi q) for all q from first to last, as a function of t. */
struct affine affine_cosine(rational first, rational last, int g);

/* Releases scratch memory down to the mark, all but what these consist of. */
void affine_keep(struct mark mark, struct affine *values, size_t count);

#endif
