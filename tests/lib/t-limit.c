/* t-limit.c: Laurent values of formulas, centres that come to rest, and block 0 of many valences behind block 1. */
#include "lib/eigen_approx.h"
#include "lib/eigenpair_affine.h"
#include "lib/limit.h"
#include "lib/laurent_value.h"
#include "lib/resting_centre.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { GRID = 64, PRECISION = 128 };

/* ---- Laurent values ---- */

static formula *read_formula(const char *text)
{
    static const definitions none;
    static long column[1001];
    diagnostic d;
    formula *f = NULL;
    for (long i = 0; i <= 1000; i++)
        column[i] = i + 1;
    CHECK(formula_read(&f, text, strlen(text), 1, column, &none, FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY, &d) == STATUS_OK, "'%s': %s", text, d.text);
    return f;
}

/* The sum of c_i k^i. */
static void evaluate(rational *z, const laurent_value *x, long k)
{
    rational power, q;
    rational_init(&power), rational_init(&q);
    MUST(rational_set_si(z, 0, 1));
    for (int i = laurent_value_low(x); i <= laurent_value_high(x); i++) {
        MUST(rational_set_si(&q, k, 1) && rational_pow(&power, &q, i) && rational_mul(&power, &power, laurent_value_at(x, i)) && rational_add(z, z, &power));
    }
    rational_clear(&power), rational_clear(&q);
}

/* Laurent or not over k >= first, of these degrees. */
static void check_value(const char *text, long first, bool expected, int low, int high)
{
    formula *f = read_formula(text);
    laurent_value x;
    rational value, exact;
    diagnostic d;
    bool known = false;
    rational_init(&value), rational_init(&exact);
    MUST(laurent_value_make(&x) && formula_laurent_value(&x, &known, f, (valence_range){first, VALENCES_UNBOUNDED}));
    CHECK(known == expected, "'%s' is %sknown", text, known ? "" : "not ");
    if (known && expected) {
        CHECK(laurent_value_low(&x) == low && laurent_value_high(&x) == high, "'%s' has degrees %d to %d", text, laurent_value_low(&x), laurent_value_high(&x));
        for (long k = first; k < first + 5; k++) {
            formula_point at = {k, 0, 0};
            evaluate(&value, &x, k);
            CHECK(formula_exact_rational(&exact, f, &at, &d) == STATUS_OK && rational_equal(&value, &exact), "'%s' at %ld", text, k);
        }
    }
    laurent_value_clear(&x);
    rational_clear(&value), rational_clear(&exact);
    formula_free(f);
}

static void test_values(void)
{
    test_begin("laurent-values");
    check_value("1 - 3/k", 3, true, -1, 0);
    check_value("k", 3, true, 1, 1);
    check_value("7/3", 3, true, 0, 0);
    check_value("(k - 1)*(k + 1)/k^2", 3, true, -2, 0);
    check_value("(1 - 1/k)^3", 3, true, -3, 0);
    check_value("-(2/k)^2 + 4/(k*k)", 3, true, 0, 0);
    check_value("(k^2 - k)/k - k", 3, true, 0, 0);
    check_value("k^0", 3, true, 0, 0);
    check_value("2^(3 - 1)/k", 3, true, -1, -1);
    check_value("k^64", 3, true, 64, 64);
    check_value("1/k^64", 3, true, -64, -64);
    check_value("cases(k < 8: 1; k != 10: 1/k; else: k)", 11, true, -1, -1);
    check_value("cases(k < 8: 1; k != 10: 1/k; else: k)", 9, false, 0, 0);
    check_value("k^65", 3, false, 0, 0);
    check_value("k^-1", 3, true, -1, -1);
    check_value("1 - 3*(2/k)^-(1 + 1)", 3, true, 0, 2);
    check_value("(k + 1)^-1", 3, false, 0, 0);
    check_value("(k - k)^-1", 3, false, 0, 0);
    check_value("2^k", 3, false, 0, 0);
    check_value("1/(k + 1)", 3, false, 0, 0);
    check_value("1/(k - k)", 3, false, 0, 0);
    check_value("k/(k + 1 - 1)", 3, true, 0, 0);
    check_value("cos(2*pi/k)", 3, false, 0, 0);
    check_value("min(k, 2)", 3, false, 0, 0);
    check_value("m/k", 3, false, 0, 0);
    check_value("cases(m = 0: 1; else: 1)", 3, false, 0, 0);
    check_value("pi/pi", 3, false, 0, 0);
    test_end();
}

/* ---- centres ---- */

#define CENTRE_TEXT(centre) "scheme x\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2 centre " centre "\nend\n"
#define CATMULL_CLARK CENTRE_TEXT("1 - 3/k, 2/k")
#define SLOW CENTRE_TEXT("1 - 3/k^2, 2/k^2")
#define GROWING CENTRE_TEXT("1 + 3/k, 0 - 2/k")
#define NOT_AT_REST CENTRE_TEXT("3/4 - 3/k, 2/k")
#define EDGES_STAY CENTRE_TEXT("1 - 3/k, 1/4 + 2/k")
#define BEYOND_BOUNDS CENTRE_TEXT("1 - k, k")
#define NO_POLYNOMIAL CENTRE_TEXT("1 - 3/(k + 1), 2/k")

static bool rests(const char *text, long first, long last)
{
    scheme s;
    diagnostic d;
    bool z;
    read_scheme(&s, text);
    CHECK(scheme_centre_rests(&z, &s, (valence_range){first, last}, &d) == STATUS_OK, "%s", s.name);
    scheme_clear(&s);
    return z;
}

static void test_centres(void)
{
    const long all = VALENCES_UNBOUNDED;
    test_begin("centres-at-rest");
    CHECK(rests(CATMULL_CLARK, 3, all) && rests(catalogue_text("catmull-clark"), 20, all) && rests(SLOW, 20, all) && rests(GROWING, 20, all), "centres that come to rest");
    CHECK(!rests(CATMULL_CLARK, 20, 1000000), "of finitely many valences");
    CHECK(!rests(NOT_AT_REST, 20, all) && !rests(EDGES_STAY, 20, all) && !rests(NO_POLYNOMIAL, 20, all) && !rests(BEYOND_BOUNDS, 20, all), "centres that do not");
    CHECK(!rests(catalogue_text("loop"), 20, all) && !rests(catalogue_text("modified-butterfly"), 20, all) && !rests(catalogue_text("kobbelt"), 20, all), "other rules");
    CHECK(!rests(catalogue_text("doo-sabin"), 20, all), "a mesh without centre");
    CHECK(rests(catalogue_text("butterfly"), 7, all), "a mask that keeps it");
    test_end();
}

/* ---- block 0 as a function of 1/k ---- */

/* The entry of block 0 without the constant net, at valence k, is in c + d t, t = 2 k1/k - 1. */
static void check_matrix(const char *text, long first, long k)
{
    scheme s;
    affine_matrix matrix;
    scheme_numbers numbers;
    block b;
    diagnostic d;
    number t, x, entry;
    number_init(&t), number_init(&x), number_init(&entry);
    read_scheme(&s, text);
    number_set_si(&t, 2 * first - k, PRECISION);
    number_div_si(&t, &t, k, PRECISION);
    CHECK(affine_matrix_make_resting(&matrix, &s, (valence_range){first, VALENCES_UNBOUNDED}, PRECISION, &d) == BLOCK_OK, "the matrix");
    CHECK(scheme_numbers_make(&numbers, &s, k, PRECISION, &d) == STATUS_OK && block_make(&b, &numbers, 0, true, &d) == BLOCK_OK && b.n == matrix.n + 1, "block 0");
    for (int i = 0; i < matrix.n; i++)
        for (int j = 0; j < matrix.n; j++) {
            const affine *z = &matrix.entry[i * matrix.n + j];
            number_mul(&x, &t, &z->slope, PRECISION);
            number_add(&x, &x, &z->centre, PRECISION);
            number_sub(&entry, &b.entry[(i + 1) * b.n + j + 1], &b.entry[j + 1], PRECISION);
            CHECK(number_less(&x, &entry) != TRUTH_TRUE && number_less(&entry, &x) != TRUTH_TRUE, "from %ld: entry %d, %d at %ld", first, i, j, k);
            CHECK(number_upper_bound(&x) - number_lower_bound(&x) < 1e-2, "entry %d, %d is wide", i, j);
        }
    affine_matrix_free(&matrix);
    block_free(&b);
    scheme_numbers_free(&numbers);
    number_clear(&t), number_clear(&x), number_clear(&entry);
    scheme_clear(&s);
}

static void test_matrix(void)
{
    static const char *const text[] = {CATMULL_CLARK, SLOW, CENTRE_TEXT("1 - 3/k + 2*(1/k)^3, (k + 1)/k^2 - 5/k"), GROWING};
    test_begin("block-0-and-1/k");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        for (int c = 0; c < 5; c++) {
            long first = random_range(15, 300);
            check_matrix(text[i], first, c ? first * random_range(1, 1000) : first);
        }
    test_end();
}

/* ---- the proof ---- */

typedef struct {
    scheme s;
    valence_range k;
    number scale;
    affine *box; /* block 1 */
    int n;
    rise_list list; /* one box */
    limit_answer found;
} setting;

static limit_task task_of(const setting *z)
{
    return (limit_task){&z->s, z->k, &z->scale, &z->box[z->n].slope};
}

static void search(setting *z, const char *text, long first)
{
    affine_matrix matrix;
    eigenpair_choice choice;
    diagnostic d = {0, 0, ""};
    arc r;
    read_scheme(&z->s, text);
    z->k = (valence_range){first, VALENCES_UNBOUNDED};
    number_init(&z->scale);
    rise_list_init(&z->list);
    arc_init(&r);
    eigenpair_choice_init(&choice);
    MUST(arc_set_valences(&r, z->k));
    CHECK(affine_matrix_make(&matrix, &z->s, z->k, one_frequency(1), &r, PRECISION, &d) == BLOCK_OK, "the matrix");
    z->n = matrix.n;
    z->box = affine_array_new((size_t)z->n + 1);
    CHECK(eigenpair_affine_choose(&choice, matrix.entry, z->n, GRID, PRECISION) == TRUTH_TRUE && eigenpair_affine_prove(z->box, &choice, matrix.entry, z->n, PRECISION) == TRUTH_TRUE, "no pair from %ld", first);
    affine_range(&z->scale, &z->box[z->n], PRECISION);
    number_lower(&z->scale, &z->scale, PRECISION);
    number_inv(&z->scale, &z->scale, PRECISION);
    number_upper(&z->scale, &z->scale, PRECISION);
    limit_task task = task_of(z);
    z->found = limit_search(rise_list_add(&z->list), &task, 10000, GRID, PRECISION, &d);
    CHECK(z->found.status == BLOCK_OK, "from %ld: %s", first, d.text);
    affine_matrix_free(&matrix);
    eigenpair_choice_clear(&choice);
    arc_clear(&r);
}

static void clear(setting *z)
{
    affine_array_free(z->box, (size_t)z->n + 1);
    rise_list_clear(&z->list);
    number_clear(&z->scale);
    scheme_clear(&z->s);
}

static bool verifies(const setting *z)
{
    limit_task task = task_of(z);
    diagnostic d;
    return limit_verify(&z->list.box[0], &task, PRECISION, &d).proved;
}

/* About the largest modulus of an eigenvalue of a block, but for that of the constant net. */
static double radius(const scheme *s, long m, long k)
{
    scheme_numbers numbers;
    block b;
    diagnostic d;
    double *entry, z = NAN;
    CHECK(scheme_numbers_make(&numbers, s, k, PRECISION, &d) == STATUS_OK && block_make(&b, &numbers, m, true, &d) == BLOCK_OK, "block %ld of %ld", m, k);
    int from = m == 0, n = b.n - from;
    entry = malloc((size_t)n * (size_t)n * sizeof *entry);
    for (int i = 0; entry && i < n; i++)
        for (int j = 0; j < n; j++)
            entry[i * n + j] = number_mid_approx(&b.entry[(i + from) * b.n + j + from]) - (from ? number_mid_approx(&b.entry[j + from]) : 0);
    if (entry)
        z = spectral_radius_approx(entry, n);
    free(entry);
    block_free(&b);
    scheme_numbers_free(&numbers);
    return z;
}

static void test_proofs(void)
{
    test_begin("limits");
    for (long first = 150; first < 2000000; first *= 11) {
        setting z;
        search(&z, CATMULL_CLARK, first);
        CHECK(z.found.applies && z.found.proved && verifies(&z), "from %ld", first);
        for (int i = 0; i < 3; i++) {
            long k = i ? first * random_range(1, 5) : first;
            CHECK(radius(&z.s, 0, k) < radius(&z.s, 1, k), "at %ld", k);
        }
        clear(&z);
    }
    test_end();
}

static void test_none(void)
{
    static const char *const text[] = {SLOW, GROWING, NOT_AT_REST};
    test_begin("limits-that-are-none");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        for (long first = 200; first < 30000; first *= 10) {
            setting z;
            search(&z, text[i], first);
            CHECK(!z.found.proved && !verifies(&z), "number %d, from %ld", (int)i, first);
            clear(&z);
        }
    test_end();
}

static void test_lies(void)
{
    setting z;
    integer saved;
    test_begin("limits-with-a-lie");
    integer_init(&saved);
    search(&z, CATMULL_CLARK, 200);
    rise_box *box = &z.list.box[0];
    CHECK(verifies(&z), "no proof");
    int power = box->power;
    box->power = -1;
    CHECK(!verifies(&z), "no power");
    box->power = 0;
    CHECK(power > 0 && !verifies(&z), "a power too low");
    box->power = power;
    integer_swap(&saved, &box->eigenpair.range);
    MUST(integer_set(&box->eigenpair.range, &box->eigenpair.radius));
    CHECK(!verifies(&z), "a range too small");
    integer_swap(&saved, &box->eigenpair.range);
    z.k.last = 1000;
    CHECK(!verifies(&z), "finitely many valences");
    z.k = (valence_range){20, VALENCES_UNBOUNDED};
    CHECK(!verifies(&z), "smaller valences");
    z.k.first = 200;
    affine *l = &z.box[z.n];
    number_one(&l->slope);
    CHECK(!verifies(&z), "a fast L");
    number_mul_2exp(&l->slope, &l->slope, -3, PRECISION);
    CHECK(!verifies(&z), "a slower one");
    number_neg(&l->slope, &l->slope);
    CHECK(verifies(&z), "a falling one does no good, and no harm");
    number_mul_2exp(&z.scale, &z.scale, 5, PRECISION);
    CHECK(!verifies(&z), "others as small as that");
    clear(&z);
    integer_clear(&saved);
    test_end();
}

static void tests(void)
{
    test_values();
    test_centres();
    test_matrix();
    test_proofs();
    test_none();
    test_lies();
}

MAIN(tests);
