/* laurent_value.c: arithmetic of Laurent polynomials in k, and formulas in it. */
#include "laurent_value.h"

#include <stdlib.h>

enum { D = LAURENT_MAX_DEGREE, COUNT = 2 * D + 1, MAX_EXPONENT = 1024 };

bool laurent_value_make(laurent_value *z)
{
    z->c = malloc(COUNT * sizeof *z->c);
    for (int i = 0; z->c && i < COUNT; i++)
        rational_init(&z->c[i]);
    return z->c != NULL;
}

void laurent_value_clear(laurent_value *z)
{
    for (int i = 0; z->c && i < COUNT; i++)
        rational_clear(&z->c[i]);
    free(z->c);
    z->c = NULL;
}

static void swap(laurent_value *x, laurent_value *y)
{
    laurent_value t = *x;
    *x = *y;
    *y = t;
}

int laurent_value_high(const laurent_value *x)
{
    int i = COUNT - 1;
    while (i >= 0 && rational_is_zero(&x->c[i]))
        i--;
    return i < 0 ? 0 : i - D;
}

int laurent_value_low(const laurent_value *x)
{
    int i = 0;
    while (i < COUNT && rational_is_zero(&x->c[i]))
        i++;
    return i == COUNT ? 0 : i - D;
}

/* z = q k^n */
static bool set_term(laurent_value *z, const rational *q, int n)
{
    bool ok = true;
    for (int i = 0; ok && i < COUNT; i++)
        ok = i == n + D ? rational_set(&z->c[i], q) : rational_set_si(&z->c[i], 0, 1);
    return ok;
}

bool laurent_value_set_si(laurent_value *z, long n)
{
    rational q;
    bool ok;
    rational_init(&q);
    ok = rational_set_si(&q, n, 1) && set_term(z, &q, 0);
    rational_clear(&q);
    return ok;
}

bool laurent_value_add(laurent_value *z, const laurent_value *x)
{
    bool ok = true;
    for (int i = 0; ok && i < COUNT; i++)
        ok = rational_add(&z->c[i], &z->c[i], &x->c[i]);
    return ok;
}

bool laurent_value_sub(laurent_value *z, const laurent_value *x)
{
    bool ok = true;
    for (int i = 0; ok && i < COUNT; i++)
        ok = rational_sub(&z->c[i], &z->c[i], &x->c[i]);
    return ok;
}

bool laurent_value_stretch(laurent_value *z, long n)
{
    rational factor, power;
    bool ok;
    rational_init(&factor);
    rational_init(&power);
    ok = rational_set_si(&factor, n, 1);
    for (int i = -D; ok && i <= D; i++)
        if (!rational_is_zero(&z->c[i + D]))
            ok = rational_pow(&power, &factor, i) && rational_mul(&z->c[i + D], &z->c[i + D], &power);
    rational_clear(&factor);
    rational_clear(&power);
    return ok;
}

/* z += q k^n x; *known: no degree is too large. */
static bool add_multiple(laurent_value *z, bool *known, const rational *q, int n, const laurent_value *x)
{
    rational p;
    bool ok = true;
    rational_init(&p);
    for (int i = 0; ok && *known && i < COUNT; i++) {
        if (rational_is_zero(&x->c[i]))
            continue;
        *known = i + n >= 0 && i + n < COUNT;
        ok = !*known || (rational_mul(&p, q, &x->c[i]) && rational_add(&z->c[i + n], &z->c[i + n], &p));
    }
    rational_clear(&p);
    return ok;
}

/* z = z y */
static bool multiply(laurent_value *z, bool *known, const laurent_value *y)
{
    laurent_value product;
    bool ok = laurent_value_make(&product);
    for (int i = 0; ok && *known && i < COUNT; i++)
        if (!rational_is_zero(&z->c[i]))
            ok = add_multiple(&product, known, &z->c[i], i - D, y);
    swap(z, &product);
    laurent_value_clear(&product);
    return ok;
}

/* z = z / y for a y of one term */
static bool divide(laurent_value *z, bool *known, const laurent_value *y)
{
    int n = laurent_value_high(y);
    laurent_value quotient;
    rational inverse;
    bool ok;
    *known = n == laurent_value_low(y) && !rational_is_zero(laurent_value_at(y, n));
    if (!*known)
        return true;
    rational_init(&inverse);
    ok = laurent_value_make(&quotient) && rational_inv(&inverse, laurent_value_at(y, n)) && add_multiple(&quotient, known, &inverse, -n, z);
    swap(z, &quotient);
    laurent_value_clear(&quotient);
    rational_clear(&inverse);
    return ok;
}

/* z = 1 / z for a z of one term */
static bool invert(laurent_value *z, bool *known)
{
    laurent_value one;
    bool ok = laurent_value_make(&one) && laurent_value_set_si(&one, 1) && divide(&one, known, z);
    swap(z, &one);
    laurent_value_clear(&one);
    return ok;
}

static bool is_short(const laurent_value *x)
{
    for (int i = 0; i < COUNT; i++)
        if (integer_bits(&x->c[i].numerator) > EXACT_MAX_BITS || integer_bits(&x->c[i].denominator) > EXACT_MAX_BITS)
            return false;
    return true;
}

/* ---- formulas ---- */

/* From the left. */
static bool binary(laurent_value *z, bool *known, const formula *f, valence_range k)
{
    laurent_value y = {NULL};
    bool ok = formula_laurent_value(z, known, f->child[0], k);
    if (ok && *known)
        ok = laurent_value_make(&y) && formula_laurent_value(&y, known, f->child[1], k);
    if (ok && *known)
        ok = f->op == '+' ? laurent_value_add(z, &y) : f->op == '-' ? laurent_value_sub(z, &y) : (f->op == '*' ? multiply : divide)(z, known, &y);
    laurent_value_clear(&y);
    return ok;
}

static bool negate(laurent_value *z)
{
    bool ok = true;
    for (int i = 0; ok && i < COUNT; i++)
        ok = rational_neg(&z->c[i], &z->c[i]);
    return ok;
}

/* *n = the exponent, a whole number that does not depend on k, |n| <= MAX_EXPONENT. */
static bool get_exponent(long *n, bool *known, const formula *f, valence_range k)
{
    laurent_value x;
    bool ok = laurent_value_make(&x) && formula_laurent_value(&x, known, f, k);
    if (ok && *known) {
        const rational *c = laurent_value_at(&x, 0);
        *known = f->depends == 0 && laurent_value_high(&x) == 0 && laurent_value_low(&x) == 0 && rational_is_integer(c) && rational_cmp_si(c, -MAX_EXPONENT, 1) >= 0 && rational_cmp_si(c, MAX_EXPONENT, 1) <= 0;
        *n = *known ? (long)integer_get_si(&c->numerator) : 0;
    }
    laurent_value_clear(&x);
    return ok;
}

static bool power(laurent_value *z, bool *known, const formula *f, valence_range k)
{
    laurent_value x = {NULL};
    long n = 0;
    bool ok = get_exponent(&n, known, f->child[1], k);
    if (ok && *known)
        ok = laurent_value_make(&x) && formula_laurent_value(&x, known, f->child[0], k) && laurent_value_set_si(z, 1);
    for (long i = 0; ok && *known && i < labs(n); i++) {
        ok = multiply(z, known, &x);
        *known = ok && *known && is_short(z);
    }
    if (ok && *known && n < 0)
        ok = invert(z, known);
    laurent_value_clear(&x);
    return ok;
}

static bool cases(laurent_value *z, bool *known, const formula *f, valence_range k)
{
    const formula_region at = {k, one_frequency(0), 0};
    *known = false;
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        if (f->child[i] && (f->child[i]->depends & ~(unsigned)FORMULA_ON_VALENCE) != 0)
            return true;
        if (f->child[i] && !formula_condition_range(&t, f->child[i], &at))
            return false;
        if (t == TRUTH_TRUE)
            return formula_laurent_value(z, known, f->child[i + 1], k);
        if (t == TRUTH_UNKNOWN)
            return true;
    }
    return true;
}

/* The depth is bounded as that of formula_exact is. */
bool formula_laurent_value(laurent_value *z, bool *known, const formula *f, valence_range k)
{
    rational one;
    bool ok;
    *known = true;
    switch (f->kind) {
    case FORMULA_NUMBER:
        return set_term(z, &f->number, 0);
    case FORMULA_VARIABLE:
        *known = f->op == 'k';
        rational_init(&one);
        ok = rational_set_si(&one, 1, 1) && set_term(z, &one, 1);
        rational_clear(&one);
        return ok;
    case FORMULA_REFERENCE:
        return formula_laurent_value(z, known, f->definition, k);
    case FORMULA_NEGATE:
        return formula_laurent_value(z, known, f->child[0], k) && (!*known || negate(z));
    case FORMULA_BINARY:
        ok = binary(z, known, f, k);
        *known = ok && *known && is_short(z);
        return ok;
    case FORMULA_POWER:
        return power(z, known, f, k);
    case FORMULA_CASES:
        return cases(z, known, f, k);
    default:
        *known = false;
        return true;
    }
}
