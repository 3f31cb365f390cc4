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
    long f = a->choices->frequency;
    const char *others = m.last == 0 ? " other than 1" : m.first == f && m.last == f ? " other than the dominant one" : "";
    const char *hint = diverges ? "; one of them seems to be at least as large" : "";
    outcome o = diverges ? OUTCOME_FALSE : OUTCOME_FAIL;
    if (m.first == m.last)
        return findings_explain(a->findings, o, "block %ld: its eigenvalues%s could not be shown to be smaller than that of block %ld%s", m.first, others, f, hint);
    return findings_explain(a->findings, o, "blocks %ld to %ld: their eigenvalues could not be shown to be smaller than that of block %ld%s", m.first, m.last, f, hint);
}

/* The matrix has only eigenvalues smaller than 1/scale: by the power of the next box of the choices, which must be m
   alone, or by one that is added to them. */
static outcome contract(analysis *a, const number *rest, int n, long m, size_t *next)
{
    cover_list *blocks = &a->choices->blocks;
    spectral_answer answer;
    outcome o;
    if (a->replay) {
        const cover_box *box = &blocks->box[*next];
        if (*next >= blocks->count || box->m.first != m || box->m.last != m || box->power < 0)
            return findings_explain(a->findings, OUTCOME_FALSE, "the next box should be that of block %ld alone", m);
        answer = spectral_contraction(rest, &a->scale, n, box->power, box->power, a->prec);
    } else {
        answer = spectral_contraction_sharp(rest, &a->scale, n, CHOICES_MAX_POWER, a->prec);
    }
    ++*next;
    o = out_of_memory_or(answer.contracts);
    if (o == OUTCOME_TRUE && n > 0)
        note_radius(a, answer.radius, m);
    if (o == OUTCOME_TRUE && !a->replay && !cover_list_add(blocks, one_frequency(m), answer.power))
        o = OUTCOME_NO_MEMORY;
    return o == OUTCOME_FAIL ? complain(a, one_frequency(m), answer.diverges) : o;
}

/* Block 0 without the eigenvalue 1 of the vector of ones. */
static outcome prove_plain(analysis *a, size_t *next)
{
    block plain;
    outcome o = analysis_make_block(&plain, a, 0, 0);
    if (o == OUTCOME_TRUE) {
        size_t size = (size_t)(plain.n - 1) * (size_t)(plain.n - 1);
        number *rest = number_array_new(size);
        o = OUTCOME_NO_MEMORY;
        if (rest) {
            matrix_deflate(rest, plain.entry, NULL, plain.n, 0, a->prec);
            o = contract(a, rest, plain.n - 1, 0, next);
            number_array_free(rest, size);
        }
    }
    block_free(&plain);
    return o;
}

static bool is_not_zero(const number *x)
{
    return number_is_positive(x) == TRUTH_TRUE || number_is_negative(x) == TRUTH_TRUE;
}

/* Block 0 or k/2 without the pair of L, which must not be real. */
static outcome prove_pair(analysis *a, size_t *next)
{
    const eigenpair_choice *e = &a->choices->eigenpair;
    int n = a->order / 2 - 2, second = eigenpair_choice_second_pivot(e);
    number *rest;
    outcome o;
    if (second < 0 || !is_not_zero(&a->box[a->order + 1]) || !is_not_zero(&a->box[a->order / 2 + second]))
        return findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block %ld could not be shown not to be real", a->choices->frequency);
    rest = number_array_new((size_t)n * (size_t)n);
    if (!rest)
        return OUTCOME_NO_MEMORY;
    matrix_deflate_pair(rest, a->matrix, a->box, a->order, e->pivot, second, a->prec);
    o = contract(a, rest, n, a->choices->frequency, next);
    number_array_free(rest, (size_t)n * (size_t)n);
    return o;
}

/* The block of L without L. */
static outcome prove_dominant(analysis *a, size_t *next)
{
    const eigenpair_choice *e = &a->choices->eigenpair;
    int n = a->order - (e->complex_form ? 2 : 1);
    number *rest = number_array_new((size_t)n * (size_t)n);
    outcome o = OUTCOME_NO_MEMORY;
    if (rest) {
        (e->complex_form ? matrix_deflate_complex : matrix_deflate)(rest, a->matrix, a->box, a->order, e->pivot, a->prec);
        o = contract(a, rest, n, a->choices->frequency, next);
        number_array_free(rest, (size_t)n * (size_t)n);
    }
    return o;
}

/* The boxes of the choices from *next on that begin in the range. */
static bool take_boxes(cover_list *z, const cover_list *blocks, frequencies m, size_t *next)
{
    for (; *next < blocks->count && blocks->box[*next].m.first <= m.last; ++*next)
        if (!cover_list_add(z, blocks->box[*next].m, blocks->box[*next].power))
            return false;
    return true;
}

/* All blocks of a range, in which the one of L is not, as lib/cover.h has it. */
static outcome prove_range(analysis *a, frequencies m, size_t *next)
{
    const cover_limits limits = {4 * CHOICES_MAX_BLOCKS, 0, CHOICES_MAX_POWER, true};
    cover_list *blocks = &a->choices->blocks, boxes;
    cover_answer answer;
    diagnostic d;
    outcome o;
    if (m.first > m.last)
        return OUTCOME_TRUE;
    cover_list_init(&boxes);
    if (a->replay && !take_boxes(&boxes, blocks, m, next)) {
        cover_list_clear(&boxes);
        return OUTCOME_NO_MEMORY;
    }
    answer = a->replay ? cover_verify(&boxes, &a->numbers, &a->scale, m, &d) : cover_search(&boxes, &a->numbers, &a->scale, m, &limits, &d);
    o = analysis_from_block(a, answer.status, &d);
    if (o == OUTCOME_TRUE && answer.stopped)
        o = findings_explain(a->findings, OUTCOME_STOPPED, "no time left");
    else if (o == OUTCOME_TRUE && !answer.proved)
        o = complain(a, answer.open, answer.diverges);
    if (o == OUTCOME_TRUE)
        note_radius(a, answer.radius, answer.largest);
    for (size_t i = 0; o == OUTCOME_TRUE && !a->replay && i < boxes.count; i++, ++*next)
        if (!cover_list_add(blocks, boxes.box[i].m, boxes.box[i].power))
            o = OUTCOME_NO_MEMORY;
    cover_list_clear(&boxes);
    return o;
}

static bool is_within_limits(const cover_list *blocks)
{
    long total = 0;
    for (size_t i = 0; i < blocks->count; i++)
        total += blocks->box[i].power;
    return total <= CHOICES_MAX_TOTAL_POWER && blocks->count <= CHOICES_MAX_BLOCKS;
}

/* The blocks from m.first to m.last, 0 among them or not. */
static outcome prove_between(analysis *a, frequencies m, size_t *next)
{
    outcome o = OUTCOME_TRUE;
    if (m.first == 0 && m.last >= 0) {
        o = prove_plain(a, next);
        m.first = 1;
    }
    return o == OUTCOME_TRUE ? prove_range(a, m, next) : o;
}

/* The i-th of the blocks that are treated otherwise, by rising frequency: they are known exactly, or have the eigenvalues of
   the eigenpairs. */
static long special_block(const choices *c, int i)
{
    if (claim_is_exact(c->claim))
        return c->exact.line[i].frequency;
    if (c->claim == CLAIM_REAL && (c->second_frequency < c->frequency) == (i == 0))
        return c->second_frequency;
    return c->frequency;
}

static outcome prove_special(analysis *a, long m, size_t *next)
{
    bool second = a->choices->claim == CLAIM_REAL && m == a->choices->second_frequency;
    outcome o;
    if (claim_is_exact(a->choices->claim))
        return OUTCOME_TRUE;
    if (second)
        analysis_exchange(a);
    o = (a->choices->pair ? prove_pair : prove_dominant)(a, next);
    if (second)
        analysis_exchange(a);
    return o;
}

/* All blocks; of the special ones what is left. */
static outcome prove_all(analysis *a, size_t *next)
{
    const choices *c = a->choices;
    int special = claim_is_exact(c->claim) ? c->exact.count : c->claim == CLAIM_REAL ? 2 : 1;
    long first = 0;
    outcome o = OUTCOME_TRUE;
    for (int i = 0; o == OUTCOME_TRUE && i < special; i++) {
        long m = special_block(c, i);
        o = prove_between(a, (frequencies){first, m - 1}, next);
        if (o == OUTCOME_TRUE)
            o = prove_special(a, m, next);
        first = m + 1;
    }
    return o == OUTCOME_TRUE ? prove_between(a, (frequencies){first, c->k.first / 2}, next) : o;
}

outcome test_spectrum(analysis *a)
{
    cover_list *blocks = &a->choices->blocks;
    size_t next = 0;
    outcome o;
    if (!a->replay) {
        blocks->count = 0;
        a->findings->runner_up = 0;
        a->findings->runner_up_block = 0;
    }
    o = prove_all(a, &next);
    if (o == OUTCOME_TRUE && next != blocks->count)
        o = findings_explain(a->findings, OUTCOME_FALSE, "there are boxes of more blocks than 0 to %ld", a->choices->k.first / 2);
    if (o == OUTCOME_TRUE && !is_within_limits(blocks))
        o = findings_explain(a->findings, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or blocks beyond the limits of certificates (%d, %d)",
                             CHOICES_MAX_TOTAL_POWER, CHOICES_MAX_BLOCKS);
    a->plan->scale_upper = number_upper_bound(&a->scale);
    if (!a->replay)
        findings_last(a->findings)->bound = a->findings->runner_up;
    return o;
}
