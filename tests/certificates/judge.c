/* judge.c: see judge.h. */
#include "tests/certificates/judge.h"

#include "tests/verify/common.h"
#include "lib/stability.h"

enum { FINER = 64 };

void judge_answer(const trial *t)
{
    const answer *a = &t->answer;
    const char *name = t->from->name;
    CHECK(a->status >= 0 && a->status <= 2, "%s: the checker ended with status %d: %.200s", name, a->status, a->err);
    CHECK(a->status == 0 || a->out[0] == '\0', "%s: not verified, but it printed %s", name, a->out);
    CHECK(a->status != 0 || (strncmp(a->out, "verified: ", 10) == 0 && a->err[0] == '\0'), "%s: verified without saying so", name);
    CHECK(a->status != 1 || strncmp(a->err, "rejected: ", 10) == 0, "%s: rejected without saying so: %s", name, a->err);
    CHECK(a->status != 2 || strncmp(a->err, "cannot check: ", 14) == 0, "%s: not checked without saying so: %s", name, a->err);
}

/* ---- choices ---- */

typedef struct {
    scheme scheme;
    problem problem;
} judge;

static bool judge_make(judge *z, const trial *t)
{
    scheme_settings settings = {(const char *const *)t->from->setting, t->from->settings};
    char *text = read_text(t->own_text ? "text" : t->from->scheme_file);
    diagnostic d = {0, 0, ""};
    bool good;
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    good = text && scheme_read(&z->scheme, text, strlen(text), t->own_text ? NULL : &settings, &d) == STATUS_OK && problem_make(&z->problem, &z->scheme);
    CHECK(good, "accepted, but the prover does not read the scheme: %s", d.text);
    free(text);
    return good;
}

static void judge_clear(judge *z)
{
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
}

static void refine_pair(eigenpair_choice *e, unsigned long bits)
{
    if (e->n == 0)
        return;
    for (int i = 0; i < e->n; i++)
        MUST(integer_mul_2exp(&e->approximation[i], &e->approximation[i], bits));
    MUST(integer_mul_2exp(&e->radius, &e->radius, bits));
    MUST(integer_mul_2exp(&e->range, &e->range, bits));
    e->grid += (long)bits;
}

/* The same choices on a grid that is finer by some bits. */
static void refine_choices(choices *c, unsigned long bits)
{
    refine_pair(&c->eigenpair, bits);
    refine_pair(&c->second, bits);
    refine_pair(&c->limit.eigenpair, bits);
    for (size_t i = 0; i < c->rise.count; i++)
        refine_pair(&c->rise.box[i].eigenpair, bits);
    for (size_t i = 0; i < c->window.count; i++)
        refine_pair(&c->window.wave[i].eigenpair, bits);
    MUST(integer_mul_2exp(&c->window.bound, &c->window.bound, bits));
    MUST(integer_mul_2exp(&c->exact.eigenvalue, &c->exact.eigenvalue, bits));
    MUST(integer_mul_2exp(&c->exact.radius, &c->exact.radius, bits));
    MUST(integer_mul_2exp(&c->modulus, &c->modulus, bits));
    c->grid += (long)bits;
}

/* A replay insists on the prover's own constants of the regular part: those of the mutant take their place, once the
   bounds K are proved to be some.  (The powers of contraction prove what the prover has proved by its own.) */
static void take_regular_part(judge *j, const choices *c)
{
    for (int i = 0; i < RING_NETS && !c->plainly_regular; i++) {
        stability_choice *own = &j->problem.stability[i];
        bool proved = c->stability[i].bound >= own->bound;
        if (!proved)
            MUST(stability_verify_window(&proved, j->problem.geometry.mask[i], c->stability[i].power, c->stability[i].bound));
        CHECK(proved, "accepted, but %lld/1024 is not proved for q_%d", (long long)c->stability[i].bound, i);
        *own = c->stability[i];
    }
    memcpy(j->problem.contraction, c->contraction, sizeof c->contraction);
}

static void follow_choices(judge *j, const trial *t)
{
    analysis_plan plan = {.problem = &j->problem, .system = "grid"};
    findings f;
    choices c;
    long line = 0;
    findings_init(&f);
    choices_init(&c);
    MUST(certificate_read(&c, &line, &j->scheme, t->certificate.bytes, t->certificate.length));
    CHECK(line == 0 && valence_range_equal(c.k, t->k) && (c.claim != CLAIM_C1) == t->from->not_c1, "accepted, but the prover reads line %ld otherwise", line);
    take_regular_part(j, &c);
    if (!test_failed())
        CHECK(analysis_replay(&f, &c, &plan) == OUTCOME_TRUE, "accepted, but not by the prover: %s", findings_last(&f)->reason);
    if (!test_failed() && !c.plainly_regular) {
        refine_choices(&c, FINER);
        CHECK(analysis_replay(&f, &c, &plan) == OUTCOME_TRUE, "accepted, but not on a finer grid: %s", findings_last(&f)->reason);
    }
    choices_clear(&c);
    findings_clear(&f);
}

/* "verified: ... (low < L < high)" or "(frequency m: low < |L| < high)", with <= of several valences: the prover's own L is
   there.  In a window of frequencies several take part, and the largest of them is what it says. */
static void compare_eigenvalue(const trial *t, const decision *d)
{
    const char *end = strstr(t->answer.out, " <"), *begin = end;
    double low, high;
    CHECK(d->plainly_regular == (strstr(t->answer.out, "plainly regular") != NULL), "plainly regular or not? %s", t->answer.out);
    if (!end || d->plainly_regular || d->claim == CLAIM_NOT_C0) /* there any eigenvalue beyond 1 will do */
        return;
    while (begin > t->answer.out && begin[-1] != ' ' && begin[-1] != '(')
        begin--;
    low = strtod(begin, NULL);
    high = strtod(strpbrk(strstr(end + 2, " <"), "0123456789"), NULL);
    CHECK(low <= d->findings.eigenvalue_upper && d->findings.eigenvalue_lower <= high, "accepted with %.17g < L < %.17g, but it is in [%.17g, %.17g]", low, high,
          d->findings.eigenvalue_lower, d->findings.eigenvalue_upper);
}

/* ---- verdicts ---- */

enum { ENOUGH_VALENCES = 200 }; /* beyond its first ones a range is long */

void opinion_init(opinion *z, valence_range k)
{
    long last = k.last - k.first < ENOUGH_VALENCES ? k.last : k.first + ENOUGH_VALENCES;
    z->asked = false;
    z->count = last > k.first ? 2 : 1;
    z->valence[0] = k.first;
    z->valence[1] = last > k.first ? k.first + 1 + (long)random_below((uint64_t)(last - k.first)) : 0;
    for (int i = 0; i < z->count; i++)
        decision_init(&z->at[i]);
}

void opinion_clear(opinion *z)
{
    for (int i = 0; i < z->count; i++)
        decision_clear(&z->at[i]);
}

static void ask_prover(opinion *z, const judge *j)
{
    for (int i = 0; i < z->count && !z->asked; i++) {
        limits l = {.max_precision = 1024, .deadline = {deadline_now() + 2 * SECONDS_PER_CHECK}};
        decide_valence(&z->at[i], &j->problem, z->valence[i], NULL, &l);
    }
    z->asked = true;
}

static void compare_verdicts(const trial *t, const opinion *o)
{
    verdict claimed = t->from->not_c1 ? VERDICT_REFUTED : VERDICT_PROVED;
    for (int i = 0; i < o->count; i++) {
        CHECK(o->at[i].verdict == claimed, "accepted, but at valence %ld the prover says %s", o->valence[i], verdict_name(o->at[i].verdict));
        compare_eigenvalue(t, &o->at[i]);
    }
}

void judge_accepted(const trial *t, opinion *o)
{
    judge j;
    if (judge_make(&j, t)) {
        ask_prover(o, &j);
        compare_verdicts(t, o);
        if (strncmp(t->certificate.bytes, "smoothcert-certificate 1\n", 25) == 0 && !test_failed())
            follow_choices(&j, t);
    }
    judge_clear(&j);
}
