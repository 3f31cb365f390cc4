/* laurent_value.h: formulas that are finite sums of c_i k^i with rational c_i (verify/certificate-valences.md, section 4,
   "Limit"). */
#ifndef LIB_LAURENT_VALUE_H
#define LIB_LAURENT_VALUE_H

#include "exact_range.h"

/* No |i| is larger. */
enum { LAURENT_MAX_DEGREE = 64 };

typedef struct {
    rational *c; /* of k^i at i + LAURENT_MAX_DEGREE; NULL: not made */
} laurent_value;

BIGFLOAT_MUST_USE bool laurent_value_make(laurent_value *z); /* 0; on either answer laurent_value_clear */
void laurent_value_clear(laurent_value *z);

static inline const rational *laurent_value_at(const laurent_value *x, int i) { return &x->c[i + LAURENT_MAX_DEGREE]; }
/* The greatest and the least i with c_i other than 0; of 0 both are 0. */
int laurent_value_high(const laurent_value *x);
int laurent_value_low(const laurent_value *x);
static inline bool laurent_value_is_constant(const laurent_value *x) { return laurent_value_high(x) == 0 && laurent_value_low(x) == 0; }

BIGFLOAT_MUST_USE bool laurent_value_set_si(laurent_value *z, long n);
BIGFLOAT_MUST_USE bool laurent_value_add(laurent_value *z, const laurent_value *x); /* z += x */
BIGFLOAT_MUST_USE bool laurent_value_sub(laurent_value *z, const laurent_value *x); /* z -= x */
BIGFLOAT_MUST_USE bool laurent_value_stretch(laurent_value *z, long n); /* z(k) becomes z(n k), n > 0 */

/* z = f for all k of the range; or *known is false: f is not made of numbers and k by + - *, minus, powers with whole exponents,
   quotients by one term, names, and `cases` that are decided over the range, or goes beyond degrees and lengths.
   false: no memory. */
BIGFLOAT_MUST_USE bool formula_laurent_value(laurent_value *z, bool *known, const formula *f, valence_range k);

#endif
