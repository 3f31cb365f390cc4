/* cover.h: all eigenvalues of all blocks of a range of frequencies are smaller than a number.  Compiled once per number
   system.

   A *box* is a range of frequencies whose blocks are enclosed together (block_make_range); what spectral_contraction
   proves of that one interval matrix holds for each of them.  Where the eigenvalue that gives the number is L(w_1) and
   L falls like w^2 near w = 0, the gap between L(w_1) and the blocks of a box that begins at m grows like m^2, and so
   does the width of a box from m to 2 m: boxes grow geometrically, and their number like log k. */
#ifndef LIB_COVER_H
#define LIB_COVER_H

#include "block.h"
#include "cover_list.h"

#define cover_search NUMBER_NAME(cover_search)
#define cover_verify NUMBER_NAME(cover_verify)

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool proved;         /* for the whole range */
    frequencies open;    /* if not: from the first to the last frequency that was left open */
    bool diverges;       /* a hint: a single block has certainly no eigenvalues that small */
    double radius;       /* all eigenvalues of the boxes that are proved are at most radius/scale in modulus, radius <= 1 */
    long largest;        /* the first frequency of the box for which radius was needed */
    long tries;          /* of boxes */
    bool exhausted;      /* all that the limits allow: more tries might prove more */
    bool stopped;        /* lib/stop.h: what is behind the last box is unknown, and nothing is proved */
} cover_answer;

/* How long cover_search looks. */
typedef struct {
    long tries; /* of boxes */
    long open;  /* it goes on behind a frequency that fails, this often; 0: it stops there */
    int power;
    bool sharpen; /* some more work for a smaller radius */
} cover_limits;

/* Finds a list of boxes for 1 <= first <= m <= last <= k/2 such that cover_verify proves that all eigenvalues of their
   blocks are smaller than 1/scale in modulus, scale thin and positive.  What it leaves open is in the list, too (COVER_OPEN);
   only if it has stopped at a failure the list ends there.  The list is the caller's and empty before. */
cover_answer cover_search(cover_list *list, scheme_numbers *numbers, const number *scale, frequencies m, const cover_limits *limits, diagnostic *d);

/* Proves it with the boxes and powers given, which must partition the range and leave nothing open. */
cover_answer cover_verify(const cover_list *list, scheme_numbers *numbers, const number *scale, frequencies m, diagnostic *d);

#endif
