/* statement.c: the head of a certificate. */
#include "statement.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 80, MOST_LINES = 65536 };

typedef struct {
    const char *at, *end;
    long line;
} reader;

/* The next line, without its end, copied to text.  false: there is none, or it is too long. */
static bool next_line(reader *r, char text[LONGEST_LINE + 1])
{
    const char *stop = r->at < r->end ? memchr(r->at, '\n', (size_t)(r->end - r->at)) : NULL;
    r->line++;
    if (!stop || stop - r->at > LONGEST_LINE)
        return false;
    memcpy(text, r->at, (size_t)(stop - r->at));
    text[stop - r->at] = '\0';
    r->at = stop + 1;
    return true;
}

static bool skip_lines(reader *r, long count)
{
    for (long i = 0; i < count; i++) {
        const char *stop = r->at < r->end ? memchr(r->at, '\n', (size_t)(r->end - r->at)) : NULL;
        r->line++;
        if (!stop)
            return false;
        r->at = stop + 1;
    }
    return true;
}

/* What follows `name` and one blank in the next line; NULL: it is another line. */
static const char *next_value(reader *r, const char *name, char text[LONGEST_LINE + 1])
{
    size_t length = strlen(name);
    return next_line(r, text) && !strncmp(text, name, length) && text[length] == ' ' ? text + length + 1 : NULL;
}

static bool next_number(reader *r, long *value, const char *name, long high)
{
    char text[LONGEST_LINE + 1], *end = NULL;
    const char *digits = next_value(r, name, text);
    if (!digits || *digits < '0' || *digits > '9')
        return false;
    *value = strtol(digits, &end, 10);
    return *end == '\0' && *value <= high;
}

/* "7", "8 20" or "21 inf". */
static bool read_valences(valence_range *z, const char *word)
{
    char text[LONGEST_LINE + 2];
    const char *blank = strchr(word, ' '), *rest;
    if (blank)
        snprintf(text, sizeof text, "%.*s..%s", (int)(blank - word), word, blank + 1);
    rest = valence_range_read(z, blank ? text : word);
    return rest && *rest == '\0' && (z->first < z->last) == (blank != NULL);
}

static const char *read_head(statement *z, reader *r)
{
    char text[LONGEST_LINE + 1];
    const char *word;
    long version = 0, lines = 0;
    if (!next_number(r, &version, "smoothcert-certificate", 1000000))
        return "this is not a certificate";
    z->version = (int)version;
    if (version > STATEMENT_NEWEST_VERSION)
        return "a certificate of a later version, which this program does not know";
    if (!next_number(r, &lines, "scheme", MOST_LINES))
        return "expected 'scheme' and a number of lines";
    z->scheme = r->at;
    if (!skip_lines(r, lines))
        return "the scheme's text ends too early";
    z->scheme_length = (size_t)(r->at - z->scheme);
    word = next_value(r, "claim", text);
    if (!word || (strcmp(word, "c1") && strcmp(word, "not-c1")))
        return "expected 'claim c1' or 'claim not-c1'";
    z->c1 = !strcmp(word, "c1");
    word = next_value(r, "valence", text);
    if (!word || !read_valences(&z->valences, word))
        return "expected 'valence' and one number, or the ends of a range";
    if (!next_number(r, &z->grid, "grid", 1000000))
        z->grid = 0;
    return NULL;
}

const char *statement_read(statement *z, long *line, const char *bytes, size_t length)
{
    reader r = {bytes, bytes + length, 0};
    const char *complaint;
    memset(z, 0, sizeof *z);
    complaint = read_head(z, &r);
    *line = r.line;
    return complaint;
}

bool statement_is_about(const statement *z, const char *scheme, size_t length)
{
    return z->scheme_length == length && !memcmp(z->scheme, scheme, length);
}
