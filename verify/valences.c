/* valences.c: ranges and single valences, sorted by marking. */
#include "valences.h"

#include <stdbool.h>

/* Reads digits; NULL if there are none. */
static const char *read_number(long *value, const char *p)
{
    const char *start = p;
    *value = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        *value = *value > CHOICES_MAX_VALENCE ? *value : 10 * *value + (*p - '0');
    return p == start ? NULL : p;
}

/* Marks the valences of the list. */
static const char *mark(bool *wanted, const char *p)
{
    for (;; p++) {
        long first, last;
        p = read_number(&first, p);
        if (!p)
            return "expected valences such as 7 or 3..20,50 (all and inf are reserved for a later version)";
        last = first;
        if (p[0] == '.' && p[1] == '.') {
            p = read_number(&last, p + 2);
            if (!p)
                return "expected a valence behind '..' (inf is reserved for a later version)";
        }
        if (first < CHOICES_MIN_VALENCE || last < first)
            return "valences begin at 3 and ranges go upwards";
        if (last > CHOICES_MAX_VALENCE)
            return "this version goes up to valence 4096";
        for (long k = first; k <= last; k++)
            wanted[k] = true;
        if (*p == '\0')
            return NULL;
        if (*p != ',')
            return "expected ',' or '..' in the list of valences";
    }
}

const char *valences_read(valences *z, const char *text)
{
    bool wanted[CHOICES_MAX_VALENCE + 1] = {false};
    const char *complaint = mark(wanted, text);
    z->count = 0;
    if (complaint)
        return complaint;
    for (long k = CHOICES_MIN_VALENCE; k <= CHOICES_MAX_VALENCE; k++)
        if (wanted[k])
            z->valence[z->count++] = k;
    return NULL;
}
