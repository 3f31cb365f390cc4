/* Reading files and lines: lib/scheme.md, "Text". */

#include "text.h"

#include "answer.h"
#include "scratch.h"

#include <stdio.h>
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
        if (used > limit)
            cannot_check("%s: the file has more than %zu bytes", name, limit);
        if (used < capacity - 1)
            break;

        char *larger = allocate(2 * capacity, 1);

        memcpy(larger, text, used);
        text = larger;
        capacity *= 2;
    }
    if (ferror(file) != 0)
        cannot_check("%s: the file cannot be read", name);
    fclose(file);
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

static void check_byte(const char *file, int line, int column, char c)
{
    if ((c < ' ' || c > '~') && !is_blank(c))
        cannot_check_at(file, line, column, "expected printable ASCII text");
    if (column > MAX_LINE)
        cannot_check_at(file, line, column, "expected a line of at most %d bytes", MAX_LINE);
}

char *text_canonical(const char *file, const char *text, size_t size, size_t *canonical_size)
{
    size_t used = 0, line_start = 0;
    bool in_comment = false, blank = false;
    int line = 1, column = 1;
    char *out = allocate(size + 2, 1);

    for (size_t i = 0; i <= size; i++, column++) {
        if (i == size || text[i] == '\n') {       /* the last LF may be missing */
            if (used > line_start)
                out[used++] = '\n';
            line_start = used;
            in_comment = blank = false;
            line++;
            column = 0;
            continue;
        }
        check_byte(file, line, column, text[i]);
        in_comment = in_comment || text[i] == '#';
        if (in_comment || is_blank(text[i])) {
            blank = true;
            continue;
        }
        if (blank && used > line_start)
            out[used++] = ' ';
        blank = false;
        out[used++] = text[i];
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
    *out = (struct cursor) { s->file, ++s->line, s->at, s->at, s->at };
    while (out->end < end && *out->end != '#')
        out->end++;
    s->at = end < s->end ? end + 1 : end;
    return true;
}

bool statements_more(struct cursor *out, struct statements *s)
{
    while (next_line(out, s))
        if (!cursor_at_end(out))
            return true;
    return false;
}

void statements_next(struct cursor *out, struct statements *s, const char *expected)
{
    if (statements_more(out, s))
        return;
    cannot_check_at(s->file, s->line + 1, 1, "%s, not the end of the file", expected);
}

/* Tokens
 * ------ */

noreturn void cursor_error(const struct cursor *c, const char *message)
{
    struct cursor here = *c;

    cursor_skip_blanks(&here);
    cannot_check_at(c->file, c->line, (int)(here.at - here.begin) + 1, "%s", message);
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

void cursor_expect(struct cursor *c, char token, const char *message)
{
    if (!cursor_accept(c, token))
        cursor_error(c, message);
}

bool cursor_accept_text(struct cursor *c, const char *text)
{
    size_t length = strlen(text);

    if ((size_t)(c->end - c->at) < length || memcmp(c->at, text, length) != 0)
        return false;
    c->at += length;
    return true;
}

/* The length of the word at the cursor. */
static size_t word_length(const struct cursor *c)
{
    size_t length = 0;

    if (c->at == c->end || !is_lower(*c->at))
        return 0;
    while (c->at + length < c->end && (is_lower(c->at[length]) ||
                                       is_digit(c->at[length]) || c->at[length] == '_'))
        length++;
    return length;
}

bool cursor_accept_word(struct cursor *c, const char *word)
{
    size_t length = strlen(word);

    cursor_skip_blanks(c);
    if (word_length(c) != length || memcmp(c->at, word, length) != 0)
        return false;
    c->at += length;
    return true;
}

bool cursor_is_apart(const struct cursor *c)
{
    char before = c->at[-1];

    return !is_lower(before) && !is_digit(before) && before != '_';
}

bool cursor_read_word(char *out, int limit, struct cursor *c)
{
    size_t length;

    cursor_skip_blanks(c);
    length = word_length(c);
    if (length == 0 || length > (size_t)limit)
        return false;
    memcpy(out, c->at, length);
    out[length] = '\0';
    c->at += length;
    return true;
}

bool cursor_at_digit(const struct cursor *c)
{
    return c->at < c->end && is_digit(*c->at);
}

int cursor_read_whole(struct cursor *c, int digits)
{
    bool negative = cursor_accept(c, '-');
    int value = 0, count = 0;

    for (; cursor_at_digit(c) && count <= digits; c->at++, count++)
        value = 10 * value + (*c->at - '0');
    if (count < 1 || count > digits)
        cursor_error(c, digits == 2 ? "expected an integer of one or two digits"
                                    : "expected an integer of one to three digits");
    return negative ? -value : value;
}
