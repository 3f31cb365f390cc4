/* t-radius.c: prover and checker follow a certificate to the same last bit: the least and the greatest radius that they
   accept are the same, found by bisection with the prover's replay. */
#include "tests/certificates/corpus.h"
#include "tests/verify/common.h"

typedef struct {
    const base *from;
    scheme scheme;
    problem problem;
    lines body;
} subject_of_claim;

static bool make_subject(subject_of_claim *z, const base *b)
{
    scheme_settings settings = {(const char *const *)b->setting, b->settings};
    char *text = read_text(b->scheme_file);
    bool good;
    z->from = b;
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    lines_read(&z->body, b->whole, "records ");
    good = text && scheme_read(&z->scheme, text, strlen(text), &settings, NULL) == STATUS_OK && problem_make(&z->problem, &z->scheme);
    CHECK(good, "%s: no scheme", b->name);
    free(text);
    return good;
}

static void clear_subject(subject_of_claim *z)
{
    lines_clear(&z->body);
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
}

static void set_radius(buffer *certificate, subject_of_claim *s, long long radius)
{
    char line[64];
    snprintf(line, sizeof line, "radius %llx", (unsigned long long)radius);
    lines_replace(&s->body, lines_find(&s->body, "radius"), line);
    lines_write(certificate, &s->body);
    seal(certificate);
}

static bool prover_accepts(subject_of_claim *s, long long radius)
{
    analysis_plan plan = {.problem = &s->problem, .system = "grid"};
    buffer certificate;
    findings f;
    choices c;
    long line = 0;
    bool good;
    buffer_init(&certificate);
    findings_init(&f);
    choices_init(&c);
    set_radius(&certificate, s, radius);
    good = certificate_read(&c, &line, &s->scheme, certificate.bytes, certificate.length) && line == 0 && analysis_replay_grid(&f, &c, &plan, c.grid) == OUTCOME_TRUE;
    choices_clear(&c);
    findings_clear(&f);
    buffer_clear(&certificate);
    return good;
}

static void expect_checker(subject_of_claim *s, long long radius, int expected)
{
    buffer certificate;
    answer a;
    buffer_init(&certificate);
    set_radius(&certificate, s, radius);
    write_file("certificate", certificate.bytes, certificate.length);
    ask_checker(&a, s->from, NULL, s->from->k, "certificate");
    CHECK(a.status == expected, "%s: radius %llx: the checker says %s%s", s->from->name, (unsigned long long)radius, a.out, a.err);
    buffer_clear(&certificate);
}

/* accepted and refused are neighbours in the end. */
static void find_border(subject_of_claim *s, long long accepted, long long refused)
{
    CHECK(prover_accepts(s, accepted) && !prover_accepts(s, refused), "%s: radius %llx is no better than %llx", s->from->name, (unsigned long long)accepted,
          (unsigned long long)refused);
    while (!test_failed() && (accepted - refused > 1 || refused - accepted > 1)) {
        long long middle = accepted + (refused - accepted) / 2;
        *(prover_accepts(s, middle) ? &accepted : &refused) = middle;
    }
    expect_checker(s, accepted, 0);
    expect_checker(s, refused, 1);
}

int main(void)
{
    static const char *const names[] = {"loop-7", "loop-1000", "wide-7", "butterfly-5", "catmull-clark-3", "doo-sabin-spectrum-5", "midpoint-4-7",
                                        "loop-spiral-5", "turned-6", "butterfly-8", "centre-divergent-5", "doo-sabin-fold-3", "loop-spiral-ripple-5"};
    static corpus good;
    test_begin("radius");
    corpus_read(&good, "accept-1", "table", false);
    corpus_read(&good, "accept-1", "refuted", true);
    for (size_t i = 0; i < sizeof names / sizeof *names && !test_failed(); i++) {
        const base *b = corpus_find(&good, names[i]);
        subject_of_claim s;
        long long radius;
        CHECK(b, "there is no certificate %s", names[i]);
        if (!b || !make_subject(&s, b))
            break;
        radius = strtoll(s.body.line[lines_find(&s.body, "radius")] + 7, NULL, 16);
        find_border(&s, radius, 1);
        find_border(&s, radius, 1LL << 62);
        clear_subject(&s);
    }
    test_end();
    return test_status();
}
