/* formula.c: life and exact evaluation of formulas. */
#include "formula.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void formula_free(formula *f)
{
    if (!f)
        return;
    for (int i = 0; i < f->children; i++)
        formula_free(f->child[i]);
    free(f->child);
    rational_clear(&f->number);
    rational_clear(&f->high);
    free(f);
}

bool formula_make_interval(formula **z, rational *low, rational *high, long line, long column)
{
    formula *f = calloc(1, sizeof *f);
    *z = f;
    if (!f)
        return false;
    rational_init(&f->number);
    rational_init(&f->high);
    rational_swap(&f->number, low);
    rational_swap(&f->high, high);
    f->kind = FORMULA_INTERVAL;
    f->depends = FORMULA_ON_INTERVAL;
    f->size = 1;
    f->line = line;
    f->column = column;
    return true;
}

/* " (at k = 5, m = 2)", as far as f depends on them. */
static void describe_point(char *text, size_t size, const formula *f, const formula_point *at)
{
    const char *separator = " (at ";
    size_t length = 0;
    const struct {
        unsigned flag;
        char name;
        long value;
    } variable[3] = {{FORMULA_ON_VALENCE, 'k', at->k}, {FORMULA_ON_FREQUENCY, 'm', at->m}, {FORMULA_ON_SECTOR, 'j', at->j}};
    text[0] = '\0';
    for (int i = 0; i < 3; i++)
        if (f->depends & variable[i].flag) {
            length += (size_t)snprintf(text + length, size - length, "%s%c = %ld", separator, variable[i].name, variable[i].value);
            separator = ", ";
        }
    if (length)
        snprintf(text + length, size - length, ")");
}

status formula_complain(const formula *f, exact_status s, const formula_point *at, diagnostic *d)
{
    static const char *const what[] = {
        [EXACT_NONE] = "expected a rational number, and this value is not one",
        [EXACT_DIVISION_BY_ZERO] = "division by zero",
        [EXACT_TOO_LARGE] = "a rational number of more than 16384 bits",
        [EXACT_UNDEFINED] = "cos and sin need a rational multiple of pi",
        [EXACT_NEGATIVE] = "the square root of something negative",
        [EXACT_NOT_WHOLE] = "mod takes two whole numbers, the second not 0",
        [EXACT_UNDECIDED] = "this comparison cannot be decided",
        [EXACT_NO_CASE] = "no case applies; add 'else: ...'",
    };
    char place[100];
    if (s == EXACT_NO_MEMORY)
        return STATUS_NO_MEMORY;
    describe_point(place, sizeof place, f, at);
    if (s == EXACT_NONE && (f->depends & FORMULA_ON_INTERVAL))
        return diagnostic_set(d, f->line, f->column, "expected one rational number, and this is an interval%s", place);
    if (s == EXACT_NOT_WHOLE && f->kind == FORMULA_POWER)
        return diagnostic_set(d, f->line, f->column, "expected a whole number as the exponent%s", place);
    return diagnostic_set(d, f->line, f->column, "%s%s", what[s], place);
}

bool formula_comparison_holds(char op, int sign)
{
    switch (op) {
    case '=':
        return sign == 0;
    case '!':
        return sign != 0;
    case '<':
        return sign < 0;
    case 'l':
        return sign <= 0;
    case '>':
        return sign > 0;
    default:
        return sign >= 0;
    }
}

status formula_exact_condition(bool *holds, bool *known, const formula *f, const formula_point *at, diagnostic *d)
{
    status s;
    *known = true;
    if (f->kind == FORMULA_AND || f->kind == FORMULA_OR) {
        bool wanted = f->kind == FORMULA_OR, open = false; /* the value that settles it */
        for (int i = 0; i < f->children; i++) {
            bool one, one_known;
            s = formula_exact_condition(&one, &one_known, f->child[i], at, d);
            if (s != STATUS_OK)
                return s;
            if (one_known && one == wanted) {
                *holds = wanted;
                return STATUS_OK;
            }
            open = open || !one_known;
        }
        *holds = !wanted;
        *known = !open;
        return STATUS_OK;
    }
    exact_value x, y;
    bool x_known, y_known = false;
    int sign = 0;
    exact_init(&x);
    exact_init(&y);
    s = formula_exact(&x, &x_known, f->child[0], at, d);
    if (s == STATUS_OK)
        s = formula_exact(&y, &y_known, f->child[1], at, d);
    *known = s == STATUS_OK && x_known && y_known && exact_compare(&sign, &x, &y) == EXACT_OK;
    *holds = *known && formula_comparison_holds(f->op, sign);
    exact_clear(&x);
    exact_clear(&y);
    return s;
}

status formula_condition(bool *holds, const formula *f, const formula_point *at, diagnostic *d)
{
    bool known;
    status s = formula_exact_condition(holds, &known, f, at, d);
    return s == STATUS_OK && !known ? formula_complain(f, EXACT_UNDECIDED, at, d) : s;
}

/* The value of the first case that applies. */
static status exact_cases(exact_value *z, bool *known, const formula *f, const formula_point *at, diagnostic *d)
{
    for (int i = 0; i < f->children; i += 2) {
        bool holds = true;
        *known = true;
        if (f->child[i]) {
            status s = formula_exact_condition(&holds, known, f->child[i], at, d);
            if (s != STATUS_OK || !*known)
                return s;
        }
        if (holds)
            return formula_exact(z, known, f->child[i + 1], at, d);
    }
    return formula_complain(f, EXACT_NO_CASE, at, d);
}

/* min, max and abs of exact values. */
static exact_status exact_choose(exact_value *z, const formula *f, const exact_value *y)
{
    exact_value minus;
    int sign;
    bool take_other;
    exact_status s;
    exact_init(&minus);
    s = f->kind == FORMULA_ABS ? exact_negate(&minus, z) : EXACT_OK;
    if (s == EXACT_OK)
        s = exact_compare(&sign, z, f->kind == FORMULA_ABS ? &minus : y);
    if (s == EXACT_OK) {
        take_other = f->kind == FORMULA_MIN ? sign > 0 : sign < 0;
        if (take_other) {
            const exact_value *other = f->kind == FORMULA_ABS ? &minus : y;
            z->is_angle = other->is_angle;
            if (!rational_set(&z->q, &other->q))
                s = EXACT_NO_MEMORY;
        }
    }
    exact_clear(&minus);
    return s;
}

static exact_status power_of(exact_value *z, const exact_value *exponent)
{
    if (exponent->is_angle || !rational_is_integer(&exponent->q))
        return EXACT_NOT_WHOLE;
    if (!integer_fits_si(&exponent->q.numerator) || integer_bits(&exponent->q.numerator) > 30)
        return EXACT_TOO_LARGE;
    return exact_power(z, z, (long)integer_get_si(&exponent->q.numerator));
}

/* Puts the exact value of a node whose operands are z and y into z. */
static exact_status combine(exact_value *z, const formula *f, const exact_value *y, const formula_point *at)
{
    bool ok = true;
    if (f->children == 0)
        z->is_angle = f->kind == FORMULA_PI;
    switch (f->kind) {
    case FORMULA_NUMBER:
        ok = rational_set(&z->q, &f->number);
        break;
    case FORMULA_VARIABLE:
        ok = rational_set_si(&z->q, f->op == 'k' ? at->k : f->op == 'm' ? at->m : at->j, 1);
        break;
    case FORMULA_PI:
        ok = rational_set_si(&z->q, 1, 1);
        break;
    case FORMULA_NEGATE:
        return exact_negate(z, z);
    case FORMULA_BINARY:
        return exact_binary(z, z, f->op, y);
    case FORMULA_POWER:
        return power_of(z, y);
    case FORMULA_COS_SIN:
        return exact_cos_sin(z, z, f->op);
    case FORMULA_SQRT:
        return exact_sqrt(z, z);
    case FORMULA_MODULO:
        return exact_modulo(z, z, y);
    case FORMULA_ABS:
    case FORMULA_MIN:
    case FORMULA_MAX:
        return exact_choose(z, f, y);
    default:
        return EXACT_NONE; /* FORMULA_INTERVAL */
    }
    return ok ? EXACT_OK : EXACT_NO_MEMORY;
}

/* Functions of two or more operands, from the left. */
static status exact_fold(exact_value *z, bool *known, const formula *f, const formula_point *at, diagnostic *d)
{
    exact_value y;
    status s = STATUS_OK;
    exact_init(&y);
    *known = true;
    for (int i = 0; s == STATUS_OK && (i < f->children || i == 0); i++) {
        bool operand_known = true;
        exact_status e = EXACT_OK;
        if (f->children)
            s = formula_exact(i ? &y : z, &operand_known, f->child[i], at, d);
        *known = *known && operand_known;
        if (s == STATUS_OK && *known && (i > 0 || f->children <= 1)) {
            e = combine(z, f, &y, at);
            *known = e == EXACT_OK;
            s = e == EXACT_OK || e == EXACT_NONE ? STATUS_OK : formula_complain(f, e, at, d);
        }
    }
    exact_clear(&y);
    return s;
}

/* The depth of recursion is bounded by the reader: at most 64 nested parentheses, and chains lean left, so their
   length is bounded by the line's (1,000 characters); definitions refer to earlier ones only. */
status formula_exact(exact_value *z, bool *known, const formula *f, const formula_point *at, diagnostic *d)
{
    status s;
    if (f->kind == FORMULA_REFERENCE)
        return formula_exact(z, known, f->definition, at, d);
    if (f->kind == FORMULA_CASES)
        return exact_cases(z, known, f, at, d);
    s = exact_fold(z, known, f, at, d);
    if (s == STATUS_OK && !*known && f->kind == FORMULA_POWER) {
        /* x^0 = 1 and x^1 = x, whatever x; the exponent itself must be exact */
        bool exponent_known;
        s = formula_exact(z, &exponent_known, f->child[1], at, d);
        if (s == STATUS_OK && (!exponent_known || z->is_angle || !rational_is_integer(&z->q)))
            return formula_complain(f, EXACT_NOT_WHOLE, at, d);
        if (s == STATUS_OK && rational_is_zero(&z->q)) {
            *known = true;
            return rational_set_si(&z->q, 1, 1) ? STATUS_OK : STATUS_NO_MEMORY;
        }
    }
    if (s == STATUS_OK && !*known && f->kind == FORMULA_MODULO)
        return formula_complain(f, EXACT_NOT_WHOLE, at, d);
    if (s == STATUS_OK && !*known && f->kind == FORMULA_COS_SIN) {
        bool argument_known;
        s = formula_exact(z, &argument_known, f->child[0], at, d);
        if (s == STATUS_OK && !argument_known)
            return formula_complain(f, EXACT_UNDEFINED, at, d);
    }
    return s;
}

status formula_exact_rational(rational *z, const formula *f, const formula_point *at, diagnostic *d)
{
    exact_value value;
    bool known;
    status s;
    exact_init(&value);
    s = formula_exact(&value, &known, f, at, d);
    if (s == STATUS_OK && (!known || value.is_angle))
        s = formula_complain(f, EXACT_NONE, at, d);
    rational_swap(z, &value.q);
    exact_clear(&value);
    return s;
}
