/* adaptive.h: local enclosures of a limit map, refined only where a decision is still missing (verify/certificate.md,
   sections 7 and 8).  Compiled once per number system.

   On an element a limit value differs from the middle of the thin values in the element's window by at most K times
   their distance from it, and by K times the nets' radius (K: lib/stability.h): that is the element's box.  If the
   boxes do not decide and limits are polynomials on the element, their coefficients may (lib/patch.h).  If these do not
   either, the children's windows are computed and tried. */
#ifndef VERIFY_ADAPTIVE_H
#define VERIFY_ADAPTIVE_H

#include "../lib/charnet.h"
#include "../lib/patch.h"
#include "choices.h"
#include "deadline.h"
#include "outcome.h"
#include "tree.h"

#define adaptive_run NUMBER_NAME(adaptive_run)
#define adaptive_seek NUMBER_NAME(adaptive_seek)

/* z = z + the quantity that is to be positive, of the values (x[i], y[i]) of the nets i.  Of polynomials it is made by their
   coefficients: of one net's it must be linear, and of two nets it must be the Jacobian x[0] y[1] - y[0] x[1] (else boxes_only). */
typedef void (*adaptive_quantity)(number *z, const number *const x[], const number *const y[], const void *data, long prec);

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
    const patch_numbers *patch[ADAPTIVE_MAX_NETS]; /* NULL unless all masks are of box splines */
    adaptive_quantity quantity;
    const void *data;
    bool boxes_only;  /* the quantity is not as polynomials need it */
    bool replay;      /* follow the word instead of writing it */
    int max_level;    /* of subdivision */
    long max_elements; /* that a search examines, 0: any number; more are OUTCOME_UNDEFINED */
    const deadline *deadline;
} adaptive_task;

/* What a run looked like. */
typedef struct {
    long examined; /* elements whose boxes or coefficients were tried, or that were split as the word said */
    int level;     /* the deepest */
    double margin; /* the quantity is at least this everywhere, as far as leaves were reached; may be -infinity */
} adaptive_report;

/* OUTCOME_TRUE: the property is proved on all elements, by the trees in `word` (written, or followed to its end).
   OUTCOME_FALSE: the opposite holds on some element; in a replay also: the word does not prove it.
   OUTCOME_STOPPED: there was no time. */
outcome adaptive_run(adaptive_report *report, tree_word *word, const adaptive_task *task, long prec);

/* OUTCOME_TRUE: the quantity is positive on the box of the descendant that the witness names (found, or followed in a
   replay).  OUTCOME_FALSE: no witness was found, or it is none. */
outcome adaptive_seek(adaptive_report *report, witness_choice *witness, const adaptive_task *task, long prec);

#endif
