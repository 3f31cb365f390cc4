/* t-mutate.c: random mutants of good certificates, given to the checker as a program.

   None may crash it or keep it busy for long, and whatever it accepts must be true: the prover must come to the same
   verdict by itself, with an eigenvalue in what the checker printed, and follow the mutant's own choices on its grid as
   well as on a finer one; of several valences the verdict is asked for at some of them.  Four in five mutants get a right count of records and a right hash; one in eight is given
   with its own claim (its scheme's text, its valence), so that the lie is not in the claim, and the others with that
   of the certificate that they come from.

   SMOOTHCERT_CHECK is the checker, SRCDIR the sources.  Arguments are parts of names: of such certificates only.  The
   mutant of a failure stays in ./mutant (and ./text). */
#include "tests/certificates/corpus.h"
#include "tests/verify/common.h"
#include "lib/stability.h"

#include <math.h>

enum { MUTANTS = 1000, FINER = 64 };

static corpus bases;
static const base *chosen[MAX_BASES]; /* which mutants are made of; lines are borrowed from any */
static int chosen_count;

/* What the checker is told, and what it says. */
typedef struct {
    const base *from;
    valence_range k;
    bool own_text;       /* the scheme is the mutant's own text, in the file `text` */
    bool sealed;
    buffer certificate;
    answer answer;
} trial;

/* ---- mutants ---- */

static valence_range random_valences(bool several)
{
    valence_range k = one_valence(3 + (long)random_below(random_bool() ? 8 : 40));
    if (several)
        k.last = random_below(3) == 0 ? VALENCES_UNBOUNDED : k.first + 1 + (long)random_below(random_bool() ? 8 : 100);
    return k;
}

/* "valence 7", "valence 7 9" or "valence 7 inf" */
static void write_valences(char *out, size_t size, valence_range k)
{
    int used = snprintf(out, size, "valence %ld", k.first);
    if (k.last == VALENCES_UNBOUNDED)
        snprintf(out + used, size - (size_t)used, " inf");
    else if (!is_one_valence(k))
        snprintf(out + used, size - (size_t)used, " %ld", k.last);
}

/* The scheme or the valences change, and the claim with them. */
static void drift(trial *t, lines *z, int first, int claim)
{
    char line[64];
    t->own_text = true;
    if (random_below(3)) {
        mutate_scheme(z, first, claim - 1);
        return;
    }
    t->k = random_valences(!is_one_valence(t->from->k));
    write_valences(line, sizeof line, t->k);
    lines_replace(z, claim + 1, line);
}

static void make_mutant(trial *t)
{
    const base *b = chosen[random_below((uint64_t)chosen_count)], *other = &bases.base[random_below((uint64_t)bases.count)];
    lines z;
    int claim, edits = 1 + (random_below(3) == 0 ? (int)random_below(4) : 0);
    lines_read(&z, b->whole, (t->sealed = random_below(5) > 0) ? "records " : NULL);
    claim = lines_find(&z, "claim");
    t->from = b;
    t->k = b->k;
    if (random_below(8) == 0) {
        drift(t, &z, 2, claim);
        edits -= random_bool();
    }
    while (edits-- > 0)
        mutate_lines(&z, !t->own_text && random_below(6) == 0 ? 0 : claim + 2, &other->body);
    lines_write(&t->certificate, &z);
    if (t->sealed)
        seal(&t->certificate);
    write_file("mutant", t->certificate.bytes, t->certificate.length);
    if (t->own_text) {
        buffer text;
        int all = z.count;
        for (int i = 0; i < 2 && claim > 0; i++)
            lines_replace(&z, i, "");
        z.count = claim;
        buffer_init(&text);
        lines_write(&text, &z);
        write_file("text", text.bytes, text.length);
        buffer_clear(&text);
        z.count = all;
    }
    lines_clear(&z);
}

/* ---- the prover's judgement ---- */

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

/* What the prover says of one of the valences, by itself. */
static void judge_valence(const trial *t, const judge *j, long valence)
{
    limits l = {.max_precision = 1024, .deadline = {deadline_now() + 2 * SECONDS_PER_CHECK}};
    verdict claimed = t->from->not_c1 ? VERDICT_REFUTED : VERDICT_PROVED;
    decision d;
    decision_init(&d);
    decide_valence(&d, &j->problem, valence, NULL, &l);
    CHECK(d.verdict == claimed, "accepted, but at valence %ld the prover says %s", valence, verdict_name(d.verdict));
    compare_eigenvalue(t, &d);
    decision_clear(&d);
}

enum { ENOUGH_VALENCES = 200 }; /* beyond its first ones a range is long */

static void judge_accepted(const trial *t)
{
    long first = t->k.first, last = t->k.last - first < ENOUGH_VALENCES ? t->k.last : first + ENOUGH_VALENCES;
    judge j;
    if (judge_make(&j, t)) {
        judge_valence(t, &j, first);
        if (last > first && !test_failed())
            judge_valence(t, &j, first + 1 + (long)random_below((uint64_t)(last - first)));
        if (strncmp(t->certificate.bytes, "smoothcert-certificate 1\n", 25) == 0 && !test_failed())
            follow_choices(&j, t);
    }
    judge_clear(&j);
}

/* ---- all of it ---- */

static bool is_wanted(const char *name, const char *const *part)
{
    bool any = *part == NULL;
    for (; *part; part++)
        any = any || strstr(name, *part);
    return any;
}

static void read_bases(const char *const *parts)
{
    corpus_read(&bases, "accept", "table", false);
    corpus_read(&bases, "accept-1", "table", false);
    corpus_read(&bases, "accept-1", "refuted", true);
    corpus_read(&bases, "../check/ranges", "table", false);
    corpus_read(&bases, "../check/ranges", "refuted", true);
    for (int i = 0; i < bases.count; i++)
        if (is_wanted(bases.base[i].name, parts))
            chosen[chosen_count++] = &bases.base[i];
    CHECK(chosen_count > 0, "no such certificates");
}

typedef struct {
    long accepted, rejected, cannot, unchanged, drifted;
} counts;

static void examine(const trial *t, counts *n)
{
    bool unchanged = t->certificate.length == strlen(t->from->whole) && memcmp(t->certificate.bytes, t->from->whole, t->certificate.length) == 0;
    CHECK(t->answer.status >= 0 && t->answer.status <= 2, "%s: the checker ended with status %d: %.200s", t->from->name, t->answer.status, t->answer.err);
    CHECK(t->answer.status == 0 || t->answer.out[0] == '\0', "%s: not verified, but it printed %s", t->from->name, t->answer.out);
    CHECK(t->answer.status != 0 || (strncmp(t->answer.out, "verified: ", 10) == 0 && t->answer.err[0] == '\0'), "%s: verified without saying so", t->from->name);
    CHECK(t->answer.status != 1 || strncmp(t->answer.err, "rejected: ", 10) == 0, "%s: rejected without saying so: %s", t->from->name, t->answer.err);
    CHECK(t->answer.status != 2 || strncmp(t->answer.err, "cannot check: ", 14) == 0, "%s: not checked without saying so: %s", t->from->name, t->answer.err);
    if (test_failed())
        return;
    CHECK(t->answer.status == 0 || !unchanged || t->own_text, "%s: unchanged, but not accepted: %s", t->from->name, t->answer.err);
    n->unchanged += unchanged;
    n->accepted += t->answer.status == 0 && !unchanged;
    n->rejected += t->answer.status == 1;
    n->cannot += t->answer.status == 2;
    n->drifted += t->answer.status == 0 && t->own_text;
    if (t->answer.status == 0 && !unchanged)
        judge_accepted(t);
}

int main(int argc, char **argv)
{
    (void)argc;
    counts n = {0, 0, 0, 0, 0};
    test_begin("mutants");
    read_bases((const char *const *)argv + 1);
    for (test_cases(MUTANTS); chosen_count > 0 && test_next();) {
        trial t = {.from = NULL};
        buffer_init(&t.certificate);
        make_mutant(&t);
        ask_checker(&t.answer, t.from, t.own_text ? "text" : NULL, t.k, "mutant");
        examine(&t, &n);
        buffer_clear(&t.certificate);
    }
    printf("%ld accepted (%ld with another claim), %ld rejected, %ld cannot be checked, %ld unchanged\n", n.accepted, n.drifted, n.rejected, n.cannot, n.unchanged);
    if (n.accepted + n.rejected >= MUTANTS / 2)
        CHECK(n.accepted && n.rejected && n.cannot, "the mutants do not reach every answer");
    test_end();
    return test_status();
}
