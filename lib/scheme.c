/* scheme.c: reads a scheme file, one function per statement of the grammar. */
#include "scheme.h"

#include <stdlib.h>
#include <string.h>

#define MAX_MASK_POINTS 300

void scheme_init(scheme *z)
{
    memset(z, 0, sizeof *z);
    laurent_init(&z->mask);
}

void scheme_clear(scheme *z)
{
    text_clear(&z->source);
    laurent_clear(&z->mask);
    formula_free(z->centre_weight);
    formula_free(z->ring_weight);
    scheme_init(z);
}

/* ---- words, points and places in lines ---- */

typedef struct {
    const source_text *source;
    size_t next;            /* index of the next line */
    const text_line *line;  /* the current one; NULL at the end */
    size_t at;              /* in the current line */
    diagnostic *complaint;
} reader;

static void next_line(reader *r)
{
    r->line = r->next < r->source->lines ? &r->source->line[r->next++] : NULL;
    r->at = 0;
}

static status complain_at(const reader *r, size_t at, const char *format, const char *what)
{
    return diagnostic_set(r->complaint, r->line->line, r->line->column[at], format, what);
}

static void skip_blank(reader *r)
{
    if (r->line && r->at < r->line->length && r->line->text[r->at] == ' ')
        r->at++;
}

/* "expected WHAT, found ..." at the current place. */
static status expected(reader *r, const char *what)
{
    size_t length;
    const char *start;
    skip_blank(r);
    if (!r->line)
        return diagnostic_set(r->complaint, r->source->last_line + 1, 1, "expected %s, but the file ends", what);
    if (r->at >= r->line->length)
        return complain_at(r, r->line->length, "expected %s, but the line ends", what);
    start = r->line->text + r->at;
    length = strcspn(start, " \n");
    return diagnostic_set(r->complaint, r->line->line, r->line->column[r->at], "expected %s, found '%.*s'", what,
                          (int)(length > 40 ? 40 : length), start);
}

/* Is the next word this one?  Then steps over it. */
static bool take_word(reader *r, const char *word)
{
    size_t length = strlen(word);
    skip_blank(r);
    if (!r->line || r->line->length - r->at < length || memcmp(r->line->text + r->at, word, length))
        return false;
    if (r->at + length < r->line->length && r->line->text[r->at + length] >= 'a' && r->line->text[r->at + length] <= 'z')
        return false; /* a longer word */
    r->at += length;
    return true;
}

static bool take_character(reader *r, char c)
{
    skip_blank(r);
    if (!r->line || r->at >= r->line->length || r->line->text[r->at] != c)
        return false;
    r->at++;
    return true;
}

static status expect_end_of_line(reader *r)
{
    skip_blank(r);
    return r->at < r->line->length ? expected(r, "the end of the line") : STATUS_OK;
}

static bool take_coordinate(reader *r, int *value)
{
    bool negative = take_character(r, '-');
    int digits = 0;
    *value = 0;
    if (!negative)
        skip_blank(r);
    while (digits < 3 && r->at < r->line->length && r->line->text[r->at] >= '0' && r->line->text[r->at] <= '9') {
        *value = 10 * *value + (r->line->text[r->at++] - '0');
        digits++;
    }
    if (negative)
        *value = -*value;
    return digits == 1 || digits == 2;
}

static status read_point(lattice *p, reader *r)
{
    if (!take_character(r, '('))
        return expected(r, "a point such as (1,0)");
    if (!take_coordinate(r, &p->a))
        return expected(r, "a coordinate (one or two digits)");
    if (!take_character(r, ','))
        return expected(r, "','");
    if (!take_coordinate(r, &p->b))
        return expected(r, "a coordinate (one or two digits)");
    if (!take_character(r, ')'))
        return expected(r, "')'");
    return STATUS_OK;
}

static status read_rest_as_formula(formula **f, reader *r)
{
    skip_blank(r);
    if (r->at >= r->line->length)
        return expected(r, "a formula");
    return formula_read(f, r->line->text + r->at, r->line->length - r->at, r->line->line, r->line->column + r->at, r->complaint);
}

/* ---- the statements ---- */

static status read_name(scheme *z, reader *r)
{
    size_t n = 0;
    if (!take_word(r, "scheme"))
        return expected(r, "'scheme NAME' as the first statement");
    skip_blank(r);
    while (r->at < r->line->length && n <= SCHEME_NAME_MAX) {
        char c = r->line->text[r->at];
        bool letter = c >= 'a' && c <= 'z';
        if (!letter && (n == 0 || !((c >= '0' && c <= '9') || c == '-')))
            break;
        if (n < SCHEME_NAME_MAX)
            z->name[n] = c;
        n++;
        r->at++;
    }
    skip_blank(r);
    if (n == 0 || n > SCHEME_NAME_MAX || r->at < r->line->length)
        return expected(r, "a name (a lower-case letter, then at most 63 lower-case letters, digits and '-')");
    z->name[n] = '\0';
    return STATUS_OK;
}

/* A statement of one word with one allowed value; the words in `later` are understood but not yet covered. */
static status read_setting(reader *r, const char *word, const char *value, const char *const *later)
{
    char what[64] = "'";
    next_line(r);
    strcat(strcat(strcat(strcat(what, word), " "), value), "'");
    if (!take_word(r, word))
        return expected(r, what);
    for (; *later; later++)
        if (take_word(r, *later))
            return diagnostic_set(r->complaint, r->line->line, r->line->column[0], "'%s %s' is reserved for a later version; this one covers %s", word, *later, what);
    if (!take_word(r, value))
        return expected(r, what);
    return expect_end_of_line(r);
}

/* The terms of a mask as they are read. */
typedef struct {
    lattice point[MAX_MASK_POINTS];
    rational weight[MAX_MASK_POINTS];
    size_t count;
} terms;

static status add_term(terms *t, lattice p, const rational *weight, const reader *r)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->point[i].a == p.a && t->point[i].b == p.b)
            return diagnostic_set(r->complaint, r->line->line, r->line->column[0],
                                  "the point (%d,%d) is given a weight twice (with 'symmetric' an entry stands for its whole orbit)", p.a, p.b);
    if (t->count == MAX_MASK_POINTS)
        return diagnostic_set(r->complaint, r->line->line, r->line->column[0], "a mask may have %d points at most", MAX_MASK_POINTS);
    t->point[t->count] = p;
    rational_init(&t->weight[t->count]);
    return rational_set(&t->weight[t->count++], weight) ? STATUS_OK : STATUS_NO_MEMORY;
}

/* Adds the images of p under rotations by a sixth of a turn and reflection, each once. */
static status add_orbit(terms *t, lattice p, const rational *weight, const reader *r)
{
    lattice image[12];
    size_t count = 0;
    for (int i = 0; i < 12; i++) {
        bool known = false;
        for (size_t j = 0; j < count; j++)
            known = known || (image[j].a == p.a && image[j].b == p.b);
        if (!known)
            image[count++] = p;
        p = i == 5 ? (lattice){p.b, p.a} : (lattice){-p.b, p.a + p.b};
    }
    for (size_t j = 0; j < count; j++) {
        status s = add_term(t, image[j], weight, r);
        if (s != STATUS_OK)
            return s;
    }
    return STATUS_OK;
}

static status read_mask_line(terms *t, bool symmetric, reader *r)
{
    lattice p;
    rational weight;
    formula *f = NULL;
    status s = read_point(&p, r);
    if (s == STATUS_OK && lattice_distance(p.a, p.b) > SCHEME_MAX_REACH)
        return complain_at(r, 0, "a mask point may be at most %s edges from 0", "8");
    if (s == STATUS_OK)
        s = read_rest_as_formula(&f, r);
    if (s == STATUS_OK && formula_depends_on_valence(f))
        s = complain_at(r, 0, "%s must not depend on k: the regular mask is the same on all meshes", "a mask weight");
    rational_init(&weight);
    if (s == STATUS_OK)
        s = formula_exact_rational(&weight, f, 0, r->complaint);
    if (s == STATUS_OK)
        s = symmetric ? add_orbit(t, p, &weight, r) : add_term(t, p, &weight, r);
    rational_clear(&weight);
    formula_free(f);
    return s;
}

static status check_class_sums(const scheme *z, const reader *r)
{
    rational sum;
    status s = STATUS_OK;
    rational_init(&sum);
    for (int i = 0; s == STATUS_OK && i < 4; i++) {
        if (!laurent_class_sum(&sum, &z->mask, i / 2, i % 2, 2)) {
            s = STATUS_NO_MEMORY;
        } else if (rational_cmp_si(&sum, 1, 1) != 0) {
            char *text = rational_get_str(&sum);
            s = text ? diagnostic_set(r->complaint, r->line->line, r->line->column[0],
                                      "the mask's weights at points congruent to (%d,%d) modulo 2 sum to %.100s, not to 1", i / 2, i % 2, text)
                     : STATUS_NO_MEMORY;
            free(text);
        }
    }
    rational_clear(&sum);
    return s;
}

/* Is the weight at p the weight at q, for all p of the box and q = image(p)? */
static bool is_invariant(const laurent *mask, bool rotation)
{
    for (int a = -SCHEME_MAX_REACH; a <= SCHEME_MAX_REACH; a++)
        for (int b = -SCHEME_MAX_REACH; b <= SCHEME_MAX_REACH; b++) {
            const integer *x = laurent_at(mask, a, b);
            const integer *y = rotation ? laurent_at(mask, -b, a + b) : laurent_at(mask, b, a);
            bool zero_x = !x || integer_is_zero(x), zero_y = !y || integer_is_zero(y);
            if (zero_x != zero_y || (!zero_x && integer_cmp(x, y) != 0))
                return false;
        }
    return true;
}

static status check_mask(scheme *z, const reader *r)
{
    status s = check_class_sums(z, r);
    if (s != STATUS_OK)
        return s;
    if (!is_invariant(&z->mask, true))
        return complain_at(r, 0, "the mask is not invariant under rotation by a sixth of a turn (%s), so it has no meaning where the valence is not 6", "(i,j) -> (-j,i+j)");
    if (!is_invariant(&z->mask, false))
        return complain_at(r, 0, "the mask is not invariant under reflection (%s): mirror-asymmetric schemes are reserved for a later version", "(i,j) -> (j,i)");
    for (int a = -SCHEME_MAX_REACH; a <= SCHEME_MAX_REACH; a++)
        for (int b = -SCHEME_MAX_REACH; b <= SCHEME_MAX_REACH; b++)
            if (!laurent_is_zero_at(&z->mask, a, b) && lattice_distance(a, b) > z->reach)
                z->reach = lattice_distance(a, b);
    return STATUS_OK;
}

static status read_mask(scheme *z, reader *r)
{
    bool symmetric;
    status s = STATUS_OK;
    terms *t = calloc(1, sizeof *t);
    if (!t)
        return STATUS_NO_MEMORY;
    next_line(r);
    if (!take_word(r, "mask"))
        s = expected(r, "'mask' or 'mask symmetric'");
    symmetric = s == STATUS_OK && take_word(r, "symmetric");
    if (s == STATUS_OK)
        s = expect_end_of_line(r);
    while (s == STATUS_OK) {
        next_line(r);
        if (take_word(r, "end"))
            break;
        s = r->line ? read_mask_line(t, symmetric, r) : expected(r, "a mask point or 'end'");
    }
    if (s == STATUS_OK)
        s = expect_end_of_line(r);
    if (s == STATUS_OK && !laurent_set_terms(&z->mask, t->point, t->weight, t->count))
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK)
        s = check_mask(z, r);
    for (size_t i = 0; i < t->count; i++)
        rational_clear(&t->weight[i]);
    free(t);
    return s;
}

/* A weight of the rule: `rest` leaves *f NULL. */
static status read_weight(formula **f, reader *r)
{
    if (take_word(r, "rest"))
        return expect_end_of_line(r);
    return read_rest_as_formula(f, r);
}

static status read_rule(scheme *z, reader *r)
{
    lattice p;
    status s;
    next_line(r);
    if (!take_word(r, "rule") || !take_word(r, "centre"))
        return expected(r, "'rule centre'");
    if ((s = expect_end_of_line(r)) != STATUS_OK)
        return s;
    next_line(r);
    if (!take_word(r, "centre"))
        return expected(r, "'centre WEIGHT'");
    if ((s = read_weight(&z->centre_weight, r)) != STATUS_OK)
        return s;
    next_line(r);
    if (!take_word(r, "all"))
        return expected(r, "'all (1,0) WEIGHT'");
    skip_blank(r);
    if ((s = read_point(&p, r)) != STATUS_OK)
        return s;
    if (p.a != 1 || p.b != 0)
        return complain_at(r, 0, "this version covers rules with the ring of neighbours, %s, only", "all (1,0)");
    if ((s = read_weight(&z->ring_weight, r)) != STATUS_OK)
        return s;
    if ((z->centre_weight == NULL) == (z->ring_weight == NULL))
        return complain_at(r, 0, "exactly one of the two weights must be %s, so that they sum to 1 exactly", "'rest'");
    next_line(r);
    if (!take_word(r, "end"))
        return expected(r, "'end'");
    return expect_end_of_line(r);
}

status scheme_read(scheme *z, const char *bytes, size_t length, diagnostic *d)
{
    static const char *const later_meshes[] = {"quad-dual", "quad", NULL};
    static const char *const later_vertices[] = {"boundary", "crease", NULL};
    static const char *const nothing[] = {NULL};
    reader r = {&z->source, 0, NULL, 0, d};
    status s = text_read(&z->source, bytes, length, d);
    if (s != STATUS_OK)
        return s;
    next_line(&r);
    if ((s = read_name(z, &r)) != STATUS_OK || (s = read_setting(&r, "mesh", "triangle", later_meshes)) != STATUS_OK
        || (s = read_setting(&r, "dilation", "2", nothing)) != STATUS_OK
        || (s = read_setting(&r, "vertices", "interior", later_vertices)) != STATUS_OK
        || (s = read_mask(z, &r)) != STATUS_OK || (s = read_rule(z, &r)) != STATUS_OK)
        return s;
    next_line(&r);
    return r.line ? expected(&r, "nothing more after the rule") : STATUS_OK;
}
