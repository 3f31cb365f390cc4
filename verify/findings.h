/* findings.h: what is told about the analysis of one valence: proved figures, and every attempt. */
#ifndef VERIFY_FINDINGS_H
#define VERIFY_FINDINGS_H

#include "outcome.h"

/* One test in one number system, for the log. */
typedef struct {
    const char *test;
    const char *system; /* "exact", "interval", "ball", "grid" (the replay of a certificate) */
    long precision;     /* bits; 0: exact */
    int max_level;      /* of subdivision, where the test subdivides */
    int level;          /* the deepest */
    long elements;      /* examined */
    double bound;       /* what decided: the least Jacobian, the largest of the other eigenvalues ...; NaN: nothing */
    double error;       /* of the uniform method: how far the limit can be from the net; NaN: nothing */
    double seconds;
    outcome outcome;
    char reason[256];   /* why the outcome is not true */
} attempt;

enum { MAX_ATTEMPTS = 96 };

typedef struct {
    double eigenvalue_lower, eigenvalue_upper; /* |L| lies between */
    char *eigenvalue;                          /* L as text, up to 40 digits */
    double runner_up;                          /* every other eigenvalue but 1 is smaller in modulus */
    long runner_up_block;                      /* where the largest of them seems to be */
    long windings;                             /* CLAIM_WINDING: of the characteristic map round 0 */
    double jacobian;                           /* a lower bound of the Jacobian on the ring, in coordinates (x, y) */
    int level;                                 /* of subdivision, in the tests that succeeded */
    long elements;                             /* examined in them */
    bool uniform;                              /* the uniform method has proved it, too: */
    int uniform_level;                         /*   at this level, */
    long uniform_elements;                     /*   which has so many triangles; */
    double uniform_width;                      /*   of several valences: the largest half-width of the net, in units of L's eigenvector */
    attempt attempts[MAX_ATTEMPTS];            /* all of them, or the first MAX_ATTEMPTS - 1 and the last */
    int attempt_count;
} findings;

void findings_init(findings *z);
void findings_clear(findings *z);

/* A new attempt, to be completed: outcome OUTCOME_TRUE, no reason, no bound. */
attempt *findings_begin(findings *z, const char *test, const char *system, long precision);
/* The attempt that is under way, or was last. */
attempt *findings_last(findings *z);

/* Sets the reason of the last attempt and returns o. */
outcome findings_explain(findings *z, outcome o, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

#endif
