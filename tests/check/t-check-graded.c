/* The checker's graded net (section 6 of certificate-valences.md, "Growing without bound") at kappa = 1/2 is the plain
 * net of the components kappa^e_i x_i and the eigenvalue L kappa^-d; and Laurent values at kappa. */

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
#define MAX_EXPONENT MAX_EXPONENT_IN_RING         /* value.c has one, too */
#include "../../verify/check/exact_formula.c"
#undef MAX_EXPONENT
#include "../../verify/check/laurent.c"
#include "../../verify/check/element.c"
#include "../../verify/check/spline.c"
#define at plane_at                                /* mask.c has an at(), too */
#include "../../verify/check/influence.c"
#undef at
#define divide divide_net
#include "../../verify/check/characteristic.c"
#undef divide
#include "../../verify/check/decide.c"
#include "../../verify/check/graded.c"

#include "protocol.h"

#include <string.h>

enum { FINE = 256, EQUAL = FINE - 240 };           /* bits; equal up to 2^-240 */

static const char text[] =
    "scheme test\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n"
    "(2,0) 1/16\nend\nrule centre\ncentre rest\nall (1,0) k/16\nend\n"
    "rule (1,1)\ncentre 1/7\n(1,0) 2/3\n(2,0) @ 1 rest\nend\n";

static const struct scheme *read_scheme_text(void)
{
    struct scheme *out = allocate(1, sizeof *out);

    scheme_read(out, "test", text, strlen(text));
    return out;
}

/* 3 + k/2 - 5 k^-2 at k = 6/kappa */
static void test_laurent(void)
{
    struct laurent *a = allocate(1, sizeof *a);
    struct affine kappa = affine_from_whole(0, FINE), out;
    interval expected;

    kappa.c = grid_from_rational(rational_from(1, 2), FINE);
    kappa.d = kappa.c;
    for (int i = 0; i < SIZE; i++)
        a->c[i] = rational_from(0, 1);
    a->c[LAURENT_DEGREE] = rational_from(3, 1);
    a->c[LAURENT_DEGREE + 1] = rational_from(1, 2);
    a->c[LAURENT_DEGREE - 2] = rational_from(-5, 1);
    laurent_rescale(a, 6);
    begin("graded-laurent");
    EXPECT(rational_equals(laurent_at(a, 1), 3, 1) && rational_equals(laurent_at(a, -2), -5, 36));
    EXPECT(!laurent_in_kappa(&out, a, 0, kappa, FINE));
    for (int shift = 1; shift <= 150; shift++) {
        EXPECT(laurent_in_kappa(&out, a, shift, kappa, FINE));
        kappa.d = grid_from(0, FINE);
        EXPECT(laurent_in_kappa(&out, a, shift, kappa, FINE));
        /* (3 + 6 - 5/144) / 2^shift */
        expected = grid_mul(grid_from_rational(rational_from(1291, 144), FINE),
                            grid_from_fraction(integer_from(1), integer_shift_left(integer_from(1), shift), FINE), FINE);
        EXPECT(integer_bits(interval_magnitude(interval_sub(out.c, expected))) <= EQUAL);
    }
    end();
}

static interval eighth(int num)
{
    return grid_from_rational(rational_from(num, 8), FINE);
}

/* 2^-n */
static interval half_to(int n)
{
    return grid_from_fraction(integer_from(1), integer_shift_left(integer_from(1), n), FINE);
}

static void test_net(void)
{
    static const int eighths[] = { 8, -2, 1, 3 };
    int grades[] = { 0, 1, 3, 2 };
    struct certificate c = { .file = "certificate", .grid = FINE, .unit = 8, .degree = 2, .grade = grades };
    struct valence *v = allocate(1, sizeof *v);
    struct block block;
    struct graded *s = allocate(1, sizeof *s);
    struct affine x[4], y[4];
    struct eigenpair pair = { .unknowns = y, .real = affine_from_whole(-12, FINE) };
    struct net net;

    begin("graded-net");
    valence_prepare(v, read_scheme_text(), (struct reference) { "certificate", 1 }, (struct span) { 8, ENDLESS }, FINE);
    graded_prepare_block(&block, v);
    EXPECT(block.n == 4);
    *s = (struct graded) { .block = &block, .c = &c, .g = FINE, .l = affine_from_whole(-3, FINE) };
    prepare_kappa(s, v->k);
    s->kappa[1] = affine_from(half_to(1));
    for (int i = 0; i < 4; i++) {
        x[i] = affine_from(eighth(eighths[i]));
        y[i] = affine_scale(half_to(grades[i]), x[i], FINE);
    }
    begin_net(s, x);
    net = net_make(TRIANGLE, block.rings);
    net_set_unknowns(&net, &block, y);
    while (s->rings < 9) {
        extend(s, 9);
        net = extend_net(&net, &block, &pair, 9);
    }
    EXPECT(net.rings == 9);
    for (int a = -4; a <= 9; a++) {
        for (int b = a < 1 ? 1 - a : 0; a + b <= 9 && b <= 9; b++) {
            const struct term_value *here = value_at(s, a, b);
            struct affine scaled = affine_scale(half_to(here->e), here->v, FINE);

            scaled = affine_sub(scaled, net_value(&net, &block, a, b).x);
            EXPECT(integer_bits(interval_magnitude(scaled.c)) <= EQUAL);
        }
    }
    end();
}

int main(void)
{
    test_laurent();
    test_net();
    return failures == 0 ? 0 : 1;
}
