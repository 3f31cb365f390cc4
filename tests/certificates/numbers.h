/* numbers.h: the numbers of a certificate, each edited in turn.

   A number is replaced by 0, by 1, by its negative, by the next one and by the one before, and all numbers of a line are
   replaced by 0, and by 1, at once: what stands for nothing, or is just beyond what was proved.  The numbers are those of the lines
   behind `valence`; words that are trees stay as they are, t-mutate has more ideas of those. */
#ifndef TESTS_CERTIFICATES_NUMBERS_H
#define TESTS_CERTIFICATES_NUMBERS_H

#include "tests/certificates/mutations.h"

typedef enum { TO_ZERO, TO_ONE, NEGATED, ONE_MORE, ONE_LESS, EDIT_KINDS } edit_kind;

enum { WHOLE_LINE = 0 }; /* where the name of the line stands */

typedef struct {
    int line;       /* of the certificate's lines */
    int place;      /* of the line's words; WHOLE_LINE: all numbers (TO_ZERO, TO_ONE) */
    edit_kind kind;
} number_edit;

typedef struct {
    number_edit *edit;
    int count;
} number_edits;

/* All edits of a certificate without count and hash that change something, each once.  There are too many numbers in lists: of a run of
   lines of one name, and of the numbers of one line, no more than MOST are edited, the first, the last and random ones in between. */
enum { MOST = 6 };
void number_edits_make(number_edits *z, const lines *certificate);
void number_edits_clear(number_edits *z);

/* The line that becomes of this one. */
void number_edit_apply(char *out, size_t size, const char *line, number_edit e);

#endif
