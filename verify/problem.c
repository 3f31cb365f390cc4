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

bool problem_make(problem *z, const scheme *s)
{
    z->scheme = s;
    if (!regular_derive(&z->regular, &s->mask))
        return false;
    if (!z->regular.divisible) {
        z->obstacle = "the mask is not divisible by 1 + 1/z^e in all directions, so the norm criterion for the regular complex is silent";
        return true;
    }
    if (!regular_contraction(z->contraction, z->norm, &z->regular) || !ring_make(&z->geometry, s, &z->regular))
        return false;
    if (!z->contraction[0] || !z->contraction[1] || !z->contraction[2])
        z->obstacle = "no power of the second difference schemes up to 6 has a norm below 1: C1 on the regular complex is not proved";
    else if (!z->geometry.nonnegative)
        z->obstacle = "the mask or one of its derivative masks has negative weights, which this version does not cover";
    return true;
}
