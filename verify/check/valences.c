/* The spectrum at several valences: sections 4 and 6 of certificate-valences.md.
 *
 * `rise` proves that the spectral radius falls with q from the first frequencies on,
 * `cover` that farther on it is smaller than L. */

#include "valences.h"

#include "answer.h"

enum { Q_BITS = 48 };

static const int64_t Q_MOST = INT64_C(1) << (Q_BITS - 1);  /* m/k = 1/2 */

int64_t valences_place(int64_t m, int64_t k, bool up)
{
    integer scaled = integer_shift_left(integer_from(m), Q_BITS);
    int64_t out;

    if (k == ENDLESS)
        return 0;
    scaled = up ? integer_divide_ceil(scaled, integer_from(k))
                : integer_divide_floor(scaled, integer_from(k));
    return integer_get_small(&out, scaled, Q_MOST) ? out : Q_MOST;
}

void valences_block_between(struct block *out, const struct valence *v, struct span m,
                            int64_t q, int64_t q_last, int line)
{
    struct valence *here = allocate(1, sizeof *here);
    int64_t unit = INT64_C(1) << Q_BITS;

    *here = *v;
    here->reference.line = line;
    block_prepare_over(out, here, m,
                       affine_cosine(rational_from(q, unit), rational_from(q_last, unit), v->g));
}

void valences_prepare_block(struct block *out, const struct valence *v, int64_t m)
{
    struct span k = v->k;

    if (m == 0)
        block_prepare(out, v, true, span_of(0));
    else
        block_prepare_over(out, v, span_of(m),
            affine_cosine(k.last == ENDLESS ? rational_from(0, 1) : rational_from(m, k.last),
                          rational_from(m, k.first), v->g));
}

/* Rise
 * ---- */

/* From q to that of the group the largest eigenvalue falls. */
static void prove_rise(const struct valence *v, int64_t q, const struct rise *rise,
                       const struct certificate *c)
{
    struct eigenpair pair;
    struct block block;

    valences_block_between(&block, v, rise->record.m, q, rise->q, rise->record.line);
    pair = eigenpair_prove(block_matrix(&block), &rise->pair, c);
    if (!affine_is_positive(pair.real) || !interval_is_positive(pair.real.d))
        rejected(c->file, rise->pair.line_of.eigenvalue,
                 "eigenvalue: it is not proved to be positive and to rise");
    pair.s = spectrum_inverse_upper(affine_range(pair.real).lo, c->grid);
    spectrum_prove_rest(&pair, &rise->record, "rise", c);
}

/* Returns Q_n, or 0 where there is no group. */
static int64_t prove_rises(const struct valence *v, const struct certificate *c)
{
    int64_t q = valences_place(1, v->k.last, false);

    if (c->rises == 0)
        return 0;
    if (!valence_is_uniform(v))
        rejected(c->file, c->rise[0].record.line, "rise: a weight of a rule depends on k or m");
    if (c->rise[c->rises - 1].q < valences_place(1, v->k.first, true))
        rejected(c->file, c->rise[c->rises - 1].record.line,
                 "rise: it ends before frequency 1 of the first valence");
    for (int i = 0; i < c->rises; i++) {
        struct mark mark = scratch_mark();

        if (c->rise[i].q <= q)
            rejected(c->file, c->rise[i].record.line, "rise: it does not go on");
        prove_rise(v, q, &c->rise[i], c);
        q = c->rise[i].q;
        scratch_release(mark);
    }
    return q;
}

/* Cover
 * ----- */

/* The frequency behind m that is not the eigenpair's. */
static int64_t next_frequency(int64_t m, const struct certificate *c)
{
    return m + 1 == c->frequency ? m + 2 : m + 1;
}

/* Are there no more frequencies behind the last one of `cover`? */
static bool is_last(int64_t last, const struct valence *v, const struct certificate *c)
{
    return last == ENDLESS || (v->k.last != ENDLESS && next_frequency(last, c) > v->k.last / 2);
}

/* The first line of a group; q_least: Q_n.  Returns Q'. */
static int64_t begin_group(const struct cover *cover, int64_t before, int64_t q_least,
                           const struct valence *v, const struct certificate *c)
{
    struct span m = cover->record.m;
    int64_t q;

    if (before > 0 && (is_last(before, v, c) || c->rises > 0))
        rejected(c->file, cover->record.line, "cover: expected no further frequencies");
    if (m.first != next_frequency(before, c) || m.last < m.first ||
        (m.first < c->frequency && c->frequency <= m.last))
        rejected(c->file, cover->record.line, "cover: expected frequencies from %lld on, "
                 "and not %lld", (long long)next_frequency(before, c),
                 (long long)c->frequency);
    q = valences_place(m.first, v->k.last, false);
    if (q < q_least)
        q = q_least;
    if (cover->q < q)
        rejected(c->file, cover->record.line, "cover: it does not go on");
    return q;
}

/* A further line of a group. */
static int64_t go_on(const struct cover *cover, const struct cover *before,
                     const struct certificate *c)
{
    struct span m = cover->record.m, same = before->record.m;

    if (m.first != same.first || m.last != same.last)
        rejected(c->file, cover->record.line, "cover: the lines of the frequencies %s end "
                 "too early", span_text(same));
    if (cover->q <= before->q)
        rejected(c->file, cover->record.line, "cover: it does not go on");
    return before->q;
}

void valences_prove_cover(const struct valence *v, const struct cover *cover, int64_t q,
                          interval s, const struct certificate *c)
{
    struct mark mark = scratch_mark();
    struct block block;

    valences_block_between(&block, v, cover->record.m, q, cover->q, cover->record.line);
    spectrum_prove_block(&block, s, &cover->record, "cover", c);
    scratch_release(mark);
}

static void prove_covers(const struct valence *v, int64_t rise, const struct eigenpair *pair,
                         const struct certificate *c)
{
    const struct cover *before = NULL;
    bool open = false;                             /* its group goes on */

    for (int i = 0; i < c->covers; i++) {
        const struct cover *cover = &c->cover[i];
        int64_t last = cover->record.m.last;
        int64_t q = open ? go_on(cover, before, c)
                  : begin_group(cover, before == NULL ? 0 : before->record.m.last, rise, v, c);

        valences_prove_cover(v, cover, q, pair->s, c);
        open = cover->q < (last == ENDLESS ? Q_MOST : valences_place(last, v->k.first, true));
        before = cover;
    }
    if (open || !is_last(before->record.m.last, v, c))
        rejected(c->file, before->record.line, "cover: it ends too early");
}

/* All of it
 * --------- */

void valences_prove_block_0(const struct valence *v, interval s, const struct certificate *c)
{
    struct block block;

    block_prepare(&block, v, true, span_of(0));
    spectrum_prove_block(&block, s, &c->block[0], "block", c);
}

void valences_prove_rest(const struct valence *v, const struct eigenpair *pair,
                         const struct certificate *c)
{
    if (c->has_limit)
        limit_prove(v, pair, c);
    else if (c->frequency != 0)
        valences_prove_block_0(v, pair->s, c);
    spectrum_prove_rest(pair, &c->block[c->frequency == 0 ? 0 : 1], "block", c);
    prove_covers(v, prove_rises(v, c), pair, c);
}
