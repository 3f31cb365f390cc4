/* range_tests.c: which tests a claim about several valences needs (verify/certificate-valences.md), and what stands here for
   things that are done otherwise.  Compiled for affine numbers. */
#include "tests.h"
#include "uniform_range.h"

enum {
    C1 = 1 << CLAIM_C1,
    FREQUENCY = 1 << CLAIM_FREQUENCY,
    NOT_C0 = 1 << CLAIM_NOT_C0,
    FOLD = 1 << CLAIM_FOLD,
    WINDOW = 1 << CLAIM_WINDOW,
    GRADED = 1 << CLAIM_GRADED
};

const analysis_test analysis_tests[] = {
    {TEST_REGULAR_COMPLEX, "regular complex", test_regular_complex, C1 | FREQUENCY | NOT_C0 | FOLD | WINDOW | GRADED},
    {TEST_EIGENPAIR, "eigenpair", test_eigenpair, C1 | FREQUENCY | NOT_C0 | FOLD},
    {TEST_EIGENPAIR, "window", test_window, WINDOW},
    {TEST_EIGENPAIR, "growth", test_graded, GRADED},
    {TEST_SPECTRUM, "spectrum", test_spectrum, C1 | FREQUENCY | FOLD},
    {TEST_REGULARITY, "regularity", test_regularity, C1},
    {TEST_INJECTIVITY, "injectivity", test_injectivity, C1},
    {TEST_ZERO_FREE, "no zero", test_zero_free, FREQUENCY},
    {TEST_WITNESS, "nonzero", test_nonzero, NOT_C0 | GRADED},
    {TEST_WITNESS, "fold", test_fold, FOLD},
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

static base_number *make_ranges(const number *x, size_t n, long prec)
{
    base_number *z = base_array_new(n);
    for (size_t i = 0; z && i < n; i++)
        affine_range(&z[i], &x[i], prec);
    return z;
}

/* The reference has no slopes: it sees intervals. */
outcome analysis_uniform(analysis *a)
{
    outcome o = analysis_make_net(a);
    size_t size = o == OUTCOME_TRUE ? (size_t)sector_size(a->net.rings) : 0;
    base_number u, *x = NULL, *y = NULL;
    if (o != OUTCOME_TRUE)
        return o;
    base_init(&u);
    affine_range(&u, &a->dominant.twist.u, a->prec);
    x = make_ranges(a->net.x, size, a->prec);
    y = make_ranges(a->net.y, size, a->prec);
    o = x && y ? BASE_NAME(uniform_over_range)(a->findings, a->choices, a->plan, x, y, a->net.rings, &u, a->prec) : OUTCOME_NO_MEMORY;
    base_array_free(x, size);
    base_array_free(y, size);
    base_clear(&u);
    return o;
}
