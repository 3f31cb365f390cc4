/* ring.h: where the characteristic map is examined: the ring of elements that is far enough out for the regular rules
   (lib/ring.md).  Combinatorial and exact. */
#ifndef LIB_RING_H
#define LIB_RING_H

#include "element.h"
#include "regular.h"
#include "scheme.h"

typedef struct {
    element_type type;
    int a, b;
} element;

/* The nets that are refined: values, and divided differences in the directions e1 and e2. */
enum { RING_VALUES, RING_FIRST, RING_SECOND, RING_NETS };

typedef struct {
    const laurent *mask[RING_NETS];    /* the scheme's, and 2 a_1, 2 a_2; kept by the scheme and `regular` */
    element_stencil stencil[RING_NETS];
    bool nonnegative;                  /* all three masks are: limits are convex combinations, K = 1 */
    int radius;                        /* r: the ring is r <= a + b <= 2r; on quads r <= max(a,b) <= 2r */
    int rings;                         /* the net is needed on the rings up to here */
    element *elements;                 /* what fills one sector of the ring, in the order of certificates: the UPs, then
                                          the DOWNs, by a + b, then b; or the SQUAREs, by max(a,b), then b, then falling a */
    int element_count;
    element *boundary;                 /* the segments on one sector of its outer curve: EDGEs by b; or, counter-clockwise,
                                          ALONG_SECONDs with a = 2r by b, then ALONG_FIRSTs with b = 2r by falling a */
    int boundary_count;
} ring;

void ring_init(ring *z);
void ring_clear(ring *z);
/* masks must be divisible. */
BIGFLOAT_MUST_USE bool ring_make(ring *z, const scheme *s, const regular_masks *masks);

#endif
