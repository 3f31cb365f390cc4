/* step.c: rules become matrices on pairs. */
#include "step.h"

#include "formula_range.h"
#include "scheme_range.h"

#include <stdlib.h>
#include <string.h>

/* ---- the weights of rules ---- */

/* A rule with fewer sectors than this may give each of them a weight of its own. */
#define MAX_SECTORS 100000

static void set_scalar(pair_matrix *z, const number *x)
{
    number_set(&z->xx, x);
    number_zero(&z->xy);
    number_zero(&z->yx);
    number_set(&z->yy, x);
}

static void add_matrix(pair_matrix *z, const number *weight, const pair_matrix *t, long prec)
{
    number_addmul(&z->xx, weight, &t->xx, prec);
    number_addmul(&z->xy, weight, &t->xy, prec);
    number_addmul(&z->yx, weight, &t->yx, prec);
    number_addmul(&z->yy, weight, &t->yy, prec);
}

/* One weight, in all of its meanings. */
typedef struct {
    scheme_numbers *z;
    const twist *twist;
    formula_region at;
    diagnostic *complaint;
    number one;
} evaluation;

static status value_of(number *x, const formula *f, evaluation *e)
{
    return NUMBER_NAME(formula_range)(x, f, &e->at, e->z->prec, e->complaint);
}

/* z = t^n. */
static void twist_power(pair_matrix *z, const evaluation *e, int n)
{
    set_scalar(z, &e->one);
    for (int i = 0; e->twist && i < abs(n); i++)
        pair_matrix_multiply(z, n > 0 ? &e->twist->forth : &e->twist->back, z, e->z->prec);
}

static void make_indeterminate(pair_matrix *z)
{
    number_indeterminate(&z->xx);
    number_indeterminate(&z->xy);
    number_indeterminate(&z->yx);
    number_indeterminate(&z->yy);
}

#if defined(NUMBER_JET) || defined(NUMBER_COSINES)
/* As a function of u it is not needed, and exactly neither (verify/exact.md, section 3). */
static bool twist_of_sector(pair_matrix *z, const evaluation *e, long j)
{
    (void)j;
    if (e->twist)
        make_indeterminate(z);
    else
        set_scalar(z, &e->one);
    return true;
}
#else
/* z = t^j for one valence and frequency, from the angle: high powers of an enclosure of t would be no use.  In the real form, where
   (x, y) is x + i h y with h = sin(w/2), multiplication by c + i s is (c, -h s; s/h, c). */
static bool twist_of_sector(pair_matrix *z, const evaluation *e, long j)
{
    long m = e->at.m.first, k = e->at.k.first;
    rational angle;
    number h;
    bool ok;
    if (!e->twist) {
        set_scalar(z, &e->one);
        return true;
    }
    rational_init(&angle);
    number_init(&h);
    ok = rational_set_si(&angle, m * j % k, k) && rational_mul_2exp(&angle, &angle, 1);
    number_cos_pi(&z->xx, &angle, e->z->prec);
    number_set(&z->yy, &z->xx);
    number_sin_pi(&z->yx, &angle, e->z->prec);
    number_neg(&z->xy, &z->yx);
    if (ok && !e->twist->complex_form) {
        ok = rational_set_si(&angle, m, k);
        number_sin_pi(&h, &angle, e->z->prec);
        number_mul(&z->xy, &h, &z->yx, e->z->prec);
        number_neg(&z->xy, &z->xy);
        number_div(&z->yx, &z->yx, &h, e->z->prec);
    }
    ok = ok && !number_lacks_memory(&z->yx);
    rational_clear(&angle);
    number_clear(&h);
    return ok;
}
#endif

/* Sum over j of weight(j) t^j; total = the sum of the weights.  For more than one frequency nothing is known. */
static status sum_over_sectors(pair_matrix *z, number *total, const source *s, evaluation *e)
{
    status result = STATUS_OK;
    pair_matrix power;
    number weight;
    if (!is_one_valence(e->at.k))
        return diagnostic_set(e->complaint, s->weight->line, s->weight->column, "a weight for each sector has no meaning for several valences at once; use 'spectrum'");
    if (e->at.k.first > MAX_SECTORS)
        return diagnostic_set(e->complaint, s->weight->line, s->weight->column, "a weight for each sector is given up to valence %d only; use 'spectrum'", MAX_SECTORS);
    if (e->at.m.first != e->at.m.last) {
        make_indeterminate(z);
        number_indeterminate(total);
        return STATUS_OK;
    }
    pair_matrix_init(&power);
    number_init(&weight);
    for (e->at.j = 0; result == STATUS_OK && e->at.j < e->at.k.first; e->at.j++) {
        result = value_of(&weight, s->weight, e);
        if (result == STATUS_OK && !twist_of_sector(&power, e, e->at.j))
            result = STATUS_NO_MEMORY;
        add_matrix(z, &weight, &power, e->z->prec);
        number_add(total, total, &weight, e->z->prec);
    }
    pair_matrix_clear(&power);
    number_clear(&weight);
    return result;
}

/* The imaginary part of a spectrum, at one valence.  At m = k/2 real weights leave none. */
static status value_of_imaginary(number *z, const source *s, evaluation *e)
{
    frequencies m = e->at.m;
    bool has_half = m.last == e->at.k.first - m.last;
    status result = STATUS_OK;
    number zero;
    number_init(&zero);
    number_zero(z);
    if (!has_half || m.first != m.last)
        result = value_of(z, s->imaginary, e);
    if (has_half)
        number_hull(z, z, &zero, e->z->prec);
    number_clear(&zero);
    return result;
}

/* The value of a spectrum at m, as a matrix; total = its value at m = 0. */
static status value_of_spectrum(pair_matrix *z, number *total, const source *s, evaluation *e)
{
    status result;
    number imaginary;
    number_init(&imaginary);
    e->at.m = one_frequency(0);
    result = value_of(total, s->weight, e);
    e->at.m = e->z->m;
    if (result == STATUS_OK)
        result = value_of(&z->xx, s->weight, e);
    if (result == STATUS_OK)
        set_scalar(z, &z->xx);
    if (result == STATUS_OK && s->imaginary && e->twist) {
        result = value_of_imaginary(&imaginary, s, e); /* such a scheme is not mirror-symmetric: complex form */
        number_neg(&z->xy, &imaginary);
        number_set(&z->yx, &imaginary);
    }
    number_clear(&imaginary);
    return result;
}

/* The weight of source i, evaluated once if it is the same for all frequencies. */
static status value_of_weight(number *weight, rule_numbers *r, int i, evaluation *e)
{
    const formula *f = r->rule->sources[i].weight;
    status result = STATUS_OK;
    if (f->depends & FORMULA_ON_FREQUENCY)
        return value_of(weight, f, e);
    if (!r->known[i])
        result = value_of(&r->weight[i], f, e);
    r->known[i] = result == STATUS_OK;
    number_set(weight, &r->weight[i]);
    return result;
}

/* The matrix and the total weight of source i, which is not the rest. */
static status value_of_source(pair_matrix *z, number *total, rule_numbers *r, int i, evaluation *e)
{
    const source *s = &r->rule->sources[i];
    pair_matrix power;
    status result;
    if (s->kind == SOURCE_SECTORS)
        return sum_over_sectors(z, total, s, e);
    if (s->kind == SOURCE_SPECTRUM)
        return value_of_spectrum(z, total, s, e);
    result = value_of_weight(total, r, i, e);
    if (result != STATUS_OK || (s->kind == SOURCE_ALL && e->twist))
        return result; /* equal shares cancel: the sum of t^j over all sectors is 0 */
    pair_matrix_init(&power);
    twist_power(&power, e, s->offset);
    add_matrix(z, total, &power, e->z->prec);
    pair_matrix_clear(&power);
    return result;
}

/* What the rest is worth, given its matrix slot. */
static void value_of_rest(pair_matrix *z, number *rest, const source *s, const evaluation *e)
{
    pair_matrix power;
    if (s->kind == SOURCE_ALL && e->twist)
        return;
    pair_matrix_init(&power);
    twist_power(&power, e, s->offset);
    add_matrix(z, rest, &power, e->z->prec);
    pair_matrix_clear(&power);
}

static status set_rule(rule_numbers *z, evaluation *e)
{
    const rule *r = z->rule;
    status result = STATUS_OK;
    number rest, total;
    number_init(&rest);
    number_init(&total);
    number_set(&rest, &e->one);
    z->count = r->count;
    for (int pass = 0; pass < 2; pass++) /* the rest is known when all others are */
        for (int i = 0; result == STATUS_OK && i < r->count; i++) {
            const source *s = &r->sources[i];
            bool is_rest = !s->weight || (r->spectrum_takes_rest && s->kind == SOURCE_SPECTRUM && !e->twist);
            if (is_rest != (pass == 1))
                continue;
            pair_matrix_clear(&z->matrix[i]);
            pair_matrix_init(&z->matrix[i]);
            z->point[i] = s->point;
            number_zero(&total);
            if (!is_rest) {
                result = value_of_source(&z->matrix[i], &total, z, i, e);
                number_sub(&rest, &rest, &total, e->z->prec);
            } else {
                value_of_rest(&z->matrix[i], &rest, s, e);
            }
            if (number_lacks_memory(&rest))
                result = STATUS_NO_MEMORY;
        }
    number_clear(&rest);
    number_clear(&total);
    return result;
}

/* ---- making ---- */

static status collect_rules(step_numbers *z, const scheme_step *step, valence_range k, diagnostic *d)
{
    z->rules = calloc((size_t)step->rule_count + 1, sizeof *z->rules);
    if (!z->rules)
        return STATUS_NO_MEMORY;
    for (int i = 0; i < step->rule_count; i++) {
        const rule *holds;
        status s = scheme_find_rule_range(&holds, step, step->rules[i].at_centre, step->rules[i].point, k, d);
        if (s != STATUS_OK)
            return s;
        if (holds == &step->rules[i])
            z->rules[z->rule_count++].rule = holds;
    }
    return STATUS_OK;
}

status scheme_numbers_make_range(scheme_numbers *z, const scheme *s, valence_range k, long prec, diagnostic *d)
{
    truth decided;
    memset(z, 0, sizeof *z);
    if (!is_one_valence(k)) {
        status result = scheme_rules_decided(&decided, s, k, d);
        if (result != STATUS_OK || decided != TRUTH_TRUE)
            return result == STATUS_NO_MEMORY ? result : STATUS_BAD_INPUT;
    }
    z->scheme = s;
    z->k = k;
    z->prec = prec;
    z->rings = scheme_closed_rings(s);
    for (int i = 0; i < s->step_count; i++) {
        status result = collect_rules(&z->steps[i], &s->steps[i], k, d);
        if (result != STATUS_OK)
            return result;
        if (!mask_numbers_make(&z->steps[i].mask, &s->steps[i].mask, prec))
            return STATUS_NO_MEMORY;
    }
    return STATUS_OK;
}

status scheme_numbers_set_frequencies(scheme_numbers *z, frequencies m, const twist *t, diagnostic *d)
{
    evaluation e;
    status result = STATUS_OK;
    e.z = z;
    e.twist = t;
    e.at = (formula_region){z->k, m, 0};
    e.complaint = d;
    number_init(&e.one);
    number_one(&e.one);
    z->m = m;
    for (int i = 0; i < z->scheme->step_count; i++)
        for (int j = 0; result == STATUS_OK && j < z->steps[i].rule_count; j++)
            result = set_rule(&z->steps[i].rules[j], &e);
    number_clear(&e.one);
    return result;
}

void scheme_numbers_free(scheme_numbers *z)
{
    for (int i = 0; z->scheme && i < z->scheme->step_count; i++) {
        step_numbers *s = &z->steps[i];
        for (int j = 0; j < s->rule_count; j++)
            for (int l = 0; l < s->rules[j].count; l++) {
                pair_matrix_clear(&s->rules[j].matrix[l]);
                number_clear(&s->rules[j].weight[l]);
            }
        free(s->rules);
        if (s->mask.mask)
            mask_numbers_free(&s->mask);
    }
    memset(z, 0, sizeof *z);
}
