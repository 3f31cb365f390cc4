/* formula_value.c: enclosures where a formula has no exact value. */
#include "formula_value.h"

static void enclose(number *z, const exact_value *x, long prec)
{
    number_set_rational(z, &x->q, prec);
    if (x->is_angle) {
        number pi;
        number_init(&pi);
        number_pi(&pi, prec);
        number_mul(z, z, &pi, prec);
        number_clear(&pi);
    }
}

static status divide(number *z, const number *x, const number *y, const formula *f, long k, long prec, diagnostic *d)
{
    if (number_contains_zero(y) && number_is_finite(y))
        return diagnostic_set(d, f->line, f->column, "division by something that may be zero at valence k = %ld", k);
    number_div(z, x, y, prec);
    return STATUS_OK;
}

static status binary(number *z, const formula *f, const number *y, long k, long prec, diagnostic *d)
{
    switch (f->op) {
    case '+':
        number_add(z, z, y, prec);
        return STATUS_OK;
    case '-':
        number_sub(z, z, y, prec);
        return STATUS_OK;
    case '*':
        number_mul(z, z, y, prec);
        return STATUS_OK;
    default:
        return divide(z, z, y, f, k, prec, d);
    }
}

static status power(number *z, const formula *f, long k, long prec, diagnostic *d)
{
    long n = f->exponent < 0 ? -f->exponent : f->exponent;
    status s = STATUS_OK;
    number x;
    number_init(&x);
    number_set(&x, z);
    for (long i = 1; i < n; i++)
        number_mul(z, z, &x, prec);
    if (f->exponent < 0) {
        number_one(&x);
        s = divide(z, &x, z, f, k, prec, d);
    }
    number_clear(&x);
    return s;
}

/* The argument is an exact angle: formula_exact has refused anything else. */
static status cos_sin(number *z, const formula *f, long k, long prec, diagnostic *d)
{
    exact_value angle;
    bool known;
    status s;
    exact_init(&angle);
    s = formula_exact(&angle, &known, f->left, k, d);
    if (s == STATUS_OK && f->op == 'c')
        number_cos_pi(z, &angle.q, prec);
    else if (s == STATUS_OK)
        number_sin_pi(z, &angle.q, prec);
    exact_clear(&angle);
    return s;
}

static status inexact(number *z, const formula *f, long k, long prec, diagnostic *d)
{
    number y;
    status s;
    if (f->kind == FORMULA_COS_SIN)
        return cos_sin(z, f, k, prec, d);
    number_init(&y);
    s = NUMBER_NAME(formula_value)(z, f->left, k, prec, d);
    if (s == STATUS_OK && f->right)
        s = NUMBER_NAME(formula_value)(&y, f->right, k, prec, d);
    if (s == STATUS_OK && f->kind == FORMULA_NEGATE)
        number_neg(z, z);
    else if (s == STATUS_OK && f->kind == FORMULA_POWER)
        s = power(z, f, k, prec, d);
    else if (s == STATUS_OK)
        s = binary(z, f, &y, k, prec, d);
    number_clear(&y);
    return s;
}

status NUMBER_NAME(formula_value)(number *z, const formula *f, long k, long prec, diagnostic *d)
{
    exact_value exact;
    bool known;
    status s;
    exact_init(&exact);
    s = formula_exact(&exact, &known, f, k, d);
    if (s == STATUS_OK && known)
        enclose(z, &exact, prec);
    else if (s == STATUS_OK)
        s = inexact(z, f, k, prec, d);
    exact_clear(&exact);
    return s == STATUS_OK && number_lacks_memory(z) ? STATUS_NO_MEMORY : s;
}

/* rest = 1 - f, exactly as far as f is exact. */
static status value_of_rest(number *rest, const number *given, const formula *f, long k, long prec, diagnostic *d)
{
    exact_value x, one;
    bool known;
    status s;
    exact_init(&x);
    exact_init(&one);
    s = formula_exact(&x, &known, f, k, d);
    if (s == STATUS_OK && !rational_set_si(&one.q, 1, 1))
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && known && !x.is_angle) {
        exact_status e = exact_binary(&one, &one, '-', &x);
        if (e == EXACT_OK)
            enclose(rest, &one, prec);
        else
            s = formula_complain(f, e, k, d);
    } else if (s == STATUS_OK) {
        number_one(rest);
        number_sub(rest, rest, given, prec);
    }
    exact_clear(&x);
    exact_clear(&one);
    return s;
}

status NUMBER_NAME(scheme_weights)(number *centre, number *ring, const scheme *s, long k, long prec, diagnostic *d)
{
    const formula *f = s->centre_weight ? s->centre_weight : s->ring_weight;
    number *given = s->centre_weight ? centre : ring, *rest = s->centre_weight ? ring : centre;
    status result = NUMBER_NAME(formula_value)(given, f, k, prec, d);
    if (result == STATUS_OK)
        result = value_of_rest(rest, given, f, k, prec, d);
    return result == STATUS_OK && number_lacks_memory(rest) ? STATUS_NO_MEMORY : result;
}
