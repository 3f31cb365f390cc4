/* tar.h: files as one archive in the ustar format (POSIX.1-1988): the same bytes for the same files, whoever packs them,
   wherever and whenever. */
#ifndef VERIFY_TAR_H
#define VERIFY_TAR_H

#include "buffer.h"

/* Appends a regular file `directory/name`, of the time 0 and of nobody, with permissions 0644 or 0755.  The directory's name has at most 154
   characters, the file's at most 99, the content is shorter than 8 GiB. */
void tar_add(buffer *z, const char *directory, const char *name, const char *bytes, size_t length, bool executable);
/* Appends what ends an archive. */
void tar_end(buffer *z);

#endif
