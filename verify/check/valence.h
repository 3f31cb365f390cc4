#ifndef CHECK_VALENCE_H
#define CHECK_VALENCE_H

/* A scheme at one valence, or at several
 * ======================================
 *
 * The rules that hold there, and their weights on the grid: intervals that contain those
 * at each of the valences.
 */

#include "affine.h"
#include "scheme.h"

/* Where messages about the scheme point to: a line of the certificate. */
struct reference {
    const char *file;
    int line;
};

struct weighted {
    const struct source *source;
    struct affine weight;                          /* spectrum: the one at m = 0 */
    interval *each;                                /* SOURCE_EACH: W_0 .. W_(k-1) */
};

struct active_rule {
    const struct rule *rule;
    struct weighted *weighted;                     /* one for each source */
    const struct value *missing;                   /* of the centre, several valences: a weight
                                                      that is not bounded there, or NULL */
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
    struct span k;
    int g;
    struct active_step step[MAX_STEPS];
    bool plainly_regular;                          /* section 3 */
    interval *cosine, *sine;                       /* of 2 pi n/k, n < k; or NULL */
};

/* Of several valences, a rule that holds at some of them only, or is not decided: rejected. */
void valence_prepare(struct valence *out, const struct scheme *scheme,
                     struct reference reference, struct span k, int g);

/* Does no weight, but of rules for the centre, depend on k or m? */
bool valence_is_uniform(const struct valence *v);

/* Rejects schemes without a centre, or where not only rules of the centre depend on k or m, or have
 * sources in all sectors. */
void valence_require_centre(const struct valence *v);

/* One valence, that of the plane: 6 on triangles, 4 on quads? */
bool valence_is_regular(const struct valence *v);

/* The rule for (a,b), or the centre, that holds; or NULL. */
const struct active_rule *valence_rule(const struct active_step *step, bool centre, int a, int b);

/* Have all spectra values at the frequency m? */
bool valence_has_values(const struct valence *v, int64_t m);

#endif
