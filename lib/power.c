/* power.c: products and class sums of words. */
#include "power.h"

#include <stdlib.h>
#include <string.h>

void power_init(mask_power *z)
{
    memset(z, 0, sizeof *z);
    integer_init(&z->denominator);
    integer_init(&z->total_denominator);
}

void power_clear(mask_power *z)
{
    free(z->entry);
    free(z->term);
    integer_clear(&z->denominator);
    integer_clear(&z->total_denominator);
    power_init(z);
}

/* common = the greatest divisor of the denominator and all coefficients. */
static bool common_divisor(integer *common, const laurent *s)
{
    if (!integer_set(common, &s->denominator))
        return false;
    for (long i = 0; i < s->na * s->nb; i++)
        if (!integer_gcd(common, common, &s->coefficient[i]))
            return false;
    return true;
}

/* t = a coefficient of s as the power counts it. */
static power_status set_coefficient(power_term *t, const mask_power *z, const laurent *s, const integer *coefficient, const integer *common)
{
    power_status status = POWER_OK;
    bool ok;
    integer c, rest;
    integer_init(&c);
    integer_init(&rest);
    ok = z->rounded ? integer_mul_2exp(&c, coefficient, POWER_MASK_BITS) && integer_fdiv_qr(&c, &rest, &c, &s->denominator)
                    : integer_divexact(&c, coefficient, common);
    t->rounded = !integer_is_zero(&rest);
    if (!ok)
        status = POWER_NO_MEMORY;
    else if (integer_bits(&c) > 60)
        status = POWER_TOO_LARGE;
    else
        t->coefficient = integer_get_si(&c);
    integer_clear(&c);
    integer_clear(&rest);
    return status;
}

/* The terms of s, from the least a and b on which it lives; their box becomes the margin. */
static power_status set_terms(mask_power *z, const laurent *s, const integer *common)
{
    laurent_extent e = laurent_get_extent(s);
    power_status status = POWER_OK;
    z->margin_a = e.high[0] - e.low[0] + 1;
    z->margin_b = e.high[1] - e.low[1] + 1;
    z->term = malloc((size_t)z->margin_a * (size_t)z->margin_b * sizeof *z->term);
    if (!z->term)
        return POWER_NO_MEMORY;
    for (long a = 0; status == POWER_OK && a < z->margin_a; a++)
        for (long b = 0; status == POWER_OK && b < z->margin_b; b++) {
            power_term *t = &z->term[z->terms];
            if (laurent_is_zero_at(s, e.low[0] + a, e.low[1] + b))
                continue;
            t->a = a;
            t->b = b;
            status = set_coefficient(t, z, s, laurent_at(s, e.low[0] + a, e.low[1] + b), common);
            z->terms++;
        }
    return status;
}

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

/* The largest sum of |term| over a class modulo 2. */
static power_status set_row_sum(mask_power *z)
{
    int64_t sum[4] = {0, 0, 0, 0};
    int rounded[4] = {0, 0, 0, 0};
    for (int i = 0; i < z->terms; i++) {
        int class = (int)((z->term[i].a & 1) * 2 + (z->term[i].b & 1));
        int64_t c = magnitude(z->term[i].coefficient);
        if (sum[class] > POWER_MAX_SUM - c)
            return POWER_TOO_LARGE;
        sum[class] += c;
        rounded[class] += z->term[i].rounded;
        z->term_row_sum = sum[class] > z->term_row_sum ? sum[class] : z->term_row_sum;
        z->rounded_terms = rounded[class] > z->rounded_terms ? rounded[class] : z->rounded_terms;
    }
    return POWER_OK;
}

/* z gets an array of zeros for a box of na times nb. */
static power_status set_box(mask_power *z, long na, long nb)
{
    int64_t rows = (int64_t)na + 2 * z->margin_a, columns = (int64_t)nb + 2 * z->margin_b;
    if (rows > POWER_MAX_ENTRIES || columns > POWER_MAX_ENTRIES || rows * columns > POWER_MAX_ENTRIES)
        return POWER_TOO_LARGE;
    z->entry = calloc((size_t)(rows * columns), sizeof *z->entry);
    z->na = na;
    z->nb = nb;
    z->stride = (long)columns;
    return z->entry ? POWER_OK : POWER_NO_MEMORY;
}

static int64_t *cell(mask_power *z, long a, long b)
{
    return z->entry + (a + z->margin_a) * z->stride + (b + z->margin_b);
}

power_status power_start(mask_power *z, const laurent *s, bool rounded)
{
    power_status status = POWER_NO_MEMORY;
    integer common;
    z->rounded = rounded;
    integer_init(&common);
    if (common_divisor(&common, s) && integer_divexact(&z->denominator, &s->denominator, &common))
        status = set_terms(z, s, &common);
    integer_clear(&common);
    if (status == POWER_OK)
        status = set_row_sum(z);
    if (status == POWER_OK)
        status = set_box(z, 1, 1);
    if (status != POWER_OK)
        return status;
    z->row_sum = rounded ? (int64_t)1 << POWER_ENTRY_BITS : 1;
    *cell(z, 0, 0) = z->row_sum;
    integer_set_si(&z->total_denominator, z->row_sum);
    return POWER_OK;
}

/* s^(N+1)(z) = s(z) s^N(z^2): the coefficient at x is the sum over terms t with x - t even of t s^N((x - t) / 2).
   One row of the product at a time, so that it stays in the cache. */
static void multiply_row(mask_power *z, const int64_t *old, long old_na, long old_nb, long old_stride, long a)
{
    for (int i = 0; i < z->terms; i++) {
        const power_term *t = &z->term[i];
        long y = a - t->a;
        const int64_t *from;
        int64_t *to = cell(z, a, t->b);
        if (y < 0 || (y & 1) || y / 2 >= old_na)
            continue;
        from = old + (y / 2 + z->margin_a) * old_stride + z->margin_b;
        for (long b = 0; b < old_nb; b++)
            to[2 * b] += t->coefficient * from[b];
    }
}

/* Back to multiples of 2^-POWER_ENTRY_BITS.  Was anything lost? */
static bool round_entries(mask_power *z)
{
    const int64_t unit = (int64_t)1 << POWER_MASK_BITS;
    bool lost = false;
    for (long a = 0; a < z->na; a++) {
        int64_t *row = cell(z, a, 0);
        for (long b = 0; b < z->nb; b++) {
            lost = lost || row[b] % unit != 0;
            row[b] /= unit;
        }
    }
    return lost;
}

/* Let A and A' be the true and the rounded entries, s and s' the masks.  A row of the next power is off by the sum of
   (s - s') A, at most rounded_terms 2^-POWER_MASK_BITS (row_sum + error), of s' (A - A'), at most the row sum of s'
   times the error, and by less than 1 for each of its entries if they were rounded: they are at most
   margin_a * margin_b. */
static void raise_error(mask_power *z, bool lost)
{
    const int64_t unit = (int64_t)1 << POWER_MASK_BITS;
    int64_t products = z->rounded_terms * (z->row_sum + z->error) + z->term_row_sum * z->error;
    z->error = (products + unit - 1) / unit + (lost ? z->margin_a * z->margin_b : 0);
}

/* The numbers in raise_error stay in words, and errors below what they are errors of. */
static bool error_is_harmless(const mask_power *z)
{
    return z->error <= z->row_sum / 4 && z->rounded_terms <= POWER_MAX_SUM / 4 / z->row_sum;
}

power_status power_raise(mask_power *z)
{
    int64_t *old = z->entry;
    long old_na = z->na, old_nb = z->nb, old_stride = z->stride;
    power_status status;
    if ((z->term_row_sum > 0 && z->row_sum > POWER_MAX_SUM / z->term_row_sum) || (double)old_na * (double)old_nb * z->terms > POWER_MAX_WORK || (z->rounded && !error_is_harmless(z)))
        return POWER_TOO_LARGE;
    status = set_box(z, 2 * (old_na - 1) + z->margin_a, 2 * (old_nb - 1) + z->margin_b);
    if (status == POWER_OK)
        for (long a = 0; a < z->na; a++)
            multiply_row(z, old, old_na, old_nb, old_stride, a);
    if (status != POWER_TOO_LARGE) /* then z still has the old array */
        free(old);
    if (status != POWER_OK)
        return status;
    z->exponent++;
    if (z->rounded) {
        raise_error(z, round_entries(z));
        z->row_sum = z->row_sum * z->term_row_sum / ((int64_t)1 << POWER_MASK_BITS) + 1;
        return POWER_OK;
    }
    z->row_sum *= z->term_row_sum;
    return integer_mul(&z->total_denominator, &z->total_denominator, &z->denominator) ? POWER_OK : POWER_NO_MEMORY;
}

/* The largest entry of sum, which is set to 0 behind it. */
static int64_t take_largest(int64_t *sum, long n)
{
    int64_t largest = 0;
    for (long i = 0; i < n; i++) {
        largest = sum[i] > largest ? sum[i] : largest;
        sum[i] = 0;
    }
    return largest;
}

/* sum[j mod n] += |p x[j] - q y[j]|, 0 <= j < length. */
static void add_differences(int64_t *sum, long n, const int64_t *x, const int64_t *y, long length, int64_t p, int64_t q)
{
    for (long j = 0; j < length; j += n) {
        long m = length - j < n ? length - j : n;
        for (long i = 0; i < m; i++)
            sum[i] += magnitude(p * x[j + i] - q * y[j + i]);
    }
}

/* x runs through the positions where s^N(x) or s^N(x + d) may be other than 0. */
bool power_largest_difference(int64_t *sum, const mask_power *z, lattice d, int64_t p, int64_t q)
{
    long n = 1L << z->exponent;
    long low_a = d.a > 0 ? -d.a : 0, high_a = d.a < 0 ? z->na - d.a : z->na;
    long low_b = d.b > 0 ? -d.b : 0, high_b = d.b < 0 ? z->nb - d.b : z->nb;
    int64_t *sums = calloc((size_t)n, sizeof *sums);
    if (!sums)
        return false;
    *sum = 0;
    for (long class = 0; class < n; class++) {
        int64_t largest;
        for (long a = low_a + class; a < high_a; a += n)
            add_differences(sums, n, power_at(z, a, low_b), power_at(z, a + d.a, low_b + d.b), high_b - low_b, p, q);
        largest = take_largest(sums, n);
        *sum = largest > *sum ? largest : *sum;
    }
    *sum += (magnitude(p) + magnitude(q)) * z->error;
    free(sums);
    return true;
}

bool power_norm(rational *norm, const mask_power *z)
{
    int64_t sum;
    integer numerator;
    bool ok = power_largest_difference(&sum, z, (lattice){0, 0}, 1, 0);
    integer_init(&numerator);
    if (ok) {
        integer_set_si(&numerator, sum);
        ok = rational_set_integers(norm, &numerator, &z->total_denominator);
    }
    integer_clear(&numerator);
    return ok;
}
