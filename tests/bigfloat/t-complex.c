/* t-complex.c: complex balls contain exact complex results; jets contain exact derivatives. */
#define NUMBER_BALL
#include "bigfloat/ball_internal.h"
#include "bigfloat/complex_ball.h"
#include "bigfloat/jet.h"

#include "random.h"

typedef struct {
    rational re, im;
} point;

static void point_init(point *p) { rational_init(&p->re), rational_init(&p->im); }
static void point_clear(point *p) { rational_clear(&p->re), rational_clear(&p->im); }

static void random_complex(complex_ball *z, point *p)
{
    random_ball(&z->re, 4), random_ball(&z->im, 4);
    if (random_below(5) == 0)
        ball_zero(random_bool() ? &z->re : &z->im);
    random_point_ball(&p->re, &z->re), random_point_ball(&p->im, &z->im);
}

static bool holds(const complex_ball *z, const point *p)
{
    return ball_contains_rational(&z->re, &p->re) && ball_contains_rational(&z->im, &p->im);
}

/* r = p q */
static void multiply(point *r, const point *p, const point *q)
{
    point t;
    rational u;
    point_init(&t);
    rational_init(&u);
    MUST(rational_mul(&t.re, &p->re, &q->re));
    MUST(rational_mul(&u, &p->im, &q->im));
    MUST(rational_sub(&t.re, &t.re, &u));
    MUST(rational_mul(&t.im, &p->re, &q->im));
    MUST(rational_mul(&u, &p->im, &q->re));
    MUST(rational_add(&t.im, &t.im, &u));
    rational_swap(&r->re, &t.re), rational_swap(&r->im, &t.im);
    point_clear(&t);
    rational_clear(&u);
}

static void add(point *r, const point *p, const point *q)
{
    MUST(rational_add(&r->re, &p->re, &q->re));
    MUST(rational_add(&r->im, &p->im, &q->im));
}

static void subtract(point *r, const point *p, const point *q)
{
    MUST(rational_sub(&r->re, &p->re, &q->re));
    MUST(rational_sub(&r->im, &p->im, &q->im));
}

/* s = |p|^2 */
static void norm(rational *s, const point *p)
{
    rational t;
    rational_init(&t);
    MUST(rational_mul(&t, &p->im, &p->im));
    MUST(rational_mul(s, &p->re, &p->re));
    MUST(rational_add(s, s, &t));
    rational_clear(&t);
}

/* r = p / q, q != 0 */
static void divide(point *r, const point *p, const point *q)
{
    point c;
    rational s;
    point_init(&c);
    rational_init(&s);
    norm(&s, q);
    MUST(rational_div(&c.re, &q->re, &s));
    MUST(rational_div(&c.im, &q->im, &s));
    MUST(rational_neg(&c.im, &c.im));
    multiply(r, p, &c);
    point_clear(&c);
    rational_clear(&s);
}

static bool point_is_zero(const point *p) { return rational_is_zero(&p->re) && rational_is_zero(&p->im); }
static bool identical(const complex_ball *x, const complex_ball *y)
{
    return ball_identical(&x->re, &y->re) && ball_identical(&x->im, &y->im);
}

/* ---- operations on two numbers ---- */

typedef void (*binary)(complex_ball *, const complex_ball *, const complex_ball *, long);

/* z = z + x y by the operation under test, from z = x */
static void addmul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    complex_ball_init(&t);
    complex_ball_set(&t, x);
    complex_ball_addmul(&t, x, y, prec);
    complex_ball_swap(z, &t);
    complex_ball_clear(&t);
}

static void submul(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball t;
    complex_ball_init(&t);
    complex_ball_set(&t, x);
    complex_ball_submul(&t, x, y, prec);
    complex_ball_swap(z, &t);
    complex_ball_clear(&t);
}

/* x by the real part of y */
static void mul_ball(complex_ball *z, const complex_ball *x, const complex_ball *y, long prec)
{
    complex_ball_mul_ball(z, x, &y->re, prec);
}

static void exact_addmul(point *r, const point *p, const point *q) { multiply(r, p, q), add(r, p, r); }
static void exact_submul(point *r, const point *p, const point *q) { multiply(r, p, q), subtract(r, p, r); }
static void exact_mul_ball(point *r, const point *p, const point *q)
{
    point real;
    point_init(&real);
    MUST(rational_set(&real.re, &q->re));
    multiply(r, p, &real);
    point_clear(&real);
}

static const struct {
    const char *name;
    binary op;
    void (*exact)(point *, const point *, const point *);
} binaries[] = {{"add", complex_ball_add, add},       {"sub", complex_ball_sub, subtract},
                {"mul", complex_ball_mul, multiply},  {"mul_ball", mul_ball, exact_mul_ball},
                {"addmul", addmul, exact_addmul},     {"submul", submul, exact_submul},
                {"div", complex_ball_div, divide}};

static void test_binary(void)
{
    test_begin("complex-binary");
    for (test_cases(3000); test_next();)
        for (size_t o = 0; o < sizeof binaries / sizeof *binaries; o++) {
            const char *name = binaries[o].name;
            complex_ball x, y, z, t;
            point p, q, r;
            complex_ball_init(&x), complex_ball_init(&y), complex_ball_init(&z), complex_ball_init(&t);
            point_init(&p), point_init(&q), point_init(&r);
            long prec = random_precision(300);
            random_complex(&x, &p), random_complex(&y, &q), random_complex(&z, &r);
            binaries[o].op(&z, &x, &y, prec);
            if (binaries[o].op != complex_ball_div || !complex_ball_contains_zero(&y)) {
                binaries[o].exact(&r, &p, &q);
                CHECK(holds(&z, &r), "%s", name);
            } else
                CHECK(!complex_ball_is_finite(&z) && !complex_ball_lacks_memory(&z), "division by a ball with 0");
            complex_ball_set(&t, &x), binaries[o].op(&t, &t, &y, prec);
            CHECK(identical(&t, &z), "%s: z = x", name);
            complex_ball_set(&t, &y), binaries[o].op(&t, &x, &t, prec);
            CHECK(identical(&t, &z), "%s: z = y", name);
            binaries[o].op(&z, &x, &x, prec);
            complex_ball_set(&t, &x), binaries[o].op(&t, &t, &t, prec);
            CHECK(identical(&t, &z), "%s: z = x = y", name);
            complex_ball_clear(&x), complex_ball_clear(&y), complex_ball_clear(&z), complex_ball_clear(&t);
            point_clear(&p), point_clear(&q), point_clear(&r);
        }
    test_end();
}

/* ---- operations on one number ---- */

typedef void (*unary)(complex_ball *, const complex_ball *, long);

static void neg(complex_ball *z, const complex_ball *x, long prec) { (void)prec, complex_ball_neg(z, x); }
static void conj_(complex_ball *z, const complex_ball *x, long prec) { (void)prec, complex_ball_conj(z, x); }
static void scale(complex_ball *z, const complex_ball *x, long prec) { complex_ball_mul_2exp(z, x, -3, prec); }
static void fifth(complex_ball *z, const complex_ball *x, long prec) { complex_ball_pow_ui(z, x, 5, prec); }
static void zeroth(complex_ball *z, const complex_ball *x, long prec) { complex_ball_pow_ui(z, x, 0, prec); }

static void exact_one(point *r, const point *p)
{
    (void)p;
    MUST(rational_set_si(&r->re, 1, 1));
    MUST(rational_set_si(&r->im, 0, 1));
}
static void exact_neg(point *r, const point *p)
{
    MUST(rational_neg(&r->re, &p->re));
    MUST(rational_neg(&r->im, &p->im));
}
static void exact_conj(point *r, const point *p)
{
    MUST(rational_set(&r->re, &p->re));
    MUST(rational_neg(&r->im, &p->im));
}
static void exact_scale(point *r, const point *p)
{
    MUST(rational_mul_2exp(&r->re, &p->re, -3));
    MUST(rational_mul_2exp(&r->im, &p->im, -3));
}
static void exact_square(point *r, const point *p) { multiply(r, p, p); }
static void exact_fifth(point *r, const point *p)
{
    point t;
    point_init(&t);
    multiply(&t, p, p), multiply(&t, &t, &t), multiply(r, &t, p);
    point_clear(&t);
}
static void exact_inverse(point *r, const point *p)
{
    point one;
    point_init(&one);
    exact_one(&one, p);
    divide(r, &one, p);
    point_clear(&one);
}

static const struct {
    const char *name;
    unary op;
    void (*exact)(point *, const point *);
} unaries[] = {{"neg", neg, exact_neg},     {"conj", conj_, exact_conj}, {"mul_2exp", scale, exact_scale},
               {"sqr", complex_ball_sqr, exact_square}, {"fifth power", fifth, exact_fifth},
               {"zeroth power", zeroth, exact_one},     {"inv", complex_ball_inv, exact_inverse}};

static void test_unary(void)
{
    test_begin("complex-unary");
    for (test_cases(2000); test_next();)
        for (size_t o = 0; o < sizeof unaries / sizeof *unaries; o++) {
            complex_ball x, z;
            point p, r;
            complex_ball_init(&x), complex_ball_init(&z);
            point_init(&p), point_init(&r);
            long prec = random_precision(300);
            random_complex(&x, &p), random_complex(&z, &r);
            unaries[o].op(&z, &x, prec);
            if (unaries[o].op != complex_ball_inv || !complex_ball_contains_zero(&x)) {
                unaries[o].exact(&r, &p);
                CHECK(holds(&z, &r), "%s", unaries[o].name);
            } else
                CHECK(!complex_ball_is_finite(&z), "inverse of a ball with 0");
            unaries[o].op(&x, &x, prec);
            CHECK(identical(&x, &z), "%s: alias", unaries[o].name);
            complex_ball_clear(&x), complex_ball_clear(&z);
            point_clear(&p), point_clear(&r);
        }
    test_end();
}

static void test_norm(void)
{
    test_begin("complex-norm");
    for (test_cases(2000); test_next();) {
        complex_ball x, t;
        point p;
        ball n;
        rational s;
        complex_ball_init(&x), complex_ball_init(&t);
        point_init(&p);
        ball_init(&n);
        rational_init(&s);
        long prec = random_precision(300);
        random_complex(&x, &p);
        norm(&s, &p);
        complex_ball_norm(&n, &x, prec);
        CHECK(ball_contains_rational(&n, &s), "norm");
        complex_ball_set(&t, &x), complex_ball_norm(&t.re, &t, prec);
        CHECK(ball_identical(&t.re, &n), "norm: alias");
        complex_ball_abs(&n, &x, prec);
        CHECK(!complex_ball_contains_zero(&x) || ball_is_negative(&n) == TRUTH_FALSE, "abs around 0 may be negative");
        complex_ball_set(&t, &x), complex_ball_abs(&t.im, &t, prec);
        CHECK(ball_identical(&t.im, &n), "abs: alias");
        ball_sqr(&n, &n, prec);
        CHECK(ball_contains_rational(&n, &s), "abs");
        complex_ball_clear(&x), complex_ball_clear(&t);
        point_clear(&p);
        ball_clear(&n);
        rational_clear(&s);
    }
    test_end();
}

/* The root of the square of p is p or -p, whichever has a positive real part; of balls around it, too. */
static void test_sqrt(void)
{
    test_begin("complex-sqrt");
    for (test_cases(4000); test_next();) {
        complex_ball x, z;
        point p, q;
        ball e;
        complex_ball_init(&x), complex_ball_init(&z);
        point_init(&p), point_init(&q);
        ball_init(&e);
        long prec = random_precision(300);
        random_complex(&x, &p);
        multiply(&q, &p, &p);
        ball_set_rational(&x.re, &q.re, 2000), ball_set_rational(&x.im, &q.im, 2000);
        if (random_bool() && x.re.size && x.im.size) {
            long top = (long)(ball_top(random_bool() ? &x.re : &x.im) - (int64_t)random_below(90));
            ball_one(&e), ball_mul_2exp(&e, &e, top, 64);
            ball_add_error(&x.re, &x.re, &e, 2000), ball_add_error(&x.im, &x.im, &e, 2000);
        }
        bool cut = ball_contains_zero(&x.im) && ball_is_positive(&x.re) != TRUTH_TRUE && !point_is_zero(&p);
        complex_ball_sqrt(&z, &x, prec);
        if (complex_ball_is_finite(&z)) {
            CHECK(!cut, "a root across the negative axis");
            if (rational_sign(&p.re) < 0)
                exact_neg(&p, &p);
            CHECK(holds(&z, &p), "sqrt");
        } else
            CHECK(cut || ball_overlaps(&x.re, &x.im) || x.re.error || x.im.error, "no root");
        complex_ball_sqrt(&x, &x, prec);
        CHECK(identical(&x, &z), "sqrt: alias");
        complex_ball_clear(&x), complex_ball_clear(&z);
        point_clear(&p), point_clear(&q);
        ball_clear(&e);
    }
    test_end();
}

/* ---- sets ---- */

static void test_sets(void)
{
    test_begin("complex-sets");
    for (test_cases(2000); test_next();) {
        complex_ball x, y;
        point p;
        ball zero;
        complex_ball_init(&x), complex_ball_init(&y);
        point_init(&p);
        ball_init(&zero);
        random_complex(&x, &p);
        CHECK(complex_ball_contains(&x, &x) && complex_ball_overlaps(&x, &x), "itself");
        ball_set_rational(&y.re, &p.re, 2000), ball_set_rational(&y.im, &p.im, 2000);
        CHECK(complex_ball_overlaps(&x, &y) && complex_ball_overlaps(&y, &x), "a point inside");
        CHECK(complex_ball_contains_zero(&x) || !point_is_zero(&p), "0 inside");
        complex_ball_set_balls(&y, &x.im, &x.re), complex_ball_set_balls(&y, &y.im, &y.re);
        CHECK(identical(&x, &y), "set_balls");
        complex_ball_zero(&y);
        CHECK(complex_ball_contains_zero(&y) && complex_ball_contains(&x, &y) == complex_ball_contains_zero(&x), "zero");
        complex_ball_one(&y);
        CHECK(!complex_ball_contains_zero(&y), "one");
        complex_ball_sub(&y, &x, &y, BALL_MAX_PRECISION); /* x - 1 and x are disjoint if x is narrow */
        CHECK(ball_contains_zero(&x.re) || x.re.error || !complex_ball_overlaps(&x, &y), "overlap");
        complex_ball_indeterminate(&y);
        CHECK(!complex_ball_is_finite(&y) && !complex_ball_lacks_memory(&y) && complex_ball_contains(&y, &x), "plane");
        complex_ball_set_balls(&y, &zero, &y.im);
        CHECK(!complex_ball_is_finite(&y) && ball_is_finite(&y.re), "line");
        complex_ball_clear(&x), complex_ball_clear(&y);
        point_clear(&p);
        ball_clear(&zero);
    }
    test_end();
}

static void test_roots_of_unity(void)
{
    test_begin("complex-roots-of-unity");
    for (long n = 1; n < 60; n++) {
        rational r;
        complex_ball z, one;
        rational_init(&r);
        complex_ball_init(&z), complex_ball_init(&one);
        MUST(rational_set_si(&r, random_range(-100, 100), n));
        complex_ball_root_of_unity(&z, &r, 200);
        complex_ball_pow_ui(&z, &z, (unsigned long)n, 200);
        complex_ball_one(&one);
        CHECK(complex_ball_contains(&z, &one) && ball_accuracy_bits_approx(&z.re) > 150, "n = %ld", n);
        rational_clear(&r);
        complex_ball_clear(&z), complex_ball_clear(&one);
    }
    test_end();
}

/* f = (t^2 + a) / t - t, f' = -a / t^2 */
static void test_jets(void)
{
    test_begin("jet-rules");
    for (test_cases(2000); test_next();) {
        jet t, a, f;
        ball x, c;
        rational p, q, v;
        jet_init(&t), jet_init(&a), jet_init(&f);
        ball_init(&x), ball_init(&c);
        rational_init(&p), rational_init(&q), rational_init(&v);
        long prec = random_precision(200);
        random_ball(&x, 3);
        random_ball(&c, 3);
        random_point_ball(&p, &x);
        random_point_ball(&q, &c);
        jet_variable(&t, &x), jet_constant(&a, &c);
        jet_sqr(&f, &t, prec), jet_add(&f, &f, &a, prec), jet_div(&f, &f, &t, prec), jet_sub(&f, &f, &t, prec);
        if (!rational_is_zero(&p)) {
            MUST(rational_div(&v, &q, &p));
            CHECK(ball_contains_rational(&f.value, &v), "value");
            MUST(rational_div(&v, &v, &p));
            MUST(rational_neg(&v, &v));
            CHECK(ball_contains_rational(&f.slope, &v), "slope");
        }
        /* (sqrt(t^2))' = 1 for t > 0 */
        jet_mul(&f, &t, &t, prec), jet_sqrt(&f, &f, prec);
        if (rational_sign(&p) > 0) {
            MUST(rational_set_si(&v, 1, 1));
            CHECK(ball_contains_rational(&f.slope, &v), "slope of a root");
        }
        jet_clear(&t), jet_clear(&a), jet_clear(&f);
        ball_clear(&x), ball_clear(&c);
        rational_clear(&p), rational_clear(&q), rational_clear(&v);
    }
    test_end();
}

int main(void)
{
    test_binary();
    test_unary();
    test_norm();
    test_sqrt();
    test_sets();
    test_roots_of_unity();
    test_jets();
    return test_status();
}
