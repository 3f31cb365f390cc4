/* prove_run.h: a run of `prove`: valences are decided, what is decided is kept, and what is kept is told. */
#ifndef VERIFY_PROVE_RUN_H
#define VERIFY_PROVE_RUN_H

#include "archive.h"
#include "archive_index.h"
#include "classification.h"
#include "keeper.h"
#include "progress.h"
#include "prove_options.h"
#include "valence_list.h"

typedef struct {
    buffer command; /* for the archive: getopt_long changes the order of argv */
    prove_options options;
    scheme scheme;
    problem problem;
    uniform_bounds uniform;
    valence_list list;
    bool in_ranges;
    archive archive;
    archive_index earlier;         /* what was there before, then */
    keeper keeper;
    progress progress;
    long reported;
    valence_range told;            /* what the last line was about */
    char error[256];               /* the last one of the scheme that was told */
    classification classification; /* of ranges */
    int result;                    /* the exit status */
} prove_run;

typedef struct {
    decision decision;
    archive_earlier earlier; /* what there was of an earlier run about these valences */
    char *certificate;       /* where it is kept */
} prove_answer;

/* ---- prove_keep.c: the keeper's work ---- */

/* keeper.keep and keeper.discard, data being the prove_run. */
bool prove_keep(void *const *answers, int count, void *data);
void prove_discard(void *answer);

/* The exit status is the most urgent one of what happened. */
void prove_raise_result(prove_run *r, int exit_status);

/* ---- prove_decide.c: all valences of the list; false: no memory for the work ---- */

/* One by one. */
bool prove_decide_each(prove_run *r);
/* In ranges. */
bool prove_decide_ranges(prove_run *r);

#endif
