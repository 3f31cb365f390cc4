/* command_archive_diff.c: two archives side by side. */
#include "command_archive.h"

#include "command.h"
#include "command_certificates.h"

#include "../bigfloat/truth.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    long same, different, first, second; /* valences or ranges: the same bytes, others, only in one of them */
} difference;

static void describe(char *text, size_t size, const archive_index_entry *e)
{
    if (!e)
        snprintf(text, size, "nothing");
    else if (e->verdict == VERDICT_UNDECIDED)
        snprintf(text, size, "undecided");
    else
        snprintf(text, size, "%s (format %d, grid 2^-%ld)", verdict_name(e->verdict), e->version, e->grid);
}

static void say(const archive_index_entry *a, const archive_index_entry *b, bool json)
{
    char valences[VALENCE_RANGE_TEXT], before[96], after[96];
    bool same_verdict = a && b && a->verdict == b->verdict;
    valence_range_print(valences, a ? a->valences : b->valences);
    describe(before, sizeof before, a);
    describe(after, sizeof after, b);
    if (json)
        printf("{\"valence\":\"%s\",\"first\":\"%s\",\"second\":\"%s\",\"first_grid\":%ld,\"second_grid\":%ld}\n", valences, a ? verdict_name(a->verdict) : "nothing",
               b ? verdict_name(b->verdict) : "nothing", a ? a->grid : 0, b ? b->grid : 0);
    else
        printf("valence %s: %s; %s%s\n", valences, before, after, same_verdict ? "; other choices" : "");
}

/* Undecided in both is the same, whatever the logs say. */
static bool is_same(const archive_index_entry *a, const archive_index_entry *b)
{
    return a->verdict == b->verdict && (a->verdict == VERDICT_UNDECIDED || !strcmp(a->digest, b->digest));
}

static const archive_index_entry *entry(const archive_index *z, size_t i)
{
    return i < z->count ? &z->entry[i] : NULL;
}

/* The order of indices: by the first valence, longer ranges first. */
static int order(const archive_index_entry *a, const archive_index_entry *b)
{
    if (!a || !b)
        return a ? -1 : 1;
    if (a->valences.first != b->valences.first)
        return a->valences.first < b->valences.first ? -1 : 1;
    return (a->valences.last < b->valences.last) - (a->valences.last > b->valences.last);
}

static void compare(difference *d, const archive_index *x, const archive_index *y, bool json)
{
    size_t i = 0, j = 0;
    while (i < x->count || j < y->count) {
        const archive_index_entry *a = entry(x, i), *b = entry(y, j);
        int o = order(a, b);
        if (o > 0)
            a = NULL;
        if (o < 0)
            b = NULL;
        i += a != NULL;
        j += b != NULL;
        if (a && b && is_same(a, b)) {
            d->same++;
            continue;
        }
        *(a && b ? &d->different : a ? &d->first : &d->second) += 1;
        say(a, b, json);
    }
}

/* Does a certificate of one contradict one of the other?  (Ranges need not be the same in both.)  TRUTH_UNKNOWN: no memory. */
static truth contradict(const archive_index *x, const archive_index *y)
{
    archive_index both = {.count = x->count + y->count};
    valence_range pair[2];
    truth result;
    both.entry = malloc((both.count + 1) * sizeof *both.entry);
    if (!both.entry)
        return TRUTH_UNKNOWN;
    for (size_t i = 0, j = 0; i + j < both.count;) {
        bool from_x = order(entry(x, i), entry(y, j)) <= 0;
        both.entry[i + j] = from_x ? x->entry[i] : y->entry[j];
        *(from_x ? &i : &j) += 1;
    }
    result = archive_index_contradiction(pair, &both) ? TRUTH_TRUE : TRUTH_FALSE;
    archive_index_clear(&both);
    return result;
}

static int say_result(const archive_view *x, const archive_view *y, const difference *d, bool json)
{
    if (!json)
        printf("%ld the same, %ld different, %ld only in %s, %ld only in %s\n", d->same, d->different, d->first, x->path, d->second, y->path);
    else
        printf("{\"same\":%ld,\"different\":%ld,\"only_first\":%ld,\"only_second\":%ld}\n", d->same, d->different, d->first, d->second);
    switch (contradict(&x->index, &y->index)) {
    case TRUTH_TRUE:
        return complain(EXIT_FAULT, "certificates of %s and of %s contradict each other: if both verify, this is a fault of the program", x->path, y->path);
    case TRUTH_UNKNOWN:
        return complain_of_memory();
    default:
        break;
    }
    return d->different || d->first || d->second ? 1 : 0;
}

static int compare_views(const archive_view *x, const archive_view *y, bool json)
{
    difference d = {0, 0, 0, 0};
    if (x->scheme.length != y->scheme.length || memcmp(x->scheme.bytes, y->scheme.bytes, x->scheme.length)) {
        if (json)
            printf("{\"schemes\":\"different\"}\n");
        else
            printf("%s and %s are about different schemes, or other values of their parameters\n", x->path, y->path);
        return 1;
    }
    compare(&d, &x->index, &y->index, json);
    return say_result(x, y, &d, json);
}

int archive_diff(const archive_options *o)
{
    archive_view x, y;
    int result;
    archive_view_init(&x);
    archive_view_init(&y);
    result = archive_view_open(&x, o->directory[0]);
    if (result < 0)
        result = archive_view_open(&y, o->directory[1]);
    if (result < 0)
        result = compare_views(&x, &y, o->json);
    archive_view_clear(&x);
    archive_view_clear(&y);
    return result;
}
