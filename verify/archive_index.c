/* archive_index.c: the list of what is in the directory. */
#define _POSIX_C_SOURCE 200809L
#include "archive_index.h"

#include "archive.h"
#include "sha256.h"
#include "statement.h"

#include "../lib/growing.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

void archive_index_init(archive_index *z)
{
    memset(z, 0, sizeof *z);
}

void archive_index_clear(archive_index *z)
{
    free(z->entry);
    archive_index_init(z);
}

/* Is it "valence-K" and the suffix? */
static bool read_name(valence_range *k, const char *name, const char *suffix)
{
    const char *rest;
    if (strncmp(name, "valence-", 8))
        return false;
    rest = valence_range_read(k, name + 8);
    return rest && !strcmp(rest, suffix);
}

static bool add(archive_index *z, valence_range k, bool certificate)
{
    archive_index_entry *room = growing_room(z->entry, z->count, &z->capacity, sizeof *room);
    if (!room) {
        errno = ENOMEM;
        return false;
    }
    z->entry = room;
    memset(&room[z->count], 0, sizeof *room);
    room[z->count].valences = k;
    room[z->count].verdict = certificate ? VERDICT_PROVED : VERDICT_UNDECIDED; /* of the former, not known yet */
    z->count++;
    return true;
}

static bool list_directory(archive_index *z, const char *path)
{
    DIR *d = opendir(path);
    bool ok = d != NULL;
    for (struct dirent *f; ok && (errno = 0, f = readdir(d)) != NULL;) {
        valence_range k;
        if (read_name(&k, f->d_name, ARCHIVE_CERTIFICATE))
            ok = add(z, k, true);
        else if (read_name(&k, f->d_name, ARCHIVE_LOG))
            ok = add(z, k, false);
    }
    ok = ok && errno == 0;
    if (d) {
        int saved = errno;
        closedir(d);
        errno = saved;
    }
    return ok;
}

/* By the first valence, longer ranges before shorter ones, certificates before logs. */
static int by_valences(const void *x, const void *y)
{
    const archive_index_entry *a = x, *b = y;
    if (a->valences.first != b->valences.first)
        return a->valences.first < b->valences.first ? -1 : 1;
    if (a->valences.last != b->valences.last)
        return a->valences.last > b->valences.last ? -1 : 1;
    return (int)a->verdict - (int)b->verdict;
}

/* One entry for each, whether there is a certificate, a log or both. */
static void merge(archive_index *z)
{
    size_t kept = 0;
    if (z->count)
        qsort(z->entry, z->count, sizeof *z->entry, by_valences);
    for (size_t i = 0; i < z->count; i++)
        if (kept == 0 || !valence_range_equal(z->entry[i].valences, z->entry[kept - 1].valences))
            z->entry[kept++] = z->entry[i];
    z->count = kept;
}

/* What the certificate claims; what cannot be read, or is not what was finished, claims nothing. */
static bool read_certificate(archive_index_entry *e, const char *path, const journal *finished)
{
    char name[ARCHIVE_NAME_MAX];
    char *file;
    const char *expected;
    statement claim;
    long line;
    buffer bytes;
    bool ok;
    archive_name(name, e->valences, ARCHIVE_CERTIFICATE);
    file = durable_path(path, name);
    buffer_init(&bytes);
    ok = file && buffer_read_file(&bytes, file, ARCHIVE_MAX_BYTES);
    free(file);
    if (!ok) {
        buffer_clear(&bytes);
        return false;
    }
    expected = journal_find(finished, name);
    sha256_hex(e->digest, bytes.bytes ? bytes.bytes : "", bytes.length);
    e->bytes = bytes.length;
    e->damaged = statement_read(&claim, &line, bytes.bytes ? bytes.bytes : "", bytes.length) || !valence_range_equal(claim.valences, e->valences) ||
                 (expected && strcmp(expected, e->digest));
    e->version = claim.version;
    e->grid = claim.grid;
    e->verdict = e->damaged ? VERDICT_UNDECIDED : claim.c1 ? VERDICT_PROVED : VERDICT_REFUTED;
    buffer_clear(&bytes);
    return true;
}

/* What is decided as part of a longer range, which comes before it, is not undecided. */
static void mark_reach(archive_index *z)
{
    long reach = 0;
    for (size_t i = 0; i < z->count; i++) {
        archive_index_entry *e = &z->entry[i];
        if (e->verdict != VERDICT_UNDECIDED && e->valences.last > reach)
            reach = e->valences.last;
        e->reach = reach;
        e->covered = e->verdict == VERDICT_UNDECIDED && !e->damaged && e->valences.last <= reach;
    }
}

bool archive_index_make(archive_index *z, const char *path, const journal *finished)
{
    bool ok = list_directory(z, path);
    merge(z);
    for (size_t i = 0; ok && i < z->count; i++)
        if (z->entry[i].verdict != VERDICT_UNDECIDED)
            ok = read_certificate(&z->entry[i], path, finished);
    for (size_t i = 0; ok && i < z->count; i++)
        z->damaged += z->entry[i].damaged;
    if (ok)
        mark_reach(z);
    return ok;
}

/* How many entries begin at k or before. */
static size_t count_up_to(const archive_index *z, long k)
{
    size_t from = 0, to = z->count;
    while (from < to) {
        size_t i = from + (to - from) / 2;
        if (z->entry[i].valences.first <= k)
            from = i + 1;
        else
            to = i;
    }
    return from;
}

const archive_index_entry *archive_index_next(const archive_index *z, valence_range k, const archive_index_entry *after)
{
    size_t i = after ? (size_t)(after - z->entry) : count_up_to(z, k.last);
    while (i-- > 0 && z->entry[i].reach >= k.first)
        if (z->entry[i].verdict != VERDICT_UNDECIDED && valence_range_overlap(z->entry[i].valences, k))
            return &z->entry[i];
    return NULL;
}

archive_index_entry *archive_index_damaged(const archive_index *z, valence_range k)
{
    for (size_t i = 0; z->damaged && i < z->count && z->entry[i].valences.first <= k.last; i++)
        if (z->entry[i].damaged && valence_range_overlap(z->entry[i].valences, k) && !valence_range_equal(z->entry[i].valences, k))
            return &z->entry[i];
    return NULL;
}

void archive_index_print(buffer *text, const archive_index *z)
{
    for (size_t i = 0; i < z->count; i++) {
        const archive_index_entry *e = &z->entry[i];
        char valences[VALENCE_RANGE_TEXT], name[ARCHIVE_NAME_MAX];
        if (e->covered)
            continue;
        valence_range_print(valences, e->valences);
        archive_name(name, e->valences, ARCHIVE_CERTIFICATE);
        if (e->verdict == VERDICT_UNDECIDED)
            buffer_print(text, "%s undecided\n", valences);
        else
            buffer_print(text, "%s %s %s %s\n", valences, verdict_name(e->verdict), e->digest, name);
    }
}

/* The entries are sorted by their first valence: it is enough to compare each with the one before it of the other verdict that
   reaches farthest. */
bool archive_index_contradiction(valence_range pair[2], const archive_index *z)
{
    const archive_index_entry *farthest[VERDICT_UNDECIDED] = {NULL, NULL};
    for (size_t i = 0; i < z->count; i++) {
        const archive_index_entry *e = &z->entry[i], *other;
        if (e->verdict == VERDICT_UNDECIDED)
            continue;
        other = farthest[e->verdict == VERDICT_PROVED ? VERDICT_REFUTED : VERDICT_PROVED];
        if (other && valence_range_overlap(other->valences, e->valences)) {
            pair[0] = other->valences;
            pair[1] = e->valences;
            return true;
        }
        if (!farthest[e->verdict] || farthest[e->verdict]->valences.last < e->valences.last)
            farthest[e->verdict] = e;
    }
    return false;
}

archive_status archive_write_index(const archive *z, valence_range contradiction[2])
{
    archive_index index;
    journal now;
    buffer text;
    archive_status result = ARCHIVE_IO_ERROR;
    if (!z->path)
        return ARCHIVE_OK;
    archive_index_init(&index);
    journal_init(&now);
    buffer_init(&text);
    if (archive_read_journal(&now, z->path) && archive_index_make(&index, z->path, &now)) {
        archive_index_print(&text, &index);
        if (text.failed)
            errno = ENOMEM;
        else if (archive_index_contradiction(contradiction, &index))
            result = ARCHIVE_CONTRADICTION;
        else if (durable_store(z->path, ARCHIVE_INDEX, text.bytes ? text.bytes : "", text.length, 0666))
            result = ARCHIVE_OK;
    }
    archive_index_clear(&index);
    journal_clear(&now);
    buffer_clear(&text);
    return result;
}
