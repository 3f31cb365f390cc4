/* partition.c: boxes of about the same width in u = cos(pi/k), as wide as what was decided before lets hope. */
#include "partition.h"

#include "../lib/scheme_range.h"

#include <math.h>
#include <stdio.h>

/* Of the first box, in u. */
#define FIRST_WIDTH 0.04
/* After so many single valences in a row, none of which helped to decide more than itself, a range without an end is given up; */
#define MAX_SINGLES 200
/* or after the first one if 1 - u is less than this; */
#define FAR 0x1p-50
/* and after so many boxes. */
#define MAX_BOXES 1000

typedef struct {
    const partition *p;
    valence_range range;
    long k;        /* the first one that is still open */
    double width;  /* of the next box */
    long singles;  /* in a row */
    long boxes;    /* all of them */
    range_reason reason; /* why the valence before is not C1, if it is not: so may be the next ones */
} progress_of_partition;

static double u_of(long k)
{
    return k == VALENCES_UNBOUNDED ? 1 : cos(acos(-1) / (double)k);
}

/* Is u almost 1, so that boxes from k on end nowhere, or at once? */
static bool is_far(long k)
{
    return 1 - u_of(k) < FAR;
}

/* The last valence of a box from k that is about so wide. */
static long end_of_box(long k, long last, double width)
{
    double u = u_of(k) + width, end = u < 1 ? acos(-1) / acos(u) : INFINITY;
    if (end >= (double)CHOICES_MAX_VALENCE || end >= (double)last)
        return last;
    return end <= (double)k ? k : (long)end;
}

/* A box that begins at k, made smaller until it is decided; true: there is a verdict, or no sense in going on. */
static bool decide_box(progress_of_partition *s, decision *d)
{
    const partition *p = s->p;
    for (long tried = 0;;) {
        valence_range box = {s->k, end_of_box(s->k, s->range.last, s->width)};
        double width;
        diagnostic unused;
        if (scheme_decided_up_to(&box.last, p->problem->scheme, box, &unused) != STATUS_OK || box.last == s->k)
            return false;
        if (box.last == tried) /* u, or the largest valence, allows no smaller box */
            return false;
        tried = box.last;
        width = u_of(box.last) - u_of(s->k);
        decide_range(d, p->problem, box, s->reason, p->limits);
        if (d->verdict != VERDICT_UNDECIDED) {
            s->width = fmin(1.5 * s->width, 1); /* of what was asked for: boxes are rounded down to whole valences */
            return true;
        }
        if (d->outcome == OUTCOME_NO_MEMORY || d->outcome == OUTCOME_STOPPED)
            return true;
        decision_clear(d);
        s->width = width / 2;
    }
}

static void leave_open(const progress_of_partition *s, decision *d)
{
    d->k = (valence_range){s->k, s->range.last};
    d->outcome = OUTCOME_FAIL;
    findings_begin(&d->findings, "ranges of valences", "exact", 0);
    if (s->k > CHOICES_MAX_VALENCE)
        findings_explain(&d->findings, OUTCOME_FAIL, "no range without an end could be decided, and single valences go up to %d", CHOICES_MAX_VALENCE);
    else if (is_far(s->k))
        findings_explain(&d->findings, OUTCOME_FAIL, "no range without an end could be decided, and so far out there are too many others");
    else if (s->boxes >= MAX_BOXES)
        findings_explain(&d->findings, OUTCOME_FAIL, "%ld boxes of valences were decided, and the next ones are not wider, which does not end", s->boxes);
    else
        findings_explain(&d->findings, OUTCOME_FAIL, "%ld valences in a row could be decided only one by one, which does not end", s->singles);
    findings_last(&d->findings)->outcome = OUTCOME_FAIL;
}

/* The next decision, about a box from s->k on. */
static void decide_next(progress_of_partition *s, decision *d)
{
    bool beyond = s->k > CHOICES_MAX_VALENCE || (s->range.last == VALENCES_UNBOUNDED && s->boxes >= MAX_BOXES);
    s->boxes++;
    if (!beyond && decide_box(s, d)) {
        s->singles = 0;
    } else if (s->range.last == VALENCES_UNBOUNDED && (beyond || s->singles >= (is_far(s->k) ? 1 : MAX_SINGLES))) {
        leave_open(s, d);
    } else {
        decide_valence(d, s->p->problem, s->k, NULL, s->p->limits);
        s->singles++;
        if (range_reason_is_one(s->reason)) /* what failed here may be done a little farther on */
            s->width = fmax(s->width, u_of(s->k + 5) - u_of(s->k + 1));
    }
}

/* What was refuted for a new reason is tried as wide as possible; and what no longer is, anew. */
static void note_refutation(progress_of_partition *s, const decision *d)
{
    range_reason r = range_reason_after(d->verdict == VERDICT_REFUTED ? d->claim : CLAIM_C1, d->frequency);
    if (!range_reason_equal(r, s->reason))
        s->width = range_reason_is_one(r) ? 1 : FIRST_WIDTH;
    s->reason = r;
}

bool partition_run(const partition *p, valence_range range)
{
    progress_of_partition s = {p, range, range.first, FIRST_WIDTH, 0, 0, range_reason_after(CLAIM_C1, 0)};
    bool more = true;
    while (more) {
        long last;
        decision d;
        decision_init(&d);
        decide_next(&s, &d);
        last = d.k.last;
        note_refutation(&s, &d);
        more = p->take(&d, p->data);
        decision_clear(&d);
        if (last >= range.last)
            break;
        s.k = last + 1;
    }
    return more;
}
