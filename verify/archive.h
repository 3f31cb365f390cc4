/* archive.h: the directory in which runs of `prove` leave their evidence.

   It holds

     scheme.scheme     the scheme's text, with the parameters as they were set
     valence-K.cert    a certificate for each decided valence K, or range of valences such as 8..20 or 21..inf
     valence-K.log     how it was decided, or why not: JSON lines
     *.damaged         what was found damaged, and is no evidence any more
     index             in order, one line each: "K proved SHA256 FILE", "K refuted SHA256 FILE" or "K undecided"
     journal           the digests of all finished certificates and logs (journal.h)
     runs              which commands of which versions worked here: JSON lines
     verify.sh         checks all certificates with smoothcert-check alone
     lock              whoever locks it works here

   Every file but the journal and the lock appears under its name only when it is complete and durable, and is in the journal only
   after that.  A directory that holds another scheme is refused.  Of several runs at once all but one are refused. */
#ifndef VERIFY_ARCHIVE_H
#define VERIFY_ARCHIVE_H

#include "../lib/scheme.h"
#include "durable.h"
#include "escalate.h"
#include "journal.h"
#include "valence_range.h"

typedef struct {
    char *path; /* NULL: nothing is kept */
    journal finished; /* when it was opened */
    int journal_fd, lock_fd;
    durable_group group; /* written since the last commit, */
    buffer lines;        /* and their lines for the journal */
} archive;

typedef enum {
    ARCHIVE_OK,
    ARCHIVE_OTHER_SCHEME,  /* the directory is about another scheme, or other parameters */
    ARCHIVE_NO_SCHEME,     /* it holds certificates, but does not say of what scheme */
    ARCHIVE_BUSY,          /* another process works there */
    ARCHIVE_CONTRADICTION, /* two certificates contradict each other: a fault of the program */
    ARCHIVE_IO_ERROR       /* errno says more */
} archive_status;

void archive_init(archive *z);
void archive_clear(archive *z); /* what was not committed is lost */
/* Opens or creates the directory for the scheme.  run: a line for the file `runs` (archive_run.h). */
archive_status archive_open(archive *z, const char *path, const scheme *s, const buffer *run);

/* What there is of an earlier run. */
typedef enum {
    EARLIER_NONE,
    EARLIER_FINISHED,   /* it is what the journal says */
    EARLIER_UNFINISHED, /* the journal does not mention it: the run was killed, or the file comes from elsewhere */
    EARLIER_DAMAGED     /* it is not what was finished; no certificate is given out */
} archive_earlier;

/* The certificate of an earlier run, if there is one that can be read; nobody vouches for it.  May run in several threads. */
archive_earlier archive_read(const archive *z, buffer *certificate, valence_range k);

/* Writes log and certificate of a decision, which archive_commit makes durable; at most ARCHIVE_GROUP_MAX decisions before
   that.  earlier: what archive_read said of these valences; an undecided decision does not displace a proof that is good.
   *certificate receives the path of the certificate, to be freed, or NULL. */
enum { ARCHIVE_GROUP_MAX = DURABLE_GROUP_MAX / 2 };
archive_status archive_keep(archive *z, char **certificate, const decision *d, archive_earlier earlier);
archive_status archive_commit(archive *z);

/* "valence-8..20" and the suffix. */
enum { ARCHIVE_NAME_MAX = VALENCE_RANGE_TEXT + 16 };
void archive_name(char name[ARCHIVE_NAME_MAX], valence_range k, const char *suffix);

/* Moves a certificate that is damaged out of the way of those that now speak of its valences, and its log: to the first free
   of "NAME.damaged", "NAME.damaged-2" ...  The journal then knows
   them no more.  name receives the new name of the certificate. */
enum { ARCHIVE_ASIDE_MAX = ARCHIVE_NAME_MAX + 24 };
archive_status archive_set_aside(archive *z, char name[ARCHIVE_ASIDE_MAX], valence_range k);

/* Writes the index of all that is in the directory.  contradiction: the two of ARCHIVE_CONTRADICTION. */
archive_status archive_write_index(const archive *z, valence_range contradiction[2]);

/* Reads the journal of the directory; it may be missing.  false: errno says why. */
bool archive_read_journal(journal *z, const char *path);

#define ARCHIVE_SCHEME "scheme.scheme"
#define ARCHIVE_INDEX "index"
#define ARCHIVE_JOURNAL "journal"
#define ARCHIVE_RUNS "runs"
#define ARCHIVE_VERIFY "verify.sh"
#define ARCHIVE_LOCK "lock"
#define ARCHIVE_CERTIFICATE ".cert"
#define ARCHIVE_LOG ".log"
#define ARCHIVE_ASIDE ".damaged"

/* No file of an archive is longer than this, but for journal and runs. */
#define ARCHIVE_MAX_BYTES (64 << 20)

#endif
