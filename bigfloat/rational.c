/* rational.c: arithmetic of fractions in lowest terms. */
#include "rational.h"

#include <math.h>

#include "integer_internal.h"

void rational_init(rational *z)
{
    integer_init(&z->numerator);
    integer_init(&z->denominator);
    integer_set_si(&z->denominator, 1);
}

void rational_clear(rational *z)
{
    integer_clear(&z->numerator);
    integer_clear(&z->denominator);
    integer_set_si(&z->denominator, 1);
}

bool rational_is_integer(const rational *x) { return integer_is_one(&x->denominator); }

bool rational_equal(const rational *x, const rational *y)
{
    return integer_cmp(&x->numerator, &y->numerator) == 0 && integer_cmp(&x->denominator, &y->denominator) == 0;
}

/* ---- assignment ---- */

bool rational_set(rational *z, const rational *x)
{
    return integer_set(&z->numerator, &x->numerator) && integer_set(&z->denominator, &x->denominator);
}

bool rational_set_integers(rational *z, const integer *p, const integer *q)
{
    integer g, a, b;
    integer_init(&g);
    integer_init(&a);
    integer_init(&b);
    bool ok = integer_gcd(&g, p, q);
    if (ok && q->size < 0)
        g.size = -g.size;
    if (ok && integer_is_one(&g))
        ok = integer_set(&a, p) && integer_set(&b, q);
    else
        ok = ok && integer_divexact(&a, p, &g) && integer_divexact(&b, q, &g);
    if (ok) {
        integer_swap(&z->numerator, &a);
        integer_swap(&z->denominator, &b);
    }
    integer_clear(&g);
    integer_clear(&a);
    integer_clear(&b);
    return ok;
}

bool rational_set_si(rational *z, int64_t p, int64_t q)
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    integer_set_si(&a, p);
    integer_set_si(&b, q);
    return rational_set_integers(z, &a, &b);
}

bool rational_set_integer_2exp(rational *z, const integer *m, long e)
{
    if (e >= 0) {
        bool ok = integer_mul_2exp(&z->numerator, m, (unsigned long)e);
        integer_set_si(&z->denominator, 1);
        return ok;
    }
    unsigned long n = 0 - (unsigned long)e, common = integer_trailing_zeros(m);
    if (integer_is_zero(m) || common > n)
        common = n;
    bool ok = integer_fdiv_2exp(&z->numerator, m, common);
    integer_set_si(&z->denominator, 1);
    return ok && integer_mul_2exp(&z->denominator, &z->denominator, n - common);
}

bool rational_set_double(rational *z, double x)
{
    int e;
    double f = frexp(x, &e);
    integer m;
    integer_init(&m);
    integer_set_si(&m, (int64_t)ldexp(f, 53)); /* |f| < 1: exact */
    return rational_set_integer_2exp(z, &m, (long)e - 53);
}

/* ---- field operations ---- */

bool rational_neg(rational *z, const rational *x)
{
    return integer_neg(&z->numerator, &x->numerator) && integer_set(&z->denominator, &x->denominator);
}

bool rational_abs(rational *z, const rational *x)
{
    return integer_abs(&z->numerator, &x->numerator) && integer_set(&z->denominator, &x->denominator);
}

static bool combine(rational *z, const rational *x, const rational *y,
                    bool (*op)(integer *, const integer *, const integer *))
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    bool ok;
    if (rational_is_integer(x) && rational_is_integer(y)) {
        ok = op(&z->numerator, &x->numerator, &y->numerator);
        integer_set_si(&z->denominator, 1);
    } else
        ok = integer_mul(&a, &x->numerator, &y->denominator) && integer_mul(&b, &y->numerator, &x->denominator)
             && op(&a, &a, &b) && integer_mul(&b, &x->denominator, &y->denominator)
             && rational_set_integers(z, &a, &b);
    integer_clear(&a);
    integer_clear(&b);
    return ok;
}

bool rational_add(rational *z, const rational *x, const rational *y) { return combine(z, x, y, integer_add); }
bool rational_sub(rational *z, const rational *x, const rational *y) { return combine(z, x, y, integer_sub); }

static bool product(rational *z, const integer *p1, const integer *p2, const integer *q1, const integer *q2)
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    bool ok = integer_mul(&a, p1, p2) && integer_mul(&b, q1, q2) && rational_set_integers(z, &a, &b);
    integer_clear(&a);
    integer_clear(&b);
    return ok;
}

bool rational_mul(rational *z, const rational *x, const rational *y)
{
    return product(z, &x->numerator, &y->numerator, &x->denominator, &y->denominator);
}

bool rational_div(rational *z, const rational *x, const rational *y)
{
    return product(z, &x->numerator, &y->denominator, &x->denominator, &y->numerator);
}

bool rational_inv(rational *z, const rational *x)
{
    if (!rational_set(z, x))
        return false;
    integer_swap(&z->numerator, &z->denominator);
    if (z->denominator.size < 0) {
        z->denominator.size = -z->denominator.size;
        z->numerator.size = -z->numerator.size;
    }
    return true;
}

bool rational_mul_2exp(rational *z, const rational *x, long e)
{
    unsigned long n = e < 0 ? 0 - (unsigned long)e : (unsigned long)e;
    const integer *up = e < 0 ? &x->denominator : &x->numerator;
    const integer *down = e < 0 ? &x->numerator : &x->denominator;
    unsigned long common = integer_trailing_zeros(down);
    if (integer_is_zero(down) || common > n)
        common = n;
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    bool ok = integer_mul_2exp(&a, up, integer_is_zero(down) ? 0 : n - common) && integer_fdiv_2exp(&b, down, common);
    if (ok) {
        integer_swap(&z->numerator, e < 0 ? &b : &a);
        integer_swap(&z->denominator, e < 0 ? &a : &b);
    }
    integer_clear(&a);
    integer_clear(&b);
    return ok;
}

/* Powers of numbers in lowest terms are in lowest terms. */
bool rational_pow(rational *z, const rational *x, long n)
{
    unsigned long k = n < 0 ? 0 - (unsigned long)n : (unsigned long)n;
    rational t;
    rational_init(&t);
    bool ok = (n < 0 ? rational_inv(&t, x) : rational_set(&t, x)) && integer_pow(&t.numerator, &t.numerator, k)
              && integer_pow(&t.denominator, &t.denominator, k);
    if (ok)
        rational_swap(z, &t);
    rational_clear(&t);
    return ok;
}

bool rational_floor(integer *z, const rational *x) { return integer_fdiv_q(z, &x->numerator, &x->denominator); }
bool rational_ceil(integer *z, const rational *x) { return integer_cdiv_q(z, &x->numerator, &x->denominator); }

/* ---- order ---- */

/* Adds the products a[i] b[k - i] of column k to the three-word accumulator. */
static void add_column(limb_t acc[3], const integer *a, const integer *b, size_t k)
{
    size_t m = (size_t)integer_length(a), n = (size_t)integer_length(b);
    const limb_t *p = integer_limbs(a), *q = integer_limbs(b);
    for (size_t i = k < n ? 0 : k - n + 1; i < m && i <= k; i++) {
        limb_t carry = 0, high, low = limb_mul(&high, p[i], q[k - i]);
        acc[0] = limb_add(acc[0], low, &carry);
        acc[1] = limb_add(acc[1], high, &carry);
        acc[2] += carry;
    }
}

static limb_t shift_out(limb_t acc[3])
{
    limb_t out = acc[0];
    acc[0] = acc[1];
    acc[1] = acc[2];
    acc[2] = 0;
    return out;
}

/* Sign of |a b| - |c d|, limb by limb from the lowest without storing the products: no memory is needed. */
static int compare_products(const integer *a, const integer *b, const integer *c, const integer *d)
{
    limb_t left[3] = {0, 0, 0}, right[3] = {0, 0, 0};
    size_t m = (size_t)(integer_length(a) + integer_length(b)), n = (size_t)(integer_length(c) + integer_length(d));
    int order = 0;
    for (size_t k = 0; k < (m > n ? m : n); k++) {
        add_column(left, a, b, k);
        add_column(right, c, d, k);
        limb_t s = shift_out(left), t = shift_out(right);
        if (s != t)
            order = s < t ? -1 : 1;
    }
    return order;
}

int rational_cmp(const rational *x, const rational *y)
{
    int s = rational_sign(x), t = rational_sign(y);
    if (s != t)
        return s < t ? -1 : 1;
    return s * compare_products(&x->numerator, &y->denominator, &y->numerator, &x->denominator);
}

int rational_cmp_si(const rational *x, int64_t p, int64_t q)
{
    rational y;
    rational_init(&y);
    integer_set_si(&y.numerator, p);
    integer_set_si(&y.denominator, q); /* not in lowest terms, which the comparison does not need */
    return rational_cmp(x, &y);
}

/* Scales both parts to their leading 64 bits first, so that neither overflows. */
double rational_get_double_approx(const rational *x)
{
    size_t m = integer_bits(&x->numerator), n = integer_bits(&x->denominator);
    integer p, q;
    integer_init(&p);
    integer_init(&q);
    unsigned long dm = m > 64 ? m - 64 : 0, dn = n > 64 ? n - 64 : 0;
    double v = 0;
    if (m && integer_fdiv_2exp(&p, &x->numerator, dm) && integer_fdiv_2exp(&q, &x->denominator, dn)) {
        long e = (long)dm - (long)dn;
        v = integer_get_double_approx(&p) / integer_get_double_approx(&q);
        v = ldexp(v, e > 4000 ? 4000 : e < -4000 ? -4000 : (int)e);
    }
    integer_clear(&p);
    integer_clear(&q);
    return v;
}
