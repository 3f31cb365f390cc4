/* ball_dot_even.c: sums of products where all mantissas have one length n, are nearly full, and not far apart: the common
   case.

   As in ball_dot.c with L = n + 1 and T = 128 n + the highest exponent, at most 30 bits too high, so that a product of the
   highest exponent loses its lowest n - 1 limbs and some bits: most of what they are made of is not even formed.
   Errors are words at one scale above each term's exponent.  See errors.md, "Dot products". */
#include "ball.h"
#include "ball_fixed.h"
#include "ball_internal.h"

#define EVEN_LIMBS 64                    /* longer mantissas go the general way */
#define EVEN_TERMS ((size_t)1 << 12)
#define EVEN_LEAST_TOP ((limb_t)1 << 48) /* of the highest limbs */

typedef struct {
    int64_t t;        /* accumulator unit */
    int64_t K, scale; /* error unit; the same, less the scale of error words above a term's exponent */
} even_frame;

static inline bool has_length(const ball *x, int n) { return x->size == n || x->size == -n; }
static inline bool is_exact_zero_term(const ball *x, const ball *y)
{
    return !ball_is_special(x) && !ball_is_special(y) && (ball_is_exact_zero(x) || ball_is_exact_zero(y));
}

/* Places accumulator and error sum; false: not this case. */
FIXED_INLINE bool even_prepare(even_frame *f, const ball *x, long xs, const ball *y, long ys, size_t N, const int n)
{
    int64_t highest = INT64_MIN, highest_inexact = INT64_MIN;
    limb_t least = ~(limb_t)0, errors = 0;
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!has_length(x, n) || !has_length(y, n))) {
            if (!is_exact_zero_term(x, y))
                return false;
            continue;
        }
        limb_t a = ball_limbs(x)[n - 1], b = ball_limbs(y)[n - 1], err = x->error | y->error;
        int64_t e = x->exponent + y->exponent, u = err ? e : INT64_MIN;
        least = a < least ? a : least;
        least = b < least ? b : least;
        errors |= err;
        highest = e > highest ? e : highest;
        highest_inexact = u > highest_inexact ? u : highest_inexact;
    }
    /* Exact operands go other ways, where a result that is exact and fits stays exact. */
    if (highest == INT64_MIN || errors == 0 || least < EVEN_LEAST_TOP)
        return false;
    int guard = limb_bits(N) + 1, down = guard - (BALL_ERROR_BITS - limb_bits(errors));
    f->t = highest + guard + 64 * (n - 1);
    f->scale = highest_inexact + (down > 0 ? down : 0);
    f->K = f->scale + 64 * n - 31;
    if (f->K < f->t) {
        f->scale += f->t - f->K;
        f->K = f->t;
    }
    return true;
}

/* The error of x y, in units of 2^K, rounded down. */
FIXED_INLINE limb_t even_error(const even_frame *f, const ball *x, const ball *y, limb_t a, limb_t b, int64_t e)
{
    /* ROUNDING: |m| + err_x and |n|, in units of 2^(64 n - 31) */
    limb_t word = ((a >> 33) + 2) * y->error + ((b >> 33) + 1) * x->error;
    uint64_t d = (uint64_t)(f->scale - e); /* negative only where word is 0 */
    return word >> (d < 63 ? d : 63);
}

/* The sum of n + 1 limbs and the errors as a ball. */
FIXED_INLINE void even_finish(ball *z, const even_frame *f, limb_t *acc, limb_t error, size_t N, long prec, const int n)
{
    limb_t mask = 0 - (acc[n] >> 63), carry = mask & 1;
    for (int i = 0; i <= n; i++)
        acc[i] = limb_add(acc[i] ^ mask, 0, &carry);
    error += N; /* ROUNDING (hidden by the next one): ceilings of N errors */
    int64_t k;
    /* ROUNDING: N products, each less than a unit too low when it is cut, and all together n / 2 for the limbs left out */
    error = ball_error_sum(&k, N + (limb_t)n / 2, 0, error, f->K - f->t);
    ball_store(z, acc, (size_t)n + 1, mask != 0, error, k, f->t, prec);
}

/* w = limbs n - 2 .. 2 n - 1 of a b, too small by at most (n - 2) B: the products a[i] b[j] with i + j < n - 2 are
   left out, as in limb_multiply_high. */
FIXED_INLINE void even_multiply(limb_t *w, const limb_t *a, const limb_t *b, const int n)
{
    if (n == 1) {
        w[0] = 0;
        w[1] = limb_mul(&w[2], a[0], b[0]);
        return;
    }
#define S(k, j)                                  \
    if ((k) < (j) + 2 && n - 2 - (j) + (k) >= 0) \
        w[k] = limb_muladd(a[n - 2 - (j) + (k) >= 0 ? n - 2 - (j) + (k) : 0], b[j], w[k], &carry);
#define ROW(j)                                                                  \
    if ((j) < n) {                                                              \
        limb_t carry = 0;                                                       \
        S(0, j) S(1, j) S(2, j) S(3, j) S(4, j) S(5, j) S(6, j) S(7, j) S(8, j) \
        w[(j) + 2] = carry;                                                     \
    }
    w[0] = w[1] = 0;
    ROW(0) ROW(1) ROW(2) ROW(3) ROW(4) ROW(5) ROW(6) ROW(7)
#undef ROW
#undef S
}

/* acc += p, n + 1 limbs, n <= 4 or 8 */
FIXED_INLINE void even_sum(limb_t *acc, const limb_t *p, const int n)
{
#if LIMB_HAVE_ADX
#define TAIL : "cc"
    if (n == 1)
        __asm__("addq %2, %0\n\tadcq %3, %1" : "+&r"(acc[0]), "+&r"(acc[1]) : "r"(p[0]), "r"(p[1]) TAIL);
    else if (n == 2)
        __asm__("addq %3, %0\n\tadcq %4, %1\n\tadcq %5, %2"
                : "+&r"(acc[0]), "+&r"(acc[1]), "+&r"(acc[2]) : "rm"(p[0]), "rm"(p[1]), "rm"(p[2]) TAIL);
    else if (n == 3)
        __asm__("addq %4, %0\n\tadcq %5, %1\n\tadcq %6, %2\n\tadcq %7, %3"
                : "+&r"(acc[0]), "+&r"(acc[1]), "+&r"(acc[2]), "+&r"(acc[3])
                : "rm"(p[0]), "rm"(p[1]), "rm"(p[2]), "rm"(p[3]) TAIL);
    else if (n == 4)
        __asm__("addq %5, %0\n\tadcq %6, %1\n\tadcq %7, %2\n\tadcq %8, %3\n\tadcq %9, %4"
                : "+&r"(acc[0]), "+&r"(acc[1]), "+&r"(acc[2]), "+&r"(acc[3]), "+&r"(acc[4])
                : "rm"(p[0]), "rm"(p[1]), "rm"(p[2]), "rm"(p[3]), "rm"(p[4]) TAIL);
    else {
        limb_t t;
#define STEP(i, add) "movq 8*" #i "(%[p]), %[t]\n\t" #add " %[t], 8*" #i "(%[acc])\n\t"
        __asm__(STEP(0, addq) STEP(1, adcq) STEP(2, adcq) STEP(3, adcq) STEP(4, adcq) STEP(5, adcq) STEP(6, adcq)
                STEP(7, adcq) STEP(8, adcq)
                : [t] "=&r"(t), "+m"(*(limb_t(*)[9])acc)
                : [acc] "r"(acc), [p] "r"(p), "m"(*(const limb_t(*)[9])p)
                : "cc");
#undef STEP
    }
#undef TAIL
#else
    limb_t carry = 0;
    for (int i = 0; i <= n; i++)
        acc[i] = limb_add(acc[i], p[i], &carry);
#endif
}

/* to = from >> d, n + 1 limbs */
static FIXED_NOINLINE void far_shift(limb_t *to, const limb_t *from, int64_t d, int n)
{
    for (int i = 0; i <= n; i++) {
        int64_t at = i + d / 64;
        limb_t low = at <= n ? from[at] : 0, high = at < n ? from[at + 1] : 0;
        to[i] = low >> (d % 64) | (high << 1) << (63 - d % 64);
    }
}

/* S(i) for i = 0 .. n, n <= 4 or 8 */
#define EVEN_EACH(n, S)                    \
    do {                                   \
        S(0)                               \
        S(1)                               \
        if ((n) > 1) {                     \
            S(2)                           \
        }                                  \
        if ((n) > 2) {                     \
            S(3)                           \
        }                                  \
        if ((n) > 3) {                     \
            S(4)                           \
        }                                  \
        if ((n) > 4) {                     \
            S(5) S(6) S(7) S(8)            \
        }                                  \
    } while (0)

FIXED_INLINE bool fixed_dot(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec, const int n)
{
    even_frame f;
    if (!even_prepare(&f, x, xs, y, ys, N, n))
        return false;
    limb_t acc[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0}, error = 0, negatives = 0;
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!x->size || !y->size))
            continue;
        const limb_t *a = ball_limbs(x), *b = ball_limbs(y);
        int64_t e = x->exponent + y->exponent;
        limb_t w[11], p[9], negative = (limb_t)((uint32_t)(x->size ^ y->size) >> 31), mask = 0 - negative;
        negatives += negative;
        error += even_error(&f, x, y, a[n - 1], b[n - 1], e);
        even_multiply(w, a, b, n);
        uint64_t r = (uint64_t)(f.t - e) - 64 * ((uint64_t)n - 1); /* >= 2 */
        /* cut first, then complemented: one less than the opposite, which `negatives` repairs */
        if (FIXED_UNLIKELY(r >= 64)) {
            limb_t near[9], far[9]; /* so that w and p stay in registers elsewhere */
#define S(i) near[i] = w[(i) + 1];
            EVEN_EACH(n, S);
#undef S
            far_shift(far, near, (int64_t)r, n);
#define S(i) p[i] = far[i] ^ mask;
            EVEN_EACH(n, S);
#undef S
        } else {
#define S(i) p[i] = (w[(i) + 1] >> r | ((i) < n ? w[(i) + 2] << (64 - r) : 0)) ^ mask;
            EVEN_EACH(n, S);
#undef S
        }
        even_sum(acc, p, n);
    }
    limb_t sum[9], carry = 0;
#define S(i) sum[i] = limb_add(acc[i], (i) ? 0 : negatives, &carry);
    EVEN_EACH(n, S);
#undef S
    even_finish(z, &f, sum, error, N, prec, n);
    return true;
}

/* acc +- w >> r, n + 1 limbs, 0 < r < 64 */
static inline void row_accumulate(limb_t *acc, const limb_t *w, unsigned r, limb_t mask, int n)
{
    limb_t carry = mask & 1;
    for (int i = 0; i < n; i++)
        acc[i] = limb_add(acc[i], (w[i] >> r | w[i + 1] << (64 - r)) ^ mask, &carry);
    acc[n] = limb_add(acc[n], w[n] >> r ^ mask, &carry);
}

/* The same for other lengths. */
static bool long_dot(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec, const int n)
{
    even_frame f;
    if (!even_prepare(&f, x, xs, y, ys, N, n))
        return false;
    limb_t acc[EVEN_LIMBS + 1], w[EVEN_LIMBS + 2], far[EVEN_LIMBS + 1], error = 0;
    limb_zero(acc, (size_t)n + 1);
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!x->size || !y->size))
            continue;
        const limb_t *a = ball_limbs(x), *b = ball_limbs(y);
        int64_t e = x->exponent + y->exponent, r = f.t - e - 64 * (n - 1);
        error += even_error(&f, x, y, a[n - 1], b[n - 1], e);
        limb_multiply_high(w, a, b, (size_t)n);
        const limb_t *from = w + 1;
        if (FIXED_UNLIKELY(r >= 64)) {
            far_shift(far, from, r - 1, n);
            from = far;
            r = 1; /* what row_accumulate has to shift */
        }
        row_accumulate(acc, from, (unsigned)r, 0 - (limb_t)((uint32_t)(x->size ^ y->size) >> 31), n);
    }
    even_finish(z, &f, acc, error, N, prec, n);
    return true;
}

/* ---- n <= 4, all exact: every digit of the sum is kept, so that what fits stays exact ---- */

/* In units of 2^lowest a product is below 2^(128 n + 62), the sum of fewer than 2^12 below 2^(64 (2 n + 2) - 54). */
FIXED_INLINE bool exact_dot(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec, const int n)
{
    int64_t highest = INT64_MIN, lowest = INT64_MAX;
    for (size_t i = 0; i < N; i++) {
        const ball *u = x + (long)i * xs, *v = y + (long)i * ys;
        int64_t e = u->exponent + v->exponent;
        if (!has_length(u, n) || !has_length(v, n)) {
            if (!is_exact_zero_term(u, v))
                return false;
            continue;
        }
        if (u->error | v->error)
            return false;
        highest = e > highest ? e : highest;
        lowest = e < lowest ? e : lowest;
    }
    if (highest == INT64_MIN || highest - lowest > 62)
        return false;
    limb_t acc[2 * 4 + 2] = {0}, negatives = 0;
    for (size_t i = 0; i < N; i++, x += xs, y += ys) {
        if (FIXED_UNLIKELY(!x->size || !y->size))
            continue;
        limb_t w[2 * 4 + 2], negative = (limb_t)((uint32_t)(x->size ^ y->size) >> 31), mask = 0 - negative, carry = 0;
        unsigned r = (unsigned)(x->exponent + y->exponent - lowest);
        fixed_multiply(w, ball_limbs(x), ball_limbs(y), n);
        w[2 * n] = 0;
        negatives += negative; /* the complement is one less than the opposite */
#pragma GCC unroll 10
        for (int k = 0; k <= 2 * n; k++)
            acc[k] = limb_add(acc[k], (w[k] << r | (k ? (w[k ? k - 1 : 0] >> 1) >> (63 - r) : 0)) ^ mask, &carry);
        acc[2 * n + 1] += mask + carry;
    }
    limb_add_1(acc, acc, 2 * (size_t)n + 2, negatives);
    bool minus = acc[2 * n + 1] >> 63;
    if (minus) {
        for (int k = 0; k < 2 * n + 2; k++)
            acc[k] = ~acc[k];
        limb_add_1(acc, acc, 2 * (size_t)n + 2, 1);
    }
    ball_store(z, acc, 2 * (size_t)n + 2, minus, 0, 0, lowest, prec);
    return true;
}

/* One function for each length, so that each has registers enough. */
#define DOT_LENGTH(name, f, n)                                                                                         \
    static FIXED_NOINLINE bool name(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec)      \
    {                                                                                                                  \
        return f(z, x, xs, y, ys, N, prec, n);                                                                         \
    }
DOT_LENGTH(fixed_dot_1, fixed_dot, 1)
DOT_LENGTH(fixed_dot_2, fixed_dot, 2)
DOT_LENGTH(fixed_dot_3, fixed_dot, 3)
DOT_LENGTH(fixed_dot_4, fixed_dot, 4)
DOT_LENGTH(fixed_dot_8, fixed_dot, 8)
DOT_LENGTH(exact_dot_1, exact_dot, 1)
DOT_LENGTH(exact_dot_2, exact_dot, 2)
DOT_LENGTH(exact_dot_3, exact_dot, 3)
DOT_LENGTH(exact_dot_4, exact_dot, 4)
#if LIMB_HAVE_ADX
FIXED_BMI2 DOT_LENGTH(fixed_dot_1_bmi2, fixed_dot, 1)
FIXED_BMI2 DOT_LENGTH(fixed_dot_2_bmi2, fixed_dot, 2)
FIXED_BMI2 DOT_LENGTH(fixed_dot_3_bmi2, fixed_dot, 3)
FIXED_BMI2 DOT_LENGTH(fixed_dot_4_bmi2, fixed_dot, 4)
FIXED_BMI2 DOT_LENGTH(fixed_dot_8_bmi2, fixed_dot, 8)
FIXED_BMI2 DOT_LENGTH(exact_dot_1_bmi2, exact_dot, 1)
FIXED_BMI2 DOT_LENGTH(exact_dot_2_bmi2, exact_dot, 2)
FIXED_BMI2 DOT_LENGTH(exact_dot_3_bmi2, exact_dot, 3)
FIXED_BMI2 DOT_LENGTH(exact_dot_4_bmi2, exact_dot, 4)
#endif

bool ball_dot_even(ball *z, const ball *x, long xs, const ball *y, long ys, size_t N, long prec)
{
    int64_t n = ball_room_bits(prec) / 64;
    if (N == 0 || N >= EVEN_TERMS || n > EVEN_LIMBS)
        return false;
    bool exact = (x->error | y->error) == 0; /* what the first term is, most are */
    switch (n) {
    case 1: return (exact ? FIXED_BEST(exact_dot_1) : FIXED_BEST(fixed_dot_1))(z, x, xs, y, ys, N, prec);
    case 2: return (exact ? FIXED_BEST(exact_dot_2) : FIXED_BEST(fixed_dot_2))(z, x, xs, y, ys, N, prec);
    case 3: return (exact ? FIXED_BEST(exact_dot_3) : FIXED_BEST(fixed_dot_3))(z, x, xs, y, ys, N, prec);
    case 4: return (exact ? FIXED_BEST(exact_dot_4) : FIXED_BEST(fixed_dot_4))(z, x, xs, y, ys, N, prec);
    case 8: return FIXED_BEST(fixed_dot_8)(z, x, xs, y, ys, N, prec);
    default: return long_dot(z, x, xs, y, ys, N, prec, (int)n);
    }
}
