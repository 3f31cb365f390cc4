/* Evident mirror symmetry: lib/scheme.md, "Mirror symmetry". */

#include "symmetry.h"

/* The axes of the sector that a point may lie on. */
enum axis { NO_AXIS, SPOKE, BISECTOR };

static enum axis axis_of(enum mesh mesh, int a, int b)
{
    if (a == b)
        return BISECTOR;
    return b == 0 && mesh != DUAL ? SPOKE : NO_AXIS;
}

/* Does the reflection in the axis map the source to itself? */
static bool source_is_mirrored(const struct source *s, enum axis axis, enum mesh mesh)
{
    switch (s->kind) {
    case SOURCE_CENTRE:
    case SOURCE_ALL:
        return true;
    case SOURCE_ONE:
        return s->sectors == 0 && axis_of(mesh, s->a, s->b) == axis;
    case SOURCE_SPECTRUM:
        return s->imaginary == NULL && axis_of(mesh, s->a, s->b) == axis;
    default:
        return false;
    }
}

static bool rule_is_mirrored(const struct rule *rule, const struct step *step)
{
    enum axis axis = axis_of(step->new, rule->a, rule->b);

    if (rule->centre)
        return true;
    if (axis == NO_AXIS)
        return false;
    for (int i = 0; i < rule->count; i++)
        if (!source_is_mirrored(&rule->source[i], axis, step->old))
            return false;
    return true;
}

bool scheme_is_mirrored(const struct scheme *scheme)
{
    for (int i = 0; i < scheme->steps; i++) {
        const struct step *step = &scheme->step[i];

        if (!mask_is_mirrored(&step->mask))
            return false;
        for (int n = 0; n < step->rules; n++)
            if (!rule_is_mirrored(&step->rule[n], step))
                return false;
    }
    return true;
}
