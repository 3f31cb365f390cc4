/* spectrum_test.c: the dominance of L over all blocks (verify/certificate.md, section 6).  Compiled once per number
   system. */
#include "tests.h"

#include "../lib/cover.h"
#include "../lib/spectrum.h"

#include <math.h>
#include <stdlib.h>

static outcome out_of_memory_or(truth contracts)
{
    return contracts == TRUTH_FALSE ? OUTCOME_NO_MEMORY : contracts == TRUTH_TRUE ? OUTCOME_TRUE : OUTCOME_FAIL;
}

/* Every other eigenvalue is at most radius/scale: the figure for people.  A replay does no more squarings than it must,
   and leaves the figure of the search. */
static void note_radius(analysis *a, double radius, long m)
{
    findings *f = a->findings;
    double bound = f->eigenvalue_upper * radius * (1 + 0x1p-50); /* 1/scale <= |L| */
    if (!a->replay && bound > f->runner_up) {
        f->runner_up = bound;
        f->runner_up_block = m;
    }
}

static outcome complain(analysis *a, frequencies m, bool diverges)
{
    const char *others = m.last == 0 ? " other than 1" : m.last == 1 ? " other than the dominant one" : "";
    const char *hint = diverges ? "; one of them seems to be at least as large" : "";
    outcome o = diverges ? OUTCOME_FALSE : OUTCOME_FAIL;
    if (m.first == m.last)
        return findings_explain(a->findings, o, "block %ld: its eigenvalues%s could not be shown to be smaller than that of block 1%s", m.first, others, hint);
    return findings_explain(a->findings, o, "blocks %ld to %ld: their eigenvalues could not be shown to be smaller than that of block 1%s", m.first, m.last, hint);
}

/* The matrix has only eigenvalues smaller than 1/scale: by the power in the choices, or by one that is added to them. */
static outcome contract(analysis *a, const number *rest, int n, long m)
{
    cover_list *blocks = &a->choices->blocks;
    spectral_answer answer;
    outcome o;
    if (a->replay) {
        int power = blocks->box[m].power;
        answer = spectral_contraction(rest, &a->scale, n, power, power, a->prec);
    } else {
        answer = spectral_contraction_sharp(rest, &a->scale, n, CHOICES_MAX_POWER, a->prec);
    }
    o = out_of_memory_or(answer.contracts);
    if (o == OUTCOME_TRUE && n > 0)
        note_radius(a, answer.radius, m);
    if (o == OUTCOME_TRUE && !a->replay && !cover_list_add(blocks, one_frequency(m), answer.power))
        o = OUTCOME_NO_MEMORY;
    return o == OUTCOME_FAIL ? complain(a, one_frequency(m), answer.diverges) : o;
}

/* Block 0 without the eigenvalue 1 of the vector of ones. */
static outcome prove_plain(analysis *a)
{
    block plain;
    outcome o = analysis_make_block(&plain, a, 0, 0);
    if (o == OUTCOME_TRUE) {
        size_t size = (size_t)(plain.n - 1) * (size_t)(plain.n - 1);
        number *rest = number_array_new(size);
        o = OUTCOME_NO_MEMORY;
        if (rest) {
            matrix_deflate(rest, plain.entry, NULL, plain.n, 0, a->prec);
            o = contract(a, rest, plain.n - 1, 0);
            number_array_free(rest, size);
        }
    }
    block_free(&plain);
    return o;
}

/* Block 1 without L. */
static outcome prove_dominant(analysis *a)
{
    const eigenpair_choice *e = &a->choices->eigenpair;
    int n = a->order - (e->complex_form ? 2 : 1);
    number *rest = number_array_new((size_t)n * (size_t)n);
    outcome o = OUTCOME_NO_MEMORY;
    if (rest) {
        (e->complex_form ? matrix_deflate_complex : matrix_deflate)(rest, a->matrix, a->box, a->order, e->pivot, a->prec);
        o = contract(a, rest, n, 1);
        number_array_free(rest, (size_t)n * (size_t)n);
    }
    return o;
}

static outcome from_status(analysis *a, block_status s, const diagnostic *d)
{
    switch (s) {
    case BLOCK_OK:
        return OUTCOME_TRUE;
    case BLOCK_OPPOSITE:
        return findings_explain(a->findings, OUTCOME_FALSE, "a rule reaches behind the extraordinary vertex, where its sheet is ambiguous");
    case BLOCK_NO_CENTRE_RULE:
        return findings_explain(a->findings, OUTCOME_FALSE, "the scheme has no rule for the extraordinary vertex, and the mask is none");
    case BLOCK_BAD_INPUT:
        return findings_explain(a->findings, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d->line, d->column, d->text);
    default:
        return OUTCOME_NO_MEMORY;
    }
}

outcome analysis_make_block(block *b, analysis *a, long first, long last)
{
    diagnostic d;
    frequencies m = {first, last};
    return from_status(a, block_make_range(b, &a->numbers, m, !a->choices->eigenpair.complex_form, &d), &d);
}

/* The boxes behind 0 and 1, as lib/cover.h has them. */
static outcome prove_ranges(analysis *a)
{
    static const cover_limits limits = {4 * CHOICES_MAX_BLOCKS, 0, CHOICES_MAX_POWER, true};
    cover_list *blocks = &a->choices->blocks, rest;
    frequencies m = {2, a->choices->valence / 2};
    cover_answer answer;
    diagnostic d;
    outcome o;
    cover_list_init(&rest);
    if (m.first > m.last)
        return !a->replay || blocks->count == 2 ? OUTCOME_TRUE : OUTCOME_FALSE;
    for (size_t i = 2; a->replay && i < blocks->count; i++)
        if (!cover_list_add(&rest, blocks->box[i].m, blocks->box[i].power)) {
            cover_list_clear(&rest);
            return OUTCOME_NO_MEMORY;
        }
    answer = a->replay ? cover_verify(&rest, &a->numbers, &a->scale, m, &d) : cover_search(&rest, &a->numbers, &a->scale, m, &limits, &d);
    o = from_status(a, answer.status, &d);
    if (o == OUTCOME_TRUE && !answer.proved)
        o = complain(a, answer.open, answer.diverges);
    if (o == OUTCOME_TRUE)
        note_radius(a, answer.radius, answer.largest);
    for (size_t i = 0; o == OUTCOME_TRUE && !a->replay && i < rest.count; i++)
        if (!cover_list_add(blocks, rest.box[i].m, rest.box[i].power))
            o = OUTCOME_NO_MEMORY;
    cover_list_clear(&rest);
    return o;
}

/* Do the first boxes hold 0 and 1, and nothing else? */
static bool begins_well(const cover_list *blocks)
{
    if (blocks->count < 2)
        return false;
    for (long m = 0; m <= 1; m++)
        if (blocks->box[m].m.first != m || blocks->box[m].m.last != m || blocks->box[m].power < 0)
            return false;
    return true;
}

static bool is_within_limits(const cover_list *blocks)
{
    long total = 0;
    for (size_t i = 0; i < blocks->count; i++)
        total += blocks->box[i].power;
    return total <= CHOICES_MAX_TOTAL_POWER && blocks->count <= CHOICES_MAX_BLOCKS;
}

outcome test_spectrum(analysis *a)
{
    cover_list *blocks = &a->choices->blocks;
    outcome o;
    if (!a->replay) {
        blocks->count = 0;
        a->findings->runner_up = 0;
        a->findings->runner_up_block = 0;
    } else if (!begins_well(blocks))
        return findings_explain(a->findings, OUTCOME_FALSE, "the blocks do not begin with those of the frequencies 0 and 1");
    o = prove_plain(a);
    if (o == OUTCOME_TRUE)
        o = prove_dominant(a);
    if (o == OUTCOME_TRUE)
        o = prove_ranges(a);
    if (o == OUTCOME_TRUE && !is_within_limits(blocks))
        o = findings_explain(a->findings, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or blocks beyond the limits of certificates (%d, %d)",
                             CHOICES_MAX_TOTAL_POWER, CHOICES_MAX_BLOCKS);
    a->plan->scale_upper = number_upper_bound(&a->scale);
    if (!a->replay)
        findings_last(a->findings)->bound = a->findings->runner_up;
    return o;
}
