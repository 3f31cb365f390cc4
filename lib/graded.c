/* graded.c: rows, degrees, and the scaled matrix. */
#include "graded.h"

#include "centre_weights.h"
#include "eigen_approx.h"
#include "reciprocal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the row of the centre ---- */

/* The unknown that a source of the centre names, whatever sector it lies in. */
static int unknown_of(const block *b, const source *s)
{
    for (int i = 0; i < b->n; i++) {
        const unknown *p = &b->unknowns[i];
        if (s->kind == SOURCE_CENTRE ? p->kind == UNKNOWN_CENTRE : p->kind == UNKNOWN_PLAIN && p->a == s->point.a && p->b == s->point.b)
            return i;
    }
    return -1;
}

static bool add_up(laurent_value *row, const block *b, const rule *r, const centre_weights *w)
{
    bool ok = true;
    for (int i = 0; ok && i < b->n; i++)
        ok = laurent_value_make(&row[i]);
    for (int i = 0; ok && i < r->count; i++) {
        int j = unknown_of(b, &r->sources[i]);
        ok = j < 0 || laurent_value_add(&row[j], &w->weight[i]); /* the rings of the block reach as far as its rules */
    }
    return ok;
}

static bool make_row(graded_block *z, const rule *centre, valence_range k)
{
    centre_weights w;
    bool known, ok = centre_weights_make(&w, &known, centre, k);
    z->centre = calloc((size_t)z->plain->n, sizeof *z->centre);
    ok = ok && z->centre && add_up(z->centre, z->plain, centre, &w);
    centre_weights_clear(&w);
    return ok;
}

/* The block needs none of them, and some may be unbounded. */
static const rule *silence_centre(scheme_numbers *numbers)
{
    const rule *centre = NULL;
    for (int i = 0; i < numbers->steps[0].rule_count; i++) {
        rule_numbers *r = &numbers->steps[0].rules[i];
        if (!r->rule->at_centre)
            continue;
        centre = r->rule;
        for (int j = 0; j < centre->count; j++) {
            number_zero(&r->weight[j]);
            r->known[j] = true;
        }
    }
    return centre;
}

block_status graded_block_make(graded_block *z, block *plain, scheme_numbers *numbers, diagnostic *d)
{
    const rule *centre = silence_centre(numbers);
    block_status result = block_make(plain, numbers, 0, true, d);
    memset(z, 0, sizeof *z);
    number_init(&z->kappa);
    z->plain = plain;
    if (result == BLOCK_OK && !make_row(z, centre, numbers->k))
        result = BLOCK_NO_MEMORY;
    return result;
}

void graded_block_free(graded_block *z)
{
    for (int i = 0; z->centre && i < z->plain->n; i++)
        laurent_value_clear(&z->centre[i]);
    free(z->centre);
    number_clear(&z->kappa);
    memset(z, 0, sizeof *z);
}

bool graded_block_set_unit(graded_block *z, long unit, long prec)
{
    bool ok = reciprocal_set(&z->kappa, unit, z->plain->k, prec);
    for (int i = 0; ok && i < z->plain->n; i++)
        ok = laurent_value_stretch(&z->centre[i], unit);
    return ok;
}

/* ---- the choice ---- */

static bool is_used(const graded_block *b, int i, int j)
{
    return number_is_zero(&b->plain->entry[i * b->plain->n + j]) != TRUTH_TRUE;
}

/* How many subdivisions it takes from the centre to each unknown, by rows other than the centre's; what never depends on it is as far
   as the farthest.  *farthest. */
static void measure_distances(int *distance, const graded_block *b)
{
    int n = b->plain->n, farthest = 0;
    for (int i = 1; i < n; i++)
        distance[i] = -1;
    for (int l = 1; l < n; l++)
        for (int i = 1; i < n; i++)
            for (int j = 0; distance[i] < 0 && j < n; j++)
                if (distance[j] == l - 1 && is_used(b, i, j))
                    farthest = distance[i] = l;
    for (int i = 1; i < n; i++)
        distance[i] = distance[i] < 0 ? farthest : distance[i];
}

/* The largest mean degree of a cycle through the centre, rounded up: its row contributes all degrees. */
static int choose_degree(const int *distance, const graded_block *b)
{
    int degree = 0;
    for (int j = 0; j < b->plain->n; j++) {
        int length = distance[j] + 1, needed = (laurent_value_high(&b->centre[j]) + length - 1) / length;
        degree = needed > degree ? needed : degree;
    }
    return degree;
}

/* The block at one valence. */
static void approximate(double *m, const graded_block *b, double k)
{
    int n = b->plain->n;
    for (int j = 0; j < n; j++)
        for (int c = laurent_value_low(&b->centre[j]); c <= laurent_value_high(&b->centre[j]); c++)
            m[j] += rational_get_double_approx(laurent_value_at(&b->centre[j], c)) * pow(k, c);
    for (int i = n; i < n * n; i++)
        m[i] = number_mid_approx(&b->plain->entry[i]);
}

/* With which the scaled eigenvalue is about 1 far out.  0: no memory. */
static long choose_unit(int degree, const graded_block *b)
{
    valence_range k = b->plain->k;
    double far = k.last == VALENCES_UNBOUNDED ? 16 * (double)k.first : (double)k.last, unit = 1;
    double *m = calloc((size_t)b->plain->n * (size_t)b->plain->n, sizeof *m);
    if (!m)
        return 0;
    approximate(m, b, far);
    if (degree > 0)
        unit = far * pow(spectral_radius_approx(m, b->plain->n), -1.0 / degree);
    free(m);
    return unit > 1 && unit < GRADED_MAX_UNIT ? lround(unit) : 1;
}

/* x_i / x_centre is about k^-(degree distance_i). */
bool graded_choose(graded_choice *z, const graded_block *b)
{
    if (!graded_choice_make(z, b->plain->n))
        return false;
    measure_distances(z->grade, b);
    z->degree = choose_degree(z->grade, b);
    for (int i = 0; i < z->n; i++)
        z->grade[i] *= z->degree;
    z->unit = choose_unit(z->degree, b);
    return z->unit > 0;
}

/* ---- the matrix ---- */

static bool scale_centre(number *m, const graded_block *b, const graded_choice *c, int j, long prec)
{
    const laurent_value *w = &b->centre[j];
    int shift = c->degree + c->grade[j] - c->grade[0];
    if (laurent_value_is_constant(w) && rational_is_zero(laurent_value_at(w, 0)))
        return true;
    if (shift < laurent_value_high(w))
        return false;
    reciprocal_laurent_value(m, w, shift, &b->kappa, prec);
    return true;
}

static bool scale_entry(number *m, const graded_block *b, const graded_choice *c, int i, int j, const number *powers, long prec)
{
    int power = c->degree + c->grade[j] - c->grade[i];
    if (i == 0)
        return scale_centre(m, b, c, j, prec);
    if (!is_used(b, i, j))
        return true;
    if (power < 0)
        return false;
    number_mul(m, &powers[power], &b->plain->entry[i * b->plain->n + j], prec);
    return true;
}

truth graded_matrix(number **m, const graded_block *b, const graded_choice *c, long prec)
{
    int n = b->plain->n, count = 2 * GRADED_MAX_DEGREE + 1;
    number *powers;
    truth t = TRUTH_FALSE;
    *m = NULL;
    if (c->n != n || !graded_choice_is_within_limits(c))
        return TRUTH_UNKNOWN;
    powers = reciprocal_powers(&b->kappa, count, prec);
    *m = number_array_new((size_t)n * (size_t)n);
    if (powers && *m)
        t = TRUTH_TRUE;
    for (int i = 0; t == TRUTH_TRUE && i < n; i++)
        for (int j = 0; t == TRUTH_TRUE && j < n; j++)
            if (!scale_entry(&(*m)[i * n + j], b, c, i, j, powers, prec))
                t = TRUTH_UNKNOWN;
    if (powers)
        number_array_free(powers, (size_t)count);
    return t;
}
