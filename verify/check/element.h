#ifndef CHECK_ELEMENT_H
#define CHECK_ELEMENT_H

/* Elements and their windows
 * ==========================
 *
 * Section 7 of certificate.md.  An element is given by its kind and a label, its
 * anchor.  All labels here are relative to the anchor, so that an element of any
 * level is as good as any other of its kind.
 */

#include "mask.h"

enum element_kind {
    ELEMENT_U, ELEMENT_D, ELEMENT_E, ELEMENT_S, ELEMENT_G, ELEMENT_H, ELEMENT_KINDS
};

struct label {
    int a, b;
};

/* The anchor of a child is twice the anchor of its parent, plus (a,b). */
struct child {
    enum element_kind kind;
    int a, b;
};

struct element_form {
    const char *name;
    int vertices;
    struct label vertex[4];
    int children;
    struct child child[4];
};

extern const struct element_form element_form[ELEMENT_KINDS];

/* A window: its labels, and the index of each in the list or -1. */
struct window {
    int count;
    struct label *label;
    int low_a, low_b, side_a, side_b;
    int *index;
};

struct window window_make(enum element_kind kind, const struct stencil *mask, enum mesh mesh);

/* The index of (a,b), or -1. */
int window_index(const struct window *w, int a, int b);

/* The largest distance of y and y + (shift_a, shift_b), y in the window, to the
 * nearest vertex of the element. */
int window_reach(const struct window *w, enum element_kind kind, enum mesh mesh,
                 int shift_a, int shift_b);

/* The elements of a ring, in the order of section 8: those on which regularity, or
 * (boundary) isolation, is decided. */
struct element {
    enum element_kind kind;
    int a, b;
};

int ring_elements(struct element **out, enum mesh mesh, int r, bool boundary);

#endif
