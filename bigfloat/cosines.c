/* cosines.c: 2 cos s cos t = cos(s + t) + cos(s - t), and every index comes back to those below n/2. */
#include "cosines.h"

/* More bits than this are no use to anybody (verify/exact.md, section 1). */
#define MAX_BITS 16384

static void become(cosines *z, cosines_state state)
{
    cosines_clear(z);
    z->state = state;
}

void cosines_clear(cosines *z)
{
    for (long i = 0; i < z->count; i++)
        rational_clear(&z->term[i]);
    free(z->term);
    cosines_init(z);
}

void cosines_zero(cosines *z)
{
    become(z, COSINES_KNOWN);
}

void cosines_indeterminate(cosines *z)
{
    become(z, COSINES_UNKNOWN);
}

/* z = 0 with room for `count` terms. */
static bool make_terms(cosines *z, long count)
{
    cosines_zero(z);
    z->term = malloc((size_t)(count ? count : 1) * sizeof *z->term);
    if (!z->term) {
        z->state = COSINES_NO_MEMORY;
        return false;
    }
    z->count = count;
    for (long i = 0; i < count; i++)
        rational_init(&z->term[i]);
    return true;
}

/* Drops terms that are 0 behind the last one that is not. */
static void finish(cosines *z, bool ok)
{
    while (z->count > 0 && rational_is_zero(&z->term[z->count - 1]))
        rational_clear(&z->term[--z->count]);
    for (long i = 0; i < z->count; i++)
        if (integer_bits(&z->term[i].numerator) > MAX_BITS || integer_bits(&z->term[i].denominator) > MAX_BITS) {
            cosines_indeterminate(z);
            return;
        }
    if (!ok)
        become(z, COSINES_NO_MEMORY);
}

/* The states of the operands, if they settle the result. */
static bool is_settled(cosines *z, const cosines *x, const cosines *y)
{
    cosines_state s = x->state > y->state ? x->state : y->state;
    if (s != COSINES_KNOWN)
        become(z, s);
    return s != COSINES_KNOWN;
}

void cosines_set(cosines *z, const cosines *x)
{
    bool ok = true;
    if (z == x)
        return;
    if (x->state != COSINES_KNOWN || !make_terms(z, x->count)) {
        if (x->state != COSINES_KNOWN)
            become(z, x->state);
        return;
    }
    for (long i = 0; ok && i < x->count; i++)
        ok = rational_set(&z->term[i], &x->term[i]);
    finish(z, ok);
}

void cosines_set_rational(cosines *z, const rational *q, long n)
{
    (void)n;
    if (make_terms(z, 1))
        finish(z, rational_set(&z->term[0], q));
}

void cosines_set_si(cosines *z, long v, long n)
{
    (void)n;
    if (make_terms(z, 1))
        finish(z, rational_set_si(&z->term[0], v, 1));
}

void cosines_one(cosines *z)
{
    cosines_set_si(z, 1, 0);
}

void cosines_neg(cosines *z, const cosines *x)
{
    bool ok = true;
    cosines_set(z, x);
    for (long i = 0; ok && i < z->count; i++)
        ok = rational_neg(&z->term[i], &z->term[i]);
    finish(z, ok);
}

/* z + sign q cos(i pi/n), z having the terms up to n/2. */
static bool add_cosine(cosines *z, long i, const rational *q, bool minus, long n)
{
    bool ok = true;
    rational half;
    i %= 2 * n;
    if (i < 0)
        i += 2 * n;
    if (i > n)
        i = 2 * n - i; /* cos(2 pi - t) = cos t */
    if (2 * i == n)
        return true;
    if (2 * i > n) {
        i = n - i; /* cos(pi - t) = -cos t */
        minus = !minus;
    }
    if (3 * i != n)
        return minus ? rational_sub(&z->term[i], &z->term[i], q) : rational_add(&z->term[i], &z->term[i], q);
    rational_init(&half); /* cos(pi/3) = 1/2 */
    ok = rational_mul_2exp(&half, q, -1) && (minus ? rational_sub(&z->term[0], &z->term[0], &half) : rational_add(&z->term[0], &z->term[0], &half));
    rational_clear(&half);
    return ok;
}

/* z = cos(i pi/n) if the rational i is whole. */
static void set_cosine(cosines *z, const rational *i, bool ok, long n)
{
    rational one;
    if (!ok)
        become(z, COSINES_NO_MEMORY);
    else if (!rational_is_integer(i) || integer_bits(&i->numerator) > 62)
        cosines_indeterminate(z);
    else if (make_terms(z, n / 2 + 1)) {
        rational_init(&one);
        ok = rational_set_si(&one, 1, 1) && add_cosine(z, (long)integer_get_si(&i->numerator), &one, false, n);
        rational_clear(&one);
        finish(z, ok);
    }
}

void cosines_cos_pi(cosines *z, const rational *r, long n)
{
    rational i;
    rational_init(&i);
    bool ok = rational_set_si(&i, n, 1) && rational_mul(&i, &i, r);
    set_cosine(z, &i, ok, n);
    rational_clear(&i);
}

/* sin t = cos(pi/2 - t) */
void cosines_sin_pi(cosines *z, const rational *r, long n)
{
    rational i, half;
    rational_init(&i);
    rational_init(&half);
    bool ok = rational_set_si(&half, 1, 2) && rational_sub(&half, &half, r) && rational_set_si(&i, n, 1) && rational_mul(&i, &i, &half);
    set_cosine(z, &i, ok, n);
    rational_clear(&i);
    rational_clear(&half);
}

static void add(cosines *z, const cosines *x, const cosines *y, bool minus)
{
    bool ok = true;
    cosines w;
    if (is_settled(z, x, y))
        return;
    cosines_init(&w);
    if (make_terms(&w, x->count > y->count ? x->count : y->count)) {
        for (long i = 0; ok && i < x->count; i++)
            ok = rational_set(&w.term[i], &x->term[i]);
        for (long i = 0; ok && i < y->count; i++)
            ok = minus ? rational_sub(&w.term[i], &w.term[i], &y->term[i]) : rational_add(&w.term[i], &w.term[i], &y->term[i]);
        finish(&w, ok);
    }
    cosines_swap(z, &w);
    cosines_clear(&w);
}

void cosines_add(cosines *z, const cosines *x, const cosines *y, long n)
{
    (void)n;
    add(z, x, y, false);
}

void cosines_sub(cosines *z, const cosines *x, const cosines *y, long n)
{
    (void)n;
    add(z, x, y, true);
}

void cosines_mul(cosines *z, const cosines *x, const cosines *y, long n)
{
    bool ok = true;
    cosines w;
    rational half;
    if (is_settled(z, x, y))
        return;
    cosines_init(&w);
    rational_init(&half);
    if (make_terms(&w, n / 2 + 1)) {
        for (long i = 0; ok && i < x->count; i++)
            for (long j = 0; ok && j < y->count; j++)
                ok = rational_is_zero(&x->term[i]) || rational_is_zero(&y->term[j])
                     || (rational_mul(&half, &x->term[i], &y->term[j]) && rational_mul_2exp(&half, &half, -1) && add_cosine(&w, i + j, &half, false, n)
                         && add_cosine(&w, i - j, &half, false, n));
        finish(&w, ok);
    }
    cosines_swap(z, &w);
    cosines_clear(&w);
    rational_clear(&half);
}

void cosines_addmul(cosines *z, const cosines *x, const cosines *y, long n)
{
    cosines product;
    cosines_init(&product);
    cosines_mul(&product, x, y, n);
    cosines_add(z, z, &product, n);
    cosines_clear(&product);
}

void cosines_div(cosines *z, const cosines *x, const cosines *y, long n)
{
    cosines inverse;
    if (is_settled(z, x, y))
        return;
    if (y->count != 1) {
        cosines_indeterminate(z);
        return;
    }
    cosines_init(&inverse);
    if (make_terms(&inverse, 1))
        finish(&inverse, rational_inv(&inverse.term[0], &y->term[0]));
    cosines_mul(z, x, &inverse, n);
    cosines_clear(&inverse);
}

/* What is never known: a function of x, or of x and y. */
static void forget(cosines *z, const cosines *x, const cosines *y)
{
    become(z, cosines_lacks_memory(x) || cosines_lacks_memory(y) ? COSINES_NO_MEMORY : COSINES_UNKNOWN);
}

void cosines_hull(cosines *z, const cosines *x, const cosines *y, long n)
{
    (void)n;
    forget(z, x, y);
}

void cosines_abs(cosines *z, const cosines *x)
{
    forget(z, x, x);
}

void cosines_min(cosines *z, const cosines *x, const cosines *y, long n)
{
    (void)n;
    forget(z, x, y);
}

void cosines_max(cosines *z, const cosines *x, const cosines *y, long n)
{
    (void)n;
    forget(z, x, y);
}

void cosines_sqrt(cosines *z, const cosines *x, long n)
{
    (void)n;
    forget(z, x, x);
}

truth cosines_is_negative(const cosines *x)
{
    (void)x;
    return TRUTH_UNKNOWN;
}

truth cosines_less(const cosines *x, const cosines *y)
{
    (void)x;
    (void)y;
    return TRUTH_UNKNOWN;
}
