/* refute_range.h: looking for a reason why a scheme is not C1 at many valences (verify/certificate-valences.md, section 6). */
#ifndef VERIFY_REFUTE_RANGE_H
#define VERIFY_REFUTE_RANGE_H

#include "analysis.h"

/* Why it was not C1 at the valence before, or on the box: what is likely to hold of the next ones. */
typedef struct {
    claim_kind claim; /* CLAIM_C1: nothing is known */
    long frequency;
} range_reason;

/* What a refutation says of the valences that follow; CLAIM_C1 also where its claim is not made of several valences. */
range_reason range_reason_after(claim_kind claim, long frequency);
static inline bool range_reason_is_one(range_reason r) { return r.claim != CLAIM_C1; }
static inline bool range_reason_equal(range_reason r, range_reason s) { return r.claim == s.claim && r.frequency == s.frequency; }

/* Tries the reason of all valences of a range of several, at one precision (0: hardware intervals), with plan's limits.
   OUTCOME_TRUE: c holds the choices that refute C1, f the figures.  OUTCOME_FAIL, OUTCOME_FALSE: nothing was proved. */
outcome refute_range(findings *f, choices *c, const analysis_plan *plan, valence_range k, range_reason r, long precision);

/* Why it is not C1, as a sentence without an end. */
void refute_range_describe(char *text, size_t size, const choices *c, const findings *f);

#endif
