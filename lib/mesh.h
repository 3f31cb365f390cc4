/* mesh.h: the lattices on which nets live, and the way round an extraordinary vertex or face.

   A net's points in one sector carry labels (a,b), a >= 1, b >= b0:
     MESH_TRIANGLE  b0 = 0: the vertex a e1 + b e2 (lib/scheme.md, "Lattice"); ring a + b; centre (0,0)
     MESH_QUAD      b0 = 0: the vertex (a,b) of the square lattice; ring max(a,b); centre (0,0)
     MESH_DUAL      b0 = 1: the point (a - 1/2, b - 1/2), in the middle of a square; ring max(a,b); no centre
   Multiplying by t = exp(2 pi i m / k) takes the values of one sector to the next, counter-clockwise. */
#ifndef LIB_MESH_H
#define LIB_MESH_H

#include "lattice.h"

#include <stdbool.h>

typedef enum { MESH_TRIANGLE, MESH_QUAD, MESH_DUAL } mesh_kind;

const char *mesh_name(mesh_kind mesh);

static inline bool mesh_in_sector(mesh_kind mesh, int a, int b)
{
    return a >= 1 && b >= (mesh == MESH_DUAL);
}

static inline bool mesh_is_centre(mesh_kind mesh, int a, int b)
{
    return a == 0 && b == 0 && mesh != MESH_DUAL;
}

/* The ring of a point of the sector. */
static inline int mesh_ring(mesh_kind mesh, int a, int b)
{
    return mesh == MESH_TRIANGLE ? a + b : a > b ? a : b;
}

/* Brings (a,b), a point of the plane other than the centre, into the sector: its value is t^turns times the one
   there.  false: it lies opposite the sector, where the sheet is ambiguous, unless the complex is the regular one
   (which is the plane: any way round gives the same). */
bool mesh_reduce(mesh_kind mesh, bool regular, int *a, int *b, int *turns);

/* Turns a label of the plane by `turns` sectors of the regular complex, counter-clockwise, about the centre. */
lattice mesh_turn(mesh_kind mesh, lattice p, int turns);

/* How long the vector (a,b) is: |(a,b)| of lib/scheme.md on triangles, max(|a|, |b|) on quads. */
int mesh_distance(mesh_kind mesh, int a, int b);

/* The symmetries of masks, on labels (new - 2 old): rotation about the centre by one sector of the regular complex,
   and reflection. */
lattice mesh_rotate_mask(mesh_kind mesh, lattice p);
static inline lattice mesh_reflect_mask(lattice p)
{
    lattice q = {p.b, p.a};
    return q;
}
/* How many sectors the regular complex has: 6 or 4. */
static inline int mesh_regular_valence(mesh_kind mesh) { return mesh == MESH_TRIANGLE ? 6 : 4; }

/* How far the mask point p reaches: a new point on ring j uses old rings up to floor((j + reach) / 2). */
int mesh_mask_reach(mesh_kind mesh, lattice p);

#endif
