/* rational_text.c: fractions and decimals as text. */
#include <stdlib.h>
#include <string.h>

#include "rational.h"

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

/* The digits of `text`, which may contain one point, without it, as an integer; the number of digits after the
   point goes to *places. */
static rational_text_status read_digits(integer *m, unsigned long *places, const char *text, size_t length)
{
    char *digits = malloc(length + 1);
    if (!digits)
        return RATIONAL_TEXT_NO_MEMORY;
    size_t n = 0, points = 0;
    *places = 0;
    for (size_t i = 0; i < length; i++)
        if (text[i] == '.') {
            points++;
            *places = length - 1 - i;
        } else
            digits[n++] = text[i];
    integer_text_status status = points <= 1 && n && is_digit(digits[0]) ? integer_set_str(m, digits, n, 10)
                                                                          : INTEGER_TEXT_MALFORMED;
    free(digits);
    return status == INTEGER_TEXT_OK          ? RATIONAL_TEXT_OK
           : status == INTEGER_TEXT_NO_MEMORY ? RATIONAL_TEXT_NO_MEMORY
                                              : RATIONAL_TEXT_MALFORMED;
}

/* [-+] digits */
static rational_text_status read_exponent(long *e, const char *text, size_t length)
{
    bool negative = length && text[0] == '-';
    size_t i = length && (text[0] == '-' || text[0] == '+');
    if (i == length)
        return RATIONAL_TEXT_MALFORMED;
    long v = 0;
    for (; i < length; i++) {
        if (!is_digit(text[i]))
            return RATIONAL_TEXT_MALFORMED;
        v = v > RATIONAL_DECIMAL_MAX_EXPONENT ? v : 10 * v + (text[i] - '0');
    }
    *e = negative ? -v : v;
    return v > RATIONAL_DECIMAL_MAX_EXPONENT ? RATIONAL_TEXT_EXPONENT_TOO_LARGE : RATIONAL_TEXT_OK;
}

/* z = m 10^e */
static bool scale_by_ten(rational *z, const integer *m, long e)
{
    integer power;
    integer_init(&power);
    integer_set_si(&power, 10);
    bool ok = integer_pow(&power, &power, e < 0 ? 0 - (unsigned long)e : (unsigned long)e);
    if (e < 0)
        ok = ok && rational_set_integers(z, m, &power);
    else {
        ok = ok && integer_mul(&z->numerator, m, &power);
        integer_set_si(&z->denominator, 1);
    }
    integer_clear(&power);
    return ok;
}

rational_text_status rational_set_decimal(rational *z, const char *text, size_t length)
{
    bool negative = length && text[0] == '-';
    size_t skip = length && (text[0] == '-' || text[0] == '+');
    text += skip;
    length -= skip;
    size_t mantissa = 0;
    while (mantissa < length && text[mantissa] != 'e' && text[mantissa] != 'E')
        mantissa++;
    long e = 0;
    rational_text_status status = RATIONAL_TEXT_OK;
    if (mantissa < length)
        status = read_exponent(&e, text + mantissa + 1, length - mantissa - 1);
    if (status == RATIONAL_TEXT_MALFORMED)
        return status;
    integer m;
    integer_init(&m);
    unsigned long places;
    rational_text_status digits = read_digits(&m, &places, text, mantissa);
    if (digits != RATIONAL_TEXT_OK)
        status = digits;
    if (status == RATIONAL_TEXT_OK && places > RATIONAL_DECIMAL_MAX_EXPONENT)
        status = RATIONAL_TEXT_EXPONENT_TOO_LARGE;
    if (status == RATIONAL_TEXT_OK && !scale_by_ten(z, &m, e - (long)places))
        status = RATIONAL_TEXT_NO_MEMORY;
    if (status == RATIONAL_TEXT_OK && negative)
        z->numerator.size = -z->numerator.size;
    integer_clear(&m);
    return status;
}

static rational_text_status read_fraction(rational *z, const char *text, size_t length, size_t slash)
{
    integer p, q;
    integer_init(&p);
    integer_init(&q);
    integer_text_status a = integer_set_str(&p, text, slash, 10);
    integer_text_status b = integer_set_str(&q, text + slash + 1, length - slash - 1, 10);
    rational_text_status status = RATIONAL_TEXT_OK;
    if (a == INTEGER_TEXT_NO_MEMORY || b == INTEGER_TEXT_NO_MEMORY)
        status = RATIONAL_TEXT_NO_MEMORY;
    else if (a != INTEGER_TEXT_OK || b != INTEGER_TEXT_OK || integer_sign(&q) <= 0)
        status = RATIONAL_TEXT_MALFORMED;
    else if (!rational_set_integers(z, &p, &q))
        status = RATIONAL_TEXT_NO_MEMORY;
    integer_clear(&p);
    integer_clear(&q);
    return status;
}

rational_text_status rational_set_str(rational *z, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (text[i] == '/')
            return read_fraction(z, text, length, i);
    return rational_set_decimal(z, text, length);
}

char *rational_get_str(const rational *x)
{
    char *p = integer_get_str(&x->numerator, 10);
    if (!p || rational_is_integer(x))
        return p;
    char *q = integer_get_str(&x->denominator, 10);
    size_t m = strlen(p), n = q ? strlen(q) : 0;
    char *text = q ? realloc(p, m + n + 2) : NULL;
    if (!text) {
        free(p);
        free(q);
        return NULL;
    }
    text[m] = '/';
    memcpy(text + m + 1, q, n + 1);
    free(q);
    return text;
}
