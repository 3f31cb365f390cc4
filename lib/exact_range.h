/* exact_range.h: where the exact values of a formula lie while the frequency m runs through a range.

   An exact_range denotes all numbers from low to high, or all angles from low pi to high pi (lib/scheme.md, "Value of
   a formula"). */
#ifndef LIB_EXACT_RANGE_H
#define LIB_EXACT_RANGE_H

#include "formula.h"

#include "../bigfloat/truth.h"

/* The frequencies first, first + 1, ..., last of one valence: 0 <= first <= last. */
typedef struct {
    long first, last;
} frequencies;

static inline frequencies one_frequency(long m) { return (frequencies){m, m}; }

typedef struct {
    bool is_angle;
    rational low, high; /* low <= high */
} exact_range;

void exact_range_init(exact_range *z);
void exact_range_clear(exact_range *z);

/* The values of f at k and j of `at` for all m of the range lie in z; or *known is false: they are not known to be
   exact, or a rule for their range is missing here, or f has no value at some m.  at->m does not matter.
   false: no memory. */
BIGFLOAT_MUST_USE bool formula_exact_range(exact_range *z, bool *known, const formula *f, const formula_point *at, frequencies m);

/* Has f the same value, or none, at all m of the range?  *constant false: perhaps not. */
BIGFLOAT_MUST_USE bool formula_is_constant(bool *constant, const formula *f, const formula_point *at, frequencies m);

/* Does the condition hold for all m of the range (TRUTH_TRUE), for none (TRUTH_FALSE), as far as exact values tell? */
BIGFLOAT_MUST_USE bool formula_condition_range(truth *t, const formula *f, const formula_point *at, frequencies m);

#endif
