/* archive_view.c: reading without changing anything. */
#define _POSIX_C_SOURCE 200809L
#include "archive_view.h"

#include "archive.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define MAX_TEXT_BYTES (1 << 30)

void archive_view_init(archive_view *z)
{
    z->path = NULL;
    buffer_init(&z->scheme);
    buffer_init(&z->index_text);
    buffer_init(&z->runs);
    journal_init(&z->finished);
    archive_index_init(&z->index);
    z->is_indexed = false;
}

void archive_view_clear(archive_view *z)
{
    buffer_clear(&z->scheme);
    buffer_clear(&z->index_text);
    buffer_clear(&z->runs);
    journal_clear(&z->finished);
    archive_index_clear(&z->index);
}

static bool read_text(buffer *z, const char *path, const char *name, bool needed)
{
    char *file = durable_path(path, name);
    bool ok = file && (buffer_read_file(z, file, MAX_TEXT_BYTES) || (errno == ENOENT && !needed));
    free(file);
    return ok;
}

/* false: no memory, as errno says. */
static bool compare_index(archive_view *z)
{
    buffer text;
    bool ok;
    buffer_init(&text);
    archive_index_print(&text, &z->index);
    z->is_indexed = text.length == z->index_text.length && (text.length == 0 || !memcmp(text.bytes, z->index_text.bytes, text.length));
    ok = !text.failed;
    if (!ok)
        errno = ENOMEM;
    buffer_clear(&text);
    return ok;
}

bool archive_view_read(archive_view *z, const char *path)
{
    z->path = path;
    return read_text(&z->scheme, path, ARCHIVE_SCHEME, true) && read_text(&z->index_text, path, ARCHIVE_INDEX, false) && read_text(&z->runs, path, ARCHIVE_RUNS, false) &&
           archive_read_journal(&z->finished, path) && archive_index_make(&z->index, path, &z->finished) && compare_index(z);
}

void archive_view_name(char name[65], const archive_view *z)
{
    const char *p = z->scheme.bytes ? z->scheme.bytes : "";
    size_t length = 0;
    if (!strncmp(p, "scheme ", 7))
        p += 7;
    while (length < 64 && p[length] > ' ' && p[length] != '/')
        length++;
    memcpy(name, p, length);
    name[length] = '\0';
}

static bool has_verdict(const archive_index_entry *e, verdict v)
{
    return e->verdict == v && !e->covered;
}

static void print_range(buffer *text, valence_range r, bool first)
{
    char valences[VALENCE_RANGE_TEXT];
    valence_range_print(valences, r);
    buffer_print(text, "%s%s", first ? "" : ", ", valences);
}

size_t archive_view_list(buffer *text, const archive_view *z, verdict v)
{
    size_t count = 0;
    valence_range together = {0, 0};
    bool first = true;
    for (size_t i = 0; i < z->index.count; i++) {
        valence_range next = z->index.entry[i].valences;
        if (!has_verdict(&z->index.entry[i], v))
            continue;
        if (count++ == 0)
            together = next;
        if (together.last < VALENCES_UNBOUNDED && next.first > together.last + 1) {
            print_range(text, together, first);
            first = false;
            together = next;
        }
        if (next.last > together.last)
            together.last = next.last;
    }
    if (count)
        print_range(text, together, first);
    return count;
}
