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

void classification_print(buffer *text, const classification *z)
{
    static const struct {
        verdict verdict;
        const char *words;
    } groups[] = {{VERDICT_PROVED, "C1"}, {VERDICT_REFUTED, "not C1"}, {VERDICT_UNDECIDED, "undecided"}};
    bool first_group = true;
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++) {
        bool first = true;
        for (size_t i = 0; i < z->count; i++) {
            const classification_part *x = &z->part[i];
            char range[VALENCE_RANGE_TEXT];
            if (x->verdict != groups[g].verdict)
                continue;
            if (first)
                buffer_print(text, "%s%s: ", first_group ? "" : "; ", groups[g].words);
            else
                buffer_print(text, ", ");
            valence_range_print(range, x->k);
            buffer_print(text, "%s", range);
            if (x->verdict == VERDICT_REFUTED) {
                buffer_print(text, " (");
                print_reason(text, x);
                buffer_print(text, ")");
            }
            first = first_group = false;
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
