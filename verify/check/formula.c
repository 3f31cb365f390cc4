/* Formulas: a parser by recursive descent.  Each function below stands for one
 * line of the grammar of lib/scheme.md. */

#include "formula.h"

#include <string.h>

enum { MAX_NESTING = 64, MAX_OPERATIONS = 10000, MAX_EXPONENT_0 = 64 };

struct parser {
    struct cursor *c;
    struct language *l;
    int allowed;
    int nesting;
};

void beyond_version_0(struct language *l, const struct cursor *c, const char *message)
{
    struct cursor here = *c;

    if (l->beyond_0.message != NULL)
        return;
    cursor_skip_blanks(&here);
    l->beyond_0.line = here.line;
    l->beyond_0.column = (int)(here.at - here.begin) + 1;
    l->beyond_0.message = message;
}

bool word_is_reserved(const char *word)
{
    static const char *const reserved[] = {
        "scheme", "mesh", "triangle", "quad", "dilation", "vertices", "interior",
        "boundary", "crease", "parameter", "let", "mask", "symmetric", "end", "rule",
        "centre", "when", "all", "rest", "spectrum", "compose", "refine", "repeat",
        "smooth", "average", "and", "or", "pi", "k", "m", "j", "cos", "sin", "sqrt",
        "abs", "min", "max", "mod", "cases", "else"
    };

    for (size_t i = 0; i < sizeof reserved / sizeof reserved[0]; i++)
        if (strcmp(word, reserved[i]) == 0)
            return true;
    return false;
}

/* Nodes
 * ----- */

static struct node *new_node(enum node_kind kind, const struct parser *p)
{
    struct node *out = allocate(1, sizeof *out);
    struct cursor here = *p->c;

    cursor_skip_blanks(&here);
    out->kind = kind;
    out->line = here.line;
    out->column = (int)(here.at - here.begin) + 1;
    return out;
}

/* Makes `operand` the last one of `node`; last: the one before it or NULL. */
static void append(struct node *node, struct node **last, struct node *operand,
                   char join, const struct parser *p)
{
    operand->join = join;
    if (*last == NULL)
        node->first = operand;
    else
        (*last)->next = operand;
    *last = operand;
    node->meaning |= operand->meaning;
    node->operations += operand->operations + 1;
    if (node->operations > MAX_OPERATIONS)
        cursor_error(p->c, "expected a formula of at most 10000 operations");
}

/* Grammar
 * ------- */

static struct node *read_formula(struct parser *p);

/* Digits with at most one point inside or in front. */
static struct node *read_number(struct parser *p)
{
    struct node *out = new_node(NODE_NUMBER, p);
    struct cursor *c = p->c;
    integer num = integer_from(0), den = integer_from(1), ten = integer_from(10);
    bool point = false, digit_last = false;

    for (; cursor_at_digit(c) || (c->at < c->end && *c->at == '.' && !point); c->at++) {
        digit_last = *c->at != '.';
        if (digit_last) {
            num = integer_add(integer_mul(num, ten), integer_from(*c->at - '0'));
            if (point)
                den = integer_mul(den, ten);
        } else {
            point = true;
        }
    }
    if (!digit_last)
        cursor_error(c, "expected a digit");
    out->number = rational_reduce(num, den);
    return out;
}

static void open_parenthesis(struct parser *p)
{
    if (!cursor_accept(p->c, '('))
        cursor_error(p->c, "expected `(`");
    if (++p->nesting > MAX_NESTING)
        cursor_error(p->c, "expected at most 64 nested parentheses");
}

static void close_parenthesis(struct parser *p)
{
    if (!cursor_accept(p->c, ')'))
        cursor_error(p->c, "expected an operator or `)`");
    p->nesting--;
}

/* "(" formula { "," formula } ")", from `least` to `most` of them */
static struct node *read_arguments(enum node_kind kind, int least, int most,
                                   struct parser *p)
{
    struct node *out = new_node(kind, p), *last = NULL;
    int count = 0;

    open_parenthesis(p);
    do {
        append(out, &last, read_formula(p), ',', p);
        count++;
    } while (count < most && cursor_accept(p->c, ','));
    if (count < least)
        cursor_error(p->c, "expected `,` and another value");
    close_parenthesis(p);
    return out;
}

static struct node *read_comparison(struct parser *p)
{
    struct node *out = new_node(NODE_COMPARISON, p), *last = NULL;
    char join;

    append(out, &last, read_formula(p), ' ', p);
    cursor_skip_blanks(p->c);
    if (cursor_accept(p->c, '='))
        join = '=';
    else if (p->c->end - p->c->at >= 2 && memcmp(p->c->at, "!=", 2) == 0)
        join = '!', p->c->at += 2;
    else if (p->c->end - p->c->at >= 2 && memcmp(p->c->at, "<=", 2) == 0)
        join = 'l', p->c->at += 2;
    else if (p->c->end - p->c->at >= 2 && memcmp(p->c->at, ">=", 2) == 0)
        join = 'g', p->c->at += 2;
    else if (cursor_accept(p->c, '<'))
        join = '<';
    else if (cursor_accept(p->c, '>'))
        join = '>';
    else
        cursor_error(p->c, "expected a comparison");
    append(out, &last, read_formula(p), join, p);
    return out;
}

static struct node *read_condition(struct parser *p)
{
    struct node *out = new_node(NODE_AND, p), *last = NULL;
    const char *word = "and";

    append(out, &last, read_comparison(p), ' ', p);
    if (cursor_accept_word(p->c, "or")) {
        out->kind = NODE_OR;
        word = "or";
    } else if (!cursor_accept_word(p->c, "and")) {
        return out;
    }
    do
        append(out, &last, read_comparison(p), ' ', p);
    while (cursor_accept_word(p->c, word));
    return out;
}

/* "(" case { ";" case } ")" */
static struct node *read_cases(struct parser *p)
{
    struct node *out = new_node(NODE_CASES, p), *last = NULL;
    bool more = true;

    open_parenthesis(p);
    while (more) {
        bool last_case = cursor_accept_word(p->c, "else");

        if (!last_case)
            append(out, &last, read_condition(p), ' ', p);
        if (!cursor_accept(p->c, ':'))
            cursor_error(p->c, "expected `:`");
        append(out, &last, read_formula(p), ' ', p);
        more = !last_case && cursor_accept(p->c, ';');
    }
    close_parenthesis(p);
    return out;
}

/* k, m or j: is it allowed here? */
static struct node *read_variable(enum node_kind kind, int meaning,
                                  const struct cursor *place, struct parser *p)
{
    struct node *out = new_node(kind, p);

    if ((p->allowed & meaning) == 0)
        cursor_error(place, "expected a number, pi, a function or `(`: k, m or j has "
                            "no meaning here");
    out->meaning = meaning;
    return out;
}

static struct node *read_defined_name(const char *word, const struct cursor *place,
                              struct parser *p)
{
    struct node *out = new_node(NODE_NAME, p);

    for (int i = 0; i < p->l->count; i++) {
        const struct definition *d = &p->l->definition[i];

        if (strcmp(word, d->name) != 0)
            continue;
        out->name = i;
        out->meaning = d->formula != NULL ? d->formula->meaning : 0;
        out->operations = d->formula != NULL ? d->formula->operations : 0;
        if ((out->meaning & ~p->allowed) != 0)
            cursor_error(place, "the value of this name depends on something that "
                                "has no meaning here");
        return out;
    }
    cursor_error(place, "expected a number, a function, `(` or a name that is "
                        "defined above");
}

static struct node *read_primary(struct parser *p)
{
    static const struct {
        const char *name;
        enum node_kind kind;
        int least, most;
    } function[] = {
        { "cos", NODE_COS, 1, 1 }, { "sin", NODE_SIN, 1, 1 },
        { "sqrt", NODE_SQRT, 1, 1 }, { "abs", NODE_ABS, 1, 1 },
        { "min", NODE_MIN, 2, 1000 }, { "max", NODE_MAX, 2, 1000 },
        { "mod", NODE_MOD, 2, 2 }
    };
    struct cursor *c = p->c, place;
    struct node *out;
    char word[MAX_WORD + 1];

    cursor_skip_blanks(c);
    place = *c;
    if (cursor_at_digit(c) || (c->at < c->end && *c->at == '.'))
        return read_number(p);
    if (c->at < c->end && *c->at == '(') {
        open_parenthesis(p);
        out = read_formula(p);
        close_parenthesis(p);
        return out;
    }
    if (!cursor_read_word(word, MAX_WORD, c))
        cursor_error(c, "expected a number, a word or `(`");
    if (strcmp(word, "pi") == 0)
        return new_node(NODE_PI, p);
    if (strcmp(word, "k") == 0)
        return read_variable(NODE_K, MEANS_K, &place, p);
    if (strcmp(word, "m") == 0)
        return read_variable(NODE_M, MEANS_M, &place, p);
    if (strcmp(word, "j") == 0)
        return read_variable(NODE_J, MEANS_J, &place, p);
    if (strcmp(word, "cases") == 0) {
        beyond_version_0(p->l, &place, "expected a function of version 0");
        return read_cases(p);
    }
    for (size_t i = 0; i < sizeof function / sizeof function[0]; i++) {
        if (strcmp(word, function[i].name) != 0)
            continue;
        if (i >= 2)
            beyond_version_0(p->l, &place, "expected a function of version 0");
        return read_arguments(function[i].kind, function[i].least, function[i].most, p);
    }
    return read_defined_name(word, &place, p);
}

/* Version 0 has exponents of digits only, of at most 64. */
static void check_exponent_0(struct parser *p)
{
    struct cursor c = *p->c;
    int n = 0;

    cursor_skip_blanks(&c);
    if (!cursor_at_digit(&c)) {
        beyond_version_0(p->l, &c, "expected the digits of an exponent");
        return;
    }
    for (; cursor_at_digit(&c) && n <= MAX_EXPONENT_0; c.at++)
        n = 10 * n + (*c.at - '0');
    if (n > MAX_EXPONENT_0)
        beyond_version_0(p->l, &c, "expected an exponent of at most 64");
    else if (c.at < c.end && *c.at == '.')
        beyond_version_0(p->l, &c, "expected an operator or the end of the line");
}

static struct node *read_power(struct parser *p)
{
    struct node *base = read_primary(p), *out, *last = NULL;
    char join = '+';

    if (!cursor_accept(p->c, '^'))
        return base;
    out = new_node(NODE_POWER, p);
    if (cursor_accept(p->c, '-'))
        join = '-';
    check_exponent_0(p);
    append(out, &last, base, ' ', p);
    append(out, &last, read_primary(p), join, p);
    return out;
}

static struct node *read_term(struct parser *p)
{
    struct node *first = read_power(p), *out, *last = NULL;
    char join = cursor_accept(p->c, '*') ? '*' : cursor_accept(p->c, '/') ? '/' : '\0';

    if (join == '\0')
        return first;
    out = new_node(NODE_PRODUCT, p);
    append(out, &last, first, '*', p);
    while (join != '\0') {
        append(out, &last, read_power(p), join, p);
        join = cursor_accept(p->c, '*') ? '*' : cursor_accept(p->c, '/') ? '/' : '\0';
    }
    return out;
}

static struct node *read_formula(struct parser *p)
{
    struct node *out, *first, *last = NULL;
    bool minus = cursor_accept(p->c, '-');
    char join;

    first = read_term(p);
    join = cursor_accept(p->c, '+') ? '+' : cursor_accept(p->c, '-') ? '-' : '\0';
    if (!minus && join == '\0')
        return first;
    out = new_node(NODE_SUM, p);
    append(out, &last, first, minus ? '-' : '+', p);
    while (join != '\0') {
        append(out, &last, read_term(p), join, p);
        join = cursor_accept(p->c, '+') ? '+' : cursor_accept(p->c, '-') ? '-' : '\0';
    }
    return out;
}

const struct node *formula_read(struct cursor *c, struct language *l, int allowed)
{
    struct parser p = { .c = c, .l = l, .allowed = allowed, .nesting = 0 };

    return read_formula(&p);
}

const struct node *condition_read(struct cursor *c, struct language *l, int allowed)
{
    struct parser p = { .c = c, .l = l, .allowed = allowed, .nesting = 0 };

    return read_condition(&p);
}
