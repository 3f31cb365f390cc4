/* range_tests.c: which tests a claim about several valences needs (verify/certificate-valences.md), and refusals in place of
   what there is for single valences only.  Compiled for affine numbers. */
#include "tests.h"

enum { C1 = 1 << CLAIM_C1, WINDOW = 1 << CLAIM_WINDOW };

const analysis_test analysis_tests[] = {
    {TEST_REGULAR_COMPLEX, "regular complex", test_regular_complex, C1 | WINDOW},
    {TEST_EIGENPAIR, "eigenpair", test_eigenpair, C1},
    {TEST_EIGENPAIR, "window", test_window, WINDOW},
    {TEST_SPECTRUM, "spectrum", test_spectrum, C1},
    {TEST_REGULARITY, "regularity", test_regularity, C1},
    {TEST_INJECTIVITY, "injectivity", test_injectivity, C1},
    {TESTS, NULL, NULL, 0},
};

block_status real_windows(charnet_windows *z, const analysis *a, int which, const element *elements, int count)
{
    (void)z, (void)a, (void)which, (void)elements, (void)count;
    return BLOCK_NO_MEMORY;
}

void exact_free(analysis *a)
{
    (void)a;
}

outcome analysis_uniform(analysis *a)
{
    return findings_explain(a->findings, OUTCOME_FALSE, "the uniform method is for single valences");
}
