/* fraction.c: products of fractions. */
#include "fraction.h"

#include "limb_row.h"

/* Above this the whole product, by Karatsuba's method, is faster than half of the schoolbook's. */
#define HIGH_PRODUCT_LIMBS 36

#if LIMB_HAVE_ADX
static void high_product_adx(limb_t *p, const limb_t *a, const limb_t *b, size_t n)
{
    p[2] = limb_mul_1_adx(p, a + n - 2, 2, b[0]);
    for (size_t i = 1; i + 1 < n; i++)
        p[i + 2] = limb_addmul_1_adx(p, a + n - 2 - i, i + 2, b[i]);
    p[n + 1] = limb_addmul_1_adx(p + 1, a, n, b[n - 1]);
}
#endif

/* The columns n - 2 ... 2 n - 1 of a b, as n + 2 limbs: the word products a[i] b[j] with i + j >= n - 2; n >= 2. */
static void high_product(limb_t *p, const limb_t *a, const limb_t *b, size_t n)
{
#if LIMB_HAVE_ADX
    if (limb_processor_has_adx()) {
        high_product_adx(p, a, b, n);
        return;
    }
#endif
    p[2] = limb_mul_1(p, a + n - 2, 2, b[0]);
    for (size_t i = 1; i + 1 < n; i++)
        p[i + 2] = limb_addmul_1(p, a + n - 2 - i, i + 2, b[i]);
    p[n + 1] = limb_addmul_1(p + 1, a, n, b[n - 1]);
}

/* ROUNDING (hidden by what the series counts for a product): the words left out are together below (n - 2) B^(n - 1),
   then less than one ulp B^n is cut: d < 2 ulp. */
bool fraction_mul(limb_t *z, const limb_t *a, const limb_t *b, size_t n, limb_t *p)
{
    if (n >= 4 && n < HIGH_PRODUCT_LIMBS) {
        high_product(p, a, b, n);
        limb_copy(z, p + 2, n);
        return true;
    }
    bool ok = limb_multiply(p, a, n, b, n);
    limb_copy(z, p + n, n);
    return ok;
}

bool fraction_square(limb_t *z, const limb_t *a, size_t n, limb_t *p)
{
    bool ok = limb_square(p, a, n);
    limb_copy(z, p + n, n);
    return ok;
}

void fraction_shift_right(limb_t *z, const limb_t *a, size_t n, size_t s)
{
    size_t whole = s / 64 < n ? s / 64 : n;
    limb_shift_right(z, a + whole, n - whole, (unsigned)(s % 64));
    limb_zero(z + n - whole, whole);
}
