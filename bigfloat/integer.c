/* integer.c: life, assignment, order, sums and shifts of integers. */
#include "integer.h"

#include <math.h>
#include <stdlib.h>

#include "integer_internal.h"

/* ---- room ---- */

void integer_clear(integer *z)
{
    if (z->capacity)
        free(z->at.heap);
    integer_init(z);
}

static limb_t *grow(integer *z, size_t n, bool keep)
{
    if (n > (size_t)INTEGER_MAX_LIMBS)
        return NULL;
    size_t wanted = n + n / 8 + 2;
    limb_t *heap = malloc(wanted * sizeof *heap);
    if (!heap)
        return NULL;
    if (keep)
        limb_copy(heap, integer_limbs(z), (size_t)integer_length(z));
    if (z->capacity)
        free(z->at.heap);
    z->at.heap = heap;
    z->capacity = (uint32_t)wanted;
    return heap;
}

limb_t *integer_room(integer *z, size_t n)
{
    size_t have = z->capacity ? z->capacity : INTEGER_INLINE_LIMBS;
    return n <= have ? integer_limbs_rw(z) : grow(z, n, true);
}

limb_t *integer_fresh(integer *z, size_t n)
{
    size_t have = z->capacity ? z->capacity : INTEGER_INLINE_LIMBS;
    return n <= have ? integer_limbs_rw(z) : grow(z, n, false);
}

/* ---- assignment ---- */

bool integer_set_limbs(integer *z, const uint64_t *limb, size_t n, bool negative)
{
    n = limb_normal(limb, n);
    limb_t *p = integer_room(z, n); /* limb may be inside z: keep */
    if (!p)
        return false;
    limb_copy(p, limb, n);
    integer_finish(z, n, negative);
    return true;
}

bool integer_set(integer *z, const integer *x)
{
    if (z == x)
        return true;
    if (!z->capacity && !x->capacity) {
        *z = *x;
        return true;
    }
    limb_t *p = integer_fresh(z, (size_t)integer_length(x));
    if (!p)
        return false;
    limb_copy(p, integer_limbs(x), (size_t)integer_length(x));
    integer_finish(z, (size_t)integer_length(x), x->size < 0);
    return true;
}

void integer_zero(integer *z)
{
    integer_finish(z, 0, false);
}

void integer_set_ui(integer *z, uint64_t v)
{
    integer_limbs_rw(z)[0] = v;
    integer_finish(z, 1, false);
}

void integer_set_si(integer *z, int64_t v)
{
    integer_limbs_rw(z)[0] = v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
    integer_finish(z, 1, v < 0);
}

bool integer_neg(integer *z, const integer *x)
{
    if (!integer_set(z, x))
        return false;
    z->size = -z->size;
    return true;
}

bool integer_abs(integer *z, const integer *x)
{
    if (!integer_set(z, x))
        return false;
    z->size = integer_length(z);
    return true;
}

/* ---- inspection ---- */

bool integer_is_one(const integer *x) { return x->size == 1 && integer_limbs(x)[0] == 1; }

int integer_cmp_abs(const integer *x, const integer *y)
{
    int32_t m = integer_length(x), n = integer_length(y);
    if (m != n)
        return m < n ? -1 : 1;
    return limb_compare(integer_limbs(x), integer_limbs(y), (size_t)n);
}

int integer_cmp(const integer *x, const integer *y)
{
#if LIMB_INT128
    if (integer_is_short(x) && integer_is_short(y)) {
        limb_signed_pair_t a = integer_get_pair(x), b = integer_get_pair(y);
        return (a > b) - (a < b);
    }
#endif
    if (x->size != y->size)
        return x->size < y->size ? -1 : 1;
    int c = limb_compare(integer_limbs(x), integer_limbs(y), (size_t)integer_length(x));
    return x->size < 0 ? -c : c;
}

int integer_cmp_si(const integer *x, int64_t v)
{
    integer y;
    integer_init(&y);
    integer_set_si(&y, v);
    return integer_cmp(x, &y);
}

size_t integer_bits(const integer *x) { return limb_bit_length(integer_limbs(x), (size_t)integer_length(x)); }

size_t integer_trailing_zeros(const integer *x)
{
    return x->size ? limb_trailing_zeros(integer_limbs(x), (size_t)integer_length(x)) : 0;
}

bool integer_fits_si(const integer *x)
{
    if (x->size == 0)
        return true;
    limb_t a = integer_limbs(x)[0];
    return (x->size == 1 && a >> 63 == 0) || (x->size == -1 && a <= (limb_t)1 << 63);
}

int64_t integer_get_si(const integer *x)
{
    if (x->size == 0)
        return 0;
    limb_t a = integer_limbs(x)[0];
    return x->size > 0 ? (int64_t)a : -(int64_t)(a - 1) - 1;
}

double integer_get_double_approx(const integer *x)
{
    double v = 0;
    int32_t n = integer_length(x);
    for (int32_t i = n; i-- > 0 && i + 3 >= n;)
        v += ldexp((double)integer_limbs(x)[i], (int)(i < 32 ? 64 * i : 4096));
    return x->size < 0 ? -v : v;
}

/* ---- sums ---- */

/* z = |x| +- |y| with the sign of |x| - |y| turned if `negative`; signs of x and y are ignored. */
static bool add_magnitudes(integer *z, const integer *x, const integer *y, bool negative)
{
    if (integer_length(x) < integer_length(y)) {
        const integer *t = x;
        x = y;
        y = t;
    }
    size_t m = (size_t)integer_length(x), n = (size_t)integer_length(y);
    limb_t *p = integer_room(z, m + 1);
    if (!p)
        return false;
    p[m] = limb_add_any(p, integer_limbs(x), m, integer_limbs(y), n);
    integer_finish(z, m + 1, negative);
    return true;
}

static bool sub_magnitudes(integer *z, const integer *x, const integer *y, bool negative)
{
    int c = integer_cmp_abs(x, y);
    if (c < 0) {
        const integer *t = x;
        x = y;
        y = t;
        negative = !negative;
    }
    size_t m = (size_t)integer_length(x), n = (size_t)integer_length(y);
    limb_t *p = integer_room(z, m);
    if (!p)
        return false;
    limb_sub_any(p, integer_limbs(x), m, integer_limbs(y), n);
    integer_finish(z, m, negative);
    return true;
}

bool integer_add(integer *z, const integer *x, const integer *y)
{
#if LIMB_INT128
    if (integer_is_short(x) && integer_is_short(y)) {
        integer_set_pair(z, integer_get_pair(x) + integer_get_pair(y));
        return true;
    }
#endif
    return (x->size < 0) == (y->size < 0) ? add_magnitudes(z, x, y, x->size < 0)
                                          : sub_magnitudes(z, x, y, x->size < 0);
}

bool integer_sub(integer *z, const integer *x, const integer *y)
{
#if LIMB_INT128
    if (integer_is_short(x) && integer_is_short(y)) {
        integer_set_pair(z, integer_get_pair(x) - integer_get_pair(y));
        return true;
    }
#endif
    return (x->size < 0) != (y->size < 0) ? add_magnitudes(z, x, y, x->size < 0)
                                          : sub_magnitudes(z, x, y, x->size < 0);
}

bool integer_add_si(integer *z, const integer *x, int64_t v)
{
    integer y;
    integer_init(&y);
    integer_set_si(&y, v);
    return integer_add(z, x, &y);
}

/* ---- powers of two ---- */

bool integer_mul_2exp(integer *z, const integer *x, unsigned long n)
{
    size_t whole = n / 64, m = (size_t)integer_length(x);
    if (m == 0) {
        integer_zero(z);
        return true;
    }
#if LIMB_INT128
    if (!x->capacity && n < 126 && integer_bits(x) + n <= 126) {
        integer_set_pair(z, integer_get_pair(x) * ((limb_signed_pair_t)1 << n));
        return true;
    }
#endif
    if (n > (unsigned long)INTEGER_MAX_LIMBS * 64)
        return false;
    bool negative = x->size < 0;
    size_t total = (integer_bits(x) + n + 63) / 64;
    limb_t *p = integer_room(z, total);
    if (!p)
        return false;
    const limb_t *a = integer_limbs(x);
    limb_t out = limb_shift_left(p + whole, a, m, n % 64);
    if (total > m + whole)
        p[total - 1] = out;
    limb_zero(p, whole);
    integer_finish(z, total, negative);
    return true;
}

/* z = floor(x / 2^n) if down, else ceil: the quotient of |x| is raised by one if bits were lost and the
   direction points away from 0. */
static bool div_2exp(integer *z, const integer *x, unsigned long n, bool down)
{
#if LIMB_INT128
    if (integer_is_short(x)) {
        limb_signed_pair_t v = integer_get_pair(x);
        unsigned s = n < 127 ? (unsigned)n : 127;
        integer_set_pair(z, down ? v >> s : -(-v >> s)); /* arithmetic shifts: floors */
        return true;
    }
#endif
    size_t m = (size_t)integer_length(x), whole = n / 64;
    bool negative = x->size < 0, away = negative == down;
    const limb_t *a = integer_limbs(x);
    bool raise = away && m && !limb_low_bits_zero(a, m, n);
    if (whole >= m) {
        integer_set_si(z, raise ? (negative ? -1 : 1) : 0);
        return true;
    }
    size_t k = m - whole;
    limb_t *p = integer_room(z, k);
    if (!p)
        return false;
    a = integer_limbs(x);
    limb_shift_right(p, a + whole, k, n % 64);
    limb_t carry = raise ? limb_add_1(p, p, k, 1) : 0;
    integer_finish(z, k, negative);
    if (!carry)
        return true;
    if (!(p = integer_room(z, k + 1))) /* only when n % 64 == 0 and all limbs were full */
        return false;
    limb_zero(p, k);
    p[k] = 1;
    integer_finish(z, k + 1, negative);
    return true;
}

bool integer_fdiv_2exp(integer *z, const integer *x, unsigned long n) { return div_2exp(z, x, n, true); }
bool integer_cdiv_2exp(integer *z, const integer *x, unsigned long n) { return div_2exp(z, x, n, false); }
