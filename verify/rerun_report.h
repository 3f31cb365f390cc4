/* rerun_report.h: what `rerun` says of one certificate. */
#ifndef VERIFY_RERUN_REPORT_H
#define VERIFY_RERUN_REPORT_H

#include "escalate.h"
#include "examine.h"

/* What was kept, and what was found anew. */
typedef struct {
    const char *file;
    const char *scheme;         /* its name */
    const examination *before;
    const decision *decision;   /* of the new search */
    const examination *after;   /* the new certificate followed, if the decision is one */
} rerun;

/* The verdict that holds now: of the kept certificate if its choices prove it, else of the new search. */
verdict rerun_verdict(const rerun *r);
/* Both hold, and contradict each other. */
bool rerun_is_contradiction(const rerun *r);

void rerun_print_line(const rerun *r);
/* Appends an object. */
void rerun_print_json(buffer *b, const rerun *r);

#endif
