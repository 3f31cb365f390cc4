/* t-memory.c: when an allocation fails, results say so, nothing is lost and nothing leaks.

   malloc, realloc and free are replaced by ones that count and, if told, fail at the n-th call. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bigfloat/complex_ball.h"

#include "random.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern void *__libc_malloc(size_t);
extern void *__libc_realloc(void *, size_t);
extern void __libc_free(void *);

static long live, until_failure = -1;
static bool failed;

static bool fails(void)
{
    if (until_failure < 0 || until_failure-- > 0)
        return false;
    failed = true;
    until_failure = 0; /* and all that follow */
    return true;
}

void *malloc(size_t n)
{
    if (fails())
        return NULL;
    void *p = __libc_malloc(n);
    live += p != NULL;
    return p;
}

void *realloc(void *old, size_t n)
{
    if (fails())
        return NULL;
    void *p = __libc_realloc(old, n);
    live += !old && p;
    return p;
}

void free(void *p)
{
    live -= p != NULL;
    __libc_free(p);
}

/* ---- balls ---- */

typedef void (*ball_op)(ball *, const ball *, const ball *, long);

static void sine(ball *z, const ball *x, const ball *y, long prec) { (void)y, ball_sin(z, x, prec); }
static void root(ball *z, const ball *x, const ball *y, long prec) { (void)y, ball_sqrt(z, x, prec); }
static void angle(ball *z, const ball *x, const ball *y, long prec) { (void)y, ball_atan(z, x, prec); }
static void dot(ball *z, const ball *x, const ball *y, long prec) { ball_dot(z, x, y, 1, prec); }
static void fused(ball *z, const ball *x, const ball *y, long prec) { ball_fma(z, x, y, x, prec); }
static void pi(ball *z, const ball *x, const ball *y, long prec) { (void)x, (void)y, ball_pi(z, 4 * prec); }

static const struct {
    const char *name;
    ball_op op;
} ball_ops[] = {{"add", ball_add}, {"mul", ball_mul}, {"div", ball_div}, {"hull", ball_hull}, {"min", ball_min},
                {"sin", sine}, {"sqrt", root}, {"atan", angle}, {"dot", dot}, {"fma", fused}, {"pi", pi},
                {"add_error", ball_add_error}};

static void test_balls(void)
{
    test_begin("memory-balls");
    for (size_t o = 0; o < sizeof ball_ops / sizeof *ball_ops; o++)
        for (long n = 0; n < 200; n++) {
            ball x, y, z, right;
            ball_init(&x), ball_init(&y), ball_init(&z), ball_init(&right);
            ball_pi(&x, 2000);
            ball_sqrt(&y, &x, 2000);
            ball_ops[o].op(&right, &x, &y, 2000);
            failed = false;
            until_failure = n;
            ball_ops[o].op(&z, &x, &y, 2000);
            until_failure = -1;
            CHECK(failed ? ball_lacks_memory(&z) || ball_identical(&z, &right) : ball_identical(&z, &right), "%s, failure %ld",
                  ball_ops[o].name, n);
            if (ball_lacks_memory(&z)) { /* it stays, and a later assignment ends it */
                ball_add(&z, &z, &x, 64);
                CHECK(ball_lacks_memory(&z), "%s: the mark is lost", ball_ops[o].name);
                ball_mul(&z, &x, &z, 64);
                CHECK(ball_lacks_memory(&z) && !ball_is_finite(&z), "%s: the mark is lost", ball_ops[o].name);
                ball_set_si(&z, 1, 64);
                CHECK(ball_is_finite(&z), "%s: not usable again", ball_ops[o].name);
            }
            bool done = !failed;
            ball_clear(&x), ball_clear(&y), ball_clear(&z), ball_clear(&right);
            if (done)
                break;
            CHECK(n < 199, "%s never succeeds", ball_ops[o].name);
        }
    CHECK(live == 0, "%ld blocks left", live);
    test_end();
}

/* ---- complex balls ---- */

static void test_complex(void)
{
    test_begin("memory-complex");
    for (int o = 0; o < 8; o++)
        for (long n = 0; n < 500; n++) {
            complex_ball x, z, right;
            rational q;
            complex_ball_init(&x), complex_ball_init(&z), complex_ball_init(&right);
            rational_init(&q);
            MUST(rational_set_si(&q, 1, 7));
            ball_pi(&x.re, 2000), ball_sqrt(&x.im, &x.re, 2000);
            if (o == 7)
                ball_neg(&x.re, &x.re);
                    for (int turn = 0; turn < 2; turn++) {
                complex_ball *to = turn ? &z : &right;
                failed = false;
                until_failure = turn ? n : -1;
                switch (o) {
                case 0: complex_ball_mul(to, &x, &x, 2000); break;
                case 1: complex_ball_div(to, &x, &x, 2000); break;
                case 2: complex_ball_inv(to, &x, 2000); break;
                case 3: complex_ball_sqr(to, &x, 2000); break;
                case 4: complex_ball_pow_ui(to, &x, 3, 2000); break;
                case 5: complex_ball_root_of_unity(to, &q, 2000); break;
                case 6: complex_ball_abs(&to->re, &x, 2000); break;
                default: complex_ball_sqrt(to, &x, 2000); break;
                }
                until_failure = -1;
            }
            CHECK(ball_lacks_memory(&z.re) || ball_identical(&z.re, &right.re), "operation %d, failure %ld: real part", o, n);
            CHECK(ball_lacks_memory(&z.im) || ball_identical(&z.im, &right.im), "operation %d, failure %ld: imaginary", o, n);
            if (complex_ball_lacks_memory(&z)) { /* the mark stays */
                complex_ball_mul(&right, &z, &x, 64);
                CHECK(complex_ball_lacks_memory(&right), "operation %d: a product without the mark", o);
                complex_ball_sqrt(&right, &z, 64);
                CHECK(complex_ball_lacks_memory(&right), "operation %d: a root without the mark", o);
            }
            complex_ball_clear(&x), complex_ball_clear(&z), complex_ball_clear(&right);
            rational_clear(&q);
            if (!failed)
                break;
            CHECK(n < 499, "operation %d never succeeds", o);
        }
    CHECK(live == 0, "%ld blocks left", live);
    test_end();
}

/* ---- integers, rationals, grids, text ---- */

typedef bool (*integer_op)(integer *, const integer *, const integer *);

static bool power(integer *z, const integer *x, const integer *y) { return (void)y, integer_pow(z, x, 9); }
static bool integer_root(integer *z, const integer *x, const integer *y) { return (void)y, integer_sqrt(z, x); }
static bool text(integer *z, const integer *x, const integer *y)
{
    (void)y;
    char *s = integer_get_str(x, 10);
    bool ok = s && integer_set_str(z, s, strlen(s), 10) == INTEGER_TEXT_OK;
    free(s);
    return ok;
}

static const struct {
    const char *name;
    integer_op op;
} integer_ops[] = {{"add", integer_add}, {"mul", integer_mul}, {"fdiv_q", integer_fdiv_q}, {"cdiv_q", integer_cdiv_q},
                   {"gcd", integer_gcd}, {"pow", power}, {"sqrt", integer_root}, {"text", text}, {"addmul", integer_addmul}};

static void test_integers(void)
{
    test_begin("memory-integers");
    for (size_t o = 0; o < sizeof integer_ops / sizeof *integer_ops; o++)
        for (long n = 0; n < 5000; n++) {
            integer x, y, z;
            integer_init(&x), integer_init(&y), integer_init(&z);
            integer_set_si(&x, 3), integer_set_si(&y, 10);
            MUST(integer_pow(&x, &x, 3001));
            MUST(integer_pow(&y, &y, 500));
            failed = false;
            until_failure = n;
            bool ok = integer_ops[o].op(&z, &x, &y);
            until_failure = -1;
            CHECK(ok || failed, "%s fails without reason", integer_ops[o].name);
            integer_set_si(&z, 5); /* assignable whatever happened */
            CHECK(integer_cmp_si(&z, 5) == 0, "%s", integer_ops[o].name);
            integer_clear(&x), integer_clear(&y), integer_clear(&z);
            if (!failed)
                break;
        }
    CHECK(live == 0, "%ld blocks left", live);
    test_end();
}

static void test_grids(void)
{
    test_begin("memory-grids");
    for (int o = 0; o < 6; o++)
        for (long n = 0; n < 500; n++) {
            grid x, y, z;
            rational q;
            grid_init(&x), grid_init(&y), grid_init(&z);
            rational_init(&q);
            MUST(rational_set_si(&q, 1, 7));
            grid_set_rational(&x, &q, 1000), grid_pi(&y, 1000);
            failed = false;
            until_failure = n;
            switch (o) {
            case 0: grid_mul(&z, &x, &y, 1000); break;
            case 1: grid_add(&z, &x, &y, 1000); break;
            case 2: grid_div(&z, &x, &y, 1000); break;
            case 3: grid_sqrt(&z, &y, 1000); break;
            case 4: grid_cos_pi(&z, &q, 1000); break;
            default: grid_addmul(&z, &x, &y, 1000); break;
            }
            until_failure = -1;
            CHECK(!failed || grid_lacks_memory(&z) || grid_is_finite(&z), "operation %d, failure %ld", o, n);
            CHECK(failed || grid_is_finite(&z), "operation %d without failure", o);
            char *s = grid_get_decimal(&z, 10);
            CHECK(s, "text");
            free(s);
            grid_clear(&x), grid_clear(&y), grid_clear(&z);
            rational_clear(&q);
            if (!failed)
                break;
        }
    CHECK(live == 0, "%ld blocks left", live);
    test_end();
}

int main(void)
{
    setvbuf(stdout, NULL, _IONBF, 0);
    test_balls();
    test_complex();
    test_integers();
    test_grids();
    return test_status();
}
#else
int main(void)
{
    test_begin("memory");
    test_skip("malloc cannot be replaced here");
    test_end();
    return test_status();
}
#endif
