/* stability.c: bounds of K by convexity, by windows and by a series. */
#include "stability.h"

#include "growing.h"
#include "power.h"

#include <stdlib.h>

/* A bound is improved at one power as often as this, and as long as it falls. */
#define MAX_IMPROVEMENTS 12

/* ---- windows ---- */

/* Can phi(y - x) and phi(y - x - d) be other than 0 at one y?  Only if the interiors of two translates of the hull of
   the mask meet; "no" is certain. */
static bool share_a_window(const laurent_extent *e, lattice d)
{
    for (int f = 0; f < 3; f++) {
        long value = lattice_functional(f, d.a, d.b);
        if ((value < 0 ? -value : value) >= e->high[f] - e->low[f])
            return false;
    }
    return true;
}

/* One d of a window.  Of g_d(K), the largest sum of |(K + 1) row(x) - (K - 1) row(x + d)| over all x (K in units), is
   known: it is convex, and 2 |S^N| at K = 1; it rises by at most `difference` per unit; and it is `value` at `at`, if that has
   been computed. */
typedef struct {
    lattice d;
    int64_t difference; /* the largest sum of |row(x) - row(x + d)| */
    int64_t at, value;  /* at = 0: not computed */
    double upper;       /* of g_d at the K of the day, up to a few roundings */
} window_shift;

typedef struct {
    window_shift *shift; /* all d of one window */
    size_t count, capacity;
    int64_t first;       /* |S^N| */
    int64_t difference;  /* the largest of all d */
} windows;

static void windows_clear(windows *z)
{
    free(z->shift);
    *z = (windows){NULL, 0, 0, 0, 0};
}

static bool add_shift(windows *z, lattice d, int64_t difference)
{
    window_shift *room = growing_room(z->shift, z->count, &z->capacity, sizeof *room);
    if (!room)
        return false;
    z->shift = room;
    z->shift[z->count++] = (window_shift){d, difference, 0, 0, 0};
    z->difference = difference > z->difference ? difference : z->difference;
    return true;
}

/* -d gives the same difference as d.  On any result windows_clear. */
static bool windows_make(windows *z, const mask_power *p, const laurent_extent *e)
{
    long reach_a = e->high[0] - e->low[0], reach_b = e->high[1] - e->low[1];
    *z = (windows){NULL, 0, 0, 0, 0};
    if (!power_largest_difference(&z->first, p, (lattice){0, 0}, 1, 0))
        return false;
    for (long a = 0; a <= reach_a; a++)
        for (long b = a ? -reach_b : 0; b <= reach_b; b++) {
            lattice d = {(int)a, (int)b}, opposite = {(int)-a, (int)-b};
            int64_t difference;
            if (!share_a_window(e, d))
                continue;
            if (!power_largest_difference(&difference, p, d, 1, 1) || !add_shift(z, d, difference) || ((a || b) && !add_shift(z, opposite, difference)))
                return false;
        }
    return true;
}

static int by_upper(const void *x, const void *y)
{
    const window_shift *a = x, *b = y;
    return (a->upper < b->upper) - (a->upper > b->upper);
}

/* By the slope, or by the chord from 1 to a place where g_d was computed. */
static void bound_shifts(windows *w, int64_t bound)
{
    double start = 2.0 * STABILITY_UNIT * (double)w->first, run = (double)(bound - STABILITY_UNIT);
    for (size_t i = 0; i < w->count; i++) {
        window_shift *s = &w->shift[i];
        bool chord = s->at >= bound && bound > STABILITY_UNIT;
        s->upper = start + run * (chord ? ((double)s->value - start) / (double)(s->at - STABILITY_UNIT) : (double)s->difference);
    }
    qsort(w->shift, w->count, sizeof *w->shift, by_upper);
}

/* g = the largest g_d(K), K = bound / STABILITY_UNIT, over all d; as a numerator over STABILITY_UNIT total_denominator.  Where the upper
   bounds, which are much more exact than one part in 2^40, say so, there is no need to look. */
static bool largest_in_windows(int64_t *g, windows *w, const mask_power *z, int64_t bound)
{
    *g = 0;
    bound_shifts(w, bound);
    for (size_t i = 0; i < w->count && w->shift[i].upper * (1 + 0x1p-40) > (double)*g; i++) {
        window_shift *s = &w->shift[i];
        if (!power_largest_difference(&s->value, z, s->d, bound + STABILITY_UNIT, bound - STABILITY_UNIT))
            return false;
        s->at = bound;
        *g = s->value > *g ? s->value : *g;
    }
    return true;
}

/* One pass costs about as many operations as the box has coefficients, for each d. */
static double pass_cost(const mask_power *z, const laurent_extent *e)
{
    double reach_a = (double)(e->high[0] - e->low[0]), reach_b = (double)(e->high[1] - e->low[1]);
    return (double)z->na * (double)z->nb * (2 * reach_a + 1) * (2 * reach_b + 1);
}

/* Are the passes over S^N within the limits? */
static bool is_usable(const mask_power *z, const laurent_extent *e)
{
    return pass_cost(z, e) <= STABILITY_MAX_WORK && z->row_sum <= POWER_MAX_SUM / 4 && z->error <= z->row_sum;
}

/* g = G(bound), the largest norm of (1 + K)/2 row(x) - (K - 1)/2 row(x'), K = bound / STABILITY_UNIT, as a numerator
   over 2 STABILITY_UNIT total_denominator.  false in *fits: too large for a word. */
static bool window_function(int64_t *g, bool *fits, windows *w, const mask_power *z, int64_t bound)
{
    *fits = bound <= STABILITY_MAX_BOUND && bound <= POWER_MAX_SUM / 4 / z->row_sum;
    return !*fits || largest_in_windows(g, w, z, bound);
}

/* z = x / y rounded up to a multiple of 1 / STABILITY_UNIT, as that multiple, y > 0. */
static bool round_up(int64_t *z, const integer *x, const integer *y)
{
    bool ok;
    integer t;
    integer_init(&t);
    ok = integer_mul_si(&t, x, STABILITY_UNIT) && integer_cdiv_q(&t, &t, y);
    *z = ok && integer_fits_si(&t) ? integer_get_si(&t) : INT64_MAX;
    integer_clear(&t);
    return ok;
}

/* *bound = (first - slope) / (1 - slope) rounded up, INT64_MAX if slope >= 1, where slope = rise / run, and first and
   rise are numerators over `denominator`. */
static bool solve(int64_t *bound, int64_t first, const integer *rise, const integer *run, const integer *denominator)
{
    bool ok;
    integer x, y;
    integer_init(&x);
    integer_init(&y);
    ok = integer_mul(&y, run, denominator) && integer_sub(&y, &y, rise)     /* run denominator (1 - slope) */
         && integer_mul_si(&x, run, first) && integer_sub(&x, &x, rise);    /* run denominator (first - slope) */
    *bound = INT64_MAX;
    if (ok && integer_sign(&y) > 0)
        ok = round_up(bound, &x, &y);
    integer_clear(&x);
    integer_clear(&y);
    return ok;
}

/* The bound by the slope of G at infinity, half the largest difference of two rows; INT64_MAX: the slope is not below
   1, and S^N proves nothing. */
static bool bound_by_difference(int64_t *bound, windows *w, const mask_power *z)
{
    bool ok;
    integer rise, two;
    integer_init(&rise);
    integer_init(&two);
    integer_set_si(&two, 2);
    integer_set_si(&rise, w->difference);
    ok = solve(bound, w->first, &rise, &two, &z->total_denominator);
    integer_clear(&rise);
    integer_clear(&two);
    return ok;
}

/* A bound > 1 replaced by the one where the chord of G from 1 to it meets the diagonal. */
static bool improve_by_chord(int64_t *bound, windows *w, const mask_power *z)
{
    bool ok, fits;
    int64_t g, better;
    integer rise, run, t;
    if (!window_function(&g, &fits, w, z, *bound))
        return false;
    if (!fits)
        return true;
    integer_init(&rise);
    integer_init(&run);
    integer_init(&t);
    integer_set_si(&rise, g); /* over 2 unit total_denominator; run over unit, so count it over 2 unit as well */
    integer_set_si(&run, 2 * (*bound - STABILITY_UNIT));
    integer_set_si(&t, w->first);
    ok = integer_mul_si(&t, &t, 2 * STABILITY_UNIT) && integer_sub(&rise, &rise, &t) && solve(&better, w->first, &rise, &run, &z->total_denominator);
    if (ok && better < *bound)
        *bound = better;
    integer_clear(&rise);
    integer_clear(&run);
    integer_clear(&t);
    return ok;
}

/* Improves a bound that is proved (INT64_MAX: none is) by the windows of S^N. */
static bool improve_by_windows(int64_t *bound, windows *w, const mask_power *z)
{
    int64_t before;
    if (!bound_by_difference(&before, w, z))
        return false;
    if (before == INT64_MAX)
        return true;
    *bound = before < *bound ? before : *bound;
    for (int i = 0; i < MAX_IMPROVEMENTS && *bound > STABILITY_UNIT; i++) {
        before = *bound;
        if (!improve_by_chord(bound, w, z))
            return false;
        if (before == *bound)
            break;
    }
    return true;
}

/* Could S^(N+1) still be used?  Its box is that of S^N and 2^N times that of s. */
static bool is_next_usable(const mask_power *z, const laurent *s, const laurent_extent *e)
{
    mask_power next = *z;
    next.na += (s->na - 1) << z->exponent;
    next.nb += (s->nb - 1) << z->exponent;
    return is_usable(&next, e);
}

/* The powers of s as long as the limits of words and of work allow: the last one, which as a rule is the best, or all. */
static bool try_powers(stability *z, const laurent *s, bool all)
{
    laurent_extent e = laurent_get_extent(s);
    mask_power p;
    power_status status;
    bool ok = true;
    power_init(&p);
    status = power_start(&p, s, true);
    while (ok && status == POWER_OK && (status = power_raise(&p)) == POWER_OK && is_usable(&p, &e)) {
        int64_t bound = z->bound;
        windows w;
        if (!all && is_next_usable(&p, s, &e))
            continue;
        ok = windows_make(&w, &p, &e) && improve_by_windows(&bound, &w, &p);
        windows_clear(&w);
        if (ok && bound < z->bound)
            *z = (stability){STABILITY_WINDOW, bound, p.exponent};
    }
    power_clear(&p);
    return ok && status != POWER_NO_MEMORY;
}

static bool try_windows(stability *z, const laurent *s)
{
    return try_powers(z, s, false) && (z->kind != STABILITY_NONE || try_powers(z, s, true));
}

/* G(bound) <= bound, and the slope of G at infinity is below 1. */
static bool verify(bool *proved, windows *w, const mask_power *z, int64_t bound)
{
    int64_t g;
    bool fits, ok;
    integer limit;
    if (!window_function(&g, &fits, w, z, bound))
        return false;
    if (!fits)
        return true;
    integer_init(&limit);
    ok = integer_mul_si(&limit, &z->total_denominator, 2 * bound);
    *proved = ok && integer_cmp_si(&limit, g) >= 0;
    ok = ok && integer_mul_si(&limit, &z->total_denominator, 2);
    *proved = *proved && ok && integer_cmp_si(&limit, w->difference) > 0;
    integer_clear(&limit);
    return ok;
}

bool stability_verify_window(bool *proved, const laurent *s, int exponent, int64_t bound)
{
    laurent_extent e = laurent_get_extent(s);
    mask_power p;
    windows w;
    power_status status;
    bool ok = true;
    *proved = false;
    power_init(&p);
    status = power_start(&p, s, true);
    while (status == POWER_OK && p.exponent < exponent)
        status = power_raise(&p);
    if (status == POWER_OK && bound > STABILITY_UNIT && bound <= STABILITY_MAX_BOUND && is_usable(&p, &e)) {
        ok = windows_make(&w, &p, &e) && verify(proved, &w, &p, bound);
        windows_clear(&w);
    }
    power_clear(&p);
    return ok && status != POWER_NO_MEMORY;
}

/* ---- the series ---- */

/* sum = (d_0 + ... + d_(N-1)) d_N / (1 - d_N), d_N < 1. */
static bool sum_of_tail(rational *sum, const norm_list *d, int n)
{
    rational t;
    bool ok;
    rational_init(&t);
    ok = rational_set_si(sum, 0, 1);
    for (int q = 0; ok && q < n; q++)
        ok = rational_add(sum, sum, &d->norm[q]);
    ok = ok && rational_mul(sum, sum, &d->norm[n]) && rational_set_si(&t, 1, 1) && rational_sub(&t, &t, &d->norm[n]) && rational_div(sum, sum, &t);
    rational_clear(&t);
    return ok;
}

/* |S^N| + 2 C (d_0 + ... + d_(N-1)) d_N / (1 - d_N), rounded up. */
static bool bound_by_series(int64_t *bound, const rational *norm, const rational *constant, const norm_list *d, int n)
{
    rational t;
    bool ok;
    rational_init(&t);
    ok = sum_of_tail(&t, d, n) && rational_mul(&t, &t, constant) && rational_mul_2exp(&t, &t, 1) && rational_add(&t, &t, norm)
         && round_up(bound, &t.numerator, &t.denominator);
    rational_clear(&t);
    return ok;
}

static bool try_series(stability *z, const laurent *s, const rational *constant, const norm_list *d)
{
    norm_list norms;
    bool ok;
    norm_list_init(&norms);
    ok = norm_list_make(&norms, s, d->count, false);
    for (int n = 1; ok && n <= norms.count && n <= d->count; n++) {
        int64_t bound;
        if (rational_cmp_si(&d->norm[n], 1, 1) >= 0)
            continue;
        ok = bound_by_series(&bound, &norms.norm[n], constant, d, n);
        if (ok && bound < z->bound)
            *z = (stability){STABILITY_SERIES, bound, n};
    }
    norm_list_clear(&norms);
    return ok;
}

/* The series needs many norms and is far from sharp: it is for masks whose windows are too much work. */
static bool find_series(stability *z, const regular_masks *masks, const laurent *s, const rational *constant, int derivative)
{
    norm_list d;
    bool ok;
    norm_list_init(&d);
    ok = regular_contraction_list(&d, masks, derivative) && try_series(z, s, constant, &d);
    norm_list_clear(&d);
    return ok;
}

bool stability_find(stability *z, const laurent *mask, const regular_masks *masks, const comparison *c, int derivative)
{
    const laurent *s = derivative < 0 ? mask : &masks->derivative[derivative];
    *z = (stability){STABILITY_NONE, INT64_MAX, 0};
    if (laurent_is_nonnegative(s)) {
        *z = (stability){STABILITY_CONVEX, STABILITY_UNIT, 0};
        return true;
    }
    if (!try_windows(z, s))
        return false;
    return z->kind != STABILITY_NONE || find_series(z, masks, s, derivative < 0 ? &c->values : &c->derivative[derivative], derivative);
}
