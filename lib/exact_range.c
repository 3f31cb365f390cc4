/* exact_range.c: affine functions of m, whose values lie between those at the ends of a range.  (What is not affine is
   left to enclosures: lib/scheme.md, "Ranges of m".) */
#include "exact_range.h"

#include <stdlib.h>

void exact_range_init(exact_range *z)
{
    z->is_angle = false;
    rational_init(&z->low);
    rational_init(&z->high);
}

void exact_range_clear(exact_range *z)
{
    rational_clear(&z->low);
    rational_clear(&z->high);
}

static bool is_zero(const exact_range *x)
{
    return rational_is_zero(&x->low) && rational_is_zero(&x->high);
}

/* z becomes the hull of z and q; the first time its only number. */
static bool include(exact_range *z, const rational *q, bool first)
{
    bool ok = true;
    if (first || rational_cmp(q, &z->low) < 0)
        ok = rational_set(&z->low, q);
    if (ok && (first || rational_cmp(q, &z->high) > 0))
        ok = rational_set(&z->high, q);
    return ok;
}

/* The range is that of the four results at the endpoints: all of these operations are monotone in each operand where
   they are defined (y does not contain 0 if it divides). */
static bool combine_corners(exact_range *z, const exact_range *x, char op, const exact_range *y)
{
    exact_range result;
    rational q;
    bool ok = true;
    exact_range_init(&result);
    rational_init(&q);
    for (int corner = 0; ok && corner < 4; corner++) {
        const rational *a = corner & 1 ? &x->high : &x->low, *b = corner & 2 ? &y->high : &y->low;
        ok = (op == '+' ? rational_add : op == '-' ? rational_sub : op == '*' ? rational_mul : rational_div)(&q, a, b);
        ok = ok && include(&result, &q, corner == 0);
    }
    rational_swap(&z->low, &result.low);
    rational_swap(&z->high, &result.high);
    exact_range_clear(&result);
    rational_clear(&q);
    return ok;
}

/* 0 counts as a rational and as an angle. */
static bool combine(exact_range *z, bool *known, const exact_range *x, char op, const exact_range *y)
{
    bool xa = x->is_angle, ya = y->is_angle;
    if (op == '+' || op == '-') {
        *known = xa == ya || is_zero(x) || is_zero(y);
        z->is_angle = xa || ya;
    } else if (op == '*') {
        *known = !(xa && ya);
        z->is_angle = xa || ya;
    } else {
        *known = (rational_sign(&y->low) > 0 || rational_sign(&y->high) < 0) && (xa || !ya);
        z->is_angle = xa && !ya;
    }
    return !*known || combine_corners(z, x, op, y);
}

static bool is_short(const exact_range *x)
{
    return integer_bits(&x->low.numerator) <= EXACT_MAX_BITS && integer_bits(&x->low.denominator) <= EXACT_MAX_BITS && integer_bits(&x->high.numerator) <= EXACT_MAX_BITS
           && integer_bits(&x->high.denominator) <= EXACT_MAX_BITS;
}

/* Is the node affine in m if its operands are?  A factor or divisor must not depend on m, then. */
static bool is_affine(const formula *f)
{
    bool first = (f->child[0]->depends & FORMULA_ON_FREQUENCY) != 0, second = f->children > 1 && (f->child[1]->depends & FORMULA_ON_FREQUENCY) != 0;
    switch (f->kind) {
    case FORMULA_NEGATE:
        return true;
    case FORMULA_BINARY:
        return f->op == '+' || f->op == '-' || (f->op == '*' ? !(first && second) : !second);
    default:
        return false;
    }
}

/* A node whose operands are z and y. */
static bool apply(exact_range *z, bool *known, const formula *f, const exact_range *y)
{
    if (f->kind == FORMULA_BINARY)
        return combine(z, known, z, f->op, y);
    rational_swap(&z->low, &z->high);
    return rational_neg(&z->low, &z->low) && rational_neg(&z->high, &z->high);
}

/* Operations on one operand or from the left on several. */
static bool fold(exact_range *z, bool *known, const formula *f, const formula_point *at, frequencies m)
{
    exact_range y;
    bool ok = true;
    exact_range_init(&y);
    *known = f->children > 0 && is_affine(f);
    for (int i = 0; ok && *known && i < f->children; i++) {
        ok = formula_exact_range(i ? &y : z, known, f->child[i], at, m);
        if (ok && *known && (i > 0 || f->children == 1))
            ok = apply(z, known, f, &y);
        *known = *known && is_short(z);
    }
    exact_range_clear(&y);
    return ok;
}

/* The value of the first case that applies, if it is the same one throughout. */
static bool cases(exact_range *z, bool *known, const formula *f, const formula_point *at, frequencies m)
{
    *known = false;
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        if (f->child[i] && !formula_condition_range(&t, f->child[i], at, m))
            return false;
        if (t == TRUTH_TRUE)
            return formula_exact_range(z, known, f->child[i + 1], at, m);
        if (t == TRUTH_UNKNOWN)
            return true;
    }
    return true;
}

static bool set_exact(exact_range *z, bool *known, const formula *f, const formula_point *at)
{
    exact_value v;
    diagnostic unused;
    status s;
    bool ok = true;
    exact_init(&v);
    s = formula_exact(&v, known, f, at, &unused);
    *known = *known && s == STATUS_OK;
    if (*known) {
        z->is_angle = v.is_angle;
        ok = rational_set(&z->low, &v.q) && rational_set(&z->high, &v.q);
    }
    exact_clear(&v);
    return ok && s != STATUS_NO_MEMORY;
}

/* The depth is bounded as that of formula_exact is. */
bool formula_exact_range(exact_range *z, bool *known, const formula *f, const formula_point *at, frequencies m)
{
    if (!(f->depends & FORMULA_ON_FREQUENCY))
        return set_exact(z, known, f, at);
    switch (f->kind) {
    case FORMULA_VARIABLE: /* m */
        z->is_angle = false;
        *known = true;
        return rational_set_si(&z->low, m.first, 1) && rational_set_si(&z->high, m.last, 1);
    case FORMULA_REFERENCE:
        return formula_exact_range(z, known, f->definition, at, m);
    case FORMULA_CASES:
        return cases(z, known, f, at, m);
    default:
        return fold(z, known, f, at, m);
    }
}

bool formula_is_constant(bool *constant, const formula *f, const formula_point *at, frequencies m)
{
    *constant = true;
    if (!(f->depends & FORMULA_ON_FREQUENCY) || m.first == m.last)
        return true;
    if (f->kind == FORMULA_REFERENCE)
        return formula_is_constant(constant, f->definition, at, m);
    if (f->kind != FORMULA_CASES) {
        *constant = f->children > 0;
        for (int i = 0; *constant && i < f->children; i++)
            if (!formula_is_constant(constant, f->child[i], at, m))
                return false;
        return true;
    }
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        if (f->child[i] && !formula_condition_range(&t, f->child[i], at, m))
            return false;
        if (t == TRUTH_TRUE)
            return formula_is_constant(constant, f->child[i + 1], at, m);
        if (t == TRUTH_UNKNOWN)
            break;
    }
    *constant = false;
    return true;
}

/* Every sign that x - y may have must give the same answer. */
static truth compare(char op, const exact_range *x, const exact_range *y)
{
    int least = rational_cmp(&x->low, &y->high), greatest = rational_cmp(&x->high, &y->low);
    bool can_hold = false, can_fail = false;
    for (int sign = -1; sign <= 1; sign++)
        if (sign >= least && sign <= greatest)
            *(formula_comparison_holds(op, sign) ? &can_hold : &can_fail) = true;
    return can_hold && can_fail ? TRUTH_UNKNOWN : can_hold ? TRUTH_TRUE : TRUTH_FALSE;
}

static bool compare_range(truth *t, const formula *f, const formula_point *at, frequencies m)
{
    exact_range x, y;
    bool ok, x_known = false, y_known = false;
    exact_range_init(&x);
    exact_range_init(&y);
    ok = formula_exact_range(&x, &x_known, f->child[0], at, m) && formula_exact_range(&y, &y_known, f->child[1], at, m);
    *t = ok && x_known && y_known && x.is_angle == y.is_angle ? compare(f->op, &x, &y) : TRUTH_UNKNOWN;
    exact_range_clear(&x);
    exact_range_clear(&y);
    return ok;
}

bool formula_condition_range(truth *t, const formula *f, const formula_point *at, frequencies m)
{
    if (f->kind == FORMULA_COMPARE)
        return compare_range(t, f, at, m);
    *t = f->kind == FORMULA_AND ? TRUTH_TRUE : TRUTH_FALSE;
    for (int i = 0; i < f->children; i++) {
        truth one;
        if (!formula_condition_range(&one, f->child[i], at, m))
            return false;
        *t = f->kind == FORMULA_AND ? truth_and(*t, one) : truth_or(*t, one);
    }
    return true;
}
