/* The arithmetic of lib/scheme.md, "Value of a formula".  (Formulas are evaluated in
 * another file, so that no compiler puts all this into the one recursive function.) */

#include "value.h"

#include "answer.h"
#include "trig.h"

enum { MAX_EXPONENT = 16384 };                     /* of bases that are not exact */

static const char SEVERAL[] = "it depends on m, for several frequencies at once";

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

struct value value_enclosure(interval x)
{
    struct value out = { .kind = ENCLOSURE, .x = x };

    return out;
}

void value_constant(struct value *out, const struct node *f)
{
    *out = f->kind == NODE_PI ? angle(rational_from(1, 1)) : value_from(f->number);
}

void value_variable(struct value *out, int64_t first, int64_t last,
                    const struct node *at)
{
    struct value range = { .kind = FREQUENCIES, .first = first, .last = last };

    if (first < 0)
        *out = undefined(at, "k, m or j has no meaning here", false);
    else
        *out = first < last ? range : value_from(rational_from(first, 1));
}

void value_undefine(struct value *out, const struct node *at, const char *fault,
                    bool open)
{
    *out = undefined(at, fault, open);
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
        return value_enclosure(interval_add(x, y));
    if (operation == '-')
        return value_enclosure(interval_sub(x, y));
    if (operation == '*')
        return value_enclosure(grid_mul(x, y, g));
    if (interval_contains_zero(y))
        return undefined(at, "division by an enclosure of zero", !interval_is_zero(y));
    return value_enclosure(grid_div(x, y, g));
}

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
        return undefined(at, SEVERAL, true);
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

void value_apply(struct value *a, char operation, const struct value *b,
                 const struct node *at, int g)
{
    *a = apply(*a, operation, *b, at, g);
}

void value_negate(struct value *v, const struct node *at)
{
    if (v->kind == FREQUENCIES)
        *v = undefined(at, SEVERAL, true);
    else if (v->kind == ENCLOSURE)
        v->x = interval_minus(v->x);
    else if (v->kind != UNDEFINED)
        v->q = rational_negate(v->q);
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

static struct value power(struct value base, struct value exponent, bool minus,
                          const struct node *at, int g)
{
    struct value one = value_from(rational_from(1, 1)), out;
    int64_t n;

    if (base.kind == UNDEFINED || exponent.kind == UNDEFINED)
        return base.kind == UNDEFINED ? base : exponent;
    if (base.kind == FREQUENCIES || exponent.kind == FREQUENCIES)
        return undefined(at, SEVERAL, true);
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
        base = out = value_enclosure(value_enclose(base, g));
        for (int64_t i = 1; i < n; i++)
            out = apply(out, '*', base, at, g);
    }
    return minus ? apply(one, '/', out, at, g) : out;
}

void value_power(struct value *base, const struct value *exponent, bool minus,
                 const struct node *at, int g)
{
    *base = power(*base, *exponent, minus, at, g);
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

enum truth value_compare(const struct value *a, char join, const struct value *b, int g)
{
    return compare(*a, join, *b, g);
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
    return value_enclosure(sine ? grid_sin_pi(v.q, g) : grid_cos_pi(v.q, g));
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
    return value_enclosure(grid_root(x, g));
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
    return value_enclosure(least ? interval_min(x, y) : interval_max(x, y));
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

void value_function(struct value *out, const struct value *b, const struct node *f, int g)
{
    if (out->kind == UNDEFINED)
        return;
    if (b != NULL && b->kind == UNDEFINED)
        *out = *b;
    else if (out->kind == FREQUENCIES || (b != NULL && b->kind == FREQUENCIES))
        *out = undefined(f, SEVERAL, true);
    else if (f->kind == NODE_COS || f->kind == NODE_SIN)
        *out = cos_or_sin(*out, f, g);
    else if (f->kind == NODE_SQRT)
        *out = square_root(*out, f, g);
    else if (f->kind == NODE_ABS)
        *out = absolute(*out);
    else if (f->kind == NODE_MOD)
        *out = modulo(*out, *b, f);
    else
        *out = least_or_greatest(*out, *b, f->kind == NODE_MIN, g);
}
