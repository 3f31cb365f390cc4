#ifndef CHECK_VALENCES_H
#define CHECK_VALENCES_H

/* The spectrum at several valences: sections 4 and 6 of certificate-valences.md.
 *
 * Frequency m of valence k is at q = m/k, in units of 2^-48, and its block at u = cos(pi q). */

#include "spectrum.h"

/* Block m, over all valences of v. */
void valences_prepare_block(struct block *out, const struct valence *v, int64_t m);

/* Proves that all eigenvalues but 1 and that of the pair, of the certificate's frequency, are
 * smaller than it in modulus; else rejects. */
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

/* Proves that all eigenvalues of block 0 but 1 are smaller than L, that of the pair, at each
 * valence (section 4, "Limit": it tends to block 1); else rejects. */
void limit_prove(const struct valence *v, const struct eigenpair *pair,
                 const struct certificate *certificate);

/* Refutations (section 6)
 * ----------------------- */

/* Proves that at each valence of v some frequency of the window dominates, and that those that may
 * do not wind once; returns what contains the largest modulus; else rejects.  q: q_0, q_1, q_2. */
interval window_prove(const struct valence *v, const struct mask q[3],
                      const struct certificate *certificate);

/* Block 0 where an eigenvalue of it grows with k, but for the rules of the centre, whose weights
 * need no values on the grid; rejects schemes that are not made for it. */
void graded_prepare_block(struct block *out, const struct valence *v);

/* Proves |l| > 1 and that its function is not 0, at each valence; returns what contains
 * |l| (q/k)^d; else rejects.  q: q_0, q_1, q_2. */
interval graded_prove(const struct block *block, const struct mask q[3],
                      const struct certificate *certificate);

#endif
