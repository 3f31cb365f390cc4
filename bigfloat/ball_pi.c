/* ball_pi.c: pi = 16 atan(1/5) - 4 atan(1/239) (Machin), in fixed point. */
#include "ball.h"
#include "ball_internal.h"

/* s = atan(1/q) B^n, up to the number of terms returned, times 2, plus 1.  Term k is floor(p_k / (2 k + 1)) with
   p_k = floor(p_(k-1) / q^2): p_k is below B^n / q^(2 k + 1) by less than 1 / (1 - 1/q^2) + 1 < 2.1 in all, so the
   term is below its true value by less than 2.1 / (2 k + 1) + 1 (2.1 for k = 0, then < 2); the terms left out
   alternate and add up to less than the first of them, < 1.  ROUNDING: 2 terms + 2. */
static limb_t atan_inverse(limb_t *s, limb_t *p, limb_t *t, size_t n, limb_t q)
{
    limb_zero(p, n);
    p[n] = 1;
    limb_divrem_1(p, p, n + 1, q);
    limb_copy(s, p, n + 1);
    limb_t k = 0;
    for (size_t m = limb_normal(p, n + 1); m; k++) {
        limb_divrem_1(p, p, m, q * q);
        m = limb_normal(p, m);
        limb_divrem_1(t, p, m, 2 * k + 3);
        if (k % 2 == 0)
            limb_sub_any(s, s, n + 1, t, m);
        else
            limb_add_any(s, s, n + 1, t, m);
    }
    return 2 * k + 4;
}

void ball_pi(ball *z, long prec)
{
    size_t n = (size_t)ball_room_bits(prec) / 64 + 1;
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, 4 * (n + 2));
    if (w) {
        limb_t *s = w, *p = s + n + 2, *t = p + n + 2, *sum = t + n + 2;
        limb_t err = 16 * atan_inverse(s, p, t, n, 5);
        limb_mul_1(sum, s, n + 1, 16);
        err += 4 * atan_inverse(s, p, t, n, 239);
        limb_submul_1(sum, s, n + 1, 4);
        ball_store(z, sum, n + 1, false, err, 0, -(int64_t)(64 * n), prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}
