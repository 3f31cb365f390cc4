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
    cursor_expect(p->c, '(', "expected `(`");
    if (++p->nesting > MAX_NESTING)
        cursor_error(p->c, "expected at most 64 nested parentheses");
}

static void close_parenthesis(struct parser *p)
{
    cursor_expect(p->c, ')', "expected an operator or `)`");
    p->nesting--;
}

/* "(" formula { "," formula } ")", from `least` to `most` of them */
static struct node *read_arguments(enum node_kind kind, int least, int most, struct parser *p)
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

/* (`<=` before `<`.) */
static char read_comparison_sign(struct cursor *c)
{
    static const struct {
        const char *text;
        char join;
    } sign[] = {
        { "=", '=' }, { "!=", '!' }, { "<=", 'l' }, { ">=", 'g' }, { "<", '<' }, { ">", '>' }
    };

    cursor_skip_blanks(c);
    for (size_t i = 0; i < sizeof sign / sizeof sign[0]; i++)
        if (cursor_accept_text(c, sign[i].text))
            return sign[i].join;
    cursor_error(c, "expected a comparison");
}

static struct node *read_comparison(struct parser *p)
{
    struct node *out = new_node(NODE_COMPARISON, p), *last = NULL;
    char join;

    append(out, &last, read_formula(p), ' ', p);
    join = read_comparison_sign(p->c);
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
        cursor_expect(p->c, ':', "expected `:`");
        append(out, &last, read_formula(p), ' ', p);
        more = !last_case && cursor_accept(p->c, ';');
    }
    close_parenthesis(p);
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
    cursor_error(place, "expected a number, a function, `(` or a name that is defined above");
}

static const struct word {
    const char *name;
    enum node_kind kind;
    int meaning, least, most;                      /* of a variable; arguments */
    bool beyond_0;
} known[] = {
    { "pi", NODE_PI, 0, 0, 0, false }, { "k", NODE_K, MEANS_K, 0, 0, false },
    { "m", NODE_M, MEANS_M, 0, 0, false }, { "j", NODE_J, MEANS_J, 0, 0, false },
    { "cos", NODE_COS, 0, 1, 1, false }, { "sin", NODE_SIN, 0, 1, 1, false },
    { "sqrt", NODE_SQRT, 0, 1, 1, true }, { "abs", NODE_ABS, 0, 1, 1, true },
    { "min", NODE_MIN, 0, 2, 1000, true }, { "max", NODE_MAX, 0, 2, 1000, true },
    { "mod", NODE_MOD, 0, 2, 2, true }, { "cases", NODE_CASES, 0, 1, 1, true }
};

/* What begins with a word, which is behind `place` now. */
static struct node *read_known_word(const struct word *word, const struct cursor *place,
                                    struct parser *p)
{
    struct node *out;

    if (word->beyond_0)
        p->l->beyond_0 = true;
    if (word->kind == NODE_CASES)
        return read_cases(p);
    if (word->most > 0)
        return read_arguments(word->kind, word->least, word->most, p);
    out = new_node(word->kind, p);
    out->meaning = word->meaning;
    if ((out->meaning & ~p->allowed) != 0)
        cursor_error(place, "expected a number, pi, a function or `(`: k, m or j has "
                            "no meaning here");
    return out;
}

static struct node *read_primary(struct parser *p)
{
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
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(word, known[i].name) == 0)
            return read_known_word(&known[i], &place, p);
    return read_defined_name(word, &place, p);
}

/* base [ "^" ["-"] exponent ]; version 0 has only whole numbers up to 64 there. */
static struct node *read_power(struct parser *p)
{
    struct node *base = read_primary(p), *exponent, *out, *last = NULL;
    bool minus;
    int64_t n;

    if (!cursor_accept(p->c, '^'))
        return base;
    out = new_node(NODE_POWER, p);
    minus = cursor_accept(p->c, '-');
    append(out, &last, base, ' ', p);
    exponent = read_primary(p);
    append(out, &last, exponent, minus ? '-' : '+', p);
    if (exponent->kind != NODE_NUMBER || !rational_is_whole(exponent->number) ||
        !integer_get_small(&n, exponent->number.num, MAX_EXPONENT_0))
        p->l->beyond_0 = true;
    return out;
}

/* One of the two characters, if it is there, else 0. */
static char accept_either(struct cursor *c, const char either[2])
{
    return cursor_accept(c, either[0]) ? either[0] : cursor_accept(c, either[1]) ? either[1] : '\0';
}

/* operand { sign operand }, the first one with the sign `before`.  A chain in brackets at the
 * beginning goes on, since all group from the left. */
static struct node *read_chain(enum node_kind kind, char before, const char signs[2],
                               struct node *(*read_operand)(struct parser *), struct parser *p)
{
    struct node *first = read_operand(p), *out = first, *last = NULL;
    char join = accept_either(p->c, signs);

    if (join == '\0' && before == signs[0])
        return first;
    if (first->kind == kind && before == signs[0]) {
        for (last = first->first; last->next != NULL; last = last->next)
            continue;
    } else {
        out = new_node(kind, p);
        append(out, &last, first, before, p);
    }
    for (; join != '\0'; join = accept_either(p->c, signs))
        append(out, &last, read_operand(p), join, p);
    return out;
}

static struct node *read_term(struct parser *p)
{
    return read_chain(NODE_PRODUCT, '*', "*/", read_power, p);
}

static struct node *read_formula(struct parser *p)
{
    char sign = cursor_accept(p->c, '-') ? '-' : '+';

    return read_chain(NODE_SUM, sign, "+-", read_term, p);
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
