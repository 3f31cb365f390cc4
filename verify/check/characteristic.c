/* The characteristic net: section 7 of certificate.md. */

#include "characteristic.h"

#include "answer.h"

/* The ring
 * -------- */

static void raise_to(int *most, int candidate)
{
    if (candidate > *most)
        *most = candidate;
}

/* omega: how far from an element its points are. */
static int used_reach(const struct characteristic *c)
{
    const struct refinable *f[2] = { &c->first, &c->second };
    int omega = window_reach(&c->value.window[ELEMENT_E], ELEMENT_E, 0, 0);

    for (int i = 0; i < 2; i++) {
        raise_to(&omega, window_reach(&f[i]->window[ELEMENT_U], ELEMENT_U,
                                      f[i]->shift_a, f[i]->shift_b));
        raise_to(&omega, window_reach(&f[i]->window[ELEMENT_D], ELEMENT_D,
                                      f[i]->shift_a, f[i]->shift_b));
    }
    return omega;
}

static int ring_radius(int omega, int h)
{
    int r = 1;

    while (!(omega <= r && omega + h < 2 * (r + 1) && omega < 2 * r))
        r++;
    return r;
}

/* U(a,b) has its vertices at a + b and a + b + 1, D(a,b) at a + b + 1 and
 * a + b + 2; the elements lie in r <= a + b <= 2r.  E(a,b) lies at a + b + 1. */
void characteristic_range(int *first, int *last, const struct characteristic *c,
                          enum element_kind kind)
{
    int r = c->radius;

    if (kind == ELEMENT_U) {
        *first = r;
        *last = 2 * r - 1;
    } else if (kind == ELEMENT_D) {
        *first = r - 1;
        *last = 2 * r - 2;
    } else {
        *first = 2 * r - 1;
        *last = 2 * r - 1;
    }
}

/* The net
 * ------- */

/* V on the rings after R: V is an eigenvector of the scheme on the whole complex,
 * so V = (new value)/L.  Once the rings 1..q are known, the new values on the
 * rings up to 2q + 1 - h use no others. */
static void extend_net(struct net *net, const struct block *block,
                       const interval *eigenvalue, int h)
{
    int known = block->rings;

    while (known < net->rings) {
        int reach = 2 * known + 1 - h;

        if (reach <= known)
            cannot_check("the checker cannot extend the characteristic net");
        for (int ring = known + 1; ring <= reach && ring <= net->rings; ring++) {
            for (int b = 0; b < ring; b++) {
                struct pair *value = net_at(net, ring - b, b);

                net_new_value(value, net, block, ring - b, b);
                grid_div(&value->x, &value->x, eigenvalue, block->g);
                grid_div(&value->y, &value->y, eigenvalue, block->g);
            }
        }
        known = reach;
    }
}

void characteristic_at(struct pair *out, const struct characteristic *c,
                       const struct refinable *f, int a, int b)
{
    struct pair here;

    net_value(out, &c->net, &c->block->twist, a + f->shift_a, b + f->shift_b,
              c->block->g);
    if (f->shift_a == 0 && f->shift_b == 0)
        return;
    net_value(&here, &c->net, &c->block->twist, a, b, c->block->g);
    interval_sub(&out->x, &out->x, &here.x);
    interval_sub(&out->y, &out->y, &here.y);
}

/* Thin nets
 * --------- */

static void raise_to_rad(integer *rho, const interval *x)
{
    integer rad;

    interval_rad(&rad, x);
    if (integer_compare(&rad, rho) > 0)
        integer_set(rho, &rad);
}

/* rho_x, rho_y of f: the largest rad at the points of the windows of all elements
 * of this kind in the ring. */
static void collect_rho(struct refinable *f, const struct characteristic *c,
                        enum element_kind kind)
{
    const struct window *window = &f->window[kind];
    int first, last;

    characteristic_range(&first, &last, c, kind);
    for (int sum = first; sum <= last; sum++) {
        for (int b = 0; b <= sum; b++) {
            for (int i = 0; i < window->count; i++) {
                struct pair value;

                characteristic_at(&value, c, f, sum - b + window->point[i].a,
                                  b + window->point[i].b);
                raise_to_rad(&f->rho_x, &value.x);
                raise_to_rad(&f->rho_y, &value.y);
            }
        }
    }
}

static void prepare_refinable(struct refinable *f, int shift_a, int shift_b)
{
    f->shift_a = shift_a;
    f->shift_b = shift_b;
    for (int kind = 0; kind < ELEMENT_KINDS; kind++)
        window_prepare(&f->window[kind], (enum element_kind)kind, &f->mask);
    integer_set_small(&f->rho_x, 0);
    integer_set_small(&f->rho_y, 0);
}

void characteristic_prepare(struct characteristic *out, const struct block *block,
                            const struct eigenpair *pair, const struct mask *q1,
                            const struct mask *q2)
{
    int h = stencil_radius(block->mask);
    int omega;

    out->block = block;
    stencil_from_mask(&out->first.mask, q1, block->g);
    stencil_from_mask(&out->second.mask, q2, block->g);
    stencil_from_mask(&out->value.mask, &block->scheme->mask, block->g);
    prepare_refinable(&out->first, 1, 0);
    prepare_refinable(&out->second, 0, 1);
    prepare_refinable(&out->value, 0, 0);

    omega = used_reach(out);
    out->radius = ring_radius(omega, h);
    net_prepare(&out->net, 2 * out->radius + omega);
    net_from_unknowns(&out->net, block, pair->unknowns);
    extend_net(&out->net, block, &pair->eigenvalue, h);

    collect_rho(&out->first, out, ELEMENT_U);
    collect_rho(&out->first, out, ELEMENT_D);
    collect_rho(&out->second, out, ELEMENT_U);
    collect_rho(&out->second, out, ELEMENT_D);
    collect_rho(&out->value, out, ELEMENT_E);
}

void characteristic_clear(struct characteristic *c)
{
    net_clear(&c->net);
}
