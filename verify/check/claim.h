#ifndef CHECK_CLAIM_H
#define CHECK_CLAIM_H

/* The valences that the reader claims something of, and the certificates that prove it. */

#include "span.h"

enum { MAX_SPANS = 1000 };

/* Disjoint and in order, as few spans as possible. */
struct claim {
    int count;
    struct span span[MAX_SPANS];
};

/* A list of numbers and ranges (3..7,20..inf), or `all`; else: cannot check. */
void claim_read(struct claim *out, const char *text);

struct proof_file {
    const char *name;
    struct span k;                                 /* what it must prove */
};

struct folder {
    int count, room;                               /* of the list */
    struct proof_file *file;
};

/* The file `name`, which must be about all that is claimed; or if it is a folder, those
 * of its files *.cert that say that they are about valences of the claim: each of these
 * exactly once, and no others with them; else: rejected. */
void folder_partition(struct folder *out, const char *name, const struct claim *claim);

#endif
