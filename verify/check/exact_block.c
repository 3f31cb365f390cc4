/* Exact blocks: section 3 of exact.md.  Sector nets as in sector.c, over a field of cosines. */

#include "polynomial.h"

#include "answer.h"
#include "exact_formula.h"

#include <stdlib.h>

struct exact_pair {
    struct number x, y;
};

/* T and T^-1 of the real form. */
struct exact_turns {
    const struct field *k;
    struct number u, turn[4], back[4];
};

struct computation {
    struct block block;
    struct exact_turns turns;
    int line;                                      /* of the certificate */
};

/* Pairs
 * ----- */

static struct exact_pair image(const struct number m[4], const struct exact_pair *v,
                               const struct field *k)
{
    struct exact_pair out = { number_from_whole(0), number_from_whole(0) };

    number_add_product(&out.x, &m[0], &v->x, k);
    number_add_product(&out.x, &m[1], &v->y, k);
    number_add_product(&out.y, &m[2], &v->x, k);
    number_add_product(&out.y, &m[3], &v->y, k);
    return out;
}

static void turn(void *v, bool behind, const struct block *block)
{
    const struct exact_turns *t = block->own;

    *(struct exact_pair *)v = image(behind ? t->turn : t->back, v, t->k);
}

static void add_multiple(struct exact_pair *sum, const struct number *weight,
                         const struct exact_pair *v, const struct block *block)
{
    const struct exact_turns *t = block->own;

    number_add_product(&sum->x, weight, &v->x, t->k);
    number_add_product(&sum->y, weight, &v->y, t->k);
}

/* A source of one sector contributes its weight times T^sectors. */
static void add_term(void *sum, const struct term *t, const void *v, const struct block *block)
{
    int sectors = t->source->kind == SOURCE_ONE && !block->plain ? t->source->sectors : 0;
    struct exact_pair turned = *(const struct exact_pair *)v;

    for (int n = 0; n < abs(sectors); n++)
        turn(&turned, sectors > 0, block);
    add_multiple(sum, t->own, &turned, block);
}

static void add_entry(void *sum, const struct stencil_entry *e, const void *v,
                      const struct block *block)
{
    struct number weight = number_from(e->exact);

    add_multiple(sum, &weight, v, block);
}

static const struct arithmetic EXACT = { sizeof(struct exact_pair), turn, add_term, add_entry, NULL,
                                         NULL };

static void prepare_turns(struct computation *c)
{
    struct exact_turns *t = &c->turns;
    rational q = rational_from(c->block.m.first, c->block.v->k.first);
    struct number one = number_from_whole(1), v, square, cosine, n;

    if (!number_cos_pi(&t->u, q, t->k))
        rejected(c->block.v->reference.file, c->line, "exact: cos(pi m/k) is not in the field");
    v = number_add(&t->u, &t->u);
    cosine = number_mul(&v, &t->u, t->k);
    cosine = number_sub(&cosine, &one);
    square = number_mul(&t->u, &t->u, t->k);
    n = number_sub(&one, &square);
    n = number_mul(&v, &n, t->k);
    t->turn[0] = t->turn[3] = t->back[0] = t->back[3] = cosine;
    t->turn[1] = number_minus(&n);
    t->turn[2] = v;
    t->back[1] = n;
    t->back[2] = number_minus(&v);
}

/* Rules
 * ----- */

static struct number formula_at(struct computation *c, const struct node *f, struct span m,
                                struct span j)
{
    const struct valence *v = c->block.v;
    struct environment e = environment_make(&v->scheme->language, v->k, m, j, v->g);
    struct number out;

    if (!exact_value(&out, f, &e, c->turns.k))
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
    for (int64_t j = 0; j < c->block.v->k.first; j++) {
        struct mark mark = scratch_mark();
        struct number w = formula_at(c, s->weight, NOTHING, span_of(j));

        sum = number_add(&sum, &w);
        number_keep(mark, &sum, 1);
    }
    return sum;
}

/* The weights of the terms; m >= 1: of spectra those at m. */
static void prepare_rule(struct block_rule *out, const struct rule *rule, struct computation *c)
{
    struct number *weight = allocate((size_t)rule->count, sizeof weight[0]);

    weight[rule->rest] = number_from_whole(1);
    for (int s = 0; s < rule->count; s++) {
        if (s == rule->rest)
            continue;
        weight[s] = total_weight(c, &rule->source[s]);
        weight[rule->rest] = number_sub(&weight[rule->rest], &weight[s]);
    }
    for (int i = 0; i < out->terms; i++) {
        const struct source *s = out->term[i].source;
        struct number *own = &weight[s - rule->source];

        out->term[i].own = own;
        if (c->block.plain)
            continue;
        if (s->kind == SOURCE_EACH || s->imaginary != NULL)
            rejected(c->block.v->reference.file, c->line, "exact: a weight for each sector, or an "
                     "imaginary part, has no exact value");
        if (s->kind == SOURCE_SPECTRUM)
            *own = formula_at(c, s->weight, c->block.m, NOTHING);
    }
}

static void prepare_rules(struct computation *c)
{
    const struct valence *v = c->block.v;

    for (int i = 0; i < v->scheme->steps; i++)
        for (int n = 0; n < v->step[i].rules; n++)
            if (c->block.plain || !v->step[i].rule[n].rule->centre)
                prepare_rule(&c->block.rule[i][n], v->step[i].rule[n].rule, c);
}

/* Columns
 * ------- */

/* The net of unknown j. */
static struct net unit_net(const struct computation *c, int j)
{
    const struct unknown *at = &c->block.unknown[j];
    struct net out = net_of(&EXACT, c->block.v->scheme->mesh, c->block.rings);
    struct number one = number_from_whole(1), zero = number_from_whole(0);
    struct exact_pair value = { one, zero };

    if (at->kind == UNKNOWN_BISECTOR)
        value = (struct exact_pair) { c->turns.u, one };
    if (at->kind == UNKNOWN_Y)
        value = (struct exact_pair) { zero, one };
    *(struct exact_pair *)net_add(&out, at->a, at->b) = value;
    if (at->kind != UNKNOWN_X && at->kind != UNKNOWN_Y)
        return out;
    value.y = number_minus(&value.y);              /* V(b,a) = T (x, -y) */
    *(struct exact_pair *)net_add(&out, at->b, at->a) = image(c->turns.turn, &value, c->turns.k);
    return out;
}

/* The value of a net at unknown i; what is 0 may be zeroed memory. */
static struct number read_off(const struct net *net, const struct block *block, int i)
{
    const struct unknown *at = &block->unknown[i];
    const struct exact_pair *v = net_find(net, block, at->a, at->b);
    const struct number *out = at->kind == UNKNOWN_BISECTOR || at->kind == UNKNOWN_Y
                             ? &v->y : &v->x;

    return number_is_zero(out) ? number_from_whole(0) : *out;
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

    c->block = *block;
    c->block.own = &c->turns;
    c->turns.k = k;
    c->line = line;
    prepare_turns(c);
    prepare_rules(c);
    out.entry = allocate(n * n, sizeof out.entry[0]);
    for (size_t j = 0; j < n; j++) {
        struct mark mark = scratch_mark();
        struct net net = unit_net(c, (int)j);

        net = net_subdivide(&net, &c->block, block->rings);
        for (size_t i = 0; i < n; i++)
            column[i] = read_off(&net, &c->block, (int)i);
        number_keep(mark, column, n);
        for (size_t i = 0; i < n; i++)
            out.entry[i * n + j] = column[i];
    }
    return block->plain ? without_constants(out.entry, block->n) : out;
}
