/* scheme_text.c: the text of a scheme as it was read, with the values that the settings gave to its parameters. */
#include "scheme_reader.h"

#include <stdlib.h>
#include <string.h>

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Appends bytes with every run of blanks as one, and none at the ends. */
static char *append_words(char *to, const char *bytes)
{
    const char *start = to;
    bool gap = false;
    for (; *bytes; bytes++) {
        if (is_blank(*bytes)) {
            gap = to > start;
            continue;
        }
        if (gap)
            *to++ = ' ';
        gap = false;
        *to++ = *bytes;
    }
    return to;
}

/* The setting of the parameter that the canonical line "parameter NAME = ..." defines, NULL if there is none; *value =
   where in the line its value stands. */
static const char *setting_for(const scheme_settings *settings, const text_line *line, size_t *value)
{
    static const char word[] = "parameter ";
    size_t start = sizeof word - 1, end = start, equals;
    const char *found = NULL;
    if (!settings || line->length <= start || memcmp(line->text, word, start))
        return NULL;
    while (end < line->length && line->text[end] != ' ' && line->text[end] != '=')
        end++;
    for (int i = 0; i < settings->count; i++) {
        const char *s = settings->settings[i];
        if (!strncmp(s, line->text + start, end - start) && s[end - start] == '=')
            found = s + (end - start) + 1;
    }
    equals = end + (end < line->length && line->text[end] == ' ');
    if (found)
        *value = equals + 1 + (equals + 1 < line->length && line->text[equals + 1] == ' ');
    return found;
}

status scheme_set_text(scheme_reader *r)
{
    scheme *z = r->z;
    size_t length = z->source.length + 1;
    char *to;
    for (int i = 0; r->settings && i < r->settings->count; i++)
        length += strlen(r->settings->settings[i]);
    to = z->text = malloc(length);
    if (!to)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < z->source.lines; i++) {
        const text_line *line = &z->source.line[i];
        size_t kept = line->length;
        const char *start = to, *value = setting_for(r->settings, line, &kept);
        memcpy(to, line->text, kept);
        to += kept;
        if (value)
            to = append_words(to, value);
        if (to - start > TEXT_MAX_LINE)
            return diagnostic_set(r->complaint, 0, 0, "a setting makes line %ld longer than %d bytes", line->line, TEXT_MAX_LINE);
        *to++ = '\n';
    }
    *to = '\0';
    z->text_length = (size_t)(to - z->text);
    if (z->text_length > TEXT_MAX_BYTES)
        return diagnostic_set(r->complaint, 0, 0, "the settings make the scheme longer than %d bytes", TEXT_MAX_BYTES);
    return STATUS_OK;
}
