/* regular.c: difference masks by division, norms by classes. */
#include "regular.h"

const lattice regular_direction[3] = {{1, 0}, {0, 1}, {1, -1}};

void regular_init(regular_masks *z)
{
    for (int i = 0; i < 2; i++)
        laurent_init(&z->derivative[i]);
    for (int i = 0; i < 3; i++)
        laurent_init(&z->second[i]);
    z->divisible = false;
}

void regular_clear(regular_masks *z)
{
    for (int i = 0; i < 2; i++)
        laurent_clear(&z->derivative[i]);
    for (int i = 0; i < 3; i++)
        laurent_clear(&z->second[i]);
}

/* z = a / (1 + z^-d), or leaves *divisible false. */
static bool difference_mask(laurent *z, bool *divisible, const laurent *a, lattice d)
{
    bool exact;
    if (!laurent_divide_binomial(z, &exact, a, d))
        return false;
    *divisible = *divisible && exact;
    return true;
}

bool regular_derive(regular_masks *z, const laurent *mask)
{
    static const int first[3] = {0, 0, 1}, second[3] = {1, 2, 2};
    bool ok = true;
    z->divisible = true;
    for (int i = 0; ok && i < 2; i++)
        ok = difference_mask(&z->derivative[i], &z->divisible, mask, regular_direction[i])
             && laurent_mul_si(&z->derivative[i], &z->derivative[i], 2);
    for (int i = 0; ok && i < 3; i++) /* 2 a_d is there already: dividing it gives 2 a_dd' */
        ok = difference_mask(&z->second[i], &z->divisible, &z->derivative[first[i]], regular_direction[second[i]]);
    return ok;
}

/* s^N(z) = s(z) s(z^2) ... s(z^(2^(N-1))) */
bool regular_norm(rational *norm, const laurent *s, int power)
{
    laurent product, factor;
    bool ok;
    laurent_init(&product);
    laurent_init(&factor);
    ok = laurent_set(&product, s);
    for (int i = 1; ok && i < power; i++)
        ok = laurent_stretch(&factor, s, 1L << i) && laurent_mul(&product, &factor, &product);
    ok = ok && laurent_class_norm(norm, &product, 1L << power);
    laurent_clear(&product);
    laurent_clear(&factor);
    return ok;
}

/* The cost of the last product: the terms of s times the box of s^(N-1), which is about 2^(N-1) times as wide. */
static bool is_affordable(const laurent *s, int power)
{
    double size = (double)s->na * (double)s->nb;
    return power <= REGULAR_MAX_POWER && size * size * (double)(1L << 2 * (power - 1)) <= REGULAR_MAX_WORK;
}

bool regular_contraction(int power[3], rational norm[3], const regular_masks *masks)
{
    for (int i = 0; i < 3; i++) {
        bool found = false;
        for (power[i] = 1; masks->divisible && !found && is_affordable(&masks->second[i], power[i]); power[i] += !found) {
            if (!regular_norm(&norm[i], &masks->second[i], power[i]))
                return false;
            found = rational_cmp_si(&norm[i], 1, 1) < 0;
        }
        if (!found)
            power[i] = 0;
    }
    return true;
}
