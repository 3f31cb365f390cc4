/* text.h: a scheme file as lines, and its canonical text (lib/scheme.md, "Text"). */
#ifndef LIB_TEXT_H
#define LIB_TEXT_H

#include "diagnostic.h"

#include <stddef.h>

enum { TEXT_MAX_BYTES = 65536, TEXT_MAX_LINE = 1000 };

/* One line of the canonical text, and where each of its characters stood in the original file. */
typedef struct {
    const char *text; /* `length` characters, ended by '\n' */
    size_t length;
    long line;          /* in the original file, from 1 */
    const long *column; /* column[i] of text[i] in the original line, from 1; length + 1 of them */
} text_line;

typedef struct {
    char *canonical; /* ended by NUL; each line ends in '\n' */
    size_t length;
    text_line *line;
    size_t lines;
    long *columns;
    long last_line; /* number of lines of the original file */
} source_text;

/* Reads `length` bytes of a file.  Complains about what lib/scheme.md excludes.  On any status text_clear. */
status text_read(source_text *t, const char *bytes, size_t length, diagnostic *d);
void text_clear(source_text *t);

#endif
