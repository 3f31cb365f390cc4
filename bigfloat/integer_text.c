/* integer_text.c: integers as text in base 10 and 16.

   Base 10 goes through words of 19 digits; long numbers are halved at a power of 10^19 so that the work is
   that of multiplication and division. */
#include <stdlib.h>
#include <string.h>

#include "integer.h"
#include "integer_internal.h"

#define WORD_DIGITS 19
#define WORD_BASE 10000000000000000000u /* 10^19 < 2^64 */
#define SPLIT_DIGITS 600                /* longer texts are halved */

static int digit_value(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return 99;
}

/* ---- reading ---- */

static bool read_hex(integer *z, const char *text, size_t length)
{
    size_t n = (length + 15) / 16;
    limb_t *p = integer_fresh(z, n);
    if (!p)
        return false;
    limb_zero(p, n);
    for (size_t i = 0; i < length; i++) {
        size_t place = length - 1 - i;
        p[place / 16] |= (limb_t)digit_value(text[i]) << (4 * (place % 16));
    }
    integer_finish(z, n, false);
    return true;
}

static bool read_decimal_short(integer *z, const char *text, size_t length)
{
    integer word;
    integer_init(&word);
    integer_zero(z);
    bool ok = true;
    for (size_t i = 0; ok && i < length;) {
        size_t n = (length - i) % WORD_DIGITS ? (length - i) % WORD_DIGITS : WORD_DIGITS;
        uint64_t v = 0;
        for (size_t end = i + n; i < end; i++)
            v = 10 * v + (uint64_t)digit_value(text[i]);
        integer base;
        integer_init(&base);
        integer_set_ui(&base, WORD_BASE);
        integer_set_ui(&word, v);
        ok = integer_mul(z, z, &base) && integer_add(z, z, &word);
    }
    integer_clear(&word);
    return ok;
}

static bool power_of_ten(integer *z, size_t n)
{
    integer_set_si(z, 10);
    return integer_pow(z, z, n);
}

/* text = high 10^k + low with k about half the length. */
static bool read_decimal(integer *z, const char *text, size_t length)
{
    if (length <= SPLIT_DIGITS)
        return read_decimal_short(z, text, length);
    size_t k = length / 2;
    integer low, power;
    integer_init(&low);
    integer_init(&power);
    bool ok = read_decimal(z, text, length - k) && read_decimal(&low, text + length - k, k)
              && power_of_ten(&power, k) && integer_mul(z, z, &power) && integer_add(z, z, &low);
    integer_clear(&low);
    integer_clear(&power);
    return ok;
}

integer_text_status integer_set_str(integer *z, const char *text, size_t length, int base)
{
    bool negative = length && text[0] == '-';
    text += negative;
    length -= negative;
    if (length == 0)
        return INTEGER_TEXT_MALFORMED;
    for (size_t i = 0; i < length; i++)
        if (digit_value(text[i]) >= base)
            return INTEGER_TEXT_MALFORMED;
    while (length > 1 && *text == '0') {
        text++;
        length--;
    }
    if (!(base == 16 ? read_hex(z, text, length) : read_decimal(z, text, length)))
        return INTEGER_TEXT_NO_MEMORY;
    if (negative)
        z->size = -z->size;
    return INTEGER_TEXT_OK;
}

/* ---- writing ---- */

static char *write_hex(char *to, const integer *x)
{
    size_t digits = (integer_bits(x) + 3) / 4;
    for (size_t place = digits; place-- > 0;)
        *to++ = "0123456789abcdef"[integer_limbs(x)[place / 16] >> (4 * (place % 16)) & 15];
    return to;
}

/* x >= 0 as exactly `width` digits (x < 10^width) into to[0..width-1]; x is destroyed. */
static bool write_decimal_short(char *to, integer *x, size_t width)
{
    size_t n = (size_t)integer_length(x);
    limb_t *p = integer_limbs_rw(x);
    while (width) {
        uint64_t v = n ? limb_divrem_1(p, p, n, WORD_BASE) : 0;
        n = limb_normal(p, n);
        for (int i = 0; i < WORD_DIGITS && width; i++, v /= 10)
            to[--width] = (char)('0' + v % 10);
    }
    integer_finish(x, n, false);
    return true;
}

static bool write_decimal(char *to, integer *x, size_t width)
{
    if (width <= SPLIT_DIGITS)
        return write_decimal_short(to, x, width);
    size_t k = width / 2;
    integer power, low;
    integer_init(&power);
    integer_init(&low);
    bool ok = power_of_ten(&power, k) && integer_fdiv_qr(x, &low, x, &power);
    integer_clear(&power);
    ok = ok && write_decimal(to, x, width - k) && write_decimal(to + width - k, &low, k);
    integer_clear(&low);
    return ok;
}

char *integer_get_str(const integer *x, int base)
{
    size_t bits = integer_bits(x);
    size_t width = base == 16 ? bits / 4 + 1 : bits * 30103 / 100000 + 1; /* log10(2) < 0.30103 */
    char *text = malloc(width + 2), *to = text;
    if (!text)
        return NULL;
    if (x->size < 0)
        *to++ = '-';
    if (base == 16 && x->size != 0) {
        *write_hex(to, x) = 0;
        return text;
    }
    integer t;
    integer_init(&t);
    bool ok = integer_abs(&t, x) && write_decimal(to, &t, width);
    integer_clear(&t);
    if (!ok) {
        free(text);
        return NULL;
    }
    size_t zeros = 0;
    while (zeros + 1 < width && to[zeros] == '0')
        zeros++;
    memmove(to, to + zeros, width - zeros);
    to[width - zeros] = 0;
    return text;
}
