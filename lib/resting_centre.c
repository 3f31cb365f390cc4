/* resting_centre.c: the conditions, rule by rule. */
#include "resting_centre.h"

#include "centre_weights.h"

static bool are_polynomials(const centre_weights *w)
{
    for (int i = 0; i < w->count; i++)
        if (laurent_value_high(&w->weight[i]) > 0)
            return false;
    return true;
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
    *rests = ok && known && are_polynomials(&w);
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

static status step_rests(bool *rests, const scheme_step *step, valence_range k, diagnostic *d)
{
    const rule *centre;
    status result = scheme_find_rule_range(&centre, step, true, (lattice){0, 0}, k, d);
    if (result != STATUS_OK)
        return result;
    *rests = centre || mask_rests(step);
    return !centre || centre_rule_rests(rests, centre, k) ? STATUS_OK : STATUS_NO_MEMORY;
}

status scheme_centre_rests(bool *rests, const scheme *s, valence_range k, diagnostic *d)
{
    status result = STATUS_OK;
    *rests = false;
    if (k.last == VALENCES_UNBOUNDED)
        result = scheme_centre_alone_varies(rests, s, k, d);
    for (int i = 0; result == STATUS_OK && *rests && i < s->step_count; i++)
        result = step_rests(rests, &s->steps[i], k, d);
    return result;
}
