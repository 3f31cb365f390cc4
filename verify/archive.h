/* archive.h: the directory in which a run leaves its evidence.

   It holds the scheme's text with the parameters as they were set (scheme.scheme), for each valence a certificate
   (valence-K.cert, only if proved) and a log (valence-K.log, JSON lines), and an index: one line per valence, in
   order, "K proved SHA256 FILE" or "K undecided".  A directory that holds another scheme is refused.  Every file appears
   under its name only when it is complete and durable. */
#ifndef VERIFY_ARCHIVE_H
#define VERIFY_ARCHIVE_H

#include "../lib/scheme.h"
#include "escalate.h"

typedef struct {
    char *path; /* NULL: nothing is kept */
} archive;

typedef enum { ARCHIVE_OK, ARCHIVE_OTHER_SCHEME, ARCHIVE_IO_ERROR } archive_status;

void archive_init(archive *z);
void archive_clear(archive *z);
/* Opens or creates the directory for the scheme.  errno says more of an ARCHIVE_IO_ERROR. */
archive_status archive_open(archive *z, const char *path, const scheme *s);
/* The certificate of an earlier run, if there is one that can be read; nobody vouches for it. */
void archive_read(const archive *z, buffer *certificate, long valence);
/* Keeps log and certificate of a decision (an undecided one does not displace an earlier proof); *certificate receives
   the path of the latter, to be freed, or NULL. */
archive_status archive_keep(archive *z, char **certificate, const decision *d);
/* Writes the index of all that is in the directory. */
archive_status archive_write_index(const archive *z);

#endif
