/* rise.h: an eigenvalue that rises with u = cos(pi m / k), along arcs (verify/certificate-valences.md, section 4, "Rise").
   Compiled once per number system.

   Where no weight of a rule depends on k or m, but the centre's, the blocks are one function B(u).  For one arc of angles, as an affine
   matrix, it is proved that
    1. B(u) has one pair (x, l) in a box, l simple and positive (eigenpair_affine_prove);
    2. l's slope is positive: l rises with u;
    3. all other eigenvalues are smaller in modulus: deflated by the box of x, B(u) contracts after division by the least
       number of l's range.
   Arcs that share their ends make a chain; along it the spectral radius of B(u) is l(u), attained by a simple eigenvalue, and
   strictly increasing in u. */
#ifndef LIB_RISE_H
#define LIB_RISE_H

#include "block_affine.h"
#include "cover.h"
#include "range_choices.h"

#define rise_search NUMBER_NAME(rise_search)
#define rise_verify NUMBER_NAME(rise_verify)

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool constant;       /* the weights are those of one function of u; else nothing is proved */
    bool proved;         /* of a search: the chain ends at the goal or beyond */
    int64_t end;         /* how far the chain goes, in the units of arc.h: from 1/k.last if it has no box */
    long tries;
    bool stopped;        /* lib/stop.h */
} rise_answer;

/* Makes a chain longer, which begins at 1/k.last (rounded down), until it ends at `goal` or beyond, or where it cannot go on;
   mirror-symmetric schemes only.  New choices are on the grid 2^-g.  Of the limits tries and power count; list->count is
   at most `most`. */
rise_answer rise_search(rise_list *list, const scheme *s, valence_range k, int64_t goal, size_t most, const cover_limits *limits, long g, long prec, diagnostic *d);

/* Proves that the list is such a chain. */
rise_answer rise_verify(const rise_list *list, const scheme *s, valence_range k, long prec, diagnostic *d);

#endif
