/* refute.h: looking for a reason why a scheme is not C1 at a valence (verify/certificate.md, section 10). */
#ifndef VERIFY_REFUTE_H
#define VERIFY_REFUTE_H

#include "analysis.h"
#include "candidates.h"

/* What the search for a proof of C1 has found that may be a reason. */
typedef struct {
    bool made;           /* the candidates have been looked for; none if their status is not STATUS_OK */
    candidates candidates;
    bool no_exact;       /* no eigenvalues are known to be equal exactly: not to be looked for again */
    bool folds;          /* L is dominant, but the Jacobian is not positive somewhere, */
    bool winds;          /*   or not shown to wind once; or L may be negative */
} suspicion;

/* Tries what is suspected, at one precision (0: hardware intervals), with plan's limits.  OUTCOME_TRUE: c holds the
   choices that refute C1, f the figures.  OUTCOME_FAIL: nothing was proved. */
outcome refute(findings *f, choices *c, suspicion *s, const analysis_plan *plan, long valence, long precision);

/* When nothing more will be tried: adds to the reason of an attempt how near two blocks' eigenvalues certainly are, if it
   may be that they are equal. */
void refute_note_gap(attempt *a, const suspicion *s, const analysis_plan *plan, long valence, long precision);

/* Why it is not C1, as a sentence without an end: "frequency 2 dominates (...): ..." */
void refute_describe(char *text, size_t size, const choices *c, const findings *f, const suspicion *s);

#endif
