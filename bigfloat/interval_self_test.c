/* interval_self_test.c: does directed rounding work, on this machine and as compiled?

   Each case is an operation on volatile operands whose exact result lies strictly between two neighbouring
   doubles a < b: as an interval it must be [a, b].  A compiler that computes it beforehand, moves it out of the
   region, keeps more digits, or a machine that rounds otherwise or flushes subnormals, gives something else. */
#include "interval_batch.h"

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

#define BATCH 5 /* four at once, and one that is left over */

static bool all_are(const interval *z, double lower, double upper)
{
    bool ok = true;
    for (int i = 0; i < BATCH; i++)
        ok = ok && is(&z[i], lower, upper);
    return ok;
}

/* The instructions of batches may carry a rounding of their own. */
static INTERVAL_NOINLINE bool run_batches(void)
{
    volatile double one_v = 1, u_v = 1 + EPS, h_v = EPS / 4;
    interval one[BATCH], u[BATCH], h[BATCH], z[BATCH];
    for (int i = 0; i < BATCH; i++) {
        interval_set_doubles(&one[i], one_v, one_v);
        interval_set_doubles(&u[i], u_v, u_v);
        interval_set_doubles(&h[i], h_v, h_v);
    }
    interval_batch_add(z, one, h, BATCH);
    bool ok = all_are(z, 1, 1 + EPS);
    interval_batch_sub(z, one, h, BATCH);
    ok = ok && all_are(z, 1 - EPS / 2, 1);
    interval_batch_mul(z, u, u, BATCH);
    ok = ok && all_are(z, 1 + 2 * EPS, 1 + 3 * EPS);
    interval_batch_scale(z, u, u, BATCH);
    ok = ok && all_are(z, 1 + 2 * EPS, 1 + 3 * EPS);
    for (int i = 0; i < BATCH; i++)
        z[i] = one[i];
    interval_batch_addmul(z, h, u, BATCH);
    ok = ok && all_are(z, 1, 1 + EPS);
    interval_batch_axpy(z, h, u, BATCH); /* [1, 1 + EPS] and a little */
    ok = ok && all_are(z, 1, 1 + 2 * EPS);
    interval_batch_dot(z, u, u, 4); /* 4 (1 + EPS)^2, each product and sum rounded */
    return ok && is(z, 4 * (1 + 2 * EPS), 4 * (1 + 3 * EPS));
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
    return ok && run_batches();
#endif
}
