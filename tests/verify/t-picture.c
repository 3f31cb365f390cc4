/* t-picture.c: pictures of maps that are known, and of what all maps have in common. */
#include "verify/picture.h"

#include "common.h"

#include <math.h>

#define PI 3.14159265358979323846

/* A picture of the dominant map at valence k, found in double intervals. */
static void take(picture *p, findings *f, const subject *s, long k)
{
    deadline never = {0};
    analysis_plan plan = {.problem = &s->problem, .deadline = &never, .system = "interval", .max_level = 12, .picture = p};
    choices c;
    choices_init(&c);
    c.k = one_valence(k);
    picture_init(p, true);
    CHECK(analysis_search(f, &c, &plan, 0) == OUTCOME_TRUE && p->taken, "valence %ld is not proved, or no picture was taken", k);
    choices_clear(&c);
}

static double distance(point p, point q)
{
    return hypot(p.x - q.x, p.y - q.y);
}

static point turned(point p, double re, double im)
{
    return (point){p.x * re - p.y * im, p.x * im + p.y * re};
}

/* A point of the ring, in its coordinates. */
static void random_point(double *a, double *b, const picture *p)
{
    double r = p->ring->radius, s, t = (double)random_below(1000) / 1000;
    if (p->mesh == MESH_TRIANGLE) {
        s = r * (1 + (double)random_below(1000) / 1000);
        *a = s * (1 - t) + 1e-3;
        *b = s * t;
    } else {
        s = 2 * r * (double)random_below(1000) / 1000;
        *a = random_bool() ? r * (1 + t) : s;
        *b = *a < r ? r * (1 + t) : s;
    }
}

/* At the regular valence the dominant map is a e1 + b e2, up to a factor, which the Jacobian is the square of. */
static void test_regular_map(const char *of, long k)
{
    char name[80];
    subject s;
    findings f;
    picture p;
    snprintf(name, sizeof name, "picture-regular-%s", of);
    test_begin(name);
    subject_from_catalogue(&s, of, NULL);
    findings_init(&f);
    take(&p, &f, &s, k);
    if (!test_failed()) {
        double w = 2 * PI / (double)k, r = p.ring->radius;
        point unit = picture_at(&p, r, 0, 0);
        double square = (unit.x * unit.x + unit.y * unit.y) / (r * r), jacobian = square * sin(w) / p.height;
        for (test_cases(300); test_next();) {
            double a, b;
            int sector = (int)random_below((uint64_t)k);
            point expected;
            random_point(&a, &b, &p);
            expected = turned(turned((point){a + b * cos(w), b * sin(w)}, unit.x / r, unit.y / r), cos(w * sector), sin(w * sector));
            CHECK(distance(picture_at(&p, a, b, sector), expected) < 1e-9, "(%g, %g) in sector %d is not where it should be", a, b, sector);
        }
        CHECK(p.least[0] <= jacobian && jacobian <= p.least[1] && p.most[0] <= jacobian && jacobian <= p.most[1] && p.least[0] > 0.5 * jacobian && p.most[1] < 2 * jacobian,
              "the Jacobian is %g, its minimum in [%g, %g], its maximum in [%g, %g]", jacobian, p.least[0], p.least[1], p.most[0], p.most[1]);
    }
    picture_clear(&p);
    findings_clear(&f);
    problem_clear(&s.problem);
    scheme_clear(&s.scheme);
    test_end();
}

/* F(y/2) = L F(y), and the end of one sector is the beginning of the next. */
static void test_any_map(const char *of, long k)
{
    char name[80];
    subject s;
    findings f;
    picture p;
    snprintf(name, sizeof name, "picture-%s", of);
    test_begin(name);
    subject_from_catalogue(&s, of, NULL);
    findings_init(&f);
    take(&p, &f, &s, k);
    if (!test_failed()) {
        double r = p.ring->radius, size = hypot(picture_at(&p, r, 0, 0).x, picture_at(&p, r, 0, 0).y);
        for (test_cases(300); test_next();) {
            double a, b;
            random_point(&a, &b, &p);
            CHECK(distance(picture_at(&p, a / 2, b / 2, 0), turned(picture_at(&p, a, b, 0), p.re, p.im)) < 0.03 * size, "(%g, %g) / 2 is not L times as far", a, b);
            CHECK(distance(picture_at(&p, 0, r + a / 4, 0), picture_at(&p, r + a / 4, 0, 1)) < 1e-9 * size, "sectors do not meet at %g", r + a / 4);
        }
        for (size_t i = 0; i < p.signs.count; i++)
            CHECK(p.signs.leaf[i].lower > 0 || p.signs.leaf[i].level == PICTURE_DEPTH, "a leaf of level %d has an open sign", p.signs.leaf[i].level);
        CHECK(p.least[1] >= f.jacobian && p.least[0] <= p.most[1], "the Jacobian's minimum is in [%g, %g], and above %g", p.least[0], p.least[1], f.jacobian);
    }
    picture_clear(&p);
    findings_clear(&f);
    problem_clear(&s.problem);
    scheme_clear(&s.scheme);
    test_end();
}

static void test_leaves(void)
{
    static const element elements[] = {{ELEMENT_UP, 2, 0}, {ELEMENT_DOWN, 1, 0}};
    static const char *const bad[] = {"0", "01", "1000", "x0", ""};
    char letters[] = "010200";
    tree_word word = {letters, 6, 7, 0};
    picture_leaves leaves = {NULL, 0, 0};
    test_begin("picture-leaves");
    CHECK(picture_read_leaves(&leaves, &word, elements, 2) && leaves.count == 5, "%zu leaves", leaves.count);
    if (leaves.count == 5) {
        CHECK(leaves.leaf[0].type == ELEMENT_UP && leaves.leaf[0].level == 0 && leaves.leaf[0].a == 2, "the first leaf is another");
        CHECK(leaves.leaf[1].type == ELEMENT_DOWN && leaves.leaf[1].level == 1 && leaves.leaf[1].a == 3 && leaves.leaf[1].b == 1, "the first child is another");
        CHECK(leaves.leaf[2].letter == TREE_COEFFICIENTS && leaves.leaf[4].type == ELEMENT_UP, "the other children are others");
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        tree_word wrong = {(char *)(uintptr_t)bad[i], strlen(bad[i]), 0, 0};
        leaves.count = 0;
        CHECK(!picture_read_leaves(&leaves, &wrong, elements, 2), "'%s' is taken for trees", bad[i]);
    }
    free(leaves.leaf);
    test_end();
}

int main(void)
{
    test_regular_map("loop", 6);
    test_regular_map("catmull-clark", 4);
    test_regular_map("doo-sabin", 4);
    test_any_map("loop", 7);
    test_any_map("butterfly", 5);
    test_any_map("kobbelt", 5);
    test_any_map("doo-sabin", 5);
    test_any_map("loop-spiral", 5);
    test_leaves();
    return test_status();
}
