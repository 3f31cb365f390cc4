/* t-graded.c: block 0 scaled by powers of q/k, and the net of its eigenvector, contain what single valences have.  The whole
   test computes with affine numbers; at a single valence their slopes are 0. */
#define NUMBER_AFFINE

#include "lib/charnet.h"
#include "lib/eigenpair_affine.h"
#include "lib/graded.h"
#include "lib/graded_scheme.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 128, GRID = 64 };

#define base(operation) NUMBER_OP(operation)

typedef struct {
    scheme scheme;
    regular_masks regular;
    ring ring;
} subject;

/* One range, or one valence, where nothing is scaled. */
typedef struct {
    scheme_numbers numbers;
    block plain;
    graded_block graded;
    graded_choice choice;
    number *matrix, *box;
    eigenpair_choice pair;
    sector_net net;
} setting;

typedef struct {
    double low, high;
} span;

/* At t. */
static span value_at(const number *x, double t)
{
    double p = base(lower_bound)(&x->slope) * t, q = base(upper_bound)(&x->slope) * t, slack = 1e-13;
    return (span){base(lower_bound)(&x->centre) + fmin(p, q) - slack, base(upper_bound)(&x->centre) + fmax(p, q) + slack};
}

/* A scheme file around what its centre is made of. */
typedef struct {
    const char *before, *after;
} family;

#define RULE "rule centre\ncentre "
#define NEIGHBOURS "\nall (2,0) 1/16\nall (1,0) rest\nend\n"

/* On triangles each new value asks for values with the same grade; on quads some do not. */
static const family triangle = {"triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\nend\n" RULE, NEIGHBOURS};
static const family quad = {"quad\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 9/16\n(1,0) 3/8\n(1,1) 1/4\n(2,0) 3/32\n(2,1) 1/16\n(2,2) 1/64\nend\n" RULE, NEIGHBOURS};
/* The centre of the nets between the steps grows, too. */
static const family last = {"quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2 centre ", "\nend\n"};
static const family earlier = {"quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2 centre ", "\nsmooth 1/3, 1/3\nend\n"};
static const family both = {"quad\ndilation 2\nvertices interior\ncompose\nrefine\nrepeat 2: smooth 1/4, 1/2 centre ", "\nend\n"};

static void make_subject(subject *z, family f, const char *centre)
{
    char text[1000];
    snprintf(text, sizeof text, "scheme s\nmesh %s%s%s", f.before, centre, f.after);
    read_scheme(&z->scheme, text);
    regular_init(&z->regular);
    ring_init(&z->ring);
    MUST(regular_derive(&z->regular, &z->scheme.mask, z->scheme.mesh) && ring_make(&z->ring, &z->scheme, &z->regular));
}

static void find_pair(setting *z, const number *matrix)
{
    int n = z->plain.n;
    z->box = number_array_new((size_t)n + 1);
    eigenpair_choice_init(&z->pair);
    CHECK(BASE_NAME(eigenpair_affine_choose)(&z->pair, matrix, n, GRID, PRECISION) == TRUTH_TRUE
              && BASE_NAME(eigenpair_affine_prove)(z->box, &z->pair, matrix, n, PRECISION) == TRUTH_TRUE, "no pair");
}

static void make_many(setting *z, const subject *s, valence_range k)
{
    diagnostic d = {0, 0, ""};
    bool is, varies;
    memset(z, 0, sizeof *z);
    graded_choice_init(&z->choice);
    CHECK(scheme_centre_is_graded(&is, &varies, &s->scheme, k, &d) == STATUS_OK && is && varies, "not graded");
    CHECK(scheme_numbers_make_range(&z->numbers, &s->scheme, k, PRECISION, &d) == STATUS_OK && graded_block_make(&z->graded, &z->plain, &z->numbers, &d) == BLOCK_OK, "%s", d.text);
    CHECK(graded_choose(&z->choice, &z->graded) == BLOCK_OK && graded_block_scale(&z->graded, z->choice.unit) == BLOCK_OK, "no block");
    CHECK(graded_matrix(&z->matrix, &z->graded, &z->choice) == TRUTH_TRUE, "no matrix");
    find_pair(z, z->matrix);
    CHECK(graded_sector_net(&z->net, &z->graded, &z->choice, z->box, &s->ring) == BLOCK_OK, "no net");
}

static void make_one(setting *z, const subject *s, long k)
{
    diagnostic d = {0, 0, ""};
    memset(z, 0, sizeof *z);
    CHECK(scheme_numbers_make(&z->numbers, &s->scheme, k, PRECISION, &d) == STATUS_OK && block_make(&z->plain, &z->numbers, 0, true, &d) == BLOCK_OK, "%s", d.text);
    find_pair(z, z->plain.entry);
    CHECK(charnet_make(&z->net, &z->plain, z->box, false, &z->numbers, s->ring.rings) == BLOCK_OK, "no net");
}

static void free_setting(setting *z)
{
    size_t n = (size_t)z->plain.n;
    sector_net_free(&z->net);
    number_array_free(z->box, n + 1);
    if (z->matrix)
        number_array_free(z->matrix, n * n);
    eigenpair_choice_clear(&z->pair);
    if (z->graded.plain)
        graded_block_free(&z->graded);
    graded_choice_clear(&z->choice);
    block_free(&z->plain);
    scheme_numbers_free(&z->numbers);
}

/* M_ij = kappa^(d + e_j - e_i) B_ij, and L = kappa^d l. */
static void compare_matrices(const setting *many, const setting *one, double kappa, double t)
{
    const graded_choice *c = &many->choice;
    int n = many->plain.n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            span x = value_at(&many->matrix[i * n + j], t);
            double y = number_mid_approx(&one->plain.entry[i * n + j]) * pow(kappa, c->degree + c->grade[j] - c->grade[i]);
            CHECK(x.low <= y && y <= x.high, "entry %d, %d: %g is not in %g .. %g", i, j, y, x.low, x.high);
        }
    span l = value_at(&many->box[n], t);
    double y = number_mid_approx(&one->box[n]) * pow(kappa, c->degree);
    CHECK(l.low <= y && y <= l.high, "eigenvalue: %g is not in %g .. %g", y, l.low, l.high);
}

static bool overlap(span x, double p, span y, double q)
{
    double a = fmin(x.low * p, x.high * p), b = fmax(x.low * p, x.high * p), c = fmin(y.low * q, y.high * q), d = fmax(y.low * q, y.high * q);
    return a <= d && c <= b;
}

/* Where the boundary needs them the values are those of the one net, times one number. */
static void compare_nets(const setting *many, const setting *one, const ring *r, double t)
{
    number x, y, unused;
    span first = {0, 0};
    double first_of_one = 0;
    number_init(&x);
    number_init(&y);
    number_init(&unused);
    for (int i = 0; i < r->boundary_count; i++)
        for (int j = 0; j < r->stencil[RING_VALUES].window[r->boundary[i].type].count; j++) {
            lattice p = r->stencil[RING_VALUES].window[r->boundary[i].type].point[j];
            int a = r->boundary[i].a + p.a, b = r->boundary[i].b + p.b;
            CHECK(sector_value(&x, &unused, &many->net, a, b, PRECISION) == SECTOR_OK && sector_value(&y, &unused, &one->net, a, b, PRECISION) == SECTOR_OK, "no value");
            if (i == 0 && j == 0) {
                first = value_at(&x, t);
                first_of_one = number_mid_approx(&y);
            }
            CHECK(overlap(value_at(&x, t), first_of_one, first, number_mid_approx(&y)), "the values at %d, %d are not in proportion", a, b);
        }
    number_clear(&x);
    number_clear(&y);
    number_clear(&unused);
}

static void try_range(family f, const char *centre, valence_range k, int degree)
{
    subject s;
    setting many;
    make_subject(&s, f, centre);
    make_many(&many, &s, k);
    CHECK(many.choice.degree == degree, "%s: degree %d", centre, many.choice.degree);
    for (long v = k.first; v <= k.last && v <= 2 * k.first && !test_failed(); v += 1 + k.first / 8) {
        double kappa = (double)many.choice.unit / (double)v, t = (kappa - base(mid_approx)(&many.graded.kappa.centre)) / base(mid_approx)(&many.graded.kappa.slope);
        setting one;
        CHECK(fabs(t) < 1 + 1e-9, "valence %ld is not in the range", v);
        make_one(&one, &s, v);
        compare_matrices(&many, &one, kappa, t);
        compare_nets(&many, &one, &s.ring, t);
        free_setting(&one);
    }
    free_setting(&many);
    ring_clear(&s.ring);
    regular_clear(&s.regular);
    scheme_clear(&s.scheme);
}

static void test_graded(void)
{
    test_begin("growth-of-many-valences");
    try_range(triangle, "1 - k/16", (valence_range){200, VALENCES_UNBOUNDED}, 1);
    try_range(triangle, "1 - k/16", (valence_range){40, 42}, 1);
    try_range(triangle, "k/5 + 1/2 + 3/k", (valence_range){300, VALENCES_UNBOUNDED}, 1);
    try_range(triangle, "1 - k^2/100 + k/7", (valence_range){400, 440}, 2);
    try_range(quad, "1 - k/8", (valence_range){100, VALENCES_UNBOUNDED}, 1);
    try_range(quad, "1 - k/8", (valence_range){30, 32}, 1);
    try_range(last, "1 - k/8, 2/k", (valence_range){100, VALENCES_UNBOUNDED}, 1);
    try_range(last, "1 - k/8, k", (valence_range){30, 32}, 1);
    try_range(earlier, "1 - k/8, 2/k", (valence_range){10000, VALENCES_UNBOUNDED}, 1);
    try_range(earlier, "k^2/30, k/5", (valence_range){50, 51}, 2);
    try_range(both, "1 - k/8, 2/k", (valence_range){200, VALENCES_UNBOUNDED}, 2);
    try_range(both, "k^2/10, k", (valence_range){100, VALENCES_UNBOUNDED}, 4);
    test_end();
}

static void tests(void)
{
    test_graded();
}

MAIN(tests);
