/* mutations.c: random edits of certificates. */
#include "mutations.h"

#include "tests/harness.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_LINE = 1 << 16 };

/* ---- lines ---- */

static char *copy_of(const char *bytes, size_t length)
{
    char *out = malloc(length + 1);
    if (!out)
        abort();
    memcpy(out, bytes, length);
    out[length] = '\0';
    return out;
}

static void insert_line(lines *z, int at, const char *line)
{
    char **more = realloc(z->line, (size_t)(z->count + 1) * sizeof *more);
    if (!more)
        abort();
    memmove(more + at + 1, more + at, (size_t)(z->count - at) * sizeof *more);
    more[at] = copy_of(line, strlen(line));
    z->line = more;
    z->count++;
}

static void delete_line(lines *z, int at)
{
    free(z->line[at]);
    z->count--;
    memmove(z->line + at, z->line + at + 1, (size_t)(z->count - at) * sizeof *z->line);
}

void lines_replace(lines *z, int i, const char *line)
{
    char *copy = copy_of(line, strlen(line));
    free(z->line[i]);
    z->line[i] = copy;
}

void lines_read(lines *z, const char *text, const char *end)
{
    z->line = NULL;
    z->count = 0;
    while (*text && !(end && strncmp(text, end, strlen(end)) == 0)) {
        size_t length = strcspn(text, "\n");
        char *line = copy_of(text, length);
        insert_line(z, z->count, line);
        free(line);
        text += length + (text[length] == '\n');
    }
}

void lines_clear(lines *z)
{
    while (z->count > 0)
        free(z->line[--z->count]);
    free(z->line);
    z->line = NULL;
}

void lines_write(buffer *z, const lines *x)
{
    for (int i = 0; i < x->count; i++) {
        buffer_append(z, x->line[i], strlen(x->line[i]));
        buffer_append(z, "\n", 1);
    }
}

int lines_find(const lines *x, const char *word)
{
    size_t length = strlen(word);
    int i = 0;
    while (i < x->count && (strncmp(x->line[i], word, length) != 0 || x->line[i][length] != ' '))
        i++;
    return i;
}

/* ---- numbers ---- */

static int below(int n)
{
    return (int)random_below((uint64_t)n);
}

static const char *pick(const char *const *words, int count)
{
    return words[below(count)];
}

static void corner_number(char *out, size_t size)
{
    static const char *const hexadecimal[] = {"0", "1", "-1", "2", "20", "-20", "c", "7fffffff", "80000000", "100000000", "ffffffffffffffff",
                                              "8000000000000000", "-8000000000000000", "10000000000000000", "-0", "0x1", "00", "+1", "-", "1.5"};
    static const char *const decimal[] = {"3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "63", "64", "65", "128", "500", "1000", "1024", "1025", "8192",
                                          "8193", "10000", "10001", "65536", "4294967296", "1000000000", "1000000001", "1099511627776", "18446744073709551616", "inf"};
    snprintf(out, size, "%s", random_bool() ? pick(hexadecimal, sizeof hexadecimal / sizeof *hexadecimal) : pick(decimal, sizeof decimal / sizeof *decimal));
}

bool line_has_name(const char *line, const char *name)
{
    size_t length = strcspn(line, " ");
    return strlen(name) == length && strncmp(line, name, length) == 0;
}

bool number_is_decimal(const char *line, int place)
{
    static const char *const names[] = {"valence", "grid", "contraction", "stability", "frequency", "second", "pivot", "block", "witness", "records", "scheme", "power",
                                        "limit", "unit", "degree", "grades", "field", "factor", "others", "exact"};
    static const struct { const char *name; int hexadecimal; } mixed[] = {{"cover", 3}, {"rise", 1}, {"wave", 1}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (line_has_name(line, names[i]))
            return true;
    for (size_t i = 0; i < sizeof mixed / sizeof *mixed; i++)
        if (line_has_name(line, mixed[i].name))
            return place != mixed[i].hexadecimal;
    return false;
}

/* number + 2^power, or - 2^power; the number itself where that is none, or too large a decimal one. */
static void shift_number_by(char *out, size_t size, const char *number, bool decimal, bool down, unsigned long power)
{
    integer x, y;
    buffer text;
    integer_init(&x);
    integer_init(&y);
    buffer_init(&text);
    snprintf(out, size, "%s", number);
    if (integer_set_str(&x, number, strlen(number), decimal ? 10 : 16) == INTEGER_TEXT_OK) {
        integer_set_si(&y, down ? -1 : 1);
        if (!integer_mul_2exp(&y, &y, power) || !integer_add(&x, &x, &y))
            abort();
        if (decimal && integer_fits_si(&x))
            snprintf(out, size, "%lld", (long long)integer_get_si(&x));
        else if (!decimal) {
            buffer_hexadecimal(&text, &x);
            snprintf(out, size, "%s", text.bytes);
        }
    }
    buffer_clear(&text);
    integer_clear(&x);
    integer_clear(&y);
}

void number_next(char *out, size_t size, const char *number, bool decimal, bool down)
{
    shift_number_by(out, size, number, decimal, down, 0);
}

/* A number plus or minus a power of two. */
static void shift_number(char *out, size_t size, const char *number, bool decimal)
{
    bool down = !random_bool();
    shift_number_by(out, size, number, decimal, down, below(2) ? (unsigned long)below(4) : (unsigned long)below(90));
}

void number_negate(char *out, size_t size, const char *number)
{
    snprintf(out, size, "%s%s", *number == '-' ? "" : "-", *number == '-' ? number + 1 : number);
}

/* ---- characters ---- */

static void mutate_character(char *out, size_t size, const char *word)
{
    static const char letters[] = "0123456789abcdefABF- ./k#x\t";
    int length = (int)strlen(word), at = below(length + 1);
    char letter = below(20) ? letters[below((int)sizeof letters - 1)] : (char)(1 + below(255));
    switch (below(3)) {
    case 0: /* one more */
        snprintf(out, size, "%.*s%c%s", at, word, letter, word + at);
        break;
    case 1: /* one less */
        snprintf(out, size, "%.*s%s", at, word, at < length ? word + at + 1 : "");
        break;
    default: /* another */
        snprintf(out, size, "%.*s%c%s", at, word, letter, at < length ? word + at + 1 : "");
    }
}

/* Another digit, of the last ones more often. */
static void mutate_digit(char *out, size_t size, const char *word)
{
    static const char digits[] = "0123456789abcdef";
    int length = (int)strlen(word), back = below(length < 8 || below(4) == 0 ? length : 8);
    snprintf(out, size, "%s", word);
    if (isxdigit((unsigned char)out[length - 1 - back]))
        out[length - 1 - back] = digits[below(16)];
}

/* Trees: leaves become splits with leaves, splits leaves, leaves others; parts go or come twice. */
static void mutate_trees(char *out, size_t size, const char *word)
{
    static const char *const split[] = {"100", "10000", "12222", "122", "1", "11000000"};
    int length = (int)strlen(word), at = below(length), to = at + below(length - at) + 1;
    const char *rest = word + at + 1;
    switch (below(6)) {
    case 0:
    case 1:
        snprintf(out, size, "%.*s%s%s", at, word, pick(split, 6), rest);
        break;
    case 2:
        snprintf(out, size, "%.*s%c%s", at, word, word[at] == '0' ? '2' : '0', rest);
        break;
    case 3: /* a split that seems to have only leaves becomes one */
        snprintf(out, size, "%.*s0%s", at, word, strlen(rest) >= 4 ? rest + (random_bool() ? 4 : 2) : "");
        break;
    case 4:
        snprintf(out, size, "%.*s%s", at, word, word + to);
        break;
    default:
        snprintf(out, size, "%.*s%s", to, word, word + at);
    }
}

static bool is_tree(const char *word)
{
    return strlen(word) > 1 && strspn(word, "012") == strlen(word);
}

static void mutate_token(char *out, size_t size, const char *token, bool decimal)
{
    int n = below(12);
    if (is_tree(token) && n < 8)
        mutate_trees(out, size, token);
    else if (n == 0)
        corner_number(out, size);
    else if (n == 1)
        number_negate(out, size, token);
    else if (n == 2)
        mutate_character(out, size, token);
    else if (n < 7)
        shift_number(out, size, token, decimal);
    else
        mutate_digit(out, size, token);
}

/* ---- tokens of a line ---- */

int split_line(char **token, char *line)
{
    int count = 0;
    for (char *p = line; *p && count < MAX_TOKENS; count++) {
        token[count] = p;
        p += strcspn(p, " ");
        if (*p)
            *p++ = '\0';
    }
    return count;
}

/* One token goes, comes twice, becomes another one, changes places with it, or is edited. */
static void mutate_tokens(char *out, size_t size, const char *line)
{
    static char changed[MAX_LINE];
    char *copy = copy_of(line, strlen(line)), *token[MAX_TOKENS];
    int count = split_line(token, copy), i, j, kind = below(12);
    size_t used = 0;
    out[0] = '\0';
    i = count > 1 && below(8) ? 1 + below(count - 1) : below(count + !count);
    j = below(count + !count);
    if (kind == 1 && count) {
        char *swapped = token[i];
        token[i] = token[j];
        token[j] = swapped;
    } else if (kind == 2 && count) {
        token[i] = token[j];
    } else if (kind > 3 && count && *token[i]) {
        mutate_token(changed, sizeof changed, token[i], number_is_decimal(line, i));
        token[i] = changed;
    }
    for (int n = 0; n < count && used < size; n++)
        for (int times = n == i && kind == 0 ? 0 : n == i && kind == 3 ? 2 : 1; times > 0 && used < size; times--)
            used += (size_t)snprintf(out + used, size - used, "%s%s", used ? " " : "", token[n]);
    free(copy);
}

/* ---- whole lines ---- */

static void first_word(char *out, size_t size, const char *line)
{
    snprintf(out, size, "%.*s", (int)strcspn(line, " "), line);
}

/* The line i, or all lines of its name, become those of the other certificate. */
static void borrow_lines(lines *z, int i, const lines *other)
{
    char name[64];
    int from, to;
    first_word(name, sizeof name, z->line[i]);
    from = lines_find(other, name);
    i = lines_find(z, name);
    if (from == other->count || i == z->count)
        return;
    if (random_bool()) {
        lines_replace(z, i, other->line[from]);
        return;
    }
    while (i < z->count && lines_find(z, name) == i)
        delete_line(z, i);
    for (to = from; to < other->count && strncmp(other->line[to], name, strlen(name)) == 0; to++)
        insert_line(z, i + to - from, other->line[to]);
}

static void swap_lines(lines *z, int i, int j)
{
    char *line = z->line[i];
    z->line[i] = z->line[j];
    z->line[j] = line;
}

void mutate_lines(lines *z, int first, const lines *other)
{
    static char changed[MAX_LINE];
    int i, j, kind = below(30);
    if (z->count <= first)
        return;
    i = first + below(z->count - first);
    j = first + below(z->count - first);
    if (kind == 0) {
        delete_line(z, i);
    } else if (kind == 1) {
        insert_line(z, j, z->line[i]);
    } else if (kind == 2) {
        swap_lines(z, i, j);
    } else if (kind == 3) {
        lines_replace(z, i, z->line[j]);
    } else if (kind < 8) {
        borrow_lines(z, i, other);
    } else if (kind == 8) {
        mutate_character(changed, sizeof changed, z->line[i]);
        lines_replace(z, i, changed);
    } else {
        mutate_tokens(changed, sizeof changed, z->line[i]);
        lines_replace(z, i, changed);
    }
}

void mutate_scheme(lines *z, int first, int last)
{
    static char changed[MAX_LINE];
    for (int tries = 0; tries < 50; tries++) {
        int i = first + below(last - first + 1), length = (int)strlen(z->line[i]), at = length ? below(length) : 0;
        if (length == 0 || length > 900 || !isdigit((unsigned char)z->line[i][at]))
            continue;
        if (below(10) == 0)
            mutate_character(changed, sizeof changed, z->line[i]);
        else
            snprintf(changed, sizeof changed, "%.*s%d%s", at, z->line[i], below(10), z->line[i] + at + 1);
        lines_replace(z, i, changed);
        return;
    }
}
