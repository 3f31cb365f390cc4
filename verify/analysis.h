/* analysis.h: one valence in one number system (verify/certificate.md, sections 5 to 8).

   analysis_search looks for choices that prove the claim (C1, or a reason why not), testing as it goes; analysis_replay follows given choices
   and accepts nothing else.  Both run the same tests; a replay on grids is the specification of certificates. */
#ifndef VERIFY_ANALYSIS_H
#define VERIFY_ANALYSIS_H

#include "choices.h"
#include "deadline.h"
#include "findings.h"
#include "outcome.h"
#include "picture.h"
#include "problem.h"
#include "uniform_bounds.h"

/* Which tests have succeeded: the choices that they need are there. */
typedef enum { TEST_REGULAR_COMPLEX, TEST_EIGENPAIR, TEST_SECOND, TEST_EXACT, TEST_SPECTRUM, TEST_UNIFORM, TEST_REGULARITY, TEST_INJECTIVITY, TEST_ZERO_FREE, TEST_WITNESS, TESTS } test_name;

typedef struct {
    const problem *problem;
    bool found[TESTS];      /* a search leaves out what is found, as long as what it rests on is no worse than then */
    double scale_upper;     /* the spectrum was found for 1/scale <= |L| with a scale that was at most this */
    int max_level;
    long max_elements;      /* to examine in one test; 0: any number */
    const uniform_bounds *uniform; /* not NULL: a search uses the uniform method, and then looks for trees that are no deeper */
    const deadline *deadline;
    const char *system;     /* for the log */
    picture *picture;       /* of one valence: NULL, or to be taken once there is an eigenpair, whatever the outcome */
} analysis_plan;

/* c->claim, frequency, valence and grid are given; a search fills in the rest.  Replays follow what is there. */
outcome analysis_search_interval(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_search_ball(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_search_grid(findings *f, choices *c, analysis_plan *p, long prec);
/* The same for several valences (verify/certificate-valences.md). */
outcome analysis_search_affine_interval(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_search_affine_ball(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_search_affine_grid(findings *f, choices *c, analysis_plan *p, long prec);

/* The search at one rung of the ladder, precision 0 being hardware intervals; sets c->grid. */
static inline outcome analysis_search(findings *f, choices *c, analysis_plan *p, long precision)
{
    c->grid = precision ? precision : CHOICES_MIN_GRID;
    if (!is_one_valence(c->k))
        return precision ? analysis_search_affine_ball(f, c, p, precision) : analysis_search_affine_interval(f, c, p, 53);
    return precision ? analysis_search_ball(f, c, p, precision) : analysis_search_interval(f, c, p, 53);
}

outcome analysis_replay_interval(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_replay_ball(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_replay_grid(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_replay_affine_interval(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_replay_affine_ball(findings *f, choices *c, analysis_plan *p, long prec);
outcome analysis_replay_affine_grid(findings *f, choices *c, analysis_plan *p, long prec);

/* The replay that certificates are about: of choices that were read, on their grid. */
static inline outcome analysis_replay(findings *f, choices *c, analysis_plan *p)
{
    return is_one_valence(c->k) ? analysis_replay_grid(f, c, p, c->grid) : analysis_replay_affine_grid(f, c, p, c->grid);
}

#endif
