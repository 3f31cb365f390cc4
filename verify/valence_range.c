/* valence_range.c: ranges of valences as text. */
#include "valence_range.h"

#include <stdio.h>
#include <string.h>

int valence_range_compare(valence_range a, valence_range b)
{
    return a.first != b.first ? (a.first > b.first) - (a.first < b.first) : (a.last > b.last) - (a.last < b.last);
}

void valence_range_print(char text[VALENCE_RANGE_TEXT], valence_range r)
{
    if (r.last == VALENCES_UNBOUNDED)
        snprintf(text, VALENCE_RANGE_TEXT, "%ld..inf", r.first);
    else if (r.last > r.first)
        snprintf(text, VALENCE_RANGE_TEXT, "%ld..%ld", r.first, r.last);
    else
        snprintf(text, VALENCE_RANGE_TEXT, "%ld", r.first);
}

/* A decimal number > 0 without leading zeros that is below VALENCES_UNBOUNDED; NULL: there is none. */
static const char *read_number(long *value, const char *p)
{
    if (*p < '1' || *p > '9')
        return NULL;
    for (*value = 0; *p >= '0' && *p <= '9'; p++) {
        int digit = *p - '0';
        if (*value > (VALENCES_UNBOUNDED - 1 - digit) / 10)
            return NULL;
        *value = 10 * *value + digit;
    }
    return p;
}

const char *valence_range_read(valence_range *r, const char *text)
{
    const char *p = read_number(&r->first, text);
    r->last = r->first;
    if (!p || strncmp(p, "..", 2))
        return p;
    if (!strncmp(p + 2, "inf", 3)) {
        r->last = VALENCES_UNBOUNDED;
        return p + 5;
    }
    p = read_number(&r->last, p + 2);
    return p && r->last > r->first ? p : NULL;
}
