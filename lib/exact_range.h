/* exact_range.h: where the exact values of a formula lie while the valence k, the frequency m, or both run through a
   range (lib/scheme.md, "Ranges of k and m"). */
#ifndef LIB_EXACT_RANGE_H
#define LIB_EXACT_RANGE_H

#include "formula.h"

#include "../bigfloat/truth.h"

#include <limits.h>

/* The frequencies first, first + 1, ..., last: 0 <= first <= last, which may be FREQUENCIES_UNBOUNDED. */
typedef struct {
    long first, last;
} frequencies;

#define FREQUENCIES_UNBOUNDED LONG_MAX

static inline frequencies one_frequency(long m) { return (frequencies){m, m}; }

/* The valences first, first + 1, ..., last: 3 <= first <= last, which may be VALENCES_UNBOUNDED. */
typedef struct {
    long first, last;
} valence_range;

#define VALENCES_UNBOUNDED LONG_MAX

static inline valence_range one_valence(long k) { return (valence_range){k, k}; }
static inline bool is_one_valence(valence_range k) { return k.first == k.last; }

/* What the variables of a formula run through, independently of each other. */
typedef struct {
    valence_range k;
    frequencies m;
    long j;
} formula_region;

/* Which of them take more than one value: FORMULA_ON_... */
static inline unsigned formula_region_varies(const formula_region *at)
{
    return (at->k.first != at->k.last ? FORMULA_ON_VALENCE : 0U) | (at->m.first != at->m.last ? FORMULA_ON_FREQUENCY : 0U);
}

/* The first values of all ranges. */
static inline formula_point formula_region_start(const formula_region *at) { return (formula_point){at->k.first, at->m.first, at->j}; }

/* A rational, or infinity > 0: +oo, < 0: -oo. */
typedef struct {
    int infinity;
    rational q; /* if infinity = 0 */
} exact_end;

/* All numbers from low to high, or all angles from low pi to high pi; low <= high, low is not +oo, high not -oo. */
typedef struct {
    bool is_angle;
    exact_end low, high;
} exact_range;

void exact_range_init(exact_range *z); /* 0 */
void exact_range_clear(exact_range *z);

static inline bool exact_range_is_bounded(const exact_range *x) { return !x->low.infinity && !x->high.infinity; }

/* The values of f in the region lie in z; or *known is false: they are not known to be exact, or a rule for their range is
   missing here, or f has no value at some point.  false: no memory. */
BIGFLOAT_MUST_USE bool formula_exact_range(exact_range *z, bool *known, const formula *f, const formula_region *at);

/* Is f evidently a whole number everywhere in the region: made of k, m and exact whole numbers by + - * and minus? */
BIGFLOAT_MUST_USE bool formula_is_whole(bool *whole, const formula *f, const formula_region *at);

/* Has f the same value, or none, everywhere in the region?  *constant false: perhaps not. */
BIGFLOAT_MUST_USE bool formula_is_constant(bool *constant, const formula *f, const formula_region *at);

/* Does the condition hold everywhere in the region (TRUTH_TRUE), or nowhere (TRUTH_FALSE), as far as exact values tell? */
BIGFLOAT_MUST_USE bool formula_condition_range(truth *t, const formula *f, const formula_region *at);

#endif
