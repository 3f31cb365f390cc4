#ifndef CHECK_CHARACTERISTIC_H
#define CHECK_CHARACTERISTIC_H

/* The characteristic net: section 7 of certificate.md (of several valences in affine
 * numbers: certificate-valences.md, section 5). */

#include "element.h"
#include "spectrum.h"
#include "spline.h"

/* One of the three refinable functions that are decided on: the differences
 * d1, d2 (refined by q_1 = 2 a_1, q_2 = 2 a_2) and the values (by q_0). */
struct refinable {
    struct stencil mask;
    struct window window[ELEMENT_KINDS];           /* those that occur */
    int shift_a, shift_b;                          /* (1,0), (0,1); (0,0): values */
    int64_t stability;                             /* T: K <= T/1024 */
    struct pair rho;                               /* [-rho, rho]: of x, y; of c, d each */
    bool has_basis;                                /* the mask is of a box spline */
    struct basis basis[ELEMENT_KINDS];             /* those that occur */
};

struct characteristic {
    const struct block *block;                     /* m = 1 */
    enum mesh mesh;
    bool version_0;                                /* how boxes are widened */
    struct refinable f[3];                         /* values, d1, d2 */
    int radius;                                    /* r */
    int elements, segments;                        /* of regularity, of the boundary */
    struct element *element, *segment;
    int rings;                                     /* 2r + omega: */
    struct net net;                                /* V on that many */
};

/* Windows and ring, for q_0, q_1, q_2. */
void characteristic_begin(struct characteristic *out, const struct block *block,
                          const struct mask q[3], const struct certificate *certificate);

/* What follows from the net. */
void characteristic_use(struct characteristic *c, const struct net *net);

/* All that, with the net of the pair. */
void characteristic_prepare(struct characteristic *out, const struct block *block,
                            const struct eigenpair *pair, const struct mask q[3],
                            const struct certificate *certificate);

/* d1(y), d2(y) or V(y) at a label y of the plane, level 0. */
struct pair characteristic_at(const struct characteristic *c, const struct refinable *f,
                              int a, int b);

/* The decisions (sections 8 and 10)
 * --------------------------------- */

/* Proves by the trees or witnesses of the certificate what its claim, or its reason, needs of
 * the function; else rejects. */
void decide_claim(const struct characteristic *c, const struct certificate *certificate);

/* The witness of `real`: a place where the derivatives of two functions, each a part of c's or of
 * d's, are not parallel. */
void decide_independent(const struct characteristic *c, const struct characteristic *d,
                        const struct certificate *certificate);

#endif
