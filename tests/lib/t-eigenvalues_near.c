/* t-eigenvalues_near.c: discs round eigenvalues that nearly meet.  The matrices are P T P^-1 with P a product of elementary
   matrices of whole numbers and T block triangular, of blocks with the characteristic polynomials

       x - a,   (x - a)^2 - e,   (x - a)^3 - c^3,

   e and c from 1 down to 10^-40: nearly defective, pairs of reals, and pairs so close to the real axis that no double
   could tell.  Every eigenvalue is p + s sqrt(q) or p + i s sqrt(q) with s = 1 or -1 and p, q rational, so
   which disc it lies in is decided exactly. */
#include "lib/eigenvalues.h"

#include <stdlib.h>

#include "common.h"
#include "discs.h"
#include "region.h"

enum { MOST = 9 };

#if defined(NUMBER_INTERVAL)
static const long precisions[] = {53};
#elif defined(NUMBER_BALL)
static const long precisions[] = {53, 128, 400};
#else
static const long precisions[] = {64, 300};
#endif
enum { PRECISIONS = sizeof precisions / sizeof *precisions };

typedef struct {
    rational p, q;
    int sign;
    bool imaginary;
} root;

typedef struct {
    int n;
    rational b[MOST][MOST];
    root roots[MOST];
} subject;

static void subject_init(subject *z)
{
    z->n = 0;
    for (int i = 0; i < MOST; i++) {
        rational_init(&z->roots[i].p), rational_init(&z->roots[i].q);
        for (int j = 0; j < MOST; j++)
            rational_init(&z->b[i][j]);
    }
}

static void subject_clear(subject *z)
{
    for (int i = 0; i < MOST; i++) {
        rational_clear(&z->roots[i].p), rational_clear(&z->roots[i].q);
        for (int j = 0; j < MOST; j++)
            rational_clear(&z->b[i][j]);
    }
}

static void set_root(root *z, const rational *p, const rational *q, int sign, bool imaginary)
{
    MUST(rational_set(&z->p, p));
    MUST(rational_abs(&z->q, q));
    z->sign = sign;
    z->imaginary = imaginary;
}

static void put_single(subject *z, const rational *a)
{
    rational zero;
    rational_init(&zero);
    MUST(rational_set(&z->b[z->n][z->n], a));
    set_root(&z->roots[z->n++], a, &zero, 1, false);
    rational_clear(&zero);
}

/* (a, e; 1, a) */
static void put_pair(subject *z, const rational *a, const rational *e)
{
    int i = z->n;
    put_single(z, a), put_single(z, a);
    MUST(rational_set(&z->b[i][i + 1], e));
    MUST(rational_set_si(&z->b[i + 1][i], 1, 1));
    set_root(&z->roots[i], a, e, 1, rational_sign(e) < 0);
    set_root(&z->roots[i + 1], a, e, -1, rational_sign(e) < 0);
}

/* (a, 1, 0; 0, a, 1; c^3, 0, a): a + c, and a - c/2 +- i sqrt(3 c^2 / 4). */
static void put_triple(subject *z, const rational *a, const rational *c)
{
    int i = z->n;
    rational p, q;
    rational_init(&p), rational_init(&q);
    put_single(z, a), put_single(z, a), put_single(z, a);
    MUST(rational_set_si(&z->b[i][i + 1], 1, 1));
    MUST(rational_set_si(&z->b[i + 1][i + 2], 1, 1));
    MUST(rational_pow(&z->b[i + 2][i], c, 3));
    MUST(rational_add(&p, a, c));
    set_root(&z->roots[i], &p, &q, 1, false);
    MUST(rational_mul_2exp(&p, c, -1) && rational_sub(&p, a, &p));
    MUST(rational_set_si(&q, 3, 4) && rational_mul(&q, &q, c) && rational_mul(&q, &q, c));
    set_root(&z->roots[i + 1], &p, &q, 1, true);
    set_root(&z->roots[i + 2], &p, &q, -1, true);
    rational_clear(&p), rational_clear(&q);
}

/* z += c x */
static void add_multiple(rational *z, const rational *x, long c)
{
    rational t;
    rational_init(&t);
    MUST(rational_set_si(&t, c, 1) && rational_mul(&t, &t, x) && rational_add(z, z, &t));
    rational_clear(&t);
}

/* E z E^-1, E = 1 + c e_to,from. */
static void elementary(subject *z, int to, int from, long c)
{
    for (int j = 0; j < z->n; j++)
        add_multiple(&z->b[to][j], &z->b[from][j], c);
    for (int i = 0; i < z->n; i++)
        add_multiple(&z->b[i][from], &z->b[i][to], -c);
}

static void exchange(subject *z, int p, int q)
{
    for (int j = 0; j < z->n; j++)
        rational_swap(&z->b[p][j], &z->b[q][j]);
    for (int i = 0; i < z->n; i++)
        rational_swap(&z->b[i][p], &z->b[i][q]);
}

/* +- 10^-d (or not that large), often 0. */
static void random_small(rational *z)
{
    MUST(rational_set_si(z, random_range(-3, 3), 1));
    for (long d = random_range(0, 40); d > 0; d--) {
        rational tenth;
        rational_init(&tenth);
        MUST(rational_set_si(&tenth, 1, 10) && rational_mul(z, z, &tenth));
        rational_clear(&tenth);
    }
}

/* Blocks, entries above them (with `coupled`), mixed or just reordered. */
static void random_subject(subject *z, bool coupled, bool mixed)
{
    int wanted = (int)random_range(2, MOST), end[MOST];
    rational a, e;
    rational_init(&a), rational_init(&e);
    while (z->n < wanted) {
        int first = z->n, room = wanted - first, kind = (int)random_below(3);
        MUST(rational_set_si(&a, random_range(-4, 4), random_bool() ? 1 : 3));
        random_small(&e);
        if (kind == 2 && room >= 3)
            put_triple(z, &a, &e);
        else if (kind == 1 && room >= 2)
            put_pair(z, &a, &e);
        else
            put_single(z, &a);
        for (int i = first; i < z->n; i++)
            end[i] = z->n;
    }
    for (int i = 0; coupled && i < z->n; i++)
        for (int j = end[i]; j < z->n; j++)
            MUST(rational_set_si(&z->b[i][j], random_range(-2, 2), 1));
    for (int i = 0; i < 2 * z->n; i++) {
        int p = (int)random_below((uint64_t)z->n), q = (int)random_below((uint64_t)z->n);
        if (p != q && mixed && i < z->n)
            elementary(z, p, q, random_bool() ? 1 : -1);
        else
            exchange(z, p, q);
    }
    rational_clear(&a), rational_clear(&e);
}

/* Is a + s b sqrt(q) <= 0, q >= 0? */
static bool is_at_most_zero(const rational *a, const rational *b, int s, const rational *q)
{
    int sign_a = rational_sign(a), sign_b = rational_is_zero(q) ? 0 : s * rational_sign(b), order;
    rational x, y;
    if (sign_a <= 0 && sign_b <= 0)
        return true;
    if (sign_a >= 0 && sign_b >= 0)
        return false;
    rational_init(&x), rational_init(&y);
    MUST(rational_mul(&x, a, a));
    MUST(rational_mul(&y, b, b) && rational_mul(&y, &y, q));
    order = rational_cmp(&x, &y);
    rational_clear(&x), rational_clear(&y);
    return sign_a < 0 ? order >= 0 : order <= 0;
}

/* With x + i y = p - centre: |t - centre|^2 - radius^2 = x^2 + y^2 + q - radius^2 + 2 s sqrt(q) (x or y). */
static bool contains(const exact_disc *d, const root *t)
{
    rational sum, square, x, y;
    bool inside;
    rational_init(&sum), rational_init(&square), rational_init(&x), rational_init(&y);
    MUST(rational_sub(&x, &t->p, &d->re) && rational_neg(&y, &d->im));
    MUST(rational_mul(&sum, &x, &x));
    MUST(rational_mul(&square, &y, &y) && rational_add(&sum, &sum, &square));
    MUST(rational_mul(&square, &d->radius, &d->radius) && rational_sub(&sum, &sum, &square));
    MUST(rational_add(&sum, &sum, &t->q));
    MUST(rational_mul_2exp(&x, t->imaginary ? &y : &x, 1));
    inside = is_at_most_zero(&sum, &x, t->sign, &t->q);
    rational_clear(&sum), rational_clear(&square), rational_clear(&x), rational_clear(&y);
    return inside;
}

static void check_discs(const subject *z, const eigenvalues *found, const char *what)
{
    exact_disc d[MOST];
    int total = 0;
    for (int i = 0; i < found->count; i++) {
        const eigenvalue_disc *e = &found->disc[i];
        int inside = 0;
        exact_disc_make(&d[i], e);
        for (int j = 0; j < z->n; j++)
            if (contains(&d[i], &z->roots[j])) {
                inside++;
                CHECK(!e->real || !z->roots[j].imaginary || rational_is_zero(&z->roots[j].q), "%s: eigenvalue %d is said to be real", what, j);
            }
        CHECK(inside == e->count, "%s: disc %d of %d (%.17g + %.17g i, radius %.3g) has %d eigenvalues, not %d", what, i, found->count, number_mid_approx(&e->re), number_mid_approx(&e->im),
              number_mid_approx(&e->radius), inside, e->count);
        for (int j = 0; j < i; j++)
            CHECK(are_disjoint(&d[i], &d[j]), "%s: the discs %d and %d meet", what, j, i);
        total += e->count;
    }
    CHECK(total == z->n, "%s: %d of %d eigenvalues", what, total, z->n);
    for (int i = 0; i < found->count; i++)
        exact_disc_clear(&d[i]);
}

static void check_subject(const subject *z)
{
    int n = z->n;
    number *b = number_array_new((size_t)(n * n));
    for (int i = 0; i < PRECISIONS; i++) {
        char name[60];
        eigenvalues found;
        truth answer;
        snprintf(name, sizeof name, "n = %d, precision %ld", n, precisions[i]);
        for (int j = 0; j < n * n; j++)
            number_set_rational(&b[j], &z->b[j / n][j % n], precisions[i]);
        answer = eigenvalues_enclose(&found, b, NULL, n, precisions[i]);
        CHECK(answer != TRUTH_FALSE, "%s: no memory", name);
        if (answer == TRUTH_TRUE)
            check_discs(z, &found, name);
        eigenvalues_free(&found);
    }
    number_array_free(b, (size_t)(n * n));
}

static void test_random(void)
{
    static const char *const names[2][2] = {{"eigenvalues-near-blocks", "eigenvalues-near-mixed"}, {"eigenvalues-near-coupled", "eigenvalues-near-all"}};
    for (int coupled = 0; coupled < 2; coupled++)
        for (int mixed = 0; mixed < 2; mixed++) {
            test_begin(names[coupled][mixed]);
            for (test_cases(PRECISIONS > 1 ? 25 : 150); test_next();) {
                subject z;
                subject_init(&z);
                random_subject(&z, coupled, mixed);
                check_subject(&z);
                subject_clear(&z);
            }
            test_end();
        }
}

/* 1 +- 10^-30 and 1 +- i 10^-30 look alike: nothing may be said but that there are two. */
static void test_alike(void)
{
    test_begin("eigenvalues-near-alike");
    for (int sign = -1; sign <= 1; sign += 2)
        for (int i = 0; i < PRECISIONS; i++) {
            subject z;
            rational a, e;
            number b[4];
            eigenvalues found;
            subject_init(&z);
            rational_init(&a), rational_init(&e);
            MUST(rational_set_si(&a, 1, 1));
            MUST(rational_set_decimal(&e, sign < 0 ? "-1e-60" : "1e-60", sign < 0 ? 6 : 5) == RATIONAL_TEXT_OK);
            put_pair(&z, &a, &e);
            for (int j = 0; j < 4; j++) {
                number_init(&b[j]);
                number_set_rational(&b[j], &z.b[j / 2][j % 2], precisions[i]);
            }
            CHECK(eigenvalues_enclose(&found, b, NULL, 2, precisions[i]) == TRUTH_TRUE, "precision %ld: nothing found", precisions[i]);
            check_discs(&z, &found, "a pair");
            CHECK(found.count == 1 && !found.disc[0].real && number_upper_bound(&found.disc[0].radius) < 1e-6, "precision %ld: %d discs", precisions[i], found.count);
            eigenvalues_free(&found);
            for (int j = 0; j < 4; j++)
                number_clear(&b[j]);
            subject_clear(&z);
            rational_clear(&a), rational_clear(&e);
        }
    test_end();
}

static void tests(void)
{
    test_random();
    test_alike();
}

MAIN(tests);
