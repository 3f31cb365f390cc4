/* grid_mul.c: products on the grid: exact endpoint products, then one floor and one ceiling. */
#include "grid.h"
#include "grid_internal.h"

/* m in units of 2^-2g goes to units of 2^-g, floor or ceiling. */
static bool rescale(integer *z, const integer *m, long g, bool up)
{
    if (g < 0)
        return integer_mul_2exp(z, m, (unsigned long)-g);
    return up ? integer_cdiv_2exp(z, m, (unsigned long)g) : integer_fdiv_2exp(z, m, (unsigned long)g);
}

/* *low and *high: the least and the greatest of the products of x's endpoints by y's. */
static bool product_range(integer *low, integer *high, const grid *x, const grid *y)
{
    integer t;
    integer_init(&t);
    bool ok = integer_mul(low, &x->lower, &y->lower) && integer_set(high, low);
    const integer *p[3] = {&x->lower, &x->upper, &x->upper}, *q[3] = {&y->upper, &y->lower, &y->upper};
    for (int i = 0; ok && i < 3; i++) {
        ok = integer_mul(&t, p[i], q[i]);
        if (ok && integer_cmp(&t, low) < 0)
            ok = integer_set(low, &t);
        else if (ok && integer_cmp(&t, high) > 0)
            ok = integer_set(high, &t);
    }
    integer_clear(&t);
    return ok;
}

static void mul_any(grid *z, const grid *x, const grid *y, long g)
{
    integer low, high;
    integer_init(&low);
    integer_init(&high);
    bool ok = product_range(&low, &high, x, y) && rescale(&z->lower, &low, g, false) && rescale(&z->upper, &high, g, true);
    integer_clear(&low);
    integer_clear(&high);
    grid_finish(z, g, ok);
}

/* ---- short endpoints, below 2^126 in absolute value, with 0 <= g < 128 ---- */

/* +-w, four limbs */
typedef struct {
    limb_t w[4];
    bool negative;
} wide;

static inline wide short_product(const integer *p, const integer *q)
{
    const limb_t *a = p->at.inline_limbs, *b = q->at.inline_limbs;
    wide z = {{0, 0, 0, 0}, (p->size ^ q->size) < 0};
    z.w[0] = limb_mul(&z.w[1], a[0], b[0]);
    if (a[1] | b[1]) {
        limb_t carry = 0, h1, h2, l1 = limb_mul(&h1, a[0], b[1]), l2 = limb_mul(&h2, a[1], b[0]);
        limb_t l3 = limb_mul(&z.w[3], a[1], b[1]);
        z.w[1] = limb_add(z.w[1], l1, &carry);
        z.w[2] = limb_add(h1, h2, &carry); /* h1 + h2 + 1 <= 2^63: h1, h2 < 2^62 */
        carry = 0;
        z.w[1] = limb_add(z.w[1], l2, &carry);
        z.w[2] = limb_add(z.w[2], l3, &carry);
        z.w[3] += carry;
    }
    return z;
}

static inline int compare_wide(const wide *x, const wide *y)
{
    if (x->negative != y->negative) /* of two zeros the sign does not matter */
        return x->negative ? -1 : 1;
    int c = limb_compare(x->w, y->w, 4);
    return x->negative ? -c : c;
}

/* *high 2^64 + *low = |x| 2^-g, floor or ceiling of +-; false if it does not fit 126 bits. */
static inline bool shift_wide(limb_t *low, limb_t *high, const wide *x, unsigned g, bool up)
{
    limb_t w0 = x->w[0], w1 = x->w[1], w2 = x->w[2], w3 = x->w[3], lost = 0;
    if (g >= 64) {
        lost = w0;
        w0 = w1, w1 = w2, w2 = w3, w3 = 0;
        g -= 64;
    }
    if (g) {
        lost |= w0 << (64 - g);
        w0 = w0 >> g | w1 << (64 - g);
        w1 = w1 >> g | w2 << (64 - g);
        w2 = w2 >> g | w3 << (64 - g);
        w3 >>= g;
    }
    if (w3 | w2 | w1 >> 62)
        return false;
    bool away = lost != 0 && x->negative != up; /* floor moves negative numbers away from 0, ceiling positive */
    *low = w0 + away;
    *high = w1 + (away && *low == 0);
    return true;
}

static inline void set_short(integer *z, limb_t low, limb_t high, bool negative)
{
    if (z->capacity)
        integer_clear(z);
    int32_t n = high ? 2 : low != 0;
    z->at.inline_limbs[0] = low;
    z->at.inline_limbs[1] = high;
    z->size = negative ? -n : n;
}

static inline bool is_short(const grid *x) { return integer_is_short(&x->lower) && integer_is_short(&x->upper); }

/* False, and z unchanged, if an endpoint of the result is not short.  The signs of the endpoints decide which
   two of the four products are the least and the greatest, unless 0 is inside both operands. */
static bool mul_short(grid *z, const grid *x, const grid *y, unsigned g)
{
    const integer *a = &x->lower, *b = &x->upper, *c = &y->lower, *d = &y->upper;
    wide low, high;
    if (a->size >= 0) {
        low = short_product(c->size >= 0 ? a : b, c);
        high = short_product(d->size >= 0 ? b : a, d);
    } else if (b->size <= 0) {
        low = short_product(d->size >= 0 ? a : b, d);
        high = short_product(c->size >= 0 ? b : a, c);
    } else if (c->size >= 0) {
        low = short_product(a, d);
        high = short_product(b, d);
    } else if (d->size <= 0) {
        low = short_product(b, c);
        high = short_product(a, c);
    } else {
        wide t = short_product(a, d), u = short_product(a, c);
        low = short_product(b, c);
        high = short_product(b, d);
        if (compare_wide(&t, &low) < 0)
            low = t;
        if (compare_wide(&u, &high) > 0)
            high = u;
    }
    limb_t l0, l1, h0, h1;
    if (!shift_wide(&l0, &l1, &low, g, false) || !shift_wide(&h0, &h1, &high, g, true))
        return false;
    set_short(&z->lower, l0, l1, low.negative);
    set_short(&z->upper, h0, h1, high.negative);
    grid_finish(z, (long)g, true);
    return true;
}

#if LIMB_INT128
/* ---- endpoints of one word, below 2^63, with 0 <= g <= 64 ---- */

static inline bool are_words(const grid *x, const grid *y)
{
    return !(x->lower.capacity | x->upper.capacity | y->lower.capacity | y->upper.capacity)
           && !(x->lower.at.inline_limbs[1] | x->upper.at.inline_limbs[1] | y->lower.at.inline_limbs[1]
                | y->upper.at.inline_limbs[1])
           && !((x->lower.at.inline_limbs[0] | x->upper.at.inline_limbs[0] | y->lower.at.inline_limbs[0]
                 | y->upper.at.inline_limbs[0]) >> 63);
}

static inline int64_t word(const integer *x)
{
    int64_t sign = x->size >> 31; /* 0 or -1 */
    return ((int64_t)x->at.inline_limbs[0] ^ sign) - sign;
}

/* min(u - v, 0) for |u|, |v| <= 2^126, without a branch: min(u, v) = v + that, max(u, v) = u - that. */
static inline limb_signed_pair_t excess(limb_signed_pair_t u, limb_signed_pair_t v)
{
    limb_signed_pair_t d = u - v;
    return d & (d >> 127);
}

/* *lower and *upper: the product in grid units.  All four products, below 2^126, are compared as they are. */
static inline void product_words(limb_signed_pair_t *lower, limb_signed_pair_t *upper, const grid *x, const grid *y,
                                 unsigned g)
{
    int64_t a = word(&x->lower), b = word(&x->upper), c = word(&y->lower), d = word(&y->upper);
    limb_signed_pair_t ac = (limb_signed_pair_t)a * c, ad = (limb_signed_pair_t)a * d;
    limb_signed_pair_t bc = (limb_signed_pair_t)b * c, bd = (limb_signed_pair_t)b * d;
    limb_signed_pair_t low = ac + excess(ad, ac), high = ad - excess(ad, ac);
    limb_signed_pair_t low2 = bc + excess(bd, bc), high2 = bd - excess(bd, bc);
    low += excess(low2, low);
    high -= excess(high, high2);
    *lower = low >> g; /* arithmetic shift: floor */
    *upper = -(-high >> g);
}

/* ---- endpoints below 2^95, with g = 64: what a product loses is its lowest limb ---- */

static inline bool are_middling(const grid *x, const grid *y)
{
    return !(x->lower.capacity | x->upper.capacity | y->lower.capacity | y->upper.capacity)
           && !((x->lower.at.inline_limbs[1] | x->upper.at.inline_limbs[1] | y->lower.at.inline_limbs[1]
                 | y->upper.at.inline_limbs[1]) >> 31);
}

/* floor(p q / 2^64), or the ceiling; |p q| < 2^190.  With p = p1 2^64 + p0, q alike, 0 <= p0, q0 < 2^64, it is p1 q1 2^64 + p1 q0 + p0 q1
   and what p0 q0 carries; the sum, below 2^126, is right although its terms are computed modulo 2^128. */
static inline limb_signed_pair_t middling_product(limb_signed_pair_t p, limb_signed_pair_t q, bool up)
{
    limb_t p0 = (limb_t)p, q0 = (limb_t)q, p1 = (limb_t)(p >> 64), q1 = (limb_t)(q >> 64);
    limb_pair_t low = (limb_pair_t)p0 * q0, cross = (limb_pair_t)p1 * q0, other = (limb_pair_t)p0 * q1;
    limb_t high = p1 * q1 - (p < 0 ? q0 : 0) - (q < 0 ? p0 : 0); /* -1 as a limb is 2^64 - 1: 2^64 too much */
    limb_pair_t sum = cross + other + (low >> 64) + ((limb_pair_t)high << 64) + (up && (limb_t)low != 0);
    return (limb_signed_pair_t)sum;
}

/* As product_words, unless both x and y contain 0 inside: false. */
static inline bool product_middling(limb_signed_pair_t *lower, limb_signed_pair_t *upper, const grid *x, const grid *y)
{
    limb_signed_pair_t a = integer_get_pair(&x->lower), b = integer_get_pair(&x->upper);
    limb_signed_pair_t c = integer_get_pair(&y->lower), d = integer_get_pair(&y->upper);
    if (a >= 0) {
        *lower = middling_product(c >= 0 ? a : b, c, false);
        *upper = middling_product(d >= 0 ? b : a, d, true);
    } else if (b <= 0) {
        *lower = middling_product(d >= 0 ? a : b, d, false);
        *upper = middling_product(c >= 0 ? b : a, c, true);
    } else if (c >= 0) {
        *lower = middling_product(a, d, false);
        *upper = middling_product(b, d, true);
    } else if (d <= 0) {
        *lower = middling_product(b, c, false);
        *upper = middling_product(a, c, true);
    } else {
        return false;
    }
    return true;
}

/* *lower and *upper: the product in grid units, below 2^126; false: not here. */
static inline bool product_short(limb_signed_pair_t *lower, limb_signed_pair_t *upper, const grid *x, const grid *y, long g)
{
    if (!grid_ready(x, g) || !grid_ready(y, g))
        return false;
    if (g >= 0 && g <= 64 && are_words(x, y)) {
        product_words(lower, upper, x, y, (unsigned)g);
        return true;
    }
    return g == 64 && are_middling(x, y) && product_middling(lower, upper, x, y);
}

/* z += p (z -= p, if `subtract`), p = [lower, upper]; all short */
static inline void accumulate(grid *z, limb_signed_pair_t lower, limb_signed_pair_t upper, long g, bool subtract)
{
    integer_set_pair(&z->lower, integer_get_pair(&z->lower) + (subtract ? -upper : lower));
    integer_set_pair(&z->upper, integer_get_pair(&z->upper) + (subtract ? -lower : upper));
    grid_finish(z, g, true);
}
#endif

void grid_mul(grid *z, const grid *x, const grid *y, long prec)
{
#if LIMB_INT128
    limb_signed_pair_t lower, upper;
    if (product_short(&lower, &upper, x, y, prec)) {
        integer_set_pair(&z->lower, lower);
        integer_set_pair(&z->upper, upper);
        grid_finish(z, prec, true);
        return;
    }
#endif
    if (!grid_ready(x, prec) || !grid_ready(y, prec) || !grid_exponent_ok(prec))
        grid_on_grid(z, x, y, prec, mul_any);
    else if (prec < 0 || prec >= 128 || !is_short(x) || !is_short(y) || !mul_short(z, x, y, (unsigned)prec))
        mul_any(z, x, y, prec);
}

void grid_sqr(grid *z, const grid *x, long prec)
{
    grid t;
    grid_init(&t);
    grid_abs(&t, x);
    grid_mul(z, &t, &t, prec);
    grid_clear(&t);
}

void grid_addmul(grid *z, const grid *x, const grid *y, long prec)
{
#if LIMB_INT128
    limb_signed_pair_t lower, upper;
    if (grid_ready(z, prec) && is_short(z) && product_short(&lower, &upper, x, y, prec)) {
        accumulate(z, lower, upper, prec, false);
        return;
    }
#endif
    grid t;
    grid_init(&t);
    grid_mul(&t, x, y, prec);
    grid_add(z, z, &t, prec);
    grid_clear(&t);
}

void grid_submul(grid *z, const grid *x, const grid *y, long prec)
{
#if LIMB_INT128
    limb_signed_pair_t lower, upper;
    if (grid_ready(z, prec) && is_short(z) && product_short(&lower, &upper, x, y, prec)) {
        accumulate(z, lower, upper, prec, true);
        return;
    }
#endif
    grid t;
    grid_init(&t);
    grid_mul(&t, x, y, prec);
    grid_sub(z, z, &t, prec);
    grid_clear(&t);
}

void grid_mul_si(grid *z, const grid *x, long v, long prec)
{
    if (!grid_move(z, x, prec))
        return;
    if (v < 0)
        integer_swap(&z->lower, &z->upper);
    grid_finish(z, prec, integer_mul_si(&z->lower, &z->lower, v) && integer_mul_si(&z->upper, &z->upper, v));
}

/* Moving x, whose endpoints count units of 2^-h, as if they counted units of 2^-(h - e). */
void grid_mul_2exp(grid *z, const grid *x, long e, long prec)
{
    if (e > 2 * GRID_MAX_EXPONENT || e < -2 * GRID_MAX_EXPONENT) {
        long half = e > 0 ? 2 * GRID_MAX_EXPONENT : -2 * GRID_MAX_EXPONENT;
        /* beyond: 0 stays 0; small numbers become [-1, 0], [0, 1], [-1, 1] units; large ones the whole line */
        if (e > 0 && grid_is_finite(x) && grid_is_zero(x) != TRUTH_TRUE) {
            grid_indeterminate(z);
            return;
        }
        e = half;
    }
    grid_set(z, x);
    if (grid_is_finite(z)) {
        z->exponent = (int32_t)(z->exponent - e);
        (void)grid_move(z, z, prec);
    }
}
