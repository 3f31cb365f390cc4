/* limb_mul.c: products.

   Schoolbook up to LIMB_KARATSUBA limbs; above, Karatsuba's three half products:
   with a = a0 + a1 B, b = b0 + b1 B,  a b = p0 + (p0 + p2 - (a0 - a1)(b0 - b1)) B + p2 B^2. */
#include <stdlib.h>

#include "limb.h"
#include "limb_row.h"

#define LIMB_KARATSUBA 28
#define LIMB_KARATSUBA_SQUARE 44

#if LIMB_HAVE_ADX
static inline void multiply_adx(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    z[na] = limb_mul_1_adx(z, a, na, b[0]);
    for (size_t i = 1; i < nb; i++)
        z[na + i] = limb_addmul_1_adx(z + i, a, na, b[i]);
}
#endif

/* Both of n limbs, n known to the compiler. */
#if defined(__GNUC__)
__attribute__((always_inline))
#endif
static inline void multiply_fixed(limb_t *z, const limb_t *a, const limb_t *b, const size_t n)
{
    limb_t carry = 0;
#pragma GCC unroll 8
    for (size_t j = 0; j < n; j++)
        z[j] = limb_muladd(a[j], b[0], 0, &carry);
    z[n] = carry;
#pragma GCC unroll 8
    for (size_t i = 1; i < n; i++) {
        carry = 0;
#pragma GCC unroll 8
        for (size_t j = 0; j < n; j++)
            z[i + j] = limb_muladd(a[j], b[i], z[i + j], &carry);
        z[n + i] = carry;
    }
}

/* Up to 7 limbs the compiler's own code is the fastest; then rows of four words. */
static bool multiply_short(limb_t *z, const limb_t *a, const limb_t *b, size_t n)
{
    switch (n) {
    case 1: multiply_fixed(z, a, b, 1); return true;
    case 2: multiply_fixed(z, a, b, 2); return true;
    case 3: multiply_fixed(z, a, b, 3); return true;
    case 4: multiply_fixed(z, a, b, 4); return true;
    case 5: multiply_fixed(z, a, b, 5); return true;
    case 6: multiply_fixed(z, a, b, 6); return true;
    case 7: multiply_fixed(z, a, b, 7); return true;
    default: return false;
    }
}

void limb_multiply_basecase(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    if (na == nb && multiply_short(z, a, b, na))
        return;
#if LIMB_HAVE_ADX
    if (na >= 4 && limb_processor_has_adx()) {
        if (na == 8 && nb == 8)
            multiply_adx(z, a, 8, b, 8);
        else
            multiply_adx(z, a, na, b, nb);
        return;
    }
#endif
    if (na == 8 && nb == 8) {
        multiply_fixed(z, a, b, 8);
        return;
    }
    z[na] = limb_mul_1(z, a, na, b[0]);
    for (size_t i = 1; i < nb; i++)
        z[na + i] = limb_addmul_1(z + i, a, na, b[i]);
}

/* The sum of a[i] b[j] B^(i + j - n + 2) over i + j >= n - 2.  Left out, in units of 1, is at most the sum of
   (k + 1) (B - 1)^2 B^k over k <= n - 3, which is at most (n - 2) (B - 1) (B^(n - 2) - 1) < (n - 2) B^(n - 1). */
void limb_multiply_high(limb_t *z, const limb_t *a, const limb_t *b, size_t n)
{
    z[0] = z[1] = 0;
#if LIMB_HAVE_ADX
    if (limb_processor_has_adx()) {
        for (size_t j = 0; j + 1 < n; j++)
            z[j + 2] = limb_addmul_1_adx(z, a + n - 2 - j, j + 2, b[j]);
        z[n + 1] = limb_addmul_1_adx(z + 1, a, n, b[n - 1]);
        return;
    }
#endif
    for (size_t j = 0; j + 1 < n; j++)
        z[j + 2] = limb_addmul_1(z, a + n - 2 - j, j + 2, b[j]);
    z[n + 1] = limb_addmul_1(z + 1, a, n, b[n - 1]);
}

/* z = sum of a[i] a[j] B^(i + j) over i < j */
static void off_diagonal(limb_t *z, const limb_t *a, size_t n)
{
    z[0] = 0;
    z[2 * n - 1] = 0;
    if (n == 1)
        return;
#if LIMB_HAVE_ADX
    if (n >= 6 && limb_processor_has_adx()) {
        z[n] = limb_mul_1_adx(z + 1, a + 1, n - 1, a[0]);
        for (size_t i = 1; i + 1 < n; i++)
            z[n + i] = limb_addmul_1_adx(z + 2 * i + 1, a + i + 1, n - i - 1, a[i]);
        return;
    }
#endif
    z[n] = limb_mul_1(z + 1, a + 1, n - 1, a[0]);
    for (size_t i = 1; i + 1 < n; i++)
        z[n + i] = limb_addmul_1(z + 2 * i + 1, a + i + 1, n - i - 1, a[i]);
}

/* Twice the products off the diagonal, plus the squares on it. */
void limb_square_basecase(limb_t *z, const limb_t *a, size_t n)
{
    off_diagonal(z, a, n);
    limb_t carry = 0, doubled = 0;
    for (size_t i = 0; i < n; i++) {
        limb_t high, low = limb_mul(&high, a[i], a[i]), u = z[2 * i], v = z[2 * i + 1];
        z[2 * i] = limb_add(u << 1 | doubled, low, &carry);
        z[2 * i + 1] = limb_add(v << 1 | u >> 63, high, &carry);
        doubled = v >> 63;
    }
}

/* z = |a - b|, a with n limbs, b with m <= n; the answer is the sign of a - b as 0 (>= 0) or 1 (< 0). */
static int difference(limb_t *z, const limb_t *a, size_t n, const limb_t *b, size_t m)
{
    size_t k = limb_normal(a, n);
    if (k > m || (k <= m && limb_compare(a, b, m) >= 0)) {
        limb_sub_any(z, a, n, b, m);
        return 0;
    }
    limb_sub_n(z, b, a, m);
    limb_zero(z + m, n - m);
    return 1;
}

/* Scratch for n limbs: S(n) = 2 h + 2 + S(h + 1)-like with h = ceil(n / 2), so that
   S(n) <= 2 (n + 64) covers all levels: sum of 2 ceil(n / 2^i) <= 2 n + 2 log2(n). */
static size_t karatsuba_scratch(size_t n) { return 2 * n + 128; }

static void multiply_same(limb_t *z, const limb_t *a, const limb_t *b, size_t n, limb_t *scratch);

/* Adds p (h2 limbs) into z at limb h; z has `room` limbs above that and the sum fits. */
static void add_into(limb_t *z, size_t room, const limb_t *p, size_t n)
{
    limb_t carry = limb_add_n(z, z, p, n);
    limb_add_1(z + n, z + n, room - n, carry);
}

static void karatsuba(limb_t *z, const limb_t *a, const limb_t *b, size_t n, limb_t *scratch)
{
    size_t h = (n + 1) / 2, k = n - h; /* k <= h <= k + 1 */
    bool square = a == b;
    limb_t *middle = scratch, *rest = scratch + 2 * h;

    /* |a0 - a1| and |b0 - b1| are parked in z until the product of them is done. */
    int sign = difference(z, a, h, a + h, k);
    int other = square ? sign : difference(z + h, b, h, b + h, k);
    multiply_same(middle, z, square ? z : z + h, h, rest);

    multiply_same(z, a, b, h, rest);
    multiply_same(z + 2 * h, a + h, b + h, k, rest);

    /* t = p0 + p2 -+ middle, at most 2 h limbs and a carry.  rest is free again: t goes there. */
    limb_t *t = rest;
    limb_t carry = limb_add_any(t, z, 2 * h, z + 2 * h, 2 * k);
    if (sign == other)
        carry -= limb_sub_n(t, t, middle, 2 * h);
    else
        carry += limb_add_n(t, t, middle, 2 * h);
    t[2 * h] = carry;
    size_t length = limb_normal(t, 2 * h + 1);
    add_into(z + h, 2 * n - h, t, length);
}

static void multiply_same(limb_t *z, const limb_t *a, const limb_t *b, size_t n, limb_t *scratch)
{
    if (a == b) {
        if (n < LIMB_KARATSUBA_SQUARE)
            limb_square_basecase(z, a, n);
        else
            karatsuba(z, a, b, n, scratch);
    } else if (n < LIMB_KARATSUBA)
        limb_multiply_basecase(z, a, n, b, n);
    else
        karatsuba(z, a, b, n, scratch);
}

bool limb_square(limb_t *z, const limb_t *a, size_t n)
{
    if (n < LIMB_KARATSUBA_SQUARE) {
        limb_square_basecase(z, a, n);
        return true;
    }
    limb_t *scratch = malloc(karatsuba_scratch(2 * n) * sizeof *scratch);
    if (!scratch)
        return false;
    karatsuba(z, a, a, n, scratch);
    free(scratch);
    return true;
}

/* Blocks of nb limbs of a, each times b. */
static bool multiply_blocks(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    size_t scratch_limbs = karatsuba_scratch(2 * nb);
    limb_t *scratch = malloc((scratch_limbs + 2 * nb) * sizeof *scratch);
    if (!scratch)
        return false;
    limb_t *product = scratch + scratch_limbs;
    multiply_same(z, a, b, nb, scratch);
    limb_zero(z + 2 * nb, na - nb);
    bool ok = true;
    for (size_t done = nb; ok && done < na;) {
        size_t n = na - done < nb ? na - done : nb;
        if (n == nb)
            multiply_same(product, a + done, b, nb, scratch);
        else
            ok = limb_multiply(product, b, nb, a + done, n);
        if (ok)
            add_into(z + done, na + nb - done, product, n + nb);
        done += n;
    }
    free(scratch);
    return ok;
}

bool limb_multiply(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    if (a == b && na == nb)
        return limb_square(z, a, na);
    if (nb < LIMB_KARATSUBA) {
        limb_multiply_basecase(z, a, na, b, nb);
        return true;
    }
    return multiply_blocks(z, a, na, b, nb);
}
