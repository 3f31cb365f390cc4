/* Influence: lib/ring.md, section 3.
 *
 * A plane says which labels of the chart of one sector are regular.  That of the old net says so of
 * all; that of a step's new net follows from the one before it, label by label.  The valence is any
 * one greater than the regular one, so that there are opposite points; all rules are taken to hold.
 *
 * Far out all is regular.  Let irregular labels of the old plane lie on rings up to s, and the mask
 * reach h.  A label asks for labels whose ring is at least (ring - h)/dilation - 1, and not for
 * opposite ones, nor across more than one spoke, if its own is beyond 2 h + 2; so beyond dilation
 * (s + 1) + 2 h + 2 only rules can make it irregular.
 */

#include "scheme.h"

#include "sector.h"

struct plane {
    enum mesh mesh;
    int most;                                      /* |a|, |b| <= most */
    bool *irregular;
};

static bool *at(const struct plane *p, int a, int b)
{
    return &p->irregular[(a + p->most) * (2 * p->most + 1) + b + p->most];
}

/* Brings a label to its own sector, so many turns away. */
static enum place turn_home(enum mesh mesh, int *a, int *b, int *turns)
{
    *turns = 0;
    for (;;) {
        enum place place = label_turn(mesh, a, b);

        if (place != BEHIND && place != BEFORE)
            return place;
        *turns += place == BEHIND ? 1 : -1;
    }
}

/* Is (a,b) the same place as the label that is (a,b), named from a sector `turns`
 * further on, in that sector's chart? */
static bool charts_agree(enum mesh mesh, int a, int b, int turns)
{
    int x = a, y = b, here, there;
    enum place place = turn_home(mesh, &a, &b, &here), other;

    for (int i = 0; i < turns; i++)
        label_from_next(mesh, &x, &y);
    for (int i = 0; i > turns; i--)
        label_from_before(mesh, &x, &y);
    other = turn_home(mesh, &x, &y, &there);
    if (place == CENTRE || other == CENTRE)
        return place == other;
    return place == IN_SECTOR && other == IN_SECTOR && a == x && b == y && here == turns + there;
}

static bool has_rule(const struct step *step, int a, int b)
{
    for (int i = 0; i < step->rules; i++)
        if (!step->rule[i].centre && step->rule[i].a == a && step->rule[i].b == b)
            return true;
    return false;
}

/* Is the new label regular, if it is no more than the mask's reach within the plane? */
static bool is_regular(const struct step *step, const struct points *mask,
                       const struct plane *old, int a, int b)
{
    int own_a = a, own_b = b, turns;

    if (turn_home(step->new, &own_a, &own_b, &turns) != IN_SECTOR || has_rule(step, own_a, own_b))
        return false;
    for (int i = 0; i < mask->count; i++) {
        int x = a - mask->point[i].a, y = b - mask->point[i].b;

        if (x % step->dilation != 0 || y % step->dilation != 0)
            continue;
        x /= step->dilation;
        y /= step->dilation;
        if (*at(old, x, y) || !charts_agree(step->old, x, y, turns))
            return false;
    }
    return true;
}

static struct plane new_plane(enum mesh mesh, int most)
{
    size_t side = 2 * (size_t)most + 1;
    struct plane out = { mesh, most, allocate(side * side, sizeof out.irregular[0]) };

    return out;
}

/* Beyond this ring of the last net all is regular. */
static int far_ring(const struct scheme *scheme)
{
    int out = 0;

    for (int i = 0; i < scheme->steps; i++) {
        const struct step *step = &scheme->step[i];

        out = step->dilation * (out + 2) + 2 * step->reach + 4;
        for (int n = 0; n < step->rules; n++) {
            const struct rule *rule = &step->rule[n];
            int ring = rule->centre ? 0 : label_ring(step->new, rule->a, rule->b);

            out = ring > out ? ring : out;
        }
    }
    return out;
}

int scheme_influence(const struct scheme *scheme)
{
    struct mark mark = scratch_mark();
    int far = far_ring(scheme), most = far, out = 0;
    struct plane plane;

    for (int i = 0; i < scheme->steps; i++)
        most += scheme->step[i].reach + 2;
    plane = new_plane(scheme->mesh, most);
    for (int i = 0; i < scheme->steps; i++) {
        const struct step *step = &scheme->step[i];
        struct points mask = mask_points(&step->mask);
        struct plane new;

        most -= step->reach + 2;
        new = new_plane(step->new, most);
        for (int a = -most; a <= most; a++)
            for (int b = -most; b <= most; b++)
                *at(&new, a, b) = !is_regular(step, &mask, &plane, a, b);
        plane = new;
    }
    for (int a = 1; a <= far; a++)
        for (int b = 0; label_ring(plane.mesh, a, b) <= far; b++)
            if (*at(&plane, a, b) && (b > 0 || plane.mesh != DUAL) &&
                label_ring(plane.mesh, a, b) > out)
                out = label_ring(plane.mesh, a, b);
    scratch_release(mark);
    return out;
}
