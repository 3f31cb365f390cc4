#ifndef CHECK_MASK_H
#define CHECK_MASK_H

/* Masks
 * =====
 *
 * A mask is a function on the lattice, or its symbol, the Laurent polynomial
 * sum of mask(x) z^x.  All masks here live in |a|, |b| <= 8.
 */

#include "grid.h"

enum { MASK_RADIUS = 8, MASK_SIDE = 2 * MASK_RADIUS + 1 };

/* weight[a + 8][b + 8] is the weight of (a,b). */
struct exact_mask {
    rational weight[MASK_SIDE][MASK_SIDE];
};

/* The same with one common denominator > 0: mask(a,b) is
 * coefficient[a + 8][b + 8] / denominator. */
struct mask {
    integer coefficient[MASK_SIDE][MASK_SIDE];
    integer denominator;
};

/* |(a,b)| = max(|a|, |b|, |a+b|) */
int lattice_distance(int a, int b);

void mask_from_exact(struct mask *out, const struct exact_mask *weights);

/* The first condition of lib/scheme.md on masks that does not hold, in words;
 * NULL if all hold. */
const char *mask_fault(const struct mask *mask);

/* out = a / (1 + z^-d) for d = (da, db); false if there is a remainder. */
bool mask_divide(struct mask *out, const struct mask *a, int da, int db);

void mask_double(struct mask *out, const struct mask *a);
bool mask_is_nonnegative(const struct mask *a);

/* A mask on the grid: the points with weight other than 0, their weights as
 * from_rational() gives them, and for f = a, b, a+b the least and greatest f of
 * the points. */
struct stencil_entry {
    int a, b;
    interval weight;
};

struct stencil {
    int count;
    struct stencil_entry entry[MASK_SIDE * MASK_SIDE];
    int low[3], high[3];
};

void stencil_from_mask(struct stencil *out, const struct mask *mask, int g);

/* h of certificate.md: the largest |point|. */
int stencil_radius(const struct stencil *s);

#endif
