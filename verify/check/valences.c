/* The spectrum at several valences: section 4 of certificate-valences.md.
 *
 * Frequency m of valence k is at q = m/k, in units of 2^-48, and its block at
 * u = cos(pi q).  `rise` proves that the spectral radius falls with q from the first
 * frequencies on, `cover` that farther on it is smaller than L. */

#include "valences.h"

#include "answer.h"
#include "slopes.h"

enum { Q_BITS = 48 };

static const int64_t Q_MOST = INT64_C(1) << (Q_BITS - 1);  /* m/k = 1/2 */

/* m/k in units of 2^-48, at most 2^47, rounded down or up. */
static int64_t place(int64_t m, int64_t k, bool up)
{
    integer scaled = integer_shift_left(integer_from(m), Q_BITS);
    int64_t out;

    if (k == ENDLESS)
        return 0;
    scaled = up ? integer_divide_ceil(scaled, integer_from(k))
                : integer_divide_floor(scaled, integer_from(k));
    return integer_get_small(&out, scaled, Q_MOST) ? out : Q_MOST;
}

/* The block of the frequencies m over u(q, q'). */
static void block_between(struct block *out, const struct valence *v, struct span m,
                          int64_t q, int64_t q_last, int line)
{
    struct valence *here = allocate(1, sizeof *here);
    int64_t unit = INT64_C(1) << Q_BITS;

    *here = *v;
    here->reference.line = line;
    block_prepare_over(out, here, m,
                       affine_cosine(rational_from(q, unit), rational_from(q_last, unit),
                                     v->g));
}

void valences_prepare_block(struct block *out, const struct valence *v)
{
    rational zero = rational_from(0, 1);

    block_prepare_over(out, v, span_of(1),
                       affine_cosine(v->k.last == ENDLESS ? zero
                                                          : rational_from(1, v->k.last),
                                     rational_from(1, v->k.first), v->g));
}

/* The ranges of M_ij - x_i M_pj, i and j other than p. */
static interval *deflate(const struct affine *m, int size, int pivot,
                         const struct affine *x, int g)
{
    interval *out = allocate((size_t)size * (size_t)size, sizeof out[0]), *next = out;

    for (int i = 0; i < size; i++)
        for (int j = 0; j < size; j++)
            if (i != pivot && j != pivot)
                *next++ = affine_range(affine_sub(m[i * size + j],
                              affine_mul(x[i], m[pivot * size + j], g)));
    return out;
}

static void prove_deflated(const struct affine *matrix, const struct eigenpair *pair,
                           int pivot, const struct block_record *record, const char *name,
                           const struct certificate *c)
{
    interval *rest = deflate(matrix, c->size, pivot - 1, pair->unknowns, c->grid);

    spectrum_prove_small(rest, c->size - 1, c->grid, pair->s, record, name, c->file);
}

/* Rise
 * ---- */

/* From q to that of the group the largest eigenvalue falls. */
static void prove_rise(const struct valence *v, int64_t q, const struct rise *rise,
                       const struct certificate *c)
{
    struct affine *matrix;
    struct eigenpair pair;
    struct block block;

    block_between(&block, v, rise->record.m, q, rise->q, rise->record.line);
    matrix = block_matrix(&block);
    pair = slopes_prove_eigenpair(matrix, c->grid, &rise->pair, c);
    if (!affine_is_positive(pair.real) || !interval_is_positive(pair.real.d))
        rejected(c->file, rise->pair.line_of.eigenvalue,
                 "eigenvalue: it is not proved to be positive and to rise");
    pair.s = spectrum_inverse_upper(affine_range(pair.real).lo, c->grid);
    prove_deflated(matrix, &pair, rise->pair.pivot, &rise->record, "rise", c);
}

/* Returns Q_n, or 0 where there is no group. */
static int64_t prove_rises(const struct valence *v, const struct certificate *c)
{
    int64_t q = place(1, v->k.last, false);

    if (c->rises == 0)
        return 0;
    if (!valence_is_uniform(v))
        rejected(c->file, c->rise[0].record.line,
                 "rise: a weight of a rule depends on k or m");
    if (c->rise[c->rises - 1].q < place(1, v->k.first, true))
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

/* Where a line `cover` begins, which may be the first one of a group (not: open); rise is
 * Q_n. */
static int64_t begin_cover(const struct cover *cover, const struct cover *before, bool open,
                           int64_t rise, const struct valence *v, const char *file)
{
    struct span m = cover->record.m;
    int64_t last = before == NULL ? 1 : before->record.m.last, q;

    if (open && (m.first != before->record.m.first || m.last != last))
        rejected(file, cover->record.line, "cover: the lines of the frequencies %lld.. end "
                 "too early", (long long)before->record.m.first);
    if (!open && (m.first != last + 1 || m.last < m.first || (rise > 0 && before != NULL)))
        rejected(file, cover->record.line, "cover: expected the frequencies from %lld on%s",
                 (long long)last + 1, rise > 0 ? ", in one group" : "");
    q = open ? before->q : place(m.first, v->k.last, false);
    if (q < rise)
        q = rise;
    if (cover->q < q || (open && cover->q == q))
        rejected(file, cover->record.line, "cover: it does not go on");
    return q;
}

static void prove_covers(const struct valence *v, int64_t rise, const struct eigenpair *pair,
                         const struct certificate *c)
{
    int64_t half = v->k.last == ENDLESS ? ENDLESS : v->k.last / 2;
    const struct cover *before = NULL;
    bool open = false;                             /* its group goes on */

    for (int i = 0; i < c->covers; i++) {
        struct mark mark = scratch_mark();
        const struct cover *cover = &c->cover[i];
        struct span m = cover->record.m;
        struct block block;
        int64_t q;

        if (!open && before != NULL && before->record.m.last >= half)
            rejected(c->file, cover->record.line, "cover: all is covered above");
        q = begin_cover(cover, before, open, rise, v, c->file);
        block_between(&block, v, m, q, cover->q, cover->record.line);
        spectrum_prove_small(affine_ranges(block_matrix(&block),
                                           (size_t)c->size * (size_t)c->size),
                             c->size, c->grid, pair->s, &cover->record, "cover", c->file);
        open = cover->q < (m.last == ENDLESS ? Q_MOST : place(m.last, v->k.first, true));
        before = cover;
        scratch_release(mark);
    }
    if (open || before->record.m.last < half)
        rejected(c->file, before->record.line, "cover: it ends too early");
}

/* All of it
 * --------- */

struct eigenpair valences_prove_spectrum(const struct block *block,
                                         const struct certificate *c)
{
    const struct affine *matrix = block_matrix(block);
    struct eigenpair pair = slopes_prove_eigenpair(matrix, c->grid, &c->pair, c);
    interval l = affine_range(pair.real);
    struct block constant;
    int64_t rise;

    if (!interval_is_positive(l) || integer_compare(l.hi, grid_from(1, c->grid).lo) >= 0)
        rejected(c->file, c->pair.line_of.eigenvalue,
                 "eigenvalue: its range is not inside (0,1)");
    pair.s = spectrum_inverse_upper(l.lo, c->grid);
    block_prepare(&constant, block->v, true, span_of(0));
    spectrum_prove_rest(affine_constants(block_matrix(&constant),
                                         (size_t)constant.size * (size_t)constant.size),
                        constant.size, c->grid, &pair, &c->block[0], c);
    prove_deflated(matrix, &pair, c->pair.pivot, &c->block[1], "block", c);
    rise = prove_rises(block->v, c);
    prove_covers(block->v, rise, &pair, c);
    return pair;
}
