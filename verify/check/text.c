/* Reading files and lines: lib/scheme.md, "Text". */

#include "text.h"

#include "answer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_LINE = 1000 };

char *text_read_file(const char *name, size_t limit, size_t *size)
{
    FILE *file = fopen(name, "rb");
    size_t capacity = 65536, used = 0;
    char *text;

    if (file == NULL)
        cannot_check("%s: the file cannot be opened", name);
    text = allocate(capacity, 1);
    for (;;) {
        used += fread(text + used, 1, capacity - 1 - used, file);
        if (used < capacity - 1)
            break;
        if (used > limit)
            cannot_check("%s: the file has more than %zu bytes", name, limit);

        char *larger = allocate(2 * capacity, 1);

        memcpy(larger, text, used);
        free(text);
        text = larger;
        capacity *= 2;
    }
    if (ferror(file) != 0)
        cannot_check("%s: the file cannot be read", name);
    fclose(file);
    if (used > limit)
        cannot_check("%s: the file has more than %zu bytes", name, limit);
    text[used] = '\0';
    *size = used;
    return text;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static bool is_lower(char c)
{
    return c >= 'a' && c <= 'z';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The canonical text
 * ------------------ */

static void check_bytes(const char *file, const char *text, size_t size)
{
    int line = 1;
    int column = 1;

    for (size_t i = 0; i < size; i++, column++) {
        unsigned char byte = (unsigned char)text[i];

        if (byte == '\n') {
            line++;
            column = 0;
        } else if ((byte < 32 || byte > 126) && !is_blank(text[i])) {
            cannot_check_at(file, line, column, "expected printable ASCII text");
        } else if (column > MAX_LINE) {
            cannot_check_at(file, line, column,
                            "expected a line of at most %d bytes", MAX_LINE);
        }
    }
}

char *text_canonical(const char *file, const char *text, size_t size,
                     size_t *canonical_size)
{
    size_t used = 0, line_start = 0;
    bool in_comment = false, blank = false;
    char *out;

    check_bytes(file, text, size);
    out = allocate(size + 2, 1);
    for (size_t i = 0; i <= size; i++) {
        if (i == size || text[i] == '\n') {       /* the last LF may be missing */
            if (used > line_start)
                out[used++] = '\n';
            line_start = used;
            in_comment = false;
            blank = false;
        } else if (in_comment || text[i] == '#') {
            in_comment = true;
        } else if (is_blank(text[i])) {
            blank = true;
        } else {
            if (blank && used > line_start)
                out[used++] = ' ';
            blank = false;
            out[used++] = text[i];
        }
    }
    out[used] = '\0';
    *canonical_size = used;
    return out;
}

/* Statements
 * ---------- */

/* The next line without its comment; false at the end of the file. */
static bool next_line(struct cursor *out, struct statements *s)
{
    const char *end = s->at;

    if (s->at == s->end)
        return false;
    while (end < s->end && *end != '\n')
        end++;
    s->line++;
    out->file = s->file;
    out->line = s->line;
    out->begin = s->at;
    out->at = s->at;
    out->end = s->at;
    while (out->end < end && *out->end != '#')
        out->end++;
    s->at = end < s->end ? end + 1 : end;
    return true;
}

void statements_next(struct cursor *out, struct statements *s,
                     const char *expected)
{
    while (next_line(out, s))
        if (!cursor_at_end(out))
            return;
    cannot_check_at(s->file, s->line + 1, 1, "%s, not the end of the file",
                    expected);
}

void statements_end(struct statements *s)
{
    struct cursor c;

    while (next_line(&c, s))
        cursor_expect_end(&c);
}

/* Tokens
 * ------ */

_Noreturn void cursor_error(const struct cursor *c, const char *message)
{
    struct cursor here = *c;

    cursor_skip_blanks(&here);
    cannot_check_at(c->file, c->line, (int)(here.at - here.begin) + 1, "%s",
                    message);
}

void cursor_skip_blanks(struct cursor *c)
{
    while (c->at < c->end && is_blank(*c->at))
        c->at++;
}

bool cursor_at_end(struct cursor *c)
{
    cursor_skip_blanks(c);
    return c->at == c->end;
}

void cursor_expect_end(struct cursor *c)
{
    if (!cursor_at_end(c))
        cursor_error(c, "expected the end of the line");
}

bool cursor_accept(struct cursor *c, char token)
{
    cursor_skip_blanks(c);
    if (c->at == c->end || *c->at != token)
        return false;
    c->at++;
    return true;
}

bool cursor_accept_word(struct cursor *c, const char *word)
{
    size_t length = strlen(word);
    size_t found = 0;

    cursor_skip_blanks(c);
    while (c->at + found < c->end && is_lower(c->at[found]))
        found++;
    if (found != length || memcmp(c->at, word, length) != 0)
        return false;
    c->at += length;
    return true;
}

bool cursor_at_digit(const struct cursor *c)
{
    return c->at < c->end && is_digit(*c->at);
}

/* INT: an optional `-` and one or two digits. */
static int read_int(struct cursor *c)
{
    bool negative = cursor_accept(c, '-');
    int value = 0;
    int digits = 0;

    while (cursor_at_digit(c) && digits < 3) {
        value = 10 * value + (*c->at - '0');
        c->at++;
        digits++;
    }
    if (digits < 1 || digits > 2)
        cursor_error(c, "expected an integer of one or two digits");
    return negative ? -value : value;
}

void cursor_read_point(int *a, int *b, struct cursor *c)
{
    if (!cursor_accept(c, '('))
        cursor_error(c, "expected a point, like (1,0)");
    cursor_skip_blanks(c);
    *a = read_int(c);
    if (!cursor_accept(c, ','))
        cursor_error(c, "expected `,`");
    cursor_skip_blanks(c);
    *b = read_int(c);
    if (!cursor_accept(c, ')'))
        cursor_error(c, "expected `)`");
}
