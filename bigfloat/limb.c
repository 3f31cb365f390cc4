/* limb.c: the linear-time kernels of limb.h. */
#include "limb.h"

#include <string.h>

void limb_zero(limb_t *z, size_t n)
{
    if (n)
        memset(z, 0, n * sizeof *z);
}

void limb_copy(limb_t *z, const limb_t *a, size_t n)
{
    if (n)
        memmove(z, a, n * sizeof *z);
}

size_t limb_normal(const limb_t *a, size_t n)
{
    while (n && a[n - 1] == 0)
        n--;
    return n;
}

int limb_compare(const limb_t *a, const limb_t *b, size_t n)
{
    while (n--)
        if (a[n] != b[n])
            return a[n] < b[n] ? -1 : 1;
    return 0;
}

size_t limb_bit_length(const limb_t *a, size_t n)
{
    n = limb_normal(a, n);
    return n ? 64 * n - (size_t)limb_clz(a[n - 1]) : 0;
}

size_t limb_trailing_zeros(const limb_t *a, size_t n)
{
    size_t i = 0;
    while (i + 1 < n && a[i] == 0)
        i++;
    return 64 * i + (size_t)limb_ctz(a[i]);
}

bool limb_low_bits_zero(const limb_t *a, size_t n, size_t bits)
{
    size_t whole = bits / 64, rest = bits % 64;
    for (size_t i = 0; i < whole && i < n; i++)
        if (a[i])
            return false;
    return whole >= n || rest == 0 || a[whole] << (64 - rest) == 0;
}

limb_t limb_add_n(limb_t *z, const limb_t *a, const limb_t *b, size_t n)
{
    limb_t carry = 0;
#pragma GCC unroll 4
    for (size_t i = 0; i < n; i++)
        z[i] = limb_add(a[i], b[i], &carry);
    return carry;
}

limb_t limb_sub_n(limb_t *z, const limb_t *a, const limb_t *b, size_t n)
{
    limb_t borrow = 0;
#pragma GCC unroll 4
    for (size_t i = 0; i < n; i++)
        z[i] = limb_sub(a[i], b[i], &borrow);
    return borrow;
}

limb_t limb_add_1(limb_t *z, const limb_t *a, size_t n, limb_t c)
{
    for (size_t i = 0; i < n; i++) {
        z[i] = a[i] + c;
        c = z[i] < c;
    }
    return c;
}

limb_t limb_sub_1(limb_t *z, const limb_t *a, size_t n, limb_t c)
{
    for (size_t i = 0; i < n; i++) {
        limb_t t = a[i];
        z[i] = t - c;
        c = t < c;
    }
    return c;
}

limb_t limb_add_any(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    return limb_add_1(z + nb, a + nb, na - nb, limb_add_n(z, a, b, nb));
}

limb_t limb_sub_any(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb)
{
    return limb_sub_1(z + nb, a + nb, na - nb, limb_sub_n(z, a, b, nb));
}

limb_t limb_mul_1(limb_t *z, const limb_t *a, size_t n, limb_t b)
{
    limb_t carry = 0;
    for (size_t i = 0; i < n; i++)
        z[i] = limb_muladd(a[i], b, 0, &carry);
    return carry;
}

limb_t limb_addmul_1(limb_t *z, const limb_t *a, size_t n, limb_t b)
{
    limb_t carry = 0;
    for (size_t i = 0; i < n; i++)
        z[i] = limb_muladd(a[i], b, z[i], &carry);
    return carry;
}

/* z - a b is formed as z + a (-b) in each word: the pair (high, low) of a b + borrow is subtracted. */
limb_t limb_submul_1(limb_t *z, const limb_t *a, size_t n, limb_t b)
{
    limb_t borrow = 0;
    for (size_t i = 0; i < n; i++) {
        limb_t low = limb_muladd(a[i], b, 0, &borrow); /* borrow <= 2^64 - 2 */
        borrow += z[i] < low;
        z[i] -= low;
    }
    return borrow;
}

limb_t limb_shift_left(limb_t *z, const limb_t *a, size_t n, unsigned s)
{
    if (s == 0) {
        limb_copy(z, a, n);
        return 0;
    }
    limb_t out = n ? a[n - 1] >> (64 - s) : 0;
    for (size_t i = n; i-- > 1;)
        z[i] = (a[i] << s) | (a[i - 1] >> (64 - s));
    if (n)
        z[0] = a[0] << s;
    return out;
}

limb_t limb_shift_right(limb_t *z, const limb_t *a, size_t n, unsigned s)
{
    if (s == 0) {
        limb_copy(z, a, n);
        return 0;
    }
    limb_t out = n ? a[0] << (64 - s) : 0;
    for (size_t i = 0; i + 1 < n; i++)
        z[i] = (a[i] >> s) | (a[i + 1] << (64 - s));
    if (n)
        z[n - 1] = a[n - 1] >> s;
    return out;
}

limb_t limb_divrem_1(limb_t *z, const limb_t *a, size_t n, limb_t d)
{
    limb_t r = 0;
    for (size_t i = n; i-- > 0;)
        z[i] = limb_div(&r, r, a[i], d);
    return r;
}

#if !LIMB_INT128
/* Schoolbook division in base 2^32: two quotient digits, each estimated from the leading digit of the divisor,
   which is at least 2^31 after normalisation; the estimate is at most two too large and corrected (Knuth,
   4.3.1, Theorem B). */
limb_t limb_div_portable(limb_t *remainder, limb_t high, limb_t low, limb_t d)
{
    int s = limb_clz(d);
    d <<= s;
    limb_t top = s ? (high << s) | (low >> (64 - s)) : high;
    low <<= s;
    limb_t d1 = d >> 32, d0 = (uint32_t)d, quotient = 0;
    for (int i = 0; i < 2; i++) {
        limb_t digit = i == 0 ? low >> 32 : (uint32_t)low;
        limb_t q = top / d1, r = top % d1;
        while (q >> 32 || q * d0 > ((r << 32) | digit)) {
            q--;
            r += d1;
            if (r >> 32)
                break;
        }
        top = ((top << 32) | digit) - q * d; /* < d; the wrap-around is harmless */
        quotient = (quotient << 32) | q;
    }
    *remainder = top >> s;
    return quotient;
}
#endif
