/* command_archive_verify.c: is everything there that was finished, and does every certificate prove its claim? */
#define _POSIX_C_SOURCE 200809L
#include "command_archive.h"

#include "archive.h"
#include "command.h"
#include "command_certificates.h"
#include "examine.h"
#include "json.h"
#include "sha256.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    archive_view view;
    bool json;
    examine_subject subject;
    long followed, old; /* certificates that hold, and those of an old version, which are not followed */
    long troubles;
    bool contradiction;
    int result; /* an exit status, if something could not be told */
} check;

/* What is wrong with which file of the directory. */
static void blame(check *c, const char *file, const char *what)
{
    buffer b;
    c->troubles++;
    if (!c->json) {
        printf("%s/%s: %s\n", c->view.path, file, what);
        return;
    }
    buffer_init(&b);
    buffer_print(&b, "{\"trouble\":");
    json_string(&b, what);
    json_add_string(&b, "directory", c->view.path);
    json_add_string(&b, "file", file);
    buffer_print(&b, "}");
    c->result = c->result ? c->result : print_line(&b);
}

/* What the journal calls finished is there as it was. */
static int check_journal(check *c)
{
    const journal *j = &c->view.finished;
    if (!j->tidy)
        blame(c, ARCHIVE_JOURNAL, "a line is cut off or strange (the run that wrote it was killed); the next run mends it");
    for (size_t i = 0; i < j->count; i++) {
        char *path = durable_path(c->view.path, j->line[i].name), digest[65];
        buffer bytes;
        buffer_init(&bytes);
        if (path && buffer_read_file(&bytes, path, ARCHIVE_MAX_BYTES)) {
            sha256_hex(digest, bytes.bytes ? bytes.bytes : "", bytes.length);
            if (strcmp(digest, j->line[i].digest))
                blame(c, j->line[i].name, "not what was finished (another digest in the journal)");
        } else if (errno == ENOENT) {
            blame(c, j->line[i].name, "missing, though it was finished");
        } else {
            free(path);
            buffer_clear(&bytes);
            return complain_of_file(j->line[i].name);
        }
        free(path);
        buffer_clear(&bytes);
    }
    return 0;
}

static void check_index(check *c)
{
    valence_range pair[2];
    char first[VALENCE_RANGE_TEXT], second[VALENCE_RANGE_TEXT], text[160];
    if (!c->view.is_indexed)
        blame(c, ARCHIVE_INDEX, c->view.index_text.length ? "not what is in the directory; the next run makes it anew" : "missing; the next run makes it");
    c->contradiction = archive_index_contradiction(pair, &c->view.index);
    if (!c->contradiction)
        return;
    valence_range_print(first, pair[0]);
    valence_range_print(second, pair[1]);
    snprintf(text, sizeof text, "the certificates for %s and for %s contradict each other", first, second);
    blame(c, ARCHIVE_INDEX, text);
}

/* The claim must be about the scheme of the directory and the valences of the name. */
static void judge(check *c, const examination *x, const archive_index_entry *e, const char *name)
{
    char text[400];
    if (!x->claim.scheme || (!x->readable && x->claim.version == STATEMENT_NEWEST_VERSION)) {
        snprintf(text, sizeof text, "line %ld: %s", x->line, x->reason);
        blame(c, name, text);
    } else if (!statement_is_about(&x->claim, c->view.scheme.bytes, c->view.scheme.length)) {
        blame(c, name, "about another scheme than " ARCHIVE_SCHEME);
    } else if (!valence_range_equal(x->claim.valences, e->valences)) {
        blame(c, name, "about another valence than its name says");
    } else if (!x->readable) {
        c->old++;
    } else if (x->followed != OUTCOME_TRUE) {
        const attempt *last = &x->findings.attempts[x->findings.attempt_count ? x->findings.attempt_count - 1 : 0];
        snprintf(text, sizeof text, "does not prove its claim: %s: %s", last->test ? last->test : "", last->reason);
        blame(c, name, text);
    } else {
        c->followed++;
    }
}

static int follow_all(check *c)
{
    int result = 0;
    for (size_t i = 0; result == 0 && i < c->view.index.count; i++) {
        const archive_index_entry *e = &c->view.index.entry[i];
        char name[ARCHIVE_NAME_MAX];
        char *path;
        examination x;
        if (!e->bytes && !e->damaged)
            continue;
        archive_name(name, e->valences, ARCHIVE_CERTIFICATE);
        path = durable_path(c->view.path, name);
        examination_init(&x);
        if (!path || !examine_read(&x, path))
            result = complain_of_file(name);
        else if (!examine(&x, &c->subject, NULL))
            result = complain_of_memory();
        else
            judge(c, &x, e, name);
        examination_clear(&x);
        free(path);
    }
    return result;
}

static void say_result(check *c)
{
    char name[65];
    archive_view_name(name, &c->view);
    if (c->json) {
        buffer b;
        buffer_init(&b);
        buffer_print(&b, "{\"scheme\":\"%s\",\"hold\":%ld,\"old\":%ld,\"troubles\":%ld", name, c->followed, c->old, c->troubles);
        json_add_string(&b, "directory", c->view.path);
        buffer_print(&b, "}");
        c->result = c->result ? c->result : print_line(&b);
        return;
    }
    printf("%s: %s: %ld certificates hold", c->view.path, name, c->followed);
    if (c->old)
        printf(", %ld of an old format are left to smoothcert-check", c->old);
    if (c->troubles)
        printf(", %ld troubles", c->troubles);
    printf("\n");
}

static int verify_one(const char *path, bool json)
{
    check c = {.json = json};
    int result;
    archive_view_init(&c.view);
    examine_subject_init(&c.subject);
    result = archive_view_open(&c.view, path);
    if (result < 0)
        result = check_journal(&c);
    if (result == 0) {
        check_index(&c);
        result = follow_all(&c);
    }
    if (result == 0) {
        say_result(&c);
        result = c.result ? c.result : c.contradiction ? EXIT_FAULT : c.troubles ? EXIT_BAD_INPUT : 0;
    }
    examine_subject_clear(&c.subject);
    archive_view_clear(&c.view);
    return result;
}

int archive_verify(const archive_options *o)
{
    int worst = 0;
    for (int i = 0; i < o->count; i++) {
        int result = verify_one(o->directory[i], o->json);
        worst = result > worst ? result : worst;
    }
    return worst;
}
