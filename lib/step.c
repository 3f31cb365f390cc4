/* step.c: rules become matrices on pairs, then a net is mapped point by point. */
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

/* The matrix and the total weight of a source that is not the rest. */
static status value_of_source(pair_matrix *z, number *total, const source *s, evaluation *e)
{
    pair_matrix power;
    status result;
    if (s->kind == SOURCE_SECTORS)
        return sum_over_sectors(z, total, s, e);
    if (s->kind == SOURCE_SPECTRUM)
        return value_of_spectrum(z, total, s, e);
    result = value_of(total, s->weight, e);
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
                result = value_of_source(&z->matrix[i], &total, s, e);
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
            for (int l = 0; l < s->rules[j].count; l++)
                pair_matrix_clear(&s->rules[j].matrix[l]);
        free(s->rules);
        if (s->mask.mask)
            mask_numbers_free(&s->mask);
    }
    memset(z, 0, sizeof *z);
}

/* ---- applying ---- */

static const rule_numbers *find_rule(const step_numbers *s, bool at_centre, int a, int b)
{
    for (int i = 0; i < s->rule_count; i++) {
        const rule *r = s->rules[i].rule;
        if (r->at_centre == at_centre && (at_centre || (r->point.a == a && r->point.b == b)))
            return &s->rules[i];
    }
    return NULL;
}

static sector_status apply_rule(number *x, number *y, const rule_numbers *r, const sector_net *old_net, long prec)
{
    sector_status s = SECTOR_OK;
    number p, q;
    number_init(&p);
    number_init(&q);
    number_zero(x);
    number_zero(y);
    for (int i = 0; s == SECTOR_OK && i < r->count; i++) {
        if (r->rule->sources[i].kind == SOURCE_CENTRE) {
            number_addmul(x, &r->matrix[i].xx, &old_net->centre, prec); /* 0 unless the net is plain */
            continue;
        }
        s = sector_value(&p, &q, old_net, r->point[i].a, r->point[i].b, prec);
        pair_matrix_apply(&p, &q, &r->matrix[i], prec);
        number_add(x, x, &p, prec);
        number_add(y, y, &q, prec);
    }
    number_clear(&p);
    number_clear(&q);
    return s;
}

/* Without a rule the centre keeps its value, if the mask says so and nothing else. */
static bool mask_keeps_centre(const laurent *mask, int dilation)
{
    for (long a = mask->a0; a < mask->a0 + mask->na; a++)
        for (long b = mask->b0; b < mask->b0 + mask->nb; b++)
            if (a % dilation == 0 && b % dilation == 0 && (a || b) && !laurent_is_zero_at(mask, a, b))
                return false;
    return true;
}

static subdivide_status apply_to_centre(sector_net *new_net, const sector_net *old_net, const scheme_step *step, const step_numbers *n, long prec)
{
    const rule_numbers *r = find_rule(n, true, 0, 0);
    number unused;
    sector_status s = SECTOR_OK;
    if (step->to == MESH_DUAL || new_net->twist)
        return SUBDIVIDE_OK; /* no centre, or 0 there */
    number_init(&unused);
    if (r)
        s = apply_rule(&new_net->centre, &unused, r, old_net, prec);
    else if (step->from != MESH_DUAL && mask_keeps_centre(&step->mask, step->dilation))
        number_mul(&new_net->centre, mask_numbers_at(&n->mask, 0, 0), &old_net->centre, prec);
    else
        return SUBDIVIDE_NO_CENTRE_RULE;
    number_clear(&unused);
    return s == SECTOR_OK ? SUBDIVIDE_OK : SUBDIVIDE_OPPOSITE;
}

static subdivide_status apply_step(sector_net *new_net, const sector_net *old_net, const scheme_step *step, const step_numbers *n, long prec)
{
    for (int a = 1; a <= new_net->rings; a++)
        for (int b = step->to == MESH_DUAL; b <= new_net->rings; b++) {
            const rule_numbers *r;
            number *x = &new_net->x[sector_index(new_net, a, b)], *y = &new_net->y[sector_index(new_net, a, b)];
            sector_status s;
            if (mesh_ring(step->to, a, b) > new_net->rings)
                continue;
            r = find_rule(n, false, a, b);
            s = r ? apply_rule(x, y, r, old_net, prec) : sector_masked_value(x, y, old_net, &n->mask, step->dilation, a, b, prec);
            if (s != SECTOR_OK)
                return SUBDIVIDE_OPPOSITE;
            if (number_lacks_memory(x) || number_lacks_memory(y))
                return SUBDIVIDE_NO_MEMORY;
        }
    return apply_to_centre(new_net, old_net, step, n, prec);
}

/* The rings that each step must produce, so that the last has `rings`. */
static void plan_rings(int *rings_after, const scheme *s, int rings)
{
    for (int i = s->step_count - 1; i >= 0; i--) {
        rings_after[i] = rings;
        rings = scheme_step_rings_needed(&s->steps[i], rings);
    }
}

subdivide_status scheme_subdivide(sector_net *new_net, const sector_net *old_net, const scheme_numbers *numbers, int rings)
{
    const scheme *s = numbers->scheme;
    int rings_after[SCHEME_MAX_STEPS];
    sector_net between[2];
    subdivide_status result = SUBDIVIDE_OK;
    memset(between, 0, sizeof between);
    plan_rings(rings_after, s, rings);
    memset(new_net, 0, sizeof *new_net);
    for (int i = 0; result == SUBDIVIDE_OK && i < s->step_count; i++) {
        const sector_net *from = i ? &between[(i - 1) % 2] : old_net;
        sector_net *to = i == s->step_count - 1 ? new_net : &between[i % 2];
        sector_net_free(to);
        if (!sector_net_make(to, s->steps[i].to, old_net->regular, rings_after[i], old_net->twist))
            result = SUBDIVIDE_NO_MEMORY;
        else
            result = apply_step(to, from, &s->steps[i], &numbers->steps[i], numbers->prec);
    }
    sector_net_free(&between[0]);
    sector_net_free(&between[1]);
    return result;
}
