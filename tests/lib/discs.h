/* discs.h: discs round eigenvalues, in rationals, for tests that decide exactly what is in them. */
#ifndef TESTS_LIB_DISCS_H
#define TESTS_LIB_DISCS_H

#include "lib/eigenvalues.h"
#include "tests/harness.h"

/* z = the thin number x. */
static inline void exact(rational *z, const number *x)
{
    ball b;
    integer m;
    int64_t e;
    ball_init(&b);
    integer_init(&m);
    CHECK(number_is_thin(x), "a centre or radius that is not thin");
    number_get_ball(&b, x, 4000);
    CHECK(ball_is_thin(&b), "the test itself");
    MUST(ball_get_parts(&m, NULL, &e, &b));
    MUST(rational_set_integer_2exp(z, &m, (long)e));
    ball_clear(&b);
    integer_clear(&m);
}

typedef struct {
    rational re, im, radius;
} exact_disc;

static inline void exact_disc_make(exact_disc *z, const eigenvalue_disc *d)
{
    rational_init(&z->re), rational_init(&z->im), rational_init(&z->radius);
    exact(&z->re, &d->re), exact(&z->im, &d->im), exact(&z->radius, &d->radius);
}

static inline void exact_disc_clear(exact_disc *z)
{
    rational_clear(&z->re), rational_clear(&z->im), rational_clear(&z->radius);
}

/* The sign of |x + i y|^2 - r^2. */
static inline int compare_modulus(const rational *x, const rational *y, const rational *r)
{
    rational s, t;
    int sign;
    rational_init(&s), rational_init(&t);
    MUST(rational_mul(&s, x, x));
    MUST(rational_mul(&t, y, y));
    MUST(rational_add(&s, &s, &t));
    MUST(rational_mul(&t, r, r));
    sign = rational_cmp(&s, &t);
    rational_clear(&s), rational_clear(&t);
    return sign;
}

static inline bool are_disjoint(const exact_disc *d, const exact_disc *e)
{
    rational x, y, r;
    int sign;
    rational_init(&x), rational_init(&y), rational_init(&r);
    MUST(rational_sub(&x, &d->re, &e->re));
    MUST(rational_sub(&y, &d->im, &e->im));
    MUST(rational_add(&r, &d->radius, &e->radius));
    sign = compare_modulus(&x, &y, &r);
    rational_clear(&x), rational_clear(&y), rational_clear(&r);
    return sign > 0;
}

#endif
