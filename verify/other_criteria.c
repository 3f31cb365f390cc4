/* other_criteria.c: signs of normals, and waves. */
#include "other_criteria.h"

#include "other_criteria_numbers.h"

#include <math.h>

/* At least rho_A and rho_B ([CP] Lemma 4.7). */
#define RHO 0.25

/* Faces round a vertex: there is none on dual meshes. */
criterion criterion_of_signs(const scheme *s, long k, const spectrum_list *l, long dominant)
{
    criterion z = {s->mesh != MESH_DUAL, TRUTH_UNKNOWN};
    long m;
    if (!z.applies || dominant < 0)
        return z;
    m = l->entry[dominant].m;
    if (m == 0 || 2 * m == k)
        z.holds = TRUTH_FALSE;
    else if (first_ring_is_not_zero_ball(s, k, m, 128))
        z.holds = TRUTH_TRUE;
    return z;
}

/* The largest lower and upper bounds of moduli in a block, but for the eigenvalue 1. */
static void bound_block(double *lower, double *upper, const spectrum_list *l, long m)
{
    long one = spectrum_find_one(l);
    *lower = *upper = 0;
    for (size_t i = 0; i < l->count; i++)
        if (l->entry[i].m == m && (long)i != one) {
            *lower = fmax(*lower, l->entry[i].modulus_lower);
            *upper = fmax(*upper, l->entry[i].modulus_upper);
        }
}

criterion criterion_of_waves(const scheme *s, long k, const spectrum_list *l)
{
    criterion z = {is_wave_ball(s, k, 128), TRUTH_UNKNOWN};
    double lambda[2], mu[2];
    if (!z.applies || spectrum_find_one(l) < 0)
        return z;
    bound_block(&lambda[0], &lambda[1], l, 1);
    bound_block(&mu[0], &mu[1], l, 0);
    if (lambda[0] > mu[1] && (k > 3 || lambda[0] > RHO))
        z.holds = TRUTH_TRUE;
    else if (mu[0] > lambda[1] && mu[0] > RHO)
        z.holds = TRUTH_FALSE;
    return z;
}
