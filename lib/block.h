/* block.h: the blocks B(w) of the subdivision matrix, by applying the scheme to sector nets (verify/certificate.md,
   section 5).  Compiled once per number system. */
#ifndef LIB_BLOCK_H
#define LIB_BLOCK_H

#include "scheme.h"
#include "sector.h"

#define block_make NUMBER_NAME(block_make)
#define block_free NUMBER_NAME(block_free)
#define block_net NUMBER_NAME(block_net)

/* What an unknown of a block says of the value at its point: in the real form a point on the spoke has y = 0, one
   on the bisector is r (u, 1), and any other shares x and y (two unknowns, x first) with its mirror image. */
typedef enum { UNKNOWN_CENTRE, UNKNOWN_PLAIN, UNKNOWN_SPOKE, UNKNOWN_BISECTOR, UNKNOWN_X, UNKNOWN_Y } unknown_kind;

typedef struct {
    unknown_kind kind;
    int a, b;
} unknown;

/* The block of rotation factor exp(2 pi i m / k) on the rings 1..rings: a real n x n matrix, row by row. */
typedef struct {
    long m, k;
    int rings;
    int n;
    unknown *unknowns;
    number *entry; /* entry[i * n + j]: what unknown j contributes to the new unknown i */
    twist twist;
} block;

/* How many rings are closed under subdivision and carry all eigenvalues that are not 0. */
static inline int block_rings(const scheme *s) { return s->reach > 1 ? s->reach : 1; }

/* 0 <= m <= k/2; for m = 0 unknown 0 is the centre, and the weights of its rule are those given (else unused).
   On any status block_free. */
typedef enum { BLOCK_OK, BLOCK_OPPOSITE, BLOCK_NO_MEMORY } block_status;
block_status block_make(block *z, const scheme *s, const mask_numbers *mask, const number *centre, const number *ring, long m, long k, long prec);
void block_free(block *z);

/* Writes the net with the given unknowns (n values) into the rings of `net` that the block has; net->twist must be
   the block's. */
void block_net(sector_net *net, const block *z, const number *values, long prec);

#endif
