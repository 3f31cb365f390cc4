/* exhaustive-interval.c: hardware intervals with all endpoints from a set of extreme doubles.

   The least double at or above each sum, product and quotient of two of these doubles, and each root, is first
   found by exact rational arithmetic.  As every operation is then a maximum of such bounds, all pairs of intervals
   can be held against the very interval that is the best possible. */
#include <float.h>
#include <math.h>

#include "bigfloat/interval.h"
#include "bigfloat/interval_batch.h"
#include "random.h"

static const double magnitude[] = {
    0x1p-1074, 0x2p-1074, 0x3p-1074, DBL_MIN - 0x1p-1074, DBL_MIN, DBL_MIN + 0x1p-1074, 0x1.6a09e667f3bcdp-538, 0x1p-537,
    0x1p-512, 0x1.fffffffffffffp-54, 0.1, 0.5, 1 - DBL_EPSILON / 2, 1, 1 + DBL_EPSILON, 1.5, 2, 3, 0x1p53, 0x1.0000000000001p53,
    0x1p511, 0x1.6a09e667f3bccp511, 0x1p512, 0x1p1023, 0x1.ffffffffffffep1023, DBL_MAX,
};

enum { MAGNITUDES = sizeof magnitude / sizeof *magnitude, POINTS = 2 * MAGNITUDES + 3 };

/* In ascending order; -infinity first, 0 in the middle, +infinity last. */
static double point[POINTS];

/* Rounded up: u + v, u v, u / v; roots up and down. */
static double sum[POINTS][POINTS], times[POINTS][POINTS], ratio[POINTS][POINTS], root_up[POINTS], root_down[POINTS];

#define INFINITE(u) ((u) >= HUGE_VAL || (u) <= -HUGE_VAL)

/* v < q, = q, > q */
static int compare(double v, const rational *q)
{
    static rational t;
    if (INFINITE(v))
        return v > 0 ? 1 : -1;
    MUST(rational_set_double(&t, v));
    return rational_cmp(&t, q);
}

static double least_above(const rational *q)
{
    double v = rational_get_double_approx(q);
    while (compare(v, q) < 0)
        v = nextafter(v, HUGE_VAL);
    while (compare(nextafter(v, -HUGE_VAL), q) >= 0)
        v = nextafter(v, -HUGE_VAL);
    return v;
}

typedef bool (*rational_op)(rational *, const rational *, const rational *);

static double exactly(rational_op op, double u, double v)
{
    static rational p, q;
    MUST(rational_set_double(&p, u));
    MUST(rational_set_double(&q, v));
    MUST(op(&p, &p, &q));
    return least_above(&p);
}

/* The greatest double whose square is at most u, or the least whose square is at least u. */
static double exact_root(double u, bool up)
{
    static rational q, t;
    MUST(rational_set_double(&q, u));
    double v = sqrt(u);
    for (;;) { /* up: the square of the next one below must be less than u */
        double next = nextafter(v, up ? HUGE_VAL : 0);
        MUST(rational_set_double(&t, v));
        MUST(rational_mul(&t, &t, &t));
        if (up ? rational_cmp(&t, &q) >= 0 : rational_cmp(&t, &q) <= 0)
            break;
        v = next;
    }
    for (;;) {
        double next = nextafter(v, up ? 0 : HUGE_VAL);
        MUST(rational_set_double(&t, next));
        MUST(rational_mul(&t, &t, &t));
        if (up ? rational_cmp(&t, &q) < 0 : rational_cmp(&t, &q) > 0)
            break;
        v = next;
    }
    return v;
}

static void make_tables(void)
{
    for (int i = 0; i < MAGNITUDES; i++) {
        point[POINTS / 2 + 1 + i] = magnitude[i];
        point[POINTS / 2 - 1 - i] = -magnitude[i];
    }
    point[0] = -HUGE_VAL;
    point[POINTS - 1] = HUGE_VAL;
    for (int i = 0; i < POINTS; i++) {
        double u = point[i];
        for (int j = 0; j < POINTS; j++) {
            double v = point[j];
            bool infinite = INFINITE(u) || INFINITE(v);
            bool negative = (u < 0) != (v < 0);
            sum[i][j] = infinite ? (INFINITE(u) ? u : v) : exactly(rational_add, u, v);
            times[i][j] = infinite ? (u == 0 || v == 0 ? 0 : negative ? -HUGE_VAL : HUGE_VAL) : exactly(rational_mul, u, v);
            ratio[i][j] = v == 0 ? 0 : INFINITE(v) ? 0 : INFINITE(u) ? (negative ? -HUGE_VAL : HUGE_VAL)
                          : exactly(rational_div, u, v);
        }
        root_up[i] = u < 0 ? 0 : INFINITE(u) ? u : u == 0 ? 0 : exact_root(u, true);
        root_down[i] = u < 0 ? 0 : u == 0 ? 0 : INFINITE(u) ? u : exact_root(u, false);
    }
}

static int minus(int i) { return POINTS - 1 - i; }

/* ---- all intervals: the indices of the endpoints; not [+infinity] or [-infinity] alone ---- */

typedef struct {
    int low, high;
} ends;

static ends family[POINTS * POINTS];
static int members;

static void make_family(void)
{
    members = 0;
    for (int low = 0; low < POINTS - 1; low++)
        for (int high = low > 0 ? low : 1; high < POINTS; high++)
            family[members++] = (ends){low, high};
}

static interval interval_of(ends x) { return interval_make_(-point[x.low], point[x.high]); }

static void wrong(const char *name, ends x, ends y, const interval *z, double low, double high)
{
    CHECK(false, "%s of [%a, %a] and [%a, %a]: [%a, %a], not [%a, %a]", name, point[x.low], point[x.high], point[y.low],
          point[y.high], -z->neg_lower, z->upper, low, high);
}

/* -0 and 0 are the same number. */
static void expect(const char *name, ends x, ends y, const interval *z, double low, double high)
{
    if (-z->neg_lower != low || z->upper != high)
        wrong(name, x, y, z, low, high);
}

static double max4(double a, double b, double c, double d) { return fmax(fmax(a, b), fmax(c, d)); }

typedef double table[POINTS][POINTS];

/* The greatest table entry over the corners, and minus the greatest for -x: the least interval. */
static void corners(double *low, double *high, table t, ends x, ends y)
{
    *high = max4(t[x.low][y.low], t[x.low][y.high], t[x.high][y.low], t[x.high][y.high]);
    *low = -max4(t[minus(x.low)][y.low], t[minus(x.low)][y.high], t[minus(x.high)][y.low], t[minus(x.high)][y.high]);
}

static INTERVAL_NOINLINE void check_questions(ends a, ends b)
{
    interval x = interval_of(a), y = interval_of(b);
    /* Open ends: no number is infinite, so nothing is known beyond. */
    truth less = a.high < b.low ? TRUTH_TRUE : a.low >= b.high ? TRUTH_FALSE : TRUTH_UNKNOWN;
    if (interval_less(&x, &y) != less)
        wrong("less", a, b, &x, less, 0);
    if (interval_contains(&x, &y) != (a.low <= b.low && b.high <= a.high))
        wrong("contains", a, b, &x, 0, 0);
    bool inner = (a.low < b.low || a.low == 0) && (b.high < a.high || a.high == POINTS - 1);
    if (interval_contains_interior(&x, &y) != inner)
        wrong("contains_interior", a, b, &x, inner, 0);
}

static INTERVAL_NOINLINE void check_pair(ends a, ends b)
{
    interval x = interval_of(a), y = interval_of(b), z;
    double low, high, l, h;
    const int zero = POINTS / 2;
    interval_add(&z, &x, &y, 0);
    expect("add", a, b, &z, -sum[minus(a.low)][minus(b.low)], sum[a.high][b.high]);
    interval_sub(&z, &x, &y, 0);
    expect("sub", a, b, &z, -sum[minus(a.low)][b.high], sum[a.high][minus(b.low)]);
    corners(&low, &high, times, a, b);
    interval_mul(&z, &x, &y, 0);
    expect("mul", a, b, &z, low, high);
    z = x, interval_addmul(&z, &x, &y, 0);
    interval t = interval_make_(-low, high), s;
    interval_add(&s, &x, &t, 0);
    expect("addmul", a, b, &z, -s.neg_lower, s.upper);
    z = x, interval_submul(&z, &x, &y, 0);
    interval_sub(&s, &x, &t, 0);
    expect("submul", a, b, &z, -s.neg_lower, s.upper);
    interval_div(&z, &x, &y, 0);
    if (b.low <= zero && zero <= b.high)
        expect("div", a, b, &z, -HUGE_VAL, HUGE_VAL);
    else {
        corners(&l, &h, ratio, a, b);
        expect("div", a, b, &z, l, h);
    }
    interval_hull(&z, &x, &y, 0);
    expect("hull", a, b, &z, fmin(point[a.low], point[b.low]), fmax(point[a.high], point[b.high]));
    interval_min(&z, &x, &y, 0);
    expect("min", a, b, &z, fmin(point[a.low], point[b.low]), fmin(point[a.high], point[b.high]));
    interval_max(&z, &x, &y, 0);
    expect("max", a, b, &z, fmax(point[a.low], point[b.low]), fmax(point[a.high], point[b.high]));
    interval_intersection(&z, &x, &y, 0);
    l = fmax(point[a.low], point[b.low]), h = fmin(point[a.high], point[b.high]);
    if (l <= h)
        expect("intersection", a, b, &z, l, h);
    else if (!(z.neg_lower > -HUGE_VAL && z.upper > -HUGE_VAL && -z.neg_lower <= z.upper))
        wrong("intersection", a, b, &z, l, h); /* any set will do, but it must be one */
    int far = minus(b.low) > b.high ? minus(b.low) : b.high;
    interval_add_error(&z, &x, &y, 0);
    expect("add_error", a, b, &z, -sum[minus(a.low)][far], sum[a.high][far]);
}

static truth positive(ends x) { return x.low > POINTS / 2 ? TRUTH_TRUE : x.high <= POINTS / 2 ? TRUTH_FALSE : TRUTH_UNKNOWN; }
static truth negative(ends x) { return x.high < POINTS / 2 ? TRUTH_TRUE : x.low >= POINTS / 2 ? TRUTH_FALSE : TRUTH_UNKNOWN; }

static void expect_thin(const char *name, ends x, const interval *z, double v)
{
    expect(name, x, x, z, INFINITE(v) ? -HUGE_VAL : v, INFINITE(v) ? HUGE_VAL : v);
}

static INTERVAL_NOINLINE void check_unary(ends a)
{
    const int zero = POINTS / 2;
    interval x = interval_of(a), z, m;
    double low = point[a.low], high = point[a.high];
    bool contains_zero = a.low <= zero && zero <= a.high, finite = a.low > 0 && a.high < POINTS - 1;
    if (interval_is_positive(&x) != positive(a) || interval_is_negative(&x) != negative(a)
        || interval_contains_zero(&x) != contains_zero || interval_is_finite(&x) != finite
        || interval_is_thin(&x) != (a.low == a.high) || interval_lacks_memory(&x)
        || interval_is_zero(&x) != (!contains_zero ? TRUTH_FALSE : a.low == a.high ? TRUTH_TRUE : TRUTH_UNKNOWN))
        wrong("signs", a, a, &x, 0, 0);
    interval_neg(&z, &x);
    expect("neg", a, a, &z, -high, -low);
    int near = contains_zero ? zero : a.low > zero ? a.low : minus(a.high), far = minus(a.low) > a.high ? minus(a.low) : a.high;
    interval_abs(&z, &x);
    expect("abs", a, a, &z, point[near], point[far]);
    interval_sqr(&z, &x, 0);
    expect("sqr", a, a, &z, -times[minus(near)][near], times[far][far]);
    interval_inv(&z, &x, 0);
    int one = zero + 1;
    while (point[one] < 1)
        one++;
    if (contains_zero)
        expect("inv", a, a, &z, -HUGE_VAL, HUGE_VAL);
    else
        expect("inv", a, a, &z, -ratio[minus(one)][a.high], ratio[one][a.low]);
    interval_sqrt(&z, &x, 0);
    if (a.low < zero)
        expect("sqrt", a, a, &z, -HUGE_VAL, HUGE_VAL);
    else
        expect("sqrt", a, a, &z, root_down[a.low], root_up[a.high]);
    interval_lower(&z, &x, 0), expect_thin("lower", a, &z, low);
    interval_upper(&z, &x, 0), expect_thin("upper", a, &z, high);
    interval_magnitude_upper(&z, &x, 0), expect_thin("magnitude_upper", a, &z, point[far]);
    interval_midpoint(&m, &x, 0);
    interval_radius_upper(&z, &x, 0);
    if (!finite) {
        expect_thin("midpoint", a, &m, HUGE_VAL);
        expect_thin("radius_upper", a, &z, HUGE_VAL);
    } else if (!(-m.neg_lower == m.upper && m.upper >= low && m.upper <= high) && a.low != a.high
               && high - low > 0x1p-1073) /* among subnormals the halves may be rounded */
        wrong("midpoint", a, a, &m, low, high);
}

/* ---- batches: the same doubles as one at a time, the sign of 0 excepted ---- */

static interval all[POINTS * POINTS], row[POINTS * POINTS], batch[POINTS * POINTS], single[POINTS * POINTS];

typedef void (*batch_operation)(interval *, const interval *, const interval *, size_t);
typedef void (*operation)(interval *, const interval *, const interval *, long);

/* These are called in regions only. */
static INTERVAL_NOINLINE void add_one(interval *z, const interval *x, const interval *y, long prec) { interval_add(z, x, y, prec); }
static INTERVAL_NOINLINE void sub_one(interval *z, const interval *x, const interval *y, long prec) { interval_sub(z, x, y, prec); }
static INTERVAL_NOINLINE void mul_one(interval *z, const interval *x, const interval *y, long prec) { interval_mul(z, x, y, prec); }
static INTERVAL_NOINLINE void addmul_one(interval *z, const interval *x, const interval *y, long prec)
{
    interval_addmul(z, x, y, prec);
}

static INTERVAL_NOINLINE void one_by_one(operation op)
{
    for (int j = 0; j < members; j++)
        op(&single[j], &row[j], &all[j], 0);
}

static void check_batch(const char *name, batch_operation op, operation one, int i)
{
    interval_mode mode = interval_enter();
    one_by_one(one);
    interval_leave(mode);
    op(batch, row, all, (size_t)members);
    for (int j = 0; j < members; j++)
        if (batch[j].neg_lower != single[j].neg_lower || batch[j].upper != single[j].upper)
            wrong(name, family[i], family[j], &batch[j], -single[j].neg_lower, single[j].upper);
}

static void restart(int i)
{
    for (int j = 0; j < members; j++)
        batch[j] = single[j] = interval_of(family[i]);
}

static void check_batches(int i)
{
    for (int j = 0; j < members; j++) {
        all[j] = interval_of(family[j]);
        row[j] = interval_of(family[i]);
    }
    check_batch("batch add", interval_batch_add, add_one, i);
    check_batch("batch sub", interval_batch_sub, sub_one, i);
    check_batch("batch mul", interval_batch_mul, mul_one, i);
    restart(i), check_batch("batch addmul", interval_batch_addmul, addmul_one, i);
    for (int j = 0; j < members; j++) { /* x times one interval: x and row change places */
        row[j] = all[j];
        all[j] = interval_of(family[i]);
    }
    check_batch("batch scale", interval_batch_scale, mul_one, i);
    restart(i), check_batch("batch axpy", interval_batch_axpy, addmul_one, i);
}

/* Exact: |t - c| <= r at both ends. */
static void check_radius(ends a)
{
    interval x = interval_of(a), m, r;
    static rational c, p, d;
    interval_mode mode = interval_enter();
    void (*volatile midpoint)(interval *, const interval *, long) = interval_midpoint;
    void (*volatile radius)(interval *, const interval *, long) = interval_radius_upper;
    midpoint(&m, &x, 0);
    radius(&r, &x, 0);
    interval_leave(mode);
    if (!interval_is_finite(&r))
        return;
    MUST(rational_set_double(&c, m.upper));
    for (int i = 0; i < 2; i++) {
        MUST(rational_set_double(&p, point[i ? a.high : a.low]));
        MUST(rational_sub(&d, &p, &c));
        MUST(rational_abs(&d, &d));
        if (compare(r.upper, &d) < 0)
            wrong("radius_upper", a, a, &r, 0, 0);
    }
}

/* ---- other conversions, outside of regions ---- */

static void check_conversions(ends a)
{
    static ball b;
    static rational q;
    static integer n;
    interval x = interval_of(a), z;
    for (int i = 0; i < POINTS; i++)
        if (!INFINITE(point[i])) {
            MUST(rational_set_double(&q, point[i]));
            if (interval_contains_rational(&x, &q) != (a.low <= i && i <= a.high))
                wrong("contains_rational", a, (ends){i, i}, &x, 0, 0);
        }
    ball_set_interval(&b, &x, 64);
    bool finite = interval_is_finite(&x);
    if (ball_is_finite(&b) != finite)
        wrong("ball_set_interval", a, a, &x, 0, 0);
    interval_set_ball(&z, &b, 0);
    if (!(z.neg_lower >= x.neg_lower && z.upper >= x.upper))
        wrong("ball_set_interval", a, a, &z, 0, 0);
    if (interval_lower_grid(&n, &x, 3) != (a.low > 0) || interval_upper_grid(&n, &x, 3) != (a.high < POINTS - 1)
        || interval_mid_grid(&n, &x, 3) != finite)
        wrong("lower_grid, mid_grid or upper_grid", a, a, &x, 0, 0);
}

static INTERVAL_NOINLINE void in_region(void (*check)(ends))
{
    for (int i = 0; i < members && !test_failed(); i++) {
        interval_mode mode = interval_enter();
        check(family[i]);
        interval_leave(mode);
    }
}

static INTERVAL_NOINLINE void pairs_in_region(void (*check)(ends, ends))
{
    for (int i = 0; i < members && !test_failed(); i++) {
        interval_mode mode = interval_enter();
        for (int j = 0; j < members; j++)
            check(family[i], family[j]);
        interval_leave(mode);
    }
}

int main(void)
{
    make_tables();
    make_family();
    test_begin("exhaustive-interval-unary");
    in_region(check_unary);
    for (int i = 0; i < members && !test_failed(); i++) {
        check_radius(family[i]);
        check_conversions(family[i]);
    }
    test_end();
    test_begin("exhaustive-interval-questions");
    pairs_in_region(check_questions);
    test_end();
    test_begin("exhaustive-interval-pairs");
    pairs_in_region(check_pair);
    test_end();
    test_begin("exhaustive-interval-batches");
    for (int i = 0; i < members && !test_failed(); i++)
        check_batches(i);
    test_end();
    return test_status();
}
