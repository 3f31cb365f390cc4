/* The scheme language: lib/scheme.md, "Grammar" and "Meaning". */

#include "scheme.h"

#include "answer.h"
#include "formula.h"
#include "text.h"

#include <stdlib.h>

enum { MAX_NAME = 64 };

static void read_name(char *out, struct cursor *c)
{
    int length = 0;

    cursor_skip_blanks(c);
    if (c->at == c->end || *c->at < 'a' || *c->at > 'z')
        cursor_error(c, "expected a name that begins with a lower-case letter");
    while (c->at < c->end && ((*c->at >= 'a' && *c->at <= 'z') ||
                              (*c->at >= '0' && *c->at <= '9') || *c->at == '-')) {
        if (length == MAX_NAME)
            cursor_error(c, "expected a name of at most 64 characters");
        out[length++] = *c->at;
        c->at++;
    }
    out[length] = '\0';
}

/* A statement of the word `first` and something behind it. */
static void next_statement(struct cursor *c, struct statements *s,
                           const char *first, const char *expected)
{
    statements_next(c, s, expected);
    if (!cursor_accept_word(c, first))
        cursor_error(c, expected);
}

static void read_header(struct scheme *out, struct statements *s)
{
    struct cursor c;

    next_statement(&c, s, "scheme", "expected `scheme` and a name");
    read_name(out->name, &c);
    cursor_expect_end(&c);

    next_statement(&c, s, "mesh", "expected `mesh triangle`");
    if (!cursor_accept_word(&c, "triangle"))
        cursor_error(&c, "expected `triangle`, the only mesh of version 0");
    cursor_expect_end(&c);

    next_statement(&c, s, "dilation", "expected `dilation 2`");
    if (!cursor_accept(&c, '2'))
        cursor_error(&c, "expected `2`, the only dilation of version 0");
    cursor_expect_end(&c);

    next_statement(&c, s, "vertices", "expected `vertices interior`");
    if (!cursor_accept_word(&c, "interior"))
        cursor_error(&c, "expected `interior`, the only vertices of version 0");
    cursor_expect_end(&c);
}

/* The mask
 * -------- */

/* The images of (a,b) under (i,j) -> (-j, i+j) and (i,j) -> (j,i): the six
 * rotations of it, and of its mirror image. */
static void list_images(int images[12][2], int a, int b)
{
    for (int i = 0; i < 12; i++) {
        int turned_a = -b, turned_b = a + b;

        images[i][0] = i < 6 ? a : b;
        images[i][1] = i < 6 ? b : a;
        a = turned_a;
        b = turned_b;
    }
}

static void name_point(bool named[MASK_SIDE][MASK_SIDE], struct exact_mask *mask,
                       int a, int b, bool symmetric, const rational *weight,
                       const struct cursor *place)
{
    int images[12][2];
    int count = symmetric ? 12 : 1;

    list_images(images, a, b);
    for (int i = 0; i < count; i++) {
        int row = images[i][0] + MASK_RADIUS;
        int column = images[i][1] + MASK_RADIUS;

        if (named[row][column])
            cursor_error(place, "expected a point that has no weight yet");
    }
    for (int i = 0; i < count; i++) {
        int row = images[i][0] + MASK_RADIUS;
        int column = images[i][1] + MASK_RADIUS;

        named[row][column] = true;
        rational_set(&mask->weight[row][column], weight);
    }
}

static void read_mask(struct scheme *out, struct statements *s, int g)
{
    bool named[MASK_SIDE][MASK_SIDE] = { { false } };
    struct exact_mask *exact = allocate(1, sizeof *exact);
    struct cursor c;
    bool symmetric;

    for (int i = 0; i < MASK_SIDE; i++)
        for (int j = 0; j < MASK_SIDE; j++)
            rational_set_small(&exact->weight[i][j], 0, 1);

    next_statement(&c, s, "mask", "expected `mask` or `mask symmetric`");
    symmetric = cursor_accept_word(&c, "symmetric");
    cursor_expect_end(&c);

    int first_line = c.line;

    for (;;) {
        struct cursor place;
        struct value weight;
        int a, b;

        statements_next(&c, s, "expected a point and its weight, or `end`");
        place = c;
        if (cursor_accept_word(&c, "end"))
            break;
        cursor_read_point(&a, &b, &c);
        if (lattice_distance(a, b) > MASK_RADIUS)
            cursor_error(&place, "expected a point at a distance of at most 8");
        formula_evaluate(&weight, &c, 0, g);
        cursor_expect_end(&c);
        if (weight.kind != RATIONAL)
            cursor_error(&place, "expected a weight that is exactly rational");
        name_point(named, exact, a, b, symmetric, &weight.q, &place);
    }
    cursor_expect_end(&c);

    mask_from_exact(&out->mask, exact);
    free(exact);

    const char *fault = mask_fault(&out->mask);

    if (fault != NULL)
        cannot_check_at(s->file, first_line, 0, "expected %s", fault);
}

/* The rule
 * -------- */

/* weight = formula | "rest"; returns whether it is "rest". */
static bool read_weight(struct value *out, struct cursor *c, int k, int g)
{
    bool rest = cursor_accept_word(c, "rest");

    if (!rest)
        formula_evaluate(out, c, k, g);
    cursor_expect_end(c);
    return rest;
}

/* out = w and other = 1 - w on the grid: two exact rationals, or enclosures. */
static void set_weights(interval *out, interval *other, const struct value *w, int g)
{
    interval one;

    if (w->kind == RATIONAL) {
        rational q;

        rational_set_small(&q, 1, 1);
        rational_sub(&q, &q, &w->q);
        grid_from_rational(out, &w->q, g);
        grid_from_rational(other, &q, g);
        return;
    }
    value_enclose(out, w, g);
    grid_set_small(&one, 1, g);
    interval_sub(other, &one, out);
}

static void read_rule(struct scheme *out, struct statements *s, int k, int g)
{
    struct cursor c;
    struct value centre, all;
    int a, b;

    next_statement(&c, s, "rule", "expected `rule centre`");
    if (!cursor_accept_word(&c, "centre"))
        cursor_error(&c, "expected `centre`, the only rule of version 0");
    cursor_expect_end(&c);

    next_statement(&c, s, "centre", "expected `centre` and its weight");

    bool centre_is_rest = read_weight(&centre, &c, k, g);

    next_statement(&c, s, "all", "expected `all (1,0)` and its total weight");
    cursor_skip_blanks(&c);

    struct cursor place = c;

    cursor_read_point(&a, &b, &c);
    if (a != 1 || b != 0)
        cursor_error(&place, "expected (1,0), the only point of version 0");
    place = c;

    bool all_is_rest = read_weight(&all, &c, k, g);

    if (centre_is_rest == all_is_rest)
        cursor_error(&place, "expected `rest` as exactly one of the two weights");
    if (centre_is_rest)
        set_weights(&out->all, &out->centre, &all, g);
    else
        set_weights(&out->centre, &out->all, &centre, g);

    next_statement(&c, s, "end", "expected `end`");
    cursor_expect_end(&c);
}

void scheme_read(struct scheme *out, const char *file, const char *text,
                 size_t size, int k, int g)
{
    struct statements s = { file, 0, text, text + size };

    read_header(out, &s);
    read_mask(out, &s, g);
    read_rule(out, &s, k, g);
    statements_end(&s);
}
