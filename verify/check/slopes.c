/* Eigenpairs of several valences: section 3 of certificate-valences.md.
 *
 * With M = c + d t, the pair (x0, l0) of c and the pair (x, l) of M, the unknowns z of
 * x = x0 + s t, l = l0 + lambda t solve a linear system G z = r, and Y G = 1 - E. */

#include "slopes.h"

#include "answer.h"

/* r_i = - sum_j D_ij X_j */
static interval *right_hand_side(const struct krawczyk *s, const struct affine *matrix)
{
    interval *out = allocate((size_t)s->size, sizeof out[0]);

    for (int i = 0; i < s->size; i++) {
        for (int j = 0; j < s->size; j++)
            out[i] = spectrum_add_product(out[i], matrix[i * s->size + j].d, s->box[j],
                                          s->g);
        out[i] = interval_minus(out[i]);
    }
    return out;
}

/* sum_l mag(E_il), E = 1 - Y G */
static integer row_of_defect(const struct krawczyk *s, int i)
{
    integer out = integer_from(0);

    for (int l = 0; l < s->size; l++) {
        struct mark mark = scratch_mark();
        interval sum = grid_from(0, s->g);

        for (int q = 0; q < s->size; q++)
            sum = spectrum_add_product(sum, s->inverse[i * s->size + q],
                                       s->slope[q * s->size + l], s->g);
        sum = interval_sub(grid_from(i == l ? 1 : 0, s->g), sum);
        out = integer_add(out, interval_magnitude(sum));
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
        for (int l = 0; l < s->size; l++)
            out[i] = spectrum_add_product(out[i], s->inverse[i * s->size + l], r[l], s->g);
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

struct eigenpair slopes_prove_eigenpair(const struct affine *matrix, int g,
                                        const struct choices *choices,
                                        const struct certificate *c)
{
    size_t entries = (size_t)c->size * (size_t)c->size;
    struct krawczyk middle, all;
    struct eigenpair out = { .s = grid_from(0, g) };
    const interval *slope;

    if (integer_compare(choices->range, choices->radius) < 0)
        rejected(c->file, choices->line_of.range, "range: it is smaller than the radius");
    middle = spectrum_prove_inclusion(affine_constants(matrix, entries), g, choices, false, c);
    all = spectrum_prove_inclusion(affine_ranges(matrix, entries), g, choices, true, c);
    slope = solve(&all, matrix, choices, c->file);
    out.unknowns = allocate((size_t)c->size, sizeof out.unknowns[0]);
    for (int i = 0; i < c->size; i++) {
        out.unknowns[i] = affine_from(middle.box[i]);
        if (i != all.pivot)
            out.unknowns[i].d = *slope++;
    }
    out.real = (struct affine) { middle.l_box[0], *slope };
    out.imaginary = affine_from_whole(0, g);
    return out;
}
