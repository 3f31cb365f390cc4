/* t-laurent.c: Laurent polynomials against their definition, term by term in rationals; the masks of differences
   and their norms against known values. */
#include "lib/laurent.h"

#include <stdlib.h>

#include "common.h"
#include "lib/regular.h"

/* ---- the definition: coefficients in a square of points ---- */

enum { HALF = 40, SIDE = 2 * HALF + 1 };

typedef struct {
    rational at[SIDE][SIDE]; /* [a + HALF][b + HALF] */
} table;

static table *new_table(void)
{
    table *z = malloc(sizeof *z);
    for (int i = 0; i < SIDE * SIDE; i++)
        rational_init(&z->at[i / SIDE][i % SIDE]);
    return z;
}

static void free_table(table *z)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        rational_clear(&z->at[i / SIDE][i % SIDE]);
    free(z);
}

static bool equals(const laurent *x, const table *t)
{
    bool same = true;
    rational q;
    rational_init(&q);
    CHECK(integer_sign(&x->denominator) > 0, "denominator");
    for (int a = -HALF; a <= HALF; a++)
        for (int b = -HALF; b <= HALF; b++) {
            const rational *expected = &t->at[a + HALF][b + HALF];
            MUST(laurent_get(&q, x, a, b));
            same = same && rational_equal(&q, expected) && laurent_is_zero_at(x, a, b) == rational_is_zero(expected);
        }
    same = same && (!x->na || (x->a0 >= -HALF && x->a0 + x->na <= HALF + 1 && x->b0 >= -HALF && x->b0 + x->nb <= HALF + 1));
    rational_clear(&q);
    return same;
}

/* Some points within `reach`, rationals with small or large parts, often zero; into z and t. */
static void random_laurent(laurent *z, table *t, int reach)
{
    enum { MOST = 40 };
    lattice point[MOST];
    rational weight[MOST];
    size_t count = (size_t)random_below(random_below(4) ? 12 : MOST), n = 0;
    for (size_t i = 0; i < count; i++) {
        int a = (int)random_range(-reach, reach), b = (int)random_range(-reach, reach);
        bool known = false;
        for (size_t j = 0; j < n; j++)
            known = known || (point[j].a == a && point[j].b == b);
        if (known)
            continue;
        point[n] = (lattice){a, b};
        rational_init(&weight[n]);
        if (random_below(6) == 0)
            random_rational(&weight[n], 3);
        else
            MUST(rational_set_si(&weight[n], random_range(-20, 20), random_range(1, 12)));
        if (t)
            MUST(rational_set(&t->at[a + HALF][b + HALF], &weight[n]));
        n++;
    }
    MUST(laurent_set_terms(z, point, weight, n));
    for (size_t i = 0; i < n; i++)
        rational_clear(&weight[i]);
}

static void test_terms(void)
{
    test_begin("laurent-terms");
    for (test_cases(200); test_next();) {
        laurent x, y;
        table *t = new_table();
        laurent_init(&x), laurent_init(&y);
        random_laurent(&x, t, 9);
        CHECK(equals(&x, t), "set_terms");
        MUST(laurent_set(&y, &x));
        CHECK(equals(&y, t), "set");
        MUST(laurent_set(&x, &x));
        CHECK(equals(&x, t), "set in place");
        laurent_clear(&x);
        CHECK(equals(&y, t), "a copy shares memory");
        laurent_swap(&x, &y);
        CHECK(equals(&x, t), "swap");
        bool positive = true;
        long low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        bool first = true;
        for (int a = -HALF; a <= HALF; a++)
            for (int b = -HALF; b <= HALF; b++) {
                const rational *q = &t->at[a + HALF][b + HALF];
                long f[3] = {a, b, a + b};
                positive = positive && rational_sign(q) >= 0;
                for (int i = 0; i < 3 && rational_sign(q); i++) {
                    low[i] = first || f[i] < low[i] ? f[i] : low[i];
                    high[i] = first || f[i] > high[i] ? f[i] : high[i];
                }
                first = first && !rational_sign(q);
            }
        CHECK(laurent_is_nonnegative(&x) == positive, "is_nonnegative");
        laurent_extent e = laurent_get_extent(&x);
        for (int i = 0; i < 3 && !first; i++)
            CHECK(e.low[i] == low[i] && e.high[i] == high[i], "extent %d", i);
        laurent_clear(&x), laurent_clear(&y);
        free_table(t);
    }
    test_end();
}

static void test_mul(void)
{
    test_begin("laurent-mul");
    for (test_cases(60); test_next();) {
        laurent x, y, z;
        table *s = new_table(), *t = new_table(), *p = new_table();
        rational q;
        rational_init(&q);
        laurent_init(&x), laurent_init(&y), laurent_init(&z);
        random_laurent(&x, s, 7), random_laurent(&y, t, 7);
        for (int i = 0; i < SIDE * SIDE; i++)
            for (int j = 0; j < SIDE * SIDE && !rational_is_zero(&s->at[i / SIDE][i % SIDE]); j++)
                if (!rational_is_zero(&t->at[j / SIDE][j % SIDE])) {
                    rational *sum = &p->at[i / SIDE + j / SIDE - HALF][i % SIDE + j % SIDE - HALF];
                    MUST(rational_mul(&q, &s->at[i / SIDE][i % SIDE], &t->at[j / SIDE][j % SIDE]));
                    MUST(rational_add(sum, sum, &q));
                }
        MUST(laurent_mul(&z, &x, &y));
        CHECK(equals(&z, p), "mul");
        MUST(laurent_mul(&y, &x, &y));
        CHECK(equals(&y, p), "mul, z = y");
        MUST(laurent_set(&z, &x));
        MUST(laurent_mul(&z, &z, &z));
        MUST(laurent_mul(&y, &x, &x));
        MUST(laurent_mul_si(&x, &x, -7));
        MUST(rational_set_si(&q, -7, 1));
        for (int i = 0; i < SIDE * SIDE; i++)
            MUST(rational_mul(&s->at[i / SIDE][i % SIDE], &s->at[i / SIDE][i % SIDE], &q));
        CHECK(equals(&x, s), "mul_si");
        for (int a = -14; a <= 14; a++)
            for (int b = -14; b <= 14; b++) {
                MUST(laurent_get(&t->at[a + HALF][b + HALF], &y, a, b));
                rational_swap(&p->at[a + HALF][b + HALF], &t->at[a + HALF][b + HALF]);
            }
        laurent_clear(&x), laurent_clear(&y);
        for (int i = 0; i < SIDE * SIDE; i++)
            if (abs(i / SIDE - HALF) > 14 || abs(i % SIDE - HALF) > 14)
                MUST(rational_set_si(&p->at[i / SIDE][i % SIDE], 0, 1));
        CHECK(equals(&z, p), "mul, all the same");
        laurent_clear(&z);
        rational_clear(&q);
        free_table(s), free_table(t), free_table(p);
    }
    test_end();
}

static void test_stretch(void)
{
    test_begin("laurent-stretch");
    for (test_cases(60); test_next();) {
        laurent x, z;
        table *s = new_table(), *t = new_table();
        long n = random_range(1, 5);
        laurent_init(&x), laurent_init(&z);
        random_laurent(&x, s, 8);
        for (int a = -8; a <= 8; a++)
            for (int b = -8; b <= 8; b++)
                MUST(rational_set(&t->at[a * n + HALF][b * n + HALF], &s->at[a + HALF][b + HALF]));
        MUST(laurent_stretch(&z, &x, n));
        CHECK(equals(&z, t), "stretch by %ld", n);
        MUST(laurent_stretch(&x, &x, n));
        CHECK(equals(&x, t), "stretch by %ld in place", n);
        laurent_clear(&x), laurent_clear(&z);
        free_table(s), free_table(t);
    }
    test_end();
}

static void make_binomial(laurent *z, lattice d) /* 1 + z^-d */
{
    lattice point[2] = {{0, 0}, {-d.a, -d.b}};
    rational one[2];
    for (int i = 0; i < 2; i++) {
        rational_init(&one[i]);
        MUST(rational_set_si(&one[i], 1, 1));
    }
    MUST(laurent_set_terms(z, point, one, 2));
}

static bool same(const laurent *x, const laurent *y)
{
    bool equal = true;
    rational p, q;
    rational_init(&p), rational_init(&q);
    for (int a = -HALF; equal && a <= HALF; a++)
        for (int b = -HALF; equal && b <= HALF; b++) {
            MUST(laurent_get(&p, x, a, b));
            MUST(laurent_get(&q, y, a, b));
            equal = rational_equal(&p, &q);
        }
    rational_clear(&p), rational_clear(&q);
    return equal;
}

/* Is x, whose points are within 6, divisible by 1 + z^-d?  It is if the alternating sum on every line p + Z d is 0. */
static bool is_divisible(const laurent *x, lattice d)
{
    bool yes = true;
    rational sum, q;
    rational_init(&sum), rational_init(&q);
    for (int a = -6; yes && a <= 6; a++)
        for (int b = -6; yes && b <= 6; b++) {
            MUST(rational_set_si(&sum, 0, 1));
            for (int i = -12; i <= 12; i++) {
                MUST(laurent_get(&q, x, a + i * d.a, b + i * d.b));
                if (i % 2 ? !rational_sub(&sum, &sum, &q) : !rational_add(&sum, &sum, &q))
                    test_fail(__FILE__, __LINE__, "no memory");
            }
            yes = rational_is_zero(&sum);
        }
    rational_clear(&sum), rational_clear(&q);
    return yes;
}

static lattice random_direction(void)
{
    lattice d;
    if (random_below(4))
        return regular_direction[random_below(3)];
    do
        d = (lattice){(int)random_range(-2, 2), (int)random_range(-2, 2)};
    while (!d.a && !d.b);
    return d;
}

static void test_divide(void)
{
    test_begin("laurent-divide-back");
    for (test_cases(300); test_next();) {
        laurent x, y, z;
        bool exact = false;
        lattice d = random_direction();
        laurent_init(&x), laurent_init(&y), laurent_init(&z);
        random_laurent(&x, NULL, 9);
        make_binomial(&y, d);
        MUST(laurent_mul(&y, &x, &y));
        MUST(laurent_divide_binomial(&z, &exact, &y, d));
        CHECK(exact, "a remainder by 1 + z^-(%d,%d)", d.a, d.b);
        CHECK(same(&z, &x), "another quotient by 1 + z^-(%d,%d)", d.a, d.b);
        MUST(laurent_divide_binomial(&y, &exact, &y, d));
        CHECK(exact && same(&y, &x), "in place");
        laurent_clear(&x), laurent_clear(&y), laurent_clear(&z);
    }
    test_end();
    test_begin("laurent-divide-remainder");
    for (test_cases(100); test_next();) {
        laurent x, y, z;
        bool exact = false;
        lattice d = regular_direction[random_below(3)];
        laurent_init(&x), laurent_init(&y), laurent_init(&z);
        random_laurent(&x, NULL, 4);
        make_binomial(&y, d);
        MUST(laurent_mul(&x, &x, &y));
        if (x.na && random_below(8)) { /* one or two coefficients change */
            for (int i = 0; i < 2; i++) {
                integer *c = &x.coefficient[random_below((uint64_t)(x.na * x.nb))];
                MUST(integer_add_si(c, c, random_bool() ? 1 : -1));
            }
        }
        bool divisible = is_divisible(&x, d);
        MUST(laurent_divide_binomial(&z, &exact, &x, d));
        CHECK(exact == divisible, "1 + z^-(%d,%d) %s, but the answer is %d", d.a, d.b, divisible ? "divides" : "leaves a remainder", exact);
        if (exact && divisible) {
            MUST(laurent_mul(&z, &z, &y));
            CHECK(same(&z, &x), "the product is not the dividend");
        }
        laurent_clear(&x), laurent_clear(&y), laurent_clear(&z);
    }
    test_end();
}

static void test_classes(void)
{
    test_begin("laurent-classes");
    for (test_cases(100); test_next();) {
        laurent x;
        table *t = new_table();
        long n = random_bool() ? 2 : random_range(1, 9);
        rational sum, magnitude, best, total;
        rational_init(&sum), rational_init(&magnitude), rational_init(&best), rational_init(&total);
        laurent_init(&x);
        random_laurent(&x, t, 9);
        for (int a = 0; a < n; a++)
            for (int b = 0; b < n; b++) {
                MUST(rational_set_si(&sum, 0, 1));
                MUST(rational_set_si(&total, 0, 1));
                for (int p = -HALF; p <= HALF; p++)
                    for (int q = -HALF; q <= HALF; q++)
                        if ((p - a) % n == 0 && (q - b) % n == 0) {
                            MUST(rational_abs(&magnitude, &t->at[p + HALF][q + HALF]));
                            MUST(rational_add(&sum, &sum, &magnitude));
                            MUST(rational_add(&total, &total, &t->at[p + HALF][q + HALF]));
                        }
                if (rational_cmp(&sum, &best) > 0)
                    MUST(rational_set(&best, &sum));
                long far = n * random_range(-5, 5);
                MUST(laurent_class_sum(&sum, &x, a + far, b - far, n));
                CHECK(rational_equal(&sum, &total), "sum over the class of (%d,%d) modulo %ld", a, b, n);
            }
        MUST(laurent_class_norm(&sum, &x, n));
        CHECK(rational_equal(&sum, &best), "norm modulo %ld", n);
        laurent_clear(&x);
        rational_clear(&sum), rational_clear(&magnitude), rational_clear(&best), rational_clear(&total);
        free_table(t);
    }
    test_end();
}

static void test_zero(void)
{
    laurent zero, x, z;
    bool exact = false;
    rational q;
    table *t = new_table();
    test_begin("laurent-zero");
    rational_init(&q);
    laurent_init(&zero), laurent_init(&x), laurent_init(&z);
    make_binomial(&x, regular_direction[2]);
    MUST(laurent_set_terms(&zero, NULL, NULL, 0));
    CHECK(equals(&zero, t) && zero.na == 0, "no terms");
    MUST(laurent_mul(&z, &zero, &x));
    CHECK(equals(&z, t), "0 x");
    MUST(laurent_mul(&z, &x, &zero));
    CHECK(equals(&z, t), "x 0");
    MUST(laurent_stretch(&z, &zero, 3));
    CHECK(equals(&z, t), "stretched 0");
    MUST(laurent_divide_binomial(&z, &exact, &zero, regular_direction[0]));
    CHECK(exact && equals(&z, t), "divided 0");
    MUST(laurent_class_norm(&q, &zero, 4));
    CHECK(rational_is_zero(&q), "norm of 0");
    MUST(laurent_class_sum(&q, &zero, 1, 2, 4));
    CHECK(rational_is_zero(&q), "sum of 0");
    CHECK(laurent_is_nonnegative(&zero) && laurent_at(&zero, 0, 0) == NULL, "0 is not negative");
    laurent_clear(&zero), laurent_clear(&x), laurent_clear(&z);
    rational_clear(&q);
    free_table(t);
    test_end();
}

/* ---- differences ---- */

/* |S^N| by its definition: how much N steps applied to a net can gain, the largest sum over y of the |weight| that the
   old point y has in a new point x.  The weights of all y in x follow step by step. */
static void brute_norm(rational *norm, const laurent *s, int power)
{
    rational q, sum;
    rational_init(&q), rational_init(&sum);
    MUST(rational_set_si(norm, 0, 1));
    for (long a = 0; a < 1L << power; a++)
        for (long b = 0; b < 1L << power; b++) {
            table *now = new_table();
            MUST(rational_set_si(&now->at[a + HALF][b + HALF], 1, 1));
            for (int step = 0; step < power; step++) {
                table *old = new_table();
                for (int i = 0; i < SIDE * SIDE; i++) {
                    int x = i / SIDE - HALF, y = i % SIDE - HALF;
                    if (rational_is_zero(&now->at[x + HALF][y + HALF]))
                        continue;
                    for (int p = -10; p <= 10; p++)
                        for (int r = -10; r <= 10; r++) {
                            if (laurent_is_zero_at(s, x - 2 * p, y - 2 * r))
                                continue;
                            MUST(laurent_get(&q, s, x - 2 * p, y - 2 * r));
                            MUST(rational_mul(&q, &q, &now->at[x + HALF][y + HALF]));
                            MUST(rational_add(&old->at[p + HALF][r + HALF], &old->at[p + HALF][r + HALF], &q));
                        }
                }
                free_table(now);
                now = old;
            }
            MUST(rational_set_si(&sum, 0, 1));
            for (int i = 0; i < SIDE * SIDE; i++) {
                MUST(rational_abs(&q, &now->at[i / SIDE][i % SIDE]));
                MUST(rational_add(&sum, &sum, &q));
            }
            if (rational_cmp(&sum, norm) > 0)
                MUST(rational_set(norm, &sum));
            free_table(now);
        }
    rational_clear(&q), rational_clear(&sum);
}

static void test_norm(void)
{
    test_begin("regular-norm-by-definition");
    for (test_cases(5); test_next();) {
        laurent s;
        rational norm, expected;
        int power = (int)random_range(1, 3);
        laurent_init(&s);
        rational_init(&norm), rational_init(&expected);
        random_laurent(&s, NULL, 3);
        MUST(regular_norm(&norm, &s, power));
        brute_norm(&expected, &s, power);
        CHECK(rational_equal(&norm, &expected), "|S^%d|", power);
        laurent_clear(&s);
        rational_clear(&norm), rational_clear(&expected);
    }
    test_end();
}

static void check_norms(const char *name, const laurent *s, const long (*fraction)[2], int count)
{
    rational norm;
    rational_init(&norm);
    for (int i = 0; i < count; i++) {
        MUST(regular_norm(&norm, s, i + 1));
        char *text = rational_get_str(&norm);
        CHECK(rational_cmp_si(&norm, fraction[i][0], fraction[i][1]) == 0, "%s, N = %d: %s, not %ld/%ld", name, i + 1, text, fraction[i][0], fraction[i][1]);
        free(text);
    }
    rational_clear(&norm);
}

static void check_powers(const regular_masks *masks, int p0, int p1, int p2)
{
    int power[3] = {-1, -1, -1}, expected[3] = {p0, p1, p2};
    rational norm[3], again;
    rational_init(&again);
    for (int i = 0; i < 3; i++)
        rational_init(&norm[i]);
    MUST(regular_contraction(power, norm, masks));
    for (int i = 0; i < 3; i++) {
        CHECK(power[i] == expected[i], "pair %d: power %d, not %d", i, power[i], expected[i]);
        if (power[i]) {
            MUST(regular_norm(&again, &masks->second[i], power[i]));
            CHECK(rational_equal(&again, &norm[i]) && rational_cmp_si(&norm[i], 1, 1) < 0, "norm of pair %d", i);
        }
        rational_clear(&norm[i]);
    }
    rational_clear(&again);
}

/* z^-d z1 z2 .. = a: a = 2 a_d (1 + z^-d) / 2, and so on: the masks are what was divided. */
static void check_derivation(const regular_masks *masks, const laurent *mask)
{
    static const int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    laurent factor, product, twice;
    laurent_init(&factor), laurent_init(&product), laurent_init(&twice);
    MUST(laurent_mul_si(&twice, mask, 2));
    for (int i = 0; i < 2; i++) {
        make_binomial(&factor, regular_direction[i]);
        MUST(laurent_mul(&product, &factor, &masks->derivative[i]));
        CHECK(same(&product, &twice), "2 a_%d", i + 1);
    }
    for (int i = 0; i < 3; i++) {
        make_binomial(&factor, regular_direction[pair[i][0]]);
        MUST(laurent_mul(&product, &factor, &masks->second[i]));
        make_binomial(&factor, regular_direction[pair[i][1]]);
        MUST(laurent_mul(&product, &factor, &product));
        CHECK(same(&product, &twice), "2 a_%d%d", pair[i][0] + 1, pair[i][1] + 1);
    }
    laurent_clear(&factor), laurent_clear(&product), laurent_clear(&twice);
}

static void test_golden(void)
{
    static const long half[6][2] = {{1, 2}, {1, 4}, {1, 8}, {1, 16}, {1, 32}, {1, 64}};
    static const long first[5][2] = {{7, 8}, {31, 64}, {261, 1024}, {2091, 16384}, {8441, 131072}};
    static const long second[6][2] = {{1, 1}, {7, 8}, {11, 16}, {1, 2}, {11, 32}, {29, 128}};
    scheme s;
    regular_masks masks;
    laurent a1;
    integer two;
    test_begin("regular-golden-butterfly");
    read_scheme(&s, BUTTERFLY_TEXT);
    regular_init(&masks);
    laurent_init(&a1);
    integer_init(&two);
    integer_set_si(&two, 2);
    MUST(regular_derive(&masks, &s.mask, MESH_TRIANGLE));
    CHECK(masks.divisible, "a remainder");
    check_derivation(&masks, &s.mask);
    for (int i = 0; i < 2; i++) { /* a_1 is half of 2 a_1 */
        MUST(laurent_set(&a1, &masks.derivative[i]));
        MUST(integer_mul(&a1.denominator, &a1.denominator, &two));
        check_norms("a_1", &a1, first, 5);
    }
    for (int i = 0; i < 3; i++)
        check_norms("2 a_12", &masks.second[i], second, 6);
    check_powers(&masks, 2, 2, 2);
    integer_clear(&two);
    laurent_clear(&a1);
    regular_clear(&masks);
    scheme_clear(&s);
    test_end();
    test_begin("regular-golden-loop");
    read_scheme(&s, catalogue_text("loop"));
    regular_init(&masks);
    MUST(regular_derive(&masks, &s.mask, MESH_TRIANGLE));
    CHECK(masks.divisible, "a remainder");
    check_derivation(&masks, &s.mask);
    for (int i = 0; i < 3; i++)
        check_norms("2 a_12", &masks.second[i], half, 6);
    check_powers(&masks, 1, 1, 1);
    regular_clear(&masks);
    scheme_clear(&s);
    test_end();
}

/* z = 4 product of (1 + z^-d) / 2 over the directions, moved by (2,1). */
static void box_spline(laurent *z, const int *direction, int count)
{
    laurent factor;
    lattice place = {2, 1};
    rational four;
    laurent_init(&factor);
    rational_init(&four);
    MUST(rational_set_si(&four, 4, 1L << count));
    MUST(laurent_set_terms(z, &place, &four, 1));
    for (int i = 0; i < count; i++) {
        make_binomial(&factor, regular_direction[direction[i]]);
        MUST(laurent_mul(z, z, &factor));
    }
    laurent_clear(&factor);
    rational_clear(&four);
}

static void check_box_spline(const int *direction, int count, bool divisible, int p0, int p1, int p2)
{
    laurent mask;
    regular_masks masks;
    laurent_init(&mask);
    regular_init(&masks);
    box_spline(&mask, direction, count);
    MUST(regular_derive(&masks, &mask, MESH_TRIANGLE));
    CHECK(masks.divisible == divisible, "divisible: %d", masks.divisible);
    if (divisible)
        check_derivation(&masks, &mask);
    check_powers(&masks, p0, p1, p2);
    laurent_clear(&mask);
    regular_clear(&masks);
}

/* A box spline of e1, e2, e3 with multiplicities i, j, k is C1 iff i + j, i + k and j + k are all at least 3. */
static void test_box_splines(void)
{
    static const int courant[] = {0, 1, 2}, first_twice[] = {0, 0, 1, 2}, second_twice[] = {0, 1, 1, 2}, third_twice[] = {0, 1, 2, 2};
    static const int loop[] = {0, 0, 1, 1, 2, 2}, smooth[] = {0, 0, 1, 1, 2}, no_third[] = {0, 0, 1, 1}, no_first[] = {1, 1, 2, 2}, no_second[] = {0, 0, 2, 2};
    test_begin("regular-box-splines");
    check_box_spline(loop, 6, true, 1, 1, 1);
    check_box_spline(smooth, 5, true, 1, 1, 1);
    check_box_spline(courant, 3, true, 0, 0, 0);
    check_box_spline(first_twice, 4, true, 1, 1, 0); /* passes two norms of three and is only C0 */
    check_box_spline(second_twice, 4, true, 1, 0, 1);
    check_box_spline(third_twice, 4, true, 0, 1, 1);
    check_box_spline(no_third, 4, false, 0, 0, 0);
    check_box_spline(no_first, 4, false, 0, 0, 0);
    check_box_spline(no_second, 4, false, 0, 0, 0);
    test_end();
}

int main(void)
{
    test_terms();
    test_mul();
    test_stretch();
    test_divide();
    test_classes();
    test_zero();
    test_norm();
    test_golden();
    test_box_splines();
    return test_status();
}
