/* Formulas evaluated: the arithmetic of lib/scheme.md, "Value of a formula". */

#include "value.h"

#include "answer.h"
#include "trig.h"

enum { MAX_EXPONENT = 16384 };                     /* of bases that are not exact */

enum truth { NO, YES, UNKNOWN };

static struct value undefined(const struct node *at, const char *fault, bool open)
{
    struct value out = { .kind = UNDEFINED, .at = at, .fault = fault, .open = open };

    return out;
}

struct value value_from(rational q)
{
    struct value out = { .kind = RATIONAL, .q = q };

    return out;
}

/* An exact multiple of pi that may be 0. */
static struct value angle(rational q)
{
    struct value out = { .kind = q.num.sign == 0 ? RATIONAL : ANGLE, .q = q };

    return out;
}

static struct value enclosure(interval x)
{
    struct value out = { .kind = ENCLOSURE, .x = x };

    return out;
}

interval value_enclose(struct value v, int g)
{
    if (v.kind == ENCLOSURE)
        return v.x;
    if (v.kind == ANGLE)
        return grid_mul(grid_from_rational(v.q, g), grid_pi(g), g);
    if (v.kind != RATIONAL)
        cannot_check("the checker uses a value that is none");
    return grid_from_rational(v.q, g);
}

void value_keep(struct mark mark, struct value *v)
{
    integer part[2] = { v->kind == ENCLOSURE ? v->x.lo : v->q.num,
                        v->kind == ENCLOSURE ? v->x.hi : v->q.den };

    if (v->kind == FREQUENCIES || v->kind == UNDEFINED) {
        scratch_release(mark);
        return;
    }
    integer_keep(mark, part, 2);
    if (v->kind == ENCLOSURE)
        v->x.lo = part[0], v->x.hi = part[1];
    else
        v->q.num = part[0], v->q.den = part[1];
}

void value_require(struct value v, const struct language *l, const char *certificate,
                   int line)
{
    if (v.kind == FREQUENCIES || (v.kind == UNDEFINED && v.at == NULL))
        rejected(certificate, line, "a formula depends on the frequency");
    if (v.kind != UNDEFINED)
        return;
    if (v.open && certificate != NULL)
        rejected(certificate, line, "the formula in line %d, column %d of the scheme "
                 "has no value: %s", v.at->line, v.at->column, v.fault);
    cannot_check_at(l->file, v.at->line, v.at->column, "at this place: %s", v.fault);
}

/* Arithmetic
 * ---------- */

static struct value with_enclosures(struct value a, char operation, struct value b,
                                    const struct node *at, int g)
{
    interval x = value_enclose(a, g), y = value_enclose(b, g);

    if (operation == '+')
        return enclosure(interval_add(x, y));
    if (operation == '-')
        return enclosure(interval_sub(x, y));
    if (operation == '*')
        return enclosure(grid_mul(x, y, g));
    if (interval_contains_zero(y))
        return undefined(at, "division by an enclosure of zero", !interval_is_zero(y));
    return enclosure(grid_div(x, y, g));
}

/* a (operation) b */
static struct value apply(struct value a, char operation, struct value b,
                          const struct node *at, int g)
{
    bool sum = operation == '+' || operation == '-';
    bool both_exact = a.kind != ENCLOSURE && b.kind != ENCLOSURE;
    int angles = (a.kind == ANGLE ? 1 : 0) + (b.kind == ANGLE ? 1 : 0);
    rational q;

    if (a.kind == UNDEFINED)
        return a;
    if (b.kind == UNDEFINED)
        return b;
    if (a.kind == FREQUENCIES || b.kind == FREQUENCIES)
        return undefined(at, "it depends on m, for several frequencies at once", true);
    if (operation == '/' && b.kind == RATIONAL && b.q.num.sign == 0)
        return undefined(at, "division by zero", false);

    /* Exact: rational with rational; angle +- angle; angle times or divided
     * by a rational; angle / angle. */
    if (!both_exact || (sum && angles == 1) || (operation == '*' && angles == 2) ||
        (operation == '/' && angles == 1 && b.kind == ANGLE))
        return with_enclosures(a, operation, b, at, g);
    q = operation == '+' ? rational_add(a.q, b.q)
      : operation == '-' ? rational_sub(a.q, b.q)
      : operation == '*' ? rational_mul(a.q, b.q) : rational_divide(a.q, b.q);
    if (angles == 0 || (operation == '/' && angles == 2))
        return value_from(q);
    return angle(q);
}

struct value value_add(struct value a, struct value b, int g)
{
    return apply(a, '+', b, NULL, g);
}

struct value value_sub(struct value a, struct value b, int g)
{
    return apply(a, '-', b, NULL, g);
}

static struct value negate(struct value v, const struct node *at)
{
    if (v.kind == FREQUENCIES)
        return undefined(at, "it depends on m, for several frequencies at once", true);
    if (v.kind == ENCLOSURE)
        v.x = interval_minus(v.x);
    else if (v.kind != UNDEFINED)
        v.q = rational_negate(v.q);
    return v;
}

/* q^n by squaring, n >= 1.  Numbers that grow end at the limit of rationals. */
static rational rational_power(rational q, integer n)
{
    rational out = rational_from(1, 1);
    bool unit = integer_compare(integer_absolute(q.num), q.den) == 0;

    if (q.num.sign == 0 || (unit && q.num.sign > 0))
        return q;
    if (unit) {                                    /* -1 */
        integer half = integer_shift_floor(n, 1);

        return integer_compare(integer_add(half, half), n) == 0 ? out : q;
    }
    for (long bit = integer_bits(n) - 1; bit >= 0; bit--) {
        integer above = integer_shift_floor(n, bit);
        integer half = integer_shift_floor(above, 1);

        out = rational_mul(out, out);
        if (integer_compare(integer_add(half, half), above) != 0)
            out = rational_mul(out, q);
    }
    return out;
}

/* base ^ n, or base ^ -n */
static struct value power(struct value base, struct value exponent, bool minus,
                          const struct node *at, int g)
{
    struct value one = value_from(rational_from(1, 1)), out;
    int64_t n;

    if (base.kind == UNDEFINED || exponent.kind == UNDEFINED)
        return base.kind == UNDEFINED ? base : exponent;
    if (base.kind == FREQUENCIES || exponent.kind == FREQUENCIES)
        return undefined(at, "it depends on m, for several frequencies at once", true);
    if (exponent.kind != RATIONAL || !rational_is_whole(exponent.q))
        return undefined(at, "the exponent is not a whole number", false);
    if (minus)
        exponent.q = rational_negate(exponent.q);
    if (exponent.q.num.sign == 0)
        return one;
    minus = exponent.q.num.sign < 0;
    exponent.q.num = integer_absolute(exponent.q.num);
    if (base.kind == RATIONAL) {
        out = value_from(rational_power(base.q, exponent.q.num));
    } else {
        if (!integer_get_small(&n, exponent.q.num, MAX_EXPONENT))
            cannot_check("an exponent of more than %d occurs", MAX_EXPONENT);
        if (base.kind == ANGLE && n == 1 && !minus)
            return base;
        base = out = enclosure(value_enclose(base, g));
        for (int64_t i = 1; i < n; i++)
            out = apply(out, '*', base, at, g);
    }
    return minus ? apply(one, '/', out, at, g) : out;
}

/* Comparisons
 * ----------- */

/* join: = ! < l (<=) > g (>=), as in formula.h; y - x has this sign. */
static enum truth holds_for_sign(char join, int sign)
{
    switch (join) {
    case '=': return sign == 0 ? YES : NO;
    case '!': return sign != 0 ? YES : NO;
    case '<': return sign > 0 ? YES : NO;
    case 'l': return sign >= 0 ? YES : NO;
    case '>': return sign < 0 ? YES : NO;
    default:  return sign <= 0 ? YES : NO;
    }
}

/* The difference is somewhere in [low, high]; here are the signs of both.  All
 * signs between occur, as far as is known. */
static enum truth holds_for_signs(char join, int low, int high)
{
    enum truth out = holds_for_sign(join, low);

    for (int sign = low; sign <= high; sign++)
        if (holds_for_sign(join, sign) != out)
            return UNKNOWN;
    return out;
}

/* m, for all of a range, and an exact number. */
static enum truth compare_frequencies(char join, struct value m, rational q)
{
    int first = rational_compare(q, rational_from(m.first, 1));
    int last = rational_compare(q, rational_from(m.last, 1));

    if (first > 0 && last < 0 && !rational_is_whole(q) && (join == '=' || join == '!'))
        return join == '!' ? YES : NO;
    return holds_for_signs(join, last, first);
}

static char mirrored(char join)
{
    return join == '<' ? '>' : join == '>' ? '<' : join == 'l' ? 'g'
         : join == 'g' ? 'l' : join;
}

static enum truth compare(struct value a, char join, struct value b, int g)
{
    interval difference;

    if (a.kind == UNDEFINED || b.kind == UNDEFINED)
        return UNKNOWN;
    if (a.kind == FREQUENCIES && b.kind == RATIONAL)
        return compare_frequencies(join, a, b.q);
    if (a.kind == RATIONAL && b.kind == FREQUENCIES)
        return compare_frequencies(mirrored(join), b, a.q);
    if (a.kind == FREQUENCIES || b.kind == FREQUENCIES)
        return UNKNOWN;
    if (a.kind == b.kind && a.kind != ENCLOSURE)
        return holds_for_sign(join, rational_compare(b.q, a.q));
    difference = interval_sub(value_enclose(b, g), value_enclose(a, g));
    return holds_for_signs(join, difference.lo.sign, difference.hi.sign);
}

/* exact: enclosures leave it unknown. */
static enum truth decide(const struct node *condition, const struct environment *e,
                         bool exact)
{
    enum truth out = condition->kind == NODE_AND ? YES : NO;

    for (const struct node *c = condition->first; c != NULL; c = c->next) {
        struct value a = evaluate(c->first, e), b = evaluate(c->first->next, e);
        enum truth here = compare(a, c->first->next->join, b, e->g);

        if (exact && (a.kind != b.kind || a.kind == ENCLOSURE))
            here = UNKNOWN;
        if (here == (condition->kind == NODE_AND ? NO : YES))
            return here;
        if (here == UNKNOWN)
            out = UNKNOWN;
    }
    return out;
}

bool condition_holds(const struct node *condition, const struct environment *e)
{
    struct mark mark = scratch_mark();
    enum truth out = decide(condition, e, true);

    scratch_release(mark);
    if (out == UNKNOWN)
        cannot_check_at(e->language->file, condition->line, condition->column,
                        "this comparison cannot be decided");
    return out == YES;
}

/* Functions
 * --------- */

static struct value cos_or_sin(struct value v, const struct node *at, int g)
{
    bool sine = at->kind == NODE_SIN;
    rational exact;

    if (v.kind == ENCLOSURE || (v.kind == RATIONAL && v.q.num.sign != 0))
        return undefined(at, "cos and sin are of 0 or a rational multiple of pi", false);
    if (sine ? rational_sin_pi(&exact, v.q) : rational_cos_pi(&exact, v.q))
        return value_from(exact);
    return enclosure(sine ? grid_sin_pi(v.q, g) : grid_cos_pi(v.q, g));
}

static struct value square_root(struct value v, const struct node *at, int g)
{
    interval x;

    if (v.kind == RATIONAL && v.q.num.sign >= 0) {
        rational root = { integer_root(v.q.num), integer_root(v.q.den) };

        if (rational_compare(rational_mul(root, root), v.q) == 0)
            return value_from(root);
    }
    x = value_enclose(v, g);
    if (x.lo.sign < 0)
        return undefined(at, "the square root of something that is or may be negative",
                         v.kind == ENCLOSURE && x.hi.sign >= 0);
    return enclosure(grid_root(x, g));
}

static struct value absolute(struct value v)
{
    if (v.kind == ENCLOSURE)
        v.x = interval_abs(v.x);
    else
        v.q.num = integer_absolute(v.q.num);
    return v;
}

static struct value least_or_greatest(struct value a, struct value b, bool least, int g)
{
    interval x, y;

    if (a.kind == b.kind && a.kind != ENCLOSURE)
        return (rational_compare(a.q, b.q) <= 0) == least ? a : b;
    x = value_enclose(a, g);
    y = value_enclose(b, g);
    return enclosure(least ? interval_min(x, y) : interval_max(x, y));
}

/* x - y floor(x / y) */
static struct value modulo(struct value a, struct value b, const struct node *at)
{
    if (a.kind != RATIONAL || b.kind != RATIONAL || !rational_is_whole(a.q) ||
        !rational_is_whole(b.q))
        return undefined(at, "mod is of whole numbers", false);
    if (b.q.num.sign == 0)
        return undefined(at, "division by zero", false);
    return value_from(rational_sub(a.q, rational_mul(b.q,
                      rational_floor(rational_divide(a.q, b.q)))));
}

static struct value function(const struct node *f, const struct environment *e)
{
    struct value out = evaluate(f->first, e);

    for (const struct node *n = f->first; n != NULL; n = n->next) {
        struct value v = n == f->first ? out : evaluate(n, e);

        if (v.kind == UNDEFINED)
            return v;
        if (v.kind == FREQUENCIES)
            return undefined(f, "it depends on m, for several frequencies at once",
                             true);
        if (f->kind == NODE_COS || f->kind == NODE_SIN)
            out = cos_or_sin(v, f, e->g);
        else if (f->kind == NODE_SQRT)
            out = square_root(v, f, e->g);
        else if (f->kind == NODE_ABS)
            out = absolute(v);
        else if (n != f->first && f->kind == NODE_MOD)
            out = modulo(out, v, f);
        else if (n != f->first)
            out = least_or_greatest(out, v, f->kind == NODE_MIN, e->g);
    }
    return out;
}

static struct value cases(const struct node *f, const struct environment *e)
{
    for (const struct node *n = f->first; n != NULL; n = n->next->next) {
        enum truth truth;

        if (n->next == NULL)                       /* else */
            return evaluate(n, e);
        truth = decide(n, e, false);
        if (truth == YES)
            return evaluate(n->next, e);
        if (truth == UNKNOWN)
            return undefined(n, "this comparison cannot be decided", true);
    }
    return undefined(f, "no case applies", false);
}

/* Formulas
 * -------- */

static struct value frequency(const struct node *at, const struct environment *e)
{
    struct value out = { .kind = FREQUENCIES, .first = e->first, .last = e->last };

    if (e->first < 0)
        return undefined(at, "m has no meaning here", false);
    if (e->first < e->last)
        return out;
    return value_from(rational_from(e->first, 1));
}

struct value evaluate(const struct node *f, const struct environment *e)
{
    struct mark mark = scratch_mark();
    struct value out;

    switch (f->kind) {
    case NODE_NUMBER:
        return value_from(f->number);
    case NODE_PI:
        return angle(rational_from(1, 1));
    case NODE_K:
        return e->k < 0 ? undefined(f, "k has no meaning here", false)
                        : value_from(rational_from(e->k, 1));
    case NODE_M:
        return frequency(f, e);
    case NODE_J:
        return e->j < 0 ? undefined(f, "j has no meaning here", false)
                        : value_from(rational_from(e->j, 1));
    case NODE_NAME:
        return e->definition[f->name];
    case NODE_SUM:
    case NODE_PRODUCT:
        out = evaluate(f->first, e);
        if (f->first->join == '-')
            out = negate(out, f);
        for (const struct node *n = f->first->next; n != NULL; n = n->next)
            out = apply(out, n->join, evaluate(n, e), n, e->g);
        break;
    case NODE_POWER:
        out = power(evaluate(f->first, e), evaluate(f->first->next, e),
                    f->first->next->join == '-', f, e->g);
        break;
    case NODE_CASES:
        out = cases(f, e);
        break;
    default:
        out = function(f, e);
        break;
    }
    value_keep(mark, &out);
    return out;
}

struct environment environment_make(const struct language *l, int64_t k, int64_t first,
                                    int64_t last, int64_t j, int g)
{
    struct environment out = { l, k, first, last, j, g, NULL };

    out.definition = allocate((size_t)l->count, sizeof out.definition[0]);
    for (int i = 0; i < l->count; i++) {
        const struct definition *d = &l->definition[i];

        if (d->formula != NULL)
            out.definition[i] = evaluate(d->formula, &out);
        else if (rational_compare(d->low, d->high) == 0)
            out.definition[i] = value_from(d->low);
        else
            out.definition[i] = enclosure(interval_hull(grid_from_rational(d->low, g),
                                                        grid_from_rational(d->high, g)));
    }
    return out;
}
