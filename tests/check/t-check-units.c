/* Unit tests of the independent checker's arithmetic and parsers.
 *
 * The checker has no library, so its source files are included here; and it
 * shares nothing with the rest of the project, so neither does this test.  One
 * line on stdout for each test, PASS or FAIL; exit status 0 iff none failed. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/sha256.c"
#include "../../verify/check/text.c"
#include "../../verify/check/formula.c"
#include "../../verify/check/mask.c"
#include "../../verify/check/regular.c"
#include "../../verify/check/window.c"

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

/* Protocol
 * -------- */

static const char *test_name;
static char reason[256];
static int failures;

static void begin(const char *name)
{
    test_name = name;
    reason[0] = '\0';
}

/* The first expectation that fails is the reason. */
#define EXPECT(condition)                                                      \
    do {                                                                       \
        if (!(condition) && reason[0] == '\0')                                 \
            snprintf(reason, sizeof reason, "line %d: %s", __LINE__, #condition); \
    } while (0)

static void end(void)
{
    if (reason[0] == '\0') {
        printf("PASS %s\n", test_name);
    } else {
        printf("FAIL %s: %s\n", test_name, reason);
        failures++;
    }
    fflush(stdout);
}

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

/* Random numbers: the same ones in every run.
 * -------------- */

static uint64_t random_state = 88172645463325252u;

static uint32_t random_word(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}

/* Limbs that make trouble are frequent. */
static uint32_t random_limb(void)
{
    static const uint32_t special[] = { 0, 1, 2, 0x7fffffff, 0x80000000u,
                                        0x80000001u, 0xfffffffeu, 0xffffffffu };
    uint32_t choice = random_word();

    return choice % 2 == 0 ? special[choice / 2 % 8] : random_word();
}

static void random_integer(integer *out, int max_length)
{
    int length = (int)(random_word() % (uint32_t)(max_length + 1));

    for (int i = 0; i < length; i++)
        out->limb[i] = random_limb();
    set_limbs(out, random_word() % 2 == 0 ? 1 : -1, out->limb, length);
}

static bool equal(const integer *a, const integer *b)
{
    return integer_compare(a, b) == 0;
}

/* The invariants of integer.h */
static bool is_valid(const integer *a)
{
    return a->length >= 0 && a->length <= INTEGER_LIMBS &&
           (a->sign == 0) == (a->length == 0) && a->sign >= -1 && a->sign <= 1 &&
           (a->length == 0 || a->limb[a->length - 1] != 0);
}

static int64_t small(const integer *a)
{
    int64_t value = INT64_MIN;

    integer_get_small(&value, a, INT64_MAX);
    return value;
}

static void from_hex(integer *out, const char *text)
{
    if (!integer_read_hex(out, text, strlen(text)))
        EXPECT(text == NULL);
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

            integer_set_small(&x, a);
            integer_set_small(&y, b);
            integer_add(&z, &x, &y);
            EXPECT(is_valid(&z) && small(&z) == a + b);
            integer_sub(&z, &x, &y);
            EXPECT(is_valid(&z) && small(&z) == a - b);
            integer_mul(&z, &x, &y);
            EXPECT(is_valid(&z) && small(&z) == a * b);
            EXPECT(integer_compare(&x, &y) == (a > b) - (a < b));
            if (b != 0) {
                integer_divide_floor(&z, &x, &y);
                EXPECT(is_valid(&z) && small(&z) == floor_of(a, b));
                integer_divide_ceil(&z, &x, &y);
                EXPECT(is_valid(&z) && small(&z) == -floor_of(-a, b));
            }
        }
        for (int bits = 0; bits < 8; bits++) {
            integer x, z;

            integer_set_small(&x, a);
            integer_shift_left(&z, &x, bits);
            EXPECT(small(&z) == a * (1 << bits));
            integer_shift_floor(&z, &x, bits);
            EXPECT(is_valid(&z) && small(&z) == floor_of(a, 1 << bits));
            integer_shift_ceil(&z, &x, bits);
            EXPECT(is_valid(&z) && small(&z) == -floor_of(-a, 1 << bits));
        }
    }
    end();
}

/* a b, bit by bit of b */
static void slow_product(integer *out, const integer *a, const integer *b)
{
    integer sum, term;

    integer_set_small(&sum, 0);
    for (long bit = integer_bits(b) - 1; bit >= 0; bit--) {
        integer_add(&sum, &sum, &sum);
        if ((b->limb[bit / 32] >> (bit % 32) & 1u) != 0)
            integer_add(&sum, &sum, a);
    }
    integer_set(&term, &sum);
    if (b->sign < 0)
        integer_negate(&term, &term);
    integer_set(out, &term);
}

static void test_integer_large(void)
{
    begin("integer-large");
    for (int i = 0; i < 20000; i++) {
        integer a, b, c, d, e;

        random_integer(&a, 9);
        random_integer(&b, 5);
        integer_add(&c, &a, &b);
        EXPECT(is_valid(&c));
        integer_sub(&d, &c, &b);
        EXPECT(is_valid(&d) && equal(&d, &a));
        integer_sub(&d, &a, &c);
        integer_negate(&d, &d);
        EXPECT(equal(&d, &b));

        integer_mul(&c, &a, &b);
        slow_product(&d, &a, &b);
        EXPECT(is_valid(&c) && equal(&c, &d));
        if (b.sign != 0) {
            integer_divide_floor(&d, &c, &b);      /* exact */
            EXPECT(equal(&d, &a));

            /* floor: 0 <= a - q b < |b| up to the sign of b; ceil alike */
            integer_divide_floor(&d, &a, &b);
            slow_product(&e, &d, &b);
            integer_sub(&e, &a, &e);
            EXPECT(is_valid(&d) && e.sign * b.sign >= 0);
            EXPECT(compare_magnitudes(&e, &b) < 0);
            integer_divide_ceil(&d, &a, &b);
            slow_product(&e, &d, &b);
            integer_sub(&e, &e, &a);
            EXPECT(is_valid(&d) && e.sign * b.sign >= 0);
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
            integer a, b, q, r;

            for (int n = 0, rest = i; n < 4; n++, rest /= 5)
                a.limb[n] = limb[rest % 5];
            for (int n = 0, rest = j; n < 3; n++, rest /= 5)
                b.limb[n] = limb[rest % 5];
            set_limbs(&a, 1, a.limb, 4);
            set_limbs(&b, 1, b.limb, 3);
            integer_divide_floor(&q, &a, &b);
            slow_product(&r, &q, &b);
            integer_sub(&r, &a, &r);
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

        random_integer(&a, 8);
        integer_set_small(&one, 1);
        integer_shift_left(&power, &one, bits);
        EXPECT(integer_bits(&power) == bits + 1);
        integer_shift_left(&b, &a, bits);
        slow_product(&power, &a, &power);
        EXPECT(is_valid(&b) && equal(&b, &power));
        integer_shift_left(&power, &one, bits);
        integer_shift_floor(&b, &a, bits);
        integer_divide_floor(&power, &a, &power);
        EXPECT(is_valid(&b) && equal(&b, &power));
        integer_shift_left(&power, &one, bits);
        integer_shift_ceil(&b, &a, bits);
        integer_divide_ceil(&power, &a, &power);
        EXPECT(is_valid(&b) && equal(&b, &power));
    }
    end();
}

/* Outputs may be inputs. */
static void test_integer_aliasing(void)
{
    static void (*const binary[])(integer *, const integer *, const integer *) = {
        integer_add, integer_sub, integer_mul, integer_divide_floor,
        integer_divide_ceil, integer_gcd
    };
    static void (*const shift[])(integer *, const integer *, long) = {
        integer_shift_left, integer_shift_floor, integer_shift_ceil
    };

    begin("integer-aliasing");
    for (int i = 0; i < 6000; i++) {
        integer a, b, c, d;

        random_integer(&a, 6);
        random_integer(&b, 6);
        if (b.sign == 0)
            integer_set_small(&b, 7);
        for (size_t f = 0; f < sizeof binary / sizeof binary[0]; f++) {
            binary[f](&c, &a, &b);
            integer_set(&d, &a);
            binary[f](&d, &d, &b);
            EXPECT(equal(&c, &d));
            integer_set(&d, &b);
            binary[f](&d, &a, &d);
            EXPECT(equal(&c, &d));
            binary[f](&c, &b, &b);
            integer_set(&d, &b);
            binary[f](&d, &d, &d);
            EXPECT(equal(&c, &d));
        }
        for (size_t f = 0; f < sizeof shift / sizeof shift[0]; f++) {
            shift[f](&c, &a, i % 100);
            integer_set(&d, &a);
            shift[f](&d, &d, i % 100);
            EXPECT(equal(&c, &d));
        }
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
            integer_set_small(&x, a);
            integer_set_small(&y, b);
            integer_gcd(&z, &x, &y);
            EXPECT(small(&z) == gcd);
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
    EXPECT(integer_read_hex(&a, "0", 1) && a.sign == 0 && is_valid(&a));
    EXPECT(integer_read_hex(&a, "-ff", 3) && small(&a) == -255);
    EXPECT(integer_read_hex(&a, "123456789abcdef", 15) &&
           small(&a) == INT64_C(0x123456789abcdef));
    EXPECT(integer_read_hex(&a, "100000000", 9) && a.length == 2);
    end();
}

/* Beyond the capacity nothing is computed: "cannot check". */
static void overflow(const char *how)
{
    integer a, b;

    integer_set_small(&a, 1);
    integer_shift_left(&a, &a, 32L * INTEGER_LIMBS - 1);
    integer_set_small(&b, 3);
    if (how[0] == '+')
        integer_add(&a, &a, &a);
    else if (how[0] == '*')
        integer_mul(&a, &a, &b);
    else if (how[0] == '<')
        integer_shift_left(&a, &a, 1);
    else if (how[0] == '/')
        integer_divide_floor(&b, &a, &b);
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

static void test_rational(void)
{
    begin("rational");
    for (int i = 0; i < 20000; i++) {
        int64_t a = (int64_t)(random_word() % 41) - 20, b = random_word() % 20 + 1;
        int64_t c = (int64_t)(random_word() % 41) - 20, d = random_word() % 20 + 1;
        rational x, y, z;

        rational_set_small(&x, a, b);
        rational_set_small(&y, -c, -d);
        rational_add(&z, &x, &y);
        EXPECT(rational_equals(&z, a * d + b * c, b * d));
        rational_sub(&z, &x, &y);
        EXPECT(rational_equals(&z, a * d - b * c, b * d));
        rational_mul(&z, &x, &y);
        EXPECT(rational_equals(&z, a * c, b * d));
        if (c != 0) {
            rational_divide(&z, &x, &y);
            EXPECT(rational_equals(&z, a * d, b * c));
            EXPECT(z.den.sign > 0);
        }
        EXPECT(rational_compare(&x, &y) == (a * d > b * c) - (a * d < b * c));
    }
    end();
}

/* Grid intervals
 * -------------- */

static void set_interval(interval *out, int lo, int hi)
{
    integer_set_small(&out->lo, lo);
    integer_set_small(&out->hi, hi);
}

static bool is_interval(const interval *x, int64_t lo, int64_t hi)
{
    return small(&x->lo) == lo && small(&x->hi) == hi;
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

                    set_interval(&x, a, b);
                    set_interval(&y, c, d);
                    for (int i = 0; i < 4; i++) {
                        int64_t product = x_end[i] * y_end[i];

                        if (i == 0 || floor_of(product, 4) < lo)
                            lo = floor_of(product, 4);
                        if (i == 0 || -floor_of(-product, 4) > hi)
                            hi = -floor_of(-product, 4);
                    }
                    grid_mul(&z, &x, &y, G);
                    EXPECT(is_interval(&z, lo, hi));
                    interval_set(&z, &x);
                    grid_mul(&z, &z, &y, G);
                    EXPECT(is_interval(&z, lo, hi));
                    interval_set(&z, &y);
                    grid_mul(&z, &x, &z, G);
                    EXPECT(is_interval(&z, lo, hi));

                    EXPECT(interval_contains_zero(&y) == (c <= 0 && d >= 0));
                    if (c > 0 || d < 0) {
                        for (int i = 0; i < 4; i++) {
                            int64_t n = 4 * x_end[i], m = y_end[i];

                            if (i == 0 || floor_of(n, m) < lo)
                                lo = floor_of(n, m);
                            if (i == 0 || -floor_of(-n, m) > hi)
                                hi = -floor_of(-n, m);
                        }
                        grid_div(&z, &x, &y, G);
                        EXPECT(is_interval(&z, lo, hi));
                    }
                    interval_add(&z, &x, &y);
                    EXPECT(is_interval(&z, a + c, b + d));
                    interval_sub(&z, &x, &y);
                    EXPECT(is_interval(&z, a - d, b - c));
                    interval_set(&z, &y);
                    interval_sub(&z, &x, &z);
                    EXPECT(is_interval(&z, a - d, b - c));
                    interval_hull(&z, &x, &y);
                    EXPECT(is_interval(&z, a < c ? a : c, b > d ? b : d));
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

            set_interval(&x, a, b);
            interval_mid(&i, &x);
            EXPECT(small(&i) == floor_of(a + b, 2));
            interval_rad(&i, &x);
            EXPECT(small(&i) == b - floor_of(a + b, 2));
            interval_magnitude(&i, &x);
            EXPECT(small(&i) == (b > -a ? b : -a));
            EXPECT(interval_is_positive(&x) == (a > 0));
            interval_minus(&x, &x);
            EXPECT(is_interval(&x, -b, -a));
        }
    }
    for (int n = -30; n <= 30; n++) {
        for (int d = 1; d <= 30; d++) {
            rational q;
            interval x;

            rational_set_small(&q, n, d);
            grid_from_rational(&x, &q, 3);
            EXPECT(is_interval(&x, floor_of(8 * n, d), -floor_of(-8 * n, d)));
        }
    }
    end();
}

/* pi, cos, sin
 * ------------ */

static bool is_one_unit_wide(const interval *x)
{
    integer width;

    integer_sub(&width, &x->hi, &x->lo);
    return small(&width) == 1;
}

static void test_trig_pi(void)
{
    static const char digits[] =                   /* of 2^256 pi */
        "3243f6a8885a308d313198a2e03707344a4093822299f31d0082efa98ec4e6c89";
    interval x;
    integer expected;

    begin("trig-pi");
    for (int g = 64; g <= 256; g++) {
        from_hex(&expected, digits);
        integer_shift_floor(&expected, &expected, 256 - g);
        grid_pi(&x, g);
        EXPECT(equal(&x.lo, &expected) && is_one_unit_wide(&x));
    }
    end();
}

/* sign of p(lo 2^-g) for p = c2 t^2 + c1 t + c0, times 2^(2g) */
static int quadratic(const integer *t, int c2, int c1, int c0, int g)
{
    integer sum, term, factor;

    integer_set_small(&factor, c2);
    integer_mul(&sum, t, t);
    integer_mul(&sum, &sum, &factor);
    integer_set_small(&factor, c1);
    integer_mul(&term, t, &factor);
    integer_shift_left(&term, &term, g);
    integer_add(&sum, &sum, &term);
    integer_set_small(&term, c0);
    integer_shift_left(&term, &term, 2L * g);
    integer_add(&sum, &sum, &term);
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

            rational_set_small(&q, number[i].num, number[i].den);
            grid_cos_pi(&x, &q, g);
            EXPECT(is_one_unit_wide(&x));
            EXPECT(quadratic(&x.lo, number[i].c2, number[i].c1, number[i].c0, g) *
                   quadratic(&x.hi, number[i].c2, number[i].c1, number[i].c0, g) < 0);

            rational_set_small(&half, 1, 2);       /* sin(x + pi/2) = cos x */
            rational_add(&s, &q, &half);
            grid_sin_pi(&y, &s, g);
            EXPECT(equal(&x.lo, &y.lo) && equal(&x.hi, &y.hi));
        }
    }
    end();
}

static void test_trig_exact(void)
{
    static const int cosine[6] = { 2, 1, -1, -2, -1, 1 };   /* 2 cos(pi n/3) */

    begin("trig-exact");
    for (int n = -12; n <= 12; n++) {
        rational q, exact, expected;
        interval x, y;

        rational_set_small(&q, n, 3);
        rational_set_small(&expected, cosine[(n + 12) % 6], 2);
        EXPECT(rational_cos_pi(&exact, &q) && rational_compare(&exact, &expected) == 0);
        grid_cos_pi(&x, &q, 64);
        grid_from_rational(&y, &expected, 64);
        EXPECT(equal(&x.lo, &y.lo) && equal(&x.hi, &y.hi) && equal(&x.lo, &x.hi));

        rational_set_small(&q, 2 * n + 1, 2);      /* cos 0, sin 1 or -1 */
        EXPECT(rational_cos_pi(&exact, &q) && rational_equals(&exact, 0, 1));
        EXPECT(rational_sin_pi(&exact, &q) &&
               rational_equals(&exact, n % 2 == 0 ? 1 : -1, 1));
        rational_set_small(&q, n, 6);              /* sin(pi n/6) */
        EXPECT(rational_sin_pi(&exact, &q) == ((n + 12) % 6 % 2 != 0 ?
               (n + 12) % 3 != 0 || (n + 12) % 6 == 3 : (n + 12) % 6 == 0));
    }
    for (int den = 4; den < 50; den++) {
        rational q, exact;

        rational_set_small(&q, 1, den);
        EXPECT(!rational_cos_pi(&exact, &q));
    }
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

        rational_set_small(&q, (int64_t)(random_word() % 4096) - 2048,
                           random_word() % 500 + 1);
        rational_set_small(&two, 2, 1);
        rational_mul(&twice, &q, &two);
        grid_cos_pi(&c, &q, g);
        grid_sin_pi(&s, &q, g);
        grid_cos_pi(&c2, &twice, g);
        grid_cos_pi(&fine, &q, g + 50);
        integer_shift_floor(&coarse, &fine.lo, 50);
        EXPECT(equal(&coarse, &c.lo));
        integer_shift_ceil(&coarse, &fine.hi, 50);
        EXPECT(equal(&coarse, &c.hi));

        grid_set_small(&one, 1, g);
        grid_mul(&c, &c, &c, g);
        grid_mul(&s, &s, &s, g);
        interval_add(&sum, &c, &s);
        interval_sub(&sum, &sum, &one);
        EXPECT(interval_contains_zero(&sum));
        interval_add(&sum, &c, &c);
        interval_sub(&sum, &sum, &one);
        interval_sub(&sum, &sum, &c2);
        EXPECT(interval_contains_zero(&sum));
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
    free(text);
    end();
}

/* Formulas
 * -------- */

static void evaluate(struct value *out, const char *text, int k)
{
    struct cursor c = { "formula", 1, text, text, text + strlen(text) };

    formula_evaluate(out, &c, k, 64);
    cursor_expect_end(&c);
}

static void try_formula(const char *text)
{
    struct value v;

    evaluate(&v, text, 7);
}

static void try_mask_formula(const char *text)
{
    struct value v;

    evaluate(&v, text, 0);
}

static bool is_rational(const char *text, int64_t num, int64_t den)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    evaluate(&v, text, 7);
    return v.kind == RATIONAL && rational_equals(&v.q, num, den);
}

static bool is_angle(const char *text, int64_t num, int64_t den)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    evaluate(&v, text, 7);
    return v.kind == ANGLE && rational_equals(&v.q, num, den);
}

static bool is_enclosure(const char *text)
{
    struct value v;

    if (status_of(try_formula, text) != 0)
        return false;
    evaluate(&v, text, 7);
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
    EXPECT(is_angle("2*pi/k", 2, 7));
    EXPECT(is_angle("-pi", -1, 1));
    EXPECT(is_angle("pi^1", 1, 1));
    EXPECT(is_angle("pi/2+pi/3", 5, 6));
    EXPECT(is_enclosure("0+pi"));
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
        "", "1.", "1..2", "1.2.3", ".", "+1", "2^3^2", "2^", "2^-", "2^65", "2^.5",
        "2 3", "2k", "kk", "x", "cos", "cos 1", "cos(1)", "cos(pi+1)", "cos()",
        "(1", "1)", "1/0", "1/(1-1)", "0^-1", "pi/0", "1/(cos(pi/7)-cos(pi/7))",
        "2*-3", "1--1", "cospi", "1e5", "1,5", "(1)(2)", "cos(0+pi)", "pi pi",
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

    free(text_canonical("text", text, strlen(text), &size));
}

static bool canonical_is(const char *text, const char *expected)
{
    size_t size;
    char *canonical = text_canonical("text", text, strlen(text), &size);
    bool same = size == strlen(expected) && strcmp(canonical, expected) == 0;

    free(canonical);
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
    return &mask->coefficient[a + MASK_RADIUS][b + MASK_RADIUS];
}

/* The weight and all its images. */
static void set_orbit(struct mask *mask, int a, int b, int weight)
{
    for (int turn = 0; turn < 6; turn++) {
        int turned = -b;

        integer_set_small(coefficient(mask, a, b), weight);
        integer_set_small(coefficient(mask, b, a), weight);
        b = a + b;
        a = turned;
    }
}

static struct mask *new_mask(int denominator)
{
    struct mask *mask = allocate(1, sizeof *mask);

    integer_set_small(&mask->denominator, denominator);
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
    EXPECT(mask_fault(mask) == NULL);
    integer_set_small(coefficient(mask, 0, 0), 11);
    EXPECT(mask_fault(mask) != NULL);
    integer_set_small(coefficient(mask, 0, 0), 10);

    integer_set_small(coefficient(mask, 1, 0), 7);       /* sums stay, no rotation */
    integer_set_small(coefficient(mask, -1, 0), 5);
    EXPECT(mask_fault(mask) != NULL);
    free(mask);

    mask = butterfly_mask();
    EXPECT(mask_fault(mask) == NULL);

    int a = 2, b = 1;                                    /* rotation, no mirror */

    for (int turn = 0; turn < 6; turn++) {
        int turned = -b;

        integer_set_small(coefficient(mask, a, b), -2);
        integer_set_small(coefficient(mask, b, a), 0);
        b = a + b;
        a = turned;
    }
    EXPECT(mask_fault(mask) != NULL);
    free(mask);
    end();
}

/* Norms of Loop: 2^-N; of Butterfly: 1, 7/8 ... (Zorin, Thesis, 1997). */
static void test_regular(void)
{
    struct derived_masks *derived = allocate(1, sizeof *derived);
    struct mask *loop = loop_mask(), *butterfly = butterfly_mask();

    begin("regular");
    EXPECT(regular_derive(derived, loop));
    for (int i = 0; i < 3; i++)
        for (int n = 1; n <= 4; n++)
            EXPECT(regular_contracts(&derived->second[i], n));
    EXPECT(mask_is_nonnegative(&derived->first[0]));

    EXPECT(regular_derive(derived, butterfly));
    for (int i = 0; i < 3; i++) {
        EXPECT(!regular_contracts(&derived->second[i], 1));
        EXPECT(regular_contracts(&derived->second[i], 2));
        EXPECT(regular_contracts(&derived->second[i], 5));
    }
    EXPECT(!mask_is_nonnegative(&derived->first[0]));

    set_orbit(loop, 2, 0, 2);                            /* a remainder */
    EXPECT(!regular_derive(derived, loop));
    free(loop);
    free(butterfly);
    free(derived);
    end();
}

/* A norm of exactly 1 does not contract, one just below does. */
static void test_regular_norm(void)
{
    struct mask *mask = new_mask(1000);

    begin("regular-norm");
    integer_set_small(coefficient(mask, 1, -1), -500);   /* s = 2 mask */
    EXPECT(!regular_contracts(mask, 1));
    EXPECT(!regular_contracts(mask, 3));
    integer_set_small(coefficient(mask, 1, -1), -499);
    EXPECT(regular_contracts(mask, 1));
    EXPECT(regular_contracts(mask, 3));
    integer_set_small(coefficient(mask, 3, 1), 1);       /* the same class */
    EXPECT(!regular_contracts(mask, 1));
    free(mask);
    end();
}

/* Windows
 * ------- */

/* Where x is in the window of a child and q(x - 2y) is not 0, y is in the window
 * of the parent; and the children cover the parent. */
static void test_windows(void)
{
    struct mask *masks[2] = { loop_mask(), butterfly_mask() };
    struct stencil *stencil = allocate(1, sizeof *stencil);
    struct window *window = allocate(ELEMENT_KINDS, sizeof *window);

    begin("windows");
    for (int n = 0; n < 2; n++) {
        stencil_from_mask(stencil, masks[n], 64);
        for (int kind = 0; kind < ELEMENT_KINDS; kind++)
            window_prepare(&window[kind], (enum element_kind)kind, stencil);
        for (int kind = 0; kind < ELEMENT_KINDS; kind++) {
            for (int i = 0; i < element_children[kind]; i++) {
                struct child child = element_child[kind][i];
                const struct window *w = &window[child.kind];

                for (int p = 0; p < w->count * stencil->count; p++) {
                    struct point x = w->point[p / stencil->count];
                    struct stencil_entry *entry =
                        &stencil->entry[p % stencil->count];
                    int a = x.a + child.a - entry->a, b = x.b + child.b - entry->b;

                    if (a % 2 == 0 && b % 2 == 0)
                        EXPECT(window_index(&window[kind], a / 2, b / 2) >= 0);
                }
            }
        }
        free(masks[n]);
    }
    EXPECT(window_index(window, -100, 0) == -1);
    free(window);
    free(stencil);
    end();
}

int main(void)
{
    test_integer_small();
    test_integer_large();
    test_integer_division();
    test_integer_shifts();
    test_integer_aliasing();
    test_integer_gcd();
    test_integer_hex();
    test_integer_capacity();
    test_rational();
    test_grid_small();
    test_grid_parts();
    test_trig_pi();
    test_trig_algebraic();
    test_trig_exact();
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
    return failures == 0 ? 0 : 1;
}
