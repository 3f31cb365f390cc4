/* limb.h: natural numbers as arrays of 64-bit limbs, lowest first.

   The number of (a, n) is the sum of a[i] 2^(64 i) for i < n.  No function here allocates, unless it says so.
   Unless said otherwise an output array may be the same as an input array, but must not overlap it partly.
   With the compiler's 128-bit type one word product is one instruction; with SMOOTHCERT_PORTABLE, or without
   that type, it is made of four 32-bit products in plain C11, with the same results. */
#ifndef BIGFLOAT_LIMB_H
#define BIGFLOAT_LIMB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__SIZEOF_INT128__) && !defined(SMOOTHCERT_PORTABLE)
#define LIMB_INT128 1
__extension__ typedef unsigned __int128 limb_pair_t;
__extension__ typedef __int128 limb_signed_pair_t;
#else
#define LIMB_INT128 0
#endif
#if LIMB_INT128 && defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define LIMB_CARRY_FLAG 1 /* chains of sums compile to chains of adc */
#else
#define LIMB_CARRY_FLAG 0
#endif

typedef uint64_t limb_t;

/* ---- single words ---- */

/* The number of leading and trailing zero bits; a != 0. */
static inline int limb_clz(limb_t a)
{
#if defined(__GNUC__) && !defined(SMOOTHCERT_PORTABLE)
    return __builtin_clzll(a);
#else
    int n = 0;
    for (int step = 32; step; step /= 2)
        if (!(a >> (64 - step))) {
            n += step;
            a <<= step;
        }
    return n;
#endif
}

static inline int limb_ctz(limb_t a)
{
#if defined(__GNUC__) && !defined(SMOOTHCERT_PORTABLE)
    return __builtin_ctzll(a);
#else
    return 63 - limb_clz(a & (~a + 1));
#endif
}

/* The least n with a < 2^n. */
static inline int limb_bits(limb_t a) { return a ? 64 - limb_clz(a) : 0; }

/* a + b + *carry = result + 2^64 *carry; carry 0 or 1. */
static inline limb_t limb_add(limb_t a, limb_t b, limb_t *carry)
{
#if LIMB_CARRY_FLAG
    unsigned long long t;
    *carry = _addcarry_u64((unsigned char)*carry, a, b, &t);
    return t;
#elif LIMB_INT128
    limb_pair_t t = (limb_pair_t)a + b + *carry;
    *carry = (limb_t)(t >> 64);
    return (limb_t)t;
#else
    limb_t s = a + b, t = s + *carry;
    *carry = (limb_t)(s < a) | (limb_t)(t < s); /* at most one of the two sums wraps */
    return t;
#endif
}

/* a - b - *borrow = result - 2^64 *borrow; borrow 0 or 1. */
static inline limb_t limb_sub(limb_t a, limb_t b, limb_t *borrow)
{
#if LIMB_CARRY_FLAG
    unsigned long long d;
    *borrow = _subborrow_u64((unsigned char)*borrow, a, b, &d);
    return d;
#else
    limb_t d = a - b, e = d - *borrow;
    *borrow = (limb_t)(a < b) | (limb_t)(d < *borrow);
    return e;
#endif
}

/* a b = result + 2^64 *high. */
static inline limb_t limb_mul(limb_t *high, limb_t a, limb_t b)
{
#if LIMB_INT128
    limb_pair_t t = (limb_pair_t)a * b;
    *high = (limb_t)(t >> 64);
    return (limb_t)t;
#else
    limb_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    limb_t low = a0 * b0, m1 = a0 * b1, m2 = a1 * b0;
    /* < 3 (2^32 - 1): no overflow */
    limb_t middle = (low >> 32) + (uint32_t)m1 + (uint32_t)m2;
    *high = a1 * b1 + (m1 >> 32) + (m2 >> 32) + (middle >> 32);
    return (middle << 32) | (uint32_t)low;
#endif
}

/* a b + c + *carry = result + 2^64 *carry, which is at most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1. */
static inline limb_t limb_muladd(limb_t a, limb_t b, limb_t c, limb_t *carry)
{
#if LIMB_INT128
    limb_pair_t t = (limb_pair_t)a * b + c + *carry;
    *carry = (limb_t)(t >> 64);
    return (limb_t)t;
#else
    limb_t high, low = limb_mul(&high, a, b);
    low += c;
    high += low < c;
    low += *carry;
    high += low < *carry;
    *carry = high;
    return low;
#endif
}

#if !LIMB_INT128
limb_t limb_div_portable(limb_t *remainder, limb_t high, limb_t low, limb_t d); /* limb.c */
#endif

/* (high, low) / d = quotient, remainder; high < d. */
static inline limb_t limb_div(limb_t *remainder, limb_t high, limb_t low, limb_t d)
{
#if LIMB_INT128 && defined(__x86_64__)
    limb_t q, r;
    __asm__("divq %4" : "=a"(q), "=d"(r) : "0"(low), "1"(high), "rm"(d) : "cc");
    *remainder = r;
    return q;
#elif LIMB_INT128
    limb_pair_t t = ((limb_pair_t)high << 64) | low;
    *remainder = (limb_t)(t % d);
    return (limb_t)(t / d);
#else
    return limb_div_portable(remainder, high, low, d);
#endif
}

/* ---- simple operations ---- */

void limb_zero(limb_t *z, size_t n);
void limb_copy(limb_t *z, const limb_t *a, size_t n);     /* any overlap */
size_t limb_normal(const limb_t *a, size_t n);            /* n without high zero limbs */
int limb_compare(const limb_t *a, const limb_t *b, size_t n);
size_t limb_bit_length(const limb_t *a, size_t n);        /* least k with number < 2^k */
size_t limb_trailing_zeros(const limb_t *a, size_t n);    /* number != 0 */
bool limb_low_bits_zero(const limb_t *a, size_t n, size_t bits); /* does 2^bits divide the number? */

/* z = a + b, n limbs each; the answer is the carry.  z = a - b; the answer is the borrow. */
limb_t limb_add_n(limb_t *z, const limb_t *a, const limb_t *b, size_t n);
limb_t limb_sub_n(limb_t *z, const limb_t *a, const limb_t *b, size_t n);
/* The same with a longer first operand: na >= nb; z has na limbs. */
limb_t limb_add_any(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb);
limb_t limb_sub_any(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb);
/* z = a + c, z = a - c for a word c. */
limb_t limb_add_1(limb_t *z, const limb_t *a, size_t n, limb_t c);
limb_t limb_sub_1(limb_t *z, const limb_t *a, size_t n, limb_t c);
/* z = a b, z += a b, z -= a b for a word b; the answer is the high limb (the borrow). */
limb_t limb_mul_1(limb_t *z, const limb_t *a, size_t n, limb_t b);
limb_t limb_addmul_1(limb_t *z, const limb_t *a, size_t n, limb_t b);
limb_t limb_submul_1(limb_t *z, const limb_t *a, size_t n, limb_t b);
/* z = a 2^s, 0 <= s < 64; the answer is the limb shifted out.  z >= a may overlap. */
limb_t limb_shift_left(limb_t *z, const limb_t *a, size_t n, unsigned s);
/* z = floor(a / 2^s), 0 <= s < 64; the answer holds the bits shifted out, at its top.  z <= a may overlap. */
limb_t limb_shift_right(limb_t *z, const limb_t *a, size_t n, unsigned s);
/* z = a / d, the answer is the remainder; d != 0. */
limb_t limb_divrem_1(limb_t *z, const limb_t *a, size_t n, limb_t d);

/* ---- multiplication (limb_mul.c): z has na + nb limbs and must not overlap a or b ---- */

/* na >= nb >= 1.  Schoolbook below LIMB_KARATSUBA limbs, Karatsuba above; false = no memory. */
bool limb_multiply(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb);
bool limb_square(limb_t *z, const limb_t *a, size_t n);
/* Never allocates: quadratic time. */
void limb_multiply_basecase(limb_t *z, const limb_t *a, size_t na, const limb_t *b, size_t nb);
void limb_square_basecase(limb_t *z, const limb_t *a, size_t n);
/* z = a b / 2^(64 (n - 2)), n + 2 limbs, too small by at most (n - 2) 2^64; n >= 2, both have n limbs. */
void limb_multiply_high(limb_t *z, const limb_t *a, const limb_t *b, size_t n);

/* ---- division (limb_div.c) ---- */

/* a = q b + r.  na >= nb >= 1, b[nb - 1] != 0.  q has na - nb + 1 limbs, r has nb limbs; q or r may be NULL.
   Outputs may not overlap inputs or each other.  False = no memory. */
bool limb_divide(limb_t *q, limb_t *r, const limb_t *a, size_t na, const limb_t *b, size_t nb);

/* ---- root (limb_sqrt.c) ---- */

/* s = floor(sqrt(a)), r = a - s^2.  a has 2 n limbs, a[2 n - 1] >= 2^62; s has n limbs, r has n + 1 limbs.
   a is destroyed.  False = no memory. */
bool limb_sqrt_rem(limb_t *s, limb_t *r, limb_t *a, size_t n);

#endif
