/* refute_range.c: one kind of claim, or two, for each reason. */
#include "refute_range.h"

#include "../lib/graded_scheme.h"
#include "../lib/scheme_range.h"

#include <math.h>
#include <stdio.h>

range_reason range_reason_after(claim_kind claim, long frequency)
{
    switch (claim) {
    case CLAIM_FREQUENCY:
    case CLAIM_WINDOW:
    case CLAIM_NOT_C0:
    case CLAIM_FOLD:
        return (range_reason){claim, frequency};
    case CLAIM_MODULUS_ONE: /* what is 1 here may be more there */
    case CLAIM_GRADED:
        return (range_reason){CLAIM_NOT_C0, frequency};
    default:
        return (range_reason){CLAIM_C1, 0};
    }
}

static outcome attempt_claim(findings *f, choices *c, const analysis_plan *plan, valence_range k, claim_kind claim, long frequency, long precision)
{
    analysis_plan own = {.problem = plan->problem, .max_level = plan->max_level, .max_elements = plan->max_elements, .deadline = plan->deadline, .system = plan->system};
    choices_clear(c);
    c->claim = claim;
    c->frequency = frequency;
    c->k = k;
    f->level = 0;
    f->elements = 0;
    return analysis_search(f, c, &own, precision);
}

/* Where the eigenvalue changes with k, intervals of weights would be too wide. */
static outcome attempt_growth(findings *f, choices *c, const analysis_plan *plan, valence_range k, long frequency, long precision)
{
    diagnostic unused;
    bool is = false, varies = false;
    if (frequency == 0 && scheme_centre_is_graded(&is, &varies, plan->problem->scheme, k, &unused) == STATUS_NO_MEMORY)
        return OUTCOME_NO_MEMORY;
    return attempt_claim(f, c, plan, k, is && varies ? CLAIM_GRADED : CLAIM_NOT_C0, frequency, precision);
}

/* If blocks are functions of m/k alone, whichever frequency falls into a window dominates. */
static outcome attempt_window(findings *f, choices *c, const analysis_plan *plan, valence_range k, long precision)
{
    diagnostic unused;
    bool vary = true;
    if (scheme_weights_vary_with_frequency(&vary, plan->problem->scheme, k, &unused) == STATUS_NO_MEMORY)
        return OUTCOME_NO_MEMORY;
    return vary ? OUTCOME_FAIL : attempt_claim(f, c, plan, k, CLAIM_WINDOW, 2, precision);
}

outcome refute_range(findings *f, choices *c, const analysis_plan *plan, valence_range k, range_reason r, long precision)
{
    outcome o = OUTCOME_FAIL;
    if (r.claim == CLAIM_NOT_C0)
        return attempt_growth(f, c, plan, k, r.frequency, precision);
    if (r.frequency > 1)
        o = attempt_window(f, c, plan, k, precision);
    if (o == OUTCOME_TRUE || o == OUTCOME_NO_MEMORY || o == OUTCOME_STOPPED || r.claim == CLAIM_WINDOW)
        return o;
    return attempt_claim(f, c, plan, k, r.claim, r.frequency, precision);
}

void refute_range_describe(char *text, size_t size, const choices *c, const findings *f)
{
    double l = f->eigenvalue_lower;
    switch (c->claim) {
    case CLAIM_FREQUENCY:
        if (c->frequency)
            snprintf(text, size, "at each of them frequency %ld dominates (by %.8f at least); the surface would wind %ld times", c->frequency, l, c->frequency);
        else
            snprintf(text, size, "at each of them frequency 0 dominates (by %.8f at least); nothing turns round the point", l);
        break;
    case CLAIM_WINDOW:
        snprintf(text, size, "at each of them a frequency m with m/k from %.6f to %.6f dominates (by %.8f at least); the surface would wind m times",
                 ldexp((double)c->window.start, -ARC_BITS), ldexp((double)window_choice_end(&c->window), -ARC_BITS), l);
        break;
    case CLAIM_NOT_C0:
        snprintf(text, size, "at each of them block %ld has an eigenvalue beyond 1 (%.8f at least); there is no continuous limit", c->frequency, l);
        break;
    case CLAIM_GRADED:
        snprintf(text, size, "at each of them block 0 has an eigenvalue beyond 1 (%.8f at least), which grows like k^%d; there is no continuous limit", l, c->graded.degree);
        break;
    case CLAIM_FOLD:
        snprintf(text, size, "at each of them the characteristic map folds; its Jacobian has both signs");
        break;
    default:
        text[0] = '\0';
    }
}
