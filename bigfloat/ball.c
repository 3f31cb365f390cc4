/* ball.c: life, rounding and assignment of balls. */
#include "ball.h"

#include <math.h>
#include <string.h>

#include "ball_internal.h"

/* ---- life ---- */

void ball_clear(ball *z)
{
    if (z->capacity)
        free(z->at.heap);
    ball_init(z);
}

limb_t *ball_fresh(ball *z, size_t n)
{
    size_t have = z->capacity ? z->capacity : BALL_INLINE_LIMBS;
    if (n <= have)
        return z->capacity ? z->at.heap : z->at.inline_limbs;
    if (n > (size_t)INTEGER_MAX_LIMBS)
        return NULL;
    limb_t *heap = malloc(n * sizeof *heap);
    if (!heap)
        return NULL;
    if (z->capacity)
        free(z->at.heap);
    z->at.heap = heap;
    z->capacity = (uint32_t)n;
    return heap;
}

void ball_indeterminate(ball *z)
{
    z->size = 0;
    z->error = 0;
    z->exponent = BALL_INDETERMINATE;
}

void ball_no_memory(ball *z)
{
    ball_indeterminate(z);
    z->error = 1;
}

bool ball_lacks_memory(const ball *x) { return ball_is_special(x) && x->error; }

void ball_indeterminate_like(ball *z, const ball *x, const ball *y)
{
    bool memory = ball_lacks_memory(x) || ball_lacks_memory(y);
    ball_indeterminate(z);
    z->error = memory;
}

void ball_zero(ball *z)
{
    z->size = 0;
    z->error = 0;
    z->exponent = 0;
}

/* ---- rounding ---- */

void ball_settle_exponent(ball *z)
{
    if (z->size == 0 && z->error == 0) {
        z->exponent = 0;
        return;
    }
    if (z->exponent > BALL_MAX_EXPONENT)
        ball_indeterminate(z);
    else if (z->exponent < -BALL_MAX_EXPONENT) {
        /* |x| < 2^top: a ball around 0, of radius 2^max(top, -MAX) */
        int64_t top = ball_top(z);
        z->size = 0;
        z->error = 1;
        z->exponent = top > -BALL_MAX_EXPONENT ? top : -BALL_MAX_EXPONENT;
    }
}

/* How many low bits must go: so many that the mantissa has at most `room` bits, and, if the error has more than
   BALL_ERROR_BITS bits (one fewer if any shift is made), so many that it has one fewer: then, rounded up
   and increased by 1 for the mantissa's lost bits, it is at most 2^(BALL_ERROR_BITS - 1) + 1. */
static int64_t rounding_shift(int64_t bits, int64_t error_bits, int64_t room)
{
    int64_t s = bits > room ? bits - room : 0;
    if (error_bits > (s ? s + BALL_ERROR_BITS - 1 : BALL_ERROR_BITS))
        s = error_bits - (BALL_ERROR_BITS - 1);
    return s;
}

/* ceil(err 2^k / 2^s), known to fit. */
static limb_t scaled_error(limb_t err, int64_t k, int64_t s)
{
    if (err == 0)
        return 0;
    if (k >= s)
        return err << (k - s);
    int64_t d = s - k;
    if (d >= 64)
        return 1;
    return (err >> d) + (err << (64 - d) != 0); /* ROUNDING: ceiling */
}

void ball_store(ball *z, limb_t *w, size_t n, bool negative, limb_t err, int64_t k, int64_t e, long prec)
{
    n = limb_normal(w, n);
    int64_t bits = n ? (int64_t)(64 * n) - limb_clz(w[n - 1]) : 0;
    int64_t s = rounding_shift(bits, err ? limb_bits(err) + k : 0, ball_room_bits(prec));
    limb_t error = scaled_error(err, k, s);
    if (s >= bits && s > 0) {
        error += n != 0; /* ROUNDING: the whole mantissa, < 2^s, is lost */
        n = 0;
    } else if (s > 0) {
        error += !limb_low_bits_zero(w, n, (size_t)s); /* ROUNDING: less than one unit is lost */
        w += s / 64;
        n -= (size_t)(s / 64);
        limb_shift_right(w, w, n, (unsigned)(s % 64));
        n = limb_normal(w, n);
    }
    limb_t *p = ball_fresh(z, n);
    if (!p) {
        ball_no_memory(z);
        return;
    }
    limb_copy(p, w, n);
    z->size = negative ? -(int32_t)n : (int32_t)n;
    z->error = error;
    z->exponent = e + s;
    ball_settle_exponent(z);
}

/* ---- size ---- */

int64_t ball_top(const ball *x)
{
    int64_t bits = (int64_t)ball_mantissa_bits(x), error_bits = limb_bits(x->error);
    if (x->error == 0)
        return x->exponent + bits;
    return x->exponent + 1 + (bits > error_bits ? bits : error_bits);
}

void ball_mantissa_word(limb_t *w, int64_t *k, const ball *x)
{
    size_t n = ball_length(x);
    const limb_t *m = ball_limbs(x);
    int64_t bits = (int64_t)ball_mantissa_bits(x);
    *k = bits > 30 ? bits - 30 : 0;
    if (bits <= 30) {
        *w = n ? m[0] : 0;
        return;
    }
    limb_t top = m[n - 1];
    int c = limb_clz(top);
    if (c)
        top = top << c | (n > 1 ? m[n - 2] >> (64 - c) : 0);
    *w = (top >> 34) + 1; /* ROUNDING: |m| < (top + 1) 2^k */
}

void ball_magnitude_word(limb_t *w, int64_t *k, const ball *x)
{
    ball_mantissa_word(w, k, x);
    if (*k == 0)
        *w += x->error;
    else
        *w += (*k < 64 ? x->error >> *k : 0) + (x->error != 0); /* ROUNDING: ceiling, or one more */
}

void ball_set_error(ball *z, limb_t w, int64_t k)
{
    ball_store(z, NULL, 0, false, w, 0, k, 64);
}

/* ---- assignment ---- */

void ball_set(ball *z, const ball *x)
{
    if (z == x)
        return;
    size_t n = ball_length(x);
    limb_t *p = ball_fresh(z, n);
    if (!p) {
        ball_no_memory(z);
        return;
    }
    limb_copy(p, ball_limbs(x), n);
    z->size = x->size;
    z->error = x->error;
    z->exponent = x->exponent;
}

/* z = (+-limbs +- err) 2^e from limbs that may belong to z. */
static void set_limbs(ball *z, const limb_t *limb, size_t n, bool negative, limb_t err, int64_t e, long prec)
{
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, n);
    if (w) {
        limb_copy(w, limb, n);
        ball_store(z, w, n, negative, err, 0, e, prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}

void ball_set_round(ball *z, const ball *x, long prec)
{
    if (ball_is_special(x) || (int64_t)ball_mantissa_bits(x) <= ball_room_bits(prec))
        ball_set(z, x);
    else
        set_limbs(z, ball_limbs(x), ball_length(x), x->size < 0, x->error, x->exponent, prec);
}

void ball_set_si(ball *z, long v, long prec)
{
    (void)prec;
    limb_t *p = ball_fresh(z, 1);
    p[0] = v < 0 ? 0 - (limb_t)v : (limb_t)v;
    z->size = v < 0 ? -1 : v != 0;
    z->error = 0;
    z->exponent = 0;
}

void ball_one(ball *z) { ball_set_si(z, 1, 64); }

/* Keeps e + (any shift) far from overflow. */
static int64_t clamp_exponent(int64_t e)
{
    const int64_t far = 4 * BALL_MAX_EXPONENT;
    return e > far ? far : e < -far ? -far : e;
}

void ball_set_integer_2exp(ball *z, const integer *m, long e, long prec)
{
    set_limbs(z, integer_limbs(m), (size_t)integer_length(m), m->size < 0, 0, clamp_exponent(e), prec);
}

void ball_set_double(ball *z, double v, long prec)
{
    if (!(v < HUGE_VAL && v > -HUGE_VAL)) {
        ball_indeterminate(z);
        return;
    }
    int e;
    double f = frexp(v < 0 ? -v : v, &e);
    limb_t w = (limb_t)ldexp(f, 53); /* an integer below 2^53: exact */
    ball_store(z, &w, 1, v < 0, 0, 0, (int64_t)e - 53, prec);
}

void ball_set_parts(ball *z, const integer *m, uint64_t err, int64_t e)
{
    set_limbs(z, integer_limbs(m), (size_t)integer_length(m), m->size < 0, err, clamp_exponent(e),
              BALL_MAX_PRECISION);
}

bool ball_get_parts(integer *m, uint64_t *err, int64_t *e, const ball *x)
{
    if (ball_is_special(x))
        return false;
    if (err)
        *err = x->error;
    if (e)
        *e = x->exponent;
    return !m || integer_set_limbs(m, ball_limbs(x), ball_length(x), x->size < 0);
}

/* ---- sign and scale ---- */

void ball_neg(ball *z, const ball *x)
{
    ball_set(z, x);
    z->size = -z->size;
}

/* (t +- t) 2^(e - 1), t rounded up to BALL_ERROR_BITS bits so that mantissa and error stay equal. */
void ball_set_from_zero(ball *z, limb_t t, int64_t e)
{
    int excess = limb_bits(t) - BALL_ERROR_BITS;
    if (excess > 0) {
        t = (t >> excess) + 1; /* ROUNDING: ceiling, or one more; 2^BALL_ERROR_BITS is rounded exactly below */
        e += excess;
    }
    if (t >> BALL_ERROR_BITS) {
        t >>= 1;
        e++;
    }
    limb_t *p = ball_fresh(z, 1);
    p[0] = t;
    z->size = t != 0;
    z->error = t;
    z->exponent = e - 1;
    ball_settle_exponent(z);
}

/* If 0 is inside, |x| is in [0, |m| + err]. */
void ball_abs(ball *z, const ball *x)
{
    if (!ball_is_special(x) && x->error && ball_contains_zero(x)) {
        ball_set_from_zero(z, (x->size ? ball_limbs(x)[0] : 0) + x->error, x->exponent);
        return;
    }
    ball_set(z, x);
    if (z->size < 0)
        z->size = -z->size;
}

void ball_mul_2exp(ball *z, const ball *x, long e, long prec)
{
    ball_set_round(z, x, prec);
    if (!ball_is_special(z)) {
        z->exponent += clamp_exponent(e);
        ball_settle_exponent(z);
    }
}

bool ball_is_finite(const ball *x) { return !ball_is_special(x); }
bool ball_is_thin(const ball *x) { return !ball_is_special(x) && x->error == 0; }

bool ball_identical(const ball *x, const ball *y)
{
    return x->size == y->size && x->error == y->error && x->exponent == y->exponent
           && limb_compare(ball_limbs(x), ball_limbs(y), ball_length(x)) == 0;
}
