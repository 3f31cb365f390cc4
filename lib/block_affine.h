/* block_affine.h: the blocks of many valences as one affine matrix (verify/certificate-valences.md, section 3).  Compiled
   once per number system (bigfloat/number.h), by way of affine numbers. */
#ifndef LIB_BLOCK_AFFINE_H
#define LIB_BLOCK_AFFINE_H

#include "../bigfloat/number.h"
#include "../bigfloat/affine.h"
#include "arc.h"
#include "block.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#else

#define block_make_over NUMBER_NAME(block_make_over)
#define block_without_constants NUMBER_NAME(block_without_constants)
#define affine_cosine NUMBER_NAME(affine_cosine)

/* u = cos(pi r) = c + d t for every r of the arc and some t: the middle and the radius of the hull of both ends, thin both.
   It falls with r.  false: no memory. */
bool affine_cosine(affine *u, const arc *r, long prec);

/* The block in the real form, for u over the arc and all valences of `numbers`; only for mirror-symmetric schemes, m.first >= 1.
   Sets the frequency of `numbers`.  On any status block_free. */
block_status block_make_over(block *z, scheme_numbers *numbers, frequencies m, const arc *r, diagnostic *d);

/* A new matrix of order b->n - 1: what is left of block 0 beside the eigenvalue 1 of the constant net, the first unknown being
   removed.  NULL: no memory. */
affine *block_without_constants(const block *b, long prec);

#endif

/* n x n, row by row. */
typedef struct {
    int n;
    affine *entry;
} BASE_NAME(affine_matrix);

/* The same as block_make_over, for others than affine sources.  On any status affine_matrix_free. */
block_status BASE_NAME(affine_matrix_make)(BASE_NAME(affine_matrix) *z, const scheme *s, valence_range k, frequencies m, const arc *r, long prec, diagnostic *d);

/* Block 0 without the constant net, of order one less than it, as a function of 1/k for k >= k.first and 1/k = 0: t = -1 there, t = 1 at
   k.first.  The scheme's centre must come to rest (lib/resting_centre.h).  It is sloped (bigfloat/affine.h).  On any status
   affine_matrix_free. */
block_status BASE_NAME(affine_matrix_make_resting)(BASE_NAME(affine_matrix) *z, const scheme *s, valence_range k, long prec, diagnostic *d);
void BASE_NAME(affine_matrix_free)(BASE_NAME(affine_matrix) *z);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define affine_matrix NUMBER_NAME(affine_matrix)
#define affine_matrix_make NUMBER_NAME(affine_matrix_make)
#define affine_matrix_make_resting NUMBER_NAME(affine_matrix_make_resting)
#define affine_matrix_free NUMBER_NAME(affine_matrix_free)
#endif

#endif
