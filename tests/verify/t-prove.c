/* t-prove.c: what is proved about one valence, in all number systems; and, above all, what is not.

   In Loop's mask the eigenvalue L of the characteristic map is 3/8 + cos(2 pi/k)/4, and the weight c0 of the centre
   decides about one eigenvalue more, c0 - 3/8: at valence k the scheme is C1 if and only if |c0 - 3/8| < L. */
#include "verify/escalate.h"

#include "common.h"

static const long precisions[] = {0, 64, 128, 256, 512}; /* 0: hardware intervals */
enum { PRECISIONS = sizeof precisions / sizeof *precisions };

static limits with_precision(long precision) { return precision ? balls(precision) : escalation(0); }

/* z = the least grid interval round 3/8 + cos(2 pi/k)/4. */
static void closed_form(grid *z, long k, long g)
{
    rational q;
    grid part;
    rational_init(&q);
    grid_init(&part);
    MUST(rational_set_si(&q, 2, k));
    grid_cos_pi(z, &q, g);
    MUST(rational_set_si(&q, 1, 4));
    grid_set_rational(&part, &q, g);
    grid_mul(z, z, &part, g);
    MUST(rational_set_si(&q, 3, 8));
    grid_set_rational(&part, &q, g);
    grid_add(z, z, &part, g);
    rational_clear(&q);
    grid_clear(&part);
}

/* The interval of L in the certificate must contain the closed form, which is known to many more digits. */
static void check_eigenvalue(const decision *d, const subject *s)
{
    choices c;
    long line = -1;
    choices_init(&c);
    MUST(certificate_read(&c, &line, &s->scheme, d->certificate.bytes, d->certificate.length));
    CHECK(line == 0 && c.k.first == d->k.first, "the certificate does not read back (line %ld)", line);
    if (line == 0) {
        const integer *middle = &c.eigenpair.approximation[c.eigenpair.n - 1];
        integer lower, upper, low, high;
        grid exact;
        integer_init(&lower), integer_init(&upper), integer_init(&low), integer_init(&high);
        grid_init(&exact);
        closed_form(&exact, d->k.first, c.grid + 64);
        MUST(grid_get_endpoints(&low, &high, &exact, c.grid + 64));
        MUST(integer_sub(&lower, middle, &c.eigenpair.radius) && integer_mul_2exp(&lower, &lower, 64));
        MUST(integer_add(&upper, middle, &c.eigenpair.radius) && integer_mul_2exp(&upper, &upper, 64));
        CHECK(integer_cmp(&lower, &low) < 0 && integer_cmp(&high, &upper) < 0, "valence %ld: L is not 3/8 + cos(2 pi/k)/4", d->k.first);
        /* and it is a small one: half of the digits at least */
        CHECK(integer_bits(&c.eigenpair.radius) < (size_t)c.grid / 2, "valence %ld: a radius of %zu bits on a grid of %ld", d->k.first,
              integer_bits(&c.eigenpair.radius), c.grid);
        CHECK(d->findings.eigenvalue_lower <= grid_lower_bound(&exact) + 1e-15 && d->findings.eigenvalue_upper >= grid_upper_bound(&exact) - 1e-15,
              "valence %ld: L in [%.17g, %.17g]", d->k.first, d->findings.eigenvalue_lower, d->findings.eigenvalue_upper);
        integer_clear(&lower), integer_clear(&upper), integer_clear(&low), integer_clear(&high);
        grid_clear(&exact);
    }
    choices_clear(&c);
}

/* Proved by every number system, twice with the same bytes. */
static void check_loop(const subject *loop, long valence)
{
    for (int i = 0; i < PRECISIONS; i++) {
        decision d, again;
        decide(&d, loop, valence, with_precision(precisions[i]));
        decide(&again, loop, valence, with_precision(precisions[i]));
        CHECK(d.verdict == VERDICT_PROVED, "valence %ld, %ld bits: %s: %s", valence, precisions[i], decision_obstacle(&d)->test, decision_obstacle(&d)->reason);
        CHECK(d.findings.jacobian > 0 && d.findings.runner_up < d.findings.eigenvalue_upper, "valence %ld: Jacobian > %g, others < %g", valence,
              d.findings.jacobian, d.findings.runner_up);
        CHECK(!strcmp(decision_obstacle(&d)->system, "grid"), "valence %ld: proved without a replay of the certificate", valence);
        if (d.verdict == VERDICT_PROVED) {
            CHECK(again.certificate.length == d.certificate.length && !memcmp(again.certificate.bytes, d.certificate.bytes, d.certificate.length),
                  "valence %ld, %ld bits: the second certificate has other bytes", valence, precisions[i]);
            check_eigenvalue(&d, loop);
        }
        decision_clear(&d);
        decision_clear(&again);
    }
}

static void test_loop(void)
{
    static const long more[] = {20, 50, 100};
    subject loop;
    test_begin("prove-loop");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    for (long k = 3; k <= 12; k++)
        check_loop(&loop, k);
    for (size_t i = 0; i < sizeof more / sizeof *more; i++)
        check_loop(&loop, more[i]);
    subject_clear(&loop);
    test_end();
}

/* The centre's weight as a decimal that is exact: c0 = (numerator / 8) + sign * 10^-digits. */
static void make_centre(char *text, size_t size, const char *base, int sign, int digits)
{
    if (sign == 0)
        snprintf(text, size, "%s", base);
    else
        snprintf(text, size, "%s %c 0.%0*d", base, sign < 0 ? '-' : '+', digits, 1);
}

static void check_not_proved(const char *mask, const char *centre, long valence)
{
    subject s;
    subject_make(&s, mask, centre);
    for (int i = 0; i < PRECISIONS; i++) {
        decision d;
        decide(&d, &s, valence, with_precision(precisions[i]));
        CHECK(d.verdict != VERDICT_PROVED, "PROVED, but not C1: centre %s at valence %ld, %ld bits, mask %s", centre, valence, precisions[i], mask);
        CHECK(d.verdict == VERDICT_REFUTED || d.certificate.length == 0, "a certificate of what is not decided: centre %s at valence %ld", centre, valence);
        CHECK(decision_obstacle(&d)->reason[0] != '\0', "no reason is given: centre %s at valence %ld", centre, valence);
        decision_clear(&d);
    }
    subject_clear(&s);
}

/* |c0 - 3/8| = L where everything is rational, and beyond by 10^-digits. */
static const struct {
    long valence;
    const char *above, *below;
} tie[] = {{3, "5/8", "1/8"}, {4, "3/4", "0"}, {6, "7/8", "-1/8"}};

static void test_ties(void)
{
    static const int digits[] = {1, 3, 8, 10, 15, 16, 17, 19, 20, 30, 38, 39, 40, 50, 77, 100, 200};
    char centre[400];
    test_begin("prove-ties");
    for (size_t i = 0; i < sizeof tie / sizeof *tie; i++) {
        check_not_proved(LOOP_MASK, tie[i].above, tie[i].valence);
        check_not_proved(LOOP_MASK, tie[i].below, tie[i].valence);
        for (size_t j = 0; j < sizeof digits / sizeof *digits; j++) {
            make_centre(centre, sizeof centre, tie[i].above, 1, digits[j]);
            check_not_proved(LOOP_MASK, centre, tie[i].valence);
            make_centre(centre, sizeof centre, tie[i].below, -1, digits[j]);
            check_not_proved(LOOP_MASK, centre, tie[i].valence);
        }
    }
    test_end();
}

/* The tie where nothing is rational. */
static void test_irrational_ties(void)
{
    static const long valence[] = {3, 4, 5, 6, 7, 8, 11, 20, 100};
    test_begin("prove-irrational-ties");
    for (size_t i = 0; i < sizeof valence / sizeof *valence; i++) {
        check_not_proved(LOOP_MASK, "3/4 + cos(2*pi/k)/4", valence[i]);
        check_not_proved(LOOP_MASK, "-cos(2*pi/k)/4", valence[i]);
        check_not_proved(LOOP_MASK, "3/4 + cos(2*pi/k)/4 + 1/10^20", valence[i]);
        check_not_proved(LOOP_MASK, "-cos(2*pi/k)/4 - 1/10^20", valence[i]);
    }
    test_end();
}

/* Weights far from any that make sense. */
static void test_wild_centres(void)
{
    static const char *const wild[] = {"11/8", "1.375000000000000000000000000001", "3/2", "2", "100", "10^30", "-5/8", "-1", "-2", "-100", "-10^30", "10^64", "(10^64)^10"};
    static const long valence[] = {3, 4, 5, 6, 7, 20};
    test_begin("prove-wild-centres");
    for (size_t i = 0; i < sizeof wild / sizeof *wild; i++)
        for (size_t j = 0; j < sizeof valence / sizeof *valence; j++)
            check_not_proved(LOOP_MASK, wild[i], valence[j]);
    test_end();
}

/* Random weights of the centre: never proved beyond L, always proved clearly inside. */
static void test_random_centres(void)
{
    test_begin("prove-random-centres");
    for (test_cases(300); test_next();) {
        static const long rational_valence[] = {3, 4, 6};
        long which = random_range(0, 2), valence = rational_valence[which];
        long l = which + 2;                               /* L = l/8 */
        long numerator = random_range(-2000, 2000);
        long precision = precisions[random_below(3)];
        char centre[64];
        subject s;
        decision d;
        snprintf(centre, sizeof centre, "3/8 + %ld/8000", labs(numerator));
        if (numerator < 0)
            snprintf(centre, sizeof centre, "3/8 - %ld/8000", labs(numerator));
        numerator *= 2;                                   /* c0 - 3/8 = numerator/16000 */
        subject_make(&s, LOOP_MASK, centre);
        decide(&d, &s, valence, with_precision(precision));
        if (labs(numerator) >= 2000 * l)
            CHECK(d.verdict != VERDICT_PROVED, "PROVED, but not C1: centre %s at valence %ld", centre, valence);
        else
            CHECK(d.verdict == VERDICT_PROVED, "centre %s at valence %ld: %s", centre, valence, decision_obstacle(&d)->reason);
        decision_clear(&d);
        subject_clear(&s);
    }
    test_end();
}

/* Loop's mask is the case s = 1/16 of 1 - 6 s, 1/2 - 2 s, 2 s, s, for which L = 1/2 - 2 s + 4 s cos(2 pi/k), other
   eigenvalues are 2 s and c0 - 1/2 + 2 s, and derivative masks are not negative up to s = 1/8.  So the truth is known:
   here at valences where all is rational, with c0 - 1/2 + 2 s at +-L or a little beside. */
static void test_random_schemes(void)
{
    static const char *const beside[] = {"0", "1/1000", "1/10^6", "1/10^12", "1/10^20", "1/10^40"};
    static const long valence[] = {3, 4, 6};
    test_begin("prove-random-schemes");
    for (test_cases(400); test_next();) {
        long which = random_range(0, 2), p = random_range(1, 130);         /* s = p/960 */
        long l = which == 0 ? 480 - 4 * p : which == 1 ? 480 - 2 * p : 480; /* L = l/960 */
        size_t gap = random_below(sizeof beside / sizeof *beside);
        bool inside = random_bool(), negative = random_bool();
        bool dominant = inside && gap > 0 && l > 2 * p, c1 = dominant && p <= 120;
        char mask[256], centre[256];
        subject s;
        decision d;
        snprintf(mask, sizeof mask, "(0,0) 1 - 6*%ld/960\n(1,0) 1/2 - 2*%ld/960\n(1,1) 2*%ld/960\n(2,0) %ld/960\n", p, p, p, p);
        snprintf(centre, sizeof centre, "1/2 - 2*%ld/960 %c (%ld/960 %c %s)", p, negative ? '-' : '+', l, inside ? '-' : '+', beside[gap]);
        subject_make(&s, mask, centre);
        decide(&d, &s, valence[which], escalation(256));
        CHECK(dominant || d.verdict != VERDICT_PROVED, "PROVED, but not C1: s = %ld/960, centre %s at valence %ld", p, centre, valence[which]);
        CHECK(!c1 || d.verdict == VERDICT_PROVED, "s = %ld/960, centre %s at valence %ld: %s", p, centre, valence[which], decision_obstacle(&d)->reason);
        decision_clear(&d);
        subject_clear(&s);
    }
    test_end();
}

/* Inside by little: proved with enough precision, and never with a wrong certificate. */
static void test_inside(void)
{
    static const int digits[] = {1, 2, 4, 6, 8, 10, 15, 20, 30, 50, 100};
    char centre[400];
    test_begin("prove-inside");
    for (size_t i = 0; i < sizeof tie / sizeof *tie; i++)
        for (size_t j = 0; j < sizeof digits / sizeof *digits; j++)
            for (int sign = -1; sign <= 1; sign += 2) {
                subject s;
                decision d;
                make_centre(centre, sizeof centre, sign < 0 ? tie[i].above : tie[i].below, sign, digits[j]);
                subject_make(&s, LOOP_MASK, centre);
                decide(&d, &s, tie[i].valence, escalation(1024));
                CHECK(d.verdict == VERDICT_PROVED, "centre %s at valence %ld: %s", centre, tie[i].valence, decision_obstacle(&d)->reason);
                decision_clear(&d);
                subject_clear(&s);
            }
    test_end();
}

/* Schemes that are not C1 for other reasons than the centre. */
static void test_other_masks(void)
{
    static const char linear[] = "(0,0) 1\n(1,0) 1/2\n", rough[] = "(0,0) 53/50\n(1,0) 13/25\n(1,1) -1/50\n(2,0) -1/100\n",
                      tie_in_block_1[] = "(0,0) 1/2\n(1,0) 1/3\n(1,1) 1/6\n(2,0) 1/12\n", steep[] = "(0,0) 2/5\n(1,0) 3/10\n(1,1) 1/5\n(2,0) 1/10\n",
                      fast[] = "(0,0) 1/4\n(1,0) 1/4\n(1,1) 1/4\n(2,0) 1/8\n", butterfly[] = "(0,0) 1\n(1,0) 1/2\n(1,1) 1/8\n(2,1) -1/16\n",
                      copy[] = "(0,0) 1\n(1,0) 0\n(1,1) 1/2\n";
    test_begin("prove-other-masks");
    for (long k = 3; k <= 8; k++) {
        check_not_proved(linear, "1/2", k);
        check_not_proved(linear, "1", k);
        check_not_proved(rough, "1/2", k);
        if (k == 3 || k >= 8) /* Zorin 6.3: C1 exactly from 4 to 7 */
            check_not_proved(butterfly, "1", k);
        check_not_proved(copy, "1/2", k);
    }
    check_not_proved(tie_in_block_1, "1/2", 3); /* L = m11 = 1/6 */
    check_not_proved(steep, "1/3", 3);          /* L = 1/10 < m11 = 1/5 */
    check_not_proved(fast, "3/10", 3);          /* L = 0 */
    check_not_proved(fast, "3/10", 4);          /* L = m11 = 1/4 */
    test_end();
}

/* Errors in the rule that appear only at one valence. */
static void test_errors_at_a_valence(void)
{
    subject s;
    decision d;
    test_begin("prove-errors-at-a-valence");
    subject_make(&s, LOOP_MASK, "3/8 + 0/(k-5)");
    decide(&d, &s, 4, escalation(128));
    CHECK(d.verdict == VERDICT_PROVED, "valence 4: %s", decision_obstacle(&d)->reason);
    decision_clear(&d);
    decide(&d, &s, 5, escalation(128));
    CHECK(d.verdict == VERDICT_UNDECIDED && decision_obstacle(&d)->reason[0], "division by zero at valence 5");
    decision_clear(&d);
    subject_clear(&s);
    test_end();
}

/* A limit that is too low leaves it undecided and says why. */
static void test_limits(void)
{
    subject s;
    decision d;
    limits l = balls(128);
    test_begin("prove-limits");
    subject_make(&s, "(0,0) 1\n(1,0) 1/2\n(1,1) 1/8\n(2,1) -1/16\n", "1");
    l.max_level = 1;
    decide(&d, &s, 5, l); /* Butterfly needs level 2 */
    CHECK(d.verdict == VERDICT_UNDECIDED && decision_obstacle(&d)->reason[0] && d.certificate.length == 0, "valence 5 is decided at level 1");
    decision_clear(&d);
    l.max_level = 12;
    decide(&d, &s, 5, l);
    CHECK(d.verdict == VERDICT_PROVED, "valence 5: %s", decision_obstacle(&d)->reason);
    decision_clear(&d);
    subject_clear(&s);
    subject_make(&s, LOOP_MASK, "5/8 - 1/10^10");
    decide(&d, &s, 3, escalation(0)); /* whatever the verdict, no ball may have been tried */
    for (int i = 0; i < d.findings.attempt_count; i++)
        CHECK(strcmp(d.findings.attempts[i].system, "ball"), "balls are used though only intervals are allowed");
    decision_clear(&d);
    l = escalation(64);
    l.no_intervals = true;
    decide(&d, &s, 4, l);
    CHECK(d.verdict == VERDICT_PROVED && !strcmp(d.findings.attempts[1].system, "ball"), "intervals are used though they are not to be trusted");
    decision_clear(&d);
    subject_clear(&s);
    test_end();
}

int main(void)
{
    test_loop();
    test_ties();
    test_irrational_ties();
    test_wild_centres();
    test_random_centres();
    test_random_schemes();
    test_inside();
    test_other_masks();
    test_errors_at_a_valence();
    test_limits();
    return test_status();
}
