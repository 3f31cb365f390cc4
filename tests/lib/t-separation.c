/* t-separation.c: the largest eigenvalue of block 1 against all other blocks, at many valences. */
#include "lib/eigen_approx.h"
#include "lib/eigenpair_affine.h"
#include "lib/separation.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { GRID = 64, PRECISION = 128 };

static const cover_limits limits = {.tries = 10000, .power = 10000};

typedef struct {
    scheme s;
    valence_range k;
    number scale;
    double least; /* of L */
    rise_list rises;
    span_list spans;
    bool has_pair;
    separation_answer found;
} setting;

/* scale = 1 / the least number of L's range, upward. */
static bool find_scale(setting *z)
{
    affine_matrix matrix;
    eigenpair_choice choice;
    diagnostic d;
    arc r;
    affine *box = NULL;
    bool ok;
    arc_init(&r);
    eigenpair_choice_init(&choice);
    MUST(arc_set_valences(&r, z->k));
    CHECK(affine_matrix_make(&matrix, &z->s, z->k, one_frequency(1), &r, PRECISION, &d) == BLOCK_OK, "%s: the matrix", z->s.name);
    box = affine_array_new((size_t)matrix.n + 1);
    ok = eigenpair_affine_choose(&choice, matrix.entry, matrix.n, GRID, PRECISION) == TRUTH_TRUE && eigenpair_affine_prove(box, &choice, matrix.entry, matrix.n, PRECISION) == TRUTH_TRUE;
    if (ok) {
        affine_range(&z->scale, &box[matrix.n], PRECISION);
        number_lower(&z->scale, &z->scale, PRECISION);
        z->least = number_mid_approx(&z->scale);
        number_inv(&z->scale, &z->scale, PRECISION);
        number_upper(&z->scale, &z->scale, PRECISION);
    }
    affine_array_free(box, (size_t)matrix.n + 1);
    affine_matrix_free(&matrix);
    eigenpair_choice_clear(&choice);
    arc_clear(&r);
    return ok;
}

static void search(setting *z, const char *text, long first, long last)
{
    diagnostic d = {0, 0, ""};
    read_scheme(&z->s, text);
    z->k = (valence_range){first, last};
    number_init(&z->scale);
    rise_list_init(&z->rises);
    span_list_init(&z->spans);
    z->has_pair = find_scale(z);
    z->found = (separation_answer){.status = BLOCK_OK};
    if (z->has_pair)
        z->found = separation_search(&z->rises, &z->spans, &z->s, z->k, &z->scale, &limits, GRID, PRECISION, &d);
    CHECK(z->found.status == BLOCK_OK, "%s: %s", z->s.name, d.text);
    CHECK(z->found.proved || (z->rises.count == 0 && z->spans.count == 0), "%s: lists without a proof", z->s.name);
}

static void clear(setting *z)
{
    number_clear(&z->scale);
    rise_list_clear(&z->rises);
    span_list_clear(&z->spans);
    scheme_clear(&z->s);
}

static bool verifies(const setting *z)
{
    diagnostic d;
    separation_answer a = separation_verify(&z->rises, &z->spans, &z->s, z->k, &z->scale, PRECISION, &d);
    CHECK(a.status == BLOCK_OK, "%s: status %d", z->s.name, (int)a.status);
    return a.proved;
}

/* About the spectral radius of a block. */
static double radius(const scheme *s, long m, long k)
{
    scheme_numbers numbers;
    block b;
    diagnostic d;
    double z = NAN, *entry;
    CHECK(scheme_numbers_make(&numbers, s, k, PRECISION, &d) == STATUS_OK && block_make(&b, &numbers, m, true, &d) == BLOCK_OK, "%s: block %ld of %ld", s->name, m, k);
    entry = malloc((size_t)b.n * (size_t)b.n * sizeof *entry);
    for (int i = 0; entry && i < b.n * b.n; i++)
        entry[i] = number_mid_approx(&b.entry[i]);
    if (entry)
        z = spectral_radius_approx(entry, b.n);
    free(entry);
    block_free(&b);
    scheme_numbers_free(&numbers);
    return z;
}

/* What is proved is true at some valences. */
static void check_truth(const setting *z)
{
    for (int i = 0; i < 6; i++) {
        long k = i == 0 ? z->k.first : random_range(z->k.first, z->k.last == VALENCES_UNBOUNDED ? 20 * z->k.first : z->k.last);
        double one = radius(&z->s, 1, k);
        CHECK(one >= z->least, "%s: L at %ld is %.9g, not at least %.9g", z->s.name, k, one, z->least);
        for (int j = 0; j < 4; j++) {
            long m = j == 0 ? 2 : random_range(2, k / 2);
            CHECK(radius(&z->s, m, k) < one * (1 + 1e-12), "%s: block %ld of %ld", z->s.name, m, k);
        }
    }
}

static void check(const char *name, long first, long last, bool rises)
{
    setting z;
    search(&z, catalogue_text(name), first, last);
    CHECK(z.found.proved, "%s, %ld to %ld: failed at %ld, %.6g, chain to %.6g", name, first, last, z.found.span.open.first, (double)z.found.span.open_from * 0x1p-48, (double)z.found.rise.end * 0x1p-48);
    CHECK(z.found.proved == verifies(&z), "%s, %ld to %ld: what was found is no proof", name, first, last);
    CHECK((z.rises.count > 0) == rises, "%s, %ld to %ld: %d arcs", name, first, last, (int)z.rises.count);
    if (z.found.proved)
        check_truth(&z);
    clear(&z);
}

static void test_proofs(void)
{
    test_begin("separations");
    check("loop", 20, VALENCES_UNBOUNDED, true);
    check("loop", 7, 8, false);
    check("loop", 10, 25, true);
    check("loop", 1000000, 1000000000, true);
    check("catmull-clark", 15, VALENCES_UNBOUNDED, true);
    check("catmull-clark", 10, 14, false);
    check("midpoint", 15, VALENCES_UNBOUNDED, true);
    check("kobbelt", 60, VALENCES_UNBOUNDED, true);
    check("wave", 22, VALENCES_UNBOUNDED, true);
    check("modified-butterfly", 22, VALENCES_UNBOUNDED, false);
    check("modified-butterfly", 10, 12, false);
    check("doo-sabin", 15, VALENCES_UNBOUNDED, false);
    check("modified-loop", 30, VALENCES_UNBOUNDED, false);
    check("loop-ring", 22, VALENCES_UNBOUNDED, false);
    test_end();
}

/* Frequency 2 needs a group of its own: with 0 to 1/4 for its weight its eigenvalue may be anything below. */
static void test_groups(void)
{
    static const char text[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                               "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) spectrum cases(m = 0: 5/8; m = 1: 1/2; m = 2: 7/16; m = 3: -7/16; else: 1/m)\nend\n";
    setting z;
    test_begin("separations-by-groups");
    search(&z, text, 30, VALENCES_UNBOUNDED);
    CHECK(z.found.proved && verifies(&z), "the groups");
    check_truth(&z);
    if (z.spans.count > 1) {
        span_box saved = z.spans.box[z.spans.count - 1];
        z.spans.box[z.spans.count - 1].m.first++;
        CHECK(!verifies(&z), "a frequency is missing");
        z.spans.box[z.spans.count - 1] = saved;
        z.spans.count--;
        CHECK(!verifies(&z), "the last ones are missing");
        z.spans.count++;
        CHECK(verifies(&z), "mended");
    }
    clear(&z);
    test_end();
}

static void check_none(const char *text, long first, long last)
{
    setting z;
    search(&z, text, first, last);
    CHECK(!z.found.proved, "%s, %ld to %ld: proved", z.s.name, first, last);
    clear(&z);
}

/* Where frequency 2 dominates, ties, or one valence of the range is not like the others. */
static void test_none(void)
{
    static const char tie[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                              "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) spectrum cases(m = 0: 5/8; m <= 2: 1/2; else: 1/4)\nend\n";
    static const char one_tie[] = "scheme x\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n"
                                  "rule centre\ncentre 5/8\nall (1,0) rest\nend\nrule (1,0)\ncentre rest\n(1,0) spectrum cases(m = 0: 5/8; m = 1: 1/2; k = 40 and m = 3: 1/2; else: 1/4)\nend\n";
    test_begin("separations-that-are-none");
    check_none(catalogue_text("butterfly"), 8, VALENCES_UNBOUNDED);
    check_none(catalogue_text("butterfly"), 100, 101);
    check_none(catalogue_text("butterfly"), 1000, 1100);
    check_none(tie, 30, VALENCES_UNBOUNDED);
    check_none(one_tie, 30, 50);
    setting z;
    search(&z, one_tie, 41, VALENCES_UNBOUNDED);
    CHECK(z.found.proved && verifies(&z), "behind the tie");
    z.k.first = 40;
    CHECK(!verifies(&z), "with the tie");
    clear(&z);
    test_end();
}

static void test_lies(void)
{
    setting z;
    test_begin("separations-with-a-lie");
    search(&z, catalogue_text("loop"), 10, 25);
    CHECK(z.rises.count >= 2 && z.spans.count >= 2 && verifies(&z), "the lists");
    if (test_failed()) {
        clear(&z);
        test_end();
        return;
    }
    rise_box *box = &z.rises.box[1];
    span_box *span = &z.spans.box[0], *last = &z.spans.box[z.spans.count - 1];
    const rise_box saved_box = *box;
    const span_box saved_span = *span, saved_last = *last;
#define LIE(change, what)                    \
    do {                                     \
        change;                              \
        CHECK(!verifies(&z), "%s", what);    \
        *box = saved_box;                    \
        *span = saved_span;                  \
        *last = saved_last;                  \
    } while (0)
    LIE(box->q *= 2, "an arc too wide, beyond the end of the next");
    LIE(box->q = z.rises.box[0].q, "an arc of no width");
    LIE(box->power = -1, "no power");
    LIE(box->q = ARC_HALF + 1, "an arc beyond 1/2");
    LIE(span->power = 0, "a power too low, of a span");
    LIE(span->power = -1, "no power, of a span");
    LIE(span->q = ARC_HALF, "a span too wide, that ends the group");
    LIE(last->q = ARC_HALF - 1, "the group does not end");
    LIE(last->q = ARC_HALF + 1, "the group ends beyond 1/2");
    LIE(last->m.first = 3, "another group");
    LIE(span->m.last = 20, "a group of one span, not ended");
    LIE(last->m.last = 11, "not all frequencies");
    LIE(z.k.last = 1000, "more valences");
    z.k.last = 25;
    LIE(z.k.last = VALENCES_UNBOUNDED, "all valences");
    z.k.last = 25;
    LIE(z.k.first = 6, "smaller valences");
    z.k.first = 10;
    LIE(box->eigenpair.pivot ^= 1, "another pivot");
    box = &z.rises.box[z.rises.count - 1];
    const rise_box saved_last_box = *box;
    box->power = -1;
    CHECK(!verifies(&z), "an arc beyond 1/10 that is not proved");
    *box = saved_last_box;
    for (size_t i = 0; i < z.spans.count; i++)
        z.spans.box[i].m.first = 3;
    CHECK(!verifies(&z), "frequency 2 is missing");
    for (size_t i = 0; i < z.spans.count; i++)
        z.spans.box[i].m.first = 2;
    CHECK(verifies(&z), "mended");
    size_t count = z.rises.count;
    z.rises.count = 1;
    CHECK(!verifies(&z), "the chain ends before 1/10");
    z.rises.count = 0;
    CHECK(!verifies(&z), "no chain");
    z.rises.count = count;
    number_mul_2exp(&z.scale, &z.scale, 1, PRECISION);
    CHECK(!verifies(&z), "half of L");
    number_mul_2exp(&z.scale, &z.scale, -1, PRECISION);
    CHECK(verifies(&z), "mended");
    clear(&z);
    test_end();
}

/* Of Butterfly's blocks those near m/k = 0.19275 have the largest eigenvalue: it falls with u below that, and rises above. */
static void check_rise(const char *name, long first, long last, bool expected)
{
    scheme s;
    rise_list list;
    diagnostic d;
    read_scheme(&s, catalogue_text(name));
    rise_list_init(&list);
    int64_t start = arc_units_below(1, last);
    rise_answer a = rise_search(&list, &s, (valence_range){first, last}, start + start / 16, 100, &limits, GRID, PRECISION, &d);
    CHECK(a.status == BLOCK_OK && a.proved == expected && (a.end > start) == expected && (list.count > 0) == expected, "%s, from 1/%ld: %d arcs", name, last, (int)list.count);
    rise_list_clear(&list);
    scheme_clear(&s);
}

static void test_rises(void)
{
    test_begin("rises");
    check_rise("butterfly", 3, 5, true);
    check_rise("butterfly", 3, 6, false);
    check_rise("butterfly", 3, 12, false);
    check_rise("loop", 3, 6, true);
    check_rise("modified-butterfly", 7, 9, false); /* weights depend on m */
    check_rise("wave-valence", 7, 9, true); /* but for the centre, nothing depends on k */
    test_end();
}

/* A chain whose rest needs squarings, and one group only behind it. */
static void test_more_lies(void)
{
    setting z;
    diagnostic d;
    test_begin("separations-with-more-lies");
    search(&z, catalogue_text("kobbelt"), 60, VALENCES_UNBOUNDED);
    if (z.rises.count && verifies(&z)) {
        CHECK(z.rises.box[0].power > 0, "no squarings");
        z.rises.box[0].power = 0;
        CHECK(!verifies(&z), "a power too low");
    } else
        CHECK(false, "no lists");
    clear(&z);
    search(&z, catalogue_text("loop"), 20, VALENCES_UNBOUNDED);
    CHECK(z.found.proved, "loop");
    span_task task = {&z.s, z.k, {2, 2}, z.found.rise.end, ARC_HALF};
    span_list_clear(&z.spans);
    CHECK(span_search(&z.spans, &task, &z.scale, &limits, PRECISION, &d).proved, "frequency 2");
    task.m = (frequencies){3, FREQUENCIES_UNBOUNDED};
    CHECK(span_search(&z.spans, &task, &z.scale, &limits, PRECISION, &d).proved, "the others");
    CHECK(!verifies(&z), "two groups behind a chain");
    task.m.first = 2;
    CHECK(span_verify(z.spans.box, z.spans.count, &task, &z.scale, PRECISION, &d).proved, "which are a cover");
    clear(&z);
    test_end();
}

/* Parts of all blocks: an arc of m/k, and frequencies up to one. */
static void test_parts(void)
{
    setting z;
    span_answer a;
    diagnostic d;
    test_begin("spans-of-parts");
    search(&z, catalogue_text("loop"), 20, VALENCES_UNBOUNDED);
    span_task task = {&z.s, z.k, {2, FREQUENCIES_UNBOUNDED}, ARC_HALF / 4, ARC_HALF / 2};
    span_list list;
    span_list_init(&list);
    a = span_search(&list, &task, &z.scale, &limits, PRECISION, &d);
    CHECK(a.proved && list.count && list.box[list.count - 1].q == task.end, "from 1/8 to 1/4");
    CHECK(span_verify(list.box, list.count, &task, &z.scale, PRECISION, &d).proved, "the spans");
    task.start--;
    CHECK(span_verify(list.box, list.count, &task, &z.scale, PRECISION, &d).proved == true, "the first one is wider");
    task.end++;
    CHECK(!span_verify(list.box, list.count, &task, &z.scale, PRECISION, &d).proved, "a gap");
    span_list_clear(&list);
    task = (span_task){&z.s, {20, 30}, {4, 6}, 0, ARC_HALF};
    a = span_search(&list, &task, &z.scale, &limits, PRECISION, &d);
    CHECK(a.proved && list.box[list.count - 1].m.last == 6 && span_verify(list.box, list.count, &task, &z.scale, PRECISION, &d).proved, "frequencies 4 to 6");
    task.m.last = 7;
    CHECK(!span_verify(list.box, list.count, &task, &z.scale, PRECISION, &d).proved, "frequency 7");
    span_list_clear(&list);
    clear(&z);
    test_end();
}

static void tests(void)
{
    test_proofs();
    test_groups();
    test_none();
    test_lies();
    test_more_lies();
    test_rises();
    test_parts();
}

MAIN(tests);
