/* scheme_compose.c: compositions of refine, smooth and average. */
#include "scheme_reader.h"

#include <stdlib.h>
#include <string.h>

/* The mask with these weights at the labels low..low+n-1 in both directions (a tensor product). */
static bool set_tensor_mask(laurent *mask, int low, int n, const rational *weight)
{
    lattice point[9];
    rational value[9];
    bool ok = true;
    for (int i = 0; i < n * n; i++) {
        point[i] = (lattice){low + i / n, low + i % n};
        rational_init(&value[i]);
        ok = ok && rational_mul(&value[i], &weight[i / n], &weight[i % n]);
    }
    ok = ok && laurent_set_terms(mask, point, value, (size_t)(n * n));
    for (int i = 0; i < n * n; i++)
        rational_clear(&value[i]);
    return ok;
}

/* A rule for the centre with `count` sources and no weights yet. */
static rule *add_centre_rule(scheme_step *s, int count, long line)
{
    s->rules = calloc(1, sizeof *s->rules);
    if (!s->rules)
        return NULL;
    s->rule_count = 1;
    s->rules[0].at_centre = true;
    s->rules[0].count = count;
    s->rules[0].line = line;
    return &s->rules[0];
}

/* Bilinear refinement: of vertices, or of a dual net (its points are then the vertices of a mesh whose extraordinary
   face gets the mean of its corners). */
static status add_refine(scheme_reader *r, bool dual)
{
    scheme_step *s = add_step(r->z, dual ? MESH_DUAL : MESH_QUAD, MESH_QUAD, 2, dual ? 2 : 1);
    rational weight[3];
    bool ok = true;
    for (int i = 0; i < 3; i++) {
        rational_init(&weight[i]);
        ok = ok && rational_set_si(&weight[i], 1, i == 1 ? 1 : 2);
    }
    ok = ok && set_tensor_mask(&s->mask, dual ? -2 : -1, 3, weight);
    if (ok && dual) {
        rule *centre = add_centre_rule(s, 1, r->line->line);
        ok = centre != NULL;
        if (ok) {
            centre->sources[0].kind = SOURCE_ALL;
            centre->sources[0].point = (lattice){1, 1};
        }
    }
    for (int i = 0; i < 3; i++)
        rational_clear(&weight[i]);
    return ok ? STATUS_OK : STATUS_NO_MEMORY;
}

static status add_average(scheme_reader *r)
{
    scheme_step *s = add_step(r->z, MESH_QUAD, MESH_DUAL, 1, 0);
    rational weight[2];
    bool ok;
    if (!s)
        return reader_complain(r, "more than %s steps", "34");
    for (int i = 0; i < 2; i++)
        rational_init(&weight[i]);
    ok = rational_set_si(&weight[0], 1, 2) && rational_set_si(&weight[1], 1, 2) && set_tensor_mask(&s->mask, 0, 2, weight);
    for (int i = 0; i < 2; i++)
        rational_clear(&weight[i]);
    return ok ? STATUS_OK : STATUS_NO_MEMORY;
}

/* alpha itself, beta shared by the edge neighbours, the rest by the diagonal ones. */
static status set_smooth_mask(laurent *mask, const formula *alpha, const formula *beta, diagnostic *d)
{
    formula_point nowhere = {0, 0, 0};
    lattice point[9];
    rational value[9], rest, quarter;
    status s;
    bool ok = true;
    for (int i = 0; i < 9; i++) {
        point[i] = (lattice){i / 3 - 1, i % 3 - 1};
        rational_init(&value[i]);
    }
    rational_init(&rest);
    rational_init(&quarter);
    s = formula_exact_rational(&value[4], alpha, &nowhere, d);
    if (s == STATUS_OK)
        s = formula_exact_rational(&value[1], beta, &nowhere, d);
    if (s == STATUS_OK) {
        ok = rational_set_si(&rest, 1, 1) && rational_sub(&rest, &rest, &value[4]) && rational_sub(&rest, &rest, &value[1])
             && rational_set_si(&quarter, 1, 4) && rational_mul(&rest, &rest, &quarter) && rational_mul(&value[1], &value[1], &quarter);
        for (int i = 0; ok && i < 9; i++)
            ok = i == 4 || i == 1 || rational_set(&value[i], i % 2 ? &value[1] : &rest);
        ok = ok && laurent_set_terms(mask, point, value, 9);
    }
    for (int i = 0; i < 9; i++)
        rational_clear(&value[i]);
    rational_clear(&rest);
    rational_clear(&quarter);
    return ok ? s : STATUS_NO_MEMORY;
}

/* The next top-level comma or word `centre` from `at`, or the end of the line. */
static size_t find_break(const scheme_reader *r, size_t at, bool comma)
{
    int depth = 0;
    for (; at < r->line->length; at++) {
        const char *p = r->line->text + at;
        depth += (*p == '(') - (*p == ')');
        if (depth == 0 && comma && *p == ',')
            return at;
        if (depth == 0 && !comma && r->line->length - at >= 6 && !memcmp(p, "centre", 6) && !is_word_character(p[-1])
            && !is_word_character(p[6])) /* there are characters on both sides: `smooth` and the line end at least */
            return at;
    }
    return r->line->length;
}

/* ALPHA, BETA up to `end`. */
static status read_pair(formula **alpha, formula **beta, scheme_reader *r, size_t end, unsigned allowed)
{
    size_t comma = find_break(r, r->at, true);
    status s = reader_formula_until(alpha, r, comma < end ? comma : end, allowed);
    if (s != STATUS_OK)
        return s;
    if (!reader_take(r, ','))
        return reader_expected(r, "', BETA'");
    return reader_formula_until(beta, r, end, allowed);
}

/* Behind `smooth`: ALPHA, BETA [centre ALPHA, BETA].  Reads them again for each repetition: each step owns its own. */
static status add_smooth(scheme_reader *r)
{
    scheme_step *s = add_step(r->z, MESH_QUAD, MESH_QUAD, 1, 1);
    formula *alpha = NULL, *beta = NULL;
    size_t start = r->at, end = find_break(r, r->at, false);
    rule *centre;
    status result;
    if (!s)
        return reader_complain(r, "more than %s steps", "34");
    centre = add_centre_rule(s, 3, r->line->line);
    if (!centre)
        return STATUS_NO_MEMORY;
    centre->sources[0].kind = SOURCE_CENTRE;
    centre->sources[1].kind = centre->sources[2].kind = SOURCE_ALL;
    centre->sources[1].point = (lattice){1, 0};
    centre->sources[2].point = (lattice){1, 1};
    result = read_pair(&alpha, &beta, r, end, 0);
    if (result == STATUS_OK)
        result = set_smooth_mask(&s->mask, alpha, beta, r->complaint);
    formula_free(alpha);
    formula_free(beta);
    if (result != STATUS_OK)
        return result;
    if (!reader_take_word(r, "centre"))
        r->at = start; /* the same weights everywhere */
    return read_pair(&centre->sources[0].weight, &centre->sources[1].weight, r, r->line->length, FORMULA_ON_VALENCE);
}

/* repeat COUNT: smooth ... */
static status add_repeated(scheme_reader *r)
{
    formula_point nowhere = {0, 0, 0};
    formula *count = NULL;
    rational value;
    size_t colon = r->at, start;
    status s;
    while (colon < r->line->length && r->line->text[colon] != ':')
        colon++;
    if (colon == r->line->length)
        return reader_complain(r, "expected 'repeat COUNT: smooth ALPHA, BETA'%s, and there is no ':'", "");
    rational_init(&value);
    s = reader_formula_until(&count, r, colon, 0);
    if (s == STATUS_OK)
        s = formula_exact_rational(&value, count, &nowhere, r->complaint);
    formula_free(count);
    if (s == STATUS_OK && (!rational_is_integer(&value) || rational_sign(&value) < 0 || rational_cmp_si(&value, SCHEME_MAX_STEPS, 1) > 0))
        s = reader_complain(r, "expected a whole number of repetitions, at most %s", "34");
    if (s == STATUS_OK && (!reader_take(r, ':') || !reader_take_word(r, "smooth")))
        s = reader_expected(r, "': smooth ALPHA, BETA'");
    start = r->at;
    if (s == STATUS_OK && rational_is_zero(&value)) { /* read it all the same: a mistake is a mistake */
        s = add_smooth(r);
        scheme_drop_step(r->z);
    }
    for (long i = s == STATUS_OK ? (long)integer_get_si(&value.numerator) : 0; i > 0 && s == STATUS_OK; i--) {
        r->at = start;
        s = add_smooth(r);
    }
    r->at = s == STATUS_OK ? r->line->length : r->at;
    rational_clear(&value);
    return s;
}

/* average [when CONDITION] */
static status read_average(bool *average, scheme_reader *r)
{
    formula_point nowhere = {0, 0, 0};
    formula *condition = NULL;
    status s = STATUS_OK;
    *average = true;
    if (reader_take_word(r, "when")) {
        reader_skip_blank(r);
        s = formula_read_condition(&condition, r->line->text + r->at, r->line->length - r->at, r->line->line, r->line->column + r->at, &r->z->definitions, 0, r->complaint);
        r->at = r->line->length;
        if (s == STATUS_OK)
            s = reader_count(r, condition);
        if (s == STATUS_OK)
            s = formula_condition(average, condition, &nowhere, r->complaint);
        formula_free(condition);
    }
    return s == STATUS_OK ? reader_expect_end(r) : s;
}

/* The product of the masks: the first step refines, the others do not. */
static status compose_masks(scheme_reader *r)
{
    scheme *z = r->z;
    if (!laurent_set(&z->mask, &z->steps[0].mask))
        return STATUS_NO_MEMORY;
    for (int i = 1; i < z->step_count; i++) {
        if (integer_bits(&z->mask.denominator) + integer_bits(&z->steps[i].mask.denominator) > EXACT_MAX_BITS)
            return reader_complain(r, "the weights of the composed mask have a common denominator of more than %s bits", "16384");
        if (!laurent_mul(&z->mask, &z->steps[i].mask, &z->mask))
            return STATUS_NO_MEMORY;
    }
    return STATUS_OK;
}

/* Whether the first step refines vertices or a dual net is known only at the end of the block. */
static status mend_refine(scheme_reader *r)
{
    scheme *z = r->z;
    scheme_step first = z->steps[0];
    int count = z->step_count;
    status s;
    laurent_clear(&first.mask);
    z->step_count = 0;
    s = add_refine(r, true);
    z->step_count = count;
    z->mesh = MESH_DUAL;
    return s;
}

/* The current line begins with `compose`. */
status read_compose(scheme_reader *r)
{
    bool average = false, last = false;
    status s = reader_expect_end(r);
    if (s == STATUS_OK && r->z->mesh != MESH_QUAD)
        s = reader_complain(r, "'compose' needs 'mesh quad' (with 'average' the control net is dual%s)", "");
    reader_next_line(r);
    if (s == STATUS_OK && !reader_take_word(r, "refine"))
        s = reader_expected(r, "'refine'");
    if (s == STATUS_OK)
        s = reader_expect_end(r);
    if (s == STATUS_OK)
        s = add_refine(r, false);
    while (s == STATUS_OK) {
        reader_next_line(r);
        if (reader_take_word(r, "end"))
            break;
        if (last)
            return reader_expected(r, "'end' behind 'average'");
        if (reader_take_word(r, "smooth"))
            s = add_smooth(r);
        else if (reader_take_word(r, "repeat"))
            s = add_repeated(r);
        else if (reader_take_word(r, "average")) {
            last = true;
            s = read_average(&average, r);
            if (s == STATUS_OK && average)
                s = add_average(r);
        } else
            s = reader_expected(r, "'smooth', 'repeat', 'average' or 'end'");
    }
    if (s == STATUS_OK)
        s = reader_expect_end(r);
    if (s == STATUS_OK && average)
        s = mend_refine(r);
    if (s == STATUS_OK)
        s = compose_masks(r);
    r->z->mirror_symmetric = true;
    return s == STATUS_OK ? check_mask(r, &r->z->mask) : s;
}
