/* limb_div.c: long division.  Quotients of few limbs by Knuth's Algorithm D (The Art of Computer Programming, 4.3.1);
   longer ones recursively, at the cost of multiplications (Burnikel and Ziegler, Fast Recursive Division). */
#include <stdlib.h>

#include "limb.h"

#define STACK_LIMBS 40
#define RECURSIVE_LIMBS 40 /* quotients from here on are divided recursively */

/* One quotient limb: u (n + 1 limbs, its value < B times v) is replaced by u mod v.  v is normalised
   (v[n - 1] >= 2^63, n >= 2).  The estimate from the three leading limbs of u and two of v is at most one too
   large; a negative difference shows it. */
static limb_t quotient_limb(limb_t *u, const limb_t *v, size_t n)
{
    limb_t q, r;
    bool carried = false;
    if (u[n] >= v[n - 1]) {
        q = ~(limb_t)0;
        r = u[n - 1] + v[n - 1]; /* (u[n], u[n-1]) - q v[n-1] when u[n] = v[n-1] */
        carried = r < v[n - 1];
    } else
        q = limb_div(&r, u[n], u[n - 1], v[n - 1]);
    while (!carried) {
        limb_t high, low = limb_mul(&high, q, v[n - 2]);
        if (high < r || (high == r && low <= u[n - 2]))
            break;
        q--;
        r += v[n - 1];
        carried = r < v[n - 1];
    }
    limb_t borrow = limb_submul_1(u, v, n, q);
    if (u[n] < borrow) {
        q--;
        borrow -= limb_add_n(u, u, v, n);
    }
    u[n] -= borrow;
    return q;
}

/* u has n + m limbs, its n upper limbs are less than v: q = m limbs of u / v, or NULL; u becomes the remainder (n limbs,
   zeros above). */
static void divide_basecase(limb_t *q, limb_t *u, size_t m, const limb_t *v, size_t n)
{
    for (size_t i = m; i-- > 0;) {
        limb_t t = quotient_limb(u + i, v, n);
        if (q)
            q[i] = t;
    }
}

static bool divide_recursive(limb_t *q, limb_t *u, size_t m, const limb_t *v, size_t n, limb_t *p);

/* The same, by dividing without the k lower limbs v0 of v = v1 B^k + v0 and then subtracting q v0.  The quotient by v1
   is never too small and, since m <= n - k or thereabouts and v is normalised, at most 2 too large; where it would need
   an (m + 1)-st limb, B^m - 1 is taken.  p: room for m + k <= n limbs. */
static bool divide_by_upper(limb_t *q, limb_t *u, size_t m, const limb_t *v, size_t n, size_t k, limb_t *p)
{
    limb_t negative; /* u = its n limbs - negative B^n */
    if (limb_compare(u + m + k, v + k, n - k) >= 0) {
        for (size_t i = 0; i < m; i++)
            q[i] = ~(limb_t)0;
        limb_t carry = limb_add_n(u, u, v, n); /* u - (B^m - 1) v */
        limb_add_1(u + n, u + n, m, carry);
        limb_sub_n(u + m, u + m, v, n);
        negative = 0 - u[n];
        limb_zero(u + n, m);
    } else {
        if (!divide_recursive(q, u + k, m, v + k, n - k, p))
            return false;
        if (!(m >= k ? limb_multiply(p, q, m, v, k) : limb_multiply(p, v, k, q, m)))
            return false;
        negative = limb_sub_any(u, u, n, p, m + k);
    }
    while (negative) {
        limb_sub_1(q, q, m, 1);
        negative -= limb_add_n(u, u, v, n);
    }
    return true;
}

/* m <= n */
static bool divide_recursive(limb_t *q, limb_t *u, size_t m, const limb_t *v, size_t n, limb_t *p)
{
    if (m < RECURSIVE_LIMBS) {
        divide_basecase(q, u, m, v, n);
        return true;
    }
    size_t k = m / 2;
    return divide_by_upper(q + k, u + k, m - k, v, n, k, p) && divide_by_upper(q, u, k, v, n, k, p);
}

/* Blocks of at most n quotient limbs, from the top. */
static bool divide_blocks(limb_t *q, limb_t *u, size_t m, const limb_t *v, size_t n)
{
    limb_t *p = malloc((n + m) * sizeof *p), *quotient = q ? q : p + n;
    if (!p)
        return false;
    bool ok = true;
    while (ok && m) {
        size_t block = m % n ? m % n : n;
        m -= block;
        ok = divide_recursive(quotient + m, u + m, block, v, n, p);
    }
    free(p);
    return ok;
}

bool limb_divide(limb_t *q, limb_t *r, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    limb_t stack[STACK_LIMBS], *space = stack;
    if (na + nb + 1 > STACK_LIMBS && !(space = malloc((na + nb + 1) * sizeof *space)))
        return false;
    limb_t *u = space, *v = space + na + 1;
    bool ok = true;
    if (nb == 1) {
        limb_t t = limb_divrem_1(q ? q : u, a, na, b[0]);
        if (r)
            r[0] = t;
    } else {
        unsigned s = (unsigned)limb_clz(b[nb - 1]);
        limb_shift_left(v, b, nb, s);
        u[na] = limb_shift_left(u, a, na, s);
        size_t m = na - nb + 1; /* u[na] < 2^s <= 2^63 <= v[nb - 1]: the upper limbs of u are less than v */
        if (m >= RECURSIVE_LIMBS && nb >= RECURSIVE_LIMBS)
            ok = divide_blocks(q, u, m, v, nb);
        else
            divide_basecase(q, u, m, v, nb);
        if (r)
            limb_shift_right(r, u, nb, s);
    }
    if (space != stack)
        free(space);
    return ok;
}
