/* An eigenvalue of block 0 that grows with k: certificate-valences.md, section 6, "Growing without
 * bound".  It is L kappa^-d, kappa = q/k, and the eigenvector has the components kappa^e_i x_i. */

#include "graded.h"

#include "answer.h"
#include "characteristic.h"
#include "valences.h"

#include <limits.h>

/* The block
 * --------- */

void graded_prepare_block(struct block *out, const struct valence *v)
{
    valence_require_centre(v);
    for (int i = 0; i < v->scheme->steps; i++)     /* weights without values are not used */
        for (int n = 0; n < v->step[i].rules; n++)
            v->step[i].rule[n].missing = NULL;
    block_prepare(out, v, true, span_of(0));
}

static struct net begin_net(const struct block *block)
{
    return net_of(&GRADED, block->v->scheme->mesh, block->rings);
}

static void set_component(struct net *net, const struct block *block, int i, int e, struct affine v)
{
    *(struct graded_value *)net_add(net, block->unknown[i].a, block->unknown[i].b) =
        (struct graded_value) { true, e, v };
}

/* M_ij = kappa^(d + e_j + c_ij - e_i) V_ij, for all i */
static void scale_column(struct affine *out, int j, const struct block *block,
                         const struct certificate *c)
{
    struct net net = begin_net(block);
    struct grading *s = block->own;

    set_component(&net, block, j, 0, affine_from_whole(1, s->g));
    net = net_subdivide(&net, block, block->rings);
    for (int i = 0; i < block->n; i++) {
        const struct graded_value *here = net_find(&net, block, block->unknown[i].a,
                                                   block->unknown[i].b);
        int shift = c->degree + c->grade[j] + here->e - c->grade[i];

        out[i] = affine_from_whole(0, s->g);
        if (!here->present)
            continue;
        if (shift < 0)
            rejected(c->file, c->line_of.form, "grades: the scaled block grows with k");
        out[i] = affine_mul(kappa_power(s, shift), here->v, s->g);
    }
}

static struct affine *scaled_matrix(const struct block *block, const struct certificate *c)
{
    struct grading *s = block->own;
    size_t n = (size_t)block->n;
    struct affine *m = allocate(n * n, sizeof m[0]), *column = allocate(n, sizeof column[0]);

    for (size_t j = 0; j < n; j++) {
        struct mark mark = scratch_mark();
        int powers = s->powers;

        scale_column(column, (int)j, block, c);
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
        rejected(c->file, c->pair.line_of.eigenvalue,
                 "eigenvalue: |L| is not proved to be larger than 1");
}

/* The net
 * ------- */

/* E: the least e in windows of the boundary. */
static int least_exponent(const struct net *net, const struct characteristic *c)
{
    int least = INT_MAX;

    for (int i = 0; i < c->segments; i++) {
        const struct element *e = &c->segment[i];
        const struct window *w = &c->f[0].window[e->kind];

        for (int n = 0; n < w->count; n++) {
            const struct graded_value *here = net_find(net, c->block, e->a + w->label[n].a,
                                                       e->b + w->label[n].b);

            least = here->present && here->e < least ? here->e : least;
        }
    }
    return least;
}

/* kappa^(e - E) V; where this is no power, no window has the label. */
static struct net scaled_net(const struct net *net, int least, const struct block *block)
{
    struct grading *s = block->own;
    struct net out = net_make(net->mesh, net->rings);

    for (int a = 1; a <= net->rings; a++) {
        for (int b = 0; label_ring(net->mesh, a, b) <= net->rings; b++) {
            const struct graded_value *here = net_find(net, block, a, b);
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
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);
    struct block own = *block;
    struct eigenpair pair;
    struct net graded, net;

    if (!grading_prepare(&own, c->unit, c->degree))
        rejected(c->file, c->line_of.form, "form: a weight of the centre has no Laurent value");
    pair = eigenpair_prove(scaled_matrix(&own, c), &c->pair, c);
    prove_size(pair.real, own.own, c);
    characteristic_begin(characteristic, &own, q, c);
    graded = begin_net(&own);
    for (int i = 0; i < own.n; i++)
        set_component(&graded, &own, i, c->grade[i], pair.unknowns[i]);
    while (graded.rings < characteristic->rings)
        graded = net_extend(&graded, &own, (struct pair) { pair.real, pair.imaginary },
                            characteristic->rings);
    net = scaled_net(&graded, least_exponent(&graded, characteristic), &own);
    characteristic_use(characteristic, &net);
    decide_claim(characteristic, c);
    return interval_abs(affine_range(pair.real));
}
