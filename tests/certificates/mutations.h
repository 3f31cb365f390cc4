/* mutations.h: random edits of certificates that know what the lines mean. */
#ifndef TESTS_CERTIFICATES_MUTATIONS_H
#define TESTS_CERTIFICATES_MUTATIONS_H

#include "verify/buffer.h"

/* A text line by line, without line feeds. */
typedef struct {
    char **line;
    int count;
} lines;

/* The lines of the text up to the first that begins with `end` (NULL: all of them). */
void lines_read(lines *z, const char *text, const char *end);
void lines_clear(lines *z);
/* Appends all lines to the buffer. */
void lines_write(buffer *z, const lines *x);
/* The first line that begins with this word and a blank; x->count if there is none. */
int lines_find(const lines *x, const char *word);
void lines_replace(lines *z, int i, const char *line);

enum { MAX_TOKENS = 2000 };
/* The tokens of the line, which is cut up (at most MAX_TOKENS). */
int split_line(char **token, char *line);

bool line_has_name(const char *line, const char *name);
/* Whether the number in this place of the line (its name being 0) is decimal, else it is hexadecimal. */
bool number_is_decimal(const char *line, int place);
void number_negate(char *out, size_t size, const char *number);
/* The next number, or the one before; the same where it is none, or too large a decimal one. */
void number_next(char *out, size_t size, const char *number, bool decimal, bool down);

/* One random edit of the lines from `first` on: of lines, tokens, digits, numbers or trees, or lines of the same name
   taken from `other`, a certificate of something else. */
void mutate_lines(lines *z, int first, const lines *other);
/* One random edit of the numbers of the scheme's text, lines first..last. */
void mutate_scheme(lines *z, int first, int last);

#endif
