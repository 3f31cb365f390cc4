/* buffer.c: text that grows. */
#include "buffer.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void buffer_init(buffer *z)
{
    memset(z, 0, sizeof *z);
}

void buffer_clear(buffer *z)
{
    free(z->bytes);
    buffer_init(z);
}

static bool reserve(buffer *z, size_t more)
{
    size_t capacity = z->capacity ? z->capacity : 1024;
    char *p;
    if (z->failed)
        return false;
    while (capacity - z->length <= more) {
        if (capacity > SIZE_MAX / 2)
            return !(z->failed = true);
        capacity *= 2;
    }
    if (capacity == z->capacity)
        return true;
    p = realloc(z->bytes, capacity);
    if (!p)
        return !(z->failed = true);
    z->bytes = p;
    z->capacity = capacity;
    return true;
}

void buffer_append(buffer *z, const char *bytes, size_t length)
{
    if (!reserve(z, length))
        return;
    memcpy(z->bytes + z->length, bytes, length);
    z->length += length;
    z->bytes[z->length] = '\0';
}

void buffer_print(buffer *z, const char *format, ...)
{
    va_list arguments;
    int length;
    va_start(arguments, format);
    length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (length < 0 || !reserve(z, (size_t)length)) {
        z->failed = true;
        return;
    }
    va_start(arguments, format);
    vsnprintf(z->bytes + z->length, (size_t)length + 1, format, arguments);
    va_end(arguments);
    z->length += (size_t)length;
}

void buffer_hexadecimal(buffer *z, const integer *x)
{
    char *digits = integer_get_str(x, 16);
    if (digits)
        buffer_append(z, digits, strlen(digits));
    else
        z->failed = true;
    free(digits);
}

bool buffer_read_file(buffer *z, const char *path, size_t limit)
{
    char chunk[4096];
    size_t n;
    bool ok;
    FILE *f = fopen(path, "rb");
    if (!f)
        return false;
    errno = 0;
    while (z->length <= limit && (n = fread(chunk, 1, sizeof chunk, f)) > 0)
        buffer_append(z, chunk, n);
    ok = !ferror(f);
    if (ok && z->failed) {
        errno = ENOMEM;
        ok = false;
    } else if (ok && z->length > limit) {
        errno = EFBIG;
        ok = false;
    } else if (!ok && errno == 0) {
        errno = EIO;
    }
    n = (size_t)errno;
    fclose(f);
    errno = (int)n;
    return ok;
}

long text_lines(const char *bytes, size_t length)
{
    long lines = 0;
    for (size_t i = 0; i < length; i++)
        lines += bytes[i] == '\n';
    return lines;
}
