/* subdivision.c: which points a mask refers to, then a net is mapped point by point. */
#include "subdivision.h"

#include "growing.h"

#include <stdlib.h>
#include <string.h>

/* ---- stencils ---- */

static const rule_numbers *find_rule(const step_numbers *s, bool at_centre, int a, int b)
{
    for (int i = 0; i < s->rule_count; i++) {
        const rule *r = s->rules[i].rule;
        if (r->at_centre == at_centre && (at_centre || (r->point.a == a && r->point.b == b)))
            return &s->rules[i];
    }
    return NULL;
}

/* Appends the term of a weight for the old point (a,b). */
static subdivide_status add_term(step_stencils *z, const sector_net *old_net, const number *weight, int a, int b)
{
    mask_term *room = growing_room(z->term, z->terms, &z->capacity, sizeof *room);
    mask_term t = {weight, CENTRE_INDEX, 0};
    if (!room)
        return SUBDIVIDE_NO_MEMORY;
    z->term = room;
    if (!mesh_is_centre(z->from, a, b)) {
        if (!mesh_reduce(z->from, old_net->regular, &a, &b, &t.turns) || mesh_ring(z->from, a, b) > old_net->rings)
            return SUBDIVIDE_OPPOSITE;
        t.at = sector_index(old_net, a, b);
    }
    z->term[z->terms++] = t;
    return SUBDIVIDE_OK;
}

/* The least number >= low that differs from a by a multiple of dilation. */
static long first_congruent(long low, long a, long dilation)
{
    long rest = (a - low) % dilation;
    return low + (rest < 0 ? rest + dilation : rest);
}

/* The old points p that contribute to (a,b) are those with (a,b) - dilation p in the mask's box. */
static subdivide_status add_mask_terms(step_stencils *z, const sector_net *old_net, const mask_numbers *mask, int dilation, int a, int b)
{
    const laurent *l = mask->mask;
    subdivide_status s = SUBDIVIDE_OK;
    for (long i = first_congruent(l->a0, a, dilation); i < l->a0 + l->na; i += dilation)
        for (long j = first_congruent(l->b0, b, dilation); s == SUBDIVIDE_OK && j < l->b0 + l->nb; j += dilation)
            if (!laurent_is_zero_at(l, i, j))
                s = add_term(z, old_net, mask_numbers_at(mask, i, j), (int)(a - i) / dilation, (int)(b - j) / dilation);
    return s;
}

/* Without a rule the centre keeps its value, if the mask says so and nothing else. */
static bool mask_keeps_centre(const laurent *mask, int dilation)
{
    for (long a = mask->a0; a < mask->a0 + mask->na; a++)
        for (long b = mask->b0; b < mask->b0 + mask->nb; b++)
            if (a % dilation == 0 && b % dilation == 0 && (a || b) && !laurent_is_zero_at(mask, a, b))
                return false;
    return true;
}

static bool no_rule_holds(const scheme_numbers *numbers)
{
    for (int i = 0; i < numbers->scheme->step_count; i++)
        if (numbers->steps[i].rule_count)
            return false;
    return true;
}

/* At the centre of plain nets: has_centre stays false if neither a rule nor the mask says what it becomes. */
static subdivide_status make_centre(step_stencils *z, const sector_net *old_net, const scheme_numbers *numbers, const scheme_step *step, const step_numbers *n)
{
    subdivide_status s = SUBDIVIDE_OK;
    z->centre = (point_stencil){CENTRE_INDEX, find_rule(n, true, 0, 0), z->terms, 0};
    z->has_centre = z->centre.rule != NULL;
    if (z->to == MESH_DUAL || z->has_centre)
        return s;
    z->has_centre = true;
    if (z->from != MESH_DUAL && mask_keeps_centre(&step->mask, step->dilation))
        s = add_term(z, old_net, mask_numbers_at(&n->mask, 0, 0), 0, 0);
    else if (numbers->any_mask && old_net->regular && no_rule_holds(numbers))
        s = add_mask_terms(z, old_net, &n->mask, step->dilation, 0, 0);
    else
        z->has_centre = false;
    z->centre.count = z->terms - z->centre.first;
    return s;
}

/* new_net and old_net say how many rings there are, and have no values. */
static subdivide_status make_stencils(step_stencils *z, const sector_net *new_net, const sector_net *old_net, const scheme_numbers *numbers, const scheme_step *step, const step_numbers *n)
{
    subdivide_status s = SUBDIVIDE_OK;
    z->from = step->from;
    z->to = step->to;
    z->rings = new_net->rings;
    z->point = malloc((size_t)sector_size(z->rings) * sizeof *z->point);
    if (!z->point)
        return SUBDIVIDE_NO_MEMORY;
    for (int a = 1; a <= z->rings; a++)
        for (int b = z->to == MESH_DUAL; s == SUBDIVIDE_OK && b <= z->rings; b++) {
            point_stencil *p = &z->point[z->points];
            if (mesh_ring(z->to, a, b) > z->rings)
                continue;
            *p = (point_stencil){sector_index(new_net, a, b), find_rule(n, false, a, b), z->terms, 0};
            if (!p->rule)
                s = add_mask_terms(z, old_net, &n->mask, step->dilation, a, b);
            p->count = z->terms - p->first;
            z->points++;
        }
    return s == SUBDIVIDE_OK ? make_centre(z, old_net, numbers, step, n) : s;
}

/* The rings that each step must produce, so that the last has `rings`. */
static void plan_rings(int *rings_after, const scheme *s, int rings)
{
    for (int i = s->step_count - 1; i >= 0; i--) {
        rings_after[i] = rings;
        rings = scheme_step_rings_needed(&s->steps[i], rings);
    }
}

subdivide_status subdivision_make(subdivision *z, const scheme_numbers *numbers, bool regular, int old_rings, int rings)
{
    const scheme *s = numbers->scheme;
    int rings_after[SCHEME_MAX_STEPS];
    sector_net from = {.regular = regular, .rings = old_rings};
    subdivide_status result = SUBDIVIDE_OK;
    memset(z, 0, sizeof *z);
    z->numbers = numbers;
    z->regular = regular;
    plan_rings(rings_after, s, rings);
    for (int i = 0; result == SUBDIVIDE_OK && i < s->step_count; i++) {
        sector_net to = {.regular = regular, .rings = rings_after[i]};
        result = make_stencils(&z->step[i], &to, &from, numbers, &s->steps[i], &numbers->steps[i]);
        from = to;
    }
    return result;
}

void subdivision_free(subdivision *z)
{
    for (int i = 0; i < SCHEME_MAX_STEPS; i++) {
        free(z->step[i].point);
        free(z->step[i].term);
    }
    memset(z, 0, sizeof *z);
}

/* ---- applying ---- */

static sector_status apply_rule(number *x, number *y, const rule_numbers *r, const sector_net *old_net, long prec)
{
    sector_status s = SECTOR_OK;
    number p, q;
    number_init(&p);
    number_init(&q);
    number_zero(x);
    number_zero(y);
    for (int i = 0; s == SECTOR_OK && i < r->count; i++) {
        if (r->rule->sources[i].kind == SOURCE_CENTRE) {
            number_addmul(x, &r->matrix[i].xx, &old_net->centre, prec); /* 0 unless the net is plain */
            number_addmul(y, &r->matrix[i].yy, &old_net->centre_y, prec);
            continue;
        }
        s = sector_value(&p, &q, old_net, r->point[i].a, r->point[i].b, prec);
        pair_matrix_apply(&p, &q, &r->matrix[i], prec);
        number_add(x, x, &p, prec);
        number_add(y, y, &q, prec);
    }
    number_clear(&p);
    number_clear(&q);
    return s;
}

/* Of unit nets most values are 0, which need not be multiplied. */
static void apply_terms(number *x, number *y, const step_stencils *s, const point_stencil *p, const sector_net *old_net, long prec)
{
    number turned[2];
    number_init(&turned[0]);
    number_init(&turned[1]);
    number_zero(x);
    number_zero(y);
    for (const mask_term *t = s->term + p->first, *end = t + p->count; t < end; t++) {
        const number *u = t->at == CENTRE_INDEX ? &old_net->centre : &old_net->x[t->at];
        const number *v = t->at == CENTRE_INDEX ? &old_net->centre_y : &old_net->y[t->at];
        bool is_real = number_is_zero(v) == TRUTH_TRUE;
        if (is_real && number_is_zero(u) == TRUTH_TRUE)
            continue;
        if (old_net->twist && t->turns) {
            number_set(&turned[0], u);
            number_set(&turned[1], v);
            twist_apply(&turned[0], &turned[1], old_net->twist, t->turns, prec);
            u = &turned[0];
            v = &turned[1];
            is_real = false;
        }
        number_addmul(x, t->weight, u, prec);
        if (!is_real)
            number_addmul(y, t->weight, v, prec);
    }
    number_clear(&turned[0]);
    number_clear(&turned[1]);
}

static subdivide_status apply_to_point(number *x, number *y, const step_stencils *s, const point_stencil *p, const sector_net *old_net, long prec)
{
    if (!p->rule)
        apply_terms(x, y, s, p, old_net, prec);
    else if (apply_rule(x, y, p->rule, old_net, prec) != SECTOR_OK)
        return SUBDIVIDE_OPPOSITE;
    return number_lacks_memory(x) || number_lacks_memory(y) ? SUBDIVIDE_NO_MEMORY : SUBDIVIDE_OK;
}

/* There is no centre, or 0 there, or it has a value. */
static subdivide_status apply_to_centre(sector_net *new_net, const sector_net *old_net, const step_stencils *s, long prec)
{
    if (s->to == MESH_DUAL || new_net->twist)
        return SUBDIVIDE_OK;
    if (!s->has_centre)
        return SUBDIVIDE_NO_CENTRE_RULE;
    return apply_to_point(&new_net->centre, &new_net->centre_y, s, &s->centre, old_net, prec);
}

static subdivide_status apply_step(sector_net *new_net, const sector_net *old_net, const step_stencils *s, long prec)
{
    subdivide_status result = SUBDIVIDE_OK;
    for (int i = 0; result == SUBDIVIDE_OK && i < s->points; i++)
        result = apply_to_point(&new_net->x[s->point[i].at], &new_net->y[s->point[i].at], s, &s->point[i], old_net, prec);
    return result == SUBDIVIDE_OK ? apply_to_centre(new_net, old_net, s, prec) : result;
}

subdivide_status subdivision_apply(sector_net *new_net, const sector_net *old_net, const subdivision *z)
{
    int steps = z->numbers->scheme->step_count;
    sector_net between[2];
    subdivide_status result = SUBDIVIDE_OK;
    memset(between, 0, sizeof between);
    memset(new_net, 0, sizeof *new_net);
    for (int i = 0; result == SUBDIVIDE_OK && i < steps; i++) {
        const sector_net *from = i ? &between[(i - 1) % 2] : old_net;
        sector_net *to = i == steps - 1 ? new_net : &between[i % 2];
        sector_net_free(to);
        if (!sector_net_make(to, z->step[i].to, z->regular, z->step[i].rings, old_net->twist))
            result = SUBDIVIDE_NO_MEMORY;
        else
            result = apply_step(to, from, &z->step[i], z->numbers->prec);
    }
    sector_net_free(&between[0]);
    sector_net_free(&between[1]);
    return result;
}

subdivide_status scheme_subdivide(sector_net *new_net, const sector_net *old_net, const scheme_numbers *numbers, int rings)
{
    subdivision z;
    subdivide_status s = subdivision_make(&z, numbers, old_net->regular, old_net->rings, rings);
    memset(new_net, 0, sizeof *new_net);
    if (s == SUBDIVIDE_OK)
        s = subdivision_apply(new_net, old_net, &z);
    subdivision_free(&z);
    return s;
}
