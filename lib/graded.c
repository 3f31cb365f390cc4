/* graded.c: the block, column by column, and the scaled matrix. */
#include "graded.h"

#include "eigen_approx.h"
#include "reciprocal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- weights ---- */

/* The plain block does without, as some may be unbounded. */
static void silence(rule_numbers *r)
{
    for (int i = 0; i < r->rule->count; i++) {
        number_zero(&r->weight[i]);
        r->known[i] = true;
    }
}

static bool take_weights(graded_block *z, scheme_numbers *numbers)
{
    bool known, ok = true;
    for (int i = 0; ok && i < numbers->scheme->step_count; i++)
        for (int j = 0; ok && j < numbers->steps[i].rule_count; j++) {
            rule_numbers *r = &numbers->steps[i].rules[j];
            if (!r->rule->at_centre)
                continue;
            ok = centre_weights_make(&z->weights[i], &known, r->rule, numbers->k);
            silence(r);
        }
    return ok;
}

static bool stretch_weights(graded_block *z, long unit)
{
    bool ok = true;
    for (int i = 0; i < SCHEME_MAX_STEPS; i++)
        for (int j = 0; ok && j < z->weights[i].count; j++)
            ok = laurent_value_stretch(&z->weights[i].weight[j], unit);
    return ok;
}

block_status graded_block_make(graded_block *z, block *plain, scheme_numbers *numbers, diagnostic *d)
{
    bool ok;
    block_status result;
    memset(z, 0, sizeof *z);
    number_init(&z->kappa);
    z->plain = plain;
    z->numbers = numbers;
    ok = take_weights(z, numbers);
    result = block_make(plain, numbers, 0, true, d);
    if (result == BLOCK_OK && ok) {
        z->order = malloc((size_t)plain->n * (size_t)plain->n * sizeof *z->order);
        z->entry = number_array_new((size_t)plain->n * (size_t)plain->n);
        ok = z->order && z->entry;
    }
    return result == BLOCK_OK && !ok ? BLOCK_NO_MEMORY : result;
}

void graded_block_free(graded_block *z)
{
    for (int i = 0; i < SCHEME_MAX_STEPS; i++)
        centre_weights_clear(&z->weights[i]);
    number_clear(&z->kappa);
    free(z->order);
    if (z->entry)
        number_array_free(z->entry, (size_t)z->plain->n * (size_t)z->plain->n);
    memset(z, 0, sizeof *z);
}

/* ---- entries ---- */

/* Column j is what becomes of unknown j alone. */
static block_status fill_column(graded_block *z, int j, const subdivision *once)
{
    const block *b = z->plain;
    graded_net unit, image;
    subdivide_status s = SUBDIVIDE_NO_MEMORY;
    memset(&image, 0, sizeof image);
    if (graded_net_make(&unit, b->mesh, b->rings)) {
        int at = graded_place(&unit, &b->unknowns[j]);
        unit.grade[at] = 0;
        number_one(&unit.value[at]);
        s = graded_subdivide(&image, &unit, once, z->weights, &z->kappa);
    }
    for (int i = 0; s == SUBDIVIDE_OK && i < b->n; i++) {
        int at = graded_place(&image, &b->unknowns[i]);
        z->order[i * b->n + j] = image.grade[at];
        number_set(&z->entry[i * b->n + j], &image.value[at]);
    }
    graded_net_free(&unit);
    graded_net_free(&image);
    return block_from_subdivide(s);
}

static block_status fill(graded_block *z)
{
    subdivision once;
    block_status result = block_from_subdivide(subdivision_make(&once, z->numbers, block_is_planar(z->plain), z->plain->rings, z->plain->rings));
    for (int j = 0; result == BLOCK_OK && j < z->plain->n; j++)
        result = fill_column(z, j, &once);
    subdivision_free(&once);
    return result;
}

block_status graded_block_scale(graded_block *z, long unit)
{
    if (!reciprocal_set(&z->kappa, unit, z->plain->k, z->numbers->prec) || !stretch_weights(z, unit))
        return BLOCK_NO_MEMORY;
    return fill(z);
}

/* ---- the choice ---- */

/* With which the scaled eigenvalue is about 1 at the valence `far`, at which the block is.  0: no memory. */
static long choose_unit(int degree, const graded_block *b, double far)
{
    int n = b->plain->n;
    double *m = calloc((size_t)n * (size_t)n, sizeof *m), unit = 1;
    if (!m)
        return 0;
    for (int i = 0; i < n * n; i++)
        if (b->order[i] != GRADED_ABSENT)
            m[i] = number_mid_approx(&b->entry[i]) * pow(far, -b->order[i]);
    if (degree > 0)
        unit = far * pow(spectral_radius_approx(m, n), -1.0 / degree);
    free(m);
    return unit > 1 && unit < GRADED_MAX_UNIT ? lround(unit) : 1;
}

block_status graded_choose(graded_choice *z, graded_block *b)
{
    valence_range k = b->plain->k;
    long far = k.last == VALENCES_UNBOUNDED ? 16 * k.first : k.last;
    block_status result = BLOCK_NO_MEMORY;
    if (reciprocal_set(&b->kappa, 1, one_valence(far), b->numbers->prec))
        result = fill(b);
    if (result != BLOCK_OK)
        return result;
    if (!graded_choice_from_orders(z, b->order, b->plain->n))
        return BLOCK_NO_MEMORY;
    z->unit = choose_unit(z->degree, b, (double)far);
    return z->unit ? BLOCK_OK : BLOCK_NO_MEMORY;
}

/* ---- the matrix ---- */

static bool scale_entry(number *m, const graded_block *b, const graded_choice *c, int i, int j)
{
    int at = i * b->plain->n + j;
    if (b->order[at] == GRADED_ABSENT)
        return true;
    int power = c->degree + c->grade[j] + b->order[at] - c->grade[i];
    if (power < 0)
        return false;
    number_set(m, &b->entry[at]);
    graded_scale(m, &b->kappa, power, b->numbers->prec);
    return true;
}

truth graded_matrix(number **m, const graded_block *b, const graded_choice *c)
{
    int n = b->plain->n;
    bool fits = true;
    *m = NULL;
    if (c->n != n || !graded_choice_is_within_limits(c))
        return TRUTH_UNKNOWN;
    *m = number_array_new((size_t)n * (size_t)n);
    for (int i = 0; *m && fits && i < n; i++)
        for (int j = 0; fits && j < n; j++)
            fits = scale_entry(&(*m)[i * n + j], b, c, i, j);
    return !*m ? TRUTH_FALSE : fits ? TRUTH_TRUE : TRUTH_UNKNOWN;
}
