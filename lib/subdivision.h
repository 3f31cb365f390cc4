/* subdivision.h: the steps of a scheme applied to sector nets.  Compiled once per number system.

   Where the value of a new point comes from does not depend on the net.  A `subdivision` looks it up once: the points that
   the mask refers to, brought back into the sector, and how often they cross a spoke on the way. */
#ifndef LIB_SUBDIVISION_H
#define LIB_SUBDIVISION_H

#include "step.h"

#define subdivision_make NUMBER_NAME(subdivision_make)
#define subdivision_apply NUMBER_NAME(subdivision_apply)
#define subdivision_free NUMBER_NAME(subdivision_free)
#define scheme_subdivide NUMBER_NAME(scheme_subdivide)

typedef enum { SUBDIVIDE_OK, SUBDIVIDE_OPPOSITE, SUBDIVIDE_NO_CENTRE_RULE, SUBDIVIDE_NO_MEMORY } subdivide_status;

/* weight times t^turns times the old value. */
typedef struct {
    const number *weight;
    int at; /* its sector_index, CENTRE_INDEX for the centre */
    int turns;
} mask_term;
enum { CENTRE_INDEX = -1 };

/* One new point: by a rule, or by terms of the mask. */
typedef struct {
    int at; /* or CENTRE_INDEX */
    const rule_numbers *rule; /* NULL: the mask */
    size_t first, count;      /* of its terms */
} point_stencil;

typedef struct {
    mesh_kind from, to;
    int rings; /* of the new net */
    point_stencil *point;
    int points;
    bool has_centre; /* by this: */
    point_stencil centre;
    mask_term *term;
    size_t terms, capacity;
} step_stencils;

typedef struct {
    const scheme_numbers *numbers; /* kept by the caller; frequencies may change */
    bool regular;
    step_stencils step[SCHEME_MAX_STEPS];
} subdivision;

/* From nets with scheme_rings_needed(scheme, rings) rings at least to the rings 1..rings.  regular: as of sector_net.  On
   any status subdivision_free. */
subdivide_status subdivision_make(subdivision *z, const scheme_numbers *numbers, bool regular, int old_rings, int rings);
/* new is made here, old has old_rings rings; on any status sector_net_free. */
subdivide_status subdivision_apply(sector_net *new_net, const sector_net *old_net, const subdivision *s);
void subdivision_free(subdivision *z);

/* All three. */
subdivide_status scheme_subdivide(sector_net *new_net, const sector_net *old_net, const scheme_numbers *numbers, int rings);

#endif
