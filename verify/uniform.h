/* uniform.h: the method of the thesis, as the reference ([Z] 5.4, TestC1cont; verify/uniform.md): one level after the other,
   all triangles of the ring alike.  Compiled once per number system.

   The tests look at the nets of one level, a->uniform, and have the signature of the others (tests.h).
   OUTCOME_UNDEFINED: one level more may help; OUTCOME_FAIL: only more precision. */
#ifndef VERIFY_UNIFORM_H
#define VERIFY_UNIFORM_H

#include "tests.h"
#include "uniform_net.h"

#define uniform_largest_error NUMBER_NAME(uniform_largest_error)
#define uniform_avoids_zero NUMBER_NAME(uniform_avoids_zero)
#define test_uniform_isolation NUMBER_NAME(test_uniform_isolation)
#define test_uniform_injectivity NUMBER_NAME(test_uniform_injectivity)
#define test_uniform_regularity NUMBER_NAME(test_uniform_regularity)

/* The characteristic map is not 0 on the ring. */
outcome test_uniform_isolation(analysis *a);
/* The ring's outer curve winds once round 0. */
outcome test_uniform_injectivity(analysis *a);
/* The Jacobian is positive on the ring. */
outcome test_uniform_regularity(analysis *a);

/* The largest error of two of the nets, for the log. */
double uniform_largest_error(const analysis *a, int net, int other);
/* Do the segment or triangle of these values, and all within z->error of it, leave out 0? */
bool uniform_avoids_zero(const uniform_net *z, const int *corner, int corners, long prec);

#endif
