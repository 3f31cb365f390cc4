/* range_spectrum.c: block 0, block 1 and all others. */
#include "range_spectrum.h"

#include "tests.h"

#include "../lib/separation.h"
#include "../lib/spectrum.h"

#include <math.h>
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

/* Block m by itself is bounded, m being 0 or 1: the box number m of the choices. */
static outcome contract(const context *c, const number *rest, int n, long m)
{
    cover_list *blocks = &c->choices->blocks;
    int power = c->replay ? blocks->box[m].power : 0, limit = c->replay ? power : CHOICES_MAX_POWER;
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
    long total = 0;
    for (size_t i = 0; i < z->blocks.count; i++)
        total += z->blocks.box[i].power;
    for (size_t i = 0; i < z->rise.count; i++)
        total += z->rise.box[i].power;
    for (size_t i = 0; i < z->spans.count; i++)
        total += z->spans.box[i].power;
    return total <= CHOICES_MAX_TOTAL_POWER && z->rise.count <= CHOICES_MAX_RISES && z->spans.count <= CHOICES_MAX_BLOCKS;
}

/* Two boxes, block 0 and block 1? */
static bool has_two_blocks(const cover_list *z)
{
    return z->count == 2 && z->box[0].m.first == 0 && z->box[0].m.last == 0 && z->box[1].m.first == 1 && z->box[1].m.last == 1;
}

outcome range_spectrum(findings *f, choices *c, const scheme *s, const number *rest, int n, const number *scale, bool replay, long prec)
{
    const context z = {f, c, s, scale, replay, prec};
    outcome o;
    if (!replay) {
        cover_list_clear(&c->blocks);
        rise_list_clear(&c->rise);
        span_list_clear(&c->spans);
        f->runner_up = 0;
    } else if (!has_two_blocks(&c->blocks)) {
        return findings_explain(f, OUTCOME_FALSE, "there should be boxes of block 0 and of block 1");
    }
    o = prove_plain(&z);
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
