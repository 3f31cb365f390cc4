/* laurent.c: dense arithmetic on boxes of integer coefficients over one denominator. */
#include "laurent.h"

#include <stdlib.h>

void laurent_init(laurent *z)
{
    z->a0 = z->b0 = z->na = z->nb = 0;
    z->coefficient = NULL;
    integer_init(&z->denominator);
    integer_set_si(&z->denominator, 1);
}

static void release_coefficients(laurent *z)
{
    for (long i = 0; i < z->na * z->nb; i++)
        integer_clear(&z->coefficient[i]);
    free(z->coefficient);
    z->coefficient = NULL;
    z->na = z->nb = 0;
}

void laurent_clear(laurent *z)
{
    release_coefficients(z);
    integer_clear(&z->denominator);
}

void laurent_swap(laurent *x, laurent *y)
{
    laurent t = *x;
    *x = *y;
    *y = t;
}

bool laurent_set_box(laurent *z, long a0, long b0, long na, long nb)
{
    release_coefficients(z);
    integer_set_si(&z->denominator, 1);
    z->a0 = a0;
    z->b0 = b0;
    if (na == 0 || nb == 0)
        return true;
    z->coefficient = malloc((size_t)na * (size_t)nb * sizeof *z->coefficient);
    if (!z->coefficient)
        return false;
    z->na = na;
    z->nb = nb;
    for (long i = 0; i < na * nb; i++)
        integer_init(&z->coefficient[i]);
    return true;
}

static integer *at(laurent *z, long a, long b)
{
    return &z->coefficient[(a - z->a0) * z->nb + (b - z->b0)];
}

/* Multiplies *m by what is missing to make it a multiple of d. */
static bool make_multiple(integer *m, const integer *d)
{
    bool ok;
    integer common, missing;
    integer_init(&common);
    integer_init(&missing);
    ok = integer_gcd(&common, m, d) && integer_divexact(&missing, d, &common) && integer_mul(m, m, &missing);
    integer_clear(&common);
    integer_clear(&missing);
    return ok;
}

bool laurent_set_terms(laurent *z, const lattice *point, const rational *weight, size_t count)
{
    long low_a = 0, high_a = -1, low_b = 0, high_b = -1;
    integer factor;
    bool ok;
    for (size_t i = 0; i < count; i++) {
        low_a = i == 0 || point[i].a < low_a ? point[i].a : low_a;
        high_a = i == 0 || point[i].a > high_a ? point[i].a : high_a;
        low_b = i == 0 || point[i].b < low_b ? point[i].b : low_b;
        high_b = i == 0 || point[i].b > high_b ? point[i].b : high_b;
    }
    ok = laurent_set_box(z, low_a, low_b, high_a - low_a + 1, high_b - low_b + 1);
    for (size_t i = 0; ok && i < count; i++)
        ok = make_multiple(&z->denominator, &weight[i].denominator);
    integer_init(&factor);
    for (size_t i = 0; ok && i < count; i++)
        ok = integer_divexact(&factor, &z->denominator, &weight[i].denominator)
             && integer_mul(at(z, point[i].a, point[i].b), &factor, &weight[i].numerator);
    integer_clear(&factor);
    return ok;
}

const integer *laurent_at(const laurent *x, long a, long b)
{
    if (a < x->a0 || a >= x->a0 + x->na || b < x->b0 || b >= x->b0 + x->nb)
        return NULL;
    return &x->coefficient[(a - x->a0) * x->nb + (b - x->b0)];
}

bool laurent_is_zero_at(const laurent *x, long a, long b)
{
    const integer *c = laurent_at(x, a, b);
    return !c || integer_is_zero(c);
}

bool laurent_get(rational *q, const laurent *x, long a, long b)
{
    const integer *c = laurent_at(x, a, b);
    return c ? rational_set_integers(q, c, &x->denominator) : rational_set_si(q, 0, 1);
}

bool laurent_set(laurent *z, const laurent *x)
{
    bool ok = true;
    laurent t;
    if (z == x)
        return true;
    laurent_init(&t);
    ok = laurent_set_box(&t, x->a0, x->b0, x->na, x->nb) && integer_set(&t.denominator, &x->denominator);
    for (long i = 0; ok && i < x->na * x->nb; i++)
        ok = integer_set(&t.coefficient[i], &x->coefficient[i]);
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

bool laurent_sub(laurent *z, const laurent *x, const laurent *y)
{
    long low_a = x->a0 < y->a0 ? x->a0 : y->a0, low_b = x->b0 < y->b0 ? x->b0 : y->b0;
    long high_a = x->a0 + x->na > y->a0 + y->na ? x->a0 + x->na : y->a0 + y->na;
    long high_b = x->b0 + x->nb > y->b0 + y->nb ? x->b0 + x->nb : y->b0 + y->nb;
    laurent t;
    bool ok;
    laurent_init(&t);
    ok = laurent_set_box(&t, low_a, low_b, high_a - low_a, high_b - low_b) && integer_mul(&t.denominator, &x->denominator, &y->denominator);
    for (long a = low_a; ok && a < high_a; a++)
        for (long b = low_b; ok && b < high_b; b++) {
            const integer *p = laurent_at(x, a, b), *q = laurent_at(y, a, b);
            ok = (!p || integer_addmul(at(&t, a, b), p, &y->denominator)) && (!q || integer_submul(at(&t, a, b), q, &x->denominator));
        }
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

/* Adds c * (y's coefficients), moved by (a,b), to z. */
static bool add_multiple(laurent *z, const integer *c, long a, long b, const laurent *y)
{
    for (long i = 0; i < y->na; i++)
        for (long j = 0; j < y->nb; j++)
            if (!integer_addmul(at(z, a + y->a0 + i, b + y->b0 + j), c, &y->coefficient[i * y->nb + j]))
                return false;
    return true;
}

bool laurent_mul(laurent *z, const laurent *x, const laurent *y)
{
    bool ok, zero = x->na == 0 || y->na == 0;
    laurent t;
    laurent_init(&t);
    ok = zero ? laurent_set_box(&t, 0, 0, 0, 0)
              : laurent_set_box(&t, x->a0 + y->a0, x->b0 + y->b0, x->na + y->na - 1, x->nb + y->nb - 1);
    ok = ok && integer_mul(&t.denominator, &x->denominator, &y->denominator);
    for (long i = 0; ok && !zero && i < x->na * x->nb; i++)
        if (!integer_is_zero(&x->coefficient[i]))
            ok = add_multiple(&t, &x->coefficient[i], x->a0 + i / x->nb, x->b0 + i % x->nb, y);
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

bool laurent_mul_si(laurent *z, const laurent *x, long v)
{
    if (!laurent_set(z, x))
        return false;
    for (long i = 0; i < z->na * z->nb; i++)
        if (!integer_mul_si(&z->coefficient[i], &z->coefficient[i], v))
            return false;
    return true;
}

bool laurent_stretch(laurent *z, const laurent *x, long n)
{
    bool ok;
    laurent t;
    laurent_init(&t);
    ok = laurent_set_box(&t, x->a0 * n, x->b0 * n, x->na ? (x->na - 1) * n + 1 : 0, x->nb ? (x->nb - 1) * n + 1 : 0)
         && integer_set(&t.denominator, &x->denominator);
    for (long i = 0; ok && i < x->na; i++)
        for (long j = 0; ok && j < x->nb; j++)
            ok = integer_set(at(&t, (x->a0 + i) * n, (x->b0 + j) * n), &x->coefficient[i * x->nb + j]);
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

/* x = (1 + z^-d) q says x(p) = q(p) + q(p + d): along each line in direction d, from the far end towards -d,
   q(p) = x(p) - q(p + d).  q must vanish outside the box of x, where nothing remains to cancel it: since
   q(p) != 0 at the last point p of a line makes x(p - d) = q(p) + q(p - d) with q(p - d) = 0 outside. */
bool laurent_divide_binomial(laurent *z, bool *exact, const laurent *x, lattice d)
{
    bool ok;
    laurent t;
    laurent_init(&t);
    *exact = true;
    ok = laurent_set_box(&t, x->a0, x->b0, x->na, x->nb) && integer_set(&t.denominator, &x->denominator);
    for (long i = 0; ok && i < x->na; i++)
        for (long j = 0; ok && j < x->nb; j++) {
            /* walk against d: the order in which p + d comes before p */
            long a = x->a0 + (d.a > 0 ? x->na - 1 - i : i);
            long b = x->b0 + (d.b > 0 ? x->nb - 1 - j : j);
            const integer *next = laurent_at(&t, a + d.a, b + d.b);
            ok = integer_set(at(&t, a, b), laurent_at(x, a, b))
                 && (!next || integer_sub(at(&t, a, b), at(&t, a, b), next));
            if (!laurent_at(x, a - d.a, b - d.b) && !integer_is_zero(at(&t, a, b)))
                *exact = false;
        }
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

static long modulo(long a, long n)
{
    long r = a % n;
    return r < 0 ? r + n : r;
}

bool laurent_class_norm(rational *norm, const laurent *x, long n)
{
    bool ok;
    long best = 0;
    integer magnitude;
    laurent sums;
    integer_init(&magnitude);
    laurent_init(&sums);
    ok = laurent_set_box(&sums, 0, 0, n, n);
    for (long i = 0; ok && i < x->na; i++)
        for (long j = 0; ok && j < x->nb; j++) {
            integer *sum = at(&sums, modulo(x->a0 + i, n), modulo(x->b0 + j, n));
            ok = integer_abs(&magnitude, &x->coefficient[i * x->nb + j]) && integer_add(sum, sum, &magnitude);
        }
    for (long i = 1; ok && i < n * n; i++)
        if (integer_cmp(&sums.coefficient[i], &sums.coefficient[best]) > 0)
            best = i;
    ok = ok && rational_set_integers(norm, &sums.coefficient[best], &x->denominator);
    integer_clear(&magnitude);
    laurent_clear(&sums);
    return ok;
}

bool laurent_class_sum(rational *sum, const laurent *x, long a, long b, long n)
{
    bool ok = true;
    integer total;
    integer_init(&total);
    for (long i = modulo(a - x->a0, n); ok && i < x->na; i += n)
        for (long j = modulo(b - x->b0, n); ok && j < x->nb; j += n)
            ok = integer_add(&total, &total, &x->coefficient[i * x->nb + j]);
    ok = ok && rational_set_integers(sum, &total, &x->denominator);
    integer_clear(&total);
    return ok;
}

bool laurent_is_nonnegative(const laurent *x)
{
    for (long i = 0; i < x->na * x->nb; i++)
        if (integer_sign(&x->coefficient[i]) < 0)
            return false;
    return true;
}

laurent_extent laurent_get_extent(const laurent *x)
{
    laurent_extent e = {{0, 0, 0}, {0, 0, 0}};
    bool first = true;
    for (long i = 0; i < x->na * x->nb; i++) {
        if (integer_is_zero(&x->coefficient[i]))
            continue;
        for (int f = 0; f < 3; f++) {
            long value = lattice_functional(f, x->a0 + i / x->nb, x->b0 + i % x->nb);
            if (first || value < e.low[f])
                e.low[f] = value;
            if (first || value > e.high[f])
                e.high[f] = value;
        }
        first = false;
    }
    return e;
}
