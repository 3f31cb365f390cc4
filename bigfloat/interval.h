/* interval.h: hardware intervals.

   An `interval` is a pair of doubles (neg_lower, upper) and denotes the set of real numbers x with

       -neg_lower  <=  x  <=  upper.

   What always holds: neither double is NaN or -infinity, and -neg_lower <= upper.  So an infinite endpoint is
   +infinity as stored and stands for "no bound"; the *indeterminate* interval is (+infinity, +infinity).

   Why the sign: with the machine rounding UPWARD, both stored doubles are rounded in the safe direction by
   the same instruction.  Sums of doubles that are not -infinity are never NaN, overflow towards +infinity gives
   "no bound", overflow towards -infinity stops at -DBL_MAX, and underflow rounds upward like all else: every
   bound below follows from "each double is >= its exact value", which is not repeated at each function.

   Arithmetic is valid only between interval_enter() and interval_leave(), which set and restore the rounding
   mode.  Compilers may move floating-point work across the calls that change the mode.  Therefore: the
   function that calls enter and leave does no arithmetic itself; it calls functions that are not inlined
   (in another source, or marked INTERVAL_NOINLINE).  Sources that use intervals are compiled with
   -frounding-math.  interval_self_test() finds out at run time whether all this works.

   The operations are those of number.h; `prec` is ignored.  Missing memory cannot be told by two doubles:
   it gives the indeterminate interval, and interval_lacks_memory is always false. */
#ifndef BIGFLOAT_INTERVAL_H
#define BIGFLOAT_INTERVAL_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "ball.h"
#include "number_array.h"
#include "number_common.h"

#if defined(__SSE2__) && !defined(SMOOTHCERT_PORTABLE)
#define INTERVAL_SSE2 1
#include <emmintrin.h>
#else
#define INTERVAL_SSE2 0
#include <fenv.h>
#endif

#if defined(__GNUC__)
#define INTERVAL_NOINLINE __attribute__((noinline))
#define INTERVAL_UNLIKELY(c) __builtin_expect(!!(c), 0)
#else
#define INTERVAL_NOINLINE
#define INTERVAL_UNLIKELY(c) (c)
#endif

typedef struct {
    double neg_lower;
    double upper;
} interval;

/* ---- regions ---- */

typedef unsigned interval_mode;

#if INTERVAL_SSE2
/* Round up (0x4000), all exceptions masked (0x1f80), no flushing of subnormals. */
#define INTERVAL_MXCSR_UP (0x4000u | 0x1f80u)

static inline interval_mode interval_enter(void)
{
    interval_mode mode = _mm_getcsr();
    _mm_setcsr(INTERVAL_MXCSR_UP);
    return mode;
}
static inline void interval_leave(interval_mode mode) { _mm_setcsr(mode); }
#else
static inline interval_mode interval_enter(void)
{
    int mode = fegetround();
    fesetround(FE_UPWARD);
    return (interval_mode)mode;
}
static inline void interval_leave(interval_mode mode) { fesetround((int)mode); }
#endif

/* Does directed rounding work, here and now, as compiled?  If not, use balls only.  Call it outside any
   region; it leaves the mode as it was. */
bool interval_self_test(void);

/* ---- life and assignment ---- */

static inline interval interval_make_(double neg_lower, double upper)
{
    interval z = {neg_lower, upper};
    return z;
}

static inline void interval_init(interval *z) { *z = interval_make_(0, 0); }
static inline void interval_clear(interval *z) { (void)z; }
static inline void interval_set(interval *z, const interval *x) { *z = *x; }
static inline void interval_swap(interval *x, interval *y)
{
    interval t = *x;
    *x = *y;
    *y = t;
}
static inline void interval_zero(interval *z) { *z = interval_make_(0, 0); }
static inline void interval_one(interval *z) { *z = interval_make_(-1, 1); }
static inline void interval_indeterminate(interval *z) { *z = interval_make_(HUGE_VAL, HUGE_VAL); }

NUMBER_DECLARE_SLOW(interval);
NUMBER_ARRAY_FUNCTIONS(interval);

/* The least interval that contains the ball (up to underflow), and the same set as a ball. */
void interval_set_ball(interval *z, const ball *x, long prec);
void ball_set_interval(ball *z, const interval *x, long prec);
/* z = [lower, upper]; indeterminate if either is NaN or lower > upper. */
void interval_set_doubles(interval *z, double lower, double upper);
void interval_set_large_si_(interval *z, long v);

static inline void interval_set_si(interval *z, long v, long prec)
{
    (void)prec;
    if (v >= -(1L << 30) && v <= (1L << 30)) /* exact in a double */
        *z = interval_make_(-(double)v, (double)v);
    else
        interval_set_large_si_(z, v);
}

/* ---- questions ---- */

static inline truth interval_is_positive(const interval *x)
{
    return x->neg_lower < 0 ? TRUTH_TRUE : x->upper <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}
static inline truth interval_is_negative(const interval *x)
{
    return x->upper < 0 ? TRUTH_TRUE : x->neg_lower <= 0 ? TRUTH_FALSE : TRUTH_UNKNOWN;
}
static inline bool interval_contains_zero(const interval *x)
{
    return x->neg_lower >= 0 && x->upper >= 0;
}
static inline truth interval_is_zero(const interval *x)
{
    return !interval_contains_zero(x) ? TRUTH_FALSE
           : x->neg_lower == 0 && x->upper == 0 ? TRUTH_TRUE : TRUTH_UNKNOWN;
}
static inline truth interval_less(const interval *x, const interval *y)
{
    return x->upper < -y->neg_lower ? TRUTH_TRUE : -x->neg_lower >= y->upper ? TRUTH_FALSE : TRUTH_UNKNOWN;
}
static inline bool interval_contains(const interval *x, const interval *y)
{
    return y->neg_lower <= x->neg_lower && y->upper <= x->upper;
}
static inline bool interval_contains_interior(const interval *x, const interval *y)
{
    return (y->neg_lower < x->neg_lower || x->neg_lower == HUGE_VAL)
           && (y->upper < x->upper || x->upper == HUGE_VAL);
}
static inline bool interval_is_finite(const interval *x)
{
    return x->neg_lower < HUGE_VAL && x->upper < HUGE_VAL;
}
static inline bool interval_is_thin(const interval *x) { return x->upper == -x->neg_lower; }
static inline bool interval_lacks_memory(const interval *x)
{
    (void)x;
    return false;
}
static inline double interval_lower_bound(const interval *x) { return -x->neg_lower; }
static inline double interval_upper_bound(const interval *x) { return x->upper; }
static inline double interval_mid_approx(const interval *x)
{
    return interval_is_finite(x) ? 0.5 * x->upper - 0.5 * x->neg_lower : 0;
}

/* ---- ring operations ---- */

static inline double interval_max_(double a, double b) { return a > b ? a : b; }
static inline double interval_min_(double a, double b) { return a < b ? a : b; }

static inline void interval_neg(interval *z, const interval *x)
{
    *z = interval_make_(x->upper, x->neg_lower);
}

static inline void interval_abs(interval *z, const interval *x)
{
    double a = x->neg_lower, b = x->upper;
    /* inf |x| is -a if x > 0 (a < 0), -b if x < 0 (b < 0), else 0. */
    *z = interval_make_(interval_min_(0, interval_min_(a, b)), interval_max_(a, b));
}

static inline void interval_add(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    *z = interval_make_(x->neg_lower + y->neg_lower, x->upper + y->upper);
}

static inline void interval_sub(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    *z = interval_make_(x->neg_lower + y->upper, x->upper + y->neg_lower);
}

void interval_mul_unbounded_(interval *z, const interval *x, const interval *y);

/* x and y finite, so no product of endpoints is NaN (0 infinity is the only way to one).  With a = -inf x,
   b = sup x, c = -inf y, d = sup y: sup = max(a c, -a d, -b c, b d) and -inf = max(-a c, a d, b c, -b d). */
#if INTERVAL_SSE2
static inline void interval_mul(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    const __m128d minus = _mm_set1_pd(-0.0);
    __m128d ab = _mm_loadu_pd(&x->neg_lower), cd = _mm_loadu_pd(&y->neg_lower), ba = _mm_shuffle_pd(ab, ab, 1);
    __m128d cc = _mm_unpacklo_pd(cd, cd), dd = _mm_unpackhi_pd(cd, cd), sum = _mm_add_pd(ab, cd);
    if (INTERVAL_UNLIKELY(!(_mm_cvtsd_f64(_mm_add_sd(sum, _mm_unpackhi_pd(sum, sum))) < HUGE_VAL))) {
        interval_mul_unbounded_(z, x, y); /* some endpoint, or just the sum, is infinite */
        return;
    }
    __m128d p = _mm_mul_pd(ab, dd), q = _mm_mul_pd(ba, cc);                                       /* ad bd, bc ac */
    __m128d r = _mm_mul_pd(_mm_xor_pd(ab, minus), cc), s = _mm_mul_pd(_mm_xor_pd(ba, minus), dd); /* -ac -bc, -bd -ad */
    _mm_storeu_pd(&z->neg_lower, _mm_max_pd(_mm_max_pd(p, q), _mm_max_pd(r, s)));
}
#else
static inline void interval_mul(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    double a = x->neg_lower, b = x->upper, c = y->neg_lower, d = y->upper;
    if (INTERVAL_UNLIKELY(!((a + b) + (c + d) < HUGE_VAL))) {
        interval_mul_unbounded_(z, x, y);
        return;
    }
    double upper = interval_max_(interval_max_(a * c, b * d), interval_max_(-a * d, -b * c));
    double neg_lower = interval_max_(interval_max_(-a * c, -b * d), interval_max_(a * d, b * c));
    *z = interval_make_(neg_lower, upper);
}
#endif

static inline void interval_addmul(interval *z, const interval *x, const interval *y, long prec)
{
    interval t;
    interval_mul(&t, x, y, prec);
    interval_add(z, z, &t, prec);
}

static inline void interval_submul(interval *z, const interval *x, const interval *y, long prec)
{
    interval t;
    interval_mul(&t, x, y, prec);
    interval_sub(z, z, &t, prec);
}

static inline void interval_sqr(interval *z, const interval *x, long prec)
{
    (void)prec;
    double a = x->neg_lower, b = x->upper;
    double upper = interval_max_(a * a, b * b);
    if (a < 0)
        *z = interval_make_(-a * a, upper); /* 0 < -a <= x */
    else if (b < 0)
        *z = interval_make_(-b * b, upper);
    else
        *z = interval_make_(0, upper);
}

static inline void interval_mul_si(interval *z, const interval *x, long v, long prec)
{
    interval t;
    interval_set_si(&t, v, prec);
    interval_mul(z, x, &t, prec);
}

/* 2^e for -1022 <= e <= 1023. */
static inline double interval_power_of_two_(long e)
{
    uint64_t bits = (uint64_t)(e + 1023) << 52;
    double p;
    memcpy(&p, &bits, sizeof p);
    return p;
}

void interval_mul_2exp_far_(interval *z, const interval *x, long e);

static inline void interval_mul_2exp(interval *z, const interval *x, long e, long prec)
{
    (void)prec;
    if (INTERVAL_UNLIKELY(e < -1022 || e > 1023)) {
        interval_mul_2exp_far_(z, x, e);
        return;
    }
    double p = interval_power_of_two_(e);
    *z = interval_make_(x->neg_lower * p, x->upper * p);
}

/* ---- division and root ---- */

/* For y > 0 (c < 0): the sup of x / y is b / inf y if b >= 0, else b / sup y; likewise -inf from a.  For y < 0
   divide -x by -y.  No quotient is NaN: an infinite numerator is >= 0 and meets the nearer, finite, nonzero
   endpoint of y. */
static inline void interval_div(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    double a = x->neg_lower, b = x->upper, c = y->neg_lower, d = y->upper;
    if (c < 0)
        *z = interval_make_(a / (a >= 0 ? -c : d), b / (b >= 0 ? -c : d));
    else if (d < 0)
        *z = interval_make_(b / (b >= 0 ? -d : c), a / (a >= 0 ? -d : c));
    else
        interval_indeterminate(z);
}

static inline void interval_inv(interval *z, const interval *x, long prec)
{
    interval one = {-1, 1};
    interval_div(z, &one, x, prec);
}

static inline void interval_div_si(interval *z, const interval *x, long v, long prec)
{
    interval t;
    interval_set_si(&t, v, prec);
    interval_div(z, x, &t, prec);
}

static inline double interval_sqrt_up_(double x)
{
#if INTERVAL_SSE2
    __m128d t = _mm_set_sd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(t, t));
#else
    return sqrt(x);
#endif
}

/* s = sqrt(l) rounded up.  If s s, rounded up, is <= l, then s is the exact root; else the double below s is
   below the root, since s is the least double that is not. */
static inline double interval_sqrt_down_(double l)
{
    double s = interval_sqrt_up_(l);
    if (s * s <= l)
        return s;
    uint64_t bits;
    memcpy(&bits, &s, sizeof bits);
    bits--;
    memcpy(&s, &bits, sizeof s);
    return s;
}

static inline void interval_sqrt(interval *z, const interval *x, long prec)
{
    (void)prec;
    if (x->neg_lower > 0)
        interval_indeterminate(z);
    else
        *z = interval_make_(-interval_sqrt_down_(-x->neg_lower), interval_sqrt_up_(x->upper));
}

/* ---- sets ---- */

static inline void interval_hull(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    *z = interval_make_(interval_max_(x->neg_lower, y->neg_lower), interval_max_(x->upper, y->upper));
}

static inline void interval_min(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    *z = interval_make_(interval_max_(x->neg_lower, y->neg_lower), interval_min_(x->upper, y->upper));
}

static inline void interval_max(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    *z = interval_make_(interval_min_(x->neg_lower, y->neg_lower), interval_max_(x->upper, y->upper));
}

static inline void interval_intersection(interval *z, const interval *x, const interval *y, long prec)
{
    (void)prec;
    double a = interval_min_(x->neg_lower, y->neg_lower), b = interval_min_(x->upper, y->upper);
    if (-a <= b)
        *z = interval_make_(a, b);
    else
        interval_indeterminate(z);
}

/* The number v, or the whole line if v is infinite. */
static inline void interval_thin_(interval *z, double v)
{
    if (v < HUGE_VAL && v > -HUGE_VAL)
        *z = interval_make_(-v, v);
    else
        interval_indeterminate(z);
}

static inline void interval_lower(interval *z, const interval *x, long prec)
{
    (void)prec;
    interval_thin_(z, -x->neg_lower);
}
static inline void interval_upper(interval *z, const interval *x, long prec)
{
    (void)prec;
    interval_thin_(z, x->upper);
}

/* Infinity minus infinity does not occur: an unbounded x is sent away first. */
static inline double interval_center_(const interval *x)
{
    return interval_is_finite(x) ? 0.5 * x->upper - 0.5 * x->neg_lower : HUGE_VAL;
}
static inline void interval_midpoint(interval *z, const interval *x, long prec)
{
    (void)prec;
    interval_thin_(z, interval_center_(x));
}
static inline void interval_radius_upper(interval *z, const interval *x, long prec)
{
    (void)prec;
    double m = interval_center_(x);
    interval_thin_(z, m < HUGE_VAL ? interval_max_(x->upper - m, x->neg_lower + m) : HUGE_VAL);
}
static inline void interval_magnitude_upper(interval *z, const interval *x, long prec)
{
    (void)prec;
    interval_thin_(z, interval_max_(x->neg_lower, x->upper));
}
static inline void interval_add_error(interval *z, const interval *x, const interval *r, long prec)
{
    (void)prec;
    double e = interval_max_(r->neg_lower, r->upper);
    *z = interval_make_(x->neg_lower + e, x->upper + e);
}

#endif
