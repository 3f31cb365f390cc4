/* fraction_cos.c: cosine and sine of an angle in fixed point.

   The angle is halved r times to y, the versine v = 1 - cos y is found by its series and doubled r times by
   1 - cos 2a = 2 v (2 - v); then cos x = 1 - v and sin x = sqrt(v (2 - v)).  Small angles need no halving, and their
   sine has its own series.  The bounds: errors-trig.md, "Versines" and "Sines". */
#include "fraction.h"

/* Chosen for speed: a halving costs a square, and saves 2 bits in each factor z of the series.  The proofs ask for at
   least 6, so that z < 2^-12, and n / 256, so that the series has no more than 2^13 terms. */
size_t fraction_halvings(size_t n) { return n < 64 ? 6 + n / 8 : n < 4000 ? 13 + n / 64 : 60 + n / 256; }

/* v = 4 v - 2 floor(v^2), with an integer part (0 or 1), which is lost unless it is the last time */
static bool double_versine(limb_t *v, size_t n, limb_t *p)
{
    if (!limb_square(p, v, n))
        return false;
    limb_shift_left(v, v, n, 1);
    limb_sub_n(v, v, p + n, n);
    v[n] = limb_shift_left(v, v, n, 1);
    return true;
}

/* v = 1 - cos x, n + 1 limbs, within *err 4^r ulp, *k = 2 r; x < 1.58. */
static bool versine(limb_t *v, limb_t *err, int64_t *k, const angle *x, limb_t *p)
{
    size_t n = x->n, zeros = angle_zeros(x), halvings = fraction_halvings(n);
    size_t r = zeros < halvings ? halvings - zeros : 0;
    limb_t *z = p + 2 * n;
    if (x->w[n]) /* an angle above 1 */
        r = halvings + 1;
    fraction_shift_right(p, x->w, n + 1, r);
    limb_copy(v, p, n);
    if (!fraction_square(z, v, n, p) || !fraction_series(v, err, z, n, 1))
        return false;
    if (v[n]) /* the sum is 1, or above by roundings only */
        limb_zero(v, n + 1);
    else {
        limb_zero(p, n);
        limb_sub_n(v, p, v, n); /* 1 - cos y */
    }
    for (size_t i = 0; i < r; i++)
        if (!double_versine(v, n, p))
            return false;
    *err += 2 + x->wrong; /* ROUNDING (hidden by the series): the squares, 2/3; the angle, 1/2 + wrong */
    *k = 2 * (int64_t)r;
    return true;
}

static void cosine_from_versine(draft *c, const limb_t *v, size_t n)
{
    c->negative = v[n] && limb_normal(v, n);
    if (v[n]) { /* cos = -(v - 1) */
        limb_copy(c->w, v, n);
        c->w[n] = 0;
    } else {
        limb_zero(c->w, n + 1);
        c->w[n] = 1 - limb_sub_n(c->w, c->w, v, n);
    }
}

bool fraction_cos(draft *c, const angle *x)
{
    ball_scratch space;
    limb_t *v = ball_scratch_new(&space, 4 * x->n + 1);
    bool ok = v && versine(v, &c->err, &c->k, x, v + x->n + 1);
    if (ok)
        cosine_from_versine(c, v, x->n);
    ball_scratch_free(&space);
    return ok;
}

/* sin x = x - x (1 - sin(x) / x) */
bool fraction_sin_small(draft *s, const angle *x)
{
    size_t n = x->n;
    ball_scratch space;
    limb_t *g = ball_scratch_new(&space, 4 * n + 1), *p = g ? g + n + 1 : NULL;
    bool ok = g && fraction_square(p + 2 * n, x->w, n, p) && fraction_series(g, &s->err, p + 2 * n, n, 2);
    if (ok) {
        limb_copy(s->w, x->w, n + 1);
        if (!g[n]) {
            limb_zero(p, n);
            limb_sub_n(g, p, g, n);
            ok = fraction_mul(g, g, x->w, n, p);
            limb_sub_n(s->w, s->w, g, n);
        }
        s->negative = false;
        size_t zeros = angle_zeros(x);
        /* ROUNDING: the series times x < 2^-zeros, rounded up, the product, the angle */
        s->err = (s->err >> (zeros < 63 ? zeros : 63)) + 3 + x->wrong;
        s->k = 0;
    }
    ball_scratch_free(&space);
    return ok;
}

/* s = floor(sqrt(w)) for 0 < w < 1 in p[n ... 2 n - 1]; p has 5 n + 1 limbs of space. */
static bool root(limb_t *s, size_t n, limb_t *p)
{
    const limb_t *w = p + n;
    limb_zero(p, n);
    size_t zeros = 64 * n - limb_bit_length(w, n), even = zeros & ~(size_t)1, down = even / 2;
    limb_t *a = p + 2 * n, *r = a + 2 * n;
    limb_zero(a, even / 64);
    limb_shift_left(a + even / 64, p, 2 * n - even / 64, (unsigned)(even % 64));
    if (!limb_sqrt_rem(s, r, a, n))
        return false;
    fraction_shift_right(s, s, n, down);
    return true;
}

static bool sine_from_versine(draft *s, const draft *c, const limb_t *v, size_t n, size_t zeros, limb_t *p)
{
    if (!limb_square(p, v, n))
        return false;
    limb_sub_n(p + n, v, p + n, n); /* w = 2 v - floor(v^2) < 1: the borrow and the carry cancel */
    limb_add_n(p + n, p + n, v, n);
    s->w[n] = 0;
    s->negative = false;
    s->err = c->err + c->err / 4 + 1; /* ROUNDING: |dw| / sqrt(w) and the floor, see "Sines" */
    s->k = c->k + (int64_t)zeros + 2;
    return root(s->w, n, p);
}

bool fraction_sin_cos(draft *s, draft *c, const angle *x)
{
    size_t n = x->n, zeros = angle_zeros(x);
    if (zeros >= fraction_halvings(n))
        return fraction_cos(c, x) && fraction_sin_small(s, x);
    ball_scratch space;
    limb_t *v = ball_scratch_new(&space, 6 * n + 2), *p = v ? v + n + 1 : NULL;
    bool ok = v && versine(v, &c->err, &c->k, x, p) && sine_from_versine(s, c, v, n, zeros, p);
    if (ok)
        cosine_from_versine(c, v, n);
    ball_scratch_free(&space);
    return ok;
}
