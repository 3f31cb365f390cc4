/* step.h: the steps of a scheme applied to sector nets: masks, and rules near the extraordinary vertex, for one valence
   and one frequency or ranges of them.  Compiled once per number system. */
#ifndef LIB_STEP_H
#define LIB_STEP_H

#include "exact_range.h"
#include "scheme.h"
#include "sector.h"

#define scheme_numbers_make NUMBER_NAME(scheme_numbers_make)
#define scheme_numbers_make_range NUMBER_NAME(scheme_numbers_make_range)
#define scheme_numbers_set_frequency NUMBER_NAME(scheme_numbers_set_frequency)
#define scheme_numbers_set_frequencies NUMBER_NAME(scheme_numbers_set_frequencies)
#define scheme_numbers_free NUMBER_NAME(scheme_numbers_free)

/* A rule's effect on nets of one frequency: the sum of matrix[i] times the value at point[i] of the own sector, or at
   the centre, as source i says. */
typedef struct {
    const rule *rule;
    int count;
    lattice point[SCHEME_MAX_SOURCES];
    pair_matrix matrix[SCHEME_MAX_SOURCES];
    bool known[SCHEME_MAX_SOURCES];     /* weight[i] is that of source i for every frequency; of the rest, only if somebody else has set it */
    number weight[SCHEME_MAX_SOURCES];
} rule_numbers;

typedef struct {
    mask_numbers mask;
    rule_numbers *rules; /* those that hold at these valences */
    int rule_count;
} step_numbers;

typedef struct {
    const scheme *scheme;
    valence_range k;
    frequencies m;
    long prec;
    int rings;     /* scheme_closed_rings */
    bool any_mask; /* where the valence is plainly regular, any mask may give the centre its value, as lib/scheme.md says;
                      else it must keep it, which is all that certificates know of (verify/certificate.md, section 5) */
    bool complex_form; /* covers (lib/cover.h) are of blocks in the complex form even where the scheme is mirror-symmetric */
    step_numbers steps[SCHEME_MAX_STEPS];
} scheme_numbers;

/* Everything that does not depend on the frequency, for all valences of the range at once.  STATUS_BAD_INPUT also: some
   rule's condition is not decided for them together (scheme_rules_decided).  On any status scheme_numbers_free. */
status scheme_numbers_make_range(scheme_numbers *z, const scheme *s, valence_range k, long prec, diagnostic *d);
static inline status scheme_numbers_make(scheme_numbers *z, const scheme *s, long k, long prec, diagnostic *d)
{
    return scheme_numbers_make_range(z, s, one_valence(k), prec, d);
}
/* The rules for all frequencies of the range at once, with the twist that the nets will have (NULL for m = 0, which is
   a range of its own). */
status scheme_numbers_set_frequencies(scheme_numbers *z, frequencies m, const twist *t, diagnostic *d);
static inline status scheme_numbers_set_frequency(scheme_numbers *z, long m, const twist *t, diagnostic *d)
{
    return scheme_numbers_set_frequencies(z, one_frequency(m), t, d);
}
void scheme_numbers_free(scheme_numbers *z);

#endif
