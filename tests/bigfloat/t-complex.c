/* t-complex.c: complex balls contain exact complex results; jets contain exact derivatives. */
#define NUMBER_BALL
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

static void test_field(void)
{
    test_begin("complex-field");
    for (test_cases(3000); test_next();) {
        complex_ball x, y, z, t;
        point p, q, r;
        complex_ball_init(&x), complex_ball_init(&y), complex_ball_init(&z), complex_ball_init(&t);
        point_init(&p), point_init(&q), point_init(&r);
        long prec = random_precision(300);
        random_complex(&x, &p), random_complex(&y, &q);
        complex_ball_add(&z, &x, &y, prec);
        MUST(rational_add(&r.re, &p.re, &q.re));
        MUST(rational_add(&r.im, &p.im, &q.im));
        CHECK(holds(&z, &r), "add");
        complex_ball_sub(&z, &z, &y, prec);
        CHECK(holds(&z, &p), "sub");
        multiply(&r, &p, &q);
        complex_ball_mul(&z, &x, &y, prec);
        CHECK(holds(&z, &r), "mul");
        complex_ball_set(&t, &x), complex_ball_mul(&t, &t, &y, prec);
        CHECK(ball_identical(&t.re, &z.re) && ball_identical(&t.im, &z.im), "alias");
        complex_ball_div(&t, &z, &y, prec);
        bool zero = rational_is_zero(&q.re) && rational_is_zero(&q.im);
        CHECK(zero ? !complex_ball_is_finite(&t) : holds(&t, &p), "div");
        complex_ball_inv(&t, &y, prec);
        complex_ball_mul(&t, &t, &z, prec);
        CHECK((rational_is_zero(&q.re) && rational_is_zero(&q.im)) || holds(&t, &p), "inv");
        complex_ball_sqr(&z, &x, prec);
        multiply(&r, &p, &p);
        CHECK(holds(&z, &r), "sqr");
        /* the root of a square is x or -x */
        complex_ball_sqrt(&t, &z, prec);
        if (complex_ball_is_finite(&t)) {
            bool plus = holds(&t, &p);
            MUST(rational_neg(&p.re, &p.re));
            MUST(rational_neg(&p.im, &p.im));
            CHECK(plus || holds(&t, &p), "sqrt");
        }
        ball n;
        ball_init(&n);
        complex_ball_norm(&n, &x, prec);
        MUST(rational_mul(&q.re, &p.re, &p.re));
        MUST(rational_mul(&q.im, &p.im, &p.im));
        MUST(rational_add(&q.re, &q.re, &q.im));
        CHECK(ball_contains_rational(&n, &q.re), "norm");
        complex_ball_abs(&n, &x, prec);
        ball_sqr(&n, &n, prec);
        CHECK(ball_contains_rational(&n, &q.re), "abs");
        ball_clear(&n);
        complex_ball_clear(&x), complex_ball_clear(&y), complex_ball_clear(&z), complex_ball_clear(&t);
        point_clear(&p), point_clear(&q), point_clear(&r);
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
    test_field();
    test_roots_of_unity();
    test_jets();
    return test_status();
}
