/* The stack of all memory: chunks, each filled from its beginning.  Chunks above
 * the top are kept for later use. */

#include "scratch.h"

#include "answer.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_CHUNKS = 4096, ALIGNMENT = 16 };

static const size_t CHUNK_BYTES = 1 << 18;
static const size_t MAX_BYTES = (size_t)1 << 30;   /* of one allocation */

static struct {
    unsigned char *bytes;
    size_t size;
} chunk[MAX_CHUNKS];

static struct mark stack_top;

static void make_chunk(int i, size_t bytes)
{
    if (i == MAX_CHUNKS)
        cannot_check("the checker needs too much memory");
    if (chunk[i].size >= bytes)
        return;
    free(chunk[i].bytes);
    chunk[i].size = bytes > CHUNK_BYTES ? bytes : CHUNK_BYTES;
    chunk[i].bytes = malloc(chunk[i].size);
    if (chunk[i].bytes == NULL)
        cannot_check("there is not enough memory");
}

void *scratch_new(size_t bytes)
{
    if (bytes > MAX_BYTES)
        cannot_check("the checker needs too much memory");
    bytes = (bytes + ALIGNMENT) / ALIGNMENT * ALIGNMENT;
    if (chunk[0].bytes == NULL)
        make_chunk(0, CHUNK_BYTES);
    if (bytes > chunk[stack_top.chunk].size - stack_top.used) {
        make_chunk(stack_top.chunk + 1, bytes);
        stack_top.chunk++;
        stack_top.used = 0;
    }
    stack_top.used += bytes;
    return chunk[stack_top.chunk].bytes + (stack_top.used - bytes);
}

void *allocate(size_t count, size_t size)
{
    if (size != 0 && count > MAX_BYTES / size)
        cannot_check("the checker needs too much memory");
    return memset(scratch_new(count * size), 0, count * size);
}

struct mark scratch_mark(void)
{
    return stack_top;
}

void scratch_release(struct mark mark)
{
    for (int i = mark.chunk; i <= stack_top.chunk; i++) {
        size_t from = i == mark.chunk ? mark.used : 0;
        size_t to = i == stack_top.chunk ? stack_top.used : chunk[i].size;

        if (to > from)
            memset(chunk[i].bytes + from, 0xff, to - from);
    }
    stack_top = mark;
}
