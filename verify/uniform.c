/* uniform.c: levels 0, 1, 2 ... until every test has an answer. */
#include "uniform.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *words;
    outcome (*run)(analysis *);
    bool proved;
} level_test;

enum { ISOLATION, INJECTIVITY, REGULARITY, LEVEL_TESTS };

double uniform_largest_error(const analysis *a, int net, int other)
{
    double error = 0;
    for (int c = 0; c < 2; c++)
        error = fmax(error, fmax(number_upper_bound(&a->uniform[net].error[c]), number_upper_bound(&a->uniform[other].error[c])));
    return error;
}

static outcome make_nets(analysis *a)
{
    const ring *r = &a->plan->problem->geometry;
    outcome o = analysis_make_net(a);
    for (int i = 0; o == OUTCOME_TRUE && i < RING_NETS; i++)
        switch (uniform_net_make(&a->uniform[i], &a->net, r, i, &a->mask[i], a->plan->uniform, a->prec)) {
        case BLOCK_OK:
            break;
        case BLOCK_NO_MEMORY:
            return OUTCOME_NO_MEMORY;
        default:
            return findings_explain(a->findings, OUTCOME_FALSE, "the ring's net reaches behind the extraordinary vertex, where its sheet is ambiguous");
        }
    return o;
}

static long triangles_of(const analysis *a)
{
    long inner = (long)a->plan->problem->geometry.radius << a->uniform[0].level;
    return 3 * inner * inner;
}

static outcome run_test(analysis *a, level_test *t)
{
    double start = deadline_now();
    attempt *log = findings_begin(a->findings, t->words, a->plan->system, a->prec);
    log->max_level = a->plan->max_level;
    log->level = a->uniform[0].level;
    log->elements = triangles_of(a);
    log->outcome = t->run(a);
    log->seconds = deadline_now() - start;
    t->proved = log->outcome == OUTCOME_TRUE;
    return log->outcome;
}

/* OUTCOME_UNDEFINED: another level is needed. */
static outcome run_level(analysis *a, level_test *tests)
{
    bool proved = true;
    for (int i = 0; i < LEVEL_TESTS; i++) {
        if (!tests[i].proved && (i != INJECTIVITY || tests[ISOLATION].proved)) {
            outcome o = run_test(a, &tests[i]);
            if (o != OUTCOME_TRUE && o != OUTCOME_UNDEFINED)
                return o;
        }
        proved = proved && tests[i].proved;
    }
    return proved ? OUTCOME_TRUE : OUTCOME_UNDEFINED;
}

/* Are the widths of the nets' intervals as large as the errors that come from the level? */
static bool precision_matters(const analysis *a)
{
    for (int i = 0; i < RING_NETS; i++)
        if (!(4 * uniform_net_width(&a->uniform[i], a->prec) < uniform_largest_error(a, i, i)))
            return true;
    return false;
}

/* Says which tests are open. */
static outcome give_up(analysis *a, const level_test *tests)
{
    char open[128] = "";
    for (int i = 0; i < LEVEL_TESTS; i++)
        if (!tests[i].proved) {
            strcat(open, open[0] ? ", " : "");
            strcat(open, tests[i].words);
        }
    findings_begin(a->findings, "uniform subdivision", a->plan->system, a->prec)->level = a->uniform[0].level;
    return findings_explain(a->findings, precision_matters(a) ? OUTCOME_FAIL : OUTCOME_UNDEFINED, "still open after %d subdivisions: %s%s", a->uniform[0].level,
                            open, a->uniform[0].level < a->plan->max_level ? "; the next net would be too large" : "");
}

static outcome refine_nets(analysis *a)
{
    outcome o = a->uniform[0].level < a->plan->max_level ? OUTCOME_TRUE : OUTCOME_UNDEFINED;
    for (int i = 0; o == OUTCOME_TRUE && i < RING_NETS; i++)
        o = uniform_net_refine(&a->uniform[i], a->plan->deadline, a->prec);
    if (o == OUTCOME_STOPPED)
        findings_explain(a->findings, o, "no time left");
    return o;
}

static outcome run_levels(analysis *a)
{
    level_test tests[LEVEL_TESTS] = {
        {"uniform isolation", test_uniform_isolation, false},
        {"uniform injectivity", test_uniform_injectivity, false},
        {"uniform regularity", test_uniform_regularity, false},
    };
    outcome o = make_nets(a);
    while (o == OUTCOME_TRUE) {
        o = run_level(a, tests);
        if (o == OUTCOME_TRUE) {
            a->findings->uniform = true;
            a->findings->uniform_level = a->uniform[0].level;
            a->findings->uniform_elements = triangles_of(a);
            return o;
        }
        if (o == OUTCOME_UNDEFINED)
            o = precision_matters(a) ? OUTCOME_FAIL : refine_nets(a);
    }
    return o == OUTCOME_UNDEFINED || o == OUTCOME_FAIL ? give_up(a, tests) : o;
}

outcome analysis_uniform(analysis *a)
{
    outcome o = OUTCOME_NO_MEMORY;
    a->uniform = malloc(RING_NETS * sizeof *a->uniform);
    if (!a->uniform)
        return o;
    for (int i = 0; i < RING_NETS; i++)
        uniform_net_init(&a->uniform[i]);
    o = run_levels(a);
    for (int i = 0; i < RING_NETS; i++)
        uniform_net_clear(&a->uniform[i]);
    free(a->uniform);
    a->uniform = NULL;
    return o;
}
