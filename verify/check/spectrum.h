#ifndef CHECK_SPECTRUM_H
#define CHECK_SPECTRUM_H

/* The spectrum: section 6 of certificate.md. */

#include "certificate.h"
#include "sector.h"

/* The eigenpair of block 1, proved, pivot included: X (complex form: real parts,
 * then imaginary parts), and the box of L.  s bounds 1/|L| from above. */
struct eigenpair {
    interval *unknowns;
    interval real, imaginary;                      /* of L; real form: 0 */
    interval s;
};

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

#endif
