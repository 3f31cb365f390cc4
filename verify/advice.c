/* advice.c: by the outcome of the attempt that was left over, and by the test. */
#include "advice.h"

#include <stdio.h>
#include <string.h>

static bool is_one_of(const char *test, const char *const *names)
{
    for (; *names; names++)
        if (!strcmp(test, *names))
            return true;
    return false;
}

/* Which subdivide, so that a limit of levels may have stopped them. */
static bool subdivides(const attempt *a)
{
    static const char *const names[] = {"regularity", "injectivity", "no zero", NULL};
    return is_one_of(a->test, names);
}

static bool is_about_eigenvalues(const attempt *a)
{
    static const char *const names[] = {"eigenpair", "spectrum", NULL};
    return is_one_of(a->test, names);
}

static int deeper(int level)
{
    return 2 * level < TREE_MAX_DEPTH ? 2 * level : TREE_MAX_DEPTH;
}

/* Twice as precise as the last attempt; 0: that is beyond what there is. */
static long more_precise(const attempt *a)
{
    long more = !strcmp(a->system, "interval") ? 256 : 2 * a->precision;
    return more <= LIMITS_MAX_PRECISION ? more : 0;
}

/* Where hardware intervals or few bits were not enough, bits may help; where thousands were not, hardly. */
static void advise_precision(char *text, size_t size, const attempt *a)
{
    enum { MANY_BITS = 1024 };
    long more = more_precise(a);
    if (more && (!is_about_eigenvalues(a) || a->precision < MANY_BITS))
        snprintf(text, size, "try --max-precision %ld", more);
    else if (is_about_eigenvalues(a))
        snprintf(text, size, "more bits will hardly help if eigenvalues are equal: see 'smoothcert spectrum' at this valence");
    else
        snprintf(text, size, "no option is likely to help");
}

void advise(char *text, size_t size, const decision *d)
{
    const attempt *a = decision_obstacle(d);
    if (d->outcome == OUTCOME_STOPPED || a->outcome == OUTCOME_STOPPED)
        snprintf(text, size, "try a longer --time-limit");
    else if (!strcmp(a->test, "regular complex"))
        snprintf(text, size, "no option helps: see 'smoothcert regular'");
    else if (!strncmp(a->test, "uniform", 7))
        snprintf(text, size, "try --method adaptive, or --max-level %d", deeper(a->level > 0 ? a->level : 1));
    else if (a->outcome == OUTCOME_UNDEFINED && subdivides(a) && a->max_level < TREE_MAX_DEPTH)
        snprintf(text, size, "try --max-level %d", deeper(a->max_level));
    else if (a->outcome == OUTCOME_FALSE && subdivides(a))
        snprintf(text, size, "it may not be C1; 'smoothcert report' shows the map");
    else if (a->outcome == OUTCOME_FALSE && is_about_eigenvalues(a))
        snprintf(text, size, "it may not be C1: see 'smoothcert spectrum' at this valence");
    else
        advise_precision(text, size, a);
}
