/* t-exhaustive.c: all pairs of tiny balls, and all pairs of balls at the edges of limbs and of the error word, for
   every binary operation: the exact results at the corners must be inside. */
#include <stdlib.h>

#include "bigfloat/ball.h"

#include "random.h"

typedef struct {
    ball x;
    rational point[3]; /* lower end, middle, upper end */
} sample;

static void make_sample(sample *s, const integer *m, uint64_t err, int64_t e)
{
    integer t, r;
    integer_init(&t);
    integer_init(&r);
    integer_set_ui(&r, err);
    ball_init(&s->x);
    ball_set_parts(&s->x, m, err, e);
    for (int i = 0; i < 3; i++) {
        rational_init(&s->point[i]);
        MUST(integer_mul_si(&t, &r, i - 1));
        MUST(integer_add(&t, &t, m));
        MUST(rational_set_integer_2exp(&s->point[i], &t, (long)e));
    }
    integer_clear(&t);
    integer_clear(&r);
}

static void clear_samples(sample *s, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        ball_clear(&s[i].x);
        for (int j = 0; j < 3; j++)
            rational_clear(&s[i].point[j]);
    }
    free(s);
}

typedef void (*ball_op)(ball *, const ball *, const ball *, long);
typedef bool (*rational_op)(rational *, const rational *, const rational *);

static bool rational_min(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? x : y);
}
static bool rational_max(rational *z, const rational *x, const rational *y)
{
    return rational_set(z, rational_cmp(x, y) < 0 ? y : x);
}
static bool rational_left(rational *z, const rational *x, const rational *y)
{
    (void)y;
    return rational_set(z, x);
}

static const struct {
    const char *name;
    ball_op op;
    rational_op exact;
    bool divides;
} operations[] = {
    {"add", ball_add, rational_add, false}, {"sub", ball_sub, rational_sub, false},
    {"mul", ball_mul, rational_mul, false}, {"div", ball_div, rational_div, true},
    {"min", ball_min, rational_min, false}, {"max", ball_max, rational_max, false},
    {"hull", ball_hull, rational_left, false}, {"add_error", ball_add_error, rational_sub, false},
};

static bool is_zero_inside(const sample *s)
{
    return rational_sign(&s->point[0]) <= 0 && rational_sign(&s->point[2]) >= 0;
}

static void check_pair(size_t o, const sample *x, const sample *y, long prec, ball *z, rational *r)
{
    operations[o].op(z, &x->x, &y->x, prec);
    if (operations[o].divides && is_zero_inside(y)) {
        CHECK(!ball_is_finite(z), "division by 0");
        return;
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            if (x->x.error == 0 && i != 1)
                continue;
            if (y->x.error == 0 && j != 1)
                continue;
            MUST(operations[o].exact(r, &x->point[i], &y->point[j]));
            if (!ball_contains_rational(z, r)) {
                char *a = ball_get_hex(&x->x), *b = ball_get_hex(&y->x), *c = ball_get_hex(z);
                CHECK(false, "%s: %s, %s at %ld bits gives %s (corner %d %d)", operations[o].name, a, b, prec, c, i, j);
                free(a), free(b), free(c);
            }
        }
}

static void check_all(const sample *s, size_t n, long prec, long every)
{
    ball z;
    rational r;
    ball_init(&z);
    rational_init(&r);
    for (size_t o = 0; o < sizeof operations / sizeof *operations; o++)
        for (size_t i = 0; i < n && !test_failed(); i++)
            for (size_t j = 0; j < n; j++)
                if (every == 1 || random_below((uint64_t)every) == 0)
                    check_pair(o, &s[i], &s[j], prec, &z, &r);
    ball_clear(&z);
    rational_clear(&r);
}

static void test_tiny(void)
{
    test_begin("exhaustive-tiny");
    size_t n = 0;
    sample *s = malloc(11 * 3 * 3 * sizeof *s);
    integer m;
    integer_init(&m);
    for (long v = -5; v <= 5; v++)
        for (uint64_t err = 0; err < 3; err++)
            for (int64_t e = -1; e <= 1; e++) {
                integer_set_si(&m, v);
                make_sample(&s[n++], &m, err, e);
            }
    check_all(s, n, 64, 1);
    clear_samples(s, n);
    integer_clear(&m);
    test_end();
}

/* +-(2^a + b) for a at limb edges and small b */
static void test_edges(void)
{
    test_begin("exhaustive-edges");
    static const int power[] = {0, 30, 63, 64, 128};
    static const uint64_t error[] = {0, 1, 2, ((uint64_t)1 << 29) - 1, ((uint64_t)1 << BALL_ERROR_BITS) - 1};
    static const int exponent[] = {0, -1, -2, -31, -63, -64, -65, -128};
    size_t n = 0;
    sample *s = malloc(5 * 3 * 2 * 5 * 8 * sizeof *s);
    integer m;
    integer_init(&m);
    for (size_t a = 0; a < 5; a++)
        for (int b = -1; b <= 1; b++)
            for (int sign = -1; sign <= 1; sign += 2)
                for (size_t r = 0; r < 5; r++)
                    for (size_t e = 0; e < 8; e++) {
                        integer_set_si(&m, 1);
                        MUST(integer_mul_2exp(&m, &m, (unsigned long)power[a]));
                        MUST(integer_add_si(&m, &m, b));
                        MUST(integer_mul_si(&m, &m, sign));
                        make_sample(&s[n++], &m, error[r], exponent[e]);
                    }
    for (test_cases(4); test_next();) {
        check_all(s, n, 64, 400);
        check_all(s, n, 128, 400);
    }
    clear_samples(s, n);
    integer_clear(&m);
    test_end();
}

int main(void)
{
    test_tiny();
    test_edges();
    return test_status();
}
