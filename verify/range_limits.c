/* range_limits.c: what there is for single valences only; in its place here, for affine numbers, is a refusal. */
#include "tests.h"

static outcome refuse(analysis *a)
{
    return findings_explain(a->findings, OUTCOME_FALSE, "this is there for single valences only");
}

outcome test_exact(analysis *a)
{
    return refuse(a);
}

outcome test_exact_witnesses(analysis *a)
{
    return refuse(a);
}

outcome test_second(analysis *a)
{
    return refuse(a);
}

outcome test_real(analysis *a)
{
    return refuse(a);
}

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
    return refuse(a);
}

outcome picture_take(picture *p, analysis *a)
{
    (void)p;
    return refuse(a);
}
