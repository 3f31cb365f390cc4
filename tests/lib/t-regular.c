/* t-regular.c: difference masks, norms, comparison constants and bounds of limits, against golden values and against
   nets that are subdivided here. */
#include "lib/decomposition.h"
#include "lib/power.h"
#include "lib/regular_refutation.h"
#include "lib/stability.h"

#include "tests/bigfloat/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- masks ---- */

typedef struct {
    lattice point;
    int numerator, denominator;
} entry;

/* z = the entries with their images under rotation by one sector and reflection. */
static void set_symmetric(laurent *z, mesh_kind mesh, const entry *e, int count)
{
    lattice point[100] = {{0, 0}};
    rational weight[100];
    size_t n = 0;
    for (int i = 0; i < 100; i++)
        rational_init(&weight[i]);
    for (int i = 0; i < count; i++)
        for (int image = 0; image < 2 * mesh_regular_valence(mesh); image++) {
            lattice p = image % 2 ? mesh_reflect_mask(e[i].point) : e[i].point;
            bool known = false;
            for (int turn = 0; turn < image / 2; turn++)
                p = mesh_rotate_mask(mesh, p);
            for (size_t j = 0; j < n; j++)
                known = known || (point[j].a == p.a && point[j].b == p.b);
            if (known)
                continue;
            MUST(rational_set_si(&weight[n], e[i].numerator, e[i].denominator));
            point[n++] = p;
        }
    MUST(laurent_set_terms(z, point, weight, n));
    for (int i = 0; i < 100; i++)
        rational_clear(&weight[i]);
}

/* The Butterfly mask with tension w = p/q. */
static void set_butterfly(laurent *z, int p, int q)
{
    entry e[4] = {{{0, 0}, 1, 1}, {{1, 0}, 1, 2}, {{1, 1}, 2, 1}, {{2, 1}, -1, 1}};
    e[2].numerator *= p;
    e[2].denominator = q;
    e[3].numerator *= p;
    e[3].denominator = q;
    set_symmetric(z, MESH_TRIANGLE, e, 4);
}

static void set_loop(laurent *z)
{
    static const entry e[4] = {{{0, 0}, 5, 8}, {{1, 0}, 3, 8}, {{1, 1}, 1, 8}, {{2, 0}, 1, 16}};
    set_symmetric(z, MESH_TRIANGLE, e, 4);
}

static void set_monomial(laurent *z, int p, int q)
{
    lattice origin = {0, 0};
    rational w;
    rational_init(&w);
    MUST(rational_set_si(&w, p, q));
    MUST(laurent_set_terms(z, &origin, &w, 1));
    rational_clear(&w);
}

/* z = z (1 + z^-d) */
static void times_factor(laurent *z, lattice d)
{
    lattice point[2] = {{0, 0}, {-d.a, -d.b}};
    rational one[2];
    laurent factor;
    laurent_init(&factor);
    for (int i = 0; i < 2; i++) {
        rational_init(&one[i]);
        MUST(rational_set_si(&one[i], 1, 1));
    }
    MUST(laurent_set_terms(&factor, point, one, 2));
    MUST(laurent_mul(z, z, &factor));
    for (int i = 0; i < 2; i++)
        rational_clear(&one[i]);
    laurent_clear(&factor);
}

/* z = p/q (1 + z^-e1)^n1 (1 + z^-e2)^n2 (1 + z^-e3)^n3 */
static void set_box_spline(laurent *z, int p, int q, int n1, int n2, int n3)
{
    int n[3] = {n1, n2, n3};
    set_monomial(z, p, q);
    for (int i = 0; i < 3; i++)
        while (n[i]-- > 0)
            times_factor(z, regular_direction[i]);
}

/* Midpoint subdivision of quads: tensor products of B-splines, in place (labels as in lib/mesh.h). */
static void set_midpoint(laurent *z, mesh_kind *mesh, int degree)
{
    int low = (degree + 2) / 2; /* powers of z^-1 reach from 0 to degree + 1 */
    set_box_spline(z, 1, 1 << 2 * degree, degree + 1, degree + 1, 0);
    z->a0 = z->b0 = -low;
    *mesh = degree % 2 ? MESH_QUAD : MESH_DUAL;
}

/* A random polynomial on n by n points, coefficients -most .. most over `denominator`. */
static void set_random(laurent *z, long n, long most, int64_t denominator)
{
    MUST(laurent_set_box(z, random_range(-5, 5), random_range(-5, 5), n, n));
    for (long i = 0; i < n * n; i++)
        integer_set_si(&z->coefficient[i], random_below(3) ? random_range(-most, most) : 0);
    if (integer_is_zero(&z->coefficient[0]))
        integer_set_si(&z->coefficient[0], 1);
    integer_set_si(&z->denominator, denominator);
}

/* ---- comparisons of numbers ---- */

static bool is_fraction(const rational *x, int64_t p, int64_t q)
{
    return rational_cmp_si(x, p, q) == 0;
}

static void check_norms(const laurent *s, const int64_t (*golden)[2], int count, bool half, const char *name)
{
    norm_list norms;
    norm_list_init(&norms);
    MUST(norm_list_make(&norms, s, count, false));
    CHECK(norms.count == count, "%s: only %d norms", name, norms.count);
    for (int n = 1; n <= norms.count; n++) {
        rational x;
        rational_init(&x);
        MUST(rational_mul_2exp(&x, &norms.norm[n], half ? -n : 0));
        CHECK(is_fraction(&x, golden[n - 1][0], golden[n - 1][1]), "%s: norm %d is near %.9g", name, n, rational_get_double_approx(&x));
        rational_clear(&x);
    }
    norm_list_clear(&norms);
}

/* ---- golden values ---- */

static void test_golden_butterfly(void)
{
    static const int64_t first[5][2] = {{7, 8}, {31, 64}, {261, 1024}, {2091, 16384}, {8441, 131072}};
    static const int64_t second[9][2] = {{1, 1}, {7, 8}, {11, 16}, {1, 2}, {11, 32}, {29, 128}, {37, 256}, {23, 256}, {7, 128}};
    static const int64_t values[4][2] = {{3, 2}, {3, 2}, {3, 2}, {24691, 16384}};
    laurent mask;
    regular_masks m;
    int power[3];
    rational norm[3];
    test_begin("golden norms of butterfly");
    laurent_init(&mask);
    regular_init(&m);
    for (int i = 0; i < 3; i++)
        rational_init(&norm[i]);
    set_butterfly(&mask, 1, 16);
    MUST(regular_derive(&m, &mask, MESH_TRIANGLE));
    CHECK(m.divisible && m.symmetric, "not divisible or not symmetric");
    for (int i = 0; i < 2; i++)
        check_norms(&m.derivative[i], first, 5, true, "a_i");
    for (int i = 0; i < 3; i++)
        check_norms(&m.second[i], second, 9, false, "2 a_ij");
    check_norms(&mask, values, 4, false, "a");
    MUST(regular_contraction(power, norm, &m));
    for (int i = 0; i < 3; i++)
        CHECK(power[i] == 2 && is_fraction(&norm[i], 7, 8), "pair %d: power %d", i, power[i]);
    laurent_clear(&mask);
    regular_clear(&m);
    for (int i = 0; i < 3; i++)
        rational_clear(&norm[i]);
    test_end();
}

/* All of these contract with 2^-N. */
static void check_halving(const laurent *mask, mesh_kind mesh, const char *name)
{
    static const int64_t halving[4][2] = {{1, 2}, {1, 4}, {1, 8}, {1, 16}};
    regular_masks m;
    regular_init(&m);
    MUST(regular_derive(&m, mask, mesh));
    CHECK(m.divisible && m.symmetric, "%s: not divisible or not symmetric", name);
    for (int i = 0; i < 2 && m.divisible; i++)
        check_norms(&m.derivative[i], halving, 4, true, name);
    for (int i = 0; i < 3 && m.divisible; i++)
        check_norms(&m.second[i], halving, 4, false, name);
    regular_clear(&m);
}

static void test_golden_splines(void)
{
    static const entry doo_sabin[3] = {{{0, 0}, 9, 16}, {{0, 1}, 3, 16}, {{1, 1}, 1, 16}};
    static const entry catmull_clark[6] = {{{0, 0}, 36, 64}, {{1, 0}, 24, 64}, {{2, 0}, 6, 64}, {{1, 1}, 16, 64}, {{2, 1}, 4, 64}, {{2, 2}, 1, 64}};
    laurent mask, other;
    mesh_kind mesh;
    test_begin("golden norms of splines");
    laurent_init(&mask);
    laurent_init(&other);
    set_loop(&mask);
    check_halving(&mask, MESH_TRIANGLE, "loop");
    for (int degree = 2; degree <= 5; degree++) {
        char name[32];
        snprintf(name, sizeof name, "midpoint %d", degree);
        set_midpoint(&mask, &mesh, degree);
        check_halving(&mask, mesh, name);
        if (degree > 3)
            continue;
        set_symmetric(&other, mesh, degree == 2 ? doo_sabin : catmull_clark, degree == 2 ? 3 : 6);
        for (long a = -5; a <= 5; a++)
            for (long b = -5; b <= 5; b++) {
                rational x, y;
                rational_init(&x), rational_init(&y);
                MUST(laurent_get(&x, &mask, a, b) && laurent_get(&y, &other, a, b));
                CHECK(rational_equal(&x, &y), "%s is not doo-sabin or catmull-clark at (%ld,%ld)", name, a, b);
                rational_clear(&x), rational_clear(&y);
            }
    }
    laurent_clear(&mask);
    laurent_clear(&other);
    test_end();
}

/* ---- schemes that are not C1, or about which the criterion must be silent ---- */

static int proved_pairs(bool *divisible, const laurent *mask, mesh_kind mesh)
{
    regular_masks m;
    int power[3], proved = 0;
    rational norm[3];
    regular_init(&m);
    for (int i = 0; i < 3; i++)
        rational_init(&norm[i]);
    MUST(regular_derive(&m, mask, mesh));
    *divisible = m.divisible;
    MUST(regular_contraction(power, norm, &m));
    for (int i = 0; i < 3; i++)
        proved |= (power[i] > 0) << i;
    for (int i = 0; i < 3; i++)
        rational_clear(&norm[i]);
    regular_clear(&m);
    return proved;
}

static void test_not_proved(void)
{
    static const entry perturbed[3] = {{{0, 0}, 9, 16}, {{0, 1}, 2, 16}, {{1, 1}, 3, 16}};
    bool divisible;
    int pairs;
    laurent mask;
    test_begin("no proof where there is none");
    laurent_init(&mask);
    set_box_spline(&mask, 1, 4, 2, 1, 1); /* {e1,e1,e2,e3}: passes the first two norms and is only C0 */
    pairs = proved_pairs(&divisible, &mask, MESH_TRIANGLE);
    CHECK(divisible && pairs == 3, "box spline {e1,e1,e2,e3}: pairs %d", pairs);
    set_box_spline(&mask, 1, 4, 1, 2, 1);
    pairs = proved_pairs(&divisible, &mask, MESH_TRIANGLE);
    CHECK(divisible && pairs == 5, "box spline {e1,e2,e2,e3}: pairs %d", pairs);
    set_box_spline(&mask, 1, 2, 1, 1, 1);
    pairs = proved_pairs(&divisible, &mask, MESH_TRIANGLE);
    CHECK(divisible && pairs == 0, "linear triangles: pairs %d", pairs);
    set_box_spline(&mask, 1, 4, 2, 2, 0);
    pairs = proved_pairs(&divisible, &mask, MESH_QUAD);
    CHECK(divisible && pairs == 2, "bilinear quads: pairs %d", pairs);
    set_box_spline(&mask, 1, 8, 2, 3, 0); /* linear in one direction, quadratic in the other */
    pairs = proved_pairs(&divisible, &mask, MESH_QUAD);
    CHECK(divisible && pairs == 6, "mixed degrees: pairs %d", pairs);
    set_symmetric(&mask, MESH_DUAL, perturbed, 3);
    pairs = proved_pairs(&divisible, &mask, MESH_DUAL);
    CHECK(!divisible && pairs == 0, "perturbed doo-sabin: pairs %d", pairs);
    set_butterfly(&mask, 1, 4);
    pairs = proved_pairs(&divisible, &mask, MESH_TRIANGLE);
    CHECK(divisible && pairs == 0, "butterfly with tension 1/4: pairs %d", pairs);
    laurent_clear(&mask);
    test_end();
}

/* ---- division ---- */

static void test_division(void)
{
    test_begin("difference masks of random products");
    for (test_cases(300); test_next();) {
        mesh_kind mesh = (mesh_kind)random_below(3);
        laurent q, a;
        regular_masks m;
        laurent_init(&q);
        laurent_init(&a);
        regular_init(&m);
        set_random(&q, random_range(1, 4), 20, random_range(1, 9));
        MUST(laurent_set(&a, &q));
        for (int i = 0; i < 3; i++)
            times_factor(&a, regular_direction[mesh == MESH_TRIANGLE ? i : i % 2]);
        if (mesh != MESH_TRIANGLE)
            times_factor(&a, regular_direction[1]);
        MUST(regular_derive(&m, &a, mesh));
        CHECK(m.divisible, "mesh %d: not divisible", (int)mesh);
        for (int i = 0; i < 3; i++) { /* 2 a_dd' (1 + z^-d) (1 + z^-d') = 2 a */
            regular_pair p = regular_get_directions(mesh, i);
            times_factor(&m.second[i], regular_direction[p.direction[0]]);
            times_factor(&m.second[i], regular_direction[p.direction[1]]);
            for (long x = -12; x <= 12; x++)
                for (long y = -12; y <= 12; y++) {
                    rational left, right;
                    rational_init(&left), rational_init(&right);
                    MUST(laurent_get(&left, &m.second[i], x, y) && laurent_get(&right, &a, x, y) && rational_mul_2exp(&right, &right, 1));
                    CHECK(rational_equal(&left, &right), "mesh %d, pair %d, (%ld,%ld)", (int)mesh, i, x, y);
                    rational_clear(&left), rational_clear(&right);
                }
        }
        MUST(integer_add_si(&a.coefficient[random_below((uint64_t)(a.na * a.nb))], &a.coefficient[0], 1000));
        MUST(regular_derive(&m, &a, mesh));
        CHECK(!m.divisible, "mesh %d: divisible although changed at one point", (int)mesh);
        laurent_clear(&q);
        laurent_clear(&a);
        regular_clear(&m);
    }
    test_end();
}

/* ---- norms against subdivision ---- */

enum { SIDE = 400 };

/* A net on 0 <= a, b < SIDE, 0 elsewhere. */
typedef struct {
    double at[SIDE][SIDE];
    int size; /* the corner that may be other than 0 */
} net;
static net nets[2];

/* Refines net 0 into net 0: whole numbers below 2^53 stay exact. */
static void subdivide(const laurent *s)
{
    int size = 2 * (nets[0].size - 1) + (int)(s->na > s->nb ? s->na : s->nb);
    for (int a = 0; a < size; a++)
        memset(nets[1].at[a], 0, (size_t)size * sizeof(double));
    for (int a = 0; a < nets[0].size; a++)
        for (int b = 0; b < nets[0].size; b++)
            for (int i = 0; nets[0].at[a][b] != 0 && i < s->na; i++)
                for (int j = 0; j < s->nb; j++)
                    nets[1].at[2 * a + i][2 * b + j] += nets[0].at[a][b] * integer_get_double_approx(&s->coefficient[i * s->nb + j]);
    nets[1].size = size;
    for (int a = 0; a < size; a++)
        memcpy(nets[0].at[a], nets[1].at[a], (size_t)size * sizeof(double));
    nets[0].size = size;
}

/* The norm of S^n times denominator^n from the subdivided delta. */
static double norm_by_delta(const laurent *s, int n)
{
    double largest = 0;
    nets[0].size = 1;
    nets[0].at[0][0] = 1;
    for (int i = 0; i < n; i++)
        subdivide(s);
    for (int a = 0; a < 1 << n; a++)
        for (int b = 0; b < 1 << n; b++) {
            double sum = 0;
            for (int i = a; i < nets[0].size; i += 1 << n)
                for (int j = b; j < nets[0].size; j += 1 << n)
                    sum += fabs(nets[0].at[i][j]);
            largest = sum > largest ? sum : largest;
        }
    return largest;
}

static void test_norms_by_delta(void)
{
    test_begin("norms against subdivided deltas");
    for (test_cases(60); test_next();) {
        laurent s;
        norm_list norms;
        int most = (int)random_range(1, 5);
        int64_t denominator = random_range(1, 12);
        laurent_init(&s);
        norm_list_init(&norms);
        set_random(&s, random_range(1, 7), 9, denominator);
        MUST(norm_list_make(&norms, &s, most, false));
        CHECK(norms.count == most, "only %d norms", norms.count);
        for (int n = 1; n <= norms.count; n++) {
            double expected = norm_by_delta(&s, n) / pow((double)denominator, n), found = rational_get_double_approx(&norms.norm[n]);
            CHECK(fabs(found - expected) <= 1e-9 * expected, "N = %d: %.17g, not %.17g", n, found, expected);
        }
        norm_list_clear(&norms);
        laurent_clear(&s);
    }
    test_end();
}

/* A factor c so large that words cannot hold s: |(c S)^N| = c^N |S^N|. */
static void test_long_norms(void)
{
    test_begin("norms beyond machine words");
    for (test_cases(30); test_next();) {
        laurent s, t;
        norm_list x, y;
        integer c;
        rational factor;
        laurent_init(&s), laurent_init(&t);
        norm_list_init(&x), norm_list_init(&y);
        integer_init(&c);
        rational_init(&factor);
        set_random(&s, random_range(1, 5), 9, random_range(1, 12));
        integer_set_si(&c, 1);
        MUST(integer_mul_2exp(&c, &c, (unsigned long)random_range(10, 200)));
        MUST(integer_add_si(&c, &c, 1) && laurent_set(&t, &s));
        for (long i = 0; i < t.na * t.nb; i++)
            MUST(integer_mul(&t.coefficient[i], &t.coefficient[i], &c));
        MUST(norm_list_make(&x, &s, 4, false) && norm_list_make(&y, &t, 4, false));
        CHECK(x.count == 4 && y.count == 4, "%d and %d norms", x.count, y.count);
        MUST(rational_set_integer_2exp(&factor, &c, 0));
        for (int n = 1; n <= 4; n++)
            for (int i = 0; i < n; i++)
                MUST(rational_mul(&x.norm[n], &x.norm[n], &factor));
        for (int n = 1; n <= 4; n++)
            CHECK(rational_equal(&x.norm[n], &y.norm[n]), "N = %d", n);
        laurent_clear(&s), laurent_clear(&t);
        norm_list_clear(&x), norm_list_clear(&y);
        integer_clear(&c);
        rational_clear(&factor);
    }
    test_end();
}

/* The largest sum over a row of |exact - rounded|, as numbers. */
static double rounding_error(const mask_power *exact, const mask_power *rounded)
{
    long n = 1L << exact->exponent;
    double largest = 0, x = integer_get_double_approx(&exact->total_denominator), y = integer_get_double_approx(&rounded->total_denominator);
    for (long a = 0; a < n; a++)
        for (long b = 0; b < n; b++) {
            double sum = 0;
            for (long i = a; i < exact->na; i += n)
                for (long j = b; j < exact->nb; j += n)
                    sum += fabs((double)*power_at(exact, i, j) / x - (double)*power_at(rounded, i, j) / y);
            largest = sum > largest ? sum : largest;
        }
    return largest;
}

static void test_rounded_powers(void)
{
    double closest = 0;
    test_begin("errors of rounded powers");
    for (test_cases(60); test_next();) {
        laurent s;
        mask_power x, y;
        laurent_init(&s);
        power_init(&x), power_init(&y);
        set_random(&s, random_range(1, 6), 9, random_bool() ? 16 : random_range(10, 40));
        CHECK(power_start(&x, &s, false) == POWER_OK && power_start(&y, &s, true) == POWER_OK, "no start");
        for (int n = 1; n <= 4 && power_raise(&x) == POWER_OK && power_raise(&y) == POWER_OK; n++) {
            double error = rounding_error(&x, &y), bound = (double)y.error / (double)(1L << POWER_ENTRY_BITS);
            CHECK(error <= bound + 1e-12, "N = %d: error %.6g, bound %.6g", n, error, bound);
            closest = bound > 0 && error / bound > closest ? error / bound : closest;
        }
        laurent_clear(&s);
        power_clear(&x), power_clear(&y);
    }
    CHECK(test_case_number() < 30 || closest > 0.2, "bounds are %.3g times the errors or more", 1 / closest);
    test_end();
}

/* ---- comparison constants ---- */

static void check_comparison(const laurent *mask, mesh_kind mesh, const int64_t (*golden)[2], const char *name)
{
    regular_masks m;
    comparison c;
    regular_init(&m);
    comparison_init(&c);
    MUST(regular_derive(&m, mask, mesh) && comparison_make(&c, mask, &m));
    CHECK(is_fraction(&c.values, golden[0][0], golden[0][1]), "%s: C is near %.9g", name, rational_get_double_approx(&c.values));
    for (int i = 0; i < 2; i++)
        CHECK(is_fraction(&c.derivative[i], golden[1][0], golden[1][1]), "%s: C%d is near %.9g", name, i + 1, rational_get_double_approx(&c.derivative[i]));
    regular_clear(&m);
    comparison_clear(&c);
}

static void test_golden_constants(void)
{
    static const int64_t butterfly[2][2] = {{1, 2}, {3, 4}}, loop[2][2] = {{1, 2}, {1, 2}}, zero[2][2] = {{0, 1}, {0, 1}};
    static const int64_t catmull_clark[2][2] = {{1, 2}, {1, 2}}, doo_sabin[2][2] = {{1, 2}, {1, 4}};
    laurent mask;
    mesh_kind mesh;
    test_begin("golden comparison constants");
    laurent_init(&mask);
    set_butterfly(&mask, 1, 16);
    check_comparison(&mask, MESH_TRIANGLE, butterfly, "butterfly");
    set_loop(&mask);
    check_comparison(&mask, MESH_TRIANGLE, loop, "loop");
    MUST(comparison_values(&mask, MESH_TRIANGLE));
    check_comparison(&mask, MESH_TRIANGLE, zero, "linear triangles");
    set_midpoint(&mask, &mesh, 1);
    check_comparison(&mask, mesh, zero, "bilinear quads");
    set_midpoint(&mask, &mesh, 3);
    check_comparison(&mask, mesh, catmull_clark, "catmull-clark");
    set_midpoint(&mask, &mesh, 2);
    check_comparison(&mask, mesh, doo_sabin, "doo-sabin");
    laurent_clear(&mask);
    test_end();
}

/* The constants of the thesis, and those that its decomposition proves. */
static void check_decomposition(const laurent *mask, const int64_t (*printed)[2], const int64_t (*proved)[2], const char *name)
{
    regular_masks m;
    decomposition c;
    regular_init(&m);
    decomposition_init(&c);
    MUST(regular_derive(&m, mask, MESH_TRIANGLE) && decomposition_make(&c, mask, &m));
    CHECK(c.identity, "%s: the identity does not hold", name);
    CHECK(is_fraction(&c.printed.values, printed[0][0], printed[0][1]), "%s: C is near %.9g", name, rational_get_double_approx(&c.printed.values));
    CHECK(is_fraction(&c.proved.values, proved[0][0], proved[0][1]), "%s: the bound is near %.9g", name, rational_get_double_approx(&c.proved.values));
    for (int i = 0; i < 2; i++) {
        CHECK(is_fraction(&c.printed.derivative[i], printed[1][0], printed[1][1]), "%s: C%d is near %.9g", name, i + 1, rational_get_double_approx(&c.printed.derivative[i]));
        CHECK(is_fraction(&c.proved.derivative[i], proved[1][0], proved[1][1]), "%s: the bound %d is near %.9g", name, i + 1, rational_get_double_approx(&c.proved.derivative[i]));
    }
    regular_clear(&m);
    decomposition_clear(&c);
}

static void test_golden_decompositions(void)
{
    static const int64_t butterfly[2][2] = {{3, 4}, {5, 4}}, butterfly_proved[2][2] = {{1, 2}, {1, 1}};
    static const int64_t loop[2][2] = {{7, 8}, {3, 2}}, loop_proved[2][2] = {{3, 4}, {1, 1}}, zero[2][2] = {{0, 1}, {0, 1}};
    laurent mask;
    test_begin("the thesis's constants, (4.31), (4.34), 6.5");
    laurent_init(&mask);
    set_butterfly(&mask, 1, 16);
    check_decomposition(&mask, butterfly, butterfly_proved, "butterfly");
    set_loop(&mask);
    check_decomposition(&mask, loop, loop_proved, "loop");
    MUST(comparison_values(&mask, MESH_TRIANGLE));
    check_decomposition(&mask, zero, zero, "linear triangles");
    laurent_clear(&mask);
    test_end();
}

/* z = b q, b linear interpolation, q a random sum of sixfold orbits with q(1,1) = 1: in general no mirror image of itself. */
static void set_random_product(laurent *z, int reach)
{
    laurent q, b;
    int64_t total = 0;
    laurent_init(&q), laurent_init(&b);
    MUST(laurent_set_box(&q, -2 * reach, -2 * reach, 4 * reach + 1, 4 * reach + 1));
    integer_set_si(&q.denominator, 32);
    for (int i = 0; i < 3; i++) {
        lattice p = {(int)random_range(-reach, reach), (int)random_range(-reach, reach)};
        int64_t weight = random_range(-5, 5);
        for (int turn = 0; turn < 6; turn++, p = mesh_rotate_mask(MESH_TRIANGLE, p)) {
            integer *c = &q.coefficient[(p.a + 2 * reach) * q.nb + p.b + 2 * reach];
            integer_set_si(c, integer_get_si(c) + weight);
            total += weight;
        }
    }
    integer *c = &q.coefficient[2 * reach * q.nb + 2 * reach];
    integer_set_si(c, integer_get_si(c) + 32 - total);
    MUST(comparison_values(&b, MESH_TRIANGLE) && laurent_mul(z, &b, &q));
    laurent_clear(&q), laurent_clear(&b);
}

/* Every plan costs the least at least. */
static void test_decompositions(void)
{
    test_begin("decompositions are identities and give valid constants");
    for (test_cases(150); test_next();) {
        laurent mask;
        regular_masks m;
        comparison least;
        decomposition c;
        laurent_init(&mask);
        regular_init(&m);
        comparison_init(&least);
        decomposition_init(&c);
        set_random_product(&mask, (int)random_range(1, 2));
        MUST(regular_derive(&m, &mask, MESH_TRIANGLE));
        CHECK(m.divisible, "not divisible");
        MUST(comparison_make(&least, &mask, &m) && decomposition_make(&c, &mask, &m));
        CHECK(c.identity, "the identity does not hold");
        CHECK(rational_cmp(&c.proved.values, &least.values) >= 0, "C below the least");
        for (int i = 0; i < 2; i++)
            CHECK(rational_cmp(&c.proved.derivative[i], &least.derivative[i]) >= 0, "C%d below the least", i + 1);
        laurent_clear(&mask);
        regular_clear(&m);
        comparison_clear(&least);
        decomposition_clear(&c);
    }
    test_end();
}

/* (4.23) is false: the example of lib/stability.md, 6, where |S_(b p_1)| = 1 and the least constant is n / 2. */
static void test_printed_bound_fails(void)
{
    laurent product, shifted, e, zero;
    rational norm, least;
    test_begin("the thesis's (4.23) is no bound");
    laurent_init(&product), laurent_init(&shifted), laurent_init(&e), laurent_init(&zero);
    rational_init(&norm), rational_init(&least);
    for (int n = 1; n <= 9; n += 2) {
        lattice point[8];
        rational weight[8];
        for (int i = 0; i < 8; i++) {
            int x = i & 1, u = i >> 1 & 1, y = i >> 2;
            point[i] = (lattice){n * x + n * u - 1, n * u - y};
            rational_init(&weight[i]);
            MUST(rational_set_si(&weight[i], 1, 2));
        }
        MUST(laurent_set_terms(&product, point, weight, 8) && laurent_class_norm(&norm, &product, 2));
        MUST(laurent_set(&shifted, &product));
        shifted.a0--;
        MUST(laurent_sub(&e, &shifted, &product) && comparison_constant(&least, &e, &zero, (lattice){1, 0}, (lattice){0, 1}));
        CHECK(is_fraction(&norm, 1, 1) && is_fraction(&least, n, 2), "n = %d: %.9g and %.9g", n, rational_get_double_approx(&norm), rational_get_double_approx(&least));
        for (int i = 0; i < 8; i++)
            rational_clear(&weight[i]);
    }
    laurent_clear(&product), laurent_clear(&shifted), laurent_clear(&e), laurent_clear(&zero);
    rational_clear(&norm), rational_clear(&least);
    test_end();
}

/* value = the coefficient of x at (a,b). */
static double coefficient(const laurent *x, long a, long b)
{
    const integer *c = laurent_at(x, a, b);
    return c ? integer_get_double_approx(c) / integer_get_double_approx(&x->denominator) : 0;
}

enum { WALK = 60 };

/* walk[WALK + i] for |i| <= WALK: steps of at most 1. */
static void set_walk(double walk[2 * WALK + 1])
{
    uint64_t way = random_word();
    walk[0] = 0;
    for (int i = 1; i <= 2 * WALK; i++) {
        way = random_below(3) ? way : random_word();
        walk[i] = walk[i - 1] + (double)(way % 3) - 1;
    }
}

/* |((S - B) p)(x)| <= C D(p) for random p with D(p) = 1: functions of the coordinate along u plus ones along v.  The
   answer is the largest |((S - B) p)(x)|. */
static double check_distance(const laurent *s, const laurent *b, lattice u, lattice v, double c)
{
    double walk_u[2 * WALK + 1], walk_v[2 * WALK + 1], largest = 0;
    int determinant = u.a * v.b - u.b * v.a;
    set_walk(walk_u);
    set_walk(walk_v);
    for (int class = 0; class < 4; class++) {
        double sum = 0;
        for (int x = -10; x <= 10; x++)
            for (int y = -10; y <= 10; y++) {
                int i = (x * v.b - y * v.a) * determinant, j = (u.a * y - u.b * x) * determinant;
                long at_a = (class >> 1) - 2 * x, at_b = (class & 1) - 2 * y;
                sum += (walk_u[WALK + i] + walk_v[WALK + j]) * (coefficient(s, at_a, at_b) - coefficient(b, at_a, at_b));
            }
        CHECK(fabs(sum) <= c + 1e-9, "difference %.9g, constant %.9g", fabs(sum), c);
        largest = fabs(sum) > largest ? fabs(sum) : largest;
    }
    return largest;
}

static void test_constants_hold(void)
{
    double closest = 0;
    test_begin("comparison constants hold for nets, and some nets attain them");
    for (test_cases(200); test_next();) {
        mesh_kind mesh = (mesh_kind)random_below(3);
        laurent mask, b;
        regular_masks m;
        comparison c;
        laurent_init(&mask), laurent_init(&b);
        regular_init(&m);
        comparison_init(&c);
        if (mesh == MESH_TRIANGLE)
            set_butterfly(&mask, (int)random_range(-3, 3), 32);
        else
            set_midpoint(&mask, &mesh, (int)random_range(1, 5));
        MUST(regular_derive(&m, &mask, mesh) && comparison_make(&c, &mask, &m));
        for (int i = -1; i < 2; i++) {
            regular_pair p = i < 0 ? (regular_pair){{0, 1}, {0, 0}} : regular_get_pair(mesh, i);
            double constant = rational_get_double_approx(i < 0 ? &c.values : &c.derivative[i]), largest;
            MUST(i < 0 ? comparison_values(&b, mesh) : comparison_derivative(&b, mesh, i));
            largest = check_distance(i < 0 ? &mask : &m.derivative[i], &b, regular_direction[p.direction[0]], regular_direction[p.direction[1]], constant);
            if (constant > 0 && largest / constant > closest)
                closest = largest / constant;
        }
        laurent_clear(&mask), laurent_clear(&b);
        regular_clear(&m);
        comparison_clear(&c);
    }
    CHECK(test_case_number() < 100 || closest > 0.999, "the closest net has %.3g of its constant", closest);
    test_end();
}

/* ---- bounds of limits ---- */

/* |S^N| tends to K; in the examples here it does not fall, so that no bound may lie below |S^6|. */
static void check_stability(const laurent *mask, mesh_kind mesh, int derivative, double at_most, stability_kind kind, const char *name)
{
    regular_masks m;
    comparison c;
    stability k;
    const laurent *s;
    double sum;
    regular_init(&m);
    comparison_init(&c);
    MUST(regular_derive(&m, mask, mesh) && comparison_make(&c, mask, &m) && stability_find(&k, mask, &m, &c, derivative));
    s = derivative < 0 ? mask : &m.derivative[derivative];
    sum = norm_by_delta(s, 6) / pow(integer_get_double_approx(&s->denominator), 6);
    CHECK(k.kind == kind, "%s, derivative %d: kind %d", name, derivative, (int)k.kind);
    CHECK((double)k.bound / STABILITY_UNIT >= sum - 1e-9, "%s, derivative %d: the bound %.6g is below the sum %.6g", name, derivative, (double)k.bound / STABILITY_UNIT, sum);
    CHECK((double)k.bound / STABILITY_UNIT <= at_most, "%s, derivative %d: the bound is only %.6g", name, derivative, (double)k.bound / STABILITY_UNIT);
    if (k.kind == STABILITY_WINDOW) {
        bool proved;
        MUST(stability_verify_window(&proved, s, k.power, k.bound));
        CHECK(proved, "%s, derivative %d: its own bound is not verified", name, derivative);
        MUST(stability_verify_window(&proved, s, k.power, (int64_t)(sum * STABILITY_UNIT) - 1));
        CHECK(!proved, "%s, derivative %d: a bound below the sum is verified", name, derivative);
    }
    regular_clear(&m);
    comparison_clear(&c);
}

static void test_stability(void)
{
    laurent mask;
    mesh_kind mesh;
    test_begin("bounds of limits");
    laurent_init(&mask);
    set_butterfly(&mask, 1, 16);
    check_stability(&mask, MESH_TRIANGLE, -1, 1.58, STABILITY_WINDOW, "butterfly");
    check_stability(&mask, MESH_TRIANGLE, 0, 2.11, STABILITY_WINDOW, "butterfly");
    set_butterfly(&mask, 1, 25);
    check_stability(&mask, MESH_TRIANGLE, 1, 2, STABILITY_WINDOW, "butterfly with tension 1/25");
    set_butterfly(&mask, 62501, 1000000); /* has to be rounded */
    check_stability(&mask, MESH_TRIANGLE, -1, 1.58, STABILITY_WINDOW, "butterfly with tension 62501/1000000");
    check_stability(&mask, MESH_TRIANGLE, 0, 2.15, STABILITY_WINDOW, "butterfly with tension 62501/1000000");
    set_loop(&mask);
    for (int i = -1; i < 2; i++)
        check_stability(&mask, MESH_TRIANGLE, i, 1, STABILITY_CONVEX, "loop");
    for (int degree = 2; degree <= 5; degree++) {
        set_midpoint(&mask, &mesh, degree);
        for (int i = -1; i < 2; i++)
            check_stability(&mask, mesh, i, 1, STABILITY_CONVEX, "midpoint");
    }
    laurent_clear(&mask);
    test_end();
}

/* The four-point scheme in both directions: a quad scheme with negative weights, on any monomial shift. */
static void set_four_point(laurent *z, int p, int q)
{
    lattice point[7];
    rational weight[7];
    laurent other;
    laurent_init(&other);
    for (int direction = 0; direction < 2; direction++) {
        for (int i = -3; i <= 3; i++) {
            rational_init(&weight[i + 3]);
            point[i + 3] = direction ? (lattice){0, i} : (lattice){i, 0};
            MUST(rational_set_si(&weight[i + 3], i == 0 ? 1 : i % 2 == 0 ? 0 : i == 1 || i == -1 ? q + 2 * p : -2 * p, i % 2 == 0 ? 1 : 2 * q));
        }
        MUST(laurent_set_terms(direction ? &other : z, point, weight, 7));
        for (int i = 0; i < 7; i++)
            rational_clear(&weight[i]);
    }
    MUST(laurent_mul(z, z, &other));
    laurent_clear(&other);
}

static void test_four_point(void)
{
    laurent mask;
    bool divisible;
    int pairs;
    test_begin("four-point tensor scheme");
    laurent_init(&mask);
    set_four_point(&mask, 1, 16);
    pairs = proved_pairs(&divisible, &mask, MESH_QUAD);
    CHECK(divisible && pairs == 7, "pairs %d", pairs);
    check_stability(&mask, MESH_QUAD, -1, 2, STABILITY_WINDOW, "four-point");
    check_stability(&mask, MESH_QUAD, 0, 4, STABILITY_WINDOW, "four-point");
    laurent_clear(&mask);
    test_end();
}

/* ---- masks that are not C1 ---- */

static void check_refutation(const laurent *mask, mesh_kind mesh, bool refuted, int64_t modulus, const char *name)
{
    regular_refutation z;
    MUST(regular_refute(&z, mask, mesh));
    CHECK(z.refuted == refuted, "%s: refuted %d", name, z.refuted);
    CHECK(!z.refuted || modulus < 0 || z.modulus == modulus, "%s: modulus %.9g", name, (double)z.modulus / REFUTATION_UNIT);
}

/* Butterfly has the eigenvalue 4w of frequency 0; interpolation has 1/2 there, whose functions have creases. */
static void test_golden_refutations(void)
{
    laurent mask;
    mesh_kind mesh;
    test_begin("masks that are not C1");
    laurent_init(&mask);
    for (int q = 2; q <= 32; q++) {
        set_butterfly(&mask, 1, q);
        check_refutation(&mask, MESH_TRIANGLE, q <= 8, q < 4 ? -1 : 4 * REFUTATION_UNIT / q, "butterfly");
    }
    set_butterfly(&mask, -1, 100);
    check_refutation(&mask, MESH_TRIANGLE, true, -1, "butterfly with a negative tension");
    set_butterfly(&mask, 127, 1024);
    check_refutation(&mask, MESH_TRIANGLE, false, -1, "butterfly, barely");
    set_butterfly(&mask, 129, 1024);
    check_refutation(&mask, MESH_TRIANGLE, true, 516, "butterfly, barely not");
    MUST(comparison_values(&mask, MESH_TRIANGLE));
    check_refutation(&mask, MESH_TRIANGLE, true, REFUTATION_UNIT / 2, "linear");
    set_loop(&mask);
    check_refutation(&mask, MESH_TRIANGLE, false, -1, "loop");
    for (int degree = 1; degree <= 7; degree++) {
        set_midpoint(&mask, &mesh, degree);
        check_refutation(&mask, mesh, degree == 1, REFUTATION_UNIT / 2, "midpoint");
    }
    set_four_point(&mask, 1, 16);
    check_refutation(&mask, MESH_QUAD, false, -1, "four-point");
    set_four_point(&mask, 1, 4);
    check_refutation(&mask, MESH_QUAD, true, -1, "four-point with too much tension");
    laurent_clear(&mask);
    test_end();
}

/* z = (1 - t) x + t y, t = p / q. */
static void set_mixture(laurent *z, const laurent *x, const laurent *y, int p, int q)
{
    laurent scaled, other;
    laurent_init(&scaled), laurent_init(&other);
    MUST(laurent_mul_si(&scaled, x, q - p) && laurent_mul_si(&other, y, -p) && laurent_sub(z, &scaled, &other));
    MUST(integer_mul_si(&z->denominator, &z->denominator, q));
    laurent_clear(&scaled), laurent_clear(&other);
}

/* What norms prove is never refuted, and the two leave little between them. */
static void test_proof_and_refutation(void)
{
    int proofs = 0, refutations = 0;
    test_begin("what is proved C1 is not refuted");
    for (test_cases(120); test_next();) {
        mesh_kind mesh = (mesh_kind)random_below(3);
        laurent mask, x, y;
        regular_refutation z;
        bool divisible;
        int pairs;
        laurent_init(&mask), laurent_init(&x), laurent_init(&y);
        if (mesh == MESH_TRIANGLE)
            set_random_product(&mask, 1);
        else {
            int degree = (int)random_range(1, 2);
            set_midpoint(&x, &mesh, degree);
            set_midpoint(&y, &mesh, degree + 2);
            set_mixture(&mask, &x, &y, (int)random_range(-12, 24), 8);
        }
        pairs = proved_pairs(&divisible, &mask, mesh);
        MUST(regular_refute(&z, &mask, mesh));
        CHECK(!z.refuted || pairs != 7, "both: frequency %d, modulus %.9g", z.frequency, (double)z.modulus / REFUTATION_UNIT);
        proofs += pairs == 7;
        refutations += z.refuted;
        laurent_clear(&mask), laurent_clear(&x), laurent_clear(&y);
    }
    CHECK(test_case_number() < 100 || (proofs >= 20 && refutations >= 20), "%d proofs, %d refutations", proofs, refutations);
    test_end();
}

/* ---- no mask can ask for unbounded work ---- */

static void test_large_masks(void)
{
    laurent s;
    norm_list norms;
    test_begin("large masks");
    laurent_init(&s);
    norm_list_init(&norms);
    for (int digits = 0; digits < 2; digits++) {
        MUST(laurent_set_box(&s, 0, 0, 17, 17));
        for (long i = 0; i < s.na * s.nb; i++)
            integer_set_si(&s.coefficient[i], (int64_t)(random_word() >> (digits ? 2 : 60)) + 1);
        MUST(norm_list_make(&norms, &s, REGULAR_MAX_POWER, false));
        CHECK(norms.count >= 2 && norms.count <= REGULAR_MAX_POWER, "%d norms", norms.count);
        regular_refutation z;
        MUST(regular_refute(&z, &s, MESH_QUAD));
    }
    norm_list_clear(&norms);
    laurent_clear(&s);
    test_end();
}

int main(void)
{
    test_golden_butterfly();
    test_golden_splines();
    test_not_proved();
    test_division();
    test_norms_by_delta();
    test_long_norms();
    test_rounded_powers();
    test_golden_constants();
    test_golden_decompositions();
    test_decompositions();
    test_printed_bound_fails();
    test_constants_hold();
    test_stability();
    test_four_point();
    test_golden_refutations();
    test_proof_and_refutation();
    test_large_masks();
    return test_status();
}
