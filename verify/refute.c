/* refute.c: the reasons, one after the other. */
#include "refute.h"

#include <math.h>

#include "exact_search.h"
#include "gap.h"

#include <stdio.h>
#include <string.h>

/* A radius this near to 1 may be beyond. */
#define NEARLY_ONE (1 - 1e-9)
/* What is exactly equal is looked for when this many bits tell nothing. */
#define EXACT_PRECISION 128

static bool is_final(outcome o)
{
    return o == OUTCOME_TRUE || o == OUTCOME_NO_MEMORY || o == OUTCOME_STOPPED;
}

static outcome attempt_choices(findings *f, choices *c, const analysis_plan *plan, long precision)
{
    analysis_plan own = {.problem = plan->problem, .max_level = plan->max_level, .deadline = plan->deadline, .system = plan->system};
    f->level = 0;
    f->elements = 0;
    return analysis_search(f, c, &own, precision);
}

static outcome attempt_claim(findings *f, choices *c, const analysis_plan *plan, claim_kind claim, long frequency, bool pair, long valence, long precision)
{
    choices_clear(c);
    c->claim = claim;
    c->frequency = frequency;
    c->pair = pair;
    c->k = one_valence(valence);
    return attempt_choices(f, c, plan, precision);
}

/* What comes next after a real function of block m: a pair of blocks, or block 0; its largest modulus, too. */
static long second_block(double *radius, const candidates *z, long m)
{
    bool zero = m != 0 && z->radius_of_zero > z->radius_of_pair;
    *radius = zero ? z->radius_of_zero : z->radius_of_pair;
    return zero ? 0 : z->pair;
}

/* A single real function in front of all, and what comes next. */
static outcome attempt_real(findings *f, choices *c, const suspicion *s, const analysis_plan *plan, int i, long valence, long precision)
{
    double radius;
    long second = second_block(&radius, &s->candidates, s->candidates.frequency[i]);
    if (!(radius > 0 && radius < s->candidates.radius[i]))
        return OUTCOME_FAIL;
    choices_clear(c);
    c->claim = CLAIM_REAL;
    c->frequency = s->candidates.frequency[i];
    c->second_frequency = second;
    c->k = one_valence(valence);
    return attempt_choices(f, c, plan, precision);
}

/* That the block's eigenvalue, or of a real block a pair of them, is larger than all others, or than 1. */
static outcome attempt_eigenvalue(findings *f, choices *c, const suspicion *s, const analysis_plan *plan, int i, bool pair, long valence, long precision)
{
    long m = s->candidates.frequency[i];
    outcome o = OUTCOME_FAIL;
    if (s->candidates.radius[i] > NEARLY_ONE)
        o = attempt_claim(f, c, plan, CLAIM_NOT_C0, m, pair, valence, precision);
    if (!is_final(o) && m != 1)
        o = attempt_claim(f, c, plan, CLAIM_FREQUENCY, m, pair, valence, precision);
    return o;
}

/* Block i of the candidates. */
static outcome attempt_block(findings *f, choices *c, const suspicion *s, const analysis_plan *plan, int i, long valence, long precision)
{
    long m = s->candidates.frequency[i];
    bool half = 2 * m == valence;
    outcome o = half ? OUTCOME_FAIL : attempt_eigenvalue(f, c, s, plan, i, false, valence, precision);
    if (!is_final(o) && (m == 0 || half))
        o = attempt_real(f, c, s, plan, i, valence, precision);
    if (!is_final(o) && (m == 0 || half))
        o = attempt_eigenvalue(f, c, s, plan, i, true, valence, precision);
    return o;
}

/* Numbers that are equal, which no precision tells. */
static outcome attempt_exact(findings *f, choices *c, suspicion *s, const analysis_plan *plan, long valence, long precision)
{
    truth found;
    choices_clear(c);
    c->k = one_valence(valence);
    found = exact_search(&c->exact, &c->claim, plan->problem->scheme, valence, &s->candidates);
    s->no_exact = found == TRUTH_UNKNOWN;
    return found == TRUTH_TRUE ? attempt_choices(f, c, plan, precision) : found == TRUTH_FALSE ? OUTCOME_NO_MEMORY : OUTCOME_FAIL;
}

static outcome look_for_candidates(suspicion *s, const analysis_plan *plan, long valence, bool hardware)
{
    diagnostic unused;
    status result;
    if (s->made)
        return OUTCOME_TRUE;
    result = hardware ? candidates_find_interval(&s->candidates, plan->problem->scheme, valence, &unused)
                      : candidates_find_ball(&s->candidates, plan->problem->scheme, valence, &unused);
    s->made = true;
    if (result != STATUS_OK)
        s->candidates.count = s->candidates.near = 0;
    return result == STATUS_NO_MEMORY ? OUTCOME_NO_MEMORY : OUTCOME_TRUE;
}

outcome refute(findings *f, choices *c, suspicion *s, const analysis_plan *plan, long valence, long precision)
{
    outcome o = look_for_candidates(s, plan, valence, precision == 0);
    if (o != OUTCOME_TRUE)
        return o;
    o = OUTCOME_FAIL;
    if (s->folds)
        o = attempt_claim(f, c, plan, CLAIM_FOLD, 1, false, valence, precision);
    if (!is_final(o) && s->winds)
        o = attempt_claim(f, c, plan, CLAIM_WINDING, 1, false, valence, precision);
    for (int i = 0; !is_final(o) && i < s->candidates.near; i++)
        o = attempt_block(f, c, s, plan, i, valence, precision);
    if (!is_final(o) && precision >= EXACT_PRECISION && s->candidates.count && !s->no_exact)
        o = attempt_exact(f, c, s, plan, valence, precision);
    return is_final(o) ? o : OUTCOME_FAIL;
}

void refute_note_gap(attempt *a, const suspicion *s, const analysis_plan *plan, long valence, long precision)
{
    size_t length = strlen(a->reason);
    long bits;
    if (precision == 0 || s->candidates.near < 2 || gap_between_ball(&bits, plan->problem->scheme, valence, s->candidates.frequency, precision) != TRUTH_TRUE || bits < precision / 2)
        return;
    snprintf(a->reason + length, sizeof a->reason - length, "; the gap to block %ld is at most 2^-%ld after %ld bits: possibly an exact tie",
             s->candidates.frequency[s->candidates.frequency[0] == 1], bits, precision);
}

/* The two blocks that count. */
static void describe_tie(char *text, size_t size, const exact_choice *e, double l)
{
    int which[2] = {0, 0}, found = 0;
    for (int i = 0; i < e->count && found < 2; i++)
        if (e->line[i].column)
            which[found++] = i;
    snprintf(text, size, "blocks %ld and %ld share the largest modulus exactly (%.8f%s); there is no tangent plane", e->line[which[0]].frequency, e->line[which[1]].frequency, l,
             e->line[which[0]].size > 1 ? ", in Jordan blocks of the same size" : "");
}

static void describe_jordan(char *text, size_t size, const choices *c, double l)
{
    int q = 1;
    for (int i = 0; i < c->exact.count; i++)
        if (c->exact.line[i].column)
            q = c->exact.line[i].size;
    if (c->frequency)
        snprintf(text, size, "frequency %ld dominates (%.8f exactly, in a Jordan block of %d rows, the largest); the surface would wind %ld times", c->frequency, l, q, c->frequency);
    else
        snprintf(text, size, "frequency 0 dominates (%.8f exactly, in a Jordan block of %d rows, the largest); nothing turns round the point", l, q);
}

/* What frequency m makes of a curve round the point. */
static void describe_frequency(char *text, size_t size, const choices *c, double l, double radius_of_one)
{
    int length = snprintf(text, size, "frequency %ld dominates%s (%.8f, frequency 1 has %.8f); ", c->frequency, c->pair ? " by a complex pair" : "", l, radius_of_one);
    if (c->frequency)
        snprintf(text + length, size - (size_t)length, "the surface would wind %ld times", c->frequency);
    else if (c->pair)
        snprintf(text + length, size - (size_t)length, "the surface would wind 0 times, or a multiple of %ld", c->k.first);
    else
        snprintf(text + length, size - (size_t)length, "nothing turns round the point");
}

static void describe_real(char *text, size_t size, const choices *c, double l, const suspicion *s)
{
    double radius;
    second_block(&radius, &s->candidates, c->frequency);
    snprintf(text, size, "block %ld dominates (%.8f), a real function, and then block %ld (%.8f); %s", c->frequency, l, c->second_frequency, radius,
             c->second_frequency ? "the normals have no limit" : "the map of both folds");
}

void refute_describe(char *text, size_t size, const choices *c, const findings *f, const suspicion *s)
{
    double l = f->eigenvalue_lower;
    switch (c->claim) {
    case CLAIM_FREQUENCY:
        describe_frequency(text, size, c, l, s->candidates.radius_of_one);
        break;
    case CLAIM_NOT_C0:
        snprintf(text, size, "block %ld has an eigenvalue beyond 1 (%.8f); there is no continuous limit", c->frequency, l);
        break;
    case CLAIM_FOLD:
        snprintf(text, size, "the characteristic map folds; its Jacobian has both signs");
        break;
    case CLAIM_WINDING:
        snprintf(text, size, "winding: the characteristic map winds %ld times round the extraordinary point", f->windings);
        break;
    case CLAIM_REAL:
        describe_real(text, size, c, l, s);
        break;
    case CLAIM_TIE:
        describe_tie(text, size, &c->exact, l);
        break;
    case CLAIM_JORDAN:
        describe_jordan(text, size, c, l);
        break;
    case CLAIM_MODULUS_ONE:
        snprintf(text, size, "block %ld has the eigenvalue %d exactly; there is no continuous limit", c->frequency, c->exact.line[0].sign);
        break;
    default:
        text[0] = '\0';
    }
}
