/* escalate.h: the only loop that raises precision: one valence, from hardware intervals to balls of more and more
   bits, until it is decided or a limit is met. */
#ifndef VERIFY_ESCALATE_H
#define VERIFY_ESCALATE_H

#include "analysis.h"
#include "buffer.h"
#include "refute_range.h"

typedef struct {
    long precision;     /* 0: escalate; else only balls of this many bits */
    long max_precision; /* of balls, when escalating */
    int max_level;      /* of subdivision; 0: chosen with the precision */
    bool no_intervals;  /* hardware intervals are not to be trusted here: balls only */
    const uniform_bounds *uniform; /* NULL: the adaptive method only; else the uniform one first (verify/uniform.md) */
    deadline deadline;
} limits;

#define LIMITS_MIN_PRECISION 64
#define LIMITS_MAX_PRECISION CHOICES_MAX_GRID

typedef struct {
    valence_range k;          /* which valences it is about */
    verdict verdict;
    outcome outcome;          /* of the last attempt that counts: why the verdict is not another */
    bool plainly_regular;     /* proved by the regular part alone */
    bool kept_before;         /* proved by the certificate of an earlier run, followed once more */
    claim_kind claim;         /* of the certificate */
    long frequency;
    char reason[256];         /* of a refutation: a sentence */
    findings findings;
    int obstacle;             /* the attempt that says why the verdict is undecided */
    const char *system;       /* of the decisive attempts: "exact", "interval", "ball" */
    long precision;
    double seconds;
    buffer certificate;       /* what was replayed, if proved; else empty */
} decision;

void decision_init(decision *z);
void decision_clear(decision *z);

/* Decides whether the scheme of p is C1 at the valence.  VERDICT_PROVED only after the finished certificate has
   been read back and followed on grids, as its specification says.  If `earlier` (NULL or empty: nothing) is such a
   certificate that was kept before, it is all there is to do, unless l->precision asks for more.
   outcome OUTCOME_NO_MEMORY: nothing was decided for lack of memory; OUTCOME_BAD_INPUT: the scheme has no meaning at this
   valence, the last attempt's reason is "LINE:COLUMN: ..."; OUTCOME_STOPPED: the deadline. */
void decide_valence(decision *z, const problem *p, long valence, const buffer *earlier, const limits *l);

/* The same for all valences of a range of several, at one precision: that of the limits, or hardware intervals.  VERDICT_UNDECIDED
   says nothing of smaller ranges.  r: why it seems that the scheme is not C1 there, if there is a reason. */
void decide_range(decision *z, const problem *p, valence_range k, range_reason r, const limits *l);

/* Does the certificate prove its claim for these valences?  Else nothing is decided. */
bool decide_by_certificate(decision *z, const problem *p, valence_range k, const buffer *certificate, const limits *l);

/* The attempt that says why the verdict is undecided. */
const attempt *decision_obstacle(const decision *z);

#endif
