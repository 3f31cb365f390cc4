/* formula_range.c: enclosures of formulas in k and m, each of them any number of a range. */
#include "formula_range.h"

#include "formula_value.h"

#define formula_value NUMBER_NAME(formula_value)
#define formula_range NUMBER_NAME(formula_range)

/* What all routines here need. */
typedef struct {
    const formula_region *at;
    long prec;
} context;

static status indeterminate(number *z)
{
    number_indeterminate(z);
    return STATUS_OK;
}

static status evaluate(number *z, const formula *f, const context *c)
{
    diagnostic unused;
    status s = formula_range(z, f, c->at, c->prec, &unused);
    return s == STATUS_BAD_INPUT ? indeterminate(z) : s;
}

/* The numbers, or angles, from low to high. */
static void enclose(number *z, const exact_range *x, long prec)
{
    number high;
    if (!exact_range_is_bounded(x)) {
        number_indeterminate(z);
        return;
    }
    number_init(&high);
    number_set_rational(z, &x->low.q, prec);
    number_set_rational(&high, &x->high.q, prec);
    number_hull(z, z, &high, prec);
    if (x->is_angle) {
        number_pi(&high, prec);
        number_mul(z, z, &high, prec);
    }
    number_clear(&high);
}

/* ---- cos and sin ---- */

/* Is there a whole number n = remainder modulo 2 with low <= n + shift/2 <= high? */
static status has_extreme(bool *has, const exact_range *angle, int remainder, int shift)
{
    rational x, half;
    integer n;
    bool ok;
    rational_init(&x);
    rational_init(&half);
    integer_init(&n);
    /* the greatest such n below high: 2 floor((high - shift/2 - remainder) / 2) + remainder */
    ok = rational_set_si(&half, shift + 2 * remainder, 2) && rational_sub(&x, &angle->high.q, &half) && rational_mul_2exp(&x, &x, -1) && rational_floor(&n, &x)
         && rational_set_integer_2exp(&x, &n, 1) && rational_add(&x, &x, &half);
    *has = ok && rational_cmp(&x, &angle->low.q) >= 0;
    rational_clear(&x);
    rational_clear(&half);
    integer_clear(&n);
    return ok ? STATUS_OK : STATUS_NO_MEMORY;
}

/* The values at both ends, and 1 at 2 n pi, -1 at (2 n + 1) pi (sin: pi/2 later), if such a point lies between. */
static status cos_sin_between(number *z, const exact_range *angle, char function, long prec)
{
    number other;
    status s = STATUS_OK;
    number_init(&other);
    (function == 'c' ? number_cos_pi : number_sin_pi)(z, &angle->low.q, prec);
    (function == 'c' ? number_cos_pi : number_sin_pi)(&other, &angle->high.q, prec);
    number_hull(z, z, &other, prec);
    for (int remainder = 0; s == STATUS_OK && remainder < 2; remainder++) {
        bool has;
        s = has_extreme(&has, angle, remainder, function == 's');
        number_set_si(&other, remainder ? -1 : 1, prec);
        if (s == STATUS_OK && has)
            number_hull(z, z, &other, prec);
    }
    number_clear(&other);
    return s;
}

static void hull_of_signs(number *z, long prec)
{
    number one;
    number_init(&one);
    number_one(&one);
    number_neg(z, &one);
    number_hull(z, z, &one, prec);
    number_clear(&one);
}

static status cos_sin(number *z, const formula *f, const context *c)
{
    exact_range angle;
    bool known, bounded;
    status s;
    exact_range_init(&angle);
    s = formula_exact_range(&angle, &known, f->child[0], c->at) ? STATUS_OK : STATUS_NO_MEMORY;
    bounded = exact_range_is_bounded(&angle);
    if (s == STATUS_OK && (!known || (!angle.is_angle && !(bounded && rational_is_zero(&angle.low.q) && rational_is_zero(&angle.high.q)))))
        s = indeterminate(z);
    else if (s == STATUS_OK && bounded)
        s = cos_sin_between(z, &angle, f->op, c->prec);
    else if (s == STATUS_OK)
        hull_of_signs(z, c->prec);
    exact_range_clear(&angle);
    return s;
}

/* ---- powers ---- */

/* A number >= 1 to this power is not computed: what it is at least (or its inverse at most) is good enough. */
#define MAX_BITS 4096

/* z contains x^n, x >= 1 with `bits` bits, for n from low to high. */
static status power_between(number *z, const rational *x, long low, long high, const context *c)
{
    size_t bits = integer_bits(&x->numerator) + integer_bits(&x->denominator);
    long most = MAX_BITS / (long)bits;
    rational q;
    number end;
    status s = STATUS_OK;
    if (high > most || most < 1)
        return indeterminate(z);
    rational_init(&q);
    number_init(&end);
    if (low < -most)
        number_zero(z);
    else if (rational_pow(&q, x, low))
        number_set_rational(z, &q, c->prec);
    else
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && rational_pow(&q, x, high < -most ? -most : high)) {
        number_set_rational(&end, &q, c->prec);
        number_hull(z, z, &end, c->prec);
    } else
        s = STATUS_NO_MEMORY;
    rational_clear(&q);
    number_clear(&end);
    return s;
}

/* x^n for an exact x > 0 that does not vary, and whole n from low to high: it is monotone in n. */
static status power_of_constant(number *z, const rational *x, long low, long high, const context *c)
{
    rational size;
    status s = STATUS_NO_MEMORY;
    rational_init(&size);
    if (rational_set(&size, x)) {
        if (rational_cmp_si(&size, 1, 1) == 0)
            s = (number_one(z), STATUS_OK);
        else if (rational_cmp_si(&size, 1, 1) > 0)
            s = power_between(z, &size, low, high, c);
        else if (rational_inv(&size, &size))
            s = power_between(z, &size, -high, -low, c);
    }
    rational_clear(&size);
    return s;
}

/* x^n, n >= 1, as lib/scheme.md multiplies it out. */
static status power_of_enclosure(number *z, const formula *base, long n, const context *c)
{
    number x;
    status s = evaluate(z, base, c);
    number_init(&x);
    number_set(&x, z);
    for (long i = 1; s == STATUS_OK && i < n; i++)
        number_mul(z, z, &x, c->prec);
    number_clear(&x);
    return s;
}

/* An end of an exponent, or one beyond all that are computed. */
static bool get_end(long *n, const exact_end *x)
{
    const integer *value = &x->q.numerator;
    if (x->infinity) {
        *n = x->infinity * (1L << 30);
        return true;
    }
    if (integer_bits(value) > 62)
        return false;
    *n = (long)integer_get_si(value);
    return true;
}

static status power(number *z, const formula *f, const context *c)
{
    exact_range base, exponent;
    bool base_known = false, known = false, whole = false;
    long low = 0, high = 0;
    status s = STATUS_OK;
    exact_range_init(&base);
    exact_range_init(&exponent);
    if (!formula_is_whole(&whole, f->child[1], c->at) || !formula_exact_range(&exponent, &known, f->child[1], c->at) || !formula_exact_range(&base, &base_known, f->child[0], c->at))
        s = STATUS_NO_MEMORY;
    known = known && whole && get_end(&low, &exponent.low) && get_end(&high, &exponent.high);
    base_known = base_known && !base.is_angle && !(f->child[0]->depends & formula_region_varies(c->at)) && rational_sign(&base.low.q) > 0;
    if (s == STATUS_OK) {
        if (known && base_known)
            s = power_of_constant(z, &base.low.q, low, high, c);
        else if (known && low == high && low >= 1 && low <= MAX_BITS)
            s = power_of_enclosure(z, f->child[0], low, c);
        else
            s = indeterminate(z);
    }
    exact_range_clear(&base);
    exact_range_clear(&exponent);
    return s;
}

/* ---- the rest ---- */

static status condition(truth *t, const formula *f, const context *c);

static status compare(truth *t, const formula *f, const context *c)
{
    number x, y;
    status s;
    number_init(&x);
    number_init(&y);
    s = evaluate(&x, f->child[0], c);
    if (s == STATUS_OK)
        s = evaluate(&y, f->child[1], c);
    if (number_less(&x, &y) == TRUTH_TRUE)
        *t = formula_comparison_holds(f->op, -1) ? TRUTH_TRUE : TRUTH_FALSE;
    else if (number_less(&y, &x) == TRUTH_TRUE)
        *t = formula_comparison_holds(f->op, 1) ? TRUTH_TRUE : TRUTH_FALSE;
    number_clear(&x);
    number_clear(&y);
    return s;
}

/* Exactly if that settles it, else by enclosures. */
static status condition(truth *t, const formula *f, const context *c)
{
    status s = formula_condition_range(t, f, c->at) ? STATUS_OK : STATUS_NO_MEMORY;
    if (s != STATUS_OK || *t != TRUTH_UNKNOWN)
        return s;
    if (f->kind == FORMULA_COMPARE)
        return compare(t, f, c);
    *t = f->kind == FORMULA_AND ? TRUTH_TRUE : TRUTH_FALSE;
    for (int i = 0; s == STATUS_OK && i < f->children; i++) {
        truth one;
        s = condition(&one, f->child[i], c);
        *t = f->kind == FORMULA_AND ? truth_and(*t, one) : truth_or(*t, one);
    }
    return s;
}

/* All cases up to the first that certainly applies. */
static status cases(number *z, const formula *f, const context *c)
{
    bool first = true;
    status s = STATUS_OK;
    truth t = TRUTH_FALSE;
    number value;
    number_init(&value);
    for (int i = 0; s == STATUS_OK && t != TRUTH_TRUE && i < f->children; i += 2) {
        t = TRUTH_TRUE;
        if (f->child[i])
            s = condition(&t, f->child[i], c);
        if (s != STATUS_OK || t == TRUTH_FALSE)
            continue;
        s = evaluate(&value, f->child[i + 1], c);
        if (first)
            number_swap(z, &value);
        else
            number_hull(z, z, &value, c->prec);
        first = false;
    }
    number_clear(&value);
    return s == STATUS_OK && t != TRUTH_TRUE ? indeterminate(z) : s; /* somewhere there may be none */
}

static void binary(number *z, const number *y, const formula *f, const context *c)
{
    switch (f->op) {
    case '+':
        number_add(z, z, y, c->prec);
        return;
    case '-':
        number_sub(z, z, y, c->prec);
        return;
    case '*':
        number_mul(z, z, y, c->prec);
        return;
    default:
        number_div(z, z, y, c->prec);
    }
}

/* Operations on one operand or from the left on several. */
static status fold(number *z, const formula *f, const context *c)
{
    number y;
    status s = evaluate(z, f->child[0], c);
    number_init(&y);
    if (f->kind == FORMULA_NEGATE)
        number_neg(z, z);
    if (f->kind == FORMULA_ABS)
        number_abs(z, z);
    if (f->kind == FORMULA_SQRT)
        number_sqrt(z, z, c->prec);
    for (int i = 1; s == STATUS_OK && i < f->children; i++) {
        s = evaluate(&y, f->child[i], c);
        if (f->kind == FORMULA_BINARY)
            binary(z, &y, f, c);
        else if (f->kind == FORMULA_MIN)
            number_min(z, z, &y, c->prec);
        else
            number_max(z, z, &y, c->prec);
    }
    number_clear(&y);
    return s;
}

/* A node that varies and whose values are not known exactly. */
static status inexact(number *z, const formula *f, const context *c)
{
    switch (f->kind) {
    case FORMULA_REFERENCE:
        return evaluate(z, f->definition, c);
    case FORMULA_CASES:
        return cases(z, f, c);
    case FORMULA_COS_SIN:
        return cos_sin(z, f, c);
    case FORMULA_POWER:
        return power(z, f, c);
    case FORMULA_NEGATE:
    case FORMULA_ABS:
    case FORMULA_SQRT:
    case FORMULA_BINARY:
    case FORMULA_MIN:
    case FORMULA_MAX:
        return fold(z, f, c);
    default:
        return indeterminate(z); /* mod, by something unknown */
    }
}

status formula_range(number *z, const formula *f, const formula_region *at, long prec, diagnostic *d)
{
    formula_point start = formula_region_start(at);
    context c = {at, prec};
    exact_range exact;
    bool known;
    status s;
    if (!(f->depends & formula_region_varies(at)))
        return formula_value(z, f, &start, prec, d);
    exact_range_init(&exact);
    s = formula_exact_range(&exact, &known, f, at) ? STATUS_OK : STATUS_NO_MEMORY;
    if (s == STATUS_OK && known)
        enclose(z, &exact, prec);
    else if (s == STATUS_OK)
        s = inexact(z, f, &c);
    exact_range_clear(&exact);
    return s == STATUS_OK && number_lacks_memory(z) ? STATUS_NO_MEMORY : s;
}
