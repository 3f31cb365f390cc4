/* problem.c: the test of the regular complex, and what follows from the mask alone. */
#include "problem.h"

#include "../lib/stability.h"

#include <string.h>

void problem_init(problem *z)
{
    memset(z, 0, sizeof *z);
    regular_init(&z->regular);
    ring_init(&z->geometry);
    for (int i = 0; i < RING_NETS; i++)
        bernstein_init(&z->bernstein[i]);
    for (int i = 0; i < 3; i++)
        rational_init(&z->norm[i]);
}

void problem_clear(problem *z)
{
    regular_clear(&z->regular);
    ring_clear(&z->geometry);
    for (int i = 0; i < RING_NETS; i++)
        bernstein_clear(&z->bernstein[i]);
    for (int i = 0; i < 3; i++)
        rational_clear(&z->norm[i]);
}

/* How much larger than their data limits are.  (Certificates know the proofs by convexity and by windows.) */
static bool find_stability(problem *z)
{
    bool convex = true, ok = true;
    comparison c;
    comparison_init(&c);
    for (int i = 0; i < RING_NETS; i++)
        convex = convex && laurent_is_nonnegative(z->geometry.mask[i]);
    if (!convex) /* else the constants are not needed */
        ok = comparison_make(&c, &z->scheme->mask, &z->regular);
    for (int i = 0; ok && i < RING_NETS; i++) {
        stability s;
        if (i == RING_SECOND && z->regular.symmetric) {
            z->stability[i] = z->stability[RING_FIRST];
            continue;
        }
        ok = stability_find(&s, &z->scheme->mask, &z->regular, &c, i - 1);
        if (s.kind != STABILITY_CONVEX && s.kind != STABILITY_WINDOW)
            z->special_obstacle = "no bound for the limits of the mask and its derivatives was found by windows of a power of the scheme";
        z->stability[i] = (stability_choice){s.kind == STABILITY_WINDOW ? s.power : 0, s.bound};
    }
    comparison_clear(&c);
    return ok;
}

/* The masks of the derivatives have a factor less than that of values, so they are of box splines if it is. */
static bool find_polynomials(problem *z)
{
    bool ok = true;
    z->polynomial = true;
    for (int i = 0; ok && z->polynomial && i < RING_NETS; i++)
        ok = bernstein_make(&z->bernstein[i], &z->polynomial, z->scheme->mesh, z->geometry.mask[i], &z->geometry.stencil[i]);
    return ok;
}

bool problem_make(problem *z, const scheme *s)
{
    z->scheme = s;
    if (!regular_derive(&z->regular, &s->mask, s->mesh))
        return false;
    if (!z->regular.divisible) {
        z->obstacle = "the mask is not divisible by 1 + 1/z^e in all directions, so the norm criterion for the regular complex is silent";
        return true;
    }
    if (!regular_contraction(z->contraction, z->norm, &z->regular))
        return false;
    if (!z->contraction[0] || !z->contraction[1] || !z->contraction[2]) {
        z->obstacle = "no power of the second difference schemes that was tried has a norm below 1: C1 on the regular complex is not proved";
        return true;
    }
    return ring_make(&z->geometry, s, &z->regular) && find_stability(z) && find_polynomials(z);
}

status problem_is_plainly_regular(bool *plainly, const problem *z, long k, diagnostic *d)
{
    const scheme *s = z->scheme;
    *plainly = k == mesh_regular_valence(s->mesh);
    for (int i = 0; i < s->step_count; i++)
        for (int j = 0; *plainly && j < s->steps[i].rule_count; j++) {
            const rule *r = &s->steps[i].rules[j], *holds;
            status result = scheme_find_rule(&holds, &s->steps[i], r->at_centre, r->point, k, d);
            if (result != STATUS_OK)
                return result;
            *plainly = holds == NULL;
        }
    return STATUS_OK;
}
