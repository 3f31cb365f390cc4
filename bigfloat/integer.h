/* integer.h: signed integers of any size.

   An `integer` denotes exactly one number of Z.  It is stored as sign and magnitude in 64-bit limbs,
   lowest first.  Magnitudes below 2^128 live inside the value: such integers never allocate.

   What always holds:
     |size| is the number of limbs and the sign of size is the sign of the number; zero has size 0;
     the highest limb in use is not zero;
     capacity is 0 when the limbs are inline (and then inline limbs not in use are 0),
     else the number of limbs that `heap` can hold.
   A value that needs more than two limbs is on the heap; a smaller one may be on either side.

   Conventions.  Outputs come first.  Every output may be the same object as any input; two outputs of one
   call must be different objects.  A function that may allocate returns false when there is no memory; its
   outputs then hold unspecified values that may still be assigned to and must still be cleared. */
#ifndef BIGFLOAT_INTEGER_H
#define BIGFLOAT_INTEGER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifndef BIGFLOAT_MUST_USE
#if defined(__GNUC__)
#define BIGFLOAT_MUST_USE __attribute__((warn_unused_result))
#else
#define BIGFLOAT_MUST_USE
#endif
#endif

#define INTEGER_INLINE_LIMBS 2

typedef struct {
    int32_t size;
    uint32_t capacity;
    union {
        uint64_t inline_limbs[INTEGER_INLINE_LIMBS];
        uint64_t *heap;
    } at;
} integer;

/* The largest number of limbs that an integer may have; anything longer counts as "no memory". */
#define INTEGER_MAX_LIMBS ((int32_t)1 << 28)

static inline const uint64_t *integer_limbs(const integer *x)
{
    return x->capacity ? x->at.heap : x->at.inline_limbs;
}

static inline int32_t integer_length(const integer *x)
{
    return x->size < 0 ? -x->size : x->size;
}

/* ---- life ---- */

static inline void integer_init(integer *z) /* z = 0; never allocates */
{
    z->size = 0;
    z->capacity = 0;
    z->at.inline_limbs[0] = z->at.inline_limbs[1] = 0;
}
void integer_clear(integer *z); /* releases the limbs and leaves z = 0 */
static inline void integer_swap(integer *x, integer *y)
{
    integer t = *x;
    *x = *y;
    *y = t;
}

/* ---- assignment ---- */

BIGFLOAT_MUST_USE bool integer_set(integer *z, const integer *x);
void integer_zero(integer *z);                 /* never allocates */
void integer_set_si(integer *z, int64_t v);    /* never allocates */
void integer_set_ui(integer *z, uint64_t v);   /* never allocates */

/* z = the number that the limbs 0..n-1 hold, negated if `negative`; high zero limbs are allowed. */
BIGFLOAT_MUST_USE bool integer_set_limbs(integer *z, const uint64_t *limb, size_t n, bool negative);

/* ---- inspection ---- */

static inline int integer_sign(const integer *x) { return (x->size > 0) - (x->size < 0); }
static inline bool integer_is_zero(const integer *x) { return x->size == 0; }
static inline bool integer_is_odd(const integer *x) { return x->size != 0 && (integer_limbs(x)[0] & 1); }
bool integer_is_one(const integer *x);
int integer_cmp(const integer *x, const integer *y);     /* sign of x - y */
int integer_cmp_abs(const integer *x, const integer *y); /* sign of |x| - |y| */
int integer_cmp_si(const integer *x, int64_t v);
size_t integer_bits(const integer *x);                   /* least n with |x| < 2^n */
size_t integer_trailing_zeros(const integer *x);         /* largest n with 2^n | x; 0 for x = 0 */
bool integer_fits_si(const integer *x);                  /* -2^63 <= x < 2^63 */
int64_t integer_get_si(const integer *x);                /* requires integer_fits_si(x) */
double integer_get_double_approx(const integer *x);      /* near x, possibly infinite */

/* ---- ring operations ---- */

BIGFLOAT_MUST_USE bool integer_neg(integer *z, const integer *x);
BIGFLOAT_MUST_USE bool integer_abs(integer *z, const integer *x);
BIGFLOAT_MUST_USE bool integer_add(integer *z, const integer *x, const integer *y);
BIGFLOAT_MUST_USE bool integer_sub(integer *z, const integer *x, const integer *y);
BIGFLOAT_MUST_USE bool integer_mul(integer *z, const integer *x, const integer *y);
BIGFLOAT_MUST_USE bool integer_sqr(integer *z, const integer *x);
BIGFLOAT_MUST_USE bool integer_add_si(integer *z, const integer *x, int64_t v);
BIGFLOAT_MUST_USE bool integer_mul_si(integer *z, const integer *x, int64_t v);
BIGFLOAT_MUST_USE bool integer_addmul(integer *z, const integer *x, const integer *y); /* z += x y */
BIGFLOAT_MUST_USE bool integer_submul(integer *z, const integer *x, const integer *y); /* z -= x y */
BIGFLOAT_MUST_USE bool integer_pow(integer *z, const integer *x, unsigned long n);     /* 0^0 = 1 */

/* ---- powers of two ---- */

BIGFLOAT_MUST_USE bool integer_mul_2exp(integer *z, const integer *x, unsigned long n);  /* x 2^n */
BIGFLOAT_MUST_USE bool integer_fdiv_2exp(integer *z, const integer *x, unsigned long n); /* floor(x / 2^n) */
BIGFLOAT_MUST_USE bool integer_cdiv_2exp(integer *z, const integer *x, unsigned long n); /* ceil(x / 2^n) */

/* ---- division; the divisor must not be 0 ---- */

/* x = q y + r with q = floor(x / y).  q or r may be NULL when it is not wanted. */
BIGFLOAT_MUST_USE bool integer_fdiv_qr(integer *q, integer *r, const integer *x, const integer *y);
BIGFLOAT_MUST_USE bool integer_fdiv_q(integer *q, const integer *x, const integer *y); /* floor(x / y) */
BIGFLOAT_MUST_USE bool integer_cdiv_q(integer *q, const integer *x, const integer *y); /* ceil(x / y) */
/* q = x / y, which must be an integer. */
BIGFLOAT_MUST_USE bool integer_divexact(integer *q, const integer *x, const integer *y);
/* z = the greatest common divisor, not negative; gcd(0, 0) = 0. */
BIGFLOAT_MUST_USE bool integer_gcd(integer *z, const integer *x, const integer *y);

/* z = floor(sqrt(x)); x must not be negative. */
BIGFLOAT_MUST_USE bool integer_sqrt(integer *z, const integer *x);
/* x = z^2 + r, 0 <= r <= 2 z.  r may be NULL. */
BIGFLOAT_MUST_USE bool integer_sqrt_rem(integer *z, integer *r, const integer *x);

/* ---- text ---- */

typedef enum { INTEGER_TEXT_OK, INTEGER_TEXT_MALFORMED, INTEGER_TEXT_NO_MEMORY } integer_text_status;

/* Reads all `length` characters as an optional '-' and at least one digit in base 10 or 16 (either case, no
   prefix).  Unless the answer is OK, z is unspecified. */
BIGFLOAT_MUST_USE integer_text_status integer_set_str(integer *z, const char *text, size_t length, int base);

/* Lower-case digits without leading zeros, '-' in front of negative numbers.  The caller frees the answer;
   NULL means no memory.  base is 10 or 16. */
char *integer_get_str(const integer *x, int base);

#endif
