/* t-valence_ranges.c: what is computed for a range of valences contains what is computed for each of them. */
#include "lib/block.h"
#include "lib/formula_range.h"
#include "lib/scheme_range.h"

#include <math.h>

#include "common.h"
#include "region.h"

/* Single valences are computed at this precision where there is a choice. */
enum { FINE = 320 };

#define INFINITE LONG_MAX

static bool meets(const number *x, const number *y)
{
    return number_lacks_memory(x) || number_lacks_memory(y) ? false : number_less(x, y) != TRUTH_TRUE && number_less(y, x) != TRUTH_TRUE;
}

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

static status evaluate(number *z, const formula *f, valence_range k, frequencies m, long prec)
{
    formula_region at = {k, m, 0};
    diagnostic d;
    return NUMBER_NAME(formula_range)(z, f, &at, prec, &d);
}

/* ---- formulas ---- */

static long some_of(long first, long last)
{
    long span = last == INFINITE ? 40 : last - first;
    switch (random_below(4)) {
    case 0:
        return first;
    case 1:
        return last == INFINITE ? first + random_range(0, 1000000) : last;
    default:
        return first + random_range(0, span);
    }
}

static void check_formula(const char *text, valence_range k, frequencies m)
{
    formula *f = read_formula(text);
    number range, one;
    number_init(&range), number_init(&one);
    bool may_fail = k.first == k.last || m.first == m.last; /* a formula that does not vary may be at fault */
    CHECK(evaluate(&range, f, k, m, 64) == STATUS_OK || may_fail, "'%s', k from %ld to %ld, m from %ld to %ld", text, k.first, k.last, m.first, m.last);
    for (int i = 0; i < 12; i++) {
        long here = some_of(k.first, k.last), there = some_of(m.first, m.last);
        if (evaluate(&one, f, one_valence(here), one_frequency(there), FINE) == STATUS_OK)
            CHECK(meets(&one, &range), "'%s' at k = %ld, m = %ld is not in the range of %ld to %ld, %ld to %ld", text, here, there, k.first, k.last, m.first, m.last);
    }
    formula_free(f);
    number_clear(&range), number_clear(&one);
}

static void test_formulas(void)
{
    static const char *const text[] = {
        "k", "m", "k - m", "k + m", "-k", "m*k", "2*m - k/3", "1/k", "1/m", "m/k", "k/m", "k/(m + 1)", "(k - 5)/(m + 1)", "-3/k", "(1 - k)/(m + 2)", "0*k", "0/k", "-m/(2*k)",
        "1/(k - 5)", "1/(m - 5/2)", "(m - k)*(m + k)", "k*k", "k^2", "(k - 7)^3", "2^-k", "2^k", "2^(m - k)", "(1/3)^k", "(1/3)^(-m)", "1^k", "(2/3)^(k - 6)", "k^-1", "(1/k)^2", "(k + 1)^m",
        "mod(k, 2)", "abs(k - 8)", "min(k, 9)", "max(1/k, 1/7)", "sqrt(k)", "sqrt(2)*k - m", "sqrt(1/k)",
        "cos(2*pi/k)", "sin(pi/k)", "cos(2*pi*m/k)", "sin(2*pi*m/k)", "cos(pi*k/3)", "sin(pi*m/7)", "cos(pi*m)", "cos(pi*(m - m))", "cos(0*k*pi)",
        "3/8 + (3/8 + cos(2*pi/k)/4)^2", "1 - 3/k - 2/k", "cos(pi/k)*sin(m*pi/k)/m", "abs(sin(5*pi*m/k))",
        "cases(k = 3: 1/2; k > 7: 1/k; else: 0)", "cases(k < 9: k; else: 9 - k)", "cases(k != 6 and m >= 2: 2^-m; else: 7)", "cases(m = 1: 1/2; m = 0 or m = 2: 1/4; else: 0)",
        "cases(2*m = k: 3; else: 1)", "cases(1/k > 1/10: 1; else: 2)", "cases(pi/k < pi/9: 1; else: 2)", "cases(k >= sqrt(65): 1; else: 2)", "cases(cos(pi*m/k) > 1/3: 1; else: m)",
        "cases(k = 8: 1/0; else: 1)", "cases(k <= 9: m)", "cases(mod(k, 2) = 0: 1; else: -1)", "cases(k > 1000: 0; else: k)", "cases(m/k <= 1/2: 1; else: 5)",
    };
    test_begin("formulas-over-ranges-of-valences");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        for (int c = 0; c < 60; c++) {
            long k1 = random_range(3, 12), m1 = random_range(0, 4);
            long k2 = random_below(3) ? k1 + random_range(0, 9) : INFINITE, m2 = random_below(3) ? m1 + random_range(0, 3) : INFINITE;
            check_formula(text[i], (valence_range){k1, k2}, (frequencies){m1, m2});
        }
    test_end();
}

#define SLACK 1e-7

/* low > high: unknown. */
static void check_range(const char *text, valence_range k, frequencies m, double low, double high)
{
    formula *f = read_formula(text);
    number range;
    number_init(&range);
    CHECK(evaluate(&range, f, k, m, 64) == STATUS_OK, "'%s'", text);
    if (low > high)
        CHECK(!number_is_finite(&range), "'%s' is known", text);
    else {
        CHECK(number_lower_bound(&range) <= low && number_lower_bound(&range) >= low - SLACK, "'%s' is at least %.17g, not %.17g", text, low, number_lower_bound(&range));
        CHECK(number_upper_bound(&range) >= high && number_upper_bound(&range) <= high + SLACK, "'%s' is at most %.17g, not %.17g", text, high, number_upper_bound(&range));
    }
    formula_free(f);
    number_clear(&range);
}

static void test_sharp(void)
{
    const valence_range beyond_20 = {20, INFINITE}, some = {10, 20};
    const frequencies all = {2, INFINITE}, one = {1, 1}, few = {2, 4};
    test_begin("formulas-over-ranges-of-valences-sharp");
    check_range("1/k", beyond_20, one, 0, 0.05);
    check_range("m/k", some, few, 0.1, 0.4);
    check_range("m/k", beyond_20, few, 0, 0.2);
    check_range("m/k", beyond_20, all, 1, 0); /* oo / oo */
    check_range("m/k", some, all, 1, 0);      /* no end */
    check_range("1/(m/k)", (valence_range){10, 10}, all, 1, 0); /* the rule of one valence */
    check_range("1/m", beyond_20, all, 0, 0.5);
    check_range("1 - 3/k", beyond_20, all, 0.85, 1);
    check_range("k", beyond_20, one, 1, 0);
    check_range("0*k", beyond_20, one, 0, 0);
    check_range("cos(2*pi/k)", beyond_20, one, 0.95105651629515357, 1);
    check_range("cos(2*pi*k)", beyond_20, one, -1, 1);
    check_range("sin(pi/k)", (valence_range){3, 6}, one, 0.5, 0.8660254037844387);
    check_range("sin(pi/k)", (valence_range){2, INFINITE}, one, 0, 1);
    check_range("2^-k", beyond_20, one, 0, 0x1p-20);
    check_range("2^(1 - m)", beyond_20, all, 0, 0.5);
    check_range("2^-(k/2)", beyond_20, one, 1, 0); /* no value at 21 */
    check_range("2^(m*2 - 2*k)", (valence_range){10, 10}, few, 0x1p-16, 0x1p-12);
    check_range("2^k", beyond_20, one, 1, 0);
    check_range("cases(m = 1: 1/2; m = 0 or m = 2: 1/4; else: 0)", beyond_20, (frequencies){3, INFINITE}, 0, 0);
    check_range("cases(k != 6: 1; else: 2)", beyond_20, one, 1, 1);
    check_range("cases(k != 6: 1; else: 2)", (valence_range){5, 7}, one, 1, 2);
    check_range("cases(k > m: 1; else: 2)", beyond_20, few, 1, 1);
    check_range("cases(1/k < 1/19: 1; else: 2)", beyond_20, few, 1, 1);
    check_range("cases(k/(-2) < -9: 1; else: 2)", beyond_20, few, 1, 1);
    check_range("cases(k*(-2) < -39: 1; else: 2)", beyond_20, few, 1, 1);
    check_range("cases(k - k/2 >= 0: 1; else: 2)", beyond_20, few, 1, 2); /* oo - oo: anything */
    test_end();
}

/* ---- rules ---- */

static const char switching[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                                "rule centre when k > 8 and k != 12\ncentre cases(k < 30: 5/8; else: 1/2)\nall (1,0) rest\nend\nrule centre\ncentre 9/16\nall (1,0) rest\nend\n"
                                "rule (1,0) when mod(k, 50) = 0\n(1,0) 1/2\ncentre rest\nend\n";

static void check_decided(const scheme *s, long first, long last, truth rules, long up_to)
{
    diagnostic d = {0, 0, ""};
    truth decided;
    long end;
    scheme_numbers z;
    valence_range k = {first, last};
    CHECK(scheme_rules_decided(&decided, s, k, &d) == STATUS_OK && decided == rules, "%s, %ld to %ld", s->name, first, last);
    CHECK(decided == TRUTH_TRUE || d.line > 0, "no complaint");
    CHECK(scheme_decided_up_to(&end, s, k, &d) == STATUS_OK && end == up_to, "%s, %ld to %ld: decided up to %ld", s->name, first, last, end);
    CHECK((scheme_numbers_make_range(&z, s, k, 64, &d) == STATUS_OK) == (rules == TRUTH_TRUE), "%s, %ld to %ld: numbers", s->name, first, last);
    scheme_numbers_free(&z);
}

static void test_decisions(void)
{
    scheme s;
    test_begin("rules-over-ranges-of-valences");
    read_scheme(&s, catalogue_text("modified-butterfly"));
    check_decided(&s, 7, INFINITE, TRUTH_TRUE, INFINITE);
    check_decided(&s, 3, 5, TRUTH_TRUE, 5);
    check_decided(&s, 3, 6, TRUTH_UNKNOWN, 5);
    check_decided(&s, 3, INFINITE, TRUTH_UNKNOWN, 5);
    check_decided(&s, 6, INFINITE, TRUTH_UNKNOWN, 6);
    scheme_clear(&s);
    read_scheme(&s, catalogue_text("loop-warren"));
    check_decided(&s, 3, INFINITE, TRUTH_TRUE, 3); /* a `cases` */
    check_decided(&s, 4, INFINITE, TRUTH_TRUE, INFINITE);
    scheme_clear(&s);
    read_scheme(&s, catalogue_text("catmull-clark"));
    check_decided(&s, 3, INFINITE, TRUTH_TRUE, INFINITE);
    scheme_clear(&s);
    read_scheme(&s, switching);
    check_decided(&s, 3, 8, TRUTH_UNKNOWN, 3); /* mod of a range is not known */
    check_decided(&s, 9, 9, TRUTH_TRUE, 9);
    scheme_clear(&s);
    test_end();
}

static void check_vary(const char *name, long first, long last, bool vary, bool with_frequency)
{
    scheme s;
    bool z;
    diagnostic d;
    valence_range k = {first, last};
    read_scheme(&s, catalogue_text(name));
    CHECK(scheme_weights_vary(&z, &s, k, &d) == STATUS_OK && z == vary, "%s, %ld to %ld: weights", name, first, last);
    CHECK(scheme_weights_vary_with_frequency(&z, &s, k, &d) == STATUS_OK && z == with_frequency, "%s, %ld to %ld: frequencies", name, first, last);
    scheme_clear(&s);
}

static void test_weights(void)
{
    test_begin("weights-that-vary");
    check_vary("loop", 3, INFINITE, false, false); /* only the centre's */
    check_vary("catmull-clark", 3, INFINITE, false, false);
    check_vary("kobbelt", 5, INFINITE, false, false);
    check_vary("modified-butterfly", 7, INFINITE, true, true);
    check_vary("modified-butterfly", 6, 6, false, false); /* no rule holds */
    check_vary("modified-loop", 7, INFINITE, true, true); /* through a definition, too */
    check_vary("doo-sabin", 5, 9, true, true);
    test_end();
}

/* ---- block 0 ---- */

static bool make_block(block *b, const scheme *s, valence_range k, long prec)
{
    scheme_numbers numbers;
    diagnostic d = {0, 0, ""};
    block_status answer = BLOCK_BAD_INPUT;
    memset(b, 0, sizeof *b);
    twist_init(&b->twist);
    if (scheme_numbers_make_range(&numbers, s, k, prec, &d) == STATUS_OK)
        answer = block_make(b, &numbers, 0, true, &d);
    CHECK(answer == BLOCK_OK, "%s, %ld to %ld: %s", s->name, k.first, k.last, d.text);
    scheme_numbers_free(&numbers);
    return answer == BLOCK_OK;
}

static void check_plain(const char *name, long first, long last)
{
    scheme s;
    block range, one;
    read_scheme(&s, catalogue_text(name));
    if (make_block(&range, &s, (valence_range){first, last}, 64)) {
        for (long k = first; k <= last && k < first + 30; k++) {
            if (make_block(&one, &s, one_valence(k), FINE))
                for (int i = 0; i < one.n * one.n; i++)
                    CHECK(meets(&one.entry[i], &range.entry[i]), "%s: entry %d of valence %ld is not in that of %ld to %ld", name, i, k, first, last);
            block_free(&one);
        }
        for (int i = 0; i < range.n * range.n; i++)
            CHECK(number_is_finite(&range.entry[i]) && number_upper_bound(&range.entry[i]) - number_lower_bound(&range.entry[i]) < 0.5, "%s, %ld to %ld: entry %d is wide", name, first, last, i);
    }
    block_free(&range);
    scheme_clear(&s);
}

static void test_plain_blocks(void)
{
    test_begin("block-0-over-ranges-of-valences");
    check_plain("loop", 20, INFINITE);
    check_plain("loop", 10, 14);
    check_plain("catmull-clark", 20, INFINITE);
    check_plain("modified-butterfly", 7, INFINITE);
    check_plain("kobbelt", 5, INFINITE);
    check_plain("midpoint", 20, INFINITE);
    check_plain("doo-sabin", 5, INFINITE);
    test_end();
}

static void test_sectors(void)
{
    static const char text[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                               "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) @ j (1/4 + cos(2*pi*j/k))/k\nend\n";
    scheme s;
    scheme_numbers z;
    diagnostic d = {0, 0, ""};
    block b;
    test_begin("weights-of-sectors-over-ranges-of-valences");
    read_scheme(&s, text);
    CHECK(scheme_numbers_make_range(&z, &s, (valence_range){7, 8}, 64, &d) == STATUS_OK && block_make(&b, &z, 0, true, &d) == BLOCK_BAD_INPUT && strstr(d.text, "each sector"), "'%s'", d.text);
    block_free(&b);
    scheme_numbers_free(&z);
    scheme_clear(&s);
    test_end();
}

static void tests(void)
{
    test_formulas();
    test_sharp();
    test_decisions();
    test_weights();
    test_plain_blocks();
    test_sectors();
}

MAIN(tests);
