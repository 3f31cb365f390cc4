/* tar.c: blocks of 512 bytes. */
#include "tar.h"

#include <stdio.h>
#include <string.h>

enum { BLOCK = 512 };

/* The fields of a header, by their places in it. */
enum { NAME = 0, MODE = 100, USER = 108, GROUP = 116, SIZE = 124, TIME = 136, CHECKSUM = 148, TYPE = 156, MAGIC = 257, VERSION = 263, MAJOR = 329, MINOR = 337, PREFIX = 345 };

/* Octal digits, `width` with the NUL behind them. */
static void put_octal(char *field, int width, unsigned long long value)
{
    for (int i = width - 2; i >= 0; i--, value >>= 3)
        field[i] = (char)('0' + (value & 7));
    field[width - 1] = '\0';
}

static void put_checksum(char header[BLOCK])
{
    unsigned sum = 0;
    memset(header + CHECKSUM, ' ', 8);
    for (int i = 0; i < BLOCK; i++)
        sum += (unsigned char)header[i];
    put_octal(header + CHECKSUM, 7, sum);
}

static void pad(buffer *z, size_t length)
{
    static const char zeros[BLOCK];
    if (length % BLOCK)
        buffer_append(z, zeros, BLOCK - length % BLOCK);
}

void tar_add(buffer *z, const char *directory, const char *name, const char *bytes, size_t length, bool executable)
{
    char header[BLOCK];
    memset(header, 0, sizeof header);
    snprintf(header + NAME, 100, "%s", name);
    put_octal(header + MODE, 8, executable ? 0755 : 0644);
    put_octal(header + USER, 8, 0);
    put_octal(header + GROUP, 8, 0);
    put_octal(header + SIZE, 12, length);
    put_octal(header + TIME, 12, 0);
    header[TYPE] = '0';
    memcpy(header + MAGIC, "ustar", 6);
    memcpy(header + VERSION, "00", 2);
    put_octal(header + MAJOR, 8, 0);
    put_octal(header + MINOR, 8, 0);
    snprintf(header + PREFIX, 155, "%s", directory);
    put_checksum(header);
    buffer_append(z, header, sizeof header);
    buffer_append(z, bytes, length);
    pad(z, length);
}

void tar_end(buffer *z)
{
    static const char zeros[2 * BLOCK];
    buffer_append(z, zeros, sizeof zeros);
}
