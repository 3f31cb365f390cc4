/* range_spectrum_test.c: the dominance of L for many valences; compiled for affine numbers. */
#include "tests.h"

outcome test_spectrum(analysis *a)
{
    return findings_explain(a->findings, OUTCOME_FAIL, "blocks of several valences are not bounded yet");
}
