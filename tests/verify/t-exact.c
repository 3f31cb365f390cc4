/* t-exact.c: refutations that rest on numbers being equal, or on two eigenpairs: found, followed, and rejected if one thing
   is wrong. */
#include "common.h"

/* Loop's mask with a weight of the centre whose eigenvalue is L itself, or minus it. */
#define TIE_ABOVE "3/8 + (3/8 + cos(2*pi/k)/4)"
#define TIE_BELOW "3/8 - (3/8 + cos(2*pi/k)/4)"

typedef struct {
    const char *name;
    const char *centre; /* NULL: of the catalogue */
    const char *scheme, *parameter;
    long valence;
    claim_kind claim;
    int lines;
} refutation;

static const refutation refutations[] = {
    {"tie-above", TIE_ABOVE, NULL, NULL, 5, CLAIM_TIE, 2},
    {"tie-below", TIE_BELOW, NULL, NULL, 7, CLAIM_TIE, 2},
    {"tie-of-others", NULL, "loop-ring", "others=1/2", 20, CLAIM_TIE, 9},
    {"tie-negative", NULL, "loop-ring", "others=-3/4", 9, CLAIM_TIE, 2},
    {"jordan", NULL, "butterfly", NULL, 3, CLAIM_JORDAN, 2},
    {"minus-one", "1 - k/16", NULL, NULL, 26, CLAIM_MODULUS_ONE, 1},
    {"one", NULL, "loop-ring", "l2=1", 7, CLAIM_MODULUS_ONE, 1},
    {"real", NULL, "loop-ring", "l2=3/4", 4, CLAIM_REAL, 0},
    {"real-negative", NULL, "loop-ring", "l2=-3/4", 4, CLAIM_REAL, 0},
};
enum { REFUTATIONS = sizeof refutations / sizeof *refutations };

static void make_subject(subject *z, const refutation *r)
{
    if (r->centre)
        subject_make(z, LOOP_MASK, r->centre);
    else
        subject_from_catalogue(z, r->scheme, r->parameter);
}

static void read_choices(choices *c, const subject *s, const decision *d)
{
    long line = -1;
    choices_init(c);
    MUST(certificate_read(c, &line, &s->scheme, d->certificate.bytes, d->certificate.length));
    CHECK(line == 0, "the certificate does not read back (line %ld)", line);
}

static bool is_followed(choices *c, const subject *s)
{
    deadline none = {0};
    analysis_plan plan = {.problem = &s->problem, .deadline = &none, .system = "grid"};
    findings f;
    outcome o;
    findings_init(&f);
    o = analysis_replay_grid(&f, c, &plan, c->grid);
    findings_clear(&f);
    return o == OUTCOME_TRUE;
}

static void test_found(void)
{
    for (int i = 0; i < REFUTATIONS; i++) {
        const refutation *r = &refutations[i];
        char name[64];
        subject s;
        decision d;
        choices c;
        snprintf(name, sizeof name, "exact-%s", r->name);
        test_begin(name);
        make_subject(&s, r);
        decide(&d, &s, r->valence, escalation(512));
        CHECK(d.verdict == VERDICT_REFUTED && d.claim == r->claim, "%s: %s", verdict_name(d.verdict), decision_obstacle(&d)->reason);
        if (d.verdict == VERDICT_REFUTED) {
            read_choices(&c, &s, &d);
            CHECK(c.exact.count == r->lines, "%d exact blocks, not %d", c.exact.count, r->lines);
            CHECK(is_followed(&c, &s), "the certificate is not followed");
            choices_clear(&c);
        }
        decision_clear(&d);
        subject_clear(&s);
        test_end();
    }
}

/* One change each; false: there is nothing to change. */
static bool change_sign(choices *c) { return c->exact.line[0].sign = -c->exact.line[0].sign, c->exact.count > 0; }
static bool change_multiplicity(choices *c) { return c->exact.line[0].multiplicity++, c->exact.count > 0; }
static bool change_size(choices *c)
{
    bool larger = c->exact.line[0].size > 1;
    c->exact.line[0].size -= larger;
    return larger;
}
static bool change_size_of_second(choices *c)
{
    bool larger = c->exact.count > 1 && c->exact.line[1].size > 1;
    c->exact.line[1].size -= larger;
    return larger;
}
static bool change_column(choices *c)
{
    for (int i = 0; i < c->exact.count; i++)
        if (c->exact.line[i].column)
            return c->exact.line[i].column = 0, true;
    return false;
}
static bool change_column_beyond(choices *c)
{
    for (int i = 0; i < c->exact.count; i++)
        if (c->exact.line[i].column)
            return c->exact.line[i].column = 60, true;
    return false;
}
static bool change_frequency(choices *c) { return c->exact.count ? (c->exact.line[c->exact.count - 1].frequency++, true) : false; }
static bool change_power(choices *c)
{
    bool used = c->exact.line[0].power > 0;
    c->exact.line[0].power = 0;
    return used;
}
static bool change_power_of_one(choices *c) { return c->claim == CLAIM_MODULUS_ONE ? (c->exact.line[0].power = 1, true) : false; }
static bool change_last(choices *c) { return c->exact.count > 1 ? (c->exact.count--, true) : false; }
static bool change_factor(choices *c)
{
    if (c->exact.degree)
        MUST(rational_mul_2exp(&c->exact.coefficient[0], &c->exact.coefficient[0], 1));
    return c->exact.degree > 0;
}
static bool change_factor_slightly(choices *c)
{
    rational q;
    if (!c->exact.degree)
        return false;
    rational_init(&q);
    MUST(rational_set_si(&q, 1, 1) && rational_mul_2exp(&q, &q, -400) && rational_add(&c->exact.coefficient[0], &c->exact.coefficient[0], &q));
    rational_clear(&q);
    return true;
}
static bool change_eigenvalue(choices *c)
{
    MUST(integer_add(&c->exact.eigenvalue, &c->exact.eigenvalue, &c->exact.radius) && integer_add(&c->exact.eigenvalue, &c->exact.eigenvalue, &c->exact.radius));
    return c->exact.degree > 0;
}
static bool change_radius(choices *c) { return integer_set_si(&c->exact.radius, 0), c->exact.degree > 0; }
static bool change_radius_to_everything(choices *c)
{
    MUST(integer_set(&c->exact.radius, &c->exact.eigenvalue));
    return c->exact.degree > 0;
}
static bool change_blocks(choices *c) { return c->blocks.count ? (c->blocks.count--, true) : false; }
static bool change_claim(choices *c)
{
    if (c->claim == CLAIM_REAL)
        return false;
    c->claim = c->claim == CLAIM_TIE ? CLAIM_JORDAN : c->claim == CLAIM_JORDAN ? CLAIM_TIE : CLAIM_MODULUS_ONE;
    return c->claim != CLAIM_MODULUS_ONE;
}
static bool change_witness(choices *c)
{
    c->witness[0].element = 1000;
    return claim_witnesses(c->claim) > 0;
}
static bool change_second_frequency(choices *c) { return c->second_frequency = 0, c->claim == CLAIM_REAL; }
/* Of the other eigenvalue that is said to be the second. */
static bool change_second_to_first(choices *c)
{
    eigenpair_choice e = c->second;
    if (c->claim != CLAIM_REAL)
        return false;
    c->second = c->eigenpair;
    c->eigenpair = e;
    return true;
}
static bool change_second_eigenvalue(choices *c)
{
    if (c->claim == CLAIM_REAL)
        MUST(integer_mul_si(&c->second.approximation[c->second.n - 1], &c->second.approximation[c->second.n - 1], 2));
    return c->claim == CLAIM_REAL;
}
static bool change_second_radius(choices *c)
{
    if (c->claim == CLAIM_REAL)
        MUST(integer_mul_2exp(&c->second.radius, &c->second.radius, 60));
    return c->claim == CLAIM_REAL;
}
static bool change_path(choices *c)
{
    c->witness[0].path[0] = '9';
    c->witness[0].path[1] = '\0';
    c->witness[0].depth = 1;
    return claim_witnesses(c->claim) > 0;
}
static bool change_block(choices *c)
{
    for (size_t i = 0; i < c->blocks.count; i++)
        if (c->blocks.box[i].power > 0)
            return c->blocks.box[i].power = 0, true;
    return false;
}
static bool change_more_boxes(choices *c)
{
    MUST(cover_list_add(&c->blocks, one_frequency(c->k.first), 3));
    return c->claim != CLAIM_MODULUS_ONE;
}
static bool change_valence(choices *c) { return c->k.first++, c->k.last++, true; }

typedef struct {
    const char *name;
    bool (*make)(choices *);
} change;

static const change changes[] = {
    {"sign", change_sign}, {"multiplicity", change_multiplicity}, {"size", change_size}, {"size of second", change_size_of_second},
    {"column", change_column}, {"column beyond", change_column_beyond}, {"frequency", change_frequency}, {"power", change_power},
    {"power of one", change_power_of_one}, {"last", change_last}, {"factor", change_factor}, {"factor slightly", change_factor_slightly},
    {"eigenvalue", change_eigenvalue}, {"radius", change_radius}, {"radius to everything", change_radius_to_everything}, {"blocks", change_blocks},
    {"claim", change_claim}, {"witness", change_witness}, {"valence", change_valence},
    {"second frequency", change_second_frequency}, {"second in place of the first", change_second_to_first}, {"second eigenvalue", change_second_eigenvalue},
    {"second radius", change_second_radius}, {"path", change_path}, {"power of a block", change_block},
    {"box behind all blocks", change_more_boxes},
};
enum { CHANGES = sizeof changes / sizeof *changes };

static void test_changed(void)
{
    int made[CHANGES] = {0};
    test_begin("exact-changed");
    for (int i = 0; i < REFUTATIONS; i++) {
        subject s;
        decision d;
        make_subject(&s, &refutations[i]);
        decide(&d, &s, refutations[i].valence, escalation(512));
        for (int j = 0; d.verdict == VERDICT_REFUTED && j < CHANGES; j++) {
            choices c;
            read_choices(&c, &s, &d);
            if (changes[j].make(&c)) {
                made[j]++;
                CHECK(!is_followed(&c, &s), "%s: another %s, and the certificate is followed", refutations[i].name, changes[j].name);
            }
            choices_clear(&c);
        }
        decision_clear(&d);
        subject_clear(&s);
    }
    for (int j = 0; j < CHANGES; j++)
        CHECK(made[j] > 0, "nowhere another %s", changes[j].name);
    test_end();
}

/* Here no real function is in front: neither that of block 2 at valence 4, which is smaller than that of block 1,
   nor that of block 1 at valence 5, which is none. */
static void test_not_real(void)
{
    static const long cases[2][3] = {{4, 2, 1}, {5, 1, 2}};
    subject s;
    test_begin("real-not");
    subject_from_catalogue(&s, "loop-ring", "l2=2/5");
    for (int i = 0; i < 2; i++) {
        analysis_plan plan = {.problem = &s.problem, .deadline = &(deadline){0}, .system = "ball", .max_level = 10};
        findings f;
        choices c;
        findings_init(&f);
        choices_init(&c);
        c.claim = CLAIM_REAL;
        c.valence = cases[i][0];
        c.frequency = cases[i][1];
        c.second_frequency = cases[i][2];
        CHECK(analysis_search(&f, &c, &plan, 128) != OUTCOME_TRUE, "valence %ld: block %ld dominates", cases[i][0], cases[i][1]);
        choices_clear(&c);
        findings_clear(&f);
    }
    subject_clear(&s);
    test_end();
}

/* Almost equal is not equal: nothing exact is claimed of it. */
static void test_almost(void)
{
    test_begin("exact-almost");
    for (int i = 0; i < 2; i++) {
        subject s;
        decision d;
        subject_make(&s, LOOP_MASK, i ? TIE_ABOVE " + 10^-40" : TIE_ABOVE " - 10^-40");
        decide(&d, &s, 5, escalation(512));
        CHECK(d.verdict == (i ? VERDICT_REFUTED : VERDICT_PROVED), "%s", verdict_name(d.verdict));
        CHECK(i == 0 || d.claim == CLAIM_FREQUENCY, "refuted for another reason: %s", d.reason);
        decision_clear(&d);
        subject_clear(&s);
    }
    test_end();
}

int main(void)
{
    test_found();
    test_changed();
    test_not_real();
    test_almost();
    return test_status();
}
