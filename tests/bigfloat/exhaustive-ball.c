/* exhaustive-ball.c: every operation on all pairs from two families of balls, against exact arithmetic.

   Since scaling by a power of two is exact, the first operand keeps the exponent 0.  The families:
     short   |m| <= 5, errors small or near 2^BALL_ERROR_BITS, exponents that make the mantissas overlap, touch,
             or miss each other at 64 and 128 bits;
     long    m = +-(2^k + d), d = -1, 0, 1, with k around multiples of 64.
   Besides containment: comparisons are exactly right, and no result is much wider than the formula of midpoint
   and radius makes it (measured in doubles; all exponents are small here). */
#include <math.h>
#include <string.h>

#include "bigfloat/ball.h"
#include "random.h"

/* ---- dyadic numbers m 2^e ---- */

typedef struct {
    integer m;
    long e;
} dyadic_number;

static integer scratch[2];

static int sign_of(const dyadic_number *x) { return integer_sign(&x->m); }

static int compare(const dyadic_number *x, const dyadic_number *y)
{
    if (x->e == y->e || sign_of(x) != sign_of(y))
        return integer_cmp(&x->m, &y->m);
    long e = x->e < y->e ? x->e : y->e;
    MUST(integer_mul_2exp(&scratch[0], &x->m, (unsigned long)(x->e - e)));
    MUST(integer_mul_2exp(&scratch[1], &y->m, (unsigned long)(y->e - e)));
    return integer_cmp(&scratch[0], &scratch[1]);
}

static void add(dyadic_number *z, const dyadic_number *x, const dyadic_number *y)
{
    long e = x->e < y->e ? x->e : y->e;
    MUST(integer_mul_2exp(&scratch[0], &x->m, (unsigned long)(x->e - e)));
    MUST(integer_mul_2exp(&scratch[1], &y->m, (unsigned long)(y->e - e)));
    MUST(integer_add(&z->m, &scratch[0], &scratch[1]));
    z->e = e;
}

static void multiply(dyadic_number *z, const dyadic_number *x, const dyadic_number *y)
{
    MUST(integer_mul(&z->m, &x->m, &y->m));
    z->e = x->e + y->e;
}

static void negate(dyadic_number *z, const dyadic_number *x)
{
    MUST(integer_neg(&z->m, &x->m));
    z->e = x->e;
}

static void assign(dyadic_number *z, const dyadic_number *x)
{
    MUST(integer_set(&z->m, &x->m));
    z->e = x->e;
}

static void keep_less(dyadic_number *z, const dyadic_number *x)
{
    if (compare(x, z) < 0)
        assign(z, x);
}

static void keep_greater(dyadic_number *z, const dyadic_number *x)
{
    if (compare(x, z) > 0)
        assign(z, x);
}

/* ---- closed intervals, and the balls as such ---- */

typedef struct {
    dyadic_number low, high;
} range;

static void range_init(range *r)
{
    integer_init(&r->low.m);
    integer_init(&r->high.m);
    r->low.e = r->high.e = 0;
}

static void range_clear(range *r)
{
    integer_clear(&r->low.m);
    integer_clear(&r->high.m);
}

static bool range_of(range *r, const ball *x)
{
    uint64_t err;
    int64_t e;
    if (!ball_get_parts(&r->low.m, &err, &e, x))
        return false;
    MUST(integer_add_si(&r->high.m, &r->low.m, (int64_t)err));
    MUST(integer_add_si(&r->low.m, &r->low.m, -(int64_t)err));
    r->low.e = r->high.e = (long)e;
    return true;
}

static bool inside(const range *r, const range *of)
{
    return compare(&of->low, &r->low) <= 0 && compare(&r->high, &of->high) <= 0;
}

static double radius_approx(const ball *x) { return ldexp((double)x->error, (int)x->exponent); }
static double mid_approx(const ball *x) { return fabs(ball_mid_approx(x)); }

/* ---- the families ---- */

#define MOST 4000
static ball family[MOST], other[MOST];
static range family_range[MOST], other_range[MOST];
static int members, others;

static void put(bool first, const integer *m, uint64_t err, int64_t e)
{
    ball *z = first ? &family[members] : &other[others];
    range *r = first ? &family_range[members++] : &other_range[others++];
    ball_init(z);
    range_init(r);
    ball_set_parts(z, m, err, e);
    CHECK(range_of(r, z), "a member is not finite");
}

static void drop_families(void)
{
    for (int i = 0; i < members; i++)
        ball_clear(&family[i]), range_clear(&family_range[i]);
    for (int i = 0; i < others; i++)
        ball_clear(&other[i]), range_clear(&other_range[i]);
    members = others = 0;
}

#define LAST ((UINT64_C(1) << BALL_ERROR_BITS) - 1)

static void make_short(void)
{
    static const uint64_t errors[] = {0, 1, 2, 3, LAST / 2 + 1, LAST - 1, LAST};
    static const int exponents[] = {-128, -65, -64, -63, -31, -1, 0, 1, 30, 63, 64};
    integer m;
    integer_init(&m);
    for (int v = -5; v <= 5; v++)
        for (size_t r = 0; r < sizeof errors / sizeof *errors; r++) {
            integer_set_si(&m, v);
            put(true, &m, errors[r], 0);
            for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++)
                put(false, &m, errors[r], exponents[e]);
        }
    integer_clear(&m);
}

static void make_long(void)
{
    static const uint64_t errors[] = {0, 1, LAST};
    static const unsigned long lengths[] = {1, 33, 63, 64, 65, 128, 190};
    static const int exponents[] = {-129, -64, -1, 0, 3, 63, 64};
    integer m;
    integer_init(&m);
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++)
        for (int d = -1; d <= 1; d++)
            for (int sign = -1; sign <= 1; sign += 2)
                for (size_t r = 0; r < sizeof errors / sizeof *errors; r++) {
                    integer_set_si(&m, 1);
                    MUST(integer_mul_2exp(&m, &m, lengths[k]));
                    MUST(integer_add_si(&m, &m, d));
                    MUST(integer_mul_si(&m, &m, sign));
                    put(true, &m, errors[r], 0);
                    for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++)
                        put(false, &m, errors[r], exponents[e]);
                }
    integer_clear(&m);
}

/* ---- reports ---- */

static void report(const char *name, const ball *x, const ball *y, const ball *z, long prec, const char *what)
{
    char *a = ball_get_hex(x), *b = y ? ball_get_hex(y) : NULL, *c = ball_get_hex(z);
    CHECK(false, "%s: x = %s, y = %s, prec %ld: z = %s: %s", name, a, b ? b : "", prec, c, what);
    free(a), free(b), free(c);
}

/* What rounding to prec bits may add to the radius: 4 units of the last place. */
static double rounding(const ball *z, long prec)
{
    return ldexp(mid_approx(z) + radius_approx(z), (int)(prec < 64 ? -64 : -prec) + 3);
}

/* z contains r, and its radius is at most `formula`, within 1 in 2^18, and what rounding may add. */
static void expect(const char *name, const ball *x, const ball *y, const ball *z, long prec, const range *r, double formula)
{
    static range zr;
    if (test_failed())
        return;
    if (!range_of(&zr, z))
        report(name, x, y, z, prec, "not finite");
    else if (z->error >> BALL_ERROR_BITS)
        report(name, x, y, z, prec, "error too long");
    else if (!inside(r, &zr))
        report(name, x, y, z, prec, "does not contain the exact result");
    else if (radius_approx(z) > formula * (1 + 0x1p-18) + rounding(z, prec))
        report(name, x, y, z, prec, "too wide");
}

/* ---- binary operations ---- */

static range exact, product;
static dyadic_number t[4];

static void corner_products(range *r, const range *x, const range *y)
{
    for (int i = 0; i < 4; i++) {
        multiply(&t[i], i & 1 ? &x->high : &x->low, i & 2 ? &y->high : &y->low);
        if (i == 0) {
            assign(&r->low, &t[0]);
            assign(&r->high, &t[0]);
        } else {
            keep_less(&r->low, &t[i]);
            keep_greater(&r->high, &t[i]);
        }
    }
}

/* z = [zl, zh] contains every x / y, y > 0, iff zl y <= x <= zh y for all x and y: it suffices at endpoints. */
static bool contains_quotients(const range *z, const range *x, const range *y)
{
    bool ok = true;
    for (int i = 0; i < 2; i++) {
        multiply(&t[0], &z->low, i ? &y->high : &y->low);
        multiply(&t[1], &z->high, i ? &y->high : &y->low);
        ok = ok && compare(&t[0], &x->low) <= 0 && compare(&x->high, &t[1]) <= 0;
    }
    return ok;
}

static void check_quotient(const ball *x, const range *xr, const ball *y, const range *yr, long prec)
{
    static ball z;
    static range zr, xn, yn;
    ball_div(&z, x, y, prec);
    if (sign_of(&yr->low) <= 0 && sign_of(&yr->high) >= 0) {
        if (ball_is_finite(&z))
            report("div", x, y, &z, prec, "division by 0 is finite");
        return;
    }
    bool flip = sign_of(&yr->high) < 0;
    if (flip) {
        negate(&xn.low, &xr->high), negate(&xn.high, &xr->low);
        negate(&yn.low, &yr->high), negate(&yn.high, &yr->low);
    }
    double rx = radius_approx(x), ry = radius_approx(y), mx = mid_approx(x), my = mid_approx(y);
    if (!range_of(&zr, &z))
        report("div", x, y, &z, prec, "not finite");
    else if (!contains_quotients(&zr, flip ? &xn : xr, flip ? &yn : yr))
        report("div", x, y, &z, prec, "does not contain the exact result");
    else if (radius_approx(&z) > (rx + mx / my * ry) / (my - ry) * (1 + 0x1p-18) + rounding(&z, prec))
        report("div", x, y, &z, prec, "too wide");
}

static truth less(const range *x, const range *y)
{
    return compare(&x->high, &y->low) < 0 ? TRUTH_TRUE : compare(&x->low, &y->high) >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

static void check_questions(const ball *x, const range *xr, const ball *y, const range *yr)
{
    if (ball_less(x, y) != less(xr, yr))
        report("less", x, y, x, 0, "wrong");
    if (ball_less(y, x) != less(yr, xr))
        report("less", y, x, y, 0, "wrong");
    if (ball_contains(x, y) != inside(yr, xr))
        report("contains", x, y, x, 0, "wrong");
    if (ball_contains_interior(x, y) != (compare(&xr->low, &yr->low) < 0 && compare(&yr->high, &xr->high) < 0))
        report("contains_interior", x, y, x, 0, "wrong");
    if (ball_overlaps(x, y) != (compare(&xr->low, &yr->high) <= 0 && compare(&yr->low, &xr->high) <= 0))
        report("overlaps", x, y, x, 0, "wrong");
}

static void check_sets(const ball *x, const range *xr, const ball *y, const range *yr, long prec)
{
    static ball z;
    const range *low = compare(&xr->low, &yr->low) < 0 ? xr : yr, *high = compare(&xr->high, &yr->high) > 0 ? xr : yr;
    double width;
#define HALF_WIDTH() (add(&t[1], &exact.high, (negate(&t[0], &exact.low), &t[0])), \
                      0.5 * ldexp(integer_get_double_approx(&t[1].m), (int)t[1].e))
    ball_hull(&z, x, y, prec);
    assign(&exact.low, &low->low), assign(&exact.high, &high->high);
    width = HALF_WIDTH();
    expect("hull", x, y, &z, prec, &exact, width);
    ball_min(&z, x, y, prec);
    assign(&exact.high, high == xr ? &yr->high : &xr->high);
    width = HALF_WIDTH();
    expect("min", x, y, &z, prec, &exact, width);
    ball_max(&z, x, y, prec);
    assign(&exact.low, low == xr ? &yr->low : &xr->low), assign(&exact.high, &high->high);
    width = HALF_WIDTH();
    expect("max", x, y, &z, prec, &exact, width);
    ball_intersection(&z, x, y, prec);
    assign(&exact.high, high == xr ? &yr->high : &xr->high);
    if (compare(&exact.low, &exact.high) <= 0) {
        width = HALF_WIDTH();
        expect("intersection", x, y, &z, prec, &exact, width);
    }
}

static void check_pair(const ball *x, const range *xr, const ball *y, const range *yr, long prec)
{
    static ball z, w;
    double rx = radius_approx(x), ry = radius_approx(y), mx = mid_approx(x), my = mid_approx(y);
    double sum = rx + ry, times = mx * ry + my * rx + rx * ry;
    ball_add(&z, x, y, prec);
    add(&exact.low, &xr->low, &yr->low), add(&exact.high, &xr->high, &yr->high);
    expect("add", x, y, &z, prec, &exact, sum);
    ball_sub(&z, y, x, prec);
    negate(&t[0], &xr->high), add(&exact.low, &yr->low, &t[0]);
    negate(&t[0], &xr->low), add(&exact.high, &yr->high, &t[0]);
    expect("sub", y, x, &z, prec, &exact, sum);
    ball_mul(&z, x, y, prec);
    corner_products(&product, xr, yr);
    expect("mul", x, y, &z, prec, &product, times);
    double slack = ldexp(mx * my + my, (int)(prec < 64 ? -62 : 2 - prec));
    ball_set(&w, y), ball_addmul(&w, x, y, prec);
    add(&exact.low, &yr->low, &product.low), add(&exact.high, &yr->high, &product.high);
    expect("addmul", x, y, &w, prec, &exact, ry + times + slack);
    ball_set(&w, y), ball_submul(&w, x, y, prec);
    negate(&t[0], &product.high), add(&exact.low, &yr->low, &t[0]);
    negate(&t[0], &product.low), add(&exact.high, &yr->high, &t[0]);
    expect("submul", x, y, &w, prec, &exact, ry + times + slack);
    ball_add_error(&z, x, y, prec);
    negate(&t[0], &yr->low), assign(&t[1], &yr->high), keep_greater(&t[1], &t[0]); /* max |y| */
    add(&exact.high, &xr->high, &t[1]);
    negate(&t[2], &t[1]), add(&exact.low, &xr->low, &t[2]);
    expect("add_error", x, y, &z, prec, &exact, sum + my);
    check_quotient(x, xr, y, yr, prec);
    check_sets(x, xr, y, yr, prec);
}

static void check_all_pairs(const char *name, void (*make)(void), long prec, bool questions)
{
    test_begin(name);
    make();
    for (int i = 0; i < members && !test_failed(); i++)
        for (int j = 0; j < others && !test_failed(); j++) {
            check_pair(&family[i], &family_range[i], &other[j], &other_range[j], prec);
            if (questions)
                check_questions(&family[i], &family_range[i], &other[j], &other_range[j]);
        }
    drop_families();
    test_end();
}

/* ---- unary operations ---- */

static truth positive(const range *r)
{
    return sign_of(&r->low) > 0 ? TRUTH_TRUE : sign_of(&r->high) <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}
static truth negative(const range *r)
{
    return sign_of(&r->high) < 0 ? TRUTH_TRUE : sign_of(&r->low) >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

static void check_signs(const ball *x, const range *r)
{
    bool zero = sign_of(&r->low) <= 0 && sign_of(&r->high) >= 0;
    if (ball_is_positive(x) != positive(r) || ball_is_negative(x) != negative(r))
        report("is_positive or is_negative", x, NULL, x, 0, "wrong");
    if (ball_contains_zero(x) != zero
        || ball_is_zero(x) != (!zero ? TRUTH_FALSE : compare(&r->low, &r->high) == 0 ? TRUTH_TRUE : TRUTH_UNKNOWN))
        report("contains_zero or is_zero", x, NULL, x, 0, "wrong");
    if (!ball_is_finite(x) || ball_is_thin(x) != (compare(&r->low, &r->high) == 0) || ball_lacks_memory(x))
        report("is_finite, is_thin or lacks_memory", x, NULL, x, 0, "wrong");
}

/* [0, |x|] folds: the exact range of |x|, and of x^2 by multiply. */
static void absolute(range *z, const range *x)
{
    negate(&t[0], &x->low);
    if (sign_of(&x->low) >= 0)
        assign(&z->low, &x->low), assign(&z->high, &x->high);
    else {
        assign(&z->high, &t[0]);
        if (sign_of(&x->high) <= 0)
            negate(&z->low, &x->high);
        else {
            integer_zero(&z->low.m);
            keep_greater(&z->high, &x->high);
        }
    }
}

static void check_root(const ball *x, const range *r, long prec)
{
    static ball z;
    static range zr;
    ball_sqrt(&z, x, prec);
    if (sign_of(&r->low) < 0) {
        if (ball_is_finite(&z))
            report("sqrt", x, NULL, &z, prec, "of negative numbers is finite");
        return;
    }
    if (!range_of(&zr, &z)) {
        report("sqrt", x, NULL, &z, prec, "not finite");
        return;
    }
    multiply(&t[0], &zr.low, &zr.low), multiply(&t[1], &zr.high, &zr.high);
    if ((sign_of(&zr.low) > 0 && compare(&t[0], &r->low) > 0) || sign_of(&zr.high) < 0 || compare(&t[1], &r->high) < 0)
        report("sqrt", x, NULL, &z, prec, "does not contain the root");
    double m = mid_approx(x), e = radius_approx(x), root = sqrt(m);
    double formula = m > 300 * e ? e * 0.67 / root : m > 0 ? e / root : 0;
    if (radius_approx(&z) > formula * (1 + 0x1p-18) + rounding(&z, prec))
        report("sqrt", x, NULL, &z, prec, "too wide");
}

/* v = floor or ceil(x 2^g): v 2^-g <= x < (v + 1) 2^-g, mirrored for ceilings. */
static void check_rounding(const ball *x, const range *r, long g)
{
    static integer v;
    static dyadic_number a;
    static const dyadic_number half = {{1, 0, {{1, 0}}}, -1};
    MUST(ball_lower_grid(&v, x, g));
    MUST(integer_set(&a.m, &v)), a.e = -g;
    bool ok = compare(&a, &r->low) <= 0;
    MUST(integer_add_si(&a.m, &v, 1));
    ok = ok && compare(&a, &r->low) > 0;
    MUST(ball_upper_grid(&v, x, g));
    MUST(integer_set(&a.m, &v));
    ok = ok && compare(&a, &r->high) >= 0;
    MUST(integer_add_si(&a.m, &v, -1));
    ok = ok && compare(&a, &r->high) < 0;
    if (!ok)
        report("lower_grid or upper_grid", x, NULL, x, g, "wrong");
    MUST(ball_mid_grid(&v, x, g)); /* |2 v - m 2^g 2| <= 1 */
    MUST(integer_set(&a.m, &v)), a.e = 0;
    add(&t[0], &r->low, &r->high), t[0].e += g - 1;
    negate(&a, &a), add(&t[1], &t[0], &a);
    MUST(integer_abs(&t[1].m, &t[1].m));
    if (compare(&t[1], &half) > 0)
        report("mid_grid", x, NULL, x, g, "wrong");
}

/* The doubles next to the endpoints, outward. */
static void check_doubles(const ball *x, const range *r)
{
    static rational q, v;
    double low = ball_lower_bound(x), high = ball_upper_bound(x);
    bool ok = true;
    MUST(rational_set_integer_2exp(&q, &r->low.m, r->low.e));
    MUST(rational_set_double(&v, low));
    ok = ok && rational_cmp(&v, &q) <= 0;
    MUST(rational_set_double(&v, nextafter(low, HUGE_VAL)));
    ok = ok && rational_cmp(&v, &q) > 0;
    MUST(rational_set_integer_2exp(&q, &r->high.m, r->high.e));
    MUST(rational_set_double(&v, high));
    ok = ok && rational_cmp(&v, &q) >= 0;
    MUST(rational_set_double(&v, nextafter(high, -HUGE_VAL)));
    ok = ok && rational_cmp(&v, &q) < 0;
    if (!ok)
        report("lower_bound or upper_bound", x, NULL, x, 0, "wrong");
    if (!ball_contains_rational(x, &q))
        report("contains_rational", x, NULL, x, 0, "wrong");
    MUST(rational_set_si(&v, 1, 3));
    MUST(rational_add(&q, &q, &v));
    if (ball_contains_rational(x, &q))
        report("contains_rational", x, NULL, x, 0, "wrong outside");
}

static void check_thin(const char *name, const ball *x, const ball *z, long prec)
{
    if (!ball_is_thin(z))
        report(name, x, NULL, z, prec, "not thin");
}

static void check_ends(const ball *x, const range *r, long prec)
{
    static ball z, c;
    static range zr, cr;
    ball_lower(&z, x, prec), check_thin("lower", x, &z, prec);
    if (!range_of(&zr, &z) || compare(&zr.low, &r->low) > 0)
        report("lower", x, NULL, &z, prec, "above");
    ball_upper(&z, x, prec), check_thin("upper", x, &z, prec);
    if (!range_of(&zr, &z) || compare(&zr.low, &r->high) < 0)
        report("upper", x, NULL, &z, prec, "below");
    ball_magnitude_upper(&z, x, prec), check_thin("magnitude_upper", x, &z, prec);
    absolute(&exact, r);
    if (!range_of(&zr, &z) || compare(&zr.low, &exact.high) < 0)
        report("magnitude_upper", x, NULL, &z, prec, "too small");
    ball_midpoint(&c, x, prec), check_thin("midpoint", x, &c, prec);
    ball_radius_upper(&z, x, prec), check_thin("radius_upper", x, &z, prec);
    MUST(range_of(&cr, &c));
    MUST(range_of(&zr, &z));
    negate(&t[0], &zr.low), add(&t[1], &cr.low, &t[0]), add(&t[2], &cr.low, &zr.low);
    if (compare(&t[1], &r->low) > 0 || compare(&t[2], &r->high) < 0)
        report("radius_upper", x, NULL, &z, prec, "too small");
}

static void check_unary(const ball *x, const range *r, long prec)
{
    static ball z, w;
    static range v, one;
    double rx = radius_approx(x), mx = mid_approx(x);
    check_signs(x, r);
    check_doubles(x, r);
    check_ends(x, r, prec);
    check_root(x, r, prec);
    ball_neg(&z, x);
    negate(&exact.low, &r->high), negate(&exact.high, &r->low);
    expect("neg", x, NULL, &z, 10000, &exact, rx);
    ball_set_round(&z, x, prec);
    expect("set_round", x, NULL, &z, prec, r, rx);
    ball_abs(&z, x);
    absolute(&v, r);
    if (ball_is_negative(&z) != TRUTH_FALSE)
        report("abs", x, NULL, &z, prec, "may be negative");
    expect("abs", x, NULL, &z, prec, &v, rx);
    ball_sqr(&z, x, prec);
    multiply(&exact.low, &v.low, &v.low), multiply(&exact.high, &v.high, &v.high);
    if (ball_contains_zero(x) && ball_is_negative(&z) != TRUTH_FALSE)
        report("sqr", x, NULL, &z, prec, "may be negative");
    expect("sqr", x, NULL, &z, prec, &exact, 2 * mx * rx + rx * rx);
    ball_pow_ui(&z, x, 3, prec + 64);
    multiply(&exact.low, &r->low, &r->low), multiply(&exact.low, &exact.low, &r->low);
    multiply(&exact.high, &r->high, &r->high), multiply(&exact.high, &exact.high, &r->high);
    expect("pow_ui 3", x, NULL, &z, prec, &exact, 4 * (3 * mx * mx * rx + 3 * mx * rx * rx + rx * rx * rx));
    for (long e = -3; e <= 3; e += 3) {
        ball_mul_2exp(&z, x, e, prec);
        assign(&exact.low, &r->low), assign(&exact.high, &r->high);
        exact.low.e += e, exact.high.e += e;
        expect("mul_2exp", x, NULL, &z, prec, &exact, ldexp(rx, (int)e));
    }
    ball_set_si(&w, 1, prec);
    MUST(range_of(&one, &w));
    check_quotient(&w, &one, x, r, prec);
    ball_inv(&z, x, prec), ball_div(&w, &w, x, prec);
    if (!ball_identical(&z, &w))
        report("inv", x, NULL, &z, prec, "is not 1 / x");
    for (long s = -3; s <= 7; s++) {
        ball_set_si(&w, s, prec), ball_mul(&w, x, &w, prec), ball_mul_si(&z, x, s, prec);
        if (!ball_identical(&z, &w))
            report("mul_si", x, NULL, &z, prec, "is not the product");
        ball_set_si(&w, s, prec), ball_div(&w, x, &w, prec), ball_div_si(&z, x, s, prec);
        if (!ball_identical(&z, &w))
            report("div_si", x, NULL, &z, prec, "is not the quotient");
    }
    for (long g = -66; g <= 66; g += 2 + (g < -2) + (g > 2))
        check_rounding(x, r, g);
    char *text = ball_get_hex(x);
    if (ball_set_hex(&z, text, strlen(text)) != RATIONAL_TEXT_OK || !ball_identical(&z, x))
        report("set_hex(get_hex)", x, NULL, &z, prec, "another ball");
    free(text);
    text = ball_get_decimal(x, 20);
    if (ball_set_str(&z, text, strlen(text), 400) != RATIONAL_TEXT_OK || !ball_contains(&z, x))
        report("set_str(get_decimal)", x, NULL, &z, prec, "lost something");
    free(text);
}

static void check_all(const char *name, void (*make)(void), long prec)
{
    test_begin(name);
    make();
    for (int i = 0; i < members && !test_failed(); i++)
        check_unary(&family[i], &family_range[i], prec);
    for (int i = 0; i < others && !test_failed(); i++)
        check_unary(&other[i], &other_range[i], prec);
    drop_families();
    test_end();
}

int main(void)
{
    check_all("exhaustive-ball-short-unary", make_short, 64);
    check_all("exhaustive-ball-long-unary", make_long, 128);
    check_all_pairs("exhaustive-ball-short-64", make_short, 64, true);
    check_all_pairs("exhaustive-ball-short-128", make_short, 128, false);
    check_all_pairs("exhaustive-ball-long-64", make_long, 64, true);
    check_all_pairs("exhaustive-ball-long-128", make_long, 128, false);
    return test_status();
}
