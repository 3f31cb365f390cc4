/* Unit tests of what the independent checker needs for several valences: affine numbers,
 * formulas over ranges, slopes of eigenpairs, blocks.  Protocol as in t-check-units.c. */

#define _POSIX_C_SOURCE 200809L

#include "../../verify/check/answer.c"
#include "../../verify/check/scratch.c"
#include "../../verify/check/integer.c"
#include "../../verify/check/rational.c"
#include "../../verify/check/grid.c"
#include "../../verify/check/trig.c"
#include "../../verify/check/affine.c"
#include "../../verify/check/text.c"
#include "../../verify/check/formula.c"
#include "../../verify/check/value.c"
#include "../../verify/check/evaluate.c"
#include "../../verify/check/mask.c"
#include "../../verify/check/symmetry.c"
#include "../../verify/check/scheme.c"
#include "../../verify/check/valence.c"
#include "../../verify/check/sector.c"
#include "../../verify/check/eigenpair.c"
#include "../../verify/check/spectrum.c"

#include <stdio.h>
#include <stdlib.h>

enum { G = 24, FINE = 128 };

static int failures;

static void report(const char *name, bool good)
{
    printf(good ? "PASS %s\n" : "FAIL %s: it does not hold\n", name);
    failures += good ? 0 : 1;
}

static uint64_t state = 1;

/* From -n to n. */
static int64_t draw(int64_t n)
{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (int64_t)((state >> 33) % (uint64_t)(2 * n + 1)) - n;
}

/* Affine numbers
 * --------------
 *
 * Functions of t in [-1, 1] with what is computed for them. */
struct function {
    rational at[2];                                /* at the two t's */
    struct affine x;
};

static rational in_units(integer a)
{
    return rational_reduce(a, integer_shift_left(integer_from(1), G));
}

/* Is q in c + d t? */
static bool encloses(interval c, interval d, rational t, rational q)
{
    rational x = rational_mul(in_units(d.lo), t), y = rational_mul(in_units(d.hi), t);
    bool rising = rational_compare(x, y) <= 0;

    return rational_compare(rational_add(in_units(c.lo), rising ? x : y), q) <= 0 &&
           rational_compare(rational_add(in_units(c.hi), rising ? y : x), q) >= 0;
}

/* c + d t, around some of it */
static struct function draw_function(const rational t[2])
{
    rational c = rational_from(draw(5000), 1000), d = rational_from(draw(3000), 1000);
    struct function out;

    out.x = (struct affine) { grid_from_rational(c, G), grid_from_rational(d, G) };
    for (int i = 0; i < 2; i++)
        out.at[i] = rational_add(c, rational_mul(d, t[i]));
    return out;
}

static struct function apply_both(struct function f, char operation, struct function h)
{
    for (int i = 0; i < 2; i++)
        f.at[i] = operation == '-' ? rational_sub(f.at[i], h.at[i])
                                   : apply_to_ends(f.at[i], operation, h.at[i]);
    f.x = operation == '+' ? affine_add(f.x, h.x) : operation == '-' ? affine_sub(f.x, h.x)
        : operation == '*' ? affine_mul(f.x, h.x, G) : affine_div(f.x, h.x, G);
    return f;
}

static bool is_enclosed_and_sloped(const struct function *f, const rational t[2])
{
    static const interval zero;

    return encloses(f->x.c, f->x.d, t[0], f->at[0]) &&
           encloses(zero, f->x.d, rational_sub(t[0], t[1]),
                    rational_sub(f->at[0], f->at[1]));
}

static bool try_expression(void)
{
    rational t[2] = { rational_from(draw(1000), 1000), rational_from(draw(1000), 1000) };
    struct function f = draw_function(t);
    bool good = is_enclosed_and_sloped(&f, t);

    for (int i = 0; i < 4; i++) {
        struct function h = draw_function(t);
        char operation = "+-*/"[draw(100) & 3];

        if (operation == '/' && interval_contains_zero(affine_range(h.x)))
            continue;
        f = draw(1) < 0 ? apply_both(h, '-', f) : f;
        f = apply_both(f, operation, h);
        good = good && is_enclosed_and_sloped(&f, t);
    }
    return good;
}

static void test_affine(void)
{
    bool good = true;

    for (int i = 0; i < 3000; i++) {
        struct mark mark = scratch_mark();

        good = good && try_expression();
        scratch_release(mark);
    }
    report("affine-expressions", good);
}

static void test_cosine(void)
{
    bool good = true;

    for (int i = 0; i < 200; i++) {
        int64_t a = draw(250) + 250, b = draw(250) + 250;
        rational q = rational_from(a < b ? a : b, 1000), last = rational_from(a < b ? b : a, 1000);
        struct affine u = affine_cosine(q, last, FINE);

        good = good && integer_compare(u.c.lo, u.c.hi) == 0 && u.d.lo.sign >= 0 &&
               (a == b || u.d.lo.sign > 0) && integer_compare(u.d.lo, u.d.hi) == 0;
        for (int n = 0; n <= 4; n++) {             /* points between */
            rational r = rational_add(q, rational_mul(rational_sub(last, q), rational_from(n, 4)));
            interval cosine = grid_cos_pi(r, FINE), all = affine_range(u);

            good = good && integer_compare(all.lo, cosine.lo) <= 0 &&
                   integer_compare(cosine.hi, all.hi) <= 0;
        }
    }
    report("affine-cosine", good);
}

/* Formulas
 * -------- */

static const char *const formulas[] = {
    "1/k", "m/k", "k - k", "m - k/2", "(m + 1)/(k + 2) - 3*k", "2*pi*m/k", "cos(2*pi*m/k)",
    "sin(pi*m/k)", "cos(2*pi/k)^2/4 + 3/8", "sqrt(1/k)", "abs(m - k)", "min(1/k, 1/10)",
    "max(m/k, 1/4)", "2^-m", "(1/3)^(k - m)", "(1/2)^(2*k - 15)", "3^(2 - k)", "(1/k)^3",
    "cases(k < 10: 1/k; k < 12: 2/k; else: 3/k)", "cases(m = 2: 1; m < k: 2; else: 3)",
    "cases(k > 2: 7; else: 1/0)", "(k - 5/k)/(m/k + 1)", "-(k + m)", "cos(pi*k)", "1/(3 - k)",
    "(k + 3)/2", "pi*k/(pi*k + pi)", "cos(pi*m/(k + 1)) * m", "1/(0 - k) * (-3)",
    "cos(0 - pi*m/k)", "sin(2*pi/k + 0*k)"
};

static struct value value_at(const char *text, struct span k, struct span m)
{
    static struct language l = { .file = "formula" };
    struct cursor c = { "formula", 1, text, text, text + strlen(text) };
    struct environment e = environment_make(&l, k, m, NOTHING, FINE);

    return evaluate(formula_read(&c, &l, MEANS_K | MEANS_M), &e);
}

static bool is_known(const struct value *v)
{
    return v->kind != UNDEFINED && !is_unbounded(v);
}

/* Every value at a valence and a frequency is within that of the range. */
static bool holds_over(const char *text, struct span k, struct span m)
{
    struct value all = value_at(text, k, m);
    bool good = true;

    for (int64_t x = k.first; x <= k.last && x < k.first + 40; x += x < 30 ? 1 : 7) {
        for (int64_t y = m.first; y <= m.last && y < m.first + 20; y++) {
            struct mark mark = scratch_mark();
            struct value v = value_at(text, span_of(x), span_of(y));

            if (is_known(&all) && is_known(&v)) {
                interval a = value_enclose(all, FINE), b = value_enclose(v, FINE);

                good = good && integer_compare(a.lo, b.hi) <= 0 &&
                       integer_compare(b.lo, a.hi) <= 0;
            }
            scratch_release(mark);
        }
    }
    return good;
}

static void test_formulas(void)
{
    static const struct span ks[] = { { 8, 20 }, { 8, ENDLESS }, { 9, 10 }, { 7, 7 } };
    static const struct span ms[] = { { 0, 0 }, { 1, 1 }, { 2, 5 }, { 2, ENDLESS } };

    for (size_t i = 0; i < sizeof formulas / sizeof formulas[0]; i++) {
        bool good = true;

        for (int x = 0; x < 4; x++)
            for (int y = 0; y < 4; y++)
                good = good && holds_over(formulas[i], ks[x], ms[y]);
        report(formulas[i], good);
    }
}

/* num[0]/den .. num[1]/den exactly over k = 8..last, m = 2..6 */
static void test_ends(void)
{
    static const struct {
        const char *text;
        int64_t last, low, high, den;
    } trial[] = {
        { "1/k", ENDLESS, 0, 1, 8 }, { "1/k", 16, 1, 2, 16 }, { "m/k", ENDLESS, 0, 3, 4 },
        { "k - k", 20, -12, 12, 1 }, { "m - 2*k", 10, -18, -10, 1 },
        { "-m/k", 16, -6, -1, 8 }, { "k/m", 12, 4, 18, 3 }, { "0*k", ENDLESS, 0, 0, 1 },
        { "(k - k + 1)/k", ENDLESS, 0, 0, 0 }, { "k", ENDLESS, 0, 0, 0 },
        { "k/k", ENDLESS, 0, 0, 0 }, { "k*m", ENDLESS, 0, 0, 0 }, { "k*m", 20, 16, 120, 1 },
        { "2^k", ENDLESS, 0, 0, 0 }, { "2^-k", ENDLESS, 0, 1, 256 },
        { "2^(-k/2)", 10, 0, 0, 0 }, { "2^(-k/2)", ENDLESS, 0, 0, 0 },
        { "(1/2)^(k - m)", 9, 1, 32, 128 }, { "mod(k, 2)", 20, 0, 0, 0 },
        { "1/(k - 10)", 20, 0, 0, 0 }, { "1/(k - 8)", 20, 0, 0, 0 },
        { "sqrt(k)", ENDLESS, 0, 0, 0 }, { "cos(k)", 20, 0, 0, 0 },
        { "cos(pi*k)", ENDLESS, -1, 1, 1 }, { "cos(2*pi/k)", ENDLESS, 0, 0, 0 },
        { "cos(0 - 4*pi/k)", 12, 0, 1, 2 }, { "cos(4*pi/k + 0*k)", 12, 0, 1, 2 },
        { "cos(pi*k - 0)", ENDLESS, -1, 1, 1 }, { "cos(4*pi/k + 1)", 12, 0, 0, 0 },
        { "cos(4*pi/k + (k - 8))", 12, 0, 0, 0 }, { "cos(4*pi/k + (k - 12))", 12, 0, 0, 0 },
        { "cos(0*k*pi + 1)", 12, 0, 0, 0 },
        { "cases(k < 8: 5; k >= 8: 6)", ENDLESS, 6, 6, 1 },
        { "cases(k < 9: 5; else: 6)", ENDLESS, 5, 6, 1 },
        { "cases(k < 9: 5; k >= 9: 6)", ENDLESS, 0, 0, 0 },
    };

    for (size_t i = 0; i < sizeof trial / sizeof trial[0]; i++) {
        struct value v = value_at(trial[i].text, (struct span) { 8, trial[i].last },
                                  (struct span) { 2, 6 });
        char name[64];
        bool good = !is_known(&v);

        if (trial[i].den > 0) {
            interval x = is_known(&v) ? value_enclose(v, FINE) : grid_from(1000, FINE);
            interval expected = interval_hull(
                grid_from_rational(rational_from(trial[i].low, trial[i].den), FINE),
                grid_from_rational(rational_from(trial[i].high, trial[i].den), FINE));

            good = integer_compare(x.lo, expected.lo) == 0 &&
                   integer_compare(x.hi, expected.hi) == 0;
        } else if (strcmp(trial[i].text, "cos(2*pi/k)") == 0) {
            good = is_known(&v);
        }
        snprintf(name, sizeof name, "ends of %s, %zu", trial[i].text, i);
        report(name, good);
    }
}

/* Slopes
 * ------
 *
 * M = (a + b t, 0; 1, 1/8): L = a + b t, x = (1, 1/(L - 1/8)). */
static bool slopes_are(int64_t b)
{
    interval slope = grid_from_rational(rational_from(b, 1024), FINE);
    struct affine m[4] = { { grid_from_rational(rational_from(1, 2), FINE), slope },
                           affine_from_whole(0, FINE), affine_from_whole(1, FINE),
                           affine_from(grid_from_rational(rational_from(1, 8), FINE)) };
    /* x = 8/3; G = (0, -1; -3/8, -8/3), Y = (64/9, -8/3; -1, 0) */
    integer eigenvector = grid_from_rational(rational_from(8, 3), FINE).lo;
    integer inverse[4] = { grid_from_rational(rational_from(64, 9), 32).lo,
                           grid_from_rational(rational_from(-8, 3), 32).lo,
                           grid_from(-1, 32).lo, integer_from(0) };
    struct certificate c = {
        .file = "certificate", .grid = FINE, .valence = { 3, 4 }, .real = true, .n = 2, .size = 2
    };
    struct choices choices = { .pivot = 1, .eigenvector = &eigenvector, .inverse = inverse };
    struct eigenpair pair;
    bool good = true;

    choices.eigenvalue[0] = m[0].c.lo;
    choices.eigenvalue[1] = integer_from(0);
    choices.radius = integer_shift_left(integer_from(1), FINE - 28);
    choices.range = integer_shift_left(integer_from(1), FINE - 5);
    pair = eigenpair_prove(m, &choices, &c);
    for (int t = -1; t <= 1; t++) {                /* L(t) and x(t) are enclosed */
        rational l = rational_from(512 + b * t, 1024);
        rational x = rational_divide(rational_from(1, 1), rational_sub(l, rational_from(1, 8)));
        interval step = grid_from(t, FINE), v;

        v = interval_add(pair.real.c, grid_mul(pair.real.d, step, FINE));
        good = good && !interval_is_positive(interval_sub(v, grid_from_rational(l, FINE))) &&
               !interval_is_positive(interval_sub(grid_from_rational(l, FINE), v));
        v = interval_add(pair.unknowns[1].c, grid_mul(pair.unknowns[1].d, step, FINE));
        good = good && !interval_is_positive(interval_sub(v, grid_from_rational(x, FINE))) &&
               !interval_is_positive(interval_sub(grid_from_rational(x, FINE), v));
    }
    return good && pair.real.d.lo.sign == (b > 0) - (b < 0);
}

/* Blocks
 * ------ */

/* Does (c, d) fit what it is at k, for t = (cos(pi m/k) - c_u)/d_u? */
static bool fits(struct affine x, interval t, interval single)
{
    interval v = interval_add(x.c, grid_mul(x.d, t, FINE));

    return integer_compare(v.lo, single.hi) <= 0 && integer_compare(single.lo, v.hi) <= 0;
}

static bool blocks_fit(const char *name, int64_t first, int64_t last, struct span m)
{
    static struct valence all, one;
    struct reference reference = { "certificate", 1 };
    struct scheme *scheme = allocate(1, sizeof *scheme);
    const char *source = getenv("SRCDIR");
    char file[1000], *text;
    size_t size;
    struct affine u = affine_cosine(rational_from(m.first, last), rational_from(m.last, first),
                                    FINE);
    struct block block, single;
    struct affine *matrix, *here;
    bool good = true;

    snprintf(file, sizeof file, "%s/lib/catalogue/%s.scheme", source != NULL ? source : ".",
             name);
    text = text_read_file(file, 65536, &size);
    scheme_read(scheme, file, text, size);
    valence_prepare(&all, scheme, reference, (struct span) { first, last }, FINE);
    block_prepare_over(&block, &all, m, u);
    matrix = block_matrix(&block);
    for (int64_t k = first; k <= last; k++) {
        for (int64_t n = m.first; n <= m.last; n++) {
            interval t = grid_div(interval_sub(grid_cos_pi(rational_from(n, k), FINE), u.c), u.d,
                                  FINE);

            valence_prepare(&one, scheme, reference, span_of(k), FINE);
            block_prepare(&single, &one, true, span_of(n));
            here = block_matrix(&single);
            for (int i = 0; i < block.size * block.size; i++)
                good = good && fits(matrix[i], t, here[i].c);
        }
    }
    return good;
}

int main(void)
{
    test_affine();
    test_cosine();
    test_formulas();
    test_ends();
    report("slopes-rising", slopes_are(1));
    report("slopes-falling", slopes_are(-1));
    report("slopes-none", slopes_are(0));
    report("blocks-loop", blocks_fit("loop", 20, 24, span_of(1)));
    report("blocks-loop-of-several-frequencies",
           blocks_fit("loop", 20, 22, (struct span) { 2, 4 }));
    report("blocks-catmull-clark", blocks_fit("catmull-clark", 9, 12, span_of(2)));
    report("blocks-kobbelt", blocks_fit("kobbelt", 30, 32, span_of(1)));
    report("blocks-modified-butterfly",
           blocks_fit("modified-butterfly", 20, 22, (struct span) { 1, 3 }));
    return failures == 0 ? 0 : 1;
}
