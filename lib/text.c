/* text.c: comments and superfluous blanks go, places are remembered. */
#include "text.h"

#include <stdlib.h>
#include <string.h>

void text_clear(source_text *t)
{
    free(t->canonical);
    free(t->line);
    free(t->columns);
    memset(t, 0, sizeof *t);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Appends one original line [bytes, bytes + length) to the canonical text. */
static status add_line(source_text *t, const char *bytes, size_t length, long number, diagnostic *d)
{
    size_t start = t->length;
    bool gap = false;
    if (length > TEXT_MAX_LINE)
        return diagnostic_set(d, number, TEXT_MAX_LINE + 1, "a line may have %d bytes at most", TEXT_MAX_LINE);
    for (size_t i = 0; i < length; i++)
        if (!is_blank(bytes[i]) && (bytes[i] < 33 || bytes[i] > 126))
            return diagnostic_set(d, number, (long)i + 1, "byte %d is not allowed: a scheme is plain ASCII text", (unsigned char)bytes[i]);
    for (size_t i = 0; i < length && bytes[i] != '#'; i++) {
        if (is_blank(bytes[i])) {
            gap = t->length > start;
            continue;
        }
        if (gap) {
            t->columns[t->length] = (long)i;
            t->canonical[t->length++] = ' ';
            gap = false;
        }
        t->columns[t->length] = (long)i + 1;
        t->canonical[t->length++] = bytes[i];
    }
    if (t->length > start) {
        text_line *line = &t->line[t->lines++];
        line->text = t->canonical + start;
        line->length = t->length - start;
        line->line = number;
        line->column = t->columns + start;
        t->columns[t->length] = t->columns[t->length - 1] + 1;
        t->canonical[t->length++] = '\n';
    }
    return STATUS_OK;
}

status text_read(source_text *t, const char *bytes, size_t length, diagnostic *d)
{
    size_t at = 0;
    memset(t, 0, sizeof *t);
    if (length > TEXT_MAX_BYTES)
        return diagnostic_set(d, 0, 0, "a scheme may have %d bytes at most", TEXT_MAX_BYTES);
    /* a canonical line is no longer than the original with its line end, except the last one */
    t->canonical = malloc(length + 2);
    t->columns = malloc((length + 2) * sizeof *t->columns);
    t->line = malloc((length + 1) * sizeof *t->line);
    if (!t->canonical || !t->columns || !t->line)
        return STATUS_NO_MEMORY;
    while (at < length) {
        const char *end = memchr(bytes + at, '\n', length - at);
        size_t line_length = end ? (size_t)(end - bytes) - at : length - at;
        status s = add_line(t, bytes + at, line_length, ++t->last_line, d);
        if (s != STATUS_OK)
            return s;
        at += line_length + 1;
    }
    t->canonical[t->length] = '\0';
    return STATUS_OK;
}
