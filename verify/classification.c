/* classification.c: ranges with the same answer, grouped by what it is. */
#include "classification.h"

#include "valence_range.h"

#include "../lib/growing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void classification_init(classification *z)
{
    *z = (classification){NULL, 0, 0, 0, 0, 0};
}

void classification_clear(classification *z)
{
    free(z->part);
    classification_init(z);
}

/* Frequencies count where they are always the same one. */
static bool is_same_answer(const classification_part *x, const decision *d)
{
    return x->verdict == d->verdict && (d->verdict != VERDICT_REFUTED || (!strcmp(claim_name(x->claim), claim_name(d->claim)) && (x->frequency == 0) == (d->frequency == 0)));
}

bool classification_add(classification *z, const decision *d)
{
    classification_part *last = z->count ? &z->part[z->count - 1] : NULL, *room;
    z->boxes++;
    if (d->findings.uniform && d->findings.uniform_level > z->uniform_level)
        z->uniform_level = d->findings.uniform_level;
    z->uniform_width = fmax(z->uniform_width, d->findings.uniform_width);
    if (last && last->k.last + 1 == d->k.first && is_same_answer(last, d)) {
        last->k.last = d->k.last;
        return true;
    }
    room = growing_room(z->part, z->count, &z->capacity, sizeof *room);
    if (!room)
        return false;
    z->part = room;
    z->part[z->count++] = (classification_part){d->k, d->verdict, d->claim, d->frequency};
    return true;
}

/* "frequency 0": with the frequency only where it is 0, for others change from valence to valence. */
static void print_reason(buffer *text, const classification_part *x)
{
    buffer_print(text, "%s", claim_name(x->claim));
    if (x->claim == CLAIM_FREQUENCY && x->frequency == 0)
        buffer_print(text, " 0");
}

/* For people an eigenvalue of modulus 1 and one beyond are the same reason, and so are all frequencies but 0; NULL: proved, or not decided. */
static const char *reason_of(const classification_part *x)
{
    if (x->verdict != VERDICT_REFUTED)
        return NULL;
    switch (x->claim) {
    case CLAIM_NOT_C0:
    case CLAIM_GRADED:
    case CLAIM_MODULUS_ONE:
        return "not-C0";
    case CLAIM_FREQUENCY:
        return x->frequency == 0 ? "frequency 0" : "frequency";
    default:
        return claim_name(x->claim);
    }
}

static bool is_same_reason(const char *x, const char *y)
{
    return x && y ? !strcmp(x, y) : x == y;
}

/* The range from part i on, with all that follow without a gap for the same reason; returns the next part. */
static size_t print_range(buffer *text, const classification *z, size_t i)
{
    const classification_part *x = &z->part[i];
    valence_range k = x->k;
    char range[VALENCE_RANGE_TEXT];
    while (++i < z->count && k.last + 1 == z->part[i].k.first && x->verdict == z->part[i].verdict && is_same_reason(reason_of(x), reason_of(&z->part[i])))
        k.last = z->part[i].k.last;
    valence_range_print(range, k);
    buffer_print(text, "%s", range);
    return i;
}

/* All ranges with the verdict and the reason of part `first`, which is the first one: "3, 20..25 (frequency 0)". */
static void print_ranges(buffer *text, const classification *z, size_t first)
{
    const char *reason = reason_of(&z->part[first]);
    for (size_t i = first; i < z->count;) {
        if (z->part[i].verdict != z->part[first].verdict || !is_same_reason(reason_of(&z->part[i]), reason)) {
            i++;
            continue;
        }
        buffer_print(text, "%s", i > first ? ", " : "");
        i = print_range(text, z, i);
    }
    if (reason)
        buffer_print(text, " (%s)", reason);
}

static bool is_first_of_its_kind(const classification *z, size_t i)
{
    for (size_t j = 0; j < i; j++)
        if (z->part[j].verdict == z->part[i].verdict && is_same_reason(reason_of(&z->part[j]), reason_of(&z->part[i])))
            return false;
    return true;
}

void classification_print(buffer *text, const classification *z)
{
    static const struct {
        verdict verdict;
        const char *words;
    } groups[] = {{VERDICT_PROVED, "C1"}, {VERDICT_REFUTED, "not C1"}, {VERDICT_UNDECIDED, "undecided"}};
    const char *before_group = "";
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++) {
        const char *before = NULL; /* within the group */
        for (size_t i = 0; i < z->count; i++) {
            if (z->part[i].verdict != groups[g].verdict || !is_first_of_its_kind(z, i))
                continue;
            if (before)
                buffer_print(text, "%s", before);
            else
                buffer_print(text, "%s%s: ", before_group, groups[g].words);
            print_ranges(text, z, i);
            before = ", ";
            before_group = "; ";
        }
    }
}

static void print_range_json(buffer *text, valence_range k)
{
    if (k.last == VALENCES_UNBOUNDED)
        buffer_print(text, "[%ld,null]", k.first);
    else
        buffer_print(text, "[%ld,%ld]", k.first, k.last);
}

static void print_group_json(buffer *text, const classification *z, verdict which, const char *name)
{
    const char *comma = "";
    buffer_print(text, "\"%s\":[", name);
    for (size_t i = 0; i < z->count; i++) {
        const classification_part *x = &z->part[i];
        if (x->verdict != which)
            continue;
        buffer_print(text, "%s", comma);
        comma = ",";
        if (which == VERDICT_REFUTED)
            buffer_print(text, "{\"valences\":");
        print_range_json(text, x->k);
        if (which == VERDICT_REFUTED) {
            buffer_print(text, ",\"reason\":\"");
            print_reason(text, x);
            buffer_print(text, "\"}");
        }
    }
    buffer_print(text, "]");
}

void classification_print_json(buffer *text, const classification *z)
{
    print_group_json(text, z, VERDICT_PROVED, "c1");
    buffer_print(text, ",");
    print_group_json(text, z, VERDICT_REFUTED, "not_c1");
    buffer_print(text, ",");
    print_group_json(text, z, VERDICT_UNDECIDED, "undecided");
}
