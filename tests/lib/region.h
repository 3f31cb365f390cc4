/* region.h: for tests that are compiled once per number system (bigfloat/number.h).

   The whole test runs where the arithmetic of the number system is valid; MAIN(tests) is its main.  What the test
   itself computes in doubles may be rounded upward there, so comparisons of such doubles allow for it. */
#ifndef TESTS_LIB_REGION_H
#define TESTS_LIB_REGION_H

#include "bigfloat/number.h"

#define MAIN(tests)                                                           \
    static INTERVAL_NOINLINE int run_tests(void)                              \
    {                                                                         \
        tests();                                                              \
        return test_status();                                                 \
    }                                                                         \
    int main(void)                                                            \
    {                                                                         \
        number_mode mode = number_enter();                                    \
        int status_of_tests = run_tests();                                    \
        number_leave(mode);                                                   \
        return status_of_tests;                                               \
    }                                                                         \
    typedef int main_ends_here

/* Does x contain a number within `tolerance` of v, and nothing far away from it? */
static inline bool is_near(const number *x, double v, double tolerance)
{
    return number_lower_bound(x) >= v - tolerance && number_upper_bound(x) <= v + tolerance;
}

#endif
