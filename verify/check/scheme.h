#ifndef CHECK_SCHEME_H
#define CHECK_SCHEME_H

/* Schemes
 * =======
 *
 * What a scheme file says: lib/scheme.md.  All points are given by their labels
 * (certificate.md, section 3), and compositions have been written out as steps
 * with masks and rules, so that nobody else needs to know of them.
 */

#include "mask.h"
#include "value.h"

enum { MAX_RULES = 16, MAX_SOURCES = 32, MAX_STEPS = 34 };

struct source {
    enum source_kind {
        SOURCE_CENTRE,
        SOURCE_ALL,                                /* all (a,b) */
        SOURCE_ONE,                                /* (a,b) @ sectors */
        SOURCE_EACH,                               /* (a,b) @ j */
        SOURCE_SPECTRUM
    } kind;
    int a, b, sectors;
    const struct node *weight;                     /* NULL: the rest */
    const struct node *imaginary;                  /* of a spectrum, or NULL */
};

struct rule {
    bool centre;
    int a, b;                                      /* else */
    const struct node *condition;                  /* NULL: always */
    int rest;                                      /* the source of this number is it */
    int count;
    struct source source[MAX_SOURCES];
};

struct step {
    enum mesh old, new;                            /* of the nets */
    int dilation;
    int reach;                                     /* section 5, "Size" */
    struct mask mask;
    int rules;
    const struct rule *rule;
};

struct scheme {
    char name[65];
    enum mesh mesh;                                /* of the old net and the result */
    struct language language;
    int steps;
    struct step step[MAX_STEPS];
    struct mask mask;                              /* of all steps together */
    bool mirrored;                                 /* evidently mirror-symmetric */
};

/* Reads the text of the file (whose bytes text_canonical() has checked).  A text
 * that is not a scheme: cannot check. */
void scheme_read(struct scheme *out, const char *file, const char *text, size_t size);

/* Is it a triangle scheme of one mask and one rule, as in verify/scheme-0.md? */
bool scheme_is_of_version_0(const struct scheme *scheme);

/* The largest reach of the points of a mask from this mesh to itself: section 5, "Size". */
int mask_reach(const struct mask *mask, enum mesh mesh);

/* The number of the ring of a label of the sector. */
int label_ring(enum mesh mesh, int a, int b);

/* needed(j) of section 5 for one step. */
int step_needs(const struct step *step, int j);

/* Is it evidently mirror-symmetric: lib/scheme.md, "Mirror symmetry"? */
bool scheme_is_mirrored(const struct scheme *scheme);

/* F of lib/ring.md: the farthest ring on which a new value may not follow the scheme's mask, at
 * whatever valence beyond the regular one. */
int scheme_influence(const struct scheme *scheme);

#endif
