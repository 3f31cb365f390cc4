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
#include "../../verify/check/eigenpair.c"
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
    struct affine matrix[4] = { affine_from(thin(t->l)), affine_from_whole(0, G), affine_from_whole(1, G),
                                affine_from(thin(t->mu)) };
    struct block_record record = { { 1, 1 }, t->power, 1 };
    integer eigenvector, inverse[4], one = integer_from(1);
    struct certificate c = {
        .file = "certificate", .grid = G, .real = true, .frequency = 1, .n = 2, .size = 2,
        .pair = { .pivot = 1, .eigenvector = &eigenvector, .inverse = inverse }
    };
    struct eigenpair pair;

    if (difference == 0)                           /* no eigenvector: try any */
        difference = 1 << 18;
    c.pair.radius = integer_from(t->radius);
    c.pair.eigenvalue[0] = integer_add(matrix[0].c.lo, integer_from(t->shift));
    c.pair.eigenvalue[1] = integer_from(0);

    /* x = 1/(L - mu); G = (0, -1; mu - L, -x), Y = (-x/(mu - L), 1/(mu - L); -1, 0) */
    eigenvector = integer_divide_floor(integer_shift_left(one, G + 20),
                                       integer_from(difference));
    inverse[0] = integer_shift_floor(integer_mul(eigenvector, eigenvector), 2 * G - 32);
    inverse[1] = inverse_entry(-(INT64_C(1) << 20), difference);
    inverse[2] = integer_from(-(INT64_C(1) << 32));
    inverse[3] = integer_from(0);

    pair = eigenpair_prove(matrix, &c.pair, &c);
    spectrum_prove_size(&pair, &c);
    spectrum_prove_rest(&pair, &record, "block", &c);
}

/* A pair l, conj l of a real block
 * --------------------------------
 *
 * A = S diag((a, -b; b, a), mu) S^-1, S = (v1, v2, v3) = (1 0 1; 2 1 0; 1 1 1): v1 - i v2 belongs to a + i b, and
 * what A does modulo v1 and v2 is mu (all even).  Twice in the complex form. */

static void pair_matrix(struct affine m[36], int a, int b, int mu)
{
    static const int s[3][3] = { { 1, 0, 1 }, { 2, 1, 0 }, { 1, 1, 1 } };
    static const int inverse[3][3] = { { 1, 1, -1 }, { -2, 0, 2 }, { 1, -1, 1 } };  /* twice */
    const int d[3][3] = { { a, -b, 0 }, { b, a, 0 }, { 0, 0, mu } };

    for (int i = 0; i < 36; i++)
        m[i] = affine_from_whole(0, G);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            int sum = 0;

            for (int k = 0; k < 3; k++)
                for (int l = 0; l < 3; l++)
                    sum += s[i][k] * d[k][l] * inverse[l][j];
            m[6 * i + j] = m[6 * (i + 3) + j + 3] = affine_from(thin(sum / 2));
        }
    }
}

/* Is a power of what is left below 1/s = 1/2?  l: a, mu, power: b, radius: how wide beta is, all in units of
 * 2^-20. */
static void run_pair(const struct trial *t)
{
    int a = t->l, b = t->power, mu = t->mu;
    static const int eigenvector[6] = { 1, 2, 1, 0, -1, -1 };
    struct block_record record = { { 0, 0 }, 4, 1 };
    struct certificate c = {
        .file = "certificate", .grid = G, .real = false, .frequency = 0, .n = 3, .size = 6, .valence = { 5, 5 },
        .pair = { .pivot = 1 }
    };
    struct affine unknowns[6], m[36];
    struct eigenpair pair = {
        .matrix = m, .choices = &c.pair, .unknowns = unknowns, .real = affine_from(thin(a)), .imaginary = affine_from(thin(b)),
        .s = spectrum_inverse_upper(thin(1 << 19).lo, G)
    };

    pair.imaginary.c.lo = integer_sub(pair.imaginary.c.lo, thin((int)t->radius).lo);
    for (int i = 0; i < 6; i++)
        unknowns[i] = affine_from_whole(eigenvector[i], G);
    pair_matrix(m, a, b, mu);
    spectrum_prove_rest(&pair, &record, "block", &c);
}

static int status_of(void (*test)(const struct trial *t), const struct trial *t)
{
    int status = 0;
    pid_t child;

    fflush(stdout);
    child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stderr) == NULL)
            _exit(99);
        test(t);
        _exit(0);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

static int failures;

static void run_trials(void (*test)(const struct trial *t), const struct trial *trial, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        int status = status_of(test, &trial[i]);

        if (status == trial[i].expected) {
            printf("PASS %s\n", trial[i].name);
        } else {
            printf("FAIL %s: exit status %d, not %d\n", trial[i].name, status,
                   trial[i].expected);
            failures++;
        }
    }
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
    /* a, mu, b, width; 1/s = 1/2 */
    static const struct trial pair[] = {
        { "pair", HALF, HALF - 2, HALF, 0, 0, GOOD },
        { "pair-equal", HALF, HALF, HALF, 0, 0, BAD },
        { "pair-smaller", HALF, HALF / 2, HALF, 0, 0, GOOD },
        { "pair-negative", HALF, -HALF / 2, -HALF, 0, 0, GOOD },
        { "pair-larger", HALF, HALF + 2048, HALF, 0, 0, BAD },
        { "pair-almost-real", HALF, HALF / 2, 2, 1, 0, GOOD },
        { "pair-maybe-real", HALF, HALF / 2, 2, 2, 0, BAD },
    };

    run_trials(run, trial, sizeof trial / sizeof trial[0]);
    run_trials(run_pair, pair, sizeof pair / sizeof pair[0]);
    return failures == 0 ? 0 : 1;
}
