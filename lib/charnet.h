/* charnet.h: the control net of the characteristic map, as far out as the ring needs it, and its thin nets of
   differences (verify/certificate.md, section 7; lib/ring.md).  Compiled once per number system. */
#ifndef LIB_CHARNET_H
#define LIB_CHARNET_H

#include "block.h"
#include "ring.h"

#define charnet_make NUMBER_NAME(charnet_make)
#define charnet_divide NUMBER_NAME(charnet_divide)
#define charnet_windows_make NUMBER_NAME(charnet_windows_make)
#define charnet_windows_free NUMBER_NAME(charnet_windows_free)

/* net = the eigenvector `box` of the block b extended to `rings` rings (those of b at least) by the scheme itself:
   V = S V / eigenvalue.  In real form and for m = 0 box holds the n components x, then the eigenvalue; in complex form, and for
   m = 0 if the eigenvalue is complex, n real parts, n imaginary parts, then those of the eigenvalue (lib/eigenpair.h): is_complex.
   The numbers must be set to b's frequency.  net->twist is b's.  On any status sector_net_free. */
block_status charnet_make(sector_net *net, const block *b, const number *box, bool is_complex, const scheme_numbers *numbers, int rings);

/* x + i y = (x + i y) / (re + i im) as certificates have it; im NULL: 0. */
void charnet_divide(number *x, number *y, const number *re, const number *im, long prec);

/* The thin values of one net (values or differences) in the windows of some elements, and how far they may be from
   the true ones: |true - thin| <= radius, by component. */
typedef struct {
    int count;         /* elements */
    int window[ELEMENT_TYPES]; /* points in the window of each type */
    int stride;        /* most points in a window */
    number *x, *y;     /* of element i from i * stride */
    number radius[2];
} charnet_windows;

/* which is RING_VALUES, RING_FIRST or RING_SECOND. */
block_status charnet_windows_make(charnet_windows *z, const sector_net *net, const ring *r, int which, const element *elements, int count, long prec);
void charnet_windows_free(charnet_windows *z);

#endif
