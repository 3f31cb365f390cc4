/* scheme_range.h: what may be said of a scheme's rules at many valences at once (verify/certificate-valences.md). */
#ifndef LIB_SCHEME_RANGE_H
#define LIB_SCHEME_RANGE_H

#include "scheme.h"

/* Does each rule hold at all valences of the range, or at none of them, by exact values?  TRUTH_UNKNOWN: of some rule that is
   not known, and *d says of which one.  For one valence the answer is TRUTH_TRUE unless the scheme is at fault there. */
status scheme_rules_decided(truth *decided, const scheme *s, valence_range k, diagnostic *d);

/* The same, and all conditions of `cases` in weights of rules that depend on k alone are decided, too: the weights change there
   like smooth functions. */
status scheme_cases_decided(truth *decided, const scheme *s, valence_range k, diagnostic *d);

/* *last = the greatest one, k.first <= *last <= k.last, for which scheme_cases_decided says so of k.first..*last: where a
   proof for a range does well to end. */
status scheme_decided_up_to(long *last, const scheme *s, valence_range k, diagnostic *d);

/* May a weight depend on k or m, of a rule for a point other than the centre that holds at the valences of the range, which
   are decided?  If not, the blocks m >= 1 in the real form are one function of u = cos(pi m / k). */
status scheme_weights_vary(bool *vary, const scheme *s, valence_range k, diagnostic *d);
/* May such a weight depend on m? */
status scheme_weights_vary_with_frequency(bool *vary, const scheme *s, valence_range k, diagnostic *d);

#endif
