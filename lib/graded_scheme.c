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

/* (One step with a rule of the centre is that of a mask: compositions begin with one that has none.) */
status scheme_centre_is_graded(bool *is, bool *varies, const scheme *s, valence_range k, diagnostic *d)
{
    const rule *centre = NULL;
    status result = STATUS_OK;
    *is = *varies = false;
    if (s->step_count == 1)
        result = scheme_centre_alone_varies(is, s, k, d);
    if (result == STATUS_OK && *is)
        result = scheme_find_rule_range(&centre, &s->steps[0], true, (lattice){0, 0}, k, d);
    *is = *is && centre;
    if (result == STATUS_OK && *is && !rule_is_graded(is, varies, centre, k))
        result = STATUS_NO_MEMORY;
    return result;
}
