/* random.h: random operands for the tests of bigfloat/, chosen to hit corners. */
#ifndef TESTS_BIGFLOAT_RANDOM_H
#define TESTS_BIGFLOAT_RANDOM_H

#include "bigfloat/ball.h"
#include "bigfloat/grid.h"
#include "tests/harness.h"
#include "bigfloat/interval.h"
#include "bigfloat/rational.h"

/* Any memory failure in a test is the test's failure. */
#define MUST(call) ((call) ? (void)0 : test_fail(__FILE__, __LINE__, "no memory in %s", #call))

void random_integer(integer *z, size_t max_limbs);
void random_nonzero_integer(integer *z, size_t max_limbs);
void random_rational(rational *z, size_t max_limbs);
/* Finite; exponents in a range where operands often overlap; errors of all lengths, often 0. */
void random_ball(ball *z, size_t max_limbs);
/* A rational number of the ball, interval or grid: an endpoint, the middle, or in between; finite ones only. */
void random_point_ball(rational *q, const ball *x);
void random_point_interval(rational *q, const interval *x);
void random_point_grid(rational *q, const grid *x);
void random_interval(interval *z);
double random_double(void); /* finite, corners included */
void random_grid(grid *z, size_t max_limbs, long g);
long random_precision(long most);

#endif
