/* Unit tests of the independent checker's arithmetic and parsers.
 *
 * The checker has no library, so its source files are included here; and it
 * shares nothing with the rest of the project, so neither does this test.  Exit status 0
 * iff nothing failed. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/scratch.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/sha256.c"
#include "../../verify/check/text.c"
#include "../../verify/check/formula.c"
#include "../../verify/check/value.c"
#include "../../verify/check/evaluate.c"
#include "../../verify/check/mask.c"
#include "../../verify/check/regular.c"
#include "../../verify/check/stability.c"
#include "../../verify/check/element.c"

#include "protocol.h"

#include <sys/wait.h>
#include <unistd.h>

/* Helpers
 * ------- */

/* The exit status of run(argument) in a process of its own, quietly. */
static int status_of(void (*run)(const char *), const char *argument)
{
    int status = 0;
    pid_t child;

    fflush(stdout);
    child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stderr) == NULL)
            _exit(99);
        run(argument);
        _exit(0);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

/* Limbs that make trouble are frequent. */
static uint32_t random_limb(void)
{
    static const uint32_t special[] = { 0, 1, 2, 0x7fffffff, 0x80000000u,
                                        0x80000001u, 0xfffffffeu, 0xffffffffu };
    uint32_t choice = random_word();

    return choice % 2 == 0 ? special[choice / 2 % 8] : random_word();
}

static integer random_integer(int max_length)
{
    uint32_t limb[16];
    int length = (int)(random_word() % (uint32_t)(max_length + 1));

    for (int i = 0; i < length; i++)
        limb[i] = random_limb();
    return make(random_word() % 2 == 0 ? 1 : -1, limb, length);
}

static bool equal(integer a, integer b)
{
    return integer_compare(a, b) == 0;
}

/* The invariants of integer.h */
static bool is_valid(integer a)
{
    return a.length >= 0 && a.length <= INTEGER_LIMBS &&
           (a.sign == 0) == (a.length == 0) && a.sign >= -1 && a.sign <= 1 &&
           (a.length == 0 || limbs(&a)[a.length - 1] != 0);
}

static int64_t small(integer a)
{
    int64_t value = INT64_MIN;

    integer_get_small(&value, a, INT64_MAX);
    return value;
}

static integer from_hex(const char *text)
{
    integer out = integer_from(0);

    if (!integer_read_hex(&out, text, strlen(text)))
        EXPECT(text == NULL);
    return out;
}

/* Integers
 * -------- */

static int64_t floor_of(int64_t a, int64_t b)
{
    int64_t q = a / b;

    return a % b != 0 && (a % b < 0) != (b < 0) ? q - 1 : q;
}

static void test_integer_small(void)
{
    begin("integer-small");
    for (int a = -40; a <= 40; a++) {
        for (int b = -40; b <= 40; b++) {
            integer x, y, z;

            x = integer_from(a);
            y = integer_from(b);
            z = integer_add(x, y);
            EXPECT(is_valid(z) && small(z) == a + b);
            z = integer_sub(x, y);
            EXPECT(is_valid(z) && small(z) == a - b);
            z = integer_mul(x, y);
            EXPECT(is_valid(z) && small(z) == a * b);
            EXPECT(integer_compare(x, y) == (a > b) - (a < b));
            if (b != 0) {
                z = integer_divide_floor(x, y);
                EXPECT(is_valid(z) && small(z) == floor_of(a, b));
                z = integer_divide_ceil(x, y);
                EXPECT(is_valid(z) && small(z) == -floor_of(-a, b));
            }
        }
        for (int bits = 0; bits < 8; bits++) {
            integer x, z;

            x = integer_from(a);
            z = integer_shift_left(x, bits);
            EXPECT(small(z) == a * (1 << bits));
            z = integer_shift_floor(x, bits);
            EXPECT(is_valid(z) && small(z) == floor_of(a, 1 << bits));
            z = integer_shift_ceil(x, bits);
            EXPECT(is_valid(z) && small(z) == -floor_of(-a, 1 << bits));
        }
    }
    end();
}

/* a b, bit by bit of b */
static integer slow_product(integer a, integer b)
{
    integer sum = integer_from(0);

    for (long bit = integer_bits(b) - 1; bit >= 0; bit--) {
        sum = integer_add(sum, sum);
        if ((limbs(&b)[bit / 32] >> (bit % 32) & 1u) != 0)
            sum = integer_add(sum, a);
    }
    return b.sign < 0 ? integer_negate(sum) : sum;
}

static void test_integer_large(void)
{
    begin("integer-large");
    for (int i = 0; i < 20000; i++) {
        integer a, b, c, d, e;

        a = random_integer(9);
        b = random_integer(5);
        c = integer_add(a, b);
        EXPECT(is_valid(c));
        d = integer_sub(c, b);
        EXPECT(is_valid(d) && equal(d, a));
        d = integer_sub(a, c);
        d = integer_negate(d);
        EXPECT(equal(d, b));

        c = integer_mul(a, b);
        d = slow_product(a, b);
        EXPECT(is_valid(c) && equal(c, d));
        if (b.sign != 0) {
            d = integer_divide_floor(c, b);      /* exact */
            EXPECT(equal(d, a));

            /* floor: 0 <= a - q b < |b| up to the sign of b; ceil alike */
            d = integer_divide_floor(a, b);
            e = slow_product(d, b);
            e = integer_sub(a, e);
            EXPECT(is_valid(d) && e.sign * b.sign >= 0);
            EXPECT(compare_magnitudes(&e, &b) < 0);
            d = integer_divide_ceil(a, b);
            e = slow_product(d, b);
            e = integer_sub(e, a);
            EXPECT(is_valid(d) && e.sign * b.sign >= 0);
            EXPECT(compare_magnitudes(&e, &b) < 0);
        }
    }
    end();
}

/* Every quotient of a few troublesome limbs, among them those for which the
 * guess of long division has to be corrected. */
static void test_integer_division(void)
{
    static const uint32_t limb[] = { 0, 1, 0x7fffffff, 0x80000000u, 0xffffffffu };

    begin("integer-division");
    for (int i = 0; i < 5 * 5 * 5 * 5; i++) {
        for (int j = 1; j < 5 * 5 * 5; j++) {
            uint32_t x[4], y[3];
            integer a, b, q, r;

            for (int n = 0, rest = i; n < 4; n++, rest /= 5)
                x[n] = limb[rest % 5];
            for (int n = 0, rest = j; n < 3; n++, rest /= 5)
                y[n] = limb[rest % 5];
            a = make(1, x, 4);
            b = make(1, y, 3);
            q = integer_divide_floor(a, b);
            r = slow_product(q, b);
            r = integer_sub(a, r);
            EXPECT(r.sign >= 0 && compare_magnitudes(&r, &b) < 0);
        }
    }
    end();
}

static void test_integer_shifts(void)
{
    begin("integer-shifts");
    for (int i = 0; i < 5000; i++) {
        integer a, b, power, one;
        long bits = (long)(random_word() % 200);

        a = random_integer(8);
        one = integer_from(1);
        power = integer_shift_left(one, bits);
        EXPECT(integer_bits(power) == bits + 1);
        b = integer_shift_left(a, bits);
        power = slow_product(a, power);
        EXPECT(is_valid(b) && equal(b, power));
        power = integer_shift_left(one, bits);
        b = integer_shift_floor(a, bits);
        power = integer_divide_floor(a, power);
        EXPECT(is_valid(b) && equal(b, power));
        power = integer_shift_left(one, bits);
        b = integer_shift_ceil(a, bits);
        power = integer_divide_ceil(a, power);
        EXPECT(is_valid(b) && equal(b, power));
    }
    end();
}

static void test_integer_get_small(void)
{
    begin("integer-get-small");
    for (int i = 0; i < 20000; i++) {
        integer a = random_integer(9);
        int64_t bound = (int64_t)(random_word() >> random_word() % 32), value = -7;
        bool is_small = integer_bits(a) < 64;

        EXPECT(integer_get_small(&value, a, INT64_MAX) == is_small);
        EXPECT(is_small ? equal(integer_from(value), a) : value == -7);
        value = -7;
        is_small = integer_compare(integer_absolute(a), integer_from(bound)) <= 0;
        EXPECT(integer_get_small(&value, a, bound) == is_small);
        EXPECT(is_small ? equal(integer_from(value), a) : value == -7);
        EXPECT(!integer_get_small(&value, a, -1));
    }
    end();
}

static void test_integer_root(void)
{
    begin("integer-root");
    for (int i = 0; i < 3000; i++) {
        integer a = i < 200 ? integer_from(i) : integer_absolute(random_integer(9));
        integer root = integer_root(a), above = integer_add(root, integer_from(1));

        EXPECT(is_valid(root) && integer_compare(slow_product(root, root), a) <= 0);
        EXPECT(integer_compare(slow_product(above, above), a) > 0);
    }
    end();
}

/* What is kept survives a release, what is not is overwritten. */
static void test_integer_keep(void)
{
    struct mark mark = scratch_mark();
    integer kept[3], same[3];

    begin("integer-keep");
    for (int i = 0; i < 3; i++) {
        kept[i] = integer_shift_left(integer_from(7 + i), 300 * i);
        same[i] = kept[i];
    }
    integer_shift_left(integer_from(5), 1000);
    integer_keep(mark, kept, 3);
    for (int i = 0; i < 3; i++) {
        same[i] = integer_shift_floor(kept[i], 300 * i);
        EXPECT(is_valid(kept[i]) && small(same[i]) == 7 + i);
    }
    end();
}

static void test_integer_gcd(void)
{
    begin("integer-gcd");
    for (int a = -60; a <= 60; a++) {
        for (int b = -60; b <= 60; b++) {
            integer x, y, z;
            int gcd = 0;

            for (int d = 1; d <= 60; d++)
                if (a % d == 0 && b % d == 0 && (a != 0 || b != 0))
                    gcd = d;
            x = integer_from(a);
            y = integer_from(b);
            z = integer_gcd(x, y);
            EXPECT(small(z) == gcd);
        }
    }
    end();
}

static void test_integer_hex(void)
{
    static const char *const bad[] = {
        "", "-", "-0", "00", "01", "-01", "A", "1g", "0x1", "+1", " 1", "1 ", "--1",
        "1-"
    };
    integer a;

    begin("integer-hex");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        EXPECT(!integer_read_hex(&a, bad[i], strlen(bad[i])));
    EXPECT(integer_read_hex(&a, "0", 1) && a.sign == 0 && is_valid(a));
    EXPECT(integer_read_hex(&a, "-ff", 3) && small(a) == -255);
    EXPECT(integer_read_hex(&a, "123456789abcdef", 15) &&
           small(a) == INT64_C(0x123456789abcdef));
    EXPECT(integer_read_hex(&a, "100000000", 9) && a.length == 2);
    end();
}

/* Beyond the capacity nothing is computed: "cannot check". */
static void overflow(const char *how)
{
    integer a, b;

    a = integer_from(1);
    a = integer_shift_left(a, 32L * INTEGER_LIMBS - 1);
    b = integer_from(3);
    if (how[0] == '+')
        a = integer_add(a, a);
    else if (how[0] == '*')
        a = integer_mul(a, b);
    else if (how[0] == '<')
        a = integer_shift_left(a, 1);
    else if (how[0] == '/')
        b = integer_divide_floor(a, b);
}

static void test_integer_capacity(void)
{
    begin("integer-capacity");
    EXPECT(status_of(overflow, "") == 0);
    EXPECT(status_of(overflow, "/") == 0);
    EXPECT(status_of(overflow, "+") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(overflow, "*") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(overflow, "<") == ANSWER_CANNOT_CHECK);
    end();
}

/* Rationals
 * --------- */

/* A number of four limbs, used when its memory has been given back: "" at once, "=" when another number of that
 * length is there, "*" as part of an array that was given back, too. */
static void use_too_late(const char *what)
{
    struct mark mark = scratch_mark();
    integer *list = allocate(4, sizeof list[0]);
    integer a = list[0] = integer_shift_left(integer_from(1), 100), b;

    if (what[0] != '-')
        scratch_release(mark);
    b = integer_from(1);
    if (what[0] == '=') {
        allocate(4, sizeof list[0]);
        b = integer_shift_left(integer_from(3), 100);
    }
    integer_add(what[0] == '*' ? list[0] : a, b);
}

static void test_integer_too_late(void)
{
    begin("integer-too-late");
    EXPECT(status_of(use_too_late, "-") == 0);
    EXPECT(status_of(use_too_late, "") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(use_too_late, "=") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(use_too_late, "*") == ANSWER_CANNOT_CHECK);
    end();
}

static void test_rational(void)
{
    begin("rational");
    for (int i = 0; i < 20000; i++) {
        int64_t a = (int64_t)(random_word() % 41) - 20, b = random_word() % 20 + 1;
        int64_t c = (int64_t)(random_word() % 41) - 20, d = random_word() % 20 + 1;
        rational x, y, z;

        x = rational_from(a, b);
        y = rational_from(-c, -d);
        z = rational_add(x, y);
        EXPECT(rational_equals(z, a * d + b * c, b * d));
        z = rational_sub(x, y);
        EXPECT(rational_equals(z, a * d - b * c, b * d));
        z = rational_mul(x, y);
        EXPECT(rational_equals(z, a * c, b * d));
        if (c != 0) {
            z = rational_divide(x, y);
            EXPECT(rational_equals(z, a * d, b * c));
            EXPECT(z.den.sign > 0);
        }
        EXPECT(rational_compare(x, y) == (a * d > b * c) - (a * d < b * c));
    }
    end();
}

/* Grid intervals
 * -------------- */

static interval set_interval(int lo, int hi)
{
    return interval_of(integer_from(lo), integer_from(hi));
}

static bool is_interval(interval x, int64_t lo, int64_t hi)
{
    return small(x.lo) == lo && small(x.hi) == hi;
}

/* All intervals with ends in -5..5 on the grid g = 2, against the definition. */
static void test_grid_small(void)
{
    enum { N = 5, G = 2 };

    begin("grid-small");
    for (int a = -N; a <= N; a++)
        for (int b = a; b <= N; b++)
            for (int c = -N; c <= N; c++)
                for (int d = c; d <= N; d++) {
                    const int x_end[4] = { a, a, b, b }, y_end[4] = { c, d, c, d };
                    int64_t lo = 0, hi = 0;
                    interval x, y, z;

                    x = set_interval(a, b);
                    y = set_interval(c, d);
                    for (int i = 0; i < 4; i++) {
                        int64_t product = x_end[i] * y_end[i];

                        if (i == 0 || floor_of(product, 4) < lo)
                            lo = floor_of(product, 4);
                        if (i == 0 || -floor_of(-product, 4) > hi)
                            hi = -floor_of(-product, 4);
                    }
                    z = grid_mul(x, y, G);
                    EXPECT(is_interval(z, lo, hi));
                    z = x;
                    z = grid_mul(z, y, G);
                    EXPECT(is_interval(z, lo, hi));
                    z = y;
                    z = grid_mul(x, z, G);
                    EXPECT(is_interval(z, lo, hi));

                    EXPECT(interval_contains_zero(y) == (c <= 0 && d >= 0));
                    EXPECT(interval_is_zero(y) == (c == 0 && d == 0));
                    if (c > 0 || d < 0) {
                        for (int i = 0; i < 4; i++) {
                            int64_t n = 4 * x_end[i], m = y_end[i];

                            if (i == 0 || floor_of(n, m) < lo)
                                lo = floor_of(n, m);
                            if (i == 0 || -floor_of(-n, m) > hi)
                                hi = -floor_of(-n, m);
                        }
                        z = grid_div(x, y, G);
                        EXPECT(is_interval(z, lo, hi));
                    }
                    z = interval_add(x, y);
                    EXPECT(is_interval(z, a + c, b + d));
                    z = interval_sub(x, y);
                    EXPECT(is_interval(z, a - d, b - c));
                    z = y;
                    z = interval_sub(x, z);
                    EXPECT(is_interval(z, a - d, b - c));
                    z = interval_hull(x, y);
                    EXPECT(is_interval(z, a < c ? a : c, b > d ? b : d));
                }
    end();
}

static void test_grid_parts(void)
{
    begin("grid-parts");
    for (int a = -9; a <= 9; a++) {
        for (int b = a; b <= 9; b++) {
            interval x;
            integer i;

            x = set_interval(a, b);
            i = interval_mid(x);
            EXPECT(small(i) == floor_of(a + b, 2));
            i = interval_rad(x);
            EXPECT(small(i) == b - floor_of(a + b, 2));
            i = interval_magnitude(x);
            EXPECT(small(i) == (b > -a ? b : -a));
            EXPECT(interval_is_positive(x) == (a > 0));
            x = interval_minus(x);
            EXPECT(is_interval(x, -b, -a));
        }
    }
    for (int n = -30; n <= 30; n++) {
        for (int d = 1; d <= 30; d++) {
            rational q;
            interval x;

            q = rational_from(n, d);
            x = grid_from_rational(q, 3);
            EXPECT(is_interval(x, floor_of(8 * n, d), -floor_of(-8 * n, d)));
        }
    }
    end();
}

/* pi, cos, sin
 * ------------ */

static bool is_one_unit_wide(interval x)
{
    return small(integer_sub(x.hi, x.lo)) == 1;
}

static void test_trig_pi(void)
{
    static const char digits[] =                   /* of 2^256 pi */
        "3243f6a8885a308d313198a2e03707344a4093822299f31d0082efa98ec4e6c89";
    interval x;
    integer expected;

    begin("trig-pi");
    for (int g = 64; g <= 256; g++) {
        expected = from_hex(digits);
        expected = integer_shift_floor(expected, 256 - g);
        x = grid_pi(g);
        EXPECT(equal(x.lo, expected) && is_one_unit_wide(x));
    }
    end();
}

/* sign of p(lo 2^-g) for p = c2 t^2 + c1 t + c0, times 2^(2g) */
static int quadratic(integer t, int c2, int c1, int c0, int g)
{
    integer sum = integer_mul(integer_mul(t, t), integer_from(c2));
    integer term = integer_mul(t, integer_from(c1));

    sum = integer_add(sum, integer_shift_left(term, g));
    sum = integer_add(sum, integer_shift_left(integer_from(c0), 2L * g));
    return sum.sign;
}

/* Zeros of quadratic polynomials: the ends of the least interval have opposite
 * signs. */
static void test_trig_algebraic(void)
{
    static const struct {
        int num, den, c2, c1, c0;
    } number[] = {
        { 1, 4, 2, 0, -1 }, { 1, 6, 4, 0, -3 }, { 1, 5, 4, -2, -1 },
        { 2, 5, 4, 2, -1 }, { 3, 5, 4, -2, -1 }, { 5, 6, 4, 0, -3 },
        { 9, 4, 2, 0, -1 }, { -11, 6, 4, 0, -3 }, { 1000005, 4, 2, 0, -1 }
    };

    begin("trig-algebraic");
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++) {
        for (int g = 64; g <= 1024; g *= 2) {
            rational q, s, half;
            interval x, y;

            q = rational_from(number[i].num, number[i].den);
            x = grid_cos_pi(q, g);
            EXPECT(is_one_unit_wide(x));
            EXPECT(quadratic(x.lo, number[i].c2, number[i].c1, number[i].c0, g) *
                   quadratic(x.hi, number[i].c2, number[i].c1, number[i].c0, g) < 0);

            half = rational_from(1, 2);       /* sin(x + pi/2) = cos x */
            s = rational_add(q, half);
            y = grid_sin_pi(s, g);
            EXPECT(equal(x.lo, y.lo) && equal(x.hi, y.hi));
        }
    }
    end();
}

static void test_trig_exact(void)
{
    static const int cosine[6] = { 2, 1, -1, -2, -1, 1 };   /* 2 cos(pi n/3) */

    begin("trig-exact");
    for (int n = -12; n <= 12; n++) {
        rational q, exact, expected, half = rational_from(1, 2);
        interval x, y;

        q = rational_from(n, 3);
        expected = rational_from(cosine[(n + 12) % 6], 2);
        EXPECT(rational_cos_pi(&exact, q) && rational_compare(exact, expected) == 0);
        x = grid_cos_pi(q, 64);
        y = grid_from_rational(expected, 64);
        EXPECT(equal(x.lo, y.lo) && equal(x.hi, y.hi) && equal(x.lo, x.hi));

        q = rational_from(2 * n + 1, 2);      /* cos 0, sin 1 or -1 */
        EXPECT(rational_cos_pi(&exact, q) && rational_equals(exact, 0, 1));
        EXPECT(rational_cos_pi(&exact, rational_sub(half, q)) &&
               rational_equals(exact, n % 2 == 0 ? 1 : -1, 1));
        q = rational_from(n, 6);              /* sin(pi n/6) */
        EXPECT(rational_cos_pi(&exact, rational_sub(half, q)) == ((n + 12) % 6 % 2 != 0 ?
               (n + 12) % 3 != 0 || (n + 12) % 6 == 3 : (n + 12) % 6 == 0));
    }
    for (int den = 4; den < 50; den++) {
        rational q, exact;

        q = rational_from(1, den);
        EXPECT(!rational_cos_pi(&exact, q));
    }
    end();
}

/* 2^64 cos(1065 pi/8663) is 4.4e-8 more than a whole number: the first estimate does not see on which side it is. */
static void test_trig_close(void)
{
    integer expected = from_hex("ed24ab1941068e84");
    interval x = grid_cos_pi(rational_from(1065, 8663), 64);

    begin("trig-close");
    EXPECT(equal(x.lo, expected) && is_one_unit_wide(x));
    end();
}

/* Least intervals on finer grids lie in those on coarser ones; and
 * cos 2x = 2 cos^2 x - 1, cos^2 x + sin^2 x = 1 are contained. */
static void test_trig_consistent(void)
{
    begin("trig-consistent");
    for (int i = 0; i < 2000; i++) {
        int g = 64 + i % 40;
        rational q, twice, two;
        interval c, s, c2, fine, one, sum;
        integer coarse;

        q = rational_from((int64_t)(random_word() % 4096) - 2048, random_word() % 500 + 1);
        two = rational_from(2, 1);
        twice = rational_mul(q, two);
        c = grid_cos_pi(q, g);
        s = grid_sin_pi(q, g);
        c2 = grid_cos_pi(twice, g);
        fine = grid_cos_pi(q, g + 50);
        coarse = integer_shift_floor(fine.lo, 50);
        EXPECT(equal(coarse, c.lo));
        coarse = integer_shift_ceil(fine.hi, 50);
        EXPECT(equal(coarse, c.hi));

        one = grid_from(1, g);
        c = grid_mul(c, c, g);
        s = grid_mul(s, s, g);
        sum = interval_add(c, s);
        sum = interval_sub(sum, one);
        EXPECT(interval_contains_zero(sum));
        sum = interval_add(c, c);
        sum = interval_sub(sum, one);
        sum = interval_sub(sum, c2);
        EXPECT(interval_contains_zero(sum));
    }
    end();
}

/* SHA-256
 * ------- */

static bool hash_is(const char *text, size_t size, const char *expected)
{
    char hash[65];

    sha256_hex(hash, (const unsigned char *)text, size);
    return strcmp(hash, expected) == 0;
}

static void test_sha256(void)
{
    size_t million = 1000000;
    char *text = allocate(million, 1);

    begin("sha256");
    EXPECT(hash_is("", 0,
        "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    EXPECT(hash_is("abc", 3,
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    EXPECT(hash_is("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56,
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
    memset(text, 'a', million);
    EXPECT(hash_is(text, million,
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"));
    EXPECT(hash_is(text, 55,
        "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318"));
    EXPECT(hash_is(text, 63,
        "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34"));
    EXPECT(hash_is(text, 64,
        "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb"));
    EXPECT(hash_is(text, 119,
        "31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb"));
    end();
}

/* Formulas
 * -------- */

static struct value value_at(const char *text, int k)
{
    static struct language l = { .file = "formula" };
    struct cursor c = { "formula", 1, text, text, text + strlen(text) };
    struct environment e = environment_make(&l, k < 0 ? NOTHING : span_of(k), NOTHING,
                                            NOTHING, 64);
    struct value out = evaluate(formula_read(&c, &l, k > 0 ? MEANS_K : 0), &e);

    cursor_expect_end(&c);
    value_require(out, &l, NULL, 0);
    return out;
}

static void try_formula(const char *text)
{
    value_at(text, 7);
}

static void try_mask_formula(const char *text)
{
    value_at(text, -1);
}

static bool is_rational(const char *text, int64_t num, int64_t den)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    v = value_at(text, 7);
    return v.kind == RATIONAL && rational_equals(v.q, num, den);
}

static bool is_angle(const char *text, int64_t num, int64_t den)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    v = value_at(text, 7);
    return v.kind == ANGLE && rational_equals(v.q, num, den);
}

static bool is_enclosure(const char *text)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    v = value_at(text, 7);
    return v.kind == ENCLOSURE;
}

static void test_formula_values(void)
{
    begin("formula-values");
    EXPECT(is_rational("12", 12, 1));
    EXPECT(is_rational("0.0625", 1, 16));
    EXPECT(is_rational(".5", 1, 2));
    EXPECT(is_rational("k", 7, 1));
    EXPECT(is_rational("-2^2", -4, 1));
    EXPECT(is_rational("8/4/2", 1, 1));
    EXPECT(is_rational("8-4-2", 2, 1));
    EXPECT(is_rational("2 * 3 + 4 * 5", 26, 1));
    EXPECT(is_rational("2*(3+4)*5", 70, 1));
    EXPECT(is_rational("2^-3", 1, 8));
    EXPECT(is_rational("(2/3)^-2", 9, 4));
    EXPECT(is_rational("0^0", 1, 1));
    EXPECT(is_rational("pi^0", 1, 1));
    EXPECT(is_rational("cos(pi/7)^0", 1, 1));
    EXPECT(is_rational("pi/pi", 1, 1));
    EXPECT(is_rational("2*pi-pi-pi", 0, 1));
    EXPECT(is_rational("0*pi", 0, 1));
    EXPECT(is_rational("cos(2*pi/3)", -1, 2));
    EXPECT(is_rational("sin(-pi/6)", -1, 2));
    EXPECT(is_rational("cos(0)", 1, 1));
    EXPECT(is_rational("sin(pi-pi)", 0, 1));
    EXPECT(is_rational("-(1-3)", 2, 1));
    EXPECT(is_rational("mod(-7, 3)", 2, 1));
    EXPECT(is_rational("sqrt(9/16)", 3, 4));
    EXPECT(is_rational("abs(-k) - min(3, 2, 5) + max(1/2, 1/3)", 11, 2));
    EXPECT(is_rational("cases(k = 3: 1; k >= 7 and k < 8: 2; else: 3)", 2, 1));
    EXPECT(is_rational("cases(k = 3 or k = 7: 5; else: 1/(k-7))", 5, 1));
    EXPECT(!is_rational("cases(pi > 3.1415: 1; else: 2)", 1, 1));    /* by an enclosure */
    EXPECT(is_rational("mod(cases(k = 7: 1; pi > 3: 2; else: 3), 2)", 1, 1));
    EXPECT(is_rational("2^(k-4)", 8, 1));
    EXPECT(is_rational("(-1)^12345678901", -1, 1));
    EXPECT(is_angle("abs(-pi)", 1, 1));
    EXPECT(is_enclosure("sqrt(2)"));
    EXPECT(is_enclosure("max(pi, 3)"));
    EXPECT(is_angle("2*pi/k", 2, 7));
    EXPECT(is_angle("-pi", -1, 1));
    EXPECT(is_angle("pi^1", 1, 1));
    EXPECT(is_angle("pi/2+pi/3", 5, 6));
    EXPECT(is_angle("0+pi", 1, 1));
    EXPECT(is_angle("0-pi", -1, 1));
    EXPECT(is_angle("pi-0", 1, 1));
    EXPECT(is_angle("pi/3+0*pi", 1, 3));
    EXPECT(is_angle("pi-pi+pi/2", 1, 2));
    EXPECT(is_rational("cos(0+pi)", -1, 1));

    EXPECT(is_enclosure("pi^-1"));
    EXPECT(is_enclosure("pi*pi"));
    EXPECT(is_enclosure("1/pi"));
    EXPECT(is_enclosure("pi+1"));
    EXPECT(is_enclosure("cos(pi/7)"));
    EXPECT(is_enclosure("cos(pi/7)-cos(pi/7)"));
    EXPECT(is_enclosure("cos(2*pi/7)/cos(pi/7)"));
    end();
}

static void test_formula_errors(void)
{
    static const char *const bad[] = {
        "", "1.", "1..2", "1.2.3", ".", "+1", "2^3^2", "2^", "2^-", "2^(1/2)", "2^.5", "sqrt(-1)", "mod(1/2,1)", "mod(1,0)", "cases(k=3:1)",
        "cases(else: 1; k=7: 2)", "min(1)", "sqrt(1,2)", "1 = 1", "cases(k=3 and k=4 or k=7:1;else:2)",
        "2 3", "2k", "kk", "x", "cos", "cos 1", "cos(1)", "cos(pi+1)", "cos()",
        "(1", "1)", "1/0", "1/(1-1)", "0^-1", "pi/0", "1/(cos(pi/7)-cos(pi/7))",
        "2*-3", "1--1", "cospi", "1e5", "1,5", "(1)(2)", "cos(1/2+pi)", "cos(0/pi)", "pi pi",
        "9.99^64^2", "rest", "1 .5"
    };

    begin("formula-errors");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        if (status_of(try_formula, bad[i]) != ANSWER_CANNOT_CHECK && reason[0] == '\0')
            snprintf(reason, sizeof reason, "`%s` is not refused", bad[i]);
    EXPECT(status_of(try_mask_formula, "k") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(try_mask_formula, "cos(pi/3)") == 0);
    end();
}

static void nest(const char *parentheses)
{
    char text[1000] = "";
    int count = (int)strlen(parentheses);

    for (int i = 0; i < count; i++)
        strcat(text, "(1+");
    strcat(text, "1");
    for (int i = 0; i < count; i++)
        strcat(text, ")");
    try_formula(text);
}

static void test_formula_nesting(void)
{
    char parentheses[66];

    begin("formula-nesting");
    memset(parentheses, '(', 65);
    parentheses[65] = '\0';
    EXPECT(status_of(nest, parentheses + 1) == 0);
    EXPECT(status_of(nest, parentheses) == ANSWER_CANNOT_CHECK);
    end();
}

/* Texts
 * ----- */

static void try_text(const char *text)
{
    size_t size;

    text_canonical("text", text, strlen(text), &size);
}

static bool canonical_is(const char *text, const char *expected)
{
    size_t size;
    char *canonical = text_canonical("text", text, strlen(text), &size);
    bool same = size == strlen(expected) && strcmp(canonical, expected) == 0;

    return same;
}

static void test_canonical_text(void)
{
    begin("canonical-text");
    EXPECT(canonical_is("", ""));
    EXPECT(canonical_is("a\n", "a\n"));
    EXPECT(canonical_is("a", "a\n"));
    EXPECT(canonical_is("\n\n a  b\t\r\n# c\nd#e\n #\n", "a b\nd\n"));
    EXPECT(canonical_is("a # b # c", "a\n"));
    EXPECT(canonical_is("# a", ""));
    EXPECT(status_of(try_text, "a\x01\n") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(try_text, "# \x7f\n") == ANSWER_CANNOT_CHECK);
    EXPECT(status_of(try_text, "# \xc3\xa9\n") == ANSWER_CANNOT_CHECK);
    end();
}

/* Masks
 * ----- */

static integer *coefficient(struct mask *mask, int a, int b)
{
    return mask_cell(mask, a, b);
}

/* The weight and all its images. */
static void set_orbit(struct mask *mask, int a, int b, int weight)
{
    for (int turn = 0; turn < 6; turn++) {
        int turned = -b;

        *coefficient(mask, a, b) = integer_from(weight);
        *coefficient(mask, b, a) = integer_from(weight);
        b = a + b;
        a = turned;
    }
}

static struct mask *new_mask(int denominator)
{
    struct mask *mask = allocate(1, sizeof *mask);

    *mask = mask_new(-8, -8, 17, 17);
    mask->denominator = integer_from(denominator);
    return mask;
}

static struct mask *loop_mask(void)
{
    struct mask *mask = new_mask(16);

    set_orbit(mask, 0, 0, 10);
    set_orbit(mask, 1, 0, 6);
    set_orbit(mask, 1, 1, 2);
    set_orbit(mask, 2, 0, 1);
    return mask;
}

static struct mask *butterfly_mask(void)
{
    struct mask *mask = new_mask(16);

    set_orbit(mask, 0, 0, 16);
    set_orbit(mask, 1, 0, 8);
    set_orbit(mask, 1, 1, 2);
    set_orbit(mask, 2, 1, -1);
    return mask;
}

static void test_mask_conditions(void)
{
    struct mask *mask = loop_mask();

    begin("mask-conditions");
    EXPECT(mask_fault(mask, TRIANGLE) == NULL);
    *coefficient(mask, 0, 0) = integer_from(11);
    EXPECT(mask_fault(mask, TRIANGLE) != NULL);
    *coefficient(mask, 0, 0) = integer_from(10);

    *coefficient(mask, 1, 0) = integer_from(7);       /* sums stay, no rotation */
    *coefficient(mask, -1, 0) = integer_from(5);
    EXPECT(mask_fault(mask, TRIANGLE) != NULL);

    mask = butterfly_mask();
    EXPECT(mask_fault(mask, TRIANGLE) == NULL);

    int a = 2, b = 1;                                    /* rotation, no mirror */

    for (int turn = 0; turn < 6; turn++) {
        int turned = -b;

        *coefficient(mask, a, b) = integer_from(-2);
        *coefficient(mask, b, a) = integer_from(0);
        b = a + b;
        a = turned;
    }
    EXPECT(mask_fault(mask, TRIANGLE) == NULL && !mask_is_mirrored(mask));
    end();
}

/* Norms of Loop: 2^-N; of Butterfly: 1, 7/8 ... (Zorin, Thesis, 1997). */
static void test_regular(void)
{
    struct derived_masks *derived = allocate(1, sizeof *derived);
    struct mask *loop = loop_mask(), *butterfly = butterfly_mask();

    begin("regular");
    EXPECT(regular_derive(derived, loop, TRIANGLE));
    for (int i = 0; i < 3; i++)
        for (int n = 1; n <= 4; n++)
            EXPECT(regular_contracts(&derived->second[i], n));
    EXPECT(mask_is_nonnegative(&derived->first[0]));

    EXPECT(regular_derive(derived, butterfly, TRIANGLE));
    for (int i = 0; i < 3; i++) {
        EXPECT(!regular_contracts(&derived->second[i], 1));
        EXPECT(regular_contracts(&derived->second[i], 2));
        EXPECT(regular_contracts(&derived->second[i], 5));
    }
    EXPECT(!mask_is_nonnegative(&derived->first[0]));

    set_orbit(loop, 2, 0, 2);                            /* a remainder */
    EXPECT(!regular_derive(derived, loop, TRIANGLE));
    end();
}

/* A norm of exactly 1 does not contract, one just below does. */
static void test_regular_norm(void)
{
    struct mask *mask = new_mask(1000);

    begin("regular-norm");
    *coefficient(mask, 1, -1) = integer_from(-500);   /* s = 2 mask */
    EXPECT(!regular_contracts(mask, 1));
    EXPECT(!regular_contracts(mask, 3));
    *coefficient(mask, 1, -1) = integer_from(-499);
    EXPECT(regular_contracts(mask, 1));
    EXPECT(regular_contracts(mask, 3));
    *coefficient(mask, 3, 1) = integer_from(1);       /* the same class */
    EXPECT(!regular_contracts(mask, 1));
    end();
}

/* Butterfly's derivatives: |S^7| = 2.07.., and windows of S^7 give 2.10
 * (lib/stability.md).  K >= |S^n| for all n. */
static void test_stability(void)
{
    struct derived_masks *derived = allocate(1, sizeof *derived);
    struct mask *butterfly = butterfly_mask(), q;

    begin("stability");
    EXPECT(regular_derive(derived, butterfly, TRIANGLE));
    q = mask_double(&derived->first[0]);
    EXPECT(!stability_holds(&q, 7, 2048));
    EXPECT(!stability_holds(&q, 7, 2100));
    EXPECT(stability_holds(&q, 7, 2160));
    EXPECT(stability_holds(&q, 7, 4000));
    EXPECT(!stability_holds(&q, 1, 2160));
    EXPECT(!stability_holds(butterfly, 5, 1500));
    EXPECT(stability_holds(butterfly, 5, 1700));
    end();
}

/* lib/stability.md, section 3, to the letter and without rounding: for masks in units of 1/16 with points in
 * [-1, 2]^2, and N <= 3, so that those of S^N lie in [-7, 14]^2. */
enum { PLANE = 22, ORIGIN = 7, ROW = 13, ROW_ORIGIN = 6 };

static int64_t power_plane[PLANE][PLANE], row_plane[2][ROW][ROW];

/* power_plane := the coefficients of s^n, in units of 16^-n */
static void make_power(const int weight[4][4], int n)
{
    int64_t old[PLANE][PLANE];

    memset(power_plane, 0, sizeof power_plane);
    power_plane[ORIGIN][ORIGIN] = 1;
    for (int step = 0; step < n; step++) {
        memcpy(old, power_plane, sizeof old);
        memset(power_plane, 0, sizeof power_plane);
        for (int i = 0; i < PLANE * PLANE; i++)
            for (int j = 0; old[i / PLANE][i % PLANE] != 0 && j < 16; j++)
                power_plane[i / PLANE + (j / 4 - 1) * (1 << step)]
                           [i % PLANE + (j % 4 - 1) * (1 << step)] +=
                    old[i / PLANE][i % PLANE] * weight[j / 4][j % 4];
    }
}

/* row_plane[which] := row (a,b) */
static void make_row(int which, int a, int b, int n)
{
    memset(row_plane[which], 0, sizeof row_plane[which]);
    for (int i = 0; i < ROW * ROW; i++) {
        int x = a - (i / ROW - ROW_ORIGIN) * (1 << n) + ORIGIN;
        int y = b - (i % ROW - ROW_ORIGIN) * (1 << n) + ORIGIN;

        if (x >= 0 && x < PLANE && y >= 0 && y < PLANE)
            row_plane[which][i / ROW][i % ROW] = power_plane[x][y];
    }
}

static bool pair_is_fine(int a, int b, int da, int db, int n, int64_t t)
{
    int64_t delta = 0, h = 0, unit = INT64_C(1) << (4 * n);

    make_row(0, a, b, n);
    make_row(1, a + da, b + db, n);
    for (int i = 0; i < ROW * ROW; i++) {
        int64_t here = row_plane[0][i / ROW][i % ROW];
        int64_t there = row_plane[1][i / ROW][i % ROW];

        delta += magnitude(here - there);
        h += magnitude((1024 + t) * here - (t - 1024) * there);
    }
    return delta < 2 * unit && h <= 2 * t * unit;
}

static bool holds_by_definition(const int weight[4][4], int n, int64_t t)
{
    int low[3] = { 9, 9, 9 }, high[3] = { -9, -9, -9 };
    bool fine = true;

    for (int i = 0; i < 16; i++) {
        int f[3] = { i / 4 - 1, i % 4 - 1, i / 4 + i % 4 - 2 };

        for (int d = 0; d < 3 && weight[i / 4][i % 4] != 0; d++) {
            low[d] = f[d] < low[d] ? f[d] : low[d];
            high[d] = f[d] > high[d] ? f[d] : high[d];
        }
    }
    make_power(weight, n);
    for (int da = low[0] - high[0] + 1; da < high[0] - low[0]; da++)
        for (int db = low[1] - high[1] + 1; db < high[1] - low[1]; db++)
            for (int x = 0; abs(da + db) < high[2] - low[2] && x < 1 << (2 * n); x++)
                fine = fine && pair_is_fine(x >> n, x & ((1 << n) - 1), da, db, n, t);
    return fine;
}

/* A mask like that of the linear spline along both axes, a little disturbed. */
static void random_mask(int weight[4][4])
{
    static const int hat[4] = { 2, 4, 2, 0 };

    for (int i = 0; i < 16; i++)
        weight[i / 4][i % 4] = hat[i / 4] * hat[i % 4];
    for (int i = (int)(random_word() % 6); i > 0; i--) {
        int a = (int)(random_word() % 2), b = (int)(random_word() % 2);
        int by = (int)(random_word() % 5) - 2;

        weight[a][b] += by;                            /* sums of classes stay */
        weight[a + (int)(random_word() % 2) * 2][b + 2] -= by;
    }
}

static void test_stability_by_definition(void)
{
    int decisive = 0;

    begin("stability-by-definition");
    for (int i = 0; i < 60; i++) {
        struct mask *mask = new_mask(16);
        int weight[4][4], n = 1 + i % 3;
        int64_t low = 1024, high = 1 << 20;

        random_mask(weight);
        for (int c = 0; c < 16; c++)
            *coefficient(mask, c / 4 - 1, c % 4 - 1) = integer_from(weight[c / 4][c % 4]);
        if (!holds_by_definition(weight, n, high)) {
            EXPECT(!stability_holds(mask, n, high));
            continue;
        }
        while (high - low > 1) {
            int64_t middle = (low + high) / 2;

            *(holds_by_definition(weight, n, middle) ? &high : &low) = middle;
        }
        EXPECT(stability_holds(mask, n, high));
        EXPECT(low == 1024 || !stability_holds(mask, n, low));
        EXPECT(stability_holds(mask, n, high + 1000));
        decisive += low > 1024;
    }
    EXPECT(decisive >= 5);
    end();
}

/* Rows that have nothing in common: |(1024+T) m_x - (T-1024) m_x'| is at its limit, 2 T, for every T, and
 * |m_x - m_x'| = 2 forbids it; with 1/3 in place of 1, rounding errors do. */
static void test_stability_of_disjoint_rows(void)
{
    struct mask *mask = new_mask(1), *thirds = new_mask(3);

    begin("stability-of-disjoint-rows");
    for (int a = 0; a < 2; a++) {
        for (int b = 0; b < 2; b++) {
            *coefficient(mask, 3 * a, 3 * b) = integer_from(1);
            for (int i = 0; i < 3; i++)
                *coefficient(thirds, 3 * a + 2 * i - 2, 3 * b) = integer_from(1);
        }
    }
    EXPECT(!stability_holds(mask, 1, 2000));
    EXPECT(!stability_holds(mask, 1, 1000000));
    EXPECT(!stability_holds(mask, 2, 2000));
    EXPECT(!stability_holds(thirds, 1, 2000));
    EXPECT(!stability_holds(thirds, 1, 1000000));
    end();
}

/* Windows
 * ------- */

/* Where x is in the window of a child and q(x - 2y) is not 0, y is in the window
 * of the parent; and the children cover the parent. */
static void check_windows(const struct mask *mask, enum mesh mesh)
{
    struct stencil stencil = stencil_make(mask, 2, 64);
    struct window window[ELEMENT_KINDS];

    for (int kind = 0; kind < ELEMENT_KINDS; kind++)
        window[kind] = window_make((enum element_kind)kind, &stencil, mesh);
    for (int kind = 0; kind < ELEMENT_KINDS; kind++) {
        for (int i = 0; i < element_form[kind].children; i++) {
            struct child child = element_form[kind].child[i];
            const struct window *w = &window[child.kind];

            for (int p = 0; p < w->count * stencil.first[4]; p++) {
                struct label x = w->label[p / stencil.first[4]];
                struct stencil_entry *entry = &stencil.entry[p % stencil.first[4]];
                int a = x.a + child.a - entry->a, b = x.b + child.b - entry->b;

                if (a % 2 == 0 && b % 2 == 0)
                    EXPECT(window_index(&window[kind], a / 2, b / 2) >= 0);
            }
        }
    }
    EXPECT(window_index(window, -100, 0) == -1);
}

static void test_windows(void)
{
    struct mask *square = allocate(1, sizeof *square);

    begin("windows");
    check_windows(loop_mask(), TRIANGLE);
    check_windows(butterfly_mask(), TRIANGLE);
    *square = mask_new(-2, -2, 4, 4);              /* biquadratic B-splines */
    for (int i = 0; i < 16; i++)
        square->coefficient[i] = integer_from((i % 4 % 3 == 0 ? 1 : 3) *
                                              (i / 4 % 3 == 0 ? 1 : 3));
    square->denominator = integer_from(16);
    EXPECT(mask_fault(square, DUAL) == NULL && mask_fault(square, QUAD) != NULL);
    check_windows(square, DUAL);
    end();
}

/* The elements of a ring are different ones, and as many as its area says. */
static void test_rings(void)
{
    begin("rings");
    for (int r = 1; r < 9; r++) {
        struct element *list;

        EXPECT(ring_elements(&list, TRIANGLE, r, false) == 3 * r * r);
        EXPECT(ring_elements(&list, TRIANGLE, r, true) == 2 * r);
        EXPECT(ring_elements(&list, DUAL, r, true) == 4 * r);
        EXPECT(ring_elements(&list, QUAD, r, false) == 3 * r * r);
        EXPECT(list[0].a == r && list[0].b == 0);
        for (int i = 1; i < 3 * r * r; i++) {
            int a = list[i].a, b = list[i].b, ring = a > b ? a : b;

            EXPECT(ring >= r && ring < 2 * r);
            EXPECT(a != list[i - 1].a || b != list[i - 1].b);
        }
    }
    end();
}

int main(void)
{
    test_integer_small();
    test_integer_large();
    test_integer_division();
    test_integer_shifts();
    test_integer_get_small();
    test_integer_root();
    test_integer_keep();
    test_integer_gcd();
    test_integer_hex();
    test_integer_capacity();
    test_integer_too_late();
    test_rational();
    test_grid_small();
    test_grid_parts();
    test_trig_pi();
    test_trig_algebraic();
    test_trig_exact();
    test_trig_close();
    test_trig_consistent();
    test_sha256();
    test_formula_values();
    test_formula_errors();
    test_formula_nesting();
    test_canonical_text();
    test_mask_conditions();
    test_regular();
    test_regular_norm();
    test_windows();
    test_rings();
    test_stability();
    test_stability_by_definition();
    test_stability_of_disjoint_rows();
    return failures == 0 ? 0 : 1;
}
