/* t-eigenvalues.c: discs round the eigenvalues of matrices that are built from their eigenvalues: P D P^-1 with whole
   numbers, D of Jordan blocks and rotations, P of determinant 1.  What is in which disc is decided in rationals. */
#include "lib/eigenvalues.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "discs.h"
#include "region.h"

enum { MOST = 12 };

#if defined(NUMBER_INTERVAL)
static const long precisions[] = {53};
#elif defined(NUMBER_BALL)
static const long precisions[] = {53, 64, 256};
#else
static const long precisions[] = {64, 256};
#endif
enum { PRECISIONS = sizeof precisions / sizeof *precisions };

/* (re + i im) / denominator, and the eigenvalues in the same unit. */
typedef struct {
    int n;
    bool is_complex;
    long re[MOST][MOST], im[MOST][MOST];
    long p[MOST], q[MOST]; /* eigenvalues p + i q, each as often as its multiplicity */
    int block;             /* of the largest Jordan block */
    long denominator;
} subject;

/* Puts a Jordan block of the size given at (i,i), of p + i q; in a real matrix q = 0. */
static void put_jordan(subject *z, int i, int size, long p, long q)
{
    for (int j = i; j < i + size; j++) {
        z->re[j][j] = z->p[j] = p;
        z->im[j][j] = z->q[j] = q;
        if (j + 1 < i + size)
            z->re[j][j + 1] = 1;
    }
    z->block = size > z->block ? size : z->block;
}

/* The same of a pair p +- i q of a real matrix, in 2 size rows. */
static void put_pair(subject *z, int i, int size, long p, long q)
{
    for (int j = i; j < i + 2 * size; j += 2) {
        z->re[j][j] = z->re[j + 1][j + 1] = z->p[j] = z->p[j + 1] = p;
        z->re[j][j + 1] = -q, z->re[j + 1][j] = q;
        z->q[j] = q, z->q[j + 1] = -q;
        if (j + 2 < i + 2 * size)
            z->re[j][j + 2] = z->re[j + 1][j + 3] = 1;
    }
    z->block = size > z->block ? size : z->block;
}

/* E z E^-1, E = 1 + c e_to,from. */
static void elementary(subject *z, int to, int from, long c)
{
    for (int j = 0; j < z->n; j++) {
        z->re[to][j] += c * z->re[from][j];
        z->im[to][j] += c * z->im[from][j];
    }
    for (int i = 0; i < z->n; i++) {
        z->re[i][from] -= c * z->re[i][to];
        z->im[i][from] -= c * z->im[i][to];
    }
}

static void mix(subject *z, int steps)
{
    for (; steps > 0 && z->n > 1; steps--) {
        int to = (int)random_below((uint64_t)z->n), from = (int)random_below((uint64_t)z->n);
        if (to != from)
            elementary(z, to, from, random_bool() ? 1 : -1);
    }
}

/* Blocks of sizes up to `largest`; eigenvalues may meet by chance, or on purpose. */
static void random_subject(subject *z, bool is_complex, int largest)
{
    static const long denominators[] = {1, 16, 97, 1000};
    *z = (subject){.n = (int)random_range(1, MOST), .is_complex = is_complex, .denominator = denominators[random_below(4)]};
    for (int i = 0; i < z->n;) {
        int size = (int)random_range(1, largest), room = z->n - i;
        long p = random_range(-12, 12), q = random_range(1, 12);
        if (i > 0 && random_below(5) == 0)
            p = z->p[i - 1], q = z->q[i - 1] ? labs(z->q[i - 1]) : q; /* once more */
        size = size > room ? room : size;
        if (!is_complex && 2 * size <= room && random_below(3) == 0) {
            put_pair(z, i, size, p, q);
            i += 2 * size;
        } else {
            put_jordan(z, i, size, p, is_complex ? random_range(-1, 1) * q : 0);
            i += size;
        }
    }
    mix(z, random_bool() ? z->n : 2 * z->n);
}

/* Enclosures of the parts; if `wide`, not round the numbers themselves. */
static number *numbers_of(const subject *z, bool imaginary, bool wide, long prec)
{
    number *b = number_array_new((size_t)(z->n * z->n));
    number error;
    rational q;
    rational_init(&q);
    number_init(&error);
    for (int i = 0; i < z->n; i++)
        for (int j = 0; j < z->n; j++) {
            number *x = &b[i * z->n + j];
            MUST(rational_set_si(&q, imaginary ? z->im[i][j] : z->re[i][j], z->denominator));
            number_set_rational(x, &q, prec);
            if (wide) {
                double e = ldexp(random_unit(), -30);
                number_set_double(&error, e, prec);
                number_add(&error, x, &error, prec);
                number_hull(x, x, &error, prec);
            }
        }
    number_clear(&error);
    rational_clear(&q);
    return b;
}

static bool contains(const exact_disc *d, long p, long q, long denominator)
{
    rational x, y;
    int sign;
    rational_init(&x), rational_init(&y);
    MUST(rational_set_si(&x, p, denominator));
    MUST(rational_set_si(&y, q, denominator));
    MUST(rational_sub(&x, &x, &d->re));
    MUST(rational_sub(&y, &y, &d->im));
    sign = compare_modulus(&x, &y, &d->radius);
    rational_clear(&x), rational_clear(&y);
    return sign <= 0;
}

/* Everything that the header promises. */
static void check_discs(const subject *z, const eigenvalues *found, const char *what)
{
    exact_disc d[MOST];
    int total = 0;
    CHECK(found->count >= 1 && found->count <= z->n, "%s: %d discs", what, found->count);
    if (test_failed())
        return;
    for (int i = 0; i < found->count; i++) {
        int inside = 0;
        const eigenvalue_disc *e = &found->disc[i];
        exact_disc_make(&d[i], e);
        CHECK(rational_sign(&d[i].radius) >= 0, "%s: a negative radius", what);
        for (int j = 0; j < z->n; j++)
            if (contains(&d[i], z->p[j], z->q[j], z->denominator)) {
                inside++;
                CHECK(!e->real || z->q[j] == 0, "%s: (%ld + %ld i)/%ld is said to be real", what, z->p[j], z->q[j], z->denominator);
            }
        CHECK(inside == e->count, "%s: disc %d (%.17g + %.17g i, radius %.3g) has %d eigenvalues, not %d", what, i, number_mid_approx(&e->re), number_mid_approx(&e->im),
              number_mid_approx(&e->radius), inside, e->count);
        CHECK(!e->real || ((e->count == 1 || rational_sign(&d[i].radius) == 0) && !z->is_complex), "%s: real", what);
        CHECK(i == 0 || e->modulus <= found->disc[i - 1].modulus, "%s: the order", what);
        CHECK(fabs(e->modulus - hypot(number_mid_approx(&e->re), number_mid_approx(&e->im))) <= 1e-9 * (1 + e->modulus), "%s: modulus", what);
        total += e->count;
        for (int j = 0; j < i; j++)
            CHECK(are_disjoint(&d[i], &d[j]), "%s: the discs %d and %d meet", what, j, i);
    }
    CHECK(total == z->n, "%s: %d of %d eigenvalues", what, total, z->n);
    for (int i = 0; i < found->count; i++)
        exact_disc_clear(&d[i]);
}

static truth enclose(eigenvalues *found, const subject *z, bool wide, long prec)
{
    number *re = numbers_of(z, false, wide, prec), *im = z->is_complex ? numbers_of(z, true, wide, prec) : NULL;
    truth answer = eigenvalues_enclose(found, re, im, z->n, prec);
    number_array_free(re, (size_t)(z->n * z->n));
    if (im)
        number_array_free(im, (size_t)(z->n * z->n));
    return answer;
}

static void check_subject(const subject *z, bool wide, const char *what)
{
    for (int i = 0; i < PRECISIONS; i++) {
        char name[100];
        eigenvalues found;
        snprintf(name, sizeof name, "%s, n = %d, precision %ld", what, z->n, precisions[i]);
        truth answer = enclose(&found, z, wide, precisions[i]);
        CHECK(answer != TRUTH_FALSE, "%s: no memory", name);
        CHECK(answer == TRUTH_TRUE || wide, "%s: nothing is found", name);
        if (answer == TRUTH_TRUE)
            check_discs(z, &found, name);
        eigenvalues_free(&found);
    }
}

static void test_random(void)
{
    static const char *const names[2][2] = {{"eigenvalues-real", "eigenvalues-real-jordan"}, {"eigenvalues-complex", "eigenvalues-complex-jordan"}};
    for (int is_complex = 0; is_complex < 2; is_complex++)
        for (int jordan = 0; jordan < 2; jordan++) {
            test_begin(names[is_complex][jordan]);
            for (test_cases(PRECISIONS > 1 ? 12 : 60); test_next();) {
                subject z;
                random_subject(&z, is_complex, jordan ? 4 : 1);
                check_subject(&z, false, "thin");
                check_subject(&z, true, "wide");
            }
            test_end();
        }
}

/* ---- quality ---- */

/* How often each eigenvalue occurs. */
static int multiplicity(const subject *z, int i)
{
    int n = 0;
    for (int j = 0; j < z->n; j++)
        n += z->p[j] == z->p[i] && z->q[j] == z->q[i];
    return n;
}

/* Matrices that are nearly normal: few steps away from their diagonal.  One disc for each different eigenvalue, about as
   small as the precision allows; real ones are known to be real; Jordan blocks of size s lose all but 1/s of the digits. */
static void test_tight(void)
{
    test_begin("eigenvalues-tight");
    for (test_cases(PRECISIONS > 1 ? 12 : 60); test_next();) {
        subject z = {.n = (int)random_range(1, MOST), .is_complex = random_below(3) == 0, .denominator = random_bool() ? 1 : 97};
        for (int i = 0; i < z.n; i++) {
            bool again = true;
            while (again) {
                long p = random_range(-9, 9), q = z.is_complex ? random_range(-9, 9) : i + 1 < z.n && random_below(3) == 0 ? random_range(1, 9) : 0;
                again = false;
                for (int j = 0; j < i; j++)
                    again = again || (z.p[j] == p && labs(z.q[j]) == labs(q));
                if (again)
                    continue;
                if (!z.is_complex && q)
                    put_pair(&z, i++, 1, p, q);
                else
                    put_jordan(&z, i, 1, p, q);
            }
        }
        mix(&z, (int)random_below(3));
        for (int i = 0; i < PRECISIONS; i++) {
            eigenvalues found;
            long prec = precisions[i];
            double tolerance = ldexp(1, -(int)prec + 20);
            CHECK(enclose(&found, &z, false, prec) == TRUTH_TRUE, "nothing found");
            check_discs(&z, &found, "tight");
            CHECK(found.count == z.n, "precision %ld: %d discs for %d eigenvalues", prec, found.count, z.n);
            for (int j = 0; j < found.count && !test_failed(); j++) {
                const eigenvalue_disc *e = &found.disc[j];
                CHECK(number_upper_bound(&e->radius) < tolerance, "n = %d, precision %ld: radius %.3g", z.n, prec, number_upper_bound(&e->radius));
                bool real = !z.is_complex && fabs(number_mid_approx(&e->im)) < 0.001;
                CHECK(e->real == real, "precision %ld: %.3g + %.3g i is%s real", prec, number_mid_approx(&e->re), number_mid_approx(&e->im), e->real ? "" : " not known to be");
            }
            eigenvalues_free(&found);
        }
    }
    test_end();
    test_begin("eigenvalues-tight-jordan");
    for (int size = 1; size <= 4; size++)
        for (int i = 0; i < PRECISIONS; i++) {
            subject z = {.n = size + 3, .denominator = 16};
            eigenvalues found;
            put_jordan(&z, 0, size, 5, 0);
            put_jordan(&z, size, 1, -3, 0);
            put_pair(&z, size + 1, 1, 1, 2);
            for (int j = 1; j < z.n; j++)
                elementary(&z, j, j - 1, 1);
            CHECK(enclose(&found, &z, false, precisions[i]) == TRUTH_TRUE, "nothing found");
            check_discs(&z, &found, "jordan");
            CHECK(found.count == 4 && found.disc[0].count == size && multiplicity(&z, 0) == size, "size %d: %d discs", size, found.count);
            /* doubles find the Schur vectors, so the triangle is only as good as they are: about 2^-50 below the diagonal */
            for (int j = 0; j < found.count; j++) {
                double limit = j ? ldexp(1, -(int)(precisions[i] < 64 ? precisions[i] : 64) + 24) : ldexp(64, -40 / size);
                CHECK(number_upper_bound(&found.disc[j].radius) < limit, "size %d, precision %ld, disc %d: radius %.3g", size, precisions[i], j, number_upper_bound(&found.disc[j].radius));
            }
            eigenvalues_free(&found);
        }
    test_end();
}

/* ---- corners ---- */

static void test_corners(void)
{
    test_begin("eigenvalues-corners");
    for (int n = 1; n <= MOST; n++) { /* multiples of the identity, and 0 */
        subject z = {.n = n, .denominator = 3};
        check_subject(&z, false, "zero");
        put_jordan(&z, 0, 1, 2, 0);
        for (int i = 1; i < n; i++)
            put_jordan(&z, i, 1, 2, 0);
        check_subject(&z, false, "identity");
        check_subject(&z, true, "identity");
    }
    { /* nilpotent */
        subject z = {.n = 4, .denominator = 1};
        put_jordan(&z, 0, 4, 0, 0);
        check_subject(&z, false, "nilpotent");
        mix(&z, 6);
        check_subject(&z, false, "nilpotent");
    }
    { /* a pair so close to the axis that an interval cannot tell: (500 +- i)/1000, and a pair of reals as close */
        subject z = {.n = 2, .denominator = 1000000};
        put_pair(&z, 0, 1, 500000, 1);
        check_subject(&z, false, "nearly real");
        check_subject(&z, true, "nearly real");
        z = (subject){.n = 2, .denominator = 1000000};
        put_jordan(&z, 0, 1, 500000, 0);
        put_jordan(&z, 1, 1, 500001, 0);
        elementary(&z, 0, 1, 1);
        check_subject(&z, false, "nearly double");
        check_subject(&z, true, "nearly double");
    }
    for (int e = -200; e <= 200; e += 100) { /* another unit */
        subject z = {.n = 5, .denominator = 1};
        eigenvalues plain, scaled;
        put_jordan(&z, 0, 2, 3, 0), put_jordan(&z, 2, 1, -2, 0), put_pair(&z, 3, 1, 1, 1);
        for (int j = 1; j < z.n; j++)
            elementary(&z, j, j - 1, 1);
#if !defined(NUMBER_GRID)
        long prec = precisions[0];
        number *b = numbers_of(&z, false, false, prec);
        CHECK(eigenvalues_enclose(&plain, b, NULL, z.n, prec) == TRUTH_TRUE, "plain");
        for (int i = 0; i < z.n * z.n; i++)
            number_mul_2exp(&b[i], &b[i], e, prec);
        CHECK(eigenvalues_enclose(&scaled, b, NULL, z.n, prec) == TRUTH_TRUE && scaled.count == plain.count, "2^%d", e);
        for (int i = 0; i < scaled.count && !test_failed(); i++) {
            eigenvalue_disc *d = &scaled.disc[i];
            number_mul_2exp(&d->re, &d->re, -e, prec);
            number_mul_2exp(&d->im, &d->im, -e, prec);
            number_mul_2exp(&d->radius, &d->radius, -e, prec);
            d->modulus = ldexp(d->modulus, -e);
        }
        check_discs(&z, &scaled, "another unit");
        number_array_free(b, (size_t)(z.n * z.n));
        eigenvalues_free(&scaled), eigenvalues_free(&plain);
#else
        (void)plain, (void)scaled;
#endif
    }
    { /* no enclosure of what may be anything */
        subject z = {.n = 3, .denominator = 1};
        eigenvalues found;
        put_jordan(&z, 0, 1, 1, 0), put_jordan(&z, 1, 1, 2, 0), put_jordan(&z, 2, 1, 3, 0);
        number *b = numbers_of(&z, false, false, 64);
        number_indeterminate(&b[4]);
        CHECK(eigenvalues_enclose(&found, b, NULL, 3, 64) == TRUTH_UNKNOWN, "indeterminate");
        number_array_free(b, 9);
        eigenvalues_free(&found);
    }
    test_end();
}

static void tests(void)
{
    test_random();
    test_tight();
    test_corners();
}
MAIN(tests);
