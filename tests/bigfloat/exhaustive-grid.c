/* exhaustive-grid.c: all pairs of small grid intervals on small grids, and pairs whose endpoints lie where the
   length of an integer changes: every result is the one interval that grid.h promises, computed here anew. */
#include "bigfloat/grid.h"
#include "random.h"

/* ---- small intervals, in machine words ---- */

typedef struct {
    int64_t low, high; /* units of 2^-g */
    bool finite;
} small;

#define NOTHING ((small){0, 0, false})

static int64_t floor_div(int64_t a, int64_t b) /* b > 0 */
{
    return a / b - (a % b < 0);
}
static int64_t ceil_div(int64_t a, int64_t b) { return -floor_div(-a, b); }

/* The least interval of units 2^-g around [low, high] 2^-h. */
static small outward(int64_t low, int64_t high, long h, long g)
{
    if (g >= h)
        return (small){low * ((int64_t)1 << (g - h)), high * ((int64_t)1 << (g - h)), true};
    return (small){floor_div(low, (int64_t)1 << (h - g)), ceil_div(high, (int64_t)1 << (h - g)), true};
}

static bool same(const grid *z, small s, long g)
{
    if (!s.finite)
        return !grid_is_finite(z) && !grid_lacks_memory(z);
    return grid_is_finite(z) && z->exponent == g && integer_cmp_si(&z->lower, s.low) == 0 && integer_cmp_si(&z->upper, s.high) == 0;
}

static int64_t min(int64_t a, int64_t b) { return a < b ? a : b; }
static int64_t max(int64_t a, int64_t b) { return a > b ? a : b; }

static small product(small x, small y, long g)
{
    int64_t p = x.low * y.low, q = x.low * y.high, r = x.high * y.low, s = x.high * y.high;
    return outward(min(min(p, q), min(r, s)), max(max(p, q), max(r, s)), 2 * g, g);
}

/* The least and greatest of four fractions p[i] / q[i], q > 0, rounded. */
static small quotient(small x, small y, long g)
{
    if (y.low <= 0 && y.high >= 0)
        return NOTHING;
    /* on a coarse grid divide by y 2^-g */
    int64_t up = g > 0 ? (int64_t)1 << g : 1, down = g < 0 ? (int64_t)1 << -g : 1;
    small z = {INT64_MAX, INT64_MIN, true};
    for (int i = 0; i < 4; i++) {
        int64_t a = (i & 1 ? x.high : x.low) * up, b = (i & 2 ? y.high : y.low) * down;
        if (b < 0)
            a = -a, b = -b;
        z.low = min(z.low, floor_div(a, b));
        z.high = max(z.high, ceil_div(a, b));
    }
    return z;
}

static int64_t root_floor(int64_t a)
{
    int64_t r = 0;
    while ((r + 1) * (r + 1) <= a)
        r++;
    return r;
}

static small root(small x, long g)
{
    if (x.low < 0)
        return NOTHING;
    /* sqrt(x 2^-g) in units of 2^-g is sqrt(x 2^g) */
    small t = outward(x.low, x.high, 0, g); /* floor(sqrt(floor(t))) = floor(sqrt(t)) */
    int64_t r = root_floor(t.high);
    return (small){root_floor(t.low), r + (r * r < t.high), true};
}

typedef struct {
    grid z;
    int64_t low, high;
    long h;
} member;

static member family[2000];
static int members;

static void make_family(int64_t least, int64_t most, long from, long to)
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    members = 0;
    for (long h = from; h <= to; h++)
        for (int64_t low = least; low <= most; low++)
            for (int64_t high = low; high <= most; high++) {
                member *m = &family[members++];
                grid_init(&m->z);
                integer_set_si(&a, low);
                integer_set_si(&b, high);
                grid_set_endpoints(&m->z, &a, &b, h);
                m->low = low;
                m->high = high;
                m->h = h;
            }
}

static void wrong(const char *name, const member *x, const member *y, long g)
{
    CHECK(false, "%s of [%d, %d] 2^-%ld and [%d, %d] 2^-%ld on grid %ld", name, (int)x->low, (int)x->high, x->h,
          (int)y->low, (int)y->high, y->h, g);
}

/* a 2^-g <= b 2^-h? with small exponents */
static int order(int64_t a, long g, int64_t b, long h)
{
    int64_t u = a * ((int64_t)1 << (8 - g)), v = b * ((int64_t)1 << (8 - h));
    return u < v ? -1 : u > v;
}

static void check_questions(const member *x, const member *y)
{
    bool less = order(x->high, x->h, y->low, y->h) < 0, not_less = order(x->low, x->h, y->high, y->h) >= 0;
    int low = order(x->low, x->h, y->low, y->h), high = order(y->high, y->h, x->high, x->h);
    if (grid_less(&x->z, &y->z) != (less ? TRUTH_TRUE : not_less ? TRUTH_FALSE : TRUTH_UNKNOWN))
        wrong("less", x, y, 0);
    if (grid_contains(&x->z, &y->z) != (low <= 0 && high <= 0))
        wrong("contains", x, y, 0);
    if (grid_contains_interior(&x->z, &y->z) != (low < 0 && high < 0))
        wrong("contains_interior", x, y, 0);
}

static void check_pair(const member *x, const member *y, long g)
{
    static grid z;
    small a = outward(x->low, x->high, x->h, g), b = outward(y->low, y->high, y->h, g), p = product(a, b, g);
#define EXPECT(name, ...)             \
    if (!same(&z, __VA_ARGS__, g))    \
        wrong(name, x, y, g)
    grid_add(&z, &x->z, &y->z, g);
    EXPECT("add", (small){a.low + b.low, a.high + b.high, true});
    grid_sub(&z, &x->z, &y->z, g);
    EXPECT("sub", (small){a.low - b.high, a.high - b.low, true});
    grid_mul(&z, &x->z, &y->z, g);
    EXPECT("mul", p);
    grid_div(&z, &x->z, &y->z, g);
    EXPECT("div", quotient(a, b, g));
    grid_set(&z, &x->z), grid_addmul(&z, &x->z, &y->z, g);
    EXPECT("addmul", (small){a.low + p.low, a.high + p.high, true});
    grid_set(&z, &x->z), grid_submul(&z, &x->z, &y->z, g);
    EXPECT("submul", (small){a.low - p.high, a.high - p.low, true});
    grid_hull(&z, &x->z, &y->z, g);
    EXPECT("hull", (small){min(a.low, b.low), max(a.high, b.high), true});
    grid_min(&z, &x->z, &y->z, g);
    EXPECT("min", (small){min(a.low, b.low), min(a.high, b.high), true});
    grid_max(&z, &x->z, &y->z, g);
    EXPECT("max", (small){max(a.low, b.low), max(a.high, b.high), true});
    grid_intersection(&z, &x->z, &y->z, g);
    EXPECT("intersection", (small){max(a.low, b.low), min(a.high, b.high), max(a.low, b.low) <= min(a.high, b.high)});
    int64_t r = max(-b.low, b.high);
    grid_add_error(&z, &x->z, &y->z, g);
    EXPECT("add_error", (small){a.low - r, a.high + r, true});
}

static truth positive(const member *x) { return x->low > 0 ? TRUTH_TRUE : x->high <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN; }
static truth negative(const member *x) { return x->high < 0 ? TRUTH_TRUE : x->low >= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN; }

static void check_signs(const member *x)
{
    bool zero = x->low <= 0 && x->high >= 0;
    if (grid_is_positive(&x->z) != positive(x) || grid_is_negative(&x->z) != negative(x) || grid_contains_zero(&x->z) != zero
        || grid_is_zero(&x->z) != (!zero ? TRUTH_FALSE : x->low == x->high ? TRUTH_TRUE : TRUTH_UNKNOWN)
        || grid_is_thin(&x->z) != (x->low == x->high) || !grid_is_finite(&x->z))
        wrong("signs", x, x, 0);
    double scale = 1;
    for (long h = x->h; h > 0; h--)
        scale /= 2;
    for (long h = x->h; h < 0; h++)
        scale *= 2;
    if (grid_lower_bound(&x->z) != (double)x->low * scale || grid_upper_bound(&x->z) != (double)x->high * scale)
        wrong("lower_bound or upper_bound", x, x, 0);
}

static void check_unary(const member *x, long g)
{
    static grid z;
    static integer low, high, middle;
    static rational q;
    static ball t;
    const member *y = x;
    small a = outward(x->low, x->high, x->h, g);
    small folded = a.low >= 0 ? a : a.high <= 0 ? (small){-a.high, -a.low, true} : (small){0, max(-a.low, a.high), true};
    grid_set_round(&z, &x->z, g);
    EXPECT("set_round", a);
    grid_neg(&z, &z);
    EXPECT("neg", (small){-a.high, -a.low, true});
    grid_set_round(&z, &x->z, g), grid_abs(&z, &z);
    EXPECT("abs", folded);
    grid_set_round(&z, &x->z, g), grid_sqr(&z, &z, g);
    EXPECT("sqr", product(folded, folded, g));
    grid_sqr(&z, &x->z, g); /* the move comes first */
    EXPECT("sqr after a move", product(folded, folded, g));
    grid_sqrt(&z, &x->z, g);
    EXPECT("sqrt", root(a, g));
    /* 1 / (m 2^-g) in units of 2^-g is 2^2g / m */
    grid_inv(&z, &x->z, g);
    EXPECT("inv", quotient((small){1, 1, true}, a, 2 * g));
    for (long v = -3; v <= 3; v++) {
        grid_mul_si(&z, &x->z, v, g);
        EXPECT("mul_si", (small){min(a.low * v, a.high * v), max(a.low * v, a.high * v), true});
        grid_div_si(&z, &x->z, v, g);
        EXPECT("div_si", quotient(a, (small){v, v, true}, 0));
        grid_mul_2exp(&z, &x->z, v, g);
        EXPECT("mul_2exp", outward(x->low, x->high, x->h - v, g)); /* exact, then moved */
        grid_set_si(&z, v, g);
        EXPECT("set_si", outward(v, v, 0, g));
    }
    grid_lower(&z, &x->z, g);
    EXPECT("lower", (small){a.low, a.low, true});
    grid_upper(&z, &x->z, g);
    EXPECT("upper", (small){a.high, a.high, true});
    int64_t m = floor_div(a.low + a.high, 2), far = max(-a.low, a.high);
    grid_midpoint(&z, &x->z, g);
    EXPECT("midpoint", (small){m, m, true});
    grid_radius_upper(&z, &x->z, g);
    EXPECT("radius_upper", (small){a.high - m, a.high - m, true});
    grid_magnitude_upper(&z, &x->z, g);
    EXPECT("magnitude_upper", (small){far, far, true});
    MUST(grid_lower_grid(&low, &x->z, g));
    MUST(grid_upper_grid(&high, &x->z, g));
    if (integer_cmp_si(&low, a.low) != 0 || integer_cmp_si(&high, a.high) != 0)
        wrong("lower_grid or upper_grid", x, x, g);
    MUST(grid_get_endpoints(&low, &high, &x->z, g));
    if (integer_cmp_si(&low, a.low) != 0 || integer_cmp_si(&high, a.high) != 0)
        wrong("get_endpoints", x, x, g);
    MUST(grid_mid_grid(&middle, &x->z, g)); /* within half a unit: |2 middle - (low + high) 2^(g - h)| <= 1 */
    int64_t twice = 2 * integer_get_si(&middle);
    if (order(twice - 1, g, x->low + x->high, x->h) > 0 || order(twice + 1, g, x->low + x->high, x->h) < 0)
        wrong("mid_grid", x, x, g);
    ball_set_grid(&t, &x->z, 64);
    grid_set_ball(&z, &t, g);
    EXPECT("set_ball(ball_set_grid)", a);
    for (int64_t p = -9; p <= 9; p++) {
        MUST(rational_set_si(&q, p, 3));
        grid_set_rational(&z, &q, g);
        small least = quotient((small){p, p, true}, (small){3, 3, true}, g);
        EXPECT("set_rational", least);
        /* p / 3 in [low, high] 2^-h */
        if (grid_contains_rational(&x->z, &q) != (order(3 * x->low, x->h, p, 0) <= 0 && order(p, 0, 3 * x->high, x->h) <= 0))
            wrong("contains_rational", x, x, g);
    }
}

static void check_small(void)
{
    test_begin("exhaustive-grid-small");
    make_family(-4, 4, -1, 3);
    for (int i = 0; i < members && !test_failed(); i++) {
        check_signs(&family[i]);
        for (long g = -1; g <= 3; g++)
            check_unary(&family[i], g);
        for (int j = 0; j < members && !test_failed(); j++) {
            check_questions(&family[i], &family[j]);
            for (long g = -1; g <= 3; g++)
                check_pair(&family[i], &family[j], g);
        }
    }
    for (int i = 0; i < members; i++)
        grid_clear(&family[i].z);
    test_end();
}

/* ---- endpoints where lengths change, in integers ---- */

#define CORNERS 19

static void make_corners(integer *c)
{
    static const struct { unsigned long k; int d; } corner[] = {{0, 0},   {62, 0},  {63, -1},  {63, 0},  {64, -1},
                                                                {64, 0},  {126, -1}, {126, 0}, {128, -1}};
    int n = 0;
    integer_init(&c[n]);
    n++; /* 0 */
    for (size_t i = 0; i < sizeof corner / sizeof *corner; i++)
        for (int sign = -1; sign <= 1; sign += 2) {
            integer_init(&c[n]);
            integer_set_si(&c[n], 1);
            MUST(integer_mul_2exp(&c[n], &c[n], corner[i].k));
            MUST(integer_add_si(&c[n], &c[n], corner[i].d));
            MUST(integer_mul_si(&c[n], &c[n], sign));
            n++;
        }
}

static bool equal(const grid *z, const integer *low, const integer *high, long g)
{
    return grid_is_finite(z) && z->exponent == g && integer_cmp(&z->lower, low) == 0 && integer_cmp(&z->upper, high) == 0;
}

static void check_corner_pair(const grid *x, const grid *y, long g)
{
    static grid z;
    static integer p[4], low, high, s, t;
    const integer *a[2] = {&x->lower, &x->upper}, *b[2] = {&y->lower, &y->upper};
    int least = 0, most = 0;
    for (int i = 0; i < 4; i++) {
        MUST(integer_mul(&p[i], a[i & 1], b[i >> 1]));
        least = integer_cmp(&p[i], &p[least]) < 0 ? i : least;
        most = integer_cmp(&p[i], &p[most]) > 0 ? i : most;
    }
    MUST(integer_fdiv_2exp(&low, &p[least], (unsigned long)g));
    MUST(integer_cdiv_2exp(&high, &p[most], (unsigned long)g));
    grid_mul(&z, x, y, g);
    CHECK(equal(&z, &low, &high, g), "mul on grid %ld", g);
    grid_set(&z, x), grid_addmul(&z, &z, y, g);
    MUST(integer_add(&s, &x->lower, &low));
    MUST(integer_add(&t, &x->upper, &high));
    CHECK(equal(&z, &s, &t, g), "addmul on grid %ld", g);
    grid_set(&z, x), grid_submul(&z, &z, y, g);
    MUST(integer_sub(&s, &x->lower, &high));
    MUST(integer_sub(&t, &x->upper, &low));
    CHECK(equal(&z, &s, &t, g), "submul on grid %ld", g);
    grid_add(&z, x, y, g);
    MUST(integer_add(&s, &x->lower, &y->lower));
    MUST(integer_add(&t, &x->upper, &y->upper));
    CHECK(equal(&z, &s, &t, g), "add on grid %ld", g);
    grid_sub(&z, x, y, g);
    MUST(integer_sub(&s, &x->lower, &y->upper));
    MUST(integer_sub(&t, &x->upper, &y->lower));
    CHECK(equal(&z, &s, &t, g), "sub on grid %ld", g);
}

static void check_corners(void)
{
    static const long grids[] = {0, 1, 63, 64, 65, 127, 128};
    integer c[CORNERS];
    static grid family_of_corners[CORNERS * CORNERS];
    int n = 0;
    test_begin("exhaustive-grid-corners");
    make_corners(c);
    for (size_t k = 0; k < sizeof grids / sizeof *grids; k++) {
        n = 0;
        for (int i = 0; i < CORNERS; i++)
            for (int j = 0; j < CORNERS; j++)
                if (integer_cmp(&c[i], &c[j]) <= 0)
                    grid_set_endpoints(&family_of_corners[n++], &c[i], &c[j], grids[k]);
        for (int i = 0; i < n && !test_failed(); i++)
            for (int j = 0; j < n && !test_failed(); j++)
                check_corner_pair(&family_of_corners[i], &family_of_corners[j], grids[k]);
    }
    for (int i = 0; i < n; i++)
        grid_clear(&family_of_corners[i]);
    for (int i = 0; i < CORNERS; i++)
        integer_clear(&c[i]);
    test_end();
}

int main(void)
{
    check_small();
    check_corners();
    return test_status();
}
