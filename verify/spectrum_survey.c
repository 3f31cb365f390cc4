/* spectrum_survey.c: the spectrum at a large valence, without enumerating blocks.  Compiled once per number system.

   Doubles suggest which block has the largest eigenvalue L: the *top*.  That all other blocks m >= 1 have smaller ones is
   proved side by side: next to the top along a chain on which the largest eigenvalue falls from frequency to
   frequency (lib/monotone.h), farther off in boxes (lib/cover.h).  Where L(w) has its maximum at the top or beside it,
   a chain can only start some blocks away from it, and these blocks are boxes of one. */
#include "spectrum_blocks.h"
#include "spectrum_doubles.h"

#include "../lib/cover.h"
#include "../lib/monotone.h"

#include <math.h>
#include <stdlib.h>

#define survey_blocks NUMBER_NAME(survey_blocks)
status survey_blocks(spectrum_list *z, spectrum_doubles *doubles, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d);

typedef struct {
    spectrum_list *list;
    scheme_numbers numbers;
    diagnostic *complaint;
    bool mirror_symmetric;
    long half;           /* k/2 */
    spectrum_doubles *doubles;
    number lower;        /* thin, <= L */
    double rival;        /* the largest modulus besides L that has an entry, at most */
} survey;

/* ---- the search for the top ---- */

static double radius_approx(survey *z, long m)
{
    return spectrum_doubles_radius(z->doubles, m);
}

#define EQUAL_PARTS 96
#define FIRST_SAMPLES 8
#define STEP 1.4

/* The next frequency to look at: all of the first, then in growing steps, then in equal ones. */
static long next_sample(long m, long half)
{
    double step = m < FIRST_SAMPLES ? 1 : fmin((double)m * (STEP - 1), (double)half / EQUAL_PARTS + 1);
    long next = m + (step < 1 ? 1 : (long)step);
    return m == half ? half + 1 : next > half ? half : next;
}

/* The best sample and the ones beside it. */
static long best_sample(long *left, long *right, survey *z)
{
    double best = -1;
    long found = 1, last = 1;
    *left = *right = 1;
    for (long m = 1; m <= z->half; last = m, m = next_sample(m, z->half)) {
        double radius = radius_approx(z, m);
        if (radius > best * (1 + 1e-13)) {
            best = radius;
            found = m;
            *left = last;
            *right = m;
        }
        if (last == found && m > found)
            *right = m;
    }
    return found;
}

/* Between left, where L still rises with the frequency, and right, where it falls, the top by the sign of the slope, which
   tells it far better than values do.  At the frequency k/2 itself L is even in u: nothing need fall there.  0: it does not
   work. */
static long bisect_slope(long left, long right, survey *z)
{
    number x, y;
    int sign = -1, other = 1;
    number_init(&x);
    number_init(&y);
    if (monotone_direction(&x, &sign, &z->numbers, left, z->complaint) != BLOCK_OK || monotone_direction(&y, &other, &z->numbers, right, z->complaint) != BLOCK_OK || sign != -1 || (other != 1 && right != z->half))
        left = right = 0;
    while (right - left > 1) {
        long middle = left + (right - left) / 2;
        if (monotone_direction(&x, &sign, &z->numbers, middle, z->complaint) != BLOCK_OK || sign == 0)
            left = right = middle;
        else
            *(sign < 0 ? &left : &right) = middle;
    }
    if (right - left == 1 && right == z->half && other != 1)
        left = right;
    if (right - left == 1 && monotone_direction(&x, &sign, &z->numbers, left, z->complaint) == BLOCK_OK && sign && monotone_direction(&y, &other, &z->numbers, right, z->complaint) == BLOCK_OK
        && other && number_less(&x, &y) == TRUTH_TRUE)
        left = right;
    number_clear(&x);
    number_clear(&y);
    return left;
}

/* Between the neighbours of the best sample: by slopes, or by thirds. */
static long find_top(survey *z)
{
    long left, right, top = best_sample(&left, &right, z);
    if (right - left <= 1 || top == 1)
        return top;
    if (z->mirror_symmetric) {
        long found = bisect_slope(left, right, z);
        if (found && radius_approx(z, found) >= radius_approx(z, top) * (1 - 1e-10))
            return found;
    }
    while (right - left > 2) {
        long third = (right - left + 2) / 3, p = left + third, q = right - third;
        if (radius_approx(z, p) < radius_approx(z, q))
            left = p;
        else
            right = q;
    }
    for (long m = left; m <= right; m++)
        if (radius_approx(z, m) > radius_approx(z, top))
            top = m;
    return top;
}

/* ---- entries ---- */

static bool has_entries(const survey *z, long m)
{
    return m < 4 || labs(m - z->list->top) <= 1;
}

/* Blocks 0 to 3, the top and its neighbours. */
static status list_entries(survey *z, int digits)
{
    long top = z->list->top;
    status result = STATUS_OK;
    for (long m = 0; result == STATUS_OK && m <= z->half; m = m == 3 && top > 5 ? top - 1 : m + 1) {
        if (!has_entries(z, m))
            break;
        result = spectrum_list_block(z->list, &z->numbers, m, digits, z->complaint);
    }
    return result;
}

/* lower = about the largest number that the largest modulus in block `top`, without 1 in block 0, certainly reaches; 0
   if nothing is known. */
static status find_lower(survey *z)
{
    block b;
    eigenvalues e;
    number modulus, one;
    status result = block_complaint(block_make(&b, &z->numbers, z->list->top, z->mirror_symmetric, z->complaint), z->complaint);
    number_init(&modulus);
    number_init(&one);
    number_one(&one);
    number_zero(&z->lower);
    if (result == STATUS_OK) {
        if (eigenvalues_enclose(&e, b.entry, b.imaginary, b.n, z->numbers.prec) == TRUTH_TRUE) {
            bool skip = z->list->top == 0;
            for (int i = 0; i < e.count; i++) {
                disc_modulus(&modulus, &e.disc[i], z->numbers.prec);
                if (skip && number_contains(&modulus, &one)) {
                    skip = false;
                    continue;
                }
                number_lower(&modulus, &modulus, z->numbers.prec);
                number_max(&z->lower, &z->lower, &modulus, z->numbers.prec);
            }
        }
        eigenvalues_free(&e);
    }
    block_free(&b);
    number_clear(&modulus);
    number_clear(&one);
    return result;
}

/* ---- the sides ---- */

/* How long to try: a few boxes for a quick bound, more to go on without a chain, many before something is left open;
   fewer where a box costs more. */
typedef enum { QUICK, STRICT, LENIENT } effort;

static cover_limits limits_of(const survey *z, effort e)
{
    static const double tries[] = {100, 400, 8000}, most[] = {100, 400, 1000};
    double size = spectrum_doubles_size(z->doubles), factor = fmin(1, 1000 / (size * size * size + 1));
    return (cover_limits){.tries = (long)fmin(fmax(tries[e] * factor, 20), most[e]), .open = e == LENIENT ? 40 : 0, .power = 10000};
}

/* Are all eigenvalues of the blocks smaller than `bound`, thin?  Double intervals prove what they can, numbers with more
   bits what is left. */
static status prove_below(bool *proved, frequencies *open, bool *exhausted, survey *z, frequencies m, const number *bound, effort e)
{
    cover_list list;
    cover_answer answer = {.status = BLOCK_OK, .proved = true};
    number scale;
    number_init(&scale);
    cover_list_init(&list);
#if !defined(NUMBER_INTERVAL)
    if (m.first <= m.last)
        m.first = spectrum_doubles_below(z->doubles, m, number_lower_bound(bound), limits_of(z, e).tries);
#endif
    if (m.first <= m.last) {
        number_inv(&scale, bound, z->numbers.prec);
        number_upper(&scale, &scale, z->numbers.prec);
        cover_limits limits = limits_of(z, e);
        answer = cover_search(&list, &z->numbers, &scale, m, &limits, z->complaint);
    }
    *proved = answer.proved;
    *open = answer.open;
    *exhausted = answer.exhausted;
    cover_list_clear(&list);
    number_clear(&scale);
    return block_complaint(answer.status, z->complaint);
}

static status prove_below_double(bool *proved, survey *z, frequencies m, double bound, effort e)
{
    frequencies open;
    bool exhausted;
    status result;
    number b;
    number_init(&b);
    number_set_double(&b, bound, z->numbers.prec);
    result = prove_below(proved, &open, &exhausted, z, m, &b, e);
    number_clear(&b);
    return result;
}

static void widen(frequencies *z, frequencies m)
{
    if (z->first > z->last)
        *z = m;
    z->first = m.first < z->first ? m.first : z->first;
    z->last = m.last > z->last ? m.last : z->last;
}

/* Are the blocks not, or hardly, larger than the rival?  *upper = a bound that is proved. */
static status prove_no_rival(bool *proved, double *upper, survey *z, frequencies m)
{
    static const double slack[] = {0x1p-30, 0x1p-12, 0x1p-8, 0x1p-5};
    status result = STATUS_OK;
    *proved = false;
    for (size_t i = 0; result == STATUS_OK && !*proved && i < sizeof slack / sizeof *slack; i++) {
        *upper = z->rival * (1 + slack[i]);
        if (*upper > 0 && *upper < number_lower_bound(&z->lower))
            result = prove_below_double(proved, z, m, *upper, STRICT);
    }
    return result;
}

/* Blocks that no chain puts in order: no rivals if that goes, at least smaller than L.  If not even that goes in few
   tries, *proved = false, and nothing is said of them. */
static status try_rest(bool *proved, survey *z, frequencies m)
{
    bool exhausted;
    frequencies open;
    double upper;
    status result = prove_no_rival(proved, &upper, z, m);
    if (result == STATUS_OK && !*proved && number_is_positive(&z->lower) == TRUTH_TRUE) {
        upper = number_upper_bound(&z->lower);
        result = prove_below(proved, &open, &exhausted, z, m, &z->lower, STRICT);
    }
    if (*proved)
        z->list->rest_upper = fmax(z->list->rest_upper, upper);
    return result;
}

/* The same with patience; what stays open is noted. */
static status prove_rest(survey *z, frequencies m)
{
    bool proved, exhausted = false;
    frequencies open = m;
    status result;
    if (m.first > m.last)
        return STATUS_OK;
    result = try_rest(&proved, z, m);
    if (result != STATUS_OK || proved)
        return result;
    if (number_is_positive(&z->lower) == TRUTH_TRUE)
        result = prove_below(&proved, &open, &exhausted, z, m, &z->lower, LENIENT);
    z->list->rest_upper = fmax(z->list->rest_upper, proved ? number_upper_bound(&z->lower) : INFINITY);
    if (!proved) {
        z->list->exhausted = z->list->exhausted || exhausted;
        widen(&z->list->open, open);
        z->list->ordered = false;
    }
    return result;
}

/* A chain that goes on until L has fallen by one of these fractions may make the rest easy. */
static const double fall[] = {0x1p-12, 0x1p-8, 0x1p-4, 1};
enum { FALLS = sizeof fall / sizeof *fall };
#define MAX_RANGES 2000
#define MAX_DISTANCE 1024

/* A chain away from the top that starts at `start`.  *end = start: there is none. */
static status find_chain(long *end, survey *z, long start, long goal, double smaller)
{
    monotone_list list;
    monotone_answer answer;
    double enough = number_lower_bound(&z->lower) * (1 - smaller);
    *end = start;
    if (start == goal || !z->mirror_symmetric || z->list->top == 0)
        return STATUS_OK;
    monotone_list_init(&list);
    answer = monotone_search(&list, &z->numbers, start, goal, MAX_RANGES, enough, z->complaint);
    *end = answer.end;
    monotone_list_clear(&list);
    return block_complaint(answer.status, z->complaint);
}

static frequencies between(long a, long b)
{
    return a < b ? (frequencies){a, b} : (frequencies){b, a};
}

/* The blocks from `start` to `goal` if a chain begins there; *found = false: none does. */
static status prove_along_chain(bool *found, survey *z, long start, long goal)
{
    long end, step = goal > start ? 1 : -1;
    status result = find_chain(&end, z, start, goal, fall[0]);
    *found = end != start;
    for (int i = 1; result == STATUS_OK && *found && i < FALLS && end != goal; i++) {
        long last = end;
        bool proved;
        result = try_rest(&proved, z, between(end + step, goal));
        if (proved)
            return result;
        if (result == STATUS_OK)
            result = find_chain(&end, z, last, goal, fall[i]);
        if (end == last)
            break;
    }
    if (result == STATUS_OK && *found && end != goal)
        result = prove_rest(z, between(end + step, goal));
    return result;
}

/* All blocks from the top, exclusive, to `goal`, 1 or k/2.  (Of a chain from the top, the next block bounds the others,
   and it has entries.) */
static status prove_side(survey *z, long goal)
{
    long top = z->list->top, step = goal > top ? 1 : -1;
    bool found, proved;
    status result;
    if (goal == top)
        return STATUS_OK;
    result = prove_along_chain(&found, z, top, goal);
    if (result != STATUS_OK || found)
        return result;
    result = try_rest(&proved, z, between(top + step, goal));
    for (long distance = 1; result == STATUS_OK && !proved && distance <= MAX_DISTANCE && distance < labs(goal - top); distance *= 2) {
        long start = top + step * distance;
        result = prove_along_chain(&found, z, start, goal);
        if (result == STATUS_OK && found)
            return prove_rest(z, between(top + step, start));
    }
    return result == STATUS_OK && !proved ? prove_rest(z, between(top + step, goal)) : result;
}

/* ---- ranges ---- */

/* A bound for the blocks of one range that is not far from the best, or what is known of all. */
static status add_range(survey *z, frequencies m, bool bounds)
{
    static const double slack[] = {0x1p-10, 0x1p-5};
    double radius = 0, upper = INFINITY;
    status result = STATUS_OK;
    if (z->list->ordered)
        upper = fmax(z->rival, z->list->rest_upper);
    for (int i = 0; bounds && i <= 8; i++)
        radius = fmax(radius, radius_approx(z, m.first + (long)((double)(m.last - m.first) * i / 8)));
    for (size_t i = 0; bounds && result == STATUS_OK && i < sizeof slack / sizeof *slack; i++) {
        double bound = fmax(radius, 0x1p-20) * (1 + slack[i]);
        bool proved;
        if (!(bound < upper))
            break;
        result = prove_below_double(&proved, z, m, bound, QUICK);
        if (proved)
            upper = bound;
        if (proved)
            break;
    }
    return result == STATUS_OK && !spectrum_list_add_range(z->list, m, upper) ? STATUS_NO_MEMORY : result;
}

#define RANGE_RATIO 8

/* Everything without entries, in ranges that grow. */
static status list_ranges(survey *z, bool bounds)
{
    status result = STATUS_OK;
    frequencies m = {0, 0};
    while (result == STATUS_OK && m.first <= z->half) {
        if (has_entries(z, m.first)) {
            m.first++;
            continue;
        }
        m.last = m.first < z->half / RANGE_RATIO ? m.first * RANGE_RATIO - 1 : z->half;
        if (m.first < z->list->top && m.last > z->list->top - 2)
            m.last = z->list->top - 2;
        result = add_range(z, m, bounds);
        m.first = m.last + 1;
    }
    return result;
}

/* ---- all together ---- */

/* Index of the largest eigenvalue of block m besides 1 in block 0, -1: it has no enclosures. */
static long largest_of(const spectrum_list *l, long m, long one)
{
    for (size_t i = 0; i < l->count; i++)
        if (l->entry[i].m == m && (long)i != one)
            return l->entry[i].re ? (long)i : -1;
    return -1;
}

static status examine(survey *z, int digits, bool bounds)
{
    spectrum_list *l = z->list;
    status result;
    long one, own, central;
    l->top = find_top(z);
    result = list_entries(z, digits);
    if (result != STATUS_OK)
        return result;
    one = spectrum_find_one(l);
    own = largest_of(l, l->top, one);
    central = largest_of(l, 0, one);
    if (own >= 0 && central >= 0 && l->entry[central].modulus_lower > l->entry[own].modulus_upper) {
        own = central;
        l->top = 0;
    }
    result = find_lower(z);
    for (size_t i = 0; i < l->count; i++)
        if ((long)i != one && (long)i != own && !(own >= 0 && spectrum_is_conjugate_pair(l, (size_t)own, i)))
            z->rival = fmax(z->rival, l->entry[i].modulus_upper);
    l->ordered = true;
    l->open = (frequencies){1, 0};
    if (result == STATUS_OK)
        result = prove_side(z, z->half);
    if (result == STATUS_OK && l->top > 1)
        result = prove_side(z, 1);
    if (result == STATUS_OK)
        result = list_ranges(z, bounds);
    return result;
}

status survey_blocks(spectrum_list *list, spectrum_doubles *doubles, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d)
{
    survey z = {.list = list, .doubles = doubles, .complaint = d, .mirror_symmetric = s->mirror_symmetric, .half = k / 2};
    status result = scheme_numbers_make(&z.numbers, s, k, prec, d);
    number_init(&z.lower);
    if (result == STATUS_OK)
        result = examine(&z, digits, bounds);
    number_clear(&z.lower);
    scheme_numbers_free(&z.numbers);
    return result;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
status NUMBER_NAME(spectrum_survey)(spectrum_list *z, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d)
{
    spectrum_doubles *doubles;
    number_mode mode;
    status result = spectrum_doubles_make(&doubles, s, k, d);
    if (result == STATUS_OK) {
        mode = number_enter();
        result = survey_blocks(z, doubles, s, k, digits, prec, bounds, d);
        number_leave(mode);
    }
    spectrum_doubles_free(doubles);
    return result;
}
