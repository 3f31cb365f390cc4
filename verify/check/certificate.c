/* Reading certificates: section 1 of certificate.md, line by line. */

#include "certificate.h"

#include "answer.h"
#include "sha256.h"

#include <stdlib.h>
#include <string.h>

enum {
    MIN_VALENCE = 3, MAX_VALENCE = 4096,
    MIN_GRID = 64, MAX_GRID = 8192, BITS_ABOVE_GRID = 64,
    MAX_CONTRACTION = 10, MAX_POWER = 10000, MAX_TOTAL_POWER = 200000,
    NORMAL_BITS = 32, INVERSE_BITS_LIMIT = 96,
    MAX_ELEMENTS = 1000000,
    MAX_DECIMAL = 9                                /* digits; all limits have less */
};

/* A record: one line, whose tokens are taken from the left. */
struct record {
    const struct certificate *c;
    const char *name;
    int line;
    const char *at, *end;
};

/* Lines and tokens
 * ---------------- */

/* The next line: printable ASCII, no blank at its ends, no two in a row. */
static void next_line(struct record *out, struct certificate *c)
{
    out->c = c;
    out->name = "line";
    out->line = c->line;
    out->at = c->next;
    if (c->next == c->end)
        rejected(c->file, c->line, "the file ends too early");
    for (out->end = c->next; out->end < c->end && *out->end != '\n'; out->end++) {
        const char *p = out->end;
        bool last = p + 1 == c->end || p[1] == '\n';

        if (*p < 32 || *p > 126)
            rejected(c->file, c->line, "expected printable ASCII");
        if (*p == ' ' && (p == out->at || last || p[1] == ' '))
            rejected(c->file, c->line, "expected single blanks between tokens only");
    }
    if (out->end == c->end)
        rejected(c->file, c->line, "expected a line feed at the end");
    c->next = out->end + 1;
    c->line++;
}

/* The next token of the line; there must be one. */
static const char *next_token(size_t *size, struct record *r)
{
    const char *token = r->at;

    if (r->at == r->end)
        rejected(r->c->file, r->line, "%s: expected more values", r->name);
    while (r->at < r->end && *r->at != ' ')
        r->at++;
    *size = (size_t)(r->at - token);
    if (r->at < r->end)
        r->at++;                                   /* never the last character */
    return token;
}

static bool token_is(const char *token, size_t size, const char *word)
{
    return size == strlen(word) && memcmp(token, word, size) == 0;
}

static void begin_record(struct record *out, struct certificate *c, const char *name)
{
    size_t size;
    const char *token;

    next_line(out, c);
    if (out->at == out->end)
        rejected(c->file, out->line, "expected `%s`", name);
    token = next_token(&size, out);
    if (!token_is(token, size, name))
        rejected(c->file, out->line, "expected `%s`", name);
    out->name = name;
}

static void end_record(const struct record *r)
{
    if (r->at != r->end)
        rejected(r->c->file, r->line, "%s: expected no more values", r->name);
}

/* Values
 * ------ */

/* A decimal number in [low, high]. */
static int read_decimal(struct record *r, int low, int high)
{
    size_t size;
    const char *token = next_token(&size, r);
    int value = 0;

    for (size_t i = 0; i < size; i++)
        if (token[i] < '0' || token[i] > '9' || (i == 0 && size > 1 && token[0] == '0'))
            rejected(r->c->file, r->line, "%s: expected a decimal number", r->name);
    for (size_t i = 0; i < size && size <= MAX_DECIMAL; i++)
        value = 10 * value + (token[i] - '0');
    if (size > MAX_DECIMAL || value < low || value > high)
        cannot_check_at(r->c->file, r->line, 0,
                        "%s: expected a number in %d..%d", r->name, low, high);
    return value;
}

/* A hexadecimal number below 2^bits in magnitude. */
static void read_hex(integer *out, struct record *r, int bits)
{
    size_t size;
    const char *token = next_token(&size, r);

    if (!integer_read_hex(out, token, size))
        rejected(r->c->file, r->line, "%s: expected a hexadecimal number", r->name);
    if (integer_bits(out) > bits)
        cannot_check_at(r->c->file, r->line, 0,
                        "%s: expected a magnitude below 2^%d", r->name, bits);
}

static const char *read_word(size_t *size, struct record *r)
{
    const char *token = next_token(size, r);

    for (size_t i = 0; i < *size; i++)
        if (token[i] != '0' && token[i] != '1')
            rejected(r->c->file, r->line, "%s: expected a word over {0,1}", r->name);
    return token;
}

/* The record `name D` */
static int read_decimal_record(struct certificate *c, const char *name, int low,
                               int high, int *line)
{
    struct record r;
    int value;

    begin_record(&r, c, name);
    value = read_decimal(&r, low, high);
    end_record(&r);
    *line = r.line;
    return value;
}

/* Records
 * ------- */

static void read_version(struct certificate *c)
{
    struct record r;
    int version;

    begin_record(&r, c, "smoothcert-certificate");
    version = read_decimal(&r, 0, 999999999);
    end_record(&r);
    if (version != 0)
        cannot_check_at(c->file, r.line, 0,
                        "certificates of version %d; this checker knows version 0",
                        version);
}

static void read_scheme_text(struct certificate *c)
{
    struct record r;
    int lines = read_decimal_record(c, "scheme", 0, 65536, &c->line_of.scheme);

    c->scheme_text = c->next;
    for (int i = 0; i < lines; i++)
        next_line(&r, c);
    c->scheme_size = (size_t)(c->next - c->scheme_text);
}

static void read_claim(struct certificate *c)
{
    struct record r;
    size_t size;
    const char *token;

    begin_record(&r, c, "claim");
    token = next_token(&size, &r);
    end_record(&r);
    c->claims_c1 = token_is(token, size, "c1");
    c->line_of.claim = r.line;
}

void certificate_read_subject(struct certificate *out, const char *file,
                              const char *text, size_t size)
{
    memset(out, 0, sizeof *out);
    out->file = file;
    out->text = text;
    out->next = text;
    out->end = text + size;
    out->line = 1;
    read_version(out);
    read_scheme_text(out);
    read_claim(out);
    out->valence = read_decimal_record(out, "valence", MIN_VALENCE, MAX_VALENCE,
                                       &out->line_of.valence);
    out->grid = read_decimal_record(out, "grid", MIN_GRID, MAX_GRID,
                                    &out->line_of.grid);
}

static void read_eigenpair(struct certificate *c)
{
    int bits = c->grid + BITS_ABOVE_GRID;
    struct record r;

    /* Beyond n: rejected where it is used, not a limit of the format. */
    c->pivot = read_decimal_record(c, "pivot", 0, 999999999, &c->line_of.pivot);

    begin_record(&r, c, "eigenvalue");
    read_hex(&c->eigenvalue, &r, bits);
    end_record(&r);
    c->line_of.eigenvalue = r.line;

    c->eigenvector = allocate((size_t)c->n, sizeof c->eigenvector[0]);
    begin_record(&r, c, "eigenvector");
    for (int i = 0; i < c->n - 1; i++)
        read_hex(&c->eigenvector[i], &r, bits);
    end_record(&r);

    begin_record(&r, c, "radius");
    read_hex(&c->radius, &r, bits);
    end_record(&r);
    c->line_of.radius = r.line;

    c->inverse = allocate((size_t)(c->n * c->n), sizeof c->inverse[0]);
    for (int i = 0; i < c->n; i++) {
        begin_record(&r, c, "inverse");
        for (int j = 0; j < c->n; j++)
            read_hex(&c->inverse[i * c->n + j], &r, INVERSE_BITS_LIMIT);
        end_record(&r);
    }
}

static void read_powers(struct certificate *c)
{
    int count = c->valence / 2 + 1, total = 0;     /* at most 2049 * MAX_POWER */
    struct record r;

    c->power = allocate((size_t)count, sizeof c->power[0]);
    begin_record(&r, c, "power");
    for (int m = 0; m < count; m++) {
        c->power[m] = read_decimal(&r, 0, MAX_POWER);
        total += c->power[m];
    }
    end_record(&r);
    c->line_of.power = r.line;
    if (total > MAX_TOTAL_POWER)
        cannot_check_at(c->file, r.line, 0, "expected powers whose sum is at most %d",
                        MAX_TOTAL_POWER);
}

static void read_decisions(struct certificate *c)
{
    struct record r;
    integer component;

    begin_record(&r, c, "halfplane");
    for (int i = 0; i < 2; i++) {
        read_hex(&component, &r, NORMAL_BITS);
        if (!integer_get_small(&c->normal[i], &component, INT64_C(1) << NORMAL_BITS))
            rejected(c->file, r.line, "halfplane: expected a small number");
    }
    end_record(&r);
    c->line_of.halfplane = r.line;

    begin_record(&r, c, "regularity");
    c->regularity = read_word(&c->regularity_size, &r);
    end_record(&r);
    c->line_of.regularity = r.line;

    begin_record(&r, c, "boundary");
    c->boundary = read_word(&c->boundary_size, &r);
    end_record(&r);
    c->line_of.boundary = r.line;

    if (c->regularity_size + c->boundary_size > MAX_ELEMENTS)
        cannot_check_at(c->file, c->line_of.regularity, 0,
                        "expected at most %d elements", MAX_ELEMENTS);
}

/* `records` counts the lines above it, `sha256` is the hash of all bytes above
 * it, and nothing follows. */
static void read_end(struct certificate *c)
{
    struct record r;
    size_t size;
    const char *token;
    char hash[65];
    int line, above = c->line - 1;

    if (read_decimal_record(c, "records", 0, 999999999, &line) != above)
        rejected(c->file, line, "records: there are %d lines above", above);

    sha256_hex(hash, (const unsigned char *)c->text, (size_t)(c->next - c->text));
    begin_record(&r, c, "sha256");
    token = next_token(&size, &r);
    end_record(&r);
    if (!token_is(token, size, hash))
        rejected(c->file, r.line, "sha256: the hash of the lines above is %s", hash);
    if (c->next != c->end)
        rejected(c->file, c->line, "expected the end of the file");
}

void certificate_read_choices(struct certificate *out, int n)
{
    struct record r;

    out->n = n;
    begin_record(&r, out, "contraction");
    for (int i = 0; i < 3; i++)
        out->contraction[i] = read_decimal(&r, 1, MAX_CONTRACTION);
    end_record(&r);
    out->line_of.contraction = r.line;
    read_eigenpair(out);
    read_powers(out);
    read_decisions(out);
    read_end(out);
}

void certificate_clear(struct certificate *c)
{
    free(c->eigenvector);
    free(c->inverse);
    free(c->power);
}
