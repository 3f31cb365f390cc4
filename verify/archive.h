/* archive.h: the directory in which a run leaves its evidence.

   It holds the scheme's canonical text (scheme.scheme) and for each valence a certificate (valence-K.cert, only
   if proved) and a log (valence-K.log, JSON lines).  A directory that holds another scheme is refused.  Every
   file appears under its name only when it is complete and durable. */
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
/* Keeps log and certificate of a decision (an undecided one does not displace an earlier proof); *certificate receives the path of the latter, to be freed, or NULL. */
archive_status archive_keep(archive *z, char **certificate, const decision *d);

#endif
