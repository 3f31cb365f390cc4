/* eigenpair_affine.c: the proof for the centres, the proof for the ranges, and the slopes between them. */
#include "eigenpair_affine.h"

#include "eigenpair.h"
#include "eigenpair_slope.h"

#include <math.h>

/* The parts of an affine matrix, n x n each. */
typedef struct {
    size_t size;
    number *centre, *slope, *range;
} parts;

static bool take_apart(parts *z, const affine *b, int n, long prec)
{
    z->size = (size_t)n * (size_t)n;
    z->centre = number_array_new(z->size);
    z->slope = number_array_new(z->size);
    z->range = number_array_new(z->size);
    if (!z->centre || !z->slope || !z->range)
        return false;
    for (size_t i = 0; i < z->size; i++) {
        number_set(&z->centre[i], &b[i].centre);
        number_set(&z->slope[i], &b[i].slope);
        affine_range(&z->range[i], &b[i], prec);
    }
    return true;
}

static void parts_free(parts *z)
{
    number_array_free(z->centre, z->size);
    number_array_free(z->slope, z->size);
    number_array_free(z->range, z->size);
}

truth eigenpair_affine_choose(eigenpair_choice *z, const affine *b, int n, long g, long prec)
{
    parts p;
    truth found = TRUTH_FALSE;
    if (take_apart(&p, b, n, prec))
        found = eigenpair_choose(z, p.centre, n, false, g, prec);
    if (found == TRUTH_UNKNOWN)
        found = eigenpair_choose_radius(z, p.centre, prec);
    if (found == TRUTH_TRUE)
        found = eigenpair_choose_range(z, p.range, prec);
    parts_free(&p);
    return found;
}

/* box: the pair of the centres, wide: that of the ranges; slope: n + 1 numbers each. */
static truth prove_parts(number *box, number *wide, number *slope, const eigenpair_choice *choice, const parts *p, long prec)
{
    truth t = eigenpair_prove(box, choice, p->centre, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_prove_range(wide, choice, p->range, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_slope(slope, wide, choice, p->range, p->slope, prec);
    return t;
}

truth eigenpair_affine_prove(affine *box, const eigenpair_choice *choice, const affine *b, int n, long prec)
{
    size_t count = (size_t)n + 1;
    number *centre, *wide, *slope;
    parts p;
    truth t = TRUTH_FALSE;
    if (choice->n != n || choice->complex_form || integer_cmp(&choice->range, &choice->radius) < 0)
        return TRUTH_UNKNOWN; /* a choice that somebody else made */
    centre = number_array_new(count);
    wide = number_array_new(count);
    slope = number_array_new(count);
    if (take_apart(&p, b, n, prec) && centre && wide && slope)
        t = prove_parts(centre, wide, slope, choice, &p, prec);
    for (size_t j = 0; t == TRUTH_TRUE && j < count; j++) {
        number_swap(&box[j].centre, &centre[j]);
        number_swap(&box[j].slope, &slope[j]);
    }
    parts_free(&p);
    number_array_free(centre, count);
    number_array_free(wide, count);
    number_array_free(slope, count);
    return t;
}

void affine_deflate(number *z, const affine *b, const affine *x, int n, int pivot, long prec)
{
    affine rest;
    affine_init(&rest);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            if (i == pivot || j == pivot)
                continue;
            affine_mul(&rest, &x[i], &b[pivot * n + j], prec);
            affine_sub(&rest, &b[i * n + j], &rest, prec);
            affine_range(z++, &rest, prec);
        }
    affine_clear(&rest);
}

spectral_answer affine_contract_rest(const affine *b, const affine *x, int n, int pivot, const number *scale, int least, int most, long prec)
{
    spectral_answer z = {TRUTH_FALSE, 0, false, INFINITY};
    size_t size = (size_t)(n - 1) * (size_t)(n - 1);
    number *rest = number_array_new(size);
    if (rest) {
        affine_deflate(rest, b, x, n, pivot, prec);
        z = spectral_contraction(rest, scale, n - 1, least, most, prec);
        number_array_free(rest, size);
    }
    return z;
}
