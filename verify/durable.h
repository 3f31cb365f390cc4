/* durable.h: files that are under their names only when they are complete, and then survive a loss of power.

   The order is: write to a temporary name, fsync; rename; fsync of the directory.  A group of files shares the last
   step.  Nothing here repeats a failed fsync: what it has not written may be gone for good, and a second one would say
   that all is well. */
#ifndef VERIFY_DURABLE_H
#define VERIFY_DURABLE_H

#include <stdbool.h>
#include <stddef.h>

enum { DURABLE_GROUP_MAX = 64 };

/* "DIRECTORY/NAME", to be freed; NULL: no memory, as errno says, too. */
char *durable_path(const char *directory, const char *name);

/* Makes the directory, and those above it that are missing.  An existing one is as good.  false: errno says why. */
bool durable_make_directory(const char *path);
/* Makes its name durable, and those of all directories above it in the path, whoever made them: perhaps somebody who was killed
   before he could do that.  false: errno says why. */
bool durable_sync_names(const char *path);

/* Files of one directory that get their names together. */
typedef struct {
    const char *directory; /* the caller's */
    int count;
    struct {
        char *temporary, *path;
        int fd;
    } file[DURABLE_GROUP_MAX];
} durable_group;

void durable_group_init(durable_group *z, const char *directory);
/* Writes a file of the group under a temporary name; there is room for DURABLE_GROUP_MAX.  false: errno says why. */
bool durable_group_add(durable_group *z, const char *name, const char *bytes, size_t length, unsigned mode);
/* Makes all of them durable under their names, in the order of adding, and empties the group.  false: errno says why;
   each name then has its new file or its old one. */
bool durable_group_commit(durable_group *z);
/* Forgets them and leaves no rest. */
void durable_group_abandon(durable_group *z);

/* One file: both at once. */
bool durable_store(const char *directory, const char *name, const char *bytes, size_t length, unsigned mode);

/* Gives a file another name, in the place of what had it.  false: errno says why. */
bool durable_rename(const char *directory, const char *from, const char *to);

/* Appends to the file behind fd, durably.  false: errno says why. */
bool durable_append(int fd, const char *bytes, size_t length);

#endif
