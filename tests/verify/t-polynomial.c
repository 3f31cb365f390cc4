/* t-polynomial.c: where limits are polynomials: proofs without subdivision, folds found exactly, and trees that claim too much. */
#include <math.h>

#include "common.h"

static void check_level_0(const char *name, const char *parameter, const long *valence, int count)
{
    subject s;
    subject_from_catalogue(&s, name, parameter);
    for (int i = 0; i < count; i++) {
        decision d;
        decide(&d, &s, valence[i], escalation(0));
        CHECK(d.verdict == VERDICT_PROVED && d.findings.level == 0, "%s %s, valence %ld: %s, level %d", name, parameter ? parameter : "", valence[i],
              decision_obstacle(&d)->reason, d.findings.level);
        decision_clear(&d);
    }
    subject_clear(&s);
}

static void test_level_0(void)
{
    static const long many[] = {3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 33, 50, 100, 1000, 100000}, few[] = {3, 4, 5, 6, 8, 12, 30};
    static const char *const degree[] = {"degree=2", "degree=3", "degree=4", "degree=5", "degree=6", "degree=7"};
    test_begin("polynomial-level-0");
    check_level_0("loop", NULL, many, sizeof many / sizeof *many);
    check_level_0("catmull-clark", NULL, many, sizeof many / sizeof *many);
    check_level_0("doo-sabin", NULL, many, sizeof many / sizeof *many);
    for (size_t i = 0; i < sizeof degree / sizeof *degree; i++)
        check_level_0("midpoint", degree[i], few, sizeof few / sizeof *few);
    test_end();
}

/* J. Peters, U. Reif 1998: Doo-Sabin schemes with the eigenvalue l do not fold where this is positive. */
static double peters_reif(double l, long k) { return 128 * l * l * (1 - l) - 7 * l - 2 + 9 * l * cos(2 * 3.14159265358979323846 / (double)k); }

static void test_folds(void)
{
    test_begin("polynomial-folds");
    for (long k = 3; k <= 9; k += k == 3 ? 2 : 1)
        for (int i = 0; i < 24 && !test_failed(); i++) {
            static const int last[] = {700, 800, 900, 920, 930, 940, 944, 947, 948, 950, 953, 955, 957, 958, 960, 965, 970, 975, 980, 985, 990, 992, 995, 999};
            char parameter[40];
            subject s;
            decision d;
            snprintf(parameter, sizeof parameter, "l=%d/1000", last[i]);
            subject_from_catalogue(&s, "doo-sabin-spectrum", parameter);
            decide(&d, &s, k, escalation(128));
            CHECK((d.verdict == VERDICT_PROVED) == (peters_reif(last[i] / 1000.0, k) > 0), "valence %ld, l = 0.%d: %s, but the criterion says %g", k, last[i],
                  d.verdict == VERDICT_PROVED ? "proved" : "undecided", peters_reif(last[i] / 1000.0, k));
            decision_clear(&d);
            subject_clear(&s);
        }
    test_end();
}

/* ---- forged trees ---- */

static void set_word(tree_word *z, const char *letters)
{
    tree_reset(z);
    for (; *letters; letters++)
        MUST(tree_put(z, *letters));
}

static outcome replay(const subject *s, choices *c)
{
    findings f;
    deadline none = {0};
    analysis_plan plan = {.problem = &s->problem, .deadline = &none, .system = "grid"};
    outcome o;
    findings_init(&f);
    o = analysis_replay_grid(&f, c, &plan, c->grid);
    findings_clear(&f);
    return o;
}

/* Replaces each letter `from` of the word, one at a time, by `to`: which certificates are still proofs? */
static int count_proofs(const subject *s, choices *c, tree_word *word, char from, char to)
{
    int proofs = 0;
    for (size_t i = 0; i < word->length; i++)
        if (word->letter[i] == from) {
            word->letter[i] = to;
            proofs += replay(s, c) == OUTCOME_TRUE;
            word->letter[i] = from;
        }
    return proofs;
}

static bool make_choices(choices *c, const subject *s, long valence)
{
    decision d;
    long line = -1;
    decide(&d, s, valence, escalation(0));
    choices_init(c);
    CHECK(d.verdict == VERDICT_PROVED, "valence %ld: %s", valence, decision_obstacle(&d)->reason);
    MUST(certificate_read(c, &line, &s->scheme, d.certificate.bytes ? d.certificate.bytes : "", d.certificate.length));
    decision_clear(&d);
    return line == 0 && replay(s, c) == OUTCOME_TRUE;
}

static void test_no_polynomials(void)
{
    subject s;
    choices c;
    test_begin("polynomial-forged-none");
    subject_from_catalogue(&s, "modified-butterfly", NULL);
    CHECK(make_choices(&c, &s, 5), "the certificate is no proof");
    CHECK(count_proofs(&s, &c, &c.regularity, '0', '2') == 0 && count_proofs(&s, &c, &c.boundary, '0', '2') == 0, "coefficients of a mask that is of no box spline");
    choices_clear(&c);
    subject_clear(&s);
    test_end();
}

/* With polynomials: all leaves may be of this kind, but none with a letter too many. */
static void test_all_coefficients(void)
{
    static const char *const name[] = {"loop", "catmull-clark", "doo-sabin"};
    test_begin("polynomial-forged-leaves");
    for (int i = 0; i < 3; i++) {
        char letters[200] = "";
        subject s;
        choices c;
        subject_from_catalogue(&s, name[i], NULL);
        CHECK(make_choices(&c, &s, 3), "the certificate is no proof");
        MUST((size_t)s.problem.geometry.element_count < sizeof letters - 1);
        memset(letters, '2', (size_t)s.problem.geometry.element_count);
        set_word(&c.regularity, letters);
        CHECK(replay(&s, &c) == OUTCOME_TRUE, "%s: coefficients do not prove regularity", name[i]);
        strcat(letters, "2");
        set_word(&c.regularity, letters);
        CHECK(replay(&s, &c) != OUTCOME_TRUE, "%s: a letter too many", name[i]);
        letters[strlen(letters) - 2] = '\0';
        set_word(&c.regularity, letters);
        CHECK(replay(&s, &c) != OUTCOME_TRUE, "%s: a letter is missing", name[i]);
        choices_clear(&c);
        subject_clear(&s);
    }
    test_end();
}

/* A map that folds: everything is found but the trees, and no word proves it. */
static void test_fold_is_refused(void)
{
    static const char *const letters[] = {"2", "0", "12222", "10000", "1122221222212222122222"};
    subject s;
    choices c;
    findings f;
    deadline none = {0};
    analysis_plan plan = {.problem = &s.problem, .deadline = &none, .system = "interval", .max_level = 6};
    test_begin("polynomial-forged-fold");
    subject_from_catalogue(&s, "doo-sabin-spectrum", "l=948/1000");
    choices_init(&c);
    findings_init(&f);
    c.k = one_valence(5);
    c.grid = 64;
    CHECK(analysis_search_interval(&f, &c, &plan, 53) == OUTCOME_FALSE && plan.found[TEST_SPECTRUM] && !plan.found[TEST_REGULARITY], "the map does not fold");
    c.normal[0] = 1;
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++) {
        tree_reset(&c.regularity);
        for (int e = 0; e < s.problem.geometry.element_count; e++)
            for (const char *l = letters[i]; *l; l++)
                MUST(tree_put(&c.regularity, *l));
        plan = (analysis_plan){.problem = &s.problem, .deadline = &none, .system = "grid"};
        findings_clear(&f);
        CHECK(analysis_replay_grid(&f, &c, &plan, c.grid) == OUTCOME_FALSE && !strcmp(findings_last(&f)->test, "regularity"), "a fold is not seen by leaves %s: %s", letters[i],
              findings_last(&f)->test);
    }
    findings_clear(&f);
    choices_clear(&c);
    subject_clear(&s);
    test_end();
}

/* A half-plane on the wrong side. */
static void test_half_plane(void)
{
    subject s;
    choices c;
    test_begin("polynomial-forged-half-plane");
    subject_from_catalogue(&s, "loop", NULL);
    CHECK(make_choices(&c, &s, 7), "the certificate is no proof");
    memset(c.boundary.letter, '2', c.boundary.length);
    CHECK(replay(&s, &c) == OUTCOME_TRUE, "coefficients do not prove that the curve lies in the half-plane");
    for (int i = 0; i < 3; i++) {
        long x = c.normal[0], y = c.normal[1];
        c.normal[0] = i == 0 ? -x : i == 1 ? y : -y;
        c.normal[1] = i == 0 ? -y : i == 1 ? -x : x;
        CHECK(replay(&s, &c) != OUTCOME_TRUE, "proved with a normal of another direction");
        c.normal[0] = x;
        c.normal[1] = y;
    }
    choices_clear(&c);
    subject_clear(&s);
    test_end();
}

int main(void)
{
    test_level_0();
    test_folds();
    test_no_polynomials();
    test_all_coefficients();
    test_fold_is_refused();
    test_half_plane();
    return test_status();
}
