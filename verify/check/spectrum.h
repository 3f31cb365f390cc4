#ifndef CHECK_SPECTRUM_H
#define CHECK_SPECTRUM_H

/* The spectrum: section 6 of certificate.md. */

#include "eigenpair.h"

/* The thin ceil(1 / a), a > 0 in units of 2^-g. */
interval spectrum_inverse_upper(integer a, int g);

/* Proves the size of L that the certificate's reason needs (c1: 0 < L < 1), and sets s; else
 * rejects. */
void spectrum_prove_size(struct eigenpair *pair, const struct certificate *certificate);

/* Block 0 without the constant net, the plain form of section 10: of order n - 1. */
struct affine *spectrum_without_constants(const struct affine *b, int n);

/* From the eigenvector of differences of the block with the matrix b to the net's unknowns;
 * rejects a complex L that is too near to 1. */
void spectrum_add_constants(struct eigenpair *pair, const struct affine *b, int n, bool complex,
                            const struct certificate *certificate);

/* Twice the real block a, of order n: the complex form of block 0. */
struct affine *spectrum_doubled(const struct affine *a, int n);

/* Proves that all eigenvalues of a matrix (which is overwritten) are smaller than 1/s in
 * modulus, by the power of the record; else rejects.  name: of the record. */
void spectrum_prove_small(interval *matrix, int size, int g, interval s,
                          const struct block_record *record, const char *name,
                          const char *file);

/* The same for a block, in block 0 all eigenvalues but the 1 of constant nets. */
void spectrum_prove_block(const struct block *block, interval s, const struct block_record *record,
                          const char *name, const struct certificate *certificate);

/* The same for all eigenvalues of the pair's matrix but L (and conj L, of a real block in the complex
 * form), with the pair's s; the certificate is about that pair. */
void spectrum_prove_rest(const struct eigenpair *pair, const struct block_record *record,
                         const char *name, const struct certificate *certificate);

#endif
