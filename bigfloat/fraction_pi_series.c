/* fraction_pi_series.c: pi to any length, by the Chudnovskys' series and binary splitting over the integers.

       426880 sqrt(10005) / pi = sum over k >= 0 of (-1)^k (6k)! (13591409 + 545140134 k) / ((3k)! k!^3 640320^(3k)).

   For a <= k < b let p_k = (6k - 5)(2k - 1)(6k - 1), q_k = k^3 640320^3 / 24 (p_0 = q_0 = 1), P and Q their products,
   and T / Q = the sum of (-1)^k (13591409 + 545140134 k) (p_a ... p_k) / (q_a ... q_k); two neighbouring ranges join by
   T = T1 Q2 + P1 T2.  All of this is exact. */
#include "fraction.h"

typedef struct {
    integer P, Q, T;
} range;

static void range_init(range *r)
{
    integer_init(&r->P);
    integer_init(&r->Q);
    integer_init(&r->T);
}

static void range_clear(range *r)
{
    integer_clear(&r->P);
    integer_clear(&r->Q);
    integer_clear(&r->T);
}

/* k < 2^21: every word here is below 2^63 */
static bool one_term(range *r, int64_t k)
{
    const int64_t c = 10939058860032000; /* 640320^3 / 24 */
    integer_set_si(&r->P, k ? (6 * k - 5) * (2 * k - 1) : 1);
    integer_set_si(&r->Q, k ? k * k * k : 1);
    return (k == 0 || (integer_mul_si(&r->P, &r->P, 6 * k - 1) && integer_mul_si(&r->Q, &r->Q, c)))
           && integer_mul_si(&r->T, &r->P, (k % 2 ? -1 : 1) * (13591409 + 545140134 * k));
}

static bool split(range *r, int64_t a, int64_t b)
{
    if (b - a == 1)
        return one_term(r, a);
    int64_t middle = a + (b - a) / 2;
    range s;
    range_init(&s);
    bool ok = split(r, a, middle) && split(&s, middle, b) && integer_mul(&r->T, &r->T, &s.Q)
              && integer_mul(&s.T, &s.T, &r->P) && integer_add(&r->T, &r->T, &s.T) && integer_mul(&r->P, &r->P, &s.P)
              && integer_mul(&r->Q, &r->Q, &s.Q);
    range_clear(&s);
    return ok;
}

/* x = floor(426880 floor(sqrt(10005 B^(2 N))) Q / T) */
static bool quotient(integer *x, const range *r, size_t N)
{
    integer_set_si(x, 10005);
    return integer_mul_2exp(x, x, 128 * N) && integer_sqrt(x, x) && integer_mul_si(x, x, 426880)
           && integer_mul(x, x, &r->Q) && integer_fdiv_q(x, x, &r->T);
}

/* One limb more than asked for, N = n + 1, takes up the error: by errors-trig.md, "Pi", the integer less 1 is a lower
   bound of pi B^N, and less than 3 below it, so that its upper limbs are floor(pi B^n) or one less. */
bool fraction_pi_series(limb_t *p, size_t n)
{
    size_t N = n + 1;
    if (n >> 20)
        return false;
    range r;
    integer x;
    range_init(&r);
    integer_init(&x);
    /* more than 64 N / 47 + 1 terms, each of which has 47 bits less than the one before */
    bool ok = split(&r, 0, (int64_t)(64 * N / 47 + 2)) && quotient(&x, &r, N)
              && integer_add_si(&x, &x, -1); /* ROUNDING (hidden by the limb added): the rest of the series */
    if (ok) {
        const limb_t *w = integer_limbs(&x);
        size_t length = (size_t)integer_length(&x); /* N + 1 */
        limb_copy(p, w + 1, length - 1);
    }
    integer_clear(&x);
    range_clear(&r);
    return ok;
}
