#ifndef CHECK_VALENCE_H
#define CHECK_VALENCE_H

/* A scheme at one valence
 * =======================
 *
 * The rules that hold there, and their weights on the grid.
 */

#include "scheme.h"

/* Where messages about the scheme point to: a line of the certificate. */
struct reference {
    const char *file;
    int line;
};

struct weighted {
    const struct source *source;
    interval weight;                               /* spectrum: the one at m = 0 */
    interval *each;                                /* SOURCE_EACH: W_0 .. W_(k-1) */
};

struct active_rule {
    const struct rule *rule;
    struct weighted *weighted;                     /* one for each source */
};

struct active_step {
    const struct step *step;
    struct stencil stencil;
    int rules;                                     /* those that hold */
    struct active_rule *rule;
};

struct valence {
    const struct scheme *scheme;
    struct reference reference;
    int64_t k;
    int g;
    struct active_step step[MAX_STEPS];
    bool plainly_regular;                          /* section 3 */
    interval *cosine, *sine;                       /* of 2 pi n/k, n < k; or NULL */
};

void valence_prepare(struct valence *out, const struct scheme *scheme,
                     struct reference reference, int64_t k, int g);

/* The rule for (a,b), or the centre, that holds; or NULL. */
const struct active_rule *valence_rule(const struct active_step *step, bool centre, int a,
                                       int b);

/* Have all spectra values at the frequency m? */
bool valence_has_values(const struct valence *v, int64_t m);

#endif
