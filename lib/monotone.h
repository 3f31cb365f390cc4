/* monotone.h: an eigenvalue that falls from frequency to frequency.  Compiled once per number system.

   Near w = 0 the largest eigenvalues of neighbouring blocks agree to more digits than any enclosure has, for their
   difference is of the order m / k^2.  That they are in order follows from the sign of a derivative.

   A *chain* is a list of ranges of frequencies a_0..a_1, a_1..a_2, ..., each of which shares an end with the next.  For
   one range let U be the interval of u = cos(pi m / k) between its ends.  In the real form the blocks are B(u), a
   function of u in U whose weights do not depend on m there; what is proved for all u in U, for B(U) and B'(U) as
   interval matrices:
    1. B(u) has one pair (x, L) in a box, L simple and positive (eigenpair_prove);
    2. dL/du has one strict sign (eigenpair_slope; forward chains need it positive, backward ones negative);
    3. all other eigenvalues of B(u) are smaller in modulus than the least number of L's interval: deflated by the box of
       x, B(u) contracts after division by it (matrix_deflate, spectral_contraction).

   So for every m of the range the spectral radius of block m is L(u_m), attained by a simple, positive, real eigenvalue,
   and strictly monotone in m, because u_m falls with m.  At a common end of two ranges the block is one and the same, and
   both say of it that their L is its spectral radius: the L's agree.  Weights that are constant on both ranges are
   constant on their union for the same reason.  Hence along a forward chain from a_0 to a_n

       rho(B(w_m)) = L_m,   L_(a_0) > L_(a_0 + 1) > ... > L_(a_n),

   and along a backward chain, whose m fall, likewise: L falls away from a_0. */
#ifndef LIB_MONOTONE_H
#define LIB_MONOTONE_H

#include "block.h"
#include "monotone_list.h"

#define monotone_search NUMBER_NAME(monotone_search)
#define monotone_direction NUMBER_NAME(monotone_direction)
#define monotone_verify NUMBER_NAME(monotone_verify)

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool proved;         /* of a search: the chain has at least one range */
    long end;            /* how far the chain goes: a_n */
    double last_approx;  /* about L_(a_n), in a search */
    long tries;          /* of ranges */
} monotone_answer;

/* Finds a chain from `start`, to larger frequencies (forward) or smaller ones, which ends at `goal` at the latest; mirror-
   symmetric schemes only, 1 <= start, goal <= k/2.  It ends earlier when it has `most` ranges, when about L_(a_n) < enough,
   or where two neighbours cannot be proved to be in order.  The list is empty before and the caller's. */
monotone_answer monotone_search(monotone_list *list, const scheme_numbers *numbers, long start, long goal, size_t most, double enough, diagnostic *d);

/* Encloses an eigenvalue L of block m that is real, simple and about the largest, and proves on which side of m it is
   larger: *sign = 1, dL/du > 0: for smaller frequencies; -1: for larger ones; 0: not proved, and nothing is enclosed. */
block_status monotone_direction(number *eigenvalue, int *sign, const scheme_numbers *numbers, long m, diagnostic *d);

/* Proves that the list is such a chain. */
monotone_answer monotone_verify(const monotone_list *list, const scheme_numbers *numbers, long start, bool forward, diagnostic *d);

#endif
