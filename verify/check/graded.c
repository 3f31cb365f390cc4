/* An eigenvalue of block 0 that grows with k: certificate-valences.md, section 6, "Growing without
 * bound".
 *
 * kappa = q/k.  The eigenvalue is L kappa^-d, and the eigenvector has the components
 * kappa^e_i x_i; so has its net, the value kappa^e(y) V(y) at a label y. */

#include "graded.h"

#include "answer.h"
#include "decide.h"
#include "laurent.h"

#include <limits.h>

enum { MAX_KAPPA = 4096 };

/* kappa^e v */
struct term_value {
    struct affine v;
    int e;
};

struct graded {
    const struct block *block;
    const struct certificate *c;
    int g;
    struct affine kappa[MAX_KAPPA + 1];         /* its powers */
    int powers;                                    /* those that are known */
    struct affine l;
    int rings;                                     /* of the net */
    struct term_value *value;                      /* at labels of the sector; (0,0): centre */
};

static noreturn void reject(const struct certificate *c, int line, const char *why)
{
    rejected(c->file, line, "%s", why);
}

static struct affine kappa_power(struct graded *s, int n)
{
    if (n > MAX_KAPPA)
        cannot_check("the checker has no power %d of q/k", n);
    for (; s->powers <= n; s->powers++)
        s->kappa[s->powers] = affine_mul(s->kappa[s->powers - 1], s->kappa[1], s->g);
    return s->kappa[n];
}

static void prepare_kappa(struct graded *s, struct span k)
{
    int64_t q = s->c->unit;
    interval u = k.last == ENDLESS ? grid_from(0, s->g)
                                   : grid_from_rational(rational_from(q, k.last), s->g);

    u = interval_hull(u, grid_from_rational(rational_from(q, k.first), s->g));
    s->kappa[0] = affine_from_whole(1, s->g);
    s->kappa[1] = (struct affine) { interval_thin(interval_mid(u)),
                                    interval_thin(interval_rad(u)) };
    s->powers = 2;
}

/* The block
 * --------- */

static noreturn void reject_scheme(const struct valence *v, const char *why)
{
    rejected(v->reference.file, v->reference.line, "scheme: %s", why);
}

static struct active_rule without_weights(const struct active_rule *r)
{
    struct active_rule out = { .rule = r->rule };

    out.weighted = allocate((size_t)r->rule->count, sizeof out.weighted[0]);
    for (int i = 0; i < r->rule->count; i++)
        out.weighted[i].source = r->weighted[i].source;
    return out;
}

/* The weights of the centre are 0 here: its row is computed apart. */
void graded_prepare_block(struct block *out, const struct valence *v)
{
    struct valence *own = allocate(1, sizeof *own);
    struct active_step *step = &own->step[0];
    struct active_rule *rule;

    *own = *v;
    if (v->scheme->steps != 1 || v->scheme->mesh == DUAL ||
        valence_rule(step, true, 0, 0) == NULL)
        reject_scheme(v, "the scheme has no mask, or no rule for the centre");
    if (!valence_is_uniform(v) || !valence_is_local(v))
        reject_scheme(v, "only the rule of the centre may depend on k, or have sources in all "
                      "sectors");
    rule = allocate((size_t)step->rules, sizeof rule[0]);
    for (int n = 0; n < step->rules; n++)
        rule[n] = step->rule[n].rule->centre ? without_weights(&step->rule[n]) : step->rule[n];
    step->rule = rule;
    block_prepare(out, own, true, span_of(0));
}

/* Turns a label into the sector; T = 1. */
static void find_in_sector(enum mesh mesh, int *a, int *b)
{
    enum place place;

    do
        place = label_turn(mesh, a, b);
    while (place == BEHIND || place == BEFORE);
    if (place == OPPOSITE)
        cannot_check("a rule uses a point opposite to its sector");
}

static int unknown_at(const struct block *block, int a, int b)
{
    find_in_sector(block->v->scheme->mesh, &a, &b);
    for (int i = 0; i < block->n; i++)
        if (block->unknown[i].a == a && block->unknown[i].b == b)
            return i;
    cannot_check("the checker looks for a point outside of its net");
}

/* The centre's row of block 0: a Laurent value in 1/kappa for each unknown, or NULL. */
static struct laurent **centre_row(const struct graded *s)
{
    const struct valence *v = s->block->v;
    const struct rule *rule = valence_rule(&v->step[0], true, 0, 0)->rule;
    struct environment e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, s->g);
    struct laurent **out = allocate((size_t)s->block->n, sizeof out[0]);
    struct laurent *w = allocate((size_t)rule->count, sizeof w[0]);

    if (!laurent_weights(w, rule, &e))
        reject(s->c, s->c->line_of.form, "form: a weight of the centre has no Laurent value");
    for (int i = 0; i < rule->count; i++) {
        const struct source *source = &rule->source[i];
        int j = source->kind == SOURCE_CENTRE ? 0 : unknown_at(s->block, source->a, source->b);

        laurent_rescale(&w[i], s->c->unit);
        if (out[j] == NULL)
            out[j] = &w[i];
        else
            laurent_add(out[j], &w[i]);
    }
    return out;
}

/* M_ij = kappa^(d + e_j - e_i) B_ij */
static struct affine *scaled_matrix(struct graded *s)
{
    const struct certificate *c = s->c;
    struct affine *m = block_matrix(s->block), *out = m;
    struct laurent **row = centre_row(s);
    int n = s->block->n;

    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++, out++) {
            int shift = c->degree + c->grade[j] - c->grade[i];
            bool fits = true;

            if (i == 0 && row[j] != NULL)
                fits = laurent_in_kappa(out, row[j], shift, s->kappa[1], s->g);
            else if (i > 0 && !interval_is_zero(out->c) && (fits = shift >= 0))
                *out = affine_scale(out->c, kappa_power(s, shift), s->g);
            if (!fits)
                reject(c, c->line_of.form, "grades: the scaled block grows with k");
        }
    }
    return m;
}

/* |L| > kappa^d, and L is not 0. */
static void prove_size(struct graded *s)
{
    struct affine one = kappa_power(s, s->c->degree);

    if (interval_contains_zero(affine_range(s->l)) ||
        !(affine_is_positive(affine_sub(s->l, one)) ||
          affine_is_positive(affine_minus(affine_add(s->l, one)))))
        reject(s->c, s->c->pair.line_of.eigenvalue,
               "eigenvalue: |L| is not proved to be larger than 1");
}

/* The net
 * ------- */

static struct term_value *value_at(const struct graded *s, int a, int b)
{
    find_in_sector(s->block->v->scheme->mesh, &a, &b);
    if ((a > 0 || b > 0) && label_ring(s->block->v->scheme->mesh, a, b) > s->rings)
        cannot_check("the checker looks for a point outside of its net");
    return &s->value[a * (s->rings + 1) + b];
}

/* The values that the new one at (a,b) asks for, times their weights; returns their number. */
static int collect_terms(struct term_value *out, const struct graded *old, int a, int b)
{
    const struct active_step *step = &old->block->v->step[0];
    const struct active_rule *rule = valence_rule(step, false, a, b);
    const struct stencil *mask = &step->stencil;
    int class = stencil_class(mask, a, b), first = rule == NULL ? mask->first[class] : 0;
    int count = rule == NULL ? mask->first[class + 1] - first : rule->rule->count;

    for (int i = 0; i < count; i++) {
        const struct stencil_entry *e = &mask->entry[first + i];
        const struct source *s = rule == NULL ? NULL : rule->weighted[i].source;

        if (s == NULL)
            out[i] = *value_at(old, (a - e->a) / mask->dilation,
                               (b - e->b) / mask->dilation);
        else
            out[i] = s->kind == SOURCE_CENTRE ? old->value[0] : *value_at(old, s->a, s->b);
        out[i].v = affine_scale(s == NULL ? e->weight : rule->weighted[i].weight.c, out[i].v,
                                old->g);
    }
    return count;
}

/* e = d + the least of the e's, V = the sum of kappa^(e' - least) w V' / L */
static struct term_value divided_value(struct graded *s, int a, int b)
{
    struct term_value *term = allocate(MAX_SOURCES + (size_t)s->block->v->step[0].stencil.first[4],
                                       sizeof term[0]);
    struct affine sum = affine_from_whole(0, s->g);
    int count = collect_terms(term, s, a, b), least = term[0].e;

    for (int i = 0; i < count; i++)
        least = term[i].e < least ? term[i].e : least;
    for (int i = 0; i < count; i++)
        sum = affine_add(sum, affine_mul(kappa_power(s, term[i].e - least), term[i].v, s->g));
    sum = affine_div(sum, s->l, s->g);
    return (struct term_value) { sum, s->c->degree + least };
}

/* The net with that many rings, or as many as follow from those of the old one. */
static void extend(struct graded *s, int rings)
{
    enum mesh mesh = s->block->v->scheme->mesh;
    int old = s->rings;
    struct term_value *value;

    while (scheme_needs(s->block->v->scheme, rings) > s->rings)
        rings--;
    if (rings <= s->rings)
        cannot_check("the checker cannot extend the characteristic net");
    value = allocate((size_t)(rings + 1) * (size_t)(rings + 1), sizeof value[0]);
    value[0] = s->value[0];
    for (int a = 1; a <= rings; a++)
        for (int b = 0; label_ring(mesh, a, b) <= rings; b++)
            value[a * (rings + 1) + b] = label_ring(mesh, a, b) <= old
                                       ? s->value[a * (old + 1) + b] : divided_value(s, a, b);
    s->rings = rings;
    s->value = value;
}

static void begin_net(struct graded *s, const struct affine *x)
{
    const struct block *block = s->block;

    s->rings = block->rings;
    s->value = allocate((size_t)(s->rings + 1) * (size_t)(s->rings + 1), sizeof s->value[0]);
    for (int i = 0; i < block->n; i++)             /* the centre is (0,0) there */
        s->value[block->unknown[i].a * (s->rings + 1) + block->unknown[i].b] =
            (struct term_value) { x[i], s->c->grade[i] };
}

/* E: the least e of the labels in windows of the boundary. */
static int least_exponent(const struct graded *s, const struct characteristic *c)
{
    int least = INT_MAX;

    for (int i = 0; i < c->segments; i++) {
        const struct element *e = &c->segment[i];
        const struct window *w = &c->value.window[e->kind];

        for (int n = 0; n < w->count; n++) {
            int here = value_at(s, e->a + w->label[n].a, e->b + w->label[n].b)->e;

            least = here < least ? here : least;
        }
    }
    return least;
}

/* kappa^(e(y) - E) V(y); where this is no power, no window has the label. */
static struct net scaled_net(struct graded *s, const struct characteristic *c)
{
    enum mesh mesh = s->block->v->scheme->mesh;
    struct net out = net_make(mesh, s->rings);
    int least = least_exponent(s, c);

    for (int a = 1; a <= s->rings; a++) {
        for (int b = 0; label_ring(mesh, a, b) <= s->rings; b++) {
            const struct term_value *here = value_at(s, a, b);
            struct pair v = { affine_from_whole(0, s->g), affine_from_whole(0, s->g) };

            if (here->e >= least)
                v.x = affine_mul(kappa_power(s, here->e - least), here->v, s->g);
            net_set(&out, a, b, v);
        }
    }
    return out;
}

interval graded_prove(const struct block *block, const struct mask q[3],
                      const struct certificate *c)
{
    struct graded *s = allocate(1, sizeof *s);
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);
    struct eigenpair pair;
    struct net net;

    s->block = block;
    s->c = c;
    s->g = c->grid;
    prepare_kappa(s, block->v->k);
    pair = eigenpair_prove(scaled_matrix(s), &c->pair, c);
    s->l = pair.real;
    prove_size(s);
    begin_net(s, pair.unknowns);
    characteristic_begin(characteristic, block, q, c);
    while (s->rings < characteristic->rings)
        extend(s, characteristic->rings);
    net = scaled_net(s, characteristic);
    characteristic_use(characteristic, &net);
    decide_not_zero(characteristic, c);
    return interval_abs(affine_range(s->l));
}
