#ifndef CHECK_CLAIM_H
#define CHECK_CLAIM_H

/* The valences that the reader claims something of. */

#include "span.h"

enum { MAX_SPANS = 1000 };

/* Disjoint and in order, as few spans as possible. */
struct claim {
    int count;
    struct span span[MAX_SPANS];
};

/* A list of numbers and ranges (3..7,20..inf), or `all`; else: cannot check. */
void claim_read(struct claim *out, const char *text);

#endif
