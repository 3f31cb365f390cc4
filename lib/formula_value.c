/* formula_value.c: enclosures where a formula has no exact value. */
#include "formula_value.h"

#define formula_value NUMBER_NAME(formula_value)

/* What all routines here need. */
typedef struct {
    const formula_point *at;
    long prec;
    diagnostic *complaint;
} context;

static status evaluate(number *z, const formula *f, const context *c)
{
    return formula_value(z, f, c->at, c->prec, c->complaint);
}

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

/* By something that may be 0 the quotient is the whole line: more precision may help.  Only 0 itself is an error. */
static status divide(number *z, const number *x, const number *y, const formula *f, const context *c)
{
    if (number_is_zero(y) == TRUTH_TRUE)
        return formula_complain(f, EXACT_DIVISION_BY_ZERO, c->at, c->complaint);
    number_div(z, x, y, c->prec);
    return STATUS_OK;
}

static status binary(number *z, const number *y, const formula *f, const context *c)
{
    switch (f->op) {
    case '+':
        number_add(z, z, y, c->prec);
        return STATUS_OK;
    case '-':
        number_sub(z, z, y, c->prec);
        return STATUS_OK;
    case '*':
        number_mul(z, z, y, c->prec);
        return STATUS_OK;
    default:
        return divide(z, z, y, f, c);
    }
}

/* The exponent is an exact whole number: formula_exact has refused anything else. */
static status power(number *z, const formula *f, const context *c)
{
    rational exponent;
    number x;
    status s;
    rational_init(&exponent);
    number_init(&x);
    s = formula_exact_rational(&exponent, f->child[1], c->at, c->complaint);
    if (s == STATUS_OK && (!integer_fits_si(&exponent.numerator) || integer_cmp_si(&exponent.numerator, 1L << 14) > 0 || integer_cmp_si(&exponent.numerator, -(1L << 14)) < 0))
        s = formula_complain(f, EXACT_TOO_LARGE, c->at, c->complaint);
    if (s == STATUS_OK)
        s = evaluate(z, f->child[0], c);
    if (s == STATUS_OK) {
        long n = (long)integer_get_si(&exponent.numerator), times = n < 0 ? -n : n;
        number_set(&x, z);
        for (long i = 1; i < times; i++)
            number_mul(z, z, &x, c->prec);
        number_one(&x);
        if (n < 0)
            s = divide(z, &x, z, f, c);
    }
    rational_clear(&exponent);
    number_clear(&x);
    return s;
}

/* The argument is an exact angle: formula_exact has refused anything else. */
static status cos_sin(number *z, const formula *f, const context *c)
{
    exact_value angle;
    bool known;
    status s;
    exact_init(&angle);
    s = formula_exact(&angle, &known, f->child[0], c->at, c->complaint);
    if (s == STATUS_OK && f->op == 'c')
        number_cos_pi(z, &angle.q, c->prec);
    else if (s == STATUS_OK)
        number_sin_pi(z, &angle.q, c->prec);
    exact_clear(&angle);
    return s;
}

/* The root of something that may be negative is the whole line, of something that is, an error. */
static status square_root(number *z, const formula *f, const context *c)
{
    status s = evaluate(z, f->child[0], c);
    if (s == STATUS_OK && number_is_negative(z) == TRUTH_TRUE)
        return formula_complain(f, EXACT_NEGATIVE, c->at, c->complaint);
    if (s == STATUS_OK)
        number_sqrt(z, z, c->prec);
    return s;
}

static status compare(truth *t, const formula *f, const context *c)
{
    number x, y;
    status s;
    truth less, more;
    number_init(&x);
    number_init(&y);
    s = evaluate(&x, f->child[0], c);
    if (s == STATUS_OK)
        s = evaluate(&y, f->child[1], c);
    less = number_less(&x, &y);
    more = number_less(&y, &x);
    *t = TRUTH_UNKNOWN;
    if (less == TRUTH_TRUE || more == TRUTH_TRUE)
        *t = formula_comparison_holds(f->op, less == TRUTH_TRUE ? -1 : 1) ? TRUTH_TRUE : TRUTH_FALSE;
    number_clear(&x);
    number_clear(&y);
    return s;
}

static status condition(truth *t, const formula *f, const context *c)
{
    bool holds, known;
    status s = formula_exact_condition(&holds, &known, f, c->at, c->complaint);
    if (s != STATUS_OK || known) {
        *t = holds ? TRUTH_TRUE : TRUTH_FALSE;
        return s;
    }
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

static status cases(number *z, const formula *f, const context *c)
{
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        status s = f->child[i] ? condition(&t, f->child[i], c) : STATUS_OK;
        if (s != STATUS_OK)
            return s;
        if (t == TRUTH_UNKNOWN) { /* any case may apply: the whole line, until more precision tells */
            number_indeterminate(z);
            return STATUS_OK;
        }
        if (t == TRUTH_TRUE)
            return evaluate(z, f->child[i + 1], c);
    }
    return formula_complain(f, EXACT_NO_CASE, c->at, c->complaint);
}

/* Operations on one operand or from the left on several. */
static status fold(number *z, const formula *f, const context *c)
{
    number y;
    status s = evaluate(z, f->child[0], c);
    number_init(&y);
    if (s == STATUS_OK && f->kind == FORMULA_NEGATE)
        number_neg(z, z);
    if (s == STATUS_OK && f->kind == FORMULA_ABS)
        number_abs(z, z);
    for (int i = 1; s == STATUS_OK && i < f->children; i++) {
        s = evaluate(&y, f->child[i], c);
        if (s != STATUS_OK)
            break;
        if (f->kind == FORMULA_BINARY)
            s = binary(z, &y, f, c);
        else if (f->kind == FORMULA_MIN)
            number_min(z, z, &y, c->prec);
        else
            number_max(z, z, &y, c->prec);
    }
    number_clear(&y);
    return s;
}

static void set_interval(number *z, const formula *f, long prec)
{
    number high;
    number_init(&high);
    number_set_rational(z, &f->number, prec);
    number_set_rational(&high, &f->high, prec);
    number_hull(z, z, &high, prec);
    number_clear(&high);
}

static status inexact(number *z, const formula *f, const context *c)
{
    switch (f->kind) {
    case FORMULA_REFERENCE:
        return evaluate(z, f->definition, c);
    case FORMULA_CASES:
        return cases(z, f, c);
    case FORMULA_COS_SIN:
        return cos_sin(z, f, c);
    case FORMULA_SQRT:
        return square_root(z, f, c);
    case FORMULA_POWER:
        return power(z, f, c);
    case FORMULA_INTERVAL:
        set_interval(z, f, c->prec);
        return STATUS_OK;
    default:
        return fold(z, f, c);
    }
}

status formula_value(number *z, const formula *f, const formula_point *at, long prec, diagnostic *d)
{
    context c = {at, prec, d};
    exact_value exact;
    bool known;
    status s;
    exact_init(&exact);
    s = formula_exact(&exact, &known, f, at, d);
    if (s == STATUS_OK && known)
        enclose(z, &exact, prec);
    else if (s == STATUS_OK)
        s = inexact(z, f, &c);
    exact_clear(&exact);
    return s == STATUS_OK && number_lacks_memory(z) ? STATUS_NO_MEMORY : s;
}
