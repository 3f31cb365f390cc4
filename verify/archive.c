/* archive.c: what is there of earlier runs, and what this one adds. */
#define _POSIX_C_SOURCE 200809L
#include "archive.h"

#include "prove_output.h"
#include "sha256.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MAX_JOURNAL_BYTES (1 << 30)

void archive_name(char name[ARCHIVE_NAME_MAX], valence_range k, const char *suffix)
{
    char valences[VALENCE_RANGE_TEXT];
    valence_range_print(valences, k);
    snprintf(name, ARCHIVE_NAME_MAX, "valence-%s%s", valences, suffix);
}

static valence_range valences_of(const decision *d)
{
    return d->k;
}

/* Is this what was finished under that name? */
static archive_earlier compare_with_journal(const archive *z, const char *name, const buffer *bytes)
{
    const char *finished = journal_find(&z->finished, name);
    char digest[65];
    if (!finished)
        return EARLIER_UNFINISHED;
    sha256_hex(digest, bytes->bytes, bytes->length);
    return strcmp(digest, finished) ? EARLIER_DAMAGED : EARLIER_FINISHED;
}

/* The file, if it is not damaged. */
static archive_earlier read_file(const archive *z, buffer *bytes, const char *name)
{
    archive_earlier result;
    char *path = durable_path(z->path, name);
    if (path && buffer_read_file(bytes, path, ARCHIVE_MAX_BYTES) && bytes->length)
        result = compare_with_journal(z, name, bytes);
    else
        result = journal_find(&z->finished, name) ? EARLIER_DAMAGED : EARLIER_NONE;
    free(path);
    if (result == EARLIER_NONE || result == EARLIER_DAMAGED)
        buffer_clear(bytes);
    return result;
}

archive_earlier archive_read(const archive *z, buffer *certificate, valence_range k)
{
    char name[ARCHIVE_NAME_MAX];
    if (!z->path)
        return EARLIER_NONE;
    archive_name(name, k, ARCHIVE_CERTIFICATE);
    return read_file(z, certificate, name);
}

bool archive_read_journal(journal *z, const char *path)
{
    char *file = durable_path(path, ARCHIVE_JOURNAL);
    buffer text;
    bool ok;
    buffer_init(&text);
    ok = file && (buffer_read_file(&text, file, MAX_JOURNAL_BYTES) || errno == ENOENT);
    if (ok && !journal_read(z, text.bytes ? text.bytes : "", text.length)) {
        errno = ENOMEM;
        ok = false;
    }
    free(file);
    buffer_clear(&text);
    return ok;
}

/* ---- writing ---- */

static bool keep_file(archive *z, const char *name, const buffer *bytes)
{
    if (bytes->failed) {
        errno = ENOMEM;
        return false;
    }
    journal_print(&z->lines, name, bytes->bytes ? bytes->bytes : "", bytes->length);
    return durable_group_add(&z->group, name, bytes->bytes ? bytes->bytes : "", bytes->length, 0666);
}

static bool keep_log(archive *z, const decision *d)
{
    char name[ARCHIVE_NAME_MAX];
    buffer text;
    bool ok;
    buffer_init(&text);
    prove_write_log(&text, d);
    archive_name(name, valences_of(d), ARCHIVE_LOG);
    ok = keep_file(z, name, &text);
    buffer_clear(&text);
    return ok;
}

static bool keep_certificate(archive *z, const decision *d)
{
    char name[ARCHIVE_NAME_MAX];
    archive_name(name, valences_of(d), ARCHIVE_CERTIFICATE);
    return keep_file(z, name, &d->certificate);
}

static bool has_log(const archive *z, const decision *d)
{
    char name[ARCHIVE_NAME_MAX];
    buffer log;
    archive_earlier earlier;
    buffer_init(&log);
    archive_name(name, valences_of(d), ARCHIVE_LOG);
    earlier = read_file(z, &log, name);
    buffer_clear(&log);
    return earlier == EARLIER_FINISHED;
}

archive_status archive_keep(archive *z, char **certificate, const decision *d, archive_earlier earlier)
{
    bool ok = true;
    *certificate = NULL;
    if (!z->path)
        return ARCHIVE_OK;
    if (d->verdict == VERDICT_UNDECIDED && (earlier == EARLIER_FINISHED || earlier == EARLIER_UNFINISHED))
        return ARCHIVE_OK; /* what was proved once stays, and the log that belongs to it */
    if (!d->kept_before || !has_log(z, d))
        ok = keep_log(z, d);
    if (ok && d->verdict != VERDICT_UNDECIDED) {
        char name[ARCHIVE_NAME_MAX];
        archive_name(name, valences_of(d), ARCHIVE_CERTIFICATE);
        *certificate = durable_path(z->path, name);
        ok = *certificate && ((d->kept_before && earlier == EARLIER_FINISHED) || keep_certificate(z, d));
    }
    return ok ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
}

archive_status archive_commit(archive *z)
{
    bool ok = true;
    if (!z->path)
        return ARCHIVE_OK;
    if (z->lines.failed) {
        errno = ENOMEM;
        ok = false;
    }
    ok = ok && durable_group_commit(&z->group);
    if (ok && z->lines.length)
        ok = durable_append(z->journal_fd, z->lines.bytes, z->lines.length);
    buffer_clear(&z->lines);
    return ok ? ARCHIVE_OK : ARCHIVE_IO_ERROR;
}

/* ---- out of the way ---- */

static bool is_there(const char *directory, const char *name)
{
    char *path = durable_path(directory, name);
    bool there = !path || access(path, F_OK) == 0;
    free(path);
    return there;
}

/* Nothing that was moved before is lost.  Whoever is here has the lock: a name that is free stays so. */
static bool set_aside(archive *z, char aside[ARCHIVE_ASIDE_MAX], const char *name)
{
    snprintf(aside, ARCHIVE_ASIDE_MAX, "%s" ARCHIVE_ASIDE, name);
    for (int i = 2; i < 1000 && is_there(z->path, aside); i++)
        snprintf(aside, ARCHIVE_ASIDE_MAX, "%s" ARCHIVE_ASIDE "-%d", name, i);
    if (is_there(z->path, aside)) {
        errno = EEXIST;
        return false;
    }
    if (!durable_rename(z->path, name, aside))
        return false;
    journal_print_withdrawn(&z->lines, name);
    return true;
}

/* The log first: after a crash in between, the next run finds the certificate, and goes on with it. */
archive_status archive_set_aside(archive *z, char name[ARCHIVE_ASIDE_MAX], valence_range k)
{
    char file[ARCHIVE_NAME_MAX];
    bool ok;
    archive_name(file, k, ARCHIVE_LOG);
    ok = set_aside(z, name, file) || errno == ENOENT;
    archive_name(file, k, ARCHIVE_CERTIFICATE);
    return ok && set_aside(z, name, file) ? archive_commit(z) : ARCHIVE_IO_ERROR;
}
