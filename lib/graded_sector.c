/* graded_sector.c: the eigenvector's net, ring by ring, and one power of kappa for all. */
#include "graded.h"

#include <string.h>

static bool begin(graded_net *z, const block *b, const graded_choice *c, const number *box)
{
    bool ok = graded_net_make(z, b->mesh, b->rings);
    for (int i = 0; ok && i < b->n; i++) {
        int at = graded_place(z, &b->unknowns[i]);
        z->grade[at] = c->grade[i];
        number_set(&z->value[at], &box[i]);
    }
    return ok;
}

static void copy(graded_net *to, int at, const graded_net *from, int from_at)
{
    to->grade[at] = from->grade[from_at];
    number_set(&to->value[at], &from->value[from_at]);
}

/* V = S V / eigenvalue beyond the rings that `old` has; its values up to there. */
static void settle(graded_net *z, const graded_net *old, const number *eigenvalue, int degree, long prec)
{
    copy(z, GRADED_CENTRE, old, GRADED_CENTRE);
    for (int a = 1; a <= z->rings; a++)
        for (int b = 0; b <= z->rings; b++) {
            int at = graded_index(z, a, b);
            if (!mesh_in_sector(z->mesh, a, b) || mesh_ring(z->mesh, a, b) > z->rings)
                continue;
            if (mesh_ring(z->mesh, a, b) <= old->rings)
                copy(z, at, old, graded_index(old, a, b));
            else if (z->grade[at] != GRADED_ABSENT) {
                number_div(&z->value[at], &z->value[at], eigenvalue, prec);
                z->grade[at] += degree;
            }
        }
}

/* As far as the known rings allow, towards `rings`. */
static block_status extend(graded_net *net, const graded_block *b, const graded_choice *c, const number *eigenvalue, int rings)
{
    int upto = scheme_rings_reached(b->numbers->scheme, net->rings, rings);
    graded_net wide;
    subdivision s;
    subdivide_status result = subdivision_make(&s, b->numbers, block_is_planar(b->plain), net->rings, upto);
    memset(&wide, 0, sizeof wide);
    if (result == SUBDIVIDE_OK)
        result = graded_subdivide(&wide, net, &s, b->weights, &b->kappa);
    if (result == SUBDIVIDE_OK)
        settle(&wide, net, eigenvalue, c->degree, b->numbers->prec);
    subdivision_free(&s);
    graded_net_free(net);
    *net = wide;
    return block_from_subdivide(result);
}

/* ---- one power for all ---- */

/* The least grade of the values that the boundary needs.  false: one lies opposite. */
static bool find_least(int *least, const graded_net *net, bool regular, const ring *r)
{
    *least = GRADED_ABSENT;
    for (int i = 0; i < r->boundary_count; i++) {
        const element *e = &r->boundary[i];
        for (int j = 0; j < r->stencil[RING_VALUES].window[e->type].count; j++) {
            lattice p = r->stencil[RING_VALUES].window[e->type].point[j];
            int a = e->a + p.a, b = e->b + p.b, turns, at = GRADED_CENTRE;
            if (!mesh_is_centre(net->mesh, a, b)) {
                if (!mesh_reduce(net->mesh, regular, &a, &b, &turns))
                    return false;
                at = graded_index(net, a, b);
            }
            *least = net->grade[at] < *least ? net->grade[at] : *least;
        }
    }
    return true;
}

/* Where the grade is less, no window has the value. */
static void level_value(number *z, graded_net *net, int at, int least, const graded_block *b)
{
    int grade = net->grade[at];
    if (grade == GRADED_ABSENT || grade < least)
        return;
    number_swap(z, &net->value[at]);
    graded_scale(z, &b->kappa, grade - least, b->numbers->prec);
}

static void level(sector_net *z, graded_net *net, int least, const graded_block *b)
{
    level_value(&z->centre, net, GRADED_CENTRE, least, b);
    for (int i = 0; i < sector_size(net->rings); i++)
        level_value(&z->x[i], net, 1 + i, least, b);
}

block_status graded_sector_net(sector_net *z, const graded_block *b, const graded_choice *c, const number *box, const ring *r)
{
    bool regular = block_is_planar(b->plain);
    block_status result = BLOCK_OK;
    graded_net net;
    int least;
    memset(z, 0, sizeof *z);
    if (!begin(&net, b->plain, c, box))
        result = BLOCK_NO_MEMORY;
    while (result == BLOCK_OK && net.rings < r->rings)
        result = extend(&net, b, c, &box[b->plain->n], r->rings);
    if (result == BLOCK_OK && !find_least(&least, &net, regular, r))
        result = BLOCK_OPPOSITE;
    if (result == BLOCK_OK && !sector_net_make(z, b->plain->mesh, regular, net.rings, NULL))
        result = BLOCK_NO_MEMORY;
    if (result == BLOCK_OK)
        level(z, &net, least, b);
    graded_net_free(&net);
    return result;
}
