/* checker.c: exit, files and memory for the checker inside a test.

   Memory takes the place of verify/check/scratch.c: every allocation is one of malloc's, so that the address sanitizer
   sees each step beyond its end and each use after scratch_release. */
#include "checker.h"

#include "verify/check/scratch.h"

#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <stdnoreturn.h>
#include <string.h>

enum { MAX_FILES = 2 };

noreturn void checker_exit(int status);
FILE *checker_fopen(const char *name, const char *mode);

static jmp_buf back;

static struct {
    const char *name, *bytes;
    size_t size;
} files[MAX_FILES];

/* A stack of blocks; a mark is its height. */
static void **blocks;
static size_t height, capacity;

noreturn void checker_exit(int status)
{
    longjmp(back, status + 1);
}

int checker_try(void (*run)(void *), void *argument)
{
    int status = setjmp(back);

    if (status == 0)
        run(argument);
    scratch_release((struct mark){0, 0});
    return status - 1;
}

void checker_set_file(const char *name, const char *bytes, size_t size)
{
    int i = 0;

    while (i + 1 < MAX_FILES && files[i].name && strcmp(files[i].name, name) != 0)
        i++;
    files[i].name = name;
    files[i].bytes = bytes;
    files[i].size = size;
}

FILE *checker_fopen(const char *name, const char *mode)
{
    for (int i = 0; i < MAX_FILES; i++)
        if (files[i].name && strcmp(files[i].name, name) == 0 && files[i].size > 0)
            return fmemopen((void *)(uintptr_t)files[i].bytes, files[i].size, mode);
    return NULL;
}

void *scratch_new(size_t bytes)
{
    void *out = malloc(bytes > 0 ? bytes : 1);

    if (height == capacity) {
        capacity = 2 * capacity + 1024;
        blocks = realloc(blocks, capacity * sizeof *blocks);
    }
    if (!out || !blocks)
        checker_exit(2);
    blocks[height++] = out;
    return out;
}

void *allocate(size_t count, size_t size)
{
    if (size != 0 && count > ((size_t)1 << 30) / size)
        checker_exit(2);
    return memset(scratch_new(count * size), 0, count * size);
}

struct mark scratch_mark(void)
{
    return (struct mark){0, height};
}

void scratch_release(struct mark mark)
{
    while (height > mark.used)
        free(blocks[--height]);
}
