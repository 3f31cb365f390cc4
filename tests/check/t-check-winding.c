/* The checker follows a curve by half-planes and counts its quarters of a turn (section 10 of certificate.md,
 * `winding`); sums are compared with those of the same curve read the other way round. */

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
#include "../../verify/check/element.c"
#include "../../verify/check/spline.c"
#define at plane_at                                /* mask.c has an at(), too */
#include "../../verify/check/influence.c"
#undef at
#define divide divide_net
#include "../../verify/check/characteristic.c"
#undef divide
#include "../../verify/check/decide.c"

#include "protocol.h"

#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { G = 64 };

static const struct certificate certificate = { .file = "certificate" };

/* A box of the whole numbers x, y and x + 1, y + 1. */
static struct pair box_at(int x, int y)
{
    struct pair out = { affine_from_whole(x, G), affine_from_whole(y, G) };

    out.x.c.hi = grid_from(x + 1, G).lo;
    out.y.c.hi = grid_from(y + 1, G).lo;
    return out;
}

/* The quarters of a turn of the boxes, x and y alternating. */
static int turns_of(const int *xy, int boxes)
{
    struct tree t = { .certificate = &certificate, .name = "boundary" };

    for (int i = 0; i < boxes; i++) {
        struct pair box = box_at(xy[2 * i], xy[2 * i + 1]);
        struct leaf leaf = { .value = { &box } };

        if (!follow(&t, &leaf))
            return 999;
    }
    return t.path.turns;
}

static void test_follow(void)
{
    static const int round[] = { 2, 0, 2, 2, 0, 2, -2, 2, -2, -2, 0, -2, 0, -3, 3, -3, 2, 0 };
    static const int back[] = { 2, 0, 3, -3, 0, -3, 0, -2, -2, -2, -2, 2, 0, 2, 2, 2, 2, 0 };
    static const int still[] = { 2, 0, 3, 3, 2, -2, 2, 0 };
    static const int zero[] = { 2, 0, -1, -1 }, touching[] = { 2, 0, -1, 0 };

    begin("winding-follow");
    EXPECT(turns_of(round, 9) == 4);
    EXPECT(turns_of(back, 9) == -4);
    EXPECT(turns_of(round, 3) == 1);
    EXPECT(turns_of(still, 4) == 0);
    EXPECT(turns_of(zero, 2) == 999);
    EXPECT(turns_of(touching, 2) == 999);
    end();
}

/* The same boxes in pieces of three, each read the other way round. */
static void test_reversed_pieces(void)
{
    static const int piece[3][6] = {
        { -2, 2, 0, 2, 2, 0 }, { 0, -2, -2, -2, -2, 2 }, { 2, 0, 3, -3, 0, -3 }
    };
    struct tree t = { .certificate = &certificate, .name = "boundary" };
    struct path curve = { .begun = false };

    begin("winding-reversed");
    for (int i = 0; i < 3; i++) {
        t.path = (struct path) { .begun = false };
        for (int n = 0; n < 3; n++) {
            struct pair box = box_at(piece[i][2 * n], piece[i][2 * n + 1]);
            struct leaf leaf = { .value = { &box } };

            EXPECT(follow(&t, &leaf));
        }
        join_paths(&t, &curve, reversed(t.path));
    }
    EXPECT(curve.turns == 4 && curve.first == 0 && curve.last == 0);
    end();
}

/* From x > 0 to x < 0 there is no telling which way. */
static void test_jump(void)
{
    static const int jump[] = { 2, 0, -3, 0 };
    int status = 0;
    pid_t child;

    begin("winding-jump");
    fflush(stdout);
    child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stderr) == NULL)
            _exit(99);
        turns_of(jump, 2);
        _exit(0);
    }
    EXPECT(child > 0 && waitpid(child, &status, 0) == child);
    EXPECT(WIFEXITED(status) && WEXITSTATUS(status) == ANSWER_REJECTED);
    end();
}

/* 2 pi/k is not between (Q - 2) pi/2 and (Q + 2) pi/2. */
static void test_count(void)
{
    begin("winding-count");
    for (int64_t k = 3; k <= 12; k++) {
        for (int q = -9; q <= 9; q++) {
            double angle = 4.0 / (double)k;

            EXPECT(winds_otherwise(q, k) == (angle <= q - 2 || angle >= q + 2));
        }
    }
    EXPECT(winds_otherwise(-2, 1000000000) && winds_otherwise(3, 1000000000));
    EXPECT(!winds_otherwise(2, 1000000000) && !winds_otherwise(-1, 1000000000));
    EXPECT(winds_otherwise(3, 4) && !winds_otherwise(3, 3));
    end();
}

/* The errors of slopes count where the slopes themselves are 0 on a window. */
static void test_errors_of_slopes(void)
{
    struct refinable f = { .stability = 1024 };
    struct affine rho = { interval_of(integer_from(-2), integer_from(2)),
                          interval_of(integer_from(-3), integer_from(3)) };
    struct affine x = widened_parts(affine_from_whole(1, G), rho, &f, false);

    begin("errors-of-slopes");
    EXPECT(integer_compare(x.d.lo, integer_from(-3)) == 0 && integer_compare(x.d.hi, integer_from(3)) == 0);
    EXPECT(integer_compare(integer_sub(x.c.hi, x.c.lo), integer_from(4)) == 0);
    end();
}

int main(void)
{
    test_follow();
    test_errors_of_slopes();
    test_reversed_pieces();
    test_jump();
    test_count();
    return failures == 0 ? 0 : 1;
}
