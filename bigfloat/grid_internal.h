/* grid_internal.h: what the sources of grids share. */
#ifndef BIGFLOAT_GRID_INTERNAL_H
#define BIGFLOAT_GRID_INTERNAL_H

#include "grid.h"
#include "integer_internal.h"

void grid_no_memory(grid *z);
void grid_indeterminate_like(grid *z, const grid *x, const grid *y);

/* Is g a possible grid exponent? */
static inline bool grid_exponent_ok(long g) { return g >= -GRID_MAX_EXPONENT && g <= GRID_MAX_EXPONENT; }

/* Finite, and its endpoints count units of the grid g?  (0 is on every grid.) */
static inline bool grid_ready(const grid *x, long g)
{
    return x->state == GRID_FINITE
           && (x->exponent == g || ((x->lower.size | x->upper.size) == 0 && grid_exponent_ok(g)));
}

/* z = x on the grid g, outward; false: z is indeterminate (x was, or g is out of range, or no memory). */
bool grid_move(grid *z, const grid *x, long g);

/* Calls op(z, x, y, g) with copies of x and y that lie on the grid g. */
void grid_on_grid(grid *z, const grid *x, const grid *y, long g,
                  void (*op)(grid *, const grid *, const grid *, long));

/* A result is in place, or memory was missing. */
static inline void grid_finish(grid *z, long g, bool ok)
{
    z->exponent = (int32_t)g;
    z->state = ok ? GRID_FINITE : GRID_NO_MEMORY;
}

#endif
