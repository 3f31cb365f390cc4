/* ring.c: the smallest ring on which all rules are regular, in one planar chart. */
#include "ring.h"

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
static int reach_of(const ring *z)
{
    static const lattice none = {0, 0}, e1 = {1, 0}, e2 = {0, 1};
    int reach = element_stencil_reach(&z->stencil[RING_VALUES], ELEMENT_EDGE, none);
    for (int type = ELEMENT_UP; type <= ELEMENT_DOWN; type++) {
        reach = larger(reach, element_stencil_reach(&z->stencil[RING_FIRST], (element_type)type, e1));
        reach = larger(reach, element_stencil_reach(&z->stencil[RING_SECOND], (element_type)type, e2));
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

static bool list_elements(ring *z)
{
    int r = z->radius;
    z->elements = malloc((size_t)(4 * r * r + 4 * r) * sizeof *z->elements);
    z->boundary = malloc((size_t)(2 * r) * sizeof *z->boundary);
    if (!z->elements || !z->boundary)
        return false;
    z->element_count = list(z->elements, ELEMENT_UP, r, 2 * r - 1);
    z->element_count += list(z->elements + z->element_count, ELEMENT_DOWN, r - 1, 2 * r - 2);
    z->boundary_count = list(z->boundary, ELEMENT_EDGE, 2 * r - 1, 2 * r - 1);
    return true;
}

/* The farthest ring on which a rule replaces the mask, whatever the valence: points used after the first subdivision
   must lie beyond it. */
static int farthest_rule(const scheme *s)
{
    int farthest = 0;
    for (int i = 0; i < s->steps[0].rule_count; i++) {
        const rule *r = &s->steps[0].rules[i];
        farthest = larger(farthest, r->at_centre ? 0 : mesh_ring(s->mesh, r->point.a, r->point.b));
    }
    return farthest;
}

bool ring_make(ring *z, const scheme *s, const regular_masks *masks)
{
    int reach;
    z->mask[RING_VALUES] = &s->mask;
    z->mask[RING_FIRST] = &masks->derivative[0];
    z->mask[RING_SECOND] = &masks->derivative[1];
    z->nonnegative = true;
    for (int i = 0; i < RING_NETS; i++) {
        z->nonnegative = z->nonnegative && laurent_is_nonnegative(z->mask[i]);
        if (!element_stencil_make(&z->stencil[i], z->mask[i]))
            return false;
    }
    reach = reach_of(z);
    z->radius = 1;
    while (reach > z->radius || reach + s->steps[0].reach >= 2 * (z->radius + 1) || reach + farthest_rule(s) >= 2 * z->radius)
        z->radius++;
    z->rings = 2 * z->radius + reach;
    return list_elements(z);
}
