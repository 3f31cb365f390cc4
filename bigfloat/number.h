/* number.h: one source, three number systems.

   A source that includes this file is compiled up to three times, with one of NUMBER_INTERVAL, NUMBER_BALL,
   NUMBER_GRID defined.  `number` is then interval (hardware doubles, rounded outward), ball (any precision)
   or grid (exact endpoints on a grid 2^-prec; the arithmetic of certificates).  A `number` denotes a
   closed set of real numbers that is an interval, at worst the *indeterminate* one: the whole line.
   NUMBER_NAME(f) is f_interval, f_ball or f_grid: name every external function of such a source with it.
   (With NUMBER_JET, too, `number` is a jet of them: bigfloat/number_jet.h; with NUMBER_AFFINE an affine one:
   bigfloat/number_affine.h.  With NUMBER_COSINES it is an exact number of a real cyclotomic field, and only what blocks
   need is there: bigfloat/cosines.h.)

   In the contracts below x, y, r are any numbers of the sets given; each operation yields a set that contains
   the result for EVERY choice of them.  Nothing fails: division by a set that contains 0, the root of a set
   that reaches below 0, an exponent out of range, a missing result of any kind are the whole line, and so is
   missing memory, which number_lacks_memory reports and which stays with every result computed from it.
   Any output may be the same object as any input.  `prec` is last: bits for ball, grid exponent for grid,
   ignored by interval.

   life        number_init(z)            z = 0, no allocation.  number_clear(z) releases it.
               number_array_new(n)       n initialised numbers, NULL = no memory; number_array_free(a, n)
   regions     number_enter() .. number_leave(mode) must surround all arithmetic.  See interval.h: the function
               that calls them must not itself contain arithmetic, only calls of functions that are not inlined.
   assignment  number_set(z, x)  number_swap(x, y)  number_zero(z)  number_one(z)  number_indeterminate(z)
               number_set_si(z, v, prec)  number_set_double(z, v, prec)
               number_set_integer_2exp(z, m, e, prec)      m 2^e
               number_set_rational(z, q, prec)
               number_set_ball(z, b, prec)                 the set of the ball b; number_get_ball(b, x, prec)
   arithmetic  neg(z, x)  abs(z, x); add sub mul div (z, x, y, prec); addmul submul (z, x, y, prec): z +- x y;
               sqr inv sqrt (z, x, prec); mul_2exp(z, x, e, prec): x 2^e; mul_si div_si (z, x, v, prec)
   sets        hull(z, x, y, prec)       contains both x and y
               min max (z, x, y, prec)   of numbers of x and y, not of sets
               intersection(z, x, y, prec)   contains every number in both sets; if they are disjoint,
                                         indeterminate or some other set: such a result means nothing
               lower upper (z, x, prec)  a thin number below (above) every number of x
               midpoint(z, x, prec)      a thin number in or near x
               radius_upper(z, x, prec)  thin, >= |t - c| for every t in x, c = midpoint(x, prec)
               magnitude_upper(z, x, prec)  thin, >= |t| for every t in x
               add_error(z, x, r, prec)  contains t + s for t in x and |s| <= max |r|
             Of an indeterminate number, lower upper midpoint radius_upper magnitude_upper are indeterminate.
   questions   is_positive is_negative is_zero (x), less(x, y): answers for all choices, or TRUTH_UNKNOWN
               contains_zero(x); contains(x, y): is every number of y in x?  contains_interior(x, y): is y in the
               interior of x?  contains_rational(x, q).  These are exact about the sets as stored.
               is_finite(x); is_thin(x): exactly one number; lacks_memory(x)
   doubles     mid_approx(x); lower_bound(x) upper_bound(x): true bounds, possibly infinite
   grids       mid_grid(m, x, g): m about midpoint 2^g; lower_grid: m = floor(lower 2^g); upper_grid: ceiling;
               false = no memory or not finite
   constants   pi(z, prec)  cos_pi(z, r, prec)  sin_pi(z, r, prec): cos and sin of pi r, r rational; exact where
               the value is 0, +-1/2, +-1
   text        char *get_decimal(x, digits): encloses x; the caller frees it; NULL = no memory */
#ifndef BIGFLOAT_NUMBER_H
#define BIGFLOAT_NUMBER_H

#if defined(NUMBER_INTERVAL) + defined(NUMBER_BALL) + defined(NUMBER_GRID) + defined(NUMBER_COSINES) != 1
#error "define exactly one of NUMBER_INTERVAL, NUMBER_BALL, NUMBER_GRID, NUMBER_COSINES"
#endif

#if defined(NUMBER_INTERVAL)
#include "interval.h"
#define NUMBER_BASE_TYPE interval
#define NUMBER_JET_TYPE jet_interval
#define NUMBER_AFFINE_TYPE affine_interval
#define NUMBER_SYSTEM_NAME "interval"
#elif defined(NUMBER_BALL)
#include "ball.h"
#define NUMBER_BASE_TYPE ball
#define NUMBER_JET_TYPE jet_ball
#define NUMBER_AFFINE_TYPE affine_ball
#define NUMBER_SYSTEM_NAME "ball"
#elif defined(NUMBER_COSINES)
#include "cosines.h"
#define NUMBER_BASE_TYPE cosines
#else
#include "grid.h"
#define NUMBER_BASE_TYPE grid
#define NUMBER_JET_TYPE jet_grid
#define NUMBER_AFFINE_TYPE affine_grid
#define NUMBER_SYSTEM_NAME "grid"
#endif

#define NUMBER_TYPE NUMBER_BASE_TYPE

#define NUMBER_PASTE_(f, system) f##_##system
#define NUMBER_PASTE(f, system) NUMBER_PASTE_(f, system)
#define NUMBER_NAME(f) NUMBER_PASTE(f, NUMBER_TYPE)
#define NUMBER_OP(op) NUMBER_PASTE(NUMBER_BASE_TYPE, op)

typedef NUMBER_TYPE number;

#if defined(NUMBER_INTERVAL)
typedef interval_mode number_mode;
#define number_enter() interval_enter()
#define number_leave(mode) interval_leave(mode)
#else
typedef int number_mode;
#define number_enter() ((number_mode)0)
#define number_leave(mode) ((void)(mode))
#endif

#define number_array_new NUMBER_OP(array_new)
#define number_array_free NUMBER_OP(array_free)

#define number_init NUMBER_OP(init)
#define number_clear NUMBER_OP(clear)
#define number_set NUMBER_OP(set)
#define number_swap NUMBER_OP(swap)
#define number_zero NUMBER_OP(zero)
#define number_one NUMBER_OP(one)
#define number_indeterminate NUMBER_OP(indeterminate)
#define number_set_si NUMBER_OP(set_si)
#define number_set_double NUMBER_OP(set_double)
#define number_set_integer_2exp NUMBER_OP(set_integer_2exp)
#define number_set_rational NUMBER_OP(set_rational)
#if defined(NUMBER_BALL)
#define number_set_ball ball_set_round
#define number_get_ball ball_set_round
#elif defined(NUMBER_GRID)
#define number_set_ball grid_set_ball
#define number_get_ball ball_set_grid
#else
#define number_set_ball interval_set_ball
#define number_get_ball ball_set_interval
#endif

#define number_neg NUMBER_OP(neg)
#define number_abs NUMBER_OP(abs)
#define number_add NUMBER_OP(add)
#define number_sub NUMBER_OP(sub)
#define number_mul NUMBER_OP(mul)
#define number_div NUMBER_OP(div)
#define number_addmul NUMBER_OP(addmul)
#define number_submul NUMBER_OP(submul)
#define number_sqr NUMBER_OP(sqr)
#define number_mul_2exp NUMBER_OP(mul_2exp)
#define number_mul_si NUMBER_OP(mul_si)
#define number_div_si NUMBER_OP(div_si)
#define number_inv NUMBER_OP(inv)
#define number_sqrt NUMBER_OP(sqrt)

#define number_hull NUMBER_OP(hull)
#define number_min NUMBER_OP(min)
#define number_max NUMBER_OP(max)
#define number_intersection NUMBER_OP(intersection)
#define number_lower NUMBER_OP(lower)
#define number_upper NUMBER_OP(upper)
#define number_midpoint NUMBER_OP(midpoint)
#define number_radius_upper NUMBER_OP(radius_upper)
#define number_magnitude_upper NUMBER_OP(magnitude_upper)
#define number_add_error NUMBER_OP(add_error)

#define number_is_positive NUMBER_OP(is_positive)
#define number_is_negative NUMBER_OP(is_negative)
#define number_is_zero NUMBER_OP(is_zero)
#define number_less NUMBER_OP(less)
#define number_contains_zero NUMBER_OP(contains_zero)
#define number_contains NUMBER_OP(contains)
#define number_contains_interior NUMBER_OP(contains_interior)
#define number_contains_rational NUMBER_OP(contains_rational)
#define number_is_finite NUMBER_OP(is_finite)
#define number_is_thin NUMBER_OP(is_thin)
#define number_lacks_memory NUMBER_OP(lacks_memory)

#define number_mid_approx NUMBER_OP(mid_approx)
#define number_lower_bound NUMBER_OP(lower_bound)
#define number_upper_bound NUMBER_OP(upper_bound)
#define number_mid_grid NUMBER_OP(mid_grid)
#define number_lower_grid NUMBER_OP(lower_grid)
#define number_upper_grid NUMBER_OP(upper_grid)

#define number_pi NUMBER_OP(pi)
#define number_cos_pi NUMBER_OP(cos_pi)
#define number_sin_pi NUMBER_OP(sin_pi)
#define number_get_decimal NUMBER_OP(get_decimal)

#if defined(NUMBER_JET)
#include "number_jet.h"
#elif defined(NUMBER_AFFINE)
#include "number_affine.h"
#endif

#endif
