/* t-formula.c: reading formulas and their exact values. */
#include "lib/formula.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"

static const definitions no_names;
static const unsigned everything = FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY | FORMULA_ON_SECTOR;

static formula_point at_valence(long k)
{
    return (formula_point){k, 0, 0};
}

/* Reads an exact copy of the text, as if its characters stood in the columns 1, 2, .. of line 7. */
static bool read_text(formula **f, diagnostic *d, const char *text)
{
    size_t length = strlen(text);
    char *exactly = malloc(length + 1);
    long *column = malloc((length + 1) * sizeof *column);
    memcpy(exactly, text, length);
    for (size_t i = 0; i <= length; i++)
        column[i] = (long)i + 1;
    *d = (diagnostic){0, 0, ""};
    status s = formula_read(f, exactly, length, 7, column, &no_names, everything, d);
    free(exactly);
    free(column);
    CHECK(s != STATUS_NO_MEMORY, "no memory for '%s'", text);
    CHECK((s == STATUS_OK) == (*f != NULL), "'%s': the formula and the status disagree", text);
    return s == STATUS_OK;
}

/* ---- values ---- */

/* `expected` is p, p/q, "angle p/q" or "none". */
static void check_value(const char *text, const char *expected, long k)
{
    diagnostic d;
    formula *f;
    exact_value z;
    bool known = false, angle = !strncmp(expected, "angle ", 6);
    rational q;
    formula_point at = {k, 2, 3};
    exact_init(&z);
    rational_init(&q);
    if (!read_text(&f, &d, text)) {
        test_fail(__FILE__, __LINE__, "'%s' is not read: %s", text, d.text);
    } else {
        status s = formula_exact(&z, &known, f, &at, &d);
        CHECK(s == STATUS_OK, "'%s' has no value: %s", text, d.text);
        CHECK(known == (strcmp(expected, "none") != 0), "'%s' is%s known exactly", text, known ? "" : " not");
        if (known && s == STATUS_OK) {
            const char *number = angle ? expected + 6 : expected;
            char *found = rational_get_str(&z.q);
            CHECK(rational_set_str(&q, number, strlen(number)) == RATIONAL_TEXT_OK, "the test itself");
            CHECK(rational_equal(&q, &z.q) && z.is_angle == angle, "'%s' is %s%s, not %s", text, z.is_angle ? "angle " : "", found, expected);
            free(found);
        }
        /* where a rational is wanted, only a rational will do */
        s = formula_exact_rational(&q, f, &at, &d);
        CHECK((s == STATUS_OK) == (known && !angle), "'%s' as a rational: status %d", text, (int)s);
        formula_free(f);
    }
    exact_clear(&z);
    rational_clear(&q);
}

static void test_values(void)
{
    static const char *const value[][2] = {
        {"12", "12"}, {"0.0625", "1/16"}, {".5", "1/2"}, {"007.250", "29/4"}, {"0", "0"},
        {"1+2*3", "7"}, {"2*3+1", "7"}, {"(1+2)*3", "9"}, {"1-2-3", "-4"}, {"1-(2-3)", "2"}, {"24/4/2", "3"}, {"24/(4/2)", "12"},
        {"2/3*3", "2"}, {"1-2+3", "2"}, {"2*3/4*5", "15/2"},
        {"-2^2", "-4"}, {"(-2)^2", "4"}, {"-2*3", "-6"}, {"-1+2", "1"}, {"-(1+2)", "-3"}, {"1-(-2)", "3"}, {"-0", "0"}, {"(-(-(3)))", "3"},
        {"2^3", "8"}, {"2^-3", "1/8"}, {"2^ - 3", "1/8"}, {"(2/3)^-2", "9/4"}, {"2*3^2", "18"}, {"12/2^2", "3"}, {"2^0", "1"}, {"0^0", "1"}, {"2^064", "18446744073709551616"},
        {"(2^3)^2", "64"}, {"2^(3)", "8"}, {"2^(1/2)", "error"}, {"2^pi", "error"},
        {"k", "5"}, {"k^2-1", "24"}, {"1/k", "1/5"},
        {"pi", "angle 1"}, {"2*pi/k", "angle 2/5"}, {"pi*2", "angle 2"}, {"-pi", "angle -1"}, {"pi+pi/2", "angle 3/2"}, {"pi-3*pi", "angle -2"},
        {"pi-pi", "0"}, {"pi/3+0*pi", "angle 1/3"}, {"0-pi", "angle -1"}, {"pi-0", "angle 1"}, {"0*pi", "0"}, {"pi*0", "0"}, {"pi/pi", "1"}, {"(2*pi)/(3*pi)", "2/3"}, {"pi^1", "angle 1"}, {"pi^0", "1"}, {"(pi/k)^1", "angle 1/5"},
        {"pi^2", "none"}, {"pi*pi", "none"}, {"1+pi", "none"}, {"pi-1", "none"}, {"1/pi", "none"}, {"0/pi", "none"}, {"0+pi", "angle 1"}, {"pi^-1", "none"},
        {"cos(0)", "1"}, {"sin(0)", "0"}, {"cos(pi-pi)", "1"}, {"sin(0*pi)", "0"}, {"cos(pi)", "-1"}, {"cos(pi/3)", "1/2"}, {"cos(2*pi/3)", "-1/2"},
        {"sin(pi/6)", "1/2"}, {"sin(pi/2)", "1"}, {"sin(3*pi/2)", "-1"}, {"sin(-pi/6)", "-1/2"}, {"cos(1001*pi)", "-1"}, {"cos(pi/4)", "none"},
        {"cos(2*pi/k)", "none"}, {"cos(2*pi/6)", "1/2"}, {"cos(pi*pi/pi)", "error"}, {"cos(pi*(pi/pi))", "-1"},
        {"sin(pi/3)", "none"}, {"cos(pi/6)", "none"}, {"cos(pi/5)^0", "1"}, {"cos(pi/5)-cos(pi/5)", "none"}, {"-cos(pi/5)", "none"},
        {"sin(pi/6)+cos(pi/3)*2", "3/2"}, {"3/8 + (3/8 + cos(2*pi/6)/4)^2", "5/8"}, {" 1 + ( 2 ) ", "3"}, {"cos (pi)", "-1"},
        {"m", "2"}, {"j", "3"}, {"k+10*m+100*j", "325"}, {"2^k", "32"}, {"2^-m", "1/4"}, {"2^(k-2*j)", "1/2"}, {"k^(m^(j))", "390625"},
        {"sqrt(0)", "0"}, {"sqrt(9/4)", "3/2"}, {"sqrt(2)", "none"}, {"sqrt(2)^2", "none"}, {"sqrt(pi)", "none"}, {"sqrt(2)^0", "1"}, {"sqrt(4*k+5)", "5"},
        {"sqrt(9)/sqrt(16)", "3/4"}, {"sqrt(1/9)", "1/3"}, {"sqrt(8/9)", "none"}, {"sqrt(4/8)", "none"},
        {"abs(-3/2)", "3/2"}, {"abs(2)", "2"}, {"abs(0)", "0"}, {"abs(-pi)", "angle 1"}, {"abs(pi/7)", "angle 1/7"}, {"abs(sqrt(2))", "none"},
        {"min(1,2)", "1"}, {"min(2,1)", "1"}, {"max(1,2,3/2)", "2"}, {"min(3,1,2,0,5)", "0"}, {"max(-pi,pi/2)", "angle 1/2"}, {"min(pi,pi/2,2*pi)", "angle 1/2"},
        {"min(pi,1)", "none"}, {"max(1,sqrt(2),3)", "none"}, {"min(k,m,j)", "2"},
        {"mod(7,3)", "1"}, {"mod(-7,3)", "2"}, {"mod(7,-3)", "-2"}, {"mod(-7,-3)", "-1"}, {"mod(6,3)", "0"}, {"mod(k,m)", "1"}, {"mod(0,5)", "0"}, {"mod(10^30,7)", "1"},
        {"cases(k = 5: 1; else: 2)", "1"}, {"cases(k = 4: 1; else: 2)", "2"}, {"cases(k != 5: 1; k >= 6: 2; k <= 4: 3; k > 5: 4; k < 5: 5; else: 6)", "6"},
        {"cases(k < 5: 1; k <= 5: 2; k = 5: 3)", "2"}, {"cases(k > 5: 1; k >= 5: 2; k = 5: 3)", "2"}, {"cases(k = 5 and m = 2 and j = 4: 1; else: 2)", "2"},
        {"cases(k = 5 and m = 2 and j = 3: 1; else: 2)", "1"}, {"cases(k = 4 or m = 4 or j = 3: 1; else: 2)", "1"}, {"cases(k = 4 or m = 4: 1; else: 2)", "2"},
        {"cases(else: 3)", "3"}, {"cases(k = 5: pi; else: 1)", "angle 1"}, {"cases(pi < 2*pi: 1; else: 2)", "1"}, {"cases(pi/2 = pi - pi/2: 1; else: 2)", "1"},
        {"cases(sqrt(2) > 1: 1; else: 2)", "none"}, {"cases(k = 5: 1; sqrt(2) > 1: 2)", "1"}, {"cases(pi > 3: 1; else: 2)", "none"},
        {"cases(k = 5: 1; else: 1/0)", "1"}, {"cases(k = 4: 1/0; else: 1)", "1"}, {"1 + cases(k = 5: 2; else: 1)*2", "5"},
        {"cases(k = 4 and 1/sqrt(2) > 0: 1; else: 2)", "2"}, {"cases(k = 5 or 1/sqrt(2) > 0: 1; else: 2)", "1"},
        {"mod(1/2,1)", "error"}, {"mod(1,0)", "error"}, {"mod(pi,1)", "error"}, {"mod(sqrt(2),1)", "error"}, {"sqrt(-1)", "error"}, {"cases(k = 4: 1)", "error"}, {"cos(sqrt(2))", "error"},
        {"2^sqrt(2)", "error"}, {"cases(1/0 = 1: 1; else: 2)", "error"},
    };
    test_begin("formula-values");
    for (size_t i = 0; i < sizeof value / sizeof *value; i++)
        if (strcmp(value[i][1], "error"))
            check_value(value[i][0], value[i][1], 5);
        else {
            diagnostic d;
            formula *f;
            exact_value z;
            bool known;
            formula_point at = at_valence(5);
            exact_init(&z);
            if (read_text(&f, &d, value[i][0])) {
                CHECK(formula_exact(&z, &known, f, &at, &d) == STATUS_BAD_INPUT, "'%s' is accepted", value[i][0]);
                formula_free(f);
            }
            exact_clear(&z);
        }
    test_end();
}

/* cos and sin of every p/q pi, 1 <= q <= 24: exact iff twice the value is a whole number. */
static void test_niven(void)
{
    test_begin("formula-niven");
    for (int q = 1; q <= 24; q++)
        for (int p = -3 * q; p <= 3 * q; p++)
            for (int sine = 0; sine < 2; sine++) {
                char text[64];
                static const char *const known[5] = {"-1", "-1/2", "0", "1/2", "1"};
                double angle = 3.14159265358979323846 * p / q, twice = 2 * (sine ? sin(angle) : cos(angle));
                snprintf(text, sizeof text, "%s(%s%d*pi/%d)", sine ? "sin" : "cos", p < 0 ? "-" : "", abs(p), q);
                check_value(text, fabs(twice - round(twice)) < 1e-6 ? known[(int)round(twice) + 2] : "none", 3);
            }
    test_end();
}

/* ---- random formulas, written down together with their values ---- */

typedef struct {
    char text[4000];
    size_t length;
    bool defined; /* no division by 0 */
} writer;

static void put(writer *w, const char *text)
{
    if (random_below(5) == 0 && w->length)
        w->text[w->length++] = ' ';
    memcpy(w->text + w->length, text, strlen(text) + 1);
    w->length += strlen(text);
}

static void write_formula(rational *z, writer *w, int depth);

static void write_primary(rational *z, writer *w, int depth)
{
    char text[64];
    if (depth > 0 && random_below(3) == 0) {
        put(w, "(");
        write_formula(z, w, depth - 1);
        put(w, ")");
    } else if (random_below(8) == 0) {
        put(w, "k");
        MUST(rational_set_si(z, 17, 1));
    } else if (random_below(8) == 0) {
        put(w, "cos"), put(w, "("), put(w, "pi"), put(w, ")");
        MUST(rational_set_si(z, -1, 1));
    } else {
        int whole = (int)random_below(200), places = (int)random_below(4), fraction = (int)random_below(1000), ten = 1;
        for (int i = 0; i < places; i++)
            ten *= 10;
        fraction %= ten;
        if (!places)
            snprintf(text, sizeof text, "%d", whole);
        else if (whole < 50)
            whole = 0, snprintf(text, sizeof text, ".%0*d", places, fraction);
        else
            snprintf(text, sizeof text, "%d.%0*d", whole, places, fraction);
        put(w, text);
        MUST(rational_set_si(z, whole * ten + fraction, ten));
    }
}

static void write_power(rational *z, writer *w, int depth)
{
    write_primary(z, w, depth);
    if (random_below(4) == 0) {
        long n = (long)random_below(4);
        char text[32];
        put(w, "^");
        if (random_bool())
            put(w, "-"), n = -n;
        snprintf(text, sizeof text, "%ld", labs(n));
        put(w, text);
        if (n < 0 && rational_is_zero(z))
            w->defined = false;
        else
            MUST(rational_pow(z, z, n));
    }
}

static void write_term(rational *z, writer *w, int depth)
{
    rational next;
    rational_init(&next);
    write_power(z, w, depth);
    while (random_below(3) == 0) {
        bool times = random_bool();
        put(w, times ? "*" : "/");
        write_power(&next, w, depth);
        if (times)
            MUST(rational_mul(z, z, &next));
        else if (rational_is_zero(&next))
            w->defined = false;
        else
            MUST(rational_div(z, z, &next));
    }
    rational_clear(&next);
}

static void write_formula(rational *z, writer *w, int depth)
{
    bool minus = random_below(4) == 0;
    rational next;
    rational_init(&next);
    if (minus)
        put(w, "-");
    write_term(z, w, depth);
    if (minus)
        MUST(rational_neg(z, z));
    while (random_below(3) == 0) {
        bool plus = random_bool();
        put(w, plus ? "+" : "-");
        write_term(&next, w, depth);
        MUST(plus ? rational_add(z, z, &next) : rational_sub(z, z, &next));
    }
    rational_clear(&next);
}

static void test_random(void)
{
    test_begin("formula-random");
    for (test_cases(3000); test_next();) {
        writer w = {"", 0, true};
        rational expected, found;
        diagnostic d;
        formula *f;
        formula_point at = at_valence(17);
        rational_init(&expected), rational_init(&found);
        write_formula(&expected, &w, 3);
        if (w.length < 900 && integer_bits(&expected.numerator) < 2000) {
            if (!read_text(&f, &d, w.text)) {
                test_fail(__FILE__, __LINE__, "'%s' is not read: %s", w.text, d.text);
            } else {
                status s = formula_exact_rational(&found, f, &at, &d);
                CHECK((s == STATUS_OK) == w.defined, "'%s': status %d", w.text, (int)s);
                if (s == STATUS_OK && w.defined)
                    CHECK(rational_equal(&found, &expected), "'%s' has the wrong value", w.text);
                CHECK((f->depends == FORMULA_ON_VALENCE) == (strchr(w.text, 'k') != NULL) && (f->depends & ~(unsigned)FORMULA_ON_VALENCE) == 0, "'%s' depends on k?", w.text);
                formula_free(f);
            }
        }
        rational_clear(&expected), rational_clear(&found);
    }
    test_end();
}

/* ---- complaints ---- */

static void check_complaint(const char *text, long column, const char *expected)
{
    diagnostic d;
    formula *f;
    if (read_text(&f, &d, text)) {
        test_fail(__FILE__, __LINE__, "'%s' is accepted", text);
        formula_free(f);
        return;
    }
    CHECK(d.line == 7 && d.column == column, "'%s': line %ld, column %ld, not %ld", text, d.line, d.column, column);
    CHECK(!strcmp(d.text, expected), "'%s': \"%s\"", text, d.text);
}

#define A_PRIMARY "expected a number, a word or '('"
#define NO_OPERATOR "expected an operator or the end of the line"

static void test_complaints(void)
{
    test_begin("formula-complaints");
    check_complaint("", 1, A_PRIMARY ", but the formula ends");
    check_complaint("1+", 3, A_PRIMARY ", but the formula ends");
    check_complaint("1 + ", 5, A_PRIMARY ", but the formula ends");
    check_complaint("*2", 1, A_PRIMARY ", found '*'");
    check_complaint("+2", 1, A_PRIMARY ", found '+'");
    check_complaint("2*-1", 3, A_PRIMARY ", found '-'");
    check_complaint("2--1", 3, A_PRIMARY ", found '-'");
    check_complaint("1 $", 3, NO_OPERATOR ", found '$'");
    check_complaint("1 2", 3, NO_OPERATOR ", found '2'");
    check_complaint("2k", 2, NO_OPERATOR ", found 'k'");
    check_complaint("(1)(2)", 4, NO_OPERATOR ", found '('");
    check_complaint("1)", 2, NO_OPERATOR ", found ')'");
    check_complaint("(1", 3, "expected ')' or an operator, but the formula ends");
    check_complaint("(1 2)", 4, "expected ')' or an operator, found '2'");
    check_complaint("()", 2, A_PRIMARY ", found ')'");
    check_complaint("1.", 1, "'1.' is not a number such as 3, 0.25 or .5");
    check_complaint("2+1.2.3", 3, "'1.2.3' is not a number such as 3, 0.25 or .5");
    check_complaint(".", 1, "'.' is not a number such as 3, 0.25 or .5");
    check_complaint("1e5", 2, NO_OPERATOR ", found 'e5'");
    check_complaint("x", 1, "unknown word 'x': expected a number, k, pi, a function or a name defined before");
    check_complaint("2*tan(pi)", 3, "unknown word 'tan': expected a number, k, pi, a function or a name defined before");
    check_complaint("kk", 1, "unknown word 'kk': expected a number, k, pi, a function or a name defined before");
    check_complaint("pik", 1, "unknown word 'pik': expected a number, k, pi, a function or a name defined before");
    check_complaint("cos", 4, "expected '(', but the formula ends");
    check_complaint("cos 2", 5, "expected '(', found '2'");
    check_complaint("2^3^2", 4, "a second '^' needs parentheses, such as (a^b)^c");
    check_complaint("2^", 3, A_PRIMARY ", but the formula ends");
    check_complaint("2^+3", 3, A_PRIMARY ", found '+'");
    check_complaint("2^--3", 4, A_PRIMARY ", found '-'");
    check_complaint("2^-", 4, A_PRIMARY ", but the formula ends");
    check_complaint("2^-3^2", 5, "a second '^' needs parentheses, such as (a^b)^c");
    check_complaint("2^6 4", 5, NO_OPERATOR ", found '4'");
    check_complaint("K", 1, A_PRIMARY ", found 'K'");
    check_complaint("sqrt(1,2)", 7, "expected ')' or an operator, found ','");
    check_complaint("min(1)", 6, "expected ',', found ')'");
    check_complaint("mod(1,2,3)", 8, "expected ')' or an operator, found ','");
    check_complaint("max(1,)", 7, A_PRIMARY ", found ')'");
    check_complaint("cases()", 7, A_PRIMARY ", found ')'");
    check_complaint("cases(k: 1)", 8, "expected a comparison: = != < <= > or >=, found ':'");
    check_complaint("cases(k = 1 2)", 13, "expected ':', found '2'");
    check_complaint("cases(k = 1: 2; else: 3; k = 4: 5)", 24, "expected ')', found ';'");
    check_complaint("cases(k = 1: 2 else: 3)", 16, "expected ';' or ')', found 'else'");
    check_complaint("cases(k = 1: 2;)", 16, A_PRIMARY ", found ')'");
    check_complaint("cases(k = 1 and m = 2 or j = 3: 1; else: 2)", 23, "'and' and 'or' cannot be mixed in one condition");
    check_complaint("cases(k ! 1: 2)", 9, "expected a comparison: = != < <= > or >=, found '!'");
    check_complaint("cases(k == 1: 2)", 10, "expected a formula behind the comparison (equality is written with one '='), found '='");
    check_complaint("sqr(2)", 1, "unknown word 'sqr'; did you mean 'sqrt'?");
    check_complaint("coss(2)", 1, "unknown word 'coss'; did you mean 'cos'?");
    test_end();
}

static void check_no_value(const char *text, long column, const char *expected)
{
    diagnostic d;
    formula *f;
    exact_value z;
    bool known = true;
    formula_point at = at_valence(6);
    exact_init(&z);
    if (read_text(&f, &d, text)) {
        CHECK(formula_exact(&z, &known, f, &at, &d) == STATUS_BAD_INPUT, "'%.60s' has a value", text);
        CHECK(d.line == 7 && d.column == column, "'%.60s': column %ld, not %ld", text, d.column, column);
        CHECK(!strcmp(d.text, expected), "'%.60s': \"%s\"", text, d.text);
        formula_free(f);
    } else {
        test_fail(__FILE__, __LINE__, "'%.60s' is not read", text);
    }
    exact_clear(&z);
}

static void test_no_value(void)
{
    test_begin("formula-without-value");
    check_no_value("1/0", 2, "division by zero");
    check_no_value("2 + 1/(k-6)", 6, "division by zero (at k = 6)");
    check_no_value("pi/0", 3, "division by zero");
    check_no_value("0^-1", 2, "division by zero");
    check_no_value("(k-6)^-2", 6, "division by zero (at k = 6)");
    check_no_value("1/(pi-pi)", 2, "division by zero");
    check_no_value("cos(1)", 1, "cos and sin need a rational multiple of pi");
    check_no_value("1+sin(cos(pi/5))", 3, "cos and sin need a rational multiple of pi");
    check_no_value("cos(pi^2)", 1, "cos and sin need a rational multiple of pi");
    check_no_value("cos(1+pi)", 1, "cos and sin need a rational multiple of pi");
    check_no_value("cos(pi/5)*(1/0)", 13, "division by zero");
    check_no_value("(1/0)^0", 3, "division by zero");
    check_no_value("1 + sqrt(2-k)", 5, "the square root of something negative (at k = 6)");
    check_no_value("mod(k,4/3)", 1, "mod takes two whole numbers, the second not 0 (at k = 6)");
    check_no_value("2*mod(3,k-6)", 3, "mod takes two whole numbers, the second not 0 (at k = 6)");
    check_no_value("2^(1/k)", 2, "expected a whole number as the exponent (at k = 6)");
    check_no_value("1+cases(k = 5: 1; k < 3: 2)", 3, "no case applies; add 'else: ...' (at k = 6)");
    check_no_value("1/(m+j)+1/(k-6)", 2, "division by zero (at m = 0, j = 0)");
    check_no_value("1/(m*j*(k-6))", 2, "division by zero (at k = 6, m = 0, j = 0)");
    test_end();
}

/* ---- limits ---- */

static void nested(char *text, int depth, const char *open)
{
    *text = 0;
    for (int i = 0; i < depth; i++)
        strcat(text, open);
    strcat(text, "pi");
    for (int i = 0; i < depth; i++)
        strcat(text, ")");
}

#define LARGE "a rational number of more than 16384 bits"

static void test_limits(void)
{
    char text[1200];
    diagnostic d;
    formula *f;
    rational q;
    formula_point at = at_valence(3);
    test_begin("formula-limits");
    rational_init(&q);
    nested(text, 64, "(");
    check_value(text, "angle 1", 3);
    nested(text, 65, "(");
    check_complaint(text, 65, "parentheses nest more than 64 deep");
    nested(text, 500, "(");
    check_complaint(text, 65, "parentheses nest more than 64 deep");
    strcpy(text, "0*");
    nested(text + 2, 65, "cos(");
    check_complaint(text, 2 + 4 * 65, "parentheses nest more than 64 deep");
    nested(text, 64, "(");
    strcat(text, "+");
    nested(text + strlen(text), 64, "("); /* side by side is no nesting */
    check_value(text, "angle 2", 3);
    check_value("0^64", "0", 3);
    check_value("1^-64", "1", 3);
    /* 2^16383 has 16384 bits */
    CHECK(read_text(&f, &d, "((2^64)^64)^3 * (2^64)^63 * 2^63") && formula_exact_rational(&q, f, &at, &d) == STATUS_OK && integer_bits(&q.numerator) == 16384, "2^16383");
    formula_free(f);
    CHECK(read_text(&f, &d, "1/((2^64)^64)^3 / (2^64)^63 / 2^63") && formula_exact_rational(&q, f, &at, &d) == STATUS_OK && integer_bits(&q.denominator) == 16384, "2^-16383");
    formula_free(f);
    CHECK(read_text(&f, &d, "-((2^64)^64)^3 * (2^64)^63 * (2^63 + 2^63 - 1)") && formula_exact_rational(&q, f, &at, &d) == STATUS_OK && integer_bits(&q.numerator) == 16384, "almost 2^16384");
    formula_free(f);
    check_no_value("((2^64)^64)^3 * (2^64)^63 * 2^63*2", 33, LARGE);
    check_no_value("1/((2^64)^64)^3 / (2^64)^63 / 2^63/2", 35, LARGE);
    check_no_value("((2^64)^64)^4", 12, LARGE);
    check_no_value("((2^64)^64)^-4", 12, LARGE);
    check_no_value("((2^64)^64)^4/((2^64)^64)^4", 12, LARGE);
    check_no_value("((2^64)^64)^64", 12, LARGE);
    check_no_value("((3^64)^64)^3", 12, LARGE); /* 19,477 bits */
    check_no_value("((3/2^64)^64)^-5", 14, LARGE);
    check_no_value("pi*((2^64)^64)^4", 15, LARGE);
    check_no_value("0*((2^64)^64)^4", 14, LARGE);
    check_no_value("cos(pi*(2^64)^64*(2^64)^64*(2^64)^64*(2^64)^64)", 37, LARGE);
    /* a chain as long as a line */
    strcpy(text, "1");
    for (int i = 0; i < 499; i++)
        strcat(text, i % 2 ? "-1" : "+1");
    check_value(text, "2", 3);
    memset(text, '9', 1000);
    text[1000] = 0;
    CHECK(read_text(&f, &d, text) && formula_exact_rational(&q, f, &at, &d) == STATUS_OK && integer_bits(&q.numerator) == 3322, "a number of 1000 digits");
    formula_free(f);
    rational_clear(&q);
    test_end();
}

/* Random bytes and broken formulas are refused or read, and never do any harm. */
static void test_garbage(void)
{
    static const char alphabet[] = "0123456789.+-*/^()kpicosin  ";
    test_begin("formula-garbage");
    for (test_cases(20000); test_next();) {
        char text[64];
        size_t length = (size_t)random_below(24);
        diagnostic d;
        formula *f;
        for (size_t i = 0; i < length; i++)
            text[i] = alphabet[random_below(sizeof alphabet - 1)];
        text[length] = 0;
        bool read = read_text(&f, &d, text);
        CHECK(read || (d.line == 7 && d.column >= 1 && d.column <= (long)length + 1 && *d.text), "'%s': column %ld", text, d.column);
        if (read) {
            exact_value z;
            bool known;
            formula_point at = at_valence(5);
            exact_init(&z);
            CHECK(formula_exact(&z, &known, f, &at, &d) != STATUS_NO_MEMORY, "'%s'", text);
            exact_clear(&z);
        }
        formula_free(f);
    }
    test_end();
}

int main(void)
{
    test_values();
    test_niven();
    test_random();
    test_complaints();
    test_no_value();
    test_limits();
    test_garbage();
    return test_status();
}
