/* formula.c: a recursive-descent reader, one function per line of the grammar, and exact evaluation. */
#include "formula.h"

#include <stdlib.h>
#include <string.h>

#define MAX_DEPTH 64
#define MAX_EXPONENT 64

typedef struct {
    const char *at, *end;
    const char *start;  /* of the text */
    long line;
    const long *column; /* of each of its characters, in the file */
    int depth;
    diagnostic *complaint;
} reader;

void formula_free(formula *f)
{
    if (!f)
        return;
    formula_free(f->left);
    formula_free(f->right);
    rational_clear(&f->number);
    free(f);
}

static long column_of(const reader *r, const char *place)
{
    return r->column[place - r->start];
}

static void skip_blanks(reader *r)
{
    while (r->at < r->end && *r->at == ' ')
        r->at++;
}

/* The next character that is no blank, 0 at the end. */
static char peek(reader *r)
{
    skip_blanks(r);
    return r->at < r->end ? *r->at : '\0';
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

static status expected(reader *r, const char *what)
{
    char c = peek(r);
    if (c == '\0')
        return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "expected %s, but the line ends", what);
    return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "expected %s, found '%c'", what, c);
}

static status make_node(formula **z, formula_kind kind, char op, formula *left, formula *right, const reader *r, const char *place)
{
    formula *f = calloc(1, sizeof *f);
    if (!f) {
        formula_free(left);
        formula_free(right);
        return STATUS_NO_MEMORY;
    }
    rational_init(&f->number);
    f->kind = kind;
    f->op = op;
    f->left = left;
    f->right = right;
    f->line = r->line;
    f->column = column_of(r, place);
    *z = f;
    return STATUS_OK;
}

static status read_formula(formula **z, reader *r);

static status read_number(formula **z, reader *r)
{
    const char *start = r->at;
    int points = 0, digits = 0;
    status s;
    while (r->at < r->end && (is_digit(*r->at) || *r->at == '.')) {
        *r->at == '.' ? points++ : digits++;
        r->at++;
    }
    if (points > 1 || digits == 0 || r->at[-1] == '.')
        return diagnostic_set(r->complaint, r->line, column_of(r, start), "'%.*s' is not a number such as 3, 0.25 or .5",
                              (int)(r->at - start > 40 ? 40 : r->at - start), start);
    s = make_node(z, FORMULA_NUMBER, 0, NULL, NULL, r, start);
    if (s == STATUS_OK && rational_set_decimal(&(*z)->number, start, (size_t)(r->at - start)) != RATIONAL_TEXT_OK)
        s = STATUS_NO_MEMORY;
    return s;
}

static status read_parenthesis(formula **z, reader *r)
{
    status s;
    if (peek(r) != '(')
        return expected(r, "'('");
    if (++r->depth > MAX_DEPTH)
        return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "parentheses nest more than %d deep", MAX_DEPTH);
    r->at++;
    s = read_formula(z, r);
    if (s == STATUS_OK && peek(r) != ')')
        s = expected(r, "')' or an operator");
    r->at++;
    r->depth--;
    return s;
}

static status read_word(formula **z, reader *r)
{
    const char *start = r->at;
    int length;
    status s;
    while (r->at < r->end && is_letter(*r->at))
        r->at++;
    length = (int)(r->at - start);
    if (length == 1 && *start == 'k')
        return make_node(z, FORMULA_VALENCE, 0, NULL, NULL, r, start);
    if (length == 2 && !memcmp(start, "pi", 2))
        return make_node(z, FORMULA_PI, 0, NULL, NULL, r, start);
    if (length == 3 && (!memcmp(start, "cos", 3) || !memcmp(start, "sin", 3))) {
        formula *argument = NULL;
        s = read_parenthesis(&argument, r);
        if (s == STATUS_OK)
            return make_node(z, FORMULA_COS_SIN, *start, argument, NULL, r, start);
        formula_free(argument);
        return s;
    }
    return diagnostic_set(r->complaint, r->line, column_of(r, start), "unknown word '%.*s': expected a number, k, pi, cos(...) or sin(...)",
                          length > 40 ? 40 : length, start);
}

static status read_primary(formula **z, reader *r)
{
    char c = peek(r);
    if (is_digit(c) || c == '.')
        return read_number(z, r);
    if (is_letter(c))
        return read_word(z, r);
    if (c == '(')
        return read_parenthesis(z, r);
    return expected(r, "a number, k, pi, cos, sin or '('");
}

static status read_power(formula **z, reader *r)
{
    const char *place;
    bool negative = false;
    long n = 0;
    status s = read_primary(z, r);
    if (s != STATUS_OK || peek(r) != '^')
        return s;
    place = r->at++;
    if (peek(r) == '-') {
        negative = true;
        r->at++;
    }
    if (!is_digit(peek(r)))
        return expected(r, "a whole number as exponent");
    while (r->at < r->end && is_digit(*r->at) && n <= MAX_EXPONENT)
        n = 10 * n + (*r->at++ - '0');
    if (n > MAX_EXPONENT)
        return diagnostic_set(r->complaint, r->line, column_of(r, place), "an exponent may be %d at most", MAX_EXPONENT);
    s = make_node(z, FORMULA_POWER, 0, *z, NULL, r, place);
    if (s != STATUS_OK) {
        *z = NULL;
        return s;
    }
    (*z)->exponent = negative ? -n : n;
    return peek(r) == '^' ? expected(r, "no second '^' (write parentheses)") : STATUS_OK;
}

/* *z has been read; reads { op operand } with op one of the characters given, grouping from the left. */
static status continue_chain(formula **z, reader *r, const char *operators, status (*read_operand)(formula **, reader *))
{
    status s = STATUS_OK;
    while (s == STATUS_OK && peek(r) != '\0' && strchr(operators, *r->at)) {
        const char *place = r->at++;
        formula *right = NULL;
        s = read_operand(&right, r);
        if (s != STATUS_OK) {
            formula_free(right);
            return s;
        }
        s = make_node(z, FORMULA_BINARY, *place, *z, right, r, place);
        if (s != STATUS_OK)
            *z = NULL;
    }
    return s;
}

static status read_term(formula **z, reader *r)
{
    status s = read_power(z, r);
    return s == STATUS_OK ? continue_chain(z, r, "*/", read_power) : s;
}

static status read_signed_term(formula **z, reader *r)
{
    const char *place;
    status s;
    if (peek(r) != '-')
        return read_term(z, r);
    place = r->at++;
    s = read_term(z, r);
    if (s == STATUS_OK) {
        s = make_node(z, FORMULA_NEGATE, 0, *z, NULL, r, place);
        if (s != STATUS_OK)
            *z = NULL;
    }
    return s;
}

static status read_formula(formula **z, reader *r)
{
    status s = read_signed_term(z, r);
    return s == STATUS_OK ? continue_chain(z, r, "+-", read_term) : s;
}

status formula_read(formula **f, const char *text, size_t length, long line, const long *column, diagnostic *d)
{
    reader r = {text, text + length, text, line, column, 0, d};
    status s;
    *f = NULL;
    s = read_formula(f, &r);
    if (s == STATUS_OK && peek(&r) != '\0')
        s = expected(&r, "an operator or the end of the line");
    if (s != STATUS_OK) {
        formula_free(*f);
        *f = NULL;
    }
    return s;
}

bool formula_depends_on_valence(const formula *f)
{
    return f && (f->kind == FORMULA_VALENCE || formula_depends_on_valence(f->left) || formula_depends_on_valence(f->right));
}

status formula_complain(const formula *f, exact_status s, long k, diagnostic *d)
{
    const char *what = s == EXACT_DIVISION_BY_ZERO ? "division by zero"
                       : s == EXACT_TOO_LARGE ? "a rational number of more than 16384 bits"
                       : s == EXACT_UNDEFINED ? "cos and sin need a rational multiple of pi"
                                              : "expected a rational number, and this value is not one";
    if (s == EXACT_NO_MEMORY)
        return STATUS_NO_MEMORY;
    if (k > 0)
        return diagnostic_set(d, f->line, f->column, "%s (at valence k = %ld)", what, k);
    return diagnostic_set(d, f->line, f->column, "%s", what);
}

/* Puts the exact value of a node whose operands are z (and right) into z. */
static exact_status combine(exact_value *z, const formula *f, const exact_value *right, long k)
{
    bool ok = true;
    switch (f->kind) {
    case FORMULA_NUMBER:
        ok = rational_set(&z->q, &f->number);
        break;
    case FORMULA_VALENCE:
        ok = rational_set_si(&z->q, k, 1);
        break;
    case FORMULA_PI:
        z->is_angle = true;
        ok = rational_set_si(&z->q, 1, 1);
        break;
    case FORMULA_NEGATE:
        return exact_negate(z, z);
    case FORMULA_POWER:
        return exact_power(z, z, f->exponent);
    case FORMULA_COS_SIN:
        return exact_cos_sin(z, z, f->op);
    case FORMULA_BINARY:
        return exact_binary(z, z, f->op, right);
    }
    return ok ? EXACT_OK : EXACT_NO_MEMORY;
}

/* The depth of recursion is bounded by the reader: at most 64 nested parentheses, and chains lean left, so their
   length is bounded by the line's (1,000 characters). */
status formula_exact(exact_value *z, bool *known, const formula *f, long k, diagnostic *d)
{
    bool left_known = true, right_known = true;
    exact_value right;
    exact_status e;
    status s = f->left ? formula_exact(z, &left_known, f->left, k, d) : STATUS_OK;
    exact_init(&right);
    if (s == STATUS_OK && f->right)
        s = formula_exact(&right, &right_known, f->right, k, d);
    *known = left_known && right_known;
    if (f->kind == FORMULA_POWER && f->exponent == 0)
        *known = true; /* x^0 is 1, whatever x */
    if (s == STATUS_OK && *known) {
        e = combine(z, f, &right, k);
        *known = e == EXACT_OK;
        s = e == EXACT_OK || e == EXACT_NONE ? STATUS_OK : formula_complain(f, e, k, d);
    } else if (s == STATUS_OK && f->kind == FORMULA_COS_SIN) {
        s = formula_complain(f, EXACT_UNDEFINED, k, d);
    }
    exact_clear(&right);
    return s;
}

status formula_exact_rational(rational *z, const formula *f, long k, diagnostic *d)
{
    exact_value value;
    bool known;
    status s;
    exact_init(&value);
    s = formula_exact(&value, &known, f, k, d);
    if (s == STATUS_OK && (!known || value.is_angle))
        s = formula_complain(f, EXACT_NONE, k, d);
    rational_swap(z, &value.q);
    exact_clear(&value);
    return s;
}
