/* command_out.h: what all commands with an option --out do with their archive. */
#ifndef VERIFY_COMMAND_OUT_H
#define VERIFY_COMMAND_OUT_H

#include "archive.h"

/* Opens or creates it (archive_open).  -1: well; else it has complained, and this is the exit status. */
int command_open_archive(archive *z, const char *path, const scheme *s, const buffer *run);

/* Writes its index.  0: well; else it has complained, and this is the exit status. */
int command_write_index(const archive *z);

#endif
