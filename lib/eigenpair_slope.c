/* eigenpair_slope.c: the linear system for the slopes, with the preconditioner of the proof. */
#include "eigenpair_slope.h"

typedef struct {
    int n, pivot;
    number *e; /* 1 - Y G */
    number *s; /* -Y d x */
    number *y;
    number *scratch;
} workspace;

/* Which entry of the box the unknown number l is; n for the eigenvalue. */
static int component(const workspace *w, int l)
{
    return l == w->n - 1 ? w->n : l < w->pivot ? l : l + 1;
}

static void load(workspace *w, const eigenpair_choice *choice, long prec)
{
    for (int i = 0; i < w->n * w->n; i++)
        number_set_integer_2exp(&w->y[i], &choice->inverse[i], -EIGENPAIR_INVERSE_BITS, prec);
}

/* scratch = d x, s = -Y scratch. */
static void make_constant(workspace *w, const number *box, const number *b_slope, long prec)
{
    int n = w->n;
    for (int i = 0; i < n; i++) {
        number_zero(&w->scratch[i]);
        for (int j = 0; j < n; j++)
            number_addmul(&w->scratch[i], &b_slope[i * n + j], &box[j], prec);
    }
    for (int i = 0; i < n; i++) {
        number_zero(&w->s[i]);
        for (int j = 0; j < n; j++)
            number_submul(&w->s[i], &w->y[i * n + j], &w->scratch[j], prec);
    }
}

/* e = 1 - Y G, column by column; scratch is a column of G. */
static void make_defect(workspace *w, const number *box, const number *b, long prec)
{
    int n = w->n;
    for (int l = 0; l < n; l++) {
        int j = component(w, l);
        for (int i = 0; i < n; i++) {
            number *g = &w->scratch[i];
            if (j == n) {
                number_neg(g, &box[i]);
            } else {
                number_set(g, &b[i * n + j]);
                if (i == j)
                    number_sub(g, g, &box[n], prec);
            }
        }
        for (int i = 0; i < n; i++) {
            number *e = &w->e[i * n + l];
            number_set_si(e, i == l, prec);
            for (int q = 0; q < n; q++)
                number_submul(e, &w->y[i * n + q], &w->scratch[q], prec);
        }
    }
}

/* bound >= |s| / (1 - |E|), thin; size[i] = the norm of row i of E.  TRUTH_UNKNOWN: |E| < 1 is not certain; TRUTH_FALSE: no memory. */
static truth first_bound(number *bound, number *size, const workspace *w, long prec)
{
    int n = w->n;
    truth certain;
    number norm, part;
    number_init(&norm);
    number_init(&part);
    number_zero(bound);
    for (int i = 0; i < n; i++) {
        number_zero(&size[i]);
        for (int l = 0; l < n; l++) {
            number_magnitude_upper(&part, &w->e[i * n + l], prec);
            number_add(&size[i], &size[i], &part, prec);
        }
        number_max(&norm, &norm, &size[i], prec);
        number_magnitude_upper(&part, &w->s[i], prec);
        number_max(bound, bound, &part, prec);
    }
    number_one(&part);
    number_sub(&norm, &part, &norm, prec);
    certain = number_lacks_memory(&norm) ? TRUTH_FALSE : number_is_positive(&norm) == TRUTH_TRUE ? TRUTH_TRUE : TRUTH_UNKNOWN;
    number_div(bound, bound, &norm, prec);
    number_upper(bound, bound, prec);
    number_clear(&norm);
    number_clear(&part);
    return certain;
}

/* slope = s + E slope, as often as it helps. */
static void improve(number *slope, workspace *w, int times, long prec)
{
    int n = w->n;
    for (int step = 0; step < times; step++) {
        for (int i = 0; i < n; i++) {
            number_set(&w->scratch[i], &w->s[i]);
            for (int l = 0; l < n; l++)
                number_addmul(&w->scratch[i], &w->e[i * n + l], &slope[component(w, l)], prec);
        }
        for (int i = 0; i < n; i++) {
            number *z = &slope[component(w, i)];
            number_intersection(z, z, &w->scratch[i], prec);
        }
    }
}

static truth find_slope(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, int improvements, long prec)
{
    int n = choice->n;
    size_t square = (size_t)n * (size_t)n;
    workspace w = {n, choice->pivot, number_array_new(square), number_array_new((size_t)n), number_array_new(square), number_array_new((size_t)n)};
    truth found = TRUTH_FALSE;
    number bound;
    number_init(&bound);
    if (w.e && w.s && w.y && w.scratch) {
        load(&w, choice, prec);
        make_constant(&w, box, b_slope, prec);
        make_defect(&w, box, b, prec);
        found = first_bound(&bound, w.scratch, &w, prec);
    }
    if (found == TRUTH_TRUE) {
        number_zero(&slope[w.pivot]);
        for (int i = 0; i < n; i++) {
            number_mul(&w.scratch[i], &w.scratch[i], &bound, prec);
            number_add_error(&slope[component(&w, i)], &w.s[i], &w.scratch[i], prec);
        }
        improve(slope, &w, improvements, prec);
        if (number_lacks_memory(&slope[n]))
            found = TRUTH_FALSE;
    }
    number_clear(&bound);
    number_array_free(w.e, square);
    number_array_free(w.s, (size_t)n);
    number_array_free(w.y, square);
    number_array_free(w.scratch, (size_t)n);
    return found;
}

truth eigenpair_slope(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, long prec)
{
    return find_slope(slope, box, choice, b, b_slope, 0, prec);
}

#define IMPROVEMENTS 3

truth eigenpair_slope_sharp(number *slope, const number *box, const eigenpair_choice *choice, const number *b, const number *b_slope, long prec)
{
    return find_slope(slope, box, choice, b, b_slope, IMPROVEMENTS, prec);
}
