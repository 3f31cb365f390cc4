/* Reading certificates: section 1 of certificate.md and of certificate-valences.md, line
 * by line. */

#include "certificate.h"

#include "answer.h"
#include "sha256.h"

#include <stdarg.h>
#include <string.h>

enum {
    MIN_VALENCE = 3, MAX_VALENCE_0 = 4096, MAX_VALENCE_1 = 1000000000,
    MIN_GRID = 64, MAX_GRID = 8192, BITS_ABOVE_GRID = 64,
    MAX_CONTRACTION = 10, MAX_STABILITY_POWER = 9,
    MAX_UNKNOWNS_0 = 512, MAX_UNKNOWNS_1 = 1024, MAX_NUMBER = 999999999,
    MAX_BLOCKS = 10000, MAX_POWER = 10000, MAX_TOTAL_POWER = 200000,
    MAX_RISES = 1000, MAX_COVERS = 10000, Q_BITS = 48,
    NORMAL_BITS = 32, INVERSE_BITS_LIMIT = 96,
    MAX_ELEMENTS = 1000000,
    MAX_GRADE = 64, MAX_GROUP_INTEGERS = 1 << 21,
    MAX_FACTOR = 64, MAX_EXACT = 64, MAX_EXACT_ORDER = 64,
    MAX_DECIMAL = 15                               /* digits; all limits have less */
};

static const int64_t MAX_STABILITY = INT64_C(1) << 40;

/* A record: one line, whose tokens are taken from the left. */
struct record {
    struct certificate *c;
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

/* Values
 * ------ */

/* A decimal number in [low, high]. */
static int64_t read_decimal(struct record *r, int64_t low, int64_t high)
{
    size_t size;
    const char *token = next_token(&size, r);
    int64_t value = 0;

    for (size_t i = 0; i < size; i++)
        if (token[i] < '0' || token[i] > '9' || (i == 0 && size > 1 && token[0] == '0'))
            rejected(r->c->file, r->line, "%s: expected a decimal number", r->name);
    for (size_t i = 0; i < size && size <= MAX_DECIMAL; i++)
        value = 10 * value + (token[i] - '0');
    if (size > MAX_DECIMAL || value < low || value > high)
        cannot_check_at(r->c->file, r->line, 0, "%s: expected a number in %lld..%lld",
                        r->name, (long long)low, (long long)high);
    return value;
}

/* If the next token is the word: steps over it. */
static bool accept_word(struct record *r, const char *word)
{
    struct record rest = *r;
    const char *token;
    size_t size;

    if (r->at == r->end)
        return false;
    token = next_token(&size, &rest);
    if (!token_is(token, size, word))
        return false;
    *r = rest;
    return true;
}

/* A hexadecimal number below 2^bits in magnitude. */
static integer read_hex(struct record *r, int bits)
{
    size_t size;
    const char *token = next_token(&size, r);
    integer out;

    if (!integer_read_hex(&out, token, size))
        rejected(r->c->file, r->line, "%s: expected a hexadecimal number", r->name);
    if (integer_bits(out) > bits)
        cannot_check_at(r->c->file, r->line, 0,
                        "%s: expected a magnitude below 2^%d", r->name, bits);
    return out;
}

/* Q in 0..2^47 */
static int64_t read_q(struct record *r)
{
    integer q = read_hex(r, Q_BITS);
    int64_t out;

    if (!integer_get_small(&out, q, INT64_C(1) << (Q_BITS - 1)) || out < 0)
        cannot_check_at(r->c->file, r->line, 0, "%s: expected a number in 0..2^47", r->name);
    return out;
}

/* A power; of all powers there are limits together. */
static int read_power(struct record *r)
{
    int out = (int)read_decimal(r, 0, MAX_POWER);

    r->c->powers += out;
    if (r->c->powers > MAX_TOTAL_POWER)
        cannot_check_at(r->c->file, r->line, 0, "expected powers whose sum is at most %d",
                        MAX_TOTAL_POWER);
    return out;
}

/* The number of the next token among `count` words, or their count. */
static int read_word(struct record *r, const char *const *words, int count)
{
    size_t size;
    const char *token = next_token(&size, r);

    for (int i = 0; i < count; i++)
        if (token_is(token, size, words[i]))
            return i;
    return count;
}

/* Records
 * ------- */

/* Does the next line begin with this name, or is it this? */
static bool next_is(const struct certificate *c, const char *name)
{
    size_t length = strlen(name);

    return (size_t)(c->end - c->next) > length && memcmp(c->next, name, length) == 0 &&
           (c->next[length] == ' ' || c->next[length] == '\n');
}

static struct record begin_record(struct certificate *c, const char *name)
{
    struct record r;

    next_line(&r, c);
    if (!accept_word(&r, name))
        rejected(c->file, r.line, "expected `%s`", name);
    r.name = name;
    return r;
}

/* Returns the number of the line. */
static int end_record(const struct record *r)
{
    if (r->at != r->end)
        rejected(r->c->file, r->line, "%s: expected no more values", r->name);
    return r->line;
}

/* Reads a whole line, and returns its number.  What follows the name, by the letters of the format:
 *     m i   int64_t *: a valence or frequency, 0..10^9; or `inf`
 *     n     int *, how many, least and greatest value: numbers
 *     l     int64_t *, greatest value: a number
 *     p     int *: a power
 *     q     int64_t *: Q
 *     h     integer *, how many, bits: in hexadecimal
 *     t     const char **, size_t *: a token
 *     w     int *, words, how many: the number of one of them, or how many */
static int read_record(struct certificate *c, const char *name, const char *format, ...)
{
    struct record r = begin_record(c, name);
    va_list to;

    va_start(to, format);
    for (; *format != '\0'; format++) {
        int64_t *m = strchr("milq", *format) != NULL ? va_arg(to, int64_t *) : NULL;
        int *n = strchr("npw", *format) != NULL ? va_arg(to, int *) : NULL;

        if (*format == 'q') {
            *m = read_q(&r);
        } else if (*format == 'i' && accept_word(&r, "inf")) {
            *m = ENDLESS;
        } else if (m != NULL) {
            *m = read_decimal(&r, 0, *format == 'l' ? va_arg(to, int64_t) : MAX_VALENCE_1);
        } else if (*format == 'p') {
            *n = read_power(&r);
        } else if (*format == 'n') {
            int count = va_arg(to, int), low = va_arg(to, int), high = va_arg(to, int);

            for (int i = 0; i < count; i++)
                n[i] = (int)read_decimal(&r, low, high);
        } else if (*format == 'w') {
            const char *const *words = va_arg(to, const char *const *);

            *n = read_word(&r, words, va_arg(to, int));
        } else if (*format == 't') {
            const char **token = va_arg(to, const char **);

            *token = next_token(va_arg(to, size_t *), &r);
        } else {
            integer *h = va_arg(to, integer *);
            int count = va_arg(to, int), bits = va_arg(to, int);

            for (int i = 0; i < count; i++)
                h[i] = read_hex(&r, bits);
        }
    }
    va_end(to);
    return end_record(&r);
}

/* One number in units of 2^-g, which is to be positive. */
static void read_positive(integer *out, struct certificate *c, const char *name)
{
    int line = read_record(c, name, "h", out, 1, c->grid + BITS_ABOVE_GRID);

    if (out->sign <= 0)
        rejected(c->file, line, "%s: it is not positive", name);
}

/* A list has no more than `limit` records of a kind; `count` are there already. */
static void check_count(const struct certificate *c, int count, int limit, const char *name)
{
    if (count >= limit)
        cannot_check_at(c->file, c->line, 0, "expected at most %d records `%s`", limit, name);
}

/* The subject
 * ----------- */

static void read_scheme_text(struct certificate *c)
{
    struct record r;
    int lines;

    c->line_of.scheme = read_record(c, "scheme", "n", &lines, 1, 0, 65536);
    c->scheme_text = c->next;
    for (int i = 0; i < lines; i++)
        next_line(&r, c);
    c->scheme_size = (size_t)(c->next - c->scheme_text);
}

/* k, or the first and the last (or `inf`) of several */
static void read_valence(struct certificate *c)
{
    int64_t most = c->version == 0 ? MAX_VALENCE_0 : MAX_VALENCE_1;
    struct record r = begin_record(c, "valence");

    c->valence = span_of(read_decimal(&r, MIN_VALENCE, most));
    if (r.at != r.end && c->version > 0) {
        c->valence.last = accept_word(&r, "inf") ? ENDLESS : read_decimal(&r, MIN_VALENCE, most);
        if (!span_is_several(c->valence))
            rejected(c->file, r.line, "valence: expected the first and a greater last one");
    }
    c->line_of.valence = end_record(&r);
}

void certificate_read_subject(struct certificate *out, const char *file,
                              const char *text, size_t size)
{
    static const char *const claim[] = { "c1", "not-c1" };
    int line, choice;

    *out = (struct certificate) {
        .file = file, .text = text, .next = text, .end = text + size, .line = 1,
        .regularity.word = "", .boundary.word = ""  /* refutations may have none */
    };
    line = read_record(out, "smoothcert-certificate", "n", &out->version, 1, 0, MAX_NUMBER);
    if (out->version > 1)
        cannot_check_at(file, line, 0, "certificates of version %d; this checker knows "
                        "versions 0 and 1", out->version);
    read_scheme_text(out);
    out->line_of.claim = read_record(out, "claim", "w", &choice, claim, 2);
    out->claim = (enum claim)choice;
    read_valence(out);
    read_record(out, "grid", "n", &out->grid, 1, MIN_GRID, MAX_GRID);
}

/* Reasons
 * ------- */

/* What follows behind the blocks: trees, and witnesses. */
static const struct {
    bool boundary;
    int witnesses;
} ending[] = {
    [REASON_FREQUENCY] = { true, 0 }, [REASON_NOT_C0] = { false, 1 },
    [REASON_FOLD] = { false, 2 }, [REASON_WINDING] = { true, 0 }, [REASON_REAL] = { false, 1 },
    [REASON_TIE] = { false, 2 }, [REASON_JORDAN] = { true, 0 },
    [REASON_MODULUS_ONE] = { false, 1 }
};

bool certificate_is_exact(const struct certificate *c)
{
    return c->reason >= REASON_TIE;
}

static void read_reason(struct certificate *c)
{
    static const char *const reason[] = {
        "frequency", "not-c0", "fold", "winding", "real", "tie", "jordan", "modulus-one"
    };
    int choice, line = read_record(c, "reason", "w", &choice, reason, 8);

    if (choice == 8)
        rejected(c->file, line, "reason: expected `frequency`, `not-c0`, `fold`, `winding`, "
                 "`real`, `tie`, `jordan` or `modulus-one`");
    c->reason = (enum reason)(REASON_FREQUENCY + choice);
    if (span_is_several(c->valence) && c->reason >= REASON_WINDING)
        rejected(c->file, line, "reason: it is for single valences only");
}

/* Is the frequency k/2? */
static bool is_half(const struct certificate *c)
{
    return 2 * c->frequency == c->valence.first && !span_is_several(c->valence);
}

static bool frequency_fits(const struct certificate *c)
{
    if (c->reason == REASON_REAL)
        return c->frequency == 0 || is_half(c);
    if (2 * c->frequency >= c->valence.first && !is_half(c))
        return false;
    if (c->reason == REASON_FOLD || c->reason == REASON_WINDING)
        return c->frequency == 1;
    return c->reason == REASON_NOT_C0 || c->frequency != 1;
}

static void read_frequency(struct certificate *c)
{
    int line, none;

    if (span_is_several(c->valence) && c->reason == REASON_FREQUENCY &&
        next_is(c, "frequency window")) {
        read_record(c, "frequency", "w", &none, NULL, 0);
        c->frequency = -1;
        return;
    }
    line = read_record(c, "frequency", "m", &c->frequency);
    if (!frequency_fits(c))
        rejected(c->file, line, "frequency: it is beyond k/2, or not one for this reason");
}

/* plain: the real form of m = 0.  That of m = k/2 is for `real` only. */
static void read_form(struct certificate *c)
{
    static const char *const form[] = { "real", "complex", "plain", "graded" };
    int choice, line = c->line_of.form = read_record(c, "form", "w", &choice, form, 4);

    if (choice == 4 || (choice != 1 && (choice >= 2) != (c->frequency == 0)))
        rejected(c->file, line, "form: expected `real` or `complex`, or for frequency 0 "
                 "`plain` or `complex`");
    c->graded = choice == 3;
    c->real = choice != 1;
    if (c->graded && !(span_is_several(c->valence) && c->reason == REASON_NOT_C0))
        rejected(c->file, line, "form: `graded` is for `not-c0` at several valences");
    if (choice == 0 && is_half(c) && c->reason != REASON_REAL)
        rejected(c->file, line, "form: for frequency k/2 expected `complex`");
    if (span_is_several(c->valence) && !c->real)
        rejected(c->file, line, "form: of several valences expected `real`");
}

/* Eigenpairs
 * ---------- */

/* For the unknowns of c. */
static void read_eigenpair(struct choices *out, struct certificate *c)
{
    int bits = c->grid + BITS_ABOVE_GRID, parts = c->real ? 1 : 2, size = c->size;

    /* Beyond n: rejected where it is used, not a limit of the format. */
    out->line_of.pivot = read_record(c, "pivot", "n", &out->pivot, 1, 0, MAX_NUMBER);
    out->line_of.eigenvalue = read_record(c, "eigenvalue", "h", out->eigenvalue, parts, bits);
    out->eigenvector = allocate((size_t)size, sizeof out->eigenvector[0]);
    read_record(c, "eigenvector", "h", out->eigenvector, parts * (c->n - 1), bits);
    out->line_of.radius = read_record(c, "radius", "h", &out->radius, 1, bits);
    if (span_is_several(c->valence))
        out->line_of.range = read_record(c, "range", "h", &out->range, 1, bits);
    out->inverse = allocate((size_t)size * (size_t)size, sizeof out->inverse[0]);
    for (int i = 0; i < size; i++)
        read_record(c, "inverse", "h", &out->inverse[i * size], size, INVERSE_BITS_LIMIT);
    if (!c->real)
        out->line_of.modulus = read_record(c, "modulus", "h", &out->modulus, 1, bits);
}

/* How unknowns are scaled, of which there are n. */
static void read_grades(struct certificate *c)
{
    int line = read_record(c, "unit", "m", &c->unit);

    if (c->unit == 0)
        rejected(c->file, line, "unit: it is not positive");
    read_record(c, "degree", "n", &c->degree, 1, 0, MAX_GRADE);
    c->grade = allocate((size_t)c->n, sizeof c->grade[0]);
    read_record(c, "grades", "n", c->grade, c->n, 0, MAX_GRADE);
}

/* `second m'` and its eigenpair: its form is plain for 0, which is for k/2 only, else real. */
static void read_second(struct certificate *c, const int n[2])
{
    struct certificate own = *c;
    int line = read_record(&own, "second", "m", &own.frequency);

    if (2 * own.frequency >= c->valence.first || (own.frequency == 0 && !is_half(c)))
        rejected(c->file, line, "second: it is not between 0 and k/2");
    read_form(&own);
    if (!own.real)
        rejected(c->file, own.line_of.form, "form: expected `real`, or for frequency 0 `plain`");
    own.n = own.size = n[own.frequency == 0 ? 0 : 1];
    read_eigenpair(&own.second, &own);
    c->second_frequency = own.frequency;
    c->second = own.second;
    c->next = own.next;
    c->line = own.line;
}

/* Trees and witnesses
 * ------------------- */

static void read_trees(struct trees *out, struct certificate *c, const char *name)
{
    out->line = read_record(c, name, "t", &out->word, &out->size);
    for (size_t i = 0; i < out->size; i++)
        if (memchr("012", out->word[i], c->has_splines ? 3 : 2) == NULL)
            rejected(c->file, out->line, "%s: expected a word over {0,1}", name);
    c->letters += out->size;
    if (c->letters > MAX_ELEMENTS)
        cannot_check_at(c->file, out->line, 0, "expected at most %d elements", MAX_ELEMENTS);
}

static void read_decisions(struct certificate *c)
{
    read_record(c, "halfplane", "h", c->normal, 2, NORMAL_BITS);
    read_trees(&c->regularity, c, "regularity");
    read_trees(&c->boundary, c, "boundary");
}

/* `witness D P`: P digits from 0 to 3, or `-` */
static void read_witness(struct witness *w, struct certificate *c)
{
    w->line = read_record(c, "witness", "lt", &w->element, (int64_t)MAX_ELEMENTS, &w->path,
                          &w->path_size);
    if (token_is(w->path, w->path_size, "-"))
        w->path_size = 0;
    for (size_t i = 0; i < w->path_size; i++)
        if (w->path[i] < '0' || w->path[i] > '3')
            rejected(c->file, w->line, "witness: expected digits from 0 to 3, or `-`");
}

static void read_refutation(struct certificate *c)
{
    if (ending[c->reason].boundary)
        read_trees(&c->boundary, c, "boundary");
    for (int i = 0; i < ending[c->reason].witnesses; i++)
        read_witness(&c->witness[i], c);
}

/* Exact ties
 * ---------- */

/* g: for each coefficient Q > 0 and d numerators, without a common divisor. */
static void read_factor(struct certificate *c, int d)
{
    struct exact_choices *e = &c->exact;
    int line = read_record(c, "factor", "n", &e->degree, 1, 0, MAX_FACTOR);

    if (e->degree < 1)
        rejected(c->file, line, "factor: its degree is not positive");
    e->coefficient = allocate((size_t)e->degree * (size_t)(d + 1), sizeof e->coefficient[0]);
    for (int i = 0; i < e->degree; i++) {
        integer *q = &e->coefficient[i * (d + 1)], gcd;

        line = read_record(c, "coefficient", "h", q, d + 1, RATIONAL_BITS);
        gcd = q[0];
        for (int part = 1; part <= d; part++)
            gcd = integer_gcd(gcd, q[part]);
        if (q[0].sign <= 0 || integer_bits(gcd) != 1)
            rejected(c->file, line, "coefficient: its denominator is not positive, or it is "
                     "not in lowest terms");
    }
}

static void read_exact_record(struct exact_record *out, struct certificate *c)
{
    static const char *const signs[] = { "1", "-1" };
    int sign, order[2], line;

    line = read_record(c, "exact", "mwnnp", &out->m, &sign, signs, 2, order, 2, 0,
                       MAX_EXACT_ORDER, &out->j, 1, 0, MAX_NUMBER, &out->record.power);
    out->sign = sign == 0 ? 1 : -1;
    out->a = order[0];
    out->q = order[1];
    out->record.m = span_of(out->m);
    out->record.line = line;
    if (sign == 2)
        rejected(c->file, line, "exact: expected 1 or -1 for s");
    if (2 * out->m > c->valence.first || (out != c->exact.line && out->m <= out[-1].m))
        rejected(c->file, line, "exact: frequencies have to rise, up to k/2");
    if (out->q < 1 || out->q > out->a)
        rejected(c->file, line, "exact: it must be 1 <= q <= a");
}

static bool is_exact_frequency(const struct certificate *c, struct span m)
{
    for (int i = 0; i < c->exact.count; i++)
        if (m.first <= c->exact.line[i].m && c->exact.line[i].m <= m.last)
            return true;
    return false;
}

/* Blocks of one valence
 * --------------------- */

/* Has one of the frequencies m an eigenpair? */
static bool contains_own(const struct certificate *c, struct span m)
{
    return (m.first <= c->frequency && c->frequency <= m.last) ||
           (c->reason == REASON_REAL && m.first <= c->second_frequency &&
            c->second_frequency <= m.last);
}

static struct block_record *read_block(struct certificate *c)
{
    struct block_record *b = &c->block[c->blocks++];

    b->line = read_record(c, "block", "mmp", &b->m.first, &b->m.last, &b->power);
    return b;
}

/* The next frequency without an exact block. */
static int64_t skip_exact(const struct certificate *c, int64_t m)
{
    while (is_exact_frequency(c, span_of(m)))
        m++;
    return m;
}

/* 0; 1; then without gaps up to floor(k/2); but for exact blocks. */
static void read_blocks(struct certificate *c)
{
    int64_t next = skip_exact(c, 0), half = c->valence.first / 2;

    c->block = allocate(MAX_BLOCKS, sizeof c->block[0]);
    while ((c->blocks == 0 && next <= half) || next_is(c, "block")) {
        const struct block_record *b;

        check_count(c, c->blocks, MAX_BLOCKS, "block");
        b = read_block(c);
        if (b->m.first != next || b->m.last < b->m.first || b->m.last > half ||
            is_exact_frequency(c, b->m) ||
            (span_is_several(b->m) && (next <= 1 || contains_own(c, b->m))))
            rejected(c->file, b->line, "block: expected `block 0 0`, `block 1 1`, then "
                     "ranges without gaps up to %lld", (long long)half);
        next = skip_exact(c, b->m.last + 1);
    }
    if (next <= half)
        rejected(c->file, c->line, "block: the frequencies from %lld on are missing",
                 (long long)next);
}

/* Version 0: one record with a power for each frequency. */
static void read_powers_0(struct certificate *c)
{
    struct record r = begin_record(c, "power");

    c->blocks = (int)(c->valence.first / 2) + 1;
    c->block = allocate((size_t)c->blocks, sizeof c->block[0]);
    for (int m = 0; m < c->blocks; m++)
        c->block[m] = (struct block_record) {
            span_of(m), read_power(&r), r.line
        };
    end_record(&r);
}

/* Several valences
 * ---------------- */

/* Blocks 0 (or `limit P` with its eigenpair) and m, the eigenpair's frequency. */
static void read_two_blocks(struct certificate *c)
{
    const int64_t m[2] = { 0, c->frequency };

    c->block = allocate(2, sizeof c->block[0]);
    c->has_limit = c->claim == CLAIM_C1 && c->valence.last == ENDLESS && next_is(c, "limit");
    if (c->has_limit) {
        c->limit.record.m = span_of(0);
        c->limit.record.line = read_record(c, "limit", "p", &c->limit.record.power);
        read_eigenpair(&c->limit.pair, c);
        c->blocks = 1;
    }
    while (c->blocks < (c->frequency > 0 ? 2 : 1)) {
        int64_t here = m[c->blocks];
        const struct block_record *b = read_block(c);

        if (b->m.first != here || b->m.last != here)
            rejected(c->file, b->line, "block: expected `block %lld %lld`", (long long)here,
                     (long long)here);
    }
}

/* `rise` or `wave` */
static void read_rises(struct certificate *c, bool wave)
{
    const char *name = wave ? "wave" : "rise";

    c->rise = allocate(MAX_RISES, sizeof c->rise[0]);
    for (; next_is(c, name); c->rises++) {
        struct rise *rise = &c->rise[c->rises];

        check_count(c, c->rises, MAX_RISES, name);
        if ((c->rises + 1) * c->size * c->size > MAX_GROUP_INTEGERS)
            cannot_check_at(c->file, c->line, 0, "expected at most %d integers in the groups of "
                            "`%s`", MAX_GROUP_INTEGERS, name);
        rise->record.line = read_record(c, name, "qp", &rise->q, &rise->record.power);
        rise->record.m = (struct span) { wave ? 2 : 1, ENDLESS };
        read_eigenpair(&rise->pair, c);
        if (wave)
            read_trees(&rise->boundary, c, "boundary");
    }
}

/* What proves the rest. */
static void read_ranges(struct certificate *c)
{
    read_two_blocks(c);
    if (c->claim == CLAIM_C1)
        read_rises(c, false);
    c->cover = allocate(MAX_COVERS, sizeof c->cover[0]);
    do {
        struct cover *cover = &c->cover[c->covers];
        struct block_record *b = &cover->record;

        check_count(c, c->covers, MAX_COVERS, "cover");
        b->line = read_record(c, "cover", "miqp", &b->m.first, &b->m.last, &cover->q, &b->power);
        c->covers++;
    } while (next_is(c, "cover"));
}

/* A window of frequencies. */
static void read_window(struct certificate *c)
{
    c->line_of.window = read_record(c, "window", "q", &c->window);
    read_positive(&c->bound, c, "bound");
    read_rises(c, true);
}

/* All of it
 * --------- */

/* What proves the eigenvalue and bounds the rest. */
static void read_root(struct certificate *c, int d)
{
    struct exact_choices *e = &c->exact;

    read_factor(c, d);
    e->line_of_eigenvalue = read_record(c, "eigenvalue", "h", &e->eigenvalue, 1,
                                        c->grid + BITS_ABOVE_GRID);
    read_positive(&e->radius, c, "radius");
    e->others.line = read_record(c, "others", "p", &e->others.power);
}

/* The records of exact.md from `field` on. */
static void read_exact(struct certificate *c)
{
    struct exact_choices *e = &c->exact;
    int line = read_record(c, "field", "n", &e->field, 1, MIN_FIELD, MAX_FIELD);
    int d = field_degree(e->field);
    bool has_root = c->reason != REASON_MODULUS_ONE;

    c->frequency = -1;
    if (d > MAX_DEGREE)
        cannot_check_at(c->file, line, 0, "field: its degree is beyond %d", MAX_DEGREE);
    if (has_root)
        read_root(c, d);
    e->line = allocate(MAX_EXACT, sizeof e->line[0]);
    do {
        check_count(c, e->count, MAX_EXACT, "exact");
        read_exact_record(&e->line[e->count++], c);
    } while (next_is(c, "exact"));
    if (!has_root && e->count > 1)
        rejected(c->file, e->line[1].record.line, "exact: expected one only");
    if (has_root)
        read_blocks(c);
    read_refutation(c);
}

static void read_stability(struct certificate *c)
{
    int *n = c->stability_power, most = MAX_STABILITY_POWER;
    int64_t *t = c->stability;

    c->line_of.stability = read_record(c, "stability", "nlnlnl", &n[0], 1, 0, most, &t[0],
                                       MAX_STABILITY, &n[1], 1, 0, most, &t[1], MAX_STABILITY,
                                       &n[2], 1, 0, most, &t[2], MAX_STABILITY);
}

void certificate_read_form(struct certificate *out, bool plainly_regular)
{
    out->line_of.contraction = read_record(out, "contraction", "n", out->contraction, 3, 1,
                                           MAX_CONTRACTION);
    out->line_of.stability = out->line_of.contraction;
    out->real = true;
    out->frequency = 1;
    for (int i = 0; i < 3; i++)
        out->stability[i] = 1024;
    if (out->version == 0 || plainly_regular)
        return;
    read_stability(out);
    if (out->claim == CLAIM_NOT_C1)
        read_reason(out);
    if (certificate_is_exact(out)) {
        read_exact(out);
        return;
    }
    if (out->claim == CLAIM_NOT_C1)
        read_frequency(out);
    read_form(out);
}

void certificate_read_choices(struct certificate *out, const int n[2])
{
    out->has_splines = out->version > 0 && out->claim == CLAIM_C1;
    out->n = n[out->frequency == 0 ? 0 : 1];
    out->size = out->real ? out->n : 2 * out->n;
    if (out->size > (out->version == 0 ? MAX_UNKNOWNS_0 : MAX_UNKNOWNS_1))
        cannot_check("%s: blocks of %d unknowns", out->file, out->size);
    if (out->graded)
        read_grades(out);
    if (out->frequency < 0)
        read_window(out);
    else
        read_eigenpair(&out->pair, out);
    if (out->reason == REASON_REAL)
        read_second(out, n);
    if (out->version == 0)
        read_powers_0(out);
    else if (out->reason != REASON_NOT_C0 && span_is_several(out->valence))
        read_ranges(out);
    else if (out->reason != REASON_NOT_C0)
        read_blocks(out);
    if (out->claim == CLAIM_C1)
        read_decisions(out);
    else if (out->frequency >= 0)
        read_refutation(out);
}

/* `records` counts the lines above it, `sha256` is the hash of all bytes above
 * it, and nothing follows. */
void certificate_read_end(struct certificate *c)
{
    char hash[65];
    const char *const words[] = { hash };
    int line, count, choice, above = c->line - 1;

    line = read_record(c, "records", "n", &count, 1, 0, MAX_NUMBER);
    if (count != above)
        rejected(c->file, line, "records: there are %d lines above", above);
    sha256_hex(hash, (const unsigned char *)c->text, (size_t)(c->next - c->text));
    line = read_record(c, "sha256", "w", &choice, words, 1);
    if (choice != 0)
        rejected(c->file, line, "sha256: the hash of the lines above is %s", hash);
    if (c->next != c->end)
        rejected(c->file, c->line, "expected the end of the file");
}
