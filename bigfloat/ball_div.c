/* ball_div.c: quotients and square roots.  The bounds are derived in errors.md, "Quotients" and "Roots". */
#include "ball.h"
#include "ball_internal.h"

/* |m| - err >= *d 2^*k, 0 < *d < 2^32; false if |m| <= err (0 is in the ball). */
static bool magnitude_word_lower(limb_t *d, int64_t *k, const ball *x)
{
    size_t n = ball_length(x);
    const limb_t *m = ball_limbs(x);
    if (n == 0 || (n == 1 && m[0] <= x->error))
        return false;
    limb_t v = m[n - 1];
    int c = limb_clz(v);
    *k = 64 * (int64_t)(n - 1);
    if (n > 1) {
        if (c)
            v = v << c | m[n - 2] >> (64 - c);
        *k -= c;
        v -= *k >= 30 ? 1 : x->error; /* ROUNDING: err < 2^30 <= 2^k; v >= 2^63 is far larger than either */
    } else
        v -= x->error;
    int drop = limb_bits(v) - 32;
    if (drop > 0) {
        v >>= drop; /* floor */
        *k += drop;
    }
    *d = v;
    return true;
}

/* a 2^*k, rounded up to a whole number if *k < 0. */
static limb_t at_nonnegative_scale(int64_t *k, limb_t a)
{
    if (*k < 0) {
        a = ball_error_at(0 - *k, a, 0);
        *k = 0;
    }
    return a;
}

/* In units of 2^-s, with quotient q <= |mx| 2^s / |my| < q + 1, the error is at most
   (err_x 2^s + (q + 1) err_y) / (|my| - err_y), plus 1 for the truncated quotient; q instead of q + 1 if the division
   left no remainder. */
static limb_t quotient_error(int64_t *k, const ball *x, const ball *y, const ball *q, int64_t s, limb_t d, int64_t dk)
{
    limb_t u;
    int64_t i;
    ball_magnitude_word(&u, &i, q); /* of the ball q +- (the remainder is not 0) */
    limb_t a = ball_error_sum(k, x->error, x->error ? s : 0, u * y->error, y->error ? i : 0);
    if (a == 0) {
        *k = 0;
        return 0;
    }
    /* a < 2^62.  Scale it up so that the quotient by d keeps 30 bits or all. */
    int lift = limb_clz(a) - 1;
    a <<= lift;
    *k -= lift + dk;
    a = a / d + 1; /* ROUNDING: ceiling, or one more */
    return at_nonnegative_scale(k, a);
}

static void divide(ball *z, const ball *x, const ball *y, limb_t d, int64_t dk, long prec)
{
    int64_t room = ball_room_bits(prec), bx = (int64_t)ball_mantissa_bits(x), by = (int64_t)ball_mantissa_bits(y);
    /* the quotient has s + bx - by or one more bits, more than room */
    int64_t s = room + 1 + by - bx;
    if (s < 0)
        s = 0;
    size_t m = ball_length(x), n = ball_length(y), na = (size_t)(bx + s) / 64 + 2;
    if (na < n)
        na = n;
    ball_scratch space;
    limb_t *a = ball_scratch_new(&space, na + (na - n + 1) + n);
    if (!a) {
        ball_no_memory(z);
        return;
    }
    limb_t *q = a + na, *r = q + na - n + 1;
    size_t whole = (size_t)s / 64;
    limb_zero(a, na);
    a[whole + m] = limb_shift_left(a + whole, ball_limbs(x), m, (unsigned)(s % 64));
    bool negative = (x->size < 0) != (y->size < 0);
    int64_t e = x->exponent - y->exponent - s, k = 0;
    if (limb_divide(q, r, a, na, ball_limbs(y), n)) {
        size_t nq = limb_normal(q, na - n + 1);
        limb_t cut = limb_normal(r, n) != 0;
        q[0] |= cut; /* ROUNDING: the truncated quotient has at least one bit too many: its last one says "and more" */
        ball t;
        ball_init(&t);
        t.size = (int32_t)nq;
        t.error = cut; /* |mx| 2^s / |my| <= q, or < q + 1 */
        t.capacity = nq ? (uint32_t)nq : 1;
        t.at.heap = q; /* only looked at */
        limb_t err = quotient_error(&k, x, y, &t, s, d, dk);
        ball_store(z, q, nq, negative, err, k, e, prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

void ball_div(ball *z, const ball *x, const ball *y, long prec)
{
    limb_t d;
    int64_t dk;
    if (ball_is_special(x) || ball_is_special(y))
        ball_indeterminate_like(z, x, y);
    else if (!magnitude_word_lower(&d, &dk, y))
        ball_indeterminate(z);
    else
        divide(z, x, y, d, dk, prec);
}

void ball_inv(ball *z, const ball *x, long prec)
{
    ball one;
    ball_init(&one);
    ball_one(&one);
    ball_div(z, &one, x, prec);
}

void ball_div_si(ball *z, const ball *x, long v, long prec)
{
    ball t;
    ball_init(&t);
    ball_set_si(&t, v, prec);
    ball_div(z, x, &t, prec);
}

/* num / den of exact balls. */
void ball_set_rational(ball *z, const rational *q, long prec)
{
    ball a, b;
    ball_init(&a);
    ball_init(&b);
    ball_set_integer_2exp(&a, &q->numerator, 0, BALL_MAX_PRECISION);
    ball_set_integer_2exp(&b, &q->denominator, 0, BALL_MAX_PRECISION);
    ball_div(z, &a, &b, prec);
    ball_clear(&a);
    ball_clear(&b);
}

/* ---- square root ---- */

/* With M = m 2^s and r = floor(sqrt(M)): sqrt((m + t) 2^s) - sqrt(M) = t 2^s / (sqrt((m + t) 2^s) + sqrt(M)), in
   absolute value at most err 2^s / r, and, if err < m / 2^8, at most err 2^s / (2 r (1 - 2^-8)), which is below
   err 2^(s + 1) / (3 r). */
static limb_t root_error(int64_t *k, const ball *x, const ball *root, int64_t s)
{
    *k = 0;
    if (x->error == 0)
        return 0;
    limb_t d;
    int64_t dk;
    if (!magnitude_word_lower(&d, &dk, root)) /* root exact and not 0 */
        return 0;
    bool narrow = (int64_t)ball_mantissa_bits(x) > limb_bits(x->error) + 8;
    limb_t a = x->error << (narrow ? 1 : 0);
    if (narrow)
        d *= 3; /* < 2^34 */
    int lift = limb_clz(a) - 1;
    a = (a << lift) / d + 1; /* ROUNDING: ceiling, or one more */
    *k = s - lift - dk;
    return at_nonnegative_scale(k, a);
}

static void root(ball *z, const ball *x, long prec)
{
    int64_t bits = (int64_t)ball_mantissa_bits(x), s = 2 * ball_room_bits(prec) + 2 - bits;
    if (s < 0)
        s = 0;
    if ((x->exponent - s) & 1)
        s++;
    integer a, r, rem;
    integer_init(&a);
    integer_init(&r);
    integer_init(&rem);
    bool ok = integer_set_limbs(&a, ball_limbs(x), ball_length(x), false) && integer_mul_2exp(&a, &a, (unsigned long)s)
              && integer_sqrt_rem(&r, &rem, &a);
    if (ok) {
        ball t;
        ball_init(&t);
        ball_set_parts(&t, &r, 0, 0);
        int64_t k = 0;
        limb_t err = ball_is_special(&t) ? 0 : root_error(&k, x, &t, s);
        int64_t e = (x->exponent - s) / 2;
        err = ball_error_sum(&k, err, k, !integer_is_zero(&rem), 0); /* ROUNDING: r is below the root by < 1 */
        if (ball_is_special(&t))
            ball_no_memory(z);
        else
            ball_store(z, integer_limbs_rw(&r), (size_t)integer_length(&r), false, err, k, e, prec);
        ball_clear(&t);
    } else
        ball_no_memory(z);
    integer_clear(&a);
    integer_clear(&r);
    integer_clear(&rem);
}

void ball_sqrt(ball *z, const ball *x, long prec)
{
    if (ball_is_special(x))
        ball_indeterminate_like(z, x, x);
    else if (ball_is_exact_zero(x))
        ball_zero(z);
    else if (x->size <= 0 || (x->size == 1 && ball_limbs(x)[0] < x->error))
        ball_indeterminate(z);
    else
        root(z, x, prec);
}
