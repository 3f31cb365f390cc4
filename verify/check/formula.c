/* Formulas: a parser by recursive descent that evaluates while it reads,
 * with the grammar and the arithmetic of lib/scheme.md.  Each function below
 * stands for one line of the grammar. */

#include "formula.h"

#include "trig.h"

enum { MAX_NESTING = 64, MAX_EXPONENT = 64 };

struct parser {
    struct cursor *c;
    int k;                                         /* 0: not allowed */
    int g;
    int nesting;
};

void value_enclose(interval *out, const struct value *v, int g)
{
    if (v->kind == ENCLOSURE) {
        interval_set(out, &v->x);
        return;
    }
    grid_from_rational(out, &v->q, g);
    if (v->kind == ANGLE) {
        interval pi;

        grid_pi(&pi, g);
        grid_mul(out, out, &pi, g);
    }
}

/* An exact multiple of pi that may be 0. */
static void set_angle(struct value *out, const rational *q)
{
    rational_set(&out->q, q);
    out->kind = q->num.sign == 0 ? RATIONAL : ANGLE;
}

static void set_rational(struct value *out, const rational *q)
{
    rational_set(&out->q, q);
    out->kind = RATIONAL;
}

static void set_value(struct value *out, const struct value *v)
{
    out->kind = v->kind;
    if (v->kind == ENCLOSURE)
        interval_set(&out->x, &v->x);
    else
        rational_set(&out->q, &v->q);
}

/* Operations
 * ---------- */

static void apply_to_enclosures(struct value *out, char operation,
                                const struct value *right, struct parser *p)
{
    interval x, y;

    value_enclose(&x, out, p->g);
    value_enclose(&y, right, p->g);
    if (operation == '/' && interval_contains_zero(&y))
        cursor_error(p->c, "before this place: division by an enclosure of zero");
    if (operation == '+')
        interval_add(&out->x, &x, &y);
    else if (operation == '-')
        interval_sub(&out->x, &x, &y);
    else if (operation == '*')
        grid_mul(&out->x, &x, &y, p->g);
    else
        grid_div(&out->x, &x, &y, p->g);
    out->kind = ENCLOSURE;
}

/* out := out (operation) right */
static void apply(struct value *out, char operation, const struct value *right,
                  struct parser *p)
{
    bool sum = operation == '+' || operation == '-';
    bool both_exact = out->kind != ENCLOSURE && right->kind != ENCLOSURE;
    int angles = (out->kind == ANGLE ? 1 : 0) + (right->kind == ANGLE ? 1 : 0);
    rational q;

    if (operation == '/' && right->kind == RATIONAL && right->q.num.sign == 0)
        cursor_error(p->c, "before this place: division by zero");

    /* Exact: rational with rational; angle +- angle; angle times or divided
     * by a rational; angle / angle. */
    if (!both_exact || (sum && angles == 1) ||
        (operation == '*' && angles == 2) ||
        (operation == '/' && angles == 1 && right->kind == ANGLE)) {
        apply_to_enclosures(out, operation, right, p);
        return;
    }
    if (operation == '+')
        rational_add(&q, &out->q, &right->q);
    else if (operation == '-')
        rational_sub(&q, &out->q, &right->q);
    else if (operation == '*')
        rational_mul(&q, &out->q, &right->q);
    else
        rational_divide(&q, &out->q, &right->q);
    if (angles == 0 || (operation == '/' && angles == 2))
        set_rational(out, &q);
    else
        set_angle(out, &q);
}

static void negate(struct value *v)
{
    if (v->kind == ENCLOSURE)
        interval_minus(&v->x, &v->x);
    else
        rational_negate(&v->q, &v->q);
}

/* v := v ^ n, or v ^ -n */
static void raise_to_power(struct value *v, int n, bool inverse, struct parser *p)
{
    struct value one, base;

    one.kind = RATIONAL;
    rational_set_small(&one.q, 1, 1);
    if (n == 0) {
        set_value(v, &one);
        return;
    }
    if (v->kind == ANGLE && n == 1 && !inverse)
        return;
    if (v->kind == ANGLE) {
        value_enclose(&v->x, v, p->g);
        v->kind = ENCLOSURE;
    }
    set_value(&base, v);
    for (int i = 1; i < n; i++)
        apply(v, '*', &base, p);
    if (inverse) {
        apply(&one, '/', v, p);
        set_value(v, &one);
    }
}

static void cos_or_sin(struct value *v, bool sine, struct parser *p)
{
    rational exact;
    bool is_rational;

    if (v->kind == ENCLOSURE || (v->kind == RATIONAL && v->q.num.sign != 0))
        cursor_error(p->c, "before this place: expected 0 or a rational "
                           "multiple of pi in cos or sin");
    is_rational = sine ? rational_sin_pi(&exact, &v->q)
                       : rational_cos_pi(&exact, &v->q);
    if (is_rational) {
        set_rational(v, &exact);
        return;
    }
    if (sine)
        grid_sin_pi(&v->x, &v->q, p->g);
    else
        grid_cos_pi(&v->x, &v->q, p->g);
    v->kind = ENCLOSURE;
}

/* Grammar
 * ------- */

static void read_formula(struct value *out, struct parser *p);

/* Digits with at most one point inside or in front. */
static void read_number(struct value *out, struct parser *p)
{
    struct cursor *c = p->c;
    integer num, den, ten, digit;
    bool point = false, digit_last = false;

    integer_set_small(&num, 0);
    integer_set_small(&den, 1);
    integer_set_small(&ten, 10);
    while (cursor_at_digit(c) || (c->at < c->end && *c->at == '.' && !point)) {
        digit_last = *c->at != '.';
        if (digit_last) {
            integer_set_small(&digit, *c->at - '0');
            integer_mul(&num, &num, &ten);
            integer_add(&num, &num, &digit);
            if (point)
                integer_mul(&den, &den, &ten);
        } else {
            point = true;
        }
        c->at++;
    }
    if (!digit_last)
        cursor_error(c, "expected a digit");
    rational_reduce(&out->q, &num, &den);
    out->kind = RATIONAL;
}

/* "(" formula ")" */
static void read_parentheses(struct value *out, struct parser *p)
{
    if (!cursor_accept(p->c, '('))
        cursor_error(p->c, "expected `(`");
    if (++p->nesting > MAX_NESTING)
        cursor_error(p->c, "expected at most 64 nested parentheses");
    read_formula(out, p);
    if (!cursor_accept(p->c, ')'))
        cursor_error(p->c, "expected an operator or `)`");
    p->nesting--;
}

static void read_primary(struct value *out, struct parser *p)
{
    struct cursor *c = p->c;

    cursor_skip_blanks(c);
    if (cursor_at_digit(c) || (c->at < c->end && *c->at == '.')) {
        read_number(out, p);
    } else if (p->k > 0 && cursor_accept_word(c, "k")) {
        rational_set_small(&out->q, p->k, 1);
        out->kind = RATIONAL;
    } else if (cursor_accept_word(c, "pi")) {
        rational_set_small(&out->q, 1, 1);
        out->kind = ANGLE;
    } else if (cursor_accept_word(c, "cos")) {
        read_parentheses(out, p);
        cos_or_sin(out, false, p);
    } else if (cursor_accept_word(c, "sin")) {
        read_parentheses(out, p);
        cos_or_sin(out, true, p);
    } else if (c->at < c->end && *c->at == '(') {
        read_parentheses(out, p);
    } else if (p->k > 0) {
        cursor_error(c, "expected a number, k, pi, cos, sin or `(`");
    } else {
        cursor_error(c, "expected a number, pi, cos, sin or `(`");
    }
}

static void read_power(struct value *out, struct parser *p)
{
    struct cursor *c = p->c;
    bool inverse;
    int n = 0;

    read_primary(out, p);
    if (!cursor_accept(c, '^'))
        return;
    inverse = cursor_accept(c, '-');
    cursor_skip_blanks(c);
    if (!cursor_at_digit(c))
        cursor_error(c, "expected the digits of an exponent");
    for (; cursor_at_digit(c); c->at++) {
        n = 10 * n + (*c->at - '0');
        if (n > MAX_EXPONENT)
            cursor_error(c, "expected an exponent of at most 64");
    }
    raise_to_power(out, n, inverse, p);
}

static void read_term(struct value *out, struct parser *p)
{
    struct value right;

    read_power(out, p);
    for (;;) {
        char operation = cursor_accept(p->c, '*') ? '*'
                       : cursor_accept(p->c, '/') ? '/' : '\0';

        if (operation == '\0')
            return;
        read_power(&right, p);
        apply(out, operation, &right, p);
    }
}

static void read_formula(struct value *out, struct parser *p)
{
    struct value right;

    if (cursor_accept(p->c, '-')) {
        read_term(out, p);
        negate(out);
    } else {
        read_term(out, p);
    }
    for (;;) {
        char operation = cursor_accept(p->c, '+') ? '+'
                       : cursor_accept(p->c, '-') ? '-' : '\0';

        if (operation == '\0')
            return;
        read_term(&right, p);
        apply(out, operation, &right, p);
    }
}

void formula_evaluate(struct value *out, struct cursor *c, int k, int g)
{
    struct parser p = { .c = c, .k = k, .g = g, .nesting = 0 };

    read_formula(out, &p);
}
