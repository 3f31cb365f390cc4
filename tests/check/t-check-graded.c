/* Graded values of the checker (section 6 of certificate-valences.md, "Growing without bound"): blocks and nets at
 * kappa = 1/2 are the plain ones of valence 2q; blocks of compositions enclose what exact arithmetic says at each
 * valence of a range; and Laurent values at kappa. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/scratch.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/affine.c"
#include "../../verify/check/text.c"
#include "../../verify/check/formula.c"
#include "../../verify/check/value.c"
#include "../../verify/check/evaluate.c"
#include "../../verify/check/mask.c"
#include "../../verify/check/symmetry.c"
#include "../../verify/check/scheme.c"
#include "../../verify/check/valence.c"
#include "../../verify/check/sector.c"
#include "../../verify/check/eigenpair.c"
#include "../../verify/check/spectrum.c"
#include "../../verify/check/field.c"
#include "../../verify/check/exact_formula.c"
#include "../../verify/check/laurent.c"
#include "../../verify/check/element.c"
#include "../../verify/check/spline.c"
#define at plane_at                                /* mask.c has an at(), too */
#include "../../verify/check/influence.c"
#undef at
#include "../../verify/check/characteristic.c"
#include "../../verify/check/decide.c"
#include "../../verify/check/graded_net.c"
#include "../../verify/check/graded.c"

#include "protocol.h"

#include <string.h>

enum { FINE = 256, EQUAL = FINE - 230 };           /* bits; equal up to 2^-230 */

static const char with_rule[] =
    "scheme test\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n"
    "(2,0) 1/16\nend\nrule centre\ncentre rest\nall (1,0) k/16\nend\n"
    "rule (1,1)\ncentre 1/7\n(1,0) 2/3\n(2,0) @ 1 rest\nend\nrule (5,2)\ncentre 2/3\n(1,0) rest\nend\n";
static const char without_centre[] =
    "scheme test\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 1\n(1,0) 1/2\nend\n"
    "rule (1,0)\ncentre 5\n(1,0) rest\nend\n";
static const char composed[] =
    "scheme test\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\nsmooth 1/4, 1/2 centre 1 - k/8, 2/k\nend\n";
static const char composed_more[] =
    "scheme test\nmesh quad\ndilation 2\nvertices interior\ncompose\nrefine\n"
    "repeat 2: smooth 1/4, 1/2 centre 3/7 - k^2/5 + 2/k, 1/9 - k/3\nsmooth 1/2, 1/3 centre 0, 1/k^2\nend\n";

static const struct scheme *read_scheme_text(const char *text)
{
    struct scheme *out = allocate(1, sizeof *out);

    scheme_read(out, "test", text, strlen(text));
    return out;
}

/* Block 0 at the valences, graded and with kappa = q/k; or plain. */
static struct block *block_at(const char *text, int64_t first, int64_t last)
{
    struct valence *v = allocate(1, sizeof *v);
    struct block *out = allocate(1, sizeof *out);

    valence_prepare(v, read_scheme_text(text), (struct reference) { "certificate", 1 },
                    (struct span) { first, last }, FINE);
    if (first == last)
        block_prepare(out, v, true, span_of(0));
    else
        graded_prepare_block(out, v);
    return out;
}

static struct grading *grading_at(struct block *block, int64_t q, int degree)
{
    EXPECT(grading_prepare(block, q, degree));
    return block->own;
}

/* 2^-n */
static interval half_to(int n)
{
    return n < 0 ? grid_from_fraction(integer_shift_left(integer_from(1), -n), integer_from(1), FINE)
                 : grid_from_fraction(integer_from(1), integer_shift_left(integer_from(1), n), FINE);
}

/* kappa = 1/2 in place of all that it may be. */
static void prepare_at_half(struct block *block, int64_t q, int degree)
{
    grading_at(block, q, degree)->kappa[1] = affine_from(half_to(1));
}

static bool are_equal(struct affine x, struct affine y)
{
    x = affine_sub(x, y);
    return integer_bits(interval_magnitude(x.c)) <= EQUAL && interval_is_zero(x.d);
}

/* What it stands for at kappa = 1/2 */
static struct affine at_half(const struct graded_value *x)
{
    return x->present ? affine_mul(affine_from(half_to(x->e)), x->v, FINE) : affine_from_whole(0, FINE);
}

/* 3 + k/2 - 5 k^-2, and without k/2 */
static void test_laurent(void)
{
    struct laurent *a = allocate(1, sizeof *a);
    struct affine kappa = affine_from(half_to(1)), out;

    for (int i = 0; i < SIZE; i++)
        a->c[i] = rational_from(0, 1);
    a->c[LAURENT_DEGREE] = rational_from(3, 1);
    a->c[LAURENT_DEGREE + 1] = rational_from(1, 2);
    a->c[LAURENT_DEGREE - 2] = rational_from(-5, 1);
    begin("graded-laurent");
    laurent_rescale(a, 6);
    EXPECT(rational_equals(laurent_at(a, 1), 3, 1) && rational_equals(laurent_at(a, -2), -5, 36));
    EXPECT(!laurent_in_kappa(&out, a, kappa, FINE));
    a->c[LAURENT_DEGREE + 1] = rational_from(0, 1);
    EXPECT(laurent_in_kappa(&out, a, kappa, FINE));
    /* 3 - 5/144 */
    EXPECT(are_equal(out, affine_from(grid_from_rational(rational_from(427, 144), FINE))));
    end();
}

/* q/k from 6/24 to 6/8, and from 0 to 8/8 */
static void test_kappa(void)
{
    const struct affine *kappa = grading_at(block_at(composed, 8, 24), 6, 0)->kappa;

    begin("graded-kappa");
    EXPECT(are_equal(affine_from(kappa[1].c), affine_from(half_to(1))));
    EXPECT(are_equal(affine_from(kappa[1].d), affine_from(half_to(2))));
    EXPECT(are_equal(kappa[0], affine_from_whole(1, FINE)));
    kappa = grading_at(block_at(composed, 8, ENDLESS), 8, 0)->kappa;
    EXPECT(are_equal(affine_from(kappa[1].c), affine_from(half_to(1))));
    EXPECT(are_equal(affine_from(kappa[1].d), affine_from(half_to(1))));
    end();
}

/* The scaled block at k = 2q is that of the valence, scaled. */
static void test_block(const char *name, const char *text)
{
    enum { Q = 8 };
    struct block *graded = block_at(text, Q, ENDLESS), *plain = block_at(text, 2 * Q, 2 * Q);
    int *grades = allocate((size_t)graded->n, sizeof grades[0]);
    struct certificate c = { .file = "certificate", .grid = FINE, .unit = Q, .degree = 12, .grade = grades };
    const struct affine *m, *b = block_matrix(plain);

    begin(name);
    EXPECT(graded->n == plain->n);
    for (int i = 0; i < graded->n; i++)
        grades[i] = (i + 2) * i % 5;
    prepare_at_half(graded, Q, c.degree);
    m = scaled_matrix(graded, &c);
    for (int i = 0; i < graded->n; i++)
        for (int j = 0; j < graded->n; j++)
            EXPECT(are_equal(affine_mul(affine_from(half_to(grades[i] - grades[j] - 12)), m[i * graded->n + j], FINE),
                             b[i * graded->n + j]));
    end();
}

/* Further rings at k = 2q are those of the components kappa^e_i x_i and the eigenvalue L kappa^-d. */
static void test_net(const char *name, const char *text)
{
    enum { Q = 8, RINGS = 9 };
    struct block *block = block_at(text, Q, ENDLESS), *plain = block_at(text, 2 * Q, 2 * Q);
    size_t n = (size_t)block->n;
    int *grades = allocate(n, sizeof grades[0]);
    struct affine *x = allocate(n, sizeof x[0]), *y = allocate(n, sizeof y[0]), l = affine_from_whole(-3, FINE);
    struct affine plain_l = affine_from_whole(-12, FINE);
    struct net net = net_make(plain->v->scheme->mesh, plain->rings);
    struct net graded = begin_net(block);

    begin(name);
    for (int i = 0; i < block->n; i++) {
        grades[i] = (i + 2) * i % 5;
        x[i] = affine_from(grid_from_rational(rational_from(11 * i % 16 - 5, 8), FINE));
        y[i] = affine_mul(affine_from(half_to(grades[i])), x[i], FINE);
    }
    prepare_at_half(block, Q, 2);
    for (int i = 0; i < block->n; i++)
        set_component(&graded, block, i, grades[i], x[i]);
    net_set_unknowns(&net, plain, y);
    while (graded.rings < RINGS) {
        graded = net_extend(&graded, block, (struct pair) { l, l }, RINGS);
        net = net_extend(&net, plain, (struct pair) { plain_l, plain_l }, RINGS);
    }
    EXPECT(net.rings == RINGS && graded.rings == RINGS);
    for (int a = -4; a <= RINGS; a++)
        for (int b = a < 1 ? 1 - a : 0; label_ring(graded.mesh, a, b) <= RINGS && b <= RINGS; b++)
            EXPECT(are_equal(at_half(net_find(&graded, block, a, b)), net_value(&net, plain, a, b).x));
    end();
}

/* Exact nets of quads, the centre at (0,0)
 * ---------------------------------------- */

enum { PLANE = 40 };

struct exact_net {
    rational v[PLANE][PLANE];
};

static rational exact_at(const struct exact_net *net, int a, int b)
{
    while (a < 0 || b < 0 || (a == 0 && b > 0)) {
        int old = a;

        a = b >= 1 ? b : -b;
        b = b >= 1 ? -old : old;
    }
    return net->v[a][b];
}

static rational halved(rational x, rational y)
{
    return rational_mul(rational_add(x, y), rational_from(1, 2));
}

static struct exact_net *exact_refine(const struct exact_net *old, int rings)
{
    struct exact_net *out = allocate(1, sizeof *out);

    for (int a = 0; a <= rings; a++)
        for (int b = 0; b <= rings; b++)
            out->v[a][b] = halved(halved(exact_at(old, a / 2, b / 2), exact_at(old, (a + 1) / 2, b / 2)),
                                  halved(exact_at(old, a / 2, (b + 1) / 2), exact_at(old, (a + 1) / 2, (b + 1) / 2)));
    return out;
}

/* w0 own + w1 edges + (1 - w0 - w1) diagonals */
static rational exact_mean(rational w0, rational w1, rational own, rational edges, rational diagonals)
{
    rational w2 = rational_sub(rational_sub(rational_from(1, 1), w0), w1);

    return rational_add(rational_add(rational_mul(w0, own), rational_mul(w1, edges)), rational_mul(w2, diagonals));
}

/* w: weights and weights of the centre */
static struct exact_net *exact_smooth(const struct exact_net *old, int rings, const rational w[4])
{
    struct exact_net *out = allocate(1, sizeof *out);

    for (int a = 1; a <= rings; a++)
        for (int b = 0; b <= rings; b++)
            out->v[a][b] = exact_mean(w[0], w[1], exact_at(old, a, b),
                                      halved(halved(exact_at(old, a - 1, b), exact_at(old, a + 1, b)),
                                             halved(exact_at(old, a, b - 1), exact_at(old, a, b + 1))),
                                      halved(halved(exact_at(old, a - 1, b - 1), exact_at(old, a + 1, b - 1)),
                                             halved(exact_at(old, a - 1, b + 1), exact_at(old, a + 1, b + 1))));
    out->v[0][0] = exact_mean(w[2], w[3], old->v[0][0], old->v[1][0], old->v[1][1]);
    return out;
}

/* The weights of composed and composed_more at k */
static int list_smoothings(rational w[3][4], bool more, int64_t k)
{
    rational x = rational_from(k, 1);

    for (int i = 0; i < 3; i++) {
        w[i][0] = rational_from(1, 4);
        w[i][1] = rational_from(1, 2);
        w[i][2] = rational_sub(rational_from(1, 1), rational_from(k, 8));
        w[i][3] = rational_from(2, k);
    }
    if (!more)
        return 1;
    for (int i = 0; i < 2; i++) {
        w[i][2] = rational_add(rational_sub(rational_from(3, 7), rational_mul(rational_from(k, 5), x)),
                               rational_from(2, k));
        w[i][3] = rational_sub(rational_from(1, 9), rational_from(k, 3));
    }
    w[2][0] = rational_from(1, 2);
    w[2][1] = rational_from(1, 3);
    w[2][2] = rational_from(0, 1);
    w[2][3] = rational_divide(rational_from(1, k), x);
    return 3;
}

static struct exact_net *exact_subdivide(const struct exact_net *old, int rings, bool more, int64_t k)
{
    rational w[3][4];
    int steps = list_smoothings(w, more, k);
    struct exact_net *net = exact_refine(old, rings + steps);

    for (int i = 0; i < steps; i++)
        net = exact_smooth(net, rings + steps - 1 - i, w[i]);
    return net;
}

/* Does x enclose exact (k/q)^e, q/k being c + d t? */
static bool encloses(const struct graded_value *x, rational exact, int64_t q, int64_t k, const struct grading *s)
{
    interval t = grid_div(interval_sub(grid_from_rational(rational_from(q, k), FINE), s->kappa[1].c), s->kappa[1].d,
                          FINE);
    interval all, one;

    if (!x->present)
        return exact.num.sign == 0;
    for (int i = 0; i < x->e; i++)
        exact = rational_mul(exact, rational_from(k, q));
    for (int i = x->e; i < 0; i++)
        exact = rational_mul(exact, rational_from(q, k));
    all = interval_add(x->v.c, grid_mul(x->v.d, t, FINE));
    one = grid_from_rational(exact, FINE);
    return integer_compare(all.lo, one.lo) <= 0 && integer_compare(one.hi, all.hi) <= 0;
}

/* Column j of the block over 900..inf is the exact one at k. */
static void compare_column(const struct block *block, int j, bool more, int64_t q, int64_t k)
{
    struct net net = begin_net(block);
    struct exact_net *exact = allocate(1, sizeof *exact);

    for (int i = 0; i < PLANE * PLANE; i++)
        exact->v[i / PLANE][i % PLANE] = rational_from(0, 1);
    exact->v[block->unknown[j].a][block->unknown[j].b] = rational_from(1, 1);
    set_component(&net, block, j, 0, affine_from_whole(1, FINE));
    exact = exact_subdivide(exact, block->rings, more, k);
    net = net_subdivide(&net, block, block->rings);
    for (int i = 0; i < block->n; i++)
        EXPECT(encloses(net_find(&net, block, block->unknown[i].a, block->unknown[i].b),
                        exact_at(exact, block->unknown[i].a, block->unknown[i].b), q, k, block->own));
}

static void test_exact(const char *name, const char *text, bool more)
{
    static const int64_t k[] = { 900, 901, 1000, 123457, 1000000000 };
    enum { Q = 30 };
    struct block *block = block_at(text, 900, ENDLESS);

    begin(name);
    grading_at(block, Q, 0);
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++)
        for (int j = 0; j < block->n; j++)
            compare_column(block, j, more, Q, k[i]);
    end();
}

int main(void)
{
    test_laurent();
    test_kappa();
    test_block("graded-block", with_rule);
    test_block("graded-block-without-centre", without_centre);
    test_block("graded-block-composed", composed);
    test_block("graded-block-composed-more", composed_more);
    test_net("graded-net", with_rule);
    test_net("graded-net-without-centre", without_centre);
    test_net("graded-net-composed", composed);
    test_net("graded-net-composed-more", composed_more);
    test_exact("graded-exact-composed", composed, false);
    test_exact("graded-exact-composed-more", composed_more, true);
    return failures == 0 ? 0 : 1;
}
