/* span.h: all eigenvalues of all blocks whose m/k lies in spans, at many valences, are smaller than a number
   (verify/certificate-valences.md, section 4, "Cover").  Compiled once per number system.

   Frequencies come in groups A..B; the arcs of m/k that a group may have at the valences of the range are cut into spans, the affine
   matrix of each of which is bounded by spectral_contraction. */
#ifndef LIB_SPAN_H
#define LIB_SPAN_H

#include "block_affine.h"
#include "cover.h"
#include "range_choices.h"

#define span_search NUMBER_NAME(span_search)
#define span_verify NUMBER_NAME(span_verify)

/* Which blocks: those of the frequencies m, 2 m <= k, at each valence k of the range, for which start <= m/k <= end in the units of arc.h.
   (All of them: 0, ARC_HALF.) */
typedef struct {
    const scheme *scheme;
    valence_range k;
    frequencies m; /* last may be unbounded */
    int64_t start, end;
} span_task;

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool proved;
    frequencies open;    /* if not: the group where a search, or the proof, has failed */
    int64_t open_from;   /* and the end of the last span before */
    bool diverges;       /* a hint: more precision will hardly help there */
    double radius;       /* all eigenvalues are at most radius/scale in modulus, as far as they are proved */
    int64_t largest;     /* where the span begins for which radius was needed */
    long tries;
    bool stopped;        /* lib/stop.h */
} span_answer;

/* Finds a list with which span_verify proves that these blocks have only eigenvalues smaller than 1/scale in modulus, scale thin and
   positive.  Mirror-symmetric schemes only.  Of the limits tries and power count.  What is found is added to the list; if not
   all is proved, nothing. */
span_answer span_search(span_list *list, const span_task *task, const number *scale, const cover_limits *limits, long prec, diagnostic *d);

/* Proves it with the spans boxes[0..count), which must be a cover of the task as the page says. */
span_answer span_verify(const span_box *boxes, size_t count, const span_task *task, const number *scale, long prec, diagnostic *d);

#endif
