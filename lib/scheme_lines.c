/* scheme_lines.c: words, points and formulas in the lines of a scheme file, with their places. */
#include "scheme_reader.h"

#include <stdio.h>
#include <string.h>

void reader_next_line(scheme_reader *r)
{
    const source_text *t = &r->z->source;
    r->line = r->next < t->lines ? &t->line[r->next++] : NULL;
    r->at = 0;
}

void reader_skip_blank(scheme_reader *r)
{
    if (r->line && r->at < r->line->length && r->line->text[r->at] == ' ')
        r->at++;
}

/* A complaint about the whole current line. */
status reader_complain(const scheme_reader *r, const char *format, const char *what)
{
    return diagnostic_set(r->complaint, r->line->line, r->line->column[0], format, what);
}

/* "expected WHAT, found ..." at the current place. */
status reader_expected(scheme_reader *r, const char *what)
{
    size_t length;
    const char *start;
    reader_skip_blank(r);
    if (!r->line)
        return diagnostic_set(r->complaint, r->z->source.last_line + 1, 1, "expected %s, but the file ends", what);
    if (r->at >= r->line->length)
        return diagnostic_set(r->complaint, r->line->line, r->line->column[r->line->length], "expected %s, but the line ends", what);
    start = r->line->text + r->at;
    length = strcspn(start, " \n");
    return diagnostic_set(r->complaint, r->line->line, r->line->column[r->at], "expected %s, found '%.*s'", what,
                          (int)(length > 40 ? 40 : length), start);
}

bool reader_at_end(scheme_reader *r)
{
    reader_skip_blank(r);
    return r->at >= r->line->length;
}

/* Is the next word this one?  Then steps over it. */
bool reader_take_word(scheme_reader *r, const char *word)
{
    size_t length = strlen(word);
    reader_skip_blank(r);
    if (!r->line || r->line->length - r->at < length || memcmp(r->line->text + r->at, word, length))
        return false;
    if (r->at + length < r->line->length && is_word_character(r->line->text[r->at + length]))
        return false; /* a longer word */
    r->at += length;
    return true;
}

bool reader_take(scheme_reader *r, char c)
{
    reader_skip_blank(r);
    if (!r->line || r->at >= r->line->length || r->line->text[r->at] != c)
        return false;
    r->at++;
    return true;
}

status reader_expect_end(scheme_reader *r)
{
    return reader_at_end(r) ? STATUS_OK : reader_expected(r, "the end of the line");
}

/* A whole number of one or two digits, or for dual meshes an odd number of halves; *twice is twice its value. */
static status read_coordinate(int *twice, bool dual, scheme_reader *r)
{
    size_t start = (reader_skip_blank(r), r->at);
    bool negative = reader_take(r, '-');
    int digits = 0, value = 0;
    while (digits < 3 && r->at < r->line->length && is_digit(r->line->text[r->at])) {
        value = 10 * value + (r->line->text[r->at++] - '0');
        digits++;
    }
    if (digits != 1 && digits != 2) {
        r->at = start;
        return reader_expected(r, "a coordinate of one or two digits");
    }
    if (dual && (value % 2 == 0 || r->line->length - r->at < 2 || memcmp(r->line->text + r->at, "/2", 2))) {
        r->at = start;
        return reader_expected(r, "halves such as 1/2 or -3/2 (points of dual meshes lie in the middle of squares)");
    }
    if (dual)
        r->at += 2;
    *twice = (negative ? -1 : 1) * (dual ? value : 2 * value);
    return STATUS_OK;
}

/* Twice the coordinates of a point. */
status reader_point(lattice *twice, mesh_kind mesh, scheme_reader *r)
{
    status s;
    if (!reader_take(r, '('))
        return reader_expected(r, mesh == MESH_DUAL ? "a point such as (1/2,1/2)" : "a point such as (1,0)");
    s = read_coordinate(&twice->a, mesh == MESH_DUAL, r);
    if (s != STATUS_OK)
        return s;
    if (!reader_take(r, ','))
        return reader_expected(r, "','");
    s = read_coordinate(&twice->b, mesh == MESH_DUAL, r);
    if (s != STATUS_OK)
        return s;
    return reader_take(r, ')') ? STATUS_OK : reader_expected(r, "')'");
}

/* A complaint about the label p of a point, which says what its name is if it lies in a sector nearby. */
static status expected_in_sector(lattice p, mesh_kind mesh, scheme_reader *r)
{
    char text[200];
    int turns, n = snprintf(text, sizeof text, "%s", mesh == MESH_DUAL ? "a point of the sector: both coordinates at least 1/2 and at most 31/2"
                                                                       : "a point of the sector: (a,b) with a >= 1, b >= 0, at most 16 rings out");
    bool other = !mesh_in_sector(mesh, p.a, p.b) && !mesh_is_centre(mesh, p.a, p.b) && mesh_reduce(mesh, false, &p.a, &p.b, &turns);
    if (other && mesh == MESH_DUAL)
        snprintf(text + n, sizeof text - (size_t)n, " (this one is (%d/2,%d/2) of sector %d)", 2 * p.a - 1, 2 * p.b - 1, turns);
    else if (other)
        snprintf(text + n, sizeof text - (size_t)n, " (this one is (%d,%d) of sector %d)", p.a, p.b, turns);
    return reader_expected(r, text);
}

/* The label of a point of the sector, from twice its coordinates: (a - 1/2) for dual meshes. */
status reader_sector_point(lattice *p, mesh_kind mesh, scheme_reader *r)
{
    size_t place;
    status s;
    reader_skip_blank(r);
    place = r->at;
    s = reader_point(p, mesh, r);
    if (s != STATUS_OK)
        return s;
    p->a = mesh == MESH_DUAL ? (p->a + 1) / 2 : p->a / 2;
    p->b = mesh == MESH_DUAL ? (p->b + 1) / 2 : p->b / 2;
    if (mesh_in_sector(mesh, p->a, p->b) && mesh_ring(mesh, p->a, p->b) <= 2 * SCHEME_MAX_REACH)
        return STATUS_OK;
    r->at = place;
    return expected_in_sector(*p, mesh, r);
}

status reader_count(scheme_reader *r, const formula *f)
{
    r->operations += f->size;
    if (r->operations > SCHEME_MAX_OPERATIONS)
        return diagnostic_set(r->complaint, f->line, f->column, "with this one the formulas of the file have more than %d operations, definitions written out", SCHEME_MAX_OPERATIONS);
    return STATUS_OK;
}

/* The formula that fills the line up to `end`. */
status reader_formula_until(formula **f, scheme_reader *r, size_t end, unsigned allowed)
{
    reader_skip_blank(r);
    if (r->at >= end)
        return reader_expected(r, "a formula");
    status s = formula_read(f, r->line->text + r->at, end - r->at, r->line->line, r->line->column + r->at, &r->z->definitions, allowed, r->complaint);
    r->at = end;
    return s == STATUS_OK ? reader_count(r, *f) : s;
}

status reader_formula(formula **f, scheme_reader *r, unsigned allowed)
{
    return reader_formula_until(f, r, r->line->length, allowed);
}
