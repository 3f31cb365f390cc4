/* durable.c: write, fsync, rename, fsync of the directory. */
#define _POSIX_C_SOURCE 200809L
#include "durable.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *durable_path(const char *directory, const char *name)
{
    size_t length = strlen(directory) + strlen(name) + 2;
    char *p = malloc(length);
    if (p)
        snprintf(p, length, "%s/%s", directory, name);
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
        if (n == 0)
            errno = EIO;
        if (n <= 0)
            return false;
        bytes += n;
        length -= (size_t)n;
    }
    return true;
}

/* Closes without losing the error of what came before. */
static bool close_after(int fd, bool ok)
{
    int saved = errno;
    if (close(fd) != 0 && ok)
        return false;
    errno = saved;
    return ok;
}

static bool sync_directory(const char *path)
{
    int fd = open(path, O_RDONLY | O_DIRECTORY);
    return fd >= 0 && close_after(fd, fsync(fd) == 0);
}

/* ---- directories ---- */

/* Calls act for "a", "a/b" ... up to the whole of the path, as long as it returns true. */
static bool for_each_level(const char *path, bool (*act)(char *level))
{
    size_t length = strlen(path);
    char *level = malloc(length + 1);
    bool ok = level != NULL;
    if (!ok)
        errno = ENOMEM;
    for (size_t i = 1; ok && i <= length; i++) {
        if ((path[i] != '/' && path[i] != '\0') || path[i - 1] == '/')
            continue;
        memcpy(level, path, i);
        level[i] = '\0';
        ok = act(level);
    }
    free(level);
    return ok;
}

static bool make_level(char *path)
{
    struct stat s;
    if (stat(path, &s) == 0) {
        errno = ENOTDIR;
        return S_ISDIR(s.st_mode);
    }
    return errno == ENOENT && (mkdir(path, 0777) == 0 || errno == EEXIST);
}

bool durable_make_directory(const char *path)
{
    errno = ENOENT;
    return *path && for_each_level(path, make_level);
}

/* Syncs what holds the name behind the last '/'.  Where it may not be read, or cannot be synced at all, nobody can do more. */
static bool sync_name(char *path)
{
    char *separator = strrchr(path, '/');
    bool ok;
    if (separator && separator != path)
        *separator = '\0';
    ok = sync_directory(!separator ? "." : separator == path ? "/" : path);
    return ok || errno == EACCES || errno == EPERM || errno == EINVAL || errno == EROFS;
}

bool durable_sync_names(const char *path)
{
    return for_each_level(path, sync_name);
}

/* ---- files ---- */

void durable_group_init(durable_group *z, const char *directory)
{
    z->directory = directory;
    z->count = 0;
}

bool durable_group_add(durable_group *z, const char *name, const char *bytes, size_t length, unsigned mode)
{
    char unfinished[160];
    char *path = durable_path(z->directory, name), *temporary;
    int fd = -1;
    bool ok;
    snprintf(unfinished, sizeof unfinished, "unfinished-%ld-%s.tmp", (long)getpid(), name);
    temporary = durable_path(z->directory, unfinished);
    ok = path && temporary && (fd = open(temporary, O_WRONLY | O_CREAT | O_TRUNC, mode)) >= 0;
    if (!ok) {
        int saved = errno;
        free(path);
        free(temporary);
        errno = saved;
        return false;
    }
    z->file[z->count].temporary = temporary;
    z->file[z->count].path = path;
    z->file[z->count].fd = fd;
    z->count++;
    if (!write_all(fd, bytes, length))
        return false;
    /* The disk may begin now: then the fsyncs of the group wait for all its files at once. */
    posix_fadvise(fd, 0, 0, POSIX_FADV_DONTNEED);
    return true;
}

static bool sync_and_close(durable_group *z)
{
    bool ok = true;
    for (int i = 0; ok && i < z->count; i++) {
        int fd = z->file[i].fd;
        z->file[i].fd = -1;
        ok = close_after(fd, fsync(fd) == 0);
    }
    return ok;
}

static bool rename_all(durable_group *z)
{
    bool ok = true;
    for (int i = 0; ok && i < z->count; i++) {
        ok = rename(z->file[i].temporary, z->file[i].path) == 0;
        if (ok)
            *z->file[i].temporary = '\0';
    }
    return ok;
}

bool durable_group_commit(durable_group *z)
{
    bool ok = z->count == 0 || (sync_and_close(z) && rename_all(z) && sync_directory(z->directory));
    durable_group_abandon(z);
    return ok;
}

void durable_group_abandon(durable_group *z)
{
    int saved = errno;
    for (int i = 0; i < z->count; i++) {
        if (z->file[i].fd >= 0)
            close(z->file[i].fd);
        if (*z->file[i].temporary)
            unlink(z->file[i].temporary);
        free(z->file[i].temporary);
        free(z->file[i].path);
    }
    z->count = 0;
    errno = saved;
}

bool durable_store(const char *directory, const char *name, const char *bytes, size_t length, unsigned mode)
{
    durable_group one;
    durable_group_init(&one, directory);
    if (durable_group_add(&one, name, bytes, length, mode))
        return durable_group_commit(&one);
    durable_group_abandon(&one);
    return false;
}

bool durable_rename(const char *directory, const char *from, const char *to)
{
    char *old = durable_path(directory, from), *new = durable_path(directory, to);
    bool ok = old && new && rename(old, new) == 0 && sync_directory(directory);
    int saved = errno;
    free(old);
    free(new);
    errno = saved;
    return ok;
}

bool durable_append(int fd, const char *bytes, size_t length)
{
    return write_all(fd, bytes, length) && fsync(fd) == 0;
}
