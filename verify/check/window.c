/* Refutations by a window of frequencies: section 6 of certificate-valences.md. */

#include "valences.h"

#include "answer.h"
#include "characteristic.h"

/* From q on: the eigenpair of each block, the rest of it below R, no zero on the curve. */
static interval prove_wave(const struct valence *v, int64_t q, const struct rise *wave,
                           interval s, const struct mask masks[3], const struct certificate *c)
{
    struct characteristic characteristic;
    struct certificate own = *c;
    struct eigenpair pair;
    struct block block;

    own.boundary = wave->boundary;
    valences_block_between(&block, v, wave->record.m, q, wave->q, wave->record.line);
    pair = eigenpair_prove(block_matrix(&block), &wave->pair, c);
    spectrum_prove_size(&pair, c);
    pair.s = s;
    spectrum_prove_rest(&pair, &wave->record, "wave", c);
    characteristic_prepare(&characteristic, &block, &pair, masks, &own);
    decide_claim(&characteristic, &own);
    return interval_abs(affine_range(pair.real));
}

/* The waves from Q_0 on; consecutive ones with moduli of at least R must be wide enough to
 * contain a frequency of each valence.  Returns the hull of all moduli. */
static interval prove_waves(const struct valence *v, interval s, const struct mask masks[3],
                            const struct certificate *c)
{
    int64_t q = c->window, strong = q;             /* all is strong from there on */
    interval moduli = interval_thin(c->bound);
    bool wide = false;

    for (int i = 0; i < c->rises; i++) {
        const struct rise *wave = &c->rise[i];
        struct mark mark = scratch_mark();
        interval modulus;

        if (wave->q <= q || wave->q >= valences_place(1, 2, false))
            rejected(c->file, wave->record.line, "wave: it does not go on, or up to 1/2");
        modulus = prove_wave(v, q, wave, s, masks, c);
        if (integer_compare(modulus.lo, c->bound) < 0)
            strong = wave->q;
        wide = wide || wave->q - strong >= valences_place(1, v->k.first, true);
        moduli = interval_hull(moduli, modulus);
        interval_keep(mark, &moduli, 1);
        q = wave->q;
    }
    if (!wide)
        rejected(c->file, c->line_of.window, "window: it is not proved that the largest "
                 "eigenvalue of each valence is in it");
    moduli.lo = c->bound;
    return moduli;
}

/* All outside of the window is below R: one group, with a gap from Q_0 to Q_n. */
static void prove_outside(const struct valence *v, interval s, const struct certificate *c)
{
    int64_t q = valences_place(1, v->k.last, false), end = c->window;

    for (int i = 0; i < c->covers; i++) {
        const struct cover *cover = &c->cover[i];
        struct span m = cover->record.m;

        if (m.first != 1 || m.last != ENDLESS || cover->q <= q || cover->q > end)
            rejected(c->file, cover->record.line, "cover: expected `cover 1 inf`, without "
                     "the window");
        valences_prove_cover(v, cover, q, s, c);
        q = cover->q;
        if (q == end) {
            q = end == c->window ? c->rise[c->rises - 1].q : q;
            end = valences_place(1, 2, false);
        }
    }
    if (q < end || end == c->window)
        rejected(c->file, c->line_of.window, "window: not all outside of it is covered");
}

interval window_prove(const struct valence *v, const struct mask q[3], const struct certificate *c)
{
    interval s = spectrum_inverse_upper(c->bound, c->grid), moduli;

    if (c->rises == 0 || c->window <= valences_place(1, v->k.first, false))
        rejected(c->file, c->line_of.window, "window: it begins too early, or is empty");
    moduli = prove_waves(v, s, q, c);
    valences_prove_block_0(v, s, c);
    prove_outside(v, s, c);
    return moduli;
}
