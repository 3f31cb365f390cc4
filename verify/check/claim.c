/* The valences that are claimed, and which certificates are to prove the claim. */

#include "claim.h"

#include "answer.h"
#include "check.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MIN_VALENCE = 3, MAX_VALENCE = 1000000000 };

const char *span_text(struct span s)
{
    enum { SIZE = 64 };
    char *out = allocate(SIZE, 1);

    if (s.first == s.last)
        snprintf(out, SIZE, "%lld", (long long)s.first);
    else if (s.last == ENDLESS)
        snprintf(out, SIZE, "%lld..inf", (long long)s.first);
    else
        snprintf(out, SIZE, "%lld..%lld", (long long)s.first, (long long)s.last);
    return out;
}

/* A number without leading zeros from 3 to 10^9 at *text, which moves behind it. */
static int64_t read_valence(const char **text)
{
    int64_t k = 0;

    for (; **text >= '0' && **text <= '9' && k <= MAX_VALENCE; (*text)++) {
        if (k == 0 && **text == '0')
            break;
        k = 10 * k + (**text - '0');
    }
    if (k < MIN_VALENCE || k > MAX_VALENCE)
        cannot_check("--valence: expected numbers in 3..1000000000, such as 3..7,20");
    return k;
}

static struct span read_span(const char **text)
{
    struct span out = span_of(read_valence(text));

    if (strncmp(*text, "..", 2) != 0)
        return out;
    *text += 2;
    if (strncmp(*text, "inf", 3) == 0) {
        *text += 3;
        out.last = ENDLESS;
    } else {
        out.last = read_valence(text);
    }
    if (out.last < out.first)
        cannot_check("--valence: expected ranges such as 3..7");
    return out;
}

static int by_first(const void *a, const void *b)
{
    int64_t x = ((const struct span *)a)->first, y = ((const struct span *)b)->first;

    return (x > y) - (x < y);
}

/* Joins what overlaps or follows at once. */
static void normalize(struct claim *c)
{
    int count = 0;

    qsort(c->span, (size_t)c->count, sizeof c->span[0], by_first);
    for (int i = 0; i < c->count; i++) {
        struct span *last = count > 0 ? &c->span[count - 1] : NULL;

        if (last == NULL || (last->last != ENDLESS && c->span[i].first > last->last + 1))
            c->span[count++] = c->span[i];
        else if (c->span[i].last > last->last)
            last->last = c->span[i].last;
    }
    c->count = count;
}

void claim_read(struct claim *out, const char *text)
{
    out->count = 0;
    if (strcmp(text, "all") == 0)
        text = "3..inf";
    for (;;) {
        if (out->count == MAX_SPANS)
            cannot_check("--valence: expected at most %d ranges", MAX_SPANS);
        out->span[out->count++] = read_span(&text);
        if (*text == '\0')
            break;
        if (*text++ != ',')
            cannot_check("--valence: expected numbers and ranges, such as 3..7,20");
    }
    normalize(out);
}

/* Folders
 * ------- */

static void append(struct folder *l, struct proof_file e)
{
    if (l->count == l->room) {
        struct proof_file *more = allocate(2 * (size_t)l->room + 64, sizeof more[0]);

        if (l->count > 0)
            memcpy(more, l->file, (size_t)l->count * sizeof more[0]);
        l->file = more;
        l->room = 2 * l->room + 64;
    }
    l->file[l->count++] = e;
}

static bool is_certificate(const char *name)
{
    const char *suffix = ".cert";
    size_t size = strlen(name);

    return size > strlen(suffix) && strcmp(name + size - strlen(suffix), suffix) == 0;
}

/* Adds the certificate if it is about something of the claim. */
static void consider(struct folder *l, const char *folder, const char *file,
                     const struct claim *claim)
{
    size_t size = strlen(folder) + strlen(file) + 2;
    char *name = allocate(size, 1);
    struct proof_file e = { name, NOTHING };

    snprintf(name, size, "%s/%s", folder, file);
    e.k = check_valences(name);
    for (int i = 0; i < claim->count; i++) {
        struct span s = claim->span[i];

        if (e.k.last < s.first || s.last < e.k.first)
            continue;
        if (e.k.first < s.first || s.last < e.k.last)
            rejected(NULL, 0, "%s is about the valences %s, of which only a part is claimed",
                     name, span_text(e.k));
        append(l, e);
    }
}

static int by_valence(const void *a, const void *b)
{
    const struct proof_file *x = a, *y = b;

    return x->k.first != y->k.first ? (x->k.first > y->k.first) - (x->k.first < y->k.first)
                                    : strcmp(x->name, y->name);
}

static noreturn void missing(const char *folder, int64_t first, int64_t last)
{
    rejected(NULL, 0, "no certificate in %s is about %s %s", folder,
             first == last ? "valence" : "the valences",
             span_text((struct span) { first, last }));
}

/* Are the entries from e on, which are in order, all of s?  Returns the first behind. */
static const struct proof_file *cover_span(const struct proof_file *e,
                                           const struct proof_file *end, struct span s,
                                           const char *folder)
{
    int64_t next = s.first;
    bool done = false;

    for (; e < end && e->k.first <= s.last; e++) {
        if (done || e->k.first < next)
            rejected(NULL, 0, "both %s and %s are about valence %lld", e[-1].name, e->name,
                     (long long)e->k.first);
        if (e->k.first > next)
            missing(folder, next, e->k.first - 1);
        done = e->k.last == s.last;
        next = done ? next : e->k.last + 1;
    }
    if (!done)
        missing(folder, next, s.last);
    return e;
}

static void list_folder(struct folder *out, DIR *directory, const char *name,
                        const struct claim *claim)
{
    const struct proof_file *next;

    for (struct dirent *file; (file = readdir(directory)) != NULL; )
        if (is_certificate(file->d_name))
            consider(out, name, file->d_name, claim);
    if (out->count > 0)
        qsort(out->file, (size_t)out->count, sizeof out->file[0], by_valence);
    next = out->file;
    for (int i = 0; i < claim->count; i++)
        next = cover_span(next, out->file + out->count, claim->span[i], name);
}

void folder_partition(struct folder *out, const char *name, const struct claim *claim)
{
    DIR *directory = opendir(name);

    *out = (struct folder) { 0, 0, NULL };
    if (directory != NULL) {
        list_folder(out, directory, name, claim);
        closedir(directory);
        return;
    }
    if (claim->count > 1)
        cannot_check("--valence: one certificate is about one valence or one range");
    append(out, (struct proof_file) { name, claim->span[0] });
}
