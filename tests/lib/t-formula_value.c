/* t-formula_value.c: enclosures of formulas contain the exact values, which are bracketed here by integers alone, or
   computed along with a random formula. */
#include "lib/formula_value.h"
#include "lib/step.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

#define PI 3.14159265358979323846

static formula_point at_valence(long k)
{
    return (formula_point){k, 0, 0};
}

static formula *read_formula(const char *text)
{
    static const definitions none;
    static long column[1001];
    diagnostic d;
    formula *f = NULL;
    for (long i = 0; i <= 1000; i++)
        column[i] = i + 1;
    CHECK(formula_read(&f, text, strlen(text), 1, column, &none, FORMULA_ON_VALENCE, &d) == STATUS_OK, "'%s': %s", text, d.text);
    return f;
}

/* ---- cos(2 pi/k) without any trigonometry ----

   cos(j pi/k), j = 1..k-1, are the simple roots of the Chebyshev polynomial U of the second kind of degree k - 1,
   U(x) = sin(k t) / sin(t), x = cos t: U > 0 right of cos(pi/k), U < 0 between cos(2 pi/k) and cos(pi/k), and U > 0
   between cos(3 pi/k) and cos(2 pi/k). */

enum { BITS = 400 };

/* The sign of U of degree k - 1 at x 2^-BITS, by U_(n+1) = 2 x U_n - U_(n-1), scaled by 2^(BITS n). */
static int chebyshev_sign(const integer *x, int k)
{
    integer u, last, next;
    int sign;
    integer_init(&u), integer_init(&last), integer_init(&next);
    integer_set_si(&u, 1);
    for (int n = 1; n < k; n++) {
        MUST(integer_mul(&next, &u, x));
        MUST(integer_mul_2exp(&next, &next, 1));
        MUST(integer_mul_2exp(&last, &last, 2 * BITS));
        MUST(integer_sub(&next, &next, &last));
        integer_swap(&last, &u);
        integer_swap(&u, &next);
    }
    sign = integer_sign(&u);
    integer_clear(&u), integer_clear(&last), integer_clear(&next);
    return sign;
}

/* low < cos(2 pi/k) <= high, k >= 4, neighbours on the grid 2^-BITS, by bisection between points that doubles show
   to be left and right of it. */
static void bracket_cosine(rational *low, rational *high, int k)
{
    integer left, right, middle;
    integer_init(&left), integer_init(&right), integer_init(&middle);
    integer_set_si(&left, (int64_t)floor(cos(2.5 * PI / k) * 0x1p40));
    integer_set_si(&right, (int64_t)floor(cos(1.5 * PI / k) * 0x1p40));
    MUST(integer_mul_2exp(&left, &left, BITS - 40));
    MUST(integer_mul_2exp(&right, &right, BITS - 40));
    CHECK(chebyshev_sign(&left, k) > 0 && chebyshev_sign(&right, k) < 0, "k = %d: the start is not left and right of cos(2 pi/k)", k);
    for (;;) {
        MUST(integer_sub(&middle, &right, &left));
        if (integer_is_one(&middle))
            break;
        MUST(integer_add(&middle, &left, &right));
        MUST(integer_fdiv_2exp(&middle, &middle, 1));
        if (chebyshev_sign(&middle, k) > 0)
            integer_swap(&left, &middle);
        else
            integer_swap(&right, &middle);
    }
    MUST(rational_set_integer_2exp(low, &left, -BITS));
    MUST(rational_set_integer_2exp(high, &right, -BITS));
    CHECK(fabs(rational_get_double_approx(low) - cos(2 * PI / k)) < 1e-12, "bracket");
    integer_clear(&left), integer_clear(&right), integer_clear(&middle);
}

/* Loop's c0 = 3/8 + (3/8 + c/4)^2, which grows with c. */
static void loop_centre(rational *z, const rational *cosine)
{
    rational q;
    rational_init(&q);
    MUST(rational_mul_2exp(z, cosine, -2));
    MUST(rational_set_si(&q, 3, 8));
    MUST(rational_add(z, z, &q));
    MUST(rational_mul(z, z, z));
    MUST(rational_add(z, z, &q));
    rational_clear(&q);
}

/* The weight of the centre in its own rule, and the total weight of its neighbours. */
static void centre_weights(number *centre, number *ring, const scheme *s, long k, long prec)
{
    scheme_numbers z;
    diagnostic d = {0, 0, ""};
    const rule_numbers *r;
    CHECK(scheme_numbers_make(&z, s, k, prec, &d) == STATUS_OK && scheme_numbers_set_frequency(&z, 0, NULL, &d) == STATUS_OK, "k = %ld: %s", k, d.text);
    CHECK(z.steps[0].rule_count == 1 && z.steps[0].rules[0].count == 2, "the rule of the centre");
    r = &z.steps[0].rules[0];
    number_set(centre, &r->matrix[0].xx);
    number_set(ring, &r->matrix[1].xx);
    CHECK(r->point[1].a == 1 && r->point[1].b == 0, "the neighbours");
    scheme_numbers_free(&z);
}

static double width(const number *x)
{
    return number_upper_bound(x) - number_lower_bound(x);
}

/* low <= cos(2 pi/k) <= high, much closer than numbers of this precision are. */
static void check_loop(const scheme *s, int k, const rational *low, const rational *high, long prec)
{
    rational a, b, one;
    number centre, ring, cosine;
    diagnostic d;
    formula_point at = at_valence(k);
    formula *f = read_formula("cos(2*pi/k)");
    rational_init(&a), rational_init(&b), rational_init(&one);
    number_init(&centre), number_init(&ring), number_init(&cosine);
    CHECK(NUMBER_NAME(formula_value)(&cosine, f, &at, prec, &d) == STATUS_OK, "%s", d.text);
    CHECK(number_contains_rational(&cosine, low) || number_contains_rational(&cosine, high), "k = %d, precision %ld: cos(2 pi/k)", k, prec);
    loop_centre(&a, low), loop_centre(&b, high);
    centre_weights(&centre, &ring, s, k, prec);
    CHECK(number_contains_rational(&centre, &a) || number_contains_rational(&centre, &b), "k = %d, precision %ld: c0", k, prec);
    MUST(rational_set_si(&one, 1, 1));
    MUST(rational_sub(&a, &one, &a));
    MUST(rational_sub(&b, &one, &b));
    CHECK(number_contains_rational(&ring, &a) || number_contains_rational(&ring, &b), "k = %d, precision %ld: c1", k, prec);
    double tolerance = ldexp(1, prec < 53 ? 4 - (int)prec : -49);
    CHECK(width(&centre) < tolerance && width(&ring) < tolerance, "k = %d, precision %ld: c0 is wide", k, prec);
    formula_free(f);
    number_clear(&centre), number_clear(&ring), number_clear(&cosine);
    rational_clear(&a), rational_clear(&b), rational_clear(&one);
}

static void test_loop(void)
{
    static const long precisions[] = {64, 65, 100, 192, 256, 333};
    scheme s;
    rational low, high;
    test_begin("weights-of-loop");
    rational_init(&low), rational_init(&high);
    read_scheme(&s, catalogue_text("loop"));
    /* the bracket itself, where the cosine is a rational */
    bracket_cosine(&low, &high, 6);
    CHECK(rational_cmp_si(&low, 1, 2) < 0 && rational_cmp_si(&high, 1, 2) == 0, "cos(pi/3) = 1/2");
    for (int k = 5; k <= 60; k += k == 5 ? 2 : k < 12 ? 1 : 8) {
        bracket_cosine(&low, &high, k);
        for (size_t i = 0; i < sizeof precisions / sizeof *precisions; i++)
            check_loop(&s, k, &low, &high, precisions[i]);
    }
    rational_clear(&low), rational_clear(&high);
    scheme_clear(&s);
    test_end();
}

/* ---- weights that are exact ---- */

static void check_weights(const char *text, long k, long p0, long q0, bool thin)
{
    scheme s;
    number centre, ring;
    rational q;
    rational_init(&q);
    number_init(&centre), number_init(&ring);
    read_scheme(&s, text);
    centre_weights(&centre, &ring, &s, k, 64);
    MUST(rational_set_si(&q, p0, q0));
    CHECK(number_contains_rational(&centre, &q) && (!thin || number_is_thin(&centre)), "k = %ld: c0 is not %ld/%ld", k, p0, q0);
    MUST(rational_set_si(&q, q0 - p0, q0));
    CHECK(number_contains_rational(&ring, &q) && (!thin || number_is_thin(&ring)), "k = %ld: c1 is not %ld/%ld", k, q0 - p0, q0);
    number_clear(&centre), number_clear(&ring);
    scheme_clear(&s);
    rational_clear(&q);
}

static void test_exact_weights(void)
{
    static const char ring_given[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 1\n(1,0) 1/2\nend\nrule centre\ncentre rest\nall (1,0) 3/(8*k)\nend\n";
    test_begin("weights-exact");
    check_weights(LOOP_TEXT, 3, 7, 16, true);   /* 3/8 + (1/4)^2 */
    check_weights(LOOP_TEXT, 4, 33, 64, true);  /* 3/8 + (3/8)^2 */
    check_weights(LOOP_TEXT, 6, 5, 8, true);
    check_weights(LOOP_TEXT, 2, 25, 64, true);  /* 3/8 + (1/8)^2 */
    check_weights(ring_given, 4, 29, 32, true);
    check_weights(ring_given, 7, 53, 56, false); /* not a number of any system */
    check_weights(SCHEME_TEXT("(0,0) 1\n(1,0) 1/2\n", "-7/4"), 9, -7, 4, true);
    test_end();
}

/* ---- complaints that only come with a value ---- */

static void check_complaint(const char *text, long k, long column, const char *expected)
{
    formula *f = read_formula(text);
    number z;
    formula_point at = at_valence(k);
    diagnostic d = {0, 0, ""};
    number_init(&z);
    CHECK(NUMBER_NAME(formula_value)(&z, f, &at, 64, &d) == STATUS_BAD_INPUT, "'%s' has a value at k = %ld", text, k);
    CHECK(d.line == 1 && d.column == column && !strcmp(d.text, expected), "'%s': %ld:%ld: \"%s\"", text, d.line, d.column, d.text);
    number_clear(&z);
    formula_free(f);
}

static void test_complaints(void)
{
    test_begin("formula-value-complaints");
    check_complaint("cos(2*pi/k)/0", 5, 12, "division by zero (at k = 5)");
    check_complaint("pi^2/(1-1)", 5, 5, "division by zero");
    check_complaint("(pi^2)^-1/(1-1)", 5, 10, "division by zero");
    check_complaint("1 + sqrt(1/2 - sqrt(2))", 5, 5, "the square root of something negative");
    check_complaint("sqrt(-sqrt(2)-k)", 7, 1, "the square root of something negative (at k = 7)");
    check_complaint("pi + cases(sqrt(2) < 1: 1; sqrt(2) > 3/2: 2)", 7, 6, "no case applies; add 'else: ...'");
    check_complaint("pi*mod(sqrt(2), 2)", 7, 4, "mod takes two whole numbers, the second not 0");
    check_complaint("pi^(1/2)", 7, 3, "expected a whole number as the exponent");
    check_complaint("pi^(2^14+1)", 7, 3, "a rational number of more than 16384 bits");
    check_complaint("1/(k-5)", 5, 2, "division by zero (at k = 5)");
    check_complaint("cos(cos(pi/7))", 5, 1, "cos and sin need a rational multiple of pi");
    check_complaint("sin(pi/7)+1/cos(pi/2)", 7, 12, "division by zero");
    test_end();
}

/* ---- random formulas ---- */

typedef struct {
    char text[1000];
    size_t length;
} writer;

static void put(writer *w, const char *text)
{
    memcpy(w->text + w->length, text, strlen(text) + 1);
    w->length += strlen(text);
}

/* Writes a formula with its value in doubles; what divides is kept away from 0. */
static double write_formula(writer *w, int depth, int k)
{
    char text[64];
    double x, y, z;
    int p, q;
    switch (depth > 0 ? random_below(9) : 5 + random_below(4)) {
    case 0:
    case 1:
        put(w, "("), x = write_formula(w, depth - 1, k), put(w, "+"), y = write_formula(w, depth - 1, k), put(w, ")");
        return x + y;
    case 2:
        put(w, "("), x = write_formula(w, depth - 1, k), put(w, "-"), y = write_formula(w, depth - 1, k), put(w, ")");
        return x - y;
    case 3:
        x = write_formula(w, depth - 1, k), put(w, "*"), y = write_formula(w, depth - 1, k);
        return x * y;
    case 4:
        put(w, "(-"), x = write_formula(w, depth - 1, k), put(w, ")^2/(4+("), y = write_formula(w, depth - 1, k), put(w, ")^2)");
        z = x * x / (4 + y * y);
        return z;
    case 5:
        p = (int)random_range(1, 99), q = (int)random_range(1, 9);
        snprintf(text, sizeof text, "(%d/%d)", p, q);
        put(w, text);
        return (double)p / q;
    case 6:
        put(w, "pi");
        return PI;
    default:
        p = (int)random_range(0, 20), q = (int)random_range(1, 9);
        bool sine = random_bool(), valence = random_bool();
        snprintf(text, sizeof text, valence ? "%s(%d*pi/k)" : "%s(%d*pi/%d)", sine ? "sin" : "cos", p, q);
        put(w, text);
        x = PI * p / (valence ? k : q);
        return sine ? sin(x) : cos(x);
    }
}

status formula_value_ball(ball *z, const formula *f, const formula_point *at, long prec, diagnostic *d);

static void test_random(void)
{
    test_begin("formula-value-random");
    for (test_cases(2000); test_next();) {
        writer w = {"", 0};
        int k = (int)random_range(3, 40);
        double expected = write_formula(&w, 3, k);
        long prec = random_range(30, 300);
        formula_point at = at_valence(k);
        diagnostic d;
        number z;
        ball fine;
        integer m;
        int64_t e;
        rational q;
        formula *f = read_formula(w.text);
        number_init(&z);
        ball_init(&fine);
        integer_init(&m);
        rational_init(&q);
        if (f) {
            CHECK(NUMBER_NAME(formula_value)(&z, f, &at, prec, &d) == STATUS_OK, "'%s' at k = %d: %s", w.text, k, d.text);
            CHECK(fabs(expected - number_mid_approx(&z)) <= (1e-9 + ldexp(1e4, -(int)prec)) * (1 + fabs(expected)) * 1000, "'%s' at k = %d is not %.17g but %.17g", w.text, k, expected, number_mid_approx(&z));
            /* the middle of an enclosure of 1000 bits is in every enclosure of 300, if both are right */
            CHECK(formula_value_ball(&fine, f, &at, 1000, &d) == STATUS_OK, "%s", d.text);
            MUST(ball_get_parts(&m, NULL, &e, &fine));
            MUST(rational_set_integer_2exp(&q, &m, (long)e));
            CHECK(number_contains_rational(&z, &q), "'%s' at k = %d, precision %ld: two enclosures do not agree", w.text, k, prec);
        }
        formula_free(f);
        number_clear(&z);
        ball_clear(&fine);
        integer_clear(&m);
        rational_clear(&q);
    }
    test_end();
}

/* sin(pi/k) by its square: cos(2 pi/k) = 1 - 2 sin(pi/k)^2. */
static void test_sine(void)
{
    test_begin("formula-value-sine");
    for (int k = 3; k <= 400; k += k < 20 ? 1 : 17) {
        formula *f = read_formula("cos(2*pi/k) - 1 + 2*sin(pi/k)^2"), *g = read_formula("sin(2*pi/k) - 2*sin(pi/k)*cos(pi/k)"), *h = read_formula("sin(pi/k)");
        number z;
        formula_point at = at_valence(k);
        diagnostic d;
        number_init(&z);
        CHECK(NUMBER_NAME(formula_value)(&z, f, &at, 100, &d) == STATUS_OK && number_contains_zero(&z) && width(&z) < 1e-14, "cos(2 x) at k = %d", k);
        CHECK(NUMBER_NAME(formula_value)(&z, g, &at, 100, &d) == STATUS_OK && number_contains_zero(&z) && width(&z) < 1e-14, "sin(2 x) at k = %d", k);
        CHECK(NUMBER_NAME(formula_value)(&z, h, &at, 100, &d) == STATUS_OK && number_is_positive(&z) == TRUTH_TRUE, "sin at k = %d", k);
        number_clear(&z);
        formula_free(f), formula_free(g), formula_free(h);
    }
    test_end();
}

/* ---- functions ---- */

static void check_value(const char *text, long k, double value)
{
    formula *f = read_formula(text);
    number z;
    formula_point at = at_valence(k);
    diagnostic d = {0, 0, ""};
    number_init(&z);
    CHECK(NUMBER_NAME(formula_value)(&z, f, &at, 64, &d) == STATUS_OK, "'%s': %s", text, d.text);
    CHECK(is_near(&z, value, 1e-13 * (1 + fabs(value))), "'%s' is %.17g, not %.17g", text, number_mid_approx(&z), value);
    number_clear(&z);
    formula_free(f);
}

/* More precision may tell; until then the value may be anything. */
static void check_indeterminate(const char *text, long k)
{
    formula *f = read_formula(text);
    number z;
    formula_point at = at_valence(k);
    diagnostic d = {0, 0, ""};
    number_init(&z);
    CHECK(NUMBER_NAME(formula_value)(&z, f, &at, 64, &d) == STATUS_OK, "'%s': %s", text, d.text);
    CHECK(!number_is_finite(&z), "'%s' is %.17g", text, number_mid_approx(&z));
    number_clear(&z);
    formula_free(f);
}

static void test_functions(void)
{
    test_begin("formula-value-functions");
    check_value("sqrt(2)", 3, sqrt(2));
    check_value("sqrt(2)^2 - 2", 3, 0);
    check_value("sqrt(cos(2*pi/k) + 2)", 7, sqrt(cos(2 * PI / 7) + 2));
    check_value("abs(cos(pi/k) - 1)", 5, 1 - cos(PI / 5));
    check_value("abs(1 - sqrt(2)) - abs(sqrt(2) - 1)", 3, 0);
    check_value("min(sqrt(2), 3/2, pi)", 3, sqrt(2));
    check_value("max(sqrt(2), 3/2, 1)", 3, 1.5);
    check_value("max(pi, 3)", 3, PI);
    check_value("min(pi, 22/7, sqrt(10))", 3, PI);
    check_value("cases(cos(2*pi/k) > 1/2: sqrt(2); else: sqrt(3))", 7, sqrt(2));
    check_value("cases(cos(2*pi/k) > 1/2: sqrt(2); else: sqrt(3))", 5, sqrt(3));
    check_value("cases(cos(2*pi/k) > 1/2: sqrt(2); else: sqrt(3))", 6, sqrt(3)); /* exactly equal */
    check_value("cases(cos(2*pi/k) >= 1/2: 1; else: 2)", 6, 1);
    check_value("cases(sqrt(2) > 1 and k = 7: pi; else: 2)", 7, PI);
    check_value("cases(sqrt(2) < 1 or pi <= 3: pi; sqrt(2) != 1: sqrt(5))", 7, sqrt(5));
    check_value("cases(sqrt(2) = 1: 1; pi >= 3: 3)", 7, 3);
    check_value("mod(7,k)*sqrt(2)", 5, 2 * sqrt(2));
    check_value("pi^2", 3, PI * PI);
    check_value("(1/2 + sqrt(2)/2)^(k-3)", 5, pow(0.5 + sqrt(0.5), 2));
    check_value("pi^(-2)", 3, 1 / PI / PI);
    check_value("(pi/4)^(2^14)", 3, 0);
    test_end();
    test_begin("formula-value-undecided");
    check_indeterminate("1/(cos(2*pi/k)-cos(2*pi/k))", 5);
    check_indeterminate("(pi-pi*cos(0)+cos(pi/5)-cos(pi/5))^-2", 5);
    check_indeterminate("sqrt(sqrt(2)^2 - 2) + 1", 5);
    check_indeterminate("cases(cos(2*pi/k) = cos(-2*pi/k): 1; else: 2)", 7);
    check_indeterminate("1 + cases(sqrt(2)^2 <= 2: 1; else: 2)", 7);
    check_indeterminate("cases(sqrt(2)^2 >= 2 and pi > 3: 1; else: 2)", 7);
    check_indeterminate("cases(sqrt(2)^2 != 2 or pi < 3: 1; else: 2)", 7);
    check_value("cases(sqrt(2)^2 >= 2 and pi < 3: 1; else: 2)", 7, 2);
    check_value("cases(sqrt(2)^2 != 2 or pi > 3: 1; else: 2)", 7, 1);
    test_end();
}

static void tests(void)
{
    test_functions();
    test_loop();
    test_exact_weights();
    test_complaints();
    test_random();
    test_sine();
}
MAIN(tests);
