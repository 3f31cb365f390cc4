/* The checker's exact numbers: fields of cosines, and polynomials and matrices over them.  Protocol as in
 * t-check-units.c. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/scratch.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/field.c"
#include "../../verify/check/polynomial.c"

#include "protocol.h"

enum { G = 512, ORDER = 4 };

static bool are_equal(const struct number *a, const struct number *b)
{
    struct number difference = number_sub(a, b);

    return number_is_zero(&difference);
}

/* Do they meet, and is x narrow? */
static bool fits(interval x, interval y)
{
    return integer_compare(x.lo, y.hi) <= 0 && integer_compare(y.lo, x.hi) <= 0 &&
           integer_bits(interval_rad(x)) < G / 2;
}

static struct number random_number(const struct field *k)
{
    integer part[MAX_DEGREE];

    for (int i = 0; i < k->degree; i++)
        part[i] = integer_from((int64_t)(random_word() % 41) - 20);
    return number_of(part, integer_from(1 + random_word() % 12), k);
}

static int common_divisor(int a, int b)
{
    return b == 0 ? a : common_divisor(b, a % b);
}

/* The degree is half the count of numbers below 2n that have no divisor with it in common. */
static void test_degrees(void)
{
    begin("field-degree");
    for (int n = MIN_FIELD; n <= 200; n++) {
        int count = 0;

        for (int i = 1; i < 2 * n; i++)
            count += common_divisor(i, 2 * n) == 1 ? 1 : 0;
        EXPECT(2 * field_degree(n) == count);
    }
    EXPECT(field_degree(4096) == 2048);
    end();
}

/* Psi has that degree, is monic, and theta is its root. */
static void test_minimal(void)
{
    begin("field-minimal-polynomial");
    for (int n = MIN_FIELD; n <= 240; n++) {
        struct mark mark = scratch_mark();
        struct field k;
        interval c = grid_cos_pi(rational_from(1, n), G), t = interval_add(c, c);
        interval z = grid_from(1, G);

        if (field_degree(n) > MAX_DEGREE)
            continue;
        field_make(&k, n);
        EXPECT(integer_compare(k.minimal[k.degree], integer_from(1)) == 0);
        for (int i = k.degree - 1; i >= 0; i--)
            z = interval_add(grid_mul(z, t, G), interval_thin(
                integer_shift_left(k.minimal[i], G)));
        EXPECT(fits(z, grid_from(0, G)));
        scratch_release(mark);
    }
    end();
}

static void test_cosines(void)
{
    static const int all[] = { 2, 3, 5, 7, 12, 26, 60 };

    begin("field-cosines");
    for (size_t f = 0; f < sizeof all / sizeof all[0]; f++) {
        struct field k;
        struct number c;
        int n = all[f];

        field_make(&k, n);
        for (int i = -3 * n; i <= 5 * n; i++) {
            struct mark mark = scratch_mark();

            EXPECT(number_cos_pi(&c, rational_from(i, n), &k));
            EXPECT(fits(number_enclose(&c, &k, G), grid_cos_pi(rational_from(i, n), G)));
            scratch_release(mark);
        }
        EXPECT(!number_cos_pi(&c, rational_from(1, 7 * n), &k));
        EXPECT(!number_cos_pi(&c, rational_from(2 * n + 1, 2 * n), &k));
    }
    end();
}

/* The laws, exactly, and by enclosures. */
static void test_arithmetic(void)
{
    static const int all[] = { 2, 3, 4, 5, 7, 9, 15, 16, 26, 127 };

    begin("field-arithmetic");
    for (int trial = 0; trial < 60; trial++) {
        struct mark mark = scratch_mark();
        struct field k;
        struct number a, b, c, x, y, z;
        rational q;

        field_make(&k, all[trial % 10]);
        a = random_number(&k);
        b = random_number(&k);
        c = random_number(&k);
        x = number_add(&a, &b);
        EXPECT(fits(number_enclose(&x, &k, G), interval_add(number_enclose(&a, &k, G),
                                                         number_enclose(&b, &k, G))));
        y = number_sub(&x, &b);
        EXPECT(are_equal(&y, &a));
        EXPECT(integer_compare(y.den, a.den) == 0);           /* lowest terms */
        x = number_mul(&x, &c, &k);
        y = number_mul(&a, &c, &k);
        z = number_mul(&b, &c, &k);
        EXPECT(fits(number_enclose(&y, &k, G), grid_mul(number_enclose(&a, &k, G),
                                                     number_enclose(&c, &k, G), G)));
        y = number_add(&y, &z);
        EXPECT(are_equal(&x, &y));
        x = number_mul(&a, &b, &k);
        x = number_mul(&x, &c, &k);
        y = number_mul(&b, &c, &k);
        y = number_mul(&a, &y, &k);
        EXPECT(are_equal(&x, &y));
        x = number_from_whole(3);
        x = number_mul(&x, &a, &k);
        y = number_scale(rational_from(3, 1), &a, &k);
        EXPECT(are_equal(&x, &y));
        EXPECT(!number_get_rational(&q, &a) || k.degree == 1);
        scratch_release(mark);
    }
    end();
}

static struct exact_matrix random_matrix(const struct field *k)
{
    struct exact_matrix out = { .size = ORDER };

    out.entry = allocate(ORDER * ORDER, sizeof out.entry[0]);
    for (int i = 0; i < ORDER * ORDER; i++)
        out.entry[i] = random_number(k);
    return out;
}

/* Cayley and Hamilton; and no polynomial of that degree but this one. */
static void test_characteristic(void)
{
    begin("characteristic-polynomial");
    for (int n = 2; n < 10; n++) {
        struct mark mark = scratch_mark();
        struct field k;
        struct exact_matrix m;
        struct polynomial p;
        struct number one = number_from_whole(1), v[ORDER];

        field_make(&k, n);
        m = random_matrix(&k);
        p = polynomial_characteristic(&m, &k);
        for (int wrong = 0; wrong < 2; wrong++) {
            bool zero = true;

            for (int i = 0; i < ORDER; i++)
                v[i] = number_from_whole(i == 2 ? 1 : 0);
            polynomial_apply(v, &p, &m, &k);
            for (int i = 0; i < ORDER; i++)
                zero = zero && number_is_zero(&v[i]);
            EXPECT(zero == (wrong == 0));
            p.coefficient[n % ORDER] = number_add(&p.coefficient[n % ORDER], &one);
        }
        scratch_release(mark);
    }
    end();
}

/* x^2 - 2 theta x + theta^2 - 1 = (x - theta + 1)(x - theta - 1) */
static void test_division(void)
{
    struct field k;
    struct number theta, one = number_from_whole(1), square, sum;
    struct polynomial p, f, turned;

    begin("polynomial-division");
    field_make(&k, 7);
    number_cos_pi(&theta, rational_from(1, 7), &k);
    theta = number_add(&theta, &theta);
    square = number_mul(&theta, &theta, &k);
    p = polynomial_make(2);
    p.coefficient[0] = number_sub(&square, &one);
    sum = number_add(&theta, &theta);
    p.coefficient[1] = number_minus(&sum);
    f = polynomial_make(1);
    f.coefficient[0] = number_sub(&one, &theta);
    turned = polynomial_turn(&f, -1);
    EXPECT(!polynomial_divide(&p, &turned, &k));
    p.coefficient[0] = number_sub(&square, &one);
    p.coefficient[1] = number_minus(&sum);
    EXPECT(polynomial_divide(&p, &f, &k));
    EXPECT(p.degree == 1);
    sum = number_add(&theta, &one);
    sum = number_minus(&sum);
    EXPECT(are_equal(&p.coefficient[0], &sum));
    EXPECT(!polynomial_divide(&p, &f, &k));
    p.degree = 0;
    EXPECT(!polynomial_divide(&p, &f, &k));
    turned = polynomial_turn(&f, 1);
    EXPECT(are_equal(&turned.coefficient[0], &f.coefficient[0]));
    end();
}

int main(void)
{
    test_degrees();
    test_minimal();
    test_cosines();
    test_arithmetic();
    test_characteristic();
    test_division();
    return failures == 0 ? 0 : 1;
}
