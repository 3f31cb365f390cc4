/* archive_index.c: the list of what is in the directory, made from what is in the directory. */
#define _POSIX_C_SOURCE 200809L
#include "archive_internal.h"

#include "sha256.h"

#include "../lib/growing.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    long valence;
    bool decided; /* there is a certificate */
} entry;

typedef struct {
    entry *entries;
    size_t count, capacity;
} listing;

/* The valence of "valence-K.SUFFIX", 0 if the name is another. */
static long valence_of(const char *name, const char *suffix)
{
    static const char head[] = "valence-";
    const char *p = name + sizeof head - 1;
    long valence = 0;
    if (strncmp(name, head, sizeof head - 1) || *p < '1' || *p > '9')
        return 0;
    for (; *p >= '0' && *p <= '9' && valence <= CHOICES_MAX_VALENCE; p++)
        valence = 10 * valence + (*p - '0');
    return strcmp(p, suffix) ? 0 : valence;
}

static bool add(listing *z, entry e)
{
    entry *p = growing_room(z->entries, z->count, &z->capacity, sizeof *p);
    if (!p)
        return false;
    z->entries = p;
    z->entries[z->count++] = e;
    return true;
}

/* Certificates first among those of one valence. */
static int by_valence(const void *x, const void *y)
{
    const entry *a = x, *b = y;
    return a->valence != b->valence ? (a->valence > b->valence) - (a->valence < b->valence) : b->decided - a->decided;
}

static bool list_directory(listing *z, const char *path)
{
    DIR *d = opendir(path);
    bool ok = d != NULL;
    for (struct dirent *f; ok && (errno = 0, f = readdir(d)) != NULL;) {
        entry e = {valence_of(f->d_name, ".cert"), true};
        if (!e.valence)
            e = (entry){valence_of(f->d_name, ".log"), false};
        if (e.valence)
            ok = add(z, e);
    }
    ok = ok && errno == 0;
    if (d)
        closedir(d);
    return ok;
}

static bool print_entry(buffer *text, const archive *z, const entry *e)
{
    buffer certificate;
    char digest[65];
    if (!e->decided) {
        buffer_print(text, "%ld undecided\n", e->valence);
        return true;
    }
    buffer_init(&certificate);
    archive_read(z, &certificate, e->valence);
    if (certificate.length == 0)
        return false;
    sha256_hex(digest, certificate.bytes, certificate.length);
    buffer_print(text, "%ld %s %s valence-%ld.cert\n", e->valence, strstr(certificate.bytes, "\nclaim c1\n") ? "proved" : "refuted", digest, e->valence);
    buffer_clear(&certificate);
    return true;
}

archive_status archive_write_index(const archive *z)
{
    listing l = {NULL, 0, 0};
    buffer text;
    bool ok;
    if (!z->path)
        return ARCHIVE_OK;
    buffer_init(&text);
    ok = list_directory(&l, z->path);
    qsort(l.entries, l.count, sizeof *l.entries, by_valence);
    for (size_t i = 0; ok && i < l.count; i++)
        if (i == 0 || l.entries[i].valence != l.entries[i - 1].valence)
            ok = print_entry(&text, z, &l.entries[i]);
    if (text.failed) {
        ok = false;
        errno = ENOMEM;
    }
    ok = ok && archive_store(z, "index", text.bytes ? text.bytes : "", text.length);
    free(l.entries);
    buffer_clear(&text);
    return ok ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
}
