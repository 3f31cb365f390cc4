#ifndef CHECK_CHARACTERISTIC_H
#define CHECK_CHARACTERISTIC_H

/* The characteristic net: section 7 of certificate.md. */

#include "spectrum.h"
#include "window.h"

/* One of the three refinable functions that are decided on: the differences
 * d1, d2 (refined by q1 = 2 a_1, q2 = 2 a_2) and the values (by q0). */
struct refinable {
    struct stencil mask;
    struct window window[ELEMENT_KINDS];           /* those that occur */
    int shift_a, shift_b;                          /* (1,0), (0,1); (0,0): values */
    integer rho_x, rho_y;
};

struct characteristic {
    const struct block *block;                     /* m = 1 */
    struct refinable first, second, value;         /* d1, d2, values */
    int radius;                                    /* r */
    struct net net;                                /* V on rings up to 2r + omega */
};

/* Windows, ring and net.  The masks must be non-negative. */
void characteristic_prepare(struct characteristic *out, const struct block *block,
                            const struct eigenpair *pair, const struct mask *q1,
                            const struct mask *q2);

/* d1(y), d2(y) or V(y) at a point y of the plane, level 0. */
void characteristic_at(struct pair *out, const struct characteristic *c,
                       const struct refinable *f, int a, int b);

/* The elements of the ring, in the order of section 8: each kind by a + b, then
 * by b.  They are the (a,b), a, b >= 0, with first <= a + b <= last. */
void characteristic_range(int *first, int *last, const struct characteristic *c,
                          enum element_kind kind);

void characteristic_clear(struct characteristic *c);

#endif
