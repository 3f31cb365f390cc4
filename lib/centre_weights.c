/* centre_weights.c: source by source, rule by rule. */
#include "centre_weights.h"

#include "scheme_range.h"

#include <string.h>

bool centre_weights_make(centre_weights *z, bool *known, const rule *r, valence_range k)
{
    laurent_value *rest = NULL;
    bool ok = true;
    memset(z, 0, sizeof *z);
    *known = true;
    z->count = r->count;
    for (int i = 0; ok && i < r->count; i++) {
        ok = laurent_value_make(&z->weight[i]);
        if (!r->sources[i].weight) {
            rest = &z->weight[i];
            ok = ok && laurent_value_set_si(rest, 1);
        }
    }
    for (int i = 0; ok && *known && i < r->count; i++) {
        if (!r->sources[i].weight)
            continue;
        ok = formula_laurent_value(&z->weight[i], known, r->sources[i].weight, k);
        if (ok && *known && rest)
            ok = laurent_value_sub(rest, &z->weight[i]);
    }
    return ok;
}

void centre_weights_clear(centre_weights *z)
{
    for (int i = 0; i < z->count; i++)
        laurent_value_clear(&z->weight[i]);
    z->count = 0;
}

static bool has_only_points(const rule *r)
{
    for (int i = 0; i < r->count; i++)
        if (r->sources[i].kind != SOURCE_CENTRE && r->sources[i].kind != SOURCE_POINT)
            return false;
    return true;
}

/* Of the rules that hold for other points than the centre. */
static status step_has_only_points(bool *only, const scheme_step *step, valence_range k, diagnostic *d)
{
    *only = true;
    for (int i = 0; *only && i < step->rule_count; i++) {
        const rule *r = &step->rules[i], *holds;
        status result = r->at_centre ? STATUS_OK : scheme_find_rule_range(&holds, step, false, r->point, k, d);
        if (result != STATUS_OK)
            return result;
        *only = r->at_centre || holds != r || has_only_points(r);
    }
    return STATUS_OK;
}

status scheme_centre_alone_varies(bool *alone, const scheme *s, valence_range k, diagnostic *d)
{
    truth decided = TRUTH_UNKNOWN;
    bool vary = true;
    status result = STATUS_OK;
    *alone = false;
    if (s->mesh == MESH_DUAL)
        return STATUS_OK;
    result = scheme_rules_decided(&decided, s, k, d);
    if (result == STATUS_OK && decided == TRUTH_TRUE)
        result = scheme_weights_vary(&vary, s, k, d);
    *alone = !vary;
    for (int i = 0; result == STATUS_OK && *alone && i < s->step_count; i++)
        result = step_has_only_points(alone, &s->steps[i], k, d);
    return result;
}
