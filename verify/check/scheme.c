/* The scheme language: lib/scheme.md, "Grammar" and "Meaning". */

#include "scheme.h"

#include "answer.h"

#include <string.h>

enum { MAX_NAME = 64, MASK_RADIUS = 8, MASK_SIDE = 2 * MASK_RADIUS + 1,
       MAX_RULE_RING = 16, EXACT_GRID = 64 };

struct reader {
    struct scheme *scheme;
    struct statements s;
};

/* A statement of the word `first` and something behind it. */
static struct cursor next_statement(struct reader *r, const char *first, const char *expected)
{
    struct cursor c;

    statements_next(&c, &r->s, expected);
    if (!cursor_accept_word(&c, first))
        cursor_error(&c, expected);
    return c;
}

/* Is the next statement of this word?  Then nothing is read. */
static bool next_is(struct reader *r, const char *word)
{
    struct statements ahead = r->s;
    struct cursor c;

    return statements_more(&c, &ahead) && cursor_accept_word(&c, word);
}

/* The header
 * ---------- */

static void read_name(char *out, struct cursor *c)
{
    const char *from;
    size_t length;

    cursor_skip_blanks(c);
    from = c->at;
    if (c->at == c->end || *c->at < 'a' || *c->at > 'z')
        cursor_error(c, "expected a name that begins with a lower-case letter");
    while (c->at < c->end && ((*c->at >= 'a' && *c->at <= 'z') || cursor_at_digit(c) ||
                              *c->at == '-'))
        c->at++;
    length = (size_t)(c->at - from);
    if (length > MAX_NAME)
        cursor_error(c, "expected a name of at most 64 characters");
    memcpy(out, from, length);
}

static void read_mesh(struct scheme *out, struct cursor *c)
{
    if (cursor_accept_word(c, "triangle"))
        out->mesh = TRIANGLE;
    else if (cursor_accept_word(c, "quad"))
        out->mesh = cursor_accept_text(c, "-dual") ? DUAL : QUAD;
    else
        cursor_error(c, "expected `triangle`, `quad` or `quad-dual`");
    cursor_expect_end(c);
}

static void read_header(struct reader *r)
{
    struct cursor c = next_statement(r, "scheme", "expected `scheme` and a name");

    read_name(r->scheme->name, &c);
    cursor_expect_end(&c);
    c = next_statement(r, "mesh", "expected `mesh` and its kind");
    read_mesh(r->scheme, &c);
    c = next_statement(r, "dilation", "expected `dilation 2`");
    cursor_expect(&c, '2', "expected `2`, the only dilation");
    cursor_expect_end(&c);
    c = next_statement(r, "vertices", "expected `vertices interior`");
    if (!cursor_accept_word(&c, "interior"))
        cursor_error(&c, "expected `interior`");
    cursor_expect_end(&c);
}

/* Definitions
 * ----------- */

/* A formula that must be rational. */
static rational read_rational(struct cursor *c, struct language *l)
{
    struct cursor place = *c;
    struct environment e = environment_plain(l, EXACT_GRID);
    struct value v = evaluate(formula_read(c, l, 0), &e);

    value_require(v, l, NULL, 0);
    if (v.kind != RATIONAL)
        cursor_error(&place, "expected a value that is exactly rational");
    return v.q;
}

/* constant = formula | "[" formula "," formula "]" */
static void read_constant(struct definition *out, struct cursor *c, struct language *l)
{
    if (!cursor_accept(c, '[')) {
        out->low = out->high = read_rational(c, l);
        return;
    }
    out->interval = true;
    out->low = read_rational(c, l);
    cursor_expect(c, ',', "expected `,`");
    out->high = read_rational(c, l);
    cursor_expect(c, ']', "expected `]`");
    if (rational_compare(out->low, out->high) > 0)
        cursor_error(c, "the lower end of this interval is above the upper one");
}

static void read_definition(struct reader *r, bool parameter)
{
    struct language *l = &r->scheme->language;
    struct definition *d = &l->definition[l->count];
    struct cursor c = next_statement(r, parameter ? "parameter" : "let", "");
    struct cursor place = c;

    if (l->count == MAX_DEFINITIONS)
        cursor_error(&c, "expected at most 64 parameters and abbreviations");
    if (!cursor_read_word(d->name, MAX_WORD, &c) || word_is_reserved(d->name))
        cursor_error(&place, "expected a new name");
    for (int i = 0; i < l->count; i++)
        if (strcmp(d->name, l->definition[i].name) == 0)
            cursor_error(&place, "expected a name that is not defined yet");
    cursor_expect(&c, '=', "expected `=`");
    if (parameter)
        read_constant(d, &c, l);
    else
        d->formula = formula_read(&c, l, MEANS_K | MEANS_M | MEANS_J);
    cursor_expect_end(&c);
    l->count++;
}

static void read_definitions(struct reader *r)
{
    while (next_is(r, "parameter") || next_is(r, "let"))
        read_definition(r, next_is(r, "parameter"));
}

/* Points
 * ------ */

/* A coordinate as a label: `shift` is -1 in masks, where labels are differences,
 * and 1 in rules.  The half n/2 is the label (n + shift)/2. */
static int read_coordinate(struct cursor *c, enum mesh mesh, int shift)
{
    struct cursor place = *c;
    int value;

    cursor_skip_blanks(c);
    value = cursor_read_whole(c, 2);
    if (mesh != DUAL)
        return value;
    if (value % 2 == 0 || !cursor_accept_text(c, "/2"))
        cursor_error(&place, "expected halves such as 1/2 or -3/2");
    return (value + shift) / 2;
}

static void read_point(int *a, int *b, struct cursor *c, enum mesh mesh, int shift)
{
    cursor_expect(c, '(', "expected a point, like (1,0)");
    *a = read_coordinate(c, mesh, shift);
    cursor_expect(c, ',', "expected `,`");
    *b = read_coordinate(c, mesh, shift);
    cursor_expect(c, ')', "expected `)`");
}

int label_ring(enum mesh mesh, int a, int b)
{
    return mesh == TRIANGLE ? a + b : a > b ? a : b;
}

static void read_sector_point(int *a, int *b, struct cursor *c, enum mesh mesh)
{
    struct cursor place = *c;

    read_point(a, b, c, mesh, 1);
    if (*a < 1 || *b < (mesh == DUAL ? 1 : 0))
        cursor_error(&place, "expected a point of the sector");
    if (label_ring(mesh, *a, *b) > MAX_RULE_RING)
        cursor_error(&place, "expected a point at most 16 rings out");
}

/* The mask
 * -------- */

struct mask_reader {
    struct mask mask;
    rational weight[MASK_SIDE * MASK_SIDE];        /* 0/0: none is named */
    enum mesh mesh;
};

static int cell_number(const struct mask_reader *m, int a, int b)
{
    return (int)(mask_cell(&m->mask, a, b) - m->mask.coefficient);
}

/* Gives the label its weight; with `symmetric` all its images, too: the rotations
 * of it, and of its mirror image. */
static void name_point(struct mask_reader *m, int a, int b, bool symmetric, rational w,
                       const struct cursor *place)
{
    int turns = m->mesh == TRIANGLE ? 6 : 4;
    int images = symmetric ? 2 * turns : 1;
    int cell[12];

    for (int i = 0; i < images; i++) {
        cell[i] = i < turns ? cell_number(m, a, b) : cell_number(m, b, a);
        if (m->weight[cell[i]].den.sign != 0)
            cursor_error(place, "expected a point that has no weight yet");
        label_rotate(m->mesh, &a, &b);
    }
    for (int i = 0; i < images; i++)
        m->weight[cell[i]] = w;
}

static void read_mask_entry(struct mask_reader *m, struct cursor *c, bool symmetric,
                            struct language *l)
{
    struct cursor place = *c;
    rational weight;
    int a, b;

    read_point(&a, &b, c, m->mesh, -1);
    if (lattice_distance(m->mesh, a, b) > MASK_RADIUS || mask_cell(&m->mask, a, b) == NULL)
        cursor_error(&place, "expected a point at a distance of at most 8");
    weight = read_rational(c, l);
    cursor_expect_end(c);
    name_point(m, a, b, symmetric, weight, &place);
}

static struct mask read_mask(struct reader *r)
{
    struct mask_reader *m = allocate(1, sizeof *m);
    struct language *l = &r->scheme->language;
    struct cursor c = next_statement(r, "mask", "expected `mask` or `mask symmetric`");
    bool symmetric = cursor_accept_word(&c, "symmetric");
    struct cursor first = c;
    const char *fault;

    cursor_expect_end(&c);
    m->mesh = r->scheme->mesh;
    m->mask = mask_new(-MASK_RADIUS, -MASK_RADIUS, MASK_SIDE, MASK_SIDE);
    if (m->mesh == DUAL)                           /* -15/2 .. 15/2: -8 .. 7 */
        m->mask = mask_new(-MASK_RADIUS, -MASK_RADIUS, MASK_SIDE - 1, MASK_SIDE - 1);
    for (;;) {
        statements_next(&c, &r->s, "expected a point and its weight, or `end`");
        if (cursor_accept_word(&c, "end"))
            break;
        read_mask_entry(m, &c, symmetric, l);
    }
    cursor_expect_end(&c);

    for (int i = 0; i < MASK_SIDE * MASK_SIDE; i++)
        if (m->weight[i].den.sign == 0)
            m->weight[i] = rational_from(0, 1);
    mask_set_weights(&m->mask, m->weight);
    fault = mask_fault(&m->mask, m->mesh);
    if (fault != NULL)
        cannot_check_at(r->s.file, first.line, 0, "expected %s", fault);
    return m->mask;
}

/* Rules
 * ----- */

/* The kind of a source that begins with a point, and what is behind `@`. */
static void read_point_source(struct source *out, struct cursor *c, enum mesh mesh)
{
    read_sector_point(&out->a, &out->b, c, mesh);
    if (cursor_accept_word(c, "spectrum")) {
        out->kind = SOURCE_SPECTRUM;
    } else if (!cursor_accept(c, '@')) {
        out->kind = SOURCE_ONE;
    } else if (cursor_accept_word(c, "j")) {
        out->kind = SOURCE_EACH;
    } else {
        out->kind = SOURCE_ONE;
        cursor_skip_blanks(c);
        out->sectors = cursor_read_whole(c, 3);
    }
}

/* rule->rest: -1 as long as there is none.  Returns the place of the weight. */
static struct cursor read_source(struct rule *rule, struct cursor *c, struct scheme *scheme)
{
    struct language *l = &scheme->language;
    struct source *out = &rule->source[rule->count];
    struct cursor place = *c;

    if (rule->count == MAX_SOURCES)
        cursor_error(c, "expected at most 32 sources in a rule");
    if (cursor_accept_word(c, "centre")) {
        out->kind = SOURCE_CENTRE;
        if (scheme->mesh == DUAL)
            cursor_error(&place, "a dual mesh has no point in its centre");
    } else if (cursor_accept_word(c, "all")) {
        out->kind = SOURCE_ALL;
        read_sector_point(&out->a, &out->b, c, scheme->mesh);
    } else {
        if (rule->centre)                          /* else not the same for all sectors */
            cursor_error(c, "expected `centre` or `all` in the rule of the centre");
        read_point_source(out, c, scheme->mesh);
    }

    place = *c;
    if (cursor_accept_word(c, "rest")) {
        if (out->kind == SOURCE_EACH || out->kind == SOURCE_SPECTRUM)
            cursor_error(&place, "`rest` cannot be the weights of all sectors");
        if (rule->rest >= 0)
            cursor_error(&place, "expected `rest` as exactly one of the weights");
        rule->rest = rule->count;
    } else {
        out->weight = formula_read(c, l, out->kind == SOURCE_SPECTRUM ? MEANS_K | MEANS_M
                                       : out->kind == SOURCE_EACH ? MEANS_K | MEANS_J
                                       : MEANS_K);
    }
    if (out->kind == SOURCE_SPECTRUM && cursor_accept(c, ','))
        out->imaginary = formula_read(c, l, MEANS_K | MEANS_M);
    cursor_expect_end(c);
    rule->count++;
    return place;
}

/* Exactly one `rest`; without one the value of the one spectrum at m = 0 is it. */
static void find_rest(struct rule *rule, const struct cursor *place)
{
    int spectra = 0;

    if (rule->rest >= 0)
        return;
    for (int i = 0; i < rule->count; i++) {
        if (rule->source[i].kind == SOURCE_SPECTRUM) {
            rule->rest = i;
            spectra++;
        }
    }
    if (spectra != 1)
        cursor_error(place, "expected `rest` as exactly one of the weights");
}

static void read_rule(struct rule *out, struct reader *r)
{
    struct scheme *scheme = r->scheme;
    struct cursor c = next_statement(r, "rule", "expected `rule`"), place = c;

    out->rest = -1;
    out->centre = cursor_accept_word(&c, "centre");
    if (out->centre && scheme->mesh == DUAL)
        cursor_error(&place, "a dual mesh has no point in its centre");
    if (!out->centre)
        read_sector_point(&out->a, &out->b, &c, scheme->mesh);
    place = c;
    if (cursor_accept_word(&c, "when"))
        out->condition = condition_read(&c, &scheme->language, MEANS_K);
    cursor_expect_end(&c);
    for (;;) {
        statements_next(&c, &r->s, "expected a source and its weight, or `end`");
        if (cursor_accept_word(&c, "end"))
            break;
        place = read_source(out, &c, scheme);
    }
    cursor_expect_end(&c);
    find_rest(out, &place);
}

static void read_mask_and_rules(struct reader *r)
{
    struct scheme *out = r->scheme;
    struct step *step = &out->step[0];
    struct rule *rule = allocate(MAX_RULES, sizeof rule[0]);
    struct cursor c;

    out->steps = 1;
    step->old = step->new = out->mesh;
    step->dilation = 2;
    step->mask = read_mask(r);
    step->reach = mask_reach(&step->mask, out->mesh);
    step->rule = rule;
    for (struct statements ahead = r->s; statements_more(&c, &ahead); ahead = r->s) {
        if (!cursor_accept_word(&c, "rule"))
            cursor_error(&c, "expected `rule`, or the end of the line");
        if (step->rules == MAX_RULES)
            cursor_error(&c, "expected at most 16 rules");
        read_rule(&rule[step->rules++], r);
    }
}

/* Compositions
 * ------------ */

/* The rule of the centre: the old centre, all (1,0), and the rest to all (1,1);
 * or, without weights, all to all (1,1). */
static const struct rule *centre_rule(const struct node *own, const struct node *edges)
{
    const struct source source[3] = { { .kind = SOURCE_CENTRE, .weight = own },
                                      { .kind = SOURCE_ALL, .a = 1, .weight = edges },
                                      { .kind = SOURCE_ALL, .a = 1, .b = 1 } };
    struct rule *out = allocate(1, sizeof *out);

    out->centre = true;
    out->rest = own == NULL ? 0 : 2;
    out->count = out->rest + 1;
    memcpy(out->source, &source[2 - out->rest], (size_t)out->count * sizeof source[0]);
    return out;
}

/* The mask is on the square of this side whose lowest label is (low, low). */
static struct step make_step(enum mesh old, enum mesh new, int dilation, int reach, int low,
                             int side, const rational *weight, const struct rule *rule)
{
    struct step out = { .old = old, .new = new, .dilation = dilation, .reach = reach,
                        .mask = mask_new(low, low, side, side),
                        .rules = rule == NULL ? 0 : 1, .rule = rule };

    mask_set_weights(&out.mask, weight);
    return out;
}

static struct step refine_step(enum mesh old)
{
    rational w[9];

    for (int i = 0; i < 9; i++)                    /* 1 = 4/4, 1/2 = 2/4, 1/4 */
        w[i] = rational_from((i % 3 == 1 ? 2 : 1) * (i / 3 == 1 ? 2 : 1), 4);
    if (old == DUAL)
        return make_step(DUAL, QUAD, 2, 2, -2, 3, w, centre_rule(NULL, NULL));
    return make_step(QUAD, QUAD, 2, 1, -1, 3, w, NULL);
}

static struct step smooth_step(rational own, rational edges, const struct node *at_centre[2])
{
    rational diagonals = rational_sub(rational_sub(rational_from(1, 1), own), edges);
    rational four = rational_from(4, 1), w[9];

    for (int i = 0; i < 9; i++)
        w[i] = rational_divide(i % 2 == 0 ? diagonals : edges, four);
    w[4] = own;
    return make_step(QUAD, QUAD, 1, 1, -1, 3, w, centre_rule(at_centre[0], at_centre[1]));
}

static struct step average_step(void)
{
    rational quarter = rational_from(1, 4), w[4] = { quarter, quarter, quarter, quarter };

    return make_step(QUAD, DUAL, 1, 0, 0, 2, w, NULL);
}

static struct node *number_node(rational q)
{
    struct node *out = allocate(1, sizeof *out);

    out->kind = NODE_NUMBER;
    out->number = q;
    return out;
}

static void add_step(struct scheme *out, const struct step *step, const struct cursor *c)
{
    if (out->steps == MAX_STEPS)
        cursor_error(c, "expected at most 34 steps");
    out->step[out->steps++] = *step;
}

static const char COMMA[] = "expected `,` and a second weight";

/* ["repeat" formula ":"] "smooth" pair ["centre" pair] */
static void read_smooth(struct reader *r, struct cursor *c)
{
    struct language *l = &r->scheme->language;
    const struct node *at_centre[2];
    struct cursor place = *c;
    struct step step;
    rational own, edges;
    int64_t times = 1;

    if (cursor_accept_word(c, "repeat")) {
        rational q = read_rational(c, l);

        if (!rational_is_whole(q) || q.num.sign < 0 || !integer_get_small(&times, q.num, MAX_STEPS))
            cursor_error(&place, "expected a whole number of repetitions, at most 34");
        cursor_expect(c, ':', "expected `:`");
    }
    if (!cursor_accept_word(c, "smooth"))
        cursor_error(c, "expected `smooth`, `repeat`, `average` or `end`");
    own = read_rational(c, l);
    cursor_expect(c, ',', COMMA);
    edges = read_rational(c, l);
    at_centre[0] = number_node(own);
    at_centre[1] = number_node(edges);
    cursor_skip_blanks(c);
    if (cursor_is_apart(c) && cursor_accept_word(c, "centre")) {
        at_centre[0] = formula_read(c, l, MEANS_K);
        cursor_expect(c, ',', COMMA);
        at_centre[1] = formula_read(c, l, MEANS_K);
    }
    cursor_expect_end(c);
    step = smooth_step(own, edges, at_centre);
    for (int64_t i = 0; i < times; i++)
        add_step(r->scheme, &step, &place);
}

/* "average" ["when" condition] */
static bool read_average(struct reader *r, struct cursor *c)
{
    struct language *l = &r->scheme->language;
    struct environment e = environment_plain(l, EXACT_GRID);
    bool out = true;

    if (cursor_accept_word(c, "when"))
        out = condition_holds(condition_read(c, l, 0), &e);
    cursor_expect_end(c);
    return out;
}

static void read_composition(struct reader *r)
{
    struct scheme *out = r->scheme;
    struct cursor c = next_statement(r, "compose", ""), place = c;
    struct step average = average_step();

    if (out->mesh != QUAD)
        cursor_error(&c, "expected `mesh quad` for `compose`");
    cursor_expect_end(&c);
    c = next_statement(r, "refine", "expected `refine`");
    cursor_expect_end(&c);
    out->steps = 1;                                /* made below */
    for (;;) {
        statements_next(&c, &r->s, "expected a step, or `end`");
        if (cursor_accept_word(&c, "end"))
            break;
        if (cursor_accept_word(&c, "average")) {
            if (read_average(r, &c)) {
                out->mesh = DUAL;
                add_step(out, &average, &place);
            }
            c = next_statement(r, "end", "expected `end` behind `average`");
            break;
        }
        read_smooth(r, &c);
    }
    cursor_expect_end(&c);
    if (statements_more(&c, &r->s))
        cursor_expect_end(&c);
    out->step[0] = refine_step(out->mesh);
}

/* Size
 * ---- */

int mask_reach(const struct mask *mask, enum mesh mesh)
{
    struct points p = mask_points(mask);
    int out = 0;

    for (int i = 0; i < p.count; i++) {
        int a = p.point[i].a, b = p.point[i].b, reach;

        if (mesh == DUAL) {                        /* i >= 0 counts as i + 1 */
            a = a >= 0 ? a + 1 : a;
            b = b >= 0 ? b + 1 : b;
        }
        reach = lattice_distance(mesh, a, b);
        out = reach > out ? reach : out;
    }
    return out;
}

int step_needs(const struct step *step, int j)
{
    int out = (j + step->reach) / step->dilation;

    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = &step->rule[i];

        if (!rule->centre && label_ring(step->new, rule->a, rule->b) > j)
            continue;
        for (int n = 0; n < rule->count; n++) {
            const struct source *s = &rule->source[n];
            int ring = label_ring(step->old, s->a, s->b);

            if (s->kind != SOURCE_CENTRE && ring > out)
                out = ring;
        }
    }
    return out;
}

/* All of it
 * --------- */

void scheme_read(struct scheme *out, const char *file, const char *text, size_t size)
{
    struct reader r = { out, { file, 0, text, text + size } };

    memset(out, 0, sizeof *out);
    out->language.file = file;
    read_header(&r);
    read_definitions(&r);
    if (next_is(&r, "compose"))
        read_composition(&r);
    else
        read_mask_and_rules(&r);
    out->mask = out->step[0].mask;
    for (int i = 1; i < out->steps; i++)
        out->mask = mask_multiply(&out->step[i].mask, &out->mask);
    out->mirrored = scheme_is_mirrored(out);
}

bool scheme_is_of_version_0(const struct scheme *s)
{
    const struct rule *rule = s->step[0].rule;

    return s->mesh == TRIANGLE && s->language.count == 0 && !s->language.beyond_0 &&
           mask_is_mirrored(&s->mask) && s->step[0].rules == 1 && rule->centre &&
           rule->condition == NULL && rule->count == 2 &&
           rule->source[0].kind == SOURCE_CENTRE && rule->source[1].kind == SOURCE_ALL &&
           rule->source[1].a == 1 && rule->source[1].b == 0;
}
