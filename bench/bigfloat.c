/* bigfloat.c: our numbers, MPFR's and arb's on the same operands, interleaved in one process.

   usage: bigfloat [OPERATION]...        (all of them if none is named)

   Each line of the table: operation, kind of operands, bits, nanoseconds of one operation, and the others' time
   divided by ours: above 1 we are faster.  Every figure is the median of REPETITIONS runs, and the runs of the
   libraries take turns, so that a busy machine hurts all alike.  "thin" operands are exact, those called "ball"
   have full mantissas and an error of one unit in the last place; MPFR gets their midpoints.  At the end the
   figures are held against the goals. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bigfloat/ball.h"
#include "bigfloat/grid.h"
#include "bigfloat/interval.h"

#if defined(__has_include)
#if __has_include("bigfloat/interval_batch.h")
#include "bigfloat/interval_batch.h"
#define HAVE_BATCH 1
#endif
#endif

#ifdef HAVE_MPFR
#include <mpfr.h>
#endif
#ifdef HAVE_FLINT
#ifdef HAVE_FLINT_ARB_H
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#endif

#define OPERANDS 64 /* a power of two */
#define REPETITIONS 9
#define SECONDS_PER_RUN 4e-4
#define LEAST_OPERANDS 8 /* in a run, however slow they are */
#define DOT_TERMS 16
#define BATCH 256
#define MOST_LIMBS 160

static ball bx[OPERANDS], by[OPERANDS], bz[OPERANDS], bw;
static grid gx[OPERANDS], gy[OPERANDS], gz[OPERANDS];
static interval hx[BATCH], hy[BATCH], hz[BATCH];
static rational angle[OPERANDS];
#ifdef HAVE_MPFR
static mpfr_t mx[OPERANDS], my[OPERANDS], mz[OPERANDS], mw;
#endif
#ifdef HAVE_FLINT
static arb_struct ax[OPERANDS], ay[OPERANDS], az[OPERANDS];
static arb_t aw;
static fmpq aangle[OPERANDS];
#endif
static long bits;
static volatile long answer; /* so that questions are asked */

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); /* what others do on this machine is not counted */
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void must(bool ok)
{
    if (!ok) {
        fprintf(stderr, "no memory\n");
        exit(71);
    }
}

static uint64_t state;
static uint64_t word(void)
{
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* ---- operands ---- */

typedef enum {
    THIN,
    BALL,
    CLOSE,    /* balls, y inside x: as hard as a comparison gets */
    POSITIVE, /* balls */
    POSITIVE_THIN,
    NONE,     /* no operands, or operands of another system */
} kind;

static const char *const kind_name[] = {"thin", "ball", "close", "ball", "thin", ""};

/* `bits` bits, in [-16, 16], not near 0. */
static void fill(ball *x, bool positive, uint64_t error)
{
    uint64_t limb[MOST_LIMBS];
    size_t n = (size_t)(bits + 63) / 64;
    for (size_t i = 0; i < n; i++)
        limb[i] = word();
    limb[n - 1] |= (uint64_t)1 << 63;
    limb[0] = limb[0] >> (64 * n - (size_t)bits) << (64 * n - (size_t)bits);
    integer m;
    integer_init(&m);
    must(integer_set_limbs(&m, limb, n, !positive && (word() & 1)));
    must(integer_fdiv_2exp(&m, &m, 64 * n - (unsigned long)bits));
    ball_set_parts(x, &m, error, (int64_t)(word() % 8) - 3 - bits);
    integer_clear(&m);
}

#if defined(HAVE_MPFR) || defined(HAVE_FLINT)
static char *mantissa(uint64_t *error, long *e, const ball *x)
{
    integer m;
    int64_t exponent;
    integer_init(&m);
    must(ball_get_parts(&m, error, &exponent, x));
    *e = (long)exponent;
    char *text = integer_get_str(&m, 16);
    must(text != NULL);
    integer_clear(&m);
    return text;
}
#endif

#ifdef HAVE_MPFR
static void give_mpfr(mpfr_t z, const ball *x)
{
    uint64_t error;
    long e;
    char *text = mantissa(&error, &e, x);
    mpfr_set_prec(z, bits);
    mpfr_set_str(z, text, 16, MPFR_RNDN);
    mpfr_mul_2si(z, z, e, MPFR_RNDN);
    free(text);
}
#endif

#ifdef HAVE_FLINT
static void give_arb(arb_t z, const ball *x)
{
    uint64_t error;
    long e;
    char *text = mantissa(&error, &e, x);
    fmpz_t m;
    fmpz_init(m);
    fmpz_set_str(m, text, 16);
    arf_set_fmpz(arb_midref(z), m);
    arf_mul_2exp_si(arb_midref(z), arb_midref(z), e);
    mag_set_ui_2exp_si(arb_radref(z), error, e);
    fmpz_clear(m);
    free(text);
}
#endif

static void load(kind k)
{
    state = (uint64_t)bits;
    for (int i = 0; k != NONE && i < OPERANDS; i++) {
        bool positive = k == POSITIVE || k == POSITIVE_THIN;
        fill(&bx[i], positive, k == THIN || k == POSITIVE_THIN ? 0 : k == CLOSE ? 1000 : 1);
        fill(&by[i], positive, k == THIN || k == POSITIVE_THIN ? 0 : 1);
        if (k == CLOSE) { /* the same midpoint, less error */
            ball_midpoint(&by[i], &bx[i], bits);
            ball_set_si(&bz[i], 1, bits);
            ball_mul_2exp(&bz[i], &bz[i], 3 - bits, bits);
            ball_add_error(&by[i], &by[i], &bz[i], bits);
        }
#ifdef HAVE_MPFR
        give_mpfr(mx[i], &bx[i]);
        give_mpfr(my[i], &by[i]);
        mpfr_set_prec(mz[i], bits);
        mpfr_set_prec(mw, bits);
#endif
#ifdef HAVE_FLINT
        give_arb(&ax[i], &bx[i]);
        give_arb(&ay[i], &by[i]);
#endif
    }
}

/* x in [-s, s], width some units. */
static void fill_grid(grid *x, int above)
{
    integer a, b;
    uint64_t limb[2] = {word(), word() & ((1u << above) - 1)};
    integer_init(&a);
    integer_init(&b);
    must(integer_set_limbs(&a, limb, 2, word() & 1));
    if (above == 0)
        must(integer_fdiv_2exp(&a, &a, 2)); /* in (-1/4, 1/4): one word and a spare bit */
    must(integer_add_si(&b, &a, (int64_t)(word() % 100)));
    grid_set_endpoints(x, &a, &b, 64);
    integer_clear(&a);
    integer_clear(&b);
}

static void load_others(void)
{
    state = 7;
    for (int i = 0; i < BATCH; i++) {
        double u = ldexp((double)(word() >> 11), -50) - 4, v = ldexp((double)(word() >> 11), -50) - 4;
        interval_set_doubles(&hx[i], u, u + 0x1p-40);
        interval_set_doubles(&hy[i], v, v + 0x1p-40);
    }
    for (int i = 0; i < OPERANDS; i++) {
        long q = 3 + i, p = 1 + (long)(word() % (uint64_t)q);
        must(rational_set_si(&angle[i], p, q));
#ifdef HAVE_FLINT
        fmpq_set_si(&aangle[i], p, (ulong)q);
#endif
    }
}

/* ---- kernels: n operations, one operand after the other ---- */

typedef void (*kernel)(long n);

#define LOOP(name, statement)              \
    static void name(long n)               \
    {                                      \
        for (long j = 0; j < n; j++) {     \
            long i = j & (OPERANDS - 1);   \
            statement;                     \
        }                                  \
    }
#ifdef HAVE_MPFR
#define LOOP_MPFR(name, statement) LOOP(name, statement)
#define WITH_MPFR(f) f
#else
#define LOOP_MPFR(name, statement) enum { name##_is_absent }
#define WITH_MPFR(f) NULL
#endif
#ifdef HAVE_FLINT
#define LOOP_ARB(name, statement) LOOP(name, statement)
#define WITH_ARB(f) f
#else
#define LOOP_ARB(name, statement) enum { name##_is_absent }
#define WITH_ARB(f) NULL
#endif

#define BINARY(op)                                                        \
    LOOP(op##_ours, ball_##op(&bz[i], &bx[i], &by[i], bits))              \
    LOOP_MPFR(op##_mpfr, mpfr_##op(mz[i], mx[i], my[i], MPFR_RNDN))       \
    LOOP_ARB(op##_arb, arb_##op(&az[i], &ax[i], &ay[i], bits))
#define UNARY(op)                                                         \
    LOOP(op##_ours, ball_##op(&bz[i], &bx[i], bits))                      \
    LOOP_MPFR(op##_mpfr, mpfr_##op(mz[i], mx[i], MPFR_RNDN))              \
    LOOP_ARB(op##_arb, arb_##op(&az[i], &ax[i], bits))

BINARY(add)
BINARY(sub)
BINARY(mul)
BINARY(div)
UNARY(sqrt)
LOOP(sqr_ours, ball_sqr(&bz[i], &bx[i], bits))
LOOP_MPFR(sqr_mpfr, mpfr_sqr(mz[i], mx[i], MPFR_RNDN))
LOOP_ARB(sqr_arb, arb_mul(&az[i], &ax[i], &ax[i], bits))
LOOP(addmul_ours, (ball_set(&bz[i], &by[i]), ball_addmul(&bz[i], &bx[i], &by[i], bits)))
LOOP_MPFR(addmul_mpfr, mpfr_fma(mz[i], mx[i], my[i], my[i], MPFR_RNDN))
LOOP_ARB(addmul_arb, (arb_set(&az[i], &ay[i]), arb_addmul(&az[i], &ax[i], &ay[i], bits)))

#define FIRST(i) ((i) & ~(DOT_TERMS - 1))
LOOP(dot_ours, ball_dot(&bz[i], bx + FIRST(i), by + FIRST(i), DOT_TERMS, bits))
LOOP_ARB(dot_arb, arb_dot(&az[i], NULL, 0, ax + FIRST(i), 1, ay + FIRST(i), 1, DOT_TERMS, bits))

LOOP(sign_ours, answer += ball_is_positive(&bx[i]))
LOOP_MPFR(sign_mpfr, answer += mpfr_sgn(mx[i]))
LOOP_ARB(sign_arb, answer += arb_is_positive(&ax[i]))
LOOP(less_ours, answer += ball_less(&bx[i], &by[i]))
LOOP_MPFR(less_mpfr, answer += mpfr_less_p(mx[i], my[i]))
LOOP_ARB(less_arb, answer += arb_lt(&ax[i], &ay[i]))
LOOP(contains_ours, answer += ball_contains(&bx[i], &by[i]))
LOOP_ARB(contains_arb, answer += arb_contains(&ax[i], &ay[i]))

UNARY(sin)
UNARY(cos)
UNARY(atan)
LOOP(sin_cos_ours, ball_sin_cos(&bz[i], &bw, &bx[i], bits))
LOOP_MPFR(sin_cos_mpfr, mpfr_sin_cos(mz[i], mw, mx[i], MPFR_RNDN))
LOOP_ARB(sin_cos_arb, arb_sin_cos(&az[i], aw, &ax[i], bits))
LOOP(cos_pi_ours, ball_cos_pi(&bz[i], &angle[i], bits))
LOOP_ARB(cos_pi_arb, arb_cos_pi_fmpq(&az[i], &aangle[i], bits))
LOOP(pi_ours, ball_pi(&bz[i], bits))

LOOP(grid_add_ours, grid_add(&gz[i], &gx[i], &gy[i], 64))
LOOP(grid_mul_ours, grid_mul(&gz[i], &gx[i], &gy[i], 64))
LOOP(grid_addmul_ours, (grid_set(&gz[i], &gx[i]), grid_addmul(&gz[i], &gx[i], &gy[i], 64)))

/* Hardware intervals: whole arrays. */
#if defined(__GNUC__)
#define FORGET() __asm__ volatile("" : : "r"(hz), "r"(hx), "r"(hy) : "memory")
#else
#define FORGET() ((void)0)
#endif
#define ARRAYS(name, statement)                                  \
    static INTERVAL_NOINLINE void name##_arrays(long n)          \
    {                                                            \
        for (long j = 0; j < n; j += BATCH) {                    \
            statement;                                           \
            FORGET();                                            \
        }                                                        \
    }                                                            \
    static void name(long n)                                     \
    {                                                            \
        interval_mode mode = interval_enter();                   \
        name##_arrays(n);                                        \
        interval_leave(mode);                                    \
    }
#define EACH(call) for (int i = 0; i < BATCH; i++) call(&hz[i], &hx[i], &hy[i], 0)
ARRAYS(interval_add_scalar, EACH(interval_add))
ARRAYS(interval_mul_scalar, EACH(interval_mul))
ARRAYS(interval_div_scalar, EACH(interval_div))
#ifdef HAVE_BATCH
ARRAYS(interval_add_batched, interval_batch_add(hz, hx, hy, BATCH))
ARRAYS(interval_mul_batched, interval_batch_mul(hz, hx, hy, BATCH))
#endif

/* ---- the table ---- */

typedef struct {
    const char *name;
    kernel ours, mpfr, arb;
    kind operands[3];
    int kinds;
    long sizes[10];
} operation;

#define ALL_SIZES {64, 128, 192, 256, 512, 1024, 2048, 4096}
#define FUNCTION_SIZES {64, 128, 192, 256, 512, 1024, 10000}
#define ROW(op, ...) {#op, op##_ours, WITH_MPFR(op##_mpfr), WITH_ARB(op##_arb), __VA_ARGS__}
#define ROW_NO_MPFR(op, ...) {#op, op##_ours, NULL, WITH_ARB(op##_arb), __VA_ARGS__}
#define ROW_ALONE(name, f, bits) {name, f, NULL, NULL, {NONE}, 1, {bits}}

static const operation operations[] = {
    ROW(add, {BALL, THIN}, 2, ALL_SIZES),
    ROW(sub, {BALL, THIN}, 2, ALL_SIZES),
    ROW(mul, {BALL, THIN}, 2, ALL_SIZES),
    ROW(sqr, {BALL, THIN}, 2, ALL_SIZES),
    ROW(addmul, {BALL, THIN}, 2, ALL_SIZES),
    ROW_NO_MPFR(dot, {BALL, THIN}, 2, {64, 128, 192, 256, 512, 1024, 4096}),
    ROW(div, {BALL, THIN}, 2, ALL_SIZES),
    ROW(sqrt, {POSITIVE, POSITIVE_THIN}, 2, ALL_SIZES),
    ROW(sign, {BALL}, 1, ALL_SIZES),
    ROW(less, {BALL, CLOSE}, 2, ALL_SIZES),
    ROW_NO_MPFR(contains, {BALL, CLOSE}, 2, ALL_SIZES),
    ROW(sin, {BALL, THIN}, 2, FUNCTION_SIZES),
    ROW(cos, {BALL, THIN}, 2, FUNCTION_SIZES),
    ROW(sin_cos, {BALL}, 1, FUNCTION_SIZES),
    ROW_NO_MPFR(cos_pi, {NONE}, 1, FUNCTION_SIZES),
    ROW(atan, {BALL}, 1, FUNCTION_SIZES),
    {"pi", pi_ours, NULL, NULL, {NONE}, 1, FUNCTION_SIZES}, /* the others keep theirs in a cache */
    ROW_ALONE("grid-add", grid_add_ours, 64),
    ROW_ALONE("grid-mul", grid_mul_ours, 64),
    ROW_ALONE("grid-addmul", grid_addmul_ours, 64),
    ROW_ALONE("grid-mul-word", grid_mul_ours, 63), /* endpoints of one word */
    ROW_ALONE("interval-add", interval_add_scalar, 53),
    ROW_ALONE("interval-mul", interval_mul_scalar, 53),
    ROW_ALONE("interval-div", interval_div_scalar, 53),
#ifdef HAVE_BATCH
    ROW_ALONE("batch-add", interval_add_batched, 53),
    ROW_ALONE("batch-mul", interval_mul_batched, 53),
#endif
};

typedef struct {
    const char *name;
    kind k;
    long bits;
    double ours, mpfr, arb; /* ns; 0: not measured */
} result;

static result results[400];
static int count;

static double run(kernel f, long n)
{
    double t = seconds();
    f(n);
    return seconds() - t;
}

static int by_size(const void *a, const void *b)
{
    double u = *(const double *)a, v = *(const double *)b;
    return u < v ? -1 : u > v;
}

static double median(double *t)
{
    qsort(t, REPETITIONS, sizeof *t, by_size);
    return t[REPETITIONS / 2];
}

/* So many operations that they take SECONDS_PER_RUN. */
static long enough(kernel f)
{
    f(LEAST_OPERANDS); /* caches, branch predictors */
    long n = LEAST_OPERANDS;
    while (run(f, n) < SECONDS_PER_RUN)
        n *= 2;
    return n;
}

static void measure(const operation *op, kind k)
{
    const kernel f[3] = {op->ours, op->mpfr, op->arb};
    double t[3][REPETITIONS] = {{0}};
    long n[3];
    for (int i = 0; i < 3; i++)
        n[i] = f[i] ? enough(f[i]) : 1;
    for (int r = 0; r < REPETITIONS; r++)
        for (int i = 0; i < 3; i++)
            if (f[i])
                t[i][r] = 1e9 * run(f[i], n[i]) / (double)n[i];
    result *z = &results[count++];
    *z = (result){op->name, k, bits, median(t[0]), median(t[1]), median(t[2])};
    printf("%-14s %-5s %6ld %12.1f", z->name, kind_name[k], bits, z->ours);
    z->mpfr > 0 ? printf(" %12.1f", z->mpfr) : printf(" %12s", "");
    z->arb > 0 ? printf(" %12.1f", z->arb) : printf(" %12s", "");
    z->mpfr > 0 ? printf(" %9.2f", z->mpfr / z->ours) : printf(" %9s", "");
    if (z->arb > 0)
        printf(" %9.2f", z->arb / z->ours);
    printf("\n");
    fflush(stdout);
}

static void measure_all(const operation *op)
{
    for (int k = 0; k < op->kinds; k++)
        for (const long *size = op->sizes; *size; size++) {
            bits = *size;
            load(op->operands[k]);
            if (strncmp(op->name, "grid", 4) == 0)
                for (int i = 0; i < OPERANDS; i++) {
                    state = (uint64_t)i;
                    fill_grid(&gx[i], bits == 63 ? 0 : 3);
                    fill_grid(&gy[i], bits == 63 ? 0 : 3);
                }
            measure(op, op->operands[k]);
        }
}

/* ---- goals ---- */

typedef struct {
    const char *what;
    const char *names; /* separated by blanks */
    kind k;
    long from, to;
    enum { ARB_RATIO, MPFR_RATIO, NANOSECONDS } measure;
    double mean, worst; /* bounds for the geometric mean and for each; 0 = none */
} goal;

/* In brackets: no goal, the same for exact operands. */
static const goal goals[] = {
    {"add, sub, mul against arb: 2 in the mean, none below 1", "add sub mul", BALL, 64, 256, ARB_RATIO, 2, 1},
    {"(add, sub, mul of exact operands)", "add sub mul", THIN, 64, 256, ARB_RATIO, 2, 1},
    {"dot product of 16 terms against arb: 1.3", "dot", BALL, 64, 512, ARB_RATIO, 1.3, 0},
    {"(dot product of exact operands)", "dot", THIN, 64, 512, ARB_RATIO, 1.3, 0},
    {"mul of many bits against arb: 0.6", "mul", BALL, 512, 4096, ARB_RATIO, 0, 0.6},
    {"(mul of exact operands)", "mul", THIN, 512, 4096, ARB_RATIO, 0, 0.6},
    {"sin, cos against MPFR: 1", "sin cos", BALL, 64, 1024, MPFR_RATIO, 0, 1},
    {"(sin, cos of exact operands)", "sin cos", THIN, 64, 1024, MPFR_RATIO, 0, 1},
    {"sign, comparison, containment: 10 ns", "sign less contains", BALL, 64, 4096, NANOSECONDS, 0, 10},
    {"interval sum in a batch: 0.6 ns", "batch-add", NONE, 0, 100, NANOSECONDS, 0, 0.6},
    {"interval product in a batch: 0.9 ns", "batch-mul", NONE, 0, 100, NANOSECONDS, 0, 0.9},
};

static bool names_it(const char *names, const char *name)
{
    size_t n = strlen(name);
    for (const char *p = names; (p = strstr(p, name)) != NULL; p += n)
        if ((p == names || p[-1] == ' ') && (p[n] == 0 || p[n] == ' '))
            return true;
    return false;
}

static void judge(const goal *g)
{
    double logs = 0, worst = g->measure == NANOSECONDS ? 0 : HUGE_VAL;
    int n = 0;
    for (int i = 0; i < count; i++) {
        const result *r = &results[i];
        double v = g->measure == ARB_RATIO ? r->arb / r->ours : g->measure == MPFR_RATIO ? r->mpfr / r->ours : r->ours;
        if (!names_it(g->names, r->name) || r->k != g->k || r->bits < g->from || r->bits > g->to || !(v > 0))
            continue;
        logs += log(v);
        worst = g->measure == NANOSECONDS ? fmax(worst, v) : fmin(worst, v);
        n++;
    }
    if (n == 0)
        return;
    double mean = exp(logs / n);
    bool met = g->measure == NANOSECONDS ? worst <= g->worst : mean >= g->mean && worst >= g->worst;
    printf("%-60s mean %7.2f  worst %7.2f  %s\n", g->what, mean, worst, g->what[0] == '(' ? "" : met ? "met" : "MISSED");
}

static void print_machine(void)
{
    char line[256] = "model name\t: unknown\n";
    FILE *f = fopen("/proc/cpuinfo", "r");
    while (f && fgets(line, sizeof line, f) && strncmp(line, "model name", 10) != 0)
        ;
    if (f)
        fclose(f);
    const char *name = strchr(line, ':');
    printf("processor: %s", name ? name + 2 : "unknown\n");
#ifdef __VERSION__
    printf("compiler: %s%s\n",
#ifdef __clang__
           "",
#else
           "gcc ",
#endif
           __VERSION__);
#endif
#ifdef HAVE_MPFR
    printf("MPFR %s\n", mpfr_get_version());
#endif
#ifdef HAVE_FLINT
    printf("FLINT %s\n", FLINT_VERSION);
#endif
}

static void start(void)
{
    for (int i = 0; i < OPERANDS; i++) {
        ball_init(&bx[i]), ball_init(&by[i]), ball_init(&bz[i]);
        grid_init(&gx[i]), grid_init(&gy[i]), grid_init(&gz[i]);
        rational_init(&angle[i]);
#ifdef HAVE_MPFR
        mpfr_init(mx[i]), mpfr_init(my[i]), mpfr_init(mz[i]);
#endif
#ifdef HAVE_FLINT
        arb_init(&ax[i]), arb_init(&ay[i]), arb_init(&az[i]);
        fmpq_init(&aangle[i]);
#endif
    }
    ball_init(&bw);
#ifdef HAVE_MPFR
    mpfr_init(mw);
#endif
#ifdef HAVE_FLINT
    arb_init(aw);
#endif
}

int main(int argc, char **argv)
{
    start();
    load_others();
    print_machine();
    printf("\n%-14s %-5s %6s %12s %12s %12s %9s %9s\n", "operation", "", "bits", "ours, ns", "MPFR, ns", "arb, ns", "MPFR/ours",
           "arb/ours");
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        bool asked = argc < 2;
        for (int a = 1; a < argc; a++)
            asked = asked || strcmp(argv[a], operations[i].name) == 0;
        if (asked)
            measure_all(&operations[i]);
    }
    printf("\n");
    for (size_t i = 0; i < sizeof goals / sizeof *goals; i++)
        judge(&goals[i]);
    return 0;
}
