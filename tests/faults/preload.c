/* preload.c: a library to be preloaded (LD_PRELOAD) that records what a program writes, lets calls fail, and kills it.

   By its environment:

     FAULTS_FAIL=KIND:N[+]:ERROR  the Nth call (with `+`: and all later ones) of this kind fails with this errno: KIND is
                                  malloc (and calloc, realloc), open (and fopen, opendir), write, fsync, rename, close, mkdir or unlink;
                                  ERROR a number
     FAULTS_KILL=N                SIGKILL before the Nth operation of those that are recorded
     FAULTS_SWALLOW=N             the Nth fsync says that all is well and does nothing, nor is it recorded
     FAULTS_COUNT=FILE            at the end, how many calls of each kind there were: lines "KIND N"
     FAULTS_RECORD=FILE           appends the record, one operation a line, for crash.c:
                                    mkdir PATH, create FILE PATH, truncate FILE, write FILE OFFSET HEX, fsync FILE,
                                    fsyncdir PATH, rename PATH PATH, unlink PATH,
                                    out N (a flush of stdout, which is a file, after which it has N bytes)
                                  FILE is a number

   One lock makes the record's order that of the operations. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MALLOC, OPEN, WRITE, FSYNC, RENAME, CLOSE, MKDIR, UNLINK, KINDS };
static const char *const names[KINDS] = {"malloc", "open", "write", "fsync", "rename", "close", "mkdir", "unlink"};

static atomic_long calls[KINDS];
static int failing = -1, failure, record = -1;
static long fail_at, kill_at, swallow_at, operations;
static bool fail_all_later;
static const char *count_file;
static pthread_mutex_t order = PTHREAD_MUTEX_INITIALIZER;

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static void read_failure(const char *text)
{
    char *end;
    for (int k = 0; k < KINDS; k++) {
        size_t length = strlen(names[k]);
        if (strncmp(text, names[k], length) || text[length] != ':')
            continue;
        fail_at = strtol(text + length + 1, &end, 10);
        fail_all_later = *end == '+';
        end += fail_all_later;
        failure = *end == ':' ? atoi(end + 1) : EIO;
        failing = k;
    }
}

__attribute__((constructor)) static void begin(void)
{
    const char *text;
    if ((text = getenv("FAULTS_KILL")))
        kill_at = atol(text);
    if ((text = getenv("FAULTS_SWALLOW")))
        swallow_at = atol(text);
    if ((text = getenv("FAULTS_RECORD")))
        record = (int)syscall(SYS_openat, AT_FDCWD, text, O_WRONLY | O_CREAT | O_APPEND, 0666);
    count_file = getenv("FAULTS_COUNT");
    if ((text = getenv("FAULTS_FAIL")))
        read_failure(text);
}

__attribute__((destructor)) static void end(void)
{
    int fd = count_file ? (int)syscall(SYS_openat, AT_FDCWD, count_file, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    for (int k = 0; fd >= 0 && k < KINDS; k++)
        dprintf(fd, "%s %ld\n", names[k], (long)calls[k]);
}

/* Is this call to fail?  Then errno is set. */
static bool fails(int kind)
{
    long n = ++calls[kind];
    if (kind != failing || (fail_all_later ? n < fail_at : n != fail_at))
        return false;
    errno = failure;
    return true;
}

/* ---- memory ---- */

#ifdef __GLIBC__
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *p, size_t size);

void *malloc(size_t size) { return fails(MALLOC) ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails(MALLOC) ? NULL : __libc_calloc(count, size); }
void *realloc(void *p, size_t size) { return fails(MALLOC) ? NULL : __libc_realloc(p, size); }
#endif

/* ---- the record ---- */

/* Takes the lock; returns before the operation. */
static void enter(void)
{
    pthread_mutex_lock(&order);
    if (++operations == kill_at)
        raise(SIGKILL);
}

static void leave(void)
{
    int saved = errno;
    pthread_mutex_unlock(&order);
    errno = saved;
}

static void note(const char *format, ...)
{
    int saved = errno;
    va_list arguments;
    va_start(arguments, format);
    if (record >= 0)
        vdprintf(record, format, arguments);
    va_end(arguments);
    errno = saved;
}

static long number_of(int fd)
{
    struct stat s;
    return fstat(fd, &s) == 0 ? (long)s.st_ino : -1;
}

static bool is_directory(int fd)
{
    struct stat s;
    return fstat(fd, &s) == 0 && S_ISDIR(s.st_mode);
}

/* The names under which directories were opened. */
enum { MOST = 256 };
static char directory_of[MOST][256];

static int open_and_note(const char *path, int flags, mode_t mode)
{
    struct stat s;
    bool is_new, writes = flags & (O_WRONLY | O_RDWR);
    int fd;
    if (fails(OPEN))
        return -1;
    if (!writes && !(flags & O_DIRECTORY))
        return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
    enter();
    is_new = stat(path, &s) != 0;
    fd = (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
    if (fd >= 0 && writes) {
        if (is_new)
            note("create %ld %s\n", number_of(fd), path);
        else if (flags & O_TRUNC)
            note("truncate %ld\n", number_of(fd));
    } else if (fd >= 0 && fd < MOST) {
        snprintf(directory_of[fd], sizeof directory_of[fd], "%s", path);
    }
    leave();
    return fd;
}

int open(const char *path, int flags, ...)
{
    va_list arguments;
    mode_t mode;
    va_start(arguments, flags);
    mode = (mode_t)va_arg(arguments, int);
    va_end(arguments);
    return open_and_note(path, flags, mode);
}

int open64(const char *path, int flags, ...) __attribute__((alias("open")));

FILE *fopen(const char *path, const char *mode)
{
    return fails(OPEN) ? NULL : REAL(fopen)(path, mode);
}

DIR *opendir(const char *path)
{
    return fails(OPEN) ? NULL : REAL(opendir)(path);
}

ssize_t write(int fd, const void *bytes, size_t length)
{
    struct stat s;
    off_t offset;
    ssize_t n;
    /* A full disk takes half of what it gets first. */
    if (fails(WRITE)) {
        bool first = failure == ENOSPC && calls[WRITE] == fail_at && length > 1;
        if (!first)
            return -1;
        length /= 2;
    }
    enter();
    offset = fstat(fd, &s) == 0 && (fcntl(fd, F_GETFL) & O_APPEND) ? s.st_size : lseek(fd, 0, SEEK_CUR);
    n = (ssize_t)syscall(SYS_write, fd, bytes, length);
    if (n > 0 && fd > 2 && fd != record && record >= 0) {
        note("write %ld %ld ", number_of(fd), (long)offset);
        for (ssize_t i = 0; i < n; i++)
            note("%02x", ((const unsigned char *)bytes)[i]);
        note("\n");
    }
    leave();
    return n;
}

int fsync(int fd)
{
    int result;
    if (fails(FSYNC))
        return -1;
    if (calls[FSYNC] == swallow_at)
        return 0;
    enter();
    result = (int)syscall(SYS_fsync, fd);
    if (result == 0 && is_directory(fd))
        note("fsyncdir %s\n", fd < MOST ? directory_of[fd] : "?");
    else if (result == 0)
        note("fsync %ld\n", number_of(fd));
    leave();
    return result;
}

int rename(const char *from, const char *to)
{
    int result;
    if (fails(RENAME))
        return -1;
    enter();
    result = (int)syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to);
    if (result == 0)
        note("rename %s %s\n", from, to);
    leave();
    return result;
}

int close(int fd)
{
    if (fails(CLOSE)) {
        int saved = errno;
        syscall(SYS_close, fd);
        errno = saved;
        return -1;
    }
    return (int)syscall(SYS_close, fd);
}

int mkdir(const char *path, mode_t mode)
{
    int result;
    if (fails(MKDIR))
        return -1;
    enter();
    result = (int)syscall(SYS_mkdirat, AT_FDCWD, path, mode);
    if (result == 0)
        note("mkdir %s\n", path);
    leave();
    return result;
}

int unlink(const char *path)
{
    int result;
    if (fails(UNLINK))
        return -1;
    enter();
    result = (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
    if (result == 0)
        note("unlink %s\n", path);
    leave();
    return result;
}

/* What is written to stdout is told: from then on it must be true. */
int fflush(FILE *f)
{
    struct stat s;
    int result;
    if (f != stdout)
        return REAL(fflush)(f);
    enter();
    result = REAL(fflush)(f);
    if (result == 0 && fstat(1, &s) == 0)
        note("out %ld\n", (long)s.st_size);
    leave();
    return result;
}
