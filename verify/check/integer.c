/* Integers of fixed capacity.
 *
 * School arithmetic on limbs in base 2^32, with products in uint64_t.  What is
 * difficult is not trusted: long division multiplies its quotient back and
 * compares each time (divide()), and the square root is squared.
 *
 * Work is counted here, since all time is spent here: after WORK_LIMIT limb
 * products the answer is "cannot check".  So every run ends.
 */

#include "integer.h"

#include "answer.h"

#include <stdlib.h>
#include <string.h>

/* About a quarter of an hour. */
static const uint64_t WORK_LIMIT = UINT64_C(1000000000000);

void integer_count_work(int rows, int columns)
{
    static uint64_t work = 0;

    work += (uint64_t)rows * (uint64_t)columns + 1;
    if (work > WORK_LIMIT)
        cannot_check("this certificate needs more work than the checker's limit");
}

/* Magnitudes
 * ---------- */

static const uint32_t *limbs(const integer *a)
{
    if (a->length >= 0 && a->length <= SHORT_LIMBS)
        return a->limb.here;
    if (a->length < 0 || a->limb.there[-1] != a->serial)
        cannot_check("the checker uses a number after its time");
    return a->limb.there;
}

/* sign * limb[0..length) */
static integer make(int sign, const uint32_t *limb, int length)
{
    static uint32_t last_serial = 0;
    uint32_t *there;

    while (length > 0 && limb[length - 1] == 0)
        length--;
    if (length <= SHORT_LIMBS)
        return (integer) { length > 0 ? sign : 0, length, 0,
                           { { length > 0 ? limb[0] : 0, length > 1 ? limb[1] : 0 } } };
    if (length > INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);
    there = scratch_new(((size_t)length + 1) * sizeof limb[0]);
    last_serial = (last_serial + 1) & 0x7fffffffu; /* never what scratch_release() writes */
    *there++ = last_serial;
    for (int i = 0; i < length; i++)
        there[i] = limb[i];
    return (integer) { sign, length, last_serial, { .there = there } };
}

/* Copies the limbs of a, and what stands in front of them; returns what is behind the copy. */
static uint32_t *copy_limbs(uint32_t *to, const integer *a)
{
    size_t count = (size_t)a->length + 1;

    memcpy(to, limbs(a) - 1, count * sizeof to[0]);
    return to + count;
}

void integer_keep(struct mark mark, integer *values, size_t count)
{
    size_t total = 0;
    uint32_t *copy, *at, *home;

    for (size_t i = 0; i < count; i++)
        if (values[i].length > SHORT_LIMBS)
            total += (size_t)values[i].length + 1;
    if (total == 0) {
        scratch_release(mark);
        return;
    }
    at = copy = malloc(total * sizeof copy[0]);
    if (copy == NULL)
        cannot_check("there is not enough memory");
    for (size_t i = 0; i < count; i++)
        if (values[i].length > SHORT_LIMBS)
            at = copy_limbs(at, &values[i]);
    scratch_release(mark);
    home = memcpy(scratch_new(total * sizeof home[0]), copy, total * sizeof home[0]);
    free(copy);
    for (size_t i = 0; i < count; i++) {
        if (values[i].length > SHORT_LIMBS) {
            values[i].limb.there = home + 1;
            home += values[i].length + 1;
        }
    }
}

void integer_store(integer *a, uint32_t *home)
{
    if (a->length <= SHORT_LIMBS)
        return;
    copy_limbs(home, a);
    a->limb.there = home + 1;
}

static int compare_magnitudes(const integer *a, const integer *b)
{
    const uint32_t *x = limbs(a), *y = limbs(b);

    if (a->length != b->length)
        return a->length < b->length ? -1 : 1;
    for (int i = a->length - 1; i >= 0; i--)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}

/* sign (|a| + |b|), where a is not shorter */
static integer add_magnitudes(int sign, const integer *a, const integer *b)
{
    uint32_t sum[INTEGER_LIMBS + 1];
    const uint32_t *x = limbs(a), *y = limbs(b);
    uint64_t carry = 0;

    for (int i = 0; i < a->length; i++) {
        carry += (uint64_t)x[i] + (i < b->length ? y[i] : 0);
        sum[i] = (uint32_t)(carry & 0xffffffffu);
        carry >>= 32;
    }
    sum[a->length] = (uint32_t)carry;
    return make(sign, sum, a->length + 1);
}

/* sign (|a| - |b|) where |a| >= |b| */
static integer sub_magnitudes(int sign, const integer *a, const integer *b)
{
    uint32_t difference[INTEGER_LIMBS];
    const uint32_t *x = limbs(a), *y = limbs(b);
    uint64_t borrow = 0;

    for (int i = 0; i < a->length; i++) {
        uint64_t take = (uint64_t)(i < b->length ? y[i] : 0) + borrow;
        uint64_t from = x[i];

        borrow = from < take ? 1 : 0;
        difference[i] = (uint32_t)((from + (borrow << 32) - take) & 0xffffffffu);
    }
    return make(sign, difference, a->length);
}

/* Values in and out
 * ----------------- */

integer integer_from(int64_t a)
{
    uint64_t magnitude = a < 0 ? (uint64_t)0 - (uint64_t)a : (uint64_t)a;
    uint32_t limb[2] = { (uint32_t)(magnitude & 0xffffffffu),
                         (uint32_t)(magnitude >> 32) };

    return make(a < 0 ? -1 : 1, limb, 2);
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
    uint32_t limb[INTEGER_LIMBS] = { 0 };

    if (digits == 0)
        return false;
    for (size_t i = 0; i < digits; i++)
        if (hex_digit(digit[i]) < 0)
            return false;
    if (digit[0] == '0' && (digits > 1 || negative))
        return false;
    if (digits > 8 * INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);
    for (size_t i = 0; i < digits; i++)            /* i-th digit from the right */
        limb[i / 8] |= (uint32_t)hex_digit(digit[digits - 1 - i]) << (4 * (i % 8));
    *out = make(negative ? -1 : 1, limb, (int)((digits + 7) / 8));
    return true;
}

int integer_compare(integer a, integer b)
{
    if (a.sign != b.sign)
        return a.sign < b.sign ? -1 : 1;
    return a.sign * compare_magnitudes(&a, &b);
}

long integer_bits(integer a)
{
    long bits = 32L * a.length;

    if (a.length == 0)
        return 0;
    for (uint32_t top = limbs(&a)[a.length - 1]; top < 0x80000000u; top <<= 1)
        bits--;
    return bits;
}

bool integer_get_small(int64_t *out, integer a, int64_t bound)
{
    uint64_t magnitude = 0;

    if (a.length > 2)
        return false;
    for (int i = a.length - 1; i >= 0; i--)
        magnitude = magnitude << 32 | limbs(&a)[i];
    if (bound < 0 || magnitude > (uint64_t)bound)
        return false;
    *out = a.sign * (int64_t)magnitude;
    return true;
}

/* Exact arithmetic
 * ---------------- */

integer integer_negate(integer a)
{
    a.sign = (int16_t)-a.sign;
    return a;
}

integer integer_absolute(integer a)
{
    a.sign = a.sign != 0 ? 1 : 0;
    return a;
}

integer integer_add(integer a, integer b)
{
    if (a.sign == 0)
        return b;
    if (b.sign == 0)
        return a;
    if (a.sign == b.sign)
        return a.length >= b.length ? add_magnitudes(a.sign, &a, &b)
                                    : add_magnitudes(a.sign, &b, &a);
    if (compare_magnitudes(&a, &b) >= 0)
        return sub_magnitudes(a.sign, &a, &b);
    return sub_magnitudes(b.sign, &b, &a);
}

integer integer_sub(integer a, integer b)
{
    return integer_add(a, integer_negate(b));
}

integer integer_mul(integer a, integer b)
{
    uint32_t product[2 * INTEGER_LIMBS];
    const uint32_t *x = limbs(&a), *y = limbs(&b);

    if (a.sign == 0 || b.sign == 0)
        return integer_from(0);
    integer_count_work(a.length, b.length);
    for (int i = 0; i < a.length + b.length; i++)
        product[i] = 0;
    for (int i = 0; i < a.length; i++) {
        uint64_t factor = x[i];
        uint64_t carry = 0;

        /* (2^32-1)^2 + 2 (2^32-1) < 2^64: no overflow. */
        for (int j = 0; j < b.length; j++) {
            carry += factor * y[j] + product[i + j];
            product[i + j] = (uint32_t)(carry & 0xffffffffu);
            carry >>= 32;
        }
        product[i + b.length] = (uint32_t)carry;
    }
    return make(a.sign * b.sign, product, a.length + b.length);
}

integer integer_min(integer a, integer b)
{
    return integer_compare(a, b) <= 0 ? a : b;
}

integer integer_max(integer a, integer b)
{
    return integer_compare(a, b) >= 0 ? a : b;
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

integer integer_shift_left(integer a, long bits)
{
    uint32_t shifted[INTEGER_LIMBS + 2];
    int zeros = (int)(bits / 32);

    if (a.sign == 0)
        return a;
    if (bits < 0 || bits + integer_bits(a) > 32L * INTEGER_LIMBS)
        cannot_check("a number of more than %d bits occurs", 32 * INTEGER_LIMBS);
    for (int i = 0; i < zeros; i++)
        shifted[i] = 0;
    shift_limbs(shifted + zeros, limbs(&a), a.length, (int)(bits % 32));
    return make(a.sign, shifted, zeros + a.length + 1);
}

/* Division
 * -------- */

/* quotient[0 .. a.length - b.length] = floor(|a| / |b|), for a.length >= b.length: Knuth, The
 * Art of Computer Programming 2, 4.3.1, Algorithm D, with a limb of 0 below both, so that b
 * has two.  divide() checks the result. */
static void divide_long(uint32_t *quotient, const integer *a, const integer *b)
{
    uint32_t rest[INTEGER_LIMBS + 2], divisor[INTEGER_LIMBS + 2];
    int n = b->length + 1, bits = 0;

    rest[0] = divisor[0] = 0;
    while ((limbs(b)[b->length - 1] << bits & 0x80000000u) == 0)
        bits++;
    shift_limbs(rest + 1, limbs(a), a->length, bits);
    shift_limbs(divisor + 1, limbs(b), b->length, bits);

    for (int j = a->length - b->length; j >= 0; j--) {
        uint64_t top = (uint64_t)rest[j + n] << 32 | rest[j + n - 1];
        uint64_t guess = top / divisor[n - 1], left = top % divisor[n - 1];
        uint64_t carry = 0, borrow = 0;

        /* The guess is at most 2 too large; mostly this makes it right. */
        while (guess >> 32 != 0 ||
               guess * divisor[n - 2] > (left << 32 | rest[j + n - 2])) {
            guess--;
            left += divisor[n - 1];
            if (left >> 32 != 0)
                break;
        }
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

/* Returns floor(a / b), rest = a - b floor(a / b), for b > 0.  Whatever the long
 * division did, 0 <= rest < b holds at the end. */
static integer divide(integer *rest, integer a, integer b)
{
    uint32_t limb[INTEGER_LIMBS + 1];
    integer q = integer_from(0);

    integer_count_work(a.length, b.length);
    if (compare_magnitudes(&a, &b) >= 0) {
        divide_long(limb, &a, &b);
        q = make(a.sign, limb, a.length - b.length + 1);
    }
    *rest = integer_sub(a, integer_mul(q, b));
    if (rest->sign < 0) {                          /* from truncation to floor */
        q = integer_sub(q, integer_from(1));
        *rest = integer_add(*rest, b);
    }
    if (rest->sign < 0 || integer_compare(*rest, b) >= 0)
        cannot_check("the checker's division is at fault");
    return q;
}

integer integer_divide_floor(integer a, integer b)
{
    integer rest;

    if (b.sign == 0)
        cannot_check("the checker divides by zero");
    if (b.sign < 0)
        return divide(&rest, integer_negate(a), integer_negate(b));
    return divide(&rest, a, b);
}

integer integer_divide_ceil(integer a, integer b)
{
    return integer_negate(integer_divide_floor(integer_negate(a), b));
}

/* a / 2^bits, towards 0, or if `away` away from 0. */
static integer shift_right(integer a, long bits, bool away)
{
    uint32_t shifted[INTEGER_LIMBS];
    const uint32_t *limb = limbs(&a);
    int skip = (int)(bits / 32), rest = (int)(bits % 32), length = a.length - skip;
    bool lost = false;
    integer out;

    if (bits < 0)
        cannot_check("the checker shifts by a negative number");
    if (length <= 0)
        return integer_from(away ? a.sign : 0);
    for (int i = 0; i < length; i++) {
        uint64_t both = limb[skip + i];

        if (i + 1 < length)
            both |= (uint64_t)limb[skip + i + 1] << 32;
        shifted[i] = (uint32_t)(both >> rest & 0xffffffffu);
    }
    out = make(a.sign, shifted, length);
    if (!away)
        return out;
    for (int i = 0; i < skip && !lost; i++)
        lost = limb[i] != 0;
    lost = lost || (limb[skip] & (((uint32_t)1 << rest) - 1)) != 0;
    return lost ? integer_add(out, integer_from(a.sign)) : out;
}

integer integer_shift_floor(integer a, long bits)
{
    return shift_right(a, bits, a.sign < 0);
}

integer integer_shift_ceil(integer a, long bits)
{
    return shift_right(a, bits, a.sign > 0);
}

/* Euclid: gcd(x, y) = gcd(y, x mod y). */
integer integer_gcd(integer a, integer b)
{
    struct mark mark = scratch_mark();
    integer pair[2] = { integer_absolute(a), integer_absolute(b) };

    while (pair[1].sign != 0) {
        integer rest;

        divide(&rest, pair[0], pair[1]);
        pair[0] = pair[1];
        pair[1] = rest;
        integer_keep(mark, pair, 2);
    }
    return pair[0];
}

/* Newton's iteration from above: x > floor(root) implies that
 * floor((x + floor(a/x))/2) is smaller than x and not below floor(root). */
integer integer_root(integer a)
{
    struct mark mark = scratch_mark();
    integer x, next, above;

    if (a.sign <= 0)
        return integer_from(0);
    x = integer_shift_left(integer_from(1), (integer_bits(a) + 1) / 2);
    for (;;) {
        next = integer_shift_floor(integer_add(x, integer_divide_floor(a, x)), 1);
        if (integer_compare(next, x) >= 0)
            break;
        x = next;
        integer_keep(mark, &x, 1);
    }
    above = integer_add(x, integer_from(1));
    if (integer_compare(integer_mul(x, x), a) > 0 ||
        integer_compare(integer_mul(above, above), a) <= 0)
        cannot_check("the checker's square root is at fault");
    integer_keep(mark, &x, 1);
    return x;
}
