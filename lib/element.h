/* element.h: the elements of a subdivided mesh, and which points influence the limit on them (lib/ring.md, 1 and 2).

   Triangle meshes have the elements UP(a,b), the triangle (a,b) (a+1,b) (a,b+1); DOWN(a,b), the triangle (a+1,b+1)
   (a,b+1) (a+1,b); and EDGE(a,b), the segment from (a+1,b) to (a,b+1).  Quad meshes have SQUARE(a,b), the square
   with the corners (a,b) and (a+1,b+1); ALONG_FIRST(a,b), the segment from (a,b) to (a+1,b); and ALONG_SECOND(a,b),
   the segment from (a,b) to (a,b+1).  On dual meshes elements are those of quads, in the coordinates in which the label
   (a,b) lies at (a,b).  Everything here is combinatorial: small integers. */
#ifndef LIB_ELEMENT_H
#define LIB_ELEMENT_H

#include "laurent.h"
#include "mesh.h"

typedef enum { ELEMENT_UP, ELEMENT_DOWN, ELEMENT_EDGE, ELEMENT_SQUARE, ELEMENT_ALONG_FIRST, ELEMENT_ALONG_SECOND } element_type;
enum { ELEMENT_TYPES = 6, ELEMENT_MAX_CHILDREN = 4 };

/* A child of the element at (a,b) lies at (2a + shift.a, 2b + shift.b) of the next level. */
typedef struct {
    element_type type;
    lattice shift;
} element_child;

/* Do meshes of this kind have elements of this type? */
bool element_is_of(element_type type, mesh_kind mesh);
bool element_is_segment(element_type type);
int element_children(element_type type); /* how many */
element_child element_get_child(element_type type, int index);
int element_vertices(element_type type);
lattice element_get_vertex(element_type type, int index); /* relative to (a,b) */

/* The window of an element at (0,0) for a mask: the points, in order of a then b, whose basis functions may be
   non-zero on it. */
typedef struct {
    lattice *point;
    int count;
} element_window;

/* How the values in a child's window follow from those in its parent's: row i of the child is the sum over
   entries e from row[i] to row[i+1] of mask(term[e]) * value[source[e]]. */
typedef struct {
    int *row;       /* count + 1 of them */
    int *source;
    lattice *term;  /* where in the mask */
    int count;      /* points in the child's window */
} element_refinement;

/* The windows of one mask for all types of its mesh (empty ones for other types), and the refinements from each to its
   children. */
typedef struct {
    element_window window[ELEMENT_TYPES];
    element_refinement child[ELEMENT_TYPES][ELEMENT_MAX_CHILDREN];
} element_stencil;

void element_stencil_init(element_stencil *z);
void element_stencil_clear(element_stencil *z);
BIGFLOAT_MUST_USE bool element_stencil_make(element_stencil *z, mesh_kind mesh, const laurent *mask);

/* The largest distance (mesh_distance) from a point that the stencil uses, y and y + difference, to the nearest vertex
   of the element.  The type must be one of the stencil's mesh. */
int element_stencil_reach(const element_stencil *s, element_type type, lattice difference);

#endif
