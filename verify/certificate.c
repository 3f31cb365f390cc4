/* certificate.c: writing, and reading what was written. */
#include "certificate.h"

#include "sha256.h"

#include <stdlib.h>
#include <string.h>

/* ---- writing ---- */

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

static void write_choices(buffer *z, const choices *c)
{
    const eigenpair_choice *e = &c->eigenpair;
    buffer_print(z, "claim c1\nvalence %ld\ngrid %ld\n", c->valence, c->grid);
    buffer_print(z, "contraction %d %d %d\npivot %d\n", c->contraction[0], c->contraction[1], c->contraction[2], e->pivot + 1);
    write_integers(z, "eigenvalue", &e->approximation[e->n - 1], 1);
    write_integers(z, "eigenvector", e->approximation, e->n - 1);
    write_integers(z, "radius", &e->radius, 1);
    for (int i = 0; i < e->n; i++)
        write_integers(z, "inverse", &e->inverse[i * e->n], e->n);
    buffer_print(z, "power");
    for (long m = 0; m <= c->valence / 2; m++)
        buffer_print(z, " %d", c->power[m]);
    buffer_print(z, "\nhalfplane");
    write_long_hexadecimal(z, c->normal[0]);
    write_long_hexadecimal(z, c->normal[1]);
    buffer_print(z, "\nregularity %s\nboundary %s\n", c->regularity.letter ? c->regularity.letter : "", c->boundary.letter ? c->boundary.letter : "");
}

static long count_lines(const char *bytes, size_t length)
{
    long lines = 0;
    for (size_t i = 0; i < length; i++)
        lines += bytes[i] == '\n';
    return lines;
}

void certificate_write(buffer *z, const scheme *s, const choices *c)
{
    size_t start = z->length;
    char digest[65];
    buffer_print(z, "smoothcert-certificate 0\nscheme %ld\n", count_lines(s->source.canonical, s->source.length));
    buffer_append(z, s->source.canonical, s->source.length);
    write_choices(z, c);
    if (z->failed)
        return;
    buffer_print(z, "records %ld\n", count_lines(z->bytes + start, z->length - start));
    if (z->failed)
        return;
    sha256_hex(digest, z->bytes + start, z->length - start);
    buffer_print(z, "sha256 %s\n", digest);
}

/* ---- reading ---- */

/* Reads word after word; whatever the words leave open is settled by comparing with what would be written. */
typedef struct {
    const char *at, *end;
    bool failed; /* malformed */
    bool no_memory;
} reader;

/* The next word, separated by one blank or line end; empty at the end. */
static size_t next_word(reader *r, const char **word)
{
    *word = r->at;
    while (r->at < r->end && *r->at != ' ' && *r->at != '\n')
        r->at++;
    size_t length = (size_t)(r->at - *word);
    if (r->at < r->end)
        r->at++;
    return length;
}

static void expect(reader *r, const char *name)
{
    const char *word;
    size_t length = next_word(r, &word);
    if (length != strlen(name) || memcmp(word, name, length))
        r->failed = true;
}

static void read_integer(reader *r, integer *z, int base)
{
    const char *word;
    size_t length = next_word(r, &word);
    if (r->failed || length == 0 || length > 4096) {
        r->failed = true;
        return;
    }
    switch (integer_set_str(z, word, length, base)) {
    case INTEGER_TEXT_OK:
        break;
    case INTEGER_TEXT_MALFORMED:
        r->failed = true;
        break;
    default:
        r->no_memory = r->failed = true;
    }
}

static long read_long(reader *r, int base, long low, long high)
{
    integer z;
    long v = low;
    integer_init(&z);
    read_integer(r, &z, base);
    if (!r->failed && integer_cmp_si(&z, low) >= 0 && integer_cmp_si(&z, high) <= 0)
        v = (long)integer_get_si(&z);
    else
        r->failed = true;
    integer_clear(&z);
    return v;
}

static void read_tree(reader *r, tree_word *z, const char *name)
{
    const char *word;
    size_t length;
    expect(r, name);
    length = next_word(r, &word);
    for (size_t i = 0; !r->failed && i < length; i++) {
        if (word[i] != '0' && word[i] != '1')
            r->failed = true;
        else if (!tree_put(z, word[i]))
            r->no_memory = r->failed = true;
    }
}

/* The order of the block follows from the number of words of the line. */
static int count_words(const reader *r)
{
    int count = 0;
    for (const char *p = r->at; p < r->end && *p != '\n'; p++)
        count += *p == ' ';
    return count;
}

static void read_eigenpair(reader *r, eigenpair_choice *e, long grid)
{
    integer eigenvalue;
    int n, pivot;
    expect(r, "pivot");
    pivot = (int)read_long(r, 10, 1, 512);
    integer_init(&eigenvalue);
    expect(r, "eigenvalue");
    read_integer(r, &eigenvalue, 16);
    n = count_words(r) + 1;
    if (n < pivot || n > 512)
        r->failed = true;
    if (!r->failed && !eigenpair_choice_make(e, n, grid))
        r->no_memory = r->failed = true;
    e->pivot = pivot - 1;
    expect(r, "eigenvector");
    for (int i = 0; !r->failed && i < n - 1; i++)
        read_integer(r, &e->approximation[i], 16);
    if (!r->failed)
        integer_swap(&e->approximation[n - 1], &eigenvalue);
    expect(r, "radius");
    read_integer(r, &e->radius, 16);
    if (integer_sign(&e->radius) <= 0)
        r->failed = true;
    for (int i = 0; !r->failed && i < n; i++) {
        expect(r, "inverse");
        for (int j = 0; !r->failed && j < n; j++)
            read_integer(r, &e->inverse[i * n + j], 16);
    }
    integer_clear(&eigenvalue);
}

static void read_choices(reader *r, choices *c)
{
    long normal_limit = 1L << CHOICES_NORMAL_BITS, total = 0;
    long valence, grid;
    expect(r, "claim");
    expect(r, "c1");
    expect(r, "valence");
    valence = read_long(r, 10, CHOICES_MIN_VALENCE, CHOICES_MAX_VALENCE);
    expect(r, "grid");
    grid = read_long(r, 10, CHOICES_MIN_GRID, CHOICES_MAX_GRID);
    if (r->failed)
        return;
    if (!choices_make(c, valence, grid)) {
        r->no_memory = r->failed = true;
        return;
    }
    expect(r, "contraction");
    for (int i = 0; i < 3; i++)
        c->contraction[i] = (int)read_long(r, 10, 1, 10);
    read_eigenpair(r, &c->eigenpair, grid);
    expect(r, "power");
    for (long m = 0; m <= valence / 2; m++) {
        c->power[m] = (int)read_long(r, 10, 0, CHOICES_MAX_POWER);
        total += c->power[m];
    }
    if (total > CHOICES_MAX_TOTAL_POWER)
        r->failed = true;
    expect(r, "halfplane");
    for (int i = 0; i < 2; i++)
        c->normal[i] = read_long(r, 16, 1 - normal_limit, normal_limit - 1);
    read_tree(r, &c->regularity, "regularity");
    read_tree(r, &c->boundary, "boundary");
}

/* The first line, from 1, in which the texts differ; 0 if they are equal. */
static long first_difference(const char *x, size_t m, const char *y, size_t n)
{
    long line = 1;
    for (size_t i = 0; i < m && i < n; i++) {
        if (x[i] != y[i])
            return line;
        line += x[i] == '\n';
    }
    return m == n ? 0 : line;
}

bool certificate_read(choices *c, long *line, const scheme *s, const char *bytes, size_t length)
{
    reader r = {bytes, bytes + length, false, false};
    buffer again;
    const char *word;
    expect(&r, "smoothcert-certificate");
    expect(&r, "0");
    expect(&r, "scheme");
    next_word(&r, &word);
    if ((size_t)(r.end - r.at) >= s->source.length)
        r.at += s->source.length; /* compared below */
    read_choices(&r, c);
    *line = count_lines(bytes, (size_t)(r.at - bytes)) + 1;
    if (r.failed)
        return !r.no_memory;
    buffer_init(&again);
    certificate_write(&again, s, c);
    if (again.failed)
        r.no_memory = true;
    else
        *line = first_difference(bytes, length, again.bytes, again.length);
    buffer_clear(&again);
    return !r.no_memory;
}
