/* analysis_tests.c: which tests a claim about one valence needs.  Compiled once per number system. */
#include "tests.h"

enum {
    C1 = 1 << CLAIM_C1,
    FREQUENCY = 1 << CLAIM_FREQUENCY,
    NOT_C0 = 1 << CLAIM_NOT_C0,
    FOLD = 1 << CLAIM_FOLD,
    WINDING = 1 << CLAIM_WINDING,
    REAL = 1 << CLAIM_REAL,
    TIE = 1 << CLAIM_TIE,
    JORDAN = 1 << CLAIM_JORDAN,
    MODULUS_ONE = 1 << CLAIM_MODULUS_ONE,
    ENCLOSED = C1 | FREQUENCY | NOT_C0 | FOLD | WINDING | REAL,
    EXACT = TIE | JORDAN | MODULUS_ONE
};

const analysis_test analysis_tests[] = {
    {TEST_REGULAR_COMPLEX, "regular complex", test_regular_complex, ENCLOSED | EXACT},
    {TEST_EIGENPAIR, "eigenpair", test_eigenpair, ENCLOSED},
    {TEST_SECOND, "second eigenpair", test_second, REAL},
    {TEST_EXACT, "exact", test_exact, EXACT},
    {TEST_SPECTRUM, "spectrum", test_spectrum, C1 | FREQUENCY | FOLD | WINDING | REAL | TIE | JORDAN},
    {TEST_REGULARITY, "regularity", test_regularity, C1},
    {TEST_INJECTIVITY, "injectivity", test_injectivity, C1},
    {TEST_ZERO_FREE, "no zero", test_zero_free, FREQUENCY | JORDAN},
    {TEST_ZERO_FREE, "winding", test_winding, WINDING},
    {TEST_WITNESS, "nonzero", test_nonzero, NOT_C0},
    {TEST_WITNESS, "fold", test_fold, FOLD},
    {TEST_WITNESS, "normals", test_real, REAL},
    {TEST_WITNESS, "nonzero", test_exact_witnesses, TIE | MODULUS_ONE},
    {TESTS, NULL, NULL, 0},
};
