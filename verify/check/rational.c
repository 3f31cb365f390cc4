/* Exact rationals: the school formulas, then division by the gcd. */

#include "rational.h"

#include "answer.h"

rational rational_reduce(integer num, integer den)
{
    struct mark mark = scratch_mark();
    integer gcd;
    rational out;

    if (den.sign == 0)
        cannot_check("the checker divides by zero");
    if (den.sign < 0) {
        num = integer_negate(num);
        den = integer_negate(den);
    }
    gcd = integer_gcd(num, den);
    out.num = integer_divide_floor(num, gcd);      /* exact */
    out.den = integer_divide_floor(den, gcd);      /* exact */
    if (integer_bits(out.num) > RATIONAL_BITS || integer_bits(out.den) > RATIONAL_BITS)
        cannot_check("a rational number of more than %d bits occurs", RATIONAL_BITS);
    integer_keep(mark, &out.num, 2);
    return out;
}

rational rational_from(int64_t num, int64_t den)
{
    return rational_reduce(integer_from(num), integer_from(den));
}

rational rational_negate(rational a)
{
    a.num = integer_negate(a.num);
    return a;
}

rational rational_add(rational a, rational b)
{
    return rational_reduce(integer_add(integer_mul(a.num, b.den),
                                       integer_mul(b.num, a.den)),
                           integer_mul(a.den, b.den));
}

rational rational_sub(rational a, rational b)
{
    return rational_add(a, rational_negate(b));
}

rational rational_mul(rational a, rational b)
{
    return rational_reduce(integer_mul(a.num, b.num), integer_mul(a.den, b.den));
}

rational rational_divide(rational a, rational b)
{
    return rational_reduce(integer_mul(a.num, b.den), integer_mul(a.den, b.num));
}

rational rational_floor(rational a)
{
    rational out = { integer_divide_floor(a.num, a.den), integer_from(1) };

    return out;
}

int rational_compare(rational a, rational b)
{
    return integer_compare(integer_mul(a.num, b.den), integer_mul(b.num, a.den));
}

bool rational_equals(rational a, int64_t num, int64_t den)
{
    return rational_compare(a, rational_from(num, den)) == 0;
}

bool rational_is_whole(rational a)
{
    return integer_compare(a.den, integer_from(1)) == 0;
}
