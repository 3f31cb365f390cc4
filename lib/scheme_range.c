/* scheme_range.c: conditions and weights of all rules. */
#include "scheme_range.h"

status scheme_rules_decided(truth *decided, const scheme *s, valence_range k, diagnostic *d)
{
    *decided = TRUTH_TRUE;
    for (int i = 0; i < s->step_count; i++)
        for (int j = 0; j < s->steps[i].rule_count; j++) {
            const rule *r = &s->steps[i].rules[j];
            truth holds;
            status result = scheme_rule_holds(&holds, r, k, d);
            if (result != STATUS_OK)
                return result;
            if (holds == TRUTH_UNKNOWN) {
                *decided = TRUTH_UNKNOWN;
                return STATUS_OK;
            }
        }
    return STATUS_OK;
}

/* ---- cases ---- */

static bool is_condition(const formula *f)
{
    return f->kind == FORMULA_COMPARE || f->kind == FORMULA_AND || f->kind == FORMULA_OR;
}

/* Are all conditions on k alone in f decided?  (m may be anything, then.)  false: no memory. */
static bool conditions_decided(truth *decided, const formula *f, const formula_region *at)
{
    if (!(f->depends & FORMULA_ON_VALENCE))
        return true;
    if (f->kind == FORMULA_REFERENCE)
        return conditions_decided(decided, f->definition, at);
    if (is_condition(f)) {
        truth holds;
        if (f->depends & (FORMULA_ON_FREQUENCY | FORMULA_ON_SECTOR))
            return true;
        if (!formula_condition_range(&holds, f, at))
            return false;
        *decided = holds == TRUTH_UNKNOWN ? TRUTH_UNKNOWN : *decided;
        return true;
    }
    for (int i = 0; i < f->children; i++)
        if (f->child[i] && !conditions_decided(decided, f->child[i], at))
            return false;
    return true;
}

status scheme_cases_decided(truth *decided, const scheme *s, valence_range k, diagnostic *d)
{
    formula_region at = {k, one_frequency(0), 0};
    status result = scheme_rules_decided(decided, s, k, d);
    for (int i = 0; result == STATUS_OK && !is_one_valence(k) && i < s->step_count; i++)
        for (int j = 0; j < s->steps[i].rule_count; j++)
            for (int l = 0; l < s->steps[i].rules[j].count; l++) {
                const source *from = &s->steps[i].rules[j].sources[l];
                if ((from->weight && !conditions_decided(decided, from->weight, &at)) || (from->imaginary && !conditions_decided(decided, from->imaginary, &at)))
                    return STATUS_NO_MEMORY;
            }
    return result;
}

/* What is decided for a range is so for its parts: by bisection. */
status scheme_decided_up_to(long *last, const scheme *s, valence_range k, diagnostic *d)
{
    long beyond = k.last; /* not decided up to here, after the first step */
    truth decided;
    status result = scheme_cases_decided(&decided, s, k, d);
    *last = result == STATUS_OK && decided == TRUTH_TRUE ? k.last : k.first;
    while (result == STATUS_OK && *last < beyond - 1 && *last != k.last) {
        long span = beyond - *last, middle = *last + (beyond == VALENCES_UNBOUNDED && span > *last ? *last : span / 2);
        result = scheme_cases_decided(&decided, s, (valence_range){k.first, middle}, d);
        *(decided == TRUTH_TRUE ? last : &beyond) = middle;
    }
    return result;
}

/* ---- weights ---- */

static bool depends(const formula *f, unsigned on)
{
    return f && (f->depends & on) != 0;
}

/* Does rule j hold, and no earlier one for its point everywhere? */
static status may_be_in_force(bool *z, const scheme_step *s, int j, valence_range k, diagnostic *d)
{
    const rule *r = &s->rules[j];
    truth holds;
    status result = scheme_rule_holds(&holds, r, k, d);
    *z = holds != TRUTH_FALSE;
    for (int i = 0; result == STATUS_OK && *z && i < j; i++) {
        const rule *earlier = &s->rules[i];
        if (earlier->at_centre != r->at_centre || earlier->point.a != r->point.a || earlier->point.b != r->point.b)
            continue;
        result = scheme_rule_holds(&holds, earlier, k, d);
        *z = holds != TRUTH_TRUE;
    }
    return result;
}

static status weights_depend(bool *z, const scheme *s, valence_range k, unsigned on, diagnostic *d)
{
    *z = false;
    for (int i = 0; i < s->step_count; i++)
        for (int j = 0; j < s->steps[i].rule_count; j++) {
            const rule *r = &s->steps[i].rules[j];
            bool counts;
            status result = may_be_in_force(&counts, &s->steps[i], j, k, d);
            if (result != STATUS_OK)
                return result;
            for (int l = 0; l < r->count && !r->at_centre && counts; l++)
                *z = *z || depends(r->sources[l].weight, on) || depends(r->sources[l].imaginary, on);
        }
    return STATUS_OK;
}

status scheme_weights_vary(bool *vary, const scheme *s, valence_range k, diagnostic *d)
{
    return weights_depend(vary, s, k, FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY, d);
}

status scheme_weights_vary_with_frequency(bool *vary, const scheme *s, valence_range k, diagnostic *d)
{
    return weights_depend(vary, s, k, FORMULA_ON_FREQUENCY, d);
}
