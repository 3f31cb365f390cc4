/* influence.c: special points pass from step to step; what is left is followed path by path in one chart
   (lib/ring.md, 3). */
#include "influence.h"

#include <stdlib.h>
#include <string.h>

/* No number here exceeds some hundreds: masks reach 8, the 34 steps of a composition 1 or 2 each. */

static int larger(int x, int y)
{
    return x > y ? x : y;
}

/* How far the labels of a step's mask reach. */
static int label_reach(const scheme_step *s)
{
    int reach = 0;
    for (long a = s->mask.a0; a < s->mask.a0 + s->mask.na; a++)
        for (long b = s->mask.b0; b < s->mask.b0 + s->mask.nb; b++)
            if (!laurent_is_zero_at(&s->mask, a, b))
                reach = larger(reach, mesh_distance(s->to, (int)a, (int)b));
    return reach;
}

/* The old points that the mask asks for at x, one after the other: *next from 0. */
static bool next_source(lattice *y, long *next, const scheme_step *s, lattice x)
{
    const laurent *m = &s->mask;
    for (; *next < m->na * m->nb; ++*next) {
        int a = x.a - (int)(m->a0 + *next / m->nb), b = x.b - (int)(m->b0 + *next % m->nb);
        if (integer_is_zero(&m->coefficient[*next]) || a % s->dilation || b % s->dilation)
            continue;
        *y = (lattice){a / s->dilation, b / s->dilation};
        ++*next;
        return true;
    }
    return false;
}

/* ---- what rules do: special points ---- */

/* Which points of a net are special: at (a,b) of the sector, a and b up to `rings`; the centre always is. */
typedef struct {
    int rings; /* the farthest ring with one */
    int side;
    bool *at;
} special_net;

static bool *special_at(const special_net *z, lattice p)
{
    return &z->at[p.a * z->side + p.b];
}

static bool has_rule(const scheme_step *s, lattice p)
{
    for (int i = 0; i < s->rule_count; i++)
        if (!s->rules[i].at_centre && s->rules[i].point.a == p.a && s->rules[i].point.b == p.b)
            return true;
    return false;
}

/* Is the new value at p, of the sector, special, given the special old ones (`old`; NULL: there are none)? */
static bool becomes_special(const scheme_step *s, const special_net *old, lattice p)
{
    lattice y;
    if (has_rule(s, p))
        return true;
    for (long next = 0; next_source(&y, &next, s, p);) {
        int turns;
        if (mesh_is_centre(s->from, y.a, y.b)) {
            if (old)
                return true;
            continue;
        }
        if (!mesh_reduce(s->from, false, &y.a, &y.b, &turns))
            return true;
        if (old && y.a < old->side && y.b < old->side && *special_at(old, y))
            return true;
    }
    return false;
}

/* z = the special points after a step.  No special point is farther out than a rule, than the mask brings one from, or,
   for asking what is opposite, than the mask reaches (lib/ring.md, 3). */
static bool pass_step(special_net *z, const scheme_step *s, const special_net *old)
{
    int reach = label_reach(s), most = larger(reach, old ? s->dilation * old->rings + reach : 0);
    for (int i = 0; i < s->rule_count; i++)
        if (!s->rules[i].at_centre)
            most = larger(most, mesh_ring(s->to, s->rules[i].point.a, s->rules[i].point.b));
    z->rings = 0;
    z->side = most + 1;
    z->at = calloc((size_t)z->side * (size_t)z->side, sizeof *z->at);
    if (!z->at)
        return false;
    for (int a = 1; a <= most; a++)
        for (int b = s->to == MESH_DUAL; b <= most; b++)
            if (becomes_special(s, old, (lattice){a, b})) {
                *special_at(z, (lattice){a, b}) = true;
                z->rings = larger(z->rings, mesh_ring(s->to, a, b));
            }
    return true;
}

static bool farthest_special(int *ring, const scheme *s)
{
    special_net old = {0, 0, NULL}, new_net;
    bool ok = true;
    for (int i = 0; ok && i < s->step_count; i++) {
        ok = pass_step(&new_net, &s->steps[i], i ? &old : NULL);
        free(old.at);
        old = new_net;
    }
    free(old.at);
    *ring = old.rings;
    return ok;
}

/* ---- where charts differ ---- */

/* Does the point y of the chart of one sector have the same name in the chart of the sector `turns` further on? */
static bool same_in_charts(mesh_kind mesh, lattice y, int turns)
{
    lattice z = mesh_turn(mesh, y, -turns);
    int from_here, from_there;
    if (mesh_is_centre(mesh, y.a, y.b))
        return true;
    return mesh_reduce(mesh, false, &y.a, &y.b, &from_here) && mesh_reduce(mesh, false, &z.a, &z.b, &from_there)
           && y.a == z.a && y.b == z.b && from_here == from_there + turns;
}

/* The points of a net that some point of the sector depends on, in its chart; labels from -half to half. */
typedef struct {
    int half, side;
    bool *now, *before;
} path_net;

/* before = what the step asks for at the points of now.  false: two charts disagree on some of it. */
static bool follow_step(path_net *z, const scheme_step *s)
{
    memset(z->before, 0, (size_t)z->side * (size_t)z->side * sizeof *z->before);
    for (int i = 0; i < z->side * z->side; i++) {
        lattice x = {i / z->side - z->half, i % z->side - z->half}, reduced = x, y;
        int turns = 0;
        if (!z->now[i])
            continue;
        if (!mesh_is_centre(s->to, x.a, x.b) && !mesh_reduce(s->to, false, &reduced.a, &reduced.b, &turns))
            return false;
        for (long next = 0; next_source(&y, &next, s, x);) {
            if (!same_in_charts(s->from, y, turns))
                return false;
            z->before[(y.a + z->half) * z->side + y.b + z->half] = true;
        }
    }
    return true;
}

static bool fits_one_chart(path_net *z, const scheme *s, lattice x)
{
    bool fits = true;
    memset(z->now, 0, (size_t)z->side * (size_t)z->side * sizeof *z->now);
    z->now[(x.a + z->half) * z->side + x.b + z->half] = true;
    for (int i = s->step_count - 1; fits && i >= 0; i--) {
        bool *t = z->now;
        fits = follow_step(z, &s->steps[i]);
        z->now = z->before;
        z->before = t;
    }
    return fits;
}

static bool ring_fits(path_net *z, const scheme *s, int ring)
{
    for (int a = 1; a <= ring; a++)
        for (int b = s->mesh == MESH_DUAL; b <= ring; b++)
            if (mesh_ring(s->mesh, a, b) == ring && !fits_one_chart(z, s, (lattice){a, b}))
                return false;
    return true;
}

bool influence_farthest(int *ring, const scheme *s)
{
    path_net z;
    int reach = 0; /* of all steps, in labels of the new net: beyond it charts agree (lib/ring.md, 3) */
    bool ok;
    for (int i = 0; i < s->step_count; i++)
        reach = reach * s->steps[i].dilation + label_reach(&s->steps[i]);
    z.half = 2 * reach + 1;
    z.side = 2 * z.half + 1;
    z.now = malloc((size_t)z.side * (size_t)z.side * sizeof *z.now);
    z.before = malloc((size_t)z.side * (size_t)z.side * sizeof *z.before);
    ok = z.now && z.before && farthest_special(ring, s);
    for (int j = reach; ok && j > *ring; j--)
        if (!ring_fits(&z, s, j))
            *ring = j;
    free(z.now);
    free(z.before);
    return ok;
}
