/* valences.c: ranges and single valences, sorted and merged. */
#include "valences.h"

#include <stdbool.h>
#include <stdlib.h>

/* Reads digits; NULL if there are none. */
static const char *read_number(long *value, const char *p)
{
    const char *start = p;
    *value = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        *value = *value > CHOICES_MAX_VALENCE ? *value : 10 * *value + (*p - '0');
    return p == start ? NULL : p;
}

static const char *read_ranges(valences *z, const char *p)
{
    for (;; p++) {
        valence_range r;
        if (z->ranges == VALENCES_MAX_RANGES)
            return "a list may have 1000 parts at most";
        p = read_number(&r.first, p);
        if (!p)
            return "expected valences such as 7 or 3..20,50 (all and inf are reserved for a later version)";
        r.last = r.first;
        if (p[0] == '.' && p[1] == '.') {
            p = read_number(&r.last, p + 2);
            if (!p)
                return "expected a valence behind '..' (inf is reserved for a later version)";
        }
        if (r.first < CHOICES_MIN_VALENCE || r.last < r.first)
            return "valences begin at 3 and ranges go upwards";
        if (r.last > CHOICES_MAX_VALENCE)
            return "this version goes up to valence 1000000000";
        z->range[z->ranges++] = r;
        if (*p == '\0')
            return NULL;
        if (*p != ',')
            return "expected ',' or '..' in the list of valences";
    }
}

static int by_first(const void *x, const void *y)
{
    long a = ((const valence_range *)x)->first, b = ((const valence_range *)y)->first;
    return (a > b) - (a < b);
}

const char *valences_read(valences *z, const char *text)
{
    const char *complaint;
    int merged = 0;
    z->ranges = 0;
    z->count = 0;
    complaint = read_ranges(z, text);
    if (complaint) {
        z->ranges = 0;
        return complaint;
    }
    qsort(z->range, (size_t)z->ranges, sizeof *z->range, by_first);
    for (int i = 1; i < z->ranges; i++) {
        if (z->range[i].first > z->range[merged].last + 1)
            z->range[++merged] = z->range[i];
        else if (z->range[i].last > z->range[merged].last)
            z->range[merged].last = z->range[i].last;
    }
    z->ranges = merged + 1;
    for (int i = 0; i < z->ranges; i++)
        z->count += z->range[i].last - z->range[i].first + 1;
    if (z->count > VALENCES_MAX) {
        z->ranges = 0;
        z->count = 0;
        return "this version examines valences one by one, at most 100000 in a run";
    }
    return NULL;
}

long valences_get(const valences *z, long i)
{
    for (const valence_range *r = z->range;; r++) {
        long length = r->last - r->first + 1;
        if (i < length)
            return r->first + i;
        i -= length;
    }
}
