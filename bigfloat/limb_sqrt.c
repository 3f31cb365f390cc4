/* limb_sqrt.c: square root with remainder (P. Zimmermann, Karatsuba Square Root, INRIA RR-3805).

   Split a = A B^(2l) + a1 B^l + a0 and let s', r' be root and remainder of the top part A.  Divide:
   r' B^l + a1 = q (2 s') + u.  Then s = s' B^l + q, r = u B^l + a0 - q^2, and where r < 0, s is one too large:
   s - 1 has the remainder r + 2 s - 1.  One correction is enough because A >= B^(2h) / 4. */
#include <math.h>
#include <stdlib.h>

#include "limb.h"

/* floor(sqrt(a)) for a >= 2^62.  The double is within 2 of it; the loops settle the rest. */
static limb_t root_word(limb_t *rem, limb_t a)
{
    limb_t s = (limb_t)sqrt((double)a);
    if (s > 0xffffffff)
        s = 0xffffffff;
    while (s * s > a)
        s--;
    while (s < 0xffffffff && (s + 1) * (s + 1) <= a)
        s++;
    *rem = a - s * s;
    return s;
}

/* The root of two limbs, by the step above with B = 2^32, h = l = 1. */
static void root_pair(limb_t *s, limb_t *r, const limb_t *a)
{
    limb_t r1, s1 = root_word(&r1, a[1]);
    limb_t high = a[0] >> 32, low = (uint32_t)a[0];
    limb_t t = (r1 << 31) | (high >> 1); /* r1 <= 2 s1 < 2^33 */
    limb_t q = t / s1, u = ((t % s1) << 1) | (high & 1);
    if (q >> 32) { /* q = 2^32 only */
        q--;
        u += 2 * s1;
    }
    limb_t root = (s1 << 32) + q;
    limb_t borrow = 0, r0 = limb_sub((u << 32) | low, q * q, &borrow);
    limb_t top = (u >> 32) - borrow;
    if (top >> 63) { /* negative: add 2 root - 1 */
        limb_t carry = 0;
        root--;
        r0 = limb_add(r0, (root << 1) | 1, &carry);
        top += (root >> 63) + carry;
    }
    s[0] = root;
    r[0] = r0;
    r[1] = top;
}

/* t = u B^l + a0 - q^2 as h + l + 2 limbs in two's complement; u has h + 1 limbs, q and a0 have l limbs. */
static bool remainder_candidate(limb_t *t, const limb_t *u, size_t h, const limb_t *a0, const limb_t *q, size_t l,
                                limb_t *square)
{
    limb_copy(t, a0, l);
    limb_copy(t + l, u, h + 1);
    t[l + h + 1] = 0;
    if (!limb_square(square, q, l))
        return false;
    limb_sub_any(t, t, h + l + 2, square, 2 * l);
    return true;
}

static bool root(limb_t *s, limb_t *r, limb_t *a, size_t n, limb_t *space)
{
    if (n == 1) {
        root_pair(s, r, a);
        return true;
    }
    size_t l = n / 2, h = n - l;
    if (!root(s + l, r, a + 2 * l, h, space))
        return false;
    /* N = r' B^l + a1 over s', l + h + 1 limbs by h: Q has l + 2 limbs. */
    limb_t *N = space, *Q = N + l + h + 1, *u = Q + l + 2, *t = u + h + 1, *square = t + n + 2;
    limb_copy(N, a + l, l);
    limb_copy(N + l, r, h + 1);
    if (!limb_divide(Q, u, N, l + h + 1, s + l, h))
        return false;
    u[h] = 0;
    if (Q[0] & 1)
        u[h] += limb_add_n(u, u, s + l, h);
    limb_shift_right(Q, Q, l + 2, 1);
    if (Q[l]) { /* q = B^l: take B^l - 1 */
        for (size_t i = 0; i < l; i++)
            Q[i] = ~(limb_t)0;
        u[h] += limb_add_n(u, u, s + l, h);
        u[h] += limb_add_n(u, u, s + l, h);
    }
    limb_copy(s, Q, l);
    if (!remainder_candidate(t, u, h, a, Q, l, square))
        return false;
    if (t[n + 1] >> 63) { /* t + 2 s - 1 = t + s + (s - 1) */
        limb_t carry = limb_add_n(t, t, s, n);
        limb_add_1(t + n, t + n, 2, carry);
        limb_sub_1(s, s, n, 1);
        carry = limb_add_n(t, t, s, n);
        limb_add_1(t + n, t + n, 2, carry);
    }
    limb_copy(r, t, n + 1);
    return true;
}

bool limb_sqrt_rem(limb_t *s, limb_t *r, limb_t *a, size_t n)
{
    limb_t stack[128], *space = stack;
    if (6 * n + 16 > 128 && !(space = malloc((6 * n + 16) * sizeof *space)))
        return false;
    bool ok = root(s, r, a, n, space);
    if (space != stack)
        free(space);
    return ok;
}
