/* grid.h: intervals whose endpoints are integers in units of 2^-g, with one right answer for everything.

   A finite `grid` denotes the set of real numbers x with

       lower 2^-g  <=  x  <=  upper 2^-g,        lower <= upper integers of any size, g the grid exponent.

   An *indeterminate* grid (state not GRID_FINITE) denotes the whole line; there are no half lines.

   Every operation that takes `prec` answers on the grid prec.  An operand that lies on another grid is first
   moved there: to the least interval of the grid prec that contains it, which is the operand itself when its
   own grid is coarser.  An operation without prec stays on the grid of its operand; zero and one are made
   on the grid 0.

   The results are canonical, so that two programs that share no line of code get the same integers.  With all
   operands on the grid prec:
     neg, abs, add, sub, mul_si, hull, min, max and intersection are exact;
     set_*, mul, sqr, div, inv, div_si, mul_2exp, sqrt, pi, cos_pi and sin_pi give the LEAST grid interval that
       contains { f(x, y) : x in X, y in Y }: for mul, floor of the least and ceiling of the greatest of the
       four exact endpoint products; for div the same of the four quotients; exact where that is an integer;
     addmul and submul are add and sub of that mul;
     div, inv and div_si by an interval that contains 0 and sqrt of one that reaches below 0 are indeterminate;
     midpoint is floor((lower + upper) / 2), and radius_upper is upper - midpoint, in grid units;
     magnitude_upper is max(|lower|, |upper|); add_error(x, r) widens x by max(|r.lower|, |r.upper|);
     an intersection that is empty is indeterminate.
   |g| is at most GRID_MAX_EXPONENT, else the result is indeterminate. */
#ifndef BIGFLOAT_GRID_H
#define BIGFLOAT_GRID_H

#include "ball.h"
#include "number_array.h"
#include "number_common.h"

#define GRID_MAX_EXPONENT (1L << 20)

enum { GRID_FINITE, GRID_INDETERMINATE, GRID_NO_MEMORY };

typedef struct {
    integer lower;
    integer upper;
    int32_t exponent;
    int32_t state;
} grid;

static inline void grid_init(grid *z) /* z = 0; never allocates */
{
    integer_init(&z->lower);
    integer_init(&z->upper);
    z->exponent = 0;
    z->state = GRID_FINITE;
}

static inline void grid_swap(grid *x, grid *y)
{
    grid t = *x;
    *x = *y;
    *y = t;
}

NUMBER_DECLARE(grid);
NUMBER_DECLARE_SLOW(grid);
NUMBER_ARRAY_FUNCTIONS(grid);

double grid_mid_approx(const grid *x);
double grid_lower_bound(const grid *x);
double grid_upper_bound(const grid *x);

/* z = [lower, upper] in units of 2^-g; indeterminate if lower > upper. */
void grid_set_endpoints(grid *z, const integer *lower, const integer *upper, long g);
/* Both endpoints of x on the grid g: exact if x lies on a grid that is no finer, else outward; false = no
   memory or indeterminate. */
BIGFLOAT_MUST_USE bool grid_get_endpoints(integer *lower, integer *upper, const grid *x, long g);
/* The least interval of the grid g that contains x. */
void grid_set_ball(grid *z, const ball *x, long g);
void grid_set_round(grid *z, const grid *x, long g);
/* A ball that contains x. */
void ball_set_grid(ball *z, const grid *x, long prec);
/* The same grid exponent and the same endpoints, or both indeterminate? */
bool grid_identical(const grid *x, const grid *y);

#endif
