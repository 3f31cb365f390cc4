/* gap.h: how near the largest eigenvalues of two blocks certainly are to each other in modulus. */
#ifndef VERIFY_GAP_H
#define VERIFY_GAP_H

#include "../lib/scheme.h"

/* TRUTH_TRUE: the moduli of the dominant eigenvalues of the blocks m[0] and m[1] (other than 1) differ by at most 2^-bits.
   TRUTH_UNKNOWN: one of them could not be enclosed.  TRUTH_FALSE: no memory. */
truth gap_between_ball(long *bits, const scheme *s, long k, const long m[2], long prec);
truth gap_between_interval(long *bits, const scheme *s, long k, const long m[2], long prec);
truth gap_between_grid(long *bits, const scheme *s, long k, const long m[2], long prec);

#endif
