#ifndef CHECK_VALENCES_H
#define CHECK_VALENCES_H

/* The spectrum at several valences: sections 4 and 6 of certificate-valences.md.
 *
 * Frequency m of valence k is at q = m/k, in units of 2^-48, and its block at
 * u = cos(pi q). */

#include "spectrum.h"

/* Block m, over all valences of v (m < 0: any other one but 0). */
void valences_prepare_block(struct block *out, const struct valence *v, int64_t m);

/* Proves the eigenpair of the block with a size that its reason needs (c1: 0 < L < 1), and
 * that all other eigenvalues but 1 are smaller than L in modulus; else rejects. */
struct eigenpair valences_prove_spectrum(const struct block *block,
                                         const struct certificate *certificate);

/* The parts of it
 * --------------- */

/* m/k in units of 2^-48, at most 2^47, rounded down or up. */
int64_t valences_place(int64_t m, int64_t k, bool up);

/* The block of the frequencies m over u(q, q'); line: of the certificate. */
void valences_block_between(struct block *out, const struct valence *v, struct span m,
                            int64_t q, int64_t q_last, int line);

/* What is left of a matrix beside its eigenpair, and of block 0 beside 1, passes. */
void valences_prove_deflated(const struct affine *matrix, const struct eigenpair *pair,
                             int pivot, const struct block_record *record, const char *name,
                             const struct certificate *certificate);
void valences_prove_block_0(const struct valence *v, const struct eigenpair *pair,
                            const struct certificate *certificate);

/* All blocks of `cover`, from q on, pass with the s of the pair. */
void valences_prove_cover(const struct valence *v, const struct cover *cover, int64_t q,
                          interval s, const struct certificate *certificate);

#endif
