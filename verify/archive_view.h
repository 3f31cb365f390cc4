/* archive_view.h: an archive as a reader finds it. */
#ifndef VERIFY_ARCHIVE_VIEW_H
#define VERIFY_ARCHIVE_VIEW_H

#include "archive_index.h"
#include "buffer.h"

typedef struct {
    const char *path;        /* the caller's */
    buffer scheme;           /* texts of its files; empty where there is none */
    buffer index_text, runs;
    journal finished;
    archive_index index;     /* made from the directory as it is; */
    bool is_indexed;         /*   the file `index` says the same */
} archive_view;

void archive_view_init(archive_view *z);
void archive_view_clear(archive_view *z);

/* Reads it; nothing is locked.  false: errno says why; ENOENT: there is no directory, or no scheme.scheme in it. */
bool archive_view_read(archive_view *z, const char *path);

/* The second word of the scheme's text: its name; 64 characters at most. */
void archive_view_name(char name[65], const archive_view *z);

/* Appends the valences with that verdict as a list, neighbours together: "3..7, 9".  How many entries these are. */
size_t archive_view_list(buffer *text, const archive_view *z, verdict v);

#endif
