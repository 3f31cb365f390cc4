/* integer_mul.c: products and powers of integers. */
#include <stdlib.h>

#include "integer.h"
#include "integer_internal.h"

/* x times one limb v, negated if `flip`. */
static bool mul_limb(integer *z, const integer *x, limb_t v, bool flip)
{
    size_t m = (size_t)integer_length(x);
    bool negative = (x->size < 0) != flip;
    limb_t *p = integer_room(z, m + 1);
    if (!p)
        return false;
    p[m] = limb_mul_1(p, integer_limbs(x), m, v);
    integer_finish(z, m + 1, negative);
    return true;
}

bool integer_mul(integer *z, const integer *x, const integer *y)
{
    if (integer_length(x) < integer_length(y)) {
        const integer *t = x;
        x = y;
        y = t;
    }
    size_t m = (size_t)integer_length(x), n = (size_t)integer_length(y);
    if (n == 0) {
        integer_zero(z);
        return true;
    }
    if (n == 1)
        return mul_limb(z, x, integer_limbs(y)[0], y->size < 0);
    bool negative = (x->size < 0) != (y->size < 0);
    integer t;
    integer_init(&t);
    integer *to = z == x || z == y ? &t : z;
    limb_t *p = integer_fresh(to, m + n);
    bool ok = p && limb_multiply(p, integer_limbs(x), m, integer_limbs(y), n);
    if (ok) {
        integer_finish(to, m + n, negative);
        if (to == &t)
            integer_swap(z, &t);
    }
    integer_clear(&t);
    return ok;
}

bool integer_sqr(integer *z, const integer *x) { return integer_mul(z, x, x); }

bool integer_mul_si(integer *z, const integer *x, int64_t v)
{
    return mul_limb(z, x, v < 0 ? 0 - (uint64_t)v : (uint64_t)v, v < 0);
}

bool integer_addmul(integer *z, const integer *x, const integer *y)
{
    integer t;
    integer_init(&t);
    bool ok = integer_mul(&t, x, y) && integer_add(z, z, &t);
    integer_clear(&t);
    return ok;
}

bool integer_submul(integer *z, const integer *x, const integer *y)
{
    integer t;
    integer_init(&t);
    bool ok = integer_mul(&t, x, y) && integer_sub(z, z, &t);
    integer_clear(&t);
    return ok;
}

/* Binary powering from the highest bit of n. */
bool integer_pow(integer *z, const integer *x, unsigned long n)
{
    integer base, power;
    integer_init(&base);
    integer_init(&power);
    integer_set_si(&power, 1);
    bool ok = integer_set(&base, x);
    for (unsigned long bit = n ? 1UL << (limb_bits(n) - 1) : 0; ok && bit; bit /= 2)
        ok = integer_sqr(&power, &power) && (!(n & bit) || integer_mul(&power, &power, &base));
    if (ok)
        integer_swap(z, &power);
    integer_clear(&base);
    integer_clear(&power);
    return ok;
}
