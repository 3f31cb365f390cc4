/* trig_pi.c: exact reduction of the angle pi r, and balls around its cosine and sine. */
#include "trig_pi.h"

#include "ball.h"
#include "fraction.h"

/* t = r mod 2, in [0, 2) */
static bool modulo_two(rational *t, const rational *r)
{
    integer twice, rest;
    integer_init(&twice);
    integer_init(&rest);
    bool ok = integer_mul_2exp(&twice, &r->denominator, 1) && integer_fdiv_qr(NULL, &rest, &r->numerator, &twice)
              && rational_set_integers(t, &rest, &r->denominator);
    integer_clear(&twice);
    integer_clear(&rest);
    return ok;
}

/* t = p / q - t */
static bool reflect(rational *t, int64_t p, int64_t q)
{
    rational c;
    rational_init(&c);
    return rational_set_si(&c, p, q) && rational_sub(t, &c, t);
}

/* One word each, with room for small multiples? */
static bool is_short(const rational *r)
{
    return integer_length(&r->numerator) == 1 && integer_length(&r->denominator) == 1
           && integer_limbs(&r->numerator)[0] >> 60 == 0 && integer_limbs(&r->denominator)[0] >> 60 == 0;
}

/* The steps of trig_pi_reduce, for the angle pi a / (2 q). */
static bool reduce_short(trig_pi *u, const rational *r, bool of_sine)
{
    int64_t p = (int64_t)integer_limbs(&r->numerator)[0], q = (int64_t)integer_limbs(&r->denominator)[0];
    if (r->numerator.size < 0)
        p = -p;
    int64_t a = (of_sine ? q - 2 * p : 2 * p) % (4 * q);
    if (a < 0)
        a = -a; /* cos(-a) = cos a */
    if (a > 2 * q)
        a = 4 * q - a;
    if (a > q) {
        u->negative = true;
        a = 2 * q - a;
    }
    u->exact = a == 0 || 3 * a == 2 * q || a == q;
    if (u->exact)
        u->half = (a == 0 ? 2 : a == q ? 0 : 1) * (u->negative ? -1 : 1);
    else if (2 * a > q) {
        u->sine = true;
        a = q - a;
    }
    return u->exact || rational_set_si(&u->t, a, 2 * q);
}

bool trig_pi_reduce(trig_pi *u, const rational *r, bool of_sine)
{
    u->exact = u->sine = u->negative = false;
    u->half = 0;
    rational_init(&u->t);
    if (is_short(r))
        return reduce_short(u, r, of_sine);
    if (!rational_set(&u->t, r) || (of_sine && !reflect(&u->t, 1, 2)) /* sin a = cos(pi/2 - a) */
        || !modulo_two(&u->t, &u->t))
        return false;
    if (rational_cmp_si(&u->t, 1, 1) > 0 && !reflect(&u->t, 2, 1)) /* cos(2 pi - a) = cos a */
        return false;
    if (rational_cmp_si(&u->t, 1, 2) > 0) { /* cos(pi - a) = -cos a */
        u->negative = true;
        if (!reflect(&u->t, 1, 1))
            return false;
    }
    int sign = u->negative ? -1 : 1;
    u->exact = true;
    if (rational_is_zero(&u->t))
        u->half = 2 * sign;
    else if (rational_cmp_si(&u->t, 1, 3) == 0)
        u->half = sign;
    else if (rational_cmp_si(&u->t, 1, 2) != 0)
        u->exact = false;
    if (!u->exact && rational_cmp_si(&u->t, 1, 4) > 0) {
        u->sine = true;
        return reflect(&u->t, 1, 2);
    }
    return true;
}

static void ball_trig_pi(ball *z, const rational *r, bool of_sine, long prec)
{
    trig_pi u;
    if (!trig_pi_reduce(&u, r, of_sine))
        ball_no_memory(z);
    else if (u.exact) {
        ball_set_si(z, u.half, prec);
        ball_mul_2exp(z, z, -1, prec);
    } else
        ball_trig_of_turns(z, &u.t, u.sine, u.negative, prec);
    rational_clear(&u.t);
}

void ball_cos_pi(ball *z, const rational *r, long prec) { ball_trig_pi(z, r, false, prec); }
void ball_sin_pi(ball *z, const rational *r, long prec) { ball_trig_pi(z, r, true, prec); }
