#ifndef CHECK_WINDOW_H
#define CHECK_WINDOW_H

/* Elements and their windows
 * ==========================
 *
 * Section 7 of certificate.md.  An element is given by its kind and a lattice
 * point, its anchor.  All points here are relative to the anchor, so that an
 * element of any level is as good as any other of its kind.
 */

#include "mask.h"

enum element_kind { ELEMENT_U, ELEMENT_D, ELEMENT_E, ELEMENT_KINDS };

struct point {
    int a, b;
};

/* The anchor of a child is twice the anchor of its parent, plus (a,b). */
struct child {
    enum element_kind kind;
    int a, b;
};

/* Number of vertices, number of children. */
extern const int element_vertices[ELEMENT_KINDS];
extern const struct point element_vertex[ELEMENT_KINDS][3];
extern const int element_children[ELEMENT_KINDS];
extern const struct child element_child[ELEMENT_KINDS][4];

/* Windows reach from min f - 8 to max f + 8 in a and b. */
enum { WINDOW_LOW = -MASK_RADIUS, WINDOW_SIDE = 2 * MASK_RADIUS + 2 };

/* A window: its points, and the index of each point in the list or -1. */
struct window {
    int count;
    struct point point[WINDOW_SIDE * WINDOW_SIDE];
    int index[WINDOW_SIDE][WINDOW_SIDE];
};

void window_prepare(struct window *out, enum element_kind kind,
                    const struct stencil *mask);

/* The index of (a,b), or -1. */
int window_index(const struct window *w, int a, int b);

/* The largest distance of y and y + (shift_a, shift_b), y in the window, to the
 * nearest vertex of the element. */
int window_reach(const struct window *w, enum element_kind kind, int shift_a,
                 int shift_b);

#endif
