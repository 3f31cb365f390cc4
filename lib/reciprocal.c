/* reciprocal.c: multiples of 1/k, and what is made of them. */
#include "reciprocal.h"

bool reciprocal_set(affine *kappa, long unit, valence_range k, long prec)
{
    rational q;
    base_number low, high;
    bool ok;
    rational_init(&q);
    base_init(&low);
    base_init(&high);
    ok = k.last == VALENCES_UNBOUNDED || rational_set_si(&q, unit, k.last);
    base_set_rational(&low, &q, prec);
    ok = ok && rational_set_si(&q, unit, k.first);
    base_set_rational(&high, &q, prec);
    affine_between(kappa, &low, &high, prec);
    rational_clear(&q);
    base_clear(&low);
    base_clear(&high);
    return ok && !affine_lacks_memory(kappa);
}

/* (1 + t)/(2 k1) */
bool reciprocal_set_down_to_zero(affine *kappa, valence_range k, long prec)
{
    rational half;
    bool ok;
    rational_init(&half);
    ok = rational_set_si(&half, 1, k.first) && rational_mul_2exp(&half, &half, -1);
    base_set_rational(&kappa->centre, &half, prec);
    base_set(&kappa->slope, &kappa->centre);
    rational_clear(&half);
    return ok;
}

affine *reciprocal_powers(const affine *kappa, int count, long prec)
{
    affine *z = affine_array_new((size_t)count);
    for (int i = 0; z && i < count; i++) {
        if (i == 0)
            affine_one(&z[i]);
        else
            affine_mul(&z[i], &z[i - 1], kappa, prec);
    }
    return z;
}

void reciprocal_laurent_value(affine *z, const laurent_value *w, const affine *kappa, long prec)
{
    affine c;
    affine_init(&c);
    affine_zero(z);
    for (int i = laurent_value_low(w); i <= 0; i++) {
        affine_set_rational(&c, laurent_value_at(w, i), prec);
        affine_mul(z, z, kappa, prec);
        affine_add(z, z, &c, prec);
    }
    affine_clear(&c);
}
