/* resting_centre.h: schemes whose centre comes to rest as the valence grows (verify/certificate-valences.md, section 4, "Limit").

   The weights of their rules of the centre are polynomials in 1/k, at 1/k = 0 the centre keeps its value, and no other
   weight depends on k or m, nor on what rotation does but by whole sectors: block 0, but for the constant net, tends to what
   block 1 tends to. */
#ifndef LIB_RESTING_CENTRE_H
#define LIB_RESTING_CENTRE_H

#include "scheme.h"

/* Is the scheme of this kind at all valences from k.first on (k.last must be unbounded)?  It has a centre, then, and its rules
   are decided. */
status scheme_centre_rests(bool *rests, const scheme *s, valence_range k, diagnostic *d);

#endif
