/* rerun_report.c: before and after. */
#include "rerun_report.h"

#include "json.h"

#include <math.h>
#include <stdio.h>

static bool holds(const rerun *r)
{
    return r->before->followed == OUTCOME_TRUE;
}

static verdict stated(const rerun *r)
{
    return r->before->claim.c1 ? VERDICT_PROVED : VERDICT_REFUTED;
}

static bool decided_anew(const rerun *r)
{
    return r->decision->verdict != VERDICT_UNDECIDED;
}

verdict rerun_verdict(const rerun *r)
{
    return holds(r) ? stated(r) : r->decision->verdict;
}

bool rerun_is_contradiction(const rerun *r)
{
    return holds(r) && decided_anew(r) && r->decision->verdict != stated(r);
}

/* ---- what became tighter ---- */

static bool has_eigenvalue(const examination *x)
{
    return x->followed == OUTCOME_TRUE && !x->choices.plainly_regular && x->choices.eigenpair.n > 0;
}

static bool is_comparable(const rerun *r)
{
    return decided_anew(r) && has_eigenvalue(r->before) && has_eigenvalue(r->after);
}

/* The radii are in units of 2^-grid: r 2^-g < s 2^-h? */
static bool is_eigenvalue_tighter(const rerun *r)
{
    const eigenpair_choice *a = &r->after->choices.eigenpair, *b = &r->before->choices.eigenpair;
    integer scaled;
    bool tighter = false;
    if (!is_comparable(r) || a->grid < b->grid)
        return false;
    integer_init(&scaled);
    if (integer_mul_2exp(&scaled, &b->radius, (unsigned long)(a->grid - b->grid)))
        tighter = integer_cmp(&a->radius, &scaled) < 0;
    integer_clear(&scaled);
    return tighter;
}

/* Bounds of the Jacobian are in the coordinates that the eigenvector gives: they are comparable if its pivot is the same. */
static bool has_jacobians(const rerun *r)
{
    const choices *a = &r->after->choices, *b = &r->before->choices;
    return is_comparable(r) && r->before->claim.c1 && a->claim == CLAIM_C1 && a->eigenpair.pivot == b->eigenpair.pivot && a->eigenpair.n == b->eigenpair.n &&
           isfinite(r->before->findings.jacobian) && isfinite(r->after->findings.jacobian);
}

static bool is_jacobian_tighter(const rerun *r)
{
    return has_jacobians(r) && r->after->findings.jacobian > r->before->findings.jacobian;
}

/* ---- a line for people ---- */

/* Printing moves a figure by at most half a unit of its last digit: so it still is a bound. */
static double round_down(double v)
{
    return v - fabs(v) * 0.000501;
}

static void print_tighter(const rerun *r)
{
    bool eigenvalue = is_eigenvalue_tighter(r), jacobian = is_jacobian_tighter(r);
    printf("; tighter: %s", eigenvalue && jacobian ? "L, Jacobian" : eigenvalue ? "L" : jacobian ? "Jacobian" : "nothing");
}

static void print_comparison(const rerun *r)
{
    char before[EXAMINE_RADIUS_TEXT], after[EXAMINE_RADIUS_TEXT];
    printf("; grid %ld -> %ld", r->before->choices.grid, r->after->choices.grid);
    examine_print_radius(before, &r->before->choices.eigenpair);
    examine_print_radius(after, &r->after->choices.eigenpair);
    printf(", L +/- %s -> %s", before, after);
    if (has_jacobians(r))
        printf(", Jacobian > %.4g -> %.4g", round_down(r->before->findings.jacobian), round_down(r->after->findings.jacobian));
    print_tighter(r);
}

static void print_search(const rerun *r)
{
    const decision *d = r->decision;
    if (d->verdict == VERDICT_UNDECIDED)
        printf("; a new search is undecided: %s: %s", decision_obstacle(d)->test, decision_obstacle(d)->reason);
    else if (is_comparable(r))
        print_comparison(r);
    else
        printf("; found anew");
}

void rerun_print_line(const rerun *r)
{
    char claim[160];
    examine_print_claim(claim, sizeof claim, r->before, r->scheme);
    if (rerun_is_contradiction(r))
        printf("contradiction: %s, and the opposite was found anew", claim);
    else if (holds(r))
        printf("still %s: %s", verdict_name(stated(r)), claim);
    else
        printf("%s anew: %s", verdict_name(rerun_verdict(r)), claim);
    if (!holds(r) && decided_anew(r) && r->decision->verdict != stated(r))
        printf(" is wrong");
    if (!holds(r) && !r->before->readable)
        printf(" (the certificate: line %ld: %s)", r->before->line, r->before->reason);
    else if (!holds(r))
        printf(" (its own choices do not prove it)");
    print_search(r);
    printf("%s; %s\n", r->decision->kept_before ? " (kept)" : "", r->file);
}

/* ---- JSON ---- */

static void add_figures(buffer *b, const char *name, const examination *x)
{
    char radius[EXAMINE_RADIUS_TEXT];
    buffer_print(b, ",\"%s\":{\"grid\":%ld", name, x->choices.grid);
    examine_print_radius(radius, &x->choices.eigenpair);
    json_add_string(b, "eigenvalue_radius", radius);
    if (x->choices.claim == CLAIM_C1)
        json_add_number(b, "jacobian_lower", x->findings.jacobian);
    buffer_print(b, "}");
}

void rerun_print_json(buffer *b, const rerun *r)
{
    char valences[VALENCE_RANGE_TEXT];
    valence_range_print(valences, r->before->claim.valences);
    buffer_print(b, "{\"verdict\":\"%s\",\"holds\":%s", verdict_name(rerun_verdict(r)), holds(r) ? "true" : "false");
    json_add_string(b, "scheme", r->scheme);
    json_add_string(b, "valence", valences);
    json_add_string(b, "claim", r->before->claim.c1 ? "c1" : "not-c1");
    json_add_string(b, "found_anew", verdict_name(r->decision->verdict));
    if (has_eigenvalue(r->before))
        add_figures(b, "before", r->before);
    if (decided_anew(r) && has_eigenvalue(r->after))
        add_figures(b, "after", r->after);
    if (is_comparable(r))
        buffer_print(b, ",\"tighter\":{\"eigenvalue\":%s,\"jacobian\":%s}", is_eigenvalue_tighter(r) ? "true" : "false", is_jacobian_tighter(r) ? "true" : "false");
    if (!r->before->readable)
        json_add_string(b, "trouble", r->before->reason);
    json_add_string(b, "certificate", r->file);
    buffer_print(b, "}");
}
