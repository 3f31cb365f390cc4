/* ring.c: the smallest ring on which all rules are regular, in one planar chart. */
#include "ring.h"

#include "influence.h"

#include <stdlib.h>
#include <string.h>

void ring_init(ring *z)
{
    memset(z, 0, sizeof *z);
}

void ring_clear(ring *z)
{
    for (int i = 0; i < RING_NETS; i++)
        element_stencil_clear(&z->stencil[i]);
    free(z->elements);
    free(z->boundary);
    ring_init(z);
}

static int larger(int x, int y)
{
    return x > y ? x : y;
}

/* omega: how far from its element a used point can be. */
static int reach_of(const ring *z, mesh_kind mesh)
{
    static const lattice none = {0, 0}, e1 = {1, 0}, e2 = {0, 1};
    int reach = 0;
    for (int t = 0; t < ELEMENT_TYPES; t++) {
        element_type type = (element_type)t;
        if (!element_is_of(type, mesh))
            continue;
        if (element_is_segment(type)) {
            reach = larger(reach, element_stencil_reach(&z->stencil[RING_VALUES], type, none));
        } else {
            reach = larger(reach, element_stencil_reach(&z->stencil[RING_FIRST], type, e1));
            reach = larger(reach, element_stencil_reach(&z->stencil[RING_SECOND], type, e2));
        }
    }
    return reach;
}

/* The points (a,b) with a, b >= 0 and low <= a + b <= high, in order of a + b, then b. */
static int list(element *z, element_type type, int low, int high)
{
    int n = 0;
    for (int j = low; j <= high; j++)
        for (int b = 0; b <= j; b++)
            z[n++] = (element){type, j - b, b};
    return n;
}

static void list_triangles(ring *z)
{
    int r = z->radius;
    z->element_count = list(z->elements, ELEMENT_UP, r, 2 * r - 1);
    z->element_count += list(z->elements + z->element_count, ELEMENT_DOWN, r - 1, 2 * r - 2);
    z->boundary_count = list(z->boundary, ELEMENT_EDGE, 2 * r - 1, 2 * r - 1);
}

static void list_squares(ring *z)
{
    int r = z->radius, n = 0;
    for (int j = r; j < 2 * r; j++) {
        for (int b = 0; b < j; b++)
            z->elements[n++] = (element){ELEMENT_SQUARE, j, b};
        for (int a = j; a >= 0; a--)
            z->elements[n++] = (element){ELEMENT_SQUARE, a, j};
    }
    z->element_count = n;
    n = 0;
    for (int b = 0; b < 2 * r; b++)
        z->boundary[n++] = (element){ELEMENT_ALONG_SECOND, 2 * r, b};
    for (int a = 2 * r - 1; a >= 0; a--)
        z->boundary[n++] = (element){ELEMENT_ALONG_FIRST, a, 2 * r};
    z->boundary_count = n;
}

static bool list_elements(ring *z, mesh_kind mesh)
{
    size_t r = (size_t)z->radius;
    z->elements = malloc(3 * r * r * sizeof *z->elements); /* the area of the ring, in squares or in halves of them */
    z->boundary = malloc(4 * r * sizeof *z->boundary);
    if (!z->elements || !z->boundary)
        return false;
    if (mesh == MESH_TRIANGLE)
        list_triangles(z);
    else
        list_squares(z);
    return true;
}

/* h: how far the composed mask reaches. */
static int mask_reach(const scheme *s)
{
    int reach = 0;
    for (long a = s->mask.a0; a < s->mask.a0 + s->mask.na; a++)
        for (long b = s->mask.b0; b < s->mask.b0 + s->mask.nb; b++)
            if (!laurent_is_zero_at(&s->mask, a, b))
                reach = larger(reach, mesh_mask_reach(s->mesh, (lattice){(int)a, (int)b}));
    return reach;
}

/* Is a ring from r on far enough out? */
static bool is_far_enough(mesh_kind mesh, int r, int omega, int h, int farthest)
{
    bool never_opposite = mesh == MESH_TRIANGLE ? omega <= r && omega + h < 2 * (r + 1) : omega < r && omega + h < 2 * r;
    return never_opposite && omega + farthest < 2 * r;
}

bool ring_make(ring *z, const scheme *s, const regular_masks *masks)
{
    int omega, h = mask_reach(s), farthest;
    z->mask[RING_VALUES] = &s->mask;
    z->mask[RING_FIRST] = &masks->derivative[0];
    z->mask[RING_SECOND] = &masks->derivative[1];
    z->nonnegative = true;
    for (int i = 0; i < RING_NETS; i++) {
        z->nonnegative = z->nonnegative && laurent_is_nonnegative(z->mask[i]);
        if (!element_stencil_make(&z->stencil[i], s->mesh, z->mask[i]))
            return false;
    }
    if (!influence_farthest(&farthest, s))
        return false;
    omega = reach_of(z, s->mesh);
    z->radius = 1;
    while (!is_far_enough(s->mesh, z->radius, omega, h, farthest))
        z->radius++;
    z->rings = 2 * z->radius + omega;
    return list_elements(z, s->mesh);
}
