/* archive_internal.h: what the files of archive.h share. */
#ifndef VERIFY_ARCHIVE_INTERNAL_H
#define VERIFY_ARCHIVE_INTERNAL_H

#include "archive.h"

/* Makes `name` hold the bytes, durably, or leaves it as it was.  false: errno says why. */
bool archive_store(const archive *z, const char *name, const char *bytes, size_t length);

#endif
