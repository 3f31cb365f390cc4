/* Reading certificates: section 1 of certificate.md and of certificate-valences.md, line
 * by line. */

#include "certificate.h"

#include "answer.h"
#include "sha256.h"

#include <string.h>

enum {
    MIN_VALENCE = 3, MAX_VALENCE_0 = 4096, MAX_VALENCE_1 = 1000000000,
    MIN_GRID = 64, MAX_GRID = 8192, BITS_ABOVE_GRID = 64,
    MAX_CONTRACTION = 10, MAX_STABILITY_POWER = 9,
    MAX_UNKNOWNS_0 = 512, MAX_UNKNOWNS_1 = 1024, MAX_PIVOT = 999999999,
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

/* The same, or `inf`. */
static int64_t read_decimal_or_inf(struct record *r, int64_t low, int64_t high)
{
    size_t left = (size_t)(r->end - r->at);

    if (left < 3 || memcmp(r->at, "inf", 3) != 0 || (left > 3 && r->at[3] != ' '))
        return read_decimal(r, low, high);
    next_token(&left, r);
    return ENDLESS;
}

/* A hexadecimal number below 2^bits in magnitude. */
static void read_hex(integer *out, struct record *r, int bits)
{
    size_t size;
    const char *token = next_token(&size, r);

    if (!integer_read_hex(out, token, size))
        rejected(r->c->file, r->line, "%s: expected a hexadecimal number", r->name);
    if (integer_bits(*out) > bits)
        cannot_check_at(r->c->file, r->line, 0,
                        "%s: expected a magnitude below 2^%d", r->name, bits);
}

static const char *read_word(size_t *size, struct record *r)
{
    const char *token = next_token(size, r);

    for (size_t i = 0; i < *size; i++)
        if (token[i] != '0' && token[i] != '1' && (token[i] != '2' || !r->c->has_splines))
            rejected(r->c->file, r->line, "%s: expected a word over {0,1}", r->name);
    return token;
}

/* Begins the record and remembers its line. */
static struct record begin_noted(struct certificate *c, const char *name, int *line)
{
    struct record r;

    begin_record(&r, c, name);
    *line = r.line;
    return r;
}

/* The record `name D` */
static int64_t read_decimal_record(struct certificate *c, const char *name, int64_t low,
                                   int64_t high, int *line)
{
    struct record r = begin_noted(c, name, line);
    int64_t value = read_decimal(&r, low, high);

    end_record(&r);
    return value;
}

/* Does the next line begin with this name, or is it this? */
static bool next_is(const struct certificate *c, const char *name)
{
    size_t length = strlen(name);

    return (size_t)(c->end - c->next) > length && memcmp(c->next, name, length) == 0 &&
           (c->next[length] == ' ' || c->next[length] == '\n');
}

/* The subject
 * ----------- */

static void read_version(struct certificate *c)
{
    int line;
    int64_t version = read_decimal_record(c, "smoothcert-certificate", 0, 999999999, &line);

    if (version > 1)
        cannot_check_at(c->file, line, 0, "certificates of version %d; this checker "
                        "knows versions 0 and 1", (int)version);
    c->version = (int)version;
}

static void read_scheme_text(struct certificate *c)
{
    struct record r;
    int64_t lines = read_decimal_record(c, "scheme", 0, 65536, &c->line_of.scheme);

    c->scheme_text = c->next;
    for (int64_t i = 0; i < lines; i++)
        next_line(&r, c);
    c->scheme_size = (size_t)(c->next - c->scheme_text);
}

/* The record `name WORD`: the number of the word among `words`, or their count. */
static int read_choice_record(struct certificate *c, const char *name,
                              const char *const *words, int count, int *line)
{
    struct record r = begin_noted(c, name, line);
    size_t size;
    const char *token = next_token(&size, &r);

    end_record(&r);
    for (int i = 0; i < count; i++)
        if (token_is(token, size, words[i]))
            return i;
    return count;
}

/* k, or the first and the last (or `inf`) of several */
static void read_valence(struct certificate *c)
{
    int64_t most = c->version == 0 ? MAX_VALENCE_0 : MAX_VALENCE_1;
    struct record r = begin_noted(c, "valence", &c->line_of.valence);

    c->valence = span_of(read_decimal(&r, MIN_VALENCE, most));
    if (r.at != r.end && c->version > 0) {
        c->valence.last = read_decimal_or_inf(&r, MIN_VALENCE, most);
        if (!span_is_several(c->valence))
            rejected(c->file, r.line, "valence: expected the first and a greater last one");
    }
    end_record(&r);
}

void certificate_read_subject(struct certificate *out, const char *file,
                              const char *text, size_t size)
{
    static const char *const claim[] = { "c1", "not-c1" };

    memset(out, 0, sizeof *out);
    out->file = file;
    out->text = text;
    out->next = text;
    out->end = text + size;
    out->regularity.word = out->boundary.word = "";  /* refutations may have none */
    out->line = 1;
    read_version(out);
    read_scheme_text(out);
    out->claim = (enum claim)read_choice_record(out, "claim", claim, 2, &out->line_of.claim);
    read_valence(out);
    out->grid = (int)read_decimal_record(out, "grid", MIN_GRID, MAX_GRID,
                                         &out->line_of.grid);
}

/* The choices
 * ----------- */

/* Is the frequency k/2? */
static bool is_half(const struct certificate *c)
{
    return 2 * c->frequency == c->valence.first && !span_is_several(c->valence);
}

/* plain: the real form of m = 0.  That of m = k/2 is for `real` only. */
static void read_form(struct certificate *c)
{
    static const char *const form[] = { "real", "complex", "plain", "graded" };
    int choice = read_choice_record(c, "form", form, 4, &c->line_of.form);

    if (choice == 4 || (choice != 1 && (choice >= 2) != (c->frequency == 0)))
        rejected(c->file, c->line_of.form, "form: expected `real` or `complex`, or for "
                 "frequency 0 `plain` or `complex`");
    c->graded = choice == 3;
    if (c->graded && !(span_is_several(c->valence) && c->reason == REASON_NOT_C0))
        rejected(c->file, c->line_of.form, "form: `graded` is for `not-c0` at several valences");
    if (choice == 0 && is_half(c) && c->reason != REASON_REAL)
        rejected(c->file, c->line_of.form, "form: for frequency k/2 expected `complex`");
    c->real = choice != 1;
    if (span_is_several(c->valence) && choice == 1)
        rejected(c->file, c->line_of.form, "form: of several valences expected `real`");
}

bool certificate_is_exact(const struct certificate *c)
{
    return c->reason >= REASON_TIE;
}

static void read_reason(struct certificate *c)
{
    static const char *const reason[] = {
        "frequency", "not-c0", "fold", "winding", "real", "tie", "jordan", "modulus-one"
    };
    int choice = read_choice_record(c, "reason", reason, 8, &c->line_of.reason);

    if (choice == 8)
        rejected(c->file, c->line_of.reason, "reason: expected `frequency`, `not-c0`, "
                 "`fold`, `winding`, `real`, `tie`, `jordan` or `modulus-one`");
    c->reason = (enum reason)(REASON_FREQUENCY + choice);
    if (span_is_several(c->valence) && c->reason >= REASON_WINDING)
        rejected(c->file, c->line_of.reason, "reason: it is for single valences only");
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
    int line;
    struct record r;
    size_t size;

    if (span_is_several(c->valence) && c->reason == REASON_FREQUENCY &&
        next_is(c, "frequency window"))
        c->frequency = -1;
    r = begin_noted(c, "frequency", &line);
    if (c->frequency < 0)
        next_token(&size, &r);                     /* `window` */
    else
        c->frequency = read_decimal(&r, 0, MAX_VALENCE_1);
    end_record(&r);
    if (c->frequency >= 0 && !frequency_fits(c))
        rejected(c->file, line, "frequency: it is beyond k/2, or not one for this reason");
}

/* The record `name I ...` */
static void read_hex_record(integer *out, int count, struct certificate *c,
                            const char *name, int bits, int *line)
{
    struct record r = begin_noted(c, name, line);

    for (int i = 0; i < count; i++)
        read_hex(&out[i], &r, bits);
    end_record(&r);
}

/* For the unknowns of c. */
static void read_eigenpair(struct choices *out, struct certificate *c)
{
    int bits = c->grid + BITS_ABOVE_GRID, parts = c->real ? 1 : 2, line;

    /* Beyond n: rejected where it is used, not a limit of the format. */
    out->pivot = (int)read_decimal_record(c, "pivot", 0, MAX_PIVOT, &out->line_of.pivot);
    read_hex_record(out->eigenvalue, parts, c, "eigenvalue", bits, &out->line_of.eigenvalue);
    out->eigenvector = allocate((size_t)c->size, sizeof out->eigenvector[0]);
    read_hex_record(out->eigenvector, parts * (c->n - 1), c, "eigenvector", bits, &line);
    read_hex_record(&out->radius, 1, c, "radius", bits, &out->line_of.radius);
    if (span_is_several(c->valence))
        read_hex_record(&out->range, 1, c, "range", bits, &out->line_of.range);
    out->inverse = allocate((size_t)c->size * (size_t)c->size, sizeof out->inverse[0]);
    for (int i = 0; i < c->size; i++)
        read_hex_record(&out->inverse[i * c->size], c->size, c, "inverse",
                        INVERSE_BITS_LIMIT, &line);
    if (!c->real)
        read_hex_record(&out->modulus, 1, c, "modulus", bits, &out->line_of.modulus);
}

/* How unknowns are scaled, of which there are n. */
static void read_grades(struct certificate *c)
{
    int line;
    struct record r;

    c->unit = read_decimal_record(c, "unit", 0, MAX_VALENCE_1, &line);
    if (c->unit == 0)
        rejected(c->file, line, "unit: it is not positive");
    c->degree = (int)read_decimal_record(c, "degree", 0, MAX_GRADE, &line);
    r = begin_noted(c, "grades", &line);
    c->grade = allocate((size_t)c->n, sizeof c->grade[0]);
    for (int i = 0; i < c->n; i++)
        c->grade[i] = (int)read_decimal(&r, 0, MAX_GRADE);
    end_record(&r);
}

static void check_total_power(const struct certificate *c)
{
    int total = c->limit.record.power;             /* at most 11068 * MAX_POWER */

    total += c->exact.others.power;
    for (int i = 0; i < c->exact.count; i++)
        total += c->exact.line[i].record.power;
    for (int i = 0; i < c->blocks; i++)
        total += c->block[i].power;
    for (int i = 0; i < c->rises; i++)
        total += c->rise[i].record.power;
    for (int i = 0; i < c->covers; i++)
        total += c->cover[i].record.power;
    if (total > MAX_TOTAL_POWER)
        cannot_check_at(c->file, c->blocks > 0 ? c->block[0].line : c->line, 0,
                        "expected powers whose sum is at most %d", MAX_TOTAL_POWER);
}

/* Version 0: one record with a power for each frequency. */
static void read_powers_0(struct certificate *c)
{
    struct record r;

    c->blocks = (int)(c->valence.first / 2) + 1;
    c->block = allocate((size_t)c->blocks, sizeof c->block[0]);
    begin_record(&r, c, "power");
    for (int m = 0; m < c->blocks; m++)
        c->block[m] = (struct block_record) {
            span_of(m), (int)read_decimal(&r, 0, MAX_POWER), r.line
        };
    end_record(&r);
}

/* `limit P` with its eigenpair */
static void read_limit(struct certificate *c)
{
    c->has_limit = true;
    c->limit.record.m = span_of(0);
    c->limit.record.power = (int)read_decimal_record(c, "limit", 0, MAX_POWER,
                                                     &c->limit.record.line);
    read_eigenpair(&c->limit.pair, c);
}

/* Of several valences: 0, and the eigenpair's frequency. */
static void read_two_blocks(struct certificate *c)
{
    const int64_t m[2] = { 0, c->frequency };

    c->block = allocate(2, sizeof c->block[0]);
    if (c->claim == CLAIM_C1 && c->valence.last == ENDLESS && next_is(c, "limit"))
        read_limit(c);
    for (int i = c->has_limit ? 1 : 0; i < (c->frequency > 0 ? 2 : 1); i++) {
        struct record r = begin_noted(c, "block", &c->block[i].line);

        c->block[i].m.first = read_decimal(&r, 0, MAX_VALENCE_1);
        c->block[i].m.last = read_decimal(&r, 0, MAX_VALENCE_1);
        c->block[i].power = (int)read_decimal(&r, 0, MAX_POWER);
        end_record(&r);
        if (c->block[i].m.first != m[i] || c->block[i].m.last != m[i])
            rejected(c->file, r.line, "block: expected `block %lld %lld`", (long long)m[i],
                     (long long)m[i]);
        c->blocks = i + 1;
    }
}

/* Has one of the frequencies m an eigenpair? */
static bool contains_own(const struct certificate *c, struct span m)
{
    if (c->reason == REASON_REAL && m.first <= c->second_frequency &&
        c->second_frequency <= m.last)
        return true;
    return m.first <= c->frequency && c->frequency <= m.last;
}

static bool is_exact_frequency(const struct certificate *c, int64_t first, int64_t last)
{
    for (int i = 0; i < c->exact.count; i++)
        if (first <= c->exact.line[i].m && c->exact.line[i].m <= last)
            return true;
    return false;
}

/* The next frequency without an exact block. */
static int64_t skip_exact(const struct certificate *c, int64_t m)
{
    while (is_exact_frequency(c, m, m))
        m++;
    return m;
}

/* 0; 1; then without gaps up to floor(k/2); but for exact blocks. */
static void read_blocks(struct certificate *c)
{
    int64_t next = skip_exact(c, 0), half = c->valence.first / 2;

    c->block = allocate(MAX_BLOCKS, sizeof c->block[0]);
    while ((c->blocks == 0 && next <= half) || next_is(c, "block")) {
        struct block_record *b = &c->block[c->blocks];
        struct record r = begin_noted(c, "block", &b->line);

        b->m.first = read_decimal(&r, 0, MAX_VALENCE_1);
        b->m.last = read_decimal(&r, 0, MAX_VALENCE_1);
        b->power = (int)read_decimal(&r, 0, MAX_POWER);
        end_record(&r);
        if (b->m.first != next || b->m.last < b->m.first || b->m.last > half ||
            is_exact_frequency(c, b->m.first, b->m.last) ||
            (span_is_several(b->m) && (next <= 1 || contains_own(c, b->m))))
            rejected(c->file, b->line, "block: expected `block 0 0`, `block 1 1`, then "
                     "ranges without gaps up to %lld", (long long)half);
        next = skip_exact(c, b->m.last + 1);
        if (++c->blocks == MAX_BLOCKS && next_is(c, "block"))
            cannot_check_at(c->file, b->line, 0, "expected at most %d blocks", MAX_BLOCKS);
    }
    if (next <= half)
        rejected(c->file, c->line, "block: the frequencies from %lld on are missing",
                 (long long)next);
}

static void read_trees(struct trees *out, struct certificate *c, const char *name)
{
    struct record r = begin_noted(c, name, &out->line);

    out->word = read_word(&out->size, &r);
    end_record(&r);
    c->letters += out->size;
    if (c->letters > MAX_ELEMENTS)
        cannot_check_at(c->file, out->line, 0, "expected at most %d elements", MAX_ELEMENTS);
}

/* Q in 0..2^47 */
static int64_t read_q(struct record *r)
{
    integer q;
    int64_t out;

    read_hex(&q, r, Q_BITS);
    if (!integer_get_small(&out, q, INT64_C(1) << (Q_BITS - 1)) || out < 0)
        cannot_check_at(r->c->file, r->line, 0, "%s: expected a number in 0..2^47", r->name);
    return out;
}

/* There is one more of a kind of record. */
static void count_record(int *count, int limit, const struct certificate *c,
                         const char *name)
{
    if (++*count > limit)
        cannot_check_at(c->file, c->line, 0, "expected at most %d records `%s`", limit,
                        name);
}

/* `rise` or `wave` */
static void read_rises(struct certificate *c, bool wave)
{
    const char *name = wave ? "wave" : "rise";

    c->rise = allocate(MAX_RISES, sizeof c->rise[0]);
    while (next_is(c, name)) {
        struct rise *rise = &c->rise[c->rises];
        struct record r;

        count_record(&c->rises, MAX_RISES, c, name);
        if (c->rises * c->size * c->size > MAX_GROUP_INTEGERS)
            cannot_check_at(c->file, c->line, 0, "expected at most %d integers in the groups of "
                            "`%s`", MAX_GROUP_INTEGERS, name);
        r = begin_noted(c, name, &rise->record.line);
        rise->q = read_q(&r);
        rise->record.m = (struct span) { wave ? 2 : 1, ENDLESS };
        rise->record.power = (int)read_decimal(&r, 0, MAX_POWER);
        end_record(&r);
        read_eigenpair(&rise->pair, c);
        if (wave)
            read_trees(&rise->boundary, c, "boundary");
    }
}

static void read_covers(struct certificate *c)
{
    c->cover = allocate(MAX_COVERS, sizeof c->cover[0]);
    while (c->covers == 0 || next_is(c, "cover")) {
        struct cover *cover = &c->cover[c->covers];
        struct block_record *b = &cover->record;
        struct record r;

        count_record(&c->covers, MAX_COVERS, c, "cover");
        r = begin_noted(c, "cover", &b->line);
        b->m.first = read_decimal(&r, 0, MAX_VALENCE_1);
        b->m.last = read_decimal_or_inf(&r, 0, MAX_VALENCE_1);
        cover->q = read_q(&r);
        b->power = (int)read_decimal(&r, 0, MAX_POWER);
        end_record(&r);
    }
}

static void read_decisions(struct certificate *c)
{
    struct record r = begin_noted(c, "halfplane", &c->line_of.halfplane);
    integer component;

    for (int i = 0; i < 2; i++) {
        read_hex(&component, &r, NORMAL_BITS);
        if (!integer_get_small(&c->normal[i], component, INT64_C(1) << NORMAL_BITS))
            rejected(c->file, r.line, "halfplane: expected a small number");
    }
    end_record(&r);
    read_trees(&c->regularity, c, "regularity");
    read_trees(&c->boundary, c, "boundary");
}

/* What proves the rest at several valences. */
static void read_ranges(struct certificate *c)
{
    read_two_blocks(c);
    if (c->claim == CLAIM_C1)
        read_rises(c, false);
    read_covers(c);
}

/* A window of frequencies. */
static void read_window(struct certificate *c)
{
    struct record r = begin_noted(c, "window", &c->line_of.window);
    int line;

    c->window = read_q(&r);
    end_record(&r);
    read_hex_record(&c->bound, 1, c, "bound", c->grid + BITS_ABOVE_GRID, &line);
    if (c->bound.sign <= 0)
        rejected(c->file, line, "bound: it is not positive");
    read_rises(c, true);
}

/* `witness D P`: P digits from 0 to 3, or `-` */
static void read_witness(struct certificate *c)
{
    struct witness *w = &c->witness[c->witnesses++];
    struct record r = begin_noted(c, "witness", &w->line);

    w->element = read_decimal(&r, 0, MAX_ELEMENTS);
    w->path = next_token(&w->path_size, &r);
    end_record(&r);
    if (token_is(w->path, w->path_size, "-"))
        w->path_size = 0;
    for (size_t i = 0; i < w->path_size; i++)
        if (w->path[i] < '0' || w->path[i] > '3')
            rejected(c->file, w->line, "witness: expected digits from 0 to 3, or `-`");
}

static void read_refutation(struct certificate *c)
{
    if (c->reason == REASON_FREQUENCY || c->reason == REASON_WINDING)
        read_trees(&c->boundary, c, "boundary");
    if (c->reason == REASON_NOT_C0 || c->reason == REASON_FOLD || c->reason == REASON_REAL)
        read_witness(c);
    if (c->reason == REASON_FOLD)
        read_witness(c);
}

/* `second m'` and its eigenpair: its form is plain for 0, which is for k/2 only, else real. */
static void read_second(struct certificate *c, const int n[2])
{
    struct certificate own = *c;
    int line;

    own.frequency = read_decimal_record(&own, "second", 0, MAX_VALENCE_1, &line);
    if (2 * own.frequency >= c->valence.first || (own.frequency == 0 && !is_half(c)))
        rejected(c->file, line, "second: it is not between 0 and k/2");
    read_form(&own);
    if (!own.real)
        rejected(c->file, own.line_of.form, "form: expected `real`, or for frequency 0 `plain`");
    own.n = own.size = own.frequency == 0 ? n[0] : n[1];
    read_eigenpair(&own.second, &own);
    c->second_frequency = own.frequency;
    c->second = own.second;
    c->next = own.next;
    c->line = own.line;
}

/* Exact ties
 * ---------- */

/* g: for each coefficient Q > 0 and d numerators, without a common divisor. */
static void read_factor(struct certificate *c, int d)
{
    struct exact_choices *e = &c->exact;

    e->degree = (int)read_decimal_record(c, "factor", 0, MAX_FACTOR, &e->line_of.factor);
    if (e->degree < 1)
        rejected(c->file, e->line_of.factor, "factor: its degree is not positive");
    e->coefficient = allocate((size_t)e->degree * (size_t)(d + 1), sizeof e->coefficient[0]);
    for (int i = 0; i < e->degree; i++) {
        integer *q = &e->coefficient[i * (d + 1)], gcd;
        int line;

        read_hex_record(q, d + 1, c, "coefficient", RATIONAL_BITS, &line);
        gcd = q[0];
        for (int part = 1; part <= d; part++)
            gcd = integer_gcd(gcd, q[part]);
        if (q[0].sign <= 0 || integer_bits(gcd) != 1)
            rejected(c->file, line, "coefficient: its denominator is not positive, or it is "
                     "not in lowest terms");
    }
}

/* `1` or `-1` */
static int read_sign(struct record *r)
{
    size_t size;
    const char *token = next_token(&size, r);

    if (!token_is(token, size, "1") && !token_is(token, size, "-1"))
        rejected(r->c->file, r->line, "%s: expected 1 or -1 for s", r->name);
    return size == 1 ? 1 : -1;
}

static void read_exact_record(struct exact_record *out, struct certificate *c)
{
    struct record r = begin_noted(c, "exact", &out->record.line);

    out->m = read_decimal(&r, 0, MAX_VALENCE_1);
    out->sign = read_sign(&r);
    out->a = (int)read_decimal(&r, 0, MAX_EXACT_ORDER);
    out->q = (int)read_decimal(&r, 0, MAX_EXACT_ORDER);
    out->j = (int)read_decimal(&r, 0, MAX_PIVOT);
    out->record.power = (int)read_decimal(&r, 0, MAX_POWER);
    out->record.m = span_of(out->m);
    end_record(&r);
    if (2 * out->m > c->valence.first || (out != c->exact.line && out->m <= out[-1].m))
        rejected(c->file, r.line, "exact: frequencies have to rise, up to k/2");
    if (out->q < 1 || out->q > out->a)
        rejected(c->file, r.line, "exact: it must be 1 <= q <= a");
}

static void read_exact_records(struct certificate *c)
{
    struct exact_choices *e = &c->exact;

    e->line = allocate(MAX_EXACT, sizeof e->line[0]);
    while (e->count == 0 || next_is(c, "exact")) {
        if (e->count == MAX_EXACT)
            cannot_check_at(c->file, c->line, 0, "expected at most %d exact blocks", MAX_EXACT);
        read_exact_record(&e->line[e->count], c);
        e->count++;
    }
}

/* What proves the eigenvalue and bounds the rest. */
static void read_root(struct certificate *c, int d)
{
    struct exact_choices *e = &c->exact;
    int bits = c->grid + BITS_ABOVE_GRID, line;

    read_factor(c, d);
    read_hex_record(&e->eigenvalue, 1, c, "eigenvalue", bits, &e->line_of.eigenvalue);
    read_hex_record(&e->radius, 1, c, "radius", bits, &line);
    if (e->radius.sign <= 0)
        rejected(c->file, line, "radius: it is not positive");
    e->others.power = (int)read_decimal_record(c, "others", 0, MAX_POWER, &e->others.line);
}

/* The records of exact.md from `field` on. */
static void read_exact(struct certificate *c)
{
    struct exact_choices *e = &c->exact;
    int d;

    c->frequency = -1;
    e->field = (int)read_decimal_record(c, "field", MIN_FIELD, MAX_FIELD, &e->line_of.field);
    d = field_degree(e->field);
    if (d > MAX_DEGREE)
        cannot_check_at(c->file, e->line_of.field, 0, "field: its degree is beyond %d",
                        MAX_DEGREE);
    if (c->reason != REASON_MODULUS_ONE)
        read_root(c, d);
    read_exact_records(c);
    if (c->reason == REASON_MODULUS_ONE && e->count > 1)
        rejected(c->file, e->line[1].record.line, "exact: expected one only");
    if (c->reason != REASON_MODULUS_ONE)
        read_blocks(c);
    check_total_power(c);
    if (c->reason == REASON_JORDAN)
        read_trees(&c->boundary, c, "boundary");
    for (int i = 0; i < (c->reason == REASON_TIE ? 2 : 1) && c->reason != REASON_JORDAN; i++)
        read_witness(c);
}

void certificate_read_form(struct certificate *out, bool plainly_regular)
{
    struct record r = begin_noted(out, "contraction", &out->line_of.contraction);

    for (int i = 0; i < 3; i++)
        out->contraction[i] = (int)read_decimal(&r, 1, MAX_CONTRACTION);
    end_record(&r);
    out->real = true;
    out->frequency = 1;
    for (int i = 0; i < 3; i++)
        out->stability[i] = 1024;
    if (out->version == 0 || plainly_regular)
        return;
    r = begin_noted(out, "stability", &out->line_of.stability);
    for (int i = 0; i < 3; i++) {
        out->stability_power[i] = (int)read_decimal(&r, 0, MAX_STABILITY_POWER);
        out->stability[i] = read_decimal(&r, 0, MAX_STABILITY);
    }
    end_record(&r);
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

void certificate_read_choices(struct certificate *out, int n, const int n_second[2])
{
    out->has_splines = out->version > 0 && out->claim == CLAIM_C1;
    out->n = n;
    out->size = out->real ? n : 2 * n;
    if (out->size > (out->version == 0 ? MAX_UNKNOWNS_0 : MAX_UNKNOWNS_1))
        cannot_check("%s: blocks of %d unknowns", out->file, out->size);
    if (out->graded)
        read_grades(out);
    if (out->frequency < 0)
        read_window(out);
    else
        read_eigenpair(&out->pair, out);
    if (out->reason == REASON_REAL)
        read_second(out, n_second);
    if (out->version == 0)
        read_powers_0(out);
    else if (out->reason != REASON_NOT_C0 && span_is_several(out->valence))
        read_ranges(out);
    else if (out->reason != REASON_NOT_C0)
        read_blocks(out);
    check_total_power(out);
    if (out->claim == CLAIM_C1)
        read_decisions(out);
    else if (out->frequency >= 0)
        read_refutation(out);
}

/* `records` counts the lines above it, `sha256` is the hash of all bytes above
 * it, and nothing follows. */
void certificate_read_end(struct certificate *c)
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
