/* t-number_field.c: real cyclotomic fields, polynomials and matrices over them, against what they mean in doubles, and
   against identities. */
#include "lib/exact_block.h"

#include "common.h"

#include <math.h>
#include <stdlib.h>

static double value_approx(const number_field *f, const rational *x)
{
    double theta = 2 * cos(acos(-1.) / (double)f->n), value = 0;
    for (int i = f->degree - 1; i >= 0; i--)
        value = value * theta + rational_get_double_approx(&x[i]);
    return value;
}

static void random_element(number_field *f, rational *z)
{
    for (int i = 0; i < f->degree; i++)
        MUST(rational_set_si(&z[i], random_range(-9, 9), random_range(1, 9)));
}

/* z = cos(i pi/n) */
static void set_cosine(cosines *z, long i, long n)
{
    rational q;
    rational_init(&q);
    MUST(rational_set_si(&q, i, n));
    cosines_cos_pi(z, &q, n);
    rational_clear(&q);
}

static long gcd(long a, long b) { return b ? gcd(b, a % b) : a; }

/* The degree is the number of 1 <= i <= n without a common divisor with 2n, and theta is 2 cos(pi/n). */
static void test_degree(void)
{
    test_begin("field-degree");
    for (long n = 2; n <= 200; n++) {
        number_field f;
        long degree = 0;
        for (long i = 1; i <= n; i++)
            degree += gcd(i, 2 * n) == 1;
        if (number_field_make(&f, n)) {
            double theta = 2 * cos(acos(-1.) / (double)n), sum = 1;
            for (int i = f.degree - 1; i >= 0; i--)
                sum = sum * theta + rational_get_double_approx(&f.minimal[i]);
            CHECK(f.degree == degree, "n = %ld: degree %d, not %ld", n, f.degree, degree);
            CHECK(f.degree > 24 || fabs(sum) < 1e-6, "n = %ld: the minimal polynomial is %g at theta", n, sum);
        } else {
            CHECK(degree > NUMBER_FIELD_MAX_DEGREE && !f.failed, "n = %ld: no field", n);
        }
        number_field_free(&f);
    }
    test_end();
}

/* Products of sums of cosines, by both arithmetics and in doubles. */
static void test_products(void)
{
    test_begin("field-products");
    for (test_cases(300); test_next();) {
        long n = random_range(2, 24);
        number_field f;
        cosines x, y, z;
        MUST(number_field_make(&f, n));
        cosines_init(&x), cosines_init(&y), cosines_init(&z);
        set_cosine(&x, random_range(-50, 50), n);
        for (int i = 0; i < 3; i++) {
            set_cosine(&y, random_range(-50, 50), n);
            cosines_set_si(&z, random_range(-5, 5), n);
            cosines_addmul(&y, &z, &x, n);
            rational *a = field_new(&f, 3), *b = field_at(&f, a, 1), *c = field_at(&f, a, 2);
            field_set_cosines(&f, a, &x);
            field_set_cosines(&f, b, &y);
            double expected = value_approx(&f, a) * value_approx(&f, b);
            cosines_mul(&x, &x, &y, n);
            field_set_cosines(&f, c, &x);
            field_mul(&f, a, a, b);
            CHECK(!f.failed && fabs(value_approx(&f, c) - expected) < 1e-8 * (1 + fabs(expected)), "n = %ld: %g, not %g", n, value_approx(&f, c), expected);
            field_sub(&f, a, a, c);
            CHECK(field_is_zero(&f, a), "n = %ld: the products differ", n);
            field_free(&f, a, 3);
        }
        cosines_clear(&x), cosines_clear(&y), cosines_clear(&z);
        number_field_free(&f);
    }
    test_end();
}

/* The cosines of (2i - 1) pi/n, i = 1 .. (n - 1)/2, sum to 1/2 for odd n: forms are unique, and sines are cosines. */
static void test_unique(void)
{
    test_begin("field-unique");
    for (long n = 3; n <= 41; n += 2) {
        number_field f;
        cosines x, sum;
        MUST(number_field_make(&f, n));
        cosines_init(&x), cosines_init(&sum);
        for (long i = 1; i < n; i += 2) {
            set_cosine(&x, i, n);
            cosines_add(&sum, &sum, &x, n);
        }
        rational *a = field_new(&f, 1);
        field_set_cosines(&f, a, &sum);
        CHECK(rational_cmp_si(&a[0], 1, 2) == 0, "n = %ld: the sum is not 1/2", n);
        for (int i = 1; i < f.degree; i++)
            CHECK(rational_is_zero(&a[i]), "n = %ld: the sum is not rational", n);
        field_free(&f, a, 1);
        cosines_clear(&x), cosines_clear(&sum);
        number_field_free(&f);
    }
    test_end();
}

/* What has no exact value is unknown, and what is computed from it. */
static void test_unknown(void)
{
    cosines x, y;
    rational q;
    test_begin("cosines-unknown");
    cosines_init(&x), cosines_init(&y), rational_init(&q);
    MUST(rational_set_si(&q, 1, 7));
    cosines_cos_pi(&x, &q, 10);
    CHECK(x.state == COSINES_UNKNOWN, "cos(pi/7) in the field of pi/10");
    cosines_sin_pi(&x, &q, 7);
    CHECK(x.state == COSINES_UNKNOWN, "sin(pi/7) in the field of pi/7");
    cosines_sin_pi(&x, &q, 14);
    CHECK(x.state == COSINES_KNOWN, "sin(pi/7) is not in the field of pi/14");
    cosines_one(&y);
    cosines_div(&y, &y, &x, 14);
    CHECK(y.state == COSINES_UNKNOWN, "1/sin(pi/7) has a sum of cosines");
    cosines_zero(&x);
    cosines_mul(&x, &x, &y, 14);
    CHECK(x.state == COSINES_UNKNOWN && cosines_is_zero(&x) != TRUTH_TRUE, "0 times something unknown is 0");
    cosines_one(&y);
    cosines_sqrt(&x, &y, 14);
    CHECK(x.state == COSINES_UNKNOWN, "the root of 1 by the field");
    cosines_max(&x, &y, &y, 14);
    CHECK(x.state == COSINES_UNKNOWN, "the larger of equal numbers");
    cosines_hull(&x, &y, &y, 14);
    CHECK(x.state == COSINES_UNKNOWN, "the hull of equal numbers");
    cosines_clear(&x), cosines_clear(&y), rational_clear(&q);
    test_end();
}

static void test_inverse(void)
{
    test_begin("field-inverse");
    for (test_cases(100); test_next();) {
        number_field f;
        MUST(number_field_make(&f, random_range(2, 16)));
        rational *a = field_new(&f, 3), *b = field_at(&f, a, 1), *one = field_at(&f, a, 2);
        random_element(&f, a);
        field_set_si(&f, one, 1);
        if (!field_is_zero(&f, a)) {
            field_inverse(&f, b, a);
            field_mul(&f, b, a, b);
            field_sub(&f, b, b, one);
            CHECK(!f.failed && field_is_zero(&f, b), "n = %ld: x / x is not 1", f.n);
        }
        field_free(&f, a, 3);
        number_field_free(&f);
    }
    test_end();
}

/* p = the product of x - root over random roots, of which `first` is one */
static void random_product(field_polynomial *p, const rational *first, int degree)
{
    number_field *f = p->field;
    field_polynomial linear, next;
    field_polynomial_init(&linear, f), field_polynomial_init(&next, f);
    field_polynomial_make_room(p, 0);
    field_set_si(f, field_polynomial_at(p, 0), 1);
    for (int i = 0; i < degree; i++) {
        field_polynomial_make_room(&linear, 1);
        field_set_si(f, field_polynomial_at(&linear, 1), 1);
        random_element(f, field_polynomial_at(&linear, 0));
        if (i == 0)
            field_neg(f, field_polynomial_at(&linear, 0), first);
        field_polynomial_mul(&next, p, &linear);
        field_polynomial_swap(p, &next);
    }
    field_polynomial_clear(&linear), field_polynomial_clear(&next);
}

static void test_gcd(void)
{
    test_begin("field-gcd");
    for (test_cases(40); test_next();) {
        number_field f;
        field_polynomial p, q, g, rest;
        MUST(number_field_make(&f, random_range(2, 10)));
        field_polynomial_init(&p, &f), field_polynomial_init(&q, &f), field_polynomial_init(&g, &f), field_polynomial_init(&rest, &f);
        rational *root = field_new(&f, 1);
        random_element(&f, root);
        random_product(&p, root, 3);
        random_product(&q, root, 2);
        field_polynomial_gcd(&g, &p, &q);
        CHECK(g.degree >= 1, "n = %ld: a common root, and the greatest common divisor has degree %d", f.n, g.degree);
        field_polynomial_divide(NULL, &rest, &p, &g);
        CHECK(rest.degree < 0, "it does not divide the first");
        field_polynomial_divide(NULL, &rest, &q, &g);
        CHECK(rest.degree < 0, "it does not divide the second");
        field_free(&f, root, 1);
        field_polynomial_clear(&p), field_polynomial_clear(&q), field_polynomial_clear(&g), field_polynomial_clear(&rest);
        number_field_free(&f);
    }
    test_end();
}

/* Cayley and Hamilton; and the coefficient below the first is minus the trace. */
static void test_characteristic(void)
{
    test_begin("field-characteristic");
    for (test_cases(40); test_next();) {
        number_field f;
        field_matrix m;
        field_polynomial p;
        int n = (int)random_range(1, 4);
        MUST(number_field_make(&f, random_range(2, 8)));
        field_matrix_init(&m, &f, n);
        field_polynomial_init(&p, &f);
        rational *v = field_new(&f, (size_t)n), *trace = field_new(&f, 1);
        for (int i = 0; i < n * n; i++)
            random_element(&f, field_at(&f, m.entry, (size_t)i));
        for (int i = 0; i < n; i++) {
            random_element(&f, field_at(&f, v, (size_t)i));
            field_add(&f, trace, trace, field_at(&f, m.entry, (size_t)(i * n + i)));
        }
        field_matrix_characteristic(&p, &m);
        CHECK(p.degree == n, "degree %d, not %d", p.degree, n);
        field_add(&f, trace, trace, field_polynomial_at(&p, n - 1));
        CHECK(field_is_zero(&f, trace), "not the trace");
        field_matrix_apply_polynomial(v, &p, &m);
        CHECK(!f.failed && field_vector_is_zero(&f, v, n), "the matrix is no root of it");
        field_free(&f, v, (size_t)n), field_free(&f, trace, 1);
        field_polynomial_clear(&p);
        field_matrix_clear(&m);
        number_field_free(&f);
    }
    test_end();
}

/* Is x - (3/8 + cos(2 pi m/k)/4) a factor of Loop's block m? */
static void check_loop(const scheme *loop, long k, long m)
{
    number_field f;
    field_matrix b;
    field_polynomial chi, factor, rest;
    cosines l, part;
    MUST(number_field_make(&f, k));
    field_polynomial_init(&chi, &f), field_polynomial_init(&factor, &f), field_polynomial_init(&rest, &f);
    cosines_init(&l), cosines_init(&part);
    CHECK(exact_block_make(&b, &f, loop, k, m) == EXACT_BLOCK_OK, "valence %ld: block %ld has no exact value", k, m);
    field_matrix_characteristic(&chi, &b);
    rational q;
    rational_init(&q);
    set_cosine(&l, 2 * m, k);
    MUST(rational_set_si(&q, 1, 4));
    cosines_set_rational(&part, &q, k);
    cosines_mul(&l, &l, &part, k);
    MUST(rational_set_si(&q, 3, 8));
    cosines_set_rational(&part, &q, k);
    cosines_add(&l, &l, &part, k);
    cosines_neg(&l, &l);
    field_polynomial_make_room(&factor, 1);
    field_set_si(&f, field_polynomial_at(&factor, 1), 1);
    field_set_cosines(&f, field_polynomial_at(&factor, 0), &l);
    field_polynomial_divide(NULL, &rest, &chi, &factor);
    CHECK(chi.degree == b.n && rest.degree < 0 && !f.failed, "valence %ld, block %ld: 3/8 + cos(2 pi m/k)/4 is no eigenvalue", k, m);
    rational_clear(&q);
    cosines_clear(&l), cosines_clear(&part);
    field_polynomial_clear(&chi), field_polynomial_clear(&factor), field_polynomial_clear(&rest);
    field_matrix_clear(&b);
    number_field_free(&f);
}

static void test_blocks(void)
{
    scheme loop;
    test_begin("exact-blocks");
    read_scheme(&loop, LOOP_TEXT);
    for (long k = 3; k <= 17; k++)
        for (long m = 1; 2 * m <= k; m++)
            check_loop(&loop, k, m);
    scheme_clear(&loop);
    test_end();
}

/* Weights by sectors: in block 0 only. */
static void check_sectors(void)
{
    static const char text[] = "scheme made-up\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                               "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) @ j 1/k\nend\n";
    scheme s;
    number_field f;
    field_matrix b;
    read_scheme(&s, text);
    MUST(number_field_make(&f, 12));
    for (long m = 0; m <= 2; m++) {
        CHECK(exact_block_make(&b, &f, &s, 6, m) == (m ? EXACT_BLOCK_NONE : EXACT_BLOCK_OK), "weights by sectors in block %ld", m);
        field_matrix_clear(&b);
    }
    number_field_free(&f);
    scheme_clear(&s);
}

/* Weights that leave the field, intervals and mirror-asymmetric blocks have no exact value. */
static void test_no_blocks(void)
{
    static const char *const centre[] = {"sqrt(cos(pi/k))", "1/(2 + cos(2*pi/k))", "abs(cos(2*pi/k))", "cos(pi/11)"};
    test_begin("exact-blocks-none");
    for (size_t i = 0; i < sizeof centre / sizeof *centre; i++) {
        char text[1024];
        scheme s;
        number_field f;
        field_matrix b;
        snprintf(text, sizeof text, SCHEME_TEXT("(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\n", "%s"), centre[i]);
        read_scheme(&s, text);
        MUST(number_field_make(&f, 10));
        CHECK(exact_block_make(&b, &f, &s, 5, 0) == EXACT_BLOCK_NONE, "%s has an exact value", centre[i]);
        field_matrix_clear(&b);
        number_field_free(&f);
        scheme_clear(&s);
    }
    check_sectors();
    test_end();
}

int main(void)
{
    test_degree();
    test_products();
    test_unique();
    test_unknown();
    test_inverse();
    test_gcd();
    test_characteristic();
    test_blocks();
    test_no_blocks();
    return test_status();
}
