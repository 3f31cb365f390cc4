/* other_criteria.h: what two papers say about C1 at a valence, from proved numbers, to be compared with our verdict.

   [KS] H. Kawaharada, K. Sugihara: the normals of the faces round the vertex must, in the limit, all have one sign.  If the
   simple dominant eigenvalue is in block m they are |z|^2 sin(2 pi m/k), z the eigenvector on the first ring; if it is in block
   0 or k/2 they sum to 0, whatever comes next.  So this sees neither a wrong frequency nor a fold.
   [CP] Q. Chen, H. Prautzsch, Subdivision by WAVES, Theorem 6.1: a wave scheme with 0 <= alpha, beta < 1 and 0 < alpha + beta < 1
   is C1 at valence k if lambda > |mu_0| (5.1), lambda the dominant eigenvalue of block 1, mu_0 that of block 0 besides 1
   (on the core mesh: what farther points add there is at most 1/4); at k = 3 also lambda > rho_A, rho_B, which are at most
   1/4.  If not, nothing follows. */
#ifndef VERIFY_OTHER_CRITERIA_H
#define VERIFY_OTHER_CRITERIA_H

#include "spectrum_list.h"

typedef struct {
    bool applies;  /* it is about such schemes */
    truth holds;   /* as far as was proved */
} criterion;

/* l has entries for all blocks; dominant is the index of the simple eigenvalue that is larger than all others but 1
   (and its conjugates), -1: not known. */
criterion criterion_of_signs(const scheme *s, long k, const spectrum_list *l, long dominant);
criterion criterion_of_waves(const scheme *s, long k, const spectrum_list *l);

#endif
