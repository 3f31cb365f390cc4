/* Eigenpairs: section 6 of certificate.md; of several valences section 3 of
 * certificate-valences.md, where, with M = c + d t, the pair (x0, l0) of c and the pair (x, l) of
 * M, the unknowns z of x = x0 + s t, l = l0 + lambda t solve G z = r, and Y G = 1 - E. */

#include "eigenpair.h"

#include "answer.h"

enum { INVERSE_BITS = 32 };

/* What the Krawczyk step works on; unknowns are counted from 0.  In the complex form
 * a vector has its real parts, then its imaginary parts. */
struct krawczyk {
    int g, n, size, pivot;
    bool real;
    interval *m;                                   /* size x size */
    interval *mid, *box;                           /* x~ and X, fixed ones too */
    interval l_mid[2], l_box[2];                   /* L~ and X_L: alpha, beta */
    interval *f, *slope, *inverse;                 /* f; G and Y, size x size */
};

interval spectrum_add_product(interval sum, interval x, interval y, int g)
{
    integer_count_work(0, 0);
    if (interval_is_zero(x) || interval_is_zero(y))
        return sum;
    return interval_add(sum, grid_mul(x, y, g));
}

interval spectrum_dot(const interval *x, const interval *y, int stride, int size, int g)
{
    struct mark mark = scratch_mark();
    interval sum = grid_from(0, g);

    for (int j = 0; j < size; j++)
        sum = spectrum_add_product(sum, x[j], y[j * stride], g);
    interval_keep(mark, &sum, 1);
    return sum;
}

/* One matrix
 * ---------- */

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
        s->inverse[i] = interval_thin(integer_shift_left(c->inverse[i], s->g - INVERSE_BITS));
}

/* f = M x~ - L~ x~ */
static void compute_residual(struct krawczyk *s)
{
    for (int i = 0; i < s->size; i++) {
        struct mark mark = scratch_mark();
        interval sum = spectrum_dot(&s->m[i * s->size], s->mid, 1, s->size, s->g);

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

/* E_il, E = 1 - Y G */
static interval defect(const struct krawczyk *s, int i, int l)
{
    interval product = spectrum_dot(&s->inverse[i * s->size], &s->slope[l], s->size, s->size, s->g);

    return interval_sub(grid_from(i == l ? 1 : 0, s->g), product);
}

/* K_i = - sum_l Y_il f_l + sum_l E_il [-rho, rho] */
static interval compute_image(const struct krawczyk *s, int i, interval box)
{
    interval out = interval_minus(spectrum_dot(&s->inverse[i * s->size], s->f, 1, s->size, s->g));

    for (int l = 0; l < s->size; l++) {
        struct mark mark = scratch_mark();

        out = interval_add(out, grid_mul(defect(s, i, l), box, s->g));
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

        if (integer_compare(image.lo, box.lo) <= 0 || integer_compare(image.hi, box.hi) >= 0)
            rejected(file, line,
                     "%s: the Krawczyk operator does not map the box into "
                     "its interior (component %d)", name, i + 1);
        scratch_release(mark);
    }
}

/* Exactly one eigenpair of the matrix's c, or (of a range of valences) of each in its range, is in
 * the box round the choices, of their radius or range, and it is simple; else rejects. */
static struct krawczyk prove_box(const struct affine *matrix, const struct choices *choices,
                                 bool range, const struct certificate *c)
{
    integer radius = range ? choices->range : choices->radius;
    struct krawczyk s = { .g = c->grid, .n = c->n, .size = c->size, .pivot = choices->pivot - 1,
                          .real = c->real };
    int entries = s.size * s.size;

    if (radius.sign <= 0)
        rejected(c->file, choices->line_of.radius, "radius: it is not positive");
    if (choices->pivot < 1 || choices->pivot > s.n)
        rejected(c->file, choices->line_of.pivot,
                 "pivot: it is not the index of one of the %d unknowns", s.n);
    s.m = allocate((size_t)entries, sizeof s.m[0]);
    for (int i = 0; i < entries; i++)
        s.m[i] = range ? affine_range(matrix[i]) : matrix[i].c;
    read_choices(&s, choices, radius);
    compute_residual(&s);
    compute_slope(&s);
    prove_inclusion(&s, radius, c->file, range ? choices->line_of.range : choices->line_of.radius,
                    range ? "range" : "radius");
    return s;
}

/* Several
 * ------- */

/* r_i = - sum_j D_ij X_j */
static interval *right_hand_side(const struct krawczyk *s, const struct affine *matrix)
{
    interval *out = allocate((size_t)s->size, sizeof out[0]);

    for (int i = 0; i < s->size; i++) {
        for (int j = 0; j < s->size; j++)
            out[i] = spectrum_add_product(out[i], matrix[i * s->size + j].d, s->box[j], s->g);
        out[i] = interval_minus(out[i]);
    }
    return out;
}

/* sum_l mag(E_il) */
static integer row_of_defect(const struct krawczyk *s, int i)
{
    integer out = integer_from(0);

    for (int l = 0; l < s->size; l++) {
        struct mark mark = scratch_mark();

        out = integer_add(out, interval_magnitude(defect(s, i, l)));
        integer_keep(mark, &out, 1);
    }
    return out;
}

/* z = Y r + E z, so |z| <= beta / (1 - e), and each z_i is in b_i + e_i |z| [-1, 1]. */
static interval *solve(const struct krawczyk *s, const struct affine *matrix,
                       const struct choices *choices, const char *file)
{
    const interval *r = right_hand_side(s, matrix);
    interval *out = allocate((size_t)s->size, sizeof out[0]);
    integer *e = allocate((size_t)s->size, sizeof e[0]);
    integer one = grid_from(1, s->g).lo, most = integer_from(0), beta = most, w;

    for (int i = 0; i < s->size; i++) {
        out[i] = spectrum_dot(&s->inverse[i * s->size], r, 1, s->size, s->g);
        e[i] = row_of_defect(s, i);
        beta = integer_max(beta, interval_magnitude(out[i]));
        most = integer_max(most, e[i]);
    }
    if (integer_compare(most, one) >= 0)
        rejected(file, choices->line_of.range,
                 "range: the slopes of the eigenpair are not bounded");
    w = integer_divide_ceil(integer_shift_left(beta, s->g), integer_sub(one, most));
    for (int i = 0; i < s->size; i++) {
        integer a = integer_shift_ceil(integer_mul(e[i], w), s->g);

        out[i] = interval_add(out[i], interval_of(integer_negate(a), a));
    }
    return out;
}

/* X^0 + S t */
static void add_slopes(struct eigenpair *out, const struct affine *matrix,
                       const struct choices *choices, const struct certificate *c)
{
    struct krawczyk all = prove_box(matrix, choices, true, c);
    const interval *slope = solve(&all, matrix, choices, c->file);

    for (int i = 0; i < c->size; i++)
        if (i != all.pivot)
            out->unknowns[i].d = *slope++;
    out->real.d = *slope;
}

struct eigenpair eigenpair_prove(const struct affine *matrix, const struct choices *choices,
                                 const struct certificate *c)
{
    size_t size = (size_t)c->size;
    struct eigenpair out = { .matrix = matrix, .choices = choices, .s = grid_from(0, c->grid) };
    struct krawczyk s;

    if (span_is_several(c->valence) && integer_compare(choices->range, choices->radius) < 0)
        rejected(c->file, choices->line_of.range, "range: it is smaller than the radius");
    s = prove_box(matrix, choices, false, c);
    out.unknowns = allocate(size, sizeof out.unknowns[0]);
    for (size_t i = 0; i < size; i++)
        out.unknowns[i] = affine_from(s.box[i]);
    out.real = affine_from(s.l_box[0]);
    out.imaginary = c->real ? affine_from_whole(0, c->grid) : affine_from(s.l_box[1]);
    if (span_is_several(c->valence))
        add_slopes(&out, matrix, choices, c);
    return out;
}
