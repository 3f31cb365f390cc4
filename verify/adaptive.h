/* adaptive.h: local enclosures of a limit map, refined only where a decision is still missing (verify/certificate.md,
   sections 7 and 8).  Compiled once per number system.

   On an element a limit value differs from the middle of the thin values in the element's window by at most K times
   their distance from it, and by K times the nets' radius (K: lib/stability.h): that is the element's box.  If the
   boxes do not decide, the children's windows are computed and tried. */
#ifndef VERIFY_ADAPTIVE_H
#define VERIFY_ADAPTIVE_H

#include "../lib/charnet.h"
#include "deadline.h"
#include "outcome.h"
#include "tree.h"

#define adaptive_run NUMBER_NAME(adaptive_run)

/* The box of one net on one element. */
typedef struct {
    number x, y;
} adaptive_box;

/* Decides an element from the boxes of its nets.  OUTCOME_TRUE: the property wanted holds on it.  OUTCOME_FALSE: its
   opposite holds on it.  OUTCOME_UNDEFINED: the boxes leave it open.  *margin, a lower bound of the quantity that
   must be positive, may be -infinity. */
typedef outcome (*adaptive_decision)(double *margin, const adaptive_box *box, const void *data, long prec);

#define adaptive_sign NUMBER_NAME(adaptive_sign)
/* The decision whose property is x > 0, and its margin. */
outcome adaptive_sign(double *margin, const number *x);

enum { ADAPTIVE_MAX_NETS = 2 };

typedef struct {
    const ring *geometry;
    const element *elements;
    int count;
    int nets;                                /* 1 or 2 */
    int which[ADAPTIVE_MAX_NETS];            /* RING_VALUES, ... */
    const charnet_windows *windows[ADAPTIVE_MAX_NETS];
    const mask_numbers *mask[ADAPTIVE_MAX_NETS];
    int64_t stability[ADAPTIVE_MAX_NETS];    /* K of each net, in units of 1/1024 */
    adaptive_decision decide;
    const void *data;
    bool replay;      /* follow the word instead of writing it */
    int max_level;    /* of subdivision */
    const deadline *deadline;
} adaptive_task;

/* What a run looked like. */
typedef struct {
    long examined; /* elements whose boxes were tried, or that were split as the word said */
    int level;     /* the deepest */
    double margin; /* the smallest over the leaves */
} adaptive_report;

/* OUTCOME_TRUE: the property is proved on all elements, by the trees in `word` (written, or followed to its end).
   OUTCOME_FALSE: the opposite holds on some element; in a replay also: the word does not prove it.
   OUTCOME_STOPPED: there was no time. */
outcome adaptive_run(adaptive_report *report, tree_word *word, const adaptive_task *task, long prec);

#endif
