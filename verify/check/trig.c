/* pi, cos(pi q), sin(pi q) for certificate.md, section 2.
 *
 * Everything is computed in units of 2^-p for some p > g, by integer
 * operations with a counted error: a pair (value, error) with
 *
 *     |value - 2^p * exact| <= error.
 *
 * If floor(2^g exact) is the same for value - error and value + error, it is
 * known, and as the exact number is irrational the least grid interval is
 * [floor, floor + 1].  Else p is increased.  An irrational number is at a
 * positive distance from every grid number, so that this ends.
 */

#include "trig.h"

#include "answer.h"

enum { FIRST_GUARD_BITS = 32 };

/* sum = floor-wise series of 2^p atan(1/x), x = 5 or 239; returns a bound of
 * the error.
 *
 * atan(1/x) = sum of (-1)^j / ((2j+1) x^(2j+1)).  Repeated division with floor
 * is division by the product with floor, so that term j is
 * floor(2^p / ((2j+1) x^(2j+1))): error < 1.  The sum stops before the first j
 * with 2^p / x^(2j+1) < 1; the alternating rest is < 1. */
static int64_t series_atan(integer *sum, int x, long p)
{
    integer power, square, odd, term;
    int64_t terms = 0;

    integer_set_small(&power, 1);
    integer_shift_left(&power, &power, p);
    integer_set_small(&odd, x);
    integer_divide_floor(&power, &power, &odd);
    integer_set_small(&square, (int64_t)x * x);
    integer_set_small(sum, 0);
    while (power.sign > 0) {
        integer_set_small(&odd, 2 * terms + 1);
        integer_divide_floor(&term, &power, &odd);
        if (terms % 2 == 0)
            integer_add(sum, sum, &term);
        else
            integer_sub(sum, sum, &term);
        integer_divide_floor(&power, &power, &square);
        terms++;
    }
    return terms + 1;
}

/* value = 2^p pi; returns a bound of the error.  Machin's formula
 * pi = 16 atan(1/5) - 4 atan(1/239). */
static int64_t fixed_pi(integer *value, long p)
{
    integer fifth, small;
    int64_t error = 16 * series_atan(&fifth, 5, p);

    error += 4 * series_atan(&small, 239, p);
    integer_shift_left(&fifth, &fifth, 4);
    integer_shift_left(&small, &small, 2);
    integer_sub(value, &fifth, &small);
    return error;
}

/* value = 2^p cos(pi q) (or sin) for 0 <= q <= 1/4; returns a bound of the
 * error.
 *
 * Let P be the value for pi, E its error, X = floor(P q) and x = X 2^-p.
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
static int64_t fixed_cos_sin(integer *value, const rational *q, bool sine, long p)
{
    integer x, square, term, product, factor;
    int64_t error = fixed_pi(&x, p);
    int64_t degree = sine ? 1 : 0;
    int64_t terms = 0;

    integer_mul(&x, &x, &q->num);
    integer_divide_floor(&x, &x, &q->den);
    integer_mul(&square, &x, &x);
    integer_shift_floor(&square, &square, p);

    if (sine) {
        integer_set(&term, &x);
    } else {
        integer_set_small(&term, 1);
        integer_shift_left(&term, &term, p);
    }
    integer_set_small(value, 0);
    while (term.sign > 0) {
        if (terms % 2 == 0)
            integer_add(value, value, &term);
        else
            integer_sub(value, value, &term);
        integer_mul(&product, &term, &square);
        integer_shift_floor(&product, &product, p);
        integer_set_small(&factor, (degree + 1) * (degree + 2));
        integer_divide_floor(&term, &product, &factor);
        degree += 2;
        terms++;
    }
    return 4 * (terms + 1) + error;
}

/* out = the least grid interval, if value and error (units 2^-p) say it. */
static bool round_to_grid(interval *out, const integer *value, int64_t error,
                          long p, int g)
{
    integer radius, low, high, one;

    integer_set_small(&radius, error);
    integer_sub(&low, value, &radius);
    integer_add(&high, value, &radius);
    integer_shift_floor(&low, &low, p - g);
    integer_shift_floor(&high, &high, p - g);
    if (integer_compare(&low, &high) != 0)
        return false;
    integer_set_small(&one, 1);
    integer_add(&high, &low, &one);
    interval_set_ends(out, &low, &high);
    return true;
}

void grid_pi(interval *out, int g)
{
    integer value;

    for (long guard = FIRST_GUARD_BITS; ; guard *= 2) {
        int64_t error = fixed_pi(&value, g + guard);

        if (round_to_grid(out, &value, error, g + guard, g))
            return;
    }
}

/* Brings q to [0, 1/2]: cos(pi q) before = sign * cos(pi q) after. */
static int reduce(rational *q)
{
    rational two, one, half;
    integer twice, periods;

    rational_set_small(&two, 2, 1);
    rational_set_small(&one, 1, 1);
    rational_set_small(&half, 1, 2);

    integer_shift_left(&twice, &q->den, 1);        /* q := q - 2 floor(q/2) */
    integer_divide_floor(&periods, &q->num, &twice);
    integer_mul(&periods, &periods, &twice);
    integer_sub(&q->num, &q->num, &periods);

    if (rational_compare(q, &one) > 0)             /* cos(2 pi - x) = cos x */
        rational_sub(q, &two, q);
    if (rational_compare(q, &half) <= 0)
        return 1;
    rational_sub(q, &one, q);                      /* cos(pi - x) = -cos x */
    return -1;
}

bool rational_cos_pi(rational *out, const rational *q)
{
    rational r;

    rational_set(&r, q);

    int sign = reduce(&r);

    if (rational_equals(&r, 0, 1))
        rational_set_small(out, sign, 1);
    else if (rational_equals(&r, 1, 3))
        rational_set_small(out, sign, 2);
    else if (rational_equals(&r, 1, 2))
        rational_set_small(out, 0, 1);
    else
        return false;
    return true;
}

void grid_cos_pi(interval *out, const rational *q, int g)
{
    rational exact, r, half, quarter;
    integer value;

    if (rational_cos_pi(&exact, q)) {
        grid_from_rational(out, &exact, g);
        return;
    }
    rational_set(&r, q);

    int sign = reduce(&r);

    rational_set_small(&half, 1, 2);
    rational_set_small(&quarter, 1, 4);

    bool sine = rational_compare(&r, &quarter) > 0;

    if (sine)                                      /* cos x = sin(pi/2 - x) */
        rational_sub(&r, &half, &r);
    for (long guard = FIRST_GUARD_BITS; ; guard *= 2) {
        int64_t error = fixed_cos_sin(&value, &r, sine, g + guard);

        if (round_to_grid(out, &value, error, g + guard, g))
            break;
    }
    if (sign < 0)
        interval_minus(out, out);
}

/* sin x = cos(pi/2 - x) */
static void complement(rational *out, const rational *q)
{
    rational half;

    rational_set_small(&half, 1, 2);
    rational_sub(out, &half, q);
}

bool rational_sin_pi(rational *out, const rational *q)
{
    rational r;

    complement(&r, q);
    return rational_cos_pi(out, &r);
}

void grid_sin_pi(interval *out, const rational *q, int g)
{
    rational r;

    complement(&r, q);
    grid_cos_pi(out, &r, g);
}
