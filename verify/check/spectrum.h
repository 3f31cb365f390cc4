#ifndef CHECK_SPECTRUM_H
#define CHECK_SPECTRUM_H

/* The spectrum: section 6 of certificate.md. */

#include "certificate.h"
#include "sector.h"

/* The eigenpair of block 1, proved, pivot included: X (complex form: real parts,
 * then imaginary parts), and the box of L.  s bounds 1/|L| from above.  (All affine for
 * the sake of several valences; of one, d = 0.) */
struct eigenpair {
    struct affine *unknowns;
    struct affine real, imaginary;                 /* of L; real form: 0 */
    interval s;
};

/* What the Krawczyk step works on; unknowns are counted from 0.  In the complex form
 * a vector has its real parts, then its imaginary parts. */
struct krawczyk {
    int g, n, size, pivot;
    bool real;
    const interval *m;                             /* size x size */
    interval *mid, *box;                           /* x~ and X, fixed ones too */
    interval l_mid[2], l_box[2];                   /* L~ and X_L: alpha, beta */
    interval *f, *slope, *inverse;                 /* f; G and Y, size x size */
};

/* Proves that exactly one eigenpair of the matrix is in the box round the choices, of their
 * radius or (of a range of valences) of their range, and that it is simple; else rejects. */
struct krawczyk spectrum_prove_inclusion(const interval *matrix, int g,
                                         const struct choices *choices, bool range,
                                         const struct certificate *certificate);

/* sum + x y */
interval spectrum_add_product(interval sum, interval x, interval y, int g);

/* The thin ceil(1 / a), a > 0 in units of 2^-g. */
interval spectrum_inverse_upper(integer a, int g);

/* Proves the size of a real L that the certificate's reason needs (c1: 0 < L < 1); returns
 * s; else rejects. */
interval spectrum_prove_size(interval l, int g, const struct certificate *certificate);

/* Block 0 without the constant net, the plain form of section 10: of order n - 1. */
struct affine *spectrum_without_constants(const struct affine *b, int n);

/* From the eigenvector of differences of the block with the matrix b to the net's unknowns;
 * rejects a complex L that is too near to 1. */
void spectrum_add_constants(struct eigenpair *pair, const struct affine *b, int n, bool complex,
                            const struct certificate *certificate);

/* Twice the real block a, of order n: the complex form of block 0. */
interval *spectrum_doubled(const interval *a, int n);

/* Proves the eigenpair of the block with this matrix, and 0 < |L| < 1 (reason not-c0:
 * |L| > 1); else rejects. */
struct eigenpair spectrum_prove_eigenpair(const interval *matrix, int g,
                                          const struct certificate *certificate);

/* Proves that all other eigenvalues of the block are smaller than L in modulus
 * (for m = 0: all but 1); else rejects. */
void spectrum_prove_rest(const interval *matrix, int size, int g,
                         const struct eigenpair *pair,
                         const struct block_record *record,
                         const struct certificate *certificate);

/* Proves that all eigenvalues of a matrix (which is overwritten) are smaller than 1/s in
 * modulus, by the power of the record; else rejects.  name: of the record. */
void spectrum_prove_small(interval *matrix, int size, int g, interval s,
                          const struct block_record *record, const char *name,
                          const char *file);

#endif
