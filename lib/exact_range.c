/* exact_range.c: interval arithmetic on exact values, for what is monotone in each of its operands.  (All else is left to
   enclosures: lib/scheme.md, "Ranges of k and m".) */
#include "exact_range.h"

#include <stdlib.h>

/* ---- ends ---- */

static void end_init(exact_end *z)
{
    z->infinity = 0;
    rational_init(&z->q);
}

static bool end_set(exact_end *z, const exact_end *x)
{
    z->infinity = x->infinity;
    return rational_set(&z->q, &x->q);
}

static bool end_set_infinity(exact_end *z, int sign)
{
    z->infinity = sign;
    return rational_set_si(&z->q, 0, 1);
}

static int end_sign(const exact_end *x)
{
    return x->infinity ? x->infinity : rational_sign(&x->q);
}

static bool end_is_zero(const exact_end *x)
{
    return end_sign(x) == 0;
}

/* Never of two equal infinities. */
static int end_cmp(const exact_end *x, const exact_end *y)
{
    return x->infinity || y->infinity ? (x->infinity > y->infinity) - (x->infinity < y->infinity) : rational_cmp(&x->q, &y->q);
}

/* Infinities of different signs are not added; oo * 0 = 0, x / oo = 0, and oo / oo does not occur. */
static bool end_combine(exact_end *z, const exact_end *x, char op, const exact_end *y)
{
    switch (op) {
    case '+':
        return x->infinity || y->infinity ? end_set_infinity(z, x->infinity ? x->infinity : y->infinity) : rational_add(&z->q, &x->q, &y->q);
    case '-':
        return x->infinity || y->infinity ? end_set_infinity(z, x->infinity ? x->infinity : -y->infinity) : rational_sub(&z->q, &x->q, &y->q);
    case '*':
        return x->infinity || y->infinity ? end_set_infinity(z, end_sign(x) * end_sign(y)) : rational_mul(&z->q, &x->q, &y->q);
    default:
        if (y->infinity)
            return end_set_infinity(z, 0);
        return x->infinity ? end_set_infinity(z, x->infinity * end_sign(y)) : rational_div(&z->q, &x->q, &y->q);
    }
}

/* ---- ranges ---- */

void exact_range_init(exact_range *z)
{
    z->is_angle = false;
    end_init(&z->low);
    end_init(&z->high);
}

void exact_range_clear(exact_range *z)
{
    rational_clear(&z->low.q);
    rational_clear(&z->high.q);
}

static void swap(exact_range *x, exact_range *y)
{
    exact_range t = *x;
    *x = *y;
    *y = t;
}

static bool is_zero(const exact_range *x)
{
    return end_is_zero(&x->low) && end_is_zero(&x->high);
}

/* z becomes the hull of z and x; the first time its only number. */
static bool include(exact_range *z, const exact_end *x, bool first)
{
    bool ok = true;
    if (first || end_cmp(x, &z->low) < 0)
        ok = end_set(&z->low, x);
    if (ok && (first || end_cmp(x, &z->high) > 0))
        ok = end_set(&z->high, x);
    return ok;
}

/* Sums and differences are monotone in one direction in each operand. */
static bool add_ends(exact_range *z, const exact_range *x, char op, const exact_range *y)
{
    return end_combine(&z->low, &x->low, op, op == '+' ? &y->low : &y->high) && end_combine(&z->high, &x->high, op, op == '+' ? &y->high : &y->low);
}

/* Products and quotients are monotone in each operand where they are defined (y does not contain 0 if it divides), in what
   direction depends on the other one: the range is that of the four results at the ends. */
static bool multiply_ends(exact_range *z, const exact_range *x, char op, const exact_range *y)
{
    exact_end corner;
    bool ok = true;
    end_init(&corner);
    for (int c = 0; ok && c < 4; c++) {
        corner.infinity = 0;
        ok = end_combine(&corner, c & 1 ? &x->high : &x->low, op, c & 2 ? &y->high : &y->low) && include(z, &corner, c == 0);
    }
    rational_clear(&corner.q);
    return ok;
}

/* z is not x or y.  0 counts as a rational and as an angle. */
static bool combine(exact_range *z, bool *known, const exact_range *x, char op, const exact_range *y)
{
    bool xa = x->is_angle, ya = y->is_angle, sum = op == '+' || op == '-';
    if (sum)
        *known = xa == ya || is_zero(x) || is_zero(y);
    else if (op == '*')
        *known = !(xa && ya);
    else
        *known = (end_sign(&y->low) > 0 || end_sign(&y->high) < 0) && (xa || !ya) && (exact_range_is_bounded(x) || exact_range_is_bounded(y));
    z->is_angle = op == '/' ? xa && !ya : xa || ya;
    return !*known || (sum ? add_ends : multiply_ends)(z, x, op, y);
}

static bool is_short(const exact_end *x)
{
    return integer_bits(&x->q.numerator) <= EXACT_MAX_BITS && integer_bits(&x->q.denominator) <= EXACT_MAX_BITS;
}

/* ---- formulas ---- */

/* May the node's range be taken from those of its operands?  A product of two that vary is left to enclosures, and so is,
   at one valence, a quotient by something that depends on m: certificates rely on it. */
static bool is_monotone(const formula *f, const formula_region *at)
{
    unsigned varies = formula_region_varies(at);
    bool first = (f->child[0]->depends & varies) != 0, second = f->children > 1 && (f->child[1]->depends & varies) != 0;
    switch (f->kind) {
    case FORMULA_NEGATE:
        return true;
    case FORMULA_BINARY:
        return f->op == '+' || f->op == '-' || (f->op == '*' ? !(first && second) : !second || !is_one_valence(at->k));
    default:
        return false;
    }
}

/* A node whose operands are z and y. */
static bool apply(exact_range *z, bool *known, const formula *f, const exact_range *y)
{
    exact_range x;
    bool ok;
    exact_range_init(&x);
    if (f->kind == FORMULA_BINARY) {
        ok = combine(&x, known, z, f->op, y);
    } else {
        x.is_angle = z->is_angle;
        ok = rational_neg(&x.low.q, &z->high.q) && rational_neg(&x.high.q, &z->low.q);
        x.low.infinity = -z->high.infinity;
        x.high.infinity = -z->low.infinity;
    }
    swap(z, &x);
    exact_range_clear(&x);
    return ok;
}

/* Operations on one operand or from the left on several. */
static bool fold(exact_range *z, bool *known, const formula *f, const formula_region *at)
{
    exact_range y;
    bool ok = true;
    exact_range_init(&y);
    *known = f->children > 0 && is_monotone(f, at);
    for (int i = 0; ok && *known && i < f->children; i++) {
        ok = formula_exact_range(i ? &y : z, known, f->child[i], at);
        if (ok && *known && (i > 0 || f->children == 1))
            ok = apply(z, known, f, &y);
        *known = *known && is_short(&z->low) && is_short(&z->high);
    }
    exact_range_clear(&y);
    return ok;
}

/* The value of the first case that applies, if it is the same one throughout. */
static bool cases(exact_range *z, bool *known, const formula *f, const formula_region *at)
{
    *known = false;
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        if (f->child[i] && !formula_condition_range(&t, f->child[i], at))
            return false;
        if (t == TRUTH_TRUE)
            return formula_exact_range(z, known, f->child[i + 1], at);
        if (t == TRUTH_UNKNOWN)
            return true;
    }
    return true;
}

static bool set_exact(exact_range *z, bool *known, const formula *f, const formula_region *at)
{
    formula_point here = formula_region_start(at);
    exact_value v;
    diagnostic unused;
    status s;
    bool ok = true;
    exact_init(&v);
    s = formula_exact(&v, known, f, &here, &unused);
    *known = *known && s == STATUS_OK;
    if (*known) {
        z->is_angle = v.is_angle;
        z->low.infinity = z->high.infinity = 0;
        ok = rational_set(&z->low.q, &v.q) && rational_set(&z->high.q, &v.q);
    }
    exact_clear(&v);
    return ok && s != STATUS_NO_MEMORY;
}

/* k or m */
static bool set_variable(exact_range *z, long first, long last)
{
    z->is_angle = false;
    z->low.infinity = 0;
    z->high.infinity = last == LONG_MAX;
    return rational_set_si(&z->low.q, first, 1) && rational_set_si(&z->high.q, z->high.infinity ? 0 : last, 1);
}

/* The depth is bounded as that of formula_exact is. */
bool formula_exact_range(exact_range *z, bool *known, const formula *f, const formula_region *at)
{
    if (!(f->depends & formula_region_varies(at)))
        return set_exact(z, known, f, at);
    switch (f->kind) {
    case FORMULA_VARIABLE:
        *known = true;
        return f->op == 'k' ? set_variable(z, at->k.first, at->k.last) : set_variable(z, at->m.first, at->m.last);
    case FORMULA_REFERENCE:
        return formula_exact_range(z, known, f->definition, at);
    case FORMULA_CASES:
        return cases(z, known, f, at);
    default:
        return fold(z, known, f, at);
    }
}

static bool is_whole_constant(bool *whole, const formula *f, const formula_region *at)
{
    exact_range x;
    bool ok;
    exact_range_init(&x);
    ok = set_exact(&x, whole, f, at);
    *whole = ok && *whole && !x.is_angle && rational_is_integer(&x.low.q);
    exact_range_clear(&x);
    return ok;
}

bool formula_is_whole(bool *whole, const formula *f, const formula_region *at)
{
    if (!(f->depends & formula_region_varies(at)))
        return is_whole_constant(whole, f, at);
    if (f->kind == FORMULA_REFERENCE)
        return formula_is_whole(whole, f->definition, at);
    *whole = f->kind == FORMULA_VARIABLE || f->kind == FORMULA_NEGATE || (f->kind == FORMULA_BINARY && f->op != '/');
    for (int i = 0; *whole && i < f->children; i++)
        if (!formula_is_whole(whole, f->child[i], at))
            return false;
    return true;
}

bool formula_is_constant(bool *constant, const formula *f, const formula_region *at)
{
    *constant = true;
    if (!(f->depends & formula_region_varies(at)))
        return true;
    if (f->kind == FORMULA_REFERENCE)
        return formula_is_constant(constant, f->definition, at);
    if (f->kind != FORMULA_CASES) {
        *constant = f->children > 0;
        for (int i = 0; *constant && i < f->children; i++)
            if (!formula_is_constant(constant, f->child[i], at))
                return false;
        return true;
    }
    for (int i = 0; i < f->children; i += 2) {
        truth t = TRUTH_TRUE;
        if (f->child[i] && !formula_condition_range(&t, f->child[i], at))
            return false;
        if (t == TRUTH_TRUE)
            return formula_is_constant(constant, f->child[i + 1], at);
        if (t == TRUTH_UNKNOWN)
            break;
    }
    *constant = false;
    return true;
}

/* Every sign that x - y may have must give the same answer. */
static truth compare(char op, const exact_range *x, const exact_range *y)
{
    int least = end_cmp(&x->low, &y->high), greatest = end_cmp(&x->high, &y->low);
    bool can_hold = false, can_fail = false;
    for (int sign = -1; sign <= 1; sign++)
        if (sign >= least && sign <= greatest)
            *(formula_comparison_holds(op, sign) ? &can_hold : &can_fail) = true;
    return can_hold && can_fail ? TRUTH_UNKNOWN : can_hold ? TRUTH_TRUE : TRUTH_FALSE;
}

static bool compare_range(truth *t, const formula *f, const formula_region *at)
{
    exact_range x, y;
    bool ok, x_known = false, y_known = false;
    exact_range_init(&x);
    exact_range_init(&y);
    ok = formula_exact_range(&x, &x_known, f->child[0], at) && formula_exact_range(&y, &y_known, f->child[1], at);
    *t = ok && x_known && y_known && x.is_angle == y.is_angle ? compare(f->op, &x, &y) : TRUTH_UNKNOWN;
    exact_range_clear(&x);
    exact_range_clear(&y);
    return ok;
}

bool formula_condition_range(truth *t, const formula *f, const formula_region *at)
{
    if (f->kind == FORMULA_COMPARE)
        return compare_range(t, f, at);
    *t = f->kind == FORMULA_AND ? TRUTH_TRUE : TRUTH_FALSE;
    for (int i = 0; i < f->children; i++) {
        truth one;
        if (!formula_condition_range(&one, f->child[i], at))
            return false;
        *t = f->kind == FORMULA_AND ? truth_and(*t, one) : truth_or(*t, one);
    }
    return true;
}
