/* t-uniform_net.c: nets that are subdivided everywhere alike, their errors, and what the tests of one level make of maps
   whose winding and folds are known. */
#include "verify/uniform.h"

#include <math.h>
#include <stdlib.h>

#include "tests/lib/common.h"
#include "tests/lib/region.h"

#define PI 3.14159265358979323846

#if defined(NUMBER_INTERVAL)
enum { PRECISION = 53, DEEP = 6, CASES = 8 };
#else
enum { PRECISION = 64, DEEP = 4, CASES = 4 };
#endif

/* 1 - 6s, 1/2 - 2s, 2s, s with s = 3/32: between Loop's scheme (1/16) and the end of those without negative weights (1/8). */
#define BLUNT_TEXT SCHEME_TEXT("(0,0) 7/16\n(1,0) 5/16\n(1,1) 3/16\n(2,0) 3/32\n", "1/2")
/* Butterfly with w = 1/14 in place of 1/16: differences of derivatives may grow in a step. */
#define TENSE_TEXT SCHEME_TEXT("(0,0) 1\n(1,0) 1/2\n(1,1) 1/7\n(1,2) -1/14\n", "1")
enum { LOOP, BUTTERFLY, BLUNT, TENSE, MASKS };
static const char *const masks[MASKS] = {LOOP_TEXT, BUTTERFLY_TEXT, BLUNT_TEXT, TENSE_TEXT};

/* A regular scheme, and what the method knows of it. */
typedef struct {
    scheme scheme;
    problem problem;
    uniform_bounds bounds;
    mask_numbers mask[RING_NETS];
    twist twist;
} setting;

static setting settings[MASKS];

/* Nets that rotation by a sector turns by 2 pi/3. */
static void setting_make(setting *z, const char *text)
{
    read_scheme(&z->scheme, text);
    problem_init(&z->problem);
    uniform_bounds_init(&z->bounds);
    MUST(problem_make(&z->problem, &z->scheme));
    MUST(uniform_bounds_make(&z->bounds, &z->problem));
    CHECK(!z->bounds.obstacle, "%s", z->bounds.obstacle);
    for (int i = 0; i < RING_NETS; i++)
        MUST(mask_numbers_make(&z->mask[i], z->problem.geometry.mask[i], PRECISION));
    twist_init(&z->twist);
    MUST(twist_set_complex(&z->twist, 1, 3, PRECISION));
}

static void setting_clear(setting *z)
{
    twist_clear(&z->twist);
    for (int i = 0; i < RING_NETS; i++)
        mask_numbers_free(&z->mask[i]);
    uniform_bounds_clear(&z->bounds);
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
}

static void make_settings(void)
{
    for (int k = 0; k < MASKS; k++)
        setting_make(&settings[k], masks[k]);
}

static void clear_settings(void)
{
    for (int k = 0; k < MASKS; k++)
        setting_clear(&settings[k]);
}

static void make_net(sector_net *net, const setting *z)
{
    MUST(sector_net_make(net, MESH_TRIANGLE, false, z->problem.geometry.rings, &z->twist));
}

static void make_uniform(uniform_net *u, const setting *z, const sector_net *net, int which)
{
    uniform_net_init(u);
    CHECK(uniform_net_make(u, net, &z->problem.geometry, which, &z->mask[which], &z->bounds, PRECISION) == BLOCK_OK, "net %d is not made", which);
}

static void refine(uniform_net *u)
{
    CHECK(uniform_net_refine(u, NULL, PRECISION) == OUTCOME_TRUE, "net %d is not refined beyond level %d", u->which, u->level);
}

static void set_point(sector_net *net, int a, int b, double x, double y)
{
    number_set_double(&net->x[sector_index(net, a, b)], x, PRECISION);
    number_set_double(&net->y[sector_index(net, a, b)], y, PRECISION);
}

/* Noise, signs, a single point, or something smooth with a little noise: what differences and bounds depend on. */
static void fill_random(sector_net *net)
{
    long kind = random_range(0, 3), rings = net->rings;
    int only_a = (int)random_range(1, rings), only_b = (int)random_range(0, rings - only_a);
    double noise = ldexp(1, -(int)random_range(0, 10));
    for (int a = 1; a <= rings; a++)
        for (int b = 0; a + b <= rings; b++) {
            double x = random_unit(), y = random_unit();
            if (kind == 1)
                x = x < 0 ? -1 : 1, y = y < 0 ? -1 : 1;
            else if (kind == 2)
                x = y = a == only_a && b == only_b;
            else if (kind == 3)
                x = a + 0.25 * b + noise * x, y = b * 0.5 + noise * y;
            set_point(net, a, b, x, y);
        }
}

static double at(const uniform_net *u, int component, int a, int b)
{
    return number_mid_approx(&u->value[component][uniform_net_index(u, a, b)]);
}

/* ---- nets ---- */

/* 2^m times a difference of level-m values is the level-m difference: the scheme and its derivatives fit. */
static void test_differences(void)
{
    test_begin("uniform-net-differences");
    for (test_cases(20); test_next();) {
        const setting *s = &settings[random_below(MASKS)];
        sector_net net;
        uniform_net u[RING_NETS];
        make_net(&net, s);
        fill_random(&net);
        for (int i = 0; i < RING_NETS; i++)
            make_uniform(&u[i], s, &net, i);
        for (int m = 0; m <= 4 && !test_failed(); m++) {
            for (int i = RING_FIRST; i <= RING_SECOND; i++)
                for (int a = u[i].low[0]; a <= u[i].high[0]; a++)
                    for (int b = u[i].low[1]; b <= u[i].high[1]; b++) {
                        if (a + b < u[i].low[2] || a + b > u[i].high[2])
                            continue;
                        for (int c = 0; c < 2; c++) {
                            double d = ldexp(at(&u[0], c, a + (i == RING_FIRST), b + (i == RING_SECOND)) - at(&u[0], c, a, b), m);
                            CHECK(fabs(d - at(&u[i], c, a, b)) < 1e-9, "level %d, (%d,%d): %.17g, not %.17g", m, a, b, at(&u[i], c, a, b), d);
                        }
                    }
            for (int i = 0; m < 4 && i < RING_NETS; i++)
                refine(&u[i]);
        }
        for (int i = 0; i < RING_NETS; i++)
            uniform_net_clear(&u[i]);
        sector_net_free(&net);
    }
    test_end();
}

/* What lies inside wide intervals stays inside. */
static void test_enclosures(void)
{
    test_begin("uniform-net-enclosures");
    for (test_cases(10); test_next();) {
        const setting *s = &settings[random_below(MASKS)];
        sector_net wide, thin;
        uniform_net u, v;
        number radius;
        int which = (int)random_below(RING_NETS);
        number_init(&radius);
        number_set_double(&radius, ldexp(1, -20), PRECISION);
        make_net(&wide, s);
        make_net(&thin, s);
        fill_random(&thin);
        for (int i = 0; i < sector_size(thin.rings); i++) {
            number_add_error(&wide.x[i], &thin.x[i], &radius, PRECISION);
            number_add_error(&wide.y[i], &thin.y[i], &radius, PRECISION);
        }
        make_uniform(&u, s, &wide, which);
        make_uniform(&v, s, &thin, which);
        for (int m = 0; m < 3; m++) {
            for (int c = 0; c < 2; c++) {
                for (int i = 0; i < u.count; i++)
                    CHECK(number_contains(&u.value[c][i], &v.value[c][i]), "level %d: a value has left its interval", m);
                CHECK(number_upper_bound(&u.spread[c][m]) >= number_upper_bound(&v.spread[c][m]), "level %d: wide intervals have smaller differences", m);
            }
            CHECK(uniform_net_width(&u, PRECISION) >= ldexp(1, -20) && uniform_net_width(&u, PRECISION) < ldexp(1, -12), "width %g", uniform_net_width(&u, PRECISION));
            refine(&u);
            refine(&v);
        }
        uniform_net_clear(&u);
        uniform_net_clear(&v);
        sector_net_free(&wide);
        sector_net_free(&thin);
        number_clear(&radius);
    }
    test_end();
}

/* ---- errors ---- */

/* The net's own function of level m (kept in `coarse`), on the triangle, UP or DOWN, of level m + steps at (a,b); of values:
   at the corner (a,b) of an UP. */
static double own_function(const uniform_net *coarse, int component, int steps, int a, int b, bool down)
{
    int n = 1 << steps, p = a >> steps, q = b >> steps, u = a & (n - 1), v = b & (n - 1);
    bool in_up = u + v < n - down;
    double x, y, corner;
    if (coarse->which != RING_VALUES)
        return in_up ? at(coarse, component, p, q) : at(coarse, component, p + (coarse->which == RING_SECOND), q + (coarse->which == RING_FIRST));
    x = at(coarse, component, p + 1, q);
    y = at(coarse, component, p, q + 1);
    if (in_up) {
        corner = at(coarse, component, p, q);
        return corner + (u * (x - corner) + v * (y - corner)) / n;
    }
    corner = at(coarse, component, p + 1, q + 1);
    return corner + ((n - u) * (y - corner) + (n - v) * (x - corner)) / n;
}


/* The place (a,b) of the deep level, in all levels down to it. */
enum { PLACES = 400 };
typedef struct {
    int a, b;
    bool down;
    double value[DEEP + 1][2];
} place;

static void choose_places(place *z, int radius)
{
    int inner = radius << DEEP, outer = 2 * inner;
    for (int i = 0; i < PLACES; i++)
        do {
            z[i].a = (int)random_range(0, outer - 2);
            z[i].b = (int)random_range(0, outer - 2);
            z[i].down = random_bool();
        } while (z[i].a + z[i].b < inner || z[i].a + z[i].b > outer - 2);
}

/* |L^m - f| <= error_m at every level, f known to within error_DEEP.  The largest quotient that is seen is returned. */
static double check_errors(const setting *s, const sector_net *net, int which)
{
    static place places[PLACES];
    double error[DEEP + 1][2], worst = 0;
    uniform_net u;
    choose_places(places, s->problem.geometry.radius);
    make_uniform(&u, s, net, which);
    for (int m = 0; m <= DEEP && !test_failed(); m++) {
        for (int c = 0; c < 2; c++) {
            error[m][c] = number_upper_bound(&u.error[c]);
            for (int i = 0; i < PLACES; i++) {
                place *p = &places[i];
                p->value[m][c] = own_function(&u, c, DEEP - m, p->a, p->b, which != RING_VALUES && p->down);
            }
        }
        if (m < DEEP)
            refine(&u);
    }
    for (int m = 0; m < DEEP && !test_failed(); m++)
        for (int i = 0; i < PLACES; i++)
            for (int c = 0; c < 2; c++) {
                double d = fabs(places[i].value[m][c] - places[i].value[DEEP][c]);
                CHECK(d <= error[m][c] + error[DEEP][c] + 1e-9, "net %d, level %d: %g from level %d, but errors %g and %g", which, m, d, (int)DEEP, error[m][c],
                      error[DEEP][c]);
                if (error[m][c] > 1e-6)
                    worst = fmax(worst, d / error[m][c]);
            }
    uniform_net_clear(&u);
    return worst;
}

/* And not by miles: errors that were much smaller would be seen to be wrong. */
static void test_errors(void)
{
    static const double near[MASKS] = {[LOOP] = 0.05, [BUTTERFLY] = 0.01, [BLUNT] = 0.05, [TENSE] = 0.005};
    double worst[MASKS][RING_NETS] = {{0}};
    test_begin("uniform-net-errors");
    for (test_cases(CASES); test_next();)
        for (int k = 0; k < MASKS; k++)
            for (int i = 0; i < RING_NETS; i++) {
                sector_net net;
                make_net(&net, &settings[k]);
                fill_random(&net);
                worst[k][i] = fmax(worst[k][i], check_errors(&settings[k], &net, i));
                sector_net_free(&net);
            }
    for (int k = 0; k < MASKS; k++)
        for (int i = 0; i < RING_NETS; i++)
            CHECK(worst[k][i] > near[k], "mask %d, net %d: no net comes nearer to the error than %g of it", k, i, worst[k][i]);
    test_end();
}

/* As long as no number of steps contracts, there is no error: derivatives of both masks need 2, with norms 1 and
   above 1 for 1. */
static void test_first_levels(void)
{
    test_begin("uniform-net-first-levels");
    for (int k = BUTTERFLY; k <= TENSE; k += TENSE - BUTTERFLY) {
        const norm_list *norms = &settings[k].bounds.contraction[RING_FIRST];
        int steps = norm_list_first_contraction(norms);
        sector_net net;
        uniform_net u;
        make_net(&net, &settings[k]);
        set_point(&net, 2, 1, 1, 1);
        make_uniform(&u, &settings[k], &net, RING_FIRST);
        CHECK(steps == 2 && rational_cmp_si(&norms->norm[1], 1, 1) == (k == TENSE), "mask %d contracts in %d steps", k, steps);
        for (; u.level < steps - 1 && !test_failed(); refine(&u))
            CHECK(!number_is_finite(&u.error[0]) && !number_is_finite(&u.error[1]), "mask %d: an error at level %d", k, u.level);
        CHECK(number_is_finite(&u.error[0]) && number_is_finite(&u.error[1]), "mask %d: no error at level %d", k, u.level);
        uniform_net_clear(&u);
        sector_net_free(&net);
    }
    test_end();
}

/* ---- the tests of one level ---- */

/* A map of the plane that turns by 2 pi/3 with a sector, z^2 + c conj(z)^4 or d z^8; turned itself. */
static void fill_map(sector_net *net, double square, double conjugate, double eighth, double turn)
{
    for (int a = 1; a <= net->rings; a++)
        for (int b = 0; a + b <= net->rings; b++) {
            double r = hypot(a + 0.5 * b, sqrt(0.75) * b), w = atan2(sqrt(0.75) * b, a + 0.5 * b);
            double p = square * r * r, q = conjugate * r * r * r * r, e = eighth * pow(r, 8);
            double x = p * cos(2 * w) + q * cos(4 * w) + e * cos(8 * w), y = p * sin(2 * w) - q * sin(4 * w) + e * sin(8 * w);
            set_point(net, a, b, x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn));
        }
}

typedef struct {
    sector_net net;
    uniform_net uniform[RING_NETS];
    analysis_plan plan;
    findings findings;
    analysis analysis;
} bench;

static void bench_make(bench *z, const setting *s, double square, double conjugate, double eighth, double turn)
{
    memset(z, 0, sizeof *z);
    make_net(&z->net, s);
    fill_map(&z->net, square, conjugate, eighth, turn);
    for (int i = 0; i < RING_NETS; i++)
        make_uniform(&z->uniform[i], s, &z->net, i);
    findings_init(&z->findings);
    findings_begin(&z->findings, "a level", "test", PRECISION);
    z->plan.problem = &s->problem;
    z->plan.uniform = &s->bounds;
    z->analysis.plan = &z->plan;
    z->analysis.findings = &z->findings;
    z->analysis.prec = PRECISION;
    z->analysis.uniform = z->uniform;
}

static void bench_clear(bench *z)
{
    for (int i = 0; i < RING_NETS; i++)
        uniform_net_clear(&z->uniform[i]);
    findings_clear(&z->findings);
    sector_net_free(&z->net);
}

/* The test's answer at the first level where it has one; until then it must be undefined. */
static outcome answer(bench *z, outcome (*test)(analysis *), int levels)
{
    outcome o = OUTCOME_UNDEFINED;
    for (int m = 0; o == OUTCOME_UNDEFINED; m++) {
        o = test(&z->analysis);
        if (m == levels)
            break;
        for (int i = 0; o == OUTCOME_UNDEFINED && i < RING_NETS; i++)
            refine(&z->uniform[i]);
    }
    return o;
}

static void check_answer(int mask, const char *map, double square, double conjugate, double eighth, const char *words, outcome (*test)(analysis *), outcome expected)
{
    bench z;
    outcome o;
    bench_make(&z, &settings[mask], square, conjugate, eighth, 0);
    o = answer(&z, test, mask == LOOP ? 8 : 6);
    CHECK(o == expected, "%s of %s is %s, not %s: %s", words, map, outcome_name(o), outcome_name(expected), findings_last(&z.findings)->reason);
    bench_clear(&z);
}

static void test_windings(void)
{
    test_begin("uniform-windings");
    check_answer(BUTTERFLY, "z^2", 1, 0, 0, "injectivity", test_uniform_injectivity, OUTCOME_TRUE);
    check_answer(BUTTERFLY, "z^2 + conj(z)^4 / 200", 1, 0.005, 0, "injectivity", test_uniform_injectivity, OUTCOME_TRUE);
    check_answer(BUTTERFLY, "conj(z)^4", 0, 1, 0, "injectivity", test_uniform_injectivity, OUTCOME_FALSE);
    check_answer(BUTTERFLY, "conj(z)^4 + z^2", 1, 1, 0, "injectivity", test_uniform_injectivity, OUTCOME_FALSE);
    check_answer(BUTTERFLY, "z^8", 0, 0, 1, "injectivity", test_uniform_injectivity, OUTCOME_FALSE);
    check_answer(LOOP, "0", 0, 0, 0, "injectivity", test_uniform_injectivity, OUTCOME_UNDEFINED);
    test_end();
}

/* The place of a direction on the unit square, counter-clockwise from (1,0). */
static double place_of(double angle)
{
    double turns = floor(angle / (2 * PI)), w = angle - 2 * PI * turns, x = cos(w), y = sin(w);
    double along = fabs(y) >= fabs(x) ? (y > 0 ? 2 - x / y : 6 - x / y) : x > 0 ? (y < 0 ? 8 + y / x : y / x) : 4 + y / x;
    return 8 * turns + along;
}

/* One sector of z^2, turned so that it begins anywhere: all pairs of sides occur, and the length must be right. */
static void test_lengths(void)
{
    test_begin("uniform-lengths");
    for (test_cases(200); test_next();) {
        double turn = PI * random_unit(), right = place_of(turn + 2 * PI / 3) - place_of(turn), length;
        long levels = random_range(1, 3);
        bench z;
        outcome o;
        bench_make(&z, &settings[LOOP], 1, 0, 0, turn);
        for (long m = 0; m < levels; m++)
            refine(&z.uniform[RING_VALUES]);
        for (int c = 0; c < 2; c++) /* the length is that of the polygon, whatever the error */
            number_zero(&z.uniform[RING_VALUES].error[c]);
        o = test_uniform_injectivity(&z.analysis);
        length = findings_last(&z.findings)->bound;
        CHECK(o == OUTCOME_UNDEFINED || fabs(length - right) < 1e-6, "turned by %g, level %ld: length %.9g, not %.9g", turn, levels, length, right);
        CHECK(o == OUTCOME_TRUE || (o == OUTCOME_UNDEFINED && levels == 1), "turned by %g, level %ld: %s", turn, levels, findings_last(&z.findings)->reason);
        bench_clear(&z);
    }
    test_end();
}

/* z^2 + c conj(z)^4 has the Jacobian 4 |z|^2 - 16 c^2 |z|^6, positive where 2 c |z|^2 < 1, and zeros where c |z|^2 = 1; the ring is
   1 <= |z| <= 2 for Loop's scheme and 2 <= |z| <= 4 for Butterfly, roughly.  (Subdivision hardly changes harmonic functions.) */
static void test_signs(void)
{
    test_begin("uniform-signs");
    check_answer(BUTTERFLY, "z^2", 1, 0, 0, "regularity", test_uniform_regularity, OUTCOME_TRUE);
    check_answer(BUTTERFLY, "z^2 + conj(z)^4 / 200", 1, 0.005, 0, "regularity", test_uniform_regularity, OUTCOME_TRUE);
    check_answer(LOOP, "z^2 + conj(z)^4 / 4", 1, 0.25, 0, "regularity", test_uniform_regularity, OUTCOME_FALSE);
    check_answer(LOOP, "conj(z)^4", 0, 1, 0, "regularity", test_uniform_regularity, OUTCOME_FALSE);
    check_answer(LOOP, "0", 0, 0, 0, "regularity", test_uniform_regularity, OUTCOME_UNDEFINED);
    test_end();
}

/* The label of the triangle's edge in direction d: the corner p such that p + d is a corner, too. */
static lattice find_edge(const element *e, lattice d)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            lattice p = element_get_vertex(e->type, i), q = element_get_vertex(e->type, j);
            if (q.a - p.a == d.a && q.b - p.b == d.b)
                return (lattice){e->a + p.a, e->b + p.b};
        }
    CHECK(false, "a triangle without an edge in direction (%d,%d)", d.a, d.b);
    return (lattice){0, 0};
}

/* Each triangle counts, with its own edges: the least Jacobian of random derivatives, without errors. */
static void test_triangles(void)
{
    static const lattice e1 = {1, 0}, e2 = {0, 1};
    test_begin("uniform-triangles");
    for (test_cases(300); test_next();) {
        const setting *s = &settings[random_bool() ? LOOP : BUTTERFLY];
        double least = INFINITY;
        bench z;
        bench_make(&z, s, 1, 0, 0, 0);
        for (int i = RING_FIRST; i <= RING_SECOND; i++)
            for (int c = 0; c < 2; c++) {
                number_zero(&z.uniform[i].error[c]);
                for (int j = 0; j < z.uniform[i].count; j++)
                    number_set_double(&z.uniform[i].value[c][j], (c == i - RING_FIRST ? 2 : 0) + random_unit(), PRECISION);
            }
        for (int i = 0; i < s->problem.geometry.element_count; i++) {
            const element *e = &s->problem.geometry.elements[i];
            lattice p = find_edge(e, e1), q = find_edge(e, e2);
            least = fmin(least, at(&z.uniform[RING_FIRST], 0, p.a, p.b) * at(&z.uniform[RING_SECOND], 1, q.a, q.b)
                                    - at(&z.uniform[RING_FIRST], 1, p.a, p.b) * at(&z.uniform[RING_SECOND], 0, q.a, q.b));
        }
        test_uniform_regularity(&z.analysis);
        CHECK(fabs(findings_last(&z.findings)->bound - least) < 1e-9, "the least Jacobian is %.9g, not %.9g", findings_last(&z.findings)->bound, least);
        bench_clear(&z);
    }
    test_end();
}

static void test_isolation(void)
{
    test_begin("uniform-isolation");
    check_answer(BUTTERFLY, "z^2", 1, 0, 0, "isolation", test_uniform_isolation, OUTCOME_TRUE);
    check_answer(LOOP, "conj(z)^4", 0, 1, 0, "isolation", test_uniform_isolation, OUTCOME_TRUE);
    check_answer(LOOP, "z^2 + conj(z)^4 / 2", 1, 0.5, 0, "isolation", test_uniform_isolation, OUTCOME_UNDEFINED);
    check_answer(LOOP, "0", 0, 0, 0, "isolation", test_uniform_isolation, OUTCOME_UNDEFINED);
    test_end();
}

/* Values that are hardly known: nothing is decided, and injectivity asks for precision. */
static void test_wide(void)
{
    bench z;
    number radius;
    test_begin("uniform-wide");
    number_init(&radius);
    number_set_double(&radius, 0.25, PRECISION);
    bench_make(&z, &settings[BUTTERFLY], 1, 0, 0, 0);
    for (int m = 0; m < 4; m++)
        for (int i = 0; i < RING_NETS; i++)
            refine(&z.uniform[i]);
    CHECK(test_uniform_injectivity(&z.analysis) == OUTCOME_TRUE, "injectivity: %s", findings_last(&z.findings)->reason);
    for (int i = 0; i < RING_NETS; i++) /* the nets as if they were known to 1/4 only */
        for (int c = 0; c < 2; c++)
            for (int j = 0; j < z.uniform[i].count; j++)
                number_add_error(&z.uniform[i].value[c][j], &z.uniform[i].value[c][j], &radius, PRECISION);
    CHECK(test_uniform_injectivity(&z.analysis) == OUTCOME_FAIL, "injectivity of wide intervals: %s", findings_last(&z.findings)->reason);
    for (int i = 0; i < RING_NETS; i++)
        for (int c = 0; c < 2; c++)
            for (int j = 0; j < z.uniform[i].count; j++)
                number_indeterminate(&z.uniform[i].value[c][j]);
    CHECK(test_uniform_injectivity(&z.analysis) == OUTCOME_UNDEFINED && test_uniform_isolation(&z.analysis) == OUTCOME_UNDEFINED
              && test_uniform_regularity(&z.analysis) == OUTCOME_UNDEFINED, "something is known of unknown values");
    bench_clear(&z);
    number_clear(&radius);
    test_end();
}

static void tests(void)
{
    make_settings();
    test_differences();
    test_enclosures();
    test_errors();
    test_first_levels();
    test_windings();
    test_lengths();
    test_signs();
    test_triangles();
    test_isolation();
    test_wide();
    clear_settings();
}

MAIN(tests);
