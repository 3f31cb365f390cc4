/* t-eigenpair.c: what is proved of an eigenpair is true, and what is true is proved. */
#include "lib/eigenpair.h"

#include <stdlib.h>

#include "region.h"
#include "matrix.h"

#if defined(NUMBER_INTERVAL)
static const long precisions[] = {53};
#elif defined(NUMBER_BALL)
static const long precisions[] = {64, 128, 256, 1024};
#else
static const long precisions[] = {64, 256, 1024};
#endif
enum { PRECISIONS = sizeof precisions / sizeof *precisions };

static long grid_of(long prec)
{
    return prec < 64 ? 64 : prec;
}

/* Component i of eigenvector number e, with 1 at the pivot; false if the eigenvector is 0 there. */
static bool exact_component(rational *q, const known_matrix *m, int e, int i, int pivot)
{
    if (m->p[pivot][e] == 0)
        return false;
    MUST(rational_set_si(q, m->p[i][e], m->p[pivot][e]));
    return true;
}

/* Does the box contain the exact pair number e? */
static bool box_contains(const number *box, const known_matrix *m, int e, int pivot)
{
    bool yes = true;
    rational q;
    rational_init(&q);
    for (int i = 0; yes && i < m->n; i++)
        yes = exact_component(&q, m, e, i, pivot) && number_contains_rational(&box[i], &q);
    MUST(rational_set_si(&q, m->d[e][e], m->denominator));
    yes = yes && number_contains_rational(&box[m->n], &q);
    rational_clear(&q);
    return yes;
}

static int count_contained(const number *box, const known_matrix *m, int pivot)
{
    int count = 0;
    for (int e = 0; e < m->n; e++)
        count += box_contains(box, m, e, pivot);
    return count;
}

static double widest(const number *box, int n)
{
    double width = 0;
    for (int i = 0; i <= n; i++) {
        double w = number_upper_bound(&box[i]) - number_lower_bound(&box[i]);
        width = w > width ? w : width;
    }
    return width;
}

static void test_found(void)
{
    test_begin("eigenpair-found");
    for (test_cases(60); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        random_real_matrix(&m, (int)random_range(1, MATRIX_MAX));
        number *b = matrix_numbers(&m, prec), *box = number_array_new((size_t)m.n + 1);
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, m.n, false, grid_of(prec), prec) == TRUTH_TRUE, "not found, n = %d, precision %ld", m.n, prec);
        if (!test_failed()) {
            CHECK(choice.n == m.n && choice.grid == grid_of(prec) && integer_sign(&choice.radius) > 0, "choice");
            CHECK(eigenpair_prove(box, &choice, b, prec) == TRUTH_TRUE, "not proved, n = %d, precision %ld", m.n, prec);
            CHECK(box_contains(box, &m, 0, choice.pivot), "the box does not contain the eigenpair, n = %d, precision %ld", m.n, prec);
            CHECK(count_contained(box, &m, choice.pivot) == 1, "more than one eigenpair in the box");
            CHECK(widest(box, m.n) < (prec < 64 ? 1e-8 : 1e-12), "the box is %.3g wide at precision %ld", widest(box, m.n), prec);
            CHECK(number_is_thin(&box[choice.pivot]), "the pivot's 1");
        }
        eigenpair_choice_clear(&choice);
        number_array_free(b, (size_t)(m.n * m.n));
        number_array_free(box, (size_t)m.n + 1);
    }
    test_end();
}

/* What holds for all matrices of an enclosure holds for one of them. */
static void test_enclosure(void)
{
    test_begin("eigenpair-of-enclosure");
    for (test_cases(30); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        number error;
        number_init(&error);
        random_real_matrix(&m, (int)random_range(1, 4));
        number *b = matrix_numbers(&m, prec), *box = number_array_new((size_t)m.n + 1);
        eigenpair_choice_init(&choice);
        number_set_double(&error, 0x1p-30, prec);
        for (int i = 0; i < m.n * m.n; i++)
            number_add_error(&b[i], &b[i], &error, prec);
        CHECK(eigenpair_choose(&choice, b, m.n, false, grid_of(prec), prec) == TRUTH_TRUE && eigenpair_prove(box, &choice, b, prec) == TRUTH_TRUE, "not proved");
        CHECK(test_failed() || box_contains(box, &m, 0, choice.pivot), "the box does not contain the eigenpair");
        /* and the corners of the enclosure: shifting the diagonal by 2^-30 moves the eigenvalue by as much */
        CHECK(test_failed() || widest(box + m.n, 0) >= 0x1p-29, "the eigenvalue is too certain");
        eigenpair_choice_clear(&choice);
        number_array_free(b, (size_t)(m.n * m.n));
        number_array_free(box, (size_t)m.n + 1);
        number_clear(&error);
    }
    test_end();
}

static void add_small(integer *z, const integer *unit, long times)
{
    integer t;
    integer_init(&t);
    MUST(integer_mul_si(&t, unit, times));
    MUST(integer_add(z, z, &t));
    integer_clear(&t);
}

/* Changes something of a choice that proves. */
static void tamper(eigenpair_choice *c)
{
    integer *x = &c->approximation[random_below((uint64_t)c->n)], *y = &c->inverse[random_below((uint64_t)(c->n * c->n))];
    switch (random_below(9)) {
    case 0: /* the midpoint moves */
        add_small(x, &c->radius, random_range(-4, 4));
        break;
    case 1:
        MUST(integer_fdiv_2exp(x, x, (unsigned long)random_below(4)));
        break;
    case 2: /* the box shrinks */
        MUST(integer_fdiv_2exp(&c->radius, &c->radius, (unsigned long)random_below(30)));
        break;
    case 3:
        integer_set_si(&c->radius, random_range(-1, 2));
        break;
    case 4: /* the box grows */
        MUST(integer_mul_2exp(&c->radius, &c->radius, (unsigned long)random_below((uint64_t)c->grid)));
        break;
    case 5:
        MUST(integer_neg(&c->radius, &c->radius));
        break;
    case 6:
        integer_zero(y);
        break;
    case 7:
        MUST(integer_neg(y, y));
        break;
    default:
        c->pivot = (int)random_below((uint64_t)c->n);
    }
}

static void test_wrong_choices(void)
{
    int accepted = 0, refused = 0;
    test_begin("eigenpair-wrong-choices");
    for (test_cases(150); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        random_real_matrix(&m, (int)random_range(1, 5));
        number *b = matrix_numbers(&m, prec), *box = number_array_new((size_t)m.n + 1);
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, m.n, false, grid_of(prec), prec) == TRUTH_TRUE, "not found");
        if (!test_failed()) {
            bool nonsense;
            tamper(&choice);
            if (random_bool())
                tamper(&choice);
            nonsense = integer_sign(&choice.radius) <= 0;
            truth t = eigenpair_prove(box, &choice, b, prec);
            CHECK(t != TRUTH_FALSE, "no memory");
            if (t == TRUTH_TRUE) {
                accepted++;
                CHECK(!nonsense, "a box without inside is accepted");
                CHECK(count_contained(box, &m, choice.pivot) == 1, "accepted, but the box contains %d eigenpairs", count_contained(box, &m, choice.pivot));
            } else
                refused++;
        }
        eigenpair_choice_clear(&choice);
        number_array_free(b, (size_t)(m.n * m.n));
        number_array_free(box, (size_t)m.n + 1);
    }
    CHECK(accepted + refused < 100 || (accepted > 0 && refused > 0), "%d accepted, %d refused", accepted, refused);
    test_end();
}

/* A choice that is right for one matrix says nothing of another one. */
static void test_other_matrix(void)
{
    test_begin("eigenpair-other-matrix");
    for (test_cases(60); test_next();) {
        known_matrix m;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        random_real_matrix(&m, (int)random_range(1, 5));
        number *b = matrix_numbers(&m, prec), *box = number_array_new((size_t)m.n + 1);
        eigenpair_choice_init(&choice);
        CHECK(eigenpair_choose(&choice, b, m.n, false, grid_of(prec), prec) == TRUTH_TRUE, "not found");
        number_array_free(b, (size_t)(m.n * m.n));
        /* all eigenvalues move by a thousandth of the old denominator, and no eigenvector moves */
        m.denominator *= 1000;
        for (int i = 0; i < m.n; i++) {
            for (int j = 0; j < m.n; j++)
                m.b[i][j] = 1000 * m.b[i][j] + (i == j);
            m.d[i][i] = 1000 * m.d[i][i] + 1;
        }
        b = matrix_numbers(&m, prec);
        CHECK(test_failed() || eigenpair_prove(box, &choice, b, prec) != TRUTH_TRUE || count_contained(box, &m, choice.pivot) == 1, "proved for another matrix");
        CHECK(test_failed() || eigenpair_prove(box, &choice, b, prec) == TRUTH_UNKNOWN, "proved again: so wide a box is not expected");
        eigenpair_choice_clear(&choice);
        number_array_free(b, (size_t)(m.n * m.n));
        number_array_free(box, (size_t)m.n + 1);
    }
    test_end();
}

/* The dominant eigenvalue is double, with one eigenvector or two: no choice can prove it simple.  The choices tried
   come from the matrix itself and from neighbours where it is simple. */
static void test_double(void)
{
    test_begin("eigenpair-double-eigenvalue");
    for (test_cases(80); test_next();) {
        known_matrix m, near;
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        int n = (int)random_range(2, 5), apart = (int)random_range(4, 24);
        m = (known_matrix){.n = n, .denominator = 1L << apart};
        m.d[0][0] = m.d[1][1] = random_range(20, 30) * m.denominator;
        m.d[0][1] = random_bool() ? m.denominator : 0;
        for (int i = 2; i < n; i++)
            m.d[i][i] = random_range(-15, 15) * m.denominator;
        near = m;
        near.d[1][1] -= 1; /* the eigenvalues are 2^-apart away from each other */
        uint64_t steps = random_below(8);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                m.b[i][j] = m.d[i][j], near.b[i][j] = near.d[i][j];
        for (uint64_t s = 0; s < steps; s++) {
            int to = (int)random_below((uint64_t)n), from = (int)random_below((uint64_t)n);
            if (to == from)
                continue;
            for (int j = 0; j < n; j++)
                m.b[to][j] += m.b[from][j], near.b[to][j] += near.b[from][j];
            for (int i = 0; i < n; i++)
                m.b[i][from] -= m.b[i][to], near.b[i][from] -= near.b[i][to];
        }
        number *b = matrix_numbers(&m, prec), *c = matrix_numbers(&near, prec), *box = number_array_new((size_t)n + 1);
        rational dominant;
        rational_init(&dominant);
        MUST(rational_set_si(&dominant, m.d[0][0], m.denominator));
        for (int from_near = 0; from_near < 2; from_near++) {
            eigenpair_choice_init(&choice);
            if (eigenpair_choose(&choice, from_near ? c : b, n, false, grid_of(prec), prec) == TRUTH_TRUE || (choice.n == n && choice.inverse))
                for (int tries = 0; tries < 6; tries++) {
                    if (tries)
                        MUST(integer_mul_2exp(&choice.radius, &choice.radius, (unsigned long)random_below(20)));
                    if (integer_bits(&choice.radius) > (size_t)choice.grid + 2) /* it may reach other eigenvalues */
                        break;
                    CHECK(eigenpair_prove(box, &choice, b, prec) != TRUTH_TRUE || !number_contains_rational(&box[n], &dominant), "a double eigenvalue is simple, precision %ld", prec);
                    CHECK(eigenpair_prove(box, &choice, b, prec) != TRUTH_TRUE || number_upper_bound(&box[n]) < 16, "an eigenvalue that is not there, precision %ld", prec);
                }
            eigenpair_choice_clear(&choice);
        }
        rational_clear(&dominant);
        number_array_free(b, (size_t)(n * n)), number_array_free(c, (size_t)(n * n));
        number_array_free(box, (size_t)n + 1);
    }
    test_end();
}

/* A rotation has no real eigenvalue. */
static void test_none(void)
{
    test_begin("eigenpair-complex");
    for (test_cases(20); test_next();) {
        known_matrix m = {.n = (int)random_range(2, 5), .denominator = 8};
        eigenpair_choice choice;
        long prec = precisions[random_below(PRECISIONS)];
        m.d[0][0] = m.d[1][1] = random_range(0, 20);
        m.d[1][0] = random_range(8, 20), m.d[0][1] = -m.d[1][0];
        transform(&m, 5, 0);
        number *b = matrix_numbers(&m, prec), *box = number_array_new((size_t)m.n + 1);
        eigenpair_choice_init(&choice);
        if (eigenpair_choose(&choice, b, m.n, false, grid_of(prec), prec) == TRUTH_TRUE) {
            CHECK(m.n > 2, "a real eigenvalue of a rotation");
            CHECK(eigenpair_prove(box, &choice, b, prec) != TRUTH_TRUE || (m.n == 3 && number_contains_zero(&box[m.n])), "an eigenvalue that is not there");
        }
        eigenpair_choice_clear(&choice);
        number_array_free(b, (size_t)(m.n * m.n));
        number_array_free(box, (size_t)m.n + 1);
    }
    test_end();
}

static void tests(void)
{
    test_found();
    test_enclosure();
    test_wrong_choices();
    test_other_matrix();
    test_double();
    test_none();
}
MAIN(tests);
