/* An eigenvalue of block 0 that grows with k: certificate-valences.md, section 6, "Growing without
 * bound".
 *
 * The eigenvalue is L kappa^-d, kappa = q/k, and the eigenvector has the components kappa^e_i x_i. */

#include "graded.h"

#include "answer.h"
#include "decide.h"
#include "graded_net.h"

#include <limits.h>

static noreturn void reject(const struct certificate *c, int line, const char *why)
{
    rejected(c->file, line, "%s", why);
}

/* The block
 * --------- */

static noreturn void reject_scheme(const struct valence *v, const char *why)
{
    rejected(v->reference.file, v->reference.line, "scheme: %s", why);
}

/* The rules of a step, whether or not weights of the centre have values on the grid. */
static struct active_rule *rules_without_values(const struct active_step *step)
{
    struct active_rule *out = allocate((size_t)step->rules, sizeof out[0]);

    for (int n = 0; n < step->rules; n++) {
        out[n] = step->rule[n];
        out[n].missing = NULL;
    }
    return out;
}

void graded_prepare_block(struct block *out, const struct valence *v)
{
    struct valence *own = allocate(1, sizeof *own);

    if (v->scheme->mesh == DUAL)
        reject_scheme(v, "there is no centre");
    if (!valence_is_uniform(v) || !valence_is_local(v))
        reject_scheme(v, "only rules of the centre may depend on k, or have sources in all "
                      "sectors");
    *own = *v;
    for (int i = 0; i < v->scheme->steps; i++)
        own->step[i].rule = rules_without_values(&v->step[i]);
    block_prepare(out, own, true, span_of(0));
}

/* The component of a net at an unknown */
static struct graded_value *component(const struct graded_net *net, const struct block *block,
                                      int i)
{
    return graded_net_at(net, block->unknown[i].a, block->unknown[i].b);
}

/* M_ij = kappa^(d + e_j + c_ij - e_i) V_ij, for all i */
static void scale_column(struct affine *out, int j, struct grading *s, const struct certificate *c)
{
    const struct block *block = s->block;
    struct graded_net net = graded_net_make(block->v->scheme->mesh, block->rings);

    *component(&net, block, j) = (struct graded_value) { true, 0, affine_from_whole(1, s->g) };
    net = graded_net_subdivide(s, &net, block->rings);
    for (int i = 0; i < block->n; i++) {
        const struct graded_value *here = component(&net, block, i);
        int shift = c->degree + c->grade[j] + here->e - c->grade[i];

        out[i] = affine_from_whole(0, s->g);
        if (!here->present)
            continue;
        if (shift < 0)
            reject(c, c->line_of.form, "grades: the scaled block grows with k");
        out[i] = affine_mul(kappa_power(s, shift), here->v, s->g);
    }
}

static struct affine *scaled_matrix(struct grading *s, const struct certificate *c)
{
    size_t n = (size_t)s->block->n;
    struct affine *m = allocate(n * n, sizeof m[0]), *column = allocate(n, sizeof column[0]);

    for (size_t j = 0; j < n; j++) {
        struct mark mark = scratch_mark();
        int powers = s->powers;

        scale_column(column, (int)j, s, c);
        affine_keep(mark, column, n);
        s->powers = powers;                        /* the others are gone */
        for (size_t i = 0; i < n; i++)
            m[i * n + j] = column[i];
    }
    return m;
}

/* |L| > kappa^d, and L is not 0. */
static void prove_size(struct affine l, struct grading *s, const struct certificate *c)
{
    struct affine one = kappa_power(s, c->degree);

    if (interval_contains_zero(affine_range(l)) ||
        !(affine_is_positive(affine_sub(l, one)) ||
          affine_is_positive(affine_minus(affine_add(l, one)))))
        reject(c, c->pair.line_of.eigenvalue,
               "eigenvalue: |L| is not proved to be larger than 1");
}

/* The net
 * ------- */

static struct graded_net begin_net(const struct block *block, const struct affine *x,
                                   const struct certificate *c)
{
    struct graded_net out = graded_net_make(block->v->scheme->mesh, block->rings);

    for (int i = 0; i < block->n; i++)
        *component(&out, block, i) = (struct graded_value) { true, c->grade[i], x[i] };
    return out;
}

/* The net with that many rings, or as many as follow from those of the old one: the new value
 * divided by L kappa^-d. */
static struct graded_net extend(const struct graded_net *old, int rings, struct affine l, int d,
                                struct grading *s)
{
    struct graded_net out;

    while (scheme_needs(s->block->v->scheme, rings) > old->rings)
        rings--;
    if (rings <= old->rings)
        cannot_check("the checker cannot extend the characteristic net");
    out = graded_net_subdivide(s, old, rings);
    *graded_net_at(&out, 0, 0) = *graded_net_at(old, 0, 0);
    for (int a = 1; a <= rings; a++) {
        for (int b = 0; label_ring(old->mesh, a, b) <= rings; b++) {
            struct graded_value *here = graded_net_at(&out, a, b);

            if (label_ring(old->mesh, a, b) <= old->rings)
                *here = *graded_net_at(old, a, b);
            else
                *here = (struct graded_value) { here->present, d + here->e,
                                                affine_div(here->v, l, s->g) };
        }
    }
    return out;
}

/* E: the least e in windows of the boundary. */
static int least_exponent(const struct graded_net *net, const struct characteristic *c)
{
    int least = INT_MAX;

    for (int i = 0; i < c->segments; i++) {
        const struct element *e = &c->segment[i];
        const struct window *w = &c->value.window[e->kind];

        for (int n = 0; n < w->count; n++) {
            const struct graded_value *here = graded_net_at(net, e->a + w->label[n].a,
                                                            e->b + w->label[n].b);

            least = here->present && here->e < least ? here->e : least;
        }
    }
    return least;
}

/* kappa^(e - E) V; where this is no power, no window has the label. */
static struct net scaled_net(const struct graded_net *net, int least, struct grading *s)
{
    struct net out = net_make(net->mesh, net->rings);

    for (int a = 1; a <= net->rings; a++) {
        for (int b = 0; label_ring(net->mesh, a, b) <= net->rings; b++) {
            const struct graded_value *here = graded_net_at(net, a, b);
            struct pair v = { affine_from_whole(0, s->g), affine_from_whole(0, s->g) };

            if (here->present && here->e >= least)
                v.x = affine_mul(kappa_power(s, here->e - least), here->v, s->g);
            net_set(&out, a, b, v);
        }
    }
    return out;
}

interval graded_prove(const struct block *block, const struct mask q[3],
                      const struct certificate *c)
{
    struct grading *s = allocate(1, sizeof *s);
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);
    struct graded_net graded;
    struct eigenpair pair;
    struct net net;

    if (!grading_prepare(s, block, c->unit))
        reject(c, c->line_of.form, "form: a weight of the centre has no Laurent value");
    pair = eigenpair_prove(scaled_matrix(s, c), &c->pair, c);
    prove_size(pair.real, s, c);
    characteristic_begin(characteristic, block, q, c);
    graded = begin_net(block, pair.unknowns, c);
    while (graded.rings < characteristic->rings)
        graded = extend(&graded, characteristic->rings, pair.real, c->degree, s);
    net = scaled_net(&graded, least_exponent(&graded, characteristic), s);
    characteristic_use(characteristic, &net);
    decide_claim(characteristic, c);
    return interval_abs(affine_range(pair.real));
}
