/* The spectrum: section 6 of certificate.md. */

#include "spectrum.h"

#include "answer.h"

enum { MAX_MAGNITUDE_BITS = 64 };

/* The eigenvalue
 * -------------- */

/* In units of 2^-g: 2^g / (a 2^-g). */
interval spectrum_inverse_upper(integer a, int g)
{
    return interval_thin(integer_divide_ceil(
        integer_shift_left(integer_from(1), 2L * g), a));
}

/* |L|^2 */
static interval squared_modulus(const struct eigenpair *pair, int g)
{
    return affine_range(pair_norm((struct pair) { pair->real, pair->imaginary }, g));
}

/* s for 0 < ell < |L|. */
static interval inverse_modulus(const struct eigenpair *pair, const struct certificate *c)
{
    interval ell = interval_thin(pair->choices->modulus), q = squared_modulus(pair, c->grid);

    if (!interval_is_positive(ell) ||
        !interval_is_positive(interval_sub(q, grid_mul(ell, ell, c->grid))))
        rejected(c->file, pair->choices->line_of.modulus,
                 "modulus: it is not positive, or not proved to be smaller than |L|");
    return spectrum_inverse_upper(ell.lo, c->grid);
}

/* L < 0 for refutations only, but those by a fold.  Complex form: |L|^2 in place of L. */
void spectrum_prove_size(struct eigenpair *pair, const struct certificate *c)
{
    interval l = c->real ? affine_range(pair->real) : squared_modulus(pair, c->grid);
    integer one = grid_from(1, c->grid).lo;
    int line = pair->choices->line_of.eigenvalue;

    if (!c->real)
        pair->s = inverse_modulus(pair, c);
    if (c->reason != REASON_NONE && c->reason != REASON_FOLD && l.hi.sign < 0)
        l = interval_minus(l);
    if (c->reason == REASON_NOT_C0 && integer_compare(l.lo, one) <= 0)
        rejected(c->file, line, "eigenvalue: |L| is not proved to be larger than 1");
    if (c->reason == REASON_NOT_C0)
        return;
    if (l.lo.sign <= 0 || integer_compare(l.hi, one) >= 0)
        rejected(c->file, line, "eigenvalue: its interval is not inside (0,1)");
    if (c->real)
        pair->s = spectrum_inverse_upper(l.lo, c->grid);
}

/* The plain form
 * -------------- */

struct affine *spectrum_without_constants(const struct affine *b, int n)
{
    struct affine *out = allocate((size_t)(n - 1) * (size_t)(n - 1), sizeof out[0]);

    for (int i = 1; i < n; i++)
        for (int j = 1; j < n; j++)
            out[(i - 1) * (n - 1) + j - 1] = affine_sub(b[i * n + j], b[j]);
    return out;
}

/* sum of B_pj y_j */
static struct affine constant_row(const struct affine *b, const struct affine *y, int n, int g)
{
    struct affine sum = affine_from_whole(0, g);

    for (int j = 1; j < n; j++)
        sum = affine_add(sum, affine_mul(b[j], y[j - 1], g));
    return sum;
}

/* x_p = (sum of B_pj y_j)/(L - 1), x_i = y_i + x_p. */
void spectrum_add_constants(struct eigenpair *pair, const struct affine *b, int n, bool complex,
                            const struct certificate *c)
{
    int parts = complex ? 2 : 1, g = c->grid;
    struct affine *out = allocate((size_t)(parts * n), sizeof out[0]), x[2];
    const struct affine *y = pair->unknowns;
    struct pair l = { affine_sub(pair->real, affine_from_whole(1, g)), pair->imaginary };
    struct pair p;

    for (int part = 0; part < parts; part++)
        x[part] = constant_row(b, &y[part * (n - 1)], n, g);
    if (complex && !affine_is_positive(pair_norm(l, g)))
        rejected(c->file, pair->choices->line_of.eigenvalue, "eigenvalue: it is too near to 1");
    p = complex ? pair_divide((struct pair) { x[0], x[1] }, l, g)
                : (struct pair) { affine_div(x[0], l.x, g), l.y };
    for (int part = 0; part < parts; part++) {
        out[part * n] = part == 0 ? p.x : p.y;
        for (int i = 1; i < n; i++)
            out[part * n + i] = affine_add(y[part * (n - 1) + i - 1], out[part * n]);
    }
    pair->unknowns = out;
}

struct affine *spectrum_doubled(const struct affine *a, int n)
{
    struct affine *out = allocate((size_t)(4 * n) * (size_t)n, sizeof out[0]);

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            out[i * 2 * n + j] = out[(i + n) * 2 * n + j + n] = a[i * n + j];
    return out;
}

/* The rest
 * -------- */

static bool has_large_entry(const interval *c, int size, int g)
{
    for (int i = 0; i < size * size; i++)
        if (integer_bits(interval_magnitude(c[i])) > g + MAX_MAGNITUDE_BITS)
            return true;
    return false;
}

/* c := c c, with the memory back to the mark but for the result. */
static void square(interval *c, interval *result, int size, int g, struct mark mark)
{
    for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
            struct mark entry = scratch_mark();
            interval sum = grid_from(0, g);

            for (int l = 0; l < size; l++)
                sum = spectrum_add_product(sum, c[i * size + l], c[l * size + j], g);
            interval_keep(entry, &sum, 1);
            result[i * size + j] = sum;
        }
    }
    interval_keep(mark, result, (size_t)size * (size_t)size);
    for (int i = 0; i < size * size; i++)
        c[i] = result[i];
}

/* Is the sum of magnitudes of each row < 1? */
static bool has_small_rows(const interval *c, int size, int g)
{
    for (int i = 0; i < size; i++) {
        integer sum = integer_from(0);

        for (int j = 0; j < size; j++)
            sum = integer_add(sum, interval_magnitude(c[i * size + j]));
        if (integer_compare(sum, grid_from(1, g).lo) >= 0)
            return false;
    }
    return true;
}

void spectrum_prove_small(interval *c, int size, int g, interval s,
                          const struct block_record *record, const char *name,
                          const char *file)
{
    interval *work = allocate((size_t)size * (size_t)size, sizeof work[0]);
    struct mark mark;

    for (int i = 0; i < size * size; i++)
        c[i] = grid_mul(c[i], s, g);
    mark = scratch_mark();
    for (int step = 0; ; step++) {
        if (has_large_entry(c, size, g))
            rejected(file, record->line, "%s: an entry of block %lld reaches 2^64", name,
                     (long long)record->m.first);
        if (step == record->power)
            break;
        square(c, work, size, g, mark);
    }
    if (!has_small_rows(c, size, g))
        rejected(file, record->line,
                 "%s: the other eigenvalues of block %lld are not proved to be "
                 "smaller than L", name, (long long)record->m.first);
}

/* What is known of a matrix: vectors that span what it maps to itself, each with an unknown where
 * it is 1 and the other one 0. */
struct subspace {
    int count;
    const struct affine *vector[2];
    int pivot[2];
};

/* What the first rows and columns of a matrix, `size` of its `full` ones, do modulo the subspace
 * passes: M'_ij = M_ij - v_i M_pj - w_i M_qj, i and j other than p and q. */
static void prove_modulo(const struct affine *m, int full, int size, const struct subspace *space,
                         interval s, const struct block_record *record, const char *name,
                         const struct certificate *c)
{
    interval *out = allocate((size_t)size * (size_t)size, sizeof out[0]), *next = out;
    int p = space->count > 0 ? space->pivot[0] : -1, q = space->count > 1 ? space->pivot[1] : -1;

    for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
            struct affine entry = m[i * full + j];

            if (i == p || i == q || j == p || j == q)
                continue;
            for (int n = 0; n < space->count; n++)
                entry = affine_sub(entry, affine_mul(space->vector[n][i],
                                                     m[space->pivot[n] * full + j], c->grid));
            *next++ = affine_range(entry);
        }
    }
    spectrum_prove_small(out, size - space->count, c->grid, s, record, name, c->file);
}

void spectrum_prove_block(const struct block *block, interval s, const struct block_record *record,
                          const char *name, const struct certificate *c)
{
    struct affine *ones = allocate((size_t)block->n, sizeof ones[0]);
    struct subspace space = { block->plain ? 1 : 0, { ones, NULL }, { 0, 0 } };

    for (int i = 0; i < block->n; i++)
        ones[i] = affine_from_whole(1, c->grid);
    prove_modulo(block_matrix(block), block->size, block->size, &space, s, record, name, c);
}

static integer mid_size(struct affine x)
{
    return integer_absolute(interval_mid(x.c));
}

/* The plane of x and y, x + i y belonging to a pair l, conj l of a real block of order n: a basis
 * f, g of it with f_p = g_q = 1, f_q = g_p = 0. */
static struct subspace real_plane(const struct eigenpair *pair, const struct certificate *c)
{
    int n = c->n, q = 0, g = c->grid;
    const struct affine *x = pair->unknowns, *y = &x[n];
    struct affine *f_of = allocate((size_t)n, sizeof f_of[0]);
    struct affine *g_of = allocate((size_t)n, sizeof g_of[0]);

    if (interval_contains_zero(affine_range(pair->imaginary)))
        rejected(c->file, pair->choices->line_of.eigenvalue, "eigenvalue: it may be real");
    for (int i = 1; i < n; i++)
        if (integer_compare(mid_size(y[i]), mid_size(y[q])) > 0)
            q = i;
    if (interval_contains_zero(affine_range(y[q])))
        rejected(c->file, pair->choices->line_of.pivot, "pivot: no second one can be found");
    for (int i = 0; i < n; i++) {
        g_of[i] = affine_div(y[i], y[q], g);
        f_of[i] = affine_sub(x[i], affine_mul(x[q], g_of[i], g));
    }
    return (struct subspace) { 2, { f_of, g_of }, { pair->choices->pivot - 1, q } };
}

/* That of X and J X. */
static struct subspace complex_line(const struct eigenpair *pair, const struct certificate *c)
{
    int n = c->n, p = pair->choices->pivot - 1;
    struct affine *turned = allocate(2 * (size_t)n, sizeof turned[0]);

    for (int i = 0; i < n; i++) {
        turned[i] = affine_minus(pair->unknowns[i + n]);
        turned[i + n] = pair->unknowns[i];
    }
    return (struct subspace) { 2, { pair->unknowns, turned }, { p, p + n } };
}

void spectrum_prove_rest(const struct eigenpair *pair, const struct block_record *record,
                         const char *name, const struct certificate *c)
{
    bool of_reals = !c->real && (c->frequency == 0 || 2 * c->frequency == c->valence.first);
    struct subspace space = { 1, { pair->unknowns, NULL }, { pair->choices->pivot - 1, 0 } };

    if (of_reals)
        space = real_plane(pair, c);
    else if (!c->real)
        space = complex_line(pair, c);
    prove_modulo(pair->matrix, c->size, of_reals ? c->n : c->size, &space, pair->s, record, name,
                 c);
}
