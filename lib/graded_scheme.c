/* graded_scheme.c: the conditions. */
#include "graded_scheme.h"

#include "centre_weights.h"

static bool rule_is_graded(bool *is, bool *varies, const rule *r, valence_range k)
{
    centre_weights w;
    bool ok = centre_weights_make(&w, is, r, k);
    for (int i = 0; ok && *is && i < w.count; i++)
        *varies = *varies || !laurent_value_is_constant(&w.weight[i]);
    centre_weights_clear(&w);
    return ok;
}

static status step_is_graded(bool *is, bool *varies, const scheme_step *step, valence_range k, diagnostic *d)
{
    const rule *centre = NULL;
    status result = scheme_find_rule_range(&centre, step, true, (lattice){0, 0}, k, d);
    if (result == STATUS_OK && centre && !rule_is_graded(is, varies, centre, k))
        result = STATUS_NO_MEMORY;
    return result;
}

status scheme_centre_is_graded(bool *is, bool *varies, const scheme *s, valence_range k, diagnostic *d)
{
    status result = scheme_centre_alone_varies(is, s, k, d);
    *varies = false;
    for (int i = 0; result == STATUS_OK && *is && i < s->step_count; i++)
        result = step_is_graded(is, varies, &s->steps[i], k, d);
    return result;
}
