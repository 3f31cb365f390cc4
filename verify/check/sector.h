#ifndef CHECK_SECTOR_H
#define CHECK_SECTOR_H

/* Sector nets
 * ===========
 *
 * Section 5 of certificate.md.  A net on the k-regular complex that rotation
 * multiplies by exp(i w_m) is stored on one sector, up to some ring.  For m >= 1 a
 * value is a pair; for m = 0 values are plain, y being 0 and not used, or complex.
 */

#include "affine.h"
#include "valence.h"

struct pair {
    struct affine x, y;
};

struct pair pair_add(struct pair v, struct pair w);

/* v / w, both standing for x + i y; |w|^2 must not contain 0. */
struct pair pair_divide(struct pair v, struct pair w, int g);

/* |v|^2, for x + i y. */
struct affine pair_norm(struct pair v, int g);

/* Where a label of the plane is. */
enum place { IN_SECTOR, CENTRE, BEHIND, BEFORE, OPPOSITE };

/* The same place, named from the next sector or from the one before. */
void label_from_next(enum mesh mesh, int *a, int *b);
void label_from_before(enum mesh mesh, int *a, int *b);

/* BEHIND (T V) and BEFORE (T^-1 V): the label is turned by one sector. */
enum place label_turn(enum mesh mesh, int *a, int *b);

struct block;
struct term;

/* What a net's values are, of the block: numbers that zeroed memory makes 0. */
struct arithmetic {
    size_t size;
    void (*turn)(void *v, bool behind, const struct block *block);     /* T v; T^-1 v */

    /* The sum gets a source of a rule, or a point of the mask, whose value is v; (or NULL:) and
     * what is done with the sum of all. */
    void (*add_term)(void *sum, const struct term *t, const void *v, const struct block *block);
    void (*add_entry)(void *sum, const struct stencil_entry *e, const void *v,
                      const struct block *block);
    void (*finish)(void *sum, const struct block *block);

    /* v := v / l, the eigenvalue; NULL where no net is extended. */
    void (*divide)(void *v, struct pair l, const struct block *block);
};

/* Values on the rings 1..rings of the sector, at the centre (0,0) if there is one, and, found by
 * rotation when they are first asked for, on the labels of the plane round it. */
struct net {
    const struct arithmetic *of;
    enum mesh mesh;
    int rings;
    unsigned char *value;
    bool *known;
};

/* An unknown of a block: what is read off at which label. */
struct unknown {
    int a, b;
    enum unknown_kind {
        UNKNOWN_PLAIN,                             /* m = 0: the value */
        UNKNOWN_COMPLEX,                           /* x + i y */
        UNKNOWN_SPOKE,                             /* b = 0: x */
        UNKNOWN_BISECTOR,                          /* a = b: y, where x = u y */
        UNKNOWN_X, UNKNOWN_Y                       /* a > b > 0: x, y */
    } kind;
};

/* A source of a rule: the pairs at its label are multiplied by a matrix. */
struct term {
    const struct source *source;
    struct affine m[4];                            /* m0 m1; m2 m3 */
    const void *own;                               /* its weight, for other arithmetics */
};

struct block_rule {
    int terms;
    struct term *term;
};

/* What a computation on the nets of some frequencies depends on. */
struct block {
    const struct valence *v;
    struct span m;
    bool plain, real;                              /* m = 0; m >= 1 in real form */
    bool has_y;                                    /* m >= 1, or set: y is used, too */
    struct affine turn[4], back[4], u;             /* T, T^-1 */
    struct block_rule *rule[MAX_STEPS];            /* as in v->step[].rule */
    int rings;                                     /* R */
    int n;                                         /* number of unknowns */
    int size;                                      /* of the real matrix: N */
    struct unknown *unknown;
    void *own;                                     /* what other arithmetics need */
};

/* The block of the frequencies m. */
void block_prepare(struct block *out, const struct valence *v, bool real, struct span m);

/* The same in the real form, for u in place of what follows from k and m. */
void block_prepare_over(struct block *out, const struct valence *v, struct span m, struct affine u);

/* M: size x size, row by row. */
struct affine *block_matrix(const struct block *block);

/* A net of zeros with that many rings. */
struct net net_make(enum mesh mesh, int rings);

/* Sets the value at a label of the sector. */
void net_set(struct net *net, int a, int b, struct pair value);

/* Sets the values on the rings 1..R (and the centre) from the unknowns (complex
 * form: real parts, then imaginary parts). */
void net_set_unknowns(struct net *out, const struct block *block, const struct affine *unknowns);

/* V(a,b) for any label of the plane that is not opposite. */
struct pair net_value(const struct net *net, const struct block *block, int a, int b);

/* The same for values of any kind: a net of zeros, the place of a value that is set by that, and
 * the value of a label. */
struct net net_of(const struct arithmetic *of, enum mesh mesh, int rings);
void *net_add(struct net *net, int a, int b);
const void *net_find(const struct net *net, const struct block *block, int a, int b);

/* The net after one subdivision, on the rings 1..rings. */
struct net net_subdivide(const struct net *old, const struct block *block, int rings);

/* The net of an eigenvector, at l, with that many rings or as many as follow from those of the old
 * one: V = (new value)/l, as V is an eigenvector of the scheme on the whole complex. */
struct net net_extend(const struct net *old, const struct block *block, struct pair l, int rings);

#endif
