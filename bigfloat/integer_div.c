/* integer_div.c: quotients, common divisors and roots of integers. */
#include <stdlib.h>

#include "integer.h"
#include "integer_internal.h"

/* Truncated division: |x| = q |y| + r, signs of x / y on q and of x on r.  q and r are not x or y. */
static bool divide_truncated(integer *q, integer *r, const integer *x, const integer *y)
{
    size_t m = (size_t)integer_length(x), n = (size_t)integer_length(y);
    if (m < n) {
        integer_zero(q);
        return integer_set(r, x);
    }
    limb_t *pq = integer_fresh(q, m - n + 1), *pr = integer_fresh(r, n);
    if (!pq || !pr || !limb_divide(pq, pr, integer_limbs(x), m, integer_limbs(y), n))
        return false;
    integer_finish(q, m - n + 1, (x->size < 0) != (y->size < 0));
    integer_finish(r, n, x->size < 0);
    return true;
}

bool integer_fdiv_qr(integer *q, integer *r, const integer *x, const integer *y)
{
    integer s, t;
    integer_init(&s);
    integer_init(&t);
    bool ok = divide_truncated(&s, &t, x, y);
    if (ok && t.size && (t.size < 0) != (y->size < 0)) /* the truncated quotient is one above the floor */
        ok = integer_add_si(&s, &s, -1) && integer_add(&t, &t, y);
    if (ok && q)
        integer_swap(q, &s);
    if (ok && r)
        integer_swap(r, &t);
    integer_clear(&s);
    integer_clear(&t);
    return ok;
}

bool integer_fdiv_q(integer *q, const integer *x, const integer *y) { return integer_fdiv_qr(q, NULL, x, y); }

bool integer_cdiv_q(integer *q, const integer *x, const integer *y)
{
    integer s, t;
    integer_init(&s);
    integer_init(&t);
    bool ok = divide_truncated(&s, &t, x, y);
    if (ok && t.size && (t.size < 0) == (y->size < 0))
        ok = integer_add_si(&s, &s, 1);
    if (ok)
        integer_swap(q, &s);
    integer_clear(&s);
    integer_clear(&t);
    return ok;
}

bool integer_divexact(integer *q, const integer *x, const integer *y) { return integer_fdiv_q(q, x, y); }

/* ---- greatest common divisor ---- */

static uint64_t gcd_words(uint64_t a, uint64_t b)
{
    if (a == 0 || b == 0)
        return a | b;
    int shift = limb_ctz(a | b);
    a >>= limb_ctz(a);
    while (b) {
        b >>= limb_ctz(b);
        if (a > b) {
            uint64_t t = a;
            a = b;
            b = t;
        }
        b -= a;
    }
    return a << shift;
}

/* The 64 bits of |x| from bit position `low` on. */
static uint64_t bits_from(const integer *x, size_t low)
{
    size_t i = low / 64, n = (size_t)integer_length(x);
    unsigned s = low % 64;
    const limb_t *a = integer_limbs(x);
    uint64_t v = i < n ? a[i] >> s : 0;
    return s && i + 1 < n ? v | a[i + 1] << (64 - s) : v;
}

/* Lehmer's step.  u >= v are the leading 62 bits of a and b at one scale.  The rows (A B; C D) of cofactors,
   applied to (a, b), make the same Euclidean steps as long as the quotient of (u + A) by (v + C) agrees with
   that of (u + B) by (v + D) (Knuth 4.5.2, Algorithm L).  False: not one step could be made. */
static bool lehmer_cofactors(int64_t c[4], int64_t u, int64_t v)
{
    int64_t A = 1, B = 0, C = 0, D = 1;
    while (v + C != 0 && v + D != 0) {
        int64_t q = (u + A) / (v + C);
        if (q != (u + B) / (v + D) || q > INT32_MAX)
            break;
        int64_t t = A - q * C;
        A = C, C = t;
        t = B - q * D;
        B = D, D = t;
        t = u - q * v;
        u = v, v = t;
        if (C > INT32_MAX || C < -INT32_MAX || D > INT32_MAX || D < -INT32_MAX) /* products stay in range */
            break;
    }
    c[0] = A, c[1] = B, c[2] = C, c[3] = D;
    return B != 0;
}

/* (a, b) = (A a + B b, C a + D b) */
static bool apply_cofactors(integer *a, integer *b, const int64_t c[4], integer *s, integer *t)
{
    return integer_mul_si(s, a, c[0]) && integer_mul_si(t, b, c[1]) && integer_add(s, s, t)
           && integer_mul_si(a, a, c[2]) && integer_mul_si(b, b, c[3]) && integer_add(b, a, b)
           && (integer_swap(a, s), true);
}

static bool gcd_step(integer *a, integer *b, integer *s, integer *t)
{
    int64_t c[4];
    size_t low = integer_bits(a) - 62;
    if (lehmer_cofactors(c, (int64_t)bits_from(a, low), (int64_t)(bits_from(b, low))))
        return apply_cofactors(a, b, c, s, t);
    return integer_fdiv_qr(NULL, s, a, b) && (integer_swap(a, b), integer_swap(b, s), true);
}

bool integer_gcd(integer *z, const integer *x, const integer *y)
{
    integer a, b, s, t;
    integer_init(&a);
    integer_init(&b);
    integer_init(&s);
    integer_init(&t);
    bool ok = integer_abs(&a, x) && integer_abs(&b, y);
    if (ok && integer_cmp(&a, &b) < 0)
        integer_swap(&a, &b);
    while (ok && integer_length(&a) > 1 && b.size)
        ok = gcd_step(&a, &b, &s, &t);
    if (ok && b.size == 0)
        integer_swap(z, &a);
    else if (ok)
        integer_set_ui(z, gcd_words(integer_limbs(&a)[0], integer_limbs(&b)[0]));
    integer_clear(&a);
    integer_clear(&b);
    integer_clear(&s);
    integer_clear(&t);
    return ok;
}

/* ---- square root ---- */

/* x is scaled by an even power of two so that it has 2 n limbs and its top bit or the one below is set:
   4^k x = s^2 + r with s = floor(sqrt(4^k x)), and floor(sqrt(x)) = floor(s / 2^k). */
bool integer_sqrt(integer *z, const integer *x)
{
    size_t m = (size_t)integer_length(x);
    if (m == 0) {
        integer_zero(z);
        return true;
    }
    size_t n = (m + 1) / 2, scale = (128 * n - integer_bits(x)) / 2;
    limb_t *space = malloc((4 * n + 1) * sizeof *space);
    if (!space)
        return false;
    limb_t *a = space, *s = a + 2 * n, *r = s + n;
    limb_zero(a, 2 * n);
    size_t whole = 2 * scale / 64;
    limb_t out = limb_shift_left(a + whole, integer_limbs(x), m, (2 * scale) % 64);
    if (whole + m < 2 * n)
        a[whole + m] = out;
    bool ok = limb_sqrt_rem(s, r, a, n) && integer_set_limbs(z, s, n, false) && integer_fdiv_2exp(z, z, scale);
    free(space);
    return ok;
}

bool integer_sqrt_rem(integer *z, integer *r, const integer *x)
{
    integer s, t;
    integer_init(&s);
    integer_init(&t);
    bool ok = integer_sqrt(&s, x) && integer_sqr(&t, &s) && integer_sub(&t, x, &t);
    if (ok)
        integer_swap(z, &s);
    if (ok && r)
        integer_swap(r, &t);
    integer_clear(&s);
    integer_clear(&t);
    return ok;
}
