/* number_field.c: polynomials in theta modulo its minimal polynomial. */
#include "number_field.h"

#include <string.h>

/* Notes whether an operation on rationals went well. */
static void note(number_field *f, bool ok)
{
    if (!ok)
        f->failed = true;
}

static void note_size(number_field *f, const rational *q)
{
    if (integer_bits(&q->numerator) > NUMBER_FIELD_MAX_BITS || integer_bits(&q->denominator) > NUMBER_FIELD_MAX_BITS)
        f->failed = true;
}

/* ---- making ---- */

static long totient(long n)
{
    long result = n;
    for (long p = 2; p <= n; p++)
        if (n % p == 0) {
            result -= result / p;
            while (n % p == 0)
                n /= p;
        }
    return result;
}

/* Moebius' function. */
static int moebius(long n)
{
    int sign = 1;
    for (long p = 2; p <= n; p++)
        if (n % p == 0) {
            n /= p;
            sign = -sign;
            if (n % p == 0)
                return 0;
        }
    return sign;
}

/* a[0..count) = the first coefficients of the cyclotomic polynomial, the product of (1 - x^(order/i))^moebius(i) over the
   divisors i of the order, as a power series. */
static void cyclotomic(long *a, long count, long order)
{
    memset(a, 0, (size_t)count * sizeof *a);
    a[0] = 1;
    for (long i = 1; i <= order; i++) {
        long power = order / i;
        int sign = order % i ? 0 : moebius(i);
        for (long j = count - 1; sign > 0 && j >= power; j--)
            a[j] -= a[j - power];
        for (long j = power; sign < 0 && j < count; j++)
            a[j] += a[j - power];
    }
}

/* z^-d Phi(z) = c_0 + sum of c_i (z^i + z^-i) = c_0 + sum of c_i V_i(z + 1/z). */
static void set_minimal(number_field *f)
{
    enum { SIZE = NUMBER_FIELD_MAX_DEGREE + 1 };
    long phi[SIZE], sum[SIZE + 1] = {0}, v[3][SIZE + 1] = {{2}, {0, 1}};
    int d = f->degree;
    cyclotomic(phi, d + 1, 2 * f->n);
    sum[0] = phi[d];
    for (int i = 1; i <= d; i++) {
        for (int j = 0; j <= d; j++)
            sum[j] += phi[d - i] * v[1][j];
        for (int j = 0; j <= d; j++)
            v[2][j] = (j ? v[1][j - 1] : 0) - v[0][j];
        memcpy(v[0], v[1], sizeof v[0]);
        memcpy(v[1], v[2], sizeof v[1]);
    }
    for (int j = 0; j < d; j++)
        note(f, rational_set_si(&f->minimal[j], sum[j], 1));
}

bool number_field_make(number_field *f, long n)
{
    long degree = totient(2 * n) / 2;
    memset(f, 0, sizeof *f);
    if (degree > NUMBER_FIELD_MAX_DEGREE)
        return false;
    f->n = n;
    f->degree = (int)degree;
    f->minimal = field_new(f, 1);
    f->scratch = field_new(f, 2);
    if (!f->failed)
        set_minimal(f);
    return !f->failed;
}

void number_field_free(number_field *f)
{
    field_free(f, f->minimal, 1);
    field_free(f, f->scratch, 2);
    memset(f, 0, sizeof *f);
}

rational *field_new(number_field *f, size_t count)
{
    size_t n = count * (size_t)f->degree;
    rational *x = malloc((n ? n : 1) * sizeof *x);
    for (size_t i = 0; x && i < n; i++)
        rational_init(&x[i]);
    if (!x)
        f->failed = true;
    return x;
}

void field_free(const number_field *f, rational *x, size_t count)
{
    for (size_t i = 0; x && i < count * (size_t)f->degree; i++)
        rational_clear(&x[i]);
    free(x);
}

/* ---- arithmetic ---- */

void field_set(number_field *f, rational *z, const rational *x)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_set(&z[i], &x[i]));
}

void field_set_si(number_field *f, rational *z, long v)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_set_si(&z[i], i ? 0 : v, 1));
}

void field_neg(number_field *f, rational *z, const rational *x)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_neg(&z[i], &x[i]));
}

void field_add(number_field *f, rational *z, const rational *x, const rational *y)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_add(&z[i], &x[i], &y[i]));
}

void field_sub(number_field *f, rational *z, const rational *x, const rational *y)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_sub(&z[i], &x[i], &y[i]));
}

/* z x, x a rational */
static void scale(number_field *f, rational *z, const rational *x)
{
    for (int i = 0; i < f->degree; i++)
        note(f, rational_mul(&z[i], &z[i], x));
}

static void add_product(number_field *f, rational *z, const rational *x, const rational *y, bool minus)
{
    rational p;
    if (rational_is_zero(x) || rational_is_zero(y))
        return;
    rational_init(&p);
    note(f, rational_mul(&p, x, y));
    note(f, minus ? rational_sub(z, z, &p) : rational_add(z, z, &p));
    note_size(f, z);
    rational_clear(&p);
}

/* theta^d = minus the minimal polynomial's other terms, from the highest power down. */
void field_mul(number_field *f, rational *z, const rational *x, const rational *y)
{
    rational *p = f->scratch;
    int d = f->degree;
    if (f->failed)
        return;
    for (int i = 0; i < 2 * d; i++)
        note(f, rational_set_si(&p[i], 0, 1));
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d && !f->failed; j++)
            add_product(f, &p[i + j], &x[i], &y[j], false);
    for (int i = 2 * d - 2; i >= d; i--)
        for (int j = 0; j < d && !f->failed; j++)
            add_product(f, &p[i - d + j], &p[i], &f->minimal[j], true);
    field_set(f, z, p);
}

void field_addmul(number_field *f, rational *z, const rational *x, const rational *y)
{
    rational *p;
    if (field_is_zero(f, x) || field_is_zero(f, y))
        return;
    p = field_new(f, 1);
    if (p) {
        field_mul(f, p, x, y);
        field_add(f, z, z, p);
    }
    field_free(f, p, 1);
}

void field_div_si(number_field *f, rational *z, const rational *x, long v)
{
    rational q;
    rational_init(&q);
    note(f, rational_set_si(&q, 1, v));
    field_set(f, z, x);
    scale(f, z, &q);
    rational_clear(&q);
}

bool field_is_zero(const number_field *f, const rational *x)
{
    for (int i = 0; i < f->degree; i++)
        if (!rational_is_zero(&x[i]))
            return false;
    return true;
}

/* z = V_i(theta), by V_(i+1) = theta V_i - V_(i-1). */
static void set_v(number_field *f, rational *z, long i)
{
    rational *last = field_new(f, 3), *theta, *next;
    if (f->failed) {
        field_free(f, last, 3);
        return;
    }
    theta = field_at(f, last, 1);
    next = field_at(f, last, 2);
    if (f->degree > 1)
        note(f, rational_set_si(&theta[1], 1, 1));
    else
        note(f, rational_neg(&theta[0], &f->minimal[0]));
    field_set_si(f, last, 2);
    field_set(f, z, theta);
    if (i == 0)
        field_set_si(f, z, 2);
    for (long l = 1; l < i; l++) {
        field_mul(f, next, theta, z);
        field_sub(f, next, next, last);
        field_set(f, last, z);
        field_set(f, z, next);
    }
    field_free(f, last, 3);
}

void field_set_cosines(number_field *f, rational *z, const cosines *x)
{
    rational *v = field_new(f, 1), half;
    rational_init(&half);
    field_set_si(f, z, 0);
    for (long i = 0; v && !f->failed && i < x->count; i++) {
        if (rational_is_zero(&x->term[i]))
            continue;
        set_v(f, v, i);
        note(f, rational_mul_2exp(&half, &x->term[i], -1));
        scale(f, v, &half);
        field_add(f, z, z, v);
    }
    rational_clear(&half);
    field_free(f, v, 1);
}

/* ---- inverses ---- */

/* Row `pivot` of an equation system with d rows of d + 1 numbers is made to begin with 1, and the other rows with 0, in
   column `pivot`. */
static void eliminate(number_field *f, rational *a, int pivot)
{
    int d = f->degree, w = d + 1, row = pivot;
    rational q;
    while (row < d - 1 && rational_is_zero(&a[row * w + pivot]))
        row++;
    if (rational_is_zero(&a[row * w + pivot])) {
        f->failed = true; /* only for x = 0 */
        return;
    }
    rational_init(&q);
    for (int j = 0; j < w; j++)
        rational_swap(&a[row * w + j], &a[pivot * w + j]);
    note(f, rational_inv(&q, &a[pivot * w + pivot]));
    for (int j = 0; j < w; j++)
        note(f, rational_mul(&a[pivot * w + j], &a[pivot * w + j], &q));
    for (int i = 0; i < d && !f->failed; i++) {
        note(f, rational_set(&q, &a[i * w + pivot]));
        for (int j = 0; j < w && i != pivot; j++)
            add_product(f, &a[i * w + j], &q, &a[pivot * w + j], true);
    }
    rational_clear(&q);
}

/* The z with z_0 x + z_1 theta x + ... = 1. */
void field_inverse(number_field *f, rational *z, const rational *x)
{
    int d = f->degree, w = d + 1;
    rational *power = field_new(f, 2), *a = field_new(f, (size_t)w), *theta = power ? field_at(f, power, 1) : NULL;
    if (!f->failed) {
        if (d > 1)
            note(f, rational_set_si(&theta[1], 1, 1));
        field_set(f, power, x);
        for (int j = 0; j < d; j++) {
            for (int i = 0; i < d; i++)
                note(f, rational_set(&a[i * w + j], &power[i]));
            if (d > 1)
                field_mul(f, power, power, theta);
        }
        note(f, rational_set_si(&a[d], 1, 1));
        for (int i = 0; i < d && !f->failed; i++)
            eliminate(f, a, i);
        for (int i = 0; i < d; i++)
            note(f, rational_set(&z[i], &a[i * w + d]));
    }
    field_free(f, power, 2);
    field_free(f, a, (size_t)w);
}
