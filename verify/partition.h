/* partition.h: a range of valences, perhaps without an end, decided in boxes as wide as can be. */
#ifndef VERIFY_PARTITION_H
#define VERIFY_PARTITION_H

#include "escalate.h"

typedef struct {
    const problem *problem;
    const limits *limits;
    /* Takes a decision over, in the order of valences, with all that belongs to it, or leaves that where it is.  false: no more. */
    bool (*take)(decision *d, void *data);
    void *data;
} partition;

/* Decides all valences of the range: every decision is about a box of them, and together they are the range, unless `take`
   ends it.  A box that could be neither proved nor refuted is made smaller; single valences are decided like any other
   (decide_valence).  Where that does not end, what is left is undecided in one piece.  false: `take` wanted no more. */
bool partition_run(const partition *p, valence_range range);

#endif
