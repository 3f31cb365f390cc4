/* block.h: the blocks B(w) of the subdivision matrix, by applying the scheme to sector nets (verify/certificate.md,
   section 5).  Compiled once per number system. */
#ifndef LIB_BLOCK_H
#define LIB_BLOCK_H

#include "subdivision.h"

#define block_make NUMBER_NAME(block_make)
#define block_make_range NUMBER_NAME(block_make_range)
#define block_make_at NUMBER_NAME(block_make_at)
#define block_real_matrix NUMBER_NAME(block_real_matrix)
#define block_free NUMBER_NAME(block_free)
#define block_from_subdivide NUMBER_NAME(block_from_subdivide)
#define block_net NUMBER_NAME(block_net)

/* What an unknown of a block says of the value at its point.  Plain nets: the value.  Real form: on a spoke y = 0; on
   the bisector the value is r (u, 1); any other point shares x and y (two unknowns, x first) with its mirror image.
   Complex form: the complex value. */
typedef enum { UNKNOWN_CENTRE, UNKNOWN_PLAIN, UNKNOWN_SPOKE, UNKNOWN_BISECTOR, UNKNOWN_X, UNKNOWN_Y, UNKNOWN_COMPLEX } unknown_kind;

typedef struct {
    unknown_kind kind;
    int a, b;
} unknown;

/* The block of rotation factor exp(2 pi i m / k) on the rings 1..rings: an n x n matrix, row by row; entry[i n + j] is
   what unknown j contributes to the new unknown i.  In the complex form imaginary has the imaginary parts.  For a range
   of frequencies the entries contain those of all blocks from m to last, and so for a range of valences. */
typedef struct {
    long m, last;
    valence_range k;
    mesh_kind mesh;
    int rings;
    int n;
    unknown *unknowns;
    number *entry;
    number *imaginary; /* NULL unless in complex form */
    twist twist;
} block;

/* 0 <= m <= k/2, for one valence; for several, m = 0.  Sets the frequency of `numbers`.  In the real form (only for mirror-symmetric schemes) if `real`.
   On any status block_free. */
typedef enum { BLOCK_OK, BLOCK_OPPOSITE, BLOCK_NO_CENTRE_RULE, BLOCK_BAD_INPUT, BLOCK_STOPPED /* lib/stop.h */, BLOCK_NO_MEMORY } block_status;
block_status block_make(block *z, scheme_numbers *numbers, long m, bool real, diagnostic *d);
/* All blocks of a range; 0 is in no range but its own. */
block_status block_make_range(block *z, scheme_numbers *numbers, frequencies m, bool real, diagnostic *d);
/* In the real form, for all u of an interval within [0, 1], whether u = cos(pi m / k) for some m or not; the weights of
   rules are those of the frequencies m >= 1 and of the valences of `numbers`. */
block_status block_make_at(block *z, scheme_numbers *numbers, frequencies m, const number *u, diagnostic *d);
/* A new real matrix with the eigenvalues of the block and, in the complex form, their conjugates: size x size numbers,
   size = n or 2 n.  The caller frees it.  NULL: no memory. */
number *block_real_matrix(int *size, const block *z);
void block_free(block *z);
/* Is the k-regular complex the regular one?  (Of several valences that is not said.) */
static inline bool block_is_planar(const block *z) { return is_one_valence(z->k) && z->k.first == mesh_regular_valence(z->mesh); }
block_status block_from_subdivide(subdivide_status s);

/* Writes the net with the given unknowns into the rings of `net` that the block has; net->twist must be the block's
   (NULL for m = 0).  imaginary is NULL unless in complex form, or for m = 0 if values are complex. */
void block_net(sector_net *net, const block *z, const number *values, const number *imaginary, long prec);

#endif
