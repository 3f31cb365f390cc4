/* scheme.c: life of schemes, and which rules reach how far. */
#include "scheme_reader.h"

#include <stdlib.h>
#include <string.h>

void scheme_init(scheme *z)
{
    memset(z, 0, sizeof *z);
    laurent_init(&z->mask);
}

static void clear_rule(rule *r)
{
    formula_free(r->condition);
    for (int i = 0; i < r->count; i++) {
        formula_free(r->sources[i].weight);
        formula_free(r->sources[i].imaginary);
    }
}

void scheme_drop_step(scheme *z)
{
    scheme_step *s = &z->steps[--z->step_count];
    for (int j = 0; j < s->rule_count; j++)
        clear_rule(&s->rules[j]);
    free(s->rules);
    laurent_clear(&s->mask);
}

void scheme_clear(scheme *z)
{
    while (z->step_count)
        scheme_drop_step(z);
    laurent_clear(&z->mask);
    for (int i = 0; i < z->definitions.count; i++)
        formula_free(z->definitions.entry[i].value);
    text_clear(&z->source);
    free(z->text);
    scheme_init(z);
}

status scheme_rule_holds(truth *holds, const rule *r, valence_range k, diagnostic *d)
{
    formula_region at = {k, one_frequency(0), 0};
    formula_point start = formula_region_start(&at);
    bool one;
    status s;
    *holds = TRUTH_TRUE;
    if (!r->condition)
        return STATUS_OK;
    if (!is_one_valence(k)) {
        if (!formula_condition_range(holds, r->condition, &at))
            return STATUS_NO_MEMORY;
        if (*holds == TRUTH_UNKNOWN)
            diagnostic_set(d, r->condition->line, r->condition->column, "this condition is not known to hold, or not to hold, at all valences from %ld on", k.first);
        return STATUS_OK;
    }
    s = formula_condition(&one, r->condition, &start, d);
    *holds = one ? TRUTH_TRUE : TRUTH_FALSE;
    return s;
}

status scheme_find_rule_range(const rule **z, const scheme_step *s, bool at_centre, lattice p, valence_range k, diagnostic *d)
{
    *z = NULL;
    for (int i = 0; i < s->rule_count; i++) {
        const rule *r = &s->rules[i];
        truth holds;
        status result;
        if (r->at_centre != at_centre || (!at_centre && (r->point.a != p.a || r->point.b != p.b)))
            continue;
        result = scheme_rule_holds(&holds, r, k, d);
        if (result != STATUS_OK)
            return result;
        if (holds == TRUTH_UNKNOWN)
            return STATUS_BAD_INPUT;
        if (holds == TRUTH_TRUE) {
            *z = r;
            return STATUS_OK;
        }
    }
    return STATUS_OK;
}

int scheme_step_rings_needed(const scheme_step *step, int ring)
{
    int needed = (ring + step->reach) / step->dilation;
    for (int i = 0; i < step->rule_count; i++) { /* a rule may reach farther than the mask */
        const rule *r = &step->rules[i];
        if (!r->at_centre && mesh_ring(step->to, r->point.a, r->point.b) > ring)
            continue;
        for (int l = 0; l < r->count; l++) {
            int from = r->sources[l].kind == SOURCE_CENTRE ? 0 : mesh_ring(step->from, r->sources[l].point.a, r->sources[l].point.b);
            needed = from > needed ? from : needed;
        }
    }
    return needed;
}

int scheme_rings_needed(const scheme *s, int ring)
{
    for (int i = s->step_count - 1; i >= 0; i--)
        ring = scheme_step_rings_needed(&s->steps[i], ring);
    return ring;
}

/* Beyond the rings of a block (scheme_closed_rings) ring j needs less than j: one more at least. */
int scheme_rings_reached(const scheme *s, int known, int wanted)
{
    int upto = known;
    while (upto < wanted && scheme_rings_needed(s, upto + 1) <= known)
        upto++;
    return upto;
}

/* Beyond the rings on which a rule or the mask's reach matters, needed(j) <= (j + constant) / 2 < j. */
int scheme_closed_rings(const scheme *s)
{
    int rings = 1, far = 4 * SCHEME_MAX_REACH * (s->step_count + 1) + 100;
    for (int j = 1; j <= far; j++)
        if (scheme_rings_needed(s, j) >= j)
            rings = j;
    while (scheme_rings_needed(s, rings) > rings)
        rings = scheme_rings_needed(s, rings);
    return rings;
}
