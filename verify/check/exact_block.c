/* Exact blocks: section 3 of exact.md.  Sector nets as in sector.c, over a field of cosines; a value
 * is computed when it is first asked for, after each step of the subdivision. */

#include "exact_block.h"

#include "answer.h"
#include "exact_formula.h"

#include <stdlib.h>
#include <string.h>

struct exact_pair {
    struct number x, y;
};

/* A source of a rule contributes weight T^sectors of its value. */
struct exact_term {
    const struct source *source;
    struct number weight;
    int sectors;
};

struct exact_rule {
    int terms;
    struct exact_term *term;
};

/* The net after so many steps, the centre (0,0) among its values. */
struct exact_net {
    int rings;
    bool *known;
    struct exact_pair *value;
};

struct computation {
    const struct block *block;
    const struct field *k;
    int line;                                      /* of the certificate */
    struct number u, turn[4], back[4];
    struct exact_rule *rule[MAX_STEPS];            /* as in v->step[].rule */
    struct exact_net net[MAX_STEPS + 1];
};

static struct exact_pair value_at(struct computation *c, int step, int a, int b);

/* Pairs
 * ----- */

static struct exact_pair zero_pair(void)
{
    return (struct exact_pair) { number_from_whole(0), number_from_whole(0) };
}

static void add_product(struct number *sum, const struct number *a, const struct number *b,
                        const struct field *k)
{
    struct number product;

    if (number_is_zero(a) || number_is_zero(b))
        return;
    product = number_mul(a, b, k);
    *sum = number_add(sum, &product);
}

static struct exact_pair image(const struct number m[4], const struct exact_pair *v,
                               const struct field *k)
{
    struct exact_pair out = zero_pair();

    add_product(&out.x, &m[0], &v->x, k);
    add_product(&out.x, &m[1], &v->y, k);
    add_product(&out.y, &m[2], &v->x, k);
    add_product(&out.y, &m[3], &v->y, k);
    return out;
}

/* T and T^-1 of the real form. */
static void prepare_turns(struct computation *c)
{
    const struct block *block = c->block;
    rational q = rational_from(block->m.first, block->v->k.first);
    struct number one = number_from_whole(1), v, square, cosine, n;

    if (!number_cos_pi(&c->u, q, c->k))
        rejected(block->v->reference.file, c->line, "exact: cos(pi m/k) is not in the field");
    v = number_add(&c->u, &c->u);
    cosine = number_mul(&v, &c->u, c->k);
    cosine = number_sub(&cosine, &one);
    square = number_mul(&c->u, &c->u, c->k);
    n = number_sub(&one, &square);
    n = number_mul(&v, &n, c->k);
    c->turn[0] = c->turn[3] = c->back[0] = c->back[3] = cosine;
    c->turn[1] = number_minus(&n);
    c->turn[2] = v;
    c->back[1] = n;
    c->back[2] = number_minus(&v);
}

/* Rules
 * ----- */

static struct number formula_at(struct computation *c, const struct node *f, struct span m,
                                struct span j)
{
    const struct valence *v = c->block->v;
    struct environment e = environment_make(&v->scheme->language, v->k, m, j, v->g);
    struct number out;

    if (!exact_value(&out, f, &e, c->k))
        rejected(v->reference.file, c->line, "exact: the formula in line %d, column %d of the "
                 "scheme has no exact value in the field", f->line, f->column);
    return out;
}

/* The total weight, at m = 0, of a source that is not the rest. */
static struct number total_weight(struct computation *c, const struct source *s)
{
    struct number sum = number_from_whole(0);

    if (s->kind == SOURCE_SPECTRUM)
        return formula_at(c, s->weight, span_of(0), NOTHING);
    if (s->kind != SOURCE_EACH)
        return formula_at(c, s->weight, NOTHING, NOTHING);
    for (int64_t j = 0; j < c->block->v->k.first; j++) {
        struct mark mark = scratch_mark();
        struct number w = formula_at(c, s->weight, NOTHING, span_of(j));

        sum = number_add(&sum, &w);
        number_keep(mark, &sum, 1);
    }
    return sum;
}

/* False if the source contributes nothing. */
static bool make_term(struct exact_term *out, const struct source *s, const struct number *w,
                      struct computation *c)
{
    bool plain = c->block->plain;

    *out = (struct exact_term) { s, *w, plain || s->kind != SOURCE_ONE ? 0 : s->sectors };
    if (!plain && (s->kind == SOURCE_CENTRE || s->kind == SOURCE_ALL))
        return false;
    if (!plain && (s->kind == SOURCE_EACH || s->imaginary != NULL))
        rejected(c->block->v->reference.file, c->line, "exact: a weight for each sector, or an "
                 "imaginary part, has no exact value");
    if (!plain && s->kind == SOURCE_SPECTRUM)
        out->weight = formula_at(c, s->weight, c->block->m, NOTHING);
    return true;
}

static void prepare_rule(struct exact_rule *out, const struct rule *rule,
                         struct computation *c)
{
    struct number *weight = allocate((size_t)rule->count, sizeof weight[0]);
    struct number rest = number_from_whole(1);

    for (int s = 0; s < rule->count; s++) {
        if (s == rule->rest)
            continue;
        weight[s] = total_weight(c, &rule->source[s]);
        rest = number_sub(&rest, &weight[s]);
    }
    weight[rule->rest] = rest;
    out->term = allocate((size_t)rule->count, sizeof out->term[0]);
    for (int s = 0; s < rule->count; s++)
        if (make_term(&out->term[out->terms], &rule->source[s], &weight[s], c))
            out->terms++;
}

static void prepare_rules(struct computation *c)
{
    const struct valence *v = c->block->v;

    for (int i = 0; i < v->scheme->steps; i++) {
        c->rule[i] = allocate((size_t)v->step[i].rules, sizeof c->rule[i][0]);
        for (int n = 0; n < v->step[i].rules; n++)
            if (c->block->plain || !v->step[i].rule[n].rule->centre)
                prepare_rule(&c->rule[i][n], v->step[i].rule[n].rule, c);
    }
}

/* New values
 * ---------- */

static struct exact_pair value_by_rule(struct computation *c, int step,
                                       const struct exact_rule *rule)
{
    struct exact_pair sum = zero_pair();

    for (int i = 0; i < rule->terms; i++) {
        const struct exact_term *t = &rule->term[i];
        struct exact_pair v = value_at(c, step, t->source->a, t->source->b);

        for (int n = 0; n < abs(t->sectors); n++)
            v = image(t->sectors < 0 ? c->back : c->turn, &v, c->k);
        add_product(&sum.x, &t->weight, &v.x, c->k);
        add_product(&sum.y, &t->weight, &v.y, c->k);
    }
    return sum;
}

/* As in sector.c: without a rule the mask must give the centre its old value. */
static struct exact_pair value_by_mask(struct computation *c, int step, bool centre, int a,
                                       int b)
{
    const struct active_step *active = &c->block->v->step[step];
    const struct stencil *s = &active->stencil;
    const struct mask *mask = &active->step->mask;
    struct exact_pair sum = zero_pair();
    int class = stencil_class(s, a, b);

    for (int i = s->first[class]; i < s->first[class + 1]; i++) {
        int x = s->entry[i].a, y = s->entry[i].b;
        rational w = rational_reduce(*mask_cell(mask, x, y), mask->denominator);
        struct exact_pair v = value_at(c, step, (a - x) / s->dilation, (b - y) / s->dilation);

        if (centre && (x != 0 || y != 0))
            cannot_check("the centre has no rule, and the mask does not give it its "
                         "old value");
        v = (struct exact_pair) { number_scale(w, &v.x), number_scale(w, &v.y) };
        sum.x = number_add(&sum.x, &v.x);
        sum.y = number_add(&sum.y, &v.y);
    }
    return sum;
}

/* At the centre or a label of the sector, after step + 1 steps; at m >= 1 the centre is 0. */
static struct exact_pair new_value(struct computation *c, int step, bool centre, int a, int b)
{
    const struct active_step *active = &c->block->v->step[step];
    const struct active_rule *rule = valence_rule(active, centre, a, b);

    if (centre && !c->block->plain)
        return zero_pair();
    if (rule != NULL)
        return value_by_rule(c, step, &c->rule[step][rule - active->rule]);
    return value_by_mask(c, step, centre, a, b);
}

static enum mesh mesh_after(const struct computation *c, int step)
{
    const struct valence *v = c->block->v;

    return step == 0 ? v->scheme->mesh : v->step[step - 1].step->new;
}

/* The number of a label in the lists of a net. */
static int cell(const struct exact_net *net, int a, int b)
{
    int i = a + net->rings + 1, j = b + net->rings + 1, side = 2 * net->rings + 3;

    if (i < 0 || i >= side || j < 0 || j >= side)
        cannot_check("the checker looks for a point outside of its net");
    return i * side + j;
}

static void set_value(struct exact_net *net, int a, int b, struct exact_pair value)
{
    net->value[cell(net, a, b)] = value;
    net->known[cell(net, a, b)] = true;
}

/* Of any label of the plane that is not opposite. */
static struct exact_pair value_at(struct computation *c, int step, int a, int b)
{
    const struct block *block = c->block;
    struct exact_net *net = &c->net[step];
    enum mesh mesh = mesh_after(c, step);
    int own_a = a, own_b = b;
    struct exact_pair out;
    enum place place;

    if (net->known[cell(net, a, b)])
        return net->value[cell(net, a, b)];
    place = label_turn(mesh, &own_a, &own_b);
    if (place == IN_SECTOR && label_ring(mesh, a, b) > net->rings)
        cannot_check("the checker looks for a point outside of its net");
    if (place == OPPOSITE && valence_is_regular(block->v)) {
        label_from_next(mesh, &own_a, &own_b);
        place = BEHIND;
    }
    if (place == OPPOSITE)
        cannot_check("a rule uses a point opposite to its sector");
    if (place == IN_SECTOR || place == CENTRE)
        out = step == 0 ? zero_pair() : new_value(c, step - 1, place == CENTRE, a, b);
    else
        out = value_at(c, step, own_a, own_b);
    if ((place == BEHIND || place == BEFORE) && !block->plain)
        out = image(place == BEHIND ? c->turn : c->back, &out, c->k);
    set_value(net, a, b, out);
    return out;
}

/* Columns
 * ------- */

/* The net of unknown j; the centre is (0,0). */
static void set_unit(struct computation *c, int j)
{
    const struct unknown *at = &c->block->unknown[j];
    struct number one = number_from_whole(1), zero = number_from_whole(0);
    struct exact_pair value = { one, zero };

    if (at->kind == UNKNOWN_BISECTOR)
        value = (struct exact_pair) { c->u, one };
    if (at->kind == UNKNOWN_Y)
        value = (struct exact_pair) { zero, one };
    set_value(&c->net[0], at->a, at->b, value);
    if (at->kind != UNKNOWN_X && at->kind != UNKNOWN_Y)
        return;
    value.y = number_minus(&value.y);              /* V(b,a) = T (x, -y) */
    set_value(&c->net[0], at->b, at->a, image(c->turn, &value, c->k));
}

static void begin_nets(struct computation *c)
{
    const struct scheme *scheme = c->block->v->scheme;
    int rings = c->block->rings;

    for (int step = scheme->steps; step >= 0; step--) {
        struct exact_net *net = &c->net[step];
        size_t cells = (size_t)(2 * rings + 3) * (size_t)(2 * rings + 3);

        memset(net, 0, sizeof *net);
        net->rings = rings;
        net->value = allocate(cells, sizeof net->value[0]);
        net->known = allocate(cells, sizeof net->known[0]);
        rings = step > 0 ? step_needs(&scheme->step[step - 1], rings) : rings;
    }
}

/* The value of the net after all steps at unknown i. */
static struct number read_off(struct computation *c, int i)
{
    const struct unknown *at = &c->block->unknown[i];
    struct exact_pair v = value_at(c, c->block->v->scheme->steps, at->a, at->b);

    return at->kind == UNKNOWN_BISECTOR || at->kind == UNKNOWN_Y ? v.y : v.x;
}

/* M_ij = B_ij - B_pj, without the first unknown p. */
static struct exact_matrix without_constants(const struct number *b, int n)
{
    struct exact_matrix out = { .size = n - 1 };

    out.entry = allocate((size_t)(n - 1) * (size_t)(n - 1), sizeof out.entry[0]);
    for (int i = 1; i < n; i++)
        for (int j = 1; j < n; j++)
            out.entry[(i - 1) * (n - 1) + j - 1] = number_sub(&b[i * n + j], &b[j]);
    return out;
}

struct exact_matrix exact_block(const struct block *block, const struct field *k, int line)
{
    struct computation *c = allocate(1, sizeof *c);
    struct exact_matrix out = { .size = block->n };
    size_t n = (size_t)block->n;
    struct number *column = allocate(n, sizeof column[0]);

    c->block = block;
    c->k = k;
    c->line = line;
    prepare_turns(c);
    prepare_rules(c);
    out.entry = allocate(n * n, sizeof out.entry[0]);
    for (size_t j = 0; j < n; j++) {
        struct mark mark = scratch_mark();

        begin_nets(c);
        set_unit(c, (int)j);
        for (size_t i = 0; i < n; i++)
            column[i] = read_off(c, (int)i);
        number_keep(mark, column, n);
        for (size_t i = 0; i < n; i++)
            out.entry[i * n + j] = column[i];
    }
    return block->plain ? without_constants(out.entry, block->n) : out;
}
