/* t-uniform.c: the uniform method is never wiser than the truth, nor quicker than the adaptive one. */
#include "verify/escalate.h"

#include "common.h"

/* A scheme that both methods can decide. */
typedef struct {
    subject subject;
    uniform_bounds bounds;
} uniform_subject;

static void prepare(uniform_subject *z)
{
    uniform_bounds_init(&z->bounds);
    MUST(problem_make(&z->subject.problem, &z->subject.scheme));
    MUST(uniform_bounds_make(&z->bounds, &z->subject.problem));
    CHECK(!z->bounds.obstacle, "%s", z->bounds.obstacle);
}

static void make_named(uniform_subject *z, const char *name, const char *setting)
{
    const char *settings[1] = {setting};
    scheme_settings all = {settings, setting != NULL};
    const struct catalogue_entry *e = catalogue;
    diagnostic d = {0, 0, ""};
    while (e->name && strcmp(e->name, name))
        e++;
    scheme_init(&z->subject.scheme);
    problem_init(&z->subject.problem);
    CHECK(e->name && scheme_read(&z->subject.scheme, e->text, strlen(e->text), &all, &d) == STATUS_OK, "%s: %ld:%ld: %s", name, d.line, d.column, d.text);
    prepare(z);
}

static void make_own(uniform_subject *z, const char *mask, const char *centre)
{
    subject_make(&z->subject, mask, centre);
    uniform_bounds_init(&z->bounds);
    MUST(uniform_bounds_make(&z->bounds, &z->subject.problem));
}

static void clear(uniform_subject *z)
{
    uniform_bounds_clear(&z->bounds);
    subject_clear(&z->subject);
}

static void decide_uniformly(decision *d, const uniform_subject *z, long valence, limits l)
{
    l.uniform = &z->bounds;
    decide(d, &z->subject, valence, l);
}

/* Both prove it, by the same certificate, and the uniform method at `level`, not less deep than the other. */
static void check_agreement(const uniform_subject *z, long valence, int level, limits l)
{
    decision u, a;
    decide_uniformly(&u, z, valence, l);
    decide(&a, &z->subject, valence, l);
    CHECK(u.verdict == VERDICT_PROVED, "valence %ld: %s: %s", valence, decision_obstacle(&u)->test, decision_obstacle(&u)->reason);
    CHECK(a.verdict == VERDICT_PROVED, "valence %ld, adaptively: %s: %s", valence, decision_obstacle(&a)->test, decision_obstacle(&a)->reason);
    CHECK(u.findings.uniform && !a.findings.uniform, "valence %ld: the findings do not tell the methods apart", valence);
    CHECK(u.findings.uniform_level == level, "valence %ld: uniform level %d, not %d", valence, u.findings.uniform_level, level);
    CHECK(a.findings.level <= u.findings.uniform_level, "valence %ld: adaptive level %d, uniform level %d", valence, a.findings.level, u.findings.uniform_level);
    CHECK(a.findings.elements == u.findings.elements && a.findings.elements < u.findings.uniform_elements, "valence %ld: %ld elements, %ld after the uniform method, %ld in it",
          valence, a.findings.elements, u.findings.elements, u.findings.uniform_elements);
    CHECK(a.certificate.length == u.certificate.length && !memcmp(a.certificate.bytes, u.certificate.bytes, a.certificate.length), "valence %ld: other certificates", valence);
    for (int i = 0; i < u.findings.attempt_count; i++) /* the search for trees */
        if (!strcmp(u.findings.attempts[i].test, "regularity") && strcmp(u.findings.attempts[i].system, "grid"))
            CHECK(u.findings.attempts[i].max_level == level, "valence %ld: trees as deep as %d were sought", valence, u.findings.attempts[i].max_level);
    CHECK(!strcmp(decision_obstacle(&u)->system, "grid"), "valence %ld: proved without a replay of the certificate", valence);
    decision_clear(&u);
    decision_clear(&a);
}

/* The levels that were seen, once.  Zorin: Modified Butterfly 12 * 4^7 triangles, Loop 12 * 4^3, which are
   3 * 4^4 on the smaller ring used here. */
static const struct {
    const char *scheme;
    int count;
    struct {
        long valence;
        int level;
    } at[8];
} agreements[] = {
    {"loop", 8, {{3, 4}, {4, 3}, {5, 3}, {6, 2}, {7, 2}, {8, 2}, {20, 3}, {50, 3}}},
    {"modified-loop", 8, {{3, 3}, {4, 2}, {5, 1}, {6, 1}, {7, 1}, {8, 1}, {20, 2}, {50, 3}}},
    {"loop-warren", 8, {{3, 4}, {4, 3}, {5, 3}, {6, 2}, {7, 2}, {8, 2}, {20, 3}, {50, 3}}},
    {"modified-butterfly", 7, {{3, 7}, {4, 6}, {5, 4}, {7, 4}, {8, 4}, {20, 6}, {50, 6}}},
    {"butterfly", 3, {{4, 5}, {5, 4}, {7, 4}}},
};

static void test_agreement(void)
{
    test_begin("uniform-agreement");
    for (size_t i = 0; i < sizeof agreements / sizeof *agreements; i++) {
        uniform_subject z;
        make_named(&z, agreements[i].scheme, NULL);
        for (int j = 0; j < agreements[i].count; j++)
            check_agreement(&z, agreements[i].at[j].valence, agreements[i].at[j].level, escalation(0));
        clear(&z);
    }
    test_end();
}

static void test_balls(void)
{
    uniform_subject z;
    test_begin("uniform-balls");
    make_named(&z, "loop", NULL);
    check_agreement(&z, 3, 4, balls(64));
    check_agreement(&z, 7, 2, balls(256));
    clear(&z);
    make_named(&z, "modified-butterfly", NULL);
    check_agreement(&z, 7, 4, balls(128));
    clear(&z);
    test_end();
}

static void check_not_proved(const uniform_subject *z, const char *what, long valence)
{
    static const long precisions[] = {0, 64, 256}; /* 0: hardware intervals */
    for (size_t i = 0; i < sizeof precisions / sizeof *precisions; i++) {
        decision d;
        limits l = precisions[i] ? balls(precisions[i]) : escalation(0);
        l.max_level = 6;
        decide_uniformly(&d, z, valence, l);
        CHECK(d.verdict != VERDICT_PROVED, "PROVED, but not C1: %s at valence %ld", what, valence);
        CHECK(d.verdict == VERDICT_REFUTED || (d.certificate.length == 0 && decision_obstacle(&d)->reason[0]), "no reason is given: %s at valence %ld", what, valence);
        CHECK(d.verdict == VERDICT_REFUTED || !d.findings.uniform, "the uniform method has proved it: %s at valence %ld", what, valence);
        decision_clear(&d);
    }
}

/* Does some attempt say so? */
static bool was_found(const decision *d, const char *test, outcome o)
{
    for (int i = 0; i < d->findings.attempt_count; i++)
        if (!strcmp(d->findings.attempts[i].test, test) && d->findings.attempts[i].outcome == o)
            return true;
    return false;
}

/* Folds that only the Jacobian shows: L is simple and dominant.  The uniform method sees both signs. */
static void test_folds(void)
{
    static const struct {
        const char *l;
        long valence;
    } fold[] = {{"l=19/20", 3}, {"l=99/100", 3}, {"l=99/100", 5}, {"l=99/100", 7}, {"l=99/100", 20}};
    test_begin("uniform-folds");
    for (size_t i = 0; i < sizeof fold / sizeof *fold; i++) {
        uniform_subject z;
        decision d;
        make_named(&z, "loop-ring", fold[i].l);
        check_not_proved(&z, fold[i].l, fold[i].valence);
        decide_uniformly(&d, &z, fold[i].valence, escalation(0));
        CHECK(was_found(&d, "uniform regularity", OUTCOME_FALSE), "%s at valence %ld: no level shows the fold", fold[i].l, fold[i].valence);
        decision_clear(&d);
        clear(&z);
    }
    test_end();
}

static void test_wrong(void)
{
    static const char *const centres[] = {"5/8", "3/4", "11/8", "2", "-5/8", "100"};
    uniform_subject z;
    test_begin("uniform-wrong");
    for (size_t i = 0; i < sizeof centres / sizeof *centres; i++) {
        make_own(&z, LOOP_MASK, centres[i]);
        check_not_proved(&z, centres[i], 3);
        clear(&z);
    }
    make_own(&z, LOOP_MASK, "3/4 + cos(2*pi/k)/4");
    for (long k = 3; k <= 8; k++)
        check_not_proved(&z, "a tie", k);
    clear(&z);
    make_own(&z, "(0,0) 1\n(1,0) 1/2\n", "1/2"); /* piecewise linear */
    check_not_proved(&z, "linear", 5);
    clear(&z);
    make_named(&z, "butterfly", NULL);
    for (long k = 8; k <= 10; k++)
        check_not_proved(&z, "butterfly", k);
    check_not_proved(&z, "butterfly", 3);
    clear(&z);
    test_end();
}

/* A level that is too low leaves it undecided, and no precision is wasted on it. */
static void test_limits(void)
{
    uniform_subject z;
    decision d;
    limits l = escalation(4096);
    test_begin("uniform-limits");
    make_named(&z, "modified-butterfly", NULL);
    l.max_level = 3;
    decide_uniformly(&d, &z, 5, l);
    CHECK(d.verdict == VERDICT_UNDECIDED && d.outcome == OUTCOME_UNDEFINED && !d.findings.uniform && d.precision == 53, "undecided at level 3, with %ld bits: %s",
          d.precision, decision_obstacle(&d)->reason);
    for (int i = 0; i < d.findings.attempt_count; i++)
        CHECK(d.findings.attempts[i].level <= 3, "level %d was tried", d.findings.attempts[i].level);
    decision_clear(&d);
    l.max_level = 4;
    decide_uniformly(&d, &z, 5, l);
    CHECK(d.verdict == VERDICT_PROVED, "level 4: %s", decision_obstacle(&d)->reason);
    decision_clear(&d);
    clear(&z);
    test_end();
}

/* Quads have no uniform method. */
static void test_quads(void)
{
    uniform_subject z;
    const struct catalogue_entry *e = catalogue;
    diagnostic d = {0, 0, ""};
    test_begin("uniform-quads");
    while (e->name && strcmp(e->name, "catmull-clark"))
        e++;
    scheme_init(&z.subject.scheme);
    problem_init(&z.subject.problem);
    uniform_bounds_init(&z.bounds);
    CHECK(e->name && scheme_read(&z.subject.scheme, e->text, strlen(e->text), NULL, &d) == STATUS_OK, "catmull-clark: %s", d.text);
    MUST(problem_make(&z.subject.problem, &z.subject.scheme) && uniform_bounds_make(&z.bounds, &z.subject.problem));
    CHECK(z.bounds.obstacle != NULL, "quads are no obstacle");
    clear(&z);
    test_end();
}

int main(void)
{
    test_agreement();
    test_balls();
    test_folds();
    test_wrong();
    test_limits();
    test_quads();
    return test_status();
}
