/* arc.c: life of arcs, and fractions in units. */
#include "arc.h"

void arc_init(arc *z)
{
    rational_init(&z->low);
    rational_init(&z->high);
}

void arc_clear(arc *z)
{
    rational_clear(&z->low);
    rational_clear(&z->high);
}

bool arc_set_units(arc *z, int64_t low, int64_t high)
{
    return rational_set_si(&z->low, low, (int64_t)1 << ARC_BITS) && rational_set_si(&z->high, high, (int64_t)1 << ARC_BITS);
}

bool arc_set_frequency(arc *z, long m, valence_range k)
{
    bool ok = k.last == VALENCES_UNBOUNDED ? rational_set_si(&z->low, 0, 1) : rational_set_si(&z->low, m, k.last);
    return ok && rational_set_si(&z->high, m, k.first);
}

/* floor(m 2^48 / k) for 0 <= m < k, digit by digit; *rest: is it less than the quotient? */
static int64_t divide(bool *rest, long m, long k)
{
    uint64_t remainder = (uint64_t)m, divisor = (uint64_t)k;
    int64_t quotient = 0;
    for (int i = 0; i < ARC_BITS; i++) {
        remainder *= 2;
        quotient = 2 * quotient + (remainder >= divisor);
        remainder -= remainder >= divisor ? divisor : 0;
    }
    *rest = remainder > 0;
    return quotient;
}

int64_t arc_units_below(long m, long k)
{
    bool rest;
    if (k == VALENCES_UNBOUNDED)
        return 0;
    return m >= k - m ? ARC_HALF : divide(&rest, m, k);
}

int64_t arc_units_above(long m, long k)
{
    bool rest;
    int64_t below;
    if (k == VALENCES_UNBOUNDED)
        return m == FREQUENCIES_UNBOUNDED ? ARC_HALF : 0;
    if (m >= k - m)
        return ARC_HALF;
    below = divide(&rest, m, k);
    return below + rest;
}
