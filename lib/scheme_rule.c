/* scheme_rule.c: rules at and near the extraordinary place. */
#include "scheme_reader.h"

#include <stdlib.h>
#include <string.h>

/* WEIGHT: `rest`, or a formula. */
static status read_weight(formula **f, scheme_reader *r, unsigned allowed)
{
    if (reader_take_word(r, "rest"))
        return reader_expect_end(r);
    return reader_formula(f, r, allowed);
}

/* Behind `@`: the variable j, or a whole number. */
static status read_offset(source *s, scheme_reader *r)
{
    bool negative;
    int digits = 0;
    reader_skip_blank(r);
    size_t start = r->at;
    if (reader_take_word(r, "j")) {
        s->kind = SOURCE_SECTORS;
        return STATUS_OK;
    }
    negative = reader_take(r, '-');
    while (r->at < r->line->length && is_digit(r->line->text[r->at]) && digits < 4) {
        s->offset = 10 * s->offset + (r->line->text[r->at++] - '0');
        digits++;
    }
    s->offset = negative ? -s->offset : s->offset;
    if (digits >= 1 && digits <= 3)
        return STATUS_OK;
    r->at = start;
    return reader_expected(r, "j, or a whole number of sectors with at most three digits");
}

/* Behind `spectrum`: a formula in k and m, or two with a comma between: real and imaginary part. */
static status read_spectrum(source *s, scheme_reader *r)
{
    unsigned allowed = FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY;
    size_t comma = r->at;
    int depth = 0;
    status result;
    while (comma < r->line->length && (depth > 0 || r->line->text[comma] != ',')) {
        depth += (r->line->text[comma] == '(') - (r->line->text[comma] == ')');
        comma++;
    }
    result = reader_formula_until(&s->weight, r, comma, allowed);
    if (result == STATUS_OK && reader_take(r, ','))
        result = reader_formula(&s->imaginary, r, allowed);
    return result;
}

static status read_source(source *s, scheme_reader *r)
{
    mesh_kind mesh = r->z->mesh;
    unsigned allowed = FORMULA_ON_VALENCE;
    status result;
    memset(s, 0, sizeof *s);
    if (reader_take_word(r, "centre")) {
        if (mesh == MESH_DUAL)
            return reader_complain(r, "a %s mesh has no point in its centre", "dual");
        s->kind = SOURCE_CENTRE;
        return read_weight(&s->weight, r, allowed);
    }
    s->kind = reader_take_word(r, "all") ? SOURCE_ALL : SOURCE_POINT;
    reader_skip_blank(r);
    if (s->kind == SOURCE_POINT && (reader_at_end(r) || r->line->text[r->at] != '('))
        return reader_expected(r, mesh == MESH_DUAL ? "'all', a point such as (1/2,1/2), or 'end'" : "'centre', 'all', a point such as (1,0), or 'end'");
    result = reader_sector_point(&s->point, mesh, r);
    if (result != STATUS_OK)
        return result;
    if (s->kind == SOURCE_ALL && (reader_skip_blank(r), r->at < r->line->length) && r->line->text[r->at] == '@')
        return reader_expected(r, "a weight ('all' takes the points of all sectors)");
    if (s->kind == SOURCE_POINT && reader_take_word(r, "spectrum")) {
        s->kind = SOURCE_SPECTRUM;
        return read_spectrum(s, r);
    }
    if (s->kind == SOURCE_POINT && reader_take(r, '@')) {
        result = read_offset(s, r);
        if (result != STATUS_OK)
            return result;
    }
    if (s->kind == SOURCE_SECTORS)
        allowed |= FORMULA_ON_SECTOR;
    result = read_weight(&s->weight, r, allowed);
    if (result == STATUS_OK && s->kind == SOURCE_SECTORS && !s->weight)
        return reader_complain(r, "%s cannot be the weights of all sectors; give it to another point", "'rest'");
    return result;
}

/* Sums to 1 exactly: one weight is `rest`; if none is, then the value of the one spectrum at m = 0 is. */
static status check_rest(rule *z, const scheme_reader *r)
{
    int rests = 0, spectra = 0;
    for (int i = 0; i < z->count; i++) {
        spectra += z->sources[i].kind == SOURCE_SPECTRUM;
        rests += !z->sources[i].weight;
    }
    z->spectrum_takes_rest = rests == 0 && spectra == 1;
    if (rests == 1 || z->spectrum_takes_rest)
        return STATUS_OK;
    return reader_complain(r, "exactly one weight of a rule must be %s, so that they sum to 1 exactly", "'rest'");
}

/* Behind the target: nothing, or `when CONDITION`. */
static status read_when(rule *z, scheme_reader *r)
{
    if (reader_at_end(r))
        return STATUS_OK;
    if (!reader_take_word(r, "when"))
        return reader_expected(r, "'when' or the end of the line");
    reader_skip_blank(r);
    status s = formula_read_condition(&z->condition, r->line->text + r->at, r->line->length - r->at, r->line->line, r->line->column + r->at,
                                      &r->z->definitions, FORMULA_ON_VALENCE, r->complaint);
    r->at = r->line->length;
    return s == STATUS_OK ? reader_count(r, z->condition) : s;
}

static status read_rule_body(rule *z, scheme_reader *r)
{
    status s = STATUS_OK;
    z->line = r->line->line;
    if (reader_take_word(r, "centre"))
        z->at_centre = true;
    else if (reader_at_end(r) || r->line->text[r->at] != '(')
        return reader_expected(r, r->z->mesh == MESH_DUAL ? "a point such as (1/2,1/2)" : "'centre' or a point such as (1,0)");
    else
        s = reader_sector_point(&z->point, r->z->mesh, r);
    if (s == STATUS_OK && z->at_centre && r->z->mesh == MESH_DUAL)
        s = reader_complain(r, "a %s mesh has no point in its centre", "dual");
    if (s == STATUS_OK)
        s = read_when(z, r);
    while (s == STATUS_OK) {
        reader_next_line(r);
        if (!r->line)
            return reader_expected(r, "a source with its weight, or 'end'");
        if (reader_take_word(r, "end"))
            break;
        if (z->count == SCHEME_MAX_SOURCES)
            return reader_complain(r, "a rule may have %s sources at most", "32");
        s = read_source(&z->sources[z->count], r);
        if (s == STATUS_OK && z->at_centre && z->sources[z->count].kind > SOURCE_ALL) /* a single sector would turn nets of one frequency into others */
            s = reader_complain(r, "a rule for the centre must treat all sectors alike: write %s, with the weight of all of them together", "'all' in front of the point");
        z->count++; /* also after a complaint: its formulas are freed with the rule */
    }
    if (s == STATUS_OK)
        s = reader_expect_end(r);
    return s == STATUS_OK ? check_rest(z, r) : s;
}

/* The current line begins with `rule`. */
status read_rule(scheme_reader *r)
{
    scheme_step *step = &r->z->steps[0];
    rule *grown;
    if (step->rule_count == SCHEME_MAX_RULES)
        return reader_complain(r, "a scheme may have %s rules at most", "16");
    grown = realloc(step->rules, (size_t)(step->rule_count + 1) * sizeof *grown);
    if (!grown)
        return STATUS_NO_MEMORY;
    step->rules = grown;
    memset(&step->rules[step->rule_count], 0, sizeof *grown);
    return read_rule_body(&step->rules[step->rule_count++], r);
}
