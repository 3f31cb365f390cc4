/* The check of a certificate, in the order of certificate.md. */

#include "check.h"

#include "answer.h"
#include "certificate.h"
#include "characteristic.h"
#include "regular.h"
#include "spectrum.h"
#include "text.h"
#include "ties.h"
#include "valences.h"

#include <string.h>

enum { MAX_SCHEME_BYTES = 65536, MAX_CERTIFICATE_BYTES = 1 << 26 };

/* What has been proved of q_i, or of the pair (d,d') number i: the last choices that did. */
struct proved {
    int contraction[3];
    int stability_power[3];
    int64_t stability[3];
};

struct statement {
    const char *file;
    char *text, *canonical;
    size_t text_size, canonical_size;
    const struct setting *settings;
    int setting_count;
    bool not_c1;                                   /* the claim */

    bool is_read;                                  /* the scheme, what is below */
    struct scheme scheme;
    bool divisible;
    struct derived_masks derived;
    struct mask q[3];                              /* a, 2 a_1, 2 a_2 */
    struct proved proved;
};

/* Section 3
 * --------- */

/* Puts the value in place of that in the scheme's text. */
static void apply_setting(struct statement *s, const struct setting *setting)
{
    struct statements line = { s->file, 0, s->text, s->text + s->text_size };
    size_t before, behind, size = strlen(setting->value);
    struct cursor c;
    char *out;

    do
        if (!statements_more(&c, &line))
            cannot_check("--set: the scheme has no parameter `%s`", setting->name);
    while (!cursor_accept_word(&c, "parameter") || !cursor_accept_word(&c, setting->name) ||
           !cursor_accept(&c, '='));
    cursor_skip_blanks(&c);
    before = (size_t)(c.at - s->text);
    behind = s->text_size - (size_t)(c.end - s->text);
    out = allocate(before + size + behind + 1, 1);
    memcpy(out, s->text, before);
    memcpy(out + before, setting->value, size);
    memcpy(out + before + size, c.end, behind);
    s->text = out;
    s->text_size = before + size + behind;
}

struct statement *statement_new(const char *scheme_file, const struct setting *settings,
                                int setting_count, bool not_c1)
{
    struct statement *out = allocate(1, sizeof *out);

    out->file = scheme_file;
    out->settings = settings;
    out->setting_count = setting_count;
    out->not_c1 = not_c1;
    return out;
}

const char *statement_scheme_name(const struct statement *s)
{
    return s->scheme.name;
}

static void compare_subject(const struct certificate *c, const struct statement *s, struct span k)
{
    size_t same = 0;
    int line = c->line_of.scheme + 1;

    while (same < s->canonical_size && same < c->scheme_size &&
           s->canonical[same] == c->scheme_text[same]) {
        if (s->canonical[same] == '\n')
            line++;
        same++;
    }
    if (same < s->canonical_size || same < c->scheme_size)
        rejected(c->file, line, "scheme: expected the text of the given scheme");
    if (c->claim != (s->not_c1 ? CLAIM_NOT_C1 : CLAIM_C1))
        rejected(c->file, c->line_of.claim, "claim: expected %s", s->not_c1 ? "not-c1" : "c1");
    if (c->valence.first != k.first || c->valence.last != k.last)
        rejected(c->file, c->line_of.valence, "valence: expected %s", span_text(k));
}

static void read_statement(struct statement *s)
{
    s->text = text_read_file(s->file, MAX_SCHEME_BYTES, &s->text_size);
    for (int i = 0; i < s->setting_count; i++)
        apply_setting(s, &s->settings[i]);
    s->canonical = text_canonical(s->file, s->text, s->text_size, &s->canonical_size);
}

static void read_scheme(struct statement *s)
{
    scheme_read(&s->scheme, s->file, s->text, s->text_size);
    s->divisible = regular_derive(&s->derived, &s->scheme.mask, s->scheme.mesh);
    if (s->divisible) {
        s->q[0] = s->scheme.mask;
        s->q[1] = mask_double(&s->derived.first[0]);
        s->q[2] = mask_double(&s->derived.first[1]);
    }
    s->is_read = true;
}

/* Section 4
 * --------- */

static void check_contraction(struct statement *s, const struct certificate *c)
{
    int line = c->line_of.contraction;

    if (!s->divisible)
        rejected(c->file, line, "contraction: the mask's symbol is not divisible "
                 "by the factors that differences need");
    for (int i = 0; i < 3; i++) {
        struct mark mark = scratch_mark();

        if (s->proved.contraction[i] == c->contraction[i])
            continue;
        if (!regular_contracts(&s->derived.second[i], c->contraction[i]))
            rejected(c->file, line, "contraction: power %d of 2 a_%d has a norm of at "
                     "least 1", c->contraction[i], s->derived.name[i]);
        s->proved.contraction[i] = c->contraction[i];
        scratch_release(mark);
    }
}

/* Version 0 has no such record, and K = 1 for non-negative masks only. */
static void check_stability(struct statement *s, const struct certificate *c)
{
    int line = c->line_of.stability;
    bool mirrored = mask_is_mirrored(&s->scheme.mask);

    if (mirrored && (c->stability_power[2] != c->stability_power[1] ||
                     c->stability[2] != c->stability[1]))
        rejected(c->file, line, "stability: expected the same for both derivatives");
    for (int i = 0; i < (mirrored ? 2 : 3); i++) {
        int n = c->stability_power[i];
        int64_t t = c->stability[i];

        if (mask_is_nonnegative(&s->q[i])) {
            if (n != 0 || t != 1024)
                rejected(c->file, line, "stability: expected 0 1024 for q_%d", i);
            continue;
        }
        if (n > 0 && s->proved.stability_power[i] == n && s->proved.stability[i] == t)
            continue;                              /* n = 0: nothing is proved yet */
        if (n < 1 || t <= 1024 || !stability_holds(&s->q[i], n, t))
            rejected(c->file, line, "stability: %lld/1024 is not proved for q_%d, which has "
                     "negative weights", (long long)t, i);
        s->proved.stability_power[i] = n;
        s->proved.stability[i] = t;
    }
}

/* Sections 5 and 6
 * ---------------- */

/* An eigenpair of a block with the matrix b, and the choices for it. */
struct proved_pair {
    const struct certificate *choices;
    const struct block *block;
    const struct affine *b;
    struct eigenpair pair;
};

/* The rest: all blocks, those of the pairs first, each with what its certificate says; `real` is
 * the form of the others, and s is that of the pairs. */
static void check_rest(const struct proved_pair *proved, int count, const struct valence *valence,
                       bool real, interval s, const struct certificate *c)
{
    const char *name = c->version == 0 ? "power" : "block";

    for (int i = 0; i < 2 * c->blocks; i++) {
        const struct block_record *record = &c->block[i % c->blocks];
        struct mark mark = scratch_mark();
        struct valence v = *valence;
        struct span m = record->m;
        const struct proved_pair *own = NULL;
        struct block other;

        for (int n = 0; n < count; n++)
            if (m.first == proved[n].choices->frequency)
                own = &proved[n];
        if (i < c->blocks && own != NULL)
            spectrum_prove_rest(&own->pair, record, name, own->choices);
        if (i < c->blocks || own != NULL)
            continue;
        v.reference.line = record->line;
        if (m.first > 1 && m.first == m.last && !valence_has_values(&v, m.first))
            m.first--;                             /* a box of its own is too long */
        block_prepare(&other, &v, real, m);
        spectrum_prove_block(&other, s, record, name, c);
        scratch_release(mark);
    }
}

/* The eigenpair of the block.  For m = 0 it is about differences, in the complex form twice. */
static struct proved_pair prove_pair(const struct block *block, const struct certificate *c)
{
    struct proved_pair out = { .choices = c, .block = block, .b = block_matrix(block) };
    const struct affine *matrix = out.b;

    if (block->plain)
        matrix = spectrum_without_constants(out.b, block->n);
    if (block->plain && block->has_y)
        matrix = spectrum_doubled(matrix, block->n - 1);
    out.pair = eigenpair_prove(matrix, &c->pair, c);
    spectrum_prove_size(&out.pair, c);
    return out;
}

/* Its net. */
static void prepare_net(struct characteristic *out, struct proved_pair *p, const struct mask q[3])
{
    if (p->block->plain)
        spectrum_add_constants(&p->pair, p->b, p->block->n, !p->choices->real, p->choices);
    characteristic_prepare(out, p->block, &p->pair, q, p->choices);
}

/* All of it
 * --------- */

/* |L|; that of c1 in real form is L.  (Complex form: |L|^2 > 0 has been proved.) */
static interval eigenvalue_size(const struct eigenpair *pair, const struct certificate *c)
{
    struct pair l = { pair->real, pair->imaginary };

    return c->real ? interval_abs(affine_range(l.x))
                   : grid_root(affine_range(pair_norm(l, c->grid)), c->grid);
}

/* Section 10, `real`. */
static struct verified check_real(const struct statement *s, const struct block *block,
                                  const struct certificate *c)
{
    struct certificate own = *c;
    struct proved_pair proved[2];
    struct characteristic *net = allocate(2, sizeof net[0]);
    interval modulus[2];
    struct block other;

    own.frequency = c->second_frequency;
    own.pair = c->second;
    block_prepare(&other, block->v, true, span_of(own.frequency));
    own.n = own.size = other.plain ? other.n - 1 : other.n;
    proved[0] = prove_pair(block, c);
    proved[1] = prove_pair(&other, &own);
    for (int i = 0; i < 2; i++)
        modulus[i] = interval_abs(affine_range(proved[i].pair.real));
    if (integer_compare(modulus[1].hi, modulus[0].lo) >= 0)
        rejected(c->file, c->second.line_of.eigenvalue,
                 "eigenvalue: |l'| is not proved to be smaller than |l|");
    proved[0].pair.s = proved[1].pair.s;
    check_rest(proved, 2, block->v, true, proved[1].pair.s, c);
    for (int i = 0; i < 2; i++)
        prepare_net(&net[i], &proved[i], s->q);
    decide_independent(&net[0], &net[1], c);
    return (struct verified) { .frequency = c->frequency, .g = c->grid, .eigenvalue = modulus[0] };
}

/* exact.md. */
static struct verified check_ties(const struct statement *s, const struct valence *v,
                                  const struct certificate *c)
{
    struct tie tie = tie_prove(v, s->q, c);

    check_rest(NULL, 0, v, s->scheme.mirrored, tie.s, c);
    return (struct verified) { .real = false, .frequency = tie.frequency,
                               .eigenvalue = tie.lambda, .exact = c->reason == REASON_MODULUS_ONE,
                               .g = c->grid };
}

/* One eigenpair, and what its function decides.  The plain form says nothing about the form of
 * the other blocks. */
static struct verified check_eigenpair(struct statement *s, const struct block *block,
                                       const struct certificate *c)
{
    const struct valence *v = block->v;
    struct verified out = { .real = c->real && !s->not_c1, .frequency = c->frequency,
                            .g = c->grid };
    struct proved_pair proved = prove_pair(block, c);
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);

    if (c->reason != REASON_NOT_C0 && span_is_several(c->valence))
        valences_prove_rest(v, &proved.pair, c);
    else
        check_rest(&proved, 1, v, c->real && block->plain ? v->scheme->mirrored : c->real,
                   proved.pair.s, c);
    if (c->version == 0)
        check_stability(s, c);
    prepare_net(characteristic, &proved, s->q);
    decide_claim(characteristic, c);
    out.eigenvalue = eigenvalue_size(&proved.pair, c);
    return out;
}

/* The block that the certificate's choices are about; of a window any one of as many unknowns. */
static void prepare_block(struct block *out, const struct valence *v, const struct certificate *c)
{
    if (c->graded)
        graded_prepare_block(out, v);
    else if (span_is_several(c->valence))
        valences_prepare_block(out, v, c->frequency < 0 ? 1 : c->frequency);
    else
        block_prepare(out, v, c->real, span_of(c->frequency));
    out->has_y = out->has_y || !c->real;
}

static struct verified check_choices(struct statement *s, struct certificate *c)
{
    struct reference reference = { c->version == 0 ? NULL : c->file, c->line_of.scheme };
    struct valence *v = allocate(1, sizeof *v);
    struct verified out = { .real = true, .g = c->grid };
    bool several = span_is_several(c->valence);
    struct block block;
    int n[2];                                      /* unknowns: of block 0, of others */

    valence_prepare(v, &s->scheme, reference, c->valence, c->grid);
    out.plainly_regular = v->plainly_regular && c->version > 0;
    if (s->not_c1 && (c->version == 0 || out.plainly_regular))
        rejected(c->file, c->line_of.claim, "claim: there is no such certificate");
    certificate_read_form(c, out.plainly_regular);
    if (out.plainly_regular) {
        certificate_read_end(c);
        check_contraction(s, c);
        return out;
    }
    if (certificate_is_exact(c)) {
        certificate_read_end(c);
        check_contraction(s, c);
        check_stability(s, c);
        return check_ties(s, v, c);
    }
    if ((c->real && (c->frequency != 0 || several) && !s->scheme.mirrored) ||
        (c->reason == REASON_REAL && !(c->real && s->scheme.mirrored)))
        rejected(c->file, c->line_of.form, "form: %s", s->scheme.mirrored
                 ? "expected `real`" : "the scheme is not evidently mirror-symmetric");
    prepare_block(&block, v, c);
    /* Section 5: one for each point, as x and y at (a,b), a > b, are for (b,a), too; in block 0 one
     * for the centre besides. */
    n[1] = block.plain && s->scheme.mesh != DUAL ? block.n - 1 : block.n;
    n[0] = c->graded ? block.n : s->scheme.mesh != DUAL ? n[1] : n[1] - 1;
    certificate_read_choices(c, n);
    certificate_read_end(c);

    check_contraction(s, c);
    if (c->version > 0)
        check_stability(s, c);
    if (c->frequency < 0)
        return (struct verified) { .frequency = -1, .g = c->grid,
                                   .eigenvalue = window_prove(v, s->q, c) };
    if (c->graded)
        return (struct verified) { .g = c->grid, .unit = c->unit, .degree = c->degree,
                                   .eigenvalue = graded_prove(&block, s->q, c) };
    if (c->reason == REASON_REAL)
        return check_real(s, &block, c);
    return check_eigenpair(s, &block, c);
}

struct span check_valences(const char *file)
{
    struct mark mark = scratch_mark();
    struct certificate *c = allocate(1, sizeof *c);
    struct span out;
    size_t size;
    const char *text = text_read_file(file, MAX_CERTIFICATE_BYTES, &size);

    certificate_read_subject(c, file, text, size);
    out = c->valence;
    scratch_release(mark);
    return out;
}

struct verified check_certificate(struct statement *s, struct span k, const char *file)
{
    struct certificate *c;
    struct verified out;
    struct mark mark;
    size_t size;
    char *bytes;

    if (!s->is_read)
        read_statement(s);
    mark = scratch_mark();
    c = allocate(1, sizeof *c);
    bytes = text_read_file(file, MAX_CERTIFICATE_BYTES, &size);
    certificate_read_subject(c, file, bytes, size);
    compare_subject(c, s, k);
    if (!s->is_read) {
        read_scheme(s);
        mark = scratch_mark();
    }
    if (c->version == 0 && !scheme_is_of_version_0(&s->scheme))
        cannot_check("%s: expected a scheme of version 0 (verify/scheme-0.md)", s->file);
    out = check_choices(s, c);
    interval_keep(mark, &out.eigenvalue, 1);
    return out;
}
