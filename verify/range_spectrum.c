/* range_spectrum.c: block 0, block 1 and all others. */
#include "range_spectrum.h"

#include "tests.h"

#include "../lib/eigen_approx.h"
#include "../lib/eigenpair_affine.h"
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
    const number *scale;
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

/* Which box of the choices is that of a block: block 0, unless it has a limit, comes before that of the pair. */
static size_t box_of(const choices *c, long m)
{
    return m > 0 && !c->has_limit;
}

/* Squarings to follow; a search begins with none. */
static int least_power(const context *c, long m)
{
    return c->replay ? c->choices->blocks.box[box_of(c->choices, m)].power : 0;
}

static int most_power(const context *c, long m)
{
    return c->replay ? least_power(c, m) : CHOICES_MAX_POWER;
}

/* Takes over what bounds a block, without 1 and L, by itself. */
static outcome take_power(const context *c, spectral_answer answer, long m)
{
    if (answer.contracts == TRUTH_FALSE)
        return OUTCOME_NO_MEMORY;
    if (answer.contracts != TRUTH_TRUE)
        return findings_explain(c->findings, answer.diverges ? OUTCOME_FALSE : OUTCOME_FAIL,
                                "block %ld: its eigenvalues other than %s could not be shown to be smaller than the dominant one of block %ld at all these valences", m,
                                m == c->choices->frequency ? "it" : "1", c->choices->frequency);
    note_radius(c, answer.radius);
    return c->replay || cover_list_add(&c->choices->blocks, one_frequency(m), answer.power) ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

/* What is left of the pair's block. */
static outcome prove_rest_of(const context *c, const range_pair *pair)
{
    long m = c->choices->frequency;
    return take_power(c, affine_contract_rest(pair->matrix, pair->box, pair->order, pair->pivot, c->scale, least_power(c, m), most_power(c, m), c->prec), m);
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
            o = take_power(c, spectral_contraction(rest, c->scale, plain.n - 1, least_power(c, 0), most_power(c, 0), c->prec), 0);
            number_array_free(rest, size);
        }
    }
    block_free(&plain);
    scheme_numbers_free(&numbers);
    return o;
}

/* Block 0 as a function of 1/k. */
static outcome prove_limit(const context *c, const number *slope)
{
    const limit_task task = {c->scheme, c->choices->k, c->scale, slope};
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

static long inverse_integers(const eigenpair_choice *e)
{
    return (long)e->n * e->n;
}

static bool is_within_limits(const choices *z)
{
    long powers = z->has_limit ? z->limit.power : 0, integers = inverse_integers(&z->eigenpair) + (z->has_limit ? inverse_integers(&z->limit.eigenpair) : 0);
    for (size_t i = 0; i < z->blocks.count; i++)
        powers += z->blocks.box[i].power;
    for (size_t i = 0; i < z->rise.count; i++) {
        powers += z->rise.box[i].power;
        integers += inverse_integers(&z->rise.box[i].eigenpair);
    }
    for (size_t i = 0; i < z->window.count; i++) {
        powers += z->window.wave[i].power;
        integers += inverse_integers(&z->window.wave[i].eigenpair);
    }
    for (size_t i = 0; i < z->spans.count; i++)
        powers += z->spans.box[i].power;
    return powers <= CHOICES_MAX_TOTAL_POWER && integers <= CHOICES_MAX_INVERSE_INTEGERS && z->rise.count <= CHOICES_MAX_RISES && z->spans.count <= CHOICES_MAX_BLOCKS;
}

static outcome check_limits(const context *c)
{
    if (is_within_limits(c->choices))
        return OUTCOME_TRUE;
    return findings_explain(c->findings, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or boxes beyond the limits of certificates");
}

static bool is_box_of(const cover_list *z, size_t i, long m)
{
    return i < z->count && z->box[i].m.first == m && z->box[i].m.last == m;
}

/* Boxes of block 0, unless it has a limit, and of the pair's block, and no others? */
static bool has_its_blocks(const choices *z)
{
    const cover_list *blocks = &z->blocks;
    size_t count = (size_t)!z->has_limit + (z->frequency > 0);
    return blocks->count == count && (z->has_limit || is_box_of(blocks, 0, 0)) && (z->frequency == 0 || is_box_of(blocks, box_of(z, z->frequency), z->frequency));
}

/* Before a search nothing; before a replay, its blocks. */
static outcome start(const context *c)
{
    choices *z = c->choices;
    if (c->replay)
        return has_its_blocks(z) ? OUTCOME_TRUE : findings_explain(c->findings, OUTCOME_FALSE, "there should be boxes of block 0 and of the block that dominates");
    cover_list_clear(&z->blocks);
    rise_list_clear(&z->rise);
    span_list_clear(&z->spans);
    z->has_limit = false;
    c->findings->runner_up = 0;
    return OUTCOME_TRUE;
}

outcome range_spectrum(findings *f, choices *c, const scheme *s, const range_pair *pair, const number *scale, bool replay, long prec)
{
    const context z = {f, c, s, scale, replay, prec};
    outcome o = start(&z);
    if (o == OUTCOME_TRUE && !replay)
        o = choose_limit(&z);
    if (o == OUTCOME_TRUE)
        o = c->has_limit ? prove_limit(&z, &pair->box[pair->order].slope) : prove_plain(&z);
    if (o == OUTCOME_TRUE)
        o = prove_rest_of(&z, pair);
    if (o == OUTCOME_TRUE)
        o = prove_others(&z);
    if (o == OUTCOME_TRUE)
        o = check_limits(&z);
    if (!replay)
        findings_last(f)->bound = f->runner_up;
    return o;
}

/* ---- without a chain: all blocks but some ---- */

/* The spans of the choices from number `at` on that are about the task. */
static size_t spans_of(const span_list *z, size_t at, const span_task *task)
{
    size_t count = 0;
    while (at + count < z->count && z->box[at + count].q <= task->end && z->box[at + count].m.last <= task->m.last)
        count++;
    return count;
}

/* Of the frequencies m, where m/k is between start and end; *at: the next span of the choices. */
static outcome prove_side(const context *c, frequencies m, int64_t start, int64_t end, size_t *at)
{
    const cover_limits limits = {4 * CHOICES_MAX_BLOCKS, 0, CHOICES_MAX_POWER, false};
    const span_task task = {c->scheme, c->choices->k, m, start, end};
    span_list *spans = &c->choices->spans;
    size_t count = c->replay ? spans_of(spans, *at, &task) : 0;
    diagnostic d;
    span_answer answer = c->replay ? span_verify(spans->box + *at, count, &task, c->scale, c->prec, &d) : span_search(spans, &task, c->scale, &limits, c->prec, &d);
    outcome o = outcome_from_block(c->findings, answer.status, &d);
    *at += count;
    if (o == OUTCOME_TRUE && answer.stopped)
        return findings_explain(c->findings, OUTCOME_STOPPED, "no time left");
    if (o == OUTCOME_TRUE && !answer.proved)
        return findings_explain(c->findings, OUTCOME_FAIL, "other blocks: their eigenvalues could not be shown to be smaller than those that dominate");
    if (o == OUTCOME_TRUE)
        note_radius(c, answer.radius);
    return o;
}

/* All spans were about something. */
static outcome check_end(const context *c, size_t at)
{
    if (!c->replay || at == c->choices->spans.count)
        return check_limits(c);
    return findings_explain(c->findings, OUTCOME_FALSE, "there are spans of more blocks than the others");
}

outcome range_spectrum_of_frequency(findings *f, choices *c, const scheme *s, const range_pair *pair, const number *scale, bool replay, long prec)
{
    const context z = {f, c, s, scale, replay, prec};
    long m = c->frequency;
    size_t at = 0;
    outcome o = start(&z);
    if (o == OUTCOME_TRUE && m > 0)
        o = prove_plain(&z);
    if (o == OUTCOME_TRUE)
        o = prove_rest_of(&z, pair);
    if (o == OUTCOME_TRUE && m > 1)
        o = prove_side(&z, (frequencies){1, m - 1}, 0, ARC_HALF, &at);
    if (o == OUTCOME_TRUE)
        o = prove_side(&z, (frequencies){m + 1, FREQUENCIES_UNBOUNDED}, 0, ARC_HALF, &at);
    if (o == OUTCOME_TRUE)
        o = check_end(&z, at);
    if (!replay)
        findings_last(f)->bound = f->runner_up;
    return o;
}

/* Block 0 is the only one with a box of its own. */
outcome range_window_spectrum(findings *f, choices *c, const scheme *s, const number *scale, bool replay, long prec)
{
    const context z = {f, c, s, scale, replay, prec};
    const frequencies m = {1, FREQUENCIES_UNBOUNDED};
    size_t at = 0;
    outcome o = OUTCOME_TRUE;
    if (!replay) {
        cover_list_clear(&c->blocks);
        span_list_clear(&c->spans);
        c->has_limit = false;
    } else if (c->has_limit || c->blocks.count != 1 || !is_box_of(&c->blocks, 0, 0)) {
        return findings_explain(f, OUTCOME_FALSE, "there should be a box of block 0");
    }
    o = prove_plain(&z);
    if (o == OUTCOME_TRUE)
        o = prove_side(&z, m, 0, c->window.start, &at);
    if (o == OUTCOME_TRUE)
        o = prove_side(&z, m, window_choice_end(&c->window), ARC_HALF, &at);
    return o == OUTCOME_TRUE ? check_end(&z, at) : o;
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
