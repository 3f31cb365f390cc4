/* journal.h: which files of an archive are finished, and what they then were.

   One line for each, in the form of sha256sum(1): "DIGEST  NAME", appended when the file is durable.  A later line about
   a name replaces the earlier ones; a digest of nothing but zeros says that the file was moved away.  A line that is cut off by a crash is nothing. */
#ifndef VERIFY_JOURNAL_H
#define VERIFY_JOURNAL_H

#include "buffer.h"

enum { JOURNAL_NAME_MAX = 63 };

typedef struct {
    char name[JOURNAL_NAME_MAX + 1];
    char digest[65];
    size_t order; /* of the lines */
} journal_line;

typedef struct {
    journal_line *line; /* by name, one for each */
    size_t count, capacity;
    bool tidy; /* the text was nothing but lines */
} journal;

void journal_init(journal *z);
void journal_clear(journal *z);

/* Reads the text of a journal.  false: no memory. */
BIGFLOAT_MUST_USE bool journal_read(journal *z, const char *bytes, size_t length);

/* The digest of a finished file; NULL: it is not finished. */
const char *journal_find(const journal *z, const char *name);

/* Appends the line that says: it is not finished any more. */
void journal_print_withdrawn(buffer *text, const char *name);

/* Appends the line for a file with these bytes. */
void journal_print(buffer *text, const char *name, const char *bytes, size_t length);

#endif
