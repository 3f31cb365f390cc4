/* command_archive_pack.c: an archive as one file. */
#define _POSIX_C_SOURCE 200809L
#include "command_archive.h"

#include "archive.h"
#include "archive_run.h"
#include "command.h"
#include "command_certificates.h"
#include "tar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    buffer tar;
    char name[80]; /* of the directory in it */
    const archive_view *view;
} packing;

static bool add_text(packing *p, const char *name, const buffer *text)
{
    if (text->length)
        tar_add(&p->tar, p->name, name, text->bytes, text->length, false);
    return true;
}

/* A file that may be missing.  false: errno says why. */
static bool add_file(packing *p, const char *name)
{
    char *path = durable_path(p->view->path, name);
    buffer bytes;
    bool ok;
    buffer_init(&bytes);
    ok = path && (buffer_read_file(&bytes, path, ARCHIVE_MAX_BYTES) || errno == ENOENT);
    if (ok)
        add_text(p, name, &bytes);
    buffer_clear(&bytes);
    free(path);
    return ok;
}

/* In the order of the index. */
static bool add_evidence(packing *p, bool logs)
{
    bool ok = true;
    for (size_t i = 0; ok && i < p->view->index.count; i++) {
        char name[ARCHIVE_NAME_MAX];
        archive_name(name, p->view->index.entry[i].valences, ARCHIVE_CERTIFICATE);
        ok = add_file(p, name);
        archive_name(name, p->view->index.entry[i].valences, ARCHIVE_LOG);
        ok = ok && (!logs || add_file(p, name));
    }
    return ok;
}

static bool fill(packing *p, bool logs)
{
    bool ok;
    tar_add(&p->tar, p->name, ARCHIVE_VERIFY, archive_verify_script, strlen(archive_verify_script), true);
    ok = add_text(p, ARCHIVE_SCHEME, &p->view->scheme) && add_text(p, ARCHIVE_INDEX, &p->view->index_text);
    if (ok && logs)
        ok = add_text(p, ARCHIVE_RUNS, &p->view->runs) && add_file(p, ARCHIVE_JOURNAL);
    ok = ok && add_evidence(p, logs);
    tar_end(&p->tar);
    return ok;
}

/* Packing is no way to hide that something is damaged. */
static int check(const archive_view *v)
{
    for (size_t i = 0; i < v->index.count; i++)
        if (v->index.entry[i].damaged)
            return complain(EXIT_BAD_INPUT, "%s: a certificate is damaged; 'smoothcert archive verify' says which", v->path);
    if (!v->is_indexed)
        return complain(EXIT_BAD_INPUT, "%s: the index is not up to date; the command that made the directory mends it", v->path);
    return -1;
}

static int write_out(const buffer *tar, const char *out)
{
    const char *slash = out ? strrchr(out, '/') : NULL;
    char *directory;
    bool ok;
    if (!out) {
        if (isatty(STDOUT_FILENO))
            return complain(EXIT_USAGE, "archive pack: standard output is a terminal; name a file with --out, or use a pipe");
        fwrite(tar->bytes, 1, tar->length, stdout);
        return 0;
    }
    directory = malloc(strlen(out) + 2);
    if (!directory)
        return complain_of_memory();
    strcpy(directory, slash == out ? "/" : slash ? out : ".");
    if (slash && slash != out)
        directory[slash - out] = '\0';
    ok = durable_store(directory, slash ? slash + 1 : out, tar->bytes, tar->length, 0666);
    free(directory);
    return ok ? 0 : complain_of_file(out);
}

int archive_pack(const archive_options *o)
{
    archive_view v;
    packing p = {.view = &v};
    char name[65];
    int result;
    archive_view_init(&v);
    buffer_init(&p.tar);
    result = archive_view_open(&v, o->directory[0]);
    if (result < 0)
        result = check(&v);
    if (result < 0) {
        archive_view_name(name, &v);
        snprintf(p.name, sizeof p.name, "smoothcert-%s", name);
        if (!fill(&p, !o->without_logs))
            result = complain_of_file(v.path);
        else
            result = p.tar.failed ? complain_of_memory() : write_out(&p.tar, o->out);
    }
    buffer_clear(&p.tar);
    archive_view_clear(&v);
    return result;
}
