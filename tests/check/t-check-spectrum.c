/* The checker's proof about a spectrum, on 2 x 2 matrices whose eigenvalues are
 * known: B = (L 0; 1 mu), with the eigenvector (1, 1/(L - mu)) for L.  Protocol as
 * in t-check-units.c. */

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
#include "../../verify/check/spectrum.c"

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

enum { G = 64 };

/* L and mu in units of 2^-20, and the choices of a certificate. */
struct trial {
    const char *name;
    int l, mu;
    int power;                                     /* P_1 */
    int64_t radius;                                /* in units of 2^-64 */
    int64_t shift;                                 /* of L~, in the same units */
    int expected;                                  /* exit status */
};

static interval thin(int units)
{
    return interval_thin(integer_shift_left(integer_from(units), G - 20));
}

/* num / den 2^32, to about the last place */
static integer inverse_entry(int64_t num, int64_t den)
{
    return integer_from(num * ((INT64_C(1) << 32) / den));
}

static void run(const struct trial *t)
{
    int difference = t->l - t->mu;                 /* L - mu in units of 2^-20 */
    interval matrix[4] = { thin(t->l), thin(0), grid_from(1, G), thin(t->mu) };
    struct block_record record = { { 1, 1 }, t->power, 1 };
    integer eigenvector, inverse[4], one = integer_from(1);
    struct certificate c = {
        .file = "certificate", .real = true, .frequency = 1, .n = 2, .size = 2,
        .pair = { .pivot = 1, .eigenvector = &eigenvector, .inverse = inverse }
    };
    struct eigenpair pair;

    if (difference == 0)                           /* no eigenvector: try any */
        difference = 1 << 18;
    c.pair.radius = integer_from(t->radius);
    c.pair.eigenvalue[0] = integer_add(matrix[0].lo, integer_from(t->shift));
    c.pair.eigenvalue[1] = integer_from(0);

    /* x = 1/(L - mu); G = (0, -1; mu - L, -x), Y = (-x/(mu - L), 1/(mu - L); -1, 0) */
    eigenvector = integer_divide_floor(integer_shift_left(one, G + 20),
                                       integer_from(difference));
    inverse[0] = integer_shift_floor(integer_mul(eigenvector, eigenvector), 2 * G - 32);
    inverse[1] = inverse_entry(-(INT64_C(1) << 20), difference);
    inverse[2] = integer_from(-(INT64_C(1) << 32));
    inverse[3] = integer_from(0);

    pair = spectrum_prove_eigenpair(matrix, G, &c);
    spectrum_prove_rest(matrix, 2, G, &pair, &record, &c);
}

static int status_of(const struct trial *t)
{
    int status = 0;
    pid_t child;

    fflush(stdout);
    child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stderr) == NULL)
            _exit(99);
        run(t);
        _exit(0);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

int main(void)
{
    enum { HALF = 1 << 19, ONE = 1 << 20, GOOD = ANSWER_VERIFIED, BAD = ANSWER_REJECTED };
    static const struct trial trial[] = {
        { "spectrum-plain", HALF, HALF / 2, 0, 1 << 20, 0, GOOD },
        { "spectrum-negative-mu", HALF, -HALF / 2, 0, 1 << 20, 0, GOOD },
        { "spectrum-close", HALF, HALF - 16, 20, 1 << 20, 0, GOOD },
        { "spectrum-close-by-one-row-sum", HALF, HALF - 16, 0, 1 << 20, 0, GOOD },
        { "spectrum-shifted", HALF, HALF / 2, 0, 1 << 20, 1 << 19, GOOD },
        { "spectrum-outside", HALF, HALF / 2, 0, 1 << 20, 1 << 20, BAD },
        { "spectrum-radius-zero", HALF, HALF / 2, 0, 0, 0, BAD },
        { "spectrum-radius-negative", HALF, HALF / 2, 0, -(1 << 20), 0, BAD },
        { "spectrum-negative", -HALF, HALF / 2, 0, 1 << 20, 0, BAD },
        { "spectrum-one", ONE, HALF, 0, 1 << 20, 0, BAD },
        { "spectrum-larger-than-one", ONE + HALF, HALF, 0, 1 << 20, 0, BAD },
        { "spectrum-touches-one", ONE - 1, HALF, 0, INT64_C(1) << 44, 0, BAD },
        { "spectrum-below-one", ONE - 1, HALF, 0, 1 << 20, 0, GOOD },
        { "spectrum-double", HALF, HALF, 0, 1 << 20, 0, BAD },
        { "spectrum-not-dominant", HALF, HALF + 16, 0, 1 << 20, 0, BAD },
        { "spectrum-not-dominant-large-power", HALF, HALF + 16, 40, 1 << 20, 0, BAD },
        { "spectrum-tie", HALF, -HALF, 0, 1 << 20, 0, BAD },
        { "spectrum-tie-large-power", HALF, -HALF, 30, 1 << 20, 0, BAD },
        { "spectrum-tie-largest-power", HALF, -HALF, 40, 1 << 20, 0, BAD },
    };
    int failures = 0;

    for (size_t i = 0; i < sizeof trial / sizeof trial[0]; i++) {
        int status = status_of(&trial[i]);

        if (status == trial[i].expected) {
            printf("PASS %s\n", trial[i].name);
        } else {
            printf("FAIL %s: exit status %d, not %d\n", trial[i].name, status,
                   trial[i].expected);
            failures++;
        }
    }
    return failures == 0 ? 0 : 1;
}
