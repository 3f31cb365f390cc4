/* exact_value.c: arithmetic of rationals and rational multiples of pi. */
#include "exact_value.h"

void exact_init(exact_value *z)
{
    z->is_angle = false;
    rational_init(&z->q);
}

void exact_clear(exact_value *z)
{
    rational_clear(&z->q);
}

/* Puts a finished q into z: an angle of 0 is the rational 0. */
static exact_status finish(exact_value *z, bool ok, bool is_angle)
{
    if (!ok)
        return EXACT_NO_MEMORY;
    if (integer_bits(&z->q.numerator) > EXACT_MAX_BITS || integer_bits(&z->q.denominator) > EXACT_MAX_BITS)
        return EXACT_TOO_LARGE;
    z->is_angle = is_angle && !rational_is_zero(&z->q);
    return EXACT_OK;
}

exact_status exact_binary(exact_value *z, const exact_value *x, char op, const exact_value *y)
{
    bool xa = x->is_angle, ya = y->is_angle;
    bool mixed = xa != ya && !rational_is_zero(xa ? &y->q : &x->q); /* 0 is added as an angle, too */
    switch (op) {
    case '+':
        return mixed ? EXACT_NONE : finish(z, rational_add(&z->q, &x->q, &y->q), xa || ya);
    case '-':
        return mixed ? EXACT_NONE : finish(z, rational_sub(&z->q, &x->q, &y->q), xa || ya);
    case '*':
        return xa && ya ? EXACT_NONE : finish(z, rational_mul(&z->q, &x->q, &y->q), xa || ya);
    default:
        if (rational_is_zero(&y->q))
            return EXACT_DIVISION_BY_ZERO;
        return ya && !xa ? EXACT_NONE : finish(z, rational_div(&z->q, &x->q, &y->q), xa && !ya);
    }
}

exact_status exact_negate(exact_value *z, const exact_value *x)
{
    return finish(z, rational_neg(&z->q, &x->q), x->is_angle);
}

exact_status exact_power(exact_value *z, const exact_value *x, long n)
{
    size_t bits = integer_bits(&x->q.numerator), other = integer_bits(&x->q.denominator);
    size_t exponent = (size_t)(n < 0 ? -n : n);
    if (n == 0)
        return finish(z, rational_set_si(&z->q, 1, 1), false);
    if (x->is_angle)
        return n == 1 ? finish(z, rational_set(&z->q, &x->q), true) : EXACT_NONE;
    if (rational_is_zero(&x->q) && n < 0)
        return EXACT_DIVISION_BY_ZERO;
    /* (bits - 1) n <= bits of the power - 1: refuse before computing something huge */
    if (((bits ? bits - 1 : 0) * exponent >= EXACT_MAX_BITS) || ((other - 1) * exponent >= EXACT_MAX_BITS))
        return EXACT_TOO_LARGE;
    return finish(z, rational_pow(&z->q, &x->q, n), false);
}

exact_status exact_modulo(exact_value *z, const exact_value *x, const exact_value *y)
{
    bool ok;
    integer remainder;
    if (x->is_angle || y->is_angle || !rational_is_integer(&x->q) || !rational_is_integer(&y->q) || rational_is_zero(&y->q))
        return EXACT_NOT_WHOLE;
    integer_init(&remainder);
    ok = integer_fdiv_qr(NULL, &remainder, &x->q.numerator, &y->q.numerator);
    integer_swap(&z->q.numerator, &remainder);
    integer_set_si(&z->q.denominator, 1);
    integer_clear(&remainder);
    return finish(z, ok, false);
}

exact_status exact_sqrt(exact_value *z, const exact_value *x)
{
    exact_status s = EXACT_NONE;
    rational root;
    integer rest, other;
    if (x->is_angle)
        return EXACT_NONE;
    if (rational_sign(&x->q) < 0)
        return EXACT_NEGATIVE;
    rational_init(&root);
    integer_init(&rest);
    integer_init(&other);
    if (!integer_sqrt_rem(&root.numerator, &rest, &x->q.numerator) || !integer_sqrt_rem(&root.denominator, &other, &x->q.denominator)) {
        s = EXACT_NO_MEMORY;
    } else if (integer_is_zero(&rest) && integer_is_zero(&other)) {
        rational_swap(&z->q, &root);
        s = finish(z, true, false);
    }
    rational_clear(&root);
    integer_clear(&rest);
    integer_clear(&other);
    return s;
}

exact_status exact_compare(int *sign, const exact_value *x, const exact_value *y)
{
    if (x->is_angle != y->is_angle) /* 0 is no angle, so the sign of one operand may decide */
        return EXACT_NONE;
    *sign = rational_cmp(&x->q, &y->q);
    return EXACT_OK;
}

/* f = the number of sixths of pi in q pi, modulo 12, if it is whole; else -1. */
static int sixths(bool *ok, const rational *q)
{
    int result = -1;
    rational six;
    integer twelve, remainder;
    rational_init(&six);
    integer_init(&twelve);
    integer_init(&remainder);
    integer_set_si(&twelve, 12);
    *ok = rational_set_si(&six, 6, 1) && rational_mul(&six, &six, q);
    if (*ok && rational_is_integer(&six)) {
        *ok = integer_fdiv_qr(NULL, &remainder, &six.numerator, &twelve);
        if (*ok)
            result = (int)integer_get_si(&remainder);
    }
    rational_clear(&six);
    integer_clear(&twelve);
    integer_clear(&remainder);
    return result;
}

/* By Niven's theorem the cosine of q pi is rational only at multiples of pi/2 and of pi/3: here the twelfths of
   a turn whose twice_cosine is not 3 (which marks the square roots). */
exact_status exact_cos_sin(exact_value *z, const exact_value *x, char function)
{
    static const int twice_cosine[12] = {2, 3, 1, 0, -1, 3, -2, 3, -1, 0, 1, 3};
    bool ok;
    int f;
    if (!x->is_angle && !rational_is_zero(&x->q))
        return EXACT_UNDEFINED;
    f = sixths(&ok, &x->q);
    if (!ok)
        return EXACT_NO_MEMORY;
    if (f >= 0 && function == 's')
        f = (f + 9) % 12; /* sin(t) = cos(t - pi/2) */
    if (f < 0 || twice_cosine[f] == 3)
        return rational_set(&z->q, &x->q) ? (z->is_angle = x->is_angle, EXACT_NONE) : EXACT_NO_MEMORY;
    return finish(z, rational_set_si(&z->q, twice_cosine[f], 2), false);
}
