/* ball_pi.c: pi, from a table, or by 16 atan(1/5) - 4 atan(1/239) (Machin) in fixed point. */
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

/* floor(pi 2^(64 TABLE_FRACTION)), lowest limb first; the tests compare it with the series. */
#define TABLE_FRACTION 42
static const limb_t table[TABLE_FRACTION + 1] = {
    0xef845d5de98575b1, 0x487cac605dec8032, 0x61d809ccfb21a991, 0xc4bfe81b66282193,
    0x3b8f48986b4bb9af, 0x7a32538128958677, 0xafd6ba336c24cf5c, 0xce5c3e169b87931e,
    0x2ba9c55d741831f6, 0xb3ee1411636fbc2a, 0xa15486af7c72e993, 0xb4cc5c341141e8ce,
    0x55ca396a2aab10b6, 0x5748986263e81440, 0xe65525f3aa55ab94, 0x78af2fda55605c60,
    0xd71577c1bd314b27, 0x6c9e0e8bb01e8a3e, 0x8e79dcb0603a180e, 0xca417918b8db38ef,
    0xc5d1b023286085f0, 0x9c30d5392af26013, 0x7b54a41dc25a59b5, 0x718bcd5882154aee,
    0x0d95748f728eb658, 0xa458fea3f4933d7e, 0x636920d871574e69, 0x0801f2e2858efc16,
    0x24a19947b3916cf7, 0xba7c9045f12c7f99, 0xb8e1afed6a267e96, 0x2ffd72dbd01adfb7,
    0xd1310ba698dfb5ac, 0x9216d5d98979fb1b, 0x3f84d5b5b5470917, 0xc0ac29b7c97c50dd,
    0xbe5466cf34e90c6c, 0x452821e638d01377, 0x082efa98ec4e6c89, 0xa4093822299f31d0,
    0x13198a2e03707344, 0x243f6a8885a308d3, 0x0000000000000003,
};

/* p = floor(pi 2^(64 n)), n + 1 limbs, for n <= PI_TABLE_LIMBS. */
void ball_pi_limbs(limb_t *p, size_t n) { limb_copy(p, table + TABLE_FRACTION - n, n + 1); }

static void pi_from_table(ball *z, size_t n, long prec)
{
    limb_t w[TABLE_FRACTION + 1];
    ball_pi_limbs(w, n);
    ball_store(z, w, n + 1, false, 1, 0, -(int64_t)(64 * n), prec); /* ROUNDING: the floor lost less than one unit */
}

static void pi_from_series(ball *z, size_t n, long prec)
{
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

void ball_pi(ball *z, long prec)
{
    size_t n = (size_t)ball_room_bits(prec) / 64 + 1;
    if (n <= PI_TABLE_LIMBS)
        pi_from_table(z, n, prec);
    else
        pi_from_series(z, n, prec);
}
