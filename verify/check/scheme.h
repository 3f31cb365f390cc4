#ifndef CHECK_SCHEME_H
#define CHECK_SCHEME_H

/* Schemes
 * =======
 *
 * What a scheme file says at one valence: lib/scheme.md.
 */

#include "mask.h"

struct scheme {
    char name[65];
    struct mask mask;                              /* conditions checked */
    interval centre, all;                          /* c0 and c1 on the grid */
};

/* Reads the text of the file (whose bytes text_canonical() has checked), with
 * formulas evaluated at k on the grid g.  A text that is not a scheme of
 * version 0: cannot check. */
void scheme_read(struct scheme *out, const char *file, const char *text,
                 size_t size, int k, int g);

#endif
