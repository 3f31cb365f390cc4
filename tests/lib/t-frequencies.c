/* t-frequencies.c: what is computed for a range of frequencies contains what is computed for each of them. */
#include "lib/block.h"
#include "lib/eigenvalues.h"
#include "lib/formula_range.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

/* Single frequencies are computed at this precision where there is a choice. */
enum { FINE = 320 };

/* Can the number that x encloses be in y?  Of very narrow x: is it in y? */
static bool meets(const number *x, const number *y)
{
    return number_lacks_memory(x) || number_lacks_memory(y) ? false : number_less(x, y) != TRUTH_TRUE && number_less(y, x) != TRUTH_TRUE;
}

static double width(const number *x)
{
    return number_upper_bound(x) - number_lower_bound(x);
}

/* ---- formulas ---- */

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

static void check_formula(const char *text, long k, frequencies m)
{
    formula *f = read_formula(text);
    formula_region at = {one_valence(k), m, 0};
    number range, one;
    diagnostic d;
    number_init(&range), number_init(&one);
    CHECK(NUMBER_NAME(formula_range)(&range, f, &at, 64, &d) == STATUS_OK || m.first == m.last, "'%s', k = %ld, %ld to %ld: %s", text, k, m.first, m.last, d.text);
    for (long l = m.first; l <= m.last; l++) {
        formula_region point = {one_valence(k), one_frequency(l), 0};
        if (NUMBER_NAME(formula_range)(&one, f, &point, FINE, &d) == STATUS_OK)
            CHECK(meets(&one, &range), "'%s' at k = %ld, m = %ld is not in the range of %ld to %ld", text, k, l, m.first, m.last);
    }
    formula_free(f);
    number_clear(&range), number_clear(&one);
}

static void test_formulas(void)
{
    static const char *const text[] = {
        "m", "-m", "m - m", "m*m - 3", "1/m", "k/(m - 5/2)", "(m - 3)/(m + 1)", "m^2", "(m - 4)^2", "(m - 4)^3", "(m - 4)^-1", "(m - 4)^-2",
        "2^m", "2^-m", "(1/3)^m", "(-1)^m", "(-2)^(3 - m)", "1^m", "(2/3)^(m - 6)", "(m + 1)^m",
        "mod(m, 2)", "mod(m, 3)*2 - 1", "mod(k, m + 1)", "abs(m - 5)", "min(m, 4, k - m)", "max(m, 4)", "sqrt(m)", "sqrt(m - 2)", "sqrt(2)*m - m^2",
        "cos(2*pi*m/k)", "sin(2*pi*m/k)", "cos(pi*m/3)", "sin(pi*m/3)", "cos(pi*(m - 4)^2/7)", "sin(pi/2 - m*pi)", "cos(mod(m, 3)*pi/5)", "cos(pi*(m - m))",
        "cos(2*pi*m/k)^2", "cos(2*pi*m/k)^-2", "sin(pi*m/k)^3", "(3/8 + cos(2*pi*m/k)/4)^2 - m/k", "abs(sin(5*pi*m/k))", "cos(pi/k)*sin(m*pi/k)/m",
        "cases(m = 1: 1/2; m = 0 or m = 2: 1/4; else: 0)", "cases(m < 3: m; else: 3 - m)", "cases(m >= 2 and m <= 4: cos(m*pi/4); else: -5)", "cases(m != 3: 2^-m; else: 7)",
        "cases(2*m = k: 3; else: 1)", "cases(m > sqrt(10): 1; else: 2)", "cases(cos(pi*m/k) > 1/3: 1; else: m)", "cases(m = 2: 1/0; else: 1)", "cases(m <= 6: m)",
        "cases(mod(m, 2) = 0: 1; else: -1)", "cases(m*pi > 10: 1; else: 0)", "cases(m = 0: 1; m = 3: m/(m - 2); else: 1/(m - 3))", "2^-(m*m)", "cos(2^m*pi/9)",
    };
    test_begin("formulas-over-ranges");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        for (long k = 5; k <= 26; k += 7)
            for (long first = 0; first <= k / 2; first++)
                for (long last = first; last <= k / 2; last++)
                    check_formula(text[i], k, (frequencies){first, last});
    test_end();
}

/* Ranges that are no wider than they must be.  (The radii of balls are short numbers.) */
#define SLACK 1e-7

static void check_range(const char *text, long k, frequencies m, double low, double high)
{
    formula *f = read_formula(text);
    formula_region at = {one_valence(k), m, 0};
    number range;
    diagnostic d;
    number_init(&range);
    CHECK(NUMBER_NAME(formula_range)(&range, f, &at, 64, &d) == STATUS_OK, "'%s': %s", text, d.text);
    CHECK(number_lower_bound(&range) <= low && number_lower_bound(&range) >= low - SLACK, "'%s' is at least %.17g, not %.17g", text, low, number_lower_bound(&range));
    CHECK(number_upper_bound(&range) >= high && number_upper_bound(&range) <= high + SLACK, "'%s' is at most %.17g, not %.17g", text, high, number_upper_bound(&range));
    formula_free(f);
    number_clear(&range);
}

static void test_sharp(void)
{
    const char *modified_butterfly = "cases(m = 1: 1/2; m = 0 or m = 2: 1/4; else: 0)";
    const long huge = 1000000000000000;
    test_begin("formulas-over-ranges-sharp");
    check_range(modified_butterfly, 100, (frequencies){3, 50}, 0, 0);
    check_range(modified_butterfly, 100, (frequencies){2, 50}, 0, 0.25);
    check_range(modified_butterfly, 100, (frequencies){0, 1}, 0, 0.5); /* m = 0 or 2 has no say in m = 1 */
    check_range("2^-m", huge, (frequencies){3, huge / 2}, 0, 0.125);
    check_range("2^-m", 100, (frequencies){3, 5}, 0.03125, 0.125);
    check_range("2^(k/20 - 2*m)", 100, (frequencies){3, 5}, 0.03125, 0.5);
    check_range("(1/4)^m", huge, (frequencies){20000, huge / 2}, 0, 0);
    check_range("cos(2*pi*m/k)", 12, (frequencies){1, 2}, 0.5, 0.8660254037844387);
    check_range("cos(2*pi*m/k)", huge, (frequencies){0, huge / 2}, -1, 1);
    check_range("cos(4*pi*m/k)", 24, (frequencies){5, 11}, -1, 0.8660254037844387);
    check_range("sin(2*pi*m/k)", 12, (frequencies){1, 4}, 0.5, 1);
    check_range("sin(-2*pi*m/k)", 12, (frequencies){1, 4}, -1, -0.5);
    check_range("cases(2*m = k: 3; else: 1)", 12, (frequencies){1, 5}, 1, 1);
    check_range("cases(2*m = k: 3; else: 1)", 12, (frequencies){1, 6}, 1, 3);
    check_range("cases(m*pi/k < pi/3: 1; else: 2)", 12, (frequencies){1, 3}, 1, 1);
    test_end();
}

/* ---- blocks ---- */

static bool make_block(block *b, const scheme *s, long k, frequencies m, bool real, const number *u, long prec)
{
    scheme_numbers numbers;
    diagnostic d = {0, 0, ""};
    block_status answer = BLOCK_BAD_INPUT;
    memset(b, 0, sizeof *b);
    twist_init(&b->twist);
    CHECK(scheme_numbers_make(&numbers, s, k, prec, &d) == STATUS_OK, "%s, k = %ld: %s", s->name, k, d.text);
    answer = u ? block_make_at(b, &numbers, m, u, &d) : block_make_range(b, &numbers, m, real, &d);
    CHECK(answer == BLOCK_OK, "%s, k = %ld, %ld to %ld: status %d: %s", s->name, k, m.first, m.last, (int)answer, d.text);
    scheme_numbers_free(&numbers);
    return answer == BLOCK_OK;
}

static void check_contains(const block *range, const block *one, const scheme *s)
{
    CHECK(range->n == one->n && !range->imaginary == !one->imaginary, "the shapes differ");
    for (int i = 0; range->n == one->n && i < one->n * one->n; i++) {
        CHECK(meets(&one->entry[i], &range->entry[i]), "%s, k = %ld: entry %d of block %ld is not in that of %ld to %ld", s->name, one->k.first, i, one->m, range->m, range->last);
        if (one->imaginary)
            CHECK(meets(&one->imaginary[i], &range->imaginary[i]), "%s, k = %ld: imaginary entry %d of block %ld is not in that of %ld to %ld", s->name, one->k.first, i, one->m, range->m, range->last);
    }
}

static void check_blocks(const scheme *s, long k, frequencies m, bool real)
{
    block range, one;
    number u;
    number_init(&u);
    if (make_block(&range, s, k, m, real, NULL, 64)) {
        for (long l = m.first; l <= m.last; l++) {
            if (make_block(&one, s, k, one_frequency(l), real, NULL, FINE)) {
                check_contains(&range, &one, s);
                CHECK(one.m == l && one.last == l, "a block of one frequency");
            }
            block_free(&one);
        }
        number_set(&u, &range.twist.u);
    }
    block_free(&range);
    if (real && make_block(&range, s, k, m, real, &u, 64) && make_block(&one, s, k, one_frequency(m.last), real, NULL, FINE)) {
        check_contains(&range, &one, s);
        block_free(&one);
    }
    block_free(&range);
    number_clear(&u);
}

static void test_blocks(void)
{
    static const long valence[] = {3, 4, 5, 6, 7, 8, 9, 12, 17, 20};
    test_begin("blocks-over-ranges");
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        scheme s;
        read_scheme(&s, e->text);
        for (size_t i = 0; i < sizeof valence / sizeof *valence; i++) {
            long k = valence[i], first = random_range(1, k / 2), last = random_range(first, k / 2);
            check_blocks(&s, k, (frequencies){1, k / 2}, false);
            check_blocks(&s, k, (frequencies){first, last}, false);
            if (s.mirror_symmetric) {
                check_blocks(&s, k, (frequencies){1, k / 2}, true);
                check_blocks(&s, k, (frequencies){first, last}, true);
            }
        }
        scheme_clear(&s);
    }
    test_end();
}

/* An imaginary part that is 0 at m = k/2 only, and weights that are given for each sector. */
static void test_rules(void)
{
    static const char spiral[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                                 "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) spectrum 1/2, m/k\nend\n";
    static const char sectors[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                                  "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) @ j (1/4 + cos(2*pi*j/k))/k\nend\n";
    test_begin("blocks-over-ranges-of-rules");
    for (int i = 0; i < 2; i++) {
        scheme s;
        read_scheme(&s, i ? sectors : spiral);
        for (long k = 7; k <= 8; k++)
            for (long first = 1; first <= k / 2; first++)
                for (long last = first; last <= k / 2; last++)
                    check_blocks(&s, k, (frequencies){first, last}, false);
        scheme_clear(&s);
    }
    test_end();
}

/* The entries vary with m as smooth functions do: a range of a tenth of a degree gives narrow ones. */
static void test_narrow(void)
{
    const long k = 3600000000000000;
    test_begin("blocks-over-ranges-narrow");
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        scheme s;
        read_scheme(&s, e->text);
        for (int real = 0; real <= s.mirror_symmetric; real++)
            for (int degree = 0; degree <= 175; degree += 25) {
                block b;
                long first = degree * (k / 360) + 10;
                if (make_block(&b, &s, k, (frequencies){first, first + k / 3600}, real, NULL, 64))
                    for (int i = 0; i < b.n * b.n; i++) {
                        CHECK(width(&b.entry[i]) < 0.05, "%s, %d degrees: an entry is %.3g wide", e->name, degree, width(&b.entry[i]));
                        if (b.imaginary)
                            CHECK(width(&b.imaginary[i]) < 0.05, "%s, %d degrees: an imaginary entry is %.3g wide", e->name, degree, width(&b.imaginary[i]));
                    }
                block_free(&b);
            }
        scheme_clear(&s);
    }
    test_end();
}

/* ---- u = 1 ---- */

/* The largest eigenvalues of the block at u = 1 are these and no others. */
static void check_limit(const char *name, const double *expected, const int *count, int groups)
{
    scheme s;
    block b;
    eigenvalues e;
    number u;
    number_init(&u);
    number_one(&u);
    read_scheme(&s, catalogue_text(name));
    if (make_block(&b, &s, 1000, one_frequency(1), true, &u, 128)) {
        CHECK(eigenvalues_enclose(&e, b.entry, NULL, b.n, 128) == TRUTH_TRUE, "%s: eigenvalues", name);
        for (int i = 0; i < e.count && i < groups; i++)
            CHECK(e.disc[i].count == count[i] && is_near(&e.disc[i].re, expected[i], 1e-4) && number_upper_bound(&e.disc[i].radius) < 1e-4, "%s: eigenvalue %d at u = 1 is %.9g, %d times", name, i,
                  number_mid_approx(&e.disc[i].re), e.disc[i].count);
        CHECK(e.count >= groups, "%s: eigenvalues are missing", name);
        eigenvalues_free(&e);
    }
    block_free(&b);
    number_clear(&u);
    scheme_clear(&s);
}

static void test_limit(void)
{
    test_begin("block-at-u-1");
    check_limit("loop", (const double[]){0.625, 0.125, 0.0625}, (const int[]){1, 1, 1}, 3);
    check_limit("butterfly", (const double[]){0.25, -0.0625, 0}, (const int[]){3, 2, 1}, 3);
    test_end();
}

/* ---- the real matrix of a complex block ---- */

static void test_real_matrix(void)
{
    scheme s;
    block b;
    int size;
    test_begin("real-matrix-of-complex-block");
    read_scheme(&s, catalogue_text("loop-spiral"));
    for (int real = 0; real < 2; real++) {
        if (real) {
            scheme_clear(&s);
            read_scheme(&s, catalogue_text("loop"));
        }
        if (make_block(&b, &s, 7, one_frequency(1), real, NULL, 64)) {
            number *a = block_real_matrix(&size, &b);
            CHECK(a && size == (real ? b.n : 2 * b.n), "size");
            for (int i = 0; a && i < b.n; i++)
                for (int j = 0; j < b.n; j++) {
                    double re = number_mid_approx(&b.entry[i * b.n + j]), im = real ? 0 : number_mid_approx(&b.imaginary[i * b.n + j]);
                    CHECK(number_mid_approx(&a[i * size + j]) == re, "a real part");
                    if (!real) {
                        CHECK(number_mid_approx(&a[(i + b.n) * size + j + b.n]) == re, "a real part below");
                        CHECK(number_mid_approx(&a[(i + b.n) * size + j]) == im && is_near(&a[i * size + j + b.n], -im, 1e-12), "an imaginary part");
                    }
                }
            number_array_free(a, (size_t)size * (size_t)size);
        }
        block_free(&b);
    }
    scheme_clear(&s);
    test_end();
}

static void tests(void)
{
    test_formulas();
    test_sharp();
    test_blocks();
    test_rules();
    test_narrow();
    test_limit();
    test_real_matrix();
}

MAIN(tests);
