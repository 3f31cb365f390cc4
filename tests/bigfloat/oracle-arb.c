/* oracle-arb.c: ball operations against arb's on the same balls.

   Both enclose the same set of numbers, so they must have a point in common; ours must contain a tight enclosure, by
   arb with more bits, of the result for one choice of numbers in the operands; where that result is a short dyadic
   number, ours must contain it exactly.  And our radius is at most FACTOR times arb's, plus UNITS units of the
   precision; twice that for quotients, which arb centres anew when the divisor is nearly 0. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#include "tests/harness.h"

#ifndef HAVE_FLINT
int main(void)
{
    test_begin("oracle-arb");
    test_skip("built without FLINT");
    test_end();
    return test_status();
}
#else
#ifdef HAVE_FLINT_ARB_H
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#include <stdlib.h>
#include <string.h>

#include "random.h"

#define FACTOR 2
#define UNITS 4
#define TERMS 20

/* ---- conversions ---- */

static void give_integer(fmpz_t z, const integer *m)
{
    char *text = integer_get_str(m, 16);
    CHECK(text && fmpz_set_str(z, text, 16) == 0, "conversion");
    free(text);
}

/* The same set, exactly: a short error is exact in arb. */
static void give(arb_t z, const ball *x)
{
    integer m;
    uint64_t err;
    int64_t e;
    fmpz_t f;
    integer_init(&m);
    fmpz_init(f);
    if (ball_get_parts(&m, &err, &e, x)) {
        give_integer(f, &m);
        arf_set_fmpz(arb_midref(z), f);
        arf_mul_2exp_si(arb_midref(z), arb_midref(z), (slong)e);
        mag_set_ui_2exp_si(arb_radref(z), err, (slong)e);
    } else
        arb_indeterminate(z);
    fmpz_clear(f);
    integer_clear(&m);
}

/* One number of the set, thin: an end, the middle or something between. */
static void choose(arb_t z, const ball *x)
{
    integer m;
    uint64_t err;
    int64_t e;
    fmpz_t f;
    integer_init(&m);
    fmpz_init(f);
    MUST(ball_get_parts(&m, &err, &e, x));
    int64_t r = (int64_t)err;
    MUST(integer_add_si(&m, &m, random_below(3) ? (random_bool() ? r : -r) : random_range(-r, r)));
    give_integer(f, &m);
    arb_set_fmpz(z, f);
    arb_mul_2exp_si(z, z, (slong)e);
    fmpz_clear(f);
    integer_clear(&m);
}

/* ---- operations of up to 2 TERMS balls; the result of `theirs` at infinite precision is a dyadic number if `ring` ---- */

typedef struct {
    const char *name;
    void (*ours)(ball *z, const ball *x, long prec);
    void (*theirs)(arb_t z, arb_srcptr x, slong prec);
    int operands; /* 0: any number of pairs */
    bool ring;
    bool moderate; /* operands in [-16, 16] */
    double factor; /* instead of FACTOR */
    long rounds;
} operation;

#define UNARY(op)                                                                                          \
    static void our_##op(ball *z, const ball *x, long prec) { ball_##op(z, x, prec); }                     \
    static void arb_op_##op(arb_t z, arb_srcptr x, slong prec) { arb_##op(z, x, prec); }
#define BINARY(op)                                                                                         \
    static void our_##op(ball *z, const ball *x, long prec) { ball_##op(z, x, x + 1, prec); }              \
    static void arb_op_##op(arb_t z, arb_srcptr x, slong prec) { arb_##op(z, x, x + 1, prec); }
BINARY(add)
BINARY(sub)
BINARY(mul)
BINARY(div)
UNARY(sqr)
UNARY(inv)
UNARY(sqrt)
UNARY(sin)
UNARY(cos)
UNARY(atan)
BINARY(atan2)

static int pairs; /* of the dot product */
static bool strided;

static void our_addmul(ball *z, const ball *x, long prec)
{
    ball_set(z, &x[2]);
    ball_addmul(z, &x[0], &x[1], prec);
}
static void arb_op_addmul(arb_t z, arb_srcptr x, slong prec)
{
    arb_set(z, x + 2);
    arb_addmul(z, x, x + 1, prec);
}
static void our_submul(ball *z, const ball *x, long prec)
{
    ball_set(z, &x[2]);
    ball_submul(z, &x[0], &x[1], prec);
}
static void arb_op_submul(arb_t z, arb_srcptr x, slong prec)
{
    arb_set(z, x + 2);
    arb_submul(z, x, x + 1, prec);
}
static void our_fma(ball *z, const ball *x, long prec) { ball_fma(z, &x[0], &x[1], &x[2], prec); }

static void our_dot(ball *z, const ball *x, long prec)
{
    if (strided)
        ball_dot_strided(z, x, 2, x + 2 * pairs - 1, -2, (size_t)pairs, prec);
    else
        ball_dot(z, x, x + pairs, (size_t)pairs, prec);
}
static void arb_op_dot(arb_t z, arb_srcptr x, slong prec)
{
    if (strided)
        arb_dot(z, NULL, 0, x, 2, x + 2 * pairs - 1, -2, pairs, prec);
    else
        arb_dot(z, NULL, 0, x, 1, x + pairs, 1, pairs, prec);
}

#define ROW(op) our_##op, arb_op_##op

static const operation operations[] = {
    {"add", ROW(add), 2, true, false, FACTOR, 10000},   {"sub", ROW(sub), 2, true, false, FACTOR, 10000},
    {"mul", ROW(mul), 2, true, false, FACTOR, 10000},   {"sqr", ROW(sqr), 1, true, false, FACTOR, 5000},
    {"addmul", ROW(addmul), 3, true, false, FACTOR, 5000}, {"submul", ROW(submul), 3, true, false, FACTOR, 5000},
    {"fma", our_fma, arb_op_addmul, 3, true, false, FACTOR, 3000},
    {"dot", ROW(dot), 0, true, false, FACTOR, 6000},    {"div", ROW(div), 2, false, false, 2 * FACTOR, 10000},
    {"inv", ROW(inv), 1, false, false, 2 * FACTOR, 5000},   {"sqrt", ROW(sqrt), 1, false, false, FACTOR, 5000},
    {"sin", ROW(sin), 1, false, true, FACTOR, 2000},    {"cos", ROW(cos), 1, false, true, FACTOR, 2000},
    {"atan", ROW(atan), 1, false, true, FACTOR, 1500},  {"atan2", ROW(atan2), 2, false, true, 0, 1500},
};

static ball x[2 * TERMS], z;
static arb_struct a[2 * TERMS];
static arb_t c, d;
static arf_t bound, unit;

static void draw(ball *u, const operation *op)
{
    random_ball(u, random_below(6) ? 5 : 30);
    if (op->moderate) {
        ball_mul_2exp(u, u, -(long)u->exponent - 64 * abs(u->size) + random_range(-40, 4), 1L << 20);
        if (u->size == 0 && u->error)
            ball_mul_2exp(u, u, -30, 64);
    }
}

/* radius <= factor (arb's radius) + UNITS 2^-prec |middle or radius|, both finite.  If `lipschitz`, the derivatives are
   at most 1 in absolute value: 1 is the scale, and twice the operand's own radius, which is all that we use, is allowed too. */
static bool is_tight(double factor, long prec, bool lipschitz)
{
    mag_t t;
    mag_init(t);
    arf_set_mag(bound, arb_radref(c));
    arf_mul_ui(bound, bound, (ulong)factor, 64, ARF_RND_UP);
    if (lipschitz) {
        arf_set_mag(unit, arb_radref(a));
        arf_mul_2exp_si(unit, unit, 1);
        arf_add(bound, bound, unit, 64, ARF_RND_UP);
        arf_one(unit);
    } else {
        arb_get_mag(t, d);
        arf_set_mag(unit, t);
    }
    arf_mul_ui(unit, unit, UNITS, 64, ARF_RND_UP);
    arf_mul_2exp_si(unit, unit, -prec);
    arf_add(bound, bound, unit, 64, ARF_RND_UP);
    arf_set_mag(unit, arb_radref(d));
    mag_clear(t);
    return arf_cmp(unit, bound) <= 0;
}

/* a: one number of each operand; c: the result for it, exact or to many bits. */
static bool holds_choice(const operation *op, int n, long prec)
{
    for (int i = 0; i < n; i++)
        choose(a + i, &x[i]);
    op->theirs(c, a, op->ring ? ARF_PREC_EXACT : prec + 2500);
    return !arb_is_finite(c) || arb_contains(d, c);
}

static void check(const operation *op)
{
    const bool arc = strcmp(op->name, "atan2") == 0;
    pairs = (int)random_range(0, TERMS);
    strided = random_bool();
    int n = op->operands ? op->operands : 2 * pairs;
    bool thin = random_below(3) == 0;
    for (int i = 0; i < n; i++) {
        draw(&x[i], op);
        if (thin)
            ball_midpoint(&x[i], &x[i], BALL_MAX_PRECISION);
    }
    if (n == 2 && random_below(8) == 0)
        ball_neg(&x[1], &x[0]);
    if (arc && ball_contains_zero(&x[0]) && ball_is_positive(&x[1]) != TRUTH_TRUE)
        return; /* the angle jumps, and our enclosure passes pi where arb's fills the circle */
    long prec = random_below(8) ? random_precision(512) : random_precision(3000);
    op->ours(&z, x, prec);
    give(d, &z);
    for (int i = 0; i < n; i++)
        give(a + i, &x[i]);
    op->theirs(c, a, prec);
    char *s = n > 0 ? ball_get_hex(&x[0]) : NULL, *t = n > 1 ? ball_get_hex(&x[1]) : NULL;
#define OPERANDS s ? s : "", t ? t : "", n, prec
    CHECK(ball_is_finite(&z) || !arb_is_finite(c) || op->factor < 1, "%s(%s, %s ...) of %d balls at %ld bits is indeterminate",
          op->name, OPERANDS);
    CHECK(arb_overlaps(c, d), "%s(%s, %s ...) of %d balls at %ld bits is disjoint from arb's", op->name, OPERANDS);
    if (arb_is_finite(c) && ball_is_finite(&z) && op->factor >= 1 )
        CHECK(is_tight(op->factor, prec, op->moderate), "%s(%s, %s ...) of %d balls at %ld bits is wider than arb's", op->name, OPERANDS);
    CHECK(!ball_is_finite(&z) || holds_choice(op, n, prec), "%s(%s, %s ...) of %d balls at %ld bits misses a result", op->name, OPERANDS);
    free(s), free(t);
}

/* ---- questions ---- */

static void check_questions(void)
{
    random_ball(&x[0], 5), random_ball(&x[1], 5);
    if (random_bool()) { /* nearly the same */
        ball_set(&x[1], &x[0]);
        ball_mul_2exp(&z, &x[0], random_range(-70, 0), 128);
        if (random_bool())
            ball_add_error(&x[1], &x[1], &z, 4096);
        else
            ball_add(&x[1], &x[1], &z, 4096);
    }
    give(a, &x[0]), give(a + 1, &x[1]);
    truth less = arb_lt(a, a + 1) ? TRUTH_TRUE : arb_ge(a, a + 1) ? TRUTH_FALSE : TRUTH_UNKNOWN;
    CHECK(ball_less(&x[0], &x[1]) == less, "less");
    CHECK(ball_contains(&x[0], &x[1]) == (arb_contains(a, a + 1) != 0), "contains");
    CHECK(ball_contains_interior(&x[0], &x[1]) == (arb_contains_interior(a, a + 1) != 0), "contains_interior");
    CHECK(ball_overlaps(&x[0], &x[1]) == (arb_overlaps(a, a + 1) != 0), "overlaps");
    CHECK(ball_contains_zero(&x[0]) == (arb_contains_zero(a) != 0), "contains_zero");
    CHECK((ball_is_positive(&x[0]) == TRUTH_TRUE) == (arb_is_positive(a) != 0), "is_positive");
    CHECK((ball_is_negative(&x[0]) == TRUTH_TRUE) == (arb_is_negative(a) != 0), "is_negative");
}

int main(void)
{
    for (int i = 0; i < 2 * TERMS; i++)
        ball_init(&x[i]), arb_init(a + i);
    ball_init(&z), arb_init(c), arb_init(d), arf_init(bound), arf_init(unit);
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        char name[64] = "oracle-arb-";
        strcat(name, operations[i].name);
        test_begin(name);
        for (test_cases(operations[i].rounds); test_next();)
            check(&operations[i]);
        test_end();
    }
    test_begin("oracle-arb-questions");
    for (test_cases(20000); test_next();)
        check_questions();
    test_end();
    for (int i = 0; i < 2 * TERMS; i++)
        ball_clear(&x[i]), arb_clear(a + i);
    ball_clear(&z), arb_clear(c), arb_clear(d), arf_clear(bound), arf_clear(unit);
    flint_cleanup();
    return test_status();
}
#endif
