/* Graded values and nets: certificate-valences.md, section 6, "Growing without bound". */

#include "graded_net.h"

#include "answer.h"

#include <limits.h>

/* kappa
 * ----- */

struct affine kappa_power(struct grading *s, int n)
{
    if (n > MAX_KAPPA)
        cannot_check("the checker has no power %d of q/k", n);
    for (; s->powers <= n; s->powers++)
        s->kappa[s->powers] = affine_mul(s->kappa[s->powers - 1], s->kappa[1], s->g);
    return s->kappa[n];
}

static void prepare_kappa(struct grading *s, int64_t q)
{
    struct span k = s->block->v->k;
    interval u = k.last == ENDLESS ? grid_from(0, s->g)
                                   : grid_from_rational(rational_from(q, k.last), s->g);

    u = interval_hull(u, grid_from_rational(rational_from(q, k.first), s->g));
    s->kappa[0] = affine_from_whole(1, s->g);
    s->kappa[1] = (struct affine) { interval_thin(interval_mid(u)),
                                    interval_thin(interval_rad(u)) };
    s->powers = 2;
}

/* b_c q^c for all weights */
static bool weigh_centre(struct laurent **out, const struct rule *rule,
                         const struct environment *e, int64_t q)
{
    struct laurent *w = allocate((size_t)rule->count, sizeof w[0]);

    if (!laurent_weights(w, rule, e))
        return false;
    for (int i = 0; i < rule->count; i++)
        laurent_rescale(&w[i], q);
    *out = w;
    return true;
}

bool grading_prepare(struct grading *out, const struct block *block, int64_t q)
{
    const struct valence *v = block->v;
    struct environment e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, v->g);

    *out = (struct grading) { .block = block, .g = v->g };
    prepare_kappa(out, q);
    for (int i = 0; i < v->scheme->steps; i++) {
        const struct active_rule *rule = valence_rule(&v->step[i], true, 0, 0);

        if (rule != NULL && !weigh_centre(&out->weight[i], rule->rule, &e, q))
            return false;
    }
    return true;
}

/* Nets
 * ---- */

struct graded_net graded_net_make(enum mesh mesh, int rings)
{
    struct graded_net out = { .mesh = mesh, .rings = rings };

    out.value = allocate((size_t)(rings + 1) * (size_t)(rings + 1), sizeof out.value[0]);
    return out;
}

/* Turns the label into the sector; T = 1. */
struct graded_value *graded_net_at(const struct graded_net *net, int a, int b)
{
    enum place place;

    do
        place = label_turn(net->mesh, &a, &b);
    while (place == BEHIND || place == BEFORE);
    if (place == OPPOSITE)
        cannot_check("a rule uses a point opposite to its sector");
    if (place == IN_SECTOR && label_ring(net->mesh, a, b) > net->rings)
        cannot_check("the checker looks for a point outside of its net");
    return &net->value[a * (net->rings + 1) + b];
}

/* Sums
 * ---- */

/* w kappa^-c times the value */
static void add_term(struct grading *s, interval w, int c, const struct graded_value *value)
{
    if (value->present)
        s->term[s->terms++] = (struct graded_value) { true, value->e - c,
                                                      affine_scale(w, value->v, s->g) };
}

static struct graded_value sum_of_terms(struct grading *s)
{
    struct graded_value out = { s->terms > 0, INT_MAX, affine_from_whole(0, s->g) };

    for (int i = 0; i < s->terms; i++)
        out.e = s->term[i].e < out.e ? s->term[i].e : out.e;
    for (int i = 0; i < s->terms; i++)
        out.v = affine_add(out.v, affine_mul(kappa_power(s, s->term[i].e - out.e),
                                             s->term[i].v, s->g));
    return out;
}

/* New values
 * ---------- */

static void add_by_mask(struct grading *s, const struct graded_net *old,
                        const struct stencil *mask, bool centre, int a, int b)
{
    int class = stencil_class(mask, a, b);

    for (int i = mask->first[class]; i < mask->first[class + 1]; i++) {
        const struct stencil_entry *e = &mask->entry[i];

        if (centre && (e->a != 0 || e->b != 0))
            cannot_check("the centre has no rule, and the mask does not give it its old value");
        add_term(s, e->weight, 0, graded_net_at(old, (a - e->a) / mask->dilation,
                                                (b - e->b) / mask->dilation));
    }
}

static const struct graded_value *value_of_source(const struct graded_net *old,
                                                  const struct source *source)
{
    return source->kind == SOURCE_CENTRE ? graded_net_at(old, 0, 0)
                                         : graded_net_at(old, source->a, source->b);
}

static void add_by_rule(struct grading *s, const struct graded_net *old,
                        const struct active_rule *rule)
{
    for (int i = 0; i < rule->rule->count; i++)
        add_term(s, rule->weighted[i].weight.c, 0, value_of_source(old, &rule->rule->source[i]));
}

/* The centre's, with Laurent values for weights. */
static void add_by_laurent(struct grading *s, const struct graded_net *old,
                           const struct rule *rule, const struct laurent *weight)
{
    for (int i = 0; i < rule->count; i++) {
        for (int c = -LAURENT_DEGREE; c <= LAURENT_DEGREE; c++) {
            rational w = laurent_at(&weight[i], c);

            if (w.num.sign != 0)
                add_term(s, grid_from_rational(w, s->g), c,
                         value_of_source(old, &rule->source[i]));
        }
    }
}

static struct graded_value new_value(struct grading *s, const struct graded_net *old, int step,
                                     bool centre, int a, int b)
{
    const struct active_step *active = &s->block->v->step[step];
    const struct active_rule *rule = valence_rule(active, centre, a, b);

    s->terms = 0;
    if (rule == NULL)
        add_by_mask(s, old, &active->stencil, centre, a, b);
    else if (centre)
        add_by_laurent(s, old, rule->rule, s->weight[step]);
    else
        add_by_rule(s, old, rule);
    return sum_of_terms(s);
}

static struct graded_net apply_step(struct grading *s, const struct graded_net *old, int step,
                                    int rings)
{
    struct graded_net out = graded_net_make(old->mesh, rings);

    *graded_net_at(&out, 0, 0) = new_value(s, old, step, true, 0, 0);
    for (int a = 1; a <= rings; a++)
        for (int b = 0; label_ring(out.mesh, a, b) <= rings; b++)
            *graded_net_at(&out, a, b) = new_value(s, old, step, false, a, b);
    return out;
}

struct graded_net graded_net_subdivide(struct grading *s, const struct graded_net *old, int rings)
{
    const struct scheme *scheme = s->block->v->scheme;
    int needs[MAX_STEPS + 1];
    struct graded_net net = *old;

    scheme_list_needs(needs, scheme, rings);
    for (int i = 0; i < scheme->steps; i++)
        net = apply_step(s, &net, i, needs[i + 1]);
    return net;
}
