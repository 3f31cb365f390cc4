/* uniform_range.c: intervals of many valences in place of those of one. */
#include "uniform_range.h"

#include "tests.h"

#include <math.h>
#include <string.h>

/* The largest half-width of a value: the thesis's interval_size is twice that. */
static double find_width(const sector_net *net, long prec)
{
    double width = 0;
    number radius;
    number_init(&radius);
    for (int i = 0; i < sector_size(net->rings); i++) {
        number_radius_upper(&radius, &net->x[i], prec);
        width = fmax(width, number_upper_bound(&radius));
        number_radius_upper(&radius, &net->y[i], prec);
        width = fmax(width, number_upper_bound(&radius));
    }
    number_clear(&radius);
    return width;
}

static bool make_net(analysis *a, twist *t, const number *x, const number *y, int rings, const number *u)
{
    if (!twist_set_u(t, u, a->prec) || !sector_net_make(&a->net, a->plan->problem->scheme->mesh, false, rings, t))
        return false;
    for (int i = 0; i < sector_size(rings); i++) {
        number_set(&a->net.x[i], &x[i]);
        number_set(&a->net.y[i], &y[i]);
    }
    a->net_made = true;
    return true;
}

outcome uniform_over_range(findings *f, choices *c, analysis_plan *p, const number *x, const number *y, int rings, const number *u, long prec)
{
    analysis a;
    twist t;
    bool made;
    outcome o = OUTCOME_NO_MEMORY;
    memset(&a, 0, sizeof a);
    a.plan = p;
    a.choices = c;
    a.findings = f;
    a.prec = prec;
    number_init(&a.scale);
    twist_init(&t);
    made = make_net(&a, &t, x, y, rings, u);
    for (int i = 0; made && i < RING_NETS; i++)
        made = mask_numbers_make(&a.mask[i], p->problem->geometry.mask[i], prec);
    if (made) {
        f->uniform_width = find_width(&a.net, prec);
        o = analysis_uniform(&a);
    }
    for (int i = 0; i < RING_NETS; i++)
        if (a.mask[i].mask)
            mask_numbers_free(&a.mask[i]);
    sector_net_free(&a.net);
    twist_clear(&t);
    number_clear(&a.scale);
    return o;
}
