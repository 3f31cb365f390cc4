/* The characteristic net: section 7 of certificate.md. */

#include "characteristic.h"

#include "scheme.h"

#include <string.h>

/* The ring
 * -------- */

static bool is_decided_on(enum element_kind kind, enum mesh mesh, bool boundary)
{
    if (mesh == TRIANGLE)
        return boundary ? kind == ELEMENT_E : kind == ELEMENT_U || kind == ELEMENT_D;
    return boundary ? kind == ELEMENT_G || kind == ELEMENT_H : kind == ELEMENT_S;
}

/* How far from an element its labels are. */
static int used_reach(const struct refinable *f, enum mesh mesh)
{
    bool boundary = f->shift_a == 0 && f->shift_b == 0;
    int out = 0;

    for (int kind = 0; kind < ELEMENT_KINDS; kind++) {
        int reach;

        if (!is_decided_on((enum element_kind)kind, mesh, boundary))
            continue;
        reach = window_reach(&f->window[kind], (enum element_kind)kind, mesh, f->shift_a,
                             f->shift_b);
        out = reach > out ? reach : out;
    }
    return out;
}

static int ring_radius(enum mesh mesh, int omega, int h, int influence)
{
    int r = 1, more = mesh == TRIANGLE ? 1 : 0;

    while (!(omega < r + more && omega + h < 2 * (r + more) && omega + influence < 2 * r))
        r++;
    return r;
}

/* The net
 * ------- */

struct pair characteristic_at(const struct characteristic *c, const struct refinable *f,
                              int a, int b)
{
    struct pair out = net_value(&c->net, c->block, a + f->shift_a, b + f->shift_b), here;

    if (f->shift_a == 0 && f->shift_b == 0)
        return out;
    here = net_value(&c->net, c->block, a, b);
    out.x = affine_sub(out.x, here.x);
    out.y = affine_sub(out.y, here.y);
    return out;
}

/* Thin nets
 * --------- */

static void add_error(interval *rho, interval x)
{
    integer most = integer_max(rho->hi, interval_rad(x));

    *rho = (interval) { integer_negate(most), most };
}

/* rho of f: the largest rad at the labels of the windows of the elements. */
static void collect_rho(struct refinable *f, const struct characteristic *c,
                        const struct element *element, int elements)
{
    for (int i = 0; i < elements; i++) {
        const struct window *window = &f->window[element[i].kind];

        for (int n = 0; n < window->count; n++) {
            struct pair value = characteristic_at(c, f, element[i].a + window->label[n].a,
                                                  element[i].b + window->label[n].b);

            add_error(&f->rho.x.c, value.x.c);
            add_error(&f->rho.x.d, value.x.d);
            add_error(&f->rho.y.c, value.y.c);
            add_error(&f->rho.y.d, value.y.d);
        }
    }
}

static void prepare_refinable(struct refinable *f, const struct mask *q, int64_t stability,
                              int shift_a, int shift_b, enum mesh mesh, int g)
{
    f->mask = stencil_make(q, 2, g);
    f->stability = stability;
    f->shift_a = shift_a;
    f->shift_b = shift_b;
    for (int kind = 0; kind < ELEMENT_KINDS; kind++)
        f->window[kind] = window_make((enum element_kind)kind, &f->mask, mesh);
}

/* The polynomials of limits, if the mask is of a box spline and trees ask for them. */
static void prepare_basis(struct refinable *f, const struct spline *s,
                          const struct characteristic *c, bool boundary, int g)
{
    f->has_basis = true;
    for (int kind = 0; kind < ELEMENT_KINDS; kind++)
        if (is_decided_on((enum element_kind)kind, c->mesh, boundary))
            f->has_basis = f->has_basis &&
                           basis_make(&f->basis[kind], s, (enum element_kind)kind, c->mesh,
                                      &f->window[kind], g);
}

static void prepare_bases(struct characteristic *out, const struct mask *mask, int g,
                          const struct certificate *c)
{
    struct spline s, derivative;

    if (!spline_find(&s, mask, out->mesh))
        return;
    for (int i = 0; i < 3; i++) {
        const struct trees *t = i == 0 ? &c->boundary : &c->regularity;

        derivative = i == 0 ? s : spline_derivative(&s, i - 1);
        if (t->size > 0 && memchr(t->word, '2', t->size) != NULL)
            prepare_basis(&out->f[i], &derivative, out, i == 0, g);
    }
}

void characteristic_begin(struct characteristic *out, const struct block *block,
                          const struct mask q[3], const struct certificate *c)
{
    const struct scheme *scheme = block->v->scheme;
    enum mesh mesh = scheme->mesh;
    int g = block->v->g, omega = 0, h = mask_reach(&scheme->mask, mesh);

    memset(out, 0, sizeof *out);                   /* zeroed memory is 0 */
    out->block = block;
    out->mesh = mesh;
    out->version_0 = c->version == 0;
    for (int i = 0; i < 3; i++) {
        int reach;

        prepare_refinable(&out->f[i], &q[i], c->stability[i], i == 1, i == 2, mesh, g);
        reach = used_reach(&out->f[i], mesh);
        omega = reach > omega ? reach : omega;
    }
    out->radius = ring_radius(mesh, omega, h, scheme_influence(scheme));
    out->elements = ring_elements(&out->element, mesh, out->radius, false);
    out->segments = ring_elements(&out->segment, mesh, out->radius, true);
    out->rings = 2 * out->radius + omega;
    prepare_bases(out, &scheme->mask, g, c);
}

/* Looks up each label that leaves will ask for: what a net finds it keeps, and trees, which release
 * memory, must find it there. */
void characteristic_use(struct characteristic *c, const struct net *net)
{
    c->net = *net;
    collect_rho(&c->f[0], c, c->segment, c->segments);
    collect_rho(&c->f[1], c, c->element, c->elements);
    collect_rho(&c->f[2], c, c->element, c->elements);
}

void characteristic_prepare(struct characteristic *out, const struct block *block,
                            const struct eigenpair *pair, const struct mask q[3],
                            const struct certificate *certificate)
{
    struct net net = net_make(block->v->scheme->mesh, block->rings);

    characteristic_begin(out, block, q, certificate);
    net_set_unknowns(&net, block, pair->unknowns);
    while (net.rings < out->rings)
        net = net_extend(&net, block, (struct pair) { pair->real, pair->imaginary }, out->rings);
    characteristic_use(out, &net);
}
