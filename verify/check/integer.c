/* Integers of fixed capacity.
 *
 * School arithmetic on limbs in base 2^32, with products in uint64_t.  The one
 * difficult algorithm, long division, is not trusted: its quotient is
 * multiplied back and compared each time it is used (divide()).
 *
 * Work is counted here, since all time is spent here: after WORK_LIMIT limb
 * products the answer is "cannot check".  So every run ends.
 */

#include "integer.h"

#include "answer.h"

#include <string.h>

/* About a quarter of an hour. */
static const uint64_t WORK_LIMIT = UINT64_C(1000000000000);

static void count_work(int rows, int columns)
{
    static uint64_t work = 0;

    work += (uint64_t)rows * (uint64_t)columns + 1;
    if (work > WORK_LIMIT)
        cannot_check("this certificate needs more work than the checker's limit");
}

/* Magnitudes
 * ---------- */

static int trimmed(const uint32_t *limb, int length)
{
    while (length > 0 && limb[length - 1] == 0)
        length--;
    return length;
}

/* out = sign * limb[0..length); limb may be out->limb. */
static void set_limbs(integer *out, int sign, const uint32_t *limb, int length)
{
    length = trimmed(limb, length);
    if (length > INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);
    if (limb != out->limb && length > 0)
        memmove(out->limb, limb, (size_t)length * sizeof limb[0]);
    out->length = length;
    out->sign = length > 0 ? sign : 0;
}

static int compare_magnitudes(const integer *a, const integer *b)
{
    if (a->length != b->length)
        return a->length < b->length ? -1 : 1;
    for (int i = a->length - 1; i >= 0; i--)
        if (a->limb[i] != b->limb[i])
            return a->limb[i] < b->limb[i] ? -1 : 1;
    return 0;
}

/* out = sign (|a| + |b|) */
static void add_magnitudes(integer *out, int sign, const integer *a,
                           const integer *b)
{
    uint32_t sum[INTEGER_LIMBS + 1];
    int length = a->length > b->length ? a->length : b->length;
    uint64_t carry = 0;

    for (int i = 0; i < length; i++) {
        carry += (uint64_t)(i < a->length ? a->limb[i] : 0);
        carry += (uint64_t)(i < b->length ? b->limb[i] : 0);
        sum[i] = (uint32_t)(carry & 0xffffffffu);
        carry >>= 32;
    }
    sum[length] = (uint32_t)carry;
    set_limbs(out, sign, sum, length + 1);
}

/* out = sign (|a| - |b|) where |a| >= |b| */
static void sub_magnitudes(integer *out, int sign, const integer *a,
                           const integer *b)
{
    uint32_t difference[INTEGER_LIMBS];
    int length = a->length;
    uint64_t borrow = 0;

    for (int i = 0; i < length; i++) {
        uint64_t take = (uint64_t)(i < b->length ? b->limb[i] : 0) + borrow;
        uint64_t from = a->limb[i];

        borrow = from < take ? 1 : 0;
        difference[i] = (uint32_t)((from + (borrow << 32) - take) & 0xffffffffu);
    }
    set_limbs(out, sign, difference, length);
}

/* Values in and out
 * ----------------- */

void integer_set(integer *out, const integer *a)
{
    if (out == a)
        return;
    out->sign = a->sign;
    out->length = a->length;
    memcpy(out->limb, a->limb, (size_t)a->length * sizeof a->limb[0]);
}

void integer_set_small(integer *out, int64_t a)
{
    uint64_t magnitude = a < 0 ? (uint64_t)0 - (uint64_t)a : (uint64_t)a;

    out->limb[0] = (uint32_t)(magnitude & 0xffffffffu);
    out->limb[1] = (uint32_t)(magnitude >> 32);
    set_limbs(out, a < 0 ? -1 : 1, out->limb, 2);
}

static int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return -1;
}

bool integer_read_hex(integer *out, const char *text, size_t size)
{
    bool negative = size > 0 && text[0] == '-';
    const char *digit = text + (negative ? 1 : 0);
    size_t digits = size - (negative ? 1 : 0);

    if (digits == 0)
        return false;
    for (size_t i = 0; i < digits; i++)
        if (hex_digit(digit[i]) < 0)
            return false;
    if (digit[0] == '0' && (digits > 1 || negative))
        return false;
    if (digits > 8 * INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);

    int length = (int)((digits + 7) / 8);

    for (int i = 0; i < length; i++)
        out->limb[i] = 0;
    for (size_t i = 0; i < digits; i++) {          /* i-th digit from the right */
        uint32_t value = (uint32_t)hex_digit(digit[digits - 1 - i]);

        out->limb[i / 8] |= value << (4 * (i % 8));
    }
    set_limbs(out, negative ? -1 : 1, out->limb, length);
    return true;
}

int integer_compare(const integer *a, const integer *b)
{
    if (a->sign != b->sign)
        return a->sign < b->sign ? -1 : 1;
    return a->sign * compare_magnitudes(a, b);
}

long integer_bits(const integer *a)
{
    long bits = 32L * a->length;

    if (a->length == 0)
        return 0;
    for (uint32_t top = a->limb[a->length - 1]; top < 0x80000000u; top <<= 1)
        bits--;
    return bits;
}

bool integer_get_small(int64_t *out, const integer *a, int64_t bound)
{
    uint64_t magnitude = 0;

    if (a->length > 2)
        return false;
    for (int i = a->length - 1; i >= 0; i--)
        magnitude = magnitude << 32 | a->limb[i];
    if (bound < 0 || magnitude > (uint64_t)bound)
        return false;
    *out = a->sign * (int64_t)magnitude;
    return true;
}

/* Exact arithmetic
 * ---------------- */

void integer_negate(integer *out, const integer *a)
{
    integer_set(out, a);
    out->sign = -out->sign;
}

void integer_absolute(integer *out, const integer *a)
{
    integer_set(out, a);
    out->sign = out->sign != 0 ? 1 : 0;
}

/* out = a + b_sign |b| */
static void add_signed(integer *out, const integer *a, int b_sign,
                       const integer *b)
{
    if (a->sign == 0) {
        integer_set(out, b);
        out->sign = b_sign;
    } else if (b_sign == 0) {
        integer_set(out, a);
    } else if (a->sign == b_sign) {
        add_magnitudes(out, b_sign, a, b);
    } else if (compare_magnitudes(a, b) >= 0) {
        sub_magnitudes(out, a->sign, a, b);
    } else {
        sub_magnitudes(out, b_sign, b, a);
    }
}

void integer_add(integer *out, const integer *a, const integer *b)
{
    add_signed(out, a, b->sign, b);
}

void integer_sub(integer *out, const integer *a, const integer *b)
{
    add_signed(out, a, -b->sign, b);
}

void integer_mul(integer *out, const integer *a, const integer *b)
{
    uint32_t product[2 * INTEGER_LIMBS];
    int sign = a->sign * b->sign;

    count_work(a->length, b->length);
    if (sign == 0) {
        integer_set_small(out, 0);
        return;
    }
    for (int i = 0; i < a->length + b->length; i++)
        product[i] = 0;
    for (int i = 0; i < a->length; i++) {
        uint64_t factor = a->limb[i];
        uint64_t carry = 0;

        /* (2^32-1)^2 + 2 (2^32-1) < 2^64: no overflow. */
        for (int j = 0; j < b->length; j++) {
            carry += factor * b->limb[j] + product[i + j];
            product[i + j] = (uint32_t)(carry & 0xffffffffu);
            carry >>= 32;
        }
        product[i + b->length] = (uint32_t)carry;
    }
    set_limbs(out, sign, product, a->length + b->length);
}

void integer_shift_left(integer *out, const integer *a, long bits)
{
    uint32_t shifted[INTEGER_LIMBS + 1];
    int sign = a->sign;

    if (sign == 0) {
        integer_set_small(out, 0);
        return;
    }
    if (bits < 0 || bits + integer_bits(a) > 32L * INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);

    int limbs = (int)(bits / 32);
    int rest = (int)(bits % 32);
    int length = a->length + limbs;                /* one more limb may follow */
    uint64_t carry = 0;

    for (int i = 0; i < limbs; i++)
        shifted[i] = 0;
    for (int i = 0; i < a->length; i++) {
        carry |= (uint64_t)a->limb[i] << rest;
        shifted[limbs + i] = (uint32_t)(carry & 0xffffffffu);
        carry >>= 32;
    }
    shifted[length] = (uint32_t)carry;
    set_limbs(out, sign, shifted, length + 1);
}

/* Division
 * -------- */

/* quotient = floor(|a| / d), d > 0; returns the remainder. */
static uint32_t divide_by_limb(uint32_t *quotient, const integer *a, uint32_t d)
{
    uint64_t rest = 0;

    for (int i = a->length - 1; i >= 0; i--) {
        rest = rest << 32 | a->limb[i];
        quotient[i] = (uint32_t)(rest / d);
        rest %= d;
    }
    return (uint32_t)rest;
}

/* limb << bits into out[0..length], one limb longer; 0 <= bits < 32. */
static void shift_limbs(uint32_t *out, const uint32_t *limb, int length, int bits)
{
    uint64_t carry = 0;

    for (int i = 0; i < length; i++) {
        carry |= (uint64_t)limb[i] << bits;
        out[i] = (uint32_t)(carry & 0xffffffffu);
        carry >>= 32;
    }
    out[length] = (uint32_t)carry;
}

/* quotient[0 .. a.length - b.length] = floor(|a| / |b|), for a.length >=
 * b.length >= 2: Knuth, The Art of Computer Programming 2, 4.3.1, Algorithm D.
 * divide() checks the result. */
static void divide_long(uint32_t *quotient, const integer *a, const integer *b)
{
    uint32_t rest[INTEGER_LIMBS + 1], divisor[INTEGER_LIMBS + 1];
    int n = b->length;
    int bits = 0;

    while ((b->limb[n - 1] << bits & 0x80000000u) == 0)
        bits++;
    shift_limbs(rest, a->limb, a->length, bits);
    shift_limbs(divisor, b->limb, n, bits);

    for (int j = a->length - n; j >= 0; j--) {
        uint64_t top = (uint64_t)rest[j + n] << 32 | rest[j + n - 1];
        uint64_t guess = top / divisor[n - 1];
        uint64_t left = top % divisor[n - 1];

        /* The guess is at most 2 too large; mostly this makes it right. */
        while (guess >> 32 != 0 ||
               guess * divisor[n - 2] > (left << 32 | rest[j + n - 2])) {
            guess--;
            left += divisor[n - 1];
            if (left >> 32 != 0)
                break;
        }

        uint64_t carry = 0, borrow = 0;

        for (int i = 0; i <= n; i++) {             /* rest -= guess * divisor */
            carry += guess * (i < n ? divisor[i] : 0);

            uint64_t take = (carry & 0xffffffffu) + borrow;
            uint64_t from = rest[i + j];

            borrow = from < take ? 1 : 0;
            rest[i + j] = (uint32_t)((from + (borrow << 32) - take) & 0xffffffffu);
            carry >>= 32;
        }
        if (borrow != 0) {                         /* one too large: add back */
            guess--;
            carry = 0;
            for (int i = 0; i <= n; i++) {
                carry += (uint64_t)rest[i + j] + (i < n ? divisor[i] : 0);
                rest[i + j] = (uint32_t)(carry & 0xffffffffu);
                carry >>= 32;
            }
        }
        quotient[j] = (uint32_t)guess;
    }
}

/* quotient = floor(a / b), rest = a - quotient b, for b > 0.  Whatever the
 * long division did, 0 <= rest < b holds at the end. */
static void divide(integer *quotient, integer *rest, const integer *a,
                   const integer *b)
{
    uint32_t limb[INTEGER_LIMBS + 1];
    integer q, r, one;

    count_work(a->length, b->length);
    if (compare_magnitudes(a, b) < 0)
        integer_set_small(&q, 0);
    else if (b->length == 1) {
        divide_by_limb(limb, a, b->limb[0]);
        set_limbs(&q, a->sign, limb, a->length);
    } else {
        divide_long(limb, a, b);
        set_limbs(&q, a->sign, limb, a->length - b->length + 1);
    }

    integer_mul(&r, &q, b);
    integer_sub(&r, a, &r);
    if (r.sign < 0) {                              /* from truncation to floor */
        integer_set_small(&one, 1);
        integer_sub(&q, &q, &one);
        integer_add(&r, &r, b);
    }
    if (r.sign < 0 || integer_compare(&r, b) >= 0)
        cannot_check("the checker's division is at fault");
    integer_set(quotient, &q);
    integer_set(rest, &r);
}

void integer_divide_floor(integer *out, const integer *a, const integer *b)
{
    integer n, d, rest;

    if (b->sign == 0)
        cannot_check("the checker divides by zero");
    integer_set(&n, a);
    integer_set(&d, b);
    if (d.sign < 0) {
        n.sign = -n.sign;
        d.sign = 1;
    }
    divide(out, &rest, &n, &d);
}

void integer_divide_ceil(integer *out, const integer *a, const integer *b)
{
    integer minus_a;

    integer_negate(&minus_a, a);
    integer_divide_floor(out, &minus_a, b);
    integer_negate(out, out);
}

/* out = a / 2^bits, towards 0; returns whether anything was lost. */
static bool shift_right(integer *out, const integer *a, long bits)
{
    int sign = a->sign;
    bool lost = false;

    if (bits < 0)
        cannot_check("the checker shifts by a negative number");
    if (bits >= integer_bits(a)) {
        integer_set_small(out, 0);
        return sign != 0;
    }

    int limbs = (int)(bits / 32);
    int rest = (int)(bits % 32);
    int length = a->length - limbs;

    for (int i = 0; i < limbs; i++)
        lost = lost || a->limb[i] != 0;
    lost = lost || (a->limb[limbs] & (((uint32_t)1 << rest) - 1)) != 0;
    for (int i = 0; i < length; i++) {             /* reads at or above i */
        uint64_t both = a->limb[limbs + i];

        if (i + 1 < length)
            both |= (uint64_t)a->limb[limbs + i + 1] << 32;
        out->limb[i] = (uint32_t)(both >> rest & 0xffffffffu);
    }
    set_limbs(out, sign, out->limb, length);
    return lost;
}

void integer_shift_floor(integer *out, const integer *a, long bits)
{
    bool negative = a->sign < 0;
    integer one;

    if (shift_right(out, a, bits) && negative) {
        integer_set_small(&one, 1);
        integer_sub(out, out, &one);
    }
}

void integer_shift_ceil(integer *out, const integer *a, long bits)
{
    bool positive = a->sign > 0;
    integer one;

    if (shift_right(out, a, bits) && positive) {
        integer_set_small(&one, 1);
        integer_add(out, out, &one);
    }
}

/* Euclid: gcd(x, y) = gcd(y, x mod y). */
void integer_gcd(integer *out, const integer *a, const integer *b)
{
    integer x, y, quotient, rest;

    integer_absolute(&x, a);
    integer_absolute(&y, b);
    while (y.sign != 0) {
        divide(&quotient, &rest, &x, &y);
        integer_set(&x, &y);
        integer_set(&y, &rest);
    }
    integer_set(out, &x);
}
