#ifndef CHECK_TEXT_H
#define CHECK_TEXT_H

/* Texts
 * =====
 *
 * A whole file in memory, and a cursor that reads tokens of one statement of
 * the scheme language (lib/scheme.md, "Text").
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdnoreturn.h>

/* The bytes of the file `name`, and a 0 behind them.  A file that cannot be
 * read or has more than `limit` bytes: cannot check. */
char *text_read_file(const char *name, size_t limit, size_t *size);

/* The canonical text of a scheme file (lib/scheme.md), and a 0 behind it.
 * Bytes and lines that the language does not allow: cannot check. */
char *text_canonical(const char *file, const char *text, size_t size, size_t *canonical_size);

/* A place in one line: [at, end) is still to be read.  Column 1 is `begin`. */
struct cursor {
    const char *file;
    int line;
    const char *begin, *at, *end;
};

/* Statements of a scheme file: the lines that are not empty once comments are cut off. */
struct statements {
    const char *file;
    int line;                                      /* the one read last */
    const char *at, *end;
};

/* The next statement; at the end of the file "cannot check", with the text `expected`. */
void statements_next(struct cursor *out, struct statements *s, const char *expected);

/* The same, but false at the end of the file. */
bool statements_more(struct cursor *out, struct statements *s);

/* "cannot check: FILE:LINE:COLUMN: ...", the column of the next token. */
noreturn void cursor_error(const struct cursor *c, const char *message);

void cursor_skip_blanks(struct cursor *c);

/* Is the line used up?  If not (expect): cannot check. */
bool cursor_at_end(struct cursor *c);
void cursor_expect_end(struct cursor *c);

/* If the next token is this character: step over it. */
bool cursor_accept(struct cursor *c, char token);

/* The same; another token: cannot check. */
void cursor_expect(struct cursor *c, char token, const char *message);

/* If this text is at the cursor (without blanks before it): step over it. */
bool cursor_accept_text(struct cursor *c, const char *text);

/* If the next token is this word: step over it.  Words are lower-case letters,
 * behind the first also digits and `_`. */
bool cursor_accept_word(struct cursor *c, const char *word);

/* Is the cursor behind anything but a letter, digit or _ ? */
bool cursor_is_apart(const struct cursor *c);

/* The word at the cursor, of at most `limit` characters, into out[0..limit];
 * false if there is none. */
bool cursor_read_word(char *out, int limit, struct cursor *c);

bool cursor_at_digit(const struct cursor *c);

/* An optional `-` and 1 to `digits` digits, without blanks. */
int cursor_read_whole(struct cursor *c, int digits);

#endif
