/* The arithmetic of lib/scheme.md, "Value of a formula".  (Formulas are evaluated in
 * another file, so that no compiler puts all this into the one recursive function.) */

#include "value.h"

#include "answer.h"
#include "grid.h"

enum { MAX_EXPONENT = 16384,                       /* of bases that are not exact */
       MAX_RANGE_BITS = 4096 };                    /* of powers in ranges of m */

static const char SEVERAL[] = "no rule for several frequencies or valences at once";
static const char UNBOUNDED[] = "it is not bounded over all valences";

/* Infinite ends of ranges: den = 0. */
static rational infinite_end(int sign)
{
    return (rational) { integer_from(sign), integer_from(0) };
}

static bool is_infinite(rational end)
{
    return end.den.sign == 0;
}

static bool is_unbounded(const struct value *v)
{
    return v->kind != ENCLOSURE && v->kind != UNDEFINED &&
           (is_infinite(v->q) || is_infinite(v->q_last));
}

struct value value_undefined(const struct node *at, const char *fault, bool open)
{
    struct value out = { .kind = UNDEFINED, .at = at, .fault = fault, .open = open };

    return out;
}

struct value value_from(rational q)
{
    struct value out = { .kind = RATIONAL, .q = q, .q_last = q };

    return out;
}

struct value value_enclosure(interval x)
{
    struct value out = { .kind = ENCLOSURE, .x = x };

    return out;
}

struct value value_variable(struct span span, bool divides, const struct node *at)
{
    struct value out = value_from(rational_from(span.first, 1));

    if (span.first < 0)
        return value_undefined(at, "k, m or j has no meaning here", false);
    out.range = out.whole = span_is_several(span);
    out.divides = divides && out.range;
    out.q_last = span.last == ENDLESS ? infinite_end(1) : rational_from(span.last, 1);
    return out;
}

static interval enclose_exact(rational q, bool angle, int g)
{
    interval out = grid_from_rational(q, g);

    return angle ? grid_mul(out, grid_pi(g), g) : out;
}

interval value_enclose(struct value v, int g)
{
    interval out;

    if (v.kind == ENCLOSURE)
        return v.x;
    if (v.kind == UNDEFINED || is_unbounded(&v))
        cannot_check("the checker uses a value that is none");
    out = enclose_exact(v.q, v.kind == ANGLE, g);
    return v.range ? interval_hull(out, enclose_exact(v.q_last, v.kind == ANGLE, g)) : out;
}

void value_keep(struct mark mark, struct value *v)
{
    integer part[4] = { v->q.num, v->q.den, v->q_last.num, v->q_last.den };

    if (v->kind == ENCLOSURE) {
        interval_keep(mark, &v->x, 1);
    } else if (v->kind == UNDEFINED) {
        scratch_release(mark);
    } else {
        integer_keep(mark, part, v->range ? 4 : 2);
        v->q = (rational) { part[0], part[1] };
        v->q_last = v->range ? (rational) { part[2], part[3] } : v->q;
    }
}

bool value_is_only_unbounded(const struct value *v)
{
    return v->kind == UNDEFINED ? v->fault == UNBOUNDED : is_unbounded(v);
}

void value_require(struct value v, const struct language *l, const char *certificate, int line)
{
    if (is_unbounded(&v))
        rejected(certificate, line, "a formula of the scheme is not bounded over all valences");
    if (v.kind != UNDEFINED)
        return;
    if (v.open && certificate != NULL)
        rejected(certificate, line, "the formula in line %d, column %d of the scheme "
                 "has no value: %s", v.at->line, v.at->column, v.fault);
    cannot_check_at(l->file, v.at->line, v.at->column, "at this place: %s", v.fault);
}

/* How undefined?  What is only unbounded has a value at each valence; a finer grid helps some. */
static int fault_rank(const struct value *v)
{
    return v->kind != UNDEFINED ? 0 : v->fault == UNBOUNDED ? 1 : v->open ? 2 : 3;
}

/* The undefined one of two, or the more undefined one. */
static struct value undefined_one(struct value a, struct value b)
{
    return fault_rank(&a) >= fault_rank(&b) ? a : b;
}

/* Arithmetic
 * ---------- */

static struct value with_enclosures(struct value a, char operation, struct value b,
                                    const struct node *at, int g)
{
    interval x, y;

    if (is_unbounded(&a) || is_unbounded(&b))
        return value_undefined(at, UNBOUNDED, true);
    x = value_enclose(a, g);
    y = value_enclose(b, g);
    if (operation == '+')
        return value_enclosure(interval_add(x, y));
    if (operation == '-')
        return value_enclosure(interval_sub(x, y));
    if (operation == '*')
        return value_enclosure(grid_mul(x, y, g));
    if (interval_contains_zero(y))
        return value_undefined(at, "division by an enclosure of zero", !interval_is_zero(y));
    return value_enclosure(grid_div(x, y, g));
}

/* Ranges
 * ------
 *
 * Sums of ends, low ones of low ones (never oo) and high ones of high ones (never -oo);
 * products and quotients, 0 * oo = 0 and a / oo = 0 for finite a. */

static rational apply_to_ends(rational a, char operation, rational b)
{
    int sign = a.num.sign * b.num.sign;

    if (operation == '+')
        return is_infinite(a) ? a : is_infinite(b) ? b : rational_add(a, b);
    if (sign == 0 || (operation == '/' && is_infinite(b)))
        return rational_from(0, 1);
    if (is_infinite(a) || is_infinite(b))
        return infinite_end(sign);
    return operation == '*' ? rational_mul(a, b) : rational_divide(a, b);
}

/* Not of two equal infinite ones. */
static int compare_ends(rational a, rational b)
{
    int x = is_infinite(a) ? a.num.sign : 0, y = is_infinite(b) ? b.num.sign : 0;

    if (x == 0 && y == 0)
        return rational_compare(a, b);
    return (x > y) - (x < y);
}

/* May it be divided by, and has it one sign? */
static bool is_signed_range(const struct value *v)
{
    return v->divides && v->q.num.sign * v->q_last.num.sign > 0;
}

static bool is_whole(const struct value *v)
{
    return v->range ? v->whole : rational_is_whole(v->q);
}

static struct value apply_exactly(struct value a, char operation, struct value b,
                                  enum value_kind kind, const struct node *at)
{
    struct value out = { .kind = kind, .range = a.range || b.range,
                         .divides = a.divides || b.divides };

    if (operation == '/' && is_unbounded(&a) && is_unbounded(&b))
        return value_undefined(at, UNBOUNDED, true);
    out.whole = operation != '/' && is_whole(&a) && is_whole(&b);
    if (operation == '-') {
        b = value_negate(b);
        operation = '+';
    }
    out.q = out.q_last = apply_to_ends(a.q, operation, b.q);
    if (out.range && operation == '+')
        out.q_last = apply_to_ends(a.q_last, operation, b.q_last);
    for (int i = 1; out.range && operation != '+' && i < 4; i++) {
        rational end = apply_to_ends(i == 2 ? a.q : a.q_last, operation, i == 1 ? b.q : b.q_last);

        if (compare_ends(end, out.q) < 0)
            out.q = end;
        if (compare_ends(end, out.q_last) > 0)
            out.q_last = end;
    }
    if (out.q.num.sign == 0 && out.q_last.num.sign == 0)       /* an angle is not 0 */
        out.kind = RATIONAL;
    return out;
}

/* The rational 0; a range of it, too. */
static bool is_zero(const struct value *v)
{
    return v->kind == RATIONAL && v->q.num.sign == 0 && v->q_last.num.sign == 0;
}

/* Rational with rational; angle +- angle, 0 being one; angle times or divided by a rational;
 * angle / angle.  In ranges a factor varies at most. */
static bool is_exact(const struct value *a, char operation, const struct value *b)
{
    int angles = (a->kind == ANGLE ? 1 : 0) + (b->kind == ANGLE ? 1 : 0);

    if (a->kind == ENCLOSURE || b->kind == ENCLOSURE)
        return false;
    if (operation == '*')
        return angles < 2 && !(a->range && b->range);
    if (operation == '/')
        return (angles != 1 || a->kind == ANGLE) && (!b->range || is_signed_range(b));
    return angles != 1 || is_zero(a) || is_zero(b);
}

struct value value_apply(struct value a, char operation, struct value b,
                         const struct node *at, int g)
{
    bool angle = a.kind == ANGLE || b.kind == ANGLE;

    if (a.kind == UNDEFINED || b.kind == UNDEFINED)
        return undefined_one(a, b);
    if (operation == '/' && b.kind == RATIONAL && !b.range && b.q.num.sign == 0)
        return value_undefined(at, "division by zero", false);
    if (!is_exact(&a, operation, &b))
        return with_enclosures(a, operation, b, at, g);
    if (operation == '/' && b.kind == ANGLE)
        angle = false;
    return apply_exactly(a, operation, b, angle ? ANGLE : RATIONAL, at);
}

struct value value_negate(struct value v)
{
    rational low = v.q_last;

    if (v.kind == ENCLOSURE)
        v.x = interval_minus(v.x);
    if (v.kind == ENCLOSURE || v.kind == UNDEFINED)
        return v;
    v.q_last = rational_negate(v.q);
    v.q = rational_negate(low);
    return v;
}

static bool is_odd(integer n)
{
    return integer_compare(integer_shift_left(integer_shift_floor(n, 1), 1), n) != 0;
}

/* q^n by squaring, n >= 1.  Numbers that grow end at the limit of rationals; 0, 1, -1 do not. */
static rational rational_power(rational q, integer n)
{
    rational out = rational_from(1, 1);

    if (q.num.sign == 0 || integer_compare(integer_absolute(q.num), q.den) == 0)
        return is_odd(n) ? q : rational_mul(q, q);
    for (long bit = integer_bits(n) - 1; bit >= 0; bit--) {
        out = rational_mul(out, out);
        if (is_odd(integer_shift_floor(n, bit)))
            out = rational_mul(out, q);
    }
    return out;
}

/* x^n for an exact x > 0 and whole n, not too large ones. */
static interval whole_power(rational x, int64_t n, int g)
{
    rational out = n == 0 ? rational_from(1, 1) : rational_power(x, integer_from(n < 0 ? -n : n));

    return grid_from_rational(n < 0 ? rational_divide(rational_from(1, 1), out) : out, g);
}

/* An end of a range of whole exponents; false if it is finite and huge. */
static bool get_exponent(int64_t *out, rational end)
{
    const int64_t huge = INT64_C(1) << 60;

    *out = huge * end.num.sign;
    return is_infinite(end) || integer_get_small(out, end.num, huge);
}

/* base ^ exponent, the exponent being a range. */
static struct value power_of_range(struct value base, struct value exponent,
                                   const struct node *at, int g)
{
    rational one = rational_from(1, 1);
    int64_t low, high, most;

    if (base.kind != RATIONAL || base.range || base.q.num.sign <= 0 ||
        exponent.kind != RATIONAL || !exponent.whole)
        return value_undefined(at, SEVERAL, true);
    if (rational_equals(base.q, 1, 1))
        return value_from(one);
    if (rational_compare(base.q, one) < 0) {
        base.q = rational_divide(one, base.q);
        exponent = value_negate(exponent);
    }
    most = MAX_RANGE_BITS / (integer_bits(base.q.num) + integer_bits(base.q.den));
    if (!get_exponent(&low, exponent.q) || !get_exponent(&high, exponent.q_last))
        return value_undefined(at, SEVERAL, true);
    if (most == 0 || high > most)
        return value_undefined(at, SEVERAL, true);
    return value_enclosure(interval_hull(low < -most ? grid_from(0, g)
                                               : whole_power(base.q, low, g),
                                   whole_power(base.q, high < -most ? -most : high, g)));
}

/* Has q^n certainly more than 16,384 bits?  A number of b bits is at least 2^(b-1). */
static bool is_too_long(rational q, integer n)
{
    long num = integer_bits(q.num), den = integer_bits(q.den);
    integer bits = integer_mul(n, integer_from((num > den ? num : den) - 1));

    return integer_compare(bits, integer_from(RATIONAL_BITS)) >= 0;
}

struct value value_power(struct value base, struct value exponent, bool minus,
                         const struct node *at, int g)
{
    struct value one = value_from(rational_from(1, 1)), out;
    int64_t n;

    if (base.kind == UNDEFINED || exponent.kind == UNDEFINED)
        return undefined_one(base, exponent);
    if (minus)
        exponent = value_negate(exponent);
    if (exponent.range)
        return power_of_range(base, exponent, at, g);
    if (exponent.kind != RATIONAL || !rational_is_whole(exponent.q))
        return value_undefined(at, "the exponent is not a whole number", false);
    if (exponent.q.num.sign == 0)
        return one;
    minus = exponent.q.num.sign < 0;
    exponent.q.num = integer_absolute(exponent.q.num);
    if (base.kind == RATIONAL && !base.range && is_too_long(base.q, exponent.q.num)) {
        return value_undefined(at, "it is too long", true);
    } else if (base.kind == RATIONAL && !base.range) {
        out = value_from(rational_power(base.q, exponent.q.num));
    } else {
        if (!integer_get_small(&n, exponent.q.num, MAX_EXPONENT))
            cannot_check("an exponent of more than %d occurs", MAX_EXPONENT);
        if (base.kind == ANGLE && n == 1 && !minus)
            return base;
        if (is_unbounded(&base))
            return value_undefined(at, UNBOUNDED, true);
        base = out = value_enclosure(value_enclose(base, g));
        for (int64_t i = 1; i < n; i++)
            out = value_apply(out, '*', base, at, g);
    }
    return minus ? value_apply(one, '/', out, at, g) : out;
}

struct value value_hull(struct value a, struct value b, const struct node *at, int g)
{
    if (a.kind == UNDEFINED || b.kind == UNDEFINED)
        return undefined_one(a, b);
    if (is_unbounded(&a) || is_unbounded(&b))
        return value_undefined(at, UNBOUNDED, true);
    return value_enclosure(interval_hull(value_enclose(a, g), value_enclose(b, g)));
}

/* Comparisons
 * ----------- */

/* join: = ! < l (<=) > g (>=), as in formula.h; y - x has this sign. */
static bool holds_for_sign(char join, int sign)
{
    switch (join) {
    case '=': return sign == 0;
    case '!': return sign != 0;
    case '<': return sign > 0;
    case 'l': return sign >= 0;
    case '>': return sign < 0;
    default:  return sign <= 0;
    }
}

/* The difference is somewhere in [low, high]; here are the signs of both.  All
 * signs between occur, as far as is known. */
static enum truth holds_for_signs(char join, int low, int high)
{
    bool out = holds_for_sign(join, low);

    for (int sign = low; sign <= high; sign++)
        if (holds_for_sign(join, sign) != out)
            return UNKNOWN;
    return out ? YES : NO;
}

enum truth value_compare(struct value a, char join, struct value b, int g)
{
    interval difference;

    if (a.kind == UNDEFINED || b.kind == UNDEFINED)
        return UNKNOWN;
    if (a.kind == b.kind && a.kind != ENCLOSURE)
        return holds_for_signs(join, compare_ends(b.q, a.q_last), compare_ends(b.q_last, a.q));
    if (is_unbounded(&a) || is_unbounded(&b))
        return UNKNOWN;
    difference = interval_sub(value_enclose(b, g), value_enclose(a, g));
    return holds_for_signs(join, difference.lo.sign, difference.hi.sign);
}

/* Functions
 * --------- */

/* Is there a whole number n with low <= 2 n + shift <= high? */
static bool passes(rational low, rational high, int shift)
{
    rational two = rational_from(2, 1), s = rational_from(shift, 1);
    rational n = rational_floor(rational_divide(rational_sub(high, s), two));

    return rational_compare(rational_add(rational_mul(two, n), s), low) >= 0;
}

/* cos of the angles from low pi to high pi */
static interval cos_of_range(rational low, rational high, int g)
{
    interval out = interval_hull(grid_cos_pi(low, g), grid_cos_pi(high, g));

    if (passes(low, high, 0))
        out = interval_hull(out, grid_from(1, g));
    if (passes(low, high, 1))
        out = interval_hull(out, grid_from(-1, g));
    return out;
}

static struct value cos_or_sin(struct value v, const struct node *at, int g)
{
    rational low = v.q, high = v.q_last, half = rational_from(1, 2), exact;

    if (v.kind == ENCLOSURE || (v.kind == RATIONAL && !is_zero(&v)))
        return value_undefined(at, "cos and sin are of 0 or a rational multiple of pi", false);
    if (is_unbounded(&v))
        return value_enclosure(interval_hull(grid_from(-1, g), grid_from(1, g)));
    if (at->kind == NODE_SIN) {                    /* sin x = cos(pi/2 - x) */
        low = rational_sub(half, v.q_last);
        high = rational_sub(half, v.q);
    }
    if (v.kind == ANGLE && v.range)
        return value_enclosure(cos_of_range(low, high, g));
    if (rational_cos_pi(&exact, low))
        return value_from(exact);
    return value_enclosure(grid_cos_pi(low, g));
}

static struct value square_root(struct value v, const struct node *at, int g)
{
    interval x;

    if (v.kind == RATIONAL && !v.range && v.q.num.sign >= 0) {
        rational root = { integer_root(v.q.num), integer_root(v.q.den) };

        if (rational_compare(rational_mul(root, root), v.q) == 0)
            return value_from(root);
    }
    x = value_enclose(v, g);
    if (x.lo.sign < 0)
        return value_undefined(at, "the square root of something that is or may be negative",
                         (v.kind == ENCLOSURE || v.range) && x.hi.sign >= 0);
    return value_enclosure(grid_root(x, g));
}

static struct value absolute(struct value v, int g)
{
    if (v.range)
        v = value_enclosure(value_enclose(v, g));
    if (v.kind == ENCLOSURE)
        v.x = interval_abs(v.x);
    else if (v.q.num.sign < 0)
        v = value_negate(v);
    return v;
}

static struct value least_or_greatest(struct value a, struct value b, bool least, int g)
{
    interval x, y;

    if (a.kind == b.kind && a.kind != ENCLOSURE && !a.range && !b.range)
        return (rational_compare(a.q, b.q) <= 0) == least ? a : b;
    x = value_enclose(a, g);
    y = value_enclose(b, g);
    return value_enclosure(least ? interval_min(x, y) : interval_max(x, y));
}

/* x - y floor(x / y) */
static struct value modulo(struct value a, struct value b, const struct node *at)
{
    if (a.range || b.range)
        return value_undefined(at, SEVERAL, true);
    if (a.kind != RATIONAL || b.kind != RATIONAL || !rational_is_whole(a.q) ||
        !rational_is_whole(b.q))
        return value_undefined(at, "mod is of whole numbers", false);
    if (b.q.num.sign == 0)
        return value_undefined(at, "division by zero", false);
    return value_from(rational_sub(a.q, rational_mul(b.q,
                      rational_floor(rational_divide(a.q, b.q)))));
}

struct value value_function(struct value a, struct value b, const struct node *f, int g)
{
    if (a.kind == UNDEFINED || b.kind == UNDEFINED)
        return undefined_one(a, b);
    if (f->kind == NODE_COS || f->kind == NODE_SIN)
        return cos_or_sin(a, f, g);
    if (is_unbounded(&a) || is_unbounded(&b))
        return value_undefined(f, UNBOUNDED, true);
    switch (f->kind) {
    case NODE_SQRT: return square_root(a, f, g);
    case NODE_ABS:  return absolute(a, g);
    case NODE_MOD:  return modulo(a, b, f);
    default:        return least_or_greatest(a, b, f->kind == NODE_MIN, g);
    }
}
