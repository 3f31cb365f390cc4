/* The checker's proof about a spectrum, on 2 x 2 matrices whose eigenvalues are
 * known: B = (L 0; 1 mu), with the eigenvector (1, 1/(L - mu)) for L.  Protocol as
 * in t-check-units.c. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/text.c"
#include "../../verify/check/formula.c"
#include "../../verify/check/mask.c"
#include "../../verify/check/scheme.c"
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

static void thin(interval *out, int units)
{
    integer value;

    integer_set_small(&value, units);
    integer_shift_left(&value, &value, G - 20);
    interval_set_thin(out, &value);
}

/* round(num / den 2^32), to about the last place */
static void inverse_entry(integer *out, int64_t num, int64_t den)
{
    integer_set_small(out, num * ((INT64_C(1) << 32) / den));
}

static void run(const struct trial *t)
{
    static interval matrix[4];
    static integer eigenvector[2], inverse[4];
    static int power[2];
    static struct certificate c;
    struct block block = { .g = G, .n = 2, .twist = { .m = 1 } };
    struct eigenpair pair;
    integer shift, one;
    interval one_interval;
    int difference = t->l - t->mu;                 /* L - mu in units of 2^-20 */

    if (difference == 0)                           /* no eigenvector: try any */
        difference = 1 << 18;
    thin(&matrix[0], t->l);
    thin(&matrix[1], 0);
    grid_set_small(&one_interval, 1, G);
    interval_set(&matrix[2], &one_interval);
    thin(&matrix[3], t->mu);

    c.file = "certificate";
    c.n = 2;
    c.pivot = 1;
    c.eigenvector = eigenvector;
    c.inverse = inverse;
    c.power = power;
    power[1] = t->power;
    integer_set_small(&c.radius, t->radius);
    integer_set_small(&shift, t->shift);
    integer_add(&c.eigenvalue, &matrix[0].lo, &shift);

    /* x = 1/(L - mu); G = (0, -1; mu - L, -x), Y = (-x/(mu - L), 1/(mu - L); -1, 0) */
    integer_set_small(&one, 1);
    integer_shift_left(&one, &one, G + 20);
    integer_set_small(&shift, difference);
    integer_divide_floor(&eigenvector[0], &one, &shift);
    integer_mul(&inverse[0], &eigenvector[0], &eigenvector[0]);
    integer_shift_floor(&inverse[0], &inverse[0], 2 * G - 32);
    inverse_entry(&inverse[1], -(INT64_C(1) << 20), difference);
    integer_set_small(&inverse[2], -(INT64_C(1) << 32));
    integer_set_small(&inverse[3], 0);

    spectrum_prove_eigenpair(&pair, &block, matrix, &c);
    spectrum_prove_rest(&block, matrix, &pair, &c);
    free(pair.unknowns);
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
    enum { HALF = 1 << 19, ONE = 1 << 20, YES = ANSWER_VERIFIED, NO = ANSWER_REJECTED };
    static const struct trial trial[] = {
        { "spectrum-plain", HALF, HALF / 2, 0, 1 << 20, 0, YES },
        { "spectrum-negative-mu", HALF, -HALF / 2, 0, 1 << 20, 0, YES },
        { "spectrum-close", HALF, HALF - 16, 20, 1 << 20, 0, YES },
        { "spectrum-close-by-one-row-sum", HALF, HALF - 16, 0, 1 << 20, 0, YES },
        { "spectrum-shifted", HALF, HALF / 2, 0, 1 << 20, 1 << 19, YES },
        { "spectrum-outside", HALF, HALF / 2, 0, 1 << 20, 1 << 20, NO },
        { "spectrum-radius-zero", HALF, HALF / 2, 0, 0, 0, NO },
        { "spectrum-radius-negative", HALF, HALF / 2, 0, -(1 << 20), 0, NO },
        { "spectrum-negative", -HALF, HALF / 2, 0, 1 << 20, 0, NO },
        { "spectrum-one", ONE, HALF, 0, 1 << 20, 0, NO },
        { "spectrum-larger-than-one", ONE + HALF, HALF, 0, 1 << 20, 0, NO },
        { "spectrum-touches-one", ONE - 1, HALF, 0, INT64_C(1) << 44, 0, NO },
        { "spectrum-below-one", ONE - 1, HALF, 0, 1 << 20, 0, YES },
        { "spectrum-double", HALF, HALF, 0, 1 << 20, 0, NO },
        { "spectrum-not-dominant", HALF, HALF + 16, 0, 1 << 20, 0, NO },
        { "spectrum-not-dominant-large-power", HALF, HALF + 16, 40, 1 << 20, 0, NO },
        { "spectrum-tie", HALF, -HALF, 0, 1 << 20, 0, NO },
        { "spectrum-tie-large-power", HALF, -HALF, 30, 1 << 20, 0, NO },
        { "spectrum-tie-largest-power", HALF, -HALF, 40, 1 << 20, 0, NO },
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
