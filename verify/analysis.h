/* analysis.h: one valence in one number system (verify/certificate.md, sections 5 to 8).

   analysis_search looks for choices that prove C1, testing as it goes; analysis_replay follows given choices
   and accepts nothing else.  Both run the same tests; a replay on grids is the specification of certificates. */
#ifndef VERIFY_ANALYSIS_H
#define VERIFY_ANALYSIS_H

#include "choices.h"
#include "outcome.h"
#include "problem.h"

/* What is told about a run: proved figures, or why there is none. */
typedef struct {
    double eigenvalue_lower, eigenvalue_upper; /* L lies between */
    char *eigenvalue;                          /* the same as text, up to 40 digits */
    double runner_up;                          /* every other eigenvalue but 1 is smaller in modulus */
    long runner_up_block;                      /* where the largest of them seems to be */
    double jacobian;                           /* a lower bound of the Jacobian on the ring, in coordinates (x, y) */
    int level;                                 /* of subdivision */
    long elements;                             /* examined */
    const char *test;                          /* the last test that was run */
    char reason[256];                          /* why its outcome is not true */
} findings;

void findings_init(findings *z);
void findings_clear(findings *z);

/* Sets the reason and returns o. */
outcome findings_explain(findings *f, outcome o, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;


outcome analysis_search_interval(findings *f, choices *c, const problem *p, int max_level, long prec);
outcome analysis_search_ball(findings *f, choices *c, const problem *p, int max_level, long prec);
outcome analysis_search_grid(findings *f, choices *c, const problem *p, int max_level, long prec);

outcome analysis_replay_interval(findings *f, choices *c, const problem *p, long prec);
outcome analysis_replay_ball(findings *f, choices *c, const problem *p, long prec);
outcome analysis_replay_grid(findings *f, choices *c, const problem *p, long prec);

#endif
