/* certificate_read.c: reading what certificate.c writes. */
#include "certificate.h"

#include "certificate_exact.h"

#include <stdlib.h>
#include <string.h>

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
        if (!tree_is_letter(word[i]))
            r->failed = true;
        else if (!tree_put(z, word[i]))
            r->no_memory = r->failed = true;
    }
}

/* Is the next word this one?  Takes nothing. */
static bool comes_next(const reader *r, const char *name)
{
    reader ahead = *r;
    expect(&ahead, name);
    return !ahead.failed;
}

/* The order of the block follows from the number of words of the line. */
static int count_words(const reader *r)
{
    int count = 0;
    for (const char *p = r->at; p < r->end && *p != '\n'; p++)
        count += *p == ' ';
    return count;
}

/* Of block 0 without a pair it is plain. */
static bool read_form(reader *r, bool plain)
{
    bool complex_form;
    expect(r, "form");
    complex_form = comes_next(r, "complex");
    expect(r, complex_form ? "complex" : plain ? "plain" : "real");
    return complex_form;
}

static void read_reason(reader *r, choices *c)
{
    expect(r, "reason");
    c->claim = CLAIM_C1;
    for (claim_kind k = CLAIM_FREQUENCY; k < CLAIM_WINDOW; k++)
        if (comes_next(r, claim_name(k)))
            c->claim = k;
    if (c->claim == CLAIM_C1)
        r->failed = true;
    else
        expect(r, claim_name(c->claim));
    if (claim_is_exact(c->claim))
        return;
    expect(r, "frequency");
    if (c->claim == CLAIM_FREQUENCY && !is_one_valence(c->k) && comes_next(r, "window")) {
        expect(r, "window");
        c->claim = CLAIM_WINDOW;
        return;
    }
    c->frequency = read_long(r, 10, 0, is_one_valence(c->k) ? c->k.first / 2 : (c->k.first - 1) / 2);
    if (((c->claim == CLAIM_FOLD || c->claim == CLAIM_WINDING) && c->frequency != 1) || (c->claim == CLAIM_FREQUENCY && c->frequency == 1))
        r->failed = true;
}

static void read_witness(reader *r, witness_choice *z)
{
    const char *word;
    size_t length;
    expect(r, "witness");
    z->element = (int)read_long(r, 10, 0, 1L << 30);
    length = next_word(r, &word);
    z->depth = 0;
    if (length == 1 && *word == '-')
        return;
    if (length == 0 || length > TREE_MAX_DEPTH) {
        r->failed = true;
        return;
    }
    memcpy(z->path, word, length);
    z->path[length] = '\0';
    z->depth = (int)length;
}

/* A radius: positive. */
static void read_radius(reader *r, integer *z, const char *name)
{
    expect(r, name);
    read_integer(r, z, 16);
    if (integer_sign(z) <= 0)
        r->failed = true;
}

/* With the radius of the range, if `several` valences have it. */
static void read_eigenpair(reader *r, eigenpair_choice *e, long grid, bool complex_form, bool several)
{
    integer eigenvalue[2];
    int values = complex_form ? 2 : 1, n, pivot;
    expect(r, "pivot");
    pivot = (int)read_long(r, 10, 1, CHOICES_MAX_ORDER);
    integer_init(&eigenvalue[0]);
    integer_init(&eigenvalue[1]);
    expect(r, "eigenvalue");
    for (int i = 0; i < values; i++)
        read_integer(r, &eigenvalue[i], 16);
    n = count_words(r) + values;
    if (n / values < pivot || n > CHOICES_MAX_ORDER || n % values)
        r->failed = true;
    if (!r->failed && !eigenpair_choice_make(e, n, grid))
        r->no_memory = r->failed = true;
    e->complex_form = complex_form;
    e->pivot = pivot - 1;
    expect(r, "eigenvector");
    for (int i = 0; !r->failed && i < n - values; i++)
        read_integer(r, &e->approximation[i], 16);
    for (int i = 0; !r->failed && i < values; i++)
        integer_swap(&e->approximation[n - values + i], &eigenvalue[i]);
    read_radius(r, &e->radius, "radius");
    if (several)
        read_radius(r, &e->range, "range");
    for (int i = 0; !r->failed && i < n; i++) {
        expect(r, "inverse");
        for (int j = 0; !r->failed && j < n; j++)
            read_integer(r, &e->inverse[i * n + j], 16);
    }
    integer_clear(&eigenvalue[0]);
    integer_clear(&eigenvalue[1]);
}

static void read_form_and_pair(reader *r, choices *c, eigenpair_choice *e, bool plain, bool several)
{
    bool complex_form = read_form(r, plain);
    read_eigenpair(r, e, c->grid, complex_form, several);
    if (complex_form) {
        expect(r, "modulus");
        read_integer(r, &c->modulus, 16);
    }
}

/* Not c0, by an eigenvalue that grows? */
static bool is_graded(const reader *r, const choices *c)
{
    reader ahead = *r;
    expect(&ahead, "form");
    expect(&ahead, "graded");
    return !ahead.failed && c->claim == CLAIM_NOT_C0 && c->frequency == 0 && !is_one_valence(c->k);
}

static void read_graded(reader *r, choices *c)
{
    graded_choice *z = &c->graded;
    long unit;
    int degree, n;
    c->claim = CLAIM_GRADED;
    expect(r, "form");
    expect(r, "graded");
    expect(r, "unit");
    unit = read_long(r, 10, 1, GRADED_MAX_UNIT);
    expect(r, "degree");
    degree = (int)read_long(r, 10, 0, GRADED_MAX_DEGREE);
    n = count_words(r);
    if (n < 1 || n > CHOICES_MAX_ORDER)
        r->failed = true;
    else if (!graded_choice_make(z, n))
        r->no_memory = r->failed = true;
    z->unit = unit;
    z->degree = degree;
    expect(r, "grades");
    for (int i = 0; !r->failed && i < n; i++)
        z->grade[i] = (int)read_long(r, 10, 0, GRADED_MAX_DEGREE);
    read_eigenpair(r, &c->eigenpair, c->grid, false, true);
}

/* Blocks 0 and k/2 are real: complex form means a pair, and without one k/2 is for CLAIM_REAL only. */
static void set_pair(reader *r, choices *c)
{
    bool half = is_one_valence(c->k) && 2 * c->frequency == c->k.first, may_be = is_one_valence(c->k) && c->claim != CLAIM_REAL;
    c->pair = c->eigenpair.complex_form && may_be && (c->frequency == 0 || half);
    if (!c->pair && (c->frequency == 0 ? c->eigenpair.complex_form : half && c->claim != CLAIM_REAL))
        r->failed = true;
}

static void read_pair(reader *r, choices *c, bool several)
{
    read_form_and_pair(r, c, &c->eigenpair, c->frequency == 0, several);
    set_pair(r, c);
    if (c->claim != CLAIM_REAL)
        return;
    expect(r, "second");
    c->second_frequency = read_long(r, 10, c->frequency == 0, (c->k.first - 1) / 2);
    read_form_and_pair(r, c, &c->second, c->second_frequency == 0, several);
    if (c->second_frequency == 0 && c->second.complex_form)
        r->failed = true;
}

/* Of all blocks of a certificate together. */
static int read_power(reader *r, long *total)
{
    int power = (int)read_long(r, 10, 0, CHOICES_MAX_POWER);
    *total += power;
    if (*total > CHOICES_MAX_TOTAL_POWER)
        r->failed = true;
    return power;
}

static void read_window(reader *r, choices *c, long *total)
{
    window_choice *w = &c->window;
    read_form(r, false);
    expect(r, "window");
    w->start = read_long(r, 16, 0, ARC_HALF);
    expect(r, "bound");
    read_integer(r, &w->bound, 16);
    while (!r->failed && comes_next(r, "wave")) {
        window_wave *wave = w->count < CHOICES_MAX_RISES ? window_choice_add(w) : NULL;
        if (!wave) {
            r->no_memory = w->count < CHOICES_MAX_RISES;
            r->failed = true;
            return;
        }
        expect(r, "wave");
        wave->q = read_long(r, 16, 0, ARC_HALF);
        wave->power = read_power(r, total);
        read_eigenpair(r, &wave->eigenpair, c->grid, false, true);
        read_tree(r, &wave->boundary, "boundary");
    }
}

static void read_blocks(reader *r, choices *c, long *total)
{
    while (!r->failed && comes_next(r, "block")) {
        frequencies m;
        int power;
        expect(r, "block");
        m.first = read_long(r, 10, 0, CHOICES_MAX_VALENCE);
        m.last = read_long(r, 10, 0, CHOICES_MAX_VALENCE);
        power = read_power(r, total);
        if (c->blocks.count >= CHOICES_MAX_BLOCKS)
            r->failed = true;
        else if (!r->failed && !cover_list_add(&c->blocks, m, power))
            r->no_memory = r->failed = true;
    }
}

/* What ends a range: a number or `inf`. */
static long read_last(reader *r, long low)
{
    if (!comes_next(r, "inf"))
        return read_long(r, 10, low, CHOICES_MAX_VALENCE);
    expect(r, "inf");
    return VALENCES_UNBOUNDED;
}

static void read_limit(reader *r, choices *c, long *total)
{
    c->has_limit = comes_next(r, "limit");
    if (!c->has_limit)
        return;
    expect(r, "limit");
    c->limit.power = read_power(r, total);
    read_eigenpair(r, &c->limit.eigenpair, c->grid, false, true);
}

static void read_rise(reader *r, choices *c, long *total)
{
    while (!r->failed && comes_next(r, "rise")) {
        rise_box *box = c->rise.count < CHOICES_MAX_RISES ? rise_list_add(&c->rise) : NULL;
        if (!box) {
            r->no_memory = c->rise.count < CHOICES_MAX_RISES;
            r->failed = true;
            return;
        }
        expect(r, "rise");
        box->q = read_long(r, 16, 0, ARC_HALF);
        box->power = read_power(r, total);
        read_eigenpair(r, &box->eigenpair, c->grid, false, true);
    }
}

static void read_spans(reader *r, choices *c, long *total)
{
    while (!r->failed && comes_next(r, "cover")) {
        span_box box;
        expect(r, "cover");
        box.m.first = read_long(r, 10, 0, CHOICES_MAX_VALENCE);
        box.m.last = read_last(r, box.m.first);
        box.q = read_long(r, 16, 0, ARC_HALF);
        box.power = read_power(r, total);
        if (c->spans.count >= CHOICES_MAX_BLOCKS)
            r->failed = true;
        else if (!r->failed && !span_list_add(&c->spans, box))
            r->no_memory = r->failed = true;
    }
}

static void read_exact(reader *r, choices *c)
{
    certificate_status s = r->failed ? CERTIFICATE_MALFORMED : certificate_read_exact(c, &r->at, r->end);
    r->failed = s != CERTIFICATE_READ;
    r->no_memory = r->no_memory || s == CERTIFICATE_NO_MEMORY;
}

static void read_evidence(reader *r, choices *c)
{
    long normal_limit = 1L << CHOICES_NORMAL_BITS;
    if (c->claim == CLAIM_C1) {
        expect(r, "halfplane");
        for (int i = 0; i < 2; i++)
            c->normal[i] = read_long(r, 16, 1 - normal_limit, normal_limit - 1);
        read_tree(r, &c->regularity, "regularity");
    }
    if (claim_has_boundary(c->claim))
        read_tree(r, &c->boundary, "boundary");
    for (int i = 0; i < claim_witnesses(c->claim); i++)
        read_witness(r, &c->witness[i]);
}

static void read_choices(reader *r, choices *c)
{
    bool c1, several;
    long total = 0; /* of powers */
    expect(r, "claim");
    c1 = comes_next(r, "c1");
    expect(r, c1 ? "c1" : "not-c1");
    expect(r, "valence");
    several = count_words(r) > 0;
    c->k = one_valence(read_long(r, 10, CHOICES_MIN_VALENCE, CHOICES_MAX_VALENCE));
    if (several)
        c->k.last = read_last(r, c->k.first + 1);
    expect(r, "grid");
    c->grid = read_long(r, 10, CHOICES_MIN_GRID, CHOICES_MAX_GRID);
    expect(r, "contraction");
    for (int i = 0; i < 3; i++)
        c->contraction[i] = (int)read_long(r, 10, 1, 10);
    c->plainly_regular = c1 && !several && comes_next(r, "records");
    if (r->failed || c->plainly_regular)
        return;
    expect(r, "stability");
    for (int i = 0; i < 3; i++) {
        c->stability[i].power = (int)read_long(r, 10, 0, 9);
        c->stability[i].bound = read_long(r, 10, 1024, 1L << 40);
    }
    if (!c1)
        read_reason(r, c);
    if (claim_is_exact(c->claim))
        read_exact(r, c);
    else if (c->claim == CLAIM_WINDOW)
        read_window(r, c, &total);
    else if (is_graded(r, c))
        read_graded(r, c);
    else
        read_pair(r, c, several);
    if (several && c1)
        read_limit(r, c, &total);
    read_blocks(r, c, &total);
    if (several && c1)
        read_rise(r, c, &total);
    if (several)
        read_spans(r, c, &total);
    if ((c->blocks.count || c->spans.count) && (c->claim == CLAIM_NOT_C0 || c->claim == CLAIM_GRADED || c->claim == CLAIM_MODULUS_ONE))
        r->failed = true; /* they need none */
    read_evidence(r, c);
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
    expect(&r, "1");
    expect(&r, "scheme");
    next_word(&r, &word);
    if ((size_t)(r.end - r.at) >= s->text_length)
        r.at += s->text_length; /* compared below */
    read_choices(&r, c);
    *line = text_lines(bytes, (size_t)(r.at - bytes)) + 1;
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
