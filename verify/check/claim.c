/* The valences that are claimed: the option --valence. */

#include "claim.h"

#include "answer.h"
#include "scratch.h"

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
