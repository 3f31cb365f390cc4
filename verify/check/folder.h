#ifndef CHECK_FOLDER_H
#define CHECK_FOLDER_H

/* Which certificates are to prove a claim. */

#include "claim.h"

struct proof_file {
    const char *name;
    struct span k;                                 /* what it must prove */
};

struct folder {
    int count;
    struct proof_file *file;
};

/* The file `name`, which must be about all that is claimed; or if it is a folder, those
 * of its files *.cert that say that they are about valences of the claim: each of these
 * exactly once, and no others with them; else: rejected. */
void folder_partition(struct folder *out, const char *name, const struct claim *claim);

#endif
