/* ball_trig.c: sine and cosine.

   For the midpoint t of a ball: t = q pi/2 + x with |x| about pi/4 at most, in fixed point of N limbs (units
   ulp = 2^(-64 N)).  The angle is halved r times to y, the versine v = 1 - cos y is summed by Taylor's series
   and doubled r times by 1 - cos 2a = 2 v (2 - v); then cos x = 1 - v, sin x = sqrt(v (2 - v)).  Angles that are
   small anyway need no halving, and their sine has its own series.  The ball's error is added at the end: neither
   function has a derivative above 1.

   The bounds, derived in errors.md ("Sine and cosine"):  series 5 ulp;  after r doublings and with an angle wrong by
   at most a ulp,  E = 7 4^r + a ulp for the cosine and (3 E + 3) 2^(b + 1) ulp for the sine where x >= 2^(-b - 1). */
#include "ball.h"
#include "ball_internal.h"

/* ---- series ---- */

/* h = sum over k >= 1 of (-1)^(k+1) z^k / (d_1 ... d_k), where d_k = (2 k - 1) 2 k for the versine (first = 1) and
   2 k (2 k + 1) for 1 - sin(y) / y (first = 2).  z < 2^-zero_bits.  Horner: h_k = z (1 - h_(k+1)) / d_k.  Since h_k
   enters h with the weight z^(k-1) / (d_1 ... d_(k-1)), it is computed with (k - 1) zero_bits fewer bits.
   p has 2 N limbs of space. */
static void series(limb_t *h, const limb_t *z, size_t N, size_t zero_bits, limb_t first, limb_t *p, limb_t *g)
{
    limb_t K = 1;
    for (size_t bits = 0; bits < 64 * N; K++) /* until z^K / (d_1 .. d_K) < 2^-bits is below one ulp */
        bits += zero_bits + (size_t)limb_bits((2 * K + first - 2) * (2 * K + first - 1)) - 1;
    limb_zero(h, N);
    for (limb_t k = K; k >= 1; k--) {
        size_t drop = (k - 1) * zero_bits / 64, L = drop < N ? N - drop : 1, low = N - L;
        const limb_t *top = p + L;
        if (limb_normal(h + low, L)) {
            for (size_t i = low; i < N; i++)
                g[i] = ~h[i];
            limb_add_1(g + low, g + low, L, 1); /* 1 - h */
            limb_multiply_basecase(p, g + low, L, z + low, L);
        } else
            top = z + low; /* 1 - h = 1 */
        limb_divrem_1(h + low, top, L, (2 * k + first - 2) * (2 * k + first - 1));
    }
}

/* v = 2 v (2 - v) = 4 v - 2 v^2; v < 1/4 */
static void double_versine(limb_t *v, limb_t *p, size_t N)
{
    limb_square_basecase(p, v, N);
    limb_shift_left(v, v, N, 1);
    limb_sub_n(v, v, p + N, N);
    limb_shift_left(v, v, N, 1);
}

/* ---- the kernel ---- */

/* Sine and cosine of X 2^(-64 N) <= 0.8, X != 0, as drafts: s and c have N + 1 limbs, in units of ulp, with errors
   *es 2^*ks and *ec.  The angle itself is wrong by at most `wrong` ulp. */
typedef struct {
    limb_t *s, *c;
    limb_t es, ec;
    int64_t ks;
} drafts;

static void cosine_from_versine(limb_t *c, const limb_t *v, size_t N)
{
    limb_zero(c, N);
    c[N] = 1 - limb_sub_n(c, c, v, N);
}

/* With b >= 1 leading zero bits and no halving: cos x = 1 - v, and sin x = x - x g. */
static void small_angle(drafts *d, const limb_t *X, size_t N, size_t b, limb_t wrong, limb_t *space)
{
    limb_t *z = space, *h = z + N, *g = h + N, *p = g + N;
    limb_square_basecase(p, X, N);
    limb_copy(z, p + N, N);
    series(h, z, N, 2 * b, 1, p, g);
    cosine_from_versine(d->c, h, N);
    d->ec = 6 + wrong; /* ROUNDING: series 5, angle; errors.md */
    series(h, z, N, 2 * b, 2, p, g);
    limb_multiply_basecase(p, h, N, X, N);
    d->s[N] = 0;
    limb_sub_n(d->s, X, p + N, N);
    d->es = 2 + wrong; /* ROUNDING: 5 ulp times x < 2^-2, the product's floor; the angle */
    d->ks = 0;
}

/* s = floor(sqrt(w)), w = 2 v - v^2; false = no memory */
static bool sine_from_versine(drafts *d, const limb_t *v, size_t N, size_t b, limb_t *p)
{
    limb_square_basecase(p, v, N);
    limb_t *w = p + N;
    limb_zero(p, N); /* w = 2 v - floor(v^2), then N zero limbs below */
    limb_t borrow = limb_sub_n(w, v, w, N);
    borrow = limb_add_n(w, w, v, N) - borrow; /* 0: w < 1 */
    (void)borrow;
    /* normalise by an even shift so that the root kernel applies */
    size_t shift = 0;
    while (shift < 2 * N && w[N - 1 - shift / 2] == 0)
        shift += 2;
    size_t zeros = shift / 2 * 64 + (size_t)limb_clz(w[N - 1 - shift / 2]), even = zeros & ~(size_t)1;
    limb_t *a = p + 2 * N, *r = a + 2 * N;
    limb_zero(a, 2 * N);
    limb_copy(a + even / 64, p, 2 * N - even / 64);
    if (even % 64)
        limb_shift_left(a, a, 2 * N, (unsigned)(even % 64));
    if (!limb_sqrt_rem(d->s, r, a, N))
        return false;
    d->s[N] = 0;
    limb_t *s = d->s;
    size_t down = even / 2;
    limb_copy(s, s + down / 64, N - down / 64);
    limb_zero(s + N - down / 64, down / 64);
    limb_shift_right(s, s, N, (unsigned)(down % 64));
    d->es = 3 * d->ec + 3; /* ROUNDING: errors.md, "Sine by root" */
    d->ks = (int64_t)b + 1;
    return true;
}

static bool halved_angle(drafts *d, const limb_t *X, size_t N, size_t b, unsigned r, limb_t wrong, limb_t *space)
{
    limb_t *v = space, *z = v + N, *g = z + N, *p = g + N;
    limb_shift_right(v, X, N, r);
    limb_square_basecase(p, v, N);
    limb_copy(z, p + N, N);
    series(v, z, N, 2 * (b + r), 1, p, g);
    for (unsigned i = 0; i < r; i++)
        double_versine(v, p, N);
    cosine_from_versine(d->c, v, N);
    d->ec = ((limb_t)7 << (2 * r)) + wrong; /* ROUNDING: errors.md */
    return sine_from_versine(d, v, N, b, p);
}

#define KERNEL_SPACE(N) (3 * (N) + 5 * (N) + 8)

static unsigned halvings(size_t N)
{
    return N < 4 ? 6 + 2 * (unsigned)N : N < 30 ? 12 + (unsigned)N / 3 : 22;
}

static bool kernel(drafts *d, const limb_t *X, size_t N, limb_t wrong, limb_t *space)
{
    size_t b = 64 * N - limb_bit_length(X, N);
    unsigned r = halvings(N);
    if (b >= r)
        return small_angle(d, X, N, b, wrong, space), true;
    return halved_angle(d, X, N, b, r - (unsigned)b, wrong, space);
}

/* ---- reduction ---- */

/* The quadrant: s, c = sin, cos of x + turn pi/2 from those of x. */
static void turn_by(ball *s, ball *c, unsigned turn)
{
    if (turn & 1) {
        ball_swap(s, c);
        ball_neg(c, c);
    }
    if (turn & 2) {
        ball_neg(s, s);
        ball_neg(c, c);
    }
}

/* X = floor(|m| 2^(e + 64 N)), N + 1 limbs: |x| < 2^60; *inexact = bits were lost. */
static void to_fixed(limb_t *X, size_t N, const ball *x, bool *inexact)
{
    const limb_t *m = ball_limbs(x);
    size_t n = ball_length(x);
    int64_t d = x->exponent + 64 * (int64_t)N;
    limb_zero(X, N + 1);
    *inexact = false;
    if (d >= 0) {
        limb_t out = limb_shift_left(X + d / 64, m, n, (unsigned)(d % 64));
        if ((size_t)(d / 64) + n <= N)
            X[(size_t)(d / 64) + n] = out;
    } else {
        size_t whole = (size_t)-d / 64;
        *inexact = true;
        if (whole < n)
            limb_shift_right(X, m + whole, n - whole, (unsigned)(-d % 64));
    }
}

/* An integer next to X 2 / pi (X < 2^20 in fixed point), within 1/2 + 2^-38: integer arithmetic only, so that no
   rounding mode and no library has a say in it. */
static limb_t quarter_turns(const limb_t *X, size_t N)
{
    const limb_t two_over_pi = 0xa2f9836e4e441529; /* floor(2^64 2 / pi) */
    limb_t q, v = X[N] << 40 | X[N - 1] >> 24;     /* floor(2^40 |x|) */
    limb_mul(&q, v, two_over_pi);
    return (q + ((limb_t)1 << 39)) >> 40;
}

/* X becomes |X - q pi/2|; *negative = it was negative; the answer bounds the error in ulp. */
static limb_t subtract_turns(limb_t *X, size_t N, limb_t q, bool *negative, limb_t *quarter)
{
    *negative = false;
    if (q == 0)
        return 0;
    ball_pi_limbs(quarter, N);
    limb_shift_right(quarter, quarter, N + 1, 1); /* pi/2 - 1 ulp < quarter <= pi/2: floor of a floor */
    limb_mul_1(quarter, quarter, N + 1, q);
    if (limb_compare(X, quarter, N + 1) >= 0)
        limb_sub_n(X, X, quarter, N + 1);
    else {
        limb_sub_n(X, quarter, X, N + 1);
        *negative = true;
    }
    return q; /* ROUNDING: q times less than one ulp */
}

/* z = +-w with its error, below the exponent of the fixed point. */
static void store_draft(ball *z, limb_t *w, size_t N, limb_t err, int64_t k, bool negative, long prec)
{
    ball_store(z, w, N + 1, negative, err, k, -64 * (int64_t)N, prec);
}

/* Sine and cosine of x with N limbs.  turns: |x| < 2^20 and N <= PI_TABLE_LIMBS; else |x| <= 0.8.  False: the reduced
   angle is so near to 0 that more limbs are needed for a good sine, and they can be had. */
static bool sin_cos_fixed(ball *s, ball *c, const ball *x, size_t N, long prec, bool turns)
{
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 4 * (N + 1) + KERNEL_SPACE(N));
    if (!w) {
        ball_no_memory(s);
        ball_no_memory(c);
        return true;
    }
    limb_t *X = w;
    drafts d = {X + N + 1, X + 2 * (N + 1), 0, 0, 0};
    bool inexact, flipped, good = true, ok;
    to_fixed(X, N, x, &inexact);
    limb_t q = turns ? quarter_turns(X, N) : 0, wrong = subtract_turns(X, N, q, &flipped, X + 3 * (N + 1));
    wrong += inexact; /* ROUNDING: the floor of the angle */
    int64_t b = 64 * (int64_t)N - (int64_t)limb_bit_length(X, N + 1);
    if (64 * (int64_t)N < prec + b + 2 * (b < halvings(N) ? b : 0) + limb_bits(wrong) + 4)
        good = false;
    else {
        bool zero = limb_normal(X, N + 1) == 0;
        if (zero) { /* |angle| <= wrong ulp */
            limb_zero(d.s, N + 1);
            limb_zero(d.c, N + 1);
            d.c[N] = 1;
            d.es = d.ec = wrong;
            ok = true;
        } else
            ok = kernel(&d, X, N, wrong, X + 4 * (N + 1));
        bool negative = x->size < 0;
        if (ok) {
            store_draft(s, d.s, N, d.es, d.ks, flipped, prec);
            store_draft(c, d.c, N, d.ec, 0, false, prec);
            turn_by(s, c, (unsigned)(q & 3));
            if (negative)
                ball_neg(s, s);
        } else {
            ball_no_memory(s);
            ball_no_memory(c);
        }
    }
    ball_scratch_free(&space);
    return good;
}

/* ---- thin arguments ---- */

/* turns as above; false: the table of pi is too short */
static bool sin_cos_moderate(ball *s, ball *c, const ball *x, long prec, bool turns)
{
    int64_t top = ball_top(x), bits = prec < 64 ? 64 : prec;
    /* a small angle keeps its relative accuracy: sin x has -top leading zero bits */
    size_t N = (size_t)(bits + 2 * halvings((size_t)bits / 64 + 1) + 12 + (top < 0 ? -top : 0) + 63) / 64;
    for (;;) {
        if (turns && N > PI_TABLE_LIMBS)
            return false;
        if (sin_cos_fixed(s, c, x, N, prec, turns))
            return true;
        N += 1 + N / 4;
    }
}

/* |x| < 2^top, top <= -prec: sin x = x +- |x|^3 / 6, cos x = 1 +- x^2 / 2. */
static void sin_cos_tiny(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = ball_top(x);
    ball t;
    ball_init(&t);
    ball_set(&t, x);
    ball_set_error(s, 1, 3 * top - 2); /* ROUNDING: 1/6 < 1/4 */
    ball_add(s, &t, s, prec);
    ball_set_error(&t, 1, 2 * top - 1);
    ball_one(c);
    ball_add(c, c, &t, prec);
    ball_clear(&t);
}

/* s, c = [-1, 1] */
static void any_sine(ball *s, ball *c)
{
    ball_set_error(s, 1, 0);
    ball_set_error(c, 1, 0);
}

/* x thin, |x| <= 0.8 */
static void sin_cos_small(ball *s, ball *c, const ball *x, long prec)
{
    if (ball_is_exact_zero(x)) {
        ball_zero(s);
        ball_one(c);
    } else if (ball_top(x) < -prec)
        sin_cos_tiny(s, c, x, prec);
    else
        (void)sin_cos_moderate(s, c, x, prec, false); /* without turns there is no table */
}

/* Reduction in balls, for angles or precisions beyond the table: x = q pi/2 + t, and t is near 0. */
static void sin_cos_large(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = ball_top(x);
    ball quarter, t, u;
    integer q;
    ball_init(&quarter);
    ball_init(&t);
    ball_init(&u);
    integer_init(&q);
    long working = prec + (long)(top > 0 ? top : 0) + 20;
    bool ok = true;
    for (;;) { /* until t is accurate, or it is clear that it never will be */
        ball_pi(&quarter, working);
        ball_mul_2exp(&quarter, &quarter, -1, working);
        ball_div(&t, x, &quarter, working);
        ok = ball_mid_grid(&q, &t, 0);
        ball_set_integer_2exp(&u, &q, 0, BALL_MAX_PRECISION);
        ball_mul(&u, &u, &quarter, working);
        ball_sub(&t, x, &u, working);
        if (!ok || !ball_is_finite(&t) || ball_accuracy_bits_approx(&t) >= prec || working > 4 * (prec + top + 100))
            break;
        working += working / 2;
    }
    if (ok && ball_is_finite(&t)) {
        ball_midpoint(&u, &t, working);
        sin_cos_small(s, c, &u, prec);
        t.size = 0; /* +- the error of t */
        ball_add_error(s, s, &t, prec);
        ball_add_error(c, c, &t, prec);
        unsigned turn = q.size == 0 ? 0 : (unsigned)(integer_limbs(&q)[0] & 3);
        turn_by(s, c, q.size < 0 ? (4 - turn) & 3 : turn);
    } else {
        ball_no_memory(s);
        ball_no_memory(c);
    }
    ball_clear(&quarter);
    ball_clear(&t);
    ball_clear(&u);
    integer_clear(&q);
}

/* x thin; s, c and x different objects. */
static void sin_cos_thin(ball *s, ball *c, const ball *x, long prec)
{
    int64_t top = ball_is_exact_zero(x) ? -1 : ball_top(x);
    if (top <= -1)
        sin_cos_small(s, c, x, prec);
    else if (top > BALL_MAX_PRECISION / 4)
        any_sine(s, c);
    else if (top > 20 || !sin_cos_moderate(s, c, x, prec, true))
        sin_cos_large(s, c, x, prec);
}

/* ---- balls ---- */

/* No more digits than the error leaves, relatively (sine) or absolutely (cosine), and some to spare. */
static long useful_bits(const ball *x, long prec)
{
    if (x->error == 0)
        return prec;
    int64_t relative = (int64_t)ball_mantissa_bits(x), absolute = -x->exponent;
    int64_t useful = (relative > absolute ? relative : absolute) + BALL_ERROR_BITS + 8;
    return useful < prec ? (long)(useful < 64 ? 64 : useful) : prec;
}

void ball_sin_cos(ball *s, ball *c, const ball *x, long prec)
{
    if (ball_is_special(x)) {
        bool memory = ball_lacks_memory(x);
        any_sine(s, c);
        if (memory) {
            ball_no_memory(s);
            ball_no_memory(c);
        }
        return;
    }
    prec = prec < 2 ? 2 : prec > BALL_MAX_PRECISION ? BALL_MAX_PRECISION : prec;
    ball t, r;
    ball_init(&t);
    ball_init(&r);
    ball_set(&t, x);
    r.error = t.error;
    r.exponent = t.error ? t.exponent : 0;
    t.error = 0;
    if (t.size == 0)
        t.exponent = 0;
    sin_cos_thin(s, c, &t, useful_bits(x, prec));
    if (r.error) { /* ROUNDING: |f(t + u) - f(t)| <= |u| */
        ball_add_error(s, s, &r, prec);
        ball_add_error(c, c, &r, prec);
    }
    ball_clear(&t);
    ball_clear(&r);
}

void ball_sin(ball *z, const ball *x, long prec)
{
    ball c;
    ball_init(&c);
    ball_sin_cos(z, &c, x, prec);
    ball_clear(&c);
}

void ball_cos(ball *z, const ball *x, long prec)
{
    ball s;
    ball_init(&s);
    ball_sin_cos(&s, z, x, prec);
    ball_clear(&s);
}
