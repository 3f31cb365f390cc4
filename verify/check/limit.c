/* Block 0 where it tends to block 1: certificate-valences.md, section 4, "Limit". */

#include "valences.h"

#include "answer.h"
#include "laurent.h"

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

/* Affine weights in place of the intervals, which nobody needs once there is a limit; at k = inf
 * all of the weight must be at the centre. */
static void weigh_centre(const struct limit *l, struct active_rule *rule)
{
    const struct rule *r = rule->rule;
    struct laurent *w = allocate((size_t)r->count, sizeof w[0]);

    if (!laurent_weights(w, r, &l->e))
        reject(l, "a weight of the centre is no polynomial in 1/k");
    for (int i = 0; i < r->count; i++) {
        int at_infinity = r->source[i].kind == SOURCE_CENTRE ? 1 : 0;

        if (!laurent_in_kappa(&rule->weighted[i].weight, &w[i], l->kappa, l->v->g))
            reject(l, "a weight of the centre grows with k");
        if (!rational_equals(laurent_at(&w[i], 0), at_infinity, 1))
            reject(l, "the centre does not keep its value at k = inf");
    }
    rule->missing = NULL;
}

/* Block 0 without the constant net, over kappa. */
static struct affine *limit_matrix(const struct limit *l)
{
    const struct valence *v = l->v;
    struct block block;

    for (int i = 0; i < v->scheme->steps; i++)
        for (int n = 0; n < v->step[i].rules; n++)
            if (v->step[i].rule[n].rule->centre)
                weigh_centre(l, &v->step[i].rule[n]);
    block_prepare(&block, v, true, span_of(0));
    if (block.n != l->c->n + 1)
        reject(l, "block 0 is of another order than block 1");
    return spectrum_without_constants(block_matrix(&block), block.n);
}

void limit_prove(const struct valence *v, const struct eigenpair *pair, const struct certificate *c)
{
    interval half = grid_from_rational(rational_divide(rational_from(1, 2),
                                                       rational_from(v->k.first, 1)), v->g);
    struct limit l = { .v = v, .c = c, .kappa = { half, half } };
    const struct rise *choices = &c->limit;
    struct eigenpair mu;
    integer fall = integer_max(pair->real.d.hi, integer_from(0));

    if (v->k.last != ENDLESS || v->scheme->mesh == DUAL)
        reject(&l, "it is for all valences from some on, with a centre");
    if (!valence_is_uniform(v) || !valence_is_local(v))
        reject(&l, "only rules of the centre may depend on k, or have sources in all sectors");
    l.e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, v->g);
    mu = eigenpair_prove(limit_matrix(&l), &choices->pair, c);
    if (!affine_is_positive(mu.real))
        reject(&l, "the eigenvalue is not proved to be positive");
    mu.s = pair->s;
    spectrum_prove_rest(&mu, &choices->record, "limit", c);
    if (integer_add(mu.real.d.hi, fall).sign >= 0)
        reject(&l, "the eigenvalue is not proved to fall behind L");
}
