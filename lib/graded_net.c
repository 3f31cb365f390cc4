/* graded_net.c: further rings, label by label, each with its own grade. */
#include "graded.h"

#include "reciprocal.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* The net as it grows: grade[at] belongs to the value net->x[at]. */
typedef struct {
    sector_net *net;
    int *grade, grade_of_centre;
    const graded_block *block;
    const number *eigenvalue;
    int degree;
    long prec;
} growth;

static int grade_at(const growth *g, int at)
{
    return at == CENTRE_INDEX ? g->grade_of_centre : g->grade[at];
}

/* ---- what a new value is made of ---- */

static int count_of(const point_stencil *p)
{
    return p->rule ? p->rule->count : (int)p->count;
}

/* Part i: T = 1, so that sectors do not count. */
static mask_term part_of(const growth *g, const step_stencils *s, const point_stencil *p, int i)
{
    const rule_numbers *r = p->rule;
    if (!r)
        return s->term[p->first + (size_t)i];
    return (mask_term){&r->matrix[i].xx, r->rule->sources[i].kind == SOURCE_CENTRE ? CENTRE_INDEX : sector_index(g->net, r->point[i].a, r->point[i].b), 0};
}

static int least_grade(const growth *g, const step_stencils *s, const point_stencil *p)
{
    int least = INT_MAX;
    for (int i = 0; i < count_of(p); i++) {
        int e = grade_at(g, part_of(g, s, p, i).at);
        least = e < least ? e : least;
    }
    return least;
}

/* z *= kappa^power */
static void scale(number *z, const growth *g, int power)
{
    number factor;
    number_init(&factor);
    number_one(&factor);
    for (int i = 0; i < power; i++)
        number_mul(&factor, &factor, &g->block->kappa, g->prec);
    number_mul(z, &factor, z, g->prec);
    number_clear(&factor);
}

/* V(y) = sum of kappa^(e(y') - least) w V(y') over L, and its grade. */
static void extend_to(growth *g, const step_stencils *s, const point_stencil *p)
{
    int least = least_grade(g, s, p);
    number *sum = &g->net->x[p->at], part;
    number_init(&part);
    number_zero(sum);
    for (int i = 0; i < count_of(p); i++) {
        mask_term t = part_of(g, s, p, i);
        number_mul(&part, t.weight, t.at == CENTRE_INDEX ? &g->net->centre : &g->net->x[t.at], g->prec);
        scale(&part, g, grade_at(g, t.at) - least);
        number_add(sum, sum, &part, g->prec);
    }
    number_div(sum, sum, g->eigenvalue, g->prec);
    g->grade[p->at] = g->degree + least;
    number_clear(&part);
}

/* ---- ring by ring ---- */

static int ring_of(const sector_net *net, const point_stencil *p)
{
    return mesh_ring(net->mesh, p->at / (net->rings + 1) + 1, p->at % (net->rings + 1));
}

/* Beyond the rings of the block each ring needs only those before it (scheme_closed_rings). */
static void extend(growth *g, const step_stencils *s, int known)
{
    for (int j = known + 1; j <= g->net->rings; j++)
        for (int i = 0; i < s->points; i++)
            if (ring_of(g->net, &s->point[i]) == j)
                extend_to(g, s, &s->point[i]);
}

static void set_grades(growth *g, const graded_choice *c)
{
    const block *b = g->block->plain;
    for (int i = 0; i < b->n; i++) {
        if (b->unknowns[i].kind == UNKNOWN_CENTRE)
            g->grade_of_centre = c->grade[i];
        else
            g->grade[sector_index(g->net, b->unknowns[i].a, b->unknowns[i].b)] = c->grade[i];
    }
}

/* ---- one power for all ---- */

/* Which values the boundary needs.  false: one lies opposite. */
static bool mark_windows(bool *needed, const sector_net *net, const ring *r)
{
    for (int i = 0; i < r->boundary_count; i++) {
        const element *e = &r->boundary[i];
        for (int j = 0; j < r->stencil[RING_VALUES].window[e->type].count; j++) {
            lattice p = r->stencil[RING_VALUES].window[e->type].point[j];
            int a = e->a + p.a, b = e->b + p.b, turns;
            if (!mesh_reduce(net->mesh, net->regular, &a, &b, &turns))
                return false;
            needed[sector_index(net, a, b)] = true;
        }
    }
    return true;
}

static void level(growth *g, const bool *needed)
{
    int size = sector_size(g->net->rings), least = INT_MAX;
    for (int i = 0; i < size; i++)
        least = needed[i] && g->grade[i] < least ? g->grade[i] : least;
    for (int i = 0; i < size; i++)
        if (needed[i])
            scale(&g->net->x[i], g, g->grade[i] - least);
}

static block_status grow(growth *g, const graded_choice *c, const number *box, const scheme_numbers *numbers, const ring *r, bool *needed)
{
    const block *b = g->block->plain;
    subdivision s;
    block_status result = block_from_subdivide(subdivision_make(&s, numbers, block_is_planar(b), g->net->rings, g->net->rings));
    if (result == BLOCK_OK) {
        block_net(g->net, b, box, NULL, g->prec);
        set_grades(g, c);
        extend(g, &s.step[0], b->rings);
        if (mark_windows(needed, g->net, r))
            level(g, needed);
        else
            result = BLOCK_OPPOSITE;
    }
    subdivision_free(&s);
    return result;
}

block_status graded_net_make(sector_net *net, const graded_block *b, const graded_choice *c, const number *box, const scheme_numbers *numbers, const ring *r)
{
    int rings = r->rings > b->plain->rings ? r->rings : b->plain->rings;
    growth g = {net, calloc((size_t)sector_size(rings), sizeof *g.grade), 0, b, &box[b->plain->n], c->degree, numbers->prec};
    bool *needed = calloc((size_t)sector_size(rings), sizeof *needed);
    block_status result = BLOCK_NO_MEMORY;
    if (sector_net_make(net, b->plain->mesh, block_is_planar(b->plain), rings, NULL) && g.grade && needed)
        result = grow(&g, c, box, numbers, r, needed);
    free(g.grade);
    free(needed);
    return result;
}
