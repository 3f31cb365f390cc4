/* certificate.c: writing. */
#include "certificate.h"

#include "certificate_exact.h"
#include "sha256.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static void write_integers(buffer *z, const char *name, const integer *value, int count)
{
    buffer_print(z, "%s", name);
    for (int i = 0; i < count; i++) {
        buffer_print(z, " ");
        buffer_hexadecimal(z, &value[i]);
    }
    buffer_print(z, "\n");
}

static void write_long_hexadecimal(buffer *z, long v)
{
    buffer_print(z, v < 0 ? " -%lx" : " %lx", v < 0 ? 0UL - (unsigned long)v : (unsigned long)v);
}

static const char *letters(const tree_word *w)
{
    return w->letter ? w->letter : "";
}

static void write_evidence(buffer *z, const choices *c)
{
    if (c->claim == CLAIM_C1) {
        buffer_print(z, "halfplane");
        write_long_hexadecimal(z, c->normal[0]);
        write_long_hexadecimal(z, c->normal[1]);
        buffer_print(z, "\nregularity %s\n", letters(&c->regularity));
    }
    if (claim_has_boundary(c->claim))
        buffer_print(z, "boundary %s\n", letters(&c->boundary));
    for (int i = 0; i < claim_witnesses(c->claim); i++)
        buffer_print(z, "witness %d %s\n", c->witness[i].element, c->witness[i].depth ? c->witness[i].path : "-");
}

/* The range is that of pairs for several valences. */
static void write_eigenpair(buffer *z, const eigenpair_choice *e)
{
    int values = e->complex_form ? 2 : 1, others = e->n - values;
    buffer_print(z, "pivot %d\n", e->pivot + 1);
    write_integers(z, "eigenvalue", e->approximation + others, values);
    write_integers(z, "eigenvector", e->approximation, others);
    write_integers(z, "radius", &e->radius, 1);
    if (integer_sign(&e->range) > 0)
        write_integers(z, "range", &e->range, 1);
    for (int i = 0; i < e->n; i++)
        write_integers(z, "inverse", &e->inverse[i * e->n], e->n);
}

static void write_form(buffer *z, const choices *c, const eigenpair_choice *e, bool plain)
{
    buffer_print(z, "form %s\n", plain ? "plain" : e->complex_form ? "complex" : "real");
    write_eigenpair(z, e);
    if (e->complex_form)
        write_integers(z, "modulus", &c->modulus, 1);
}

static void write_window(buffer *z, const window_choice *w)
{
    buffer_print(z, "form real\nwindow %" PRIx64 "\n", w->start);
    write_integers(z, "bound", &w->bound, 1);
    for (size_t i = 0; i < w->count; i++) {
        buffer_print(z, "wave %" PRIx64 " %d\n", w->wave[i].q, w->wave[i].power);
        write_eigenpair(z, &w->wave[i].eigenpair);
        buffer_print(z, "boundary %s\n", letters(&w->wave[i].boundary));
    }
}

static void write_graded(buffer *z, const choices *c)
{
    buffer_print(z, "form graded\nunit %ld\ndegree %d\ngrades", c->graded.unit, c->graded.degree);
    for (int i = 0; i < c->graded.n; i++)
        buffer_print(z, " %d", c->graded.grade[i]);
    buffer_print(z, "\n");
    write_eigenpair(z, &c->eigenpair);
}

/* "7", "8 20", "21 inf" */
static void write_range(buffer *z, const char *name, long first, long last)
{
    buffer_print(z, "%s %ld", name, first);
    if (last == VALENCES_UNBOUNDED)
        buffer_print(z, " inf");
    else
        buffer_print(z, " %ld", last);
}

static void write_spectrum(buffer *z, const choices *c)
{
    if (c->has_limit) {
        buffer_print(z, "limit %d\n", c->limit.power);
        write_eigenpair(z, &c->limit.eigenpair);
    }
    for (size_t i = 0; i < c->blocks.count; i++)
        buffer_print(z, "block %ld %ld %d\n", c->blocks.box[i].m.first, c->blocks.box[i].m.last, c->blocks.box[i].power);
    for (size_t i = 0; i < c->rise.count; i++) {
        buffer_print(z, "rise %" PRIx64 " %d\n", c->rise.box[i].q, c->rise.box[i].power);
        write_eigenpair(z, &c->rise.box[i].eigenpair);
    }
    for (size_t i = 0; i < c->spans.count; i++) {
        write_range(z, "cover", c->spans.box[i].m.first, c->spans.box[i].m.last);
        buffer_print(z, " %" PRIx64 " %d\n", c->spans.box[i].q, c->spans.box[i].power);
    }
}

static void write_choices(buffer *z, const choices *c)
{
    buffer_print(z, "claim %s\n", c->claim == CLAIM_C1 ? "c1" : "not-c1");
    if (is_one_valence(c->k))
        buffer_print(z, "valence %ld", c->k.first);
    else
        write_range(z, "valence", c->k.first, c->k.last);
    buffer_print(z, "\ngrid %ld\n", c->grid);
    buffer_print(z, "contraction %d %d %d\n", c->contraction[0], c->contraction[1], c->contraction[2]);
    if (c->plainly_regular)
        return;
    buffer_print(z, "stability");
    for (int i = 0; i < 3; i++)
        buffer_print(z, " %d %" PRId64, c->stability[i].power, c->stability[i].bound);
    buffer_print(z, "\n");
    if (c->claim != CLAIM_C1)
        buffer_print(z, "reason %s\n", claim_name(c->claim));
    if (c->claim != CLAIM_C1 && !claim_is_exact(c->claim))
        c->claim == CLAIM_WINDOW ? buffer_print(z, "frequency window\n") : buffer_print(z, "frequency %ld\n", c->frequency);
    if (claim_is_exact(c->claim))
        certificate_write_exact(z, c);
    else if (c->claim == CLAIM_WINDOW)
        write_window(z, &c->window);
    else if (c->claim == CLAIM_GRADED)
        write_graded(z, c);
    else
        write_form(z, c, &c->eigenpair, c->frequency == 0 && !c->pair);
    if (c->claim == CLAIM_REAL) {
        buffer_print(z, "second %ld\n", c->second_frequency);
        write_form(z, c, &c->second, c->second_frequency == 0);
    }
    write_spectrum(z, c);
    write_evidence(z, c);
}

void certificate_write(buffer *z, const scheme *s, const choices *c)
{
    size_t start = z->length;
    char digest[65];
    buffer_print(z, "smoothcert-certificate 1\nscheme %ld\n", text_lines(s->text, s->text_length));
    buffer_append(z, s->text, s->text_length);
    write_choices(z, c);
    if (z->failed)
        return;
    buffer_print(z, "records %ld\n", text_lines(z->bytes + start, z->length - start));
    if (z->failed)
        return;
    sha256_hex(digest, z->bytes + start, z->length - start);
    buffer_print(z, "sha256 %s\n", digest);
}
