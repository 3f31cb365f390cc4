/* command_archive.h: the parts of the command `archive`, each for the directories that are left of its arguments.  They return
   the exit status. */
#ifndef VERIFY_COMMAND_ARCHIVE_H
#define VERIFY_COMMAND_ARCHIVE_H

#include "archive_view.h"

typedef struct {
    const char *out;   /* pack: a file; NULL: stdout */
    bool without_logs; /* pack */
    bool json;         /* list, verify, diff */
    char **directory;
    int count;
} archive_options;

int archive_list(const archive_options *o);
int archive_verify(const archive_options *o);
int archive_diff(const archive_options *o);
int archive_pack(const archive_options *o);

/* Reads an archive; complains.  -1: well; else the exit status. */
int archive_view_open(archive_view *z, const char *path);

#endif
