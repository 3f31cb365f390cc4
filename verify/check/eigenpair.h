#ifndef CHECK_EIGENPAIR_H
#define CHECK_EIGENPAIR_H

/* Eigenpairs: section 6 of certificate.md, section 3 of certificate-valences.md. */

#include "certificate.h"
#include "sector.h"

/* An eigenpair of a block, proved, pivot included: X (complex form: real parts, then imaginary
 * parts), and the box of L.  (All affine for the sake of several valences; of one, d = 0.) */
struct eigenpair {
    const struct affine *matrix;                   /* M */
    const struct choices *choices;
    struct affine *unknowns;
    struct affine real, imaginary;                 /* of L; real form: 0 */
    interval s;                                    /* 0, or at least 1/|L| */
};

/* The eigenpair of the matrix, of the certificate's form and size, that the choices prove to be
 * simple, with s = 0; else rejects. */
struct eigenpair eigenpair_prove(const struct affine *matrix, const struct choices *choices,
                                 const struct certificate *certificate);

/* sum + x y */
interval spectrum_add_product(interval sum, interval x, interval y, int g);

/* sum of x_j y_(j stride) over j < size */
interval spectrum_dot(const interval *x, const interval *y, int stride, int size, int g);

#endif
