/* buffer.h: text that grows.  A failed allocation is remembered and reported once, at the end. */
#ifndef VERIFY_BUFFER_H
#define VERIFY_BUFFER_H

#include "../bigfloat/integer.h"

typedef struct {
    char *bytes; /* `length` of them, then NUL; NULL while empty */
    size_t length, capacity;
    bool failed;
} buffer;

void buffer_init(buffer *z);
void buffer_clear(buffer *z);
void buffer_append(buffer *z, const char *bytes, size_t length);
void buffer_print(buffer *z, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
void buffer_hexadecimal(buffer *z, const integer *x); /* as certificates write integers */

/* The whole content of a file.  false: errno says why (EFBIG: more than `limit` bytes). */
bool buffer_read_file(buffer *z, const char *path, size_t limit);

/* How many lines end in these bytes. */
long text_lines(const char *bytes, size_t length);

#endif
