/* graded_net.c: a new value is the sum of its parts, each with a grade of its own. */
#include "graded_net.h"

#include <stdlib.h>
#include <string.h>

bool graded_net_make(graded_net *z, mesh_kind mesh, int rings)
{
    int size = graded_size(rings);
    *z = (graded_net){mesh, rings, malloc((size_t)size * sizeof *z->grade), number_array_new((size_t)size)};
    for (int i = 0; z->grade && i < size; i++)
        z->grade[i] = GRADED_ABSENT;
    return z->grade && z->value;
}

void graded_net_free(graded_net *z)
{
    if (z->value)
        number_array_free(z->value, (size_t)graded_size(z->rings));
    free(z->grade);
    memset(z, 0, sizeof *z);
}

void graded_scale(number *z, const number *kappa, int power, long prec)
{
    number factor;
    number_init(&factor);
    number_one(&factor);
    for (int i = 0; i < power; i++)
        number_mul(&factor, &factor, kappa, prec);
    number_mul(z, &factor, z, prec);
    number_clear(&factor);
}

/* ---- the parts of a new value ---- */

/* kappa^grade times the weight, one of the two, times the old value at `at`. */
typedef struct {
    int grade, at;
    const number *weight;
    const rational *exact_weight;
} part;

typedef struct {
    part *item;
    int count;
} parts;

static void add_part(parts *z, const graded_net *old_net, int at, int shift, const number *weight, const rational *exact_weight)
{
    if (old_net->grade[at] != GRADED_ABSENT)
        z->item[z->count++] = (part){old_net->grade[at] + shift, at, weight, exact_weight};
}

/* Term by term: (k/unit)^i is kappa^-i. */
static void add_growing_parts(parts *z, const graded_net *old_net, int at, const laurent_value *w)
{
    for (int i = laurent_value_high(w); i >= laurent_value_low(w); i--)
        if (!rational_is_zero(laurent_value_at(w, i)))
            add_part(z, old_net, at, -i, NULL, laurent_value_at(w, i));
}

/* What subdivisions call `at`. */
static int place_of(int at)
{
    return at == CENTRE_INDEX ? GRADED_CENTRE : 1 + at;
}

static int place_of_source(const graded_net *old_net, const source *s)
{
    return s->kind == SOURCE_CENTRE ? GRADED_CENTRE : graded_index(old_net, s->point.a, s->point.b);
}

/* T = 1, so that sectors do not count.  weights: of the centre's rule; NULL at other points. */
static void list_parts(parts *z, const graded_net *old_net, const step_stencils *s, const point_stencil *p, const centre_weights *weights)
{
    z->count = 0;
    for (size_t i = 0; !p->rule && i < p->count; i++)
        add_part(z, old_net, place_of(s->term[p->first + i].at), 0, s->term[p->first + i].weight, NULL);
    for (int i = 0; p->rule && i < p->rule->count; i++) {
        int at = place_of_source(old_net, &p->rule->rule->sources[i]);
        if (weights)
            add_growing_parts(z, old_net, at, &weights->weight[i]);
        else
            add_part(z, old_net, at, 0, &p->rule->matrix[i].xx, NULL);
    }
}

static size_t most_parts(const step_stencils *s)
{
    return s->terms + SCHEME_MAX_SOURCES * (2 * LAURENT_MAX_DEGREE + 1);
}

/* ---- their sum ---- */

/* kappa^(grade - least) weight value */
static void evaluate(number *z, const part *p, const graded_net *old_net, int least, const number *kappa, long prec)
{
    if (p->weight)
        number_set(z, p->weight);
    else
        number_set_rational(z, p->exact_weight, prec);
    number_mul(z, z, &old_net->value[p->at], prec);
    if (p->grade > least)
        graded_scale(z, kappa, p->grade - least, prec);
}

/* false: no memory. */
static bool add_up(graded_net *new_net, int at, const parts *p, const graded_net *old_net, const number *kappa, long prec)
{
    number *sum = &new_net->value[at], x;
    int least = GRADED_ABSENT;
    number_init(&x);
    number_zero(sum);
    for (int i = 0; i < p->count; i++)
        least = p->item[i].grade < least ? p->item[i].grade : least;
    for (int i = 0; i < p->count; i++) {
        evaluate(&x, &p->item[i], old_net, least, kappa, prec);
        number_add(sum, sum, &x, prec);
    }
    new_net->grade[at] = least;
    number_clear(&x);
    return !number_lacks_memory(sum);
}

/* ---- steps ---- */

static subdivide_status apply_step(graded_net *new_net, const graded_net *old_net, const step_stencils *s, const centre_weights *weights, const number *kappa, long prec)
{
    parts p = {malloc(most_parts(s) * sizeof *p.item), 0};
    bool ok = p.item != NULL;
    for (int i = 0; ok && i < s->points; i++) {
        list_parts(&p, old_net, s, &s->point[i], NULL);
        ok = add_up(new_net, place_of(s->point[i].at), &p, old_net, kappa, prec);
    }
    if (ok && s->to != MESH_DUAL && s->has_centre) {
        list_parts(&p, old_net, s, &s->centre, weights);
        ok = add_up(new_net, GRADED_CENTRE, &p, old_net, kappa, prec);
    }
    free(p.item);
    if (!ok)
        return SUBDIVIDE_NO_MEMORY;
    return s->to != MESH_DUAL && !s->has_centre ? SUBDIVIDE_NO_CENTRE_RULE : SUBDIVIDE_OK;
}

subdivide_status graded_subdivide(graded_net *new_net, const graded_net *old_net, const subdivision *z, const centre_weights *weights, const number *kappa)
{
    int steps = z->numbers->scheme->step_count;
    graded_net between[2];
    subdivide_status result = SUBDIVIDE_OK;
    memset(between, 0, sizeof between);
    memset(new_net, 0, sizeof *new_net);
    for (int i = 0; result == SUBDIVIDE_OK && i < steps; i++) {
        const graded_net *from = i ? &between[(i - 1) % 2] : old_net;
        graded_net *to = i == steps - 1 ? new_net : &between[i % 2];
        graded_net_free(to);
        if (!graded_net_make(to, z->step[i].to, z->step[i].rings))
            result = SUBDIVIDE_NO_MEMORY;
        else
            result = apply_step(to, from, &z->step[i], &weights[i], kappa, z->numbers->prec);
    }
    graded_net_free(&between[0]);
    graded_net_free(&between[1]);
    return result;
}
