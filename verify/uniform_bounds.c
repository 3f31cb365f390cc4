/* uniform_bounds.c: the thesis's constants, as far as they are bounds, and the norms of powers. */
#include "uniform_bounds.h"

#include "../lib/decomposition.h"

#include <string.h>

void uniform_bounds_init(uniform_bounds *z)
{
    memset(z, 0, sizeof *z);
    for (int i = 0; i < RING_NETS; i++) {
        rational_init(&z->constant[i]);
        norm_list_init(&z->contraction[i]);
    }
}

void uniform_bounds_clear(uniform_bounds *z)
{
    for (int i = 0; i < RING_NETS; i++) {
        rational_clear(&z->constant[i]);
        norm_list_clear(&z->contraction[i]);
    }
    uniform_bounds_init(z);
}

static const rational *constant_of(const comparison *c, int net)
{
    return net == RING_VALUES ? &c->values : &c->derivative[net - RING_FIRST];
}

/* What the decomposition gives is a bound because the least constant is not larger (lib/stability.md, 6). */
static bool find_constants(uniform_bounds *z, const problem *p)
{
    comparison least;
    decomposition thesis;
    bool ok;
    comparison_init(&least);
    decomposition_init(&thesis);
    ok = comparison_make(&least, &p->scheme->mask, &p->regular) && decomposition_make(&thesis, &p->scheme->mask, &p->regular);
    for (int i = 0; ok && i < RING_NETS; i++) {
        const rational *l = constant_of(&least, i), *t = constant_of(&thesis.printed, i);
        ok = rational_set(&z->constant[i], thesis.identity && rational_cmp(t, l) > 0 ? t : l);
    }
    comparison_clear(&least);
    decomposition_clear(&thesis);
    return ok;
}

static bool contains_extent(const laurent_extent *x, const laurent_extent *y)
{
    for (int f = 0; f < 3; f++)
        if (x->low[f] > y->low[f] || x->high[f] < y->high[f])
            return false;
    return true;
}

/* Windows of the mask must hold what the simple scheme needs, too. */
static bool find_extents(uniform_bounds *z, const problem *p)
{
    laurent simple;
    bool ok = true;
    laurent_init(&simple);
    for (int i = 0; ok && i < RING_NETS; i++) {
        laurent_extent e;
        ok = i == RING_VALUES ? comparison_values(&simple, p->regular.mesh) : comparison_derivative(&simple, p->regular.mesh, i - RING_FIRST);
        if (!ok)
            break;
        z->extent[i] = laurent_get_extent(p->geometry.mask[i]);
        e = laurent_get_extent(&simple);
        if (!contains_extent(&z->extent[i], &e))
            z->obstacle = "the mask does not reach as far as that of the linear scheme with which it is compared";
    }
    laurent_clear(&simple);
    return ok;
}

/* On the ring, values are needed round triangles, not round segments only. */
static bool has_room_for_values(const ring *r)
{
    static const lattice none = {0, 0};
    int omega = r->rings - 2 * r->radius;
    return element_stencil_reach(&r->stencil[RING_VALUES], ELEMENT_UP, none) <= omega
           && element_stencil_reach(&r->stencil[RING_VALUES], ELEMENT_DOWN, none) <= omega;
}

bool uniform_bounds_make(uniform_bounds *z, const problem *p)
{
    bool ok = true;
    z->obstacle = p->obstacle;
    if (p->scheme->mesh != MESH_TRIANGLE)
        z->obstacle = "the uniform method is for triangle meshes only";
    if (z->obstacle)
        return true;
    if (!has_room_for_values(&p->geometry))
        z->obstacle = "values round the ring are needed farther out than derivatives";
    for (int i = 0; ok && i < RING_NETS; i++) {
        regular_pair pair = regular_get_pair(MESH_TRIANGLE, i == RING_SECOND);
        for (int j = 0; j < 2; j++)
            z->direction[i][j] = regular_direction[i == RING_VALUES ? j : pair.direction[j]];
        ok = regular_contraction_list(&z->contraction[i], &p->regular, i - 1);
    }
    return ok && find_constants(z, p) && find_extents(z, p);
}
