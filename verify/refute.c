/* refute.c: the reasons, one after the other. */
#include "refute.h"

#include <stdio.h>
#include <string.h>

/* A radius this near to 1 may be beyond. */
#define NEARLY_ONE (1 - 1e-9)

static outcome attempt_claim(findings *f, choices *c, const analysis_plan *plan, claim_kind claim, long frequency, long valence, long precision)
{
    analysis_plan own = {.problem = plan->problem, .max_level = plan->max_level, .deadline = plan->deadline, .system = plan->system};
    choices_clear(c);
    c->claim = claim;
    c->frequency = frequency;
    c->k = one_valence(valence);
    f->level = 0;
    f->elements = 0;
    return analysis_search(f, c, &own, precision);
}

static bool is_final(outcome o)
{
    return o == OUTCOME_TRUE || o == OUTCOME_NO_MEMORY || o == OUTCOME_STOPPED;
}

static outcome look_for_candidates(suspicion *s, const analysis_plan *plan, long valence, bool hardware)
{
    diagnostic unused;
    status result;
    if (s->made)
        return OUTCOME_TRUE;
    result = hardware ? candidates_find_interval(&s->candidates, plan->problem->scheme, valence, &unused)
                      : candidates_find_ball(&s->candidates, plan->problem->scheme, valence, &unused);
    s->made = true;
    if (result != STATUS_OK)
        s->candidates.count = 0;
    return result == STATUS_NO_MEMORY ? OUTCOME_NO_MEMORY : OUTCOME_TRUE;
}

outcome refute(findings *f, choices *c, suspicion *s, const analysis_plan *plan, long valence, long precision)
{
    outcome o = look_for_candidates(s, plan, valence, precision == 0);
    if (o != OUTCOME_TRUE)
        return o;
    o = OUTCOME_FAIL;
    if (s->folds)
        o = attempt_claim(f, c, plan, CLAIM_FOLD, 1, valence, precision);
    for (int i = 0; !is_final(o) && i < s->candidates.count; i++) {
        long m = s->candidates.frequency[i];
        if (2 * m == valence)
            continue;
        if (s->candidates.radius[i] > NEARLY_ONE)
            o = attempt_claim(f, c, plan, CLAIM_NOT_C0, m, valence, precision);
        if (!is_final(o) && m != 1)
            o = attempt_claim(f, c, plan, CLAIM_FREQUENCY, m, valence, precision);
    }
    return is_final(o) ? o : OUTCOME_FAIL;
}

void refute_describe(char *text, size_t size, const choices *c, const findings *f, const suspicion *s)
{
    double l = f->eigenvalue_lower;
    switch (c->claim) {
    case CLAIM_FREQUENCY:
        if (c->frequency)
            snprintf(text, size, "frequency %ld dominates (%.8f, frequency 1 has %.8f); the surface would wind %ld times", c->frequency, l, s->candidates.radius_of_one, c->frequency);
        else
            snprintf(text, size, "frequency 0 dominates (%.8f, frequency 1 has %.8f); nothing turns round the point", l, s->candidates.radius_of_one);
        break;
    case CLAIM_NOT_C0:
        snprintf(text, size, "block %ld has an eigenvalue beyond 1 (%.8f); there is no continuous limit", c->frequency, l);
        break;
    case CLAIM_FOLD:
        snprintf(text, size, "the characteristic map folds; its Jacobian has both signs");
        break;
    default:
        text[0] = '\0';
    }
}
