/* interval_self_test.c: does directed rounding work, on this machine and as compiled?

   Each case is an operation on volatile operands whose exact result lies strictly between two neighbouring
   doubles a < b: as an interval it must be [a, b].  A compiler that computes it beforehand, moves it out of the
   region, keeps more digits, or a machine that rounds otherwise or flushes subnormals, gives something else. */
#include "interval.h"

#define EPS DBL_EPSILON

static bool is(const interval *x, double lower, double upper)
{
    return -x->neg_lower == lower && x->upper == upper;
}

static INTERVAL_NOINLINE bool run_cases(void)
{
    volatile double one_v = 1, three_v = 3, tiny_v = DBL_MIN, large_v = DBL_MAX, u_v = 1 + EPS, h_v = EPS / 4;
    double one = one_v, three = three_v, tiny = tiny_v, large = large_v, u = u_v, h = h_v;
    interval x, y, z;
    bool ok = FLT_RADIX == 2 && DBL_MANT_DIG == 53 && sizeof(double) == 8;

    interval_set_doubles(&x, one, one); /* 1 + 2^-54 */
    interval_set_doubles(&y, h, h);
    interval_add(&z, &x, &y, 0);
    ok = ok && is(&z, 1, 1 + EPS);
    interval_sub(&z, &x, &y, 0);
    ok = ok && is(&z, 1 - EPS / 2, 1);
    interval_neg(&x, &x);
    interval_sub(&z, &x, &y, 0);
    ok = ok && is(&z, -1 - EPS, -1);

    interval_set_doubles(&x, u, u); /* (1 + EPS)^2 = 1 + 2 EPS + EPS^2 */
    interval_mul(&z, &x, &x, 0);
    ok = ok && is(&z, 1 + 2 * EPS, 1 + 3 * EPS);
    interval_sqr(&z, &x, 0);
    ok = ok && is(&z, 1 + 2 * EPS, 1 + 3 * EPS);
    interval_neg(&y, &x);
    interval_mul(&z, &x, &y, 0);
    ok = ok && is(&z, -1 - 3 * EPS, -1 - 2 * EPS);

    interval_set_doubles(&x, one, one); /* 1/3 = 0.0101...01 01..., whose 54th bit is 0 */
    interval_set_doubles(&y, three, three);
    interval_div(&z, &x, &y, 0);
    ok = ok && is(&z, 0x1.5555555555555p-2, 0x1.5555555555556p-2);

    interval_sqrt(&z, &y, 0); /* sqrt(3) = 1.BB67AE8584CAA73B... */
    ok = ok && is(&z, 0x1.bb67ae8584caap0, 0x1.bb67ae8584cabp0);
    interval_set_doubles(&y, one + three, one + three);
    interval_sqrt(&z, &y, 0);
    ok = ok && is(&z, 2, 2);

    interval_set_doubles(&x, tiny, tiny); /* underflow: 2^-1022 (1 - 2^-53) and (2^-1022)^2 */
    interval_set_doubles(&y, one - EPS / 2, one - EPS / 2);
    interval_mul(&z, &x, &y, 0);
    ok = ok && is(&z, DBL_MIN - 0x1p-1074, DBL_MIN);
    interval_mul(&z, &x, &x, 0);
    ok = ok && is(&z, 0, 0x1p-1074);

    interval_set_doubles(&x, large, large); /* overflow */
    interval_add(&z, &x, &x, 0);
    ok = ok && is(&z, DBL_MAX, HUGE_VAL);
    interval_mul(&z, &x, &x, 0);
    ok = ok && is(&z, DBL_MAX, HUGE_VAL);
    return ok;
}

/* Sums whose operands stay in registers around the region. */
static INTERVAL_NOINLINE bool inlined_sum(double a, double b)
{
    interval x, y, z;
    interval_set_doubles(&x, a, a);
    interval_set_doubles(&y, b, b);
    for (int i = 0; i < 4; i++) {
        interval_add(&z, &x, &y, 0);
        x = z;
    }
    return is(&z, 1, 1 + 4 * EPS);
}

bool interval_self_test(void)
{
#if FLT_EVAL_METHOD != 0
    return false;
#else
    volatile double a = 1, b = EPS / 4;
    interval_mode mode = interval_enter();
    bool ok = run_cases() && inlined_sum(a, b);
    interval_leave(mode);
    volatile double sum = a + b; /* back to nearest? only tested if we came from there */
    volatile double half = 1 + 0.75 * EPS * a;
    (void)sum;
    (void)half;
    return ok;
#endif
}
