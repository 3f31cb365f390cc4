/* pi, cos(pi q), sin(pi q) for certificate.md, section 2.
 *
 * Everything is computed in units of 2^-p for some p > g, by integer
 * operations with a counted error: a number and an error with
 *
 *     |number - 2^p * exact| <= error.
 *
 * If floor(2^g exact) is the same for number - error and number + error, it is
 * known, and as the exact number is irrational the least grid interval is
 * [floor, floor + 1].  Else p is increased.  An irrational number is at a
 * positive distance from every grid number, so that this ends.
 */

#include "grid.h"

enum { FIRST_GUARD_BITS = 32 };

struct estimate {
    integer number;
    int64_t error;
};

/* 2^p atan(1/x), x = 5 or 239, by the series.
 *
 * atan(1/x) = sum of (-1)^j / ((2j+1) x^(2j+1)).  Repeated division with floor
 * is division by the product with floor, so that term j is
 * floor(2^p / ((2j+1) x^(2j+1))): error < 1.  The sum stops before the first j
 * with 2^p / x^(2j+1) < 1; the alternating rest is < 1. */
static struct estimate series_atan(int x, long p)
{
    integer power = integer_divide_floor(integer_shift_left(integer_from(1), p), integer_from(x));
    struct estimate out = { integer_from(0), 1 };

    for (int64_t j = 0; power.sign > 0; j++) {
        integer term = integer_divide_floor(power, integer_from(2 * j + 1));

        out.number = j % 2 == 0 ? integer_add(out.number, term) : integer_sub(out.number, term);
        out.error++;
        power = integer_divide_floor(power, integer_from((int64_t)x * x));
    }
    return out;
}

/* 2^p pi.  Machin's formula pi = 16 atan(1/5) - 4 atan(1/239).  The last one is
 * remembered, for nearly always the same is wanted again. */
static struct estimate fixed_pi(long p)
{
    static uint32_t limb[INTEGER_LIMBS + 1];
    static struct estimate last;
    static long last_p = -1;

    if (p != last_p) {
        struct mark mark = scratch_mark();
        struct estimate fifth = series_atan(5, p), small = series_atan(239, p);

        last.number = integer_sub(integer_shift_left(fifth.number, 4),
                                  integer_shift_left(small.number, 2));
        last.error = 16 * fifth.error + 4 * small.error;
        integer_store(&last.number, limb);
        last_p = p;
        scratch_release(mark);
    }
    return last;
}

/* 2^p cos(pi q) (or sin) for 0 <= q <= 1/4.
 *
 * Let P be the number for pi, E its error, X = floor(P q) and x = X 2^-p.
 * |x - pi q| 2^p <= E/4 + 1 <= E (as E >= 20), and cos and sin have slopes of
 * at most 1: E pays for the argument.  Moreover 0 <= x < 0.8.
 *
 * The series of cos x and sin x have terms tau_0 = 1 or x,
 * tau_(j+1) = tau_j x^2 / ((m+1)(m+2)), m = the degree of tau_j.  Computed are
 * t_(j+1) = floor(floor(t_j S / 2^p) / ((m+1)(m+2))) with S = floor(X^2/2^p).
 * With e_j = |t_j - 2^p tau_j|: the inner product errs by at most e_j S/2^p <
 * e_j (from t_j), 1 (from S, tau_j <= 1) and 1 (its floor); the division by at
 * least 2 halves this; its floor adds 1: e_(j+1) <= (e_j + 2)/2 + 1.  As e_0 = 0,
 * e_j <= 4 for all j.  The sum stops before the first t_j = 0; then 2^p tau_j
 * <= 4, and so is the alternating rest.  In all 4 (terms + 1) + E. */
static struct estimate fixed_cos_sin(rational q, bool sine, long p)
{
    struct estimate pi = fixed_pi(p), out = { integer_from(0), pi.error + 4 };
    integer x = integer_divide_floor(integer_mul(pi.number, q.num), q.den);
    integer square = integer_shift_floor(integer_mul(x, x), p);
    integer term = sine ? x : integer_shift_left(integer_from(1), p);
    int64_t degree = sine ? 1 : 0;

    for (int64_t j = 0; term.sign > 0; j++) {
        out.number = j % 2 == 0 ? integer_add(out.number, term) : integer_sub(out.number, term);
        out.error += 4;
        term = integer_shift_floor(integer_mul(term, square), p);
        term = integer_divide_floor(term, integer_from((degree + 1) * (degree + 2)));
        degree += 2;
    }
    return out;
}

/* out = the least grid interval, if the estimate (units 2^-p) says it. */
static bool round_to_grid(interval *out, struct estimate e, long p, int g)
{
    integer radius = integer_from(e.error);
    integer low = integer_shift_floor(integer_sub(e.number, radius), p - g);
    integer high = integer_shift_floor(integer_add(e.number, radius), p - g);

    *out = interval_of(low, integer_add(low, integer_from(1)));
    return integer_compare(low, high) == 0;
}

interval grid_pi(int g)
{
    interval out;

    for (long guard = FIRST_GUARD_BITS; ; guard *= 2)
        if (round_to_grid(&out, fixed_pi(g + guard), g + guard, g))
            return out;
}

/* Brings q to [0, 1/2]: cos(pi q) before = sign * cos(pi q) after. */
static int reduce(rational *q)
{
    rational two = rational_from(2, 1), one = rational_from(1, 1);
    rational periods = rational_floor(rational_divide(*q, two));

    *q = rational_sub(*q, rational_mul(two, periods));
    if (rational_compare(*q, one) > 0)             /* cos(2 pi - x) = cos x */
        *q = rational_sub(two, *q);
    if (rational_compare(*q, rational_from(1, 2)) <= 0)
        return 1;
    *q = rational_sub(one, *q);                    /* cos(pi - x) = -cos x */
    return -1;
}

bool rational_cos_pi(rational *out, rational q)
{
    int sign = reduce(&q);

    if (rational_equals(q, 0, 1))
        *out = rational_from(sign, 1);
    else if (rational_equals(q, 1, 3))
        *out = rational_from(sign, 2);
    else if (rational_equals(q, 1, 2))
        *out = rational_from(0, 1);
    else
        return false;
    return true;
}

interval grid_cos_pi(rational q, int g)
{
    struct mark mark = scratch_mark();
    rational exact;
    interval out;
    bool sine;
    int sign;

    if (rational_cos_pi(&exact, q))
        return grid_from_rational(exact, g);
    sign = reduce(&q);
    sine = rational_compare(q, rational_from(1, 4)) > 0;
    if (sine)                                      /* cos x = sin(pi/2 - x) */
        q = rational_sub(rational_from(1, 2), q);
    for (long guard = FIRST_GUARD_BITS; ; guard *= 2)
        if (round_to_grid(&out, fixed_cos_sin(q, sine, g + guard), g + guard, g))
            break;
    if (sign < 0)
        out = interval_minus(out);
    interval_keep(mark, &out, 1);
    return out;
}

/* sin x = cos(pi/2 - x) */
interval grid_sin_pi(rational q, int g)
{
    return grid_cos_pi(rational_sub(rational_from(1, 2), q), g);
}
