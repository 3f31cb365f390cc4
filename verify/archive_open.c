/* archive_open.c: a directory for a scheme: new, or one that was left. */
#define _POSIX_C_SOURCE 200809L
#include "archive.h"

#include "archive_index.h"
#include "archive_run.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MAX_RUNS_BYTES (1 << 30)

void archive_init(archive *z)
{
    z->path = NULL;
    z->journal_fd = z->lock_fd = -1;
    journal_init(&z->finished);
    durable_group_init(&z->group, NULL);
    buffer_init(&z->lines);
}

void archive_clear(archive *z)
{
    durable_group_abandon(&z->group);
    if (z->journal_fd >= 0)
        close(z->journal_fd);
    if (z->lock_fd >= 0)
        close(z->lock_fd);
    journal_clear(&z->finished);
    buffer_clear(&z->lines);
    free(z->path);
    archive_init(z);
}

/* A file that may be missing: then the buffer stays empty.  false: errno says why. */
static bool read_if_there(buffer *z, const archive *a, const char *name, size_t limit, bool *there)
{
    char *path = durable_path(a->path, name);
    bool ok = path && buffer_read_file(z, path, limit);
    *there = ok;
    if (path && !ok)
        ok = errno == ENOENT;
    free(path);
    return ok;
}

/* Whoever has the lock is alone until he closes it, or ends in whatever way. */
static archive_status take_lock(archive *z)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    char *path = durable_path(z->path, ARCHIVE_LOCK);
    if (!path)
        return ARCHIVE_IO_ERROR;
    z->lock_fd = open(path, O_RDWR | O_CREAT, 0666);
    free(path);
    if (z->lock_fd < 0)
        return ARCHIVE_IO_ERROR;
    if (fcntl(z->lock_fd, F_SETLK, &whole) == 0)
        return ARCHIVE_OK;
    return errno == EACCES || errno == EAGAIN ? ARCHIVE_BUSY : ARCHIVE_IO_ERROR;
}

/* What a run that was killed has left: nobody else works here now. */
static bool remove_rests(const archive *z)
{
    DIR *d = opendir(z->path);
    bool ok = d != NULL;
    for (struct dirent *f; ok && (errno = 0, f = readdir(d)) != NULL;) {
        size_t length = strlen(f->d_name);
        char *path;
        if (strncmp(f->d_name, "unfinished-", 11) || length < 4 || strcmp(f->d_name + length - 4, ".tmp"))
            continue;
        path = durable_path(z->path, f->d_name);
        ok = path && unlink(path) == 0;
        free(path);
    }
    ok = ok && errno == 0;
    if (d)
        closedir(d);
    return ok;
}

/* ARCHIVE_OK and !*there: the directory is new. */
static archive_status compare_scheme(const archive *z, const scheme *s, bool *there)
{
    archive_status result = ARCHIVE_OK;
    buffer text;
    buffer_init(&text);
    if (!read_if_there(&text, z, ARCHIVE_SCHEME, ARCHIVE_MAX_BYTES, there))
        result = ARCHIVE_IO_ERROR;
    else if (*there && (text.length != s->text_length || memcmp(text.bytes ? text.bytes : "", s->text, text.length)))
        result = ARCHIVE_OTHER_SCHEME;
    else if (!*there) {
        archive_index index;
        archive_index_init(&index);
        if (!archive_index_make(&index, z->path, &z->finished))
            result = ARCHIVE_IO_ERROR;
        else if (index.count)
            result = ARCHIVE_NO_SCHEME;
        archive_index_clear(&index);
    }
    buffer_clear(&text);
    return result;
}

/* The runs before this one, and this one. */
static bool add_run(archive *z, const buffer *run)
{
    buffer runs;
    bool there, ok;
    buffer_init(&runs);
    ok = read_if_there(&runs, z, ARCHIVE_RUNS, MAX_RUNS_BYTES, &there);
    if (ok && run->bytes)
        buffer_append(&runs, run->bytes, run->length);
    if (ok && (runs.failed || run->failed)) {
        errno = ENOMEM;
        ok = false;
    }
    ok = ok && durable_group_add(&z->group, ARCHIVE_RUNS, runs.bytes ? runs.bytes : "", runs.length, 0666);
    buffer_clear(&runs);
    return ok;
}

/* A journal whose end was cut off is replaced by one of what could be read. */
static bool mend_journal(archive *z)
{
    buffer text;
    bool ok;
    if (z->finished.tidy)
        return true;
    buffer_init(&text);
    for (size_t i = 0; i < z->finished.count; i++)
        buffer_print(&text, "%s  %s\n", z->finished.line[i].digest, z->finished.line[i].name);
    if (text.failed)
        errno = ENOMEM;
    ok = !text.failed && durable_store(z->path, ARCHIVE_JOURNAL, text.bytes ? text.bytes : "", text.length, 0666);
    buffer_clear(&text);
    return ok;
}

static bool open_journal(archive *z)
{
    char *path = durable_path(z->path, ARCHIVE_JOURNAL);
    if (!path)
        return false;
    z->journal_fd = open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
    free(path);
    return z->journal_fd >= 0;
}

/* What the directory says of itself is durable before any certificate is there. */
static archive_status describe(archive *z, const scheme *s, const buffer *run, bool is_new)
{
    bool ok = (!is_new || durable_sync_names(z->path)) && mend_journal(z) && open_journal(z);
    if (ok && is_new)
        ok = durable_group_add(&z->group, ARCHIVE_SCHEME, s->text, s->text_length, 0666);
    ok = ok && durable_group_add(&z->group, ARCHIVE_VERIFY, archive_verify_script, strlen(archive_verify_script), 0777);
    ok = ok && add_run(z, run) && durable_group_commit(&z->group);
    return ok ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
}

archive_status archive_open(archive *z, const char *path, const scheme *s, const buffer *run)
{
    archive_status result;
    bool there = false;
    if (!durable_make_directory(path))
        return ARCHIVE_IO_ERROR;
    z->path = malloc(strlen(path) + 1);
    if (!z->path) {
        errno = ENOMEM;
        return ARCHIVE_IO_ERROR;
    }
    strcpy(z->path, path);
    durable_group_init(&z->group, z->path);
    result = take_lock(z);
    if (result == ARCHIVE_OK && !(remove_rests(z) && archive_read_journal(&z->finished, z->path)))
        result = ARCHIVE_IO_ERROR;
    if (result == ARCHIVE_OK)
        result = compare_scheme(z, s, &there);
    return result == ARCHIVE_OK ? describe(z, s, run, !there) : result;
}
