/* Block 0 where it tends to block 1: certificate-valences.md, section 4, "Limit". */

#include "limit.h"

#include "answer.h"
#include "laurent.h"
#include "slopes.h"
#include "valences.h"

struct limit {
    const struct valence *v;
    const struct certificate *c;
    struct affine kappa;                           /* 1/k */
    struct environment e;
};

static noreturn void reject(const struct limit *l, const char *why)
{
    rejected(l->c->file, l->c->limit.record.line, "limit: %s", why);
}

/* z = w_0 + kappa (w_1 + kappa (...)) */
static struct affine polynomial(const struct limit *l, const struct laurent *w)
{
    int degree = 0, g = l->v->g;
    struct affine z;

    for (int i = 1; i <= LAURENT_DEGREE; i++) {
        if (laurent_at(w, i).num.sign != 0)
            reject(l, "a weight of the centre grows with k");
        if (laurent_at(w, -i).num.sign != 0)
            degree = i;
    }
    z = affine_from(grid_from_rational(laurent_at(w, -degree), g));
    for (int i = degree - 1; i >= 0; i--)
        z = affine_add(affine_mul(z, l->kappa, g),
                       affine_from(grid_from_rational(laurent_at(w, -i), g)));
    return z;
}

/* The weight w of a source; at k = inf all of it must be at the centre. */
static struct affine weight(const struct limit *l, const struct source *s,
                            const struct laurent *w)
{
    if (!rational_equals(laurent_at(w, 0), s->kind == SOURCE_CENTRE ? 1 : 0, 1))
        reject(l, "the centre does not keep its value at k = inf");
    return polynomial(l, w);
}

/* Affine weights in place of the intervals. */
static void weigh_centre(const struct limit *l, struct active_rule *rule)
{
    const struct rule *r = rule->rule;
    struct weighted *out = allocate((size_t)r->count, sizeof out[0]);
    struct laurent rest = laurent_constant(rational_from(1, 1)), w;

    for (int i = 0; i < r->count; i++) {
        out[i] = rule->weighted[i];
        if (i == r->rest)
            continue;
        if (!laurent_evaluate(&w, r->source[i].weight, &l->e))
            reject(l, "a weight of the centre is no polynomial in 1/k");
        laurent_subtract(&rest, &w);
        out[i].weight = weight(l, &r->source[i], &w);
    }
    out[r->rest].weight = weight(l, &r->source[r->rest], &rest);
    rule->weighted = out;
}

static void check_rule(const struct limit *l, const struct rule *r)
{
    for (int i = 0; i < r->count; i++)
        if (r->source[i].kind != SOURCE_ONE && r->source[i].kind != SOURCE_CENTRE)
            reject(l, "a rule has sources in all sectors");
}

/* Without a rule the mask must be 1 at (0,0), and 0 at the others of its class. */
static void check_centre_of_mask(const struct limit *l, const struct active_step *step)
{
    const struct stencil *s = &step->stencil;
    const struct mask *mask = &step->step->mask;
    const integer *own = mask_cell(mask, 0, 0);

    if (valence_rule(step, true, 0, 0) != NULL)
        return;
    if (own == NULL || integer_compare(*own, mask->denominator) != 0 ||
        s->first[1] - s->first[0] != 1)
        reject(l, "the mask does not keep the value at the centre");
}

static void prepare_step(const struct limit *l, struct active_step *step)
{
    struct active_rule *rules = allocate((size_t)step->rules, sizeof rules[0]);

    check_centre_of_mask(l, step);
    for (int n = 0; n < step->rules; n++) {
        rules[n] = step->rule[n];
        if (rules[n].rule->centre)
            weigh_centre(l, &rules[n]);
        else
            check_rule(l, rules[n].rule);
    }
    step->rule = rules;
}

/* Block 0 without the constant net, over kappa. */
static struct affine *limit_matrix(const struct limit *l)
{
    struct valence *v = allocate(1, sizeof *v);
    struct block block;

    *v = *l->v;
    for (int i = 0; i < v->scheme->steps; i++)
        prepare_step(l, &v->step[i]);
    block_prepare(&block, v, true, span_of(0));
    if (block.n != l->c->n + 1)
        reject(l, "block 0 is of another order than block 1");
    return spectrum_without_constants(block_matrix(&block), block.n);
}

void limit_prove(const struct valence *v, const struct eigenpair *pair,
                 const struct certificate *c)
{
    interval half = grid_from_rational(rational_divide(rational_from(1, 2),
                                                       rational_from(v->k.first, 1)), v->g);
    struct limit l = { .v = v, .c = c, .kappa = { half, half } };
    const struct rise *choices = &c->limit;
    struct affine *matrix;
    struct eigenpair mu;
    integer fall = integer_max(pair->real.d.hi, integer_from(0));

    if (v->k.last != ENDLESS || v->scheme->mesh == DUAL || !valence_is_uniform(v))
        reject(&l, "it is for all valences from some on, with a centre, and weights that "
               "depend on k only there");
    l.e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, v->g);
    matrix = limit_matrix(&l);
    mu = slopes_prove_eigenpair(matrix, c->grid, &choices->pair, c);
    if (!affine_is_positive(mu.real))
        reject(&l, "the eigenvalue is not proved to be positive");
    mu.s = pair->s;
    valences_prove_deflated(matrix, &mu, choices->pair.pivot, &choices->record, "limit", c);
    if (integer_add(mu.real.d.hi, fall).sign >= 0)
        reject(&l, "the eigenvalue is not proved to fall behind L");
}
