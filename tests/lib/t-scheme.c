/* t-scheme.c: scheme files: what they mean, their canonical text, and what is said of files that are wrong. */
#include "lib/scheme.h"

#include <ctype.h>
#include <stdlib.h>

#include "common.h"
#include "lib/regular.h"

/* ---- the catalogue ---- */

/* One step of dilation 2, with a rule for the centre that has the sources `centre` and `all (1,0)`, one of them the rest. */
static void check_centre_rule(const scheme *s, bool centre_is_rest)
{
    const rule *r = s->steps[0].rules;
    CHECK(s->step_count == 1 && s->steps[0].dilation == 2 && s->steps[0].from == s->mesh && s->steps[0].to == s->mesh, "steps");
    CHECK(s->steps[0].rule_count == 1 && r->at_centre && !r->condition && r->count == 2 && !r->spectrum_takes_rest, "the rule");
    if (test_failed())
        return;
    CHECK(r->sources[0].kind == SOURCE_CENTRE && r->sources[1].kind == SOURCE_ALL && r->sources[1].point.a == 1 && r->sources[1].point.b == 0, "its sources");
    CHECK(!r->sources[0].weight == centre_is_rest && !r->sources[1].weight == !centre_is_rest, "its rest");
}

static void test_catalogue(void)
{
    static const struct {
        int a, b;
        long p, q;
    } weight[] = {{0, 0, 5, 8}, {1, 0, 3, 8}, {-1, 1, 3, 8}, {0, -1, 3, 8}, {1, 1, 1, 8}, {-1, 2, 1, 8}, {2, -1, 1, 8}, {-2, 1, 1, 8}, {2, 0, 1, 16}, {0, -2, 1, 16}, {2, -2, 1, 16}, {2, 1, 0, 1}, {3, 0, 0, 1}, {9, 9, 0, 1}};
    scheme s;
    rational q;
    test_begin("scheme-catalogue");
    rational_init(&q);
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        read_scheme(&s, e->text);
        CHECK(!strcmp(s.name, e->name), "the scheme in %s is called '%s'", e->name, s.name);
        scheme_clear(&s);
    }
    read_scheme(&s, catalogue_text("loop"));
    check_centre_rule(&s, false);
    CHECK(s.mesh == MESH_TRIANGLE && s.steps[0].reach == 2 && s.mirror_symmetric, "loop");
    for (size_t i = 0; i < sizeof weight / sizeof *weight; i++) {
        MUST(laurent_get(&q, &s.mask, weight[i].a, weight[i].b));
        CHECK(rational_cmp_si(&q, weight[i].p, weight[i].q) == 0, "loop has another weight at (%d,%d)", weight[i].a, weight[i].b);
    }
    MUST(laurent_class_norm(&q, &s.mask, 1)); /* all weights: a(1,1) = 4 */
    CHECK(rational_cmp_si(&q, 4, 1) == 0, "loop's weights do not sum to 4");
    scheme_clear(&s);
    rational_clear(&q);
    test_end();
}

/* ---- canonical text ---- */

/* The definition of lib/scheme.md, done in the plainest way on one line at a time. */
static void canonical(char *z, const char *bytes, size_t length)
{
    size_t at = 0;
    *z = 0;
    while (at < length) {
        char line[1100] = "", *end;
        size_t n = 0;
        for (; at < length && bytes[at] != '\n'; at++)
            line[n++] = bytes[at] == '\t' || bytes[at] == '\r' ? ' ' : bytes[at];
        at++;
        line[n] = 0;
        if ((end = strchr(line, '#')))
            *end = 0;
        while ((end = strstr(line, "  ")))
            memmove(end, end + 1, strlen(end));
        n = strlen(line);
        if (n && line[n - 1] == ' ')
            line[n - 1] = 0;
        if (*line == ' ')
            memmove(line, line + 1, strlen(line));
        if (*line)
            strcat(strcat(z, line), "\n");
    }
}

static void check_canonical(const char *bytes, size_t length)
{
    source_text t;
    diagnostic d;
    char *exactly = malloc(length + 1), *expected = malloc(length + 3);
    long lines = 0;
    memcpy(exactly, bytes, length);
    canonical(expected, bytes, length);
    status s = text_read(&t, exactly, length, &d);
    CHECK(s == STATUS_OK, "refused: %s", d.text);
    if (s == STATUS_OK) {
        const char *place = t.canonical;
        CHECK(!strcmp(t.canonical, expected) && t.length == strlen(expected), "'%.200s' becomes '%.200s'", bytes, t.canonical);
        for (size_t i = 0; i < t.lines; i++) {
            const text_line *line = &t.line[i];
            CHECK(line->text == place && line->text[line->length] == '\n', "line %zu", i);
            place += line->length + 1;
            /* every character stands where it is said to stand */
            const char *original = exactly, *until = exactly + length;
            for (long n = 1; n < line->line; n++)
                original = (const char *)memchr(original, '\n', (size_t)(until - original)) + 1;
            for (size_t c = 0; c < line->length; c++) {
                char there = original[line->column[c] - 1];
                CHECK(there == line->text[c] || (line->text[c] == ' ' && (there == '\t' || there == '\r')), "line %zu, character %zu is not in column %ld", i, c, line->column[c]);
            }
            CHECK(line->column[line->length] == line->column[line->length - 1] + 1, "the column of the end of line %zu", i);
        }
        CHECK(place == t.canonical + t.length, "the lines are not the whole text");
        for (size_t i = 0; i < length; i++)
            lines += bytes[i] == '\n';
        CHECK(t.last_line == lines + (length > 0 && bytes[length - 1] != '\n'), "%ld lines", t.last_line);
    }
    text_clear(&t);
    free(exactly);
    free(expected);
}

static void test_canonical(void)
{
    static const char *const text[] = {"", "\n", "\n\n\n", "a", "a\n", " a  b \n", "a#b", "#\n", " \t\r\n", "a\r\nb\r\n", "\t a \t\t b\tc #d  e\n\n x", "a # # b\n#c", "a\rb", "# \x7e~!\n q"};
    test_begin("scheme-canonical-text");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        check_canonical(text[i], strlen(text[i]));
    check_canonical(catalogue_text("loop"), strlen(catalogue_text("loop")));
    for (test_cases(3000); test_next();) {
        static const char alphabet[] = "ab(1, \t\r\n\n#  ";
        char bytes[200];
        size_t length = (size_t)random_below(sizeof bytes);
        for (size_t i = 0; i < length; i++)
            bytes[i] = alphabet[random_below(sizeof alphabet - 1)];
        check_canonical(bytes, length);
    }
    test_end();
}

/* The canonical text of a scheme is a scheme with the same text and the same mask. */
static void test_same_scheme(void)
{
    static const char blown[] = "\r\n # comment \r\n  scheme\tmade-up # so\r\nmesh triangle\n\n\ndilation   2\nvertices interior\n\n"
                                "mask symmetric#\n ( 0 , 0 )7/10\n(2,0)1/20\n(-1,1) 2/5\n( 1,1 ) 1 / 5\n(2,1)\t-1/20\nend\n\n"
                                "rule  centre\ncentre\t2/3 + sin( pi / k )/7\nall(1,0)rest\n end ";
    static const char plain[] = ODD_TEXT;
    scheme s, t, u;
    rational p, q;
    test_begin("scheme-canonical-scheme");
    rational_init(&p), rational_init(&q);
    read_scheme(&s, blown);
    read_scheme(&t, plain);
    if (!test_failed()) {
        read_scheme(&u, s.source.canonical);
        CHECK(!strcmp(u.source.canonical, s.source.canonical), "the canonical text changes");
        CHECK(u.steps[0].reach == 3 && s.steps[0].reach == 3 && t.steps[0].reach == 3, "reach");
        check_centre_rule(&s, false), check_centre_rule(&t, false), check_centre_rule(&u, false);
        CHECK(!strcmp(s.name, "made-up") && !strcmp(t.name, "made-up"), "name");
        for (int a = -9; a <= 9; a++)
            for (int b = -9; b <= 9; b++) {
                MUST(laurent_get(&p, &s.mask, a, b));
                MUST(laurent_get(&q, &t.mask, a, b));
                CHECK(rational_equal(&p, &q), "weight at (%d,%d)", a, b);
                MUST(laurent_get(&q, &u.mask, a, b));
                CHECK(rational_equal(&p, &q), "weight at (%d,%d) of the canonical text", a, b);
            }
        scheme_clear(&u);
    }
    scheme_clear(&s), scheme_clear(&t);
    rational_clear(&p), rational_clear(&q);
    test_end();
}

/* ---- masks ---- */

/* A symmetric mask is the same as the one with all images written down. */
static void test_orbits(void)
{
    static const struct {
        int a, b;
        const char *weight;
    } entry[] = {{0, 0, "7/10"}, {2, 0, "1/20"}, {1, 0, "2/5"}, {1, 1, "1/5"}, {1, 2, "-1/20"}};
    char text[4000] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask\n", line[64];
    scheme s, t;
    rational p, q;
    int listed[100][2], count = 0;
    test_begin("scheme-orbits");
    for (size_t i = 0; i < sizeof entry / sizeof *entry; i++) {
        int a = entry[i].a, b = entry[i].b;
        for (int turn = 0; turn < 12; turn++) {
            int old = a, c = turn < 6 ? a : b, d = turn < 6 ? b : a; /* the image, and its mirror image */
            bool known = false;
            for (int j = 0; j < count; j++)
                known = known || (listed[j][0] == c && listed[j][1] == d);
            if (!known) {
                listed[count][0] = c, listed[count++][1] = d;
                snprintf(line, sizeof line, "(%d,%d) %s\n", c, d, entry[i].weight);
                strcat(text, line);
            }
            a = -b, b = old + b;
        }
    }
    CHECK(count == 1 + 6 + 6 + 6 + 12, "%d points", count);
    strcat(text, "end\nrule centre\ncentre rest\nall (1,0) 1/k\nend\n");
    read_scheme(&s, text);
    read_scheme(&t, ODD_TEXT);
    rational_init(&p), rational_init(&q);
    check_centre_rule(&s, true);
    CHECK(s.steps[0].reach == 3 && s.mirror_symmetric && t.mirror_symmetric, "reach");
    for (int a = -4; a <= 4; a++)
        for (int b = -4; b <= 4; b++) {
            MUST(laurent_get(&p, &s.mask, a, b));
            MUST(laurent_get(&q, &t.mask, a, b));
            CHECK(rational_equal(&p, &q), "weight at (%d,%d)", a, b);
        }
    rational_clear(&p), rational_clear(&q);
    scheme_clear(&s), scheme_clear(&t);
    test_end();
}

/* A mask point of weight 0 does not count for the reach. */
static void test_reach(void)
{
    static const struct {
        const char *text;
        int reach;
    } schemes[] = {
        {SCHEME_TEXT("(0,0) 1\n(1,0) 1/2\n(2,0) 0\n", "1"), 1},
        {SCHEME_TEXT("(0,0) 1\n(1,0) 1/2\n(8,0) 1/16-1/2^4\n", "1"), 1},
        {SCHEME_TEXT("(0,0) 1\n(1,0) 1/4\n(4,4) 0\n(-7,1) 1/8\n", "1"), 7},
        {SCHEME_TEXT("(0,0) 1-6/9\n(1,0) 1/2\n(-8,8) 1/9\n", "1"), 8},
    };
    scheme s;
    test_begin("scheme-reach");
    for (size_t i = 0; i < sizeof schemes / sizeof *schemes; i++) {
        read_scheme(&s, schemes[i].text);
        CHECK(s.steps[0].reach == schemes[i].reach, "scheme %zu: reach %d, not %d", i, s.steps[0].reach, schemes[i].reach);
        scheme_clear(&s);
    }
    test_end();
}

/* ---- complaints ---- */

static void check_complaint(const char *name, const char *bytes, long line, long column, const char *expected)
{
    scheme s;
    diagnostic d = {0, 0, ""};
    scheme_init(&s);
    status answer = scheme_read(&s, bytes, strlen(bytes), NULL, &d);
    CHECK(answer == STATUS_BAD_INPUT, "%s: accepted (status %d)", name, (int)answer);
    CHECK(d.line == line && d.column == column, "%s: at %ld:%ld, not %ld:%ld: %s", name, d.line, d.column, line, column, d.text);
    CHECK(!strcmp(d.text, expected), "%s: \"%s\", not \"%s\"", name, d.text, expected);
    scheme_clear(&s);
}

#define HEAD "scheme x\nmesh triangle\ndilation 2\nvertices interior\n"
#define MASK "mask symmetric\n(0,0) 1\n(1,0) 1/2\nend\n"
#define RULE "rule centre\ncentre 1/2\nall (1,0) rest\nend\n"
#define NAME_EXPECTED "expected a name (a lower-case letter, then at most 63 lower-case letters, digits and '-'), found "
#define A_PRIMARY "expected a number, a word or '('"

static void test_statements(void)
{
    scheme s;
    test_begin("scheme-complaints-statements");
    read_scheme(&s, HEAD MASK RULE);
    scheme_clear(&s);
    check_complaint("empty", "", 1, 1, "expected 'scheme NAME' as the first statement, but the file ends");
    check_complaint("comment only", "# nothing\n\n", 3, 1, "expected 'scheme NAME' as the first statement, but the file ends");
    check_complaint("first word", "mesh triangle\n", 1, 1, "expected 'scheme NAME' as the first statement, found 'mesh'");
    check_complaint("longer word", "schemes x\n", 1, 1, "expected 'scheme NAME' as the first statement, found 'schemes'");
    check_complaint("no name", "\n scheme  # x\n", 2, 8, "expected a name (a lower-case letter, then at most 63 lower-case letters, digits and '-'), but the line ends");
    check_complaint("upper case", "scheme Loop\n", 1, 8, NAME_EXPECTED "'Loop'");
    check_complaint("name with a digit in front", "scheme 2x\n", 1, 8, NAME_EXPECTED "'2x'");
    check_complaint("bad character in a name", "scheme loop_2\n", 1, 12, NAME_EXPECTED "'_2'");
    check_complaint("more than a name", "scheme loop  two\n", 1, 14, NAME_EXPECTED "'two'");
    check_complaint("nothing after the scheme", "scheme x\n", 2, 1, "expected 'mesh triangle', 'mesh quad' or 'mesh quad-dual', but the file ends");
    check_complaint("order", "scheme x\ndilation 2\n", 2, 1, "expected 'mesh triangle', 'mesh quad' or 'mesh quad-dual', found 'dilation'");
    check_complaint("other mesh", "scheme x\nmesh hexagon\n", 2, 6, "expected 'triangle', 'quad' or 'quad-dual', found 'hexagon'");
    check_complaint("nothing after the mesh", "scheme x\n  mesh quad\n", 3, 1, "expected 'dilation 2' (other dilations are reserved for later), but the file ends");
    check_complaint("nothing after the dual mesh", "scheme x\nmesh quad-dual\n", 3, 1, "expected 'dilation 2' (other dilations are reserved for later), but the file ends");
    check_complaint("longer mesh", "scheme x\nmesh quad-duals\n", 2, 10, "expected the end of the line, found '-duals'");
    check_complaint("longer mesh word", "scheme x\nmesh quads\n", 2, 6, "expected 'triangle', 'quad' or 'quad-dual', found 'quads'");
    check_complaint("two meshes", "scheme x\nmesh triangle quad\n", 2, 15, "expected the end of the line, found 'quad'");
    check_complaint("dilation", "scheme x\nmesh triangle\ndilation 3\n", 3, 10, "expected 'dilation 2' (other dilations are reserved for later), found '3'");
    check_complaint("dilation 22", "scheme x\nmesh triangle\ndilation 22\n", 3, 11, "expected the end of the line, found '2'");
    check_complaint("reserved vertices", "scheme x\nmesh triangle\ndilation 2\nvertices crease\n", 4, 1, "'vertices boundary' and 'vertices crease' are reserved for a later version; this one covers interior vertices");
    check_complaint("no mask", HEAD RULE, 5, 1, "expected 'parameter', 'let', 'mask' or 'compose', found 'rule'");
    check_complaint("other symmetry", HEAD "mask mirrored\n", 5, 6, "expected the end of the line, found 'mirrored'");
    read_scheme(&s, HEAD MASK); /* rules are optional, and so is their source in the centre */
    scheme_clear(&s);
    read_scheme(&s, HEAD MASK "rule centre\nall (1,0) rest\nend\n");
    scheme_clear(&s);
    check_complaint("other rule", HEAD MASK "rule edge\n", 9, 6, "expected 'centre' or a point such as (1,0), found 'edge'");
    check_complaint("rule without weight", HEAD MASK "rule centre\ncentre\nall (1,0) rest\nend\n", 10, 7, "expected a formula, but the line ends");
    check_complaint("rule without ring", HEAD MASK "rule centre\ncentre 1/2\nend\n", 11, 1, "exactly one weight of a rule must be 'rest', so that they sum to 1 exactly");
    check_complaint("ring without point", HEAD MASK "rule centre\ncentre 1/2\nall rest\nend\n", 11, 5, "expected a point such as (1,0), found 'rest'");
    read_scheme(&s, HEAD MASK "rule centre\ncentre 1/2\nall (1,1) rest\nend\n");
    scheme_clear(&s);
    check_complaint("point outside the sector", HEAD MASK "rule centre\ncentre 1/2\nall (0,1) rest\nend\n", 11, 5,
                    "expected a point of the sector: (a,b) with a >= 1, b >= 0, at most 16 rings out (this one is (1,0) of sector 1), found '(0,1)'");
    check_complaint("two weights", HEAD MASK "rule centre\ncentre 1/2\nall (1,0) 1/2\nend\n", 12, 1, "exactly one weight of a rule must be 'rest', so that they sum to 1 exactly");
    check_complaint("no weight", HEAD MASK "rule centre\ncentre rest\nall (1,0) rest\nend\n", 12, 1, "exactly one weight of a rule must be 'rest', so that they sum to 1 exactly");
    check_complaint("rest and more", HEAD MASK "rule centre\ncentre rest + 1\nall (1,0) rest\nend\n", 10, 13, "expected the end of the line, found '+'");
    check_complaint("rule without end", HEAD MASK "rule centre\ncentre 1/2\nall (1,0) rest\n", 12, 1, "expected a source with its weight, or 'end', but the file ends");
    check_complaint("more", HEAD MASK RULE "\n  mask\n", 14, 3, "expected nothing more, found 'mask'");
    check_complaint("end of what", HEAD MASK "rule centre\ncentre 1/2\nall (1,0) rest\nend rule\n", 12, 5, "expected the end of the line, found 'rule'");
    test_end();
}

/* Names of 64 characters are allowed, 65 are not. */
static void test_name_length(void)
{
    char text[400], name[70];
    scheme s;
    test_begin("scheme-name-length");
    memset(name, 'a', sizeof name);
    name[64] = 0;
    snprintf(text, sizeof text, "scheme %s\nmesh triangle\ndilation 2\nvertices interior\n" MASK RULE, name);
    read_scheme(&s, text);
    CHECK(!strcmp(s.name, name), "'%s'", s.name);
    scheme_clear(&s);
    name[64] = 'a', name[65] = 0;
    snprintf(text, sizeof text, "scheme %s\nmesh triangle\ndilation 2\nvertices interior\n" MASK RULE, name);
    scheme_init(&s);
    CHECK(scheme_read(&s, text, strlen(text), NULL, NULL) == STATUS_BAD_INPUT, "65 characters are accepted");
    scheme_clear(&s);
    test_end();
}

static void test_mask_complaints(void)
{
#define WITH_MASK(mask) HEAD "mask symmetric\n" mask "end\n" RULE
#define WITH_PLAIN(mask) HEAD "mask\n" mask "end\n" RULE
    test_begin("scheme-complaints-mask");
    check_complaint("no point", WITH_MASK("1/2\n"), 6, 1, "expected a point such as (1,0), found '1/2'");
    check_complaint("no coordinate", WITH_MASK("(a,0) 1\n"), 6, 2, "expected a coordinate of one or two digits, found 'a,0)'");
    check_complaint("no comma", WITH_MASK("(1 0) 1\n"), 6, 4, "expected ',', found '0)'");
    check_complaint("no second coordinate", WITH_MASK("(1,) 1\n"), 6, 4, "expected a coordinate of one or two digits, found ')'");
    check_complaint("no parenthesis", WITH_MASK("(1,0 1\n"), 6, 6, "expected ')', found '1'");
    check_complaint("point alone", WITH_MASK("(1,0)\n"), 6, 6, "expected a formula, but the line ends");
    check_complaint("no end", HEAD "mask symmetric\n(0,0) 1\n(1,0) 1/2\n" RULE, 8, 1, "expected a point such as (1,0), found 'rule'");
    check_complaint("no end at all", HEAD "mask symmetric\n(0,0) 1\n", 7, 1, "expected a mask point or 'end', but the file ends");
    check_complaint("far away", WITH_MASK("(0,0) 1\n(9,0) 0\n"), 7, 1, "a mask point may be at most 8 edges from 0");
    check_complaint("far away in the third direction", WITH_MASK("(5,4) 0\n"), 6, 1, "a mask point may be at most 8 edges from 0");
    check_complaint("k in the mask", WITH_MASK("(0,0) 1+k-k\n"), 6, 9, "k, the valence, has no meaning here");
    check_complaint("irrational", WITH_MASK("(0,0) cos(pi/5)\n"), 6, 7, "expected a rational number, and this value is not one");
    check_complaint("angle", WITH_MASK("(0,0) pi\n"), 6, 7, "expected a rational number, and this value is not one");
    check_complaint("division", WITH_MASK("(0,0) 1/0\n"), 6, 8, "division by zero");
    check_complaint("formula", WITH_MASK("(0,0) 1 +\n"), 6, 10, A_PRIMARY ", but the formula ends");
    check_complaint("twice", WITH_PLAIN("(0,0) 1\n(0, 0) 1\n"), 7, 1, "a point is given a weight twice (with 'symmetric' an entry stands for its whole orbit)");
    check_complaint("twice through an orbit", WITH_MASK("(0,0) 1\n(1,0) 1/2\n  (-1,1) 1/2\n"), 8, 3, "a point is given a weight twice (with 'symmetric' an entry stands for its whole orbit)");
    check_complaint("even class", WITH_MASK("(0,0) 1\n(1,0) 1/2\n(2,0) 1/1000000\n"), 9, 1, "the weights of the mask at the points (a,b) with an even a and an even b sum to 500003/500000, not to 1");
    check_complaint("odd class", WITH_MASK("(0,0) 1\n(1,0) 1/3\n"), 8, 1, "the weights of the mask at the points (a,b) with an even a and an odd b sum to 2/3, not to 1");
    check_complaint("no points", WITH_MASK(""), 6, 1, "the weights of the mask at the points (a,b) with an even a and an even b sum to 0, not to 1");
    check_complaint("odd and even class", "scheme x\nmesh quad\ndilation 2\nvertices interior\nmask\n(0,0) 1\n(0,1) 1/2\n(0,-1) 1/2\nend\n", 9, 1,
                    "the weights of the mask at the points (a,b) with an odd a and an even b sum to 0, not to 1");
    check_complaint("a class of halves", "scheme x\nmesh quad-dual\ndilation 2\nvertices interior\nmask\n(1/2,1/2) 1\n(-3/2,-1/2) 1\nend\n", 8, 1,
                    "the weights of the mask at the points (a,b) where b, but not a, is among ... -3/2, 1/2, 5/2 ... sum to 0, not to 1");
    check_complaint("rotation", WITH_PLAIN("(0,0) 1\n(1,0) 1/2\n(-1,0) 1/2\n(0,1) 1/2\n(0,-1) 1/2\n(1,1) 1\n"), 12, 1,
                    "the mask is not invariant under rotation by one sector of the regular mesh (a sixth of a turn), so it has no meaning at other valences");
    check_complaint("one weight off the rotation", WITH_PLAIN("(0,0) 1\n(1,0) 1/2\n(-1,0) 1/2\n(0,1) 1/2\n(0,-1) 1/2\n(-1,1) 3/8\n(1,-1) 5/8\n"), 13, 1,
                    "the mask is not invariant under rotation by one sector of the regular mesh (a sixth of a turn), so it has no meaning at other valences");
    /* (2,1) with its rotations, but without (1,2) */
    scheme s;
    read_scheme(&s, WITH_PLAIN("(0,0) 1\n(1,0) 1/4\n(-1,0) 1/4\n(0,1) 1/4\n(0,-1) 1/4\n(-1,1) 1/4\n(1,-1) 1/4\n"
                               "(2,1) 1/4\n(-1,3) 1/4\n(-3,2) 1/4\n(-2,-1) 1/4\n(1,-3) 1/4\n(3,-2) 1/4\n"));
    CHECK(!s.mirror_symmetric, "a mask without its mirror image");
    scheme_clear(&s);
    test_end();
}

/* Messages name the place in the file as it is written, wherever blanks are. */
static void test_places(void)
{
    test_begin("scheme-places");
    check_complaint("blanks in front", WITH_MASK("   (0,0)   x\n"), 6, 12, "unknown word 'x': expected a number, k, pi, a function or a name defined before");
    check_complaint("end of a line with a comment", WITH_MASK("(0,0) 1 +   # 2\n"), 6, 10, A_PRIMARY ", but the formula ends");
    check_complaint("blanks in a point", WITH_MASK("(0,   0   x\n"), 6, 11, "expected ')', found 'x'");
    test_end();
    test_begin("scheme-places-in-formulas");
    check_complaint("blanks inside a formula", WITH_MASK("(0,0) 1  +   x\n"), 6, 14, "unknown word 'x': expected a number, k, pi, a function or a name defined before");
    check_complaint("tabs inside a formula", WITH_MASK("(0,0)\t1\t\t/\t\t0\n"), 6, 10, "division by zero");
    test_end();
    test_begin("scheme-tokens");
    scheme s;
    scheme_init(&s);
    const char *parted = WITH_MASK("(0,0) 1\n(- 1,0) 1/2\n");
    CHECK(scheme_read(&s, parted, strlen(parted), NULL, NULL) == STATUS_BAD_INPUT, "a blank inside an integer is accepted");
    scheme_clear(&s);
    read_scheme(&s, "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0)1\n(1,0).5\nend\nrule centre\ncentre .375\nall(1,0)rest\nend");
    scheme_clear(&s);
    check_complaint("no blank", "scheme x\nmesh triangle\ndilation2\n", 3, 1, "expected 'dilation 2' (other dilations are reserved for later), found 'dilation2'");
    check_complaint("a weight without a blank", HEAD MASK "rule centre\ncentre3/8\nall (1,0) rest\nend\n", 10, 1, "expected 'centre', 'all', a point such as (1,0), or 'end', found 'centre3/8'");
    check_complaint("a longer word", HEAD MASK "rule centre\ncentrepi\nall (1,0) rest\nend\n", 10, 1, "expected 'centre', 'all', a point such as (1,0), or 'end', found 'centrepi'");
    check_complaint("a blank between digits", WITH_MASK("(0,0) 1\n(1 2,0) 0\n"), 7, 4, "expected ',', found '2,0)'");
    test_end();
}

/* ---- sizes ---- */

static void test_sizes(void)
{
    enum { LIMIT = 65536 };
    char *text = malloc(LIMIT + 2000);
    size_t base;
    scheme s;
    diagnostic d;
    test_begin("scheme-sizes");
    strcpy(text, HEAD MASK RULE);
    base = strlen(text);
    /* fill up with comment lines of 64 bytes */
    for (size_t i = base; i < LIMIT; i++)
        text[i] = (i - base) % 64 == 63 ? '\n' : '#';
    scheme_init(&s);
    CHECK(scheme_read(&s, text, LIMIT, NULL, &d) == STATUS_OK, "65,536 bytes: %s", d.text);
    scheme_clear(&s);
    text[LIMIT] = '\n';
    CHECK(scheme_read(&s, text, LIMIT + 1, NULL, &d) == STATUS_BAD_INPUT && d.line == 0 && !strcmp(d.text, "a scheme may have 65536 bytes at most"), "65,537 bytes");
    scheme_clear(&s);
    for (int extra = 0; extra <= 1; extra++)
        for (int ended = 0; ended <= 1; ended++) {
            memset(text + base, extra ? ' ' : '#', 1001);
            text[base + 1000 + (size_t)extra] = '\n';
            status answer = scheme_read(&s, text, base + 1000 + (size_t)extra + (size_t)ended, NULL, &d);
            CHECK(answer == (extra ? STATUS_BAD_INPUT : STATUS_OK), "a line of %d bytes", 1000 + extra);
            if (extra)
                CHECK(d.line == 13 && d.column == 1001 && !strcmp(d.text, "a line may have 1000 bytes at most"), "%ld:%ld: %s", d.line, d.column, d.text);
            scheme_clear(&s);
        }
    for (int c = 0; c < 256; c++) {
        bool allowed = (c >= 32 && c <= 126) || c == '\t' || c == '\r' || c == '\n';
        text[base] = '#', text[base + 1] = (char)c, text[base + 2] = '#';
        status answer = scheme_read(&s, text, base + 3, NULL, &d);
        CHECK(answer == (allowed ? STATUS_OK : STATUS_BAD_INPUT), "byte %d in a comment", c);
        if (!allowed) {
            char expected[80];
            snprintf(expected, sizeof expected, "byte %d is not allowed: a scheme is plain ASCII text", c);
            CHECK(d.line == 13 && d.column == 2 && !strcmp(d.text, expected), "%ld:%ld: %s", d.line, d.column, d.text);
        }
        scheme_clear(&s);
    }
    free(text);
    test_end();
}

/* ---- damage ---- */

/* What always holds for the steps of an accepted scheme. */
static void check_step(const scheme *s, const scheme_step *step)
{
    rational sum;
    rational_init(&sum);
    for (int i = 0; i < step->dilation * step->dilation; i++) {
        MUST(laurent_class_sum(&sum, &step->mask, i / step->dilation, i % step->dilation, step->dilation));
        CHECK(rational_cmp_si(&sum, 1, 1) == 0, "an accepted mask does not sum to 1");
    }
    rational_clear(&sum);
    CHECK(step->reach <= SCHEME_MAX_REACH && step->rule_count <= SCHEME_MAX_RULES && (step->from == s->mesh || s->step_count > 1), "an accepted step");
    for (int i = 0; i < step->rule_count; i++) {
        int rests = 0;
        const rule *r = &step->rules[i];
        for (int j = 0; j < r->count; j++)
            rests += !r->sources[j].weight;
        CHECK(r->count >= 1 && r->count <= SCHEME_MAX_SOURCES && rests + r->spectrum_takes_rest == 1, "an accepted rule has %d rests", rests);
    }
}

/* Reads a copy of exactly these bytes.  A complaint is about a place in the text, or just behind it. */
static status read_damaged(const char *bytes, size_t length)
{
    scheme s;
    diagnostic d = {-1, -1, ""};
    long lines = 1;
    char *exactly = malloc(length + 1);
    memcpy(exactly, bytes, length);
    for (size_t i = 0; i < length; i++)
        lines += bytes[i] == '\n';
    scheme_init(&s);
    status answer = scheme_read(&s, exactly, length, NULL, &d);
    free(exactly);
    if (answer == STATUS_BAD_INPUT)
        CHECK(d.line >= 0 && d.line <= lines + 1 && d.column >= 0 && d.column <= 1001 && *d.text, "%ld:%ld: '%s'", d.line, d.column, d.text);
    else if (answer == STATUS_OK) {
        /* what is accepted satisfies what always holds */
        rational sum;
        rational_init(&sum);
        for (int i = 0; i < 4; i++) {
            MUST(laurent_class_sum(&sum, &s.mask, i / 2, i % 2, 2));
            CHECK(rational_cmp_si(&sum, 1, 1) == 0, "an accepted mask does not sum to 1");
        }
        for (int i = 0; i < s.step_count; i++)
            check_step(&s, &s.steps[i]);
        CHECK(s.step_count >= 1 && s.step_count <= SCHEME_MAX_STEPS && *s.name, "accepted");
        rational_clear(&sum);
    } else
        test_fail(__FILE__, __LINE__, "no memory");
    scheme_clear(&s);
    return answer;
}

/* A file may be cut where a block has ended, and the last line may do without its end. */
static void test_truncation(void)
{
    char expected[2000];
    test_begin("scheme-truncated");
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        size_t length = strlen(e->text);
        if (length > 1900)
            length = 1900;
        for (size_t n = 0; n <= length; n++) {
            canonical(expected, e->text, n);
            size_t m = strlen(expected);
            bool whole = m > 5 && !strcmp(expected + m - 5, "\nend\n");
            status answer = read_damaged(e->text, n);
            CHECK(answer == (whole ? STATUS_OK : STATUS_BAD_INPUT), "%zu of %zu bytes of %s: status %d", n, length, e->name, (int)answer);
        }
    }
    test_end();
}

/* Every byte of Loop is replaced by every other, those of the other files by some characters of the language. */
static void test_mutations(void)
{
    static const char some[] = "\n\x80 #(),-0129/:;=@[]^acejkmrx<";
    test_begin("scheme-mutated");
    for (const struct catalogue_entry *e = catalogue; e->name; e++) {
        size_t length = strlen(e->text);
        char *damaged = malloc(length + 2);
        bool all = !strcmp(e->name, "loop");
        for (size_t i = 0; i < length && !test_failed(); i++)
            for (size_t c = 0; c < (all ? 256 : 6); c++) {
                memcpy(damaged, e->text, length);
                damaged[i] = all ? (char)c : some[(7 * i + 5 * c) % (sizeof some - 1)];
                read_damaged(damaged, length);
            }
        for (size_t i = 0; i <= length && !test_failed(); i++) {
            memcpy(damaged, e->text, i);
            if (i < length) {
                memcpy(damaged + i, e->text + i + 1, length - i - 1); /* one byte less */
                read_damaged(damaged, length - 1);
            }
            memcpy(damaged + i + 1, e->text + i, length - i); /* one byte more */
            damaged[i] = "(9#\n/-^ "[i % 8];
            read_damaged(damaged, length + 1);
        }
        free(damaged);
    }
    test_end();
}

static void test_garbage(void)
{
    static const char *const piece[] = {"scheme", "mesh", "triangle", "quad", "dilation", "2", "vertices", "interior", "mask", "symmetric", "end", "rule", "centre", "all", "rest",
                                        "(1,0)", "(0,0)", "(", ")", "-", ",", "1/2", "k", "cos(", "pi", "^64", "\n", "\n", "\n", " ", " ", "#", HEAD, MASK, RULE, "mask symmetric\n", "\t", "x"};
    test_begin("scheme-garbage");
    for (test_cases(20000); test_next();) {
        char text[2000] = "";
        int pieces = (int)random_below(30);
        if (random_bool())
            strcat(text, random_bool() ? HEAD : HEAD "mask symmetric\n");
        for (int i = 0; i < pieces && strlen(text) < 1500; i++) {
            strcat(text, piece[random_below(sizeof piece / sizeof *piece)]);
            if (random_bool())
                strcat(text, " ");
        }
        read_damaged(text, strlen(text));
    }
    for (test_cases(5000); test_next();) {
        char bytes[300];
        size_t length = (size_t)random_below(sizeof bytes);
        for (size_t i = 0; i < length; i++)
            bytes[i] = (char)random_word();
        read_damaged(bytes, length);
    }
    test_end();
}

int main(void)
{
    test_catalogue();
    test_canonical();
    test_same_scheme();
    test_orbits();
    test_reach();
    test_statements();
    test_name_length();
    test_mask_complaints();
    test_places();
    test_sizes();
    test_truncation();
    test_mutations();
    test_garbage();
    return test_status();
}
