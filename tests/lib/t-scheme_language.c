/* t-scheme_language.c: definitions, settings, rules, conditions and compositions of scheme files. */
#include <stdlib.h>

#include "common.h"

#define HEAD "scheme x\nmesh triangle\ndilation 2\nvertices interior\n"
#define HEAD_QUAD "scheme x\nmesh quad\ndilation 2\nvertices interior\n"
#define HEAD_DUAL "scheme x\nmesh quad-dual\ndilation 2\nvertices interior\n"
#define MASK "mask symmetric\n(0,0) 1\n(1,0) 1/2\nend\n"
#define BUTTERFLY(w) "mask symmetric\n(0,0) 1\n(1,0) 1/2\n(1,1) 2*" w "\n(2,1) -" w "\nend\n"

static status read_with(scheme *z, const char *text, const char *const *settings, int count, diagnostic *d)
{
    scheme_settings given = {settings, count};
    size_t length = strlen(text);
    char *exactly = malloc(length + 1);
    memcpy(exactly, text, length);
    *d = (diagnostic){0, 0, ""};
    scheme_init(z);
    status s = scheme_read(z, exactly, length, count ? &given : NULL, d);
    free(exactly);
    return s;
}

static void check_complaint(const char *name, const char *text, const char *setting, long line, long column, const char *expected)
{
    scheme s;
    diagnostic d;
    status answer = read_with(&s, text, &setting, setting ? 1 : 0, &d);
    CHECK(answer == STATUS_BAD_INPUT, "%s: accepted (status %d)", name, (int)answer);
    CHECK(d.line == line && d.column == column, "%s: at %ld:%ld, not %ld:%ld: %s", name, d.line, d.column, line, column, d.text);
    CHECK(!strcmp(d.text, expected), "%s: \"%s\", not \"%s\"", name, d.text, expected);
    scheme_clear(&s);
}

static void check_accepted(const char *name, const char *text)
{
    scheme s;
    diagnostic d;
    CHECK(read_with(&s, text, NULL, 0, &d) == STATUS_OK, "%s: %ld:%ld: %s", name, d.line, d.column, d.text);
    scheme_clear(&s);
}

/* The scheme's mask at (a,b) is p/q. */
static void check_weight(const char *text, const char *const *settings, int count, int a, int b, long p, long q)
{
    scheme s;
    diagnostic d;
    rational w;
    rational_init(&w);
    CHECK(read_with(&s, text, settings, count, &d) == STATUS_OK, "%ld:%ld: %s", d.line, d.column, d.text);
    if (!test_failed()) {
        MUST(laurent_get(&w, &s.mask, a, b));
        CHECK(rational_cmp_si(&w, p, q) == 0, "the weight at (%d,%d) is not %ld/%ld", a, b, p, q);
    }
    rational_clear(&w);
    scheme_clear(&s);
}

/* ---- parameters and abbreviations ---- */

static void test_definitions(void)
{
    static const char text[] = HEAD "parameter w = 1/16\nparameter u2_x = w/2 + sqrt(1/4)\nlet v = 2*u2_x - 1\n" BUTTERFLY("v");
    static const char *const half[] = {"w=1/32"}, *const both[] = {"u2_x=.55", "w=7"}, *const last[] = {"w=1/32", "w=1/64"};
    test_begin("language-definitions");
    check_weight(text, NULL, 0, 2, 1, -1, 16);
    check_weight(text, NULL, 0, 1, 1, 1, 8);
    check_weight(text, half, 1, 2, 1, -1, 32); /* also by way of what depends on it */
    check_weight(text, both, 2, 2, 1, -1, 10);
    check_weight(text, last, 1, 2, 1, -1, 32);
    check_complaint("unknown parameter", text, "x=1", 0, 0, "the scheme has no parameter for the setting 'x=1' (expected NAME=VALUE)");
    check_complaint("abbreviation", text, "v=1", 0, 0, "the scheme has no parameter for the setting 'v=1' (expected NAME=VALUE)");
    check_complaint("longer name", text, "w2=1", 0, 0, "the scheme has no parameter for the setting 'w2=1' (expected NAME=VALUE)");
    check_complaint("shorter name", text, "u2_=1", 0, 0, "the scheme has no parameter for the setting 'u2_=1' (expected NAME=VALUE)");
    check_complaint("no value", text, "w=", 0, 1, "expected a number, a word or '(', but the formula ends");
    check_complaint("no equals sign", text, "w", 0, 0, "the scheme has no parameter for the setting 'w' (expected NAME=VALUE)");
    check_complaint("bad value", text, "w=1/16)", 0, 5, "expected an operator or the end of the line, found ')'");
    check_complaint("valence in a value", text, "w=k", 0, 1, "k, the valence, has no meaning here");
    check_complaint("irrational value", text, "w=sqrt(2)", 0, 1, "expected a rational number, and this value is not one");
    check_complaint("no name", HEAD "parameter = 1\n" MASK, NULL, 5, 11, "expected a new name (lower-case letters, digits and '_'; not a word of the language), found '='");
    check_complaint("upper case", HEAD "let Ab = 1\n" MASK, NULL, 5, 5, "expected a new name (lower-case letters, digits and '_'; not a word of the language), found 'Ab'");
    check_complaint("twice", HEAD "let a = 1\nparameter a = 2\n" MASK, NULL, 6, 11, "expected a name that is not defined yet, found 'a'");
    check_complaint("no equals", HEAD "let a 1\n" MASK, NULL, 5, 7, "expected '=', found '1'");
    check_complaint("no formula", HEAD "let a =\n" MASK, NULL, 5, 8, "expected a formula, but the line ends");
    check_complaint("used too early", HEAD "let a = bbbbbb\nlet bbbbbb = 1\n" MASK, NULL, 5, 9, "unknown word 'bbbbbb': expected a number, k, pi, a function or a name defined before");
    check_complaint("used in itself", HEAD "let aaaa = aaaa\n" MASK, NULL, 5, 12, "unknown word 'aaaa': expected a number, k, pi, a function or a name defined before");
    check_complaint("parameter of the valence", HEAD "parameter a = 1/k\n" MASK, NULL, 5, 17, "k, the valence, has no meaning here");
    check_complaint("parameter by way of a name", HEAD "let b = 1/k\nparameter a = b\n" MASK, NULL, 6, 15, "the value of this name depends on k, the valence, which has no meaning here");
    check_complaint("mask by way of names", HEAD "let b = 1/k\nlet c = 2*b\n" BUTTERFLY("c"), NULL, 10, 9, "the value of this name depends on k, the valence, which has no meaning here");
    check_complaint("after the mask", HEAD MASK "let a = 1\n", NULL, 9, 1, "expected nothing more, found 'let'");
    check_complaint("division", HEAD "let z = 0\nparameter a = 1/z\n" MASK, NULL, 6, 16, "division by zero");
    test_end();

    static const char *const words[] = {"scheme", "mesh", "triangle", "quad", "dual", "dilation", "vertices", "interior", "boundary", "crease", "parameter", "let", "mask",
                                        "symmetric", "end", "rule", "centre", "when", "all", "rest", "spectrum", "compose", "refine", "repeat", "smooth", "average", "and", "or", "pi", "k",
                                        "m", "j", "cos", "sin", "sqrt", "abs", "min", "max", "mod", "cases", "else"};
    test_begin("language-reserved-words");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char line[1000], name[64];
        snprintf(line, sizeof line, HEAD "let %s = 1\n" MASK, words[i]);
        scheme s;
        diagnostic d;
        CHECK(read_with(&s, line, NULL, 0, &d) == STATUS_BAD_INPUT && d.line == 5 && d.column == 5, "'%s' is accepted as a name", words[i]);
        scheme_clear(&s);
        snprintf(name, sizeof name, "%s%c", words[i], "2_x"[i % 3]); /* longer words are names like others */
        snprintf(line, sizeof line, HEAD "let %s = 1\nlet b = 2*%s\nmask symmetric\n(0,0) %s\n(1,0) %s/2\nend\nrule centre\ncentre %s\nall (1,0) rest\nend\n", name, name, name, name, name);
        CHECK(read_with(&s, line, NULL, 0, &d) == STATUS_OK, "'%s' is no name: %ld:%ld: %s", name, d.line, d.column, d.text);
        scheme_clear(&s);
    }
    test_end();
}

static void test_intervals(void)
{
    static const char text[] = HEAD "parameter c = [1/20, 1/10]\nparameter d = 3\n" MASK "rule centre\ncentre c\nall (1,0) rest\nend\n";
    static const char *const point[] = {"c=1/7"}, *const other[] = {"c=[-1,min(1,2)]"};
    scheme s;
    diagnostic d;
    test_begin("language-interval-parameters");
    for (int i = 0; i < 3; i++) {
        CHECK(read_with(&s, text, i == 1 ? point : other, i > 0, &d) == STATUS_OK, "%s", d.text);
        if (!test_failed()) {
            const formula *f = s.definitions.entry[0].value;
            const formula *w = s.steps[0].rules[0].sources[0].weight;
            CHECK((f->kind == FORMULA_INTERVAL) == (i != 1) && s.definitions.entry[0].is_parameter, "kind");
            CHECK(w && ((w->depends & FORMULA_ON_INTERVAL) != 0) == (i != 1), "dependence");
            if (i != 1)
                CHECK(rational_cmp_si(&f->number, i ? -1 : 1, i ? 1 : 20) == 0 && rational_cmp_si(&f->high, 1, i ? 1 : 10) == 0, "ends");
        }
        scheme_clear(&s);
    }
    check_accepted("one point", HEAD "parameter c = [1/2,1/2]\n" MASK);
    check_complaint("empty", HEAD "parameter c = [1, 1/2]\n" MASK, NULL, 5, 15, "the lower end of this interval is above the upper one");
    check_complaint("one end", HEAD "parameter c = [1]\n" MASK, NULL, 5, 15, "expected an interval such as [1/20, 1/10]");
    check_complaint("open", HEAD "parameter c = [1,2\n" MASK, NULL, 5, 15, "expected an interval such as [1/20, 1/10]");
    check_complaint("three ends", HEAD "parameter c = [1,2,3]\n" MASK, NULL, 5, 19, "expected an operator or the end of the line (decimals have a point: 0.5), found ','");
    check_complaint("no lower end", HEAD "parameter c = [,2]\n" MASK, NULL, 5, 16, "expected a number, a word or '(', but the formula ends");
    check_complaint("abbreviation", HEAD "let c = [1,2]\n" MASK, NULL, 5, 9, "expected a number, a word or '(' (an interval can only be the whole value of a parameter), found '['");
    check_complaint("setting", text, "c=[2,1]", 0, 1, "the lower end of this interval is above the upper one");
    check_complaint("mask", HEAD "parameter c = [1/20, 1/10]\n" BUTTERFLY("c"), NULL, 9, 8, "expected one rational number, and this is an interval");
    test_end();
}

/* Whatever a file asks for, it is answered at once: these two would take minutes. */
static void test_work(void)
{
    char text[20000];
    size_t n = (size_t)sprintf(text, HEAD_QUAD "let a = (3/7)^2500\nlet b = a");
    test_begin("language-work");
    for (int i = 0; i < 150; i++)
        n += (size_t)sprintf(text + n, "*a/a");
    n += (size_t)sprintf(text + n, "\nlet c = b/a\nmask\n");
    for (int a = -8; a <= 8; a++)
        for (int b = -8; b <= 8; b++)
            n += (size_t)sprintf(text + n, "(%d,%d) c\n", a, b);
    sprintf(text + n, "end\n");
    check_complaint("operations", text, NULL, 16, 9, "with this one the formulas of the file have more than 20000 operations, definitions written out");
    n = (size_t)sprintf(text, HEAD_QUAD "mask\n");
    for (int a = -8; a <= 8; a++)
        for (int b = -8; b <= 8; b++)
            n += (size_t)sprintf(text + n, "(%d,%d) 1/%d^1200\n", a, b, 1001 + 17 * a + b);
    sprintf(text + n, "end\n");
    check_complaint("denominators", text, NULL, 7, 1, "with this one the weights of the mask have a common denominator of more than 16384 bits");
    check_complaint("a composition", HEAD_QUAD "let b = 1/4 + 1/7^1400\ncompose\nrefine\nrepeat 33: smooth b, 1/2\nend\n", NULL, 9, 1,
                    "the weights of the composed mask have a common denominator of more than 16384 bits");
    test_end();
}

static void test_limits(void)
{
    char text[9000], line[1000], name[40];
    scheme s;
    diagnostic d;
    test_begin("language-limits");
    for (int count = 64; count <= 65; count++) { /* definitions */
        strcpy(text, HEAD);
        for (int i = 0; i < count; i++) {
            snprintf(line, sizeof line, "%s a%d = %d\n", i % 2 ? "let" : "parameter", i, i);
            strcat(text, line);
        }
        strcat(text, MASK);
        status answer = read_with(&s, text, NULL, 0, &d);
        CHECK(answer == (count == 64 ? STATUS_OK : STATUS_BAD_INPUT), "%d definitions", count);
        if (count == 65)
            CHECK(d.line == 69 && !strcmp(d.text, "more than 64 parameters and abbreviations"), "%ld: %s", d.line, d.text);
        scheme_clear(&s);
    }
    for (int length = 32; length <= 33; length++) { /* names */
        memset(name, 'n', sizeof name);
        name[length] = 0;
        snprintf(text, sizeof text, HEAD "let %s = 1\nlet b = %s\n" MASK, name, name);
        CHECK((read_with(&s, text, NULL, 0, &d) == STATUS_OK) == (length == 32), "a name of %d characters", length);
        CHECK(length == 32 || (d.line == 5 && d.column == 5), "%ld:%ld", d.line, d.column);
        scheme_clear(&s);
    }
    for (int count = 16; count <= 17; count++) { /* rules */
        strcpy(text, HEAD MASK);
        for (int i = 0; i < count; i++) {
            snprintf(line, sizeof line, "rule (%d,0)\ncentre rest\nend\n", i + 1);
            strcat(text, count == 17 && i == 3 ? "rule centre\ncentre rest\nend\n" : i == 16 ? "rule centre\ncentre rest\nend\n" : line);
        }
        status answer = read_with(&s, text, NULL, 0, &d);
        CHECK(answer == (count == 16 ? STATUS_OK : STATUS_BAD_INPUT), "%d rules: %s", count, d.text);
        if (count == 17)
            CHECK(d.line == 8 + 3 * 16 + 1 && !strcmp(d.text, "a scheme may have 16 rules at most"), "%ld: %s", d.line, d.text);
        scheme_clear(&s);
    }
    for (int count = 32; count <= 33; count++) { /* sources */
        strcpy(text, HEAD MASK "rule centre\ncentre rest\n");
        for (int i = 1; i < count; i++)
            strcat(text, "all (1,0) 1/100\n");
        strcat(text, "end\n");
        status answer = read_with(&s, text, NULL, 0, &d);
        CHECK(answer == (count == 32 ? STATUS_OK : STATUS_BAD_INPUT), "%d sources", count);
        if (count == 33)
            CHECK(d.line == 10 + 32 && !strcmp(d.text, "a rule may have 32 sources at most"), "%ld: %s", d.line, d.text);
        scheme_clear(&s);
    }
    for (int count = 12; count <= 13; count++) { /* 2^12 k's, 2^12 - 1 sums, and a reference for each: 3 * 2^12 - 2 in all is too much */
        strcpy(text, HEAD "let a0 = k\n");
        for (int i = 1; i < count; i++) {
            snprintf(line, sizeof line, "let a%d = a%d + a%d\n", i, i - 1, i - 1);
            strcat(text, line);
        }
        strcat(text, MASK);
        /* size(0) = 1, size(i) = 2 (size(i - 1) + 1) + 1: 1, 5, 13, 29 ... 2^(i+2) - 3; 8189 for i = 11, 16381 for i = 12 */
        status answer = read_with(&s, text, NULL, 0, &d);
        CHECK(answer == (count == 12 ? STATUS_OK : STATUS_BAD_INPUT), "%d doublings", count);
        if (count == 13)
            CHECK(d.line == 17 && !strcmp(d.text, "this formula has more than 10000 operations, definitions written out"), "%ld: %s", d.line, d.text);
        scheme_clear(&s);
    }
    check_accepted("reach 16", HEAD MASK "rule (16,0)\ncentre rest\nend\n");
    check_complaint("reach 17", HEAD MASK "rule (17,0)\ncentre rest\nend\n", NULL, 9, 6,
                    "expected a point of the sector: (a,b) with a >= 1, b >= 0, at most 16 rings out, found '(17,0)'");
    check_accepted("offset 999", HEAD MASK "rule (1,0)\ncentre rest\n(1,0) @ -999 1\nend\n");
    check_complaint("offset 1000", HEAD MASK "rule (1,0)\ncentre rest\n(1,0) @ 1000 1\nend\n", NULL, 11, 9, "expected j, or a whole number of sectors with at most three digits, found '1000'");
    test_end();
}

/* ---- rules ---- */

/* Which rule holds at k: the number of its line, 0 = none. */
static long rule_line(const scheme *s, bool centre, int a, int b, long k)
{
    const rule *r;
    diagnostic d = {0, 0, ""};
    lattice p = {a, b};
    CHECK(scheme_find_rule(&r, &s->steps[0], centre, p, k, &d) == STATUS_OK, "k = %ld: %s", k, d.text);
    return r ? r->line : 0;
}

static void test_conditions(void)
{
    static const char text[] = HEAD "let three = 3\n" MASK "rule (1,0) when k = three or k > 100\ncentre rest\nend\nrule (1,0) when mod(k,2) = 0 and k != 6\ncentre rest\nend\n"
                                    "rule centre\ncentre rest\nend\nrule (1,0) when k < 6\ncentre rest\nend\nrule (2,1) when cos(2*pi/k) = 1/2\ncentre rest\nend\n";
    scheme s;
    diagnostic d;
    const rule *r;
    test_begin("language-conditions");
    CHECK(read_with(&s, text, NULL, 0, &d) == STATUS_OK, "%ld:%ld: %s", d.line, d.column, d.text);
    if (!test_failed()) {
        for (long k = 3; k < 200; k++) {
            CHECK(rule_line(&s, false, 1, 0, k) == (k == 3 || k > 100 ? 10 : k % 2 == 0 && k != 6 ? 13 : k < 6 ? 19 : 0), "the rule of (1,0) at k = %ld", k);
            CHECK(rule_line(&s, true, 0, 0, k) == 16 && rule_line(&s, false, 0, 1, k) == 0 && rule_line(&s, false, 2, 0, k) == 0, "other rules at k = %ld", k);
        }
        CHECK(rule_line(&s, false, 2, 1, 6) == 22 && rule_line(&s, false, 2, 1, 4) == 0, "an exact cosine");
        CHECK(scheme_find_rule(&r, &s.steps[0], false, (lattice){2, 1}, 7, &d) == STATUS_BAD_INPUT && d.line == 22 && d.column == 29 && !strcmp(d.text, "this comparison cannot be decided (at k = 7)"),
              "%ld:%ld: %s", d.line, d.column, d.text);
    }
    scheme_clear(&s);
    check_complaint("condition of m", HEAD MASK "rule (1,0) when m = 1\ncentre rest\nend\n", NULL, 9, 17, "m, the frequency, has no meaning here");
    check_complaint("no comparison", HEAD MASK "rule (1,0) when k\ncentre rest\nend\n", NULL, 9, 18, "expected a comparison: = != < <= > or >=, but the formula ends");
    check_complaint("mixture", HEAD MASK "rule (1,0) when k = 1 or k = 2 and k = 3\ncentre rest\nend\n", NULL, 9, 32, "'and' and 'or' cannot be mixed in one condition");
    check_complaint("no condition", HEAD MASK "rule (1,0) when\ncentre rest\nend\n", NULL, 9, 16, "expected a number, a word or '(', but the formula ends");
    check_complaint("other word", HEAD MASK "rule (1,0) if k = 3\ncentre rest\nend\n", NULL, 9, 12, "expected 'when' or the end of the line, found 'if'");
    test_end();
}

#define ONE_REST "exactly one weight of a rule must be 'rest', so that they sum to 1 exactly"

static void test_sources(void)
{
    static const char text[] = HEAD MASK "rule (1,0)\ncentre 1/8\nall (2,1) k/9\n(1,0) rest\n(1,1) @ -3 1/7\n(3,2)@12 1/6\n(1,0) @ j j/k^3\n(1,0) spectrum 1/(m+1), m/k\nend\n"
                                    "rule (2,0)\n(1,0) spectrum cases(m = 0: 3; else: min(m,2))\ncentre 1/5\nend\n";
    static const struct {
        source_kind kind;
        int a, b, offset;
        bool weight, imaginary;
        unsigned depends;
    } expected[] = {{SOURCE_CENTRE, 0, 0, 0, true, false, 0}, {SOURCE_ALL, 2, 1, 0, true, false, FORMULA_ON_VALENCE}, {SOURCE_POINT, 1, 0, 0, false, false, 0},
                    {SOURCE_POINT, 1, 1, -3, true, false, 0}, {SOURCE_POINT, 3, 2, 12, true, false, 0}, {SOURCE_SECTORS, 1, 0, 0, true, false, FORMULA_ON_VALENCE | FORMULA_ON_SECTOR},
                    {SOURCE_SPECTRUM, 1, 0, 0, true, true, FORMULA_ON_FREQUENCY}};
    scheme s;
    diagnostic d;
    test_begin("language-sources");
    CHECK(read_with(&s, text, NULL, 0, &d) == STATUS_OK, "%ld:%ld: %s", d.line, d.column, d.text);
    if (!test_failed()) {
        const rule *r = &s.steps[0].rules[0];
        CHECK(s.steps[0].rule_count == 2 && r->count == 7 && !r->at_centre && r->point.a == 1 && r->point.b == 0 && !r->spectrum_takes_rest, "the rule");
        for (int i = 0; i < 7 && !test_failed(); i++) {
            const source *z = &r->sources[i];
            CHECK(z->kind == expected[i].kind && z->point.a == expected[i].a && z->point.b == expected[i].b && z->offset == expected[i].offset, "source %d", i);
            CHECK((z->weight != NULL) == expected[i].weight && (z->imaginary != NULL) == expected[i].imaginary, "weights of source %d", i);
            CHECK(!z->weight || z->weight->depends == expected[i].depends, "source %d depends on %u", i, z->weight->depends);
        }
        CHECK(s.steps[0].rules[1].spectrum_takes_rest && s.steps[0].rules[1].count == 2, "the second rule");
        CHECK(!s.mirror_symmetric, "a mirror");
        CHECK(scheme_step_rings_needed(&s.steps[0], 1) == 5 && scheme_step_rings_needed(&s.steps[0], 12) == 6, "rings: %d, %d", scheme_step_rings_needed(&s.steps[0], 1),
              scheme_step_rings_needed(&s.steps[0], 12));
        CHECK(scheme_closed_rings(&s) == 5, "%d closed rings", scheme_closed_rings(&s));
    }
    scheme_clear(&s);
    check_complaint("two rests", HEAD MASK "rule (1,0)\ncentre rest\n(1,0) rest\nend\n", NULL, 12, 1, ONE_REST);
    check_complaint("rest and nothing", HEAD MASK "rule (1,0)\nend\n", NULL, 10, 1, ONE_REST);
    check_complaint("no rest", HEAD MASK "rule (1,0)\ncentre 1\nend\n", NULL, 11, 1, ONE_REST);
    check_complaint("two spectra", HEAD MASK "rule (1,0)\n(1,0) spectrum 1/2\n(1,1) spectrum 1/2\nend\n", NULL, 12, 1, ONE_REST);
    check_accepted("two spectra and a rest", HEAD MASK "rule (1,0)\n(1,0) spectrum 1/2\n(1,1) spectrum 1/2\ncentre rest\nend\n");
    check_complaint("one sector of the centre", HEAD MASK "rule centre\n(1,0) 1/3\ncentre rest\nend\n", NULL, 10, 1,
                    "a rule for the centre must treat all sectors alike: write 'all' in front of the point, with the weight of all of them together");
    check_complaint("rest of sectors", HEAD MASK "rule (1,0)\n(1,0) @ j rest\nend\n", NULL, 10, 1, "'rest' cannot be the weights of all sectors; give it to another point");
    check_complaint("rest of a spectrum", HEAD MASK "rule (1,0)\n(1,0) spectrum rest\nend\n", NULL, 10, 16, "'rest' has no meaning in a formula");
    check_complaint("j alone", HEAD MASK "rule (1,0)\ncentre j\n(1,0) rest\nend\n", NULL, 10, 8, "j, the sector, has no meaning here");
    check_complaint("j of a spectrum", HEAD MASK "rule (1,0)\n(1,0) spectrum j\nend\n", NULL, 10, 16, "j, the sector, has no meaning here");
    check_complaint("m of sectors", HEAD MASK "rule (1,0)\n(1,0) @ j m\ncentre rest\nend\n", NULL, 10, 11, "m, the frequency, has no meaning here");
    check_complaint("m by way of a name", HEAD "let a = 1/(m+1)\n" MASK "rule (1,0)\n(1,0) @ j a\ncentre rest\nend\n", NULL, 11, 11, "the value of this name depends on m, the frequency, which has no meaning here");
    check_accepted("m by way of a name", HEAD "let a = 1/(m+1)\n" MASK "rule (1,0)\n(1,0) spectrum a\ncentre rest\nend\n");
    check_complaint("three parts", HEAD MASK "rule (1,0)\n(1,0) spectrum 1,2,3\nend\n", NULL, 10, 19, "expected an operator or the end of the line (decimals have a point: 0.5), found ','");
    check_complaint("no imaginary part", HEAD MASK "rule (1,0)\n(1,0) spectrum 1,\nend\n", NULL, 10, 18, "expected a formula, but the line ends");
    check_complaint("no offset", HEAD MASK "rule (1,0)\n(1,0) @ rest\nend\n", NULL, 10, 9, "expected j, or a whole number of sectors with at most three digits, found 'rest'");
    check_complaint("centre of a dual mesh", HEAD_DUAL "mask symmetric\n(1/2,1/2) 9/16\n(1/2,3/2) 3/16\n(3/2,3/2) 1/16\nend\nrule centre\n", NULL, 10, 1, "a dual mesh has no point in its centre");
    check_complaint("source in the centre of a dual mesh", HEAD_DUAL "mask symmetric\n(1/2,1/2) 9/16\n(1/2,3/2) 3/16\n(3/2,3/2) 1/16\nend\nrule (1/2,1/2)\ncentre rest\n", NULL, 11, 1,
                    "a dual mesh has no point in its centre");
    check_complaint("whole numbers on a dual mesh", HEAD_DUAL "mask symmetric\n(1,1) 9/16\nend\n", NULL, 6, 2, "expected halves such as 1/2 or -3/2 (points of dual meshes lie in the middle of squares), found '1,1)'");
    check_complaint("point outside a dual sector", HEAD_DUAL "mask symmetric\n(1/2,1/2) 9/16\n(1/2,3/2) 3/16\n(3/2,3/2) 1/16\nend\nrule (1/2,-1/2)\n", NULL, 10, 6,
                    "expected a point of the sector: both coordinates at least 1/2 and at most 31/2 (this one is (1/2,1/2) of sector -1), found '(1/2,-1/2)'");
    check_complaint("halves on a quad mesh", HEAD_QUAD "mask symmetric\n(1/2,1/2) 9/16\nend\n", NULL, 6, 3, "expected ',', found '/2,1/2)'");
    test_end();
}

/* ---- mirror symmetry ---- */

static void check_mirror(bool symmetric, const char *rules, const char *head)
{
    char text[2000];
    scheme s;
    diagnostic d;
    snprintf(text, sizeof text, "%s%s", head, rules);
    CHECK(read_with(&s, text, NULL, 0, &d) == STATUS_OK, "%s: %ld:%ld: %s", rules, d.line, d.column, d.text);
    CHECK(s.mirror_symmetric == symmetric, "%s: symmetric %d", rules, s.mirror_symmetric);
    scheme_clear(&s);
}

static void test_mirror(void)
{
    static const char *const yes[] = {
        "rule centre\nall (2,1) k/9\nall (1,2) k/9\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ 1 1/8\n(1,0) @ -1 0.125\ncentre rest\nend\n",                  /* equal as numbers */
        "rule (2,0)\n(1,1) k/8\n(1,1) @ -1 k/8\ncentre rest\nend\n",                        /* equal as formulas */
        "rule (2,0)\n(2,1) @ 2 1/k\n(1,2) @ -3 1/k\ncentre rest\nend\n",
        "rule (1,1)\n(1,0) a\n(1,0) @ 1 k/(k + 2)\ncentre rest\nend\n",                     /* names written out */
        "rule (1,1)\n(2,1) k\n(1,2) k\n(2,2) @ 1 w\n(2,2) @ -1 w\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*pi*j/k)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cases(j = 0: 1/4; else: (1/4 + cos(2*pi*j/k) + cos(4*pi*j/k)/2)/k)\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*j*pi/k*3)^2 + w\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cases(min(j, k - j) <= 1: 1/7; else: 2^-min(j, k - j))\ncentre rest\nend\n",
        "rule (1,1)\n(1,1) @ j cos(pi*min(j, k - j)/k)/k\n(2,1) @ j 1/k\n(1,2) @ j 1/k\ncentre rest\nend\n",
        "rule (1,0)\n(2,0) spectrum 1/(m + 1)\ncentre rest\nend\n",
        "rule (2,2)\n(2,1) spectrum 2^-m\n(1,2) spectrum 2^-m\ncentre rest\nend\n",
        "rule (1,0) when k = 4\n(1,0) @ 2 w\n(1,0) @ 1 v\n(1,0) @ 3 v\ncentre rest\nend\n",
        "rule (2,1)\n(1,0) @ 2 w\n(1,1) rest\nend\nrule (1,2)\n(1,0) @ -1 w\n(1,1) rest\nend\n",
        "rule (2,1) when k = 3\n(1,0) rest\nend\nrule (1,2) when k = 3\n(1,0) @ 1 rest\nend\nrule (1,2)\n(2,2) rest\nend\nrule (2,1)\n(2,2) rest\nend\n",
    };
    static const char *const no[] = {
        "rule (1,0)\n(1,0) @ j cos(-2*pi*j/k)\ncentre rest\nend\n", /* equal to what is evident, but not in this form */
        "rule (1,0)\n(1,0) @ j cos(4*pi*j/(2*k))\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*pi/k/(1/j))\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j 2^-min(k - j, j)\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cases(0 = j: 1/4; else: 0)\ncentre rest\nend\n",
        "rule centre\nall (2,1) k/9\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ 1 1/8\n(1,0) @ -1 1/7\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ 1 1/8\ncentre rest\nend\n",
        "rule (2,0)\n(1,1) k/8\n(1,1) @ 1 k/8\ncentre rest\nend\n",
        "rule (1,1)\n(1,0) 1/8\n(1,0) @ -1 1/8\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ 1 w\n(1,0) @ -1 rest\nend\n",
        "rule (1,0)\n(1,0) @ 1 w\n(1,0) @ -1 v\ncentre rest\nend\n",                        /* two parameters may differ */
        "rule (1,0)\n(1,0) @ j sin(2*pi*j/k)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(pi*j/k)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*pi*j/3)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*pi*j/k^2)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cos(2*pi*j*j/k)/k\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j cases(j = 1: 1/7; else: 0)\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j min(j, k)\ncentre rest\nend\n",
        "rule (1,0)\n(1,0) @ j mod(j, 2)/k\ncentre rest\nend\n",
        "rule (2,0)\n(1,1) @ j 1/k\ncentre rest\nend\n",                                     /* -j becomes -1 - j */
        "rule (1,0)\n(1,0) spectrum 1/2, cases(m = 1: 1/5; else: 0)\ncentre rest\nend\n",
        "rule (1,1)\n(1,0) spectrum 1/2\ncentre rest\nend\n",
        "rule (2,1)\n(1,1) rest\nend\n",
        "rule (1,0) when k = 5\n(1,0) @ 2 w\ncentre rest\nend\n",
        "rule (1,0) when k <= 4\n(1,0) @ 2 w\ncentre rest\nend\n",
        "rule (1,0) when k = 4 and k = 4\n(1,0) @ 2 w\ncentre rest\nend\n",
        "rule (2,1)\n(1,0) @ 2 w\n(1,1) rest\nend\nrule (1,2)\n(1,0) @ 2 w\n(1,1) rest\nend\n",
        "rule (2,1) when k = 3\n(1,0) rest\nend\nrule (1,2) when k = 4\n(1,0) @ 1 rest\nend\n",
        "rule (2,1) when k = 3\n(1,0) rest\nend\nrule (1,2)\n(2,2) rest\nend\nrule (1,2) when k = 3\n(1,0) @ 1 rest\nend\nrule (2,1)\n(2,2) rest\nend\n",
    };
    static const char head[] = HEAD "let a = k/(k + 2)\nparameter w = [0, 1/9]\nparameter v = [0, 1/9]\n" MASK;
    test_begin("language-mirror");
    for (size_t i = 0; i < sizeof yes / sizeof *yes; i++)
        check_mirror(true, yes[i], head);
    for (size_t i = 0; i < sizeof no / sizeof *no; i++)
        check_mirror(false, no[i], head);
    check_mirror(true, "rule (1/2,1/2)\n(1/2,1/2) rest\n(3/2,1/2) 1/8\n(1/2,3/2) 1/8\n(1/2,1/2) @ 1 w\n(1/2,1/2) @ -1 w\nend\n",
                 HEAD_DUAL "parameter w = 1/7\nmask symmetric\n(1/2,1/2) 1\nend\n");
    check_mirror(false, "rule (1/2,1/2)\n(1/2,1/2) rest\n(1/2,1/2) @ 1 w\nend\n", HEAD_DUAL "parameter w = 1/7\nmask symmetric\n(1/2,1/2) 1\nend\n");
    test_end();
}

/* ---- compositions ---- */

#define MIDPOINT HEAD_QUAD "parameter degree = 3\ncompose\nrefine\nrepeat (degree - 1 - mod(degree - 1, 2))/2: smooth 1/4, 1/2\naverage when mod(degree, 2) = 0\nend\n"

/* The mask is that of tensor product B-splines: C(d+1,i) C(d+1,j) / 4^d. */
static void check_spline(int degree)
{
    char setting[20];
    const char *settings[] = {setting};
    scheme s;
    diagnostic d;
    rational w, p;
    long binomial[80] = {1};
    int low = -(degree + 2) / 2, smooths = (degree - 1) / 2;
    rational_init(&w), rational_init(&p);
    snprintf(setting, sizeof setting, "degree=%d", degree);
    if (degree % 2)
        low = -(degree + 1) / 2;
    for (int row = 1; row <= degree + 1; row++)
        for (int i = row; i > 0; i--)
            binomial[i] += binomial[i - 1];
    CHECK(read_with(&s, MIDPOINT, settings, 1, &d) == STATUS_OK, "degree %d: %ld:%ld: %s", degree, d.line, d.column, d.text);
    if (!test_failed()) {
        CHECK(s.mesh == (degree % 2 ? MESH_QUAD : MESH_DUAL) && s.mirror_symmetric && s.step_count == 1 + smooths + (degree % 2 == 0), "degree %d: %d steps", degree, s.step_count);
        CHECK(s.steps[0].dilation == 2 && s.steps[0].from == s.mesh && s.steps[s.step_count - 1].to == s.mesh, "degree %d: steps", degree);
        for (int a = low - 2; a <= low + degree + 3; a++)
            for (int b = low - 2; b <= low + degree + 3; b++) {
                int i = a - low, j = b - low;
                bool inside = i >= 0 && j >= 0 && i <= degree + 1 && j <= degree + 1;
                MUST(laurent_get(&w, &s.mask, a, b));
                MUST(rational_set_si(&p, inside ? binomial[i] * binomial[j] : 0, 1));
                MUST(rational_mul_2exp(&p, &p, -2 * degree));
                CHECK(rational_equal(&w, &p), "degree %d: the weight at (%d,%d)", degree, a, b);
            }
    }
    rational_clear(&w), rational_clear(&p);
    scheme_clear(&s);
}

static void test_compositions(void)
{
    char text[3000];
    scheme s;
    diagnostic d;
    test_begin("language-compositions");
    for (int degree = 1; degree <= 14; degree++)
        check_spline(degree);
    for (int count = 33; count <= 34; count++) { /* steps */
        snprintf(text, sizeof text, HEAD_QUAD "compose\nrefine\nrepeat %d: smooth 1/4, 1/2\nend\n", count);
        status answer = read_with(&s, text, NULL, 0, &d);
        CHECK(answer == (count == 33 ? STATUS_OK : STATUS_BAD_INPUT) && s.step_count == 34, "%d smoothings: %s", count, d.text);
        CHECK(count == 33 || (d.line == 7 && !strcmp(d.text, "more than 34 steps")), "%ld: %s", d.line, d.text);
        scheme_clear(&s);
    }
    snprintf(text, sizeof text, HEAD_QUAD "compose\nrefine\nrepeat 33: smooth 1/4, 1/2\naverage\nend\n");
    CHECK(read_with(&s, text, NULL, 0, &d) == STATUS_BAD_INPUT && d.line == 8 && !strcmp(d.text, "more than 34 steps"), "%ld: %s", d.line, d.text);
    scheme_clear(&s);
    check_accepted("names that begin with centre", HEAD_QUAD "parameter centre_a = 1/4\ncompose\nrefine\nsmooth centre_a, 1/2 centre centre_a, 2*centre_a\nend\n");
    check_complaint("triangles", HEAD "compose\nrefine\nend\n", NULL, 5, 1, "'compose' needs 'mesh quad' (with 'average' the control net is dual)");
    check_complaint("dual", HEAD_DUAL "compose\nrefine\nend\n", NULL, 5, 1, "'compose' needs 'mesh quad' (with 'average' the control net is dual)");
    check_complaint("smoothing first", HEAD_QUAD "compose\nsmooth 1/4, 1/2\nend\n", NULL, 6, 1, "expected 'refine', found 'smooth'");
    check_complaint("nothing", HEAD_QUAD "compose\n", NULL, 6, 1, "expected 'refine', but the file ends");
    check_complaint("no end", HEAD_QUAD "compose\nrefine\n", NULL, 7, 1, "expected 'smooth', 'repeat', 'average' or 'end', but the file ends");
    check_complaint("no end after average", HEAD_QUAD "compose\nrefine\naverage\n", NULL, 8, 1, "expected 'end' behind 'average', but the file ends");
    check_complaint("two refinements", HEAD_QUAD "compose\nrefine\nrefine\nend\n", NULL, 7, 1, "expected 'smooth', 'repeat', 'average' or 'end', found 'refine'");
    check_complaint("smoothing after average", HEAD_QUAD "compose\nrefine\naverage\nsmooth 1/4, 1/2\nend\n", NULL, 8, 1, "expected 'end' behind 'average', found 'smooth'");
    check_accepted("average that does not hold", HEAD_QUAD "compose\nrefine\nsmooth 1/4, 1/2\naverage when 1 = 2\nend\n");
    check_complaint("smoothing after one that does not hold", HEAD_QUAD "compose\nrefine\naverage when 1 = 2\nsmooth 1/4, 1/2\nend\n", NULL, 8, 1, "expected 'end' behind 'average', found 'smooth'");
    check_complaint("one weight", HEAD_QUAD "compose\nrefine\nsmooth 1/4\nend\n", NULL, 7, 11, "expected ', BETA', but the line ends");
    check_complaint("one weight in the centre", HEAD_QUAD "compose\nrefine\nsmooth 1/4, 1/2 centre 1/k\nend\n", NULL, 7, 27, "expected ', BETA', but the line ends");
    check_complaint("valence in a regular weight", HEAD_QUAD "compose\nrefine\nsmooth 1/k, 1/2\nend\n", NULL, 7, 10, "k, the valence, has no meaning here");
    check_complaint("no number", HEAD_QUAD "compose\nrefine\nrepeat 1/2: smooth 1/4, 1/2\nend\n", NULL, 7, 1, "expected a whole number of repetitions, at most 34");
    check_complaint("below 0", HEAD_QUAD "compose\nrefine\nrepeat -1: smooth 1/4, 1/2\nend\n", NULL, 7, 1, "expected a whole number of repetitions, at most 34");
    check_complaint("too many", HEAD_QUAD "compose\nrefine\nrepeat 35: smooth 1/4, 1/2\nend\n", NULL, 7, 1, "expected a whole number of repetitions, at most 34");
    check_complaint("no colon", HEAD_QUAD "compose\nrefine\nrepeat 2 smooth 1/4, 1/2\nend\n", NULL, 7, 1, "expected 'repeat COUNT: smooth ALPHA, BETA', and there is no ':'");
    check_complaint("repeated average", HEAD_QUAD "compose\nrefine\nrepeat 2: average\nend\n", NULL, 7, 11, "expected ': smooth ALPHA, BETA', found 'average'");
    check_complaint("what is not repeated", HEAD_QUAD "compose\nrefine\nrepeat 0: smooth 1/4, nonsense\nend\n", NULL, 7, 23, "unknown word 'nonsense': expected a number, k, pi, a function or a name defined before");
    check_complaint("rule", HEAD_QUAD "compose\nrefine\nend\nrule centre\ncentre rest\nend\n", NULL, 8, 1, "expected nothing more, found 'rule'");
    test_end();
}

int main(void)
{
    test_definitions();
    test_intervals();
    test_limits();
    test_work();
    test_conditions();
    test_sources();
    test_mirror();
    test_compositions();
    return test_status();
}
