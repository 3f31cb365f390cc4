/* ball_mul.c: products.  |xy - m n| <= |m| err_y + (|n| + err_y) err_x in units of the product's last place. */
#include "ball.h"
#include "ball_fixed.h"
#include "ball_internal.h"

/* A bound err 2^k for the product's error; the words are < 2^30 (2^31 + 2), their sum < 2^62 + 2^33. */
static limb_t product_error(int64_t *k, const ball *x, const ball *y)
{
    size_t n = ball_length(x);
    if (n > 1 && n == ball_length(y)) {
        const limb_t *a = ball_limbs(x), *b = ball_limbs(y);
        limb_t err;
        int at;
        fixed_product_error(&err, &at, x, y, a, b, (unsigned)limb_clz(a[n - 1]), (unsigned)limb_clz(b[n - 1]), (int)n);
        *k = at;
        return err;
    }
    limb_t u, v;
    int64_t i, j;
    ball_mantissa_word(&u, &i, x);
    ball_magnitude_word(&v, &j, y);
    return ball_error_sum(k, u * y->error, y->error ? i : 0, v * x->error, x->error ? j : 0);
}

FIXED_NOINLINE static void mul_general(ball *z, const ball *x, const ball *y, long prec)
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

/* One function for each length, so that each has registers enough. */
#define MUL_FIXED(name, n)                                                                   \
    FIXED_NOINLINE static void name(ball *z, const ball *x, const ball *y, long prec)        \
    {                                                                                        \
        if (FIXED_UNLIKELY(!fixed_mul(z, x, y, (int)ball_room_bits(prec), n)))               \
            mul_general(z, x, y, prec);                                                      \
    }
MUL_FIXED(mul_1, 1)
MUL_FIXED(mul_2, 2)
MUL_FIXED(mul_3, 3)
MUL_FIXED(mul_4, 4)
#if LIMB_HAVE_ADX
FIXED_BMI2 MUL_FIXED(mul_1_bmi2, 1)
FIXED_BMI2 MUL_FIXED(mul_2_bmi2, 2)
FIXED_BMI2 MUL_FIXED(mul_3_bmi2, 3)
FIXED_BMI2 MUL_FIXED(mul_4_bmi2, 4)
#endif

void ball_mul(ball *z, const ball *x, const ball *y, long prec)
{
    switch (fixed_length(x, y, ball_room_bits(prec))) {
    case 1: FIXED_BEST(mul_1)(z, x, y, prec); break;
    case 2: FIXED_BEST(mul_2)(z, x, y, prec); break;
    case 3: FIXED_BEST(mul_3)(z, x, y, prec); break;
    case 4: FIXED_BEST(mul_4)(z, x, y, prec); break;
    default: mul_general(z, x, y, prec);
    }
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

/* z = w +- x y by a rounded product, when the operands are inexact (its rounding is then of the size of their errors)
   or the product came out exact; all of one length. */
FIXED_INLINE bool accumulate_fixed(ball *z, const ball *x, const ball *y, bool flip, int room, const int n)
{
    ball t;
    ball_init(&t);
    return fixed_mul(&t, x, y, room, n) && (x->error | y->error || t.error == 0)
           && fixed_add(z, z, &t, flip, room, n);
}

FIXED_INLINE bool accumulate_short(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    int64_t room = ball_room_bits(prec);
    int n = fixed_length(x, y, room);
    if (n == 0 || (z->size != n && z->size != -n))
        return false;
    switch (n) {
    case 1: return accumulate_fixed(z, x, y, flip, (int)room, 1);
    case 2: return accumulate_fixed(z, x, y, flip, (int)room, 2);
    case 3: return accumulate_fixed(z, x, y, flip, (int)room, 3);
    default: return accumulate_fixed(z, x, y, flip, (int)room, 4);
    }
}

#if LIMB_HAVE_ADX
FIXED_BMI2 static bool accumulate_bmi2(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    return accumulate_short(z, x, y, flip, prec);
}
#endif

static bool accumulate(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    return accumulate_short(z, x, y, flip, prec);
}

static void accumulate_general(ball *z, const ball *x, const ball *y, bool flip, long prec)
{
    ball t;
    ball_init(&t);
    ball_mul(&t, x, y, BALL_MAX_PRECISION);
    if (flip)
        ball_sub(z, z, &t, prec);
    else
        ball_add(z, z, &t, prec);
    ball_clear(&t);
}

void ball_addmul(ball *z, const ball *x, const ball *y, long prec)
{
    if (!FIXED_BEST(accumulate)(z, x, y, false, prec))
        accumulate_general(z, x, y, false, prec);
}

void ball_submul(ball *z, const ball *x, const ball *y, long prec)
{
    if (!FIXED_BEST(accumulate)(z, x, y, true, prec))
        accumulate_general(z, x, y, true, prec);
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
