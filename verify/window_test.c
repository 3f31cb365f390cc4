/* window_test.c: for m/k in a window some block dominates, whichever it is, and its eigenfunction does not turn once
   (verify/certificate-valences.md, section 6).  Compiled for affine numbers. */
#include "tests.h"

#include "../lib/block_affine.h"
#include "../lib/charnet.h"
#include "../lib/eigenpair_affine.h"
#include "../lib/scheme_range.h"
#include "range_spectrum.h"

#include <math.h>
#include <string.h>

/* ---- one wave ---- */

/* The block over m/k from `from` to w->q. */
static outcome make_block(analysis *a, int64_t from, const window_wave *w)
{
    const frequencies m = {2, FREQUENCIES_UNBOUNDED};
    arc r;
    diagnostic d;
    outcome o = OUTCOME_NO_MEMORY;
    arc_init(&r);
    if (arc_set_units(&r, from, w->q))
        o = analysis_from_block(a, block_make_over(&a->dominant, &a->numbers, m, &r, &d), &d);
    a->order = a->dominant.n;
    arc_clear(&r);
    return o;
}

/* 0 < l < 1 or -1 < l < 0; *strong: |l| >= R everywhere. */
static outcome bound_pair(analysis *a, bool *strong)
{
    number size, one, excess, bound;
    outcome o = OUTCOME_TRUE;
    number_init(&size);
    number_init(&one);
    number_init(&excess);
    number_init(&bound);
    number_one(&one);
    number_set(&size, &a->box[a->order]);
    if (number_is_negative(&size) == TRUTH_TRUE)
        number_neg(&size, &size);
    number_sub(&excess, &one, &size, a->prec);
    if (number_is_positive(&size) != TRUTH_TRUE || number_is_positive(&excess) != TRUTH_TRUE)
        o = findings_explain(a->findings, OUTCOME_FAIL, "an eigenvalue of the window could not be shown to lie between 0 and 1");
    base_set_integer_2exp(&bound.centre, &a->choices->window.bound, -a->choices->grid, a->prec);
    number_sub(&excess, &size, &bound, a->prec);
    *strong = number_is_positive(&excess) == TRUTH_TRUE;
    if (*strong)
        a->findings->eigenvalue_upper = fmax(a->findings->eigenvalue_upper, number_upper_bound(&size));
    number_clear(&size);
    number_clear(&one);
    number_clear(&excess);
    number_clear(&bound);
    return o;
}

/* All other eigenvalues of the blocks are below the bound. */
static outcome bound_rest(analysis *a, window_wave *w)
{
    spectral_answer rest = BASE_NAME(affine_contract_rest)(a->dominant.entry, a->box, a->order, w->eigenpair.pivot, &a->scale.centre, a->replay ? w->power : 0,
                                                           a->replay ? w->power : CHOICES_MAX_POWER, a->prec);
    w->power = rest.power;
    if (rest.contracts == TRUTH_UNKNOWN)
        return findings_explain(a->findings, OUTCOME_FAIL, "a second eigenvalue of a block in the window could not be shown to be smaller");
    return rest.contracts == TRUTH_TRUE ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

/* The eigenfunctions have no zero on the outer curve, by the trees of the wave. */
static outcome prove_curve(analysis *a, window_wave *w)
{
    tree_word kept = a->choices->boundary;
    outcome o = analysis_from_block(a, charnet_make(&a->net, &a->dominant, a->box, false, &a->numbers, a->plan->problem->geometry.rings), NULL);
    a->net_made = o == OUTCOME_TRUE;
    a->choices->boundary = w->boundary;
    if (o == OUTCOME_TRUE)
        o = test_zero_free(a);
    w->boundary = a->choices->boundary;
    a->choices->boundary = kept;
    return o;
}

static void forget(analysis *a)
{
    sector_net_free(&a->net);
    a->net_made = false;
    if (a->box)
        number_array_free(a->box, (size_t)a->order + 1);
    a->box = NULL;
    block_free(&a->dominant);
    memset(&a->dominant, 0, sizeof a->dominant);
}

static outcome prove_wave(analysis *a, int64_t from, window_wave *w, bool *strong)
{
    outcome o = make_block(a, from, w);
    if (o == OUTCOME_TRUE)
        o = analysis_prove_pair(a, &w->eigenpair, "a part of the window");
    if (o == OUTCOME_TRUE)
        o = bound_pair(a, strong);
    if (o == OUTCOME_TRUE)
        o = bound_rest(a, w);
    if (o == OUTCOME_TRUE)
        o = prove_curve(a, w);
    forget(a);
    return o;
}

/* ---- the window ---- */

enum { SAMPLES = 256, MAX_WAVES = 1000 };

/* Between these samples; the eigenvalue is at least `level` between the inner ones. */
typedef struct {
    int low, high;
    double level;
} window_guess;

static int64_t place(int sample)
{
    return ARC_HALF / SAMPLES * sample;
}

/* Round the largest sample, wide enough to hold m/k for some m at every k, and then some more, until all else is smaller. */
static bool guess_window(window_guess *z, const double *radius, valence_range k)
{
    int peak = 1, low, high, first = (int)ceil(1.05 * 2 * SAMPLES / (double)k.first), length = (int)ceil(1.1 * 2 * SAMPLES / (double)k.first) + 1;
    for (int i = 1; i <= SAMPLES; i++)
        peak = radius[i] > radius[peak] ? i : peak;
    for (low = high = peak; high - low < length;) {
        if (low <= first || high >= SAMPLES - 1)
            return false;
        if (radius[low - 1] > radius[high + 1])
            low--;
        else
            high++;
    }
    z->level = fmin(radius[low], radius[high]) * 0.995;
    while (low > first && radius[low] > z->level * 0.985)
        low--;
    while (high < SAMPLES - 1 && radius[high] > z->level * 0.985)
        high++;
    z->low = low;
    z->high = high;
    for (int i = 0; i <= SAMPLES; i++)
        if ((i <= low || i >= high) && !(radius[i] < z->level * 0.99))
            return false;
    return low > first;
}

static outcome choose_window(analysis *a, window_guess *guess)
{
    const scheme *s = a->plan->problem->scheme;
    window_choice *w = &a->choices->window;
    double radius[SAMPLES + 1];
    bool vary, ok;
    diagnostic unused;
    base_number bound;
    window_choice_clear(w);
    if (scheme_weights_vary_with_frequency(&vary, s, a->choices->k, &unused) != STATUS_OK || vary)
        return findings_explain(a->findings, OUTCOME_FAIL, "weights depend on the frequency: blocks are no function of m/k");
    for (int i = 0; i <= SAMPLES; i++)
        radius[i] = BASE_NAME(range_radius_approx)(s, a->choices->k, place(i), a->prec);
    if (!guess_window(guess, radius, a->choices->k))
        return findings_explain(a->findings, OUTCOME_FAIL, "no window of frequencies seems to dominate at all these valences");
    base_init(&bound);
    base_set_double(&bound, guess->level, a->prec);
    ok = base_lower_grid(&w->bound, &bound, a->choices->grid);
    base_clear(&bound);
    w->start = place(guess->low);
    return ok ? OUTCOME_TRUE : OUTCOME_NO_MEMORY;
}

/* 1/R, rounded up. */
static void set_scale(analysis *a)
{
    base_set_integer_2exp(&a->scale.centre, &a->choices->window.bound, -a->choices->grid, a->prec);
    base_inv(&a->scale.centre, &a->scale.centre, a->prec);
    base_upper(&a->scale.centre, &a->scale.centre, a->prec);
}

/* Is there a part of strong waves that holds some m/k for every k? */
typedef struct {
    int64_t begin; /* of the waves in a row that are strong; -1: none */
    bool wide;
} strong_part;

static void note_strength(strong_part *p, bool strong, int64_t from, int64_t to, long k)
{
    if (!strong) {
        p->begin = -1;
        return;
    }
    p->begin = p->begin < 0 ? from : p->begin;
    p->wide = p->wide || (to - p->begin) >= ((int64_t)1 << ARC_BITS) / k + 1;
}

static outcome search_waves(analysis *a, const window_guess *guess, strong_part *part)
{
    window_choice *w = &a->choices->window;
    int64_t end = place(guess->high), width = (end - w->start) / 4 + 1;
    outcome o = OUTCOME_TRUE;
    while (o == OUTCOME_TRUE && window_choice_end(w) < end) {
        int64_t from = window_choice_end(w);
        window_wave *wave = w->count < MAX_WAVES ? window_choice_add(w) : NULL;
        bool strong = false;
        if (!wave)
            return w->count < MAX_WAVES ? OUTCOME_NO_MEMORY : OUTCOME_FAIL;
        wave->q = end - from < width ? end : from + width;
        o = prove_wave(a, from, wave, &strong);
        if (o == OUTCOME_TRUE) {
            note_strength(part, strong, from, wave->q, a->choices->k.first);
            width = width * 3 / 2;
        } else if (o != OUTCOME_NO_MEMORY && o != OUTCOME_STOPPED && width > place(1) / 16) {
            window_choice_drop(w);
            width /= 2;
            o = OUTCOME_TRUE;
        }
    }
    return o;
}

static outcome follow_waves(analysis *a, strong_part *part)
{
    window_choice *w = &a->choices->window;
    int64_t from = w->start;
    outcome o = OUTCOME_TRUE;
    for (size_t i = 0; o == OUTCOME_TRUE && i < w->count; i++) {
        bool strong = false;
        if (w->wave[i].q <= from || w->wave[i].q >= ARC_HALF)
            return findings_explain(a->findings, OUTCOME_FALSE, "the parts of the window are out of order");
        o = prove_wave(a, from, &w->wave[i], &strong);
        note_strength(part, strong, from, w->wave[i].q, a->choices->k.first);
        from = w->wave[i].q;
    }
    return o;
}

/* start k > 2^ARC_BITS: block 1 is not in the window. */
static bool begins_behind_one(const analysis *a)
{
    return a->choices->window.start > ((int64_t)1 << ARC_BITS) / a->choices->k.first;
}

outcome test_window(analysis *a)
{
    window_guess guess = {0, 0, 0};
    strong_part part = {-1, false};
    outcome o;
    if (!a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "several valences at once need a scheme that is evidently mirror-symmetric");
    o = a->replay ? OUTCOME_TRUE : choose_window(a, &guess);
    if (o == OUTCOME_TRUE && (integer_sign(&a->choices->window.bound) <= 0 || !begins_behind_one(a)))
        o = findings_explain(a->findings, OUTCOME_FALSE, "the window holds frequency 1");
    if (o != OUTCOME_TRUE)
        return o;
    set_scale(a);
    a->findings->eigenvalue_lower = number_lower_bound(&a->scale) > 0 ? 1 / number_upper_bound(&a->scale) : 0;
    o = a->replay ? follow_waves(a, &part) : search_waves(a, &guess, &part);
    if (o == OUTCOME_TRUE && !part.wide)
        o = findings_explain(a->findings, OUTCOME_FALSE, "not every valence could be shown to have a frequency that dominates");
    if (o == OUTCOME_TRUE)
        o = BASE_NAME(range_window_spectrum)(a->findings, a->choices, a->plan->problem->scheme, &a->scale.centre, a->replay, a->prec);
    return o;
}
