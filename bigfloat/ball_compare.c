/* ball_compare.c: exact comparison of endpoints, and the questions about balls. */
#include "ball.h"
#include "ball_internal.h"

/* ---- dyadic numbers ---- */

/* The 64 bits of w whose highest has the weight 2^(e + top - 1 - 64 i), counted from position `top` bits. */
static limb_t window(const dyadic *x, int64_t bits, int64_t i)
{
    int64_t low = bits - 64 * (i + 1); /* position of the window's lowest bit */
    if (low <= -64)
        return 0;
    if (low < 0)
        return x->w[0] << -low;
    size_t at = (size_t)low / 64;
    unsigned s = (unsigned)(low % 64);
    limb_t v = x->w[at] >> s;
    return s && at + 1 < x->n ? v | x->w[at + 1] << (64 - s) : v;
}

static int compare_magnitudes(const dyadic *x, const dyadic *y)
{
    int64_t bx = (int64_t)limb_bit_length(x->w, x->n), by = (int64_t)limb_bit_length(y->w, y->n);
    if (bx + x->e != by + y->e)
        return bx + x->e < by + y->e ? -1 : 1;
    int64_t most = (bx > by ? bx : by) / 64 + 1;
    for (int64_t i = 0; i < most; i++) {
        limb_t a = window(x, bx, i), b = window(y, by, i);
        if (a != b)
            return a < b ? -1 : 1;
    }
    return 0;
}

int ball_dyadic_compare(const dyadic *x, const dyadic *y)
{
    int s = x->n == 0 ? 0 : x->negative ? -1 : 1, t = y->n == 0 ? 0 : y->negative ? -1 : 1;
    if (s != t)
        return s < t ? -1 : 1;
    return s == 0 ? 0 : s * compare_magnitudes(x, y);
}

void ball_endpoint(dyadic *d, limb_t *w, const ball *x, bool upper)
{
    size_t n = ball_length(x);
    d->negative = x->size < 0;
    d->e = x->exponent;
    d->w = w;
    limb_copy(w, ball_limbs(x), n);
    w[n] = 0;
    if (n == 0) {
        w[0] = x->error;
        d->negative = !upper;
        d->n = x->error != 0;
        return;
    }
    if (d->negative != upper) /* away from 0 */
        limb_add_1(w, w, n + 1, x->error);
    else if (limb_sub_1(w, w, n, x->error)) { /* past 0: n = 1 */
        w[0] = 0 - w[0];
        d->negative = !d->negative;
    }
    d->n = limb_normal(w, n + 1);
}

/* The order of an endpoint of x and one of y; 2 = no memory. */
static int compare_endpoints(const ball *x, bool x_upper, const ball *y, bool y_upper)
{
    ball_scratch space;
    size_t m = ball_length(x) + 1, n = ball_length(y) + 1;
    limb_t *w = ball_scratch_new(&space, m + n);
    int order = 2;
    if (w) {
        dyadic a, b;
        ball_endpoint(&a, w, x, x_upper);
        ball_endpoint(&b, w + m, y, y_upper);
        order = ball_dyadic_compare(&a, &b);
    }
    ball_scratch_free(&space);
    return order;
}

/* ---- leading words ---- */

/* Has every number the sign of m?  (Then m != 0.) */
static inline bool sign_is_sure(const ball *x)
{
    return x->size > 1 || x->size < -1 || (x->size && ball_limbs(x)[0] > x->error);
}

/* low 2^at <= |x| <= high 2^at for every x of a ball whose sign is sure, with 2^62 <= low, high < 2^64; false: the error
   is too large for that. */
typedef struct {
    limb_t low, high;
    int64_t at;
} leading;

static inline bool leading_word(leading *l, const ball *x)
{
    size_t n = ball_length(x);
    const limb_t *m = ball_limbs(x);
    int c = limb_clz(m[n - 1]);
    limb_t w = m[n - 1] << c, e = x->error;
    if (n > 1) {
        w |= (m[n - 2] >> 1) >> (63 - c);
        int64_t k = 64 * (int64_t)(n - 1) - c; /* units of 2^k */
        e = k < 30 ? (e >> k) + 2 : 2;         /* ROUNDING: ceiling, and the digits below w */
        l->at = x->exponent + k;
    } else {
        if (limb_bits(e) + c > 62)
            return false;
        e <<= c;
        l->at = x->exponent - c;
    }
    l->low = w - e;
    l->high = w + e;
    return e < (limb_t)1 << 62 && l->high > w - e && l->low >> 62;
}

/* -1: every |x| is less than every |y|; 1: greater; 0: not seen at once. */
static inline int quick_magnitudes(const ball *x, const ball *y)
{
    leading a, b;
    if (!leading_word(&a, x) || !leading_word(&b, y))
        return 0;
    int64_t d = a.at - b.at;
    if (d >= 3 || d <= -3) /* 2^62 2^3 > 2^64 */
        return d < 0 ? -1 : 1;
    if (d > 0) { /* floor and ceiling of the lower one's words at the higher scale */
        b.low >>= d;
        b.high = (b.high >> d) + 1;
    } else if (d < 0) {
        a.low >>= -d;
        a.high = (a.high >> -d) + 1;
    }
    return a.high < b.low ? -1 : b.high < a.low ? 1 : 0;
}

/* The same for the numbers themselves; both balls finite. */
static inline int quick_order(const ball *x, const ball *y)
{
    if (!sign_is_sure(x) || !sign_is_sure(y))
        return 0;
    if ((x->size < 0) != (y->size < 0))
        return x->size < 0 ? -1 : 1;
    int c = quick_magnitudes(x, y);
    return x->size < 0 ? -c : c;
}

/* ---- signs ---- */

bool ball_contains_zero(const ball *x)
{
    return !sign_is_sure(x); /* an indeterminate ball has size 0 */
}

truth ball_is_positive(const ball *x)
{
    if (sign_is_sure(x))
        return x->size > 0 ? TRUTH_TRUE : TRUTH_FALSE;
    if (ball_is_special(x))
        return TRUTH_UNKNOWN;
    /* 0 inside: no number is positive if m + err = 0 */
    limb_t a = x->size ? ball_limbs(x)[0] : 0;
    return (x->size < 0 ? a == x->error : x->size == 0 && x->error == 0) ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

truth ball_is_negative(const ball *x)
{
    if (sign_is_sure(x))
        return x->size < 0 ? TRUTH_TRUE : TRUTH_FALSE;
    if (ball_is_special(x))
        return TRUTH_UNKNOWN;
    limb_t a = x->size ? ball_limbs(x)[0] : 0;
    return (x->size > 0 ? a == x->error : x->size == 0 && x->error == 0) ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

truth ball_is_zero(const ball *x)
{
    if (sign_is_sure(x))
        return TRUTH_FALSE;
    return !ball_is_special(x) && ball_is_exact_zero(x) ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

/* ---- order and containment ---- */

truth ball_less(const ball *x, const ball *y)
{
    if (ball_is_special(x) || ball_is_special(y))
        return TRUTH_UNKNOWN;
    int c = quick_order(x, y);
    if (c)
        return c < 0 ? TRUTH_TRUE : TRUTH_FALSE;
    c = compare_endpoints(x, true, y, false);
    if (c == -1)
        return TRUTH_TRUE;
    if (c == 2)
        return TRUTH_UNKNOWN;
    c = compare_endpoints(x, false, y, true);
    return c == 0 || c == 1 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

bool ball_contains(const ball *x, const ball *y)
{
    if (ball_is_special(x))
        return true;
    if (ball_is_special(y))
        return false;
    if (quick_order(x, y))
        return false;
    int a = compare_endpoints(x, false, y, false), b = compare_endpoints(y, true, x, true);
    return a <= 0 && b <= 0;
}

bool ball_contains_interior(const ball *x, const ball *y)
{
    if (ball_is_special(x))
        return true;
    if (ball_is_special(y))
        return false;
    return !quick_order(x, y) && compare_endpoints(x, false, y, false) == -1 && compare_endpoints(y, true, x, true) == -1;
}

bool ball_overlaps(const ball *x, const ball *y)
{
    if (ball_is_special(x) || ball_is_special(y))
        return true;
    return !quick_order(x, y) && compare_endpoints(x, false, y, true) != 1 && compare_endpoints(y, false, x, true) != 1;
}

/* Order of an endpoint and p / q: of endpoint q and p; 2 = no memory. */
static int compare_with_rational(const ball *x, bool upper, const rational *q)
{
    size_t n = ball_length(x) + 1, m = (size_t)integer_length(&q->denominator);
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 2 * n + m);
    int order = 2;
    if (w) {
        dyadic a, p = {integer_limbs(&q->numerator), (size_t)integer_length(&q->numerator), q->numerator.size < 0, 0};
        ball_endpoint(&a, w, x, upper);
        limb_t *product = w + n;
        const limb_t *d = integer_limbs(&q->denominator);
        if (a.n == 0 || (a.n >= m ? limb_multiply(product, a.w, a.n, d, m) : limb_multiply(product, d, m, a.w, a.n))) {
            a.n = a.n ? limb_normal(product, a.n + m) : 0;
            a.w = product;
            order = ball_dyadic_compare(&a, &p);
        }
    }
    ball_scratch_free(&space);
    return order;
}

bool ball_contains_rational(const ball *x, const rational *q)
{
    if (ball_is_special(x))
        return true;
    int a = compare_with_rational(x, false, q), b = compare_with_rational(x, true, q);
    return a <= 0 && (b == 0 || b == 1);
}
