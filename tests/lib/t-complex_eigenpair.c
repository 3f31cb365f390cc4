/* t-complex_eigenpair.c: complex eigenpairs of real matrices (R, -I; I, R), and what is left when one is taken out, for
   matrices P D P^-1 / denominator of Gaussian integers, P of determinant 1. */
#include "lib/eigenpair.h"

#include <math.h>
#include <stdlib.h>

#include "lib/spectrum.h"
#include "region.h"
#include "tests/bigfloat/random.h"
#include "tests/harness.h"

#if defined(NUMBER_INTERVAL)
static const long precisions[] = {53};
#elif defined(NUMBER_BALL)
static const long precisions[] = {64, 128, 256, 1024};
#else
static const long precisions[] = {64, 256, 1024};
#endif
enum { PRECISIONS = sizeof precisions / sizeof *precisions, MOST = 5 };

typedef struct {
    long re, im;
} gaussian;

static gaussian add(gaussian x, gaussian y) { return (gaussian){x.re + y.re, x.im + y.im}; }
static gaussian times(gaussian x, gaussian y) { return (gaussian){x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re}; }
static gaussian minus(gaussian x) { return (gaussian){-x.re, -x.im}; }
static long norm(gaussian x) { return x.re * x.re + x.im * x.im; }

typedef struct {
    int n;
    gaussian b[MOST][MOST], p[MOST][MOST], d[MOST][MOST];
    long denominator;
} known_matrix;

/* b = p d p^-1, by elementary steps. */
static void transform(known_matrix *z, int steps)
{
    static const gaussian units[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int i = 0; i < z->n; i++)
        for (int j = 0; j < z->n; j++) {
            z->b[i][j] = z->d[i][j];
            z->p[i][j] = (gaussian){i == j, 0};
        }
    for (; steps > 0 && z->n > 1; steps--) {
        int to = (int)random_below((uint64_t)z->n), from = (int)random_below((uint64_t)z->n);
        gaussian c = units[random_below(4)];
        if (to == from)
            continue;
        for (int j = 0; j < z->n; j++) /* E b E^-1 and E p, E = 1 + c e_to,from */
            z->b[to][j] = add(z->b[to][j], times(c, z->b[from][j]));
        for (int i = 0; i < z->n; i++)
            z->b[i][from] = add(z->b[i][from], minus(times(c, z->b[i][to])));
        for (int j = 0; j < z->n; j++)
            z->p[to][j] = add(z->p[to][j], times(c, z->p[from][j]));
    }
}

static gaussian random_gaussian(long most) { return (gaussian){random_range(-most, most), random_range(-most, most)}; }

/* The first eigenvalue has the largest modulus, |.| > 20; the others |.| < 13, some of them equal, some in Jordan blocks. */
static void random_matrix(known_matrix *z, int n)
{
    static const long denominators[] = {1, 64, 97, 1000, 3};
    *z = (known_matrix){.n = n, .denominator = denominators[random_below(5)]};
    do
        z->d[0][0] = random_gaussian(24);
    while (norm(z->d[0][0]) < 400);
    for (int i = 1; i < n; i++) {
        z->d[i][i] = i > 1 && random_below(3) == 0 ? z->d[i - 1][i - 1] : random_gaussian(9);
        z->d[i - (i > 1)][i] = i > 1 && random_bool() && norm(add(z->d[i][i], minus(z->d[i - 1][i - 1]))) == 0 ? (gaussian){1, 0} : z->d[i - (i > 1)][i];
    }
    transform(z, 3 * n);
}

static void set_quotient(rational *q, long numerator, long denominator) { MUST(rational_set_si(q, numerator, denominator)); }

/* (R, -I; I, R) */
static number *matrix_numbers(const known_matrix *m, long prec)
{
    int n = m->n, order = 2 * n;
    number *z = number_array_new((size_t)(order * order));
    rational q;
    rational_init(&q);
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++) {
            gaussian b = m->b[i % n][j % n];
            set_quotient(&q, i / n == j / n ? b.re : i / n ? b.im : -b.im, m->denominator);
            number_set_rational(&z[i * order + j], &q, prec);
        }
    rational_clear(&q);
    return z;
}

static void free_matrix(number *z, int order) { number_array_free(z, (size_t)order * (size_t)order); }

/* Does the box contain the pair number e?  Component i of x is p_ie / p_pivot,e. */
static bool box_contains(const number *box, const known_matrix *m, int e, int pivot)
{
    bool yes = norm(m->p[pivot][e]) != 0;
    int n = m->n;
    rational q;
    rational_init(&q);
    for (int i = 0; yes && i < n; i++) {
        gaussian p = m->p[pivot][e], x = times(m->p[i][e], (gaussian){p.re, -p.im});
        set_quotient(&q, x.re, norm(p));
        yes = number_contains_rational(&box[i], &q);
        set_quotient(&q, x.im, norm(p));
        yes = yes && number_contains_rational(&box[i + n], &q);
    }
    set_quotient(&q, m->d[e][e].re, m->denominator);
    yes = yes && number_contains_rational(&box[2 * n], &q);
    set_quotient(&q, m->d[e][e].im, m->denominator);
    yes = yes && number_contains_rational(&box[2 * n + 1], &q);
    rational_clear(&q);
    return yes;
}

static double widest(const number *box, int count)
{
    double width = 0;
    for (int i = 0; i < count; i++) {
        double w = number_upper_bound(&box[i]) - number_lower_bound(&box[i]);
        width = w > width ? w : width;
    }
    return width;
}

static long grid_of(long prec) { return prec < 64 ? 64 : prec; }

static void check_modulus(const number *box, const known_matrix *m, long prec)
{
    number z;
    rational q;
    number_init(&z);
    rational_init(&q);
    eigenpair_modulus(&z, box, 2 * m->n, true, prec);
    CHECK(number_is_positive(&z) == TRUTH_TRUE, "the modulus");
    number_sqr(&z, &z, prec);
    set_quotient(&q, norm(m->d[0][0]), m->denominator * m->denominator);
    CHECK(number_contains_rational(&z, &q), "the square of the modulus");
    rational_clear(&q);
    number_clear(&z);
}

static void test_found(void)
{
    test_begin("complex-eigenpair-found");
    for (test_cases(60); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        random_matrix(&m, (int)random_range(1, MOST));
        int order = 2 * m.n;
        number *b = matrix_numbers(&m, prec), *box = number_array_new(eigenpair_box_size(order, true));
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, order, true, grid_of(prec), prec) == TRUTH_TRUE, "not found, n = %d, precision %ld", m.n, prec);
        if (!test_failed()) {
            CHECK(choice.n == order && choice.complex_form && choice.grid == grid_of(prec) && choice.pivot >= 0 && choice.pivot < m.n && integer_sign(&choice.radius) > 0, "choice");
            CHECK(eigenpair_prove(box, &choice, b, prec) == TRUTH_TRUE, "not proved, n = %d, precision %ld", m.n, prec);
            CHECK(box_contains(box, &m, 0, choice.pivot), "the box does not contain the eigenpair, n = %d, precision %ld", m.n, prec);
            CHECK(widest(box, order + 2) < (prec < 64 ? 1e-8 : 1e-12), "the box is %.3g wide at precision %ld", widest(box, order + 2), prec);
            CHECK(number_is_thin(&box[choice.pivot]) && number_is_zero(&box[choice.pivot + m.n]) == TRUTH_TRUE, "the pivot's 1");
            check_modulus(box, &m, prec);
        }
        eigenpair_choice_clear(&choice);
        free_matrix(b, order);
        number_array_free(box, eigenpair_box_size(order, true));
    }
    test_end();
}

/* A real matrix: the same eigenvalue as in the real form, and an imaginary part that contains 0. */
static void test_real(void)
{
    test_begin("complex-eigenpair-of-real-matrix");
    for (test_cases(30); test_next();) {
        known_matrix m = {.n = (int)random_range(1, MOST), .denominator = 8};
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        m.d[0][0] = (gaussian){random_bool() ? -20 : 20, 0};
        for (int i = 1; i < m.n; i++)
            m.d[i][i] = (gaussian){random_range(-9, 9), 0};
        transform(&m, 0);
        for (int s = 0; s < 3 * m.n; s++) { /* real steps */
            int to = (int)random_below((uint64_t)m.n), from = (int)random_below((uint64_t)m.n);
            for (int j = 0; to != from && j < m.n; j++)
                m.b[to][j] = add(m.b[to][j], m.b[from][j]), m.p[to][j] = add(m.p[to][j], m.p[from][j]);
            for (int i = 0; to != from && i < m.n; i++)
                m.b[i][from] = add(m.b[i][from], minus(m.b[i][to]));
        }
        int order = 2 * m.n;
        number *b = matrix_numbers(&m, prec), *box = number_array_new(eigenpair_box_size(order, true));
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, order, true, grid_of(prec), prec) == TRUTH_TRUE && eigenpair_prove(box, &choice, b, prec) == TRUTH_TRUE, "not proved");
        CHECK(test_failed() || (box_contains(box, &m, 0, choice.pivot) && number_contains_zero(&box[order + 1])), "the box");
        eigenpair_choice_clear(&choice);
        free_matrix(b, order);
        number_array_free(box, eigenpair_box_size(order, true));
    }
    test_end();
}

/* Two eigenvalues of the same modulus: conjugates, opposites, multiples. */
static void test_tied(void)
{
    test_begin("complex-eigenpair-tied");
    for (test_cases(40); test_next();) {
        known_matrix m = {.n = (int)random_range(2, MOST), .denominator = 3};
        eigenpair_choice choice;
        gaussian big = {random_range(15, 20), random_range(3, 9)};
        long prec = precisions[random_below(PRECISIONS)];
        m.d[0][0] = big;
        m.d[1][1] = random_below(3) == 0 ? minus(big) : random_bool() ? (gaussian){big.re, -big.im} : (gaussian){big.im, big.re};
        for (int i = 2; i < m.n; i++)
            m.d[i][i] = random_gaussian(7);
        transform(&m, 6);
        number *b = matrix_numbers(&m, prec);
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, 2 * m.n, true, grid_of(prec), prec) == TRUTH_UNKNOWN, "one of two eigenvalues was chosen");
        eigenpair_choice_clear(&choice);
        free_matrix(b, 2 * m.n);
    }
    test_end();
}

static void add_small(integer *z, const integer *unit, long count)
{
    integer t;
    integer_init(&t);
    MUST(integer_mul_si(&t, unit, count));
    MUST(integer_add(z, z, &t));
    integer_clear(&t);
}

static void tamper(eigenpair_choice *c)
{
    integer *x = &c->approximation[random_below((uint64_t)c->n)], *y = &c->inverse[random_below((uint64_t)(c->n * c->n))];
    switch (random_below(8)) {
    case 0:
        add_small(x, &c->radius, random_range(-4, 4));
        break;
    case 1:
        MUST(integer_fdiv_2exp(x, x, (unsigned long)random_below(4)));
        break;
    case 2:
        MUST(integer_fdiv_2exp(&c->radius, &c->radius, (unsigned long)random_below(30)));
        break;
    case 3:
        MUST(integer_mul_2exp(&c->radius, &c->radius, (unsigned long)random_below((uint64_t)c->grid)));
        break;
    case 4:
        MUST(integer_neg(&c->radius, &c->radius));
        break;
    case 5: /* the conjugate */
        x = &c->approximation[c->n - 1];
        MUST(integer_neg(x, x));
        break;
    case 6:
        MUST(integer_neg(y, y));
        break;
    default:
        c->pivot = (int)random_below((uint64_t)c->n); /* from n/2 on it is none */
    }
}

static void test_wrong_choices(void)
{
    int accepted = 0, refused = 0;
    test_begin("complex-eigenpair-wrong-choices");
    for (test_cases(120); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        random_matrix(&m, (int)random_range(1, 4));
        int order = 2 * m.n;
        number *b = matrix_numbers(&m, prec), *box = number_array_new(eigenpair_box_size(order, true));
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, order, true, grid_of(prec), prec) == TRUTH_TRUE, "not found");
        if (!test_failed()) {
            bool nonsense;
            tamper(&choice);
            nonsense = integer_sign(&choice.radius) <= 0 || choice.pivot >= m.n;
            if (eigenpair_prove(box, &choice, b, prec) == TRUTH_TRUE) {
                accepted++;
                CHECK(!nonsense, "a box without inside, or an imaginary pivot, is accepted");
                CHECK(box_contains(box, &m, 0, choice.pivot), "accepted, but the eigenpair is not in the box");
            } else
                refused++;
        }
        eigenpair_choice_clear(&choice);
        free_matrix(b, order);
        number_array_free(box, eigenpair_box_size(order, true));
    }
    CHECK(accepted + refused < 100 || (accepted > 0 && refused > 0), "%d accepted, %d refused", accepted, refused);
    test_end();
}

/* The eigenvalue is double, with two eigenvectors or one: a choice from a neighbouring matrix, where it is simple, must
   not prove it simple. */
static void test_double(void)
{
    test_begin("complex-eigenpair-double");
    for (test_cases(60); test_next();) {
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)], apart = 1L << random_range(4, 20);
        known_matrix m = {.n = (int)random_range(2, 4), .denominator = apart}, near;
        gaussian big = {random_range(15, 20) * apart, random_range(3, 9) * apart};
        m.d[0][0] = m.d[1][1] = big;
        m.d[0][1] = random_bool() ? (gaussian){apart, 0} : (gaussian){0, 0};
        near = m;
        near.d[1][1].re -= 1;
        near.d[1][1].im -= 1;
        transform(&m, 0);
        transform(&near, 0);
        number *b = matrix_numbers(&m, prec), *c = matrix_numbers(&near, prec), *box = number_array_new(eigenpair_box_size(2 * m.n, true));
        eigenpair_choice_init(&choice);
        if (eigenpair_choose(&choice, c, 2 * m.n, true, grid_of(prec), prec) == TRUTH_TRUE)
            for (int tries = 0; tries < 6 && integer_bits(&choice.radius) < (size_t)choice.grid; tries++) {
                CHECK(eigenpair_prove(box, &choice, b, prec) != TRUTH_TRUE, "a double eigenvalue is simple, precision %ld", prec);
                MUST(integer_mul_2exp(&choice.radius, &choice.radius, (unsigned long)random_below(20)));
            }
        eigenpair_choice_clear(&choice);
        free_matrix(b, 2 * m.n), free_matrix(c, 2 * m.n);
        number_array_free(box, eigenpair_box_size(2 * m.n, true));
    }
    test_end();
}

/* ---- deflation ---- */

/* z = x y, order x order. */
static void multiply(number *z, const number *x, const number *y, int order, long prec)
{
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++) {
            number_zero(&z[i * order + j]);
            for (int l = 0; l < order; l++)
                number_addmul(&z[i * order + j], &x[i * order + l], &y[l * order + j], prec);
        }
}

/* The traces of the powers of (R, -I; I, R), in R and in I, are those of the eigenvalues but the first. */
static void check_traces(const number *rest, const known_matrix *m, long prec)
{
    int n = m->n - 1, order = 2 * n;
    number *power = number_array_new((size_t)(order * order)), *next = number_array_new((size_t)(order * order));
    number re, im;
    rational q;
    long scale = 1;
    number_init(&re), number_init(&im);
    rational_init(&q);
    for (int i = 0; i < order * order; i++)
        number_set_si(&power[i], i / order == i % order, prec);
    for (int p = 1; p <= n; p++) {
        gaussian sum = {0, 0};
        multiply(next, power, rest, order, prec);
        for (int i = 0; i < order * order; i++)
            number_set(&power[i], &next[i]);
        number_zero(&re), number_zero(&im);
        for (int i = 0; i < n; i++) {
            number_add(&re, &re, &power[i * order + i], prec);
            number_add(&im, &im, &power[(i + n) * order + i], prec);
            for (int j = 0; j < n; j++)
                CHECK(fabs(number_mid_approx(&rest[i * order + j]) - number_mid_approx(&rest[(i + n) * order + j + n])) < 1e-9
                          && fabs(number_mid_approx(&rest[i * order + j + n]) + number_mid_approx(&rest[(i + n) * order + j])) < 1e-9, "the shape (R, -I; I, R)");
        }
        for (int e = 1; e <= n; e++) {
            gaussian v = {1, 0};
            for (int i = 0; i < p; i++)
                v = times(v, m->d[e][e]);
            sum = add(sum, v);
        }
        scale *= m->denominator;
        set_quotient(&q, sum.re, scale);
        CHECK(number_contains_rational(&re, &q), "the trace of power %d", p);
        set_quotient(&q, sum.im, scale);
        CHECK(number_contains_rational(&im, &q), "the imaginary trace of power %d", p);
        CHECK(number_upper_bound(&re) - number_lower_bound(&re) < 1e-3, "the trace of power %d is wide", p);
    }
    rational_clear(&q);
    number_clear(&re), number_clear(&im);
    number_array_free(power, (size_t)(order * order)), number_array_free(next, (size_t)(order * order));
}

static void test_deflation(void)
{
    test_begin("complex-deflate");
    for (test_cases(100); test_next();) {
        known_matrix m;
        int pivot;
        long prec = precisions[random_below(PRECISIONS)];
        random_matrix(&m, (int)random_range(2, MOST));
        int n = m.n, order = 2 * n;
        rational q;
        rational_init(&q);
        do
            pivot = (int)random_below((uint64_t)n);
        while (norm(m.p[pivot][0]) == 0);
        number *b = matrix_numbers(&m, prec), *x = number_array_new((size_t)order), *rest = number_array_new((size_t)((order - 2) * (order - 2)));
        for (int i = 0; i < n; i++) {
            gaussian p = m.p[pivot][0], y = times(m.p[i][0], (gaussian){p.re, -p.im});
            set_quotient(&q, y.re, norm(p));
            number_set_rational(&x[i], &q, prec);
            set_quotient(&q, y.im, norm(p));
            number_set_rational(&x[i + n], &q, prec);
        }
        matrix_deflate_complex(rest, b, x, order, pivot, prec);
        check_traces(rest, &m, prec);
        rational_clear(&q);
        free_matrix(b, order), free_matrix(rest, order - 2);
        number_array_free(x, (size_t)order);
    }
    test_end();
}

static void tests(void)
{
    test_found();
    test_real();
    test_tied();
    test_wrong_choices();
    test_double();
    test_deflation();
}
MAIN(tests);
