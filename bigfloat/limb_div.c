/* limb_div.c: long division (Knuth, The Art of Computer Programming, 4.3.1, Algorithm D). */
#include <stdlib.h>

#include "limb.h"

#define STACK_LIMBS 40

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

/* u (na + 1 limbs) becomes the remainder; q as in limb_divide, or NULL. */
static void divide_basecase(limb_t *q, limb_t *u, size_t na, const limb_t *v, size_t nb)
{
    for (size_t i = na - nb + 1; i-- > 0;) {
        limb_t t = quotient_limb(u + i, v, nb);
        if (q)
            q[i] = t;
    }
}

bool limb_divide(limb_t *q, limb_t *r, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    limb_t stack[STACK_LIMBS], *space = stack;
    if (na + nb + 1 > STACK_LIMBS && !(space = malloc((na + nb + 1) * sizeof *space)))
        return false;
    limb_t *u = space, *v = space + na + 1;
    if (nb == 1) {
        limb_t t = limb_divrem_1(q ? q : u, a, na, b[0]);
        if (r)
            r[0] = t;
    } else {
        unsigned s = (unsigned)limb_clz(b[nb - 1]);
        limb_shift_left(v, b, nb, s);
        u[na] = limb_shift_left(u, a, na, s);
        divide_basecase(q, u, na, v, nb);
        if (r)
            limb_shift_right(r, u, nb, s);
    }
    if (space != stack)
        free(space);
    return true;
}
