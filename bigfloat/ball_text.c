/* ball_text.c: balls as decimal text, outward both ways, and in an exact form. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "ball.h"
#include "ball_internal.h"

/* Beyond this |exponent| the decimal forms fall back on the exact one: they would be that long. */
#define DECIMAL_MAX_EXPONENT 400000

static char *copy_text(const char *text)
{
    size_t n = strlen(text) + 1;
    char *copy = malloc(n);
    return copy ? memcpy(copy, text, n) : NULL;
}

/* floor(n log10(2)) within 1, |n| < 10^9. */
static long decimal_scale(int64_t n) { return (long)(n * 30103 / 100000) - (n < 0); }

/* ---- the decimal and its error ---- */

/* z = z 2^a 10^b, a, b >= 0 */
static bool scale(integer *z, unsigned long a, unsigned long b)
{
    integer t;
    integer_init(&t);
    integer_set_si(&t, 10);
    bool ok = integer_pow(&t, &t, b) && integer_mul(z, z, &t) && integer_mul_2exp(z, z, a);
    integer_clear(&t);
    return ok;
}

/* n = the integer nearest m 2^e 10^k, and rest / unit >= |m 2^e 10^k - n| + err 2^e 10^k. */
static bool nearest_decimal(integer *n, integer *rest, integer *unit, const ball *x, long k)
{
    unsigned long up2 = x->exponent > 0 ? (unsigned long)x->exponent : 0;
    unsigned long down2 = x->exponent < 0 ? (unsigned long)-x->exponent : 0;
    unsigned long up10 = k > 0 ? (unsigned long)k : 0, down10 = k < 0 ? (unsigned long)-k : 0;
    integer m, t;
    integer_init(&m);
    integer_init(&t);
    integer_set_si(unit, 1);
    integer_set_ui(rest, x->error);
    bool ok = integer_set_limbs(&m, ball_limbs(x), ball_length(x), x->size < 0) && scale(&m, up2, up10)
              && scale(rest, up2, up10) && scale(unit, down2, down10) && integer_mul_2exp(&t, &m, 1)
              && integer_add(&t, &t, unit) && integer_fdiv_2exp(&t, &t, 1) && integer_fdiv_q(n, &t, unit)
              && integer_mul(&t, n, unit) && integer_sub(&t, &m, &t) && integer_abs(&t, &t)
              && integer_add(rest, rest, &t);
    integer_clear(&m);
    integer_clear(&t);
    return ok;
}

/* *digits 10^*j >= rest / unit with *digits < 100, at most 10% more if rest / unit >= 10^-1000. */
static bool two_digits(int *digits, long *j, const integer *rest, const integer *unit)
{
    integer a, b, q;
    integer_init(&a);
    integer_init(&b);
    integer_init(&q);
    long at = decimal_scale((int64_t)integer_bits(rest) - (int64_t)integer_bits(unit)) - 3;
    bool ok = true;
    for (;; at++) {
        ok = integer_set(&a, rest) && integer_set(&b, unit) && scale(&a, 0, at < 0 ? (unsigned long)-at : 0)
             && scale(&b, 0, at > 0 ? (unsigned long)at : 0) && integer_cdiv_q(&q, &a, &b);
        if (!ok || integer_cmp_si(&q, 99) <= 0)
            break;
    }
    if (ok)
        *digits = (int)integer_get_si(&q);
    *j = at;
    integer_clear(&a);
    integer_clear(&b);
    integer_clear(&q);
    return ok;
}

/* n 10^-k in plain or scientific notation; the caller frees. */
static char *write_scaled(const integer *n, long k)
{
    char *digits = integer_get_str(n, 10);
    if (!digits)
        return NULL;
    bool negative = digits[0] == '-';
    char *d = digits + negative;
    long length = (long)strlen(d), point = length - k; /* the point comes after `point` digits */
    size_t room = (size_t)(length + (k > 0 ? k : -k) + 64);
    char *text = malloc(room), *to = text;
    if (text) {
        if (negative)
            *to++ = '-';
        if (integer_is_zero(n))
            strcpy(to, "0");
        else if (k <= 0 && point <= length + 6) /* an integer, few zeros to add */
            snprintf(to, room - 1, "%s%.*s", d, (int)-k, "000000");
        else if (k > 0 && point > 0)
            snprintf(to, room - 1, "%.*s.%s", (int)point, d, d + point);
        else if (k > 0 && point > -6)
            snprintf(to, room - 1, "0.%.*s%s", (int)-point, "000000", d);
        else
            snprintf(to, room - 1, "%c%s%se%ld", d[0], length > 1 ? "." : "", d + 1, point - 1);
    }
    free(digits);
    return text;
}

/* The ball rounded to units of 10^-k, with its error. */
static char *write_decimal(const ball *x, long k)
{
    integer n, rest, unit;
    integer_init(&n);
    integer_init(&rest);
    integer_init(&unit);
    char *text = NULL;
    int digits = 0;
    long j = 0;
    bool ok = nearest_decimal(&n, &rest, &unit, x, k);
    bool exact = ok && integer_is_zero(&rest);
    if (ok && (exact || two_digits(&digits, &j, &rest, &unit)))
        text = write_scaled(&n, k);
    integer_clear(&n);
    integer_clear(&rest);
    integer_clear(&unit);
    if (!text || exact)
        return text;
    size_t length = strlen(text);
    char *longer = realloc(text, length + 48);
    if (!longer) {
        free(text);
        return NULL;
    }
    j -= k;
    if (digits >= 10)
        sprintf(longer + length, " +/- %d.%de%ld", digits / 10, digits % 10, j + 1);
    else
        sprintf(longer + length, " +/- %de%ld", digits, j);
    return longer;
}

static bool has_decimal(const ball *x)
{
    return x->exponent <= DECIMAL_MAX_EXPONENT && x->exponent >= -DECIMAL_MAX_EXPONENT
           && ball_mantissa_bits(x) <= 2 * DECIMAL_MAX_EXPONENT;
}

/* An odd number times 2^-p has p decimals; integers have none. */
static int64_t decimal_places(const ball *x)
{
    int64_t places = -(x->exponent + (int64_t)limb_trailing_zeros(ball_limbs(x), ball_length(x)));
    return places > 0 ? places : 0;
}

char *ball_get_decimal(const ball *x, int digits)
{
    if (ball_is_special(x))
        return copy_text("indeterminate");
    if (!has_decimal(x))
        return ball_get_hex(x);
    if (ball_is_exact_zero(x))
        return copy_text("0");
    if (digits < 1)
        digits = 1;
    int64_t bits = (int64_t)ball_mantissa_bits(x);
    long k = digits - 1 - decimal_scale(bits - 1 + x->exponent);
    if (x->error) { /* no digits below a tenth of the error */
        long most = 2 - decimal_scale(limb_bits(x->error) - 1 + x->exponent);
        k = k < most && x->size ? k : most;
    } else {
        int64_t places = decimal_places(x);
        k = k > places ? (long)places : k;
    }
    return write_decimal(x, k);
}

/* With 10^-k <= err 2^e the rounding adds at most half the error, and two digits at most 10% more. */
char *ball_get_str(const ball *x)
{
    if (ball_is_special(x))
        return copy_text("indeterminate");
    if (!has_decimal(x))
        return ball_get_hex(x);
    if (ball_is_exact_zero(x))
        return copy_text("0");
    if (x->error == 0)
        return write_decimal(x, (long)decimal_places(x));
    return write_decimal(x, 1 - decimal_scale(limb_bits(x->error) - 1 + x->exponent));
}

/* ---- reading ---- */

static const char *find(const char *text, size_t length, const char *what)
{
    size_t n = strlen(what);
    for (size_t i = 0; i + n <= length; i++)
        if (memcmp(text + i, what, n) == 0)
            return text + i;
    return NULL;
}

rational_text_status ball_set_str(ball *z, const char *text, size_t length, long prec)
{
    if (length == 13 && memcmp(text, "indeterminate", 13) == 0) {
        ball_indeterminate(z);
        return RATIONAL_TEXT_OK;
    }
    const char *sign = find(text, length, " +/- ");
    rational middle, error;
    rational_init(&middle);
    rational_init(&error);
    size_t first = sign ? (size_t)(sign - text) : length;
    rational_text_status status = rational_set_decimal(&middle, text, first);
    if (status == RATIONAL_TEXT_OK && sign)
        status = rational_set_decimal(&error, sign + 5, length - first - 5);
    if (status == RATIONAL_TEXT_OK) {
        ball r;
        ball_init(&r);
        ball_set_rational(z, &middle, prec);
        ball_set_rational(&r, &error, 64);
        if (sign)
            ball_add_error(z, z, &r, prec);
        ball_clear(&r);
    }
    rational_clear(&middle);
    rational_clear(&error);
    return status;
}

/* ---- the exact form ---- */

char *ball_get_hex(const ball *x)
{
    if (ball_is_special(x))
        return copy_text("indeterminate");
    integer m;
    integer_init(&m);
    char *digits = ball_get_parts(&m, NULL, NULL, x) ? integer_get_str(&m, 16) : NULL;
    integer_clear(&m);
    if (!digits)
        return NULL;
    bool negative = digits[0] == '-';
    size_t room = strlen(digits) + 64;
    char *text = malloc(room);
    if (text)
        snprintf(text, room, "%s0x%s 0x%" PRIx64 " %" PRId64, negative ? "-" : "", digits + negative, x->error, x->exponent);
    free(digits);
    return text;
}

/* The word from *at up to the next blank or the end. */
static const char *next_word(size_t *n, const char **at, const char *end)
{
    const char *word = *at, *p = word;
    while (p < end && *p != ' ')
        p++;
    *n = (size_t)(p - word);
    *at = p < end ? p + 1 : end;
    return word;
}

static integer_text_status read_word(integer *z, const char *word, size_t n, int base)
{
    if (base == 10)
        return integer_set_str(z, word, n, 10);
    bool negative = n && word[0] == '-';
    word += negative;
    n -= negative;
    if (n < 3 || word[0] != '0' || word[1] != 'x' || word[2] == '-')
        return INTEGER_TEXT_MALFORMED;
    integer_text_status status = integer_set_str(z, word + 2, n - 2, 16);
    if (status == INTEGER_TEXT_OK && negative)
        z->size = -z->size;
    return status;
}

rational_text_status ball_set_hex(ball *z, const char *text, size_t length)
{
    if (length == 13 && memcmp(text, "indeterminate", 13) == 0) {
        ball_indeterminate(z);
        return RATIONAL_TEXT_OK;
    }
    const char *at = text, *end = text + length;
    integer part[3];
    rational_text_status status = RATIONAL_TEXT_OK;
    for (int i = 0; i < 3; i++) {
        integer_init(&part[i]);
        size_t n;
        const char *word = next_word(&n, &at, end);
        integer_text_status s = read_word(&part[i], word, n, i < 2 ? 16 : 10);
        if (s != INTEGER_TEXT_OK && status == RATIONAL_TEXT_OK)
            status = s == INTEGER_TEXT_NO_MEMORY ? RATIONAL_TEXT_NO_MEMORY : RATIONAL_TEXT_MALFORMED;
    }
    if (status == RATIONAL_TEXT_OK
        && (at != end || text[length - 1] == ' ' || part[1].size < 0 || integer_bits(&part[1]) > BALL_ERROR_BITS
            || integer_bits(&part[2]) > 41))
        status = RATIONAL_TEXT_MALFORMED;
    if (status == RATIONAL_TEXT_OK)
        ball_set_parts(z, &part[0], part[1].size ? integer_limbs(&part[1])[0] : 0, integer_get_si(&part[2]));
    for (int i = 0; i < 3; i++)
        integer_clear(&part[i]);
    return status;
}
