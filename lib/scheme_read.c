/* scheme_read.c: the head of a scheme file, and its parts in order. */
#include "scheme_reader.h"

static status read_name(scheme_reader *r)
{
    size_t n = 0;
    reader_next_line(r);
    if (!reader_take_word(r, "scheme"))
        return reader_expected(r, "'scheme NAME' as the first statement");
    reader_skip_blank(r);
    size_t start = r->at;
    while (r->at < r->line->length && n <= SCHEME_NAME_MAX) {
        char c = r->line->text[r->at];
        if (!is_letter(c) && (n == 0 || !(is_digit(c) || c == '-')))
            break;
        if (n < SCHEME_NAME_MAX)
            r->z->name[n] = c;
        n++;
        r->at++;
    }
    if (n > SCHEME_NAME_MAX)
        r->at = start;
    if (n == 0 || n > SCHEME_NAME_MAX || !reader_at_end(r))
        return reader_expected(r, "a name (a lower-case letter, then at most 63 lower-case letters, digits and '-')");
    r->z->name[n] = '\0';
    return STATUS_OK;
}

static status read_mesh(scheme_reader *r)
{
    reader_next_line(r);
    if (!reader_take_word(r, "mesh"))
        return reader_expected(r, "'mesh triangle', 'mesh quad' or 'mesh quad-dual'");
    if (reader_take_word(r, "triangle"))
        r->z->mesh = MESH_TRIANGLE;
    else if (reader_take_word(r, "quad-dual"))
        r->z->mesh = MESH_DUAL;
    else if (reader_take_word(r, "quad"))
        r->z->mesh = MESH_QUAD;
    else
        return reader_expected(r, "'triangle', 'quad' or 'quad-dual'");
    return reader_expect_end(r);
}

static status read_dilation(scheme_reader *r)
{
    reader_next_line(r);
    if (!reader_take_word(r, "dilation") || !reader_take(r, '2'))
        return reader_expected(r, "'dilation 2' (other dilations are reserved for later)");
    return reader_expect_end(r);
}

static status read_vertices(scheme_reader *r)
{
    reader_next_line(r);
    if (!reader_take_word(r, "vertices"))
        return reader_expected(r, "'vertices interior'");
    if (reader_take_word(r, "boundary") || reader_take_word(r, "crease"))
        return reader_complain(r, "'vertices %s' are reserved for a later version; this one covers interior vertices", "boundary' and 'vertices crease");
    if (!reader_take_word(r, "interior"))
        return reader_expected(r, "'interior'");
    return reader_expect_end(r);
}

static status read_body(scheme_reader *r)
{
    status s;
    if (reader_take_word(r, "compose")) {
        s = read_compose(r);
        reader_next_line(r);
        return s;
    }
    if (!reader_take_word(r, "mask"))
        return reader_expected(r, "'parameter', 'let', 'mask' or 'compose'");
    s = read_mask(r);
    for (reader_next_line(r); s == STATUS_OK && reader_take_word(r, "rule"); reader_next_line(r))
        s = read_rule(r);
    if (s == STATUS_OK && r->z->mirror_symmetric) /* the mask is */
        s = find_symmetry(&r->z->mirror_symmetric, &r->z->steps[0], r->z->mesh);
    return s;
}

status scheme_read(scheme *z, const char *bytes, size_t length, const scheme_settings *settings, diagnostic *d)
{
    scheme_reader r = {z, 0, NULL, 0, 0, settings, d};
    status s = text_read(&z->source, bytes, length, d);
    if (s != STATUS_OK || (s = read_name(&r)) != STATUS_OK || (s = read_mesh(&r)) != STATUS_OK || (s = read_dilation(&r)) != STATUS_OK
        || (s = read_vertices(&r)) != STATUS_OK || (s = read_definitions(&r)) != STATUS_OK || (s = read_body(&r)) != STATUS_OK)
        return s;
    return r.line ? reader_expected(&r, "nothing more") : scheme_set_text(&r);
}
