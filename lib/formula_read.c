/* formula_read.c: a recursive-descent reader, one function per line of the grammar in lib/scheme.md. */
#include "formula.h"

#include <stdlib.h>
#include <string.h>

#define MAX_DEPTH 64
#define MAX_ARGUMENTS 64

typedef struct {
    const char *at, *end;
    const char *start;  /* of the text */
    long line;
    const long *column; /* of each of its characters, in the file */
    const definitions *names;
    unsigned allowed;
    int depth;
    diagnostic *complaint;
} reader;

static long column_of(const reader *r, const char *place)
{
    return r->column[place - r->start];
}

/* The next character that is no blank, 0 at the end. */
static char peek(reader *r)
{
    while (r->at < r->end && *r->at == ' ')
        r->at++;
    return r->at < r->end ? *r->at : '\0';
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

/* How many characters the word or number at r->at has; 1 for anything else. */
static int length_of_token(const reader *r)
{
    int length = 0;
    while (r->at + length < r->end && length < 40 && (is_letter(r->at[length]) || is_digit(r->at[length]) || r->at[length] == '_'))
        length++;
    return length ? length : 1;
}

static status expected(reader *r, const char *what)
{
    char c = peek(r);
    if (c == '\0')
        return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "expected %s, but the formula ends", what);
    return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "expected %s, found '%.*s'", what, length_of_token(r), r->at);
}

static bool take(reader *r, char c)
{
    if (peek(r) != c)
        return false;
    r->at++;
    return true;
}

/* ---- building nodes ---- */

/* A node without operands. */
static status make_leaf(formula **z, formula_kind kind, char op, unsigned depends, const reader *r, const char *place)
{
    formula *f = calloc(1, sizeof *f);
    *z = f;
    if (!f)
        return STATUS_NO_MEMORY;
    rational_init(&f->number);
    rational_init(&f->high);
    f->kind = kind;
    f->op = op;
    f->depends = depends;
    f->size = 1;
    f->line = r->line;
    f->column = column_of(r, place);
    return STATUS_OK;
}

/* Appends an operand (NULL allowed), which then belongs to f; also when this fails. */
static status add_child(formula *f, formula *child, const reader *r)
{
    formula **p = realloc(f->child, (size_t)(f->children + 1) * sizeof *p);
    if (!p) {
        formula_free(child);
        return STATUS_NO_MEMORY;
    }
    f->child = p;
    f->child[f->children++] = child;
    if (child) {
        f->depends |= child->depends;
        f->size += child->size;
    }
    if (f->size > FORMULA_MAX_SIZE)
        return diagnostic_set(r->complaint, f->line, f->column, "this formula has more than %d operations, definitions written out", FORMULA_MAX_SIZE);
    return STATUS_OK;
}

/* Makes *z the first operand of a new node that takes its place. */
static status wrap(formula **z, formula_kind kind, char op, const reader *r, const char *place)
{
    formula *operand = *z;
    status s = make_leaf(z, kind, op, 0, r, place);
    if (s != STATUS_OK) {
        formula_free(operand);
        return s;
    }
    return add_child(*z, operand, r);
}

/* ---- primaries ---- */

static status read_sum(formula **z, reader *r);
static status read_condition(formula **z, reader *r);

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
    s = make_leaf(z, FORMULA_NUMBER, 0, 0, r, start);
    if (s == STATUS_OK && rational_set_decimal(&(*z)->number, start, (size_t)(r->at - start)) != RATIONAL_TEXT_OK)
        s = STATUS_NO_MEMORY;
    return s;
}

static status enter(reader *r)
{
    if (peek(r) != '(')
        return expected(r, "'('");
    if (++r->depth > MAX_DEPTH)
        return diagnostic_set(r->complaint, r->line, column_of(r, r->at), "parentheses nest more than %d deep", MAX_DEPTH);
    r->at++;
    return STATUS_OK;
}

static status leave(reader *r, const char *what)
{
    r->depth--;
    return take(r, ')') ? STATUS_OK : expected(r, what);
}

static status read_parenthesis(formula **z, reader *r)
{
    status s = enter(r);
    if (s == STATUS_OK)
        s = read_sum(z, r);
    return s == STATUS_OK ? leave(r, "')' or an operator") : s;
}

/* The arguments of f: `least` to `most` of them, separated by commas. */
static status read_arguments(formula *f, reader *r, int least, int most)
{
    status s = enter(r);
    for (int count = 1; s == STATUS_OK; count++) {
        formula *argument = NULL;
        s = read_sum(&argument, r);
        if (s != STATUS_OK) {
            formula_free(argument);
            return s;
        }
        s = add_child(f, argument, r);
        if (s != STATUS_OK || count == most || (count >= least && peek(r) != ','))
            break;
        if (!take(r, ','))
            return expected(r, "','");
    }
    return s == STATUS_OK ? leave(r, "')' or an operator") : s;
}

static bool take_word(reader *r, const char *word)
{
    size_t length = strlen(word);
    peek(r);
    if ((size_t)(r->end - r->at) < length || memcmp(r->at, word, length) || (r->at + length < r->end && (is_letter(r->at[length]) || is_digit(r->at[length]) || r->at[length] == '_')))
        return false;
    r->at += length;
    return true;
}

/* cases(CONDITION: VALUE; ... else: VALUE) */
static status read_cases(formula *f, reader *r)
{
    status s = enter(r);
    bool last = false;
    while (s == STATUS_OK && !last) {
        formula *condition = NULL, *value = NULL;
        last = take_word(r, "else");
        if (!last) {
            s = read_condition(&condition, r);
        }
        if (s == STATUS_OK)
            s = take(r, ':') ? read_sum(&value, r) : expected(r, "':'");
        if (s != STATUS_OK) {
            formula_free(condition);
            formula_free(value);
            return s;
        }
        s = add_child(f, condition, r);
        if (s != STATUS_OK) {
            formula_free(value);
            return s;
        }
        s = add_child(f, value, r);
        if (last || !take(r, ';'))
            break;
    }
    return s == STATUS_OK ? leave(r, last ? "')'" : "';' or ')'") : s;
}

typedef struct {
    const char *name;
    formula_kind kind;
    char op;
    int least, most; /* arguments */
} function;

static const function functions[] = {
    {"cos", FORMULA_COS_SIN, 'c', 1, 1}, {"sin", FORMULA_COS_SIN, 's', 1, 1}, {"sqrt", FORMULA_SQRT, 0, 1, 1}, {"abs", FORMULA_ABS, 0, 1, 1},
    {"min", FORMULA_MIN, 0, 2, MAX_ARGUMENTS}, {"max", FORMULA_MAX, 0, 2, MAX_ARGUMENTS}, {"mod", FORMULA_MODULO, 0, 2, 2},
    {"cases", FORMULA_CASES, 0, 0, 0}, {NULL, FORMULA_NUMBER, 0, 0, 0},
};

static const char *const other_words[] = {
    "pi", "k", "m", "j", "else", "and", "or", "rest", "centre", "all", "end", "scheme", "mesh", "triangle", "quad", "dual", "dilation", "vertices",
    "interior", "boundary", "crease", "parameter", "let", "mask", "symmetric", "rule", "when", "spectrum", "compose", "refine", "smooth", "repeat",
    "average", NULL};

static bool equals(const char *name, const char *word, size_t length)
{
    return strlen(name) == length && !memcmp(name, word, length);
}

bool formula_is_reserved(const char *word, size_t length)
{
    for (const function *f = functions; f->name; f++)
        if (equals(f->name, word, length))
            return true;
    for (const char *const *w = other_words; *w; w++)
        if (equals(*w, word, length))
            return true;
    return false;
}

/* How many letters must be put in, left out, changed or exchanged with the next to make one word of the other (up to a
   bound). */
static int distance(const char *a, size_t m, const char *b, size_t n)
{
    int row[3][DEFINITION_MAX_NAME + 2];
    if (m > DEFINITION_MAX_NAME || n > DEFINITION_MAX_NAME)
        return DEFINITION_MAX_NAME;
    for (size_t j = 0; j <= n; j++)
        row[0][j] = (int)j;
    for (size_t i = 1; i <= m; i++) {
        int *now = row[i % 3], *before = row[(i + 2) % 3], *earlier = row[(i + 1) % 3];
        now[0] = (int)i;
        for (size_t j = 1; j <= n; j++) {
            int best = before[j - 1] + (a[i - 1] != b[j - 1]);
            best = before[j] + 1 < best ? before[j] + 1 : best;
            best = now[j - 1] + 1 < best ? now[j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && earlier[j - 2] + 1 < best)
                best = earlier[j - 2] + 1;
            now[j] = best;
        }
    }
    return row[m % 3][n];
}

/* Keeps the name that is nearest to the word; anything but one slip in three letters is no help. */
static void suggest(const char **best, int *least, const char *word, size_t length, const char *name)
{
    int d = distance(word, length, name, strlen(name));
    if (d < *least && 3 * d <= (int)length) {
        *best = name;
        *least = d;
    }
}

static status unknown_word(reader *r, const char *word, size_t length)
{
    const char *best = NULL;
    int least = DEFINITION_MAX_NAME, shown = (int)(length > 40 ? 40 : length);
    for (const char *const *w = other_words; *w; w++)
        if (equals(*w, word, length))
            return diagnostic_set(r->complaint, r->line, column_of(r, word), "'%.*s' has no meaning in a formula", shown, word);
    for (const function *f = functions; f->name; f++)
        suggest(&best, &least, word, length, f->name);
    for (int i = 0; i < r->names->count; i++)
        suggest(&best, &least, word, length, r->names->entry[i].name);
    if (best)
        return diagnostic_set(r->complaint, r->line, column_of(r, word), "unknown word '%.*s'; did you mean '%s'?", shown, word, best);
    return diagnostic_set(r->complaint, r->line, column_of(r, word), "unknown word '%.*s': expected a number, k, pi, a function or a name defined before", shown, word);
}

static const char *const variables[] = {"k, the valence", "m, the frequency", "j, the sector"};

static status read_variable(formula **z, reader *r, const char *word)
{
    int which = *word == 'k' ? 0 : *word == 'm' ? 1 : 2;
    unsigned flag = 1u << which;
    if (!(r->allowed & flag))
        return diagnostic_set(r->complaint, r->line, column_of(r, word), "%s, has no meaning here", variables[which]);
    return make_leaf(z, FORMULA_VARIABLE, *word, flag, r, word);
}

static status read_reference(formula **z, reader *r, const formula *value, const char *word)
{
    status s;
    for (int i = 0; i < 3; i++)
        if (value->depends & ~r->allowed & (1u << i))
            return diagnostic_set(r->complaint, r->line, column_of(r, word), "the value of this name depends on %s, which has no meaning here", variables[i]);
    s = make_leaf(z, FORMULA_REFERENCE, 0, value->depends, r, word);
    if (s == STATUS_OK) {
        (*z)->definition = value;
        (*z)->size += value->size;
    }
    return s;
}

static status read_word(formula **z, reader *r)
{
    const char *word = r->at;
    size_t length;
    while (r->at < r->end && (is_letter(*r->at) || is_digit(*r->at) || *r->at == '_'))
        r->at++;
    length = (size_t)(r->at - word);
    if (length == 1 && (*word == 'k' || *word == 'm' || *word == 'j'))
        return read_variable(z, r, word);
    if (equals("pi", word, length))
        return make_leaf(z, FORMULA_PI, 0, 0, r, word);
    for (const function *f = functions; f->name; f++)
        if (equals(f->name, word, length)) {
            status s = make_leaf(z, f->kind, f->op, 0, r, word);
            if (s == STATUS_OK)
                s = f->kind == FORMULA_CASES ? read_cases(*z, r) : read_arguments(*z, r, f->least, f->most);
            return s;
        }
    for (int i = 0; i < r->names->count; i++)
        if (equals(r->names->entry[i].name, word, length))
            return read_reference(z, r, r->names->entry[i].value, word);
    return unknown_word(r, word, length);
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
    if (peek(r) == '[')
        return expected(r, "a number, a word or '(' (an interval can only be the whole value of a parameter)");
    return expected(r, "a number, a word or '('");
}

/* ---- operators ---- */

static status read_power(formula **z, reader *r)
{
    const char *place;
    formula *exponent = NULL;
    status s = read_primary(z, r);
    if (s != STATUS_OK || peek(r) != '^')
        return s;
    place = r->at++;
    s = wrap(z, FORMULA_POWER, 0, r, place);
    if (s != STATUS_OK)
        return s;
    if (peek(r) == '-') {
        const char *sign = r->at++;
        s = read_primary(&exponent, r);
        if (s == STATUS_OK)
            s = wrap(&exponent, FORMULA_NEGATE, 0, r, sign);
    } else {
        s = read_primary(&exponent, r);
    }
    if (s != STATUS_OK) {
        formula_free(exponent);
        return s;
    }
    s = add_child(*z, exponent, r);
    return s == STATUS_OK && peek(r) == '^' ? diagnostic_set(r->complaint, r->line, column_of(r, r->at), "a second '^' needs parentheses, such as (a^b)^c") : s;
}

/* *z has been read; reads { op operand } with op one of the characters given, grouping from the left. */
static status continue_chain(formula **z, reader *r, const char *operators, status (*read_operand)(formula **, reader *))
{
    status s = STATUS_OK;
    while (s == STATUS_OK && peek(r) != '\0' && strchr(operators, *r->at)) {
        const char *place = r->at++;
        formula *right = NULL;
        s = read_operand(&right, r);
        if (s == STATUS_OK)
            s = wrap(z, FORMULA_BINARY, *place, r, place);
        if (s != STATUS_OK) {
            formula_free(right);
            return s;
        }
        s = add_child(*z, right, r);
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
    return s == STATUS_OK ? wrap(z, FORMULA_NEGATE, 0, r, place) : s;
}

static status read_sum(formula **z, reader *r)
{
    status s = read_signed_term(z, r);
    return s == STATUS_OK ? continue_chain(z, r, "+-", read_term) : s;
}

/* ---- conditions ---- */

static char take_comparison(reader *r)
{
    char c = peek(r);
    if (c != '=' && c != '!' && c != '<' && c != '>')
        return '\0';
    r->at++;
    if (c != '=' && r->at < r->end && *r->at == '=') {
        r->at++;
        return c == '!' ? '!' : c == '<' ? 'l' : 'g';
    }
    return c == '!' ? '\0' : c;
}

static status read_comparison(formula **z, reader *r)
{
    const char *place;
    char op;
    formula *right = NULL;
    status s = read_sum(z, r);
    if (s != STATUS_OK)
        return s;
    peek(r);
    place = r->at;
    op = take_comparison(r);
    if (!op) {
        r->at = place;
        return expected(r, "a comparison: = != < <= > or >=");
    }
    if (peek(r) == '=')
        return expected(r, "a formula behind the comparison (equality is written with one '=')");
    s = wrap(z, FORMULA_COMPARE, op, r, place);
    if (s != STATUS_OK)
        return s;
    s = read_sum(&right, r);
    if (s != STATUS_OK) {
        formula_free(right);
        return s;
    }
    return add_child(*z, right, r);
}

/* COMPARISON { and COMPARISON } or COMPARISON { or COMPARISON }: no mixture, so no precedence to remember. */
static status read_condition(formula **z, reader *r)
{
    status s = read_comparison(z, r);
    peek(r);
    const char *place = r->at;
    const char *word = s != STATUS_OK ? NULL : take_word(r, "and") ? "and" : take_word(r, "or") ? "or" : NULL;
    if (s != STATUS_OK || !word)
        return s;
    s = wrap(z, word[0] == 'a' ? FORMULA_AND : FORMULA_OR, 0, r, place);
    while (s == STATUS_OK) {
        formula *next = NULL;
        s = read_comparison(&next, r);
        if (s != STATUS_OK) {
            formula_free(next);
            return s;
        }
        s = add_child(*z, next, r);
        if (!take_word(r, word))
            break;
    }
    if (s == STATUS_OK) {
        peek(r);
        const char *other = r->at;
        if (take_word(r, "and") || take_word(r, "or"))
            return diagnostic_set(r->complaint, r->line, column_of(r, other), "'and' and 'or' cannot be mixed in one condition");
    }
    return s;
}

/* ---- entry ---- */

static status read_all(formula **f, status (*read)(formula **, reader *), reader *r)
{
    status s;
    *f = NULL;
    s = read(f, r);
    if (s == STATUS_OK && peek(r) == ',')
        s = expected(r, "an operator or the end of the line (decimals have a point: 0.5)");
    if (s == STATUS_OK && peek(r) != '\0')
        s = expected(r, "an operator or the end of the line");
    if (s != STATUS_OK) {
        formula_free(*f);
        *f = NULL;
    }
    return s;
}

status formula_read(formula **f, const char *text, size_t length, long line, const long *column, const definitions *names, unsigned allowed, diagnostic *d)
{
    reader r = {text, text + length, text, line, column, names, allowed, 0, d};
    return read_all(f, read_sum, &r);
}

status formula_read_condition(formula **f, const char *text, size_t length, long line, const long *column, const definitions *names, unsigned allowed, diagnostic *d)
{
    reader r = {text, text + length, text, line, column, names, allowed, 0, d};
    return read_all(f, read_condition, &r);
}
