/* outcome.h: how a test ends, and what a run says in the end. */
#ifndef VERIFY_OUTCOME_H
#define VERIFY_OUTCOME_H

#include <stdbool.h>

/* Four answers of a test, kept apart ([Z] chapter 5, DESIGN "One run"), and lack of memory. */
typedef enum {
    OUTCOME_TRUE,      /* proved */
    OUTCOME_FALSE,     /* the opposite was found, or no precision is likely to help */
    OUTCOME_UNDEFINED, /* more subdivision may help */
    OUTCOME_FAIL,      /* only more precision may help */
    OUTCOME_STOPPED,   /* a limit of time was met, or somebody interrupted */
    OUTCOME_BAD_INPUT, /* a formula of the scheme has no value here */
    OUTCOME_NO_MEMORY
} outcome;

const char *outcome_name(outcome o);

typedef enum { VERDICT_PROVED, VERDICT_REFUTED, VERDICT_UNDECIDED } verdict;

const char *verdict_name(verdict v);

#endif
