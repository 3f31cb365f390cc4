/* Sector nets and the blocks of the subdivision matrix: section 5 of
 * certificate.md. */

#include "sector.h"

#include "answer.h"
#include "trig.h"

#include <stdlib.h>

void pair_set(struct pair *out, const struct pair *v)
{
    interval_set(&out->x, &v->x);
    interval_set(&out->y, &v->y);
}

/* Rotation
 * -------- */

static void prepare_twist(struct twist *out, int k, int m, int g)
{
    rational q;
    interval one, square;

    out->m = m;
    if (m == 0)
        return;
    rational_set_small(&q, m, k);
    grid_set_small(&one, 1, g);
    grid_cos_pi(&out->u, &q, g);                   /* u = cos(w/2) */
    interval_add(&out->v, &out->u, &out->u);
    grid_mul(&out->c, &out->v, &out->u, g);        /* c = 2u^2 - 1 = cos w */
    interval_sub(&out->c, &out->c, &one);
    grid_mul(&square, &out->u, &out->u, g);
    interval_sub(&square, &one, &square);
    grid_mul(&out->n, &out->v, &square, g);        /* n = sin w sin(w/2) */
}

/* T (x, y) = (c x - n y, v x + c y) */
static void turn_forward(struct pair *p, const struct twist *t, int g)
{
    interval cx, ny, vx, cy;

    if (t->m == 0)
        return;
    grid_mul(&cx, &t->c, &p->x, g);
    grid_mul(&ny, &t->n, &p->y, g);
    grid_mul(&vx, &t->v, &p->x, g);
    grid_mul(&cy, &t->c, &p->y, g);
    interval_sub(&p->x, &cx, &ny);
    interval_add(&p->y, &vx, &cy);
}

/* T^-1 (x, y) = (c x + n y, c y - v x) */
static void turn_backward(struct pair *p, const struct twist *t, int g)
{
    interval cx, ny, vx, cy;

    if (t->m == 0)
        return;
    grid_mul(&cx, &t->c, &p->x, g);
    grid_mul(&ny, &t->n, &p->y, g);
    grid_mul(&vx, &t->v, &p->x, g);
    grid_mul(&cy, &t->c, &p->y, g);
    interval_add(&p->x, &cx, &ny);
    interval_sub(&p->y, &cy, &vx);
}

/* Nets
 * ---- */

/* Ring j = a + b begins behind the 1 + 2 + ... + (j-1) points of the rings
 * before it. */
struct pair *net_at(const struct net *net, int a, int b)
{
    int ring = a + b;

    if (a < 1 || b < 0 || ring > net->rings)
        cannot_check("the checker looks for a point outside of its net");
    return &net->value[ring * (ring - 1) / 2 + b];
}

void net_prepare(struct net *out, int rings)
{
    out->rings = rings;                            /* zeroed memory is 0 */
    out->value = allocate((size_t)(rings * (rings + 1) / 2), sizeof out->value[0]);
    interval_set(&out->centre.x, &out->value[0].x);
    interval_set(&out->centre.y, &out->value[0].y);
}

void net_clear(struct net *net)
{
    free(net->value);
}

void net_value(struct pair *out, const struct net *net, const struct twist *twist,
               int a, int b, int g)
{
    if (a == 0 && b == 0) {
        pair_set(out, &net->centre);
    } else if (a >= 1 && b >= 0) {
        pair_set(out, net_at(net, a, b));
    } else if (b >= 1) {                           /* and a <= 0 */
        net_value(out, net, twist, a + b, -a, g);
        turn_forward(out, twist, g);
    } else if (a >= 0) {                           /* and b <= -1 */
        net_value(out, net, twist, -b, a + b, g);
        turn_backward(out, twist, g);
    } else {                                       /* a < 0, b <= 0 */
        cannot_check("a rule uses a point opposite to its sector; "
                     "version 0 has no such rules");
    }
}

void net_new_value(struct pair *out, const struct net *net,
                   const struct block *block, int a, int b)
{
    int g = block->g;
    struct pair old, sum;
    interval product;

    grid_set_small(&sum.x, 0, g);
    grid_set_small(&sum.y, 0, g);
    for (int i = 0; i < block->mask->count; i++) {
        const struct stencil_entry *entry = &block->mask->entry[i];

        if ((a - entry->a) % 2 != 0 || (b - entry->b) % 2 != 0)
            continue;
        net_value(&old, net, &block->twist, (a - entry->a) / 2,
                  (b - entry->b) / 2, g);
        grid_mul(&product, &entry->weight, &old.x, g);
        interval_add(&sum.x, &sum.x, &product);
        grid_mul(&product, &entry->weight, &old.y, g);
        interval_add(&sum.y, &sum.y, &product);
    }
    pair_set(out, &sum);
}

/* Unknowns
 * -------- */

int block_size(int h)
{
    int rings = h > 1 ? h : 1;

    return rings * (rings + 1) / 2;
}

static void add_unknown(struct block *out, int a, int b, enum unknown_kind kind)
{
    struct unknown *unknown = &out->unknown[out->n++];

    unknown->a = a;
    unknown->b = b;
    unknown->kind = kind;
}

static void list_unknowns(struct block *out)
{
    out->n = 0;
    out->unknown = allocate((size_t)block_size(out->rings) + 1,
                            sizeof out->unknown[0]);
    if (out->twist.m == 0)
        add_unknown(out, 0, 0, CENTRE);
    for (int ring = 1; ring <= out->rings; ring++) {
        for (int b = 0; b < ring; b++) {
            int a = ring - b;

            if (out->twist.m == 0) {
                add_unknown(out, a, b, PLAIN);
            } else if (b == 0) {
                add_unknown(out, a, b, SPOKE);
            } else if (a == b) {
                add_unknown(out, a, b, BISECTOR);
            } else if (a > b) {
                add_unknown(out, a, b, PAIR_X);
                add_unknown(out, a, b, PAIR_Y);
            }
        }
    }
}

void net_from_unknowns(struct net *out, const struct block *block,
                       const interval *unknowns)
{
    const struct twist *twist = &block->twist;

    for (int i = 0; i < block->n; i++) {
        const struct unknown *unknown = &block->unknown[i];
        int a = unknown->a, b = unknown->b;

        switch (unknown->kind) {
        case CENTRE:
            interval_set(&out->centre.x, &unknowns[i]);
            break;
        case PLAIN:
        case SPOKE:
            interval_set(&net_at(out, a, b)->x, &unknowns[i]);
            break;
        case BISECTOR:
            grid_mul(&net_at(out, a, b)->x, &twist->u, &unknowns[i], block->g);
            interval_set(&net_at(out, a, b)->y, &unknowns[i]);
            break;
        case PAIR_X:                               /* PAIR_Y is unknown i + 1 */
            interval_set(&net_at(out, a, b)->x, &unknowns[i]);
            interval_set(&net_at(out, a, b)->y, &unknowns[i + 1]);
            interval_set(&net_at(out, b, a)->x, &unknowns[i]);
            interval_minus(&net_at(out, b, a)->y, &unknowns[i + 1]);
            turn_forward(net_at(out, b, a), twist, block->g);
            break;
        case PAIR_Y:
            break;
        }
    }
}

/* Blocks
 * ------ */

void block_prepare(struct block *out, const struct scheme *scheme,
                   const struct stencil *mask, int k, int m, int g)
{
    int h = stencil_radius(mask);

    out->scheme = scheme;
    out->mask = mask;
    out->g = g;
    out->rings = h > 1 ? h : 1;
    prepare_twist(&out->twist, k, m, g);
    list_unknowns(out);
}

void block_clear(struct block *block)
{
    free(block->unknown);
}

/* The new net of `net`, read off at an unknown. */
static void read_off(interval *out, const struct net *net,
                     const struct block *block, const struct unknown *unknown)
{
    struct pair new;

    if (unknown->kind == CENTRE) {
        interval product;

        grid_mul(&product, &block->scheme->centre, &net->centre.x, block->g);
        grid_mul(&new.x, &block->scheme->all, &net_at(net, 1, 0)->x, block->g);
        interval_add(out, &product, &new.x);
        return;
    }
    net_new_value(&new, net, block, unknown->a, unknown->b);
    if (unknown->kind == BISECTOR || unknown->kind == PAIR_Y)
        interval_set(out, &new.y);
    else
        interval_set(out, &new.x);
}

interval *block_matrix(const struct block *block)
{
    size_t n = (size_t)block->n;
    interval *matrix = allocate(n * n, sizeof matrix[0]);
    interval *unit = allocate(n, sizeof unit[0]);
    struct net net;

    net_prepare(&net, block->rings);
    for (size_t j = 0; j < n; j++) {
        grid_set_small(&unit[j], 1, block->g);
        net_from_unknowns(&net, block, unit);
        for (size_t i = 0; i < n; i++)
            read_off(&matrix[i * n + j], &net, block, &block->unknown[i]);
        grid_set_small(&unit[j], 0, block->g);
    }
    net_clear(&net);
    free(unit);
    return matrix;
}
