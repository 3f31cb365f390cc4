/* archive.c: write, fsync, rename, fsync of the directory. */
#define _POSIX_C_SOURCE 200809L
#include "archive_internal.h"

#include "prove_output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SCHEME_FILE "scheme.scheme"
#define MAX_SCHEME_BYTES 65536
#define MAX_CERTIFICATE_BYTES (64 << 20)

void archive_init(archive *z)
{
    z->path = NULL;
}

void archive_clear(archive *z)
{
    free(z->path);
    z->path = NULL;
}

static char *path_of(const archive *z, const char *name)
{
    size_t length = strlen(z->path) + strlen(name) + 2;
    char *p = malloc(length);
    if (p)
        snprintf(p, length, "%s/%s", z->path, name);
    else
        errno = ENOMEM;
    return p;
}

static bool write_all(int fd, const char *bytes, size_t length)
{
    while (length) {
        ssize_t n = write(fd, bytes, length);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        bytes += n;
        length -= (size_t)n;
    }
    return true;
}

static bool sync_directory(const char *path)
{
    int fd = open(path, O_RDONLY | O_DIRECTORY);
    bool ok = fd >= 0 && fsync(fd) == 0;
    if (fd >= 0 && close(fd) != 0)
        ok = false;
    return ok;
}

bool archive_store(const archive *z, const char *name, const char *bytes, size_t length)
{
    char unfinished[128];
    char *path = path_of(z, name), *temporary;
    bool ok = false;
    int fd, saved;
    snprintf(unfinished, sizeof unfinished, "unfinished-%ld-%s.tmp", (long)getpid(), name);
    temporary = path_of(z, unfinished);
    if (path && temporary && (fd = open(temporary, O_WRONLY | O_CREAT | O_TRUNC, 0666)) >= 0) {
        ok = write_all(fd, bytes, length) && fsync(fd) == 0;
        saved = errno;
        if (close(fd) != 0)
            ok = false;
        else
            errno = saved;
        ok = ok && rename(temporary, path) == 0 && sync_directory(z->path);
        if (!ok) {
            saved = errno;
            unlink(temporary);
            errno = saved;
        }
    }
    free(path);
    free(temporary);
    return ok;
}

archive_status archive_open(archive *z, const char *path, const scheme *s)
{
    buffer present;
    char *file;
    archive_status result = ARCHIVE_IO_ERROR;
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        return ARCHIVE_IO_ERROR;
    z->path = malloc(strlen(path) + 1);
    if (!z->path) {
        errno = ENOMEM;
        return ARCHIVE_IO_ERROR;
    }
    strcpy(z->path, path);
    file = path_of(z, SCHEME_FILE);
    if (!file)
        return ARCHIVE_IO_ERROR;
    buffer_init(&present);
    if (buffer_read_file(&present, file, MAX_SCHEME_BYTES)) {
        bool same = present.length == s->text_length && !memcmp(present.bytes ? present.bytes : "", s->text, present.length);
        result = same ? ARCHIVE_OK : ARCHIVE_OTHER_SCHEME;
    } else if (errno == ENOENT) {
        result = archive_store(z, SCHEME_FILE, s->text, s->text_length) ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
    }
    buffer_clear(&present);
    free(file);
    return result;
}

static bool is_proved(const archive *z, long valence)
{
    char name[64];
    char *path;
    bool present;
    snprintf(name, sizeof name, "valence-%ld.cert", valence);
    path = path_of(z, name);
    present = path && access(path, F_OK) == 0;
    free(path);
    return present;
}

void archive_read(const archive *z, buffer *certificate, long valence)
{
    char name[64];
    char *path;
    if (!z->path)
        return;
    snprintf(name, sizeof name, "valence-%ld.cert", valence);
    path = path_of(z, name);
    if (path && !buffer_read_file(certificate, path, MAX_CERTIFICATE_BYTES))
        buffer_clear(certificate);
    free(path);
}

archive_status archive_keep(archive *z, char **certificate, const decision *d)
{
    char name[64];
    buffer text;
    bool ok;
    *certificate = NULL;
    if (z->path && d->kept_before) {
        snprintf(name, sizeof name, "valence-%ld.cert", d->k.first);
        *certificate = path_of(z, name);
        return *certificate ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
    }
    if (!z->path || (d->verdict == VERDICT_UNDECIDED && is_proved(z, d->k.first)))
        return ARCHIVE_OK; /* what was proved once stays, and the log that belongs to it */
    buffer_init(&text);
    prove_write_log(&text, d);
    snprintf(name, sizeof name, "valence-%ld.log", d->k.first);
    if (text.failed)
        errno = ENOMEM;
    ok = !text.failed && archive_store(z, name, text.bytes, text.length);
    buffer_clear(&text);
    snprintf(name, sizeof name, "valence-%ld.cert", d->k.first);
    if (ok && d->verdict != VERDICT_UNDECIDED) {
        *certificate = path_of(z, name);
        ok = *certificate && archive_store(z, name, d->certificate.bytes, d->certificate.length);
    }
    return ok ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
}
