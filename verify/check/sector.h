#ifndef CHECK_SECTOR_H
#define CHECK_SECTOR_H

/* Sector nets
 * ===========
 *
 * Section 5 of certificate.md.  A net on the k-regular complex that rotation
 * multiplies by exp(i w_m) is stored on the sector {a >= 1, b >= 0}, up to some
 * ring a + b.  For m >= 1 a value is a pair (x, y) that stands for
 * x + i sin(w_m/2) y.  For m = 0 values are plain: y is 0 and not used.
 */

#include "scheme.h"

struct pair {
    interval x, y;
};

/* Rotation by one sector in block m. */
struct twist {
    int m;
    interval u, v, c, n;                           /* m >= 1 */
};

struct net {
    int rings;
    struct pair centre;
    struct pair *value;                            /* see net_at() */
};

/* An unknown of a block: what is read off at which point. */
struct unknown {
    int a, b;
    enum unknown_kind {
        CENTRE,                                    /* m = 0: the centre */
        PLAIN,                                     /* m = 0: the value */
        SPOKE,                                     /* b = 0: x */
        BISECTOR,                                  /* a = b: y, where x = u y */
        PAIR_X, PAIR_Y                             /* a > b > 0: x, y */
    } kind;
};

/* What a computation on nets of one block depends on. */
struct block {
    const struct scheme *scheme;
    const struct stencil *mask;
    int g;
    struct twist twist;
    int rings;                                     /* R */
    int n;                                         /* number of unknowns */
    struct unknown *unknown;
};

void pair_set(struct pair *out, const struct pair *v);

/* Prepares block m of valence k: twist, size and unknowns. */
void block_prepare(struct block *out, const struct scheme *scheme,
                   const struct stencil *mask, int k, int m, int g);

/* Number of unknowns of the blocks m >= 1 for a mask of radius h. */
int block_size(int h);

void block_clear(struct block *block);

/* B: n x n, entry i n + j is row i, column j.  The caller frees it. */
interval *block_matrix(const struct block *block);

/* A net of zeros with that many rings. */
void net_prepare(struct net *out, int rings);

void net_clear(struct net *net);

/* The stored value at (a,b), a >= 1, b >= 0, a + b <= rings. */
struct pair *net_at(const struct net *net, int a, int b);

/* Sets the values on the rings 1..R (and the centre) from the unknowns. */
void net_from_unknowns(struct net *out, const struct block *block,
                       const interval *unknowns);

/* V(a,b) for any point of the plane that is not opposite. */
void net_value(struct pair *out, const struct net *net, const struct twist *twist,
               int a, int b, int g);

/* The new value at (a,b) by the mask. */
void net_new_value(struct pair *out, const struct net *net,
                   const struct block *block, int a, int b);

#endif
