#ifndef CHECK_SPECTRUM_H
#define CHECK_SPECTRUM_H

/* The spectrum: section 6 of certificate.md. */

#include "certificate.h"
#include "sector.h"

/* The eigenpair of block 1, proved: its unknowns, pivot included, and L. */
struct eigenpair {
    interval *unknowns;                            /* X, n of them, allocated */
    interval eigenvalue;                           /* X_L */
};

/* Proves the eigenpair of the block B(w_1), and 0 < L < 1; else rejects. */
void spectrum_prove_eigenpair(struct eigenpair *out, const struct block *block,
                              const interval *matrix,
                              const struct certificate *certificate);

/* Proves that all other eigenvalues of block m are smaller than L in modulus
 * (for m = 0: all but 1); else rejects. */
void spectrum_prove_rest(const struct block *block, const interval *matrix,
                         const struct eigenpair *pair,
                         const struct certificate *certificate);

#endif
