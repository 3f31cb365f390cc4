/* valence_list.c: ranges and single valences, sorted and merged. */
#include "valence_list.h"

#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Reads digits; NULL if there are none. */
static const char *read_number(long *value, const char *p)
{
    const char *start = p;
    *value = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        *value = *value > CHOICES_MAX_VALENCE ? *value : 10 * *value + (*p - '0');
    return p == start ? NULL : p;
}

/* What stands behind "..". */
static const char *read_end(long *value, const char *p)
{
    if (strncmp(p, "inf", 3))
        return read_number(value, p);
    *value = VALENCES_UNBOUNDED;
    return p + 3;
}

/* "7", "3..20", "8..inf" or "all"; NULL: what *complaint says. */
static const char *read_range(valence_range *r, const char **complaint, const char *p)
{
    if (!strncmp(p, "all", 3)) {
        *r = (valence_range){CHOICES_MIN_VALENCE, VALENCES_UNBOUNDED};
        return p + 3;
    }
    *complaint = "expected valences such as 7, 3..20,50, 8..inf or all";
    p = read_number(&r->first, p);
    if (!p)
        return NULL;
    r->last = r->first;
    if (p[0] == '.' && p[1] == '.') {
        *complaint = "expected a valence, or inf, behind '..'";
        p = read_end(&r->last, p + 2);
        if (!p)
            return NULL;
    }
    *complaint = "valences begin at 3 and ranges go upwards";
    if (r->first < CHOICES_MIN_VALENCE || r->last < r->first)
        return NULL;
    *complaint = "ranges with an end go up to valence 1000000000; 'inf' instead of it covers all";
    return r->first > CHOICES_MAX_VALENCE || (r->last > CHOICES_MAX_VALENCE && r->last != VALENCES_UNBOUNDED) ? NULL : p;
}

static const char *read_ranges(valence_list *z, const char *p)
{
    for (;; p++) {
        const char *complaint = NULL;
        if (z->ranges == VALENCE_LIST_MAX)
            return "a list may have 1000 parts at most";
        p = read_range(&z->range[z->ranges++], &complaint, p);
        if (!p)
            return complaint;
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

/* Sorted ranges that touch become one. */
static void merge(valence_list *z)
{
    int merged = 0;
    for (int i = 1; i < z->ranges; i++) {
        valence_range *last = &z->range[merged];
        if (last->last != VALENCES_UNBOUNDED && z->range[i].first > last->last + 1)
            z->range[++merged] = z->range[i];
        else if (z->range[i].last > last->last)
            last->last = z->range[i].last;
    }
    z->ranges = merged + 1;
}

const char *valence_list_read(valence_list *z, const char *text)
{
    const char *complaint;
    z->ranges = 0;
    z->count = 0;
    complaint = read_ranges(z, text);
    if (complaint) {
        z->ranges = 0;
        return complaint;
    }
    qsort(z->range, (size_t)z->ranges, sizeof *z->range, by_first);
    merge(z);
    for (int i = 0; i < z->ranges; i++) {
        const valence_range *r = &z->range[i];
        z->count = r->last == VALENCES_UNBOUNDED ? LONG_MAX : z->count + (r->last - r->first + 1);
    }
    return NULL;
}

long valence_list_get(const valence_list *z, long i)
{
    for (const valence_range *r = z->range;; r++) {
        long length = r->last - r->first + 1;
        if (r->last == VALENCES_UNBOUNDED || i < length)
            return r->first + i;
        i -= length;
    }
}
