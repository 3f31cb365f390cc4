/* t-adaptive.c: what boxes and coefficients say of one element is true of the limit, which comes from subdivision in
   doubles; and coefficients say all that they can. */
#include "verify/adaptive.h"

#include <math.h>

#include "common.h"
#include "tests/lib/region.h"

#if defined(NUMBER_INTERVAL)
enum { PRECISION = 53 };
#else
enum { PRECISION = 64 };
#endif

enum { MOST_POINTS = 80, MOST_COEFFICIENTS = 400, DEPTH = 12 };
static const double tolerance = 1e-9;

static const struct {
    const char *name, *parameter;
    bool polynomial;
} schemes[] = {{"loop", NULL, true}, {"catmull-clark", NULL, true}, {"doo-sabin", NULL, true}, {"midpoint", "degree=4", true},
               {"midpoint", "degree=5", true}, {"butterfly", NULL, false}, {"kobbelt", NULL, false}};
enum { SCHEMES = sizeof schemes / sizeof *schemes };

static subject subjects[SCHEMES];

static void make_subjects(void)
{
    for (int i = 0; i < SCHEMES; i++) {
        subject_from_catalogue(&subjects[i], schemes[i].name, schemes[i].parameter);
        MUST(subjects[i].problem.polynomial == schemes[i].polynomial);
    }
}

/* One element by itself: values of its windows and how far they may be wrong; `value` are the true ones. */
typedef struct {
    const problem *problem;
    mask_numbers mask[ADAPTIVE_MAX_NETS];
    patch_numbers patch[ADAPTIVE_MAX_NETS];
    charnet_windows windows[ADAPTIVE_MAX_NETS];
    element element;
    adaptive_task task;
    double value[ADAPTIVE_MAX_NETS][2][MOST_POINTS];
    long normal[2];
} setting;

static void jacobian(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    (void)data;
    number_addmul(z, x[0], y[1], prec);
    number_submul(z, y[0], x[1], prec);
}

static void height(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    const long *normal = data;
    number part;
    number_init(&part);
    for (int i = 0; i < 2; i++) {
        number_mul_si(&part, i ? y[0] : x[0], normal[i], prec);
        number_add(z, z, &part, prec);
    }
    number_clear(&part);
}

static double quantity(const setting *s, const double p[2], const double q[2])
{
    return s->task.nets == 2 ? p[0] * q[1] - p[1] * q[0] : (double)s->normal[0] * p[0] + (double)s->normal[1] * p[1];
}

/* The values of the net in the window: near one vector, with random differences of at most `spread`. */
static void make_window(setting *s, int net, double spread)
{
    charnet_windows *w = &s->windows[net];
    const element_stencil *stencil = &s->problem->geometry.stencil[s->task.which[net]];
    long error = random_bool() ? 0 : random_range(1, 1 << 16); /* 2^-20, of the radius */
    memset(w, 0, sizeof *w);
    w->count = 1;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        w->window[t] = stencil->window[t].count;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        w->stride = w->window[t] > w->stride ? w->window[t] : w->stride;
    MUST(w->stride <= MOST_POINTS);
    w->x = number_array_new((size_t)w->stride);
    w->y = number_array_new((size_t)w->stride);
    MUST(w->x && w->y);
    for (int c = 0; c < 2; c++) {
        number_init(&w->radius[c]);
        number_set_double(&w->radius[c], (double)error * 0x1p-20, PRECISION);
        for (int i = 0; i < w->window[s->element.type]; i++) {
            double thin = (net == c) + ldexp((double)(long)(spread * (double)random_range(-(1 << 20), 1 << 20)), -20);
            number_set_double(c ? &w->y[i] : &w->x[i], thin, PRECISION);
            s->value[net][c][i] = thin + (double)random_range(-error, error) * 0x1p-20;
        }
    }
}

static void make_setting(setting *z, int which, bool segment, double spread)
{
    const problem *p = &subjects[which].problem;
    const ring *g = &p->geometry;
    memset(z, 0, sizeof *z);
    z->problem = p;
    z->element = segment ? g->boundary[random_below((uint64_t)g->boundary_count)] : g->elements[random_below((uint64_t)g->element_count)];
    z->normal[0] = random_range(1, 5);
    z->normal[1] = random_range(-5, 5);
    z->task = (adaptive_task){.geometry = g, .elements = &z->element, .count = 1, .nets = segment ? 1 : 2, .which = {segment ? RING_VALUES : RING_FIRST, RING_SECOND},
                              .quantity = segment ? height : jacobian, .data = z->normal, .replay = true};
    for (int i = 0; i < z->task.nets; i++) {
        int net = z->task.which[i];
        make_window(z, i, spread);
        MUST(mask_numbers_make(&z->mask[i], g->mask[net], PRECISION));
        if (p->polynomial) {
            MUST(patch_numbers_make(&z->patch[i], &p->bernstein[net], segment, PRECISION));
            z->task.patch[i] = &z->patch[i];
        }
        z->task.windows[i] = &z->windows[i];
        z->task.mask[i] = &z->mask[i];
        z->task.stability[i] = p->stability[net].bound;
    }
}

static void free_setting(setting *z)
{
    for (int i = 0; i < z->task.nets; i++) {
        charnet_windows_free(&z->windows[i]);
        mask_numbers_free(&z->mask[i]);
        if (z->problem->polynomial)
            patch_numbers_free(&z->patch[i]);
    }
}

static outcome follow(adaptive_report *report, setting *s, const char *letters)
{
    tree_word word;
    outcome o;
    tree_init(&word);
    for (const char *l = letters; *l; l++)
        MUST(tree_put(&word, *l));
    s->task.replay = true;
    o = adaptive_run(report, &word, &s->task, PRECISION);
    tree_clear(&word);
    return o;
}

/* The quantity of the true limit at a random place of the element, deep down in doubles.  Values in the last window differ by about 2^-DEPTH,
   and their mean by that from the limit. */
static double quantity_somewhere(const setting *s)
{
    int child[DEPTH];
    double mean[ADAPTIVE_MAX_NETS][2] = {{0}};
    for (int i = 0; i < DEPTH; i++)
        child[i] = (int)random_below(2 + 2 * (s->task.nets > 1));
    for (int net = 0; net < s->task.nets; net++)
        for (int c = 0; c < 2; c++) {
            const element_stencil *stencil = &s->problem->geometry.stencil[s->task.which[net]];
            double old[MOST_POINTS], new[MOST_POINTS];
            element_type type = s->element.type;
            memcpy(old, s->value[net][c], sizeof old);
            for (int i = 0; i < DEPTH; i++) {
                const element_refinement *r = &stencil->child[type][child[i]];
                for (int p = 0; p < r->count; p++) {
                    new[p] = 0;
                    for (int e = r->row[p]; e < r->row[p + 1]; e++)
                        new[p] += number_mid_approx(mask_numbers_at(&s->mask[net], r->term[e].a, r->term[e].b)) * old[r->source[e]];
                }
                memcpy(old, new, sizeof old);
                type = element_get_child(type, child[i]).type;
            }
            for (int p = 0; p < stencil->window[type].count; p++)
                mean[net][c] += old[p] / stencil->window[type].count;
        }
    return quantity(s, mean[0], mean[1]);
}

/* c = the Bernstein coefficients of the net's component. */
static void true_coefficients(double *c, const setting *s, int net, int component)
{
    const bernstein *b = &s->problem->bernstein[s->task.which[net]];
    rational entry;
    rational_init(&entry);
    for (int row = 0; row < b->rows[s->element.type]; row++) {
        c[row] = 0;
        for (int y = 0; y < b->columns[s->element.type]; y++) {
            MUST(bernstein_get(&entry, b, s->element.type, row, y));
            c[row] += rational_get_double_approx(&entry) * s->value[net][component][y];
        }
    }
    rational_clear(&entry);
}

/* The least Bernstein coefficient of the true quantity, and the least at a corner. */
static double least_coefficient(double *at_corner, const setting *s)
{
    static double c[ADAPTIVE_MAX_NETS][2][MOST_COEFFICIENTS], product[4 * MOST_COEFFICIENTS];
    bernstein_shape shape[2] = {{false, {0, 0}}, {false, {0, 0}}}, sum;
    double least = INFINITY;
    memset(product, 0, sizeof product);
    for (int net = 0; net < s->task.nets; net++) {
        shape[net] = bernstein_get_shape(&s->problem->bernstein[s->task.which[net]], s->element.type);
        for (int component = 0; component < 2; component++)
            true_coefficients(c[net][component], s, net, component);
    }
    if (s->task.nets == 1)
        shape[1].triangle = shape[0].triangle;
    sum = bernstein_shape_product(shape[0], shape[1]);
    for (int j = 0; j <= shape[0].degree[1]; j++)
        for (int i = 0; i <= bernstein_shape_last(shape[0], j); i++)
            for (int l = 0; l <= shape[1].degree[1]; l++)
                for (int k = 0; k <= bernstein_shape_last(shape[1], l); k++) {
                    int p = bernstein_shape_index(shape[0], i, j), q = bernstein_shape_index(shape[1], k, l);
                    double x[2] = {c[0][0][p], c[0][1][p]}, y[2] = {c[1][0][q], c[1][1][q]};
                    double ways = (double)bernstein_shape_multiplicity(shape[0], i, j) * (double)bernstein_shape_multiplicity(shape[1], k, l);
                    product[bernstein_shape_index(sum, i + k, j + l)] += ways / (double)bernstein_shape_multiplicity(sum, i + k, j + l) * quantity(s, x, y);
                }
    *at_corner = INFINITY;
    for (int j = 0; j <= sum.degree[1]; j++)
        for (int i = 0; i <= bernstein_shape_last(sum, j); i++) {
            double v = product[bernstein_shape_index(sum, i, j)];
            least = fmin(least, v);
            if ((i == 0 || i == bernstein_shape_last(sum, j)) && (j == 0 || j == sum.degree[1]))
                *at_corner = fmin(*at_corner, v);
        }
    return least;
}

static double largest_radius(const setting *s)
{
    double r = 0;
    for (int i = 0; i < s->task.nets; i++)
        r = fmax(r, fmax(number_upper_bound(&s->windows[i].radius[0]), number_upper_bound(&s->windows[i].radius[1])));
    return r;
}

static void check_claim(const setting *s, outcome o, const adaptive_report *report, const char *how)
{
    double slack = s->problem->polynomial ? 0.05 : 0.2; /* of quantity_somewhere */
    for (int i = 0; o == OUTCOME_TRUE && i < 8; i++) {
        double v = quantity_somewhere(s);
        CHECK(report->margin > 0 && v > report->margin - slack, "%s: %g somewhere, said to be at least %g", how, v, report->margin);
    }
}

/* Leaves of both kinds, at the level 0 and below. */
static void test_leaves(void)
{
    test_begin("adaptive-leaves");
    for (test_cases(300); test_next();) {
        setting s;
        adaptive_report report;
        bool segment = random_bool();
        double spread = (double)random_range(1, 30) / 20, corner, least;
        outcome o;
        make_setting(&s, (int)random_below(SCHEMES), segment, spread);
        check_claim(&s, follow(&report, &s, "0"), &report, "boxes");
        check_claim(&s, follow(&report, &s, segment ? "100" : "10000"), &report, "boxes of children");
        o = follow(&report, &s, "2");
        if (!s.problem->polynomial) {
            CHECK(o == OUTCOME_FALSE, "coefficients of what is no box spline");
        } else {
            least = least_coefficient(&corner, &s);
            check_claim(&s, o, &report, "coefficients");
            CHECK(o == OUTCOME_TRUE || o == OUTCOME_FALSE, "a leaf is neither proved nor refused");
            CHECK(o != OUTCOME_TRUE || report.margin <= least + tolerance, "at least %g, but a coefficient is %g", report.margin, least);
            if (largest_radius(&s) == 0) {
                CHECK((o == OUTCOME_TRUE) == (least > 0) || fabs(least) < tolerance, "%s, and the least coefficient is %g", o == OUTCOME_TRUE ? "proved" : "refused", least);
                CHECK(o != OUTCOME_TRUE || report.margin >= least - tolerance, "at least %g, but it is %g", report.margin, least);
            }
            o = follow(&report, &s, segment ? "122" : "12222");
            check_claim(&s, o, &report, "coefficients of children");
            CHECK(o == OUTCOME_TRUE || !(least - 20 * largest_radius(&s) > tolerance), "children are refused though the coefficients of the parent are at least %g", least);
        }
        free_setting(&s);
    }
    test_end();
}

/* A search ends where its word ends; what it refuses is not so at a corner; coefficients spare subdivisions. */
static void test_search(void)
{
    test_begin("adaptive-search");
    for (test_cases(300); test_next();) {
        setting s;
        adaptive_report report, again;
        tree_word word;
        outcome o;
        double corner, least;
        make_setting(&s, (int)random_below(SCHEMES), random_bool(), (double)random_range(1, 60) / 20);
        tree_init(&word);
        s.task.replay = false;
        s.task.max_level = 3;
        o = adaptive_run(&report, &word, &s.task, PRECISION);
        check_claim(&s, o, &report, "search");
        if (o == OUTCOME_TRUE) {
            CHECK(follow(&again, &s, word.letter) == OUTCOME_TRUE, "the word %s is not followed", word.letter);
            CHECK(again.examined == report.examined && again.level == report.level && again.margin == report.margin, "the word %s is followed another way", word.letter);
        }
        if (s.problem->polynomial) {
            least = least_coefficient(&corner, &s);
            if (least > 20 * largest_radius(&s) + tolerance)
                CHECK(o == OUTCOME_TRUE && report.level == 0 && word.length == 1, "coefficients of at least %g, and level %d", least, report.level);
            CHECK(o != OUTCOME_TRUE || corner > 0, "proved, but %g at a corner", corner);
        } else {
            CHECK(!word.letter || !strchr(word.letter, '2'), "coefficients of what is no box spline");
        }
        s.task.replay = false;
        s.task.max_level = 0;
        if (adaptive_run(&report, &word, &s.task, PRECISION) == OUTCOME_FALSE && s.problem->polynomial)
            CHECK(least_coefficient(&corner, &s) < 0 && corner < 0, "refused, but all corners are at least %g", corner);
        tree_clear(&word);
        free_setting(&s);
    }
    test_end();
}

/* Words that end too early, go on or are no words. */
static void test_words(void)
{
    static const char *const wrong[] = {"", "1", "3", "00", "22", "20", "02", "1000", "1222", "100000", "122222", "10003", "x"};
    test_begin("adaptive-words");
    for (int which = 0; which < SCHEMES; which++) {
        setting s;
        adaptive_report report;
        make_setting(&s, which, false, 0.01);
        CHECK(follow(&report, &s, "0") == OUTCOME_TRUE && follow(&report, &s, "10000") == OUTCOME_TRUE, "boxes do not suffice");
        CHECK((follow(&report, &s, "2") == OUTCOME_TRUE) == schemes[which].polynomial, "coefficients of %s", schemes[which].name);
        CHECK((follow(&report, &s, "10202") == OUTCOME_TRUE) == schemes[which].polynomial, "coefficients of %s", schemes[which].name);
        for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
            CHECK(follow(&report, &s, wrong[i]) == OUTCOME_FALSE, "the word '%s' is followed", wrong[i]);
        free_setting(&s);
    }
    test_end();
}

static void run_all(void)
{
    make_subjects();
    test_leaves();
    test_search();
    test_words();
    for (int i = 0; i < SCHEMES; i++)
        subject_clear(&subjects[i]);
}

MAIN(run_all);
