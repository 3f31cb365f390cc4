/* interval.c: the parts of hardware intervals that are not hot, and the start-up test. */
#include "interval.h"

/* ---- products with infinite endpoints ---- */

/* The product of endpoints of sets of real numbers: 0 times "no bound" is 0. */
static double bound_product(double u, double v) { return u == 0 || v == 0 ? 0 : u * v; }

/* As interval_mul, each product by bound_product.  A finite product may overflow: +infinity is "no bound", and
   rounded upward nothing becomes -infinity unless a factor is infinite, when the other products settle it. */
void interval_mul_unbounded_(interval *z, const interval *x, const interval *y)
{
    double a = x->neg_lower, b = x->upper, c = y->neg_lower, d = y->upper;
    double upper = interval_max_(interval_max_(bound_product(a, c), bound_product(b, d)),
                                 interval_max_(bound_product(-a, d), bound_product(-b, c)));
    double neg_lower = interval_max_(interval_max_(bound_product(-a, c), bound_product(-b, d)),
                                     interval_max_(bound_product(a, d), bound_product(b, c)));
    *z = interval_make_(neg_lower, upper);
}

/* In steps of powers of two that are doubles; each step rounds upward. */
void interval_mul_2exp_far_(interval *z, const interval *x, long e)
{
    e = e > 3000 ? 3000 : e < -3000 ? -3000 : e;
    *z = *x;
    while (e != 0) {
        long step = e > 1000 ? 1000 : e < -1000 ? -1000 : e;
        double p = interval_power_of_two_(step);
        *z = interval_make_(bound_product(z->neg_lower, p), bound_product(z->upper, p));
        e -= step;
    }
}

/* ---- conversions ---- */

void interval_set_doubles(interval *z, double lower, double upper)
{
    if (lower <= upper && lower < HUGE_VAL && upper > -HUGE_VAL)
        *z = interval_make_(-lower, upper);
    else
        interval_indeterminate(z);
}

void interval_set_double(interval *z, double v, long prec)
{
    (void)prec;
    interval_thin_(z, v);
}

void interval_set_ball(interval *z, const ball *x, long prec)
{
    (void)prec;
    *z = interval_make_(-ball_lower_bound(x), ball_upper_bound(x));
}

void ball_set_interval(ball *z, const interval *x, long prec)
{
    if (!interval_is_finite(x)) {
        ball_indeterminate(z);
        return;
    }
    ball lower, upper;
    ball_init(&lower);
    ball_init(&upper);
    ball_set_double(&lower, -x->neg_lower, 64);
    ball_set_double(&upper, x->upper, 64);
    ball_hull(z, &lower, &upper, prec);
    ball_clear(&lower);
    ball_clear(&upper);
}

/* z = the interval around the ball t, which is cleared. */
static void take_ball(interval *z, ball *t)
{
    interval_set_ball(z, t, 0);
    ball_clear(t);
}

void interval_set_large_si_(interval *z, long v)
{
    ball t;
    ball_init(&t);
    ball_set_si(&t, v, 64);
    take_ball(z, &t);
}

void interval_set_integer_2exp(interval *z, const integer *m, long e, long prec)
{
    (void)prec;
    ball t;
    ball_init(&t);
    ball_set_integer_2exp(&t, m, e, BALL_MAX_PRECISION);
    take_ball(z, &t);
}

/* With a quotient n = floor(q 2^s) of at least 64 bits and q 2^s not an integer, the doubles next to q are
   those at or below n and at or above n + 1: no double lies strictly between n and n + 1. */
void interval_set_rational(interval *z, const rational *q, long prec)
{
    (void)prec;
    integer n, r;
    integer_init(&n);
    integer_init(&r);
    long s = 66 + (long)integer_bits(&q->denominator) - (long)integer_bits(&q->numerator);
    s = s < 0 ? 0 : s;
    bool ok = integer_mul_2exp(&n, &q->numerator, (unsigned long)s) && integer_fdiv_qr(&n, &r, &n, &q->denominator);
    interval above;
    interval_set_integer_2exp(z, &n, -s, 0);
    ok = ok && (integer_is_zero(&r) || integer_add_si(&n, &n, 1));
    interval_set_integer_2exp(&above, &n, -s, 0);
    z->upper = above.upper;
    if (!ok)
        interval_indeterminate(z);
    integer_clear(&n);
    integer_clear(&r);
}

#define ENOUGH_BITS 100 /* the endpoints are then almost always the nearest doubles outward */

void interval_pi(interval *z, long prec)
{
    (void)prec;
    ball t;
    ball_init(&t);
    ball_pi(&t, ENOUGH_BITS);
    take_ball(z, &t);
}

/* Sines and cosines are in [-1, 1], whatever their enclosures. */
static void take_sine(interval *z, ball *t)
{
    take_ball(z, t);
    z->neg_lower = interval_min_(z->neg_lower, 1);
    z->upper = interval_min_(z->upper, 1);
}

void interval_cos_pi(interval *z, const rational *r, long prec)
{
    (void)prec;
    ball t;
    ball_init(&t);
    ball_cos_pi(&t, r, ENOUGH_BITS);
    take_sine(z, &t);
}

void interval_sin_pi(interval *z, const rational *r, long prec)
{
    (void)prec;
    ball t;
    ball_init(&t);
    ball_sin_pi(&t, r, ENOUGH_BITS);
    take_sine(z, &t);
}

/* ---- exact questions ---- */

/* Is v <= q (order < 0), or v >= q (order > 0)?  Infinite v are bounds that always hold. */
static bool bounds(double v, int order, const rational *q)
{
    if (v >= HUGE_VAL || v <= -HUGE_VAL)
        return true;
    rational t;
    rational_init(&t);
    bool ok = rational_set_double(&t, v);
    int c = ok ? rational_cmp(&t, q) : 0;
    rational_clear(&t);
    return ok && (order < 0 ? c <= 0 : c >= 0);
}

bool interval_contains_rational(const interval *x, const rational *q)
{
    return bounds(-x->neg_lower, -1, q) && bounds(x->upper, 1, q);
}

static bool double_grid(integer *m, double v, long g, bool up)
{
    ball t;
    ball_init(&t);
    ball_set_double(&t, v, 64);
    bool ok = up ? ball_upper_grid(m, &t, g) : ball_lower_grid(m, &t, g);
    ball_clear(&t);
    return ok;
}

bool interval_lower_grid(integer *m, const interval *x, long g) { return double_grid(m, -x->neg_lower, g, false); }
bool interval_upper_grid(integer *m, const interval *x, long g) { return double_grid(m, x->upper, g, true); }

bool interval_mid_grid(integer *m, const interval *x, long g)
{
    ball t;
    ball_init(&t);
    ball_set_double(&t, interval_center_(x), 64);
    bool ok = ball_mid_grid(m, &t, g);
    ball_clear(&t);
    return ok;
}

char *interval_get_decimal(const interval *x, int digits)
{
    ball t;
    ball_init(&t);
    ball_set_interval(&t, x, 64);
    char *text = ball_get_decimal(&t, digits);
    ball_clear(&t);
    return text;
}
