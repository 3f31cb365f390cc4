/* integer_internal.h: how integers get room for their limbs; for the sources of this folder only. */
#ifndef BIGFLOAT_INTEGER_INTERNAL_H
#define BIGFLOAT_INTEGER_INTERNAL_H

#include "integer.h"
#include "limb.h"

static inline limb_t *integer_limbs_rw(integer *z) { return z->capacity ? z->at.heap : z->at.inline_limbs; }

/* Room for n limbs in z; its limbs keep their values.  NULL = no memory (or n too large), z unchanged. */
limb_t *integer_room(integer *z, size_t n);

/* Room for n limbs in z whose present value is not needed. */
limb_t *integer_fresh(integer *z, size_t n);

/* z's limbs 0..n-1 are in place: set its size and its sign, and restore the invariants. */
static inline void integer_finish(integer *z, size_t n, bool negative)
{
    n = limb_normal(integer_limbs_rw(z), n);
    if (!z->capacity)
        for (size_t i = n; i < INTEGER_INLINE_LIMBS; i++)
            z->at.inline_limbs[i] = 0;
    z->size = negative ? -(int32_t)n : (int32_t)n;
}

/* x is inline, |x| < 2^126: the values that the quick paths take. */
static inline bool integer_is_short(const integer *x)
{
    return !x->capacity && !(x->at.inline_limbs[1] >> 62);
}

#if LIMB_INT128
static inline limb_signed_pair_t integer_get_pair(const integer *x)
{
    limb_signed_pair_t v = (limb_signed_pair_t)(((limb_pair_t)x->at.inline_limbs[1] << 64) | x->at.inline_limbs[0]);
    return x->size < 0 ? -v : v;
}

/* z = v, |v| < 2^127; z must not be on the heap. */
static inline void integer_set_pair_inline(integer *z, limb_signed_pair_t v)
{
    bool negative = v < 0;
    limb_pair_t a = negative ? -(limb_pair_t)v : (limb_pair_t)v;
    limb_t high = (limb_t)(a >> 64), low = (limb_t)a;
    int32_t n = high ? 2 : low != 0;
    z->at.inline_limbs[0] = low;
    z->at.inline_limbs[1] = high;
    z->size = negative ? -n : n;
}

static inline void integer_set_pair(integer *z, limb_signed_pair_t v)
{
    if (z->capacity)
        integer_clear(z);
    integer_set_pair_inline(z, v);
}
#endif

#endif
