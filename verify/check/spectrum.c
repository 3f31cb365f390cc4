/* The spectrum: section 6 of certificate.md. */

#include "spectrum.h"

#include "answer.h"

enum { INVERSE_BITS = 32, MAX_MAGNITUDE_BITS = 64 };

interval spectrum_add_product(interval sum, interval x, interval y, int g)
{
    integer_count_work(0, 0);
    if (interval_is_zero(x) || interval_is_zero(y))
        return sum;
    return interval_add(sum, grid_mul(x, y, g));
}

/* The eigenpair
 * ------------- */

static interval box_round(integer centre, integer radius)
{
    return interval_of(integer_sub(centre, radius), integer_add(centre, radius));
}

static bool is_fixed(const struct krawczyk *s, int i)
{
    return i == s->pivot || (!s->real && i == s->pivot + s->n);
}

/* (J x)_i: J (Re, Im) = (-Im, Re) */
static interval turned(const struct krawczyk *s, const interval *x, int i)
{
    return i < s->n ? interval_minus(x[i + s->n]) : x[i - s->n];
}

static void read_choices(struct krawczyk *s, const struct choices *c, integer radius)
{
    size_t size = (size_t)s->size;

    s->mid = allocate(size, sizeof s->mid[0]);
    s->box = allocate(size, sizeof s->box[0]);
    s->f = allocate(size, sizeof s->f[0]);
    s->slope = allocate(size * size, sizeof s->slope[0]);
    s->inverse = allocate(size * size, sizeof s->inverse[0]);

    for (int i = 0; i < 2; i++) {
        s->l_mid[i] = interval_thin(c->eigenvalue[i]);
        s->l_box[i] = box_round(c->eigenvalue[i], radius);
    }
    for (int i = 0, other = 0; i < s->size; i++) {
        if (is_fixed(s, i)) {
            s->mid[i] = s->box[i] = grid_from(i == s->pivot ? 1 : 0, s->g);
        } else {
            s->mid[i] = interval_thin(c->eigenvector[other]);
            s->box[i] = box_round(c->eigenvector[other++], radius);
        }
    }
    for (size_t i = 0; i < size * size; i++)       /* exact, since g >= 64 */
        s->inverse[i] = interval_thin(integer_shift_left(c->inverse[i],
                                                         s->g - INVERSE_BITS));
}

/* f = M x~ - L~ x~ */
static void compute_residual(struct krawczyk *s)
{
    for (int i = 0; i < s->size; i++) {
        struct mark mark = scratch_mark();
        interval sum = grid_from(0, s->g);

        for (int j = 0; j < s->size; j++)
            sum = spectrum_add_product(sum, s->m[i * s->size + j], s->mid[j], s->g);
        sum = interval_sub(sum, grid_mul(s->l_mid[0], s->mid[i], s->g));
        if (!s->real)
            sum = interval_sub(sum, grid_mul(s->l_mid[1], turned(s, s->mid, i), s->g));
        interval_keep(mark, &sum, 1);
        s->f[i] = sum;
    }
}

/* G: columns for the unknowns x_j, then for L. */
static void compute_slope(struct krawczyk *s)
{
    for (int i = 0; i < s->size; i++) {
        interval *out = &s->slope[i * s->size];

        for (int j = 0; j < s->size; j++) {
            interval entry = s->m[i * s->size + j];

            if (is_fixed(s, j))
                continue;
            if (i == j)
                entry = interval_sub(entry, s->l_box[0]);
            if (!s->real && i == j + s->n)         /* J e_j = e_i */
                entry = interval_sub(entry, s->l_box[1]);
            if (!s->real && i == j - s->n)         /* J e_j = -e_i */
                entry = interval_add(entry, s->l_box[1]);
            *out++ = entry;
        }
        *out++ = interval_minus(s->box[i]);
        if (!s->real)
            *out = interval_minus(turned(s, s->box, i));
    }
}

/* K_i = - sum_l Y_il f_l + sum_l (delta_il - sum_q Y_iq G_ql) [-rho, rho] */
static interval compute_image(const struct krawczyk *s, int i, interval box)
{
    int size = s->size;
    const interval *y = &s->inverse[i * size];
    interval out = grid_from(0, s->g);

    for (int l = 0; l < size; l++)
        out = spectrum_add_product(out, y[l], s->f[l], s->g);
    out = interval_minus(out);
    for (int l = 0; l < size; l++) {
        struct mark mark = scratch_mark();
        interval sum = grid_from(0, s->g);

        for (int q = 0; q < size; q++)
            sum = spectrum_add_product(sum, y[q], s->slope[q * size + l], s->g);
        sum = interval_sub(grid_from(i == l ? 1 : 0, s->g), sum);
        out = interval_add(out, grid_mul(sum, box, s->g));
        interval_keep(mark, &out, 1);
    }
    return out;
}

static void prove_inclusion(const struct krawczyk *s, integer radius, const char *file,
                            int line, const char *name)
{
    interval box = interval_of(integer_negate(radius), radius);

    for (int i = 0; i < s->size; i++) {
        struct mark mark = scratch_mark();
        interval image = compute_image(s, i, box);

        if (integer_compare(image.lo, box.lo) <= 0 ||
            integer_compare(image.hi, box.hi) >= 0)
            rejected(file, line,
                     "%s: the Krawczyk operator does not map the box into "
                     "its interior (component %d)", name, i + 1);
        scratch_release(mark);
    }
}

/* In units of 2^-g: 2^g / (a 2^-g). */
interval spectrum_inverse_upper(integer a, int g)
{
    return interval_thin(integer_divide_ceil(
        integer_shift_left(integer_from(1), 2L * g), a));
}

static noreturn void reject_small(const struct certificate *c)
{
    rejected(c->file, c->pair.line_of.eigenvalue,
             "eigenvalue: |L| is not proved to be larger than 1");
}

/* L < 0 for refutations only, but those by a fold. */
interval spectrum_prove_size(interval l, int g, const struct certificate *c)
{
    integer one = grid_from(1, g).lo;

    if (c->reason == REASON_NOT_C0) {
        if (integer_compare(l.lo, one) <= 0 && integer_compare(interval_minus(l).lo, one) <= 0)
            reject_small(c);
        return grid_from(0, g);
    }
    if (c->reason != REASON_NONE && c->reason != REASON_FOLD && l.hi.sign < 0)
        l = interval_minus(l);
    if (l.lo.sign <= 0 || integer_compare(l.hi, one) >= 0)
        rejected(c->file, c->pair.line_of.eigenvalue,
                 "eigenvalue: its interval is not inside (0,1)");
    return spectrum_inverse_upper(l.lo, g);
}

/* |L|^2 */
static interval squared_modulus(const struct krawczyk *s)
{
    return interval_add(grid_mul(s->l_box[0], s->l_box[0], s->g),
                        grid_mul(s->l_box[1], s->l_box[1], s->g));
}

/* 0 < ell < |L|, q = |L|^2 */
static void check_modulus(const struct krawczyk *s, const struct certificate *c, interval q)
{
    interval ell = interval_thin(c->pair.modulus);

    if (!interval_is_positive(ell) ||
        !interval_is_positive(interval_sub(q, grid_mul(ell, ell, s->g))))
        rejected(c->file, c->pair.line_of.modulus,
                 "modulus: it is not positive, or not proved to be smaller than |L|");
}

static interval prove_complex_size(const struct krawczyk *s, const struct certificate *c)
{
    interval q = squared_modulus(s);
    integer one = grid_from(1, s->g).lo;

    check_modulus(s, c, q);
    if (c->reason == REASON_NOT_C0) {
        if (integer_compare(q.lo, one) <= 0)
            reject_small(c);
        return grid_from(0, s->g);
    }
    if (integer_compare(q.hi, one) >= 0)
        rejected(c->file, c->pair.line_of.eigenvalue, "eigenvalue: |L| is not proved to be "
                 "smaller than 1");
    return spectrum_inverse_upper(c->pair.modulus, s->g);
}

struct krawczyk spectrum_prove_inclusion(const interval *matrix, int g,
                                         const struct choices *choices, bool range,
                                         const struct certificate *c)
{
    integer radius = range ? choices->range : choices->radius;
    struct krawczyk s = { .g = g, .n = c->n, .size = c->size, .pivot = choices->pivot - 1,
                          .real = c->real, .m = matrix };

    if (radius.sign <= 0)
        rejected(c->file, choices->line_of.radius, "radius: it is not positive");
    if (choices->pivot < 1 || choices->pivot > s.n)
        rejected(c->file, choices->line_of.pivot,
                 "pivot: it is not the index of one of the %d unknowns", s.n);
    read_choices(&s, choices, radius);
    compute_residual(&s);
    compute_slope(&s);
    prove_inclusion(&s, radius, c->file,
                    range ? choices->line_of.range : choices->line_of.radius,
                    range ? "range" : "radius");
    return s;
}

struct eigenpair spectrum_prove_eigenpair(const interval *matrix, int g,
                                          const struct certificate *c)
{
    struct krawczyk s = spectrum_prove_inclusion(matrix, g, &c->pair, false, c);
    struct eigenpair out;

    out.s = s.real ? spectrum_prove_size(s.l_box[0], g, c) : prove_complex_size(&s, c);
    out.unknowns = allocate((size_t)s.size, sizeof out.unknowns[0]);
    for (int i = 0; i < s.size; i++)
        out.unknowns[i] = affine_from(s.box[i]);
    out.real = affine_from(s.l_box[0]);
    out.imaginary = s.real ? affine_from_whole(0, g) : affine_from(s.l_box[1]);
    return out;
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
        rejected(c->file, c->pair.line_of.eigenvalue, "eigenvalue: it is too near to 1");
    p = complex ? pair_divide((struct pair) { x[0], x[1] }, l, g)
                : (struct pair) { affine_div(x[0], l.x, g), l.y };
    for (int part = 0; part < parts; part++) {
        out[part * n] = part == 0 ? p.x : p.y;
        for (int i = 1; i < n; i++)
            out[part * n + i] = affine_add(y[part * (n - 1) + i - 1], out[part * n]);
    }
    pair->unknowns = out;
}

interval *spectrum_doubled(const interval *a, int n)
{
    interval *out = allocate((size_t)(4 * n) * (size_t)n, sizeof out[0]);

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            out[i * 2 * n + j] = out[(i + n) * 2 * n + j + n] = a[i * n + j];
    return out;
}

/* The rest
 * -------- */

static integer mid_size(interval x)
{
    return integer_absolute(interval_mid(x));
}

/* The unknown, not p, at which the plane's g is 1. */
static int second_pivot(const interval *y, int n, const struct certificate *c)
{
    int q = 0;

    for (int i = 1; i < n; i++)
        if (integer_compare(mid_size(y[i]), mid_size(y[q])) > 0)
            q = i;
    if (interval_contains_zero(y[q]))
        rejected(c->file, c->pair.line_of.pivot, "pivot: no second one can be found");
    return q;
}

/* M' of a pair l, conj l of a real block a: what a does modulo the plane of the real and imaginary
 * parts x + i y of the eigenvector.  a is in the first rows and columns of M. */
static interval *deflate_plane(int *size, const interval *m, int g, const struct eigenpair *pair,
                               const struct certificate *c)
{
    int n = c->n, p = c->pair.pivot - 1, q;
    interval *out = allocate((size_t)n * (size_t)n, sizeof out[0]), *next = out;
    const interval *x = affine_constants(pair->unknowns, 2 * (size_t)n), *y = &x[n];

    if (interval_contains_zero(pair->imaginary.c))
        rejected(c->file, c->pair.line_of.eigenvalue, "eigenvalue: it may be real");
    q = second_pivot(y, n, c);
    for (int i = 0; i < n; i++) {
        interval of_g = grid_div(y[i], y[q], g);
        interval of_f = interval_sub(x[i], grid_mul(x[q], of_g, g));

        for (int j = 0; j < n; j++)
            if (i != p && i != q && j != p && j != q)
                *next++ = interval_sub(interval_sub(m[i * 2 * n + j],
                                                    grid_mul(of_f, m[p * 2 * n + j], g)),
                                       grid_mul(of_g, m[q * 2 * n + j], g));
    }
    *size = n - 2;
    return out;
}

/* M': what is left of the block beside its known eigenvalue, if it has one: 1, or L.
 * size: in that of M, out that of M'. */
static interval *deflate(int *size, const interval *m, int g, const struct eigenpair *pair,
                         const struct block_record *record, const struct certificate *c)
{
    bool has_l = record->m.first == c->frequency, has_one = record->m.first == 0 && !has_l;
    bool complex = has_l && !c->real;
    int full = *size, pivot = has_l ? c->pair.pivot - 1 : 0;
    interval *out = allocate((size_t)full * (size_t)full, sizeof out[0]), *next = out;

    if (complex && (c->frequency == 0 || 2 * c->frequency == c->valence.first))
        return deflate_plane(size, m, g, pair, c);
    if (has_l || has_one)
        *size = full - (complex ? 2 : 1);
    for (int i = 0; i < full; i++) {
        for (int j = 0; j < full; j++) {
            interval entry = m[i * full + j];

            if ((has_l || has_one) && (i == pivot || j == pivot))
                continue;
            if (complex && (i == pivot + c->n || j == pivot + c->n))
                continue;
            if (has_one)                           /* its eigenvector is 1, 1, 1 ... */
                entry = interval_sub(entry, m[pivot * full + j]);
            if (has_l)
                entry = interval_sub(entry, grid_mul(pair->unknowns[i].c,
                                                     m[pivot * full + j], g));
            if (complex) {                         /* minus (J X)_i M_(p+n)j */
                interval jx = i < c->n ? interval_minus(pair->unknowns[i + c->n].c)
                                       : pair->unknowns[i - c->n].c;

                entry = interval_sub(entry, grid_mul(jx, m[(pivot + c->n) * full + j], g));
            }
            *next++ = entry;
        }
    }
    return out;
}

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

void spectrum_prove_rest(const interval *matrix, int size, int g,
                         const struct eigenpair *pair,
                         const struct block_record *record,
                         const struct certificate *certificate)
{
    interval *c = deflate(&size, matrix, g, pair, record, certificate);

    spectrum_prove_small(c, size, g, pair->s, record,
                         certificate->version == 0 ? "power" : "block", certificate->file);
}
