/* fraction_series.c: Taylor's series of the cosine and of sin(y) / y, in z = y^2.

   Rectangular splitting (Paterson and Stockmeyer; Smith): with z, z^2, ..., z^m at hand, the terms of a block of m
   cost one product with a word each, and only from block to block one multiplies by z^m.  The words: terms g, ..., h -
   1 form a group with one denominator, 1/(d_1 ... d_k) = N_k / (d_1 ... d_(h-1)) with N_k = d_(k+1) ... d_(h-1) in one
   word; from group to group one divides by d_g ... d_(h-1).  Terms that come later weigh less and are computed with
   fewer limbs.  m is
   even, and groups end at even terms, so that all that is multiplied by z^m or divided is >= 0. */
#include "fraction.h"

/* No N is greater than this, times d_1 <= 6 at the end, and no group's denominator. */
#define WORD_LIMIT ((limb_t)1 << 60)

static limb_t divisor(limb_t k, limb_t first) { return (2 * k + first - 2) * (2 * k + first - 1); }

/* The number of terms: the first one left out, and so all together, is below one ulp. */
static size_t count_terms(size_t n, size_t zero_bits, limb_t first)
{
    size_t K = 0, bits = 0;
    while (bits < 64 * n)
        bits += zero_bits + (size_t)limb_bits(divisor(++K, first)) - 1;
    return K;
}

/* Even, near sqrt(K). */
static size_t block_length(size_t K)
{
    size_t m = 2;
    while (m * m + m < K)
        m += 2;
    return m;
}

/* Must the group end at k, even?  Yes if N d_k d_(k-1) d_(k-2) does not fit; N d_k does.  The group that fits at k = 4
   goes down to the term 0. */
static bool group_is_full(limb_t N, limb_t k, limb_t first)
{
    if (k < 3)
        return false;
    limb_t limit = WORD_LIMIT / N / divisor(k, first) / divisor(k - 1, first);
    return limit < divisor(k - 2, first);
}

/* z^2, ..., z^m, each less than 3 ulp too low. */
static bool fill_powers(limb_t *power, const limb_t *z, size_t m, size_t n, limb_t *p)
{
    bool ok = true;
    limb_copy(power, z, n);
    for (size_t j = 2; ok && j <= m; j++) {
        limb_t *to = power + (j - 1) * n;
        ok = j % 2 ? fraction_mul(to, power + (j - 2) * n, z, n, p)
                   : fraction_square(to, power + (j / 2 - 1) * n, n, p);
    }
    return ok;
}

/* sum += or -= N z^j, with L limbs of z^j */
static void add_term(limb_t *sum, size_t n, size_t L, const limb_t *power, size_t j, limb_t N, bool minus)
{
    limb_t high = N;
    if (j) {
        const limb_t *a = power + (j - 1) * n + n - L;
        high = minus ? limb_submul_1(sum + n - L, a, L, N) : limb_addmul_1(sum + n - L, a, L, N);
    }
    sum[n] = minus ? sum[n] - high : sum[n] + high;
}

/* sum = sum z^m, with L limbs */
static bool next_block(limb_t *sum, size_t n, size_t L, const limb_t *zm, limb_t *p)
{
    limb_t whole = sum[n], *s = sum + n - L;
    bool ok = fraction_mul(s, s, zm + n - L, L, p);
    sum[n] = 0;
    if (whole)
        sum[n] = limb_addmul_1(s, zm + n - L, L, whole);
    return ok;
}

/* The errors counted here are bounded in errors-trig.md, "Series": L is such that a unit of the limbs in use, B^-L, has
   a weight of at most one ulp in the result. */
static bool sum_terms(limb_t *sum, limb_t *err, const limb_t *power, size_t m, size_t K, size_t n, size_t zero_bits,
                      limb_t first, limb_t *p)
{
    size_t weight = 0; /* the first K - 1 divisors' product is at least 2^weight */
    for (size_t k = 1; k < K; k++)
        weight += (size_t)limb_bits(divisor(k, first)) - 1;
    limb_t N = 1;
    bool ok = true;
    *err = 2; /* ROUNDING (hidden by the terms' cuts): 1 for the rest of the series, 1/2 for z, 1/8 for its powers */
    limb_zero(sum, n + 1);
    for (size_t k = K; ok && k-- > 0;) {
        size_t drop = (k / m * m * zero_bits + weight) / 64, L = drop < n ? n - drop : 1;
        add_term(sum, n, L, power, k % m, N, k % 2 == 1);
        *err += 1; /* ROUNDING (hidden: they are all counted at their worst): z^j cut to L limbs */
        if (k == 0) {
            limb_divrem_1(sum, sum, n + 1, N);
            *err += 1; /* ROUNDING (hidden by the terms' cuts): the quotient */
            break;
        }
        limb_t d = divisor(k, first);
        weight -= (size_t)limb_bits(d) - 1;
        size_t left = k - 1;
        drop = (left / m * m * zero_bits + weight) / 64;
        L = drop < n ? n - drop : 1;
        if (k % m == 0) {
            ok = next_block(sum, n, L, power + (m - 1) * n, p);
            *err += 1; /* ROUNDING (hidden by the terms' cuts): z^m, 1/4; the product, 1/6 */
        }
        if (k % 2 == 0 && group_is_full(N, k, first)) {
            limb_divrem_1(sum + n - L, sum + n - L, L + 1, N * d);
            *err += 1; /* ROUNDING (hidden by the terms' cuts): the quotient */
            N = 1;
        } else
            N *= d;
    }
    return ok;
}

bool fraction_series(limb_t *sum, limb_t *err, const limb_t *z, size_t n, limb_t first)
{
    size_t zero_bits = 64 * n - limb_bit_length(z, n);
    size_t K = count_terms(n, zero_bits, first), m = block_length(K);
    size_t powers = K <= m ? K - 1 : m;
    ball_scratch space;
    limb_t *power = ball_scratch_new(&space, (m + 2) * n + 2);
    bool ok = power != NULL;
    if (ok) {
        limb_t *p = power + m * n;
        ok = fill_powers(power, z, powers, n, p) && sum_terms(sum, err, power, m, K, n, zero_bits, first, p);
    }
    ball_scratch_free(&space);
    return ok;
}
