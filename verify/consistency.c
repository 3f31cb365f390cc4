/* consistency.c: three statements about one valence. */
#include "consistency.h"

#include "escalate.h"

#include <stdio.h>

/* Enough for all but near ties. */
#define MAX_PRECISION 256

static status take_verdict(consistency *z, const problem *p, long k, bool no_intervals)
{
    limits l = {.max_precision = MAX_PRECISION, .no_intervals = no_intervals};
    decision d;
    status result = STATUS_OK;
    decision_init(&d);
    decide_valence(&d, p, k, NULL, &l);
    if (d.outcome == OUTCOME_NO_MEMORY)
        result = STATUS_NO_MEMORY;
    else if (d.outcome == OUTCOME_BAD_INPUT)
        result = STATUS_BAD_INPUT;
    z->verdict = d.verdict;
    if (d.verdict != VERDICT_PROVED)
        snprintf(z->reason, sizeof z->reason, "%s", d.verdict == VERDICT_REFUTED ? d.reason : decision_obstacle(&d)->reason);
    decision_clear(&d);
    return result;
}

status consistency_make(consistency *z, const scheme *s, long k, const spectrum_list *l, long dominant, bool no_intervals)
{
    problem p;
    status result = STATUS_NO_MEMORY;
    z->reason[0] = '\0';
    z->dominant = dominant < 0 ? -1 : l->entry[dominant].m;
    z->signs = criterion_of_signs(s, k, l, dominant);
    z->waves = criterion_of_waves(s, k, l);
    problem_init(&p);
    if (problem_make(&p, s))
        result = take_verdict(z, &p, k, no_intervals);
    problem_clear(&p);
    return result;
}

bool consistency_is_broken(const consistency *z)
{
    bool waves = z->waves.applies && z->waves.holds == TRUTH_TRUE, no_signs = z->signs.applies && z->signs.holds == TRUTH_FALSE;
    bool proved = z->verdict == VERDICT_PROVED;
    return (proved && (no_signs || (z->dominant >= 0 && z->dominant != 1))) || (waves && (z->verdict == VERDICT_REFUTED || no_signs));
}

void consistency_print(const consistency *z)
{
    static const char *const signs[] = {
        [TRUTH_FALSE] = "they sum to 0, so they cannot be alike, hence not C1", [TRUTH_TRUE] = "all alike, as C1 needs (this sees neither wrong frequencies nor folds)", [TRUTH_UNKNOWN] = "not decided"};
    static const char *const waves[] = {[TRUTH_FALSE] = "lambda < |mu_0|, nothing follows", [TRUTH_TRUE] = "lambda > |mu_0|, hence C1", [TRUTH_UNKNOWN] = "not decided"};
    printf("C1 here: %s%s%s\n", verdict_name(z->verdict), z->reason[0] ? "; " : "", z->reason);
    if (z->signs.applies)
        printf("Kawaharada and Sugihara's signs of normals: %s\n", signs[z->signs.holds]);
    if (z->waves.applies)
        printf("Chen and Prautzsch's (5.1), Theorem 6.1: %s\n", waves[z->waves.holds]);
}

static const char *name_of(criterion c)
{
    return !c.applies ? "null" : c.holds == TRUTH_TRUE ? "true" : c.holds == TRUTH_FALSE ? "false" : "\"undecided\"";
}

void consistency_print_json(const consistency *z)
{
    printf(",\"c1\":\"%s\",\"signs_alike\":%s,\"waves_inequality\":%s", verdict_name(z->verdict), name_of(z->signs), name_of(z->waves));
}
