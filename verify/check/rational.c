/* Exact rationals: the school formulas, then division by the gcd. */

#include "rational.h"

#include "answer.h"

void rational_reduce(rational *out, const integer *num, const integer *den)
{
    integer n, d, gcd;

    if (den->sign == 0)
        cannot_check("the checker divides by zero");
    integer_set(&n, num);
    integer_set(&d, den);
    if (d.sign < 0) {
        n.sign = -n.sign;
        d.sign = 1;
    }
    integer_gcd(&gcd, &n, &d);
    integer_divide_floor(&out->num, &n, &gcd);     /* exact */
    integer_divide_floor(&out->den, &d, &gcd);     /* exact */
    if (integer_bits(&out->num) > RATIONAL_BITS ||
        integer_bits(&out->den) > RATIONAL_BITS)
        cannot_check("a rational number of more than %d bits occurs", RATIONAL_BITS);
}

void rational_set(rational *out, const rational *a)
{
    integer_set(&out->num, &a->num);
    integer_set(&out->den, &a->den);
}

void rational_set_small(rational *out, int64_t num, int64_t den)
{
    integer n, d;

    integer_set_small(&n, num);
    integer_set_small(&d, den);
    rational_reduce(out, &n, &d);
}

void rational_negate(rational *out, const rational *a)
{
    rational_set(out, a);
    out->num.sign = -out->num.sign;
}

void rational_add(rational *out, const rational *a, const rational *b)
{
    integer left, right, den;

    integer_mul(&left, &a->num, &b->den);
    integer_mul(&right, &b->num, &a->den);
    integer_add(&left, &left, &right);
    integer_mul(&den, &a->den, &b->den);
    rational_reduce(out, &left, &den);
}

void rational_sub(rational *out, const rational *a, const rational *b)
{
    rational minus_b;

    rational_negate(&minus_b, b);
    rational_add(out, a, &minus_b);
}

void rational_mul(rational *out, const rational *a, const rational *b)
{
    integer num, den;

    integer_mul(&num, &a->num, &b->num);
    integer_mul(&den, &a->den, &b->den);
    rational_reduce(out, &num, &den);
}

void rational_divide(rational *out, const rational *a, const rational *b)
{
    integer num, den;

    integer_mul(&num, &a->num, &b->den);
    integer_mul(&den, &a->den, &b->num);
    rational_reduce(out, &num, &den);
}

int rational_compare(const rational *a, const rational *b)
{
    integer left, right;

    integer_mul(&left, &a->num, &b->den);
    integer_mul(&right, &b->num, &a->den);
    return integer_compare(&left, &right);
}

bool rational_equals(const rational *a, int64_t num, int64_t den)
{
    rational b;

    rational_set_small(&b, num, den);
    return rational_compare(a, &b) == 0;
}
