/* resting_centre.c: the conditions, rule by rule. */
#include "resting_centre.h"

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
    for (int i = 0; ok && *known && i < r->count; i++)
        *known = laurent_value_high(&z->weight[i]) <= 0;
    return ok;
}

void centre_weights_clear(centre_weights *z)
{
    for (int i = 0; i < z->count; i++)
        laurent_value_clear(&z->weight[i]);
    z->count = 0;
}

/* At 1/k = 0: 1 for the centre, 0 for all others. */
static bool keeps_centre(bool *keeps, const rule *r, const centre_weights *w)
{
    laurent_value centre;
    bool ok = laurent_value_make(&centre);
    *keeps = true;
    for (int i = 0; ok && i < r->count; i++) {
        if (r->sources[i].kind == SOURCE_CENTRE)
            ok = laurent_value_add(&centre, &w->weight[i]);
        else
            *keeps = *keeps && rational_is_zero(laurent_value_at(&w->weight[i], 0));
    }
    *keeps = ok && *keeps && rational_cmp_si(laurent_value_at(&centre, 0), 1, 1) == 0;
    laurent_value_clear(&centre);
    return ok;
}

static bool centre_rule_rests(bool *rests, const rule *r, valence_range k)
{
    centre_weights w;
    bool known, ok = centre_weights_make(&w, &known, r, k);
    *rests = ok && known;
    if (*rests)
        ok = keeps_centre(rests, r, &w);
    centre_weights_clear(&w);
    return ok;
}

/* Without a rule the mask must give the centre its old value. */
static bool mask_rests(const scheme_step *step)
{
    const laurent *m = &step->mask;
    bool one = false;
    for (long a = m->a0; a < m->a0 + m->na; a++)
        for (long b = m->b0; b < m->b0 + m->nb; b++) {
            if (a % step->dilation || b % step->dilation || laurent_is_zero_at(m, a, b))
                continue;
            if (a || b)
                return false;
            one = integer_cmp(laurent_at(m, 0, 0), &m->denominator) == 0;
        }
    return one;
}

static bool has_only_points(const rule *r)
{
    for (int i = 0; i < r->count; i++)
        if (r->sources[i].kind != SOURCE_CENTRE && r->sources[i].kind != SOURCE_POINT)
            return false;
    return true;
}

static status step_rests(bool *rests, const scheme_step *step, valence_range k, diagnostic *d)
{
    const rule *centre;
    status result = scheme_find_rule_range(&centre, step, true, (lattice){0, 0}, k, d);
    if (result != STATUS_OK)
        return result;
    *rests = centre || mask_rests(step);
    if (centre && !centre_rule_rests(rests, centre, k))
        return STATUS_NO_MEMORY;
    for (int i = 0; *rests && i < step->rule_count; i++) {
        const rule *r = &step->rules[i], *holds;
        result = r->at_centre ? STATUS_OK : scheme_find_rule_range(&holds, step, false, r->point, k, d);
        if (result != STATUS_OK)
            return result;
        *rests = r->at_centre || holds != r || has_only_points(r);
    }
    return STATUS_OK;
}

status scheme_centre_rests(bool *rests, const scheme *s, valence_range k, diagnostic *d)
{
    truth decided = TRUTH_UNKNOWN;
    bool vary = true;
    status result = STATUS_OK;
    *rests = false;
    if (s->mesh == MESH_DUAL || k.last != VALENCES_UNBOUNDED)
        return STATUS_OK;
    result = scheme_rules_decided(&decided, s, k, d);
    if (result == STATUS_OK && decided == TRUTH_TRUE)
        result = scheme_weights_vary(&vary, s, k, d);
    *rests = !vary;
    for (int i = 0; result == STATUS_OK && *rests && i < s->step_count; i++)
        result = step_rests(rests, &s->steps[i], k, d);
    return result;
}
