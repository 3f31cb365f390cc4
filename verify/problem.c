/* problem.c: the test of the regular complex, and the geometry of the ring. */
#include "problem.h"

#include <string.h>

void problem_init(problem *z)
{
    memset(z, 0, sizeof *z);
    regular_init(&z->regular);
    ring_init(&z->geometry);
    for (int i = 0; i < 3; i++)
        rational_init(&z->norm[i]);
}

void problem_clear(problem *z)
{
    regular_clear(&z->regular);
    ring_clear(&z->geometry);
    for (int i = 0; i < 3; i++)
        rational_clear(&z->norm[i]);
}

/* Formulas that certificates of version 0 can contain (lib/scheme-0.md). */
static bool is_plain(const formula *f)
{
    switch (f->kind) {
    case FORMULA_NUMBER:
    case FORMULA_PI:
    case FORMULA_VARIABLE:
        return true;
    case FORMULA_POWER:
        return is_plain(f->child[0]) && (f->child[1]->kind == FORMULA_NUMBER || (f->child[1]->kind == FORMULA_NEGATE && f->child[1]->child[0]->kind == FORMULA_NUMBER));
    case FORMULA_NEGATE:
    case FORMULA_COS_SIN:
        return is_plain(f->child[0]);
    case FORMULA_BINARY:
        return is_plain(f->child[0]) && is_plain(f->child[1]);
    default:
        return false;
    }
}

/* A mask on triangles and one rule: centre, and the ring of neighbours. */
static bool is_covered(const scheme *s)
{
    const scheme_step *step = &s->steps[0];
    const rule *r = step->rules;
    if (s->mesh != MESH_TRIANGLE || !s->mirror_symmetric || s->definitions.count || step->rule_count != 1)
        return false;
    if (!r->at_centre || r->condition || r->count != 2 || r->sources[0].kind != SOURCE_CENTRE || r->sources[1].kind != SOURCE_ALL)
        return false;
    for (int i = 0; i < 2; i++)
        if (r->sources[i].weight && !is_plain(r->sources[i].weight))
            return false;
    return r->sources[1].point.a == 1 && r->sources[1].point.b == 0;
}

bool problem_make(problem *z, const scheme *s)
{
    z->scheme = s;
    if (!is_covered(s)) {
        z->obstacle = "proofs of this version cover mirror-symmetric masks on triangles with one rule, for the centre from 'centre' and 'all (1,0)', without definitions or cases";
        return true;
    }
    if (!regular_derive(&z->regular, &s->mask, s->mesh))
        return false;
    if (!z->regular.divisible) {
        z->obstacle = "the mask is not divisible by 1 + 1/z^e in all directions, so the norm criterion for the regular complex is silent";
        return true;
    }
    if (!regular_contraction(z->contraction, z->norm, &z->regular) || !ring_make(&z->geometry, s, &z->regular))
        return false;
    if (!z->contraction[0] || !z->contraction[1] || !z->contraction[2])
        z->obstacle = "no power of the second difference schemes that was tried has a norm below 1: C1 on the regular complex is not proved";
    else if (!z->geometry.nonnegative)
        z->obstacle = "the mask or one of its derivative masks has negative weights, which this version does not cover";
    return true;
}
