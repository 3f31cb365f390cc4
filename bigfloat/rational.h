/* rational.h: exact fractions.

   A `rational` denotes exactly one number of Q, numerator / denominator.  What always holds: the denominator
   is positive and the fraction is in lowest terms, so equal numbers have equal parts; zero is 0/1.
   Conventions, ownership and the meaning of `false` are those of integer.h. */
#ifndef BIGFLOAT_RATIONAL_H
#define BIGFLOAT_RATIONAL_H

#include "integer.h"

typedef struct {
    integer numerator;
    integer denominator;
} rational;

void rational_init(rational *z); /* z = 0; never allocates */
void rational_clear(rational *z);
static inline void rational_swap(rational *x, rational *y)
{
    rational t = *x;
    *x = *y;
    *y = t;
}

BIGFLOAT_MUST_USE bool rational_set(rational *z, const rational *x);
BIGFLOAT_MUST_USE bool rational_set_si(rational *z, int64_t p, int64_t q);         /* p / q; q != 0 */
BIGFLOAT_MUST_USE bool rational_set_integers(rational *z, const integer *p, const integer *q); /* q != 0 */
BIGFLOAT_MUST_USE bool rational_set_integer_2exp(rational *z, const integer *m, long e);       /* m 2^e */
BIGFLOAT_MUST_USE bool rational_set_double(rational *z, double x); /* exact; x must be finite */

BIGFLOAT_MUST_USE bool rational_neg(rational *z, const rational *x);
BIGFLOAT_MUST_USE bool rational_abs(rational *z, const rational *x);
BIGFLOAT_MUST_USE bool rational_add(rational *z, const rational *x, const rational *y);
BIGFLOAT_MUST_USE bool rational_sub(rational *z, const rational *x, const rational *y);
BIGFLOAT_MUST_USE bool rational_mul(rational *z, const rational *x, const rational *y);
BIGFLOAT_MUST_USE bool rational_div(rational *z, const rational *x, const rational *y); /* y != 0 */
BIGFLOAT_MUST_USE bool rational_inv(rational *z, const rational *x);                    /* x != 0 */
BIGFLOAT_MUST_USE bool rational_mul_2exp(rational *z, const rational *x, long e);
BIGFLOAT_MUST_USE bool rational_pow(rational *z, const rational *x, long n); /* x != 0 if n < 0; 0^0 = 1 */

static inline int rational_sign(const rational *x) { return integer_sign(&x->numerator); }
static inline bool rational_is_zero(const rational *x) { return integer_is_zero(&x->numerator); }
bool rational_is_integer(const rational *x);
bool rational_equal(const rational *x, const rational *y);

/* The sign of x - y.  It needs no memory (see rational_cmp.c). */
int rational_cmp(const rational *x, const rational *y);
int rational_cmp_si(const rational *x, int64_t p, int64_t q); /* sign of x - p/q; q > 0 */

BIGFLOAT_MUST_USE bool rational_floor(integer *z, const rational *x);
BIGFLOAT_MUST_USE bool rational_ceil(integer *z, const rational *x);

double rational_get_double_approx(const rational *x);

/* ---- text ---- */

/* The exponent of a decimal may be at most this, in absolute value: a short text cannot ask for a number
   that fills the memory. */
#define RATIONAL_DECIMAL_MAX_EXPONENT 100000

typedef enum {
    RATIONAL_TEXT_OK,
    RATIONAL_TEXT_MALFORMED,
    RATIONAL_TEXT_EXPONENT_TOO_LARGE,
    RATIONAL_TEXT_NO_MEMORY
} rational_text_status;

/* Reads all `length` characters as a decimal: [-+] digits [. digits] [(e|E) [-+] digits], with a digit before
   or after the point.  The value is exact. */
BIGFLOAT_MUST_USE rational_text_status rational_set_decimal(rational *z, const char *text, size_t length);

/* The same, or a fraction p/q of two integers in base 10 with q > 0. */
BIGFLOAT_MUST_USE rational_text_status rational_set_str(rational *z, const char *text, size_t length);

/* "p" or "p/q" in base 10.  The caller frees it; NULL = no memory. */
char *rational_get_str(const rational *x);

#endif
