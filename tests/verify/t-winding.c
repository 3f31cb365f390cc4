/* t-winding.c: maps that wind several times or the wrong way round, and pairs of eigenvalues of the blocks 0 and k/2: what is
   refuted, in all number systems, what is not, and that choices that were changed prove nothing.

   The schemes are those of tests/certificates/schemes.  How often they wind is known from the way they are made, and from a
   computation with the matrix of the whole complex. */
#include "common.h"

static void subject_from_file(subject *z, const char *name, const char *parameter)
{
    const char *parameters[] = {parameter};
    scheme_settings settings = {parameters, parameter != NULL};
    diagnostic d = {0, 0, ""};
    char path[1024];
    buffer text;
    buffer_init(&text);
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    snprintf(path, sizeof path, "%s/tests/certificates/schemes/%s.scheme", getenv("SRCDIR"), name);
    MUST(buffer_read_file(&text, path, 1 << 16));
    if (scheme_read(&z->scheme, text.bytes, text.length, &settings, &d) != STATUS_OK) {
        CHECK(false, "%s %s: %ld:%ld: %s", name, parameter ? parameter : "", d.line, d.column, d.text);
        test_end();
        exit(1);
    }
    MUST(problem_make(&z->problem, &z->scheme));
    buffer_clear(&text);
}

typedef struct {
    const char *scheme, *parameter;
    long valence;
    claim_kind claim;
    long frequency;
    bool pair;
    long windings; /* 0: it cannot be claimed */
} statement_case;

static const statement_case cases[] = {
    {"winding-triangle", NULL, 3, CLAIM_WINDING, 1, false, -2},
    {"winding-negative", NULL, 3, CLAIM_WINDING, 1, false, -2},
    {"winding-quad", NULL, 3, CLAIM_WINDING, 1, false, -2},
    {"winding-quad", NULL, 4, CLAIM_WINDING, 1, false, -3},
    {"winding-quad", NULL, 5, CLAIM_WINDING, 1, false, -4},
    {"winding-quad", NULL, 6, CLAIM_WINDING, 1, false, -5},
    {"winding-forward", NULL, 3, CLAIM_WINDING, 1, false, 4},
    {"winding-spiral", NULL, 3, CLAIM_WINDING, 1, false, -2},
    {"winding-spiral", NULL, 20, CLAIM_WINDING, 1, false, -19},
    {"winding-spiral", "turns=1", 3, CLAIM_WINDING, 1, false, 4}, /* these fold, too */
    {"winding-spiral", "turns=1", 4, CLAIM_WINDING, 1, false, 5},
    {"winding-spiral", "turns=1", 8, CLAIM_WINDING, 1, false, 9},
    {"winding-spiral", "turns=0", 3, CLAIM_WINDING, 1, false, 0},
    {"winding-spiral", "turns=0", 8, CLAIM_WINDING, 1, false, 0},
    {"winding-quad", NULL, 8, CLAIM_WINDING, 1, false, 0}, /* block 2 dominates */
    {"pair-cups", NULL, 5, CLAIM_FREQUENCY, 0, true, 1},
    {"pair-cups", NULL, 5, CLAIM_FREQUENCY, 0, false, 0},
    {"pair-cups", NULL, 5, CLAIM_NOT_C0, 0, true, 0},
    {"pair-cups", "c=7/8", 5, CLAIM_FREQUENCY, 0, true, 0}, /* smaller than l */
    {"pair-cups", "im=29/100", 5, CLAIM_FREQUENCY, 0, true, 1},
    {"pair-cups", "re=2/5", 5, CLAIM_FREQUENCY, 0, true, 0},
    {"pair-cups", "im=0", 5, CLAIM_FREQUENCY, 0, true, 0}, /* twice the same, which is real */
    {"pair-cups", "im=1", 5, CLAIM_NOT_C0, 0, true, 1},
    {"pair-cups", "im=1", 5, CLAIM_FREQUENCY, 0, true, 0},
    {"pair-saddles", NULL, 6, CLAIM_FREQUENCY, 3, true, 1},
    {"pair-saddles", NULL, 8, CLAIM_FREQUENCY, 4, true, 1},
    {"pair-saddles", "re=2/5", 6, CLAIM_FREQUENCY, 3, true, 0},
    {"pair-saddles", "re=0", 6, CLAIM_FREQUENCY, 3, true, 0},
    {"pair-saddles", "re=1", 4, CLAIM_NOT_C0, 2, true, 1},
};
enum { CASES = sizeof cases / sizeof *cases };

static outcome search(findings *f, choices *c, const subject *s, const statement_case *t, long precision)
{
    analysis_plan plan = {.problem = &s->problem, .deadline = &(deadline){0}, .system = "test", .max_level = 12};
    findings_init(f);
    choices_init(c);
    c->claim = t->claim;
    c->k = one_valence(t->valence);
    c->frequency = t->frequency;
    c->pair = t->pair;
    return analysis_search(f, c, &plan, precision);
}

static outcome follow(findings *f, choices *c, const subject *s)
{
    analysis_plan plan = {.problem = &s->problem, .deadline = &(deadline){0}, .system = "grid"};
    findings_init(f);
    return analysis_replay(f, c, &plan);
}

/* What was found is written, read back and followed, with the same number of windings. */
static void check_certificate(const subject *s, const statement_case *t, const choices *found)
{
    buffer text;
    choices c;
    findings f;
    long line = -1;
    buffer_init(&text);
    choices_init(&c);
    certificate_write(&text, &s->scheme, found);
    MUST(!text.failed && certificate_read(&c, &line, &s->scheme, text.bytes, text.length));
    CHECK(line == 0 && c.claim == t->claim && c.frequency == t->frequency && c.pair == t->pair, "%s: the certificate reads back otherwise (line %ld)", t->scheme, line);
    CHECK(follow(&f, &c, s) == OUTCOME_TRUE, "%s: %s", t->scheme, findings_last(&f)->reason);
    CHECK(t->claim != CLAIM_WINDING || f.windings == t->windings, "%s: winds %ld times by its certificate", t->scheme, f.windings);
    findings_clear(&f);
    choices_clear(&c);
    buffer_clear(&text);
}

static void test_known(void)
{
    static const long precisions[] = {0, 64, 128, 512};
    test_begin("winding-known");
    for (int i = 0; i < CASES; i++) {
        const statement_case *t = &cases[i];
        subject s;
        subject_from_file(&s, t->scheme, t->parameter);
        for (size_t p = 0; p < sizeof precisions / sizeof *precisions; p++) {
            choices c;
            findings f;
            outcome o = search(&f, &c, &s, t, precisions[p]);
            CHECK((o == OUTCOME_TRUE) == (t->windings != 0), "%s %s at %ld, %ld bits: %s", t->scheme, t->parameter ? t->parameter : "", t->valence, precisions[p], findings_last(&f)->reason);
            CHECK(o != OUTCOME_TRUE || t->claim != CLAIM_WINDING || f.windings == t->windings, "%s at %ld winds %ld times", t->scheme, t->valence, f.windings);
            if (o == OUTCOME_TRUE)
                check_certificate(&s, t, &c);
            findings_clear(&f);
            choices_clear(&c);
        }
        subject_clear(&s);
    }
    test_end();
}

/* Maps that wind once, in the catalogue. */
static void test_once(void)
{
    static const char *const names[] = {"loop", "catmull-clark", "doo-sabin", "kobbelt", "loop-spiral", "modified-butterfly"};
    test_begin("winding-once");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (long k = 3; k < 10; k += 2) {
            const statement_case t = {names[i], NULL, k, CLAIM_WINDING, 1, false, 0};
            subject s;
            choices c;
            findings f;
            subject_from_catalogue(&s, names[i], NULL);
            CHECK(search(&f, &c, &s, &t, 0) == OUTCOME_FALSE && !strcmp(findings_last(&f)->reason, "the outer curve winds once round 0"), "%s at %ld: %s", names[i], k, findings_last(&f)->reason);
            choices_clear(&c);
            findings_clear(&f);
            subject_clear(&s);
        }
    test_end();
}

/* ---- changed choices: each returns false if there is nothing to change ---- */

static bool change_boundary(choices *c)
{
    if (!c->boundary.length)
        return false;
    return c->boundary.letter[--c->boundary.length] = '\0', true;
}
static bool change_boundary_to_leaves(choices *c)
{
    bool split = false;
    for (size_t i = 0; i < c->boundary.length; i++)
        split = split || c->boundary.letter[i] == TREE_SPLIT;
    if (split)
        tree_reset(&c->boundary);
    for (int i = 0; split && i < 8; i++)
        MUST(tree_put(&c->boundary, TREE_BOXES));
    return split;
}
static bool change_letter(choices *c) { return c->boundary.length ? (c->boundary.letter[c->boundary.length - 1] = TREE_COEFFICIENTS, true) : false; }
static bool change_pair(choices *c)
{
    bool pair = c->pair;
    c->pair = false;
    return pair && c->claim == CLAIM_FREQUENCY; /* what is beyond 1 is, in pairs or not */
}
static bool change_frequency(choices *c) { return c->frequency = c->frequency == 2 ? 1 : 2, true; }
static bool change_claim(choices *c)
{
    claim_kind before = c->claim;
    c->claim = c->claim == CLAIM_FREQUENCY ? CLAIM_NOT_C0 : c->claim == CLAIM_WINDING ? CLAIM_C1 : CLAIM_FREQUENCY;
    return before != CLAIM_NOT_C0;
}
static bool change_pivot(choices *c) { return c->eigenpair.pivot = (c->eigenpair.pivot + 1) % (c->eigenpair.n / (c->eigenpair.complex_form + 1)), true; }
/* On the real axis: no pair any more. */
static bool change_imaginary(choices *c) { return c->pair ? (integer_set_si(&c->eigenpair.approximation[c->eigenpair.n - 1], 0), true) : false; }
static bool change_modulus(choices *c)
{
    MUST(integer_mul_2exp(&c->modulus, &c->modulus, 1));
    return c->eigenpair.complex_form;
}
static bool change_power(choices *c)
{
    for (size_t i = 0; i < c->blocks.count; i++)
        if (c->blocks.box[i].power > 0)
            return c->blocks.box[i].power = 0, true;
    return false;
}
static bool change_blocks(choices *c) { return c->blocks.count ? (c->blocks.count--, true) : false; }
static bool change_witness(choices *c) { return c->claim == CLAIM_NOT_C0 ? (c->witness[0].element = 1000, true) : false; }
static bool change_valence(choices *c) { return c->k = one_valence(c->k.first + 2), c->claim != CLAIM_NOT_C0; }

static const struct {
    const char *name;
    bool (*make)(choices *);
} changes[] = {
    {"boundary", change_boundary}, {"boundary of leaves", change_boundary_to_leaves}, {"letter", change_letter}, {"kind of pair", change_pair},
    {"frequency", change_frequency}, {"claim", change_claim}, {"pivot", change_pivot}, {"imaginary part", change_imaginary}, {"modulus", change_modulus},
    {"power", change_power}, {"list of blocks", change_blocks}, {"witness", change_witness}, {"valence", change_valence},
};
enum { CHANGES = sizeof changes / sizeof *changes };

static void test_changed(void)
{
    int made[CHANGES] = {0};
    test_begin("winding-changed");
    for (int i = 0; i < CASES; i++)
        for (int j = 0; cases[i].windings && cases[i].valence < 10 && j < CHANGES; j++) {
            subject s;
            choices c;
            findings f;
            subject_from_file(&s, cases[i].scheme, cases[i].parameter);
            MUST(search(&f, &c, &s, &cases[i], 64) == OUTCOME_TRUE);
            findings_clear(&f);
            if (changes[j].make(&c)) {
                made[j]++;
                CHECK(follow(&f, &c, &s) != OUTCOME_TRUE, "%s at %ld: another %s, and it is followed", cases[i].scheme, cases[i].valence, changes[j].name);
                findings_clear(&f);
            }
            choices_clear(&c);
            subject_clear(&s);
        }
    for (int j = 0; j < CHANGES; j++)
        CHECK(made[j] > 0, "nowhere another %s", changes[j].name);
    test_end();
}

int main(void)
{
    test_known();
    test_once();
    test_changed();
    return test_status();
}
