/* spectrum_test.c: the dominance of L over all blocks (verify/certificate.md, section 6).  Compiled once per number
   system. */
#include "tests.h"

#include "../lib/eigen_approx.h"
#include "../lib/spectrum.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Is every eigenvalue of the matrix smaller than the candidate in modulus? */
static bool is_bound(const number *rest, int n, double candidate, long prec)
{
    bool proved;
    number scale;
    number_init(&scale);
    number_set_double(&scale, candidate, prec);
    number_inv(&scale, &scale, prec);
    number_upper(&scale, &scale, prec);
    proved = spectral_contraction(rest, &scale, n, 0, CHOICES_MAX_POWER, prec).contracts == TRUTH_TRUE;
    number_clear(&scale);
    return proved;
}

static double radius_approx(const number *rest, int n)
{
    double *approximation = malloc(((size_t)n * (size_t)n + 1) * sizeof *approximation), radius = NAN;
    for (int i = 0; approximation && i < n * n; i++)
        approximation[i] = number_mid_approx(&rest[i]);
    if (approximation)
        radius = spectral_radius_approx(approximation, n);
    free(approximation);
    return radius;
}

/* Raises the bound for the blocks examined so far, where needed, to one that also holds for this matrix: a little
   more than its approximate spectral radius.  Multiple eigenvalues need more than a little. */
static void bound_runner_up(analysis *a, const number *rest, int n, long m)
{
    static const double slack[] = {0x1p-20, 0x1p-14, 0x1p-8, 0x1p-4};
    findings *f = a->findings;
    double radius = radius_approx(rest, n);
    if (n == 0 || (radius * (1 + slack[0]) <= f->runner_up && is_bound(rest, n, f->runner_up, a->prec)))
        return;
    f->runner_up_block = m;
    for (size_t i = 0; i < sizeof slack / sizeof *slack; i++) {
        double candidate = fmax(radius * (1 + slack[i]), f->runner_up);
        if (candidate < f->eigenvalue_lower && is_bound(rest, n, candidate, a->prec)) {
            f->runner_up = candidate;
            return;
        }
    }
    f->runner_up = f->eigenvalue_upper; /* it is smaller than |L|, and that is all */
}

static outcome explain(analysis *a, long first, long last, bool diverges)
{
    char which[64];
    if (first == last)
        snprintf(which, sizeof which, "block %ld", first);
    else
        snprintf(which, sizeof which, "blocks %ld to %ld", first, last);
    return findings_explain(a->findings, diverges ? OUTCOME_FALSE : OUTCOME_FAIL, "%s: eigenvalues%s could not be shown to be smaller than that of block 1%s",
                            which, last == 0 ? " other than 1" : last == 1 ? " other than the dominant one" : "",
                            diverges ? "; one of them seems to be at least as large" : "");
}

/* The eigenvalues of the matrix are smaller than 1/scale; power: found, or to be followed. */
static outcome prove_rest(analysis *a, const number *rest, int n, block_choice *c, bool *diverges)
{
    spectral_answer answer = a->replay ? spectral_contraction(rest, &a->scale, n, c->power, c->power, a->prec)
                                       : spectral_contraction(rest, &a->scale, n, 0, CHOICES_MAX_POWER, a->prec);
    *diverges = answer.diverges;
    if (answer.contracts == TRUTH_FALSE)
        return OUTCOME_NO_MEMORY;
    c->power = answer.power;
    return answer.contracts == TRUTH_TRUE ? OUTCOME_TRUE : OUTCOME_FAIL;
}

/* The same of a block, or of all blocks of a range: all eigenvalues other than 1 (m = 0) and L (m = 1). */
static outcome prove_blocks(analysis *a, block_choice *c, bool *diverges)
{
    block made;
    int n = a->order, pivots = 0;
    number *matrix = a->matrix, *rest = NULL;
    outcome o = OUTCOME_TRUE;
    bool of_dominant = c->first == 1 && c->last == 1;
    *diverges = false;
    if (!of_dominant) {
        o = analysis_make_block(&made, a, c->first, c->last);
        matrix = o == OUTCOME_TRUE ? block_real_matrix(&n, &made) : NULL;
        block_free(&made);
    }
    if (c->last == 0)
        pivots = 1;
    else if (of_dominant)
        pivots = a->choices->eigenpair.complex_form ? 2 : 1;
    if (o == OUTCOME_TRUE && matrix && pivots) {
        rest = number_array_new((size_t)(n - pivots) * (size_t)(n - pivots));
        if (rest && pivots == 2)
            matrix_deflate_complex(rest, matrix, a->box, n, a->choices->eigenpair.pivot, a->prec);
        else if (rest && of_dominant)
            matrix_deflate(rest, matrix, a->box, n, a->choices->eigenpair.pivot, a->prec);
        else if (rest)
            matrix_deflate(rest, matrix, NULL, n, 0, a->prec);
    }
    if (o == OUTCOME_TRUE)
        o = matrix && (rest || !pivots) ? prove_rest(a, pivots ? rest : matrix, n - pivots, c, diverges) : OUTCOME_NO_MEMORY;
    if (o == OUTCOME_TRUE && !a->replay)
        bound_runner_up(a, pivots ? rest : matrix, n - pivots, c->first);
    if (rest)
        number_array_free(rest, (size_t)(n - pivots) * (size_t)(n - pivots));
    if (matrix && !of_dominant)
        number_array_free(matrix, (size_t)n * (size_t)n);
    return o;
}

/* ---- following ---- */

/* Do the blocks cover 0..k/2 in order, 0 and 1 by themselves? */
static bool is_cover(const choices *c)
{
    long next = 0;
    for (int i = 0; i < c->block_count; i++) {
        const block_choice *b = &c->blocks[i];
        if (b->first != next || b->last < b->first || (i < 2 && b->last != i))
            return false;
        next = b->last + 1;
    }
    return next == c->valence / 2 + 1;
}

static outcome follow(analysis *a)
{
    choices *c = a->choices;
    outcome o = OUTCOME_TRUE;
    if (!is_cover(c))
        return findings_explain(a->findings, OUTCOME_FALSE, "the blocks do not cover the frequencies 0, 1 ... %ld in order", c->valence / 2);
    for (int i = 0; o == OUTCOME_TRUE && i < c->block_count; i++) {
        bool diverges;
        o = prove_blocks(a, &c->blocks[i], &diverges);
        if (o == OUTCOME_FAIL && findings_last(a->findings)->reason[0] == '\0')
            explain(a, c->blocks[i].first, c->blocks[i].last, false);
    }
    return o;
}

/* ---- searching ---- */

/* Ranges of blocks, from m = 2 on: twice as wide as the last if that succeeds, narrower if not.  Near m = 0 eigenvalues
   change like m^2/k^2, and so does their distance from L: the width that succeeds grows like m. */
static outcome cover_ranges(analysis *a)
{
    choices *c = a->choices;
    long end = c->valence / 2, width = 1;
    for (long m = 2; m <= end;) {
        block_choice b = {m, width - 1 > end - m ? end : m + width - 1, 0};
        bool diverges;
        outcome o = prove_blocks(a, &b, &diverges);
        if (deadline_passed(a->plan->deadline))
            return findings_explain(a->findings, OUTCOME_STOPPED, "no time left");
        if (o == OUTCOME_TRUE) {
            if (!choices_add_block(c, b))
                return OUTCOME_NO_MEMORY;
            m = b.last + 1;
            width = 2 * width;
        } else if (o != OUTCOME_FAIL || b.first == b.last) {
            return o == OUTCOME_FAIL ? explain(a, b.first, b.last, diverges) : o;
        } else {
            width = (b.last - b.first + 1) / 2;
        }
    }
    return OUTCOME_TRUE;
}

static outcome search(analysis *a)
{
    choices *c = a->choices;
    c->block_count = 0;
    a->findings->runner_up = 0;
    a->findings->runner_up_block = 0;
    for (long m = 0; m <= 1; m++) {
        block_choice b = {m, m, 0};
        bool diverges;
        outcome o = prove_blocks(a, &b, &diverges);
        if (o != OUTCOME_TRUE)
            return o == OUTCOME_FAIL ? explain(a, m, m, diverges) : o;
        if (!choices_add_block(c, b))
            return OUTCOME_NO_MEMORY;
    }
    return cover_ranges(a);
}

outcome test_spectrum(analysis *a)
{
    outcome o = a->replay ? follow(a) : search(a);
    long total = 0;
    for (int i = 0; i < a->choices->block_count; i++)
        total += a->choices->blocks[i].power;
    if (o == OUTCOME_TRUE && (total > CHOICES_MAX_TOTAL_POWER || a->choices->block_count > CHOICES_MAX_BLOCKS))
        o = findings_explain(a->findings, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers or blocks beyond the limits of certificates (%d, %d)",
                             CHOICES_MAX_TOTAL_POWER, CHOICES_MAX_BLOCKS);
    a->plan->scale_upper = number_upper_bound(&a->scale);
    if (!a->replay)
        findings_last(a->findings)->bound = a->findings->runner_up;
    return o;
}
