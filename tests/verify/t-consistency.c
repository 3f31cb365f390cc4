/* t-consistency.c: other criteria beside our verdict, and when they contradict each other. */
#include "verify/consistency.h"

#include "common.h"

/* The whole spectrum by balls of 128 bits, and the index of the simple dominant eigenvalue of block m. */
static long find_dominant(spectrum_list *l, const subject *s, long k, long m)
{
    diagnostic d;
    long best = -1, one;
    spectrum_list_init(l);
    CHECK(spectrum_list_make_ball(l, &s->scheme, k, 15, 128, &d) == STATUS_OK, "no spectrum");
    one = spectrum_find_one(l);
    for (size_t i = 0; i < l->count; i++)
        if ((long)i != one && (best < 0 || l->entry[i].modulus_lower > l->entry[best].modulus_lower))
            best = (long)i;
    CHECK(best >= 0 && l->entry[best].m == m, "the largest eigenvalue is in block %ld", best >= 0 ? l->entry[best].m : -1);
    return best;
}

typedef struct {
    const char *scheme, *parameter;
    long valence, block;
    bool has_signs;
    truth signs;
    bool is_wave;
    truth inequality;
    verdict verdict;
} expectation;

static const expectation expectations[] = {
    {"loop", NULL, 5, 1, true, TRUTH_TRUE, false, TRUTH_UNKNOWN, VERDICT_PROVED},
    {"butterfly", NULL, 8, 2, true, TRUTH_TRUE, false, TRUTH_UNKNOWN, VERDICT_REFUTED},
    {"loop-ring", "z=3/4", 7, 0, true, TRUTH_FALSE, false, TRUTH_UNKNOWN, VERDICT_REFUTED},
    {"loop-ring", "l2=3/4", 4, 2, true, TRUTH_FALSE, false, TRUTH_UNKNOWN, VERDICT_REFUTED},
    {"loop-ring", "l=99/100", 7, 1, true, TRUTH_TRUE, false, TRUTH_UNKNOWN, VERDICT_REFUTED},
    {"wave", NULL, 3, 1, true, TRUTH_TRUE, true, TRUTH_TRUE, VERDICT_PROVED},
    {"midpoint", "degree=4", 5, 1, false, TRUTH_UNKNOWN, true, TRUTH_TRUE, VERDICT_PROVED},
    {"kobbelt", NULL, 5, 1, true, TRUTH_TRUE, false, TRUTH_UNKNOWN, VERDICT_PROVED},
};

static void test_criteria(void)
{
    test_begin("consistency-criteria");
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const expectation *e = &expectations[i];
        subject s;
        spectrum_list l;
        consistency c;
        subject_from_catalogue(&s, e->scheme, e->parameter);
        long dominant = find_dominant(&l, &s, e->valence, e->block);
        CHECK(consistency_make(&c, &s.scheme, e->valence, &l, dominant, false) == STATUS_OK, "%s: no answer", e->scheme);
        CHECK(c.verdict == e->verdict, "%s: %s", e->scheme, verdict_name(c.verdict));
        CHECK(c.signs.applies == e->has_signs && c.signs.holds == e->signs, "%s %s: signs %d", e->scheme, e->parameter ? e->parameter : "", c.signs.holds);
        CHECK(c.waves.applies == e->is_wave && c.waves.holds == e->inequality, "%s %s: waves %d %d", e->scheme, e->parameter ? e->parameter : "", c.waves.applies, c.waves.holds);
        CHECK(!consistency_is_broken(&c), "%s: a contradiction", e->scheme);
        spectrum_list_clear(&l);
        subject_clear(&s);
    }
    test_end();
}

/* All that cannot be true together, and nothing else. */
static void test_contradictions(void)
{
    static const verdict verdicts[] = {VERDICT_PROVED, VERDICT_REFUTED, VERDICT_UNDECIDED};
    test_begin("consistency-contradictions");
    for (int v = 0; v < 3; v++)
        for (int signs = 0; signs < 3; signs++)
            for (int waves = 0; waves < 3; waves++)
                for (int applies = 0; applies < 2; applies++)
                    for (long dominant = -1; dominant < 2; dominant++) {
                        consistency c = {.verdict = verdicts[v], .dominant = dominant, .signs = {applies, (truth)signs}, .waves = {applies, (truth)waves}};
                        bool c1 = v == 0 || (applies && waves == TRUTH_TRUE), not_c1 = v == 1 || (applies && signs == TRUTH_FALSE);
                        CHECK(consistency_is_broken(&c) == ((c1 && not_c1) || (v == 0 && dominant == 0)), "verdict %s, signs %d, waves %d, block %ld",
                              verdict_name(c.verdict), signs, waves, dominant);
                    }
    test_end();
}

int main(void)
{
    test_criteria();
    test_contradictions();
    return test_status();
}
