/* journal.c: lines of digests and names. */
#include "journal.h"

#include "sha256.h"

#include "../lib/growing.h"

#include <stdlib.h>
#include <string.h>

void journal_init(journal *z)
{
    memset(z, 0, sizeof *z);
    z->tidy = true;
}

void journal_clear(journal *z)
{
    free(z->line);
    journal_init(z);
}

/* Is it "DIGEST  NAME"? */
static bool read_line(journal_line *z, const char *text, size_t length)
{
    size_t digits = sizeof z->digest - 1, name = length - digits - 2;
    if (length < digits + 3 || name > JOURNAL_NAME_MAX || memcmp(text + digits, "  ", 2))
        return false;
    for (size_t i = 0; i < digits; i++)
        if (!memchr("0123456789abcdef", text[i], 16))
            return false;
    for (size_t i = digits + 2; i < length; i++)
        if (text[i] <= ' ' || text[i] > '~' || text[i] == '/')
            return false;
    memcpy(z->digest, text, digits);
    z->digest[digits] = '\0';
    memcpy(z->name, text + digits + 2, name);
    z->name[name] = '\0';
    return true;
}

static int by_name(const void *x, const void *y)
{
    const journal_line *a = x, *b = y;
    int order = strcmp(a->name, b->name);
    return order ? order : (a->order > b->order) - (a->order < b->order);
}

static const char withdrawn[] = "0000000000000000000000000000000000000000000000000000000000000000";

/* Keeps the last line of each name, unless it withdraws the file. */
static void keep_last(journal *z)
{
    size_t kept = 0;
    if (z->count)
        qsort(z->line, z->count, sizeof *z->line, by_name);
    for (size_t i = 0; i < z->count; i++)
        if ((i + 1 == z->count || strcmp(z->line[i].name, z->line[i + 1].name)) && strcmp(z->line[i].digest, withdrawn))
            z->line[kept++] = z->line[i];
    z->count = kept;
}

bool journal_read(journal *z, const char *bytes, size_t length)
{
    const char *p = bytes, *end = bytes + length;
    while (p < end) {
        const char *stop = memchr(p, '\n', (size_t)(end - p));
        journal_line *room = growing_room(z->line, z->count, &z->capacity, sizeof *room);
        if (!room)
            return false;
        z->line = room;
        if (!stop || !read_line(&z->line[z->count], p, (size_t)(stop - p))) {
            z->tidy = false;
        } else {
            z->line[z->count].order = z->count;
            z->count++;
        }
        p = stop ? stop + 1 : end;
    }
    keep_last(z);
    return true;
}

static int find_name(const void *key, const void *member)
{
    return strcmp(key, ((const journal_line *)member)->name);
}

const char *journal_find(const journal *z, const char *name)
{
    const journal_line *found = z->count ? bsearch(name, z->line, z->count, sizeof *z->line, find_name) : NULL;
    return found ? found->digest : NULL;
}

void journal_print_withdrawn(buffer *text, const char *name)
{
    buffer_print(text, "%s  %s\n", withdrawn, name);
}

void journal_print(buffer *text, const char *name, const char *bytes, size_t length)
{
    char digest[65];
    sha256_hex(digest, bytes, length);
    buffer_print(text, "%s  %s\n", digest, name);
}
