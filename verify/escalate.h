/* escalate.h: the only loop that raises precision: one valence, from hardware intervals to balls of more and more
   bits, until it is decided or a limit is met. */
#ifndef VERIFY_ESCALATE_H
#define VERIFY_ESCALATE_H

#include "analysis.h"
#include "buffer.h"

typedef struct {
    long precision;     /* 0: escalate; else only balls of this many bits */
    long max_precision; /* of balls, when escalating */
    int max_level;      /* of subdivision; 0: chosen with the precision */
    bool no_intervals;  /* hardware intervals are not to be trusted here: balls only */
} limits;

#define LIMITS_MIN_PRECISION 64
#define LIMITS_MAX_PRECISION CHOICES_MAX_GRID

/* One attempt, for the log. */
typedef struct {
    const char *system; /* "interval", "ball", "grid" (the replay of a certificate) */
    long precision;
    int max_level;
    outcome outcome;
    const char *test;   /* the last one that was run */
    int level;
    long elements;
    double jacobian;
    char reason[256];
} attempt;

enum { MAX_ATTEMPTS = 64 };

typedef struct {
    long valence;
    verdict verdict;
    bool no_memory;
    bool bad_input;           /* the scheme has no meaning at this valence: findings.reason is "LINE:COLUMN: ..." */
    findings findings;        /* of the decisive attempt */
    const char *system;       /* of that attempt */
    long precision;
    buffer certificate;       /* what was replayed, if proved; else empty */
    attempt attempts[MAX_ATTEMPTS];
    int attempt_count;
} decision;

void decision_init(decision *z);
void decision_clear(decision *z);

/* Decides whether the scheme of p is C1 at the valence.  VERDICT_PROVED only after the finished certificate has
   been read back and followed on grids, as its specification says. */
void decide_valence(decision *z, const problem *p, long valence, const limits *l);

#endif
