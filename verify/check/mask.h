#ifndef CHECK_MASK_H
#define CHECK_MASK_H

/* Masks
 * =====
 *
 * A mask is a function on labels, or its symbol, the Laurent polynomial
 * sum of mask(x) z^x.  Labels are those of certificate.md, section 3.
 */

#include "grid.h"

enum mesh { TRIANGLE, QUAD, DUAL };

/* |(a,b)| of certificate.md, section 7. */
int lattice_distance(enum mesh mesh, int a, int b);

/* Coefficients times a common denominator > 0, in a box of labels. */
struct mask {
    int low_a, low_b, side_a, side_b;
    integer denominator;
    integer *coefficient;                          /* row by row: see mask_cell() */
};

/* The zero mask on a box. */
struct mask mask_new(int low_a, int low_b, int side_a, int side_b);

/* The coefficient at (a,b); NULL outside of the box. */
integer *mask_cell(const struct mask *mask, int a, int b);

/* The mask with these weights, in a box of the same form as `out` comes with. */
void mask_set_weights(struct mask *out, const rational *weight);

/* The first condition of lib/scheme.md on masks that does not hold, in words; NULL if all hold. */
const char *mask_fault(const struct mask *mask, enum mesh mesh);

/* Is mask(a,b) = mask(b,a) always? */
bool mask_is_mirrored(const struct mask *mask);

/* The image of a mask's label under rotation by one sector of the regular mesh. */
void label_rotate(enum mesh mesh, int *a, int *b);

/* a / (1 + z^-d) for d = (da, db); false if there is a remainder. */
bool mask_divide(struct mask *out, const struct mask *a, int da, int db);

struct mask mask_multiply(const struct mask *a, const struct mask *b);
struct mask mask_double(const struct mask *a);
bool mask_is_nonnegative(const struct mask *a);

/* The labels with a weight other than 0, in order; their weights times the denominator; and for
 * f = a, b, a+b the least and greatest f of the labels. */
struct points {
    int count;
    struct point {
        int a, b;
        integer weight;
    } *point;
    int low[3], high[3];
};

struct points mask_points(const struct mask *mask);

/* A mask on the grid: its points ordered by class modulo the dilation, their weights as
 * from_rational() gives them. */
struct stencil_entry {
    int a, b;
    interval weight;
    rational exact;                                /* not in lowest terms */
};

struct stencil {
    int dilation;                                  /* 1 or 2 */
    int first[5];                                  /* of the classes */
    struct stencil_entry *entry;
    int low[3], high[3];
};

struct stencil stencil_make(const struct mask *mask, int dilation, int g);

/* The class of a label: those of x and of mask labels x - dilation y agree. */
int stencil_class(const struct stencil *s, int a, int b);

#endif
