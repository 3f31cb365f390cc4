/* Unit tests of the checker's box splines, mirror symmetry and influence, as in t-check-units.c.
 *
 * SRCDIR names the sources, for the catalogue. */

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
#include "../../verify/check/element.c"
#include "../../verify/check/spline.c"
#define at plane_at                                /* mask.c has an at(), too */
#include "../../verify/check/influence.c"
#undef at

#include "protocol.h"

/* Box splines
 * ----------- */

/* 4 z^c times the product of ((1 + z^e_i)/2)^m_i, and one more unit at the label c + (da, db) */
static struct mask box_mask(const int m[3], struct label c, int error)
{
    struct mask out = mask_new(c.a, c.b, 1, 1);
    int power = 0;

    *mask_cell(&out, c.a, c.b) = integer_from(4);
    for (int i = 0; i < 3; i++) {
        for (int n = 0; n < m[i]; n++) {
            struct mask factor = mask_new(0, -1, 2, 3);

            *mask_cell(&factor, 0, 0) = integer_from(1);
            *mask_cell(&factor, direction[i].a, direction[i].b) = integer_from(1);
            factor.denominator = integer_from(2);
            out = mask_multiply(&out, &factor);
            power++;
        }
    }
    if (error != 0)
        out.coefficient[power % (out.side_a * out.side_b)] =
            integer_add(out.coefficient[power % (out.side_a * out.side_b)], integer_from(error));
    return out;
}

static void test_spline_find(void)
{
    static const int good[][3] = { { 2, 2, 2 }, { 1, 1, 0 }, { 3, 1, 2 }, { 0, 2, 2 }, { 5, 5, 5 } };
    struct label c = { -2, 1 };

    begin("spline-find");
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        struct mask mask = box_mask(good[i], c, 0), other = box_mask(good[i], c, 1);
        struct spline s;

        EXPECT(spline_find(&s, &mask, TRIANGLE));
        EXPECT(s.m[0] == good[i][0] && s.m[1] == good[i][1] && s.m[2] == good[i][2]);
        EXPECT(s.c.a == c.a && s.c.b == c.b);
        EXPECT(!spline_find(&s, &other, TRIANGLE));
        EXPECT(spline_find(&s, &mask, QUAD) == (good[i][2] == 0));
    }
    end();
}

/* The polynomial, times degree!, at the point with these weights. */
static rational value_at(const integer *p, int degree, const rational w[3])
{
    rational sum = rational_from(0, 1);

    for (int i = 0; p != NULL && i <= degree; i++) {
        for (int j = 0; i + j <= degree; j++) {
            rational term = rational_reduce(p[i * (degree + 1) + j], integer_from(1));

            for (int n = 0; n < degree; n++)
                term = rational_mul(term, w[n < i ? 1 : n < i + j ? 2 : 0]);
            sum = rational_add(sum, term);
        }
    }
    return sum;
}

/* Weights of a point of the child as a point of its parent, in whose half-size units the child's vertices are labels. */
static void weights_in_parent(rational out[3], const rational w[3], enum element_kind kind, const struct child *child)
{
    rational x = rational_from(0, 1), y = rational_from(0, 1), half = rational_from(1, 2), one = rational_from(1, 1);

    for (int i = 0; i < 3; i++) {
        struct label v = element_form[child->kind].vertex[i];

        x = rational_add(x, rational_mul(w[i], rational_from(child->a + v.a, 1)));
        y = rational_add(y, rational_mul(w[i], rational_from(child->b + v.b, 1)));
    }
    x = rational_mul(x, half);
    y = rational_mul(y, half);
    out[1] = kind == ELEMENT_U ? x : rational_sub(one, x);
    out[2] = kind == ELEMENT_U ? y : rational_sub(one, y);
    out[0] = rational_sub(one, rational_add(out[1], out[2]));
}

static bool same(rational a, rational b)
{
    return rational_compare(a, b) == 0;
}

/* Once for each triangle T of the support: phi(x) = sum of a(z) phi(2x - z), at a point x of T. */
static void check_refinement(struct pieces *pieces, const int m[3], const struct mask *mask, struct element t)
{
    const struct child *child = &element_form[t.kind].child[random_word() % 4];
    int degree = m[0] + m[1] + m[2] - 2;
    rational w[3], up[3], sum = rational_from(0, 1);

    w[0] = rational_from((int)(random_word() % 4) + 1, 12);
    w[1] = rational_from((int)(random_word() % 4) + 1, 12);
    w[2] = rational_sub(rational_from(1, 1), rational_add(w[0], w[1]));
    weights_in_parent(up, w, t.kind, child);
    for (int i = 0; i < mask->side_a * mask->side_b; i++) {
        int za = mask->low_a + i / mask->side_b, zb = mask->low_b + i % mask->side_b;
        struct element at = { child->kind, 2 * t.a + child->a - za, 2 * t.b + child->b - zb };

        if (mask->coefficient[i].sign != 0)
            sum = rational_add(sum, rational_mul(rational_reduce(mask->coefficient[i], mask->denominator),
                                                 value_at(piece_at(pieces, m, at), degree, w)));
    }
    EXPECT(same(sum, value_at(piece_at(pieces, m, t), degree, up)));
}

/* Up to m1 + m2 + m3 = 17 on triangles, m1, m2 = 16 on quads. */
static void test_spline_limits(void)
{
    static const struct {
        int m[3];
        bool triangle, quad;
    } trial[] = { { { 6, 6, 5 }, true, false }, { { 6, 6, 6 }, false, false }, { { 2, 15, 0 }, true, true }, { { 2, 16, 0 }, false, true },
                  { { 2, 17, 0 }, false, false }, { { 16, 2, 0 }, false, true }, { { 17, 2, 0 }, false, false } };
    struct label c = { -2, 1 };

    begin("spline-limits");
    for (size_t i = 0; i < sizeof trial / sizeof trial[0]; i++) {
        struct mask mask = box_mask(trial[i].m, c, 0);
        struct spline s;

        EXPECT(spline_find(&s, &mask, TRIANGLE) == trial[i].triangle);
        EXPECT(spline_find(&s, &mask, QUAD) == trial[i].quad);
    }
    end();
}

/* The polynomials are those of the function with phi(x) = sum of a(z) phi(2x - z) whose translates sum to 1: there is
 * only one. */
static void check_box_spline(const int m[3])
{
    struct pieces *pieces = allocate(1, sizeof *pieces);
    struct label origin = { 0, 0 };
    struct mask mask = box_mask(m, origin, 0);
    int most = m[0] + m[1] + m[2];
    rational w[3] = { rational_from(1, 6), rational_from(1, 3), rational_from(1, 2) }, sum[2];

    sum[0] = sum[1] = rational_from(0, 1);
    for (int a = -1; a <= most; a++) {
        for (int b = -most; b <= most; b++) {
            for (int d = 0; d < 2; d++) {
                struct element t = { d == 0 ? ELEMENT_U : ELEMENT_D, a, b };

                sum[d] = rational_add(sum[d], value_at(piece_at(pieces, m, t), most - 2, w));
                check_refinement(pieces, m, &mask, t);
            }
        }
    }
    for (int d = 0; d < 2; d++)
        EXPECT(same(sum[d], rational_reduce(factorial(most - 2), integer_from(1))));
}

static void test_spline_triangles(void)
{
    static const int m[][3] = { { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 }, { 2, 2, 1 }, { 1, 2, 2 },
                                { 3, 1, 0 }, { 2, 0, 3 }, { 0, 3, 1 }, { 3, 3, 3 } };

    begin("spline-triangles");
    for (size_t i = 0; i < sizeof m / sizeof m[0]; i++)
        check_box_spline(m[i]);
    end();
}

static rational piece_value(const integer *piece, int degree, int l, rational t)
{
    rational sum = rational_from(0, 1), s = rational_sub(rational_from(1, 1), t);

    for (int i = 0; l >= 0 && l <= degree && i <= degree; i++) {
        rational term = rational_reduce(piece[l * (degree + 1) + i], integer_from(1));

        for (int n = 0; n < degree; n++)
            term = rational_mul(term, n < i ? t : s);
        sum = rational_add(sum, term);
    }
    return sum;
}

/* The same along one axis, for 2 ((1 + z)/2)^(degree + 1). */
static void test_spline_axis(void)
{
    begin("spline-axis");
    for (int degree = 0; degree <= 7; degree++) {
        integer *piece = spline_pieces(degree);
        rational t = rational_from(3, 7), total = rational_from(0, 1);

        for (int l = 0; l <= degree; l++) {
            for (int half = 0; half < 2; half++) {
                rational here = rational_mul(rational_add(t, rational_from(half, 1)), rational_from(1, 2));
                rational sum = rational_from(0, 1);
                int binomial = 1;

                for (int z = 0; z <= degree + 1; z++) {
                    sum = rational_add(sum, rational_mul(rational_from(binomial, 1 << degree),
                                                         piece_value(piece, degree, 2 * l + half - z, t)));
                    binomial = binomial * (degree + 1 - z) / (z + 1);
                }
                EXPECT(same(sum, piece_value(piece, degree, l, here)));
            }
            total = rational_add(total, piece_value(piece, degree, l, t));
        }
        EXPECT(same(total, rational_reduce(factorial(degree), integer_from(1))));
    }
    end();
}

/* Schemes
 * ------- */

static const struct scheme *read_text(const char *text)
{
    struct scheme *out = allocate(1, sizeof *out);
    size_t size;

    text_canonical("scheme", text, strlen(text), &size);
    scheme_read(out, "scheme", text, strlen(text));
    return out;
}

#define HEAD "scheme s\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n" \
             "(2,0) 1/16\nend\nrule centre\ncentre 1/2\nall (1,0) rest\nend\n"
#define SPOKE "rule (1,0)\ncentre 3/8\n(1,0) rest\n"

static void test_symmetry(void)
{
    static const struct {
        const char *rules;
        bool mirrored;
    } trial[] = {
        { "", true },
        { SPOKE "(1,0) @ 1 1/8\n(1,0) @ -1 1/8\nend\n", true },
        { SPOKE "(1,0) @ 1 1/8\n(1,0) @ -1 2/16\nend\n", true },
        { SPOKE "(1,0) @ 1 1/8\n(1,0) @ -1 1/9\nend\n", false },
        { SPOKE "(1,0) @ 1 1/8\nend\n", false },
        { SPOKE "(1,0) @ 1 1/8\n(1,0) @ 2 1/8\nend\n", false },
        { SPOKE "(1,1) 1/8\n(1,1) @ -1 1/8\nend\n", true },
        { SPOKE "(1,1) 1/8\n(1,1) @ 1 1/8\nend\n", false },
        { SPOKE "(1,0) @ 1 1/k\n(1,0) @ -1 1/k\nend\n", true },
        { SPOKE "(1,0) @ 1 1/k\n(1,0) @ -1 2/k\nend\n", false },
        { SPOKE "(1,0) @ 1 cos(pi/k)\n(1,0) @ -1 sin(pi/k)\nend\n", false },
        { SPOKE "(1,0) @ 1 min(1/k, 1/2)\n(1,0) @ -1 max(1/k, 1/2)\nend\n", false },
        { SPOKE "(1,0) @ 1 k - 1\n(1,0) @ -1 k + 1\nend\n", false },
        { SPOKE "(1,0) @ 1 k^2\n(1,0) @ -1 k^-2\nend\n", false },
        /* conditions */
        { SPOKE "(1,0) @ 1 cases(k = 5: 1; else: k)\n(1,0) @ -1 cases(k = 5: 1; else: k)\nend\n", true },
        { SPOKE "(1,0) @ 1 cases(k = 5: 1; else: k)\n(1,0) @ -1 cases(k != 5: 1; else: k)\nend\n", false },
        { SPOKE "(1,0) @ 1 cases(2 = 1: 1; else: k)\n(1,0) @ -1 cases(2 = 1: 1; else: k)\nend\n", true },
        { SPOKE "(1,0) @ 1 cases(2 = 1: 1; else: k)\n(1,0) @ -1 cases(2 > 1: 1; else: k)\nend\n", false },
        { SPOKE "(1,0) @ 1 cases(2 = 1 and 1 = 1: 1; else: k)\n(1,0) @ -1 cases(2 > 1 and 1 = 1: 1; else: k)\nend\n", false },
        { SPOKE "(1,0) @ 1 cases(2 = 1 or 1 = 1: 1; else: k)\n(1,0) @ -1 cases(2 = 1 and 1 = 1: 1; else: k)\nend\n", false },
        { "rule (2,1) when k > 4\n(1,0) 1/4\n(2,0) rest\nend\nrule (1,2) when k > 4\n(1,0) @ 1 1/4\n(2,0) @ 1 rest\nend\n", true },
        { "rule (2,1) when k > 4\n(1,0) 1/4\n(2,0) rest\nend\nrule (1,2) when k > 5\n(1,0) @ 1 1/4\n(2,0) @ 1 rest\nend\n", false },
        { "rule (2,1) when 2 > 1\n(1,0) 1/4\n(2,0) rest\nend\nrule (1,2) when 1 > 2\n(1,0) @ 1 1/4\n(2,0) @ 1 rest\nend\n", false },
        { "rule (2,1)\n(1,0) 1/4\n(2,0) rest\nend\n", false },
        { "rule (2,1)\n(1,0) 1/4\n(2,0) rest\nend\nrule (1,2)\n(1,0) 1/4\n(2,0) rest\nend\n", false },
        /* weights by sector and by spectrum */
        { "rule (1,0)\ncentre rest\n(1,0) @ j cos(2*pi*j/k)/k\nend\n", true },
        { "rule (1,0)\ncentre rest\n(1,0) @ j sin(2*pi*j/k)/k\nend\n", false },
        { "rule (1,0)\ncentre rest\n(1,0) @ j cos(3*pi*j/k)/k\nend\n", false },
        { "rule (1,0)\ncentre rest\n(1,0) @ j min(j, k - j)/k^2\nend\n", true },
        { "rule (1,0)\ncentre rest\n(1,0) @ j j/k^2\nend\n", false },
        { "rule (1,0)\ncentre rest\n(1,0) @ j cases(j = 0: 1/2; else: 1/k)\nend\n", true },
        { "rule (1,0)\ncentre rest\n(1,0) @ j cases(j = 1: 1/2; else: 1/k)\nend\n", false },
        { "rule (1,0)\ncentre rest\n(1,1) @ j 1/k^2\nend\n", false },
        { "rule (1,0)\ncentre rest\n(1,0) spectrum cases(m = 0: 5/8; else: 1/4)\nend\n", true },
        { "rule (1,0)\ncentre rest\n(1,0) spectrum cases(m = 0: 5/8; else: 1/4), cases(m = 1: 1/5; else: 0)\nend\n", false },
    };

    begin("symmetry");
    for (size_t i = 0; i < sizeof trial / sizeof trial[0]; i++) {
        char text[2000];

        snprintf(text, sizeof text, HEAD "%s", trial[i].rules);
        if (read_text(text)->mirrored != trial[i].mirrored && reason[0] == '\0')
            snprintf(reason, sizeof reason, "not %d: %.200s", trial[i].mirrored, trial[i].rules);
    }
    end();
}

/* As lib/influence.c says, which does it in another way. */
static void test_influence(void)
{
    static const struct {
        const char *name;
        int ring;
        bool mirrored;
    } trial[] = {
        { "loop", 0, true }, { "loop-warren", 0, true }, { "modified-loop", 1, true }, { "loop-ring", 1, true },
        { "loop-spiral", 1, false }, { "butterfly", 0, true }, { "modified-butterfly", 1, true },
        { "catmull-clark", 1, true }, { "catmull-clark-weights", 1, true }, { "doo-sabin", 1, true },
        { "doo-sabin-spectrum", 1, true }, { "midpoint", 1, true }, { "wave", 3, true }, { "wave-valence", 3, true },
        { "kobbelt", 3, true },
    };
    const char *sources = getenv("SRCDIR");

    begin("influence");
    for (size_t i = 0; i < sizeof trial / sizeof trial[0]; i++) {
        char name[1000];
        size_t size;
        const struct scheme *s;

        snprintf(name, sizeof name, "%s/lib/catalogue/%s.scheme", sources == NULL ? "." : sources, trial[i].name);
        s = read_text(text_read_file(name, 65536, &size));
        if (scheme_influence(s) != trial[i].ring && reason[0] == '\0')
            snprintf(reason, sizeof reason, "%s: %d, not %d", trial[i].name, scheme_influence(s), trial[i].ring);
        EXPECT(s->mirrored == trial[i].mirrored);
    }
    EXPECT(scheme_influence(read_text(HEAD "rule (4,3) when k = 5\n(2,1) rest\nend\n")) == 7);
    EXPECT(scheme_influence(read_text(HEAD "rule (1,0) when k = 5\n(1,0) rest\nend\n")) == 1);
    end();
}

int main(void)
{
    test_spline_find();
    test_spline_limits();
    test_spline_triangles();
    test_spline_axis();
    test_symmetry();
    test_influence();
    return failures == 0 ? 0 : 1;
}
