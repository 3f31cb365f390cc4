#ifndef CHECK_VALENCES_H
#define CHECK_VALENCES_H

/* The spectrum at several valences: sections 4 and 6 of certificate-valences.md.
 *
 * Frequency m of valence k is at q = m/k, in units of 2^-48, and its block at
 * u = cos(pi q). */

#include "spectrum.h"

/* Block m, over all valences of v (m < 0: any other one but 0). */
void valences_prepare_block(struct block *out, const struct valence *v, int64_t m);

/* Proves that all eigenvalues but 1 and that of the pair, of the certificate's frequency, are smaller
 * than it in modulus; else rejects. */
void valences_prove_rest(const struct valence *v, const struct eigenpair *pair,
                         const struct certificate *certificate);

/* The parts of it
 * --------------- */

/* m/k in units of 2^-48, at most 2^47, rounded down or up. */
int64_t valences_place(int64_t m, int64_t k, bool up);

/* The block of the frequencies m over u(q, q'); line: of the certificate. */
void valences_block_between(struct block *out, const struct valence *v, struct span m,
                            int64_t q, int64_t q_last, int line);

/* What is left of block 0 beside 1 passes with s. */
void valences_prove_block_0(const struct valence *v, interval s,
                            const struct certificate *certificate);

/* All blocks of `cover`, from q on, pass with s. */
void valences_prove_cover(const struct valence *v, const struct cover *cover, int64_t q,
                          interval s, const struct certificate *certificate);

#endif
