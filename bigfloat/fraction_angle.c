/* fraction_angle.c: angles in fixed point: reduction by multiples of pi/2, complements, rational parts of a turn.
   The bounds: errors-trig.md, "Angles". */
#include "fraction.h"

/* w = floor(|m| 2^(e + 64 n)) in `length` limbs, which suffice; the answer: were bits lost? */
static bool to_fixed(limb_t *w, size_t length, size_t n, const ball *x)
{
    const limb_t *m = ball_limbs(x);
    size_t size = ball_length(x);
    int64_t d = x->exponent + 64 * (int64_t)n;
    limb_zero(w, length);
    if (d >= 0) {
        size_t whole = (size_t)d / 64;
        limb_t out = limb_shift_left(w + whole, m, size, (unsigned)(d % 64));
        if (whole + size < length)
            w[whole + size] = out;
        return false;
    }
    if (-d >= 64 * (int64_t)size)
        return true;
    size_t whole = (size_t)-d / 64;
    limb_shift_right(w, m + whole, size - whole, (unsigned)(-d % 64));
    return true;
}

/* floor(pi/2 B^n), or one less: the floor of half a floor. */
static bool half_pi(limb_t *p, size_t n)
{
    bool ok = fraction_pi(p, n);
    limb_shift_right(p, p, n + 1, 1);
    return ok;
}

/* |x| >= 1/2.  With I integer limbs, x is compared with P = pi/2 to n + I limbs: X B^I = q P + R.  As q < B^I, the
   q or q + 1 copies of P, each less than 3/2 units B^-(n + I) below pi/2, are wrong by less than 3/2 ulp. */
static bool subtract_turns(angle *x, unsigned *turn, bool *minus, const ball *of, size_t I)
{
    size_t n = x->n, W = n + I;
    ball_scratch space;
    limb_t *P = ball_scratch_new(&space, 4 * (W + 1) + 2 * I + 2);
    bool ok = P && half_pi(P, W);
    if (ok) {
        limb_t *A = P + W + 1, *R = A + W + I + 1, *q = R + W + 1, *C = q + I + 1;
        limb_zero(A, I);
        to_fixed(A + I, W + 1, n, of);
        x->wrong = 3; /* ROUNDING: the copies of P, 3/2; the cut of R below and the floor of x, 1 */
        q[0] = 0;
        if (I)
            ok = limb_divide(q, R, A, W + I + 1, P, W + 1);
        else
            limb_copy(R, A, W + 1);
        if (ok) {
            limb_sub_n(C, P, R, W + 1);
            *minus = limb_compare(C, R, W + 1) < 0;
            *turn = (unsigned)((q[0] + *minus) & 3);
            limb_copy(x->w, (*minus ? C : R) + I, n + 1);
        }
    }
    ball_scratch_free(&space);
    return ok;
}

void fraction_angle_set(angle *x, const ball *of)
{
    x->wrong = to_fixed(x->w, x->n + 1, x->n, of); /* ROUNDING: the floor of x */
}

bool fraction_angle_reduce(angle *x, unsigned *turn, bool *minus, const ball *of)
{
    int64_t top = ball_top(of);
    *turn = 0;
    *minus = false;
    if (top >= 0)
        return subtract_turns(x, turn, minus, of, (size_t)(top + 63) / 64);
    fraction_angle_set(x, of);
    return true;
}

/* floor(2^(64 n - e) / |m|) */
bool fraction_angle_set_inverse(angle *x, const ball *of)
{
    int64_t d = 64 * (int64_t)x->n - of->exponent;
    size_t size = ball_length(of), length = d < 0 ? 0 : (size_t)d / 64 + 1;
    limb_zero(x->w, x->n + 1);
    x->wrong = 1; /* ROUNDING: the floor */
    if (length < size)
        return true;
    ball_scratch space;
    limb_t *a = ball_scratch_new(&space, 2 * length + 1), *q = a + length;
    bool ok = a != NULL;
    if (ok) {
        limb_zero(a, length - 1);
        a[length - 1] = (limb_t)1 << d % 64;
        ok = limb_divide(q, NULL, a, length, ball_limbs(of), size);
        limb_copy(x->w, q, ok ? limb_normal(q, length - size + 1) : 0);
    }
    ball_scratch_free(&space);
    return ok;
}

bool fraction_angle_complement(angle *x)
{
    ball_scratch space;
    limb_t *P = ball_scratch_new(&space, x->n + 1);
    bool ok = P && half_pi(P, x->n);
    if (ok) {
        limb_sub_n(x->w, P, x->w, x->n + 1);
        x->wrong += 2; /* ROUNDING: pi/2, 3/2 */
    }
    ball_scratch_free(&space);
    return ok;
}

/* floor(pi B^n) p / q, wrong by less than 2 t ulp before it is cut */
bool fraction_angle_of_turns(angle *x, const rational *t)
{
    const integer *p = &t->numerator, *q = &t->denominator;
    size_t n = x->n, np = (size_t)p->size, nq = (size_t)q->size, N = n + 1;
    x->wrong = 3; /* ROUNDING: pi, 2; the quotient, 1 */
    if (np == 0) {
        limb_zero(x->w, N);
        return true;
    }
    if (np == 1 && nq == 1) {
        ball_scratch space;
        limb_t *a = ball_scratch_new(&space, N + 1);
        bool ok = a && fraction_pi(a, n);
        if (ok) {
            a[N] = limb_mul_1(a, a, N, integer_limbs(p)[0]);
            limb_divrem_1(a, a, N + 1, integer_limbs(q)[0]);
            limb_copy(x->w, a, N);
        }
        ball_scratch_free(&space);
        return ok;
    }
    ball_scratch space;
    size_t na = N + np > nq ? N + np : nq; /* nq >= np, as t < 1 */
    limb_t *pi = ball_scratch_new(&space, N + na + (na - nq + 1));
    bool ok = pi && fraction_pi(pi, n);
    if (ok) {
        limb_t *a = pi + N, *quotient = a + na;
        limb_zero(a, na);
        ok = (N >= np ? limb_multiply(a, pi, N, integer_limbs(p), np) : limb_multiply(a, integer_limbs(p), np, pi, N))
             && limb_divide(quotient, NULL, a, na, integer_limbs(q), nq);
        limb_zero(x->w, N);
        limb_copy(x->w, quotient, na - nq + 1 < N ? na - nq + 1 : N);
    }
    ball_scratch_free(&space);
    return ok;
}
