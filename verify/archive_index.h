/* archive_index.h: what an archive holds, made from what is in the directory. */
#ifndef VERIFY_ARCHIVE_INDEX_H
#define VERIFY_ARCHIVE_INDEX_H

#include "journal.h"
#include "outcome.h"
#include "valence_range.h"

typedef struct {
    valence_range valences;
    verdict verdict;  /* VERDICT_UNDECIDED: there is no certificate, only a log */
    bool damaged;     /* there is a certificate, but it is not what the journal says, or none at all: undecided */
    char digest[65];  /* of the certificate */
    int version;      /* of the certificate, */
    long grid;        /* its grid, */
    size_t bytes;     /* and its length; 0: there is no certificate */
    long reach;       /* the last valence that a decided entry up to this one speaks of */
    bool covered;     /* undecided here, but decided as part of a longer range: not in the text */
} archive_index_entry;

typedef struct {
    archive_index_entry *entry; /* by valences */
    size_t count, capacity;
    size_t damaged; /* how many are */
} archive_index;

void archive_index_init(archive_index *z);
void archive_index_clear(archive_index *z);

/* Lists the directory and reads all its certificates.  false: errno says why. */
bool archive_index_make(archive_index *z, const char *path, const journal *finished);

/* The entries with a verdict about some valence of k, one after the other (the last one first): the one that follows `after`, NULL
   for the first.  NULL: no more. */
const archive_index_entry *archive_index_next(const archive_index *z, valence_range k, const archive_index_entry *after);

/* A damaged entry, not for k itself, about some valence of k; NULL: there is none. */
archive_index_entry *archive_index_damaged(const archive_index *z, valence_range k);

/* Appends the text of the file `index`. */
void archive_index_print(buffer *text, const archive_index *z);

/* Is there a valence that one certificate proves to be C1, and another not to be?  Then pair receives the two. */
bool archive_index_contradiction(valence_range pair[2], const archive_index *z);

#endif
