/* ball_convert.c: balls as doubles and as integers on a grid.  No floating-point operation here rounds, so the
   machine's rounding mode does not matter. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "ball.h"
#include "ball_internal.h"

static double double_from_bits(uint64_t bits)
{
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

/* The double next to +-w 2^e, at or below it in absolute value (away = false) or at or above it: possibly 0 or
   infinity.  It is put together from bits: a fraction f of at most 53 bits in units of 2^(q - 1074). */
static double dyadic_to_double(const dyadic *d, bool away)
{
    if (d->n == 0)
        return 0;
    int64_t bits = (int64_t)limb_bit_length(d->w, d->n), top = bits + d->e; /* 2^(top-1) <= value < 2^top */
    int64_t unit = top - 53 < -1074 ? -1074 : top - 53;                     /* the last place, as an exponent */
    uint64_t f = 0;
    bool lost = true;
    if (top > 1024)
        f = 0;
    else if (unit <= d->e) {
        f = d->w[0] << (unit < d->e ? d->e - unit : 0);
        lost = false;
    } else if (unit - d->e < bits) {
        int64_t drop = unit - d->e;
        size_t at = (size_t)drop / 64;
        unsigned s = (unsigned)(drop % 64);
        f = d->w[at] >> s;
        if (s && at + 1 < d->n)
            f |= d->w[at + 1] << (64 - s);
        lost = !limb_low_bits_zero(d->w, d->n, (size_t)drop);
    }
    if (top > 1024)
        return (d->negative ? -1 : 1) * (away ? HUGE_VAL : DBL_MAX);
    f += lost && away;
    if (f >> 53) {
        f >>= 1; /* was 2^53 */
        unit++;
    }
    /* f < 2^53; as a subnormal-like pattern: exponent field from unit when f >= 2^52 */
    uint64_t pattern = f;
    if (f >> 52) {
        int64_t field = unit + 1075;
        pattern = field >= 2047 ? (uint64_t)2047 << 52 : ((uint64_t)field << 52) | (f & (((uint64_t)1 << 52) - 1));
    }
    return double_from_bits(pattern | ((uint64_t)d->negative << 63));
}

static double endpoint_double(const ball *x, bool upper)
{
    if (ball_is_special(x))
        return upper ? HUGE_VAL : -HUGE_VAL;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, ball_length(x) + 1);
    double v = upper ? HUGE_VAL : -HUGE_VAL;
    if (w) {
        dyadic d;
        ball_endpoint(&d, w, x, upper);
        v = dyadic_to_double(&d, d.negative != upper);
    }
    ball_scratch_free(&space);
    return v;
}

double ball_lower_bound(const ball *x) { return endpoint_double(x, false); }
double ball_upper_bound(const ball *x) { return endpoint_double(x, true); }

double ball_mid_approx(const ball *x)
{
    if (ball_is_special(x))
        return 0;
    dyadic d = {ball_limbs(x), ball_length(x), x->size < 0, x->exponent};
    return dyadic_to_double(&d, false);
}

/* ---- grids ---- */

enum direction { DOWN, NEAR, UP };

/* m = (+-w) 2^e rounded. */
static bool round_dyadic(integer *m, const dyadic *d, enum direction to)
{
    if (d->n == 0) {
        integer_zero(m);
        return true;
    }
    int64_t bits = (int64_t)limb_bit_length(d->w, d->n);
    if (d->e > (int64_t)64 * INTEGER_MAX_LIMBS)
        return false;
    if (bits + d->e < -1) { /* |value| < 1/4 */
        integer_set_si(m, to == DOWN && d->negative ? -1 : to == UP && !d->negative ? 1 : 0);
        return true;
    }
    integer t;
    integer_init(&t);
    bool ok = integer_set_limbs(&t, d->w, d->n, d->negative);
    unsigned long drop = d->e < 0 ? (unsigned long)-d->e : 0;
    if (drop == 0)
        ok = ok && integer_mul_2exp(&t, &t, (unsigned long)d->e);
    else if (to == UP)
        ok = ok && integer_cdiv_2exp(&t, &t, drop);
    else if (to == DOWN)
        ok = ok && integer_fdiv_2exp(&t, &t, drop);
    else
        ok = ok && integer_fdiv_2exp(&t, &t, drop - 1) && integer_add_si(&t, &t, 1) && integer_fdiv_2exp(&t, &t, 1);
    if (ok)
        integer_swap(m, &t);
    integer_clear(&t);
    return ok;
}

static bool endpoint_grid(integer *m, const ball *x, bool upper, long g)
{
    if (ball_is_special(x))
        return false;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, ball_length(x) + 1);
    bool ok = w != NULL;
    if (ok) {
        dyadic d;
        ball_endpoint(&d, w, x, upper);
        d.e += g;
        ok = round_dyadic(m, &d, upper ? UP : DOWN);
    }
    ball_scratch_free(&space);
    return ok;
}

bool ball_lower_grid(integer *m, const ball *x, long g) { return endpoint_grid(m, x, false, g); }
bool ball_upper_grid(integer *m, const ball *x, long g) { return endpoint_grid(m, x, true, g); }

bool ball_mid_grid(integer *m, const ball *x, long g)
{
    if (ball_is_special(x))
        return false;
    dyadic d = {ball_limbs(x), ball_length(x), x->size < 0, x->exponent + g};
    return round_dyadic(m, &d, NEAR);
}
