/* regular_complex_test.c: C1 on the regular complex, and the bounds of limits there (verify/certificate.md, section 4).

   They are exact, and problem.c has proved them for all valences; here they become choices, or are compared with those
   that a certificate has.  Compiled once per number system, like all tests. */
#include "tests.h"

#include <string.h>

outcome test_regular_complex(analysis *a)
{
    const problem *p = a->plan->problem;
    choices *c = a->choices;
    diagnostic d;
    bool plainly = false;
    status s;
    if (p->obstacle)
        return findings_explain(a->findings, OUTCOME_UNDEFINED, "%s", p->obstacle);
    s = is_one_valence(c->k) ? problem_is_plainly_regular(&plainly, p, c->k.first, &d) : STATUS_OK; /* a range never is */
    if (s != STATUS_OK)
        return s == STATUS_NO_MEMORY ? OUTCOME_NO_MEMORY : findings_explain(a->findings, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d.line, d.column, d.text);
    if (!plainly && p->special_obstacle)
        return findings_explain(a->findings, OUTCOME_UNDEFINED, "%s", p->special_obstacle);
    if (!a->replay) {
        memcpy(c->contraction, p->contraction, sizeof c->contraction);
        memcpy(c->stability, p->stability, sizeof c->stability);
        c->plainly_regular = plainly;
        return OUTCOME_TRUE;
    }
    if (memcmp(c->contraction, p->contraction, sizeof c->contraction) || c->plainly_regular != plainly)
        return findings_explain(a->findings, OUTCOME_FALSE, "the powers of the regular part are not the least ones");
    for (int i = 0; !plainly && i < RING_NETS; i++)
        if (c->stability[i].power != p->stability[i].power || c->stability[i].bound != p->stability[i].bound)
            return findings_explain(a->findings, OUTCOME_FALSE, "the bounds of the limits are not those that were found");
    return OUTCOME_TRUE;
}
