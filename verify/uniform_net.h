/* uniform_net.h: one net on the whole ring, subdivided everywhere alike, and how far its limit can be from it
   ([Z] 4.3 and 5.3; verify/uniform.md).  Compiled once per number system.

   A `uniform_net` holds the values of level m at the labels that matter for one sector of the ring: a hexagon in the
   sector's chart, `low[f] <= f(y) <= high[f]` for f = a, b, a + b.  What always holds: each number contains the
   true value, and the limit differs by at most `error` from the net's own piecewise linear function (values) or
   piecewise constant one (derivatives; d1 of an edge in direction 1 belongs to both triangles at it). */
#ifndef VERIFY_UNIFORM_NET_H
#define VERIFY_UNIFORM_NET_H

#include "../lib/charnet.h"
#include "deadline.h"
#include "outcome.h"
#include "uniform_bounds.h"

#define uniform_net_init NUMBER_NAME(uniform_net_init)
#define uniform_net_clear NUMBER_NAME(uniform_net_clear)
#define uniform_net_make NUMBER_NAME(uniform_net_make)
#define uniform_net_refine NUMBER_NAME(uniform_net_refine)
#define uniform_net_width NUMBER_NAME(uniform_net_width)

enum {
    UNIFORM_MAX_LEVEL = 12,
    UNIFORM_MAX_POINTS = 1 << 20 /* of one net */
};

typedef struct {
    const ring *ring;             /* kept by the caller, as the bounds and the mask */
    const uniform_bounds *bounds;
    const mask_numbers *mask;
    int which;                    /* RING_VALUES, RING_FIRST or RING_SECOND */
    int level;
    int low[3], high[3];          /* of a, b, a + b */
    int *row;                     /* where the row of a begins: row[a - low[0]], then by b */
    int count;
    number *value[2];             /* x and y */
    number spread[2][UNIFORM_MAX_LEVEL + 1]; /* D of each level so far, by component: thin, upper bounds */
    number error[2];              /* thin; indeterminate if no number of steps contracts yet */
} uniform_net;

void uniform_net_init(uniform_net *z);
void uniform_net_clear(uniform_net *z);

/* Level 0: values or differences of `net`, intervals as they are there.  On any status uniform_net_clear. */
block_status uniform_net_make(uniform_net *z, const sector_net *net, const ring *r, int which, const mask_numbers *mask, const uniform_bounds *b, long prec);
/* The next level, intervals from intervals.  OUTCOME_UNDEFINED: it would have more than UNIFORM_MAX_POINTS points or
   be deeper than UNIFORM_MAX_LEVEL, and z is as before.  OUTCOME_STOPPED: no time; z can only be cleared. */
outcome uniform_net_refine(uniform_net *z, const deadline *d, long prec);

/* Where the value of (a,b) is in value[0] and value[1]; the label must be one of the hexagon. */
static inline int uniform_net_index(const uniform_net *z, int a, int b)
{
    int from = z->low[2] - a > z->low[1] ? z->low[2] - a : z->low[1];
    return z->row[a - z->low[0]] + b - from;
}

/* An upper bound of the numbers' radii, in doubles. */
double uniform_net_width(const uniform_net *z, long prec);

#endif
