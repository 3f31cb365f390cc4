/* picture.h: what can be seen of an eigenfunction's map and of the trees that decided about it: doubles, for reports.

   A picture proves nothing.  It is taken while an analysis has its enclosures at hand (picture_take, in tests.h), so that it
   shows what the analysis saw; the bounds in it are bounds. */
#ifndef VERIFY_PICTURE_H
#define VERIFY_PICTURE_H

#include "../lib/ring.h"
#include "choices.h"

typedef struct {
    double x, y;
} point;

/* A leaf of the trees of the ring, or of its outer curve; coordinates are those of `level` subdivisions. */
typedef struct {
    element_type type;
    int a, b, level;
    char letter;         /* what decided (tree.h) */
    double lower, upper; /* the Jacobian on its box, in the coordinates of the certificate */
} picture_leaf;

typedef struct {
    picture_leaf *leaf;
    size_t count, capacity;
} picture_leaves;

/* The six errors of a picture: how far a limit value (V) or derivative (D1, D2) can be, on the element of the tree where it
   can be farthest, from the middle of the net there; in x and y. */
enum { PICTURE_ERRORS = 6 };

typedef struct {
    bool with_net;      /* to be set before it is taken: is the map to be drawn, too? */
    bool taken;
    long valence, frequency;
    double re, im;      /* the eigenvalue */
    double least[2], most[2]; /* bounds of the Jacobian's minimum and maximum on the ring */
    double error[PICTURE_ERRORS]; /* V x, V y, D1 x, D1 y, D2 x, D2 y; NaN: no such tree */
    picture_leaves tree;   /* the trees of the certificate */
    picture_leaves signs;  /* trees that end where the Jacobian is known well enough, or at PICTURE_DEPTH */
    double *control;    /* real form, frequency 1: the control net in the coordinates (x, y) of certificates, in which nets have a limit as the
                           valence grows, so many numbers, x(1,b) = 1 for the first point */
    size_t controls;
    /* with_net: */
    const ring *ring;
    mesh_kind mesh;
    bool regular;
    int rings, level;   /* the net on these rings, and how often the ring can be subdivided in it */
    double *x, *y;      /* as in certificates, [(a - 1)(rings + 1) + b] */
    double height;      /* the value is x + i height y */
} picture;

enum { PICTURE_DEPTH = 5 };

void picture_init(picture *z, bool with_net);
void picture_clear(picture *z);

/* The largest difference of a coordinate of the control nets; NaN: they cannot be compared. */
double picture_distance(const picture *a, const picture *b);

bool picture_add_leaf(picture_leaves *z, const picture_leaf *leaf); /* false: no memory */
/* The leaves of the trees in `word` for the elements; bounds unknown.  false: no memory, or the word is not one. */
bool picture_read_leaves(picture_leaves *z, const tree_word *word, const element *elements, int count);

/* Where the map takes the point (a,b) of the ring's coordinates, after `sector` turns; with_net. */
point picture_at(const picture *z, double a, double b, int sector);
/* Where it takes a vertex of a leaf. */
point picture_vertex(const picture *z, const picture_leaf *leaf, int vertex, int sector);
/* The control net's point (a,b) after `level` subdivisions, level <= z->level. */
point picture_control(const picture *z, int a, int b, int level, int sector);

#endif
