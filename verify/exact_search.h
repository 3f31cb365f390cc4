/* exact_search.h: looking for eigenvalues that are exactly equal in several blocks, in larger Jordan blocks, or of modulus 1
   (verify/exact.md).  What is found is exact but for its size: that the eigenvalue is the largest is for the tests to
   prove. */
#ifndef VERIFY_EXACT_SEARCH_H
#define VERIFY_EXACT_SEARCH_H

#include "candidates.h"
#include "choices.h"

/* TRUTH_TRUE: the claim, and the choices without powers and without the bracket of the eigenvalue.  TRUTH_UNKNOWN: nothing
   was found.  TRUTH_FALSE: no memory. */
truth exact_search(exact_choice *z, claim_kind *claim, const scheme *s, long k, const candidates *c);

#endif
