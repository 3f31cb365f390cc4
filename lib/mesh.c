/* mesh.c: crossing spokes, and what masks may be turned into. */
#include "mesh.h"

const char *mesh_name(mesh_kind mesh)
{
    static const char *const names[] = {"triangle", "quad", "quad-dual"};
    return names[mesh];
}

/* Across the second spoke (a < 1) or the first (b < 0, or b < 1 for dual meshes), one at a time. */
bool mesh_reduce(mesh_kind mesh, bool regular, int *a, int *b, int *turns)
{
    *turns = 0;
    while (!mesh_in_sector(mesh, *a, *b)) {
        int p = *a, q = *b;
        bool second = q >= 1, first = !second && p >= (mesh == MESH_DUAL);
        if (second || (!first && regular)) {
            *a = mesh == MESH_TRIANGLE ? p + q : q;
            *b = mesh == MESH_DUAL ? 1 - p : -p;
            ++*turns;
        } else if (first) {
            *a = mesh == MESH_DUAL ? 1 - q : -q;
            *b = mesh == MESH_TRIANGLE ? p + q : p;
            --*turns;
        } else {
            return false;
        }
    }
    return true;
}

lattice mesh_turn(mesh_kind mesh, lattice p, int turns)
{
    int one = mesh == MESH_DUAL; /* the centre is (1/2, 1/2) there */
    for (; turns > 0; turns--)
        p = (lattice){one - p.b, mesh == MESH_TRIANGLE ? p.a + p.b : p.a};
    for (; turns < 0; turns++)
        p = (lattice){mesh == MESH_TRIANGLE ? p.a + p.b : p.b, one - p.a};
    return p;
}

int mesh_distance(mesh_kind mesh, int a, int b)
{
    int p = a < 0 ? -a : a, q = b < 0 ? -b : b;
    return mesh == MESH_TRIANGLE ? lattice_distance(a, b) : p > q ? p : q;
}

lattice mesh_rotate_mask(mesh_kind mesh, lattice p)
{
    lattice q = {mesh == MESH_DUAL ? -p.b - 1 : -p.b, mesh == MESH_TRIANGLE ? p.a + p.b : p.a};
    return q;
}

/* For dual meshes the label i stands for the offset i + 1/2, which reaches as far as -1 - i does. */
static int reach_along(mesh_kind mesh, int i)
{
    return i < 0 ? -i : mesh == MESH_DUAL ? i + 1 : i;
}

int mesh_mask_reach(mesh_kind mesh, lattice p)
{
    int i = reach_along(mesh, p.a), j = reach_along(mesh, p.b);
    return mesh == MESH_TRIANGLE ? lattice_distance(p.a, p.b) : i > j ? i : j;
}
