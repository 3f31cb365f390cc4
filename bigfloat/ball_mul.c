/* ball_mul.c: products.  |xy - m n| <= err_x |n| + (|m| + err_x) err_y in units of the product's last place. */
#include "ball.h"
#include "ball_internal.h"

/* A bound err 2^k for the product's error; the words are < 2^30 (2^31 + 2), their sum < 2^62 + 2^33. */
static limb_t product_error(int64_t *k, const ball *x, const ball *y)
{
    limb_t u, v;
    int64_t i, j;
    ball_magnitude_word(&u, &i, x);
    ball_magnitude_word(&v, &j, y);
    return ball_error_sum(k, u * y->error, y->error ? i : 0, v * x->error, x->error ? j : 0);
}

void ball_mul(ball *z, const ball *x, const ball *y, long prec)
{
    if (ball_is_special(x) || ball_is_special(y)) {
        ball_indeterminate_like(z, x, y);
        return;
    }
    if (ball_length(x) < ball_length(y)) {
        const ball *t = x;
        x = y;
        y = t;
    }
    size_t m = ball_length(x), n = ball_length(y);
    bool negative = (x->size < 0) != (y->size < 0);
    int64_t e = x->exponent + y->exponent, k = 0;
    limb_t err = x->error | y->error ? product_error(&k, x, y) : 0;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, m + n);
    if (w && (n == 0 || limb_multiply(w, ball_limbs(x), m, ball_limbs(y), n)))
        ball_store(z, w, n ? m + n : 0, negative, err, k, e, prec);
    else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

void ball_sqr(ball *z, const ball *x, long prec)
{
    ball t;
    ball_init(&t);
    ball_mul(&t, x, x, prec);
    if (!ball_is_special(&t) && x->error && ball_contains_zero(x)) { /* squares are not negative */
        limb_t r = (x->size ? ball_limbs(x)[0] : 0) + x->error; /* |x| <= r 2^e, r < 2^31 */
        ball_set_from_zero(&t, r * r, 2 * x->exponent);
    }
    ball_swap(z, &t);
    ball_clear(&t);
}

void ball_fma(ball *z, const ball *x, const ball *y, const ball *w, long prec)
{
    ball t;
    ball_init(&t);
    ball_mul(&t, x, y, BALL_MAX_PRECISION);
    ball_add(z, w, &t, prec);
    ball_clear(&t);
}

void ball_addmul(ball *z, const ball *x, const ball *y, long prec) { ball_fma(z, x, y, z, prec); }

void ball_submul(ball *z, const ball *x, const ball *y, long prec)
{
    ball t;
    ball_init(&t);
    ball_mul(&t, x, y, BALL_MAX_PRECISION);
    ball_sub(z, z, &t, prec);
    ball_clear(&t);
}

void ball_mul_si(ball *z, const ball *x, long v, long prec)
{
    ball t;
    ball_init(&t);
    ball_set_si(&t, v, prec);
    ball_mul(z, x, &t, prec);
}

/* Binary powering; on a ball around 0 the even steps are squares, so even powers stay nonnegative. */
void ball_pow_ui(ball *z, const ball *x, unsigned long n, long prec)
{
    ball base, power;
    ball_init(&base);
    ball_init(&power);
    ball_set(&base, x);
    ball_one(&power);
    long working = prec + 2 * limb_bits(n);
    for (unsigned long bit = n ? 1UL << (limb_bits(n) - 1) : 0; bit; bit /= 2) {
        ball_sqr(&power, &power, working);
        if (n & bit)
            ball_mul(&power, &power, &base, working);
    }
    ball_set_round(z, &power, prec);
    ball_clear(&base);
    ball_clear(&power);
}

void ball_pow_si(ball *z, const ball *x, long n, long prec)
{
    if (n >= 0)
        ball_pow_ui(z, x, (unsigned long)n, prec);
    else {
        ball t;
        ball_init(&t);
        ball_inv(&t, x, prec + 2 * limb_bits(0 - (unsigned long)n));
        ball_pow_ui(z, &t, 0 - (unsigned long)n, prec);
        ball_clear(&t);
    }
}

void ball_dot_strided(ball *z, const ball *x, long xstride, const ball *y, long ystride, size_t n, long prec)
{
    ball t;
    ball_init(&t);
    for (size_t i = 0; i < n; i++)
        ball_addmul(&t, x + (long)i * xstride, y + (long)i * ystride, prec + 64);
    ball_set_round(z, &t, prec);
    ball_clear(&t);
}

void ball_dot(ball *z, const ball *x, const ball *y, size_t n, long prec)
{
    ball_dot_strided(z, x, 1, y, 1, n, prec);
}
