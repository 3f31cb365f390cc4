/* spectrum_test.c: the eigenvalue L of block 1, and its dominance over all blocks (verify/certificate.md, section 6). */
#include "tests.h"

#include "../lib/eigen_approx.h"
#include "../lib/eigenpair.h"
#include "../lib/spectrum.h"

#include <math.h>
#include <stdlib.h>

typedef struct {
    analysis *a;
    number scale; /* thin, >= 1/L */
} spectrum_run;

static outcome make_block(block *b, spectrum_run *r, long m)
{
    findings *f = r->a->findings;
    diagnostic d;
    switch (block_make(b, &r->a->numbers, m, true, &d)) {
    case BLOCK_OK:
        return OUTCOME_TRUE;
    case BLOCK_OPPOSITE:
        return findings_explain(f, OUTCOME_FALSE, "a rule reaches behind the extraordinary vertex, where its sheet is ambiguous");
    case BLOCK_NO_CENTRE_RULE:
        return findings_explain(f, OUTCOME_FALSE, "the scheme has no rule for the extraordinary vertex, and the mask is none");
    case BLOCK_BAD_INPUT:
        return findings_explain(f, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d.line, d.column, d.text);
    default:
        return OUTCOME_NO_MEMORY;
    }
}

/* Proves L and its eigenvector, 0 < L < 1, and sets scale. */
static outcome prove_eigenpair(spectrum_run *r)
{
    analysis *a = r->a;
    int n = a->dominant.n;
    const number *eigenvalue;
    number one, lower;
    outcome o = OUTCOME_TRUE;
    truth found = TRUTH_TRUE;
    a->box = number_array_new((size_t)n + 1);
    if (!a->box)
        return OUTCOME_NO_MEMORY;
    if (!a->replay)
        found = eigenpair_choose(&a->choices->eigenpair, a->dominant.entry, n, false, a->choices->grid, a->prec);
    else if (a->choices->eigenpair.n != n)
        return findings_explain(a->findings, OUTCOME_FALSE, "the eigenvector has not %d components", n);
    if (found == TRUTH_TRUE)
        found = eigenpair_prove(a->box, &a->choices->eigenpair, a->dominant.entry, a->prec);
    if (found != TRUTH_TRUE)
        return found == TRUTH_FALSE ? OUTCOME_NO_MEMORY
                                    : findings_explain(a->findings, OUTCOME_FAIL, "no box round an approximate dominant eigenpair of block 1 could be proved");
    eigenvalue = &a->box[n];
    number_init(&one);
    number_init(&lower);
    number_one(&one);
    if (number_is_positive(eigenvalue) != TRUTH_TRUE || number_less(eigenvalue, &one) != TRUTH_TRUE)
        o = findings_explain(a->findings, OUTCOME_FAIL, "the dominant eigenvalue of block 1 could not be shown to lie between 0 and 1");
    number_lower(&lower, eigenvalue, a->prec);
    number_inv(&r->scale, &lower, a->prec);
    number_upper(&r->scale, &r->scale, a->prec);
    a->findings->eigenvalue_lower = number_lower_bound(eigenvalue);
    a->findings->eigenvalue_upper = number_upper_bound(eigenvalue);
    number_clear(&one);
    number_clear(&lower);
    return o;
}

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

/* Raises the bound for the blocks examined so far, where needed, to one that also holds for this matrix: a little
   more than its approximate spectral radius.  Multiple eigenvalues need more than a little. */
static void bound_runner_up(spectrum_run *r, const number *rest, int n, long m)
{
    static const double slack[] = {0x1p-20, 0x1p-14, 0x1p-8, 0x1p-4};
    findings *f = r->a->findings;
    double *approximation = malloc(((size_t)n * (size_t)n + 1) * sizeof *approximation), radius = NAN;
    for (int i = 0; approximation && i < n * n; i++)
        approximation[i] = number_mid_approx(&rest[i]);
    if (approximation)
        radius = spectral_radius_approx(approximation, n);
    free(approximation);
    if (n == 0 || (radius * (1 + slack[0]) <= f->runner_up && is_bound(rest, n, f->runner_up, r->a->prec)))
        return;
    f->runner_up_block = m;
    for (size_t i = 0; i < sizeof slack / sizeof *slack; i++) {
        double candidate = fmax(radius * (1 + slack[i]), f->runner_up);
        if (candidate < f->eigenvalue_lower && is_bound(rest, n, candidate, r->a->prec)) {
            f->runner_up = candidate;
            return;
        }
    }
    f->runner_up = f->eigenvalue_upper; /* it is smaller than L, and that is all */
}

static outcome prove_rest(spectrum_run *r, const number *rest, int n, long m)
{
    analysis *a = r->a;
    int *power = &a->choices->power[m];
    spectral_answer answer = a->replay ? spectral_contraction(rest, &r->scale, n, *power, *power, a->prec)
                                       : spectral_contraction(rest, &r->scale, n, 0, CHOICES_MAX_POWER, a->prec);
    if (answer.contracts == TRUTH_FALSE)
        return OUTCOME_NO_MEMORY;
    if (answer.contracts == TRUTH_UNKNOWN)
        return findings_explain(a->findings, answer.diverges ? OUTCOME_FALSE : OUTCOME_FAIL,
                                "block %ld: its eigenvalues%s could not be shown to be smaller than that of block 1%s", m,
                                m == 0 ? " other than 1" : m == 1 ? " other than the dominant one" : "",
                                answer.diverges ? "; one of them seems to be at least as large" : "");
    *power = answer.power;
    if (!a->replay)
        bound_runner_up(r, rest, n, m);
    return OUTCOME_TRUE;
}

/* All eigenvalues of block m other than 1 (m = 0) and L (m = 1) are smaller than L. */
static outcome prove_block(spectrum_run *r, long m)
{
    analysis *a = r->a;
    block made, *b = m == 1 ? &a->dominant : &made;
    number *rest = NULL;
    outcome o = m == 1 ? OUTCOME_TRUE : make_block(&made, r, m);
    if (o == OUTCOME_TRUE && m <= 1) {
        size_t size = (size_t)(b->n - 1) * (size_t)(b->n - 1);
        rest = number_array_new(size);
        if (rest) {
            matrix_deflate(rest, b->entry, m ? a->box : NULL, b->n, m ? a->choices->eigenpair.pivot : 0, a->prec);
            o = prove_rest(r, rest, b->n - 1, m);
            number_array_free(rest, size);
        } else {
            o = OUTCOME_NO_MEMORY;
        }
    } else if (o == OUTCOME_TRUE) {
        o = prove_rest(r, b->entry, b->n, m);
    }
    if (m != 1)
        block_free(&made);
    return o;
}

outcome test_spectrum(analysis *a)
{
    spectrum_run r;
    outcome o;
    long total = 0;
    a->findings->test = "spectrum";
    a->findings->runner_up = 0;
    r.a = a;
    number_init(&r.scale);
    o = make_block(&a->dominant, &r, 1);
    if (o == OUTCOME_TRUE)
        o = prove_eigenpair(&r);
    for (long m = 0; o == OUTCOME_TRUE && m <= a->choices->valence / 2; m++) {
        o = prove_block(&r, m);
        total += a->choices->power[m];
    }
    if (o == OUTCOME_TRUE && total > CHOICES_MAX_TOTAL_POWER)
        o = findings_explain(a->findings, OUTCOME_FALSE, "the eigenvalues are separated, but only by powers with a sum beyond the limit of certificates (%d)", CHOICES_MAX_TOTAL_POWER);
    number_clear(&r.scale);
    return o;
}
