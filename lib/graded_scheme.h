/* graded_scheme.h: schemes whose block 0 may be scaled by powers of k (verify/certificate-valences.md, section 6, "Growing
   without bound").  Exact. */
#ifndef LIB_GRADED_SCHEME_H
#define LIB_GRADED_SCHEME_H

#include "scheme.h"

/* Is the scheme of this kind?  The weights of the rules of the centre that hold in the range have Laurent values, and all else is as
   scheme_centre_alone_varies says.  *varies: some weight of the centre is no constant. */
status scheme_centre_is_graded(bool *is, bool *varies, const scheme *s, valence_range k, diagnostic *d);

#endif
