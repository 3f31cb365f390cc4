/* range_spectrum.c: block 0, block 1 and all others. */
#include "range_spectrum.h"

#include "tests.h"

#include "../lib/eigen_approx.h"
#include "../lib/limit.h"
#include "../lib/resting_centre.h"
#include "../lib/separation.h"
#include "../lib/spectrum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    findings *findings;
    choices *choices;
    const scheme *scheme;
    const number *scale, *slope;
    bool replay;
    long prec;
} context;

/* Every other eigenvalue is at most radius/scale: the figure for people, of a search. */
static void note_radius(const context *c, double radius)
{
    double bound = c->findings->eigenvalue_upper * radius * (1 + 0x1p-50);
    if (!c->replay)
        c->findings->runner_up = fmax(c->findings->runner_up, bound);
}

/* Which box of the choices is that of block m, 0 or 1; block 0 may have a limit instead. */
static long box_of(const choices *c, long m)
{
    return c->has_limit ? m - 1 : m;
}

/* Block m by itself is bounded, m being 0 or 1. */
static outcome contract(const context *c, const number *rest, int n, long m)
{
    cover_list *blocks = &c->choices->blocks;
    int power = c->replay ? blocks->box[box_of(c->choices, m)].power : 0, limit = c->replay ? power : CHOICES_MAX_POWER;
    spectral_answer answer = spectral_contraction(rest, c->scale, n, power, limit, c->prec);
    if (answer.contracts == TRUTH_FALSE)
        return OUTCOME_NO_MEMORY;
    if (answer.contracts != TRUTH_TRUE)
        return findings_explain(c->findings, answer.diverges ? OUTCOME_FALSE : OUTCOME_FAIL,
                                "block %ld: its eigenvalues other than %s could not be shown to be smaller than that one of block 1 at all these valences", m, m ? "it" : "1");
    note_radius(c, n > 0 ? answer.radius : 0);
    return c->replay || cover_list_add(blocks, one_frequency(m), answer.power) ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

/* Block 0 without the eigenvalue 1 of the vector of ones; weights over all valences. */
static outcome prove_plain(const context *c)
{
    scheme_numbers numbers;
    block plain;
    diagnostic d;
    outcome o = OUTCOME_NO_MEMORY;
    status made = scheme_numbers_make_range(&numbers, c->scheme, c->choices->k, c->prec, &d);
    memset(&plain, 0, sizeof plain);
    if (made == STATUS_OK)
        o = outcome_from_block(c->findings, block_make_range(&plain, &numbers, one_frequency(0), true, &d), &d);
    else if (made == STATUS_BAD_INPUT)
        o = outcome_from_block(c->findings, BLOCK_BAD_INPUT, &d);
    if (o == OUTCOME_TRUE) {
        size_t size = (size_t)(plain.n - 1) * (size_t)(plain.n - 1);
        number *rest = number_array_new(size);
        o = OUTCOME_NO_MEMORY;
        if (rest) {
            matrix_deflate(rest, plain.entry, NULL, plain.n, 0, c->prec);
            o = contract(c, rest, plain.n - 1, 0);
            number_array_free(rest, size);
        }
    }
    block_free(&plain);
    scheme_numbers_free(&numbers);
    return o;
}

/* Block 0 as a function of 1/k. */
static outcome prove_limit(const context *c)
{
    const limit_task task = {c->scheme, c->choices->k, c->scale, c->slope};
    diagnostic d;
    limit_answer answer = c->replay ? limit_verify(&c->choices->limit, &task, c->prec, &d)
                                    : limit_search(&c->choices->limit, &task, CHOICES_MAX_POWER, c->choices->grid, c->prec, &d);
    outcome o = outcome_from_block(c->findings, answer.status, &d);
    if (o == OUTCOME_TRUE && !answer.proved)
        o = findings_explain(c->findings, OUTCOME_FAIL, "block 0: its eigenvalues other than 1 tend to that of block 1 and could not be shown to fall behind it at all these valences");
    note_radius(c, 1);
    return o;
}

/* Does block 0 tend to block 1? */
static outcome choose_limit(const context *c)
{
    diagnostic d;
    status s = scheme_centre_rests(&c->choices->has_limit, c->scheme, c->choices->k, &d);
    return s == STATUS_OK ? OUTCOME_TRUE : outcome_from_block(c->findings, s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY, &d);
}

static outcome prove_others(const context *c)
{
    const cover_limits limits = {4 * CHOICES_MAX_BLOCKS, 0, CHOICES_MAX_POWER, false};
    choices *z = c->choices;
    diagnostic d;
    separation_answer answer = c->replay ? separation_verify(&z->rise, &z->spans, c->scheme, z->k, c->scale, c->prec, &d)
                                         : separation_search(&z->rise, &z->spans, c->scheme, z->k, c->scale, &limits, z->grid, c->prec, &d);
    outcome o = outcome_from_block(c->findings, answer.status, &d);
    if (o != OUTCOME_TRUE)
        return o;
    if (answer.stopped)
        return findings_explain(c->findings, OUTCOME_STOPPED, "no time left");
    if (!answer.proved)
        return findings_explain(c->findings, answer.span.diverges ? OUTCOME_FALSE : OUTCOME_FAIL,
                                "blocks 2 and more: their eigenvalues could not be shown to be smaller than that of block 1 at all these valences");
    note_radius(c, z->rise.count ? 1 : answer.span.radius);
    return OUTCOME_TRUE;
}

static bool is_within_limits(const choices *z)
{
    long total = z->has_limit ? z->limit.power : 0;
    for (size_t i = 0; i < z->blocks.count; i++)
        total += z->blocks.box[i].power;
    for (size_t i = 0; i < z->rise.count; i++)
        total += z->rise.box[i].power;
    for (size_t i = 0; i < z->spans.count; i++)
        total += z->spans.box[i].power;
    return total <= CHOICES_MAX_TOTAL_POWER && z->rise.count <= CHOICES_MAX_RISES && z->spans.count <= CHOICES_MAX_BLOCKS;
}

/* Boxes of block 0, unless it has a limit, and of block 1? */
static bool has_two_blocks(const choices *z)
{
    const cover_list *blocks = &z->blocks;
    for (long m = z->has_limit; m <= 1; m++) {
        size_t i = (size_t)box_of(z, m);
        if (i >= blocks->count || blocks->box[i].m.first != m || blocks->box[i].m.last != m)
            return false;
    }
    return blocks->count == (z->has_limit ? 1 : 2);
}

outcome range_spectrum(findings *f, choices *c, const scheme *s, const number *rest, int n, const number *scale, const number *slope, bool replay, long prec)
{
    const context z = {f, c, s, scale, slope, replay, prec};
    outcome o = OUTCOME_TRUE;
    if (!replay) {
        cover_list_clear(&c->blocks);
        rise_list_clear(&c->rise);
        span_list_clear(&c->spans);
        f->runner_up = 0;
        o = choose_limit(&z);
    } else if (!has_two_blocks(c)) {
        return findings_explain(f, OUTCOME_FALSE, "there should be boxes of block 0 and of block 1");
    }
    if (o == OUTCOME_TRUE)
        o = (c->has_limit ? prove_limit : prove_plain)(&z);
    if (o == OUTCOME_TRUE)
        o = contract(&z, rest, n, 1);
    if (o == OUTCOME_TRUE)
        o = prove_others(&z);
    if (o == OUTCOME_TRUE && !is_within_limits(c))
        o = findings_explain(f, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or boxes beyond the limits of certificates");
    if (!replay)
        findings_last(f)->bound = f->runner_up;
    return o;
}

/* ---- all blocks outside a window ---- */

/* The spans of the choices from number `at` on that end at the end of the task or before. */
static size_t spans_until(const span_list *z, size_t at, int64_t end)
{
    size_t count = 0;
    while (at + count < z->count && z->box[at + count].q <= end)
        count++;
    return count;
}

/* Of m/k between start and end; *at: the next span of the choices. */
static outcome prove_side(const context *c, int64_t start, int64_t end, size_t *at)
{
    const cover_limits limits = {4 * CHOICES_MAX_BLOCKS, 0, CHOICES_MAX_POWER, false};
    span_task task = {c->scheme, c->choices->k, {1, FREQUENCIES_UNBOUNDED}, start, end};
    span_list *spans = &c->choices->spans;
    size_t count = c->replay ? spans_until(spans, *at, end) : 0;
    diagnostic d;
    span_answer answer = c->replay ? span_verify(spans->box + *at, count, &task, c->scale, c->prec, &d) : span_search(spans, &task, c->scale, &limits, c->prec, &d);
    outcome o = outcome_from_block(c->findings, answer.status, &d);
    *at += count;
    if (o == OUTCOME_TRUE && answer.stopped)
        return findings_explain(c->findings, OUTCOME_STOPPED, "no time left");
    if (o == OUTCOME_TRUE && !answer.proved)
        return findings_explain(c->findings, OUTCOME_FAIL, "blocks outside the window: their eigenvalues could not be shown to be smaller than those of some block in it");
    if (o == OUTCOME_TRUE)
        note_radius(c, answer.radius);
    return o;
}

outcome range_window_spectrum(findings *f, choices *c, const scheme *s, const number *scale, bool replay, long prec)
{
    const context z = {f, c, s, scale, NULL, replay, prec};
    size_t at = 0;
    outcome o;
    if (!replay) {
        cover_list_clear(&c->blocks);
        span_list_clear(&c->spans);
        c->has_limit = false;
    } else if (c->has_limit || c->blocks.count != 1 || c->blocks.box[0].m.first != 0 || c->blocks.box[0].m.last != 0) {
        return findings_explain(f, OUTCOME_FALSE, "there should be a box of block 0");
    }
    o = prove_plain(&z);
    if (o == OUTCOME_TRUE)
        o = prove_side(&z, 0, c->window.start, &at);
    if (o == OUTCOME_TRUE)
        o = prove_side(&z, window_choice_end(&c->window), ARC_HALF, &at);
    if (o == OUTCOME_TRUE && replay && at != c->spans.count)
        o = findings_explain(f, OUTCOME_FALSE, "there are spans of more than the blocks outside the window");
    if (o == OUTCOME_TRUE && !is_within_limits(c))
        o = findings_explain(f, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or boxes beyond the limits of certificates");
    return o;
}

outcome range_contract(int *power, const number *rest, int n, const number *scale, bool replay, long prec)
{
    spectral_answer answer = spectral_contraction(rest, scale, n, replay ? *power : 0, replay ? *power : CHOICES_MAX_POWER, prec);
    *power = answer.power;
    return answer.contracts == TRUTH_FALSE ? OUTCOME_NO_MEMORY : answer.contracts == TRUTH_TRUE ? OUTCOME_TRUE : OUTCOME_FAIL;
}

double range_radius_approx(const scheme *s, valence_range k, int64_t q, long prec)
{
    const frequencies m = {2, FREQUENCIES_UNBOUNDED};
    affine_matrix b;
    arc r;
    diagnostic unused;
    double radius = NAN;
    arc_init(&r);
    memset(&b, 0, sizeof b);
    if (arc_set_units(&r, q, q) && affine_matrix_make(&b, s, k, m, &r, prec, &unused) == BLOCK_OK) {
        double *mid = malloc((size_t)b.n * (size_t)b.n * sizeof *mid);
        for (int i = 0; mid && i < b.n * b.n; i++)
            mid[i] = number_mid_approx(&b.entry[i].centre);
        if (mid)
            radius = spectral_radius_approx(mid, b.n);
        free(mid);
    }
    affine_matrix_free(&b);
    arc_clear(&r);
    return radius;
}
