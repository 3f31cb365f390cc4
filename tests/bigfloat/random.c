/* random.c: see random.h. */
#include "random.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define MOST_LIMBS 400

void random_integer(integer *z, size_t max_limbs)
{
    uint64_t limb[MOST_LIMBS];
    size_t n = (size_t)random_below(max_limbs + 1);
    random_limbs(limb, n);
    MUST(integer_set_limbs(z, limb, n, random_bool()));
}

void random_nonzero_integer(integer *z, size_t max_limbs)
{
    do
        random_integer(z, max_limbs);
    while (integer_is_zero(z));
}

void random_rational(rational *z, size_t max_limbs)
{
    integer p, q;
    integer_init(&p);
    integer_init(&q);
    random_integer(&p, max_limbs);
    random_nonzero_integer(&q, max_limbs);
    MUST(rational_set_integers(z, &p, &q));
    integer_clear(&p);
    integer_clear(&q);
}

static uint64_t random_error(void)
{
    switch (random_below(4)) {
    case 0: return 0;
    case 1: return random_below(4);
    case 2: return ((uint64_t)1 << BALL_ERROR_BITS) - 1 - random_below(3);
    default: return random_word() >> (64 - BALL_ERROR_BITS + random_below(BALL_ERROR_BITS));
    }
}

void random_ball(ball *z, size_t max_limbs)
{
    integer m;
    integer_init(&m);
    random_integer(&m, max_limbs);
    long e = random_below(4) ? random_range(-100, 100) : random_range(-700, 700);
    ball_set_parts(z, &m, random_error(), e);
    integer_clear(&m);
}

/* q = a + (b - a) t with t = 0, 1, 1/2, or random in [0, 1] */
static void between(rational *q, const rational *a, const rational *b)
{
    rational t, d;
    rational_init(&t);
    rational_init(&d);
    uint64_t k = random_below(5);
    if (k < 3)
        MUST(rational_set_si(&t, (int64_t)k, 2));
    else
        MUST(rational_set_si(&t, (int64_t)random_below(1001), 1000));
    MUST(rational_sub(&d, b, a));
    MUST(rational_mul(&t, &t, &d));
    MUST(rational_add(q, a, &t));
    rational_clear(&t);
    rational_clear(&d);
}

void random_point_ball(rational *q, const ball *x)
{
    integer m, err;
    int64_t e;
    uint64_t r;
    integer_init(&m);
    integer_init(&err);
    rational a, b;
    rational_init(&a);
    rational_init(&b);
    MUST(ball_get_parts(&m, &r, &e, x));
    integer_set_ui(&err, r);
    integer t;
    integer_init(&t);
    MUST(integer_sub(&t, &m, &err));
    MUST(rational_set_integer_2exp(&a, &t, (long)e));
    MUST(integer_add(&t, &m, &err));
    MUST(rational_set_integer_2exp(&b, &t, (long)e));
    between(q, &a, &b);
    integer_clear(&t);
    integer_clear(&m);
    integer_clear(&err);
    rational_clear(&a);
    rational_clear(&b);
}

void random_point_grid(rational *q, const grid *x)
{
    rational a, b;
    rational_init(&a);
    rational_init(&b);
    MUST(rational_set_integer_2exp(&a, &x->lower, -(long)x->exponent));
    MUST(rational_set_integer_2exp(&b, &x->upper, -(long)x->exponent));
    between(q, &a, &b);
    rational_clear(&a);
    rational_clear(&b);
}

/* Unbounded sides are replaced by the largest double. */
void random_point_interval(rational *q, const interval *x)
{
    rational a, b;
    rational_init(&a);
    rational_init(&b);
    MUST(rational_set_double(&a, fmax(-x->neg_lower, -DBL_MAX)));
    MUST(rational_set_double(&b, fmin(x->upper, DBL_MAX)));
    between(q, &a, &b);
    rational_clear(&a);
    rational_clear(&b);
}

double random_double(void)
{
    static const double corner[] = {0, 1, 0.5, 3, DBL_MIN, DBL_MAX, DBL_EPSILON, 0x1p-1074, 1 + DBL_EPSILON, 1e300, 1e-300};
    double v;
    uint64_t w = random_word();
    switch (random_below(4)) {
    case 0: v = corner[random_below(sizeof corner / sizeof *corner)]; break;
    case 1: v = ldexp((double)(w >> 11), (int)random_range(-60, -50)); break;
    case 2: v = ldexp((double)(w >> 11), (int)random_range(-1130, 970)); break;
    default: v = (double)random_range(-10, 10);
    }
    return random_bool() ? -v : v;
}

void random_interval(interval *z)
{
    double a = random_double(), b = random_below(3) ? random_double() : a;
    switch (random_below(12)) {
    case 0: a = -HUGE_VAL; break;
    case 1: b = HUGE_VAL; break;
    case 2: a = 0; break;
    case 3: b = 0; break;
    }
    if (a <= b)
        interval_set_doubles(z, a, b);
    else
        interval_set_doubles(z, b, a);
    if (z->neg_lower == HUGE_VAL && z->upper == -HUGE_VAL)
        interval_zero(z);
}

void random_grid(grid *z, size_t max_limbs, long g)
{
    integer a, b;
    integer_init(&a);
    integer_init(&b);
    random_integer(&a, max_limbs);
    random_integer(&b, max_limbs);
    if (random_below(3) == 0) {
        integer_set_si(&b, random_range(0, 3));
        MUST(integer_add(&b, &b, &a));
    }
    if (integer_cmp(&a, &b) > 0)
        integer_swap(&a, &b);
    grid_set_endpoints(z, &a, &b, g);
    integer_clear(&a);
    integer_clear(&b);
}

long random_precision(long most) { return random_bool() ? 64 * random_range(1, most / 64) : random_range(2, most); }
